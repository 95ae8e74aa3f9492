//! The swivel in four pictures, seen from above (tutorial 1.1, picture b).

use crate::prelude::*;
use spinning_bodies::scene::effects::{FourPhases, Pace};
use spinning_bodies::scene::shape::{self, SwivelState};
use spinning_bodies::scene::{Request, Scene};

parameters! {
    pub OUT: "arms_out", r"A_\mathrm{out}", "kg m²", "moment of the upper body with the arms out", [1.1, 2.4], 2.0;
    pub IN: "arms_in", r"A_\mathrm{in}", "kg m²", "moment of the upper body with the arms in", [0.3, 1.0], 0.7;
    pub LOWER: "lower", "B", "kg m²", "moment of the lower body", [0.1, 2.0], 0.6;
    pub TWIST: "twist", r"\Psi", "°", "twist at the waist", [20.0, 110.0], 90.0;
}

/// What may be chosen of the swivel.
pub const SWIVEL: &[Parameter] = &[OUT, IN, LOWER, TWIST];

fn change(values: &Values) -> FourPhases {
    let twist = values.of(&TWIST);
    FourPhases {
        arms_out: values.of(&OUT),
        arms_in: values.of(&IN),
        // The book's is exact.
        twist: if twist == 90.0 {
            FRAC_PI_2
        } else {
            twist.to_radians()
        },
        duration: 4.0,
        pace: Pace::Even,
    }
}

/// An ellipse turned by `angle`, counterclockwise.
fn ellipse(center: Point, half: [f64; 2], angle: f64) -> Vec<Point> {
    let (s, c) = angle.sin_cos();
    (0..72)
        .map(|k| {
            let (sin, cos) = (TAU * f64::from(k) / 72.0).sin_cos();
            let (x, y) = (half[0] * cos, half[1] * sin);
            [center[0] + c * x - s * y, center[1] - s * x - c * y]
        })
        .collect()
}

/// Someone who looks up the page at angle 0: feet and hip below, shoulders, arms and head above.
fn person(pen: &mut Pen, center: Point, state: &SwivelState, out: bool) {
    let solid = |pen: &mut Pen, outline: &[Point], tone: f64| {
        pen.fill(outline, Paper, 1.0);
        pen.fill(outline, Ink, tone);
        pen.outline(outline, inked(AXIS));
    };
    // Feet, pointing where the lower body faces.
    for side in [-1.0, 1.0] {
        let angle = state.lower;
        let (s, c) = angle.sin_cos();
        let (x, y) = (13.0 * side, 12.0);
        let place = [center[0] + c * x - s * y, center[1] - s * x - c * y];
        solid(pen, &ellipse(place, [7.5, 17.0], angle), 0.3);
    }
    solid(pen, &ellipse(center, [26.0, 15.0], state.lower), 0.2);
    let (s, c) = state.upper.sin_cos();
    let at = |x: f64, y: f64| [center[0] + c * x - s * y, center[1] - s * x - c * y];
    for side in [-1.0, 1.0] {
        if out {
            solid(
                pen,
                &ellipse(at(46.0 * side, 2.0), [24.0, 6.0], state.upper),
                0.06,
            );
            pen.disc(at(71.0 * side, 2.0), 5.0, Ink, 0.8);
        } else {
            solid(
                pen,
                &ellipse(at(23.0 * side, 9.0), [6.0, 13.0], state.upper),
                0.06,
            );
            pen.disc(at(17.0 * side, 20.0), 5.0, Ink, 0.8);
        }
    }
    solid(pen, &ellipse(center, [31.0, 13.0], state.upper), 0.06);
    solid(pen, &ellipse(center, [11.5, 13.5], state.upper), 0.06);
    let nose = [at(-3.5, 12.5), at(0.0, 19.0), at(3.5, 12.5)];
    pen.fill(nose, Ink, 1.0);
}

/// Twist, arms in, untwist, arms out.
pub fn swivel(values: &Values) -> Result<Figure> {
    let (change, lower) = (change(values), values.of(&LOWER));
    let scene = shape::Swivel::new(lower, change.arms_out)?.with(change)?;
    let motion = scene.simulate(&Request::at([0.0, 1.0, 2.0, 3.0, 4.0])?)?;
    let rows = motion.rows;
    let states: Vec<SwivelState> = rows.iter().map(|(_, state)| *state).collect();
    let degrees = |angle: f64| number(angle.to_degrees(), 1);
    let net = states[4].lower.to_degrees();
    let claim = match net.abs() >= 1.0 {
        true => {
            "Twist with the arms out, untwist with the arms in: you face another way.".to_owned()
        }
        false => format!(
            "Twist with the arms out, untwist with the arms in: you face another way, by {} degrees only.",
            number(net.abs(), 2)
        ),
    };
    let twist = short(values.of(&TWIST), 1);
    let [out, near, below] = shorts([change.arms_out, change.arms_in, lower], 2);
    let [there, back] = [states[1].lower, states[3].lower - states[2].lower].map(degrees);
    let end = number(net, 3);
    let [left, right, aside] = [states[1].upper, -states[1].lower, -states[4].lower].map(degrees);
    let words = words!(
        "{claim}",
        "Seen from above. The upper body twists by {twist}° against the lower; the arrows show how far the lower body has turned. Moments {out} and {near} kg m² \
         above, {below} kg m² below: the feet go {there}° one way, {back}° back, and end at {end}°. The angular momentum is 0 throughout.",
        "Five views of a person from above. At first feet and nose point up the page. Arms out, the shoulders have turned left by {left}° and the \
         feet right by {right}°. Arms in. Untwisted: the feet have come back, but not the whole way. Arms out again: feet and nose point {aside}° to \
         the right of where they began."
    );
    let centers: [Point; 5] = [
        [100.0, 112.0],
        [300.0, 112.0],
        [500.0, 112.0],
        [200.0, 316.0],
        [400.0, 316.0],
    ];
    let names = ["", "1  twist", "2  arms in", "3  untwist", "4  arms out"];
    let made = figure("swivel", 430.0, words, |pen| {
        for ((state, center), name) in states.iter().zip(centers).zip(names) {
            pen.ring(center, 82.0, muted(AXIS).alpha(0.6));
            pen.line(
                [
                    polar(center, 74.0, FRAC_PI_2),
                    polar(center, 88.0, FRAC_PI_2),
                ],
                muted(AXIS),
            );
            let out = state.upper_moment > 0.5 * (change.arms_out + change.arms_in);
            person(pen, center, state, out);
            let tip = FRAC_PI_2 + state.lower;
            if state.lower.abs() > 0.01 {
                pen.arc_arrow(center, 82.0, FRAC_PI_2, tip, stroke(Omega, DATA));
                let ahead = polar(center, 82.0, tip);
                let ends = [polar(center, 30.0, tip), ahead];
                pen.line(ends, stroke(Omega, SECONDARY).dotted());
            }
            let text = if name.is_empty() {
                "at first".to_owned()
            } else {
                format!("{name}: {}°", degrees(state.lower))
            };
            pen.label([center[0], center[1] + 106.0], Middle, &text);
        }
        pen.text([592.0, 396.0], End, "angles of the feet", small(Omega));
    });
    let columns = "time (s) | lower body (°) | upper body (°) | upper moment (kg m²)";
    let rows = rows.iter().map(|(t, state)| {
        let [lower, upper] = [state.lower, state.upper].map(f64::to_degrees);
        [*t, lower, upper, state.upper_moment]
    });
    Ok(made.data("swivel", columns, rows))
}
