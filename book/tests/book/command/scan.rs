//! `scan`: diagrams over one range and two.

use super::*;

#[test]
fn a_scan_is_drawn_over_one_range_or_two() {
    // What is told is what is varied, so the points stand on a straight line, in equal steps.
    let over = ["scan", "racket", "--over", "initial.omega.0=0.1..0.5:5"];
    let svg = printed(&book(&[&over[..], &["--plot", "first:omega1"]].concat()));
    assert!(svg.contains(">initial.omega.0<") && svg.contains(">first:omega1, rad/s<"));
    for attribute in ["cx", "cy"] {
        let places = attributes(&svg, "circle", attribute);
        let steps: Vec<f64> = places.windows(2).map(|pair| pair[1] - pair[0]).collect();
        assert!(steps.len() == 4 && steps.iter().all(|step| step.abs() > 300.0));
        let equal = steps.iter().all(|step| (step - steps[0]).abs() <= 1.0);
        assert!(equal, "{steps:?}");
    }
    let second = ["--over", "initial.omega.1=1..2:3"];
    let first = ["scan", "racket", "--over", "initial.omega.0=0.1..0.4:4"];
    let plot = ["--plot", "first:omega1"];
    let svg = printed(&book(&[&first[..], &second, &plot].concat()));
    // Four columns of three fields each, the darker the further to the right; then the scale.
    let shades = attributes(&svg, "polygon", "opacity");
    assert_eq!(shades.len(), 12 + 8);
    let columns: Vec<&[f64]> = shades[..12].chunks(3).collect();
    let mut fields = columns.iter().flat_map(|three| three.array_windows());
    assert!(fields.all(|[one, other]| one == other), "{shades:?}");
    let darker = columns.windows(2).all(|pair| pair[0][0] < pair[1][0]);
    assert!(darker, "{shades:?}");
    let third = ["--over", "initial.omega.2=1..2:2"];
    let thrice = book(&[&over[..], &second, &third, &["--plot", "tilt"]].concat());
    let told = "--plot: expected one --over, or two for a map, got 3";
    refused(&thrice, &[told]);
    let never = book(&[&over[..], &["--plot", "crossing:energy=9"]].concat());
    assert_eq!(never.status.code(), Some(1));
    assert!(text(&never.stderr).contains("no point of the scan has a `crossing:energy=9.0`"));
    let column = book(&[&over[..], &["--plot", "tlt"]].concat());
    refused(&column, &["has no column `tlt` to tell"]);
}
