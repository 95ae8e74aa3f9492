//! The rattleback's two reversals.

use spinning_bodies::Result;
use spinning_bodies::scene::contact::passage;

use super::plot::Frame;
use super::{run, stone_scene};
use crate::Figure;
use crate::style::{AXIS, Anchor, DATA, Role, Words, figure, label, number, stroke};

/// It turns back from one sense quickly, from the other slowly.
pub fn reversals() -> Result<Figure> {
    let quick = run(&stone_scene(-5.0)?, 14.0, 1400, 1e-3)?;
    let slow = run(&stone_scene(5.0)?, 14.0, 1400, 1e-3)?;
    let back = [
        passage(&quick, |s| s.spin(), 0.0).unwrap_or(f64::NAN),
        passage(&slow, |s| -s.spin(), 0.0).unwrap_or(f64::NAN),
    ];
    let words = Words {
        claim: "A rattleback spun the wrong way rattles, stops and turns back; spun the right way it takes four times as long about it.".to_owned(),
        details: format!(
            "Spin about the vertical of Kane and Levinson's stone in pure rolling without any loss, released at ±5 rad/s half a degree off level. First reversals \
             at {} s and {} s.",
            number(back[0], 2),
            number(back[1], 2),
        ),
        alt: "Spin against time up to 14 seconds. The curve that starts at minus 5 radians a second trembles, crosses zero before 3 seconds and stays positive for \
              a long time. The one that starts at plus 5 stays for more than ten seconds and then falls through zero."
            .to_owned(),
    };
    Ok(figure("rattleback", 350.0, words, |pen| {
        let frame = Frame {
            sides: [58.0, 572.0, 300.0, 14.0],
            x: [0.0, 14.0],
            y: [-7.0, 7.0],
        };
        frame.axes(
            pen,
            &[
                (0.0, "0"),
                (2.0, "2"),
                (4.0, "4"),
                (6.0, "6"),
                (8.0, "8"),
                (10.0, "10"),
                (12.0, "12"),
                (14.0, "14 s"),
            ],
            &[(-5.0, "−5"), (0.0, "0"), (5.0, "5")],
        );
        frame.names(pen, "time", "spin, rad/s");
        pen.line(
            &[frame.at(0.0, 0.0), frame.at(14.0, 0.0)],
            stroke(Role::Ink, AXIS),
        );
        for (rows, role) in [(&slow, Role::AngularMomentum), (&quick, Role::Omega)] {
            let curve = rows.iter().map(|(t, s)| (*t, s.spin().clamp(-7.0, 7.0)));
            frame.curve(pen, curve, stroke(role, DATA * 0.8));
        }
        pen.text(
            frame.at(1.0, -6.2),
            Anchor::Start,
            "the wrong way",
            label(Role::Omega),
        );
        pen.text(
            frame.at(5.2, 6.0),
            Anchor::Start,
            "the right way",
            label(Role::AngularMomentum),
        );
    })
    .value("wrong", number(back[0], 2))
    .value("right", number(back[1], 2)))
}
