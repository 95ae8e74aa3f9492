//! The chiral top spun both ways.

use spinning_bodies::Result;
use spinning_bodies::scene::contact::passage;

use super::plot::Frame;
use super::{CHIRAL_SPIN, chiral_scene, run};
use crate::Figure;
use crate::style::{Anchor, DATA, HAIR, Role, Words, figure, label, number, small, stroke};

/// One body, two answers.
pub fn both_spins() -> Result<Figure> {
    let tilt = 3_f64.to_radians();
    let stays = run(&chiral_scene(CHIRAL_SPIN, tilt, 0.0)?, 3.0, 600, 1e-3)?;
    let turns = run(&chiral_scene(-CHIRAL_SPIN, tilt, 0.0)?, 3.0, 600, 1e-3)?;
    let over = |level: f64| passage(&turns, |s| s.tilt().to_degrees(), level).unwrap_or(f64::NAN);
    let most = stays
        .iter()
        .map(|r| r.1.tilt().to_degrees())
        .fold(0.0, f64::max);
    let words = Words {
        claim: "The same top, released the same way: clockwise it turns over, anticlockwise it does not.".to_owned(),
        details: format!(
            "Tilt of the chiral top, a ball of $R = 2$ cm with a skew inertia matrix, released at 3° with 132.9 rad/s about the vertical, $\\mu = 0.3$. \
             Clockwise it is on its side after {} s and ends at {}°. Anticlockwise it stays below {}° for these three seconds.",
            number(over(90.0), 2),
            number(turns[turns.len() - 1].1.tilt().to_degrees(), 0),
            number(most, 1),
        ),
        alt: "Tilt in degrees against time up to 3 seconds. Both curves start at 3 degrees. One swings in growing waves, shoots up at 1.5 seconds and \
              settles near 175 degrees. The other swings to about 10 degrees at first and dies away to 2 degrees."
            .to_owned(),
    };
    Ok(figure("chiral-top", 380.0, words, |pen| {
        let frame = Frame {
            sides: [58.0, 572.0, 328.0, 14.0],
            x: [0.0, 3.0],
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
                (2.5, "2.5"),
                (3.0, "3 s"),
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
            &[frame.at(0.0, 90.0), frame.at(3.0, 90.0)],
            stroke(Role::Muted, HAIR),
        );
        for (rows, role) in [(&turns, Role::Omega), (&stays, Role::AngularMomentum)] {
            let curve = rows.iter().map(|(t, s)| (*t, s.tilt().to_degrees()));
            frame.curve(pen, curve, stroke(role, DATA));
        }
        pen.text(
            frame.at(1.72, 128.0),
            Anchor::Start,
            "clockwise, seen from above",
            label(Role::Omega),
        );
        pen.text(
            frame.at(1.9, 14.0),
            Anchor::Start,
            "anticlockwise",
            label(Role::AngularMomentum),
        );
        pen.text(
            frame.at(0.05, 95.0),
            Anchor::Start,
            "on its side",
            small(Role::Muted),
        );
    })
    .value("side", number(over(90.0), 2))
    .value("most", number(most, 1)))
}
