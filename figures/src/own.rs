//! Diagrams of the reader's own motions: one number against another, in one panel for each pair.

use crate::figure::Figure;
use crate::plot::{Axis, Frame, Scale, apart, powers};
use crate::style::*;

/// The values of a quantity along a motion.
#[derive(Debug, Clone)]
pub struct Quantity {
    /// Its name in scenes: `tilt`, `omega1`, …
    pub name: String,
    /// Its unit; `1` for a pure number, empty if it is not known.
    pub unit: &'static str,
    /// Whether it is an angle given between −π and π, so that a line is broken where it goes round.
    pub goes_round: bool,
    /// Whether its axis is logarithmic.
    pub logarithmic: bool,
    /// The values, one for each row; NaN is not drawn.
    pub values: Vec<f64>,
}

/// A quantity as it is drawn: relative to its first value if it hardly changes, in units of a power of ten.
struct Drawn {
    label: String,
    values: Vec<f64>,
    shown: [f64; 2],
}

impl Quantity {
    fn drawn(&self) -> Drawn {
        let [low, high] = extent(&self.values);
        if self.logarithmic {
            return Drawn {
                label: self.name.clone(),
                values: self.values.clone(),
                shown: [low, high],
            };
        }
        let greatest = low.abs().max(high.abs());
        let first = self.values.iter().copied().find(|value| !value.is_nan());
        let hardly = high > low && high - low < 1e-6 * greatest;
        let (before, origin) = if hardly {
            ("change of ", first.unwrap_or(0.0))
        } else {
            ("", 0.0)
        };
        let values: Vec<f64> = self.values.iter().map(|value| value - origin).collect();
        let [low, high] = extent(&values);
        let power = low.abs().max(high.abs()).log10().floor();
        let power = match (-3.0..5.0).contains(&power) || !power.is_finite() {
            true => 0.0,
            false => power,
        };
        let values = values.iter().map(|value| value / 10_f64.powf(power));
        let values: Vec<f64> = values.collect();
        let [low, high] = extent(&values);
        let air = if high > low { 0.06 * (high - low) } else { 1.0 };
        let unit = match (power, self.unit) {
            (0.0, "1" | "") => String::new(),
            (0.0, unit) => format!(", {unit}"),
            (_, "1" | "") => format!(", 10^{{{power}}}"),
            (_, unit) => format!(", 10^{{{power}}} {unit}"),
        };
        Drawn {
            label: format!("{before}{}{}", self.name, unit.replace('-', "\u{2212}")),
            values,
            shown: [low - air, high + air],
        }
    }

    fn axis(&self, shown: [f64; 2], ends: [f64; 2]) -> Axis {
        match self.logarithmic {
            true => Axis::log(shown, ends),
            false => Axis::linear(shown, ends),
        }
    }

    /// The colour of the quantity.
    fn role(&self) -> Role {
        let letters = self.name.trim_end_matches(|c: char| c.is_ascii_digit());
        match letters {
            _ if letters.starts_with("omega") || self.name == "spin" => Omega,
            "l" | "lx" | "ly" | "lz" | "angular_momentum" | "l_about_table" | "l_over_radius" => {
                AngularMomentum
            }
            _ => Ink,
        }
    }
}

/// A diagram with this title: in each panel one quantity to the right and one upward, with equally many values.
pub fn diagram(title: &str, panels: &[[Quantity; 2]]) -> Figure {
    let named = |[x, y]: &[Quantity; 2]| format!("{} against {}", y.name, x.name);
    let names: Vec<String> = panels.iter().map(named).collect();
    let told = |[_, y]: &[Quantity; 2]| {
        let [low, high] = extent(&y.values);
        let unit = if y.unit == "1" { "" } else { y.unit };
        let [low, high] = [low, high].map(short);
        format!("{} goes from {low} to {high} {unit}", y.name)
    };
    let told: Vec<String> = panels.iter().map(told).collect();
    let details = format!("{}.", told.join("; ").replace(" ;", ";").trim_end());
    let names = names.join(", ");
    let shown = match panels.len() {
        1 => format!("A diagram: {names}"),
        count => format!("{count} panels, below each other: {names}"),
    };
    let words = Words {
        claim: format!("{title}: {names}."),
        alt: format!("{shown}. {details}"),
        details,
    };
    let height = if panels.len() == 1 { 300.0 } else { 190.0 };
    let gap = 88.0;
    let whole = panels.len() as f64 * (height + gap) + 6.0;
    let made = figure("plot", whole, words, |pen| {
        for (k, [x, y]) in panels.iter().enumerate() {
            let top = 36.0 + k as f64 * (height + gap);
            let (across, up) = (x.drawn(), y.drawn());
            // The axis of time, or of a varied number, begins at its first value.
            let varied = x.unit.is_empty();
            let shown = match extent(&across.values) {
                [from, to] if (x.name == "t" || varied) && from < to => [from, to],
                _ => across.shown,
            };
            let frame = Frame {
                x: x.axis(shown, [84.0, 576.0]),
                y: Axis::linear(up.shown, [top + height, top]),
            };
            let (x_ticks, y_ticks) = (ticks(&frame.x, 70.0), ticks(&frame.y, 45.0));
            let names = [across.label.as_str(), &up.label];
            frame.draw(pen, &x_ticks, &y_ticks, names);
            let [low, high] = up.shown;
            if low < 0.0 && high > 0.0 {
                let zero = [frame.at(shown[0], 0.0), frame.at(shown[1], 0.0)];
                pen.line(zero, muted(AXIS).dashed());
            }
            let mut line: Vec<Point> = Vec::new();
            let mut before = [f64::NAN; 2];
            let few = varied && across.values.len() <= FEW;
            for (&a, &b) in across.values.iter().zip(&up.values) {
                let jumps = |along: usize, to: f64| (to - before[along]).abs() > 3.2;
                let round = (x.goes_round && jumps(0, a)) || (y.goes_round && jumps(1, b));
                if round || b.is_nan() {
                    pen.line(line.drain(..), stroke(y.role(), DATA));
                }
                if b.is_nan() {
                    continue;
                }
                if few {
                    pen.disc(frame.at(a, b), 3.0, y.role(), 1.0);
                }
                line.push(frame.at(a, b));
                before = [a, b];
            }
            pen.line(&line, stroke(y.role(), DATA));
            // What does not move.
            if let Some(at) = line.first().filter(|at| line.iter().all(|p| p == *at)) {
                pen.disc(*at, 3.0, y.role(), 1.0);
            }
        }
    });
    panels.iter().fold(made, |made, [x, y]| {
        let rows = x.values.iter().zip(&y.values).map(|(&x, &y)| vec![x, y]);
        let name = format!("{} against {}", y.name, x.name);
        made.data(name, "across | up", rows)
    })
}

/// Up to this number, points of a varied number are drawn as discs.
const FEW: usize = 60;

/// A map with this title: a quantity in steps of ink over two varied numbers, the second of which runs fastest in its values.
pub fn map(title: &str, [x, y]: &[Quantity; 2], told: &Quantity) -> Figure {
    let drawn = told.drawn();
    let there = || drawn.values.iter().copied().filter(|value| !value.is_nan());
    let [low, high] = extent(there());
    // Steps of ink; one where all values are the same.
    let steps = if high > low { 8 } else { 1 };
    let step = |value: f64| {
        let share = (value - low) / (high - low) * f64::from(steps);
        // NaN is the first step.
        (share as u32).min(steps - 1)
    };
    let shade = |step: u32| (5.0 + 10.0 * f64::from(step)) / 100.0;
    let count = drawn.values.len();
    let refused = count - there().count();
    let [across, up] = [x, y].map(|axis| axis.values.len());
    let [least, greatest] = extent(&told.values).map(short);
    let unit = if told.unit == "1" { "" } else { told.unit };
    let left_out = match refused {
        0 => String::new(),
        _ => format!("; {refused} of {count} points have none, and are crossed out"),
    };
    let range = format!("From {least} to {greatest} {unit}");
    let details = format!("{}{left_out}.", range.trim_end());
    let words = Words {
        claim: format!("{title}: {} over {} and {}.", told.name, x.name, y.name),
        alt: format!(
            "A map of {across} by {up} fields, the darker the greater {}. {details}",
            told.name
        ),
        details,
    };
    let made = figure("plot", 470.0, words, |pen| {
        // The numbers belong to the middles of the fields.
        let [(left, right), (bottom, top)] = [(84.0, 462.0), (400.0, 40.0)];
        let axis = |of: &Quantity, [from, to]: [f64; 2]| {
            let half = 0.5 * (to - from) / of.values.len() as f64;
            of.axis(extent(&of.values), [from + half, to - half])
        };
        let frame = Frame {
            x: axis(x, [left, right]),
            y: axis(y, [bottom, top]),
        };
        let corner = |i: usize, j: usize| {
            let x = left + (right - left) * i as f64 / across as f64;
            [x, bottom + (top - bottom) * j as f64 / up as f64]
        };
        for (k, &value) in drawn.values.iter().enumerate() {
            let corners = boxed(corner(k / up, k % up), corner(k / up + 1, k % up + 1));
            match value.is_nan() {
                true => pen.line([corners[0], corners[2]], muted(AXIS)),
                false => pen.fill(corners, Ink, shade(step(value))),
            }
        }
        let bare = Frame::linear([0.0, 1.0], [0.0, 1.0], [left, right, bottom, top]);
        bare.draw(pen, &[], &[], [&x.name, &y.name]);
        for (value, text) in ticks(&frame.x, 70.0) {
            pen.remark([frame.x.at(value), bottom + 20.0], Middle, &text);
        }
        for (value, text) in ticks(&frame.y, 45.0) {
            pen.remark([left - 9.0, frame.y.at(value) + 5.0], End, &text);
        }
        pen.label([592.0, top - 12.0], End, &drawn.label);
        for step in 0..steps {
            let height = |step: u32| bottom + (top - bottom) * f64::from(step) / f64::from(steps);
            let [from, to] = [height(step), height(step + 1)];
            pen.fill(boxed([480.0, from], [500.0, to]), Ink, shade(step));
            let value = low + (high - low) * f64::from(step) / f64::from(steps);
            pen.remark([506.0, from + 5.0], Start, &short(value));
        }
        pen.remark([506.0, top + 5.0], Start, &short(high));
    });
    let rows = told.values.iter().enumerate();
    let rows = rows.map(|(k, &value)| vec![x.values[k / up], y.values[k % up], value]);
    made.data(told.name.clone(), "across | up | told", rows)
}

/// The cost of a method, and its error.
pub type Curve = (String, Vec<Point>);

/// The diagram of a motion: the cost of each method against its error, with its name at the end of its line.
pub fn prices(title: &str, [price, error]: [&str; 2], curves: &[Curve]) -> Figure {
    let curves: Vec<Curve> = curves
        .iter()
        .map(|(name, points)| (name.clone(), corners(points)))
        .filter(|(_, points)| !points.is_empty())
        .collect();
    let all = |k: usize| {
        curves
            .iter()
            .flat_map(|curve| &curve.1)
            .map(move |point| point[k])
    };
    let [least, most] = extent(all(0));
    let [best, worst] = extent(all(1));
    let words = Words {
        claim: format!("{title}: what an error costs, method by method."),
        details: format!("{error} against {price}."),
        alt: format!(
            "{} falling curves of {error} against {price}, both logarithmic, each with the name of its method at its end.",
            curves.len()
        ),
    };
    let height = 150.0 + 16.0 * curves.len().max(14) as f64;
    let bottom = height - 60.0;
    let frame = Frame::log(
        [0.7 * least, 1.4 * most],
        [0.4 * best, 2.5 * worst],
        [74.0, 420.0, bottom, 44.0],
    );
    let made = figure("plot", height, words, |pen| {
        let (x, y) = (ticks(&frame.x, 50.0), ticks(&frame.y, 40.0));
        frame.draw(pen, &x, &y, [price, error]);
        let lines = curves
            .iter()
            .map(|(_, points)| frame.trace(points.iter().copied()));
        let lines: Vec<Vec<Point>> = lines.collect();
        let ends: Vec<Point> = lines.iter().map(|line| line[line.len() - 1]).collect();
        let wanted: Vec<f64> = ends.iter().map(|end| end[1]).collect();
        // Half way between names pushed up from below and names pushed down from above, within the frame.
        let raised = apart(&wanted, 16.0, bottom);
        let turned: Vec<f64> = wanted.iter().map(|height| -height).collect();
        let lowered = apart(&turned, 16.0, -44.0);
        let between = raised.iter().zip(&lowered).map(|(a, b)| 0.5 * (a - b));
        let mut heights = apart(&between.collect::<Vec<_>>(), 16.0, bottom);
        uncross(&ends, &mut heights);
        for (k, ((name, _), line)) in curves.iter().zip(&lines).enumerate() {
            let role = if k % 2 == 0 { Ink } else { Muted };
            let style = stroke(role, SECONDARY);
            let style = match k / 2 % 3 {
                0 => style,
                1 => style.dashed(),
                _ => style.dotted(),
            };
            pen.line(line, style);
            pen.disc(ends[k], 2.6, role, 1.0);
            let beside = [NAMED, heights[k]];
            pen.line([ends[k], beside], muted(HAIR).alpha(0.5));
            pen.text([NAMED + 4.0, heights[k] + 5.0], Start, name, small(role));
        }
    });
    curves.into_iter().fold(made, |made, (name, points)| {
        made.data(name, "price | error", points)
    })
}

/// Where the names stand.
const NAMED: f64 = 438.0;

/// Exchanges heights until no leader from an end to its name crosses another: each exchange makes them shorter in all.
fn uncross(ends: &[Point], heights: &mut [f64]) {
    let mut exchanged = true;
    while exchanged {
        exchanged = false;
        for i in 0..ends.len() {
            for j in 0..i {
                let leaders = [i, j].map(|k| [ends[k], [NAMED, heights[k]]]);
                if cross(leaders) {
                    heights.swap(i, j);
                    exchanged = true;
                }
            }
        }
    }
}

/// Whether two pieces of line cross, by more than rounding.
fn cross([one, other]: [[Point; 2]; 2]) -> bool {
    let beside = |[a, b]: [Point; 2], p: Point| {
        let area = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
        if area.abs() > 1e-6 { area } else { 0.0 }
    };
    let splits = |line, [a, b]: [Point; 2]| beside(line, a) * beside(line, b) < 0.0;
    splits(one, other) && splits(other, one)
}

/// The corners of a staircase: the points that no cheaper one matches in accuracy. An error of zero is drawn as one rounding.
pub(crate) fn corners(points: &[Point]) -> Vec<Point> {
    let is_there = |[price, error]: &&Point| *price > 0.0 && error.is_finite();
    let points = points
        .iter()
        .filter(is_there)
        .map(|&[price, error]| [price, error.max(1e-17)]);
    let mut points: Vec<Point> = points.collect();
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut best = f64::INFINITY;
    points.retain(|point| {
        let better = point[1] < best;
        best = best.min(point[1]);
        better
    });
    points
}

/// Round numbers along an axis and their texts, at this distance; powers of ten along an axis that has several.
fn ticks(axis: &Axis, apart: f64) -> Vec<(f64, String)> {
    let [low, high] = axis.shown.map(f64::log10);
    if axis.scale == Scale::Log && high - low >= 2.0 {
        let length = (axis.ends[1] - axis.ends[0]).abs();
        let every = ((high - low) * apart / length).ceil().max(1.0) as usize;
        return powers((low.ceil() as i32..=high.floor() as i32).step_by(every));
    }
    let (marks, scale) = (axis.ticks(apart), Scale::Linear);
    if marks.len() > 1 {
        marks
    } else {
        Axis { scale, ..*axis }.ticks(apart)
    }
}

/// A number in four digits, however large or small.
fn short(value: f64) -> String {
    match value.abs() {
        0.0 => "0".into(),
        size if (1e-3..1e5).contains(&size) => brief(value),
        _ => format!("{value:.3e}").replace('-', "\u{2212}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn quantity(name: &str, values: &[f64]) -> Quantity {
        let values = values.to_vec();
        Quantity {
            name: name.to_owned(),
            unit: "J",
            goes_round: false,
            logarithmic: false,
            values,
        }
    }

    #[test]
    fn what_hardly_changes_is_drawn_as_its_change() {
        let energy = quantity("energy", &[f64::NAN, 5.0, 5.0 + 4e-13, 5.0 - 4e-13]).drawn();
        assert_eq!(energy.label, "change of energy, 10^{\u{2212}13} J");
        assert!(energy.values[1] == 0.0 && energy.shown[1] > 3.9);
        assert_eq!(quantity("energy", &[2.0, 2.0]).drawn().shown, [1.0, 3.0]);
        assert_eq!(quantity("energy", &[0.0, 0.0]).drawn().label, "energy, J");
    }

    #[test]
    fn a_panel_each() {
        let time = quantity("t", &[0.0, 1.0, 2.0]);
        let tilt = Quantity {
            goes_round: true,
            ..quantity("phi", &[3.0, -3.0, -2.0])
        };
        let made = diagram(
            "The motion of a.toml",
            &[[time.clone(), tilt], [time.clone(), time]],
        );
        assert!(
            made.claim
                .starts_with("The motion of a.toml: phi against t")
        );
        assert_eq!(made.data.rows.len(), 6);
        // The line of phi is broken where it goes round: one point is left alone and draws nothing.
        assert!(!made.svg().contains("NaN"));
    }

    #[test]
    fn leaders_do_not_cross() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let pieces =
            |[a, b, c, d]: [usize; 4]| [[a, b], [c, d]].map(|ends| ends.map(|k| square[k]));
        assert!(cross(pieces([0, 2, 1, 3])) && !cross(pieces([0, 1, 2, 3])));
        let ends = [
            [100.0, 200.0],
            [400.0, 210.0],
            [250.0, 190.0],
            [400.0, 205.0],
        ];
        let mut heights = [180.0, 230.0, 196.0, 214.0];
        uncross(&ends, &mut heights);
        for i in 0..4 {
            for j in 0..i {
                let leaders = [i, j].map(|k| [ends[k], [NAMED, heights[k]]]);
                assert!(!cross(leaders), "{i} {j}");
            }
        }
    }

    #[test]
    fn what_is_dearer_and_no_better_is_left_out() {
        let points = [
            [4.0, 1e-3],
            [1.0, 1e-1],
            [2.0, 1e-3],
            [8.0, 0.0],
            [9.0, f64::NAN],
        ];
        assert_eq!(corners(&points), [[1.0, 1e-1], [2.0, 1e-3], [8.0, 1e-17]]);
    }
}
