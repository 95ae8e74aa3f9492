//! Scene files: every one in `book/scenes` runs, their keys may stand in any order, and what is wrong is refused in one line.

use std::path::Path;

use press::chapters::CHAPTERS;
use press::scenes::prices::PRICED;
use press::scenes::{output, parse, scan, simulate};
use spinning_bodies::integrators::Method;
use spinning_bodies::scene::{Geometric, Progress, Solver};

const RACKET: &str = "
title = \"A racket\"
[body]
moments = [1.0, 2.0, 3.0]
[initial]
omega = [0.01, 1.0, 0.01]
[effects]
[run]
until = 10.0
samples = 11
";

#[test]
fn every_scene_of_the_book_runs_and_its_ledger_balances() {
    let folder = Path::new("scenes");
    let mut count = 0;
    for entry in folder.read_dir().unwrap() {
        let path = entry.unwrap().path();
        let (table, _) = simulate(&path).unwrap_or_else(|error| panic!("{error}"));
        assert!(!table.ledger.entries().is_empty(), "{}", path.display());
        assert!(
            table
                .rows()
                .all(|(_, row)| row.len() == table.columns.len())
        );
        count += 1;
    }
    assert!(count >= 4);
}

/// A chapter that is not the page on scenes runs it: its name stands in a Rust block that simulates a file.
#[test]
fn every_scene_of_the_book_is_run_by_a_chapter() {
    let mut idle = Vec::new();
    for entry in Path::new("scenes").read_dir().unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap();
        let told = |block: &str| {
            let whole = block.contains(&format!("\"scenes/{name}.toml\""));
            whole || (block.contains("scenes/{") && block.contains(&format!("(\"{name}\"")))
        };
        let chapters = CHAPTERS.iter().filter(|chapter| chapter.name != "scenes");
        let mut blocks =
            chapters.flat_map(|chapter| chapter.source.split("```").skip(1).step_by(2));
        if !blocks
            .any(|block| block.starts_with("rust\n") && block.contains("simulate(") && told(block))
        {
            idle.push(name.to_owned());
        }
    }
    assert!(idle.is_empty(), "no chapter runs {}", idle.join(", "));
}

#[test]
fn the_columns_of_a_table_are_found_by_name() {
    let (table, _) = simulate("scenes/racket.toml").unwrap();
    let rows = table.numbers(["omega2", "t"]).unwrap();
    for ([omega2, t], (time, row)) in rows.into_iter().zip(table.rows()) {
        assert_eq!((t, omega2), (time, row[5]));
    }
    let error = table.numbers(["omega4"]).unwrap_err().to_string();
    assert!(
        error.contains("omega4") && error.contains("omega3"),
        "{error}"
    );
}

#[test]
fn the_order_in_which_keys_and_effects_are_listed_changes_nothing() {
    let head = "[body]\nmass = 1.0\nmoments = [1.0, 1.5, 2.0]\ncenter_of_mass = [0.1, 0.0, 0.1]\n";
    let tail = "[run]\ntimes = [2.0, 0.5]\n[initial]\nomega = [0.0, 1.0, 5.0]\n";
    let effects = ["gravity = 9.8", "pivot_friction = 0.05", "air_drag = 0.01"];
    let run = |order: [usize; 3]| {
        let listed: Vec<&str> = order.iter().map(|&i| effects[i]).collect();
        let text = format!("{tail}{head}[effects]\n{}\n", listed.join("\n"));
        let path = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(path.path(), text).unwrap();
        let (table, seconds) = simulate(path.path()).unwrap();
        output::text(&table, seconds, output::Format::Csv)
    };
    let first = run([0, 1, 2]);
    for order in [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        assert_eq!(run(order), first);
    }
}

#[test]
fn numbers_are_read_back_exactly() {
    let path = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(path.path(), RACKET).unwrap();
    let (table, seconds) = simulate(path.path()).unwrap();
    let text = output::text(&table, seconds, output::Format::Csv);
    let mut lines = text.lines();
    assert_eq!(
        lines.next(),
        Some("t,qw,qx,qy,qz,omega1,omega2,omega3,energy")
    );
    for ((t, row), line) in table.rows().zip(lines) {
        let read: Vec<f64> = line.split(',').map(|n| n.parse().unwrap()).collect();
        assert_eq!((t, row.as_slice()), (read[0], &read[1..]));
    }
    let json = output::text(&table, seconds, output::Format::Json);
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(json["plan"]["solver"], "exact");
    assert_eq!(
        json["rows"][10]["omega2"].as_f64(),
        Some(table.row(10).1[5])
    );
    assert!(json["ledger"][0]["drift"].as_f64().unwrap() < 1e-15);
}

#[test]
fn a_scan_is_its_scenes_one_by_one() {
    let path = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(path.path(), RACKET).unwrap();
    let overs = ["initial.omega.0=0.0..0.5:3", "body.moments.2=2..4:3"].map(|o| o.parse().unwrap());
    let done = std::sync::atomic::AtomicUsize::new(0);
    let count = || {
        done.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
    };
    let text = scan::scan(path.path(), &overs, count).unwrap();
    assert_eq!(done.into_inner(), 9);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 10);
    assert!(
        lines[0].starts_with("initial.omega.0,body.moments.2,t,qw,")
            && lines[0].ends_with(",status")
    );
    // Ω₁ = 0.25, I₃ = 3: the fifth point.
    let one = RACKET.replace("[0.01, 1.0", "[0.25, 1.0");
    std::fs::write(path.path(), one).unwrap();
    let (table, seconds) = simulate(path.path()).unwrap();
    let alone = output::text(&table, seconds, output::Format::Csv);
    assert_eq!(
        lines[5],
        format!("0.25,3.0,{},ok", alone.lines().last().unwrap())
    );
    // I₃ = 4 is no body's: said in its line, and the others stand.
    assert!(
        lines[6].contains("I1 + I2 >= I3") && lines[7].ends_with(",ok"),
        "{}",
        lines[6]
    );
}

#[test]
fn a_scan_over_what_is_not_there_is_refused() {
    for wrong in [
        "omega",
        "a=1..2",
        "a=1:3",
        "a=1..x:3",
        "a=1..2:0",
        "=1..2:3",
        "a=1..inf:2",
    ] {
        assert!(wrong.parse::<scan::Over>().is_err(), "{wrong}");
    }
    let path = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(path.path(), RACKET).unwrap();
    for missing in [
        "initial.omega.7=1..2:3",
        "initial.spin=1..2:3",
        "title=1..2:3",
        "title.x=1..2:3",
    ] {
        let over = [missing.parse().unwrap()];
        let error = scan::scan(path.path(), &over, || ()).unwrap_err();
        assert_eq!(error.status(), 2);
    }
}

/// What is wrong, and what the one line must name.
const WRONG: &[(&str, &str, &[&str])] = &[
    (
        "omega = [0.01, 1.0, 0.01]",
        "omega = [0.01, 1.0]",
        &["omega", "3 numbers", "got 2"],
    ),
    (
        "omega = [0.01, 1.0, 0.01]",
        "omega = [0.01, 1.0, inf]",
        &["omega", "finite", "inf"],
    ),
    (
        "omega = [0.01, 1.0, 0.01]",
        "omega = \"fast\"",
        &["omega", "rad/s", "string"],
    ),
    (
        "omega = [0.01, 1.0, 0.01]",
        "",
        &["omega", "missing", "angular_momentum"],
    ),
    (
        "omega =",
        "angular_momentum = [1, 0, 0]\nomega =",
        &["omega", "angular_momentum", "exclude"],
    ),
    (
        "omega =",
        "attitude = [1, 1, 0, 0]\nomega =",
        &["attitude", "unit quaternion", "1.414"],
    ),
    (
        "moments = [1.0, 2.0, 3.0]",
        "moments = [1.0, 1.0, 3.0]",
        &["moments", "I1 + I2 >= I3"],
    ),
    (
        "moments = [1.0, 2.0, 3.0]",
        "moments = [-1.0, 1.0, 1.0]",
        &["moments", "negative", "-1"],
    ),
    ("moments", "mass = 0.0\nmoments", &["mass", "positive", "0"]),
    (
        "moments",
        "colour = \"red\"\nmoments",
        &["colour", "unknown", "moments"],
    ),
    (
        "[effects]",
        "[effects]\ngravity = true",
        &["gravity", "m/s²", "boolean"],
    ),
    (
        "[effects]",
        "[effects]\npivot_friction = -1.0",
        &["pivot_friction", "negative"],
    ),
    (
        "[effects]",
        "[effects]\ntip_friction = 1.0",
        &["effects", "I1 = I2"],
    ),
    ("[effects]", "[efects]", &["efects", "unknown", "effects"]),
    (
        "until = 10.0\nsamples = 11",
        "times = []",
        &["times", "1 to"],
    ),
    (
        "until = 10.0\nsamples = 11",
        "",
        &["times", "until", "missing"],
    ),
    (
        "samples = 11",
        "samples = 1000000000",
        &["samples", "whole number", "1000000000"],
    ),
    (
        "samples = 11",
        "samples = 11.5",
        &["samples", "whole number", "11.5"],
    ),
    (
        "samples = 11",
        "times = [1.0]",
        &["times", "until", "exclude"],
    ),
    ("samples = 11", "accuracy = 0.0", &["accuracy", "between"]),
    (
        "samples = 11",
        "solver = \"magic\"",
        &["solver", "exact", "dop853", "magic"],
    ),
    (
        "title = \"A racket\"",
        "kind = \"toop\"",
        &["kind", "top", "toop"],
    ),
    (
        "title = \"A racket\"",
        "title = 7",
        &["title", "quotes", "7"],
    ),
    ("[body]", "[body", &["3"]),
];

#[test]
fn what_is_wrong_is_refused_in_one_line_that_names_it() {
    assert!(parse("racket.toml", RACKET).is_ok());
    for (right, wrong, named) in WRONG {
        let text = RACKET.replacen(right, wrong, 1);
        assert_ne!(text, RACKET, "{right}");
        let error = parse("racket.toml", &text).unwrap_err();
        assert_eq!(error.status(), 2, "{error}");
        let told = error.to_string();
        assert!(told.starts_with("racket.toml"), "{told}");
        assert_eq!(told.lines().count(), 1, "{told}");
        for name in *named {
            assert!(told.contains(name), "{told} does not name {name}");
        }
    }
}

/// Kinds whose motions are known from event to event: no equations to be followed.
const KNOWN: [&str; 5] = ["meteorite", "roller", "spool", "superball", "crawler"];

#[test]
fn a_run_ends_with_its_budget_and_tells_how_far_it_came() {
    const FEW: u64 = 200;
    let ends = |name: &str, text: &str| {
        let (scene, request) = parse(name, text).unwrap();
        let progress = Progress::default();
        let told = match scene.run(name, &request.within(FEW).watched(&progress)) {
            Ok(table) => panic!("{name}: {table:?}"),
            Err(error) => {
                assert_eq!(error.status(), 1, "{error}");
                error.to_string()
            }
        };
        assert!(told.contains("after 200 evaluations"), "{told}");
        let time = told
            .split("t = ")
            .nth(1)
            .unwrap()
            .split(' ')
            .next()
            .unwrap();
        let time: f64 = time.parse().unwrap();
        assert!((0.0..1.0).contains(&time), "{told}");
        assert_eq!((progress.time(), progress.until()), (time, 1.0), "{name}");
        assert_eq!(progress.most(), FEW);
        assert!(progress.evaluations() > FEW, "{name}");
    };
    for priced in PRICED {
        let text = priced.file(|_| true);
        if KNOWN.contains(&priced.kind) {
            let (scene, request) = parse(priced.kind, &text).unwrap();
            assert!(scene.run(priced.kind, &request.within(FEW)).is_ok());
        } else {
            ends(priced.kind, &text);
        }
    }
    // The other engines: closed forms row by row, steps of one length, and of another method's choice.
    let heavy = PRICED[0].file(|effect| effect == 0);
    for (lines, solver) in [
        ("samples = 301", "exact"),
        ("samples = 11", "kick-drift-2"),
        ("samples = 11", "rk4"),
        ("samples = 11", "dopri5"),
        ("samples = 11", "dormand-prince-8"),
    ] {
        let lines = format!("{lines}\nsolver = \"{solver}\"");
        ends(solver, &heavy.replace("samples = 11", &lines));
    }
}

#[test]
fn every_solver_is_found_by_its_name() {
    let all: Vec<Solver> = Solver::all().collect();
    for solver in &all {
        assert_eq!(solver.name().parse(), Ok(*solver));
        let text = RACKET.replace(
            "samples = 11",
            &format!("samples = 11\nsolver = \"{solver}\""),
        );
        assert!(parse("racket.toml", &text).is_ok(), "{solver}");
    }
    let names: std::collections::BTreeSet<&str> = all.iter().map(|solver| solver.name()).collect();
    assert_eq!(names.len(), all.len());
    for method in Method::ALL {
        assert!(all.contains(&Solver::General(method)), "{}", method.name());
    }
    for method in Geometric::ALL {
        assert!(
            all.contains(&Solver::Geometric(method)),
            "{}",
            method.name()
        );
    }
}

/// Every scene but the free body's refuses a method for free bodies: it names the key, and no number stands where there is none to tell.
#[test]
fn a_solver_that_cannot_run_a_scene_is_refused_by_its_key() {
    let scratch = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap();
    for entry in Path::new("scenes").read_dir().unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap();
        if name == "racket.toml" {
            continue;
        }
        let scene = std::fs::read_to_string(&path).unwrap();
        let asked = scene.replace("[run]", "[run]\nsolver = \"moser-veselov-4\"");
        let file = scratch.path().join(name);
        std::fs::write(&file, asked).unwrap();
        let error = simulate(&file).unwrap_err();
        let told = error.to_string();
        assert_eq!(error.status(), 2, "{told}");
        assert!(told.contains("key `solver` in [run]: "), "{told}");
        assert!(!told.contains("NaN") && !told.contains("got"), "{told}");
    }
}
