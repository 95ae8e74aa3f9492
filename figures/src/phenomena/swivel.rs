//! The swivel in four pictures, seen from above (tutorial 1.1, picture b).

use spinning_bodies::scene::effects::{FourPhases, Pace};
use spinning_bodies::scene::shape::{self, SwivelState};
use spinning_bodies::scene::{Request, Scene};

use crate::prelude::*;

parameters! {
    pub OUT: "arms_out", r"A_\mathrm{out}", "kg m²", "moment of the upper body with the arms out", [1.1, 2.4], 2.0;
    pub IN: "arms_in", r"A_\mathrm{in}", "kg m²", "moment of the upper body with the arms in", [0.3, 1.0], 0.7;
    pub LOWER: "lower", "B", "kg m²", "moment of the lower body", [0.1, 2.0], 0.6;
    pub TWIST: "twist", r"\Psi", "°", "twist at the waist", [20.0, 110.0], 90.0;
}

/// The parameters of the swivel.
pub const SWIVEL: &[Parameter] = &[OUT, IN, LOWER, TWIST];

fn change(values: &Values) -> FourPhases {
    let twist = values.of(&TWIST);
    FourPhases {
        arms_out: values.of(&OUT),
        arms_in: values.of(&IN),
        // The value of the book is exact.
        twist: match twist {
            90.0 => FRAC_PI_2,
            _ => twist.to_radians(),
        },
        duration: 4.0,
        pace: Pace::Even,
    }
}

/// A place turned about the centre by `angle`, counterclockwise.
fn turned(center: Point, angle: f64, [x, y]: Point) -> Point {
    let (s, c) = angle.sin_cos();
    [center[0] + c * x - s * y, center[1] - s * x - c * y]
}

/// Someone who looks up the page at angle 0: feet and hip below, shoulders, arms and head above.
fn person(pen: &mut Pen, center: Point, state: &SwivelState, out: bool) {
    // Ellipses that turn with a part of the body.
    let solid = |pen: &mut Pen, angle: f64, place: Point, half: [f64; 2], tone: f64| {
        let middle = turned(center, angle, place);
        let outline: Vec<Point> = (0..72)
            .map(|k| (TAU * f64::from(k) / 72.0).sin_cos())
            .map(|(sin, cos)| turned(middle, angle, [half[0] * cos, half[1] * sin]))
            .collect();
        pen.fill(&outline, Paper, 1.0);
        pen.fill(&outline, Ink, tone);
        pen.outline(&outline, inked(AXIS));
    };
    let SwivelState { lower, upper, .. } = *state;
    // Feet, pointing where the lower body faces.
    for side in [-13.0, 13.0] {
        solid(pen, lower, [side, 12.0], [7.5, 17.0], 0.3);
    }
    solid(pen, lower, [0.0; 2], [26.0, 15.0], 0.2);
    let at = |x: f64, y: f64| turned(center, upper, [x, y]);
    for side in [-1.0, 1.0] {
        let ([arm, half], hand) = match out {
            true => ([[46.0 * side, 2.0], [24.0, 6.0]], at(71.0 * side, 2.0)),
            false => ([[23.0 * side, 9.0], [6.0, 13.0]], at(17.0 * side, 20.0)),
        };
        solid(pen, upper, arm, half, 0.06);
        pen.disc(hand, 5.0, Ink, 0.8);
    }
    for half in [[31.0, 13.0], [11.5, 13.5]] {
        solid(pen, upper, [0.0; 2], half, 0.06);
    }
    pen.fill([at(-3.5, 12.5), at(0.0, 19.0), at(3.5, 12.5)], Ink, 1.0);
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
            "Twist with the arms out, untwist with the arms in: you face another way, by only {} degrees.",
            number(net.abs(), 2)
        ),
    };
    let [twist, out, near, below] = briefs(values.each([TWIST, OUT, IN, LOWER]));
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
    let above = [100.0, 300.0, 500.0].map(|x| [x, 112.0]);
    let centers = above.into_iter().chain([[200.0, 316.0], [400.0, 316.0]]);
    let names = ["", "1  twist", "2  arms in", "3  untwist", "4  arms out"];
    let made = figure("swivel", 430.0, words, |pen| {
        for ((state, center), name) in states.iter().zip(centers).zip(names) {
            pen.ring(center, 82.0, muted(AXIS).alpha(0.6));
            let ahead = [74.0, 88.0].map(|out| polar(center, out, FRAC_PI_2));
            pen.line(ahead, muted(AXIS));
            let out = state.upper_moment > 0.5 * (change.arms_out + change.arms_in);
            person(pen, center, state, out);
            let tip = FRAC_PI_2 + state.lower;
            if state.lower.abs() > 0.01 {
                pen.arc_arrow(center, 82.0, FRAC_PI_2, tip, stroke(Omega, DATA));
                let now = [30.0, 82.0].map(|out| polar(center, out, tip));
                pen.line(now, stroke(Omega, SECONDARY).dotted());
            }
            let text = match name {
                "" => "at first".to_owned(),
                _ => format!("{name}: {}°", degrees(state.lower)),
            };
            pen.label(shifted(center, [0.0, 106.0]), Middle, &text);
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
