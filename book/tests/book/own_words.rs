//! The book tells the tutorial's subject in words of its own: no six words in a row are the tutorial's.
//!
//! `own_words.txt` holds 48 bits of a hash of each run of six words of the tutorial, and nothing of its text. It was made from a
//! plain text of the tutorial, formulas between dollars, by `TUTORIAL=text.txt cargo test -p book --test book own_words -- --ignored`.

use press::chapters::{self, CHAPTERS};
use press::ledger::markdown_options;
use pulldown_cmark::{Event, Parser, Tag, TagEnd};
use std::collections::{BTreeSet, HashSet};

const RUN: usize = 6;
const HASHES: &str = include_str!("own_words.txt");

/// Names, and everyday words that can hardly be put another way.
const NAMES: &[&str] = &["throw a superball under a table"];

/// Chapters that still share a run with the tutorial. To be emptied.
const NEAR: &[&str] = &[];

/// FNV-1a, the lower 48 bits.
fn hash(words: &[String]) -> u64 {
    let fnv = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    words.join(" ").bytes().fold(0xcbf2_9ce4_8422_2325, fnv) & 0xffff_ffff_ffff
}

/// Words of a text in small letters; formulas and what stands in quotation marks end a run.
fn stretches(text: &str) -> Vec<Vec<String>> {
    let mut stretches = vec![Vec::new()];
    for (i, part) in text.split('$').enumerate() {
        if i % 2 == 1 {
            stretches.push(Vec::new());
            continue;
        }
        for (k, piece) in part.split(['“', '”']).enumerate() {
            stretches.push(Vec::new());
            if k % 2 == 1 {
                continue;
            }
            let plain = piece.to_lowercase().replace(['’', '\''], "");
            let words = plain.split(|c: char| !c.is_alphanumeric());
            let words = words.filter(|word| !word.is_empty()).map(str::to_owned);
            if let Some(stretch) = stretches.last_mut() {
                stretch.extend(words);
            }
        }
    }
    stretches
}

/// Every run of six words in a text.
fn runs(text: &str) -> Vec<Vec<String>> {
    let stretches = stretches(text);
    let runs = stretches.iter().flat_map(|words| words.windows(RUN));
    runs.map(<[String]>::to_vec).collect()
}

/// The prose of a chapter, an entry a paragraph, with its line; code and quotations left out.
fn paragraphs(source: &str) -> Vec<(usize, String)> {
    let add = |paragraphs: &mut Vec<(usize, String)>, text: &str| {
        paragraphs.last_mut().unwrap().1.push_str(text);
    };
    let mut paragraphs = vec![(1, String::new())];
    let mut outside = 0;
    for (event, span) in Parser::new_ext(source, markdown_options()).into_offset_iter() {
        match event {
            Event::Start(Tag::CodeBlock(_) | Tag::BlockQuote(_)) => outside += 1,
            Event::End(TagEnd::CodeBlock | TagEnd::BlockQuote(_)) => outside -= 1,
            Event::Start(Tag::Paragraph | Tag::Heading { .. } | Tag::Item | Tag::TableCell) => {
                let line = source[..span.start].matches('\n').count() + 1;
                paragraphs.push((line, String::new()));
            }
            _ if outside > 0 => {}
            Event::Text(text) | Event::Code(text) => add(&mut paragraphs, &text),
            Event::InlineMath(_) | Event::DisplayMath(_) => add(&mut paragraphs, " $x$ "),
            Event::SoftBreak | Event::HardBreak => add(&mut paragraphs, " "),
            _ => {}
        }
    }
    paragraphs
}

#[test]
fn no_six_words_in_a_row_are_the_tutorials() {
    let known = HASHES
        .lines()
        .map(|line| u64::from_str_radix(line, 16).unwrap());
    let known: HashSet<u64> = known.collect();
    assert!(known.len() > 4500, "only {} hashes", known.len());
    let names = NAMES.iter().flat_map(|name| runs(name));
    let names: HashSet<u64> = names.map(|run| hash(&run)).collect();
    let mut faults = Vec::new();
    let mut near = HashSet::new();
    let root = press::paths::workspace_root().unwrap();
    for &name in CHAPTERS {
        for (line, paragraph) in paragraphs(&chapters::source(&root, name).unwrap()) {
            for run in runs(&paragraph) {
                let hash = hash(&run);
                if known.contains(&hash) && !names.contains(&hash) {
                    near.insert(name);
                    if !NEAR.contains(&name) {
                        faults.push(format!("book/src/{name}.md:{line}: {}", run.join(" ")));
                    }
                }
            }
        }
    }
    for chapter in NEAR.iter().filter(|chapter| !near.contains(**chapter)) {
        faults.push(format!("{chapter} uses its own words by now"));
    }
    super::none(&faults);
}

#[test]
fn formulas_and_quotations_end_a_run() {
    assert_eq!(runs("One, two: three-four five six’s seven").len(), 2);
    assert_eq!(runs("one two three $x$ four five six").len(), 0);
    assert_eq!(runs("one “two three four five six seven” eight").len(), 0);
}

#[test]
#[ignore = "writes the hashes anew, from a text of the tutorial"]
fn write_the_hashes() {
    let path = std::env::var_os("TUTORIAL").expect("TUTORIAL=FILE");
    let text = std::fs::read_to_string(path).expect("a text");
    let runs = runs(&text.replace("$$", "$"));
    let hashes: BTreeSet<u64> = runs.iter().map(|run| hash(run)).collect();
    let lines: Vec<_> = hashes.iter().map(|hash| format!("{hash:012x}\n")).collect();
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/book/own_words.txt");
    std::fs::write(file, lines.concat()).expect("the tests' folder can be written");
}
