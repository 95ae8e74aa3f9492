//! `accuracy`: what a method pays for its error.

use super::*;

#[test]
fn what_a_method_pays_is_drawn() {
    let svg = printed(&book(&["accuracy", "--scene", "racket", "--plot"]));
    for method in "exact dormand-prince-8 dop853 rk4 moser-veselov-10".split(' ') {
        assert!(svg.contains(&format!(">{method}</text>")), "{method}");
    }
    assert!(!svg.contains("NaN") && svg.contains(">error<"));
    let several = typed("accuracy --scene free-top --plot");
    refused(&several, &["expected one, such as free-top/10"]);
    // One output has one document.
    let both = typed("accuracy --scene racket --plot --csv -");
    refused(&both, &["both on standard output"]);
    let rows = printed(&typed("accuracy --scene racket --csv -"));
    let fields = |line: &str| line.matches(',').count();
    assert!(rows.lines().all(|line| fields(line) == 8), "{rows}");
    refused(&typed("accuracy --plot"), &["--scene"]);
    let csv = typed("accuracy --scene racket --plot --output x.csv");
    refused(&csv, &["`.svg` or `.pdf` or `.png`"]);
}
