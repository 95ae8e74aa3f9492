//! Units do not matter: the scene files of the book, told in other units of time, length and mass.

use spinning_bodies::scene::files::{KeyRow, keys, parse};
use spinning_bodies::scene::{Around, Sight, Solid};
use std::fs;

/// How many of the new units are in an old one: powers of two, so that nothing is rounded.
const UNITS: [(&str, f64); 7] = [
    ("s", 8.0),
    ("m", 1.0 / 16.0),
    ("kg", 32.0),
    ("N", 1.0 / 32.0),
    ("J", 1.0 / 512.0),
    ("rad", 1.0),
    ("1", 1.0),
];

/// The same for a unit such as `kg m²/s`; none for other words.
fn factor(unit: &str) -> Option<f64> {
    let product = |words: &str| {
        words.split(' ').try_fold(1.0, |product, word| {
            let power = 1 + i32::from(word.ends_with('²')) + 2 * i32::from(word.ends_with('³'));
            let word = word.trim_end_matches(['²', '³']);
            let known = UNITS.iter().find(|(name, _)| *name == word)?;
            Some(product * known.1.powi(power))
        })
    };
    let (above, below) = unit.split_once('/').unwrap_or((unit, "1"));
    Some(product(above)? / product(below)?)
}

/// The same for what is expected of a key, "the speed in m/s below which friction fades".
fn expected(row: &KeyRow) -> Option<f64> {
    row.expected.split(" in ").skip(1).find_map(|rest| {
        let words: Vec<_> = rest.split([' ', ',', ';']).collect();
        let unit = |n: usize| factor(&words[..n].join(" "));
        (1..=words.len()).rev().find_map(unit)
    })
}

/// A scene file in the new units.
fn otherwise(kind: &str, text: &str) -> String {
    let rows = [kind, "shapes", "run"]
        .map(|kind| keys(kind).unwrap())
        .concat();
    let mut section = "";
    let mut told = String::new();
    for line in text.lines().map(|line| line.split(" #").next().unwrap()) {
        if line.starts_with('[') {
            section = line.trim().trim_matches(['[', ']']);
        }
        let key = line.split('=').next().unwrap();
        let known =
            |row: &&KeyRow| row.key == key.trim() && (row.section == section || section == "body");
        let row = rows.iter().find(known);
        let times = match row {
            Some(row) if row.key == "friction" && text.contains("\"viscous\"") => factor("s/m"),
            row => row.and_then(expected),
        };
        let times = times.unwrap_or(1.0);
        // A rate and a pure number.
        let alone = row.is_some_and(|row| row.expected.contains(" and mu_2"));
        let mut numbers = 0;
        for piece in line.split_inclusive(['=', ',', '[', ']']) {
            let number = piece.trim_end_matches([',', ']']);
            match number.trim().parse::<f64>() {
                Ok(x) if times != 1.0 && !(alone && numbers > 0) => {
                    told += &format!(" {:?}{}", x * times, &piece[number.len()..]);
                    numbers += 1;
                }
                _ => told += piece,
            }
        }
        told.push('\n');
    }
    told
}

/// All lengths that are seen, m.
fn lengths(sight: &Sight) -> Vec<f64> {
    let solids = sight.solids.iter().map(|(solid, stands)| {
        let sizes = match solid {
            Solid::Ellipsoid(half_axes) => half_axes.as_slice().to_vec(),
            Solid::Turned(outline) => outline.concat(),
            Solid::Cuboid(sizes) | Solid::Bar(sizes) => sizes.as_slice().to_vec(),
        };
        [&sizes, stands.translation.vector.as_slice()].concat()
    });
    let ceiling = match sight.around {
        Around::Under(height) => vec![height],
        _ => Vec::new(),
    };
    solids
        .chain([ceiling, sight.place.as_slice().to_vec()])
        .flatten()
        .collect()
}

#[test]
fn the_unit_does_not_matter() {
    let scenes = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/scenes");
    let mut count = 0;
    for file in fs::read_dir(scenes).unwrap() {
        let path = file.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap();
        let mut text = fs::read_to_string(&path).unwrap();
        let kind = text.lines().find_map(|line| line.strip_prefix("kind = "));
        let kind = kind.map_or("top", |kind| kind.trim_matches('"')).to_owned();
        // A body that is taken for granted has sizes, too.
        if !text.contains("[body]") {
            text += "[body]\n";
            for row in keys(&kind)
                .unwrap()
                .iter()
                .filter(|row| row.section == "body")
            {
                text += &format!("{} = {}\n", row.key, row.absent.as_ref().unwrap());
            }
        }
        let tables = [text.clone(), otherwise(&kind, &text)].map(|text| {
            let (scene, request) =
                parse(name, &text).unwrap_or_else(|told| panic!("{told}\n{text}"));
            let names: Vec<_> = scene.columns().iter().map(|column| column.name).collect();
            let scene = scene.telling(&names).unwrap();
            let table = scene.simulate(&request).unwrap();
            (scene, table)
        });
        let [(seen, here), (seen_there, there)] = &tables;
        assert_eq!(here.cost, there.cost, "{name}");
        assert_eq!(here.error_estimate, there.error_estimate, "{name}");
        assert!(
            here.error_estimate > 0.0 && !here.plan.reason.is_empty(),
            "{name}"
        );
        for (a, b) in here.ledger.entries().iter().zip(there.ledger.entries()) {
            assert_eq!(a.relative_drift(), b.relative_drift(), "{name}: {}", a.name);
        }
        for ((t, row), (other, again)) in here.rows().zip(there.rows()) {
            assert_eq!(other, 8.0 * t, "{name}");
            let sights = [
                seen.sight(&here.columns, &row),
                seen_there.sight(&there.columns, &again),
            ];
            // From moments alone a body is drawn as if it had a kilogram.
            let known = !["racket.toml", "swivel.toml"].contains(&name);
            let [a, b] = sights.map(Option::unwrap);
            let expected: Vec<_> = lengths(&a).iter().map(|x| x / 16.0).collect();
            assert!(!known || lengths(&b) == expected, "{name} at {t}");
            assert_eq!(b.omega, a.omega / 8.0, "{name} at {t}");
            // Of a strip, for each metre of it.
            let strip = name == "strip.toml";
            let momentum = factor(if strip { "kg m/s" } else { "kg m²/s" }).unwrap();
            assert_eq!(b.angular_momentum, a.angular_momentum.map(|l| l * momentum));
            for ((column, a), b) in here.columns.iter().zip(row).zip(again) {
                let times = factor(column.unit).unwrap_or_else(|| panic!("{}", column.unit));
                assert_eq!(b, times * a, "{name}: {} at {t}", column.name);
            }
        }
        count += 1;
    }
    assert!(count > 20);
}
