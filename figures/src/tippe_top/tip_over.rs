//! The tilt of the hoop with clay against the tutorial's straight line.

use spinning_bodies::Result;
use spinning_bodies::scene::contact::passage;

use super::plot::Frame;
use super::{TOY_SPIN, run, toy, toy_scene};
use crate::Figure;
use crate::style::{
    Anchor, DATA, HAIR, Role, SECONDARY, Words, figure, label, number, small, stroke,
};

/// A reckless estimate that is right to a few per cent.
pub fn tip_over() -> Result<Figure> {
    let runs = [
        run(&toy_scene(0.05, TOY_SPIN)?, 2.5, 250, 1e-3)?,
        run(&toy_scene(0.1, TOY_SPIN)?, 2.5, 250, 1e-3)?,
    ];
    let hoop = toy(0.1)?;
    let rate = hoop.tip_rate(TOY_SPIN);
    let mean = |k: usize| -> f64 {
        let at = |level: f64| passage(&runs[k], |s| s.tilt().to_degrees(), level);
        120.0 / (at(150.0).unwrap_or(f64::NAN) - at(30.0).unwrap_or(f64::NAN))
    };
    let words = Words {
        claim: "The tutorial's straight line has the right slope to a tenth, and the lighter the clay, the better."
            .to_owned(),
        details: format!(
            "Tilt of the tutorial's toy, a ball with $R = 2$ cm, $I = \\frac25MR^2$, 50 turns a second, $\\mu = \\frac13$, released at 0.1 rad. \
             Dashed: the estimate, {}° a second. Between 30° and 150° the full motion makes {}° a second for \
             $\\alpha = 0.05$ and {}° for $\\alpha = 0.1$. Dotted: the rate that Jellett's integral gives for $\\alpha = 0.1$.",
            number(rate.to_degrees(), 2),
            number(mean(0), 1),
            number(mean(1), 1),
        ),
        alt: "Tilt in degrees against time in seconds. A dashed straight line rises from near zero to 180 degrees at 2.3 seconds. Two \
              solid curves of nearly the same slope bend at the end and creep into 180 degrees. The one for the heavier clay is the steeper; the one for the \
              lighter clay starts a tenth of a second late and then runs almost parallel to the line. A dotted curve runs through the \
              steeper one."
            .to_owned(),
    };
    Ok(figure("tip-over", 392.0, words, |pen| {
        let frame = Frame {
            sides: [58.0, 580.0, 340.0, 16.0],
            x: [0.0, 2.5],
            y: [0.0, 180.0],
        };
        frame.axes(
            pen,
            &[
                (0.0, "0"),
                (0.5, "0.5"),
                (1.0, "1"),
                (1.5, "1.5"),
                (2.0, "2"),
                (2.5, "2.5 s"),
            ],
            &[
                (0.0, "0°"),
                (45.0, "45°"),
                (90.0, "90°"),
                (135.0, "135°"),
                (180.0, "180°"),
            ],
        );
        frame.names(pen, "time", "");
        pen.line(
            &[frame.at(0.0, 90.0), frame.at(2.5, 90.0)],
            stroke(Role::Muted, HAIR),
        );
        let start = 0.1_f64;
        let line = (0..=1).map(|k| {
            let t = f64::from(k) * (core::f64::consts::PI - start) / rate;
            (t, (start + rate * t).to_degrees())
        });
        frame.curve(pen, line, stroke(Role::Ink, SECONDARY).dashed());
        let refined = (0..=120).map(|k| {
            let tilt = start + (core::f64::consts::PI - start) * f64::from(k) / 120.0;
            (hoop.refined_time(TOY_SPIN, start, tilt), tilt.to_degrees())
        });
        frame.curve(pen, refined, stroke(Role::Ink, SECONDARY).dotted());
        for (rows, role) in runs.iter().zip([Role::Omega, Role::AngularMomentum]) {
            let curve = rows.iter().map(|(t, s)| (*t, s.tilt().to_degrees()));
            frame.curve(pen, curve, stroke(role, DATA));
        }
        let at = |x: f64, y: f64| frame.at(x, y);
        pen.text(
            at(1.52, 146.0),
            Anchor::End,
            "*α* = 0.1",
            label(Role::AngularMomentum),
        );
        pen.text(
            at(1.62, 100.0),
            Anchor::Start,
            "*α* = 0.05",
            label(Role::Omega),
        );
        pen.text(
            at(1.19, 66.0),
            Anchor::Start,
            "the estimate, *RμMg*/*IΩ*",
            small(Role::Ink),
        );
    })
    .value("estimate", number(rate.to_degrees(), 2))
    .value("light", number(mean(0), 1))
    .value("heavy", number(mean(1), 1)))
}
