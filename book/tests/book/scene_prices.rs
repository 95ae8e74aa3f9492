//! The page "Scenes" names every kind, every key with what it expects, every effect and every column; its tables of prices are
//! those of the scenes as they are.

use std::collections::BTreeSet;

use super::kept;
use super::priced::PRICED;
use press::scenes::{key_table, run, simulate};
use spinning_bodies::scene::files::{keys, kinds};

const PAGE: &str = include_str!("../../src/scenes.md");
const PRICES: &str = include_str!("../../src/tables/scene-prices.csv");
const TIMES: &str = include_str!("../../src/tables/scene-times.csv");

fn rows(csv: &str) -> Vec<Vec<&str>> {
    let lines = csv.lines().filter(|line| !line.starts_with('#')).skip(1);
    lines.map(|line| line.split(',').collect()).collect()
}

#[test]
fn every_kind_is_priced() {
    let priced: Vec<&str> = PRICED.iter().map(|priced| priced.kind.as_str()).collect();
    assert_eq!(priced, kinds().collect::<Vec<_>>());
}

#[test]
fn the_page_has_every_key_and_every_column() {
    for name in ["run", "shapes"].into_iter().chain(kinds()) {
        let keys = keys(name).unwrap();
        let of = if name == "shapes" { "shape" } else { "table" };
        kept(&format!("src/tables/keys-{name}.md"), &key_table(of, &keys));
    }
    let mut missing = Vec::new();
    for priced in PRICED.iter() {
        let heading = format!("\n### `{}`", priced.kind);
        let start = PAGE.find(&heading).unwrap_or_else(|| panic!("no{heading}"));
        let rest = &PAGE[start + heading.len()..];
        let end = rest.find("\n##").unwrap_or(rest.len());
        let columns = run(&priced.kind, &priced.file(|_| true)).unwrap().columns;
        let names: Vec<&str> = columns.iter().map(|column| column.name).collect();
        let include = format!("{{{{#include tables/keys-{}.md}}}}", priced.kind);
        for row in [include, format!("`t,{}`", names.join(","))] {
            if !rest[..end].contains(&row) {
                missing.push(format!("{}: {row}", priced.kind));
            }
        }
    }
    assert!(missing.is_empty(), "the page lacks\n{}", missing.join("\n"));
}

#[test]
fn the_table_of_prices_is_that_of_the_scenes() {
    let rows = rows(PRICES);
    let mut rows = rows.iter();
    for priced in PRICED.iter() {
        for (effect, _) in &priced.effects {
            let row = rows.next().expect("a row an effect");
            assert_eq!(row[..2], [&priced.kind, effect]);
            let (without, with) = priced.pair(effect);
            assert_eq!(without.is_none(), priced.needed.contains(effect));
            for (text, solver, told) in [(without, row[2], row[4]), (Some(with), row[3], row[5])] {
                let Some(text) = text else { continue };
                let table = run(&priced.kind, &text).unwrap();
                assert_eq!(table.plan.solver.name(), solver, "{} {effect}", priced.kind);
                let (now, told) = (table.cost.evaluations as f64, told.parse::<f64>().unwrap());
                // Another rounding of the last digit may cost a step more or less.
                let near = (now - told).abs() <= 0.02 * told;
                assert!(near, "{} {effect}: {now}", priced.kind);
            }
        }
    }
    assert!(rows.next().is_none());
}

/// The Markdown table of the book's files, from the measurements of the bench.
fn times(csv: &str) -> String {
    let lines: Vec<&str> = csv.lines().collect();
    let (first, rows) = lines.split_first().unwrap();
    let machine = first.trim_start_matches(['#', ' ']);
    let head = "| file | solver | evaluations | ms | at $10^{-9}$ | ms |\n";
    let mut text = format!("{head}|---|---|--:|--:|--:|--:|\n");
    for row in rows.iter().skip(1) {
        let cells: Vec<String> = row.split(',').enumerate().map(cell).collect();
        text += &format!("| {} |\n", cells.join(" | "));
    }
    text + &format!("\n*{machine}, least of repeated runs.*\n")
}

/// A cell of that table: milliseconds with two digits, no evaluations as a dash.
fn cell((column, text): (usize, &str)) -> String {
    match (column, text.parse::<f64>()) {
        (2 | 4, Ok(0.0)) => "–".to_owned(),
        (3 | 5, Ok(time)) if time < 9.95 => format!("{time:.2}"),
        (3 | 5, Ok(time)) => format!("{time:.0}"),
        _ => text.to_owned(),
    }
}

#[test]
fn the_table_of_times_has_every_file() {
    kept("src/tables/scene-times.md", &times(TIMES));
    let listed: BTreeSet<String> = rows(TIMES).iter().map(|row| row[0].to_owned()).collect();
    let mut files = BTreeSet::new();
    for entry in std::path::Path::new("scenes").read_dir().unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        let row = rows(TIMES).into_iter().find(|row| row[0] == name);
        let row = row.unwrap_or_else(|| panic!("{name} is not in the table"));
        let table = simulate(&path).unwrap();
        assert_eq!(table.plan.solver.name(), row[1], "{name}");
        files.insert(name);
    }
    assert_eq!(files, listed);
}

/// No plan is so bad that one effect more would make the scene quicker by more than 20 µs, but for two that are named.
#[test]
fn an_effect_more_does_not_make_a_scene_quicker() {
    // Resistance stops the body on the table, and the closed forms of a yo-yo take longer than the few steps that its air asks for.
    let quicker = [("table-top", "rolling_resistance"), ("yo-yo", "air_drag")];
    for row in rows(PRICES) {
        let [kind, effect, .., without, with] = row[..] else {
            panic!("{row:?}")
        };
        if without.is_empty() || quicker.contains(&(kind, effect)) {
            continue;
        }
        let (without, with): (f64, f64) = (without.parse().unwrap(), with.parse().unwrap());
        assert!(
            without - with <= 0.020,
            "{kind} {effect}: {without} ms, then {with} ms"
        );
    }
}
