//! Builds the book and reads every page of it, as a browser without a network would.

use super::{DRAWINGS, none};
use mdbook_driver::MDBook;
use mdbook_driver::config::Config;
use press::binding;
use scraper::node::Element;
use scraper::{ElementRef, Html, Selector};
use std::collections::{BTreeMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

fn root() -> PathBuf {
    press::paths::workspace_root().unwrap()
}

/// The book, built once for all tests of this file.
static BOOK: LazyLock<PathBuf> = LazyLock::new(|| {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("book");
    binding::bind(&root(), &folder, &DRAWINGS).unwrap();
    folder
});

/// All files of a folder and of those in it.
fn files(base: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let read = |path: PathBuf| {
        let bytes = std::fs::read(&path).unwrap();
        (path.strip_prefix(base).unwrap().to_owned(), bytes)
    };
    let files = press::paths::files_below(base).unwrap();
    files.into_iter().map(read).collect()
}

/// Name, text and parse tree.
type Page = (String, String, Html);

/// The page of all chapters, or all others.
fn pages(of_all_chapters: bool) -> Vec<Page> {
    let mut pages = Vec::new();
    for (path, bytes) in files(&BOOK) {
        let name = path.to_string_lossy().into_owned();
        if name.ends_with(".html") && (name == "print.html") == of_all_chapters {
            let text = String::from_utf8(bytes).unwrap();
            let tree = Html::parse_document(&text);
            pages.push((name, text, tree));
        }
    }
    pages
}

/// Reading the pages takes longer than all that is asked of them: they are read once, and the page of all chapters beside the others.
#[test]
fn every_page_is_sound() {
    let whole = std::thread::spawn(|| {
        let pages = pages(true);
        figures_are_numbered_in_reading_order(&pages[0]);
        sound(&pages);
    });
    let pages = pages(false);
    assert!(pages.len() > 20, "only {} pages were built", pages.len());
    sound(&pages);
    whole.join().unwrap();
}

fn sound(pages: &[Page]) {
    every_link_leads_somewhere_within_the_book(pages);
    nothing_is_fetched_from_a_network(pages);
    every_picture_says_what_is_seen(pages);
    a_figure_with_numbers_to_choose_is_live(pages);
    every_page_forbids_other_hosts(pages);
    nothing_is_left_unset(pages);
    no_line_of_code_is_wider_than_the_column(pages);
}

fn every_link_leads_somewhere_within_the_book(pages: &[Page]) {
    let any = Selector::parse("[id], [name]").unwrap();
    let ids = pages.iter().map(|(name, _, tree)| {
        let ids = tree
            .select(&any)
            .filter_map(|e| e.attr("id").or(e.attr("name")));
        (name.as_str(), ids.collect())
    });
    let ids: BTreeMap<&str, HashSet<&str>> = ids.collect();
    let linked = Selector::parse("[href], [src]").unwrap();
    let mut faults = Vec::new();
    for (name, _, tree) in pages {
        for element in tree.select(&linked) {
            for link in ["href", "src"].iter().filter_map(|key| element.attr(key)) {
                if link.contains("://") || link.starts_with("//") {
                    faults.push(format!("{name}: {link} leaves the book"));
                    continue;
                }
                if link.starts_with("data:") || link.starts_with("javascript:") {
                    continue;
                }
                let (path, anchor) = link.split_once('#').unwrap_or((link, ""));
                let path = path.split('?').next().unwrap_or_default();
                let target = if path.is_empty() { name } else { path };
                let lacks = |ids: &HashSet<&str>| !anchor.is_empty() && !ids.contains(anchor);
                if !BOOK.join(target).exists() {
                    faults.push(format!("{name}: there is no {target}"));
                } else if ids.get(target).is_some_and(lacks) {
                    faults.push(format!("{name}: there is no #{anchor} in {target}"));
                }
            }
        }
    }
    none(&faults);
}

fn nothing_is_fetched_from_a_network(pages: &[Page]) {
    let mut faults = Vec::new();
    for (path, bytes) in files(&BOOK) {
        let text = String::from_utf8_lossy(&bytes);
        if path.extension().is_some_and(|ending| ending == "css") {
            for far in ["url(http", "url(\"http", "url('http", "url(//", "@import"] {
                if text.contains(far) {
                    faults.push(format!("{}: {far}", path.display()));
                }
            }
        }
    }
    // mdBook's script calls the playground of the language as soon as a page holds one such block.
    let playground = Selector::parse(".playground, script[src*='//'], script[src*='MathJax']");
    let playground = playground.unwrap();
    for (name, _, tree) in pages {
        if tree.select(&playground).next().is_some() {
            faults.push(format!("{name}: a script that calls a network service"));
        }
    }
    none(&faults);
}

fn every_picture_says_what_is_seen(pages: &[Page]) {
    // A root sign in a caption is drawn as well, and its formula is said in words of its own.
    let pictures = Selector::parse("figure svg:not(.hide-tail > svg), main img").unwrap();
    let figure = Selector::parse("main figure[id^='fig-']").unwrap();
    let mut faults = Vec::new();
    let mut figures_seen = 0;
    for (name, _, tree) in pages {
        figures_seen += tree.select(&figure).count();
        for picture in tree.select(&pictures) {
            let said = picture.attr("aria-label").or(picture.attr("alt"));
            if said.is_none_or(|said| said.trim().len() < 20) {
                faults.push(format!("{name}: a picture without words"));
            }
        }
    }
    none(&faults);
    // Once in its chapter and once on the print page.
    assert_eq!(figures_seen, figures::all().len());
}

fn figures_are_numbered_in_reading_order((_, _, tree): &Page) {
    let number = Selector::parse("main .figure-number").unwrap();
    let numbers = tree.select(&number);
    let numbers = numbers.map(|e| e.text().collect::<String>());
    let expected = (1..=figures::all().len()).map(|n| format!("Figure {n}."));
    assert!(numbers.eq(expected));
}

/// Its page knows them; and of a point that can be dragged, where it stands.
fn a_figure_with_numbers_to_choose_is_live(pages: &[Page]) {
    let shown = Selector::parse("main figure[id^='fig-']").unwrap();
    for (name, _, tree) in pages {
        for figure in tree.select(&shown) {
            let id = figure.attr("id").unwrap();
            let entry = |entry: &&figures::Entry| id == format!("fig-{}", entry.name);
            let known = figures::all().iter().find(entry).unwrap().parameters.iter();
            let known = known.map(|one| (Some(one.key), one.handle.is_some()));
            let told = figure.attr("data-live").unwrap_or("[]");
            let told: Vec<serde_json::Value> = serde_json::from_str(told).unwrap();
            let told = told
                .iter()
                .map(|one| (one["key"].as_str(), !one["place"].is_null()));
            assert!(told.eq(known), "{name}: {id}");
        }
    }
}

fn every_page_forbids_other_hosts(pages: &[Page]) {
    let policy = Selector::parse("head meta[http-equiv='Content-Security-Policy']").unwrap();
    let script = Selector::parse("script:not([src])").unwrap();
    let mut faults = Vec::new();
    for (name, _, tree) in pages {
        let policy = tree
            .select(&policy)
            .next()
            .and_then(|meta| meta.attr("content"));
        let policy = policy.unwrap_or("none");
        let others = ["http", "*"].iter().any(|other| policy.contains(other));
        if others || !policy.starts_with("default-src 'self'") {
            faults.push(format!("{name}: the policy '{policy}' lets others in"));
        }
        let hashes = policy.matches("'sha256-").count();
        if hashes != tree.select(&script).count() {
            faults.push(format!("{name}: {hashes} scripts are allowed by hash"));
        }
    }
    none(&faults);
}

#[test]
fn the_search_index_is_small_and_holds_words() {
    let index = std::fs::read_to_string(BOOK.join("searchindex.js")).unwrap();
    assert!(index.len() <= 1_000_000, "{} bytes", index.len());
    for word in ["polhode", "superball", "Kovalevskaya", "herpolhode"] {
        assert!(index.contains(word), "{word} cannot be found");
    }
    for code in ["claim: C", "\\\\frac", "assert!", "fn main"] {
        assert!(!index.contains(code), "the index holds {code}");
    }
}

/// The text within an element, but for what stands in or under an element that is `left_out`.
fn told(element: ElementRef<'_>, left_out: fn(&Element) -> bool) -> String {
    let parts = element.descendants().filter_map(|node| {
        let mut above = node.ancestors().filter_map(ElementRef::wrap);
        let text = node.value().as_text()?;
        (!above.any(|up| left_out(up.value()))).then_some(&**text)
    });
    parts.collect()
}

fn nothing_is_left_unset(pages: &[Page]) {
    let prose = Selector::parse("main p, main li, main td, main figcaption, main h2").unwrap();
    let mut faults = Vec::new();
    for (name, text, tree) in pages {
        for left in ["data-piece", "katex-error", "{{figure", "{{#", "{{claims"] {
            if text.contains(left) {
                faults.push(format!("{name}: '{left}'"));
            }
        }
        // Outside of code no braces are meant as braces, and no dollars as dollars.
        for element in tree.select(&prose) {
            let text = told(element, |up| {
                matches!(up.name(), "code" | "pre") || up.classes().any(|class| class == "katex")
            });
            if text.contains("{{") || text.contains('$') {
                faults.push(format!("{name}: {}", text.trim()));
            }
        }
    }
    none(&faults);
}

/// `mdbook build book`, but for the compiler: its command for the press is the one that stands built. So two builds are the same, too.
#[test]
fn mdbook_itself_comes_to_the_same_bytes() {
    let mut settings = Config::from_disk(root().join("book/book.toml")).unwrap();
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("book-by-mdbook");
    settings.build.build_dir = folder.clone();
    let press = format!("'{}' render", env!("CARGO_BIN_EXE_book"));
    let renderer = "output.spinning-bodies.command";
    settings.set(renderer, press).unwrap();
    let book = MDBook::load_with_config(root().join("book"), settings).unwrap();
    book.build().unwrap();
    let (a, b) = (files(&BOOK), files(&folder));
    assert!(a.keys().eq(b.keys()));
    for (path, bytes) in &a {
        assert!(b[path] == *bytes, "{} differs", path.display());
    }
}

#[test]
fn a_failing_build_leaves_the_old_book() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("kept");
    std::fs::create_dir_all(&folder).unwrap();
    let page = folder.join("index.html");
    std::fs::write(&page, "old").unwrap();
    let nowhere = Path::new(env!("CARGO_TARGET_TMPDIR")).join("no-workspace");
    assert!(binding::bind(&nowhere, &folder, &[]).is_err());
    assert_eq!(std::fs::read_to_string(page).unwrap(), "old");
}

#[test]
fn a_missing_include_fails_the_build() {
    let scratch = super::scratch();
    let source = scratch.path().join("book/src");
    std::fs::create_dir_all(&source).unwrap();
    let settings = "[book]\ntitle = \"T\"\n[output.html]\nhash-files = false\n";
    std::fs::write(scratch.path().join("book/book.toml"), settings).unwrap();
    std::fs::write(source.join("SUMMARY.md"), "[A](a.md)\n").unwrap();
    let page = source.join("a.md");
    let built = || binding::bind(scratch.path(), &scratch.path().join("out"), &[]);

    std::fs::write(&page, "# A\n\n```rs\nfn main() {}\n```\n").unwrap();
    built().unwrap();
    std::fs::write(&page, "# A\n\n```rs\n{{#include nowhere.rs:x}}\n```\n").unwrap();
    let error = built().unwrap_err();
    assert!(error.to_string().contains("nowhere.rs"), "{error}");
    assert_eq!(error.status(), 2);
    assert_eq!(error.to_string().lines().count(), 1);
}

/// Characters of code that fit at 1200 pixels, in the column and under a fold. The browser check measures them.
const COLUMN: usize = 97;
const FOLDED: usize = 87;

fn no_line_of_code_is_wider_than_the_column(pages: &[Page]) {
    let code = Selector::parse("main pre > code").unwrap();
    let mut faults = Vec::new();
    for (name, _, tree) in pages {
        if name == "print.html" {
            continue;
        }
        for block in tree.select(&code) {
            let mut above = block.ancestors().filter_map(ElementRef::wrap);
            let folded = above.any(|up| up.value().name() == "details");
            let room = if folded { FOLDED } else { COLUMN };
            let text = told(block, |up| up.classes().any(|class| class == "boring"));
            for line in text.lines() {
                let wide = line.chars().count();
                if wide > room {
                    faults.push(format!("{name}: {wide} characters, {room} fit: {line}"));
                }
            }
        }
    }
    none(&faults);
}
