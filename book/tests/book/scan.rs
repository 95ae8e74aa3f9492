//! Scans: what a grid of scenes prints, and what is no grid.

use super::{RACKET, book, saved, text};
use press::scenes::output::Format;
use press::scenes::scan::{self, Scan};
use press::scenes::simulate;
use std::f64::consts::TAU;
use std::sync::atomic::{AtomicUsize, Ordering};

#[test]
fn a_scan_is_its_scenes_one_by_one() {
    let overs = ["initial.omega.0=0.0..0.5:3", "body.moments.2=2..4:3"];
    let done = AtomicUsize::new(0);
    let count = || _ = done.fetch_add(1, Ordering::Relaxed);
    let scan = asked(RACKET, &overs, &[]).unwrap();
    let (text, ran) = scan.run(Format::Csv, count);
    ran.unwrap();
    assert_eq!(done.into_inner(), 9);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 10);
    assert!(lines[0].starts_with("initial.omega.0,body.moments.2,t,qw,"));
    assert!(lines[0].ends_with(",status"));
    // Ω₁ = 0.25, I₃ = 3: the fifth point.
    let fifth = saved(&RACKET.replace("[0.01, 1.0", "[0.25, 1.0"));
    let table = simulate(fifth.path()).unwrap();
    let (t, row) = table.rows().last().unwrap();
    let numbers = [0.25, 3.0, t].into_iter().chain(row);
    let numbers: String = numbers.map(|n| format!("{n:?},")).collect();
    assert_eq!(lines[5], numbers + "ok");
    // I₃ = 4 is no body's: said in its line, and the others stand.
    assert!(lines[6].contains("I1 + I2 >= I3"), "{}", lines[6]);
    assert!(lines[7].ends_with(",ok"), "{}", lines[7]);
}

/// The mass alone, where the moments stay: the rows come, and one line of warning with them.
#[test]
fn a_scan_says_what_it_is_about() {
    let scan = |file: &str, over: &[&str]| {
        let over = over.iter().flat_map(|over| ["--over", over]);
        let output = book(&["scan", file].into_iter().chain(over).collect::<Vec<_>>());
        let told = text(&output.stderr);
        let (rows, lines) = (text(&output.stdout).lines().count(), told.lines().count());
        ((output.status.code().unwrap(), rows, lines), told)
    };
    let mass = "body.mass=0.02..0.03:2";
    let (counts, told) = scan("scenes/heavy-body.toml", &[mass]);
    assert_eq!(counts, (0, 3, 1), "{told}");
    assert!(told.starts_with("warning: "), "{told}");
    assert!(told.contains("`moments`"), "{told}");
    // A shape's inertia is per mass, a factor is, and an inertia that varies too is somebody's choice.
    for file in ["scenes/superball.toml", "scenes/egg.toml"] {
        assert_eq!(scan(file, &[mass]).0, (0, 3, 0));
    }
    let moments = "body.moments.0=0.010..0.011:2";
    assert_eq!(
        scan("scenes/heavy-body.toml", &[mass, moments]).0,
        (0, 5, 0)
    );
    // Not one point: the rows say why, and so does the status.
    let (counts, told) = scan("scenes/racket.toml", &["body.moments.0=-2..-1:2"]);
    assert_eq!(counts, (1, 3, 1), "{told}");
    assert!(told.contains("moments"), "{told}");
}

#[test]
fn a_scan_over_what_is_not_there_is_refused() {
    for wrong in "omega a=1..2 a=1:3 a=1..x:3 a=1..2:0 =1..2:3 a=1..inf:2 a=1...2:3 a=0...5:3 a=1..2:1 a=0..2:3:log a=-1..2:3:log a=1..2,:3 a=1..2,b:3".split(' ') {
        assert!(scan::over(wrong).is_err(), "{wrong}");
    }
    // The last two would be second names of the first number.
    for missing in
        "initial.omega.7 initial.spin title title.x initial.omega.00 initial.omega.+0".split(' ')
    {
        refusal(&[&format!("{missing}=1..2:3")], &[]);
    }
}

/// A scan of a text.
fn asked(text: &str, overs: &[&str], tells: &[&str]) -> press::Result<Scan> {
    let overs = overs.iter().map(|over| scan::over(over).unwrap()).collect();
    let tells = tells
        .iter()
        .map(|tell| scan::asked(tell).unwrap())
        .collect();
    Scan::new(saved(text).path(), overs, tells)
}

/// The one line with which a scan of the racket is refused.
fn refusal(overs: &[&str], tells: &[&str]) -> String {
    let error = asked(RACKET, overs, tells).unwrap_err();
    assert_eq!(error.status(), 2);
    error.to_string()
}

/// The cells of a line; those in quotation marks may have commas.
fn cells(line: &str) -> Vec<String> {
    let mut cells = vec![String::new()];
    let mut quoted = false;
    for letter in line.chars() {
        match letter {
            '"' => quoted = !quoted,
            ',' if !quoted => cells.push(String::new()),
            _ => cells.last_mut().unwrap().push(letter),
        }
    }
    cells
}

/// What a scan of a text prints, and whether any of its points could be run.
fn told(text: &str, overs: &[&str], tells: &[&str], format: Format) -> (String, bool) {
    let scan = asked(text, overs, tells).unwrap();
    let (text, ran) = scan.run(format, || ());
    (text, ran.is_ok())
}

/// The lines of a scan of the racket, changed, and whether any of its points could be run.
fn scanned(right: &str, changed: &str, overs: &[&str]) -> (Vec<Vec<String>>, bool) {
    let (text, ran) = told(&RACKET.replace(right, changed), overs, &[], Format::Csv);
    (text.lines().map(cells).collect(), ran)
}

#[test]
fn every_line_of_a_scan_is_as_wide_as_its_head() {
    for (over, runs) in [
        ("body.moments.2=2..4:3", true),
        ("body.moments.2=9..10:3", false),
        ("run.samples=2..9:3", true),
        ("body.moments.0=-2..-1:2", false),
    ] {
        let (lines, ran) = scanned("", "", &[over]);
        assert_eq!(ran, runs, "{over}");
        for line in &lines {
            assert_eq!(line.len(), lines[0].len(), "{over}: {line:?}");
            assert!(!line.last().unwrap().is_empty());
        }
    }
}

#[test]
fn a_scan_spans_all_doubles_and_whole_numbers() {
    let over = "initial.omega.1=-1e308..1e308:3";
    let (lines, _) = scanned("0.01, 1.0,", "0.01, 1.0e3,", &[over]);
    let values: Vec<&str> = lines[1..].iter().map(|line| line[0].as_str()).collect();
    assert_eq!(values, ["-1e308", "0.0", "1e308"]);
    let (lines, _) = scanned("", "", &["initial.omega.0=1e-300..1e300:5:log"]);
    let values: Vec<&str> = lines[1..].iter().map(|line| line[0].as_str()).collect();
    assert_eq!(values, ["1e-300", "1e-150", "1.0", "1e150", "1e300"]);
    // 2 and 4 are whole, 3.5 is none: its line says so.
    let (lines, _) = scanned("", "", &["run.samples=2..5:3"]);
    let [two, three, four] = [1, 2, 3].map(|k: usize| lines[k].last().unwrap().as_str());
    assert_eq!((two, four), ("ok", "ok"));
    assert!(three.contains("whole number"), "{three}");
    let twice = refusal(&["run.until=1..2:3", "run.until=2..3:3"], &[]);
    assert!(twice.contains("run.until"), "{twice}");
}

/// Numbers that vary together, by equal ratios: twice as heavy and twice as hard to turn is the same motion, with twice the energy.
#[test]
fn numbers_vary_together_and_by_equal_ratios() {
    let over = "body.moments.0=1..4,body.moments.1=2..8,body.moments.2=3..12:3:log";
    let (text, _) = told(RACKET, &[over], &["omega2", "energy"], Format::Csv);
    let lines: Vec<Vec<String>> = text.lines().map(cells).collect();
    let head = "body.moments.0,body.moments.1,body.moments.2,omega2,energy,status";
    assert_eq!(lines[0], cells(head));
    for (line, factor) in lines[1..].iter().zip([1.0, 2.0, 4.0]) {
        for k in 0..5 {
            let [number, first] = [line, &lines[1]].map(|line| line[k].parse::<f64>().unwrap());
            let expected = if k == 3 { first } else { factor * first };
            assert!((number / expected - 1.0).abs() < 1e-14, "{line:?}");
        }
    }
    assert_eq!(lines.len(), 4);
}

const DROPPED: &str = "kind = \"strip\"\n[body]\nwidth = 0.02\nareal_density = 0.08\nfluid_density = 1.2\n\
    [initial]\nangle = 0.0\nvelocity = [0.3, 2.0]\n[effects]\ngravity = 9.81\n[run]\nuntil = 2.0\nsamples = 21\n";

/// A parabola: where it begins, where it ends, its greatest height among the rows, and when it is at a level, to the last digits.
#[test]
fn what_is_asked_of_a_motion_is_told() {
    let tells = "first:vy last:y greatest:y least:vy crossing:y=-1 crossing:vy=0 crossing:x=9";
    let tells: Vec<&str> = tells.split(' ').collect();
    let over = "effects.gravity=4.905..9.81:2";
    let (text, _) = told(DROPPED, &[over], &tells, Format::Json);
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["refused"], serde_json::json!([]));
    for (row, g) in json["rows"].as_array().unwrap().iter().zip([4.905, 9.81]) {
        let height = |t: f64| 2.0 * t - 0.5 * g * t * t;
        let highest = (0..21).map(|k| height(0.1 * f64::from(k)));
        let highest = highest.fold(0.0, f64::max);
        for (name, expected) in [
            ("effects.gravity", g),
            ("first:vy", 2.0),
            ("y", height(2.0)),
            ("greatest:y", highest),
            ("least:vy", 2.0 - 2.0 * g),
            ("crossing:y=-1.0", (2.0 + (4.0 + 2.0 * g).sqrt()) / g),
            ("crossing:vy=0.0", 2.0 / g),
        ] {
            let got = row[name].as_f64().unwrap();
            let off = (got / expected - 1.0).abs();
            assert!(off < 1e-13, "{name}: {got} {expected}");
        }
        assert!(row["crossing:x=9.0"].is_null());
    }
}

/// A bounce takes the climb through zero in no time: the time of the bounce. An angle that goes round has crossed nothing.
#[test]
fn a_jump_is_crossed_and_the_end_of_a_circle_is_not() {
    let ball = std::fs::read_to_string("scenes/superball.toml").unwrap();
    let over = "initial.climb=-5..-4:2";
    let tells = [
        "crossing:climb=0",
        "crossing:bounces=1",
        "crossing:bounces=0",
    ];
    let (text, _) = told(&ball, &[over], &tells, Format::Csv);
    for (line, climb) in text.lines().skip(1).zip([5.0_f64, 4.0]) {
        let falls = 2.0 * 0.3 / (climb + (climb * climb + 2.0 * 9.81 * 0.3).sqrt());
        for time in &cells(line)[1..3] {
            let time: f64 = time.parse().unwrap();
            assert!((time / falls - 1.0).abs() < 1e-11, "{time} {falls}");
        }
        assert_eq!(cells(line)[3], "0.0");
    }
    // Upright, half of the turn counts as precession: t/2. It leaps from π to −π before it is at −3.
    let spun = "[body]\nmoments = [2.0, 2.0, 1.0]\n[initial]\nomega = [0.0, 0.0, 1.0]\n[run]\nuntil = 12.0\nsamples = 25\n";
    let asked = [0.5, -3.0, 3.2].map(|level| format!("crossing:precession={level}"));
    let tells = [&asked[0], &asked[1], &asked[2]].map(String::as_str);
    let (text, _) = told(spun, &["initial.omega.2=1..1:1"], &tells, Format::Csv);
    let line = cells(text.lines().nth(1).unwrap());
    for (cell, time) in line[1..3].iter().zip([1.0, 2.0 * (TAU - 3.0)]) {
        let crossed: f64 = cell.parse().unwrap();
        assert!((crossed - time).abs() < 1e-12, "{line:?}");
    }
    assert_eq!(line[3], "");
}

#[test]
fn what_cannot_be_told_is_refused() {
    let wrong = " last: most:tilt crossing:tilt crossing:tilt=x crossing:tilt=inf first:tilt=1";
    for wrong in wrong.split(' ') {
        assert!(scan::asked(wrong).is_err(), "{wrong}");
    }
    let told = refusal(&[], &["greatest:tlt"]);
    assert!(told.contains("did you mean `tilt`?"), "{told}");
    let told = refusal(&["initial.omga.2=1..2:3"], &[]);
    assert!(told.contains("did you mean `initial.omega.2`?"), "{told}");
    // A racket has no mass, and its moments are no other word for one.
    let told = refusal(&["body.mass=1..2:3"], &[]);
    assert!(!told.contains("did you mean"), "{told}");
}

/// In JSON they stand apart.
#[test]
fn refused_points_tell_why() {
    let (text, ran) = told(RACKET, &["body.moments.2=2..4:3"], &[], Format::Json);
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert!(ran && json["rows"].as_array().unwrap().len() == 2);
    let refused = &json["refused"][0];
    assert_eq!(refused["body.moments.2"].as_f64(), Some(4.0));
    let reason = refused["reason"].as_str().unwrap();
    assert!(reason.contains("I1 + I2 >= I3"), "{reason}");
}

#[test]
fn on_one_core_a_scan_is_the_same() {
    let scan = |cores: &str| {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_book"));
        command.args(["scan", "racket", "--over", "initial.omega.0=1e-3..1:30:log"]);
        let command = command.env("RAYON_NUM_THREADS", cores);
        command.output().unwrap().stdout
    };
    let one = scan("1");
    assert!(one.iter().filter(|&&byte| byte == b'\n').count() == 31 && one == scan("4"));
}
