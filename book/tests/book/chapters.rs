//! The sources of the chapters: one list, tagged fences, short examples, every figure shown once where it belongs.

use super::none;
use press::chapters::{self, CHAPTERS};
use press::ledger::{is_rust, markdown_options};
use press::paths::files_below;
use pulldown_cmark::{CodeBlockKind, Event, HeadingLevel, Parser, Tag, TagEnd};
use std::collections::BTreeMap;

/// Lines of a Rust example that the reader sees.
const MOST_LINES: usize = 15;

fn source(chapter: &str) -> String {
    let root = press::paths::workspace_root().unwrap();
    chapters::source(&root, chapter).unwrap()
}

/// Every code block: chapter, line, tag (`None` if indented), text.
fn blocks() -> Vec<(&'static str, usize, Option<String>, String)> {
    let mut blocks = Vec::new();
    for &chapter in CHAPTERS {
        let source = source(chapter);
        let mut open = None;
        for (event, span) in Parser::new_ext(&source, markdown_options()).into_offset_iter() {
            match event {
                Event::Start(Tag::CodeBlock(kind)) => {
                    let tag = match kind {
                        CodeBlockKind::Fenced(tag) => Some(tag.to_string()),
                        CodeBlockKind::Indented => None,
                    };
                    let line = source[..span.start].matches('\n').count() + 1;
                    open = Some((chapter, line, tag, String::new()));
                }
                Event::Text(text) => {
                    if let Some(block) = &mut open {
                        block.3.push_str(&text);
                    }
                }
                Event::End(TagEnd::CodeBlock) => blocks.extend(open.take()),
                _ => {}
            }
        }
    }
    blocks
}

#[test]
fn the_summary_is_the_list_of_chapters() {
    let summary = include_str!("../../src/SUMMARY.md");
    let mut linked = Vec::new();
    for event in Parser::new(summary) {
        if let Event::Start(Tag::Link { dest_url, .. }) = event {
            linked.push(dest_url.trim_end_matches(".md").to_owned());
        }
    }
    assert_eq!(linked, CHAPTERS);
}

#[test]
fn every_block_of_code_says_what_it_is() {
    let mut faults = Vec::new();
    for (chapter, line, tag, _) in blocks() {
        let tag = tag.as_deref().unwrap_or("none, indented");
        if !is_rust(tag) && !matches!(tag, "rs" | "text" | "toml" | "sh") {
            faults.push(format!(
                "{chapter}.md:{line}: tagged '{tag}'; rustdoc would run it"
            ));
        }
    }
    none(&faults);
}

#[test]
fn rust_examples_are_short_and_hold_no_directive() {
    let mut faults = Vec::new();
    for (chapter, line, tag, text) in blocks() {
        if !tag.as_deref().is_some_and(is_rust) {
            continue;
        }
        let hidden = |line: &str| line.trim_start().starts_with("# ") || line.trim() == "#";
        let visible = text.lines().filter(|line| !hidden(line)).count();
        for (wrong, what) in [
            (visible > MOST_LINES, "more lines than a reader wants"),
            (text.contains("{{#"), "a directive in a Rust block"),
            (!text.contains("assert"), "the example asserts nothing"),
            (
                text.contains("include_str!(\""),
                "a path not found from where all blocks are compiled as one",
            ),
        ] {
            if wrong {
                faults.push(format!("book/src/{chapter}.md:{line}: {what}"));
            }
        }
    }
    none(&faults);
}

#[test]
fn every_figure_is_shown_once_in_its_chapter() {
    let mut shown: BTreeMap<String, Vec<&str>> = BTreeMap::new();
    for &chapter in CHAPTERS {
        for line in source(chapter).lines() {
            let rest = line.trim().strip_prefix("{{figure ");
            let name = rest.and_then(|rest| rest.strip_suffix("}}"));
            let Some(name) = name.map(str::trim) else {
                continue;
            };
            if chapter == press::chapters::COVER {
                let known = figures::all().iter().any(|entry| entry.name == name);
                assert!(known, "the cover shows {name}, which is no figure");
            } else {
                shown.entry(name.to_owned()).or_default().push(chapter);
            }
        }
    }
    let mut faults = Vec::new();
    for entry in figures::all() {
        let chapters = shown.remove(entry.name).unwrap_or_default();
        let (name, own) = (entry.name, entry.chapter);
        if chapters != [own] {
            faults.push(format!("{name} is '{own}'s and shown in {chapters:?}"));
        }
    }
    for (name, chapters) in shown {
        faults.push(format!("{chapters:?} shows {name}, which is no figure"));
    }
    none(&faults);
}

#[test]
fn every_chapter_has_one_title() {
    for &chapter in CHAPTERS {
        let source = source(chapter);
        let titles = Parser::new_ext(&source, markdown_options()).filter(|event| match event {
            Event::Start(Tag::Heading { level, .. }) => *level == HeadingLevel::H1,
            _ => false,
        });
        assert_eq!(titles.count(), 1, "{chapter}");
    }
}

/// The files that a chapter has at its foot besides those of its name, if it has a foot.
fn beside(source: &str) -> Option<Vec<&str>> {
    let mut lines = source.lines();
    let named = lines.find_map(|line| line.strip_prefix("{{foot")?.strip_suffix("}}"))?;
    Some(named.split_whitespace().collect())
}

#[test]
fn the_foot_of_a_page_names_its_files() {
    let root = press::paths::workspace_root().unwrap();
    let mut faults = Vec::new();
    let mut feet = String::new();
    for &chapter in CHAPTERS {
        let source = source(chapter);
        let beside = beside(&source);
        let foot = chapters::foot(&root, chapter, beside.as_deref().unwrap_or_default());
        let foot = foot.unwrap();
        for file in beside.iter().flatten() {
            let folder = root.join(file).is_dir();
            if folder != file.ends_with('/') || !foot.contains(&format!("<code>{file}</code>")) {
                faults.push(format!("{chapter}: '{file}' is not in the foot"));
            }
        }
        // A figure's source stands in the foot of the chapter that shows it.
        let mut own = figures::all().iter();
        if own.any(|entry| entry.chapter == chapter) && !foot.contains("figures/src/") {
            faults.push(format!("{chapter} does not say where it is drawn"));
        }
        if beside.is_none() && foot.contains("<code>") {
            faults.push(format!("{chapter} has files, and no foot"));
        }
        feet += &foot;
    }
    for scene in files_below(&root.join("book/scenes")).unwrap() {
        let name = scene.file_name().unwrap().to_str().unwrap();
        if !feet.contains(&format!("book/scenes/{name}</code>")) {
            faults.push(format!("no chapter names {name}"));
        }
    }
    assert!(chapters::foot(&root, "spool", &["src/none.rs"]).is_err());
    none(&faults);
}
