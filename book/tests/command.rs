//! The command line: what it prints, and the exit status it leaves with.

use std::path::Path;
use std::process::{Command, Output, Stdio};

fn book(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_book"))
        .args(arguments)
        .output()
        .unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

#[test]
fn wrong_usage_is_told_in_one_line_and_status_2() {
    for (arguments, word) in [
        (&["figure"][..], "'figure'"),
        (&["figures", "--lits"], "'--lits'"),
        (&["figures", "no-such-figure"], "'no-such-figure'"),
        (&["figures", "--list", "no-such-figure"], "'no-such-figure'"),
        (&["figures", "--out"], "--out"),
        (&["figures", "--list", "--check"], "--check"),
        (&["book", "extra"], "'extra'"),
        (&["claims", "--all"], "'--all'"),
    ] {
        let output = book(arguments);
        let told = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {told}");
        assert_eq!(told.lines().count(), 1, "{arguments:?}: {told}");
        assert!(
            told.starts_with("error: ") && told.contains(word),
            "{arguments:?}: {told}"
        );
        assert!(output.stdout.is_empty(), "{arguments:?}");
    }
}

#[test]
fn an_unknown_figure_is_answered_with_the_nearest_name() {
    if let Some(entry) = figures::all().first() {
        let output = book(&["figures", &format!("{}x", entry.name)]);
        assert!(text(&output.stderr).contains(&format!("'{}'", entry.name)));
    }
}

#[test]
fn an_unwritable_folder_is_named_and_status_1() {
    if figures::all().is_empty() {
        return;
    }
    // A file where a folder is wanted fails for everyone, root included.
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("a-file");
    std::fs::write(&file, "").unwrap();
    let output = book(&[
        "figures",
        figures::all()[0].name,
        "--out",
        file.to_str().unwrap(),
    ]);
    let told = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{told}");
    assert!(
        told.lines()
            .last()
            .is_some_and(|line| line.contains("a-file")),
        "{told}"
    );
}

#[test]
fn help_teaches_and_is_no_error() {
    for arguments in [
        &["--help"][..],
        &["figures", "--help"],
        &["book", "--help"],
        &["help"],
    ] {
        let output = book(arguments);
        assert_eq!(output.status.code(), Some(0));
        assert!(
            text(&output.stdout).contains("cargo run --"),
            "{arguments:?}"
        );
        assert!(output.stderr.is_empty());
    }
}

#[test]
fn figures_are_listed_with_their_chapters() {
    let output = book(&["figures", "--list"]);
    assert_eq!(output.status.code(), Some(0));
    let listed = text(&output.stdout);
    assert_eq!(listed.lines().count(), figures::all().len());
    for (line, entry) in listed.lines().zip(figures::all()) {
        assert_eq!(
            line.split_whitespace().collect::<Vec<_>>(),
            [entry.name, &format!("{}.md", entry.chapter)]
        );
    }
}

#[test]
fn figures_are_written_to_the_folder_asked_for() {
    let folder = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap();
    let out = folder.path().join("svg");
    for entry in figures::all().iter().take(1) {
        let output = book(&["figures", entry.name, "--out", out.to_str().unwrap()]);
        assert_eq!(output.status.code(), Some(0));
        let names: Vec<_> = std::fs::read_dir(&out)
            .unwrap()
            .map(|file| file.unwrap().file_name().into_string().unwrap())
            .collect();
        assert_eq!(names, [format!("{}.svg", entry.name)]);
        let output = book(&[
            "figures",
            entry.name,
            "--check",
            "--out",
            out.to_str().unwrap(),
        ]);
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));

        let path = out.join(&names[0]);
        let spoilt = std::fs::read_to_string(&path).unwrap().replacen(
            "viewBox=\"0 0 6",
            "viewBox=\"0 0 7",
            1,
        );
        std::fs::write(&path, spoilt).unwrap();
        let output = book(&[
            "figures",
            entry.name,
            "--check",
            "--out",
            out.to_str().unwrap(),
        ]);
        assert_eq!(output.status.code(), Some(1));
        assert!(text(&output.stderr).contains(entry.name));
    }
}

#[test]
fn every_claim_is_a_line_of_the_table() {
    let output = book(&["claims"]);
    assert_eq!(output.status.code(), Some(0));
    let table = text(&output.stdout);
    assert!(table.lines().filter(|line| line.starts_with('C')).count() > 200);
    assert!(table.lines().any(|line| line.starts_with("C4.6-7 ")));
}

#[test]
fn a_reader_that_leaves_is_no_error() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_book"))
        .arg("claims")
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert!(output.stderr.is_empty(), "{}", text(&output.stderr));
}
