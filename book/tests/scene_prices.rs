//! The page "Scenes" names every kind, every key with what it expects, every effect and every column; its tables of prices are
//! those of the scenes as they are.

use std::collections::BTreeSet;

use press::scenes::prices::{NEEDED, PRICED, run};
use press::scenes::{kinds, simulate};

const PAGE: &str = include_str!("../src/scenes.md");
const PRICES: &str = include_str!("../src/tables/scene-prices.csv");
const TIMES: &str = include_str!("../src/tables/scene-times.csv");

fn rows(csv: &str) -> Vec<Vec<&str>> {
    let lines = csv.lines().filter(|line| !line.starts_with('#')).skip(1);
    lines.map(|line| line.split(',').collect()).collect()
}

#[test]
fn every_kind_is_priced() {
    let priced: Vec<&str> = PRICED.iter().map(|priced| priced.kind).collect();
    assert_eq!(priced, kinds());
}

#[test]
fn the_page_names_every_key_and_every_column() {
    let mut missing = Vec::new();
    for priced in PRICED {
        let heading = format!("\n### `{}`", priced.kind);
        let start = PAGE.find(&heading).unwrap_or_else(|| panic!("no{heading}"));
        let rest = &PAGE[start + heading.len()..];
        let end = rest.find("\n##").unwrap_or(rest.len());
        for asked in priced.keys().unwrap() {
            if ["", "run"].contains(&asked.section) {
                continue;
            }
            let row = format!("| {} | `{}` | {} |", asked.section, asked.key, asked.what);
            if !rest[..end].contains(&row) {
                missing.push(format!("{}: {row}", priced.kind));
            }
        }
        let columns = run(priced.kind, &priced.file(|_| true)).unwrap().columns;
        let row = format!("`t,{}`", columns.join(","));
        if !rest[..end].contains(&row) {
            missing.push(format!("{}: {row}", priced.kind));
        }
    }
    // `[run]` and what stands at the top are the same for all.
    for asked in PRICED[0].keys().unwrap() {
        if ["", "run"].contains(&asked.section) && !PAGE.contains(&format!("`{}`", asked.key)) {
            missing.push(format!("`{}`", asked.key));
        }
    }
    assert!(missing.is_empty(), "the page lacks\n{}", missing.join("\n"));
}

#[test]
fn the_table_of_prices_is_that_of_the_scenes() {
    let rows = rows(PRICES);
    let mut rows = rows.iter();
    for priced in PRICED {
        for (place, (effect, _)) in priced.effects.iter().enumerate() {
            let row = rows.next().expect("a row an effect");
            assert_eq!(row[..2], [priced.kind, *effect]);
            let (without, with) = priced.pair(place);
            assert_eq!(without.is_none(), NEEDED.contains(&(priced.kind, effect)));
            for (text, solver, told) in [(without, row[2], row[4]), (Some(with), row[3], row[5])] {
                let Some(text) = text else { continue };
                let table = run(priced.kind, &text).unwrap();
                assert_eq!(table.plan.solver.name(), solver, "{} {effect}", priced.kind);
                let (now, told) = (table.cost.evaluations as f64, told.parse::<f64>().unwrap());
                // Another rounding of the last digit may cost a step more or less.
                assert!(
                    (now - told).abs() <= 0.02 * told,
                    "{} {effect}: {now}",
                    priced.kind
                );
            }
        }
    }
    assert!(rows.next().is_none());
}

#[test]
fn the_table_of_times_has_every_file() {
    let listed: BTreeSet<String> = rows(TIMES).iter().map(|row| row[0].to_owned()).collect();
    let mut files = BTreeSet::new();
    for entry in std::path::Path::new("scenes").read_dir().unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        let row = rows(TIMES).into_iter().find(|row| row[0] == name);
        let row = row.unwrap_or_else(|| panic!("{name} is not in the table"));
        let (table, _) = simulate(&path).unwrap();
        assert_eq!(table.plan.solver.name(), row[1], "{name}");
        files.insert(name);
    }
    assert_eq!(files, listed);
}
