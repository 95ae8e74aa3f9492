//! How an error grows with the number of turns.

use lab::accuracy::{Candidate, candidates, measure, named};
use spinning_bodies::integrators::Effort;

use super::problem::*;
use crate::prelude::*;

/// A method, its effort (a step is a part of a turn), the greatest power of ten of turns for which it is run, its line, and the place of its name next to its
/// last point.
type Line = (&'static str, Effort, i32, Stroke, Point);

const RK4: Stroke = muted(DATA).dotted();
const ROTATIONS: Stroke = inked(DATA).dashed();
const DISCRETE: Stroke = inked(DATA);
const LINES: [Line; 4] = [
    ("rk4", steps(32.0), 4, RK4, [-8.0, -12.0]),
    ("dop853", TOLERANCE, 4, muted(DATA), [10.0, 5.0]),
    ("rotations-4", steps(8.0), 5, ROTATIONS, [-14.0, -10.0]),
    ("moser-veselov-10", steps(16.0), 5, DISCRETE, [0.0, 52.0]),
];
const TOLERANCE: Effort = Effort::Tolerance(1e-11);

/// So many steps a turn.
const fn steps(count: f64) -> Effort {
    Effort::Step(1.0 / count)
}

/// Errors after 1, 10, … 10ⁿ turns, in one run that continues from each to the next.
///
/// The reference is the closed form; for the closed form itself, the table of 36 digits.
fn errors(line: &Line, candidate: &Candidate, exact: &Candidate) -> Result<Vec<[f64; 2]>> {
    let (_, effort, most, ..) = line;
    let first = problem("free-top/1")?;
    let turns = (0..=*most).map(|k| 10.0_f64.powi(k));
    let times: Vec<f64> = turns.clone().map(|turns| turns * first.end()).collect();
    let effort = match *effort {
        Effort::Step(part) => Effort::Step(first.end() * part * (1.0 + 1e-12)),
        tolerance => tolerance,
    };
    let follow = |one: &Candidate, effort| one.method.follow(first.start(), &times, effort);
    let found = follow(candidate, effort)?;
    let truth = follow(exact, Effort::Tolerance(0.0))?;
    let pairs = found.states.iter().zip(&truth.states);
    tried(turns.zip(pairs), |(turns, (found, truth))| {
        Ok([turns, found.attitude()?.angle_to(&truth.attitude()?)])
    })
}

/// Error after 1, 10, … a hundred thousand turns, of the closed form a million, at the same effort throughout.
pub fn growth(_: &Values) -> Result<Figure> {
    let frame = Frame::log([0.8, 2e6], [1e-17, 10.0], [64.0, 584.0, 372.0, 32.0]);
    let all = candidates(&problem("free-top/1")?)?;
    let exact = method(&all, "exact")?;
    let mut lines = Vec::new();
    let mut told = Vec::new();
    for line in &LINES {
        let errors = errors(line, method(&all, line.0)?, exact)?;
        if let [.., [_, before], [_, last]] = errors[..] {
            told.push(format!("{} {}", line.0, number((last / before).log10(), 1)));
        }
        lines.push((line, frame.trace(errors)));
    }
    let exact = exact_errors()?;
    let told = told.join(", ");
    let words = words!(
        "In the long run a general method loses nearly two digits a decade of time, a geometric one loses one, and the closed form none.",
        "The same free body, the same effort throughout: 32 steps a turn for rk4, tolerance $10^{{-11}}$ for dop853, 8 steps a turn for rotations-4, 16 for moser-veselov-10. \
         Digits lost in the last decade: {told}.",
        "Error in the attitude against the number of turns, 1 to a million, on logarithmic axes. The lines of rk4 and dop853 become ever steeper, up to nearly two decades \
         of error a decade of turns. Those of the two geometric methods keep to one decade a decade. The closed form stays level near ten to the minus 16."
    );
    Ok(figure("accuracy-growth", 424.0, words, |pen| {
        let turns = [marks(&[1.0, 100.0], ""), powers([4, 6])].concat();
        let errors = powers([0, -4, -8, -12, -16]);
        frame.draw(pen, &turns, &errors, ["turns", "error, rad"]);
        for ((method, _, _, style, aside), places) in &lines {
            beaded(pen, places, *style);
            if let Some(&point) = places.last() {
                let anchor = if aside[0] > 0.0 { Start } else { End };
                let name = label(style.role());
                pen.text(shifted(point, *aside), anchor, method, name);
            }
        }
        let places = frame.trace(exact);
        beaded(pen, &places, inked(1.5 * DATA));
        if let Some(&point) = places.last() {
            pen.label(shifted(point, [0.0, -12.0]), End, "closed form");
        }
    }))
}

/// Errors of the closed form after 1, 10, 1000 and 10⁶ turns.
fn exact_errors() -> Result<Vec<[f64; 2]>> {
    tried(&named("free-top")?, |run| {
        let all = candidates(run)?;
        let found = measure(run, method(&all, "exact")?, Effort::Tolerance(0.0));
        Ok([run.turns(), found.error_attitude.max(2e-17)])
    })
}
