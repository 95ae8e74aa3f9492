//! No claim without its test and its place in the book, and no mark without its claim.

use press::ledger::{Ledger, Verdict};
use press::paths::workspace_root;

use crate::none;

fn ledger() -> Ledger {
    Ledger::read(&workspace_root().unwrap()).unwrap()
}

#[test]
fn every_mark_names_a_claim_and_every_claim_has_its_places() {
    let ledger = ledger();
    let in_chapters = ledger.chapters.iter().flat_map(|(chapter, mark)| {
        let line = format!("book/src/{chapter}.md:{}", mark.line);
        mark.claims.iter().map(move |claim| (line.clone(), claim))
    });
    let in_tests = ledger.tests.iter().map(|place| {
        let test = format!("{}: {}", place.file, place.function);
        (test, &place.claim)
    });
    let unknown = in_chapters
        .chain(in_tests)
        .filter(|(_, id)| ledger.claim(id).is_none())
        .map(|(place, id)| format!("{place} names '{id}', which is no claim"));
    let lacking = ledger.claims.iter().flat_map(|claim| {
        let missing = ledger.missing(claim).into_iter();
        missing.map(|what| format!("{} ({}) lacks {what}", claim.id, claim.title))
    });
    none(&unknown.chain(lacking).collect::<Vec<_>>());
}

#[test]
fn the_register_is_whole() {
    let ledger = ledger();
    let mut ids: Vec<_> = ledger.claims.iter().map(|claim| &claim.id).collect();
    let before = ids.len();
    ids.sort();
    ids.dedup();
    assert_eq!(ids.len(), before, "a claim is registered twice");
    for claim in &ledger.claims {
        let expected = format!("C{}-", claim.section);
        assert!(claim.id.starts_with(&expected), "{claim:?}");
        let empty = claim.statement.is_empty() || claim.title.is_empty();
        assert!(!empty, "{claim:?}");
    }
}

#[test]
fn every_claim_is_on_the_claims_page_and_in_the_table() {
    let ledger = ledger();
    let page = press::appendix::page(&ledger);
    let table = press::appendix::table(&ledger);
    for claim in &ledger.claims {
        let id = &claim.id;
        assert!(page.contains(&format!("id=\"{id}\"")), "{id}");
        let mut firsts = table.lines().map(|line| line.split_whitespace().next());
        assert!(firsts.any(|first| first == Some(id)), "{id}");
    }
}

#[test]
fn the_pages_say_what_the_register_says() {
    let ledger = ledger();
    let legend = include_str!("../../src/claims.md").to_lowercase();
    for claim in &ledger.claims {
        let told = format!("**{}**:", claim.verdict);
        assert!(legend.contains(&told), "{told}");
    }
    let of = |verdict| ledger.claims.iter().filter(move |c| c.verdict == verdict);
    assert_eq!(of(Verdict::Erratum).count(), 8);
    assert!(include_str!("../../src/errata.md").contains("eight are wrong"));
    // Grains that lock, and why the long axis: for these two the chapters have models and no answer. Any other question is
    // answered by a test and a block, or its verdict is not a question.
    let open: Vec<_> = of(Verdict::OpenQuestion).map(|c| c.id.as_str()).collect();
    assert_eq!(open, ["C3.5-4", "C4.10-1"]);
}
