//! `accuracy`: what a method pays for its error.

use super::*;

#[test]
fn what_a_method_pays_is_drawn() {
    let done = book(&["accuracy", "--scene", "racket", "--plot"]);
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
    let svg = text(&done.stdout);
    let named = |method: &&str| svg.contains(&format!(">{method}</text>"));
    for method in [
        "exact",
        "dormand-prince-8",
        "dop853",
        "rk4",
        "moser-veselov-10",
    ] {
        assert!(named(&method), "{method}");
    }
    assert!(!svg.contains("NaN") && svg.contains(">error<"));
    for (wrong, told) in [
        (
            &["--scene", "free-top", "--plot"][..],
            "expected one, such as free-top/10",
        ),
        (&["--plot"], "--scene"),
        (
            &["--scene", "racket", "--plot", "--output", "x.csv"],
            "`.svg` or `.pdf` or `.png`",
        ),
    ] {
        refused(&book(&[&["accuracy"], wrong].concat()), &[told]);
    }
}
