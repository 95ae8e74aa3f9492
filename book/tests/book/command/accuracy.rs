//! `accuracy`: what a method pays for its error.

use super::*;

#[test]
fn what_a_method_pays_is_drawn() {
    let svg = printed(&book(&["accuracy", "--scene", "racket", "--plot"]));
    for method in [
        "exact",
        "dormand-prince-8",
        "dop853",
        "rk4",
        "moser-veselov-10",
    ] {
        assert!(svg.contains(&format!(">{method}</text>")), "{method}");
    }
    assert!(!svg.contains("NaN") && svg.contains(">error<"));
    let wrong = |arguments: &str, told: &str| {
        let arguments: Vec<&str> = arguments.split(' ').collect();
        refused(&book(&arguments), &[told]);
    };
    wrong(
        "accuracy --scene free-top --plot",
        "expected one, such as free-top/10",
    );
    wrong("accuracy --plot", "--scene");
    let csv = "accuracy --scene racket --plot --output x.csv";
    wrong(csv, "`.svg` or `.pdf` or `.png`");
}
