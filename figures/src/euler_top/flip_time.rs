//! How long a racket waits before it flips, over sixteen decades of the distance from the separatrix (tutorial 6.3, 6.7).

use core::f64::consts::LN_10;

use spinning_bodies::Result;
use spinning_bodies::euler_top::EulerTop;
use spinning_bodies::euler_top::stability::saddle;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::inertia::PrincipalMoments;

use crate::Figure;
use crate::style::{
    AXIS, Anchor, DATA, HAIR, Pen, Point, Role, SECONDARY, Words, figure, label, number, small,
    stroke,
};

/// What well-known libraries answer: measured, with the scripts, in the folder of the table.
const PEERS: &str = include_str!("../../../tests/reference/peers/flip_time.csv");
/// A flip time wrong by more than this is no flip time.
const GIVEN_UP: f64 = 1e-3;

/// A library from its last good answer on.
#[derive(Debug, Clone, PartialEq)]
struct Peer {
    name: String,
    /// The last good answer and the wrong ones beyond: decades from 1, seconds. They end where no number comes any more.
    answers: Vec<[f64; 2]>,
}

impl Peer {
    /// Whether it still gives numbers at the end of the axis.
    fn goes_on(&self) -> bool {
        self.answers
            .last()
            .is_some_and(|answer| answer[0] >= f64::from(DECADES) - 0.25)
    }
}

/// The libraries of the table, in its order, which has a head line and for each library tilts that decrease.
fn peers(table: &str) -> Vec<Peer> {
    let mut lines = table
        .lines()
        .map(|line| line.split(',').collect::<Vec<_>>());
    let head = lines.next().unwrap_or_default();
    let column = |ending: &str| head.iter().position(|name| name.ends_with(ending));
    let (Some(tilt), Some(time)) = (column("epsilon"), column("flip_time")) else {
        return Vec::new();
    };
    let error = time + 1;
    let mut found: Vec<Peer> = Vec::new();
    for cells in lines.filter(|cells| cells.len() > error && cells[0] != "exact") {
        let read = |k: usize| cells[k].trim().parse::<f64>().unwrap_or(f64::NAN);
        let answer = [-read(tilt).log10(), read(time)];
        let name = cells[0].to_owned();
        if found.last().is_none_or(|peer| peer.name != name) {
            let answers = Vec::new();
            found.push(Peer { name, answers });
        }
        let Some(peer) = found.last_mut() else {
            continue;
        };
        if answer[0] > f64::from(DECADES) + 0.1 || !answer[1].is_finite() {
            continue;
        }
        if read(error).abs() <= GIVEN_UP {
            peer.answers.clear();
        }
        peer.answers.push(answer);
    }
    found
}

const DECADES: i32 = 16;
/// Left, right, bottom, top of the frame.
const FRAME: [f64; 4] = [70.0, 560.0, 330.0, 30.0];
/// The longest time on the axis, s.
const LONGEST: f64 = 140.0;

fn place(exponent: f64, time: f64) -> Point {
    let [left, right, bottom, top] = FRAME;
    [
        left + (right - left) * exponent / f64::from(DECADES),
        bottom - (bottom - top) * time / LONGEST,
    ]
}

/// Every decade closer costs the same.
pub fn flip_time() -> Result<Figure> {
    let moments = [1.0, 2.0, 3.0];
    let time = |exponent: f64| -> Result<f64> {
        let tilt = 10f64.powf(-exponent);
        let omega = BodyVector::new(tilt, 1.0, tilt);
        Ok(0.5 * EulerTop::from_omega(moments, omega, Attitude::identity())?.period())
    };
    let line = (0..=DECADES)
        .map(|k| Ok(place(f64::from(k), time(f64::from(k))?)))
        .collect::<Result<Vec<_>>>()?;
    let [i1, i2, i3] = moments;
    let rate = saddle(&PrincipalMoments::new(i1, i2, i3)?, 1.0)?.rate;
    let decade = 2.0 * LN_10 / rate;
    let turns = |t: f64| t / core::f64::consts::TAU;
    let (near, far) = (time(f64::from(DECADES))?, time(2.0)?);
    let (stubborn, silent): (Vec<Peer>, Vec<Peer>) =
        peers(PEERS).into_iter().partition(Peer::goes_on);
    let end = silent.iter().filter_map(|peer| peer.answers.last()).next();
    let longest = stubborn
        .iter()
        .flat_map(|peer| &peer.answers)
        .fold(0.0, |most: f64, answer| most.max(answer[1]));
    let words = Words {
        claim: "Each decade closer to the middle axis buys the same few seconds before the flip; the usual formulas give up \
                half-way."
            .to_owned(),
        details: format!(
            "Time from flip to flip, half the period of $\\Omega$, for $I = (1, 2, 3)$ and $\\Omega(0) = (\\epsilon, 1, \\epsilon)$. \
             A decade adds $2\\ln 10/\\sqrt{{\\lambda}} = {}$ s: {} s at a hundredth off the axis, {} s or {} turns at $10^{{-{DECADES}}}$. \
             Measured: the formulas of 6.6 in doubles with the functions of SciPy, GSL, Boost and libstdc++, and two integrators \
             with tolerance $10^{{-12}}$, each from its last answer that is right to a thousandth.",
            number(decade, 3),
            number(far, 2),
            number(near, 2),
            number(turns(near), 1),
        ),
        alt: format!(
            "The time between two flips against the initial distance from the middle axis, on a logarithmic axis over {DECADES} decades: \
             a straight line, up by {} seconds for every factor of ten, to {} seconds at ten to the minus {DECADES}. The answers of \
             well-known libraries end with a cross near ten to the minus {}, where the formulas of 6.6 return no number any \
             more; two integrators leave the line there and never see a racket wait for more than {} seconds.",
            number(decade, 1),
            number(near, 0),
            number(end.map_or(f64::NAN, |answer| answer[0]), 1),
            number(longest.ceil(), 0),
        ),
    };
    Ok(figure("flip-time", 392.0, words, |pen| {
        axes(pen);
        pen.line(&line, stroke(Role::Omega, DATA));
        for (k, point) in line.iter().enumerate() {
            if k > 0 {
                pen.disc(*point, 3.0, Role::Omega, 1.0);
            }
        }
        let (a, b) = (line[11], line[12]);
        pen.line(&[a, [b[0], a[1]], b], stroke(Role::Muted, AXIS));
        pen.text(
            [b[0] + 6.0, 0.5 * (a[1] + b[1]) + 9.0],
            Anchor::Start,
            &format!("{} s a decade", number(decade, 2)),
            small(Role::Ink),
        );
        for peer in stubborn.iter().chain(&silent) {
            let points: Vec<Point> = peer.answers.iter().map(|a| place(a[0], a[1])).collect();
            pen.line(&points, stroke(Role::Ink, SECONDARY).dashed());
            if let (Some(end), false) = (points.last(), peer.goes_on()) {
                cross(pen, *end);
            }
        }
        let first = |name: &str| name.split(' ').next().map(str::to_owned);
        let last = |name: &str| name.split(' ').next_back().map(str::to_owned);
        let lines = [
            ([294.0, 282.0], "no number beyond the cross:".to_owned()),
            ([294.0, 301.0], listed(&silent, first)),
            ([372.0, 214.0], "integrators lose the axis:".to_owned()),
            ([372.0, 233.0], listed(&stubborn, last)),
        ];
        for (at, line) in lines {
            pen.text(at, Anchor::Start, &line, small(Role::Ink));
        }
        if let Some(end) = end {
            let [x, y] = place(end[0], end[1]);
            pen.line(&[[x, y + 8.0], [x, 266.0]], stroke(Role::Ink, HAIR));
        }
    }))
}

/// A part of each name, without repetitions.
fn listed(peers: &[Peer], part: impl Fn(&str) -> Option<String>) -> String {
    let mut names: Vec<String> = Vec::new();
    for name in peers.iter().filter_map(|peer| part(&peer.name)) {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names.join(", ")
}

/// The end of a curve.
fn cross(pen: &mut Pen, at: Point) {
    for side in [1.0, -1.0] {
        pen.line(
            &[
                [at[0] - 4.5, at[1] - 4.5 * side],
                [at[0] + 4.5, at[1] + 4.5 * side],
            ],
            stroke(Role::Ink, DATA),
        );
    }
}

fn axes(pen: &mut Pen) {
    let [left, right, bottom, top] = FRAME;
    pen.line(
        &[[left, top], [left, bottom], [right, bottom]],
        stroke(Role::Ink, AXIS),
    );
    for time in [0.0, 40.0, 80.0, 120.0] {
        let y = place(0.0, time)[1];
        pen.line(&[[left - 5.0, y], [left, y]], stroke(Role::Ink, AXIS));
        pen.text(
            [left - 9.0, y + 5.0],
            Anchor::End,
            &number(time, 0),
            small(Role::Ink),
        );
    }
    for exponent in [0, 4, 8, 12, 16] {
        let x = place(f64::from(exponent), 0.0)[0];
        pen.line(&[[x, bottom], [x, bottom + 5.0]], stroke(Role::Ink, AXIS));
        let text = if exponent == 0 {
            "1".to_owned()
        } else {
            format!("10^{{\u{2212}{exponent}}}")
        };
        pen.text([x, bottom + 22.0], Anchor::Middle, &text, small(Role::Ink));
    }
    pen.text(
        [left + 10.0, top + 6.0],
        Anchor::Start,
        "time between flips, s",
        label(Role::Ink),
    );
    pen.text(
        [right, bottom + 46.0],
        Anchor::End,
        "distance *ε* from the middle axis",
        label(Role::Ink),
    );
}
