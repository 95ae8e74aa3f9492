//! A frame with two axes.

use crate::style::{AXIS, Anchor, Pen, Point, Role, Stroke, label, small, stroke};

/// A rectangle of the design and the numbers at its sides.
#[derive(Debug, Clone, Copy)]
pub struct Frame {
    /// Left, right, bottom and top, units.
    pub sides: [f64; 4],
    /// What is at the left and at the right.
    pub x: [f64; 2],
    /// What is at the bottom and at the top.
    pub y: [f64; 2],
}

impl Frame {
    /// Where a point is drawn.
    pub fn at(&self, x: f64, y: f64) -> Point {
        let [left, right, bottom, top] = self.sides;
        [
            left + (right - left) * (x - self.x[0]) / (self.x[1] - self.x[0]),
            bottom - (bottom - top) * (y - self.y[0]) / (self.y[1] - self.y[0]),
        ]
    }

    /// A curve, as far as it lies within the frame.
    pub fn curve(&self, pen: &mut Pen, points: impl Iterator<Item = (f64, f64)>, style: Stroke) {
        let slack = 1e-9 * (self.y[1] - self.y[0]);
        let inside = |y: f64| y >= self.y[0] - slack && y <= self.y[1] + slack;
        let all: Vec<(f64, f64)> = points.collect();
        for piece in all.split(|p| !inside(p.1)) {
            let drawn: Vec<Point> = piece.iter().map(|&(x, y)| self.at(x, y)).collect();
            pen.line(&drawn, style);
        }
    }

    /// Both axes with their ticks; an empty text is a tick without a number.
    pub fn axes(&self, pen: &mut Pen, across: &[(f64, &str)], up: &[(f64, &str)]) {
        let ink = stroke(Role::Ink, AXIS);
        let [left, right, bottom, top] = self.sides;
        pen.line(&[[left, top], [left, bottom], [right, bottom]], ink);
        for &(x, text) in across {
            let [x, _] = self.at(x, self.y[0]);
            pen.line(&[[x, bottom], [x, bottom + 5.0]], ink);
            pen.text([x, bottom + 21.0], Anchor::Middle, text, small(Role::Ink));
        }
        for &(y, text) in up {
            let [_, y] = self.at(self.x[0], y);
            pen.line(&[[left - 5.0, y], [left, y]], ink);
            pen.text([left - 9.0, y + 5.0], Anchor::End, text, small(Role::Ink));
        }
    }

    /// What the axes mean.
    pub fn names(&self, pen: &mut Pen, across: &str, up: &str) {
        let [left, right, bottom, top] = self.sides;
        pen.text(
            [right, bottom + 43.0],
            Anchor::End,
            across,
            label(Role::Ink),
        );
        pen.text(
            [left + 10.0, top + 4.0],
            Anchor::Start,
            up,
            label(Role::Ink),
        );
    }
}
