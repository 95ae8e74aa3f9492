//! The effective potential of the tippe top, deformed by spin.

use core::f64::consts::PI;

use spinning_bodies::Result;

use super::plot::Frame;
use super::{G_TIPPE, tippe};
use crate::Figure;
use crate::style::{Anchor, DATA, Role, Words, figure, label, number, small, stroke};

/// Spins of the curves, rad/s.
const SPINS: [f64; 5] = [20.0, 40.0, 50.0, 65.0, 90.0];

/// Spin moves the lowest place from the foot of the ball to its head.
pub fn effective_potential() -> Result<Figure> {
    let top = tippe()?;
    let unit = 0.02 * G_TIPPE * 0.02;
    let lambda = |spin: f64| top.jellett_of_spin(spin, 0.0);
    let (rise, invert) = (
        top.least_spin_to_rise().unwrap_or(f64::NAN),
        top.least_spin_to_invert().unwrap_or(f64::NAN),
    );
    let tilts = SPINS.map(|spin| top.final_tilt(lambda(spin), 1e-3).map(f64::to_degrees));
    let [_, b, c, d, _] = tilts;
    let (b, c, d) = (b?, c?, d?);
    let words = Words {
        claim: "Spin moves the lowest place from upright to upside down, and friction brings the top there.".to_owned(),
        details: format!(
            "Effective potential $V(\\theta)$ of the tippe top less $V(0)$, over $MgR$, for five spins about the upright axis in rad/s, each \
             with its Jellett integral. Discs: the minima where a top ends, at 0°, {}°, {}°, {}° and 180°. Upright is lost at {} rad/s, the \
             head is reached from {} rad/s on.",
            number(b, 1),
            number(c, 1),
            number(d, 1),
            number(rise, 2),
            number(invert, 2),
        ),
        alt: "Five curves over the tilt from 0 to 180 degrees, all from the same point at 0. The slowest rises all the way. The next three sink, \
              have a minimum further and further to the right, and rise again. The fastest falls all the way to 180 degrees. A disc \
              marks each minimum."
            .to_owned(),
    };
    Ok(figure("tippe-potential", 392.0, words, |pen| {
        let frame = Frame {
            sides: [58.0, 520.0, 340.0, 14.0],
            x: [0.0, 180.0],
            y: [-1.8, 0.6],
        };
        frame.axes(
            pen,
            &[
                (0.0, "0°"),
                (45.0, "45°"),
                (90.0, "90°"),
                (135.0, "135°"),
                (180.0, "180°"),
            ],
            &[
                (-1.5, "−1.5"),
                (-1.0, "−1"),
                (-0.5, "−0.5"),
                (0.0, "0"),
                (0.5, "0.5"),
            ],
        );
        frame.names(pen, "tilt *θ*", "(*V* − *V* (0))/*MgR*");
        for spin in SPINS {
            let jellett = lambda(spin);
            let height = |tilt: f64| {
                (top.effective_potential(tilt, jellett) - top.effective_potential(0.0, jellett))
                    / unit
            };
            let curve = (0..=180).map(|k| (f64::from(k), height(PI * f64::from(k) / 180.0)));
            frame.curve(pen, curve, stroke(Role::Ink, DATA).alpha(0.85));
            let tilt = top.final_tilt(jellett, 1e-3).unwrap_or(0.0);
            pen.disc(
                frame.at(tilt.to_degrees(), height(tilt)),
                5.0,
                Role::AngularMomentum,
                1.0,
            );
            let visible = (0..=180)
                .rev()
                .find(|k| height(PI * f64::from(*k) / 180.0) >= -1.8);
            let at = f64::from(visible.unwrap_or(180));
            let [x, y] = frame.at(at, height(PI * at / 180.0));
            let text = format!("{} rad/s", number(spin, 0));
            if at < 179.0 {
                pen.text([x + 8.0, y - 4.0], Anchor::Start, &text, small(Role::Ink));
            } else {
                pen.text([x + 9.0, y + 5.0], Anchor::Start, &text, small(Role::Ink));
            }
        }
        pen.text(frame.at(64.0, -0.06), Anchor::End, "", label(Role::Ink));
    }))
}
