//! The command `accuracy`: what it prints and writes, and what it refuses. These are debug runs: no times.

use super::{book, mine, printed, refused, scratch, text};
use std::path::{Path, PathBuf};
use std::process::Output;

const HEADER: &str =
    "problem,method,parameter,error_attitude,error_omega,evaluations,steps,seconds,status";

fn accuracy(arguments: &[&str]) -> Output {
    book(&[&["accuracy"], arguments].concat())
}

fn csv(folder: &tempfile::TempDir) -> (PathBuf, String) {
    let path = folder.path().join("rows.csv");
    let name = path.to_str().unwrap().to_owned();
    (path, name)
}

#[test]
fn one_problem_is_a_table_and_a_file() {
    let folder = scratch();
    let (path, name) = csv(&folder);
    let output = accuracy(&["--scene", "heavy-body/1", "--csv", &name]);
    let (table, told) = (printed(&output), text(&output.stderr));
    let warned = told.contains("debug build") && told.contains("--release");
    assert!(warned || !cfg!(debug_assertions), "{told}");
    assert!(table.starts_with("heavy-body/1: "), "{table}");
    let written = std::fs::read_to_string(path).unwrap();
    let mut lines = written.lines();
    assert_eq!(lines.next(), Some(HEADER));
    let (mut methods, mut best) = (Vec::new(), f64::INFINITY);
    for line in lines {
        let cells: Vec<&str> = line.split(',').collect();
        assert_eq!((cells.len(), cells[0]), (9, "heavy-body/1"));
        let numbers: Vec<f64> = cells[2..5].iter().map(|x| x.parse().unwrap()).collect();
        for (cell, number) in cells[2..5].iter().zip(&numbers) {
            assert_eq!(*cell, format!("{number:?}"));
        }
        assert!(cells[5].parse::<u64>().is_ok() && cells[6].parse::<u64>().is_ok());
        if cfg!(debug_assertions) {
            assert_eq!(cells[7], "");
        }
        let statuses = ["ok", "floor", "diverged", "failed"];
        assert!(statuses.contains(&cells[8]), "{line}");
        best = best.min(numbers[1]);
        if methods.last() != Some(&cells[1].to_owned()) {
            methods.push(cells[1].to_owned());
        }
    }
    for method in "kick-drift-6 kick-drift-4 munthe-kaas-4 rk4 dop853 gauss".split(' ') {
        assert!(methods.iter().any(|m| m == method), "{method}: {methods:?}");
        assert!(table.contains(&format!(" {method} ")), "{method}");
    }
    assert!(methods.iter().all(|m| m != "exact"), "{methods:?}");
    assert!(best < 1e-13, "{best:e}");
}

#[test]
fn unknown_names_are_answered_with_the_known_ones() {
    let folder = scratch();
    let (path, name) = csv(&folder);
    for wrong in ["free-tops", "free-top/2", "", "no/such.toml", "."] {
        let output = accuracy(&["--scene", wrong, "--csv", &name]);
        let wrong = format!("'{wrong}'");
        refused(&output, &[&wrong, "near-separatrix", "tippe-top"]);
        assert!(!path.exists());
    }
}

#[test]
fn a_file_that_cannot_be_there_is_refused_before_anything_is_measured() {
    let folder = scratch();
    let missing = folder.path().join("missing").join("rows.csv");
    let output = accuracy(&["--csv", missing.to_str().unwrap()]);
    refused(
        &output,
        &["missing", "the folder of this file does not exist"],
    );
    assert!(!missing.parent().unwrap().exists());
    let output = accuracy(&["--csv", folder.path().to_str().unwrap()]);
    refused(&output, &["expected a file, this is a folder"]);
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

/// Errors of a method in a CSV file, with their status: of the attitude, of the rates.
fn errors<'a>(rows: &'a str, method: &str) -> Vec<(&'a str, &'a str, &'a str)> {
    let rows = rows.lines().map(|row| row.split(',').collect::<Vec<_>>());
    let rows = rows.filter(|cells| cells[1] == method);
    rows.map(|cells| (cells[3], cells[4], cells[8])).collect()
}

#[test]
fn a_scene_of_ones_own_is_measured() {
    let scene = "[body]\nmass = 1.0\nmoments = [1.0, 1.5, 2.0]\ncenter_of_mass = [0.02, 0.01, 0.05]\n\
                 [initial]\nattitude = [0.8, 0.6, 0.0, 0.0]\nangular_momentum = [0.5, 0.4, 4.0]\n\
                 [effects]\ngravity = 9.81\n[run]\ntimes = [0.5, 2.0, 1.0]\n";
    let (folder, file) = mine(scene);
    let (path, name) = csv(&folder);
    let scene_and_csv = ["--scene", file.to_str().unwrap(), "--csv", &name];
    let table = printed(&accuracy(&scene_and_csv));
    for words in [
        "mine: 2.0 s, judged by dormand-prince-8 and verner98",
        "exact   failed: ",
        "rotations-2 … moser-veselov-10   failed: ",
        "\n1e-9: dormand-prince-8 in ",
        "; dop853 in ",
    ] {
        assert!(table.contains(words), "{words}: {table}");
    }
    let written = std::fs::read_to_string(path).unwrap();
    assert_eq!(written.lines().next(), Some(HEADER));
    let best = |method: &str| {
        let errors = errors(&written, method).into_iter();
        let errors = errors.map(|(attitude, ..)| attitude.parse::<f64>().unwrap());
        errors.fold(f64::INFINITY, f64::min)
    };
    // Observed: 2e-16 … 4e-15.
    for method in ["kick-drift-6", "dop853", "gauss", "dormand-prince-8"] {
        assert!(best(method) < 1e-13, "{method}: {:e}", best(method));
    }
    assert_eq!(errors(&written, "rotations-4"), [("inf", "inf", "failed")]);

    // Slow, and long: chaos.
    let times = "[0.5, 2.0, 1.0]";
    let slow = scene.replace("4.0]", "0.3]").replace(times, "[200.0]");
    let slow = slow.replace("[0.02, 0.01, 0.05]", "[0.2, 0.1, 0.5]");
    for (wrong, word) in [
        (scene.replace("1.5, 2.0]", "1.5, 5.0]"), "moments"),
        (scene.replace(times, "[0.0]"), "until"),
        (slow, "judge"),
    ] {
        let (_folder, bad) = mine(&wrong);
        let output = accuracy(&["--scene", bad.to_str().unwrap()]);
        refused(&output, &["mine.toml", word]);
    }
}

#[test]
fn every_body_on_a_table_is_measured() {
    let spun = |name: &str| name.starts_with("chiral-top");
    are_measured(|told, name| told.contains("\"table-top\"") && !spun(name));
}

/// They turn for longer than all others.
#[test]
fn so_are_chiral_tops() {
    are_measured(|_, name| name.starts_with("chiral-top"));
}

#[test]
fn every_other_scene_of_the_book_is_measured() {
    are_measured(|told, _| !told.contains("\"table-top\""));
}

fn are_measured(these: impl Fn(&str, &str) -> bool) {
    let without = "roller spool superball yo-yo strip swivel skater paper-cat crawler";
    for file in press::paths::files_below(Path::new("scenes")).unwrap() {
        let told = std::fs::read_to_string(&file).unwrap();
        let name = file.file_stem().unwrap().to_str().unwrap();
        if !these(&told, name) {
            continue;
        }
        let report = press::accuracy::measured(&file, 5e-3, |_, _| ()).unwrap();
        let text = &report.text;
        assert!(text.starts_with(&format!("{name}: ")), "{text}");
        let is = |kind: &str| told.contains(&format!("kind = \"{kind}\""));
        let attitude = !without.split(' ').any(is);
        let mut ran = Vec::new();
        for row in report.rows.lines() {
            let cells: Vec<&str> = row.split(',').collect();
            assert_eq!((cells.len(), cells[0]), (9, name), "{row}");
            assert_eq!(cells[3].is_empty(), !attitude, "{row}");
            // A cat has none to tell.
            assert_eq!(cells[4].is_empty(), is("cat"), "{row}");
            if cells[8] != "failed" {
                ran.push(cells[1].to_owned());
            }
        }
        for solver in spinning_bodies::scene::Solver::all() {
            let tried = report.rows.contains(&format!(",{solver},"));
            assert!(tried, "{name} {solver}");
        }
        // Nothing steps a planet.
        let planet = name == "meteorite";
        let stepper = if planet { "exact" } else { "dormand-prince-8" };
        assert!(ran.iter().any(|own| own == stepper), "{name}: {ran:?}");
    }
}

#[test]
fn help_teaches_with_a_release_build() {
    let told = printed(&accuracy(&["--help"]));
    assert!(told.contains("cargo run --release -- accuracy --scene"));
    for name in lab::accuracy::NAMES {
        assert!(told.contains(name), "{name}");
    }
}
