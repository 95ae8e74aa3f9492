//! Error against time, as measured on one machine.

use spinning_bodies::Result;

use super::{Y, panel_axes};
use crate::Figure;
use crate::plot::Frame;
use crate::style::{Anchor, DATA, Pen, Point, Role, Words, figure, small, stroke};

/// What the command `accuracy --csv` wrote, under a line that names machine and compiler.
const MEASURED: &str = include_str!("../../../book/src/tables/accuracy.csv");

/// Problem and its name on the figure.
const PANELS: [(&str, &str); 6] = [
    ("free-top/1000", "free body"),
    ("near-separatrix/1000", "beside the separatrix"),
    ("cusped-top/1000", "top with cusps"),
    ("near-sleeping/1000", "top, nearly asleep"),
    ("kovalevskaya-level/1000", "Kovalevskaya’s top"),
    ("heavy-body/1000", "no closed form"),
];
const X: [f64; 2] = [3e-7, 1.0];
const TICKS: [(f64, &str); 3] = [(1e-6, "1 µs"), (1e-3, "1 ms"), (1.0, "1 s")];

/// One measurement, as far as it is drawn.
struct Row<'a> {
    problem: &'a str,
    method: &'a str,
    error: f64,
    seconds: f64,
}

fn rows() -> Vec<Row<'static>> {
    let lines = MEASURED
        .lines()
        .filter(|line| !line.starts_with('#'))
        .skip(1);
    let rows = lines.filter_map(|line| {
        let fields: Vec<&str> = line.split(',').collect();
        let [problem, method, _, error, _, _, _, seconds, status] = fields[..] else {
            return None;
        };
        let error: f64 = error.parse().ok()?;
        let seconds = seconds.parse().ok()?;
        let shown = status == "ok" || status == "floor";
        (shown && error < Y[1]).then(|| Row {
            problem,
            method,
            error: error.max(Y[0]),
            seconds,
        })
    });
    rows.collect()
}

/// The least time for each error or a smaller one: a staircase's corners.
fn best<'a>(rows: impl Iterator<Item = &'a Row<'static>>) -> Vec<Point> {
    let mut points: Vec<Point> = rows.map(|row| [row.seconds, row.error]).collect();
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut kept: Vec<Point> = Vec::new();
    for point in points {
        if kept.last().is_none_or(|last| point[1] < last[1]) {
            kept.push(point);
        }
    }
    kept
}

fn is_general(method: &str) -> bool {
    matches!(method, "rk4" | "dopri5" | "dop853" | "verner98" | "gauss")
}

/// Small multiples: what a thousand turns of each top cost on a clock.
pub fn seconds() -> Result<Figure> {
    let rows = rows();
    let machine = MEASURED
        .lines()
        .next()
        .unwrap_or_default()
        .trim_start_matches(['#', ' ']);
    let words = Words {
        claim: "A thousand turns on a clock: the closed form is exact before a general method has warmed up.".to_owned(),
        details: format!(
            "Error of the attitude in radians after a thousand turns against time. Grey: the best of the general methods; dotted, rk4. Black line: the best of our own methods \
             that take steps. Disc: the closed form, its preparation included. Kovalevskaya’s top starts with axis 3 level. Measured once, least of repeated runs: {machine}."
        ),
        alt: "Six small diagrams, error against seconds, both logarithmic. The line of our stepping methods lies to the left of that of the general methods; a black disc, the \
              closed form, lies far to the left of both and at the bottom. The sixth problem has no closed form and no disc."
            .to_owned(),
    };
    Ok(figure("accuracy-seconds", 640.0, words, |pen| {
        let mut frames = Vec::new();
        for (k, (problem, name)) in PANELS.iter().enumerate() {
            let place = [54.0 + 300.0 * (k % 2) as f64, 40.0 + 204.0 * (k / 2) as f64];
            let of = |keep: &dyn Fn(&str) -> bool| {
                best(
                    rows.iter()
                        .filter(|row| row.problem == *problem && keep(row.method)),
                )
            };
            let lines = [
                (of(&|m| m == "rk4"), stroke(Role::Muted, DATA).dotted()),
                (
                    of(&|m| is_general(m) && m != "rk4"),
                    stroke(Role::Muted, DATA),
                ),
                (
                    of(&|m| !is_general(m) && m != "exact"),
                    stroke(Role::Ink, DATA),
                ),
            ];
            let frame @ Frame { x, y } = panel_axes(pen, name, place, X, &TICKS);
            frames.push(frame);
            for (line, stroke) in lines {
                let line: Vec<Point> = line
                    .iter()
                    .filter(|p| p[0] < X[1])
                    .map(|p| [x.at(p[0]), y.at(p[1])])
                    .collect();
                pen.line(&line, stroke);
            }
            if k == 0 {
                legend(pen, place);
            }
            for point in of(&|m| m == "exact") {
                pen.disc([x.at(point[0]), y.at(point[1])], 6.0, Role::Ink, 1.0);
            }
        }
        for (first, last) in frames.iter().zip(&frames[4..]) {
            first.panel_names(pen, last, ["time", "error, rad"]);
        }
    }))
}

/// Names at the lines of the first panel.
fn legend(pen: &mut Pen, [left, top]: Point) {
    for (x, y, name, role) in [
        (90.0, 62.0, "ours", Role::Ink),
        (176.0, 128.0, "general", Role::Muted),
        (52.0, 130.0, "closed form", Role::Ink),
    ] {
        pen.text([left + x, top + y], Anchor::Start, name, small(role));
    }
}
