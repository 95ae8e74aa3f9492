//! The command `accuracy`: what it prints and writes, and what it refuses. These are debug runs: no times.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const HEADER: &str =
    "problem,method,parameter,error_attitude,error_omega,evaluations,steps,seconds,status";

fn accuracy(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_book"))
        .arg("accuracy")
        .args(arguments)
        .output()
        .unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

fn folder() -> tempfile::TempDir {
    tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap()
}

fn csv(folder: &tempfile::TempDir) -> (PathBuf, String) {
    let path = folder.path().join("rows.csv");
    let name = path.to_str().unwrap().to_owned();
    (path, name)
}

/// Exit status 2, one line that has these words, and nothing printed.
fn refused(output: &Output, words: &[&str]) {
    let told = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{told}");
    assert_eq!(told.lines().count(), 1, "{told}");
    for word in words {
        assert!(told.contains(word), "{word}: {told}");
    }
    assert!(output.stdout.is_empty());
}

#[test]
fn one_problem_is_a_table_and_a_file() {
    let folder = folder();
    let (path, name) = csv(&folder);
    let output = accuracy(&["--scene", "heavy-body/1", "--csv", &name]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    if cfg!(debug_assertions) {
        let told = text(&output.stderr);
        assert!(
            told.contains("debug build") && told.contains("--release"),
            "{told}"
        );
    }
    let table = text(&output.stdout);
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
        assert!(
            ["ok", "floor", "diverged", "failed"].contains(&cells[8]),
            "{line}"
        );
        best = best.min(numbers[1]);
        if methods.last() != Some(&cells[1].to_owned()) {
            methods.push(cells[1].to_owned());
        }
    }
    for method in [
        "kick-drift-6",
        "kick-rotations-4",
        "midpoint-2",
        "munthe-kaas-4",
        "rk4",
        "dop853",
        "gauss",
    ] {
        assert!(methods.iter().any(|m| m == method), "{method}: {methods:?}");
        assert!(table.contains(&format!(" {method} ")), "{method}");
    }
    assert!(methods.iter().all(|m| m != "exact"), "{methods:?}");
    assert!(best < 1e-13, "{best:e}");
}

#[test]
fn unknown_names_are_answered_with_the_known_ones() {
    let folder = folder();
    let (path, name) = csv(&folder);
    for wrong in ["free-tops", "free-top/2", "", "no/such.toml", "."] {
        let output = accuracy(&["--scene", wrong, "--csv", &name]);
        refused(
            &output,
            &[&format!("'{wrong}'"), "near-separatrix", "tippe-top"],
        );
        assert!(!path.exists());
    }
}

#[test]
fn a_file_that_cannot_be_there_is_refused_before_anything_is_measured() {
    let folder = folder();
    let missing = folder.path().join("missing").join("rows.csv");
    let output = accuracy(&["--csv", missing.to_str().unwrap()]);
    refused(&output, &["missing", "no such folder"]);
    assert!(!missing.parent().unwrap().exists());
    let output = accuracy(&["--csv", folder.path().to_str().unwrap()]);
    refused(&output, &["a file is expected"]);
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn a_scene_file_is_a_problem_if_it_is_a_top_without_losses() {
    let folder = folder();
    // Shorter than the book's: by name of its own, and with all that a scene may have.
    let file = folder.path().join("mine.toml");
    let scene = "[body]\nmass = 1.0\nmoments = [1.0, 1.5, 2.0]\ncenter_of_mass = [0.02, 0.01, 0.05]\n\
                 [initial]\nattitude = [0.8, 0.6, 0.0, 0.0]\nangular_momentum = [0.5, 0.4, 4.0]\n\
                 [effects]\ngravity = 9.81\n[run]\ntimes = [0.5, 2.0, 1.0]\n";
    std::fs::write(&file, scene).unwrap();
    let (path, name) = csv(&folder);
    let output = accuracy(&["--scene", file.to_str().unwrap(), "--csv", &name]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let written = std::fs::read_to_string(path).unwrap();
    let best = |method: &str| {
        let rows = written
            .lines()
            .filter(|l| l.starts_with(&format!("mine,{method},")));
        let errors = rows.map(|l| l.split(',').nth(3).unwrap().parse::<f64>().unwrap());
        errors.fold(f64::INFINITY, f64::min)
    };
    // Observed: 2e-16 … 2e-15. The truth is another method in 32 digits.
    for method in ["kick-drift-6", "kick-rotations-6", "dop853", "gauss"] {
        assert!(best(method) < 1e-13, "{method}: {:e}", best(method));
    }

    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for (scene, words) in [
        ("sleeping-top", &["tip_friction", "loss"][..]),
        ("spool.toml", &["kind", "top"]),
        ("tippe-top.toml", &["kind", "top"]),
    ] {
        refused(&accuracy(&["--scene", scene]), words);
        let path = root.join("scenes").join(scene).with_extension("toml");
        refused(&accuracy(&["--scene", path.to_str().unwrap()]), words);
    }
    let bad = folder.path().join("bad.toml");
    std::fs::write(&bad, scene.replace("1.5, 2.0]", "1.5, 5.0]")).unwrap();
    refused(
        &accuracy(&["--scene", bad.to_str().unwrap()]),
        &["bad.toml", "moments"],
    );
    std::fs::write(
        &bad,
        scene.replace("times = [0.5, 2.0, 1.0]", "times = [0.0]"),
    )
    .unwrap();
    refused(
        &accuracy(&["--scene", bad.to_str().unwrap()]),
        &["bad.toml", "until"],
    );
}

#[test]
fn help_teaches_with_a_release_build() {
    let output = accuracy(&["--help"]);
    assert_eq!(output.status.code(), Some(0));
    let told = text(&output.stdout);
    assert!(told.contains("cargo run --release -- accuracy --scene"));
    for name in lab::accuracy::NAMES {
        assert!(told.contains(name), "{name}");
    }
}
