//! The book and its press: the chapters as they are written, the pages as they are printed, and every command with what it refuses.

mod accuracy;
mod accuracy_page;
mod chapters;
mod columns;
mod command;
mod ebook;
mod hard_cases_page;
mod ledger;
mod numbers;
mod own_words;
mod pages;
mod priced;
mod scan;
mod scene_prices;
mod scenes;
mod told;
mod typeset;

use press::drawings::{self, Drawing};
use std::path::PathBuf;
use std::process::{Command, Output};
use std::sync::LazyLock;

/// A scene file.
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

/// All figures as they are printed, drawn once.
static DRAWINGS: LazyLock<Vec<Drawing>> =
    LazyLock::new(|| drawings::draw(figures::all(), &figures::Values::default(), || ()).unwrap());

/// No fault, or all of them.
fn none(faults: &[String]) {
    let count = faults.len();
    assert_eq!(count, 0, "{count} faults:\n{}", faults.join("\n"));
}

/// A page's table is this one; `UPDATE_TABLES=1 cargo test -p book --test book` writes it.
fn kept(path: &str, table: &str) {
    if std::env::var_os("UPDATE_TABLES").is_some() {
        std::fs::write(path, table).unwrap();
    }
    let same = std::fs::read_to_string(path).unwrap() == table;
    assert!(same, "{path} is old; UPDATE_TABLES=1 writes it");
}

/// A file with this text.
fn saved(text: &str) -> tempfile::NamedTempFile {
    let file = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(file.path(), text).unwrap();
    file
}

/// An empty folder.
fn scratch() -> tempfile::TempDir {
    tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap()
}

/// A scene file in a folder of its own.
fn mine(text: &str) -> (tempfile::TempDir, PathBuf) {
    let folder = scratch();
    let file = folder.path().join("mine.toml");
    std::fs::write(&file, text).unwrap();
    (folder, file)
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// The command, in the folder `book`.
fn book(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_book"))
        .args(arguments)
        .output()
        .unwrap()
}

/// The same with the words of a line: two blanks hold an empty one.
fn typed(line: &str) -> Output {
    book(&line.split(' ').collect::<Vec<_>>())
}

/// Exit status 0, and what is printed.
fn printed(output: &Output) -> String {
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    text(&output.stdout)
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
