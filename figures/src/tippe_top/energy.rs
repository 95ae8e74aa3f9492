//! The tippe top raises its centre of mass while its energy falls.

use spinning_bodies::Result;
use spinning_bodies::scene::contact::passage;

use super::plot::Frame;
use super::{run, tippe_scene};
use crate::Figure;
use crate::style::{Anchor, DATA, HAIR, Role, Words, figure, label, number, small, stroke};

/// The centre of mass climbs, and the spin pays for it several times over.
pub fn height_and_energy() -> Result<Figure> {
    let rows = run(&tippe_scene(155.0)?, 8.0, 400, 1e-3)?;
    let (first, last) = (rows[0].1, rows[rows.len() - 1].1);
    let half = passage(&rows, |s| s.tilt().to_degrees(), 90.0).unwrap_or(f64::NAN);
    let weight = 0.02 * super::G_TIPPE;
    let gain = weight * (last.position.z() - first.position.z());
    let words = Words {
        claim: "While the top climbs, its energy falls: the spin pays the climb, and friction takes ten times as much.".to_owned(),
        details: format!(
            "Tippe top of 20 g, $R = 2$ cm, $\\alpha = 0.3$, spun at 155 rad/s about its axis, viscous friction 0.3 s/m. $C$ rises from {} to {} mm, \
             half of it at {} s; that costs {} mJ. The energy falls from {} to {} mJ, at no instant rising.",
            number(1e3 * first.position.z(), 2),
            number(1e3 * last.position.z(), 2),
            number(half, 2),
            number(1e3 * gain, 2),
            number(1e3 * first.energy, 2),
            number(1e3 * last.energy, 2),
        ),
        alt: "Two curves against time from 0 to 8 seconds. The upper one, total energy, stays level at 41 millijoules for about four seconds, then \
              falls steeply to 16 and stays. The lower one, the potential energy, rises in the same two seconds from 3 to 5 millijoules. The gap \
              between the curves is the kinetic energy."
            .to_owned(),
    };
    Ok(figure("tippe-energy", 372.0, words, |pen| {
        let frame = Frame {
            sides: [62.0, 486.0, 320.0, 16.0],
            x: [0.0, 8.0],
            y: [0.0, 45.0],
        };
        frame.axes(
            pen,
            &[(0.0, "0"), (2.0, "2"), (4.0, "4"), (6.0, "6"), (8.0, "8 s")],
            &[
                (0.0, "0"),
                (10.0, "10"),
                (20.0, "20"),
                (30.0, "30"),
                (40.0, "40 mJ"),
            ],
        );
        frame.names(pen, "time", "");
        let height = |s: &spinning_bodies::scene::contact::State| 1e3 * weight * s.position.z();
        let mut gap: Vec<_> = rows
            .iter()
            .map(|(t, s)| frame.at(*t, 1e3 * s.energy))
            .collect();
        gap.extend(rows.iter().rev().map(|(t, s)| frame.at(*t, height(s))));
        pen.fill(&gap, Role::Omega, 0.1);
        frame.curve(
            pen,
            rows.iter().map(|(t, s)| (*t, 1e3 * s.energy)),
            stroke(Role::Ink, DATA),
        );
        frame.curve(
            pen,
            rows.iter().map(|(t, s)| (*t, height(s))),
            stroke(Role::AngularMomentum, DATA),
        );
        pen.line(
            &[frame.at(half, 0.0), frame.at(half, 44.0)],
            stroke(Role::Muted, HAIR).dotted(),
        );
        pen.text(
            frame.at(half + 0.08, 42.0),
            Anchor::Start,
            "on its side",
            small(Role::Muted),
        );
        let right = frame.sides[1] + 8.0;
        let end = |y: f64| frame.at(0.0, y)[1];
        pen.text(
            [right, end(1e3 * last.energy) + 5.0],
            Anchor::Start,
            "energy",
            label(Role::Ink),
        );
        pen.text(
            [right, end(height(&last)) + 1.0],
            Anchor::Start,
            "*Mg* × height",
            label(Role::AngularMomentum),
        );
        pen.text(
            [right, end(height(&last)) + 18.0],
            Anchor::Start,
            "of *C*",
            label(Role::AngularMomentum),
        );
        pen.text(
            frame.at(2.2, 21.0),
            Anchor::Middle,
            "in the motion",
            label(Role::Omega),
        );
    })
    .value("climb", number(1e3 * gain, 2))
    .value("before", number(1e3 * first.energy, 2))
    .value("after", number(1e3 * last.energy, 2)))
}
