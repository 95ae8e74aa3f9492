//! Axes of a plain diagram.

use crate::style::*;

/// The scale of an axis: how numbers become places.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// Linear.
    Linear,
    /// Logarithmic.
    Log,
}

/// One axis: the numbers at its ends and their places, units.
#[derive(Debug, Clone, Copy)]
pub struct Axis {
    /// Numbers at both ends.
    pub shown: [f64; 2],
    /// Their places.
    pub ends: [f64; 2],
    /// The scale between them.
    pub scale: Scale,
}

impl Axis {
    /// A linear axis.
    pub const fn linear(shown: [f64; 2], ends: [f64; 2]) -> Self {
        Self {
            shown,
            ends,
            scale: Scale::Linear,
        }
    }

    /// A logarithmic axis.
    pub const fn log(shown: [f64; 2], ends: [f64; 2]) -> Self {
        Self {
            shown,
            ends,
            scale: Scale::Log,
        }
    }

    /// The place of a number.
    pub fn at(&self, value: f64) -> f64 {
        let [low, high] = self.shown;
        let share = match self.scale {
            Scale::Linear => (value - low) / (high - low),
            Scale::Log => (value / low).ln() / (high / low).ln(),
        };
        self.ends[0] + share * (self.ends[1] - self.ends[0])
    }

    /// Round numbers along it and their texts, at least `apart` units from each other.
    pub fn ticks(&self, apart: f64) -> Vec<(f64, String)> {
        let [low, high] = self.shown;
        let ticks: Vec<(f64, String)> = match self.scale {
            Scale::Linear => {
                let least = (high - low).abs() * apart / (self.ends[1] - self.ends[0]).abs();
                let digits = least.log10().floor();
                let unit = 10_f64.powf(digits);
                let rounds = [1.0, 2.0, 5.0, 10.0].map(|k| k * unit);
                let step = rounds.into_iter().find(|step| *step >= least);
                let step = step.unwrap_or(rounds[3]);
                let decimals = (-step.log10().floor()).max(0.0) as usize;
                let [first, last] = [low.min(high), low.max(high)];
                ((first / step - 1e-9).ceil() as i64..=(last / step + 1e-9).floor() as i64)
                    .map(|k| step * k as f64)
                    .map(|value| (value, short(value, decimals)))
                    .collect()
            }
            Scale::Log => {
                let decades = low.log10().floor() as i32..=high.log10().floor() as i32;
                let mut ticks: Vec<(f64, String)> = Vec::new();
                for decade in decades {
                    for digit in [1.0, 2.0, 5.0] {
                        let value = digit * 10_f64.powi(decade);
                        let clear = ticks
                            .last()
                            .is_none_or(|last| (self.at(value) - self.at(last.0)).abs() >= apart);
                        if (low..=high).contains(&value) && clear {
                            ticks.push((value, short(value, -decade.min(0) as usize)));
                        }
                    }
                }
                ticks
            }
        };
        // One number alone tells no scale.
        match ticks.len() {
            0 | 1 if apart > 20.0 => self.ticks(0.5 * apart),
            _ => ticks,
        }
    }
}

/// Both axes of a diagram: x to the right, y upward.
#[derive(Debug, Clone, Copy)]
pub struct Frame {
    /// To the right.
    pub x: Axis,
    /// Upward.
    pub y: Axis,
}

impl Frame {
    /// Both axes linear, their places left, right, bottom and top.
    pub const fn linear(x: [f64; 2], y: [f64; 2], [left, right, bottom, top]: [f64; 4]) -> Self {
        Self {
            x: Axis::linear(x, [left, right]),
            y: Axis::linear(y, [bottom, top]),
        }
    }

    /// Both axes logarithmic, places as before.
    pub const fn log(x: [f64; 2], y: [f64; 2], [left, right, bottom, top]: [f64; 4]) -> Self {
        Self {
            x: Axis::log(x, [left, right]),
            y: Axis::log(y, [bottom, top]),
        }
    }

    /// The place of a pair of numbers.
    pub fn at(&self, x: f64, y: f64) -> Point {
        [self.x.at(x), self.y.at(y)]
    }

    /// The places of pairs of numbers.
    pub fn trace(&self, points: impl IntoIterator<Item = Point>) -> Vec<Point> {
        let points = points.into_iter();
        points.map(|[x, y]| self.at(x, y)).collect()
    }

    /// A curve, as far as it lies within the frame.
    pub fn curve(&self, pen: &mut Pen, points: impl IntoIterator<Item = Point>, style: Stroke) {
        let inside = |value: f64, [low, high]: [f64; 2]| {
            let slack = 1e-9 * (high - low);
            value >= low - slack && value <= high + slack
        };
        let all: Vec<Point> = points.into_iter().collect();
        for piece in all.split(|p| !inside(p[0], self.x.shown) || !inside(p[1], self.y.shown)) {
            pen.line(self.trace(piece.iter().copied()), style);
        }
    }

    /// The axes with ticks, a number and its text each, and what they show.
    pub fn draw(
        &self,
        pen: &mut Pen,
        x_ticks: &[(f64, String)],
        y_ticks: &[(f64, String)],
        [x_name, y_name]: [&str; 2],
    ) {
        let ([left, right], [bottom, top]) = (self.x.ends, self.y.ends);
        pen.line([[left, top], [left, bottom], [right, bottom]], inked(AXIS));
        for (value, text) in x_ticks {
            let x = self.x.at(*value);
            pen.line([[x, bottom], [x, bottom + 5.0]], inked(AXIS));
            // A power reaches higher.
            let down = if text.contains('^') { 24.0 } else { 20.0 };
            pen.remark([x, bottom + down], Middle, text);
        }
        for (value, text) in y_ticks {
            let y = self.y.at(*value);
            pen.line([[left - 5.0, y], [left, y]], inked(AXIS));
            pen.line([[left, y], [right, y]], inked(HAIR).alpha(0.18));
            pen.remark([left - 9.0, y + 5.0], End, text);
        }
        for (at, anchor, name) in [
            ([right, bottom + 40.0], End, x_name),
            ([left - 30.0, top - 12.0], Start, y_name),
        ] {
            pen.label(at, anchor, name);
        }
    }

    /// The axes with round numbers at their ticks, and what they show.
    pub fn draw_round(&self, pen: &mut Pen, names: [&str; 2]) {
        let (x, y) = (self.x.ticks(70.0), self.y.ticks(45.0));
        self.draw(pen, &x, &y, names);
    }

    /// A small panel whose upper left corner is given, both axes logarithmic: its name, the numbers at the ends of each axis, and ticks.
    pub fn panel(
        pen: &mut Pen,
        name: &str,
        [left, top]: Point,
        [across, up]: [[f64; 2]; 2],
        [x_ticks, y_ticks]: [&[(f64, &str)]; 2],
    ) -> Self {
        let (right, bottom) = (left + 234.0, top + 140.0);
        let x = Axis::log(across, [left, right]);
        let y = Axis::log(up, [bottom, top]);
        pen.label([left, top - 14.0], Start, name);
        pen.line([[left, top], [left, bottom], [right, bottom]], inked(AXIS));
        for &(value, text) in x_ticks {
            // A tick at the end must not stand out of the panel.
            let anchor = if value == across[1] { End } else { Middle };
            let place = [x.at(value), bottom + 18.0];
            pen.remark(place, anchor, text);
        }
        for &(value, text) in y_ticks {
            let height = y.at(value);
            pen.line([[left, height], [right, height]], inked(HAIR).alpha(0.18));
            let place = [left - 6.0, height + 5.0];
            pen.remark(place, End, text);
        }
        Self { x, y }
    }

    /// The legend of a column of small panels, below the last of them and, where its name leaves room, above the first.
    pub fn panel_names(&self, pen: &mut Pen, last: &Self, above: f64, [x_name, y_name]: [&str; 2]) {
        let ([left, right], [_, top]) = (self.x.ends, self.y.ends);
        let bottom = last.y.ends[0];
        let small = small(Muted);
        pen.text([left - 30.0, top - above], Start, y_name, small);
        pen.text([right, bottom + 38.0], End, x_name, small);
    }
}

/// Numbers for an axis with their texts, in a unit.
pub fn marks(values: &[f64], unit: &str) -> Vec<(f64, String)> {
    let mark = |&value: &f64| (value, brief(value) + unit);
    values.iter().map(mark).collect()
}

/// Powers of ten for an axis with their texts.
pub fn powers(exponents: impl IntoIterator<Item = i32>) -> Vec<(f64, String)> {
    let power = |exponent: i32| {
        let text = match exponent {
            0 => "1".to_owned(),
            _ => format!("10^{{{exponent}}}").replace('-', "\u{2212}"),
        };
        (10_f64.powi(exponent), text)
    };
    exponents.into_iter().map(power).collect()
}

/// Heights of labels near the wanted ones, in ascending order, at least `gap` apart and none below `lowest` on the page.
pub fn apart(wanted: &[f64], gap: f64, lowest: f64) -> Vec<f64> {
    let mut order: Vec<usize> = (0..wanted.len()).collect();
    order.sort_by(|a, b| wanted[*b].total_cmp(&wanted[*a]));
    let mut heights = wanted.to_vec();
    let mut limit = lowest;
    for k in order {
        heights[k] = wanted[k].min(limit);
        limit = heights[k] - gap;
    }
    heights
}

/// A line of data with a disc at each point.
pub fn beaded(pen: &mut Pen, line: &[Point], style: Stroke) {
    pen.line(line, style);
    for &point in line {
        pen.disc(point, 2.6, style.role(), 1.0);
    }
}
