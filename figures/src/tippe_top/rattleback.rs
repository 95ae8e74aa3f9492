//! The rattleback's two reversals.

use spinning_bodies::Error;
use spinning_bodies::scene::contact::{State, passage};

use super::toys::*;
use crate::prelude::*;

parameters! {
    OFF_LEVEL: "tilt", r"\theta_0", "°", "angle off level at the release", [0.1, 5.0], 0.5, logarithmic;
}
/// The parameters.
pub const REVERSALS: [Parameter; 2] = [SPIN.between([1.0, 8.0], 5.0), OFF_LEVEL];

/// Duration of the motion, s.
const END: f64 = 14.0;

/// The stone's motion, or the part of it that is possible in pure rolling, and whether it leaves the table after that.
fn followed(spin: f64, tilt: f64) -> Result<(Rows, bool)> {
    let scene = stone_scene(spin, tilt)?;
    let (mut end, mut leaves) = (END, false);
    loop {
        // At least two hundred rows per second of shaking.
        let samples = (100.0 * end).max(200.0) as u32;
        match run(&scene, end, samples, 1e-3) {
            Err(Error::Integration { time, .. }) if time > 0.0 => {
                (end, leaves) = (0.98 * time.min(end), true);
            }
            // The motion amplifies rounding errors: only a shorter part can be computed.
            Err(_) if end > 0.1 => end *= 0.8,
            rows => return Ok((rows?, leaves)),
        }
    }
}

/// Times and spins.
fn spins(rows: &[(f64, State)]) -> impl Iterator<Item = Point> {
    rows.iter().map(|(time, state)| [*time, state.spin()])
}

/// It turns back from one sense quickly, from the other slowly.
pub fn reversals(values: &Values) -> Result<Figure> {
    let [spin, tilt] = values.each(REVERSALS);
    let (quick, first) = followed(-spin, tilt.to_radians())?;
    let (slow, second) = followed(spin, tilt.to_radians())?;
    let lost = [&quick, &slow].map(|rows| rows.last().map_or(0.0, |row| row.0));
    let back = [
        passage(&quick, State::spin, 0.0),
        passage(&slow, |s| -s.spin(), 0.0),
    ];
    let cut = |(end, way): (f64, &str)| {
        let end = Some(short(end, 3)).filter(|_| end < END)?;
        Some(format!("after {end} seconds spun the {way} way"))
    };
    let cuts = lost.into_iter().zip(["wrong", "right"]).filter_map(cut);
    let cuts: Vec<String> = cuts.collect();
    let does = match first || second {
        true => "leaves the table",
        false => "shakes itself beyond foretelling",
    };
    let claim = match back {
        _ if !cuts.is_empty() => format!(
            "So far off level and so fast, the stone {does}: its curve ends {}.",
            cuts.join(", ")
        ),
        [Some(wrong), Some(right)] if right > wrong => format!(
            "A rattleback spun the wrong way rattles, stops and turns back; spun the right way it takes {} times as long about it.",
            number(right / wrong, 1)
        ),
        [Some(_), None] => format!(
            "A rattleback spun the wrong way rattles, stops and turns back; spun the right way it has not turned back after {END} seconds."
        ),
        [None, None] => format!(
            "So far off level, the stone turns back from neither sense within {END} seconds."
        ),
        _ => "So far off level, the stone rocks at once, and turns back from both senses alike."
            .to_owned(),
    };
    let told = back.map(|time| match time {
        Some(time) => format!("at {time:.2} s"),
        None => "not within the picture".to_owned(),
    });
    let greatest = quick.iter().chain(&slow).map(|(_, s)| s.spin().abs());
    let greatest = greatest.fold(spin, f64::max);
    let [spun, askew] = numbers([spin, tilt], 1);
    let [wrong, right] = &told;
    let words = words!(
        "{claim}",
        "Spin about the vertical of Kane and Levinson's stone in pure rolling without any loss, released at ±{spun} rad/s {askew}° off level. First reversal: the wrong way \
         {wrong}, the right way {right}.",
        "Spin against time up to {END} seconds. One curve starts at minus {spun} radians a second, trembles and crosses zero {wrong}. The grey one starts at plus {spun} and crosses zero \
         {right}."
    );
    let made = figure("rattleback", 372.0, words, |pen| {
        let places = [58.0, 572.0, 322.0, 34.0];
        let frame = Frame::linear([0.0, END], [-1.3 * greatest, 1.3 * greatest], places);
        frame.draw_round(pen, ["time, s", "spin, rad/s"]);
        pen.line([frame.at(0.0, 0.0), frame.at(END, 0.0)], inked(AXIS));
        for (rows, role) in [(&slow, Muted), (&quick, Ink)] {
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
        .data("the wrong way", columns, spins(&quick))
        .data("the right way", columns, spins(&slow))
        .value("wrong", number(back[0].unwrap_or(0.0), 2))
        .value("right", number(back[1].unwrap_or(0.0), 2)))
}
