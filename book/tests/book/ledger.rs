//! No claim of a finished paragraph without its test and its place in the book, and no mark without its claim.

use press::ledger::{COMPLETE, Ledger, Verdict, must_be_settled};
use press::paths::workspace_root;

fn ledger() -> Ledger {
    Ledger::read(&workspace_root().unwrap()).unwrap()
}

#[test]
fn every_claim_of_a_complete_paragraph_is_computed() {
    let faults = ledger().faults();
    assert!(
        faults.is_empty(),
        "the ledger has {} faults:\n{}",
        faults.len(),
        faults.join("\n")
    );
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
        assert!(
            claim.id.starts_with(&expected),
            "{} is filed under {}",
            claim.id,
            claim.section
        );
        assert!(
            !claim.statement.is_empty() && !claim.title.is_empty(),
            "{}",
            claim.id
        );
    }
    for paragraph in COMPLETE {
        assert!(
            ledger.claims.iter().any(|claim| must_be_settled(claim)
                && (claim.section == *paragraph
                    || claim.section.starts_with(&format!("{paragraph}.")))),
            "no claim belongs to {paragraph}"
        );
    }
}

#[test]
fn every_claim_is_on_the_claims_page_and_in_the_table() {
    let ledger = ledger();
    let page = press::appendix::page(&ledger);
    let table = press::appendix::table(&ledger);
    for claim in &ledger.claims {
        assert!(
            page.contains(&format!("id=\"{}\"", claim.id)),
            "{} is not on the page",
            claim.id
        );
        assert!(
            table
                .lines()
                .any(|line| line.split_whitespace().next() == Some(&claim.id)),
            "{} is not in the table",
            claim.id
        );
    }
}

#[test]
fn the_pages_say_what_the_register_says() {
    let ledger = ledger();
    let legend = include_str!("../../src/claims.md").to_lowercase();
    for claim in &ledger.claims {
        let word = claim.verdict.word();
        assert!(legend.contains(&format!("**{word}**:")), "{word}");
    }
    let of = |verdict| ledger.claims.iter().filter(move |c| c.verdict == verdict);
    assert_eq!(of(Verdict::Erratum).count(), 8);
    assert!(include_str!("../../src/errata.md").contains("eight are wrong"));
    // Grains that lock, and why the long axis: for these two the chapters have models and no answer. Any other question is
    // answered by a test and a block, or its verdict is not a question.
    let open: Vec<_> = of(Verdict::OpenQuestion).map(|c| c.id.as_str()).collect();
    assert_eq!(open, ["C3.5-4", "C4.10-1"]);
}
