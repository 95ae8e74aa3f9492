//! `scan`: diagrams over one range and two.

use super::*;

#[test]
fn a_scan_is_drawn_over_one_range_or_two() {
    // What is told is what is varied, so the points stand on a straight line, in equal steps.
    let over = ["scan", "racket", "--over", "initial.omega.0=0.1..0.5:5"];
    let done = book(&[&over[..], &["--plot", "first:omega1"]].concat());
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
    let svg = text(&done.stdout);
    assert!(svg.contains(">initial.omega.0<") && svg.contains(">first:omega1, rad/s<"));
    for attribute in ["cx", "cy"] {
        let places = attributes(&svg, "circle", attribute);
        let steps: Vec<f64> = places.windows(2).map(|pair| pair[1] - pair[0]).collect();
        assert!(steps.len() == 4 && steps.iter().all(|step| step.abs() > 300.0));
        assert!(
            steps.iter().all(|step| (step - steps[0]).abs() <= 1.0),
            "{steps:?}"
        );
    }
    let second = ["--over", "initial.omega.1=1..2:3"];
    let first = ["scan", "racket", "--over", "initial.omega.0=0.1..0.4:4"];
    let done = book(&[&first[..], &second, &["--plot", "first:omega1"]].concat());
    let svg = text(&done.stdout);
    // Four columns of three fields each, the darker the further to the right; then the scale.
    let shades = attributes(&svg, "polygon", "opacity");
    assert_eq!(shades.len(), 12 + 8, "{}", text(&done.stderr));
    let columns: Vec<&[f64]> = shades[..12].chunks(3).collect();
    assert!(
        columns
            .iter()
            .all(|fields| fields.iter().all(|shade| *shade == fields[0]))
    );
    assert!(
        columns.windows(2).all(|pair| pair[0][0] < pair[1][0]),
        "{shades:?}"
    );
    let third = ["--over", "initial.omega.2=1..2:2"];
    let plot = ["--plot", "tilt"];
    let told = "--plot: expected one --over, or two for a map, got 3";
    refused(
        &book(&[&over[..], &second, &third, &plot].concat()),
        &[told],
    );
    refused(
        &book(&[&over[..], &["--plot", "tlt"]].concat()),
        &["has no column `tlt` to tell"],
    );
}
