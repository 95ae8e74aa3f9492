//! What a scene looks like at one time: solids with their positions, the angular velocity and the angular momentum.

use nalgebra::{Isometry3, Matrix3, Vector3};

#[cfg(feature = "scene-files")]
use super::columns::Column;

/// A simple solid along axes of its own, lengths in m.
#[derive(Debug, Clone, PartialEq)]
pub enum Solid {
    /// An ellipsoid about the origin whose semi-axes are the columns; one of them may be 0.
    Ellipsoid(Matrix3<f64>),
    /// A body of revolution about the third axis: heights in ascending order, each with its radius.
    Turned(Vec<[f64; 2]>),
    /// A box about the origin with these edges.
    Cuboid(Vector3<f64>),
    /// A bar from the origin to this point, too thin to hide anything.
    Bar(Vector3<f64>),
}

/// What is drawn at rest beside the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Around {
    /// Points of space, nothing else.
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

/// The picture of a scene at one time, along the axes of space, the third upward: m, rad/s, kg m²/s.
#[derive(Debug, Clone, PartialEq)]
pub struct Sight {
    /// A name for the drawing: `a ball`.
    pub drawn_as: &'static str,
    /// The solids, each with its position.
    pub solids: Vec<(Solid, Isometry3<f64>)>,
    /// Whether the attitude is known. Where only Ω is, the solids stand as at the start.
    pub turned: bool,
    /// What is drawn at rest.
    pub around: Around,
    /// The point that the picture follows and from which Ω and L are drawn.
    pub place: Vector3<f64>,
    /// Angular velocity Ω.
    pub omega: Vector3<f64>,
    /// Angular momentum L, if the scene gives it.
    pub angular_momentum: Option<Vector3<f64>>,
}

/// The numbers of a row, by the names of their columns.
#[cfg(feature = "scene-files")]
#[derive(Debug)]
pub(super) struct Told<'a> {
    pub columns: &'a [Column],
    pub row: &'a [f64],
}

#[cfg(feature = "scene-files")]
impl Told<'_> {
    /// The number in the column with this name, if there is one.
    pub fn number(&self, name: &str) -> Option<f64> {
        let place = self.columns.iter().position(|column| column.name == name)?;
        self.row.get(place).copied()
    }

    /// The numbers in the columns with these names; 0 for a missing column.
    pub fn vector<const N: usize>(&self, names: [&str; N]) -> [f64; N] {
        names.map(|name| self.number(name).unwrap_or(0.0))
    }
}

/// The picture of a scene as a function of the numbers in a row.
#[cfg(feature = "scene-files")]
pub(super) type Look = Box<dyn Fn(&Told<'_>) -> Sight + Send + Sync>;
