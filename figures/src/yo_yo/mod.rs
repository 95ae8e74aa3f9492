//! The yo-yo (tutorial 4.9).

mod animated;
mod toy;
mod turn;

use spinning_bodies::scene::effects::{Gravity, TurnLoss};
use spinning_bodies::scene::{Play, Request, Scene};
use spinning_bodies::yo_yo::{Turn, Unwinding};

use crate::prelude::*;
use toy::{AXLE, GRAVITY, LENGTH, MASS, toy};

/// The figures of the chapter, in its order.
pub const FIGURES: &[Entry] = &[
    of("yo-yo-animated", &[], animated::animated),
    of("yo-yo-speed", &[WOUND, CORE, AXLE, LENGTH], speed),
    of("yo-yo-turn", &[AXLE, LENGTH], turn::turn),
    of("yo-yo-string", &[AXLE, LENGTH, LEFT], string),
];

/// Seconds shown.
const SHOWN: f64 = 12.0;

parameters! {
    LEFT: "spin_left", "e", "", "part of the spin that a turn leaves", [0.4, 1.0], 0.9;
    CORE: "thick_axle", "r_1", "mm", "radius of the axle under the thick string", [2.0, 5.0], 4.0;
    WOUND: "wound_to", "r_2", "mm", "radius of the thick string when it is wound up", [5.5, 20.0], 10.0;
}

/// Depth and tension of a released yo-yo, against time.
pub fn string(values: &Values) -> Result<Figure> {
    let [axle, length, left] = values.each([AXLE, LENGTH, LEFT]);
    let toy = toy(values, &AXLE)?;
    let weight = MASS * GRAVITY;
    let way = Unwinding::new(toy, GRAVITY, 0.0)?;
    let turn = Turn::new(toy, GRAVITY, way.omega(length))?;
    let peak = turn.at(0.5 * turn.duration)?.tension / weight;
    let falling = toy.tension(0.0, 0.0, GRAVITY) / weight;
    let play = Play::new(toy, 0.0)?
        .with(Gravity::new(GRAVITY)?)?
        .with(TurnLoss::new(left)?)?;
    let times: Vec<f64> = spaced([0.0, SHOWN], 6000).collect();
    let rows = play.simulate(&Request::at(times)?)?.rows;

    let time = [0.0, SHOWN];
    let depth = Frame::linear(time, [1.1 * length, 0.0], [66.0, 580.0, 176.0, 36.0]);
    let pull = Frame::linear(time, [0.0, 1.28 * peak], [66.0, 580.0, 374.0, 226.0]);
    let mut place: Vec<Point> = Vec::new();
    let mut tension: Vec<Point> = Vec::new();
    let mut kept: Vec<[f64; 3]> = Vec::new();
    for (t, state) in &rows {
        let at = depth.at(*t, state.depth);
        if place.last().is_none_or(|p| at[0] - p[0] >= 1.0) {
            place.push(at);
        }
        let at = pull.at(*t, state.tension / weight);
        let far = |p: &Point| at[0] - p[0] >= 1.0 || (at[1] - p[1]).abs() >= 0.5;
        if tension.last().is_none_or(far) {
            tension.push(at);
            kept.push([*t, state.depth, state.tension]);
        }
    }
    let milliseconds = 1e3 * turn.duration;
    let [weights, mean] = [0, 1].map(|digits| number(turn.mean_tension / weight, digits));
    let [long, thick, leaves] = briefs([length, axle, left]);
    let (rise, leaves) = match left < 1.0 {
        true => ("less high every time", format!("${leaves}$")),
        false => ("all the way up every time", "all".to_owned()),
    };
    let words = words!(
        "On the way down and on the way up the string pulls a little less than the weight; in the turn, for {milliseconds:.0} milliseconds, as hard as {weights} yo-yos.",
        "A yo-yo of 55 g and radius 29 mm on {long} m of string round an axle of radius {thick} mm, let go. Pull while it winds: ${falling:.3}\\,Mg$. First turn: {milliseconds:.1} ms, mean \
         pull ${mean}\\,Mg$, peak ${peak:.1}\\,Mg$. Every turn leaves {leaves} of the spin.",
        "Two diagrams over {SHOWN} seconds. Above, the depth: arcs of parabolas that meet in sharp points at {long} m, and rise {rise}. \
         Below, the pull of the string: flat just under one weight, with a needle at each of the sharp points, the first {peak:.0} \
         weights high."
    );
    let first = way.duration()? + 0.5 * turn.duration;
    let made = figure("yo-yo-string", 420.0, words, |pen| {
        let seconds = marks(&[0.0, 3.0, 6.0, 9.0, 12.0], "");
        let mut weights = pull.y.ticks(45.0);
        weights[0] = (1.0, "1".to_owned());
        depth.draw(pen, &[], &depth.y.ticks(45.0), ["", "depth, m"]);
        pull.draw(pen, &seconds, &weights, ["time, s", "pull, weights"]);
        pen.line(&place, inked(DATA));
        pen.line(&tension, inked(DATA));
        let [px, py] = pull.at(first, peak);
        let text = format!("the turn: {milliseconds:.0} ms");
        pen.label([px - 4.0, py - 8.0], Start, &text);
    });
    Ok(made.data("yo-yo", "time (s) | depth (m) | pull (N)", kept))
}

/// Speed against depth for a thin and a thick string.
pub fn speed(values: &Values) -> Result<Figure> {
    let (thin, thick) = (toy(values, &AXLE)?, toy(values, &CORE)?);
    let thick = thick.wound_to(values.of(&WOUND) / 1e3)?;
    let length = values.of(&LENGTH);
    let thin = Unwinding::new(thin, GRAVITY, 0.0)?;
    let thick = Unwinding::new(thick, GRAVITY, 0.0)?;
    let depths = || spaced([0.0, length], 400);
    let fastest = spaced([0.0, length], 4000)
        .max_by(|&a, &b| thick.speed(a).total_cmp(&thick.speed(b)))
        .unwrap_or(0.0);
    let peak = thick.speed(fastest);
    let most = 1.12 * peak.max(thin.speed(length));
    let frame = Frame::linear([0.0, length], [0.0, most], [66.0, 570.0, 296.0, 40.0]);
    let curves = [&thin, &thick].map(|way| frame.trace(depths().map(|x| [x, way.speed(x)])));
    let claim = match fastest / length {
        share if share < 0.9 => "On a thick string the yo-yo is fastest well before the end.",
        share if share < 1.0 => "On a thick string the yo-yo is fastest shortly before the end.",
        _ => "This string is too thin: the yo-yo is fastest at its end, as on any thin string.",
    };
    let [axle, wound, core, long] = briefs(values.each([AXLE, WOUND, CORE, LENGTH]));
    let last = number(thick.speed(length), 3);
    let [spin, whirl] = numbers([&thin, &thick].map(|way| way.omega(length)), 0);
    let [end, after, later] = numbers([thin.speed(length), thin.duration()?, thick.duration()?], 4);
    let off = match fastest < length {
        true => "; then it falls off: near the end nearly all the energy is in the spin",
        false => ", its end",
    };
    let words = words!(
        "{claim}",
        "Speed on the way down. Thin string: axle of radius {axle} mm, {end} m/s and {spin} rad/s after {long} m, in {after} s. Thick string, wound up to {wound} mm on an axle of {core} mm: \
         fastest with {peak:.4} m/s at {fastest:.3} m, {last} m/s at the end with {whirl} rad/s, in {later} s.",
        "Speed against depth. The curve of the thin string is a parabola on its side that rises to the end. The curve of the thick string \
         is highest at {fastest:.2} m{off}."
    );
    let made = figure("yo-yo-speed", 344.0, words, |pen| {
        frame.draw_round(pen, ["depth, m", "speed, m/s"]);
        pen.line(&curves[0], inked(SECONDARY).dashed());
        pen.line(&curves[1], inked(DATA));
        let top = frame.at(fastest, peak);
        pen.dot(top, 4.0);
        let mut beside = |curve: &[Point], text: &str, lettering, half: f64| {
            let sides = [[half + 8.0, 16.0], [-half - 8.0, -16.0], [0.0, -18.0]];
            let places = curve.iter().skip(60).step_by(4);
            let places = places.flat_map(|p| sides.map(|side| shifted(*p, side)));
            let inside = within([72.0 + half, 590.0 - half], [30.0, 280.0]);
            pen.name(places.filter(inside), text, lettering);
        };
        beside(&[top; 61], "fastest", small(Ink), 24.0);
        beside(&curves[1], "thick string", label(Ink), 45.0);
        beside(&curves[0], "thin string", label(Ink), 42.0);
    });
    let columns = "depth (m) | speed (m/s) | angular velocity (rad/s)";
    let rows = |way: Unwinding| depths().map(move |x| [x, way.speed(x), way.omega(x)]);
    Ok(made
        .data("thin string", columns, rows(thin))
        .data("thick string", columns, rows(thick)))
}
