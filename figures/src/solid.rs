//! Solid bodies on paper: orthographic projection and hidden lines.

use nalgebra::{Isometry3, Vector3};
use spinning_bodies::frame::{Attitude, BodyVector};

use crate::style::*;

/// A point or a vector: m along the axes of a body or of space, z upward; or rad/s, or kg m²/s.
pub type Vector = Vector3<f64>;

/// Opacity of lines behind or inside a body.
pub const HIDDEN: f64 = 0.26;

/// An orthographic view of three-dimensional space.
#[derive(Debug, Clone, Copy)]
pub struct View {
    /// Unit vector to the right of the paper.
    pub right: Vector,
    /// Unit vector upward on the paper.
    pub up: Vector,
    /// Unit vector towards the eye.
    pub toward: Vector,
    center: Point,
    scale: f64,
}

impl View {
    /// The view from `azimuth` and `elevation` (radians) with the origin at `center` and `scale` units of the design per unit of length.
    pub fn new(azimuth: f64, elevation: f64, center: Point, scale: f64) -> Self {
        let (sa, ca) = azimuth.sin_cos();
        let (se, ce) = elevation.sin_cos();
        Self {
            right: Vector::new(-sa, ca, 0.0),
            up: Vector::new(-se * ca, -se * sa, ce),
            toward: Vector::new(ce * ca, ce * sa, se),
            center,
            scale,
        }
    }

    /// The view from `azimuth` and `elevation` with the points as large as they can be in a box (left, top, right, bottom) at
    /// not more than `most` units of the design per unit of length, centred.
    pub fn fitted(
        [azimuth, elevation]: [f64; 2],
        points: &[Vector],
        [left, top, right, bottom]: [f64; 4],
        most: f64,
    ) -> Self {
        let plain = Self::new(azimuth, elevation, [0.0; 2], 1.0);
        let places = plain.trace(points);
        let [[l, r], [t, b]] = [0, 1].map(|k| extent(places.iter().map(|place| place[k])));
        let scale = most
            .min((right - left) / (r - l))
            .min((bottom - top) / (b - t));
        let [x, y] = [0.5 * (left + right), 0.5 * (top + bottom)];
        let center = [x - 0.5 * (l + r) * scale, y - 0.5 * (t + b) * scale];
        Self::new(azimuth, elevation, center, scale)
    }

    /// The same view with this point of space at this place on the paper.
    pub fn centered_on(mut self, point: &Vector, place: Point) -> Self {
        let [x, y] = self.project(point);
        self.center[0] += place[0] - x;
        self.center[1] += place[1] - y;
        self
    }

    /// The same view of points that are given along the axes of a body which stands like this.
    pub fn along_body(mut self, stands: &Isometry3<f64>) -> Self {
        self.center = self.project(&stands.translation.vector);
        for axis in [&mut self.right, &mut self.up, &mut self.toward] {
            *axis = stands.rotation.inverse_transform_vector(axis);
        }
        self
    }

    /// Units of the design per unit of length.
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// The place at which a point of space is drawn.
    pub fn project(&self, point: &Vector) -> Point {
        let place = [dot(&self.right, point), dot(&self.up, point)];
        planned(self.center, self.scale, place)
    }

    /// The points of a curve, drawn.
    pub fn trace(&self, points: &[Vector]) -> Vec<Point> {
        points.iter().map(|p| self.project(p)).collect()
    }

    /// The curve cut where it becomes hidden: visible pieces, then hidden ones.
    pub fn split(
        &self,
        points: &[Vector],
        visible: impl Fn(&Vector) -> bool,
    ) -> [Vec<Vec<Point>>; 2] {
        let mut pieces = [Vec::new(), Vec::new()];
        let mut piece: Vec<Point> = Vec::new();
        let mut seen = true;
        for point in points {
            let here = self.project(point);
            let now = visible(point);
            if piece.is_empty() {
                seen = now;
            }
            piece.push(here);
            if now != seen {
                pieces[usize::from(!seen)].push(core::mem::replace(&mut piece, vec![here]));
                seen = now;
            }
        }
        pieces[usize::from(!seen)].push(piece);
        for piece in pieces.iter_mut().flatten() {
            straighten(piece);
        }
        pieces
    }

    /// Whether a point of a sphere about the origin is on this side of it.
    pub fn faces(&self, point: &Vector) -> bool {
        dot(point, &self.toward) > 0.0
    }

    /// The pieces of a curve on a sphere about the origin that are in front, and those behind.
    pub fn halves(&self, curve: &[Vector]) -> [Vec<Vec<Point>>; 2] {
        self.split(curve, |p| self.faces(p))
    }
}

/// The product of two vectors. This crate is compiled without optimisation (see the profile at the root), and most of what it computes are these.
pub fn dot(a: &Vector, b: &Vector) -> f64 {
    let ([a], [b]) = (a.data.0, b.data.0);
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Reduces straight pieces to their ends.
fn straighten(piece: &mut Vec<Point>) {
    let [a, .., b] = piece[..] else {
        return;
    };
    let off = |p: &Point| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    let length = distance(b, a);
    if length > 1.0 && piece.iter().all(|p| off(p).abs() < 1e-6 * length) {
        *piece = vec![a, b];
    }
}

/// `steps + 1` points from `a` to `b`.
pub fn segment(a: Vector, b: Vector, steps: u32) -> Vec<Vector> {
    let shares = spaced([0.0, 1.0], steps);
    shares.map(|share| a + (b - a) * share).collect()
}

/// The closed ellipse with conjugate semi-axes `u` and `v`.
pub fn ellipse(center: Vector, u: Vector, v: Vector, steps: u32) -> Vec<Vector> {
    let ([center], [u], [v]) = (center.data.0, u.data.0, v.data.0);
    let at = |(s, c): (f64, f64)| [0, 1, 2].map(|k| center[k] + u[k] * c + v[k] * s).into();
    let round = spaced([0.0, core::f64::consts::TAU], steps).map(f64::sin_cos);
    round.map(at).collect()
}

/// The position in space of a point of a body.
pub fn turned(attitude: &Attitude, place: Vector) -> Vector {
    let place = BodyVector::from_components(place);
    attitude.to_space(place).components()
}

/// The axes of a body, in space.
pub fn axes(attitude: &Attitude) -> [Vector; 3] {
    [Vector::x(), Vector::y(), Vector::z()].map(|axis| turned(attitude, axis))
}

/// A level circle about the vertical through the origin, at this height.
pub fn latitude(height: f64, radius: f64, steps: u32) -> Vec<Vector> {
    let [x, y, z] = [Vector::x(), Vector::y(), Vector::z()];
    ellipse(z * height, x * radius, y * radius, steps)
}

/// The outline of an ellipsoid with these semi-axes, the curve on which it is seen edge on.
pub fn rim(semi: &Vector, toward: &Vector, steps: u32) -> Vec<Vector> {
    let n = toward.component_div(semi).normalize();
    let u = n.cross(&Vector::z()).normalize();
    let sides = [u, n.cross(&u)].map(|side| side.component_mul(semi));
    ellipse(Vector::zeros(), sides[0], sides[1], steps)
}

/// Whether the line of sight from `point` to the eye meets the box with these half edges.
pub fn box_hides(half: &Vector, point: &Vector, toward: &Vector) -> bool {
    let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
    for k in 0..3 {
        let [a, b] = [-half[k], half[k]].map(|side| (side - point[k]) / toward[k]);
        enter = enter.max(a.min(b));
        leave = leave.min(a.max(b));
    }
    leave > enter && leave > 1e-6
}

/// Whether the line of sight from `point` to the eye meets the ellipsoid with these semi-axes.
pub fn ellipsoid_hides(half: &Vector, point: &Vector, toward: &Vector) -> bool {
    let [[p], [d], [half]] = [point, toward, half].map(|vector| vector.data.0);
    let [p, d] = [p, d].map(|v| Vector::new(v[0] / half[0], v[1] / half[1], v[2] / half[2]));
    let (a, b, c) = (dot(&d, &d), dot(&p, &d), dot(&p, &p) - 1.0);
    let discriminant = b * b - a * c;
    discriminant > 0.0 && -b + discriminant.sqrt() > 1e-6 * a
}

/// The corner points of the convex hull, in order.
pub fn hull(points: &[Point]) -> Vec<Point> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let half = |points: &mut dyn Iterator<Item = &Point>| {
        let mut chain: Vec<Point> = Vec::new();
        for &p in points {
            while let [.., a, b] = chain[..] {
                if (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0.0 {
                    break;
                }
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let mut hull = half(&mut sorted.iter());
    hull.extend(half(&mut sorted.iter().rev()));
    hull
}

/// Draws a body with flat faces, given by the numbers of their corners, anticlockwise as seen from outside, and the corners' positions: faces towards the eye
/// are shaded by their slope.
pub fn polyhedron(pen: &mut Pen, view: &View, faces: &[&[u32]], corner: impl Fn(u32) -> Vector) {
    let light = Vector::new(0.25, -0.55, 0.8);
    for face in faces {
        let face: Vec<Vector> = face.iter().map(|&k| corner(k)).collect();
        let normal = (face[1] - face[0]).cross(&(face[2] - face[0])).normalize();
        let outline = view.trace(&face);
        if view.faces(&normal) {
            let shade = 0.03 + 0.17 * (1.0 - normal.dot(&light)) / 2.0;
            pen.fill(&outline, Ink, shade);
            pen.outline(&outline, inked(SECONDARY));
        } else {
            pen.outline(&outline, inked(HAIR).alpha(HIDDEN));
        }
    }
}
