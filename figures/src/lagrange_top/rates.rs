//! Slow and fast rates of pure precession against the tilt, and where they cease (tutorial 7.3).

use core::f64::consts::PI;

use spinning_bodies::lagrange_top::Nutation;
use spinning_bodies::{Error, Result};

use super::{launch, pure_rates};
use crate::Figure;
use crate::style::{
    AXIS, Anchor, HAIR, Pen, Point, Role, Words, figure, label, number, small, stroke,
};

/// L₃ of the curves, and how they are drawn.
const SPINS: [(f64, f64); 3] = [(1.2, 1.2), (2.0, 2.0), (3.0, 2.8)];
/// Left, right, bottom, top of the frame, and the rates there.
const FRAME: [f64; 4] = [62.0, 556.0, 340.0, 26.0];
const SHOWN: [f64; 2] = [-3.6, 6.2];

fn place(tilt: f64, rate: f64) -> Point {
    let [left, right, bottom, top] = FRAME;
    [
        left + (right - left) * tilt / PI,
        bottom - (bottom - top) * (rate - SHOWN[0]) / (SHOWN[1] - SHOWN[0]),
    ]
}

/// A branch as tops that really precess at a constant tilt: the rates the library reports.
fn branch(axial: f64, which: usize, tilts: [f64; 2]) -> Result<Vec<Point>> {
    const STEPS: u32 = 240;
    let mut points = Vec::new();
    for k in 1..STEPS {
        // Closer towards the ends, where the slow and the fast branch meet.
        let share = 0.5 - 0.5 * (PI * f64::from(k) / f64::from(STEPS)).cos();
        let tilt = tilts[0] + (tilts[1] - tilts[0]) * share;
        let rate = pure_rates(tilt.cos(), axial)?[which];
        if !(SHOWN[0]..=SHOWN[1]).contains(&rate) {
            continue;
        }
        let top = launch(tilt.cos(), rate, axial)?;
        let told = top.mean_precession_rate().unwrap_or(f64::NAN);
        let roots = top.roots();
        let off = (told - rate).abs().max(roots.h2 - roots.h1);
        // Next to the end of the branches the double root of the tilt is nearly a triple one.
        if top.kind() != Nutation::PurePrecession && (off.is_nan() || off >= 1e-6) {
            return Err(Error::OutOfRange {
                quantity: "the tilt of a pure precession",
                value: tilt,
                least: tilts[0],
                greatest: tilts[1],
            });
        }
        points.push(place(tilt, told));
    }
    Ok(points)
}

/// Tilt beyond which pure precession exists, if not at every tilt.
fn least_tilt(axial: f64) -> f64 {
    (0.25 * axial * axial).min(1.0).acos()
}

/// Two rates at every tilt for a fast top; for a slow one they meet and cease.
pub fn precession_rates() -> Result<Figure> {
    let mut curves = Vec::new();
    for (axial, width) in SPINS {
        let from = least_tilt(axial);
        curves.push((width, false, branch(axial, 0, [from, PI])?));
        curves.push((width, true, branch(axial, 1, [from, 0.5 * PI])?));
        curves.push((width, true, branch(axial, 1, [0.5 * PI, PI])?));
    }
    let slowest = SPINS[0].0;
    let end = least_tilt(slowest);
    let [slow, fast] = pure_rates(0.5, 3.0)?;
    let words = Words {
        claim: "A tilted top can precess slowly or fast; if its spin is too slow and its axis too steep, not at all.".to_owned(),
        details: format!(
            "Rates of pure precession against the tilt for $L_3 = {}$, 2 and 3, $I_1 = Mg\\ell = 1.$ Slow solid, fast dashed: {} and {} for \
             $L_3 = 3$ at 60°. Dotted: where the two meet; for $L_3 = {}$ that is at {}°, and a steeper axis has no rate at all.",
            number(slowest, 1),
            number(slow, 4),
            number(fast, 4),
            number(slowest, 1),
            number(end.to_degrees(), 2),
        ),
        alt: "Rates of precession against the tilt from 0 to 180 degrees. For each of three spins a slow branch, low and nearly level, falls \
              gently to the right, and a fast branch rises from the left to infinity at 90 degrees and comes back from minus infinity beyond. \
              For the greatest spin both branches reach the upright axis. For the middle one they just meet there. For the least they \
              meet at a tilt of about 69 degrees, on a dotted curve, and to the left of it there is nothing."
            .to_owned(),
    };
    Ok(figure("precession-rates", 400.0, words, |pen| {
        axes(pen);
        let meeting: Vec<Point> = (0..=300)
            .map(|k| 0.5 * PI * f64::from(k) / 300.0)
            .map(|tilt| (tilt, 1.0 / tilt.cos().sqrt()))
            .filter(|(_, rate)| *rate < SHOWN[1])
            .map(|(tilt, rate)| place(tilt, rate))
            .collect();
        pen.line(&meeting, stroke(Role::Muted, 1.6).dotted());
        for (width, fast, points) in &curves {
            let style = stroke(Role::Ink, *width);
            pen.line(points, if *fast { style.dashed() } else { style });
        }
        pen.disc(place(end, 2.0 / slowest), 3.6, Role::Ink, 1.0);
        pen.disc(place(0.0, 1.0), 3.6, Role::Ink, 1.0);
        for (tilt, rate, text) in [
            (4.0, 3.05, "*L*_{3} = 3"),
            (20.0, 1.75, "2"),
            (60.5, 2.3, "1.2"),
            (140.0, 0.85, "slow"),
            (43.0, 5.4, "fast"),
            (104.0, -2.7, "fast"),
        ] {
            let role = if rate > 1.0 && rate < 5.0 {
                Role::AngularMomentum
            } else {
                Role::Ink
            };
            let [x, y] = place(f64::to_radians(tilt), rate);
            pen.text([x, y], Anchor::Start, text, small(role));
        }
    }))
}

fn axes(pen: &mut Pen) {
    let ink = stroke(Role::Ink, AXIS);
    let [left, right, bottom, top] = FRAME;
    pen.line(&[[left, top], [left, bottom]], ink);
    pen.line(&[place(0.0, 0.0), place(PI, 0.0)], ink);
    pen.line(
        &[place(0.5 * PI, SHOWN[0]), place(0.5 * PI, SHOWN[1])],
        stroke(Role::Muted, HAIR),
    );
    for rate in [-2.0, 0.0, 2.0, 4.0, 6.0] {
        let [x, y] = place(0.0, rate);
        pen.line(&[[x - 5.0, y], [x, y]], ink);
        pen.text(
            [x - 9.0, y + 5.0],
            Anchor::End,
            &number(rate, 0),
            small(Role::Ink),
        );
    }
    for degrees in [0.0, 30.0, 60.0, 90.0, 120.0, 150.0, 180.0] {
        let x = place(f64::to_radians(degrees), 0.0)[0];
        pen.line(&[[x, bottom], [x, bottom + 5.0]], ink);
        pen.text(
            [x, bottom + 22.0],
            Anchor::Middle,
            &format!("{}°", number(degrees, 0)),
            small(Role::Ink),
        );
    }
    pen.line(&[[left, bottom], [right, bottom]], ink);
    pen.text(
        [left + 10.0, top + 6.0],
        Anchor::Start,
        "*φ*\u{2032}",
        label(Role::Ink),
    );
    pen.text([right, bottom + 46.0], Anchor::End, "*θ*", label(Role::Ink));
}
