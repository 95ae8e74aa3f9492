//! A ball with a dark cap opposite to its centre of mass.

use nalgebra::Vector3;
use spinning_bodies::frame::{Attitude, BodyVector};

use crate::solid::{View, ellipse};
use crate::style::*;

/// Half the angle of the cap, rad.
const CAP: f64 = 0.72;

/// The table's surface below a row of bodies.
pub fn table(pen: &mut Pen, from: f64, to: f64, y: f64) {
    pen.line(&[[from, y], [to, y]], inked(SECONDARY));
}

/// A ball in the attitude given, seen slightly from above: cap, equator and one meridian turn with it.
pub fn ball(pen: &mut Pen, attitude: &Attitude, center: Point, radius: f64, azimuth: f64) {
    let view = View::new(azimuth, 0.22, center, radius);
    let space = |x: f64, y: f64, z: f64| attitude.to_space(BodyVector::new(x, y, z)).components();
    let [e1, e2, e3] = [
        space(1.0, 0.0, 0.0),
        space(0.0, 1.0, 0.0),
        space(0.0, 0.0, 1.0),
    ];
    pen.disc(center, radius, Role::Shade, 1.0);
    let rim = ellipse(e3 * CAP.cos(), e1 * CAP.sin(), e2 * CAP.sin(), 72);
    if rim.iter().any(|p| p.dot(&view.toward) > 0.0) {
        let seen: Vec<Point> = rim
            .iter()
            .map(|p| on_the_limb(&view, p, center, radius))
            .collect();
        pen.fill(&seen, Role::Ink, 0.55);
    }
    let front = |p: &Vector3<f64>| p.dot(&view.toward) > 0.0;
    for (u, v) in [(e1, e2), (e1, e3)] {
        pen.lines(
            &view.split(&ellipse(Vector3::zeros(), u, v, 96), front)[0],
            inked(HAIR).alpha(0.7),
        );
    }
    pen.ring(center, radius, inked(AXIS));
}

/// A point of the sphere where it is seen, or radially out on the limb if it is hidden.
fn on_the_limb(view: &View, point: &Vector3<f64>, center: Point, radius: f64) -> Point {
    let [x, y] = view.project(point);
    let (dx, dy) = (x - center[0], y - center[1]);
    if point.dot(&view.toward) >= 0.0 {
        return [x, y];
    }
    let stretch = radius / dx.hypot(dy).max(1e-9);
    [center[0] + dx * stretch, center[1] + dy * stretch]
}

/// The same ball cut through its axis, the axis leaning to the right by `tilt`: points of the cap in canvas-free units about K,
/// y downwards.
pub fn cap_outline(radius: f64, tilt: f64) -> Vec<Point> {
    (0..=40)
        .map(|k| tilt + CAP * (f64::from(k) / 20.0 - 1.0))
        .map(|angle| [radius * angle.sin(), -radius * angle.cos()])
        .collect()
}
