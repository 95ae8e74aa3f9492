//! The command line: what it prints, and the exit status it leaves with.

mod accuracy;
mod figures;
mod film;
mod scan;
mod scene;
#[cfg(unix)]
mod unix;

use super::{book, mine, printed, refused, scratch, text, typed};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};

#[test]
fn wrong_usage_is_told_in_one_line_and_status_2() {
    for (line, word) in [
        ("figure", "'figure'"),
        ("figures --lits", "'--lits'"),
        ("figures no-such-figure", "'no-such-figure'"),
        ("figures --list no-such-figure", "'no-such-figure'"),
        ("figures --out", "--out"),
        ("figures --list --check", "--check"),
        ("book extra", "'extra'"),
        ("claims --all", "'--all'"),
        // None of them begins to work.
        ("figures --data x.csv", "the NAME of one figure"),
        ("figures spool-dial --data x.svg", "`.csv`"),
        (
            "figures spool-dial --set axle=0.5,axle=0.6",
            "axle is given twice",
        ),
        ("figures spool-dial --as svg --width 100", "got 100"),
        ("figures spool-dial --list --width 100", "--width"),
        ("figures spool-dial --as png --width -1", "-1 is not in"),
        ("scene --keys run", "no kind `run`"),
        ("scene --keys top --as svg", "'--keys <KIND>'"),
        ("scene racket --columns tilt,l,tilt", "column `tilt` twice"),
        ("scene racket --film --speed -1", "expected a speed from"),
        ("scene racket --frames  3", "DIR is ''"),
        ("scene racket --frames stills -1", "N is '-1'"),
        ("scene racket --frames a/.. 2", "DIR is 'a/..'"),
        ("scene racket --frames a 2 --frames b 2", "multiple times"),
        ("scene racket --output rows/", "this is a folder"),
        (
            "scan racket --over body.moments.0=1..2:2 --tell l,l",
            "`l` is given twice",
        ),
        (
            "scan racket --over run.until=1..1:3:log --plot tilt",
            "two ends of `run.until`, got 1.0 twice",
        ),
    ] {
        let output = typed(line);
        let told = text(&output.stderr);
        refused(&output, &[word]);
        let whole = told.starts_with("error: ") && !told.contains("Usage");
        assert!(whole, "{line}: {told}");
    }
}

#[test]
fn a_file_where_a_folder_is_wanted_is_wrong_usage() {
    let (_kept, file) = racket(3);
    let file = file.to_str().unwrap();
    for command in ["figures", "sheets"] {
        refused(
            &book(&[command, "--out", file]),
            &[file, "expected a folder"],
        );
    }
}

#[test]
#[cfg(target_os = "linux")]
fn an_unwritable_folder_is_named_and_status_1() {
    // Nobody may make a file there, root included.
    let output = typed("figures ice --out /proc/none");
    let told = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{told}");
    assert!(
        told.lines().last().unwrap().contains("/proc/none"),
        "{told}"
    );
}

#[test]
fn help_teaches_and_is_no_error() {
    for line in ["--help", "figures --help", "book --help", "help"] {
        let output = typed(line);
        assert!(printed(&output).contains("cargo run --"), "{line}");
        assert!(output.stderr.is_empty());
    }
}

#[test]
fn every_claim_is_a_line_of_the_table() {
    let table = printed(&book(&["claims"]));
    assert!(table.lines().filter(|line| line.starts_with('C')).count() > 200);
    assert!(table.lines().any(|line| line.starts_with("C4.6-7 ")));
}

#[test]
fn a_reader_that_leaves_is_no_error() {
    let mut child = started(Path::new("."), &["claims"]);
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    printed(&output);
    assert!(output.stderr.is_empty(), "{}", text(&output.stderr));
}

/// The command, still running in a folder.
fn started(folder: &Path, arguments: &[&str]) -> Child {
    Command::new(env!("CARGO_BIN_EXE_book"))
        .args(arguments)
        .current_dir(folder)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

/// One of this many rows.
fn racket(rows: usize) -> (tempfile::TempDir, PathBuf) {
    mine(&format!(
        "[body]\nmoments = [1.0, 2.0, 3.0]\n[initial]\nomega = [0.01, 1.0, 0.01]\n[run]\nuntil = 10.0\nsamples = {rows}\n"
    ))
}

fn scene(file: &Path, arguments: &[&str]) -> Output {
    book(&[&["scene", file.to_str().unwrap()], arguments].concat())
}

fn names(folder: &Path) -> Vec<String> {
    let files = std::fs::read_dir(folder).unwrap().map(Result::unwrap);
    let names = files.map(|file| file.file_name().into_string().unwrap());
    let mut names: Vec<String> = names.collect();
    names.sort();
    names
}

/// A run that takes long, and ends.
const CHIRAL: &str = "kind = \"table-top\"\n[body]\nmass = 0.02\nradius = 0.02\nsurface_center = [0.0, 0.0, 0.006]\n\
    inertia = [3.0e-6, 3.0e-6, 3.2e-6, 0.0, 0.0, 0.0]\n[initial]\ntilt = 0.1\naxial_spin = 155.0\n\
    [effects]\ngravity = 9.82\nfriction_law = \"viscous\"\nfriction = 0.3\n[run]\nuntil = 1e5\nsamples = 11\naccuracy = 1e-6\n";

/// Numbers of an attribute, in the order of the elements that have it.
fn attributes(svg: &str, element: &str, attribute: &str) -> Vec<f64> {
    let begin = format!("<{element} ");
    let elements = svg.split(&begin).skip(1);
    let value = |element: &str| {
        let value = element.split(&format!("{attribute}=\"")).nth(1)?;
        value.split('"').next()?.parse().ok()
    };
    elements.filter_map(value).collect()
}
