//! The yo-yo (tutorial 4.9).

mod animated;

use spinning_bodies::Result;
use spinning_bodies::scene::effects::{Gravity, TurnLoss};
use spinning_bodies::scene::yo_yo::Play;
use spinning_bodies::scene::{Request, Scene};
use spinning_bodies::yo_yo::{Turn, Unwinding, YoYo};

pub use animated::animated;

use crate::Figure;
use crate::plot::{Axis, Frame};
use crate::style::{
    Anchor, DATA, Point, Role, SECONDARY, Words, figure, label, number, small, stroke,
};

const GRAVITY: f64 = 9.81;
/// Spin left by a turn.
const RESTITUTION: f64 = 0.9;
/// Seconds shown.
const SHOWN: f64 = 12.0;

/// The toy of the chapter: 55 g, radius 29 mm, a metre of string.
fn toy() -> Result<YoYo> {
    YoYo::disc(0.055, 0.029, 1.0, 0.005)
}

/// Depth and tension of a yo-yo let go, against time.
pub fn string() -> Result<Figure> {
    let toy = toy()?;
    let weight = toy.mass() * GRAVITY;
    let play = Play::new(toy, 0.0)?
        .with(Gravity::new(GRAVITY)?)?
        .with(TurnLoss::new(RESTITUTION)?)?;
    let times: Vec<f64> = (0..=12_000)
        .map(|k| SHOWN * f64::from(k) / 12_000.0)
        .collect();
    let rows = play.simulate(&Request::at(times)?)?.rows;
    let way = Unwinding::new(toy, GRAVITY, 0.0)?;
    let turn = Turn::new(toy, GRAVITY, way.omega(toy.length()))?;
    let peak = turn.at(0.5 * turn.duration())?.tension / weight;
    let falling = toy.tension(0.0, 0.0, GRAVITY) / weight;

    let x = Axis::linear([0.0, SHOWN], [66.0, 580.0]);
    let depth = Frame {
        x,
        y: Axis::linear([1.1, 0.0], [190.0, 40.0]),
    };
    let pull = Frame {
        x,
        y: Axis::linear([0.0, 25.0], [390.0, 250.0]),
    };
    let mut place: Vec<Point> = Vec::new();
    let mut tension: Vec<Point> = Vec::new();
    for (t, state) in &rows {
        let point = depth.at(*t, state.depth);
        if place.last().is_none_or(|p| point[0] - p[0] >= 1.0) {
            place.push(point);
        }
        let point = pull.at(*t, state.tension / weight);
        let far = |p: &Point| point[0] - p[0] >= 1.0 || (point[1] - p[1]).abs() >= 0.5;
        if tension.last().is_none_or(far) {
            tension.push(point);
        }
    }
    let words = Words {
        claim: "On the way down and on the way up the string pulls a little less than the weight; in the turn, for fifteen milliseconds, as hard as fifteen yo-yos."
            .to_owned(),
        details: format!(
            "A yo-yo of 55 g and radius 29 mm on a metre of string round an axle of 5 mm, let go. Pull while it winds: ${} mg$. First turn: {} ms, mean \
             pull ${} mg$, peak ${} mg$. Every turn leaves ${RESTITUTION}$ of the spin.",
            number(falling, 3),
            number(1e3 * turn.duration(), 1),
            number(turn.mean_tension() / weight, 1),
            number(peak, 1),
        ),
        alt: format!(
            "Two diagrams over twelve seconds. Above, the depth: arcs of parabolas that meet in sharp points at one metre, and rise less high \
             every time. Below, the pull of the string: flat just under one weight, with a needle at each of the sharp points, the first {} \
             weights high.",
            number(peak, 0)
        ),
    };
    Ok(figure("yo-yo-string", 440.0, words, |pen| {
        let seconds = [(0.0, "0"), (3.0, "3"), (6.0, "6"), (9.0, "9"), (12.0, "12")];
        depth.draw(
            pen,
            &[],
            &[(0.0, "0"), (0.5, "0.5"), (1.0, "1")],
            ["", "depth, m"],
        );
        pull.draw(
            pen,
            &seconds,
            &[(1.0, "1"), (10.0, "10"), (20.0, "20")],
            ["time, s", "pull, weights"],
        );
        pen.line(&place, stroke(Role::Ink, DATA));
        pen.line(&tension, stroke(Role::Torque, DATA));
        let [px, py] = pull.at(rows[1906].0, peak);
        pen.text(
            [px + 10.0, py + 6.0],
            Anchor::Start,
            "the turn: 15 ms",
            label(Role::Torque),
        );
    }))
}

/// Speed against depth for a thin and a thick string.
pub fn speed() -> Result<Figure> {
    let thin = toy()?;
    let thick = YoYo::disc(0.055, 0.029, 1.0, 0.004)?.wound_to(0.010)?;
    let ways = [thin, thick].map(|toy| Unwinding::new(toy, GRAVITY, 0.0));
    let [thin, thick] = ways;
    let (thin, thick) = (thin?, thick?);
    let depths = || (0..=400).map(|k| f64::from(k) / 400.0);
    let fastest = (0..=10_000)
        .map(|k| f64::from(k) / 10_000.0)
        .max_by(|&a, &b| thick.speed(a).total_cmp(&thick.speed(b)))
        .unwrap_or(0.0);
    let frame = Frame {
        x: Axis::linear([0.0, 1.0], [66.0, 570.0]),
        y: Axis::linear([0.0, 1.25], [310.0, 44.0]),
    };
    let curve =
        |way: &Unwinding| -> Vec<Point> { depths().map(|x| frame.at(x, way.speed(x))).collect() };
    let (curves, peak) = ([curve(&thin), curve(&thick)], thick.speed(fastest));
    let words = Words {
        claim: "On a thick string the yo-yo is fastest well before the end.".to_owned(),
        details: format!(
            "Speed on the way down. Thin string: axle of 5 mm, {} m/s and {} rad/s after a metre, in {} s. Thick string, wound up to 10 mm on an axle of 4 mm: \
             fastest with {} m/s at {} m, {} m/s at the end with {} rad/s, in {} s.",
            number(thin.speed(1.0), 4),
            number(thin.omega(1.0), 0),
            number(thin.duration()?, 4),
            number(peak, 4),
            number(fastest, 3),
            number(thick.speed(1.0), 3),
            number(thick.omega(1.0), 0),
            number(thick.duration()?, 4),
        ),
        alt: format!(
            "Speed against depth. The curve of the thin string is a parabola on its side that rises to the end. The curve of the thick string \
             starts steeper, has its maximum at {} metres, and falls off: near the end nearly all the energy is in the spin.",
            number(fastest, 2)
        ),
    };
    Ok(figure("yo-yo-speed", 360.0, words, |pen| {
        frame.draw(
            pen,
            &[
                (0.0, "0"),
                (0.25, "0.25"),
                (0.5, "0.5"),
                (0.75, "0.75"),
                (1.0, "1"),
            ],
            &[(0.0, "0"), (0.5, "0.5"), (1.0, "1")],
            ["depth, m", "speed, m/s"],
        );
        pen.line(&curves[0], stroke(Role::Ink, SECONDARY));
        pen.line(&curves[1], stroke(Role::Omega, DATA));
        let [x, y] = frame.at(fastest, peak);
        pen.disc([x, y], 4.0, Role::Omega, 1.0);
        pen.text([x, y - 12.0], Anchor::Middle, "fastest", small(Role::Omega));
        let [x, y] = frame.at(0.2, 0.7);
        pen.text([x, y], Anchor::Start, "thick string", label(Role::Omega));
        let [x, y] = frame.at(0.6, 0.7);
        pen.text([x, y], Anchor::Start, "thin string", label(Role::Ink));
    }))
}
