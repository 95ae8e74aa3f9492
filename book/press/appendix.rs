//! The ledger as a page of the book and as a table on the terminal.

use crate::ledger::{Claim, IN_CHAPTERS, Kind, Ledger, Place, Verdict};
use crate::pieces::{inert, unbroken};
use regex::{Captures, Regex};
use std::sync::LazyLock;

/// Anchor of the first place where a chapter names a claim.
pub fn place_id(chapter: &str, claim: &str) -> String {
    format!("{chapter}-{claim}")
}

/// The claims page, as Markdown: a summary, then every claim with its verdict and the places that compute it.
pub fn page(ledger: &Ledger) -> String {
    let mut out = summary(ledger);
    for (number, title) in &ledger.sections {
        out.push_str(&format!("\n## {number}. {title}\n\n"));
        for claim in of_section(ledger, number) {
            out.push_str(&row(ledger, claim));
        }
    }
    out
}

fn of_section<'a>(ledger: &'a Ledger, number: &'a str) -> impl Iterator<Item = &'a Claim> {
    let section = move |claim: &&Claim| claim.section.split('.').next() == Some(number);
    ledger.claims.iter().filter(move |claim| section(claim))
}

fn summary(ledger: &Ledger) -> String {
    let mut out = String::from(
        "| Section | Claims | Computed | Spoken of | Not yet |\n|:---|---:|---:|---:|---:|\n",
    );
    for (number, title) in &ledger.sections {
        let [claims, computed, spoken, open] = count(ledger, of_section(ledger, number));
        let anchor = mdbook_anchor(&format!("{number}. {title}"));
        out.push_str(&format!(
            "| [{number}. {title}](#{anchor}) | {claims} | {computed} | {spoken} | {open} |\n"
        ));
    }
    let [claims, computed, spoken, open] = count(ledger, ledger.claims.iter());
    out.push_str(&format!(
        "| **All** | **{claims}** | **{computed}** | **{spoken}** | **{open}** |\n"
    ));
    out
}

/// Numbers of claims: all, computed, discussed (where there is nothing to compute), still missing.
pub fn count<'a>(ledger: &Ledger, claims: impl Iterator<Item = &'a Claim>) -> [usize; 4] {
    let mut counts = [0; 4];
    for claim in claims {
        counts[0] += 1;
        let settled = ledger.missing(claim).is_empty();
        counts[match claim.verdict.is_computed() {
            _ if !settled => 3,
            true => 1,
            false => 2,
        }] += 1;
    }
    counts
}

/// The id mdBook gives a heading: letters and digits in lower case, spaces as dashes, the rest dropped.
pub fn mdbook_anchor(heading: &str) -> String {
    let kept = |c: char| match c {
        c if c.is_alphanumeric() || c == '_' || c == '-' => Some(c.to_ascii_lowercase()),
        c if c.is_whitespace() => Some('-'),
        _ => None,
    };
    heading.chars().filter_map(kept).collect()
}

/// One claim. A single line of HTML, so that Markdown leaves it alone.
fn row(ledger: &Ledger, claim: &Claim) -> String {
    let chapters = ledger.places(&claim.id, IN_CHAPTERS);
    let mut chapters: Vec<&str> = chapters.map(|place| place.file.as_str()).collect();
    chapters.dedup();
    let link = |chapter: &&str| {
        let place = place_id(chapter, &claim.id);
        format!("<a href=\"{chapter}.html#{place}\">{}</a>", inert(chapter))
    };
    let test = |place: &Place| {
        let file = place.file.strip_prefix("tests/").unwrap_or(&place.file);
        let file = file.trim_end_matches(".rs");
        let test = format!("{file}::{}", place.spot);
        format!("<code>{}</code>", inert(&test))
    };
    let verdict = claim.verdict.to_string();
    let mut places: Vec<String> = chapters.iter().map(link).collect();
    places.extend(ledger.places(&claim.id, &[Kind::Test]).map(test));
    if !ledger.missing(claim).is_empty() {
        places.push("<em>not yet</em>".into());
    }
    format!(
        "<div class=\"claim\" id=\"{id}\"><p class=\"claim-head\"><span class=\"claim-id\">{id}</span> \
         <strong>{title}</strong> <span class=\"verdict {class}\">{verdict}</span></p>\
         <p class=\"claim-statement\">{statement}</p><p class=\"claim-places\">{places}</p></div>\n\n",
        id = claim.id,
        title = inert(&claim.title),
        class = verdict.replace(", ", "-").replace(' ', "-"),
        statement = with_indices(&inert(&unbroken(&claim.statement))),
        places = places.join(" · "),
    )
}

/// The register is plain text: `L_vert`, `V_{n−1}` and `I₁` have an index, `w^{−1}` a power. Few fonts have small digits of their own.
fn with_indices(html: &str) -> String {
    static INDEX: LazyLock<Regex> = LazyLock::new(|| {
        let pattern = r"&#(95|94);(?:&#123;(.+?)&#125;|(\w+))|([₀-₉]+)";
        Regex::new(pattern).expect("it is well formed")
    });
    let digit = |c: char| char::from_digit(u32::from(c) - u32::from('₀'), 10);
    let set = |found: &Captures<'_>| {
        if let Some(small) = found.get(4) {
            let digits: String = small.as_str().chars().filter_map(digit).collect();
            return format!("<sub>{digits}</sub>");
        }
        let tag = if &found[1] == "95" { "sub" } else { "sup" };
        let letters = found.get(2).or(found.get(3)).map_or("", |one| one.as_str());
        format!("<{tag}>{letters}</{tag}>")
    };
    INDEX.replace_all(html, set).into_owned()
}

/// The ledger for the terminal: id, verdict, title, chapter and test of every claim.
pub fn table(ledger: &Ledger) -> String {
    let row = |[claim, verdict, title, chapter, test]: [&str; 5]| {
        let row = format!("{claim:7}  {verdict:26}  {title:43}  {chapter:23}  {test}");
        row.trim_end().to_owned() + "\n"
    };
    let mut out = row(["claim", "verdict", "title", "chapter", "test"]);
    for claim in &ledger.claims {
        let chapter = ledger.places(&claim.id, IN_CHAPTERS).next();
        let chapter = chapter.map(|place| format!("{}.md:{}", place.file, place.spot));
        let test = ledger.places(&claim.id, &[Kind::Test]).next();
        let test = test.map(|place| format!("{} {}", place.file, place.spot));
        let absent = |is_needed: bool| if is_needed { "not yet" } else { "-" };
        out += &row([
            &claim.id,
            &claim.verdict.to_string(),
            &claim.title,
            chapter.as_deref().unwrap_or(absent(true)),
            test.as_deref()
                .unwrap_or(absent(claim.verdict.is_computed())),
        ]);
    }
    let [claims, computed, spoken, open] = count(ledger, ledger.claims.iter());
    let questions = ledger.claims.iter();
    let questions = questions.filter(|claim| claim.verdict == Verdict::OpenQuestion);
    out.push_str(&format!(
        "\n{claims} claims: {computed} computed, {spoken} spoken of, {open} not yet ({} open questions).\n",
        questions.count()
    ));
    out
}
