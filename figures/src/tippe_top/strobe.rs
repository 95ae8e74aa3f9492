//! Strobed pictures of the chiral top, both ways.

use spinning_bodies::scene::contact::State;

use super::ball::ball;
use super::chiral::BOTH_SPINS;
use super::toys::*;
use crate::prelude::*;

parameters! {
    STEP: "step", r"\Delta t", "s", "time between two pictures", [0.1, 0.5], 0.3;
}
/// The parameters: the release of the figure before, and the time between two pictures.
pub const STROBED: &[Parameter] = &[BOTH_SPINS[0], BOTH_SPINS[1], BOTH_SPINS[2], STEP];

/// Pictures in a row.
const PICTURES: u32 = 7;
const RADIUS: f64 = 36.0;

/// Seven looks at one top, spun one way and the other.
pub fn strobed(values: &Values) -> Result<Figure> {
    let ([spin, tilt, mu], step) = (values.each(BOTH_SPINS), values.of(&STEP));
    let end = step * f64::from(PICTURES - 1);
    let rows = tried([-spin, spin], |spin| {
        let scene = chiral_scene(spin, tilt.to_radians(), 0.0, mu)?;
        run(&scene, end, PICTURES - 1)
    })?;
    let [spun, askew, mu, every] = briefs([spin, tilt, mu, step]);
    let [above, below] = [0, 1].map(|k: usize| {
        let told = tilts(&rows[k]).map(|[_, tilt]| number(tilt, 0));
        told.collect::<Vec<_>>().join(", ")
    });
    let words = words!(
        "Seven looks at one top: clockwise above, anticlockwise below.",
        "The chiral top every {every} s, released at {askew}° with {spun} rad/s, $\\mu = {mu}$ smoothed over 1 mm/s. The filled cap marks the light side of the ball, so it is on top of one that \
         stands on its foot and at the bottom of one that has turned over. Under each ball its tilt.",
        "Two rows of seven balls with a filled cap, {every} seconds apart. In the upper row the cap is tilted by {above} degrees, in the lower row by {below}."
    );
    let made = figure("chiral-strobe", 300.0, words, |pen| {
        row(pen, &rows[0], 106.0, "clockwise");
        row(pen, &rows[1], 240.0, "anticlockwise");
    });
    let columns = "time (s) | tilt (°)";
    Ok(made.data("clockwise", columns, tilts(&rows[0])).data(
        "anticlockwise",
        columns,
        tilts(&rows[1]),
    ))
}

fn row(pen: &mut Pen, rows: &[(f64, State)], floor: f64, name: &str) {
    pen.line([[8.0, floor], [592.0, floor]], inked(SECONDARY));
    pen.label([10.0, floor - 2.0 * RADIUS - 14.0], Start, name);
    // The near side goes to the left if the top is spun clockwise, seen from above.
    let ends = if name == "clockwise" {
        [128.0, 94.0]
    } else {
        [126.0, 160.0]
    };
    let [from, to] = ends.map(|x| [x, floor - 2.0 * RADIUS - 19.0]);
    pen.arrow(from, to, inked(DATA));
    for (k, (time, state)) in rows.iter().enumerate() {
        let center = [50.0 + 83.3 * k as f64, floor - RADIUS];
        ball(pen, &state.attitude, center, RADIUS);
        let text = format!("{}°", number(degrees(state), 0));
        pen.note([center[0], floor + 20.0], Middle, &text);
        if floor > 200.0 {
            let text = format!("{} s", number(*time, if *time > 0.0 { 2 } else { 0 }));
            pen.remark([center[0], floor + 42.0], Middle, &text);
        }
    }
}
