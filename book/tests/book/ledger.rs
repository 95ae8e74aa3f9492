//! No claim without its test and its place in the book, and no mark without its claim.

use press::ledger::{Claim, Kind, Ledger, Place, Verdict};
use press::paths::workspace_root;

use crate::{none, scratch};

fn ledger() -> Ledger {
    Ledger::read(&workspace_root().unwrap()).unwrap()
}

#[test]
fn every_mark_names_a_claim_and_every_claim_has_its_places() {
    let ledger = ledger();
    let is_unknown = |place: &&Place| ledger.claim(&place.claim).is_none();
    let unknown = ledger.places.iter().filter(is_unknown);
    let unknown = unknown.map(
        |Place {
             claim, file, spot, ..
         }| { format!("{file} names '{claim}' at {spot}, which is no claim") },
    );
    let lacking = ledger.claims.iter().flat_map(|claim| {
        let missing = ledger.missing(claim).into_iter();
        missing.map(|what| format!("{} ({}) lacks {what}", claim.id, claim.title))
    });
    none(&unknown.chain(lacking).collect::<Vec<_>>());
}

#[test]
fn the_register_is_whole() {
    let ledger = ledger();
    let numbers = |claim: &Claim| {
        let parts = claim.id.split(['C', '.', '-']).skip(1);
        Vec::from_iter(parts.map(|number| number.parse::<u32>().unwrap()))
    };
    let mut pairs = ledger.claims.array_windows();
    let disorder = pairs.find(|[one, next]| numbers(one) >= numbers(next));
    assert!(disorder.is_none(), "not in order, or twice: {disorder:?}");
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

/// Where the ledger of a folder with this chapter and these tests finds claims: claim, spot, kind.
fn found(chapter: &str, tests: &str) -> Vec<(String, String, Kind)> {
    let root = scratch();
    for (file, text) in [("book/src/index.md", chapter), ("tests/a.rs", tests)] {
        let file = root.path().join(file);
        std::fs::create_dir_all(file.parent().unwrap()).unwrap();
        std::fs::write(file, text).unwrap();
    }
    let places = Ledger::read(root.path()).unwrap().places.into_iter();
    places
        .map(|place| (place.claim, place.spot, place.kind))
        .collect()
}

#[test]
fn marks_are_found_in_blocks_in_comments_and_at_tests() {
    let chapter = "# A\n\n<!-- claim: C3.1-1 -->\nProse.\n\n```rust\n# // claim: C2.7-2, C2.7-3\nlet x = 1;\n// claim: C2.1-1\n```\n\n```rust\nlet no = \"claim: C1.1-1\";\n```\n\n```text\n// claim: C9.9-9\n```\n";
    let tests = "// claim: C1.1-1\n#[test]\nfn above() {}\n\n#[test]\nfn inside() {\n    // claim: C1.1-2, C1.1-3\n    let x = 1;\n}\n";
    let expected = [
        ("C3.1-1", "3", Kind::Comment),
        ("C2.7-2", "6", Kind::Block),
        ("C2.7-3", "6", Kind::Block),
        ("C2.1-1", "6", Kind::Block),
        ("C1.1-1", "above", Kind::Test),
        ("C1.1-2", "inside", Kind::Test),
        ("C1.1-3", "inside", Kind::Test),
    ];
    let expected = expected.map(|(claim, spot, kind)| (claim.to_owned(), spot.to_owned(), kind));
    assert_eq!(found(chapter, tests), expected);
}
