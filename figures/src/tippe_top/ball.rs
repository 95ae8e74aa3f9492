//! A ball with a filled cap opposite to its centre of mass.

use spinning_bodies::frame::Attitude;

use crate::prelude::*;

/// Half the angle of the cap, rad.
const CAP: f64 = 0.72;

/// A ball in the attitude given, seen slightly from above: cap, equator and one meridian turn with it.
pub fn ball(pen: &mut Pen, attitude: &Attitude, center: Point, radius: f64) {
    let view = View::new(0.6, 0.22, center, radius);
    let [e1, e2, e3] = axes(attitude);
    pen.disc(center, radius, Shade, 1.0);
    let rim = ellipse(e3 * CAP.cos(), e1 * CAP.sin(), e2 * CAP.sin(), 72);
    if rim.iter().any(|p| view.faces(p)) {
        let seen = rim.iter().map(|p| on_the_limb(&view, p, center, radius));
        pen.fill(seen, Ink, 0.55);
    }
    for (u, v) in [(e1, e2), (e1, e3)] {
        let [front, _] = view.halves(&ellipse(Vector::zeros(), u, v, 96));
        pen.lines(front, inked(HAIR).alpha(0.7));
    }
    pen.ring(center, radius, inked(AXIS));
}

/// A point of the sphere where it is seen, or radially out on the limb if it is hidden.
fn on_the_limb(view: &View, point: &Vector, center: Point, radius: f64) -> Point {
    let at = view.project(point);
    if view.faces(point) {
        return at;
    }
    between(center, at, radius / distance(at, center).max(1e-9))
}

/// The same ball cut through its upright axis: points of the cap in canvas-free units about K, y downwards.
pub fn cap_outline(radius: f64) -> Vec<Point> {
    (0..=40)
        .map(|k| CAP * (f64::from(k) / 20.0 - 1.0))
        .map(|angle| [radius * angle.sin(), -radius * angle.cos()])
        .collect()
}
