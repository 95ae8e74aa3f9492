//! Growth rates of the chiral top's slow swing against friction.

use spinning_bodies::Result;
use spinning_bodies::tippe_top::{Regularised, bodies, quasi_steady};

use super::G;
use crate::Figure;
use crate::style::{
    AXIS, Anchor, DATA, HAIR, Point, Role, SECONDARY, Words, figure, label, number, small, stroke,
};

/// Decades of friction and of rate.
const MU: [f64; 2] = [-3.0, -0.6];
const RATE: [f64; 2] = [-6.3, -0.7];

fn place(mu: f64, rate: f64) -> Point {
    [
        74.0 + 480.0 * (mu.log10() - MU[0]) / (MU[1] - MU[0]),
        340.0 - 324.0 * (rate.log10() - RATE[0]) / (RATE[1] - RATE[0]),
    ]
}

/// Handedness is of second order in friction.
pub fn growth_rates() -> Result<Figure> {
    let (natural, speed) = ((G / 0.02).sqrt(), (G * 0.02).sqrt());
    let body = bodies::chiral_top()?;
    let swing = |mu: f64, sense: f64| -> Result<f64> {
        let law = Regularised::new(mu, 1e-3 * speed)?;
        Ok(quasi_steady(&body, G, law, sense * 6.0 * natural)?
            .slow_swing()?
            .growth
            / natural)
    };
    let mut points = Vec::new();
    for k in 0..=22 {
        let mu = 10_f64.powf(-2.9 + 0.1 * f64::from(k));
        let (plus, minus) = (swing(mu, 1.0)?, swing(mu, -1.0)?);
        points.push((mu, 0.5 * (minus - plus), 0.5 * (minus + plus)));
    }
    let slope = |a: f64, b: f64| (b / a).log10() / 0.1;
    let (first, second) = (&points[0], &points[1]);
    let words = Words {
        claim: "What both spins share grows like the friction; what tells them apart, like its square.".to_owned(),
        details: format!(
            "Growth rates of the chiral top's slow swing about its quasi-steady state, in units of $\\sqrt{{g/R}}$, at $6\\sqrt{{g/R}}$: half the difference \
             of the two senses and their mean. At the left end the slopes are {} and {}. Dotted: slopes 2 and 1. Where the mean falls off it \
             changes sign.",
            number(slope(first.1, second.1), 2),
            number(slope(first.2, second.2), 2),
        ),
        alt: "Two curves on doubly logarithmic axes, friction from 0.001 to 0.2. The half difference of the growth rates follows a line of slope \
              two over four decades. The mean follows a line of slope one and lies above it for little friction; for friction above \
              0.01 the difference is the greater."
            .to_owned(),
    };
    Ok(figure("chiral-growth", 400.0, words, |pen| {
        let ink = stroke(Role::Ink, AXIS);
        let (corner, right, top) = ([74.0, 340.0], 560.0, 16.0);
        pen.line(&[[corner[0], top], corner, [right, corner[1]]], ink);
        for (decade, text) in [(-3, "0.001"), (-2, "0.01"), (-1, "0.1")] {
            let [x, _] = place(10_f64.powi(decade), 1e-3);
            pen.line(&[[x, 340.0], [x, 345.0]], ink);
            pen.text([x, 361.0], Anchor::Middle, text, small(Role::Ink));
        }
        for decade in -6..=-1 {
            let [_, y] = place(1e-2, 10_f64.powi(decade));
            pen.line(&[[69.0, y], [74.0, y]], ink);
            pen.line(
                &[[74.0, y], [right, y]],
                stroke(Role::Muted, HAIR).alpha(0.4),
            );
            pen.text(
                [64.0, y + 5.0],
                Anchor::End,
                &format!("10^{{\u{2212}{}}}", -decade),
                small(Role::Ink),
            );
        }
        pen.text(
            [right, 384.0],
            Anchor::End,
            "friction *μ*",
            label(Role::Ink),
        );
        for (power, at, rate) in [(2.0, first.0, first.1), (1.0, first.0, first.2)] {
            let far = 10_f64.powf(MU[1]);
            let end = rate * (far / at).powf(power);
            pen.line(
                &[place(at, rate), place(far, end)],
                stroke(Role::Muted, SECONDARY).dotted(),
            );
        }
        let shown = |value: f64| value > 10_f64.powf(RATE[0]);
        for (role, pick) in [
            (
                Role::Omega,
                (|p: &(f64, f64, f64)| p.1) as fn(&(f64, f64, f64)) -> f64,
            ),
            (Role::AngularMomentum, |p| p.2),
        ] {
            for piece in points.split(|p| !shown(pick(p))) {
                let drawn: Vec<Point> = piece.iter().map(|p| place(p.0, pick(p))).collect();
                pen.line(&drawn, stroke(role, DATA));
                for p in drawn {
                    pen.disc(p, 3.2, role, 1.0);
                }
            }
        }
        let at = place(4.5e-3, 3e-5);
        pen.text(
            [at[0] + 14.0, at[1] + 40.0],
            Anchor::Start,
            "half the difference: slope 2",
            label(Role::Omega),
        );
        let at = place(1.5e-3, 1.4e-4);
        pen.text(
            [at[0], at[1] - 14.0],
            Anchor::Start,
            "mean: slope 1",
            label(Role::AngularMomentum),
        );
    }))
}
