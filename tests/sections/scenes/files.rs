//! Scene files: what is wrong is told at once, each mistake with its line and key.

use spinning_bodies::scene::files::{keys, kinds, numbers, parse, set};
use support::near;

const RACKET: &str = "[body]\nmoments = [1.0, 2.0, 3.0]\n[initial]\nomega = [0.01, 1.0, 0.01]\n[run]\ntimes = [0.0, 5.0]\n";

pub(super) fn mistakes(text: &str) -> Vec<String> {
    match parse("mine.toml", text) {
        Ok(_) => Vec::new(),
        Err(mistakes) => mistakes.to_string().lines().map(str::to_owned).collect(),
    }
}

/// The only mistake.
pub(super) fn one_mistake(text: &str) -> String {
    let told = mistakes(text);
    assert_eq!(told.len(), 1, "{told:?}\n{text}");
    told[0].clone()
}

/// The numbers of these names at the last of the times.
pub(super) fn last<const N: usize>(text: &str, names: [&str; N]) -> [f64; N] {
    let (scene, request) = parse("mine.toml", text).unwrap_or_else(|told| panic!("{told}"));
    let scene = scene.telling(&names).unwrap();
    let table = scene.simulate(&request).unwrap();
    *table.numbers(names).unwrap().last().unwrap()
}

#[test]
fn every_mistake_is_told_at_once_each_in_its_line() {
    let text = "titel = \"x\"\n[body]\nmomnts = [1, 2, 3]\nmass = \"heavy\"\n[initial]\nomega = [0, 1]\nattitude = [1, 1, 0, 0]\n\
                [effects]\ngravity = nan\n[run]\nuntil = 1\nsamples = 1.5\nsolver = \"dop835\"\n";
    let told = mistakes(text);
    let heavy = "must be a mass in kg, positive, got the string \"heavy\"";
    let expected = [
        (1, "titel", "did you mean `title`?"),
        (3, "momnts", "did you mean `moments`?"),
        (4, "mass", heavy),
        (6, "omega", "a list of 3 numbers, got 2"),
        (7, "attitude", "got one of length 1.414"),
        (9, "gravity", "finite, got NaN"),
        (12, "samples", "got the float 1.5"),
        (13, "solver", "did you mean `dop853`?"),
    ];
    assert_eq!(told.len(), expected.len(), "{told:#?}");
    for ((line, key, words), told) in expected.into_iter().zip(&told) {
        let place = format!("mine.toml:{line}: key `{key}`");
        assert!(told.starts_with(&place) && told.contains(words), "{told}");
    }
    let columns = "columns = [\"l\", \"lx\", \"l\"]";
    for (more, told) in [
        ("times = [1]", "`times` stands twice"),
        ("[body]", "`body` stands twice"),
        (columns, "`columns` in [run] is asked for column `l` twice"),
    ] {
        let told = format!("mine.toml:7: key {told}");
        assert_eq!(one_mistake(&format!("{RACKET}{more}")), told);
    }
    let once = format!("{RACKET}columns = [\"l\", \"lx\"]");
    assert_eq!(mistakes(&once), [""; 0]);
    // Each of them in the member of the list that is wrong.
    let told = mistakes(&RACKET.replace("[0.01, 1.0, 0.01]", "[\n\"a\",\n1.0,\ninf]"));
    assert!(told[0].starts_with("mine.toml:5: "), "{told:?}");
    assert!(told[1].starts_with("mine.toml:7: "), "{told:?}");
}

/// What is wrong, and the key that is to blame, with the line.
#[test]
fn the_key_that_is_to_blame_is_named_first() {
    let superball = "kind = \"superball\"\n[body]\nmass = 1\n[initial]\nheight = 1\n[effects]\nceiling = 2\n[run]\nuntil = 1\n";
    let roller = "kind = \"roller\"\n[body]\nmass = 1\nradius = 1\n[initial]\nvelocity = 1\ncue_height = 1\n[effects]\ngravity = 9\nfriction = 0.2\nstatic_friction = 0.3\n[run]\nuntil = 1\n";
    for (text, right, wrong, line, key) in [
        (superball, "height = 1", "height = 3", 7, "ceiling"),
        (roller, "friction = 0.2\n", "", 10, "static_friction"),
        (roller, "us = 1", "us = 1\nshape = 'bal'", 5, "shape"),
    ] {
        let changed = text.replacen(right, wrong, 1);
        assert_ne!(changed, text, "{right}");
        let told = one_mistake(&changed);
        let place = format!("mine.toml:{line}: key `{key}`");
        assert!(told.starts_with(&place), "{told}");
    }
}

/// A slip of the pen is one mistake, not a strange key and a missing one.
#[test]
fn what_is_wrong_is_told_once() {
    let roller = "kind = \"roller\"\n[body]\nmass = 1\nradus = 0.1\n[effects]\ngravity = 9.81\n[run]\nuntil = 1\n";
    let table_top = "kind = \"table-top\"\n[body]\nmass = 1\nshape = \"ball\"\nradius = 0.1\n\
                     [initial]\ntilt = 0.1\nomega = [1, 2, 3]\n[run]\nuntil = 1\n";
    let angles = "goes with `attitude`, not with `tilt`";
    let moving = |more| table_top.replace("tilt = 0.1", &format!("velocity = [1, 0, {more}"));
    let law = "[effects]\nfriction_law = \"no-slip\"\n[run]";
    let (climbing, rolling) = (moving("2]"), moving("0]").replace("[run]", law));
    let (timeless, blind) = (
        RACKET.replace("[0.0, 5.0]", "[]"),
        format!("{RACKET}columns = []\n"),
    );
    for (text, line, words) in [
        (roller, 4, "did you mean `radius`?"),
        (table_top, 8, angles),
        (&climbing, 7, "must be level"),
        (&rolling, 7, "follows from the angular velocity"),
        (&timeless, 6, "1 to "),
        (&blind, 7, "must name one number at least"),
    ] {
        let told = one_mistake(text);
        let place = format!("mine.toml:{line}: ");
        assert!(told.starts_with(&place) && told.contains(words), "{told}");
    }
}

#[test]
fn the_last_of_the_times_is_the_one_asked_for() {
    for (until, samples) in [(52.0, 521), (1e308, 101), (-1e308, 11), (0.1, 2)] {
        let run = format!("until = {until:e}\nsamples = {samples}");
        let text = RACKET.replace("times = [0.0, 5.0]", &run);
        let (_, request) = parse("mine.toml", &text).unwrap();
        let times = request.times();
        assert_eq!(times.len(), samples);
        // The first is no negative zero.
        assert_eq!((times[0].to_bits(), times[samples - 1]), (0, until));
        let step = until / (samples - 1) as f64;
        assert!((times[1] / step - 1.0).abs() < 1e-15);
    }
}

/// Nothing that somebody may type brings the reader down, and what it tells is one line each.
#[test]
fn strange_texts_are_refused_and_nothing_panics() {
    let values = r#"nan|-inf|1e999|99999999999999999999|0x7f|-0.0|true|""|''|[]|[[]]|[1, "a"]|{}|{ a = 1 }|1979-05-27|[nan, 0, 0]|[{}]|"\u0000\n"|5e-324"#;
    let values = || {
        values
            .split('|')
            .chain(["[1e308, 1e308, 1e308, 1e308, 1e308, 1e308]"])
    };
    let paths = "kind title body initial effects run body.mass body.shape body.moments run.times run.columns initial.omega";
    for kind in kinds() {
        for path in paths.split(' ') {
            for value in values() {
                for text in [
                    format!("{path} = {value}\n{RACKET}"),
                    format!("kind = \"{kind}\"\n{path} = {value}"),
                ] {
                    for line in mistakes(&text) {
                        let one = line.lines().count() == 1;
                        assert!(one && line.starts_with("mine.toml"), "{line}");
                    }
                }
            }
        }
        // Every key alone, and every key a table.
        for row in keys(kind).unwrap() {
            assert!(row.expected.contains(' '), "{}: {}", row.key, row.expected);
            for value in values() {
                let key = format!("[{}]\n{} = {value}", row.section, row.key);
                let text = format!("kind = \"{kind}\"\n{key}\n[run]\nuntil = 1");
                assert!(mistakes(&text).iter().all(|line| line.lines().count() == 1));
            }
        }
    }
    let none = "|\u{feff}|=|[|[body|a = 1\na = 2|[body]\n[body]|\0|body = 1|kind = 7";
    for text in none.split('|') {
        assert!(!mistakes(text).is_empty(), "{text:?}");
    }
    for text in [
        RACKET.replace('\n', "\r\n"),
        format!("\u{feff}{RACKET}"),
        "body.moments = [1, 2, 3]\ninitial = { omega = [0, 1, 5] }\nrun.times = [1]".to_owned(),
        "body = { moments = [1, 2, 3] }\ninitial.omega = [\n0, # none\n1,\n5,\n]\nrun = { times = [1] }".to_owned(),
    ] {
        assert_eq!(mistakes(&text), [""; 0]);
    }
    let told = mistakes(&RACKET.replace('\n', "\r\n").replace("[1.0, 2.0, 3.0]", "7"));
    assert!(told[0].starts_with("mine.toml:2: "), "{told:?}");
}

/// What is at rest stays, whatever would resist it: its numbers have no size, and no tolerance of their own.
#[test]
fn what_nothing_moves_stays() {
    let top = |effect: &str| {
        format!(
            "[body]\nmoments = [1, 1, 2]\n[initial]\nomega = [0, 0, 0]\n[effects]\n{effect} = 0.1\n"
        )
    };
    let skater = "kind = \"skater\"\n[body]\ncore = 1\nhand = 1\n[initial]\nreach = 0.5\nspin = 0\n[effects]\nbearing_friction = 0.1\n";
    let swivel =
        "kind = \"swivel\"\n[body]\nlower = 1\nupper = 2\n[effects]\nbearing_friction = 0.1\n";
    let effects = "pivot_friction bearing_friction air_drag tip_friction";
    let still = effects.split(' ').map(top);
    for text in still.chain([skater, swivel].map(str::to_owned)) {
        let run = format!("{text}[run]\ntimes = [0, 1, 5]\n");
        let (scene, request) = parse("mine.toml", &run).unwrap();
        let table = scene.simulate(&request).expect(&text);
        let rows: Vec<_> = table.rows().map(|(_, row)| row).collect();
        assert!(rows[1] == rows[0] && rows[2] == rows[0], "{rows:?}\n{text}");
    }
    // The hands have what they are moved with, and give it back.
    let draw = "[effects.draw]\nto = 0.1\nduration = 1\npace = 'even'\n[run]\ntimes = [0.5, 2]\n";
    let (scene, request) = parse("mine.toml", &format!("{skater}{draw}")).unwrap();
    let table = scene.simulate(&request).unwrap();
    let numbers = table.numbers(["angle", "spin", "work", "energy"]).unwrap();
    // Halfway each of 1 kg goes at 1.875 times 0.4 m/s.
    let moving = (0.4_f64 * 1.875).powi(2);
    for ([angle, spin, work, energy], expected) in numbers.into_iter().zip([moving, 0.0]) {
        assert_eq!([angle, spin], [0.0; 2]);
        near!(work, expected, 1e-10);
        near!(energy, expected, 1e-15);
    }
}

#[test]
fn numbers_of_a_file_are_found_and_set() {
    let text = format!("{RACKET}samples = 3 # three\nsolver = \"auto\"\n");
    assert_eq!(numbers(&text).len(), 9);
    assert!(numbers(&text).contains(&"body.moments.2".to_owned()));
    let heavier = set(&text, "body.moments.2", 2.5).unwrap();
    assert_eq!(heavier, text.replace("2.0, 3.0]", "2.0, 2.5]"));
    for (samples, written) in [(4.0, "= 4 #"), (4.5, "= 4.5 #"), (1e20, "= 1e20 #")] {
        let other = set(&text, "run.samples", samples).unwrap();
        assert_eq!(other, text.replace("= 3 #", written));
    }
    assert_eq!(set(&text, "run", 1.0), None);
    // In other radices, and beyond whole numbers of 64 bits.
    let text = RACKET.replace("0.01, 1.0, 0.01", "0x10, 0b11, 100000000000000000000");
    let omega = ["omega1", "omega2", "omega3"].map(|name| last(&text.replace(", 5.0", ""), [name]));
    assert_eq!(omega.concat(), [16.0, 3.0, 1e20]);
}
