//! Orders, measured.

use lab::accuracy::{Status, Trial, candidates, measure, measured_order};

use super::problem::*;
use crate::prelude::*;

const GENTLE: Stroke = inked(DATA);
const DISCRETE: Stroke = inked(DATA).dashed();
const GENERAL: Stroke = muted(DATA).dotted();

/// Method, line, and the place of its name and, below that, its slope: a distance along the line, and an offset from it.
const METHODS: [(&str, Stroke, f64, Point); 6] = [
    ("rotations-2", GENTLE, 0.60, [6.0, -26.0]),
    ("rk4", GENERAL, 0.72, [8.0, -22.0]),
    ("rotations-4", GENTLE, 0.0, [-10.0, -2.0]),
    ("rotations-6", GENTLE, 0.0, [-10.0, -2.0]),
    ("moser-veselov-6", DISCRETE, 0.70, [36.0, 3.0]),
    ("moser-veselov-10", DISCRETE, 0.0, [10.0, -8.0]),
];

/// Most evaluations of a run.
const MOST: u64 = 40_000;

/// Error of a turn against the number of steps, the slope of each line at its name.
pub fn orders(_: &Values) -> Result<Figure> {
    let turn = problem("free-top/1")?;
    let all = candidates(&turn)?;
    let frame = Frame::log([0.8, 1500.0], [1e-16, 10.0], [64.0, 584.0, 372.0, 32.0]);
    let mut lines: Vec<(Vec<Point>, String)> = Vec::new();
    let mut slopes = Vec::new();
    for (name, ..) in METHODS {
        let candidate = method(&all, name)?;
        let rows = Trial::of(&turn, candidate).sweep(|rows, effort| {
            // Efforts are at most a decade or a factor 1.5 apart.
            let more = rows.last().is_none_or(|row| 3 * row.evaluations < 2 * MOST);
            more.then(|| measure(&turn, candidate, effort))
        });
        // No run that failed or diverged, and one point at the floor of rounding.
        let mut floor = 0;
        let kept = rows.iter().filter(|row| {
            floor += usize::from(row.status == Status::Floor);
            matches!(row.status, Status::Ok | Status::Floor) && floor < 2
        });
        let line = kept.map(|row| [row.steps as f64, row.error_attitude]);
        let line = line.filter(|p| p[0] < 1500.0 && p[1] > 3e-16);
        let line: Vec<Point> = line.map(|[x, y]| frame.at(x, y.max(1e-16))).collect();
        let slope = measured_order(&rows).unwrap_or(f64::NAN);
        let slope = number(slope, 2);
        slopes.push(format!("{name} {slope}"));
        lines.push((line, slope));
    }
    let slopes = slopes.join(", ");
    let words = words!(
        "An order is a slope, and every slope here is measured.",
        "A free body with three different moments, one turn: angle between the computed attitude and the true one against the number of steps. Below each name the slope of its \
         line, measured. Halve the step, and a method of order $p$ is better by $2^p$, down to the floor of rounding.",
        "Six descending lines on logarithmic axes: error in the attitude from 1 to ten to the minus 16 against up to 1024 steps a turn. The higher the \
         order, the steeper: {slopes}. The steep ones end on a floor near ten to the minus 15."
    );
    Ok(figure("accuracy-orders", 424.0, words, |pen| {
        let steps = marks(&[1.0, 4.0, 16.0, 64.0, 256.0, 1024.0], "");
        let errors = powers([0, -4, -8, -12, -16]);
        frame.draw(pen, &steps, &errors, ["steps a turn", "error, rad"]);
        for ((name, style, along, aside), (line, slope)) in METHODS.iter().zip(&lines) {
            beaded(pen, line, *style);
            let place = (along * line.len() as f64) as usize;
            if let Some(&point) = line.get(place.min(line.len().saturating_sub(1))) {
                let anchor = if aside[0] < 0.0 { End } else { Start };
                let at = shifted(point, *aside);
                pen.text(at, anchor, name, small(style.role()));
                pen.text(shifted(at, [0.0, 16.0]), anchor, slope, small(style.role()));
            }
        }
    }))
}
