//! The rattleback's two reversals.

use spinning_bodies::scene::contact::{State, passage};

use super::toys::*;
use crate::prelude::*;

parameters! {
    OFF_LEVEL: "tilt", r"\theta_0", "°", "angle off level at the release", [0.1, 1.0], 0.5, logarithmic;
}
/// The parameters. Farther off level and faster the stone shakes so hard that the motion amplifies rounding errors, or that it leaves the table at once.
pub const REVERSALS: [Parameter; 2] = [SPIN.between([1.0, 6.0], 5.0), OFF_LEVEL];

/// Duration of the motion, s.
const END: f64 = 14.0;

/// Times and spins.
fn spins(rows: &[(f64, State)]) -> impl Iterator<Item = Point> {
    rows.iter().map(|(time, state)| [*time, state.spin()])
}

/// It turns back from one sense quickly, from the other slowly.
pub fn reversals(values: &Values) -> Result<Figure> {
    let [spin, tilt] = values.each(REVERSALS);
    let runs = tried([-spin, spin], |spin| {
        run(&stone_scene(spin, tilt.to_radians())?, END, 1400)
    })?;
    let [quick, slow] = [&runs[0], &runs[1]];
    let back = [
        passage(quick, State::spin, 0.0),
        passage(slow, |s| -s.spin(), 0.0),
    ];
    let then = match back {
        [Some(wrong), Some(right)] => format!("takes {:.1} times as long about it", right / wrong),
        _ => format!("has not turned back after {END} seconds"),
    };
    let told = back.map(|time| match time {
        Some(time) => format!("at {time:.2} s"),
        None => "not within the picture".to_owned(),
    });
    let greatest = quick.iter().chain(slow).map(|(_, s)| s.spin().abs());
    let greatest = greatest.fold(spin, f64::max);
    let [spun, askew] = briefs([spin, tilt]);
    let [wrong, right] = &told;
    let words = words!(
        "A rattleback spun the wrong way rattles, stops and turns back; spun the right way it {then}.",
        "Spin about the vertical of Kane and Levinson's stone in pure rolling without any loss, released at ±{spun} rad/s, {askew}° off level. First reversal: the wrong way \
         {wrong}, the right way {right}.",
        "Spin against time up to {END} seconds. One curve starts at minus {spun} radians a second, trembles and crosses zero {wrong}. The grey one starts at plus {spun} and crosses zero \
         {right}."
    );
    let made = figure("rattleback", 372.0, words, |pen| {
        let places = [58.0, 572.0, 322.0, 34.0];
        let frame = Frame::linear([0.0, END], [-1.3 * greatest, 1.3 * greatest], places);
        frame.draw_round(pen, ["time, s", "spin, rad/s"]);
        pen.line([frame.at(0.0, 0.0), frame.at(END, 0.0)], inked(AXIS));
        for (rows, role) in [(slow, Muted), (quick, Ink)] {
            frame.curve(pen, spins(rows), stroke(role, DATA * 0.8));
        }
        let least = 1.18 * greatest;
        for (at, text, role) in [
            (-least, "the wrong way", Ink),
            (least, "the right way", Muted),
        ] {
            let at = shifted(frame.at(0.6, at), [0.0, 5.0]);
            pen.text(at, Start, text, label(role));
        }
    });
    let columns = "time (s) | spin (rad/s)";
    Ok(made
        .data("the wrong way", columns, spins(quick))
        .data("the right way", columns, spins(slow))
        .value("wrong", number(back[0].unwrap_or(0.0), 2))
        .value("right", number(back[1].unwrap_or(0.0), 2)))
}
