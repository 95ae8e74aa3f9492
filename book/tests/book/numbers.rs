//! A number that stands in the prose and beside a figure is one number.

use press::chapters::{self, CHAPTERS};
use press::ledger::markdown_options;
use pulldown_cmark::{Event, Parser, Tag, TagEnd};

/// Two numbers this near, of three digits or more, are meant as the same one: in the prose, in the code.
const NEAR: [f64; 2] = [0.02, 0.003];

/// Different numbers that happen to be near: chapter, in prose or code, beside the figure, what they are.
#[rustfmt::skip]
const DIFFERENT: &[(&str, &str, &str, &str)] = &[
    ("euler-top", "0.715", "0.7236", "a time; radius of a herpolhode"),
    ("euler-top", "0.715", "0.724", "a time; radius of a herpolhode"),
    ("euler-top", "1.0024", "1.021", "a solid angle; half a period of the racket"),
    ("euler-top", "1.026", "1.021", "a day on Mars; a ratio of moments"),
    ("euler-top", "5.38", "5.37", "published in 2015; computed"),
    ("euler-top", "5.41", "5.37", "published in 1995; computed"),
    ("euler-top", "7.35", "7.41", "published in 1995; computed"),
    ("euler-top", "7.40", "7.41", "published in 2015; computed"),
    ("euler-top", "50.5", "49.8", "Toutatis from two periods; from its moments"),
    ("euler-top", "50.5", "50.6", "Toutatis from two periods; from its moments"),
    ("euler-top", "51.2", "50.6", "Toutatis from two periods; from its moments"),
    ("falling-strip", "13.3", "13.36", "periods at different widths"),
    ("falling-strip", "1.21", "1.219", "a width; the critical one"),
    ("falling-strip", "1.21", "1.22", "a width; the critical one"),
    ("lagrange-top", "2.35", "2.3787", "a per cent; a ratio"),
    ("lagrange-top", "2.974", "2.92", "a rate of the wooden top; its dip"),
    ("tippe-top", "2.37", "2.35", "seconds of the toy; millijoules of the climb"),
    ("tippe-top", "2.369", "2.35", "seconds of the toy; millijoules of the climb"),
    ("yo-yo", "0.626", "0.627", "a place just above that of the greatest speed"),
    ("yo-yo", "0.628", "0.627", "a place just below that of the greatest speed"),
];

/// A decimal as it stands there.
#[derive(Debug, Clone, PartialEq)]
struct Decimal {
    text: String,
    value: f64,
    /// Its last digit is worth ten to the minus this.
    digits: i32,
}

impl Decimal {
    /// Whether one could be the other, rounded.
    fn agrees(&self, other: &Decimal) -> bool {
        let unit = 10f64.powi(-self.digits.min(other.digits));
        (self.value - other.value).abs() <= 0.5 * unit * (1.0 + 1e-9)
    }

    fn is_near(&self, other: &Decimal, near: f64) -> bool {
        (self.value - other.value).abs() <= near * self.value.min(other.value)
    }
}

/// The decimals of three significant digits or more in a text, with a power of ten that follows; a number alone in parentheses is a
/// paragraph of the tutorial.
fn decimals(text: &str) -> Vec<Decimal> {
    let mut found = Vec::new();
    let mut rest = text;
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
        let before = &rest[..start];
        let bound = before.ends_with(|c: char| c.is_ascii_alphabetic() || "._".contains(c));
        let opened = before.ends_with(" (");
        rest = &rest[start..];
        let end = rest.find(|c: char| !c.is_ascii_digit() && c != '.');
        let (word, after) = rest.split_at(end.unwrap_or(rest.len()));
        let paragraph = opened && after.starts_with(')');
        rest = after;
        let word = word.trim_end_matches('.');
        let Some((_, fraction)) = word.split_once('.') else {
            continue;
        };
        let significant = word.replace('.', "").trim_start_matches('0').len();
        let exponent = power_of_ten(after);
        let counts = significant >= 3 && !bound && !paragraph;
        if let (Ok(value), true) = (word.parse::<f64>(), counts) {
            found.push(Decimal {
                text: word.to_owned(),
                value: value * 10f64.powi(exponent),
                digits: fraction.len() as i32 - exponent,
            });
        }
    }
    found
}

/// The exponent of `\cdot10^{-4}`, `·10⁻⁴` or `e-4` at the start of a text; 0 if there is none.
fn power_of_ten(text: &str) -> i32 {
    let text: String = text
        .chars()
        .take(24)
        .filter(|c| !c.is_whitespace())
        .collect();
    let raised = |c: char| "⁰¹²³⁴⁵⁶⁷⁸⁹⁻".chars().position(|digit| digit == c);
    let plain = |c: char| "0123456789-".chars().nth(raised(c)?);
    let begins = |times: &&str| text.strip_prefix(times);
    let digits: String = match ["·10", "×10"].iter().find_map(begins) {
        Some(power) => power.chars().map_while(plain).collect(),
        None => {
            let times = ["\\cdot10^", "\\,\\cdot10^", "\\times10^", "e"];
            let power = times
                .iter()
                .find_map(begins)
                .unwrap_or("")
                .trim_start_matches('{');
            power
                .chars()
                .take_while(|c| c.is_ascii_digit() || *c == '-')
                .collect()
        }
    };
    digits.parse().unwrap_or(0)
}

/// Prose, visible code and tables of a chapter; formulas belong to the prose.
fn parts(source: &str) -> [String; 3] {
    let (mut prose, mut code, mut tables) = (String::new(), String::new(), String::new());
    let (mut in_table, mut in_code) = (false, false);
    for event in Parser::new_ext(source, markdown_options()) {
        match event {
            Event::Start(Tag::Table(_)) => in_table = true,
            Event::End(TagEnd::Table) => in_table = false,
            Event::Start(Tag::CodeBlock(_)) => in_code = true,
            Event::End(TagEnd::CodeBlock) => in_code = false,
            Event::Text(text) if in_code => {
                let seen = |line: &&str| !line.trim_start().starts_with("# ");
                code.extend(text.lines().filter(seen).flat_map(|line| [line, "\n"]));
            }
            Event::Text(text) | Event::InlineMath(text) | Event::DisplayMath(text) => {
                if in_table { &mut tables } else { &mut prose }.push_str(&text);
            }
            Event::End(_) | Event::SoftBreak => {
                prose.push(' ');
                tables.push(' ');
            }
            _ => {}
        }
    }
    [prose, code, tables]
}

#[test]
fn prose_and_figures_say_the_same_number() {
    let root = press::paths::workspace_root().unwrap();
    let mut used = vec![false; DIFFERENT.len()];
    let mut faults = Vec::new();
    for &chapter in CHAPTERS {
        let source = chapters::source(&root, chapter).unwrap();
        let [prose, code, mut beside] = parts(&source);
        for line in source.lines() {
            let name = line.strip_prefix("{{#include tables/");
            if let Some(name) = name.and_then(|name| name.strip_suffix("}}")) {
                let table = root.join("book/src/tables").join(name);
                beside += &std::fs::read_to_string(table).unwrap();
            }
        }
        let shown = |name: &str| source.contains(&format!("{{{{figure {name}}}}}"));
        for drawing in super::DRAWINGS.iter().filter(|one| shown(one.entry.name)) {
            let figure = &drawing.figure;
            let values = figure.values.iter().map(|(_, text)| text);
            for text in [&figure.claim, &figure.details, &figure.alt]
                .into_iter()
                .chain(values)
            {
                beside += &format!(" {text}");
            }
        }
        let beside = decimals(&beside);
        let prose = decimals(&prose).into_iter().map(|number| (number, NEAR[0]));
        let code = decimals(&code.replace('_', "")).into_iter();
        for (number, near) in prose.chain(code.map(|number| (number, NEAR[1]))) {
            if beside.iter().any(|other| number.agrees(other)) {
                continue;
            }
            for other in beside.iter().filter(|other| number.is_near(other, near)) {
                let allowed = DIFFERENT.iter().position(|(name, a, b, _)| {
                    (*name, *a, *b) == (chapter, number.text.as_str(), other.text.as_str())
                });
                match allowed {
                    Some(k) => used[k] = true,
                    None => faults.push(format!(
                        "{}: {} in prose or code, {} beside a figure or in a table",
                        chapter, number.text, other.text
                    )),
                }
            }
        }
    }
    for (allowed, _) in DIFFERENT.iter().zip(used).filter(|(_, used)| !used) {
        faults.push(format!("take it off the list: {allowed:?}"));
    }
    faults.sort();
    faults.dedup();
    super::none(&faults);
}

#[test]
fn numbers_that_differ_are_told_from_rounded_ones() {
    let pair = |a: &str, b: &str| (decimals(a).remove(0), decimals(b).remove(0));
    for (a, b, same) in [
        ("77.2 °", "77.1", false),
        ("0.826", "0.825", false),
        ("$1.25\\cdot10^{-4}$", "1.26·10⁻⁴", false),
        ("77.2.", "77.18", true),
        ("0.825", "0.8250", true),
        ("12.5e-5", "0.000125", true),
    ] {
        let (a, b) = pair(a, b);
        assert!(
            a.is_near(&b, NEAR[0]) && a.agrees(&b) == same,
            "{a:?}, {b:?}"
        );
    }
    assert!(decimals("4.7, C4.75-1, f64, 300").is_empty());
}
