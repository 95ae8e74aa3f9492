//! The EPUB, read as strictly as a device may: XML, nothing that leads nowhere, the pages of the book.

use super::{drawings, none};
use roxmltree::{Document, ParsingOptions};
use std::collections::{BTreeMap, HashSet};
use std::io::Read;
use std::path::Path;
use zip::{CompressionMethod, ZipArchive};

#[test]
fn every_page_of_the_epub_is_xml_and_leads_somewhere() {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("spinning-bodies.epub");
    let root = press::paths::workspace_root().unwrap();
    press::ebook::epub(&root, drawings(), &file).unwrap();
    let mut zip = ZipArchive::new(std::fs::File::open(&file).unwrap()).unwrap();

    let first = zip.by_index(0).unwrap();
    assert_eq!(
        (first.name(), first.compression()),
        ("mimetype", CompressionMethod::Stored)
    );
    drop(first);

    let mut texts = BTreeMap::new();
    for k in 1..zip.len() {
        let mut part = zip.by_index(k).unwrap();
        let mut text = String::new();
        part.read_to_string(&mut text).unwrap();
        texts.insert(part.name().to_owned(), text);
    }
    let options = ParsingOptions {
        allow_dtd: true,
        ..ParsingOptions::default()
    };
    let is_xml = |name: &str| !name.ends_with(".css");
    let parts: BTreeMap<&str, Document<'_>> = texts
        .iter()
        .filter(|(name, _)| is_xml(name))
        .map(
            |(name, text)| match Document::parse_with_options(text, options) {
                Ok(document) => (name.as_str(), document),
                Err(error) => panic!("{name}: {error}"),
            },
        )
        .collect();

    let ids: BTreeMap<&str, HashSet<&str>> = parts
        .iter()
        .map(|(name, part)| {
            (
                *name,
                part.descendants()
                    .filter_map(|e| e.attribute("id"))
                    .collect(),
            )
        })
        .collect();
    let mut faults = Vec::new();
    let mut chapters = 0;
    for (name, part) in parts.iter().filter(|(name, _)| name.ends_with(".xhtml")) {
        chapters += 1;
        for element in part.descendants() {
            let to = element.attribute("href").or(element.attribute("src"));
            let Some(to) = to.filter(|to| !to.contains("://")) else {
                continue;
            };
            let (file, place) = to.split_once('#').unwrap_or((to, ""));
            let file = if file.is_empty() { name } else { file };
            let there = texts.contains_key(file)
                && (place.is_empty() || ids.get(file).is_some_and(|ids| ids.contains(place)));
            if !there {
                faults.push(format!("{name} leads to {to}"));
            }
        }
        let hidden = |text: &str| text.lines().any(|line| line.starts_with("# "));
        let code = part
            .descendants()
            .filter(|e| e.has_tag_name(("http://www.w3.org/1999/xhtml", "code")));
        let rust = code.filter(|e| {
            e.attribute("class")
                .is_some_and(|class| class.contains("rust"))
        });
        faults.extend(
            rust.filter_map(|e| e.text())
                .filter(|text| hidden(text))
                .map(|text| format!("{name} shows {text}")),
        );
    }
    none(&faults);
    assert!(chapters > 25, "only {chapters} pages");
    // A formula is mathematics, and a figure a picture with words for it.
    assert!(
        texts["superball.xhtml"].contains("<math") && !texts["superball.xhtml"].contains("katex")
    );
    let superball = &parts["superball.xhtml"];
    let figures = superball.descendants().filter(|e| {
        e.attribute("src")
            .is_some_and(|to| to.starts_with("figures/"))
    });
    assert!(
        figures
            .filter(|e| e.attribute("alt").is_some_and(|alt| alt.len() > 20))
            .count()
            >= 3
    );
}
