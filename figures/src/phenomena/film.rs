//! The falling cat in eight pictures, and how far back it must bend (tutorial 1.1).

use spinning_bodies::phenomena::EqualHalves;

use super::body::{DURATION, FORWARD, RATIO, back, cat, draw, pieces, turned, turnover};
use crate::prelude::*;

parameters! {
    HALVES: "ratio", "I/J", "", "moment of a half across its spine over that about it", [1.5, 12.0], RATIO, logarithmic;
    MOST: "most", r"\gamma", "°", "greatest bend forward", [75.0, 135.0], 120.0;
}

/// The parameters of the bends.
pub const BACK_BEND: &[Parameter] = &[HALVES, MOST];

const FRAMES: usize = 8;
const SCALE: f64 = 186.0;
/// The view of the cat.
pub const AZIMUTH: f64 = -1.92;
pub const ELEVATION: f64 = 0.16;

/// On its back, bent, carried round, and on its feet: eight moments of one cat, chosen by hand.
pub fn cat_film(_: &Values) -> Result<Figure> {
    let fractions: [f64; FRAMES] = [0.0, 0.2, 0.36, 0.45, 0.53, 0.63, 0.8, 1.0];
    let states = turnover(&fractions)?;
    let back_bend = back()?;
    let turn = turned(&states[FRAMES - 1]).to_degrees();
    let forward = number(FORWARD.to_degrees(), 0);
    let (backward, whole) = (number(back_bend.to_degrees(), 2), short(turn, 4));
    let words = words!(
        "A cat turns over although its angular momentum is zero in every picture.",
        "Two cylinders with $I/J = {RATIO:.0}$, the bend carried once round: {forward}° forward, {backward}° backward half-way. Eight instants in {DURATION:.1} s; the whole turn \
         is {whole}°. Head, legs and tail are drawn on and weigh nothing.",
        "Eight pictures of a cat made of two round halves with a head, four legs and a tail. It lies on its back, bends its belly \
         together, lets the bend go round its spine, first to one side, then a little backward, then to the other side, \
         straightens, and stands on its feet."
    );
    let body = cat()?;
    Ok(figure("cat-film", 360.0, words, |pen| {
        for (k, state) in states.iter().enumerate() {
            let (column, row) = ((k % 4) as f64, (k / 4) as f64);
            let center = [72.0 + 148.0 * column, 92.0 + 176.0 * row];
            let view = View::new(AZIMUTH, ELEVATION, center, SCALE);
            draw(pen, &pieces(&body, state, &view));
            let milliseconds = number(1000.0 * fractions[k] * DURATION, 0);
            let spot = shifted(center, [0.0, 80.0]);
            pen.remark(spot, Middle, &format!("{milliseconds} ms"));
        }
    }))
}

const LEFT: f64 = 70.0;
const RIGHT: f64 = 552.0;
const BOTTOM: f64 = 326.0;
const TOP: f64 = 40.0;

/// The turn against the back bend, for five bends forward.
pub fn back_bend(values: &Values) -> Result<Figure> {
    let [ratio, most] = values.each([HALVES, MOST]);
    let equal = EqualHalves::new(1.0, ratio)?;
    let forwards = [0.5, 0.625, 0.75, 0.875, 1.0].map(|share| share * most);
    let mut curves = Vec::new();
    for forward in forwards {
        let ahead = forward.to_radians();
        let points = tried(spaced([0.0, forward.min(90.0)], 120), |back| {
            let turn = equal.turn_of_uneven_swing(ahead, back.to_radians())?;
            Ok([back, turn.to_degrees()])
        })?;
        let needed = equal.back_bend_for_half_turn(ahead)?;
        // No further back than it is drawn.
        let needed = needed.map(f64::to_degrees);
        let needed = needed.filter(|back| *back <= forward.min(90.0));
        curves.push((forward, points, needed));
    }
    let low = (curves[0].1[0][1] / 30.0).floor() * 30.0;
    let frame = Frame::linear([0.0, 90.0], [low, 240.0], [LEFT, RIGHT, BOTTOM, TOP]);
    let needed = |k: usize| curves[k].2.map(|back| number(back, 2));
    let name = brief;
    let told = |k: usize| {
        let (back, forward) = (needed(k)?, name(curves[k].0));
        Some(format!("{back}° back after {forward}° forward"))
    };
    let chosen = [usize::from(curves[1].2.is_some()), 2, 4];
    let listed: Vec<String> = chosen.into_iter().filter_map(told).collect();
    let half_turns = match listed.is_empty() {
        true => "None of these bends makes it half a turn".to_owned(),
        false => format!("Half a turn takes {}", listed.join(", ")),
    };
    let names: Vec<String> = forwards.iter().map(|forward| name(*forward)).collect();
    let (shape, names) = (brief(ratio), names.join(", "));
    let cut = curves.iter().filter(|curve| curve.2.is_some()).count();
    let words = words!(
        "The more a cat bends forward, the less it must bend backward.",
        "Turn of two cylinders with $I/J = {shape}$ when the bend swings once round, from $\\gamma$ forward to the back bend half-way. \
         {half_turns}.",
        "Five rising curves of the turn against the bend backward, for {names} degrees forward. A level line at half a \
         turn cuts {cut} of them."
    );
    let made = figure("back-bend", 384.0, words, |pen| {
        let mut turns = marks(&[0.0, 60.0, 120.0, 180.0, 240.0], "°");
        turns.retain(|(turn, _)| *turn >= low);
        let bends = marks(&[0.0, 30.0, 60.0, 90.0], "°");
        frame.draw(pen, &bends, &turns, ["bend backward", "turn"]);
        let level = frame.y.at(180.0);
        pen.line([[LEFT, level], [RIGHT, level]], inked(SECONDARY).dashed());
        let shown = |(_, points, _): &(f64, Vec<Point>, Option<f64>)| -> Vec<Point> {
            let inside = points.iter().filter(|point| point[1] <= 240.0);
            frame.trace(inside.copied())
        };
        let shown: Vec<Vec<Point>> = curves.iter().map(shown).collect();
        pen.lines(&shown, inked(DATA));
        for needed in curves.iter().filter_map(|(_, _, needed)| *needed) {
            let [x, y] = frame.at(needed, 180.0);
            pen.dot([x, y], 3.6);
            pen.line([[x, y], [x, BOTTOM]], inked(HAIR).dotted());
        }
        let mut write = |places: Vec<Point>, text: &str| {
            let half = 3.6 * text.chars().count() as f64;
            let inside = within([LEFT + half, 596.0 - half], [12.0, 384.0]);
            pen.name(places.into_iter().filter(inside), text, small(Ink));
        };
        for ((forward, _, _), points) in curves.iter().zip(&shown).rev() {
            let end = points.last().copied().unwrap_or([LEFT, BOTTOM]);
            let turns = [90.0_f64, 0.0, -40.0, 40.0, 145.0, 180.0, -90.0];
            let around = [1.0, 1.5, 2.2, 3.0].into_iter().flat_map(|far| {
                let turned = turns.map(|turn| turn.to_radians().sin_cos());
                turned.map(|(up, right)| shifted(end, [25.0 * far * right, -14.0 * far * up]))
            });
            let around = around.collect();
            let gamma = if *forward == forwards[0] {
                "*γ* = "
            } else {
                ""
            };
            write(around, &format!("{gamma}{}°", name(*forward)));
        }
        let beside = (0..40).map(|k| RIGHT - 40.0 - 10.0 * f64::from(k));
        let beside = beside.flat_map(|x| [-12.0, 14.0].map(|dy| [x, level + dy]));
        write(beside.collect(), "on its feet");
    });
    let mut made = made
        .value("after-90", needed(2).unwrap_or_default())
        .value("after-120", needed(4).unwrap_or_default());
    for (forward, points, _) in &curves {
        let columns = "bend backward (°) | turn (°)";
        let curve = format!("{}° forward", name(*forward));
        made = made.data(curve, columns, points.clone());
    }
    Ok(made)
}
