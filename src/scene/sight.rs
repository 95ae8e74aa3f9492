//! What a scene looks like at a time: solids in their places, with the angular velocity and the angular momentum.

use nalgebra::{Isometry3, Matrix3, Vector3};

/// A simple solid along axes of its own, lengths in m.
#[derive(Debug, Clone, PartialEq)]
pub enum Solid {
    /// An ellipsoid about the origin with these half axes, the columns; it may be flat.
    Ellipsoid(Matrix3<f64>),
    /// What is turned about the third axis: heights in ascending order, each with its radius.
    Turned(Vec<[f64; 2]>),
    /// A box about the origin with these edges.
    Cuboid(Vector3<f64>),
    /// A bar from the origin, too thin to hide anything.
    Bar(Vector3<f64>),
}

/// What stands still in space beside the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Around {
    /// Points of space.
    Space,
    /// The point about which the body turns.
    Pivot,
    /// A floor at height 0.
    Floor,
    /// A floor at height 0, and a ceiling at this one, m.
    Under(f64),
    /// A string from the origin to the body.
    String,
}

/// What is to be seen of a scene at a time, along the axes of space: m, rad/s, kg m²/s, the third axis upward.
#[derive(Debug, Clone, PartialEq)]
pub struct Sight {
    /// What the body is drawn as: `a ball`.
    pub drawn_as: &'static str,
    /// The solids, and how each stands.
    pub solids: Vec<(Solid, Isometry3<f64>)>,
    /// Whether they stand as they are turned. Where only Ω is known, they stand as if nothing had turned yet.
    pub turned: bool,
    /// What stands still.
    pub around: Around,
    /// The point that is followed, and at which Ω and L begin.
    pub place: Vector3<f64>,
    /// Angular velocity Ω.
    pub omega: Vector3<f64>,
    /// Angular momentum L, if it is told.
    pub angular_momentum: Option<Vector3<f64>>,
}
