//! Error against time, as measured on one machine.

use lab::accuracy::measured::{EXACT, MOTIONS, Row, SWEEP, rows};

use crate::own::corners;
use crate::prelude::*;

const X: [f64; 2] = [3e-7, 1.0];
const TIMES: [(f64, &str); 3] = [(1e-6, "1 µs"), (1e-3, "1 ms"), (1.0, "1 s")];
/// Errors at the ends of the vertical axis, rad.
const Y: [f64; 2] = [1e-16, 1.0];
const ERRORS: [(f64, &str); 3] = [(1.0, "1"), (1e-8, "10^{−8}"), (1e-16, "10^{−16}")];
/// The geometric methods, for a free body and a heavy one, and the error at which the name stands beside the line, rad.
const GEOMETRIC: [(&str, f64); 2] = [("moser-veselov-10", 1e-10), ("kick-drift-6", 1e-3)];

/// The methods that can be applied to every motion, their lines, and their places in the legend.
const STEPPERS: [(&str, Stroke, Point); 3] = [
    ("dormand-prince-8", inked(DATA).dashed(), [364.0, 22.0]),
    ("dop853", muted(DATA), [364.0, 48.0]),
    ("rk4", muted(DATA).dotted(), [514.0, 48.0]),
];

/// The least time for each error or a smaller one: a staircase's corners.
fn best(rows: &[Row<'_>], problem: &str, method: &str) -> Vec<Point> {
    let wanted = rows.iter().filter(|row| {
        row.problem == problem && row.method == method && row.error < Y[1] && row.price < X[1]
    });
    let wanted = wanted.map(|row| [row.price, row.error.max(Y[0])]);
    corners(&wanted.collect::<Vec<_>>())
}

/// Small panels: the time that the longest run of each top takes.
pub fn seconds(_: &Values) -> Result<Figure> {
    let rows = rows(SWEEP);
    let machine = SWEEP.lines().next().unwrap_or_default();
    let machine = machine.trim_start_matches(['#', ' ']);
    let words = words!(
        "A thousand turns on a clock: the closed form is exact before a method that steps has warmed up.",
        "Error of the attitude in radians against time; the tippe top makes a hundred turns. The closed form is prepared and asked once. Least of repeated runs: {machine}.",
        "Eight small diagrams, error against seconds, both logarithmic. The line of the geometric method lies to the left of those of dop853 and rk4, with dormand-prince-8 near \
         it; a disc, the closed form, lies far to the left of all and at the bottom, for Kovalevskaya's two tops near ten to the minus 12. The last two motions have no disc."
    );
    Ok(figure("accuracy-seconds", 968.0, words, |pen| {
        legend(pen);
        let mut frames = Vec::new();
        for (k, (motion, name, [.., turns])) in MOTIONS.into_iter().enumerate() {
            let [column, row] = [k % 2, k / 2].map(|k| k as f64);
            let corner = [54.0 + 292.0 * column, 120.0 + 212.0 * row];
            let frame = Frame::panel(pen, name, corner, [X, Y], [&TIMES, &ERRORS]);
            let run = format!("{motion}/{turns}");
            let line = |method: &str| -> Vec<Point> { frame.trace(best(&rows, &run, method)) };
            for (method, style, _) in STEPPERS {
                pen.line(line(method), style);
            }
            for (method, _) in GEOMETRIC {
                pen.line(line(method), inked(DATA));
            }
            for point in line(EXACT) {
                pen.dot(point, 6.0);
            }
            for (method, named) in GEOMETRIC {
                let beside = frame.y.at(named);
                if let Some(&[x, _]) = line(method).iter().rfind(|p| p[1] < beside) {
                    // To the left of its line and to the right of the axis, as high as there is room.
                    let half = 4.0 * method.len() as f64 + 16.0;
                    let least = frame.x.ends[0] + half;
                    let places = (0..60).map(|k| {
                        let left = x - half - 4.0 * f64::from(k / 6);
                        [left.max(least), beside + 9.0 * f64::from(k % 6)]
                    });
                    pen.name(places, method, small(Ink));
                }
            }
            frames.push(frame);
        }
        for (first, last) in frames.iter().zip(&frames[6..]) {
            first.panel_names(pen, last, 38.0, ["time", "error, rad"]);
        }
    }))
}

/// The legend of the lines.
fn legend(pen: &mut Pen) {
    pen.dot([72.0, 17.0], 6.0);
    pen.label([104.0, 22.0], Start, "exact, the closed form");
    let solid = ("a geometric method", inked(DATA), [104.0, 48.0]);
    for (name, style, [x, y]) in STEPPERS.into_iter().chain([solid]) {
        pen.line([[x - 48.0, y - 5.0], [x - 12.0, y - 5.0]], style);
        pen.text([x, y], Start, name, label(style.role()));
    }
}
