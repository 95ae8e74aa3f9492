//! `scene`: rows, diagrams, and where they are written.

use super::*;

#[test]
fn a_motion_is_drawn() {
    let folder = scratch();
    let path = folder.path().join("racket.svg");
    let output = ["--output", path.to_str().unwrap()];
    let wanted = ["scene", "racket", "--plot", "omega1:omega2,energy"];
    printed(&book(&[&wanted[..], &output].concat()));
    let svg = std::fs::read_to_string(&path).unwrap();
    for label in ["omega1, rad/s", "omega2, rad/s", "t, s", "change of energy"] {
        assert!(svg.contains(&format!(">{label}")), "{label}");
    }
    // The polhode is smooth and the colour of Ω, although the file asks for a hundred times.
    let polhode = svg.split("<polyline").find(|line| line.contains("#0b6bcb"));
    assert!(polhode.unwrap().split(' ').count() > 1000);
    for (wrong, told) in [
        ("omg1", "has no column `omg1` to tell"),
        ("omega1:", "expected COLUMN, or X:Y"),
        ("tilt --format csv", "cannot be used with"),
        ("tilt --output x.csv", "`.svg` or `.pdf` or `.png`"),
    ] {
        refused(&typed(&format!("scene racket --plot {wrong}")), &[told]);
    }
}

#[test]
fn the_name_of_the_output_tells_its_format() {
    let (folder, file) = racket(3);
    let out = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let read = |name: &str| std::fs::read_to_string(out(name)).unwrap();
    for (name, format) in [
        ("a.csv", None),
        ("a.txt", None),
        ("a", None),
        ("b.txt", Some("csv")),
        ("a.json", None),
        ("b.json", Some("json")),
        ("c.txt", Some("json")),
    ] {
        let path = out(name);
        let mut arguments = vec!["-o", &path];
        arguments.extend(format.iter().flat_map(|format| ["--format", format]));
        let output = scene(&file, &arguments);
        assert!(printed(&output).is_empty() && output.stderr.is_empty());
        let json = name.ends_with("json") || format == Some("json");
        let head = if json { "{" } else { "t,qw" };
        assert!(read(name).starts_with(head), "{name}");
    }
    let printed_rows = printed(&scene(&file, &["--output", "-"]));
    assert_eq!(printed_rows, read("a.csv"));
    let before = names(folder.path());
    for arguments in [
        &["--output", &out("x.svg")][..],
        &["--output", &out("x.svg"), "--format", "csv"],
        &["--output", &out("x.json"), "--format", "csv"],
        &["--output", &out("x.csv"), "--format", "json"],
    ] {
        refused(&scene(&file, arguments), &["x.", "must end with"]);
    }
    let (over, svg) = ("initial.omega.0=0..1:2", out("x.svg"));
    let scan = ["scan", file.to_str().unwrap()];
    let options = ["--over", over, "--output", &svg];
    refused(&book(&[&scan[..], &options].concat()), &["x.svg", ".csv"]);
    assert_eq!(names(folder.path()), before);
}

#[test]
fn what_cannot_be_written_is_refused_before_any_work() {
    // Half a minute of work, if it were begun.
    let (folder, file) = racket(500_000);
    for (name, words) in [
        ("missing/rows.csv", "the folder of this file does not exist"),
        (".", "this is a folder"),
        ("mine.toml", "must end with"),
    ] {
        let path = folder.path().join(name);
        let output = scene(&file, &["--output", path.to_str().unwrap()]);
        refused(&output, &[words]);
    }
    assert_eq!(names(folder.path()), ["mine.toml"]);

    let file = folder.path().join("a-file");
    std::fs::write(&file, "").unwrap();
    let output = book(&["figures", "--out", file.join("svg").to_str().unwrap()]);
    refused(&output, &["a-file is a file"]);
}

#[test]
fn a_scene_of_the_book_is_found_by_its_name() {
    for name in ["racket", "racket.toml"] {
        assert!(printed(&book(&["scene", name])).starts_with("t,qw"));
    }
    let output = book(&["scene", "racked"]);
    refused(&output, &["racked", "did you mean `racket`?"]);
}

#[test]
fn numbers_beyond_the_doubles_are_no_rows() {
    let swivel = "kind = \"swivel\"\n[body]\nlower = 0.6\nupper = 2.0\n[initial]\nangular_momentum = 1e308\n[run]\nuntil = 1e3\n";
    let (_folder, file) = mine(swivel);
    let output = scene(&file, &[]);
    let told = text(&output.stderr);
    assert_ne!(output.status.code(), Some(0), "{told}");
    assert_eq!(told.lines().count(), 1, "{told}");
    assert!(output.stdout.is_empty());
}
