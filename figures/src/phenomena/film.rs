//! The falling cat in eight pictures, and how far back it must bend (tutorial 1.1).

use spinning_bodies::Result;
use spinning_bodies::phenomena::cat::EqualHalves;

use super::body::{DURATION, FORWARD, RATIO, back, cat, draw, pieces, turned, turnover};
use crate::Figure;
use crate::solid::View;
use crate::style::{
    AXIS, Anchor, DATA, HAIR, Point, Role, SECONDARY, Words, figure, label, number, small, stroke,
};

const FRAMES: usize = 8;
const SCALE: f64 = 186.0;
/// From where the cat is seen.
pub const AZIMUTH: f64 = -1.92;
pub const ELEVATION: f64 = 0.16;

/// On its back, bent, carried round, and on its feet.
pub fn cat_film() -> Result<Figure> {
    let fractions: [f64; FRAMES] = [0.0, 0.2, 0.36, 0.45, 0.53, 0.63, 0.8, 1.0];
    let states = turnover(&fractions)?;
    let back_bend = back()?;
    let turn = turned(&states[FRAMES - 1]).to_degrees();
    let words = Words {
        claim: "A cat turns over although its angular momentum is zero in every picture.".to_owned(),
        details: format!(
            "Two cylinders with $I/J = {}$, the bend carried once round: {}° forward, {}° backward half-way. Eight moments of {} s; \
             the whole turn is {}°. Head, legs and tail are drawn on and weigh nothing.",
            number(RATIO, 0),
            number(FORWARD.to_degrees(), 0),
            number(back_bend.to_degrees(), 2),
            number(DURATION, 1),
            number(turn, 4),
        ),
        alt: "Eight pictures of a cat made of two round halves with a head, four legs and a tail. It lies on its back, bends its belly \
              together, lets the bend go round its spine, first to one side, then a little backward, then to the other side, \
              straightens, and stands on its feet."
            .to_owned(),
    };
    let body = cat()?;
    Ok(figure("cat-film", 360.0, words, |pen| {
        for (k, state) in states.iter().enumerate() {
            let (column, row) = ((k % 4) as f64, (k / 4) as f64);
            let center = [72.0 + 148.0 * column, 92.0 + 176.0 * row];
            let view = View::new(AZIMUTH, ELEVATION, center, SCALE);
            draw(pen, &pieces(&body, state, &view, SCALE));
            let milliseconds = number(1000.0 * fractions[k] * DURATION, 0);
            pen.text(
                [center[0], center[1] + 80.0],
                Anchor::Middle,
                &format!("{milliseconds} ms"),
                small(Role::Muted),
            );
        }
    }))
}

const LEFT: f64 = 70.0;
const RIGHT: f64 = 560.0;
const BOTTOM: f64 = 330.0;
const TOP: f64 = 40.0;

/// Back bend to the right, turn upward.
fn place(back: f64, turn: f64) -> Point {
    [
        LEFT + (RIGHT - LEFT) * back / 90.0,
        BOTTOM - (BOTTOM - TOP) * (turn - 60.0) / 180.0,
    ]
}

/// The turn against the back bend, for five bends forward.
pub fn back_bend() -> Result<Figure> {
    let equal = EqualHalves::new(1.0, RATIO)?;
    let forwards = [60.0_f64, 75.0, 90.0, 105.0, 120.0];
    let mut curves = Vec::new();
    for forward in forwards {
        let turn = |back: f64| -> Result<f64> {
            let turn = equal.turn_of_uneven_swing(forward.to_radians(), back.to_radians())?;
            Ok(turn.to_degrees())
        };
        let points = (0..=120)
            .map(|k| {
                let back = forward.min(90.0) * f64::from(k) / 120.0;
                Ok(place(back, turn(back)?))
            })
            .filter(|p| p.as_ref().is_ok_and(|p| p[1] > TOP))
            .collect::<Result<Vec<_>>>()?;
        let needed = equal.back_bend_for_half_turn(forward.to_radians())?;
        curves.push((forward, points, needed.map(f64::to_degrees)));
    }
    let needed = |k: usize| number(curves[k].2.unwrap_or(f64::NAN), 2);
    let words = Words {
        claim: "The more a cat bends forward, the less it must bend backward.".to_owned(),
        details: format!(
            "Turn of two cylinders with $I/J = {}$ when the bend swings once round, from $\\gamma$ forward to the back bend half-way. \
             Half a turn takes {}° back after {}° forward, {}° after {}°, {}° after {}°.",
            number(RATIO, 0),
            needed(1),
            number(curves[1].0, 0),
            needed(2),
            number(curves[2].0, 0),
            needed(4),
            number(curves[4].0, 0),
        ),
        alt: "Five rising curves of the turn against the bend backward, for 60, 75, 90, 105 and 120 degrees forward. A level line at half a \
              turn cuts each of them, further to the left the more the cat bends forward."
            .to_owned(),
    };
    Ok(figure("back-bend", 390.0, words, |pen| {
        let axis = stroke(Role::Ink, AXIS);
        pen.line(&[[LEFT, TOP], [LEFT, BOTTOM], [RIGHT, BOTTOM]], axis);
        for back in [0.0, 30.0, 60.0, 90.0] {
            let [x, y] = place(back, 60.0);
            pen.line(&[[x, y], [x, y + 5.0]], axis);
            pen.text(
                [x, y + 22.0],
                Anchor::Middle,
                &format!("{}°", number(back, 0)),
                small(Role::Ink),
            );
        }
        for turn in [60.0, 120.0, 180.0, 240.0] {
            let [x, y] = place(0.0, turn);
            pen.line(&[[x - 5.0, y], [x, y]], axis);
            pen.text(
                [x - 9.0, y + 5.0],
                Anchor::End,
                &format!("{}°", number(turn, 0)),
                small(Role::Ink),
            );
        }
        let [x, y] = place(90.0, 180.0);
        pen.line(
            &[place(0.0, 180.0), [x, y]],
            stroke(Role::Ink, SECONDARY).dashed(),
        );
        pen.text([x, y - 7.0], Anchor::End, "on its feet", label(Role::Ink));
        pen.text(
            [RIGHT, BOTTOM + 46.0],
            Anchor::End,
            "bend backward",
            label(Role::Ink),
        );
        pen.text(
            [LEFT - 40.0, TOP - 14.0],
            Anchor::Start,
            "turn",
            label(Role::Ink),
        );
        for (forward, points, needed) in &curves {
            pen.line(points, stroke(Role::Ink, DATA));
            let [x, y] = points.last().copied().unwrap_or([LEFT, BOTTOM]);
            let name = number(*forward, 0);
            if y < TOP + 2.0 {
                pen.text(
                    [x, y - 8.0],
                    Anchor::Middle,
                    &format!("{name}°"),
                    small(Role::Ink),
                );
            } else {
                // Under the level line where the curve ends on it.
                let below = if (y - place(0.0, 180.0)[1]).abs() < 12.0 {
                    20.0
                } else {
                    5.0
                };
                pen.text(
                    [x + 7.0, y + below],
                    Anchor::Start,
                    &format!("{name}°"),
                    small(Role::Ink),
                );
            }
            if let Some(needed) = needed {
                let [x, y] = place(*needed, 180.0);
                pen.disc([x, y], 3.6, Role::Ink, 1.0);
                pen.line(&[[x, y], [x, BOTTOM]], stroke(Role::Ink, HAIR).dotted());
            }
        }
    })
    .value("after-90", needed(2))
    .value("after-120", needed(4)))
}
