//! The chiral top spun both ways.

use spinning_bodies::scene::contact::passage;

use super::toys::*;
use crate::prelude::*;

parameters! {
    RELEASE: "tilt", r"\theta_0", "°", "tilt at the release", [1.0, 30.0], 3.0;
}
/// The parameters.
pub const BOTH_SPINS: [Parameter; 3] = [
    SPIN.between([60.0, 200.0], CHIRAL_SPIN),
    RELEASE,
    FRICTION.between([0.1, 0.6], 0.3),
];

/// Duration of the motion, s.
const END: f64 = 3.0;

/// One body, and its different motions for both senses of spin.
pub fn both_spins(values: &Values) -> Result<Figure> {
    let [spin, tilt, mu] = values.each(BOTH_SPINS);
    let runs = tried([-spin, spin], |spin| {
        let scene = chiral_scene(spin, tilt.to_radians(), 0.0, mu)?;
        run(&scene, END, 600)
    })?;
    let side = [0, 1].map(|k| passage(&runs[k], degrees, 90.0));
    let last = [0, 1].map(|k| degrees(&runs[k][600].1));
    let most = [0, 1].map(|k| greatest_tilt(&runs[k]));
    let over = [0, 1].map(|k| side[k].is_some() && last[k] > 150.0);
    let claim = match over {
        [true, false] => {
            "The same top, released the same way: clockwise it turns over, anticlockwise it does not."
        }
        [true, true] => "Released like this, the top turns over whichever way it is spun.",
        [false, true] => {
            "The same top, released the same way: anticlockwise it turns over, clockwise it does not."
        }
        [false, false] if side.iter().any(Option::is_some) => {
            "Released like this, the top falls over, but does not get to its head within three seconds."
        }
        [false, false] => {
            "Released like this, the top turns over neither way within three seconds."
        }
    };
    let told = [0, 1].map(|k| {
        let (way, ends, most) = (["Clockwise", "Anticlockwise"][k], last[k], most[k]);
        match side[k] {
            Some(time) => {
                format!("{way} it is on its side after {time:.2} s and ends at {ends:.0}°.")
            }
            None => format!("{way} it stays below {most:.1}° for these {END} seconds."),
        }
    });
    let told = told.join(" ");
    let [spun, askew, mu] = briefs([spin, tilt, mu]);
    let words = words!(
        "{claim}",
        "Tilt of the chiral top, a ball of $R = 2$ cm, released at {askew}° with {spun} rad/s about the vertical, $\\mu = {mu}$ smoothed over 1 mm/s. {told}",
        "Tilt in degrees against time up to {END} seconds. Both curves, clockwise and, in grey, anticlockwise, start at {askew}°. {told}"
    );
    let made = figure("chiral-top", 402.0, words, |pen| {
        let frame = Frame::linear([0.0, END], [0.0, 180.0], [58.0, 572.0, 350.0, 34.0]);
        tilt_against_time(pen, &frame);
        let styles = [inked(DATA), muted(DATA)];
        for (rows, style) in runs.iter().zip(styles) {
            frame.curve(pen, tilts(rows), style);
        }
        // Each name at the right, as near to its curve as there is room.
        let names = ["clockwise, seen from above", "anticlockwise"];
        for (k, role) in [Ink, Muted].into_iter().enumerate() {
            let x = 572.0 - 3.9 * names[k].len() as f64;
            let end = frame.y.at(last[k]);
            let heights = (0..60).map(|k| 48.0 + 5.0 * f64::from(k));
            let across = |y| [0.0, 90.0, 180.0, 270.0].map(|left| [x - left, y]);
            let mut places: Vec<Point> = heights.flat_map(across).collect();
            let far = |at: &Point| (at[1] - end).abs() + 0.6 * (x - at[0]);
            places.sort_by(|a, b| far(a).total_cmp(&far(b)));
            pen.name(places, names[k], label(role));
        }
    });
    let columns = "time (s) | tilt (°)";
    Ok(made
        .data("clockwise", columns, tilts(&runs[0]))
        .data("anticlockwise", columns, tilts(&runs[1]))
        .value("side", number(side[0].unwrap_or(0.0), 2))
        .value("most", number(most[1], 1)))
}
