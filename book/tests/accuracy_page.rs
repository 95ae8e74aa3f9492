//! The measured table of the chapter "What accuracy costs" is that of the committed measurements.

use std::path::Path;

use press::accuracy::{HEADER, winners};

fn file(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("src/tables")
        .join(name)
}

/// `UPDATE_TABLES=1 cargo test -p book --test accuracy_page` writes it.
#[test]
fn the_table_is_that_of_the_measurements() {
    let csv = std::fs::read_to_string(file("accuracy.csv")).unwrap();
    let table = winners::markdown(&csv);
    if std::env::var_os("UPDATE_TABLES").is_some() {
        std::fs::write(file("accuracy.md"), &table).unwrap();
    }
    assert_eq!(std::fs::read_to_string(file("accuracy.md")).unwrap(), table);
}

/// The first line names machine and compiler; then comes what the command writes, nothing else.
#[test]
fn the_measurements_name_their_machine() {
    let csv = std::fs::read_to_string(file("accuracy.csv")).unwrap();
    let mut lines = csv.lines();
    let first = lines.next().unwrap();
    assert!(
        first.starts_with("# ") && first.contains("Rust 1."),
        "{first}"
    );
    assert_eq!(lines.next(), Some(HEADER));
    assert!(lines.clone().count() > 1000);
    for line in lines {
        assert_eq!(line.split(',').count(), 9, "{line}");
    }
}

/// At every accuracy and every motion some method of ours is at least twice as fast as dop853, a closed form of a free or symmetric top fifty times; but on the
/// tippe top, where both take the same steps and what the steps evaluate is most of the cost: there it is 1.8 times.
#[test]
fn ours_are_faster_by_the_factors_that_the_page_names() {
    let table = std::fs::read_to_string(file("accuracy.md")).unwrap();
    for row in table.lines().skip(2) {
        for cell in row.split(" | ").skip(1) {
            let Some((best, factor)) = cell.trim_end_matches(" |").split_once(", ×") else {
                assert!(cell.contains("never"), "{row}");
                continue;
            };
            let factor: f64 = factor.parse().unwrap();
            let least = if best.starts_with("exact") {
                50.0
            } else if row.starts_with("| tippe top") {
                1.75
            } else {
                2.0
            };
            assert!(factor >= least, "{row}: {cell}");
        }
    }
}
