//! The yo-yo's turn at the end of its string (tutorial 4.9), in five pictures.

use spinning_bodies::yo_yo::{Turn, TurnState, Unwinding};

use super::toy::*;
use crate::prelude::*;

/// Design units per metre; the place of the end of the string; the longest arrow.
const METRE: f64 = 1650.0;
const END: f64 = 136.0;
const LONGEST: f64 = 76.0;

/// Disc, thread and pull at five equal steps of the turn.
pub fn turn(values: &Values) -> Result<Figure> {
    let toy = toy(values, &AXLE)?;
    let [thick, length] = values.each([AXLE, LENGTH]);
    let axle = thick / 1e3;
    let weight = MASS * GRAVITY;
    let way = Unwinding::new(toy, GRAVITY, 0.0)?;
    let turn = Turn::new(toy, GRAVITY, way.omega(length))?;
    let at = |share: f64| -> Result<(f64, TurnState)> {
        let time = share * turn.duration;
        Ok((time, turn.at(time)?))
    };
    let pictures = tried(spaced([0.0, 1.0], 4), at)?;
    let peak = pictures[2].1.tension;
    let ends = [1e3 * turn.duration, turn.omega, turn.fastest, peak / weight];
    let [lasts, spun, fastest, most] = numbers(ends, 1);
    let [long, thick] = briefs([length, thick]);
    let words = words!(
        "In {lasts} milliseconds the centre swings half round the end of the thread: the velocity is reversed, the sense of the spin is not.",
        "A yo-yo of 55 g and radius 29 mm on {long} m of string round an axle of radius {thick} mm, to scale, at five equally spaced instants of its turn. Arrows: the velocity of the centre; \
         bars: the pull of the string. The spin is {spun} rad/s at both ends and {fastest} at the bottom.",
        "Five pictures of a disc on a thread. In the first the axle hangs on the right of the thread and moves down, in the third it is below the end of the thread and moves to the left, in the \
         last it is on the left and moves up. A blue arrow shows the spin, clockwise in all five. The bar of the pull is short, longer, longest at {most} weights, and shorter again."
    );
    let made = figure("yo-yo-turn", 276.0, words, |pen| {
        for (k, (time, state)) in pictures.iter().enumerate() {
            let (sin, cos) = state.angle.sin_cos();
            let end = [64.0 + 118.0 * k as f64, END];
            let arm = METRE * axle;
            let center = shifted(end, [arm * cos, arm * sin]);
            let radius = METRE * 0.029;
            pen.disc(center, radius, Ink, 0.1);
            pen.ring(center, radius, inked(SECONDARY));
            pen.ring(center, arm, inked(AXIS));
            pen.line([[end[0], 12.0], end], inked(AXIS));
            pen.dot(end, 3.0);
            let pull = LONGEST * state.tension / peak;
            pen.line([end, [end[0], end[1] - pull]], inked(5.0));
            // The centre goes round the end of the thread.
            let speed = 0.5 * LONGEST * state.omega / turn.fastest;
            let velocity = shifted(center, [-speed * sin, speed * cos]);
            pen.arrow(center, velocity, inked(SECONDARY));
            let around = [0.9, -0.7].map(|turned| turned - state.angle);
            let style = stroke(Omega, DATA);
            pen.arc_arrow(center, 0.8 * radius, around[0], around[1], style);
            let [time, pull] = numbers([1e3 * time, state.tension / weight], 1);
            pen.remark([end[0], 232.0], Middle, &format!("{time} ms"));
            pen.note([end[0], 256.0], Middle, &format!("pull {pull} *Mg*"));
        }
        let first = [64.0 + METRE * axle, END];
        let name = polar(first, 0.8 * METRE * 0.029 + 18.0, 0.8);
        pen.text(name, Start, "*Ω*", label(Omega));
    });
    let columns =
        "time (s) | angle (rad) | depth (m) | velocity downward (m/s) | spin (rad/s) | pull (N)";
    let rows = tried(spaced([0.0, 1.0], 200), |share| {
        let (time, s) = at(share)?;
        Ok([time, s.angle, s.depth, s.velocity, s.omega, s.tension])
    })?;
    Ok(made.data("turn", columns, rows))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By Newton's law the integral of the pull minus the weight is the change of momentum; and the energy is conserved.
    #[test]
    fn the_pull_reverses_the_momentum() {
        for axle in [3.0, 5.0, 9.0] {
            let values = Values::default().with(&AXLE, axle).expect("an axle");
            let rows = turn(&values).expect("a figure").data.rows;
            let row = |k: usize| &rows[k].1;
            let step = row(1)[0] - row(0)[0];
            let sum: f64 =
                (1..200).map(|k| row(k)[5]).sum::<f64>() + 0.5 * (row(0)[5] + row(200)[5]);
            let impulse = step * sum - 0.055 * 9.81 * row(200)[0];
            let reversed = 0.055 * (row(0)[3] - row(200)[3]);
            // Two hundred steps of the trapezoidal rule.
            assert!(
                (impulse / reversed - 1.0).abs() < 3e-5,
                "{impulse} {reversed}"
            );
            let energy = |k: usize| {
                let speed = axle / 1e3 * row(k)[4];
                0.055
                    * (0.5 * speed * speed + 0.25 * (0.029 * row(k)[4]).powi(2) - 9.81 * row(k)[2])
            };
            let lost = (0..=200).map(|k| (energy(k) - energy(0)).abs());
            assert!(lost.fold(0.0, f64::max) < 1e-15);
        }
    }
}
