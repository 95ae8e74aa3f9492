//! The energy over a million steps.

use lab::accuracy::{Candidate, candidates};
use spinning_bodies::euler_top::EulerTop;
use spinning_bodies::integrators::Effort;
use spinning_bodies::integrators::geometric::Phase;

use super::problem::*;
use crate::prelude::*;

/// A sixteenth of a second, about a thirtieth of a turn.
const STEP: f64 = 0.0625;
const PARTS: u32 = 500;
const STEPS: u32 = 2000;

/// Relative error of the energy, largest so far, over 10⁶ steps of three methods.
pub fn energy_drift(_: &Values) -> Result<Figure> {
    let problem = problem("free-top/1")?;
    let energy = |phase: &Phase| -> Result<f64> {
        let (momentum, attitude) = (phase.angular_momentum(), phase.attitude()?);
        Ok(EulerTop::new(problem.moments(), momentum, attitude)?.energy())
    };
    let first = energy(problem.start())?;
    let all = candidates(&problem)?;
    let counts: Vec<f64> = (1..=PARTS).map(|part| f64::from(part * STEPS)).collect();
    let times: Vec<f64> = counts.iter().map(|count| count * STEP).collect();
    // The number of steps, and the largest relative error of the energy so far.
    let errors = |Candidate { method, .. }: &Candidate| -> Result<Vec<[f64; 2]>> {
        let effort = Effort::Step(STEP * (1.0 + 1e-9));
        let states = method.follow(problem.start(), &times, effort)?.states;
        let mut worst = 0.0_f64;
        tried(counts.iter().zip(&states), |(&count, phase)| {
            worst = worst.max((energy(phase)? / first - 1.0).abs());
            Ok([count, worst])
        })
    };
    let line = |name: &'static str, style| -> Result<_> {
        Ok((errors(method(&all, name)?)?, style, name))
    };
    let lines = [
        line("rk4", muted(DATA))?,
        line("rotations-2", inked(DATA).dashed())?,
        line("moser-veselov-2", inked(DATA))?,
    ];
    let frame = Frame::log([2e3, 1e6], [1e-16, 1e-2], [64.0, 584.0, 332.0, 32.0]);
    let [rk4, rotations, discrete] = lines.each_ref().map(|(line, ..)| {
        let last = line.last().map_or(f64::NAN, |point| point[1]);
        format!("${}$", scientific(last, 1))
    });
    let words = words!(
        "A million steps: rk4 leaks energy without end, rotations borrow it and give it back, the discrete top keeps it.",
        "Relative error of the energy of a free body, the largest so far, against the number of steps, 32 a turn. After $10^6$ of them it is {rk4} for rk4, \
         {rotations} for rotations of order 2, and {discrete} for Moser and Veselov's discrete top, a random walk of rounding.",
        "Largest relative error of the energy against the number of steps, two thousand to a million, on logarithmic axes. The line of rk4 rises \
         in proportion to the number of steps. That of rotations of order 2 is level, and rk4 crosses it after some two hundred thousand steps. That of the discrete top stays below ten to the minus 14."
    );
    Ok(figure("accuracy-drift", 384.0, words, |pen| {
        let across = powers([4, 5, 6]);
        let up = powers([-4, -6, -8, -10, -12, -14, -16]);
        frame.draw(pen, &across, &up, ["steps", "energy, relative error"]);
        for (k, (line, style, name)) in lines.iter().enumerate() {
            let places = Vec::from_iter(thinned(line).map(|[x, y]| frame.at(x, y.max(1e-16))));
            pen.line(&places, *style);
            if let Some(&end) = places.last() {
                let beside = if k == 1 { 22.0 } else { -10.0 };
                let at = shifted(end, [-6.0, beside]);
                pen.text(at, End, name, label(style.role()));
            }
        }
    }))
}

/// About twenty points per decade.
fn thinned(line: &[[f64; 2]]) -> impl Iterator<Item = [f64; 2]> {
    let mut next = 0.0;
    line.iter().copied().filter(move |&[x, _]| {
        let shown = x >= next || x >= f64::from(PARTS) * f64::from(STEPS);
        if shown {
            next = 1.12 * x;
        }
        shown
    })
}
