//! The columns of a scene mean what their names say: energies add up, and forces are what moves the centre of mass.

use super::priced::PRICED;
use press::scenes::parse;
use spinning_bodies::scene::files::kinds;

/// The rows of a scene file of the book that tells these numbers at these times.
fn rows<const N: usize>(file: &str, names: [&str; N], times: &[f64]) -> Vec<[f64; N]> {
    let text = std::fs::read_to_string(format!("scenes/{file}.toml")).unwrap();
    let (scene, request) = parse(file, &text).unwrap();
    let request = request.of_times(times).unwrap().to_accuracy(1e-10).unwrap();
    let table = scene.telling(&names).unwrap().simulate(&request);
    table.unwrap().numbers(names).unwrap()
}

/// The first of these numbers is the sum of the others, to 2e-15 of the largest of all.
fn adds_up<const N: usize>(file: &str, names: [&str; N]) {
    let times: Vec<f64> = (0..40).map(|n| 0.031 * f64::from(n)).collect();
    let rows = rows(file, names, &times);
    let largest = rows.iter().flatten().fold(0.0_f64, |a, b| a.max(b.abs()));
    for row in rows {
        let off = row[0] - row[1..].iter().sum::<f64>();
        assert!(off.abs() <= 2e-15 * largest, "{file}: {row:?}");
    }
}

#[test]
fn energy_is_the_sum_of_its_parts() {
    for file in ["tippe-top", "rattleback", "superball"] {
        adds_up(file, ["energy", "translation", "rotation", "potential"]);
    }
    for file in ["heavy-body", "sleeping-top"] {
        adds_up(file, ["energy", "kinetic", "potential"]);
    }
    for file in ["billiard-shot", "spool"] {
        adds_up(file, ["energy", "translation", "rotation"]);
    }
    adds_up("swivel", ["upper", "lower", "twist"]);
    adds_up("crawler", ["front", "rear", "gap"]);
}

/// A thin rod that turns quickly about itself, with an L nearly across its Ω: their product is small beside both.
#[test]
fn all_the_energy_of_a_free_rod_is_kinetic() {
    let body = "[body]\nmoments = [1.0, 1.0, 1e-12]\n[run]\ntimes = [0.0, 7.0]";
    let start = "[initial]\nattitude = [0.6, 0.0, 0.8, 0.0]\nomega = [1.0, 0.3, 1e6]";
    let names = ["energy", "kinetic"];
    let (scene, request) = parse("rod", &format!("{body}\n{start}")).unwrap();
    let table = scene.telling(&names).unwrap().simulate(&request).unwrap();
    for [energy, kinetic] in table.numbers(names).unwrap() {
        assert!((kinetic / energy - 1.0).abs() < 1e-15, "{kinetic} {energy}");
    }
}

/// What becomes of the energy is told twice: as what resistance has taken, and as a flow of its own.
#[test]
fn what_is_lost_is_what_the_start_had_more() {
    let times = [0.0, 0.4, 1.1, 2.5];
    let rows = rows("nutation-dies", ["lost", "energy"], &times);
    for [lost, energy] in &rows {
        assert!((lost + energy - rows[0][1]).abs() <= 1e-15 * rows[0][1]);
    }
    assert!(rows[3][0] > rows[2][0] && rows[2][0] > rows[1][0] && rows[0][0] == 0.0);
}

/// By five places a millisecond apart, to the fourth power of what lies between.
#[test]
fn velocities_are_the_rates_of_places() {
    const STEP: f64 = 1e-3;
    let pairs = "strip x vx, strip y vy, strip angle omega, rattleback x vx, rattleback z vz, tippe-top y vy, \
                 yo-yo depth velocity, paper-cat fall velocity, paper-cat tilt tilt_rate, skater angle spin, swivel lower rate, \
                 crawler center velocity, spool x velocity, spool turned omega, superball x velocity, superball height climb";
    for pair in pairs.split(", ") {
        let [file, place, velocity] = pair.split(' ').collect::<Vec<_>>()[..] else {
            panic!("{pair}")
        };
        for t in [0.131, 0.313, 0.83] {
            let times = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|n| t + n * STEP);
            let rows = rows(file, [place, velocity], &times);
            let [a, b, c, d] = [0, 1, 3, 4].map(|n| rows[n][0]);
            let (rate, told) = ((a - 8.0 * b + 8.0 * c - d) / (12.0 * STEP), rows[2][1]);
            let off = (rate - told).abs();
            assert!(
                off < 1e-4 * told.abs() + 1e-6,
                "{pair} at {t}: {rate} {told}"
            );
        }
    }
}

/// M times the acceleration of C, from its places at three times, and the weight: the force of whatever holds the body.
#[test]
fn forces_are_what_moves_the_centre_of_mass() {
    const STEP: f64 = 1e-3;
    let about = |t: f64| [t - STEP, t, t + STEP];
    let second = |rows: &[f64]| (rows[0] - 2.0 * rows[1] + rows[2]) / (STEP * STEP);
    // A top with friction: mass 0.1 kg, C 0.04 m along axis 3.
    let [fx, fy, fz, f] = ["force_x", "force_y", "force_z", "force"];
    let names = ["nutation", "precession", fx, fy, fz, f, "height"];
    let top = rows("nutation-dies", names, &about(0.7));
    let place = |[tilt, turned, ..]: &[f64; 7]| {
        let level = 0.04 * tilt.sin();
        let [across, along] = [turned.sin(), -turned.cos()].map(|x| level * x);
        [across, along, 0.04 * tilt.cos()]
    };
    let places: Vec<[f64; 3]> = top.iter().map(place).collect();
    let mut size = 0.0_f64;
    for k in 0..3 {
        let along: Vec<f64> = places.iter().map(|place| place[k]).collect();
        let weight = if k == 2 { 0.1 * 9.81 } else { 0.0 };
        let (expected, told) = (0.1 * second(&along) + weight, top[1][2 + k]);
        assert!((expected - told).abs() < 1e-4, "{k}: {expected} {told}");
        size = size.hypot(told);
    }
    assert!((size - top[1][5]).abs() < 1e-15 && (places[1][2] - top[1][6]).abs() < 1e-16);
    // A tippe top while it rises, of 0.02 kg: the table's push and its friction.
    let names = ["vx", "vy", "vz", "reaction", "friction"];
    let top = rows("tippe-top", names, &about(2.0));
    let rate = |k: usize| (top[2][k] - top[0][k]) / (2.0 * STEP);
    let push = 0.02 * (rate(2) + 9.82);
    let level = 0.02 * rate(0).hypot(rate(1));
    let [.., reaction, friction] = top[1];
    assert!((push / reaction - 1.0).abs() < 1e-3, "{push} {reaction}");
    assert!((level / friction - 1.0).abs() < 1e-2, "{level} {friction}");
    assert!(friction > 0.0);
}

/// L in space stays while nothing turns the body; it leans from the axis as L₃ = L cos says.
#[test]
fn angular_momentum_stays_and_leans() {
    let names = ["lx", "ly", "lz", "l", "l_to_axis", "omega3"];
    let rows = rows("racket", names, &[0.0, 1.3, 4.9]);
    for row in &rows {
        for k in 0..4 {
            assert!((row[k] - rows[0][k]).abs() <= 1e-14 * rows[0][3], "{row:?}");
        }
        assert!((row[3] * row[4].cos() - 0.01748 * row[5]).abs() <= 1e-15 * row[3]);
        assert!((row[0].hypot(row[1]).hypot(row[2]) - row[3]).abs() <= 1e-16);
    }
}

/// What turns in a plane has L = 2 · rotation/Ω about its centre.
#[test]
fn angular_momentum_in_a_plane_is_that_of_the_rotation() {
    let times: Vec<f64> = (1..20).map(|n| 0.05 * f64::from(n)).collect();
    for file in ["billiard-shot", "spool", "yo-yo"] {
        for [l, rotation, omega] in rows(file, ["l", "rotation", "omega"], &times) {
            let twice = 2.0 * rotation;
            assert!(twice > 0.0, "{file}");
            assert!((l * omega - twice).abs() <= 1e-15 * twice, "{file}");
        }
    }
    // m a²/3 of a flat strip, 0.08 kg/m² and 2 cm wide; m k² of a cat cut from a postcard.
    let strip = 0.08 * 0.02 * 0.01 * 0.01 / 3.0;
    let paper = 1.2e-3 * 4e-4;
    for (file, rate, moment) in [("strip", "omega", strip), ("paper-cat", "tilt_rate", paper)] {
        for [l, rate] in rows(file, ["l", rate], &times) {
            assert!((l / (moment * rate) - 1.0).abs() <= 1e-14, "{file}");
        }
    }
}

/// What the floor takes from the way of a superball it gives to its turn, and a ceiling takes both.
#[test]
fn a_superball_turns_by_what_its_way_loses() {
    let times: Vec<f64> = (0..40).map(|n| 0.025 * f64::from(n)).collect();
    let names = ["velocity", "l_over_radius", "bounces"];
    let rows = rows("superball", names, &times);
    let mut bounces = 0;
    for [before, after] in rows.array_windows() {
        if after[2] == before[2] + 1.0 {
            bounces += 1;
            // It is thrown down: first the floor.
            let sense = if before[2] % 2.0 == 0.0 { 1.0 } else { -1.0 };
            let way = 0.05 * (after[0] - before[0]);
            let turn = after[1] - before[1];
            assert!(turn.abs() > 1e-3, "{turn}");
            assert!((way + sense * turn).abs() < 1e-15, "{way} {turn}");
        }
    }
    assert!(bounces >= 5, "{bounces}");
}

#[test]
fn every_column_has_a_name_of_its_own_a_unit_and_a_meaning() {
    for priced in PRICED.iter() {
        let (scene, request) = parse(&priced.kind, &priced.file(|_| true)).unwrap();
        let columns = scene.columns();
        for (place, column) in columns.iter().enumerate() {
            assert!(!column.unit.is_empty() && !column.meaning.is_empty());
            let mut others = columns[..place].iter().map(|other| other.name).chain(["t"]);
            assert!(others.all(|other| other != column.name), "{column:?}");
        }
        let names: Vec<&str> = columns.iter().map(|column| column.name).collect();
        let table = scene.telling(&names).unwrap().simulate(&request).unwrap();
        let mut numbers = table.rows().flat_map(|(_, row)| row);
        assert!(numbers.all(f64::is_finite), "{}", priced.kind);
    }
    assert_eq!(PRICED.len(), kinds().len());
}

/// The tables of the page: the columns of every kind, the usual ones in bold.
fn tables() -> String {
    let mut text = String::new();
    for priced in PRICED.iter() {
        let (scene, _) = parse(&priced.kind, &priced.file(|_| true)).unwrap();
        text += &format!(
            "<details><summary><code>{}</code></summary>\n\n",
            priced.kind
        );
        text += "| column | unit | what |\n|---|---|---|\n";
        for column in scene.columns() {
            let bold = if column.usual { "**" } else { "" };
            let (name, unit) = (column.name, column.unit);
            let (first, rest) = column.meaning.split_at(1);
            let first = first.to_uppercase();
            text += &format!("| {bold}`{name}`{bold} | {unit} | {first}{rest} |\n");
        }
        text += "\n</details>\n\n";
    }
    text
}

#[test]
fn the_page_lists_every_column() {
    super::kept("src/tables/columns.md", &tables());
}
