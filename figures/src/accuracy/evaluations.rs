//! Error against evaluations, problem by problem.

use lab::accuracy::Problem;
use spinning_bodies::Result;

use super::{Y, panel_axes, points, problem, swept};
use crate::Figure;
use crate::plot::Frame;
use crate::style::{Anchor, DATA, Pen, Point, Role, Words, figure, small, stroke};

/// Problem, its name on the figure, and the best geometric method for it.
const PANELS: [(&str, &str, &str); 6] = [
    ("free-top/10", "free body", "moser-veselov-10"),
    (
        "near-separatrix/10",
        "beside the separatrix",
        "moser-veselov-10",
    ),
    ("cusped-top/10", "top with cusps", "kick-drift-6"),
    ("near-sleeping/10", "top, nearly asleep", "kick-drift-6"),
    (
        "kovalevskaya-level/10",
        "Kovalevskaya’s top",
        "kick-drift-6",
    ),
    ("heavy-body/10", "no closed form", "kick-drift-6"),
];
const GENERAL: &str = "dop853";
const CLASSIC: &str = "rk4";
const X: [f64; 2] = [0.7, 1e5];
const TICKS: [(f64, &str); 3] = [(1.0, "1"), (100.0, "100"), (1e4, "10^{4}")];

struct Panel {
    name: &'static str,
    classic: Vec<Point>,
    general: Vec<Point>,
    geometric: Vec<Point>,
    exact: Vec<Point>,
}

fn panel(name: &'static str, shown: &'static str, geometric: &str) -> Result<Panel> {
    let problem: Problem = problem(name)?;
    let line = |method: &str| -> Result<Vec<Point>> {
        let rows = swept(&problem, method, 90_000)?;
        let line = points(&rows, |row| row.evaluations as f64);
        Ok(line
            .into_iter()
            .map(|[x, y]| [x, y.max(Y[0])])
            .filter(|p| p[1] < Y[1])
            .collect())
    };
    Ok(Panel {
        name: shown,
        classic: line(CLASSIC)?,
        general: line(GENERAL)?,
        geometric: line(geometric)?,
        exact: line("exact")?,
    })
}

/// Small multiples: what ten turns of each top cost.
pub fn work() -> Result<Figure> {
    let panels = PANELS
        .iter()
        .map(|&(name, shown, geometric)| panel(name, shown, geometric))
        .collect::<Result<Vec<_>>>()?;
    let words = Words {
        claim: "Where there is a closed form, it sits in the corner: one evaluation, all the digits.".to_owned(),
        details: "Ten turns of six tops, error of the attitude in radians against evaluations of the right-hand side (of torques or sine pairs for geometric \
                  methods). Grey: rk4 (dotted) and dop853. Black line: a geometric method, Moser and Veselov’s of order 10 for free bodies, kicks and exact drifts \
                  of order 6 for heavy ones. Disc: the closed form."
            .to_owned(),
        alt: "Six small diagrams, error against number of evaluations, both logarithmic: rk4 falls slowly, dop853 steeply, the geometric method steeply too. In five of them \
              a single black disc stands in the lower left corner, at one evaluation and an error near 1e-16: the closed form. In the sixth there is none."
            .to_owned(),
    };
    Ok(figure("accuracy-evaluations", 640.0, words, |pen| {
        let mut frames = Vec::new();
        for (k, panel) in panels.iter().enumerate() {
            let left = 54.0 + 300.0 * (k % 2) as f64;
            let top = 40.0 + 204.0 * (k / 2) as f64;
            frames.push(draw(pen, panel, [left, top]));
            if k == 0 {
                legend(pen, [left, top]);
            }
        }
        for (first, last) in frames.iter().zip(&frames[4..]) {
            first.panel_names(pen, last, ["evaluations", "error, rad"]);
        }
    }))
}

fn draw(pen: &mut Pen, panel: &Panel, [left, top]: Point) -> Frame {
    let frame @ Frame { x, y } = panel_axes(pen, panel.name, [left, top], X, &TICKS);
    let place = |line: &[Point]| -> Vec<Point> {
        line.iter()
            .map(|p| [x.at(p[0].min(X[1])), y.at(p[1])])
            .collect()
    };
    pen.line(&place(&panel.classic), stroke(Role::Muted, DATA).dotted());
    pen.line(&place(&panel.general), stroke(Role::Muted, DATA));
    pen.line(&place(&panel.geometric), stroke(Role::Ink, DATA));
    for point in place(&panel.exact) {
        pen.disc(point, 6.0, Role::Ink, 1.0);
    }
    frame
}

/// Names at the lines of the first panel.
fn legend(pen: &mut Pen, [left, top]: Point) {
    for (x, y, name, role) in [
        (164.0, 34.0, "rk4", Role::Muted),
        (174.0, 106.0, GENERAL, Role::Muted),
        (44.0, 74.0, "geometric", Role::Ink),
        (18.0, 130.0, "closed form", Role::Ink),
    ] {
        pen.text([left + x, top + y], Anchor::Start, name, small(role));
    }
}
