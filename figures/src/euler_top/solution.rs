//! The three components of Ω against time, close to the separatrix (tutorial 6.6).

use spinning_bodies::Result;
use spinning_bodies::euler_top::EulerTop;
use spinning_bodies::euler_top::stability::saddle;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::inertia::PrincipalMoments;

use crate::Figure;
use crate::style::{
    AXIS, Anchor, HAIR, Point, Role, SECONDARY, Words, figure, label, number, small, stroke,
};

const MOMENTS: [f64; 3] = [1.0, 2.0, 3.0];
/// Ω at time zero: next to the middle axis, on the side of the third.
const OMEGA: [f64; 3] = [0.01, 1.0, 0.01];
const STEPS: usize = 400;
/// Left and right end of the time axis, height of zero, units to one rad/s.
const FRAME: [f64; 4] = [52.0, 520.0, 148.0, 78.0];

/// Ω₂ is nearly a square wave, Ω₁ and Ω₃ are pulses.
pub fn solution() -> Result<Figure> {
    let omega = BodyVector::new(OMEGA[0], OMEGA[1], OMEGA[2]);
    let top = EulerTop::from_omega(MOMENTS, omega, Attitude::identity())?;
    let period = top.period();
    let [i1, i2, i3] = MOMENTS;
    let rate = saddle(&PrincipalMoments::new(i1, i2, i3)?, OMEGA[1])?.rate;
    let length = 1.25 * period;
    let [left, right, zero, unit] = FRAME;
    let x = |t: f64| left + (right - left) * t / length;
    let states = top
        .states((0..=STEPS).map(|k| length * k as f64 / STEPS as f64))
        .collect::<Result<Vec<_>>>()?;
    let curve = |k: usize| -> Vec<Point> {
        (0..=STEPS)
            .map(|n| {
                let value = states[n].omega.components()[k];
                [x(length * n as f64 / STEPS as f64), zero - unit * value]
            })
            .collect()
    };
    let words = Words {
        claim:
            "Next to the separatrix the top rests about its middle axis and swings over in between."
                .to_owned(),
        details: format!(
            "Components of $\\Omega$ in the body for $I = (1, 2, 3)$, $\\Omega(0) = ({}, {}, {})$: $\\Omega_2$ goes as sn, $\\Omega_1$ as cn, \
             $\\Omega_3$ as dn. Period {} s; after half of it $\\Omega_1$ and $\\Omega_2$ have changed sign and $\\Omega_3$ has its old value. \
             A swing lasts a few times $1/\\sqrt{{\\lambda}} = {}$ s, however long the rests.",
            OMEGA[0],
            OMEGA[1],
            OMEGA[2],
            number(period, 3),
            number(1.0 / rate, 3),
        ),
        alt: format!(
            "Three curves over one and a quarter periods of {} seconds. The second component of the angular velocity is almost a square wave between \
             plus one and minus one. The first component is a pulse at every jump, up and down in turn; the third a smaller \
             pulse that is always positive. Between the pulses both are nearly zero: the top seems to rotate steadily about \
             its middle axis.",
            number(period, 1),
        ),
    };
    Ok(figure("euler-solution", 300.0, words, |pen| {
        pen.line(&[[left, zero], [right, zero]], stroke(Role::Ink, HAIR));
        pen.line(
            &[[left, zero - unit * 1.25], [left, zero + unit * 1.35]],
            stroke(Role::Ink, AXIS),
        );
        for (value, text) in [(1.0, "1"), (0.0, "0"), (-1.0, "\u{2212}1")] {
            let y = zero - unit * value;
            pen.line(&[[left - 5.0, y], [left, y]], stroke(Role::Ink, AXIS));
            pen.text([left - 9.0, y + 5.0], Anchor::End, text, small(Role::Ink));
        }
        let bottom = zero + unit * 1.35;
        pen.line(&[[left, bottom], [right, bottom]], stroke(Role::Ink, AXIS));
        for (share, text) in [(0.0, "0"), (0.5, "half a period"), (1.0, "a period")] {
            let at = x(share * period);
            pen.line(&[[at, bottom], [at, bottom + 5.0]], stroke(Role::Ink, AXIS));
            if share > 0.0 {
                pen.line(
                    &[[at, zero - unit * 1.25], [at, bottom]],
                    stroke(Role::Muted, AXIS).dotted(),
                );
            }
            let time = if share > 0.0 {
                format!("{} s", number(share * period, 2))
            } else {
                String::new()
            };
            pen.text([at, bottom + 21.0], Anchor::Middle, text, small(Role::Ink));
            pen.text([at, bottom + 38.0], Anchor::Middle, &time, small(Role::Ink));
        }
        let styles = [
            stroke(Role::Omega, SECONDARY).dashed(),
            stroke(Role::Omega, 2.6),
            stroke(Role::Omega, SECONDARY),
        ];
        for (k, style) in styles.into_iter().enumerate() {
            pen.line(&curve(k), style);
        }
        let swing = x(0.25 * period);
        for (at, anchor, text) in [
            ([x(0.0) + 8.0, zero - unit - 8.0], Anchor::Start, "*Ω*_{2}"),
            ([swing - 30.0, zero + unit * 0.85], Anchor::End, "*Ω*_{1}"),
            ([swing + 24.0, zero - unit * 0.42], Anchor::Start, "*Ω*_{3}"),
        ] {
            pen.text(at, anchor, text, label(Role::Omega));
        }
    }))
}
