//! Units do not matter: the scene files of the book, and what is left of each without one of its lines, told in other units of time, length and mass.

use spinning_bodies::scene::files::{KeyRow, keys, parse};
use spinning_bodies::scene::{AnyScene, Around, Sight, Solid, Table};
use std::fs;

/// How many of the new seconds, metres and kilograms are in an old one: powers of two, so that nothing is rounded. In the last two, the square or the cube
/// of a moment of inertia leaves the range of doubles.
const UNITS: [Units; 4] = [[3, -4, 6], [-3, 4, -6], [0, 200, 0], [0, -200, -300]];

type Units = [i32; 3];

/// The same for a unit such as `kg m²/s`; none for other words.
fn factor(unit: &str, [second, metre, kilogram]: Units) -> Option<f64> {
    let exponent = |words: &str| {
        words.split(' ').try_fold(0, |sum, word| {
            let power = 1 + i32::from(word.ends_with('²')) + 2 * i32::from(word.ends_with('³'));
            let known = match word.trim_end_matches(['²', '³']) {
                "s" => second,
                "m" => metre,
                "kg" => kilogram,
                "N" => kilogram + metre - 2 * second,
                "J" => kilogram + 2 * metre - 2 * second,
                "rad" | "1" => 0,
                _ => return None,
            };
            Some(sum + power * known)
        })
    };
    let (above, below) = unit.split_once('/').unwrap_or((unit, "1"));
    Some(2_f64.powi(exponent(above)? - exponent(below)?))
}

/// The same for what is expected of a key, "the speed in m/s below which friction fades".
fn expected(row: &KeyRow, units: Units) -> Option<f64> {
    row.expected.split(" in ").skip(1).find_map(|rest| {
        let words: Vec<_> = rest.split([' ', ',', ';']).collect();
        let unit = |n: usize| factor(&words[..n].join(" "), units);
        (1..=words.len()).rev().find_map(unit)
    })
}

/// A scene file in the new units.
fn otherwise(kind: &str, text: &str, units: Units) -> String {
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
            Some(row) if row.key == "friction" && text.contains("\"viscous\"") => {
                factor("s/m", units)
            }
            row => row.and_then(|row| expected(row, units)),
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
    let places = [ceiling, sight.place.as_slice().to_vec()];
    solids.chain(places).flatten().collect()
}

/// A free body of every shape but beads and meshes.
fn shapes() -> Vec<(String, String)> {
    let rows = keys("shapes").unwrap();
    let file = |shape: &str| {
        let mut text = format!("[body]\nmass = 2.0\nshape = \"{shape}\"\n");
        for (n, row) in rows.iter().filter(|row| row.section == shape).enumerate() {
            let size = match row.expected.contains("list of 3") {
                true => "[0.1, 0.2, 0.15]".to_owned(),
                false => format!("{:?}", 0.3 / (n + 1) as f64),
            };
            text += &format!("{} = {size}\n", row.key);
        }
        text + "[initial]\nomega = [1.0, 2.0, 3.0]\n[run]\ntimes = [0.5]\n"
    };
    let mut names: Vec<_> = rows.iter().map(|row| row.section.as_str()).collect();
    names.dedup();
    let files = names.iter().map(|name| (format!("a {name}"), file(name)));
    let known = files.filter(|(name, text)| parse(name, text).is_ok());
    known.collect()
}

/// What no scene of the book has: the name of one, a piece of its file, and the lines that take its place.
const OTHERS: &str = r#"
skater: [effects.draw] => [effects]; bearing_friction = 0.3; [effects.draw]
skater: to = 0.2 => to = 1.1; pace = "late"
swivel: [initial]; angular_momentum = 0.0 => [effects]; bearing_friction = 0.3; [initial]; angular_momentum = -1.3
cat: axial = [0.0025, 0.0025] => axial = [0.0025, 0.004]
strip: angle = 0.2 => velocity = [0.3, -0.2]; omega = -5.0
strip: lift = [1.7, 1.1]; drag = [1.7, 1.0] => #
spool: friction = 0.5 => friction = 0.2; rolling_resistance = 0.05
withdrawn-sheet: friction = 0.2 => friction = 0.2; rolling_resistance = 0.02
superball: ceiling = 0.6 => restitution = 0.9; tangential_restitution = 0.8
superball: ceiling = 0.6 => ceiling = 0.6; grip = 0.1
yo-yo: turn_loss = 0.9 => turn_loss = 0.9; hand = 0.05; air_drag = 1.0e-8
yo-yo: turn_loss = 0.9 => sleep = 1.5
yo-yo: turn_loss = 0.9 => sleep = 2.0; axle_friction = 2.313e-3
meteorite: [0.4, 0.4, 0.4] => [0.3, 0.4, 0.5]
nutation-dies: bearing_friction = 2.0e-4 => pivot_friction = 2.0e-5
nutation-dies: bearing_friction = 2.0e-4 => air_drag = 1.0e-6
nutation-dies: [2.0e-4, 2.0e-4, 7.0e-5] => [2.0e-4, 2.5e-4, 7.0e-5]
heavy-body: moments = [0.010, 0.014, 0.020] => inertia = [0.01, 0.014, 0.02, 0.001, -0.002, 0.003]
racket: moments = [0.00121, 0.01638, 0.01748] => inertia = [0.01, 0.014, 0.02, 0.001, -0.002, 0.003]
tippe-top: friction = 0.3 => friction = 0.3; rolling_resistance = 1.0e-4; pivoting_resistance = 1.0e-4
rattleback: friction_law = "no-slip"; [run]; until = 6.0 => friction_law = "coulomb"; friction = 0.3; [run]; until = 1.0
"#;

/// This text with another piece, "axle = 1.0 => axle = 2.0; wound = 3.0", where semicolons stand for ends of lines.
pub(super) fn changed(text: &str, change: &str) -> String {
    let change = change.replace("; ", "\n");
    let (piece, other) = change.split_once(" => ").unwrap();
    assert!(text.contains(piece), "{change}");
    text.replacen(piece, other, 1)
}

/// Scene files of the book by their names, each whole, then, as long as that leaves a scene, without one of its lines, to six digits; and [`OTHERS`].
pub(super) fn files() -> Vec<(String, String)> {
    let scenes = concat!(env!("CARGO_MANIFEST_DIR"), "/../book/scenes");
    let mut files = Vec::new();
    for file in fs::read_dir(scenes).unwrap() {
        let path = file.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        let text = fs::read_to_string(&path).unwrap();
        let lines: Vec<_> = text.lines().collect();
        let run = lines.iter().position(|line| *line == "[run]").unwrap();
        let of_use = |n: &usize| lines[*n].contains(" = ") && !lines[*n].starts_with("title");
        let less = (0..run).filter(of_use).map(|left_out| {
            let kept = lines[..left_out].iter().chain(&lines[left_out + 1..]);
            let kept = kept.filter(|line| !line.starts_with("accuracy"));
            kept.map(|line| format!("{line}\n")).collect::<String>() + "accuracy = 1e-6\n"
        });
        let less = less.filter(|less| parse(&name, less).is_ok());
        files.extend(less.chain([text.clone()]).map(|text| (name.clone(), text)));
        let others = OTHERS.lines().filter_map(|line| line.split_once(": "));
        let others = others.filter(|(of, _)| name.strip_suffix(".toml") == Some(of));
        files.extend(others.map(|(_, change)| (name.clone(), changed(&text, change))));
    }
    files
}

/// Of what lacks a line, which is simulated in the nearest units only.
#[test]
fn nor_does_it_where_a_line_is_missing() {
    let less: Vec<_> = files().into_iter().filter(lacks_a_line).collect();
    assert!(less.len() > 50, "{}", less.len());
    in_other_units(less, &UNITS[..1]);
}

#[test]
fn the_unit_does_not_matter() {
    let mut files = files();
    files.retain(|file| !lacks_a_line(file));
    assert!(files.len() > 40, "{}", files.len());
    // Steps of one length, too.
    let free = files.iter().rfind(|(name, _)| name == "racket.toml");
    let steps = "[run]\nsolver = \"moser-veselov-4\"\naccuracy = 1e-6";
    let free = free.unwrap().1.replace("[run]", steps);
    files.push(("racket.toml".to_owned(), free));
    let shapes = shapes();
    assert!(shapes.len() > 11, "{}", shapes.len());
    files.extend(shapes);
    in_other_units(files, &UNITS);
}

fn lacks_a_line((_, text): &(String, String)) -> bool {
    text.contains("accuracy = 1e-6\n")
}

fn in_other_units(files: Vec<(String, String)>, units: &[Units]) {
    for (name, mut text) in files {
        let kind = text.lines().find_map(|line| line.strip_prefix("kind = "));
        let kind = kind.map_or("top", |kind| kind.trim_matches('"')).to_owned();
        // A body that is taken for granted has sizes, too.
        if !text.contains("[body]") {
            text += "[body]\n";
            let rows = keys(&kind).unwrap();
            for row in rows.iter().filter(|row| row.section == "body") {
                text += &format!("{} = {}\n", row.key, row.absent.as_ref().unwrap());
            }
        }
        let ours = simulated(&name, &text);
        for &units in units {
            let theirs = simulated(&name, &otherwise(&kind, &text, units));
            same_in_other_units(&name, &text, [&ours, &theirs], units);
        }
    }
}

/// The scene of a text, and what it tells in all columns.
fn simulated(name: &str, text: &str) -> (AnyScene, Table) {
    let (scene, request) = parse(name, text).unwrap_or_else(|told| panic!("{told}\n{text}"));
    let names: Vec<_> = scene.columns().iter().map(|column| column.name).collect();
    let scene = scene.telling(&names).unwrap();
    let table = scene.simulate(&request).expect(text);
    (scene, table)
}

fn same_in_other_units(name: &str, text: &str, tables: [&(AnyScene, Table); 2], units: Units) {
    let factor = |unit: &str| factor(unit, units);
    let [(seen, here), (seen_there, there)] = tables;
    let lost = here.ledger.entries().iter().zip(there.ledger.entries());
    assert_eq!(here.cost, there.cost, "{name}\n{text}");
    assert_eq!(here.error_estimate, there.error_estimate, "{name}\n{text}");
    assert!(here.error_estimate > 0.0, "{name}");
    assert!(!here.plan.reason.is_empty(), "{name}");
    for (a, b) in lost {
        assert_eq!(a.relative_drift(), b.relative_drift(), "{name}: {}", a.name);
    }
    for ((t, row), (other, again)) in here.rows().zip(there.rows()) {
        assert_eq!(Some(other), factor("s").map(|s| s * t), "{name}");
        let there = seen_there.sight(&there.columns, &again);
        let sights = [seen.sight(&here.columns, &row), there];
        // From moments alone a body is drawn as if it had a kilogram; of light hands no size follows.
        let metre = match name {
            "racket.toml" | "swivel.toml" => factor("kg m²").unwrap().sqrt(),
            _ => factor("m").unwrap(),
        };
        let [a, b] = sights.map(Option::unwrap);
        let expected: Vec<_> = lengths(&a).iter().map(|x| x * metre).collect();
        let drawn = lengths(&b) == expected || name == "skater.toml" && units != UNITS[0];
        assert!(drawn, "{name} at {t}\n{text}");
        assert_eq!(b.omega, a.omega * factor("1/s").unwrap(), "{name} at {t}");
        // Of a strip, for each metre of it.
        let strip = name == "strip.toml";
        let momentum = factor(if strip { "kg m/s" } else { "kg m²/s" }).unwrap();
        assert_eq!(b.angular_momentum, a.angular_momentum.map(|l| l * momentum));
        for ((column, a), b) in here.columns.iter().zip(row).zip(again) {
            let times = factor(column.unit).unwrap_or_else(|| panic!("{}", column.unit));
            assert_eq!(b, times * a, "{name}: {} at {t}", column.name);
        }
    }
}
