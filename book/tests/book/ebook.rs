//! The EPUB, read as strictly as a device may: XML, nothing that leads nowhere, the pages of the book.

use super::{DRAWINGS, none};
use roxmltree::{Document, ParsingOptions};
use std::collections::{BTreeMap, HashSet};
use std::io::Read;
use std::path::Path;
use zip::{CompressionMethod, ZipArchive};

#[test]
fn every_page_of_the_epub_is_xml_and_leads_somewhere() {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("spinning-bodies.epub");
    let root = press::paths::workspace_root().unwrap();
    press::ebook::epub(&root, &DRAWINGS, &file).unwrap();
    let mut zip = ZipArchive::new(std::fs::File::open(&file).unwrap()).unwrap();

    let first = zip.by_index(0).unwrap();
    assert_eq!(first.name(), "mimetype");
    assert_eq!(first.compression(), CompressionMethod::Stored);
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
    let xml = texts.iter().filter(|(name, _)| !name.ends_with(".css"));
    let parts = xml.map(|(name, text)| {
        let document = Document::parse_with_options(text, options);
        (
            name.as_str(),
            document.unwrap_or_else(|error| panic!("{name}: {error}")),
        )
    });
    let parts: BTreeMap<&str, Document<'_>> = parts.collect();
    let ids = parts.iter().map(|(name, part)| {
        let ids = part.descendants().filter_map(|e| e.attribute("id"));
        (*name, ids.collect())
    });
    let ids: BTreeMap<&str, HashSet<&str>> = ids.collect();
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
            let named = || ids.get(file).is_some_and(|ids| ids.contains(place));
            if !texts.contains_key(file) || !(place.is_empty() || named()) {
                faults.push(format!("{name} leads to {to}"));
            }
        }
        let hidden = |text: &&str| text.lines().any(|line| line.starts_with("# "));
        let code = ("http://www.w3.org/1999/xhtml", "code");
        let code = part.descendants().filter(|e| e.has_tag_name(code));
        let rust = code.filter(|e| e.attribute("class").is_some_and(|c| c.contains("rust")));
        let shown = rust.filter_map(|e| e.text()).filter(hidden);
        faults.extend(shown.map(|text| format!("{name} shows {text}")));
    }
    none(&faults);
    assert!(chapters > 25, "only {chapters} pages");
    // A formula is mathematics, and a figure a picture with words for it.
    let superball = &texts["superball.xhtml"];
    assert!(superball.contains("<math") && !superball.contains("katex"));
    let figures = parts["superball.xhtml"].descendants().filter(|e| {
        let source = e.attribute("src").unwrap_or("");
        source.starts_with("figures/") && e.attribute("alt").is_some_and(|alt| alt.len() > 20)
    });
    assert!(figures.count() >= 3);
}
