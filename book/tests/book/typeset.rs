//! What the press makes of a chapter: of a book of one page.

use mdbook_driver::book::Book;
use mdbook_driver::config::Config;
use mdbook_renderer::RenderContext;
use press::drawings::Drawing;
use press::{Error, Result, binding};
use tempfile::TempDir;

/// The folder of a book with this page, which may show a number that a figure has computed.
fn of_one_page(page: &str) -> (TempDir, Vec<Drawing>) {
    let folder = super::scratch();
    for (name, text) in [
        ("book.toml", "[output.html]\nhash-files = false\n"),
        (
            "theme/head.hbs",
            "<meta content=\"'own-scripts';\">\n<script>alert(1)</script>",
        ),
        ("src/SUMMARY.md", "[X](x.md)\n"),
        (
            "src/quoted.rs",
            "impl A {\n    fn f() {\n\n        1\n    }\n}\n",
        ),
        ("src/x.md", page),
    ] {
        let path = folder.path().join("book").join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }
    let entry = figures::all()[0];
    let [claim, details, alt] = [const { String::new() }; 3];
    let words = figures::style::Words {
        claim,
        details,
        alt,
    };
    let figure = figures::style::figure(entry.name, 10.0, words, |_| ());
    let figure = figure.value("tilt", "2.92");
    (folder, vec![Drawing { entry, figure }])
}

/// The page as it is printed.
fn printed(page: &str) -> Result<String> {
    let (folder, drawings) = of_one_page(page);
    let built = folder.path().join("built");
    binding::bind(folder.path(), &built, &drawings)?;
    Ok(std::fs::read_to_string(built.join("x.html")).unwrap())
}

#[test]
fn a_page_has_what_its_chapter_asks_for() {
    let page = printed(
        "By {{value cat-animated.tilt}}\u{b0}, or $x={{value cat-animated.tilt}}$, and $x_1 * x_2$.\n\n\
         In 470 µs 2 kg m² and 40 %, of order 3 at best, from -1 to the $n$-th\n\n`cargo run -- claims`\n\n$$\\sqrt{2}$$\n\n\
         ```rs\n{{#include quoted.rs:2:5}}\n```\n",
    );
    let page = page.unwrap();
    for part in [
        "<p>By 2.92\u{b0}, or <span class=\"unbroken\"><span class=\"katex\">",
        // A line ends neither between a formula and its full stop nor between a number and its unit.
        "</span>.</span></p>",
        "In 470\u{a0}µs 2\u{a0}kg\u{a0}m² and 40\u{a0}%, of order 3 at best, from \u{2212}1 to the <span class=\"unbroken\">",
        "-th</span></p>",
        "<code>cargo run <span class=\"unbroken\">--</span> claims</code>",
        // Room for the sign of a root, on a line of its own.
        "katex-display",
        "padding-left",
        // Methods stand at the left edge.
        ">fn f() {\n\n    1\n}",
        // printf 'alert(1)' | openssl dgst -sha256 -binary | base64
        "'sha256-bhHHL3z2vDgxUt0W3dWQOrprscmda2Y5pLsLg4GF+pI='",
    ] {
        assert!(page.contains(part), "{part}: {page}");
    }
}

#[test]
fn faults_name_chapter_and_line() {
    for (source, place, word) in [
        ("a\n\n$\\frac{1}$\n", "book/src/x.md:3", "formula"),
        ("a\n\n$\\frac{1}{$\n", "book/src/x.md:3", "dollar"),
        ("a\n\n$\\sqrt f$\n", "book/src/x.md:3", "\\sqrt{…}"),
        ("a\n\nb\n\n{{figure nope}}\n", "book/src/x.md:5", "'nope'"),
        (
            "a\n\n{{foot src/nope.rs}}\n",
            "book/src/x.md:3",
            "'src/nope.rs'",
        ),
        ("a\n\n## b $x$\n", "book/src/x.md:3", "heading"),
        ("[a](b.md)\n", "book/src/x.md:1", "'b.md'"),
        ("a\n{{figure b}}\n", "book/src/x.md:2", "own"),
        ("a\n{{value b.c}}\n", "book/src/x.md:2", "'b'"),
        (
            "a\n{{value cat-animated.c}}\n",
            "book/src/x.md:2",
            "'c': expected one of [tilt]",
        ),
        ("<!-- claim: C0.0-0 -->\n", "book/src/x.md:1", "C0.0-0"),
    ] {
        let Err(Error::Input(told)) = printed(source) else {
            panic!("{source:?}")
        };
        assert!(told.starts_with(place) && told.contains(word), "{told}");
    }
}

#[test]
fn a_damaged_placeholder_is_an_error() {
    let told = printed("a <span data-piece=\"7\">x</span>\n").unwrap_err();
    assert!(told.to_string().contains("damaged placeholder"), "{told}");
}

#[test]
fn what_mdbook_serve_asks_for_is_in_the_pages() {
    let (folder, drawings) = of_one_page("a\n");
    let own = "[output.spinning-bodies]\ncommand = \"x\"\nhash-files = false\n";
    let mut settings: Config = own.parse().unwrap();
    let endpoint = "output.html.live-reload-endpoint";
    settings.set(endpoint, "__livereload").unwrap();
    let built = folder.path().join("built");
    let told = RenderContext::new(folder.path().join("book"), Book::new(), settings, &built);
    let told = serde_json::to_vec(&told).unwrap();
    binding::render(&told[..], || Ok(drawings)).unwrap();
    let page = std::fs::read_to_string(built.join("x.html")).unwrap();
    assert!(page.contains("\"__livereload\""), "{page}");
}
