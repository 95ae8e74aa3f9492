//! The racket's flip as a film strip (tutorial 6.3).

use spinning_bodies::euler_top::State;

use super::body::triple;
use super::racket::{Face, MOMENTS, TURNS, Throw, draw, face, view};
use crate::prelude::*;

/// Pictures, the first and the last included.
const FRAMES: usize = 9;
/// Heights of the two rows.
const ROWS: [f64; 2] = [116.0, 304.0];
const SCALE: f64 = 172.0;

parameters! {
    HANDLE: "handle", "I_1", "g m²", "moment about the handle", [1.15, 3.0], 1e3 * MOMENTS[0];
    SPIN: "turns", r"\Omega_2", "turns/s", "spin about the middle axis at the throw", [0.3, 3.0], TURNS;
    OFF: "off", r"\varepsilon", "°", "angle between L and the middle axis at the throw", [0.05, 20.0], 0.916, logarithmic;
}
/// The parameters.
pub const FILM: &[Parameter] = &[HANDLE, SPIN, OFF];

/// Two throws, a degree apart.
pub fn film(values: &Values) -> Result<Figure> {
    let [handle, turns, degrees] = values.each([HANDLE, SPIN, OFF]);
    let moments = [1e-3 * handle, MOMENTS[1], MOMENTS[2]];
    let thrown = Throw::off(moments, turns, degrees.to_radians())?;
    let exact = Throw::off(moments, turns, 0.0)?;
    let time = |k: usize| thrown.flip_time() * k as f64 / (FRAMES - 1) as f64;
    let states = tried(0..FRAMES, |k| {
        Ok([exact.top.at(time(k))?, thrown.top.at(time(k))?])
    })?;
    let somersaults = thrown.somersaults();
    let whole = (somersaults - 1.0).abs() < 0.01;
    let counted = number(somersaults, 2);
    let off = brief(degrees);
    let claim = match whole {
        true => "Spun about its middle axis, a racket makes half a twist with every somersault."
            .to_owned(),
        false => format!(
            "Spun {off}° off its middle axis, this racket makes half a twist in {counted} somersaults."
        ),
    };
    let brings = match whole {
        true => "brings the handle back and the other face to the front".to_owned(),
        false => format!("turns the handle {counted} times over, and $x_2$ to the other side"),
    };
    let seen = |state: State| match face(&state.attitude, &view([0.0; 2], SCALE)) {
        Face::Front => "bare",
        Face::Back => "filled",
    };
    let [above, below] = states[FRAMES - 1].map(seen);
    let pace = match turns {
        1.0 => "one turn a second".to_owned(),
        _ => format!("{} turns a second", brief(turns)),
    };
    let half = number(thrown.flip_time(), 3);
    let inertia = triple(moments.map(|moment| 1e3 * moment));
    let words = words!(
        "{claim}",
        "Two throws at {pace} seen at {FRAMES} equal times. Above, exactly about the middle axis $x_2$: no hand can do it. Below, with $L$ {off}° off: half a period of \
         $\\Omega$, {half} s, {brings}. One face is filled; the dot is the end of $x_2$. $I = {inertia}$ g m².",
        "Two rows of {FRAMES} pictures of a tennis racket turning head over handle. In the upper row it turns in one plane and \
         ends with its {above} face to the front and the dot on the right. In the lower row, thrown {off} degrees \
         differently, it twists half-way through about its handle and ends with its {below} face to the front and the dot on \
         the left."
    );
    let made = figure("racket-flip", 424.0, words, |pen| {
        let x = |k: usize| 40.0 + 62.5 * k as f64;
        let off = format!("thrown with *L* {off}° off it");
        for (y, text) in ROWS.into_iter().zip(["thrown exactly about *x*_{2}", &off]) {
            pen.note([10.0, y - 88.0], Start, text);
            let rule = [[10.0, y], [566.0, y]];
            pen.line(rule, stroke(AngularMomentum, AXIS).dotted());
            pen.arrow([570.0, y], [594.0, y], stroke(AngularMomentum, DATA));
            pen.text([582.0, y - 8.0], Middle, "*L*", label(AngularMomentum));
        }
        for (k, pair) in states.iter().enumerate() {
            for (state, y) in pair.iter().zip(ROWS) {
                draw(pen, &view([x(k), y], SCALE), &state.attitude, 1.0);
            }
            let text = match k {
                0 => "0".to_owned(),
                _ => format!("{} s", number(time(k), 2)),
            };
            pen.note([x(k), 410.0], Middle, &text);
        }
    });
    let columns = "time (s) | Ω₁ (rad/s) | Ω₂ (rad/s) | Ω₃ (rad/s)";
    let rows = |which: usize| {
        let row = |(k, pair): (usize, &[State; 2])| {
            let omega = pair[which].omega;
            [time(k), omega.x(), omega.y(), omega.z()]
        };
        states.iter().enumerate().map(row).collect::<Vec<_>>()
    };
    Ok(made
        .data("exactly about the middle axis", columns, rows(0))
        .data("off it", columns, rows(1)))
}
