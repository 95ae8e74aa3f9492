//! The drawing of a body, and how the numbers of a motion place it.

use core::f64::consts::FRAC_PI_2;

use nalgebra::{Isometry3, Matrix3, Quaternion, UnitQuaternion, Vector3};

use crate::inertia::principal_axes_of;
use crate::scene::sight::Told;
use crate::scene::{Around, Sight, Solid};

type Vector = Vector3<f64>;

impl Solid {
    /// A ball of this radius, m.
    pub(super) fn ball(radius: f64) -> Self {
        Self::Ellipsoid(Matrix3::identity() * radius)
    }

    /// A wheel or a cylinder of this radius and width (m) about the third axis.
    pub(super) fn wheel(radius: f64, width: f64) -> Self {
        Self::Turned([-0.5, 0.5].map(|half| [half * width, radius]).into())
    }
}

/// The drawing of a body, along its axes: solids, each as it stands there.
#[derive(Debug, Clone)]
pub(super) struct Outline {
    pub drawn_as: &'static str,
    pub solids: Vec<(Solid, Isometry3<f64>)>,
}

impl Outline {
    /// A drawing of one solid about the origin.
    pub fn new(drawn_as: &'static str, solid: Solid) -> Self {
        let solids = vec![(solid, Isometry3::identity())];
        Self { drawn_as, solids }
    }

    /// The homogeneous ellipsoid with this mass and these second moments about the origin, centred at `center`, and a bar from the origin to it.
    pub fn of_inertia(second_moments: Matrix3<f64>, mass: f64, center: Vector) -> Self {
        let about_center = second_moments - center * center.transpose() * mass;
        let half = principal_axes_of(&about_center).map(|axes| {
            let half = |moment: f64| (5.0 * moment.max(0.0) / mass).sqrt();
            axes.axes * Matrix3::from_diagonal(&axes.moments.map(half).into())
        });
        let ellipsoid = Solid::Ellipsoid(half.unwrap_or_else(|_| Matrix3::identity()));
        Self::new("its ellipsoid of inertia", ellipsoid)
            .moved(center)
            .and(Solid::Bar(center), Vector::zeros())
    }

    /// Adds another solid, with its origin at this place.
    pub fn and(mut self, solid: Solid, place: Vector) -> Self {
        self.solids.push((solid, place.into()));
        self
    }

    /// The drawing moved along its axes.
    pub fn moved(mut self, by: Vector) -> Self {
        for (_, stands) in &mut self.solids {
            stands.translation.vector += by;
        }
        self
    }

    /// The picture of the body with its origin at `place`.
    pub fn sight(&self, around: Around, place: Vector, attitude: UnitQuaternion<f64>) -> Sight {
        let stands = Isometry3::from_parts(place.into(), attitude);
        let solids = self.solids.iter();
        let solids = solids.map(|(solid, within)| (solid.clone(), stands * within));
        still(self.drawn_as, around, place, solids.collect())
    }
}

/// A picture of solids without Ω and L, which [`Sight::turning`] adds.
pub(super) fn still(
    drawn_as: &'static str,
    around: Around,
    place: Vector,
    solids: Vec<(Solid, Isometry3<f64>)>,
) -> Sight {
    Sight {
        drawn_as,
        solids,
        turned: true,
        around,
        place,
        omega: Vector::zeros(),
        angular_momentum: None,
    }
}

impl Sight {
    /// Adds Ω and L along this axis.
    pub(super) fn turning(self, axis: Vector, [omega, l]: [f64; 2]) -> Self {
        Self {
            omega: axis * omega,
            angular_momentum: Some(axis * l),
            ..self
        }
    }
}

/// The picture of a body at the attitude of a row.
pub(super) fn posed(body: &Outline, around: Around, told: &Told<'_>) -> Sight {
    let [w, x, y, z] = told.vector(["qw", "qx", "qy", "qz"]);
    let attitude = UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z));
    let place = told.vector(["x", "y", "z"]);
    let omega = Vector::from(told.vector(["omega1", "omega2", "omega3"]));
    let l = Vector::from(told.vector(["lx", "ly", "lz"]));
    Sight {
        omega: attitude * omega,
        angular_momentum: told.number("lx").map(|_| l),
        ..body.sight(around, place.into(), attitude)
    }
}

/// The picture of a body that turns in the plane of x and z, about the y axis, at its position and, if known, its angle (m, rad).
///
/// The third axis of a rolling body lies along y.
pub(super) fn rolling(
    body: &Outline,
    around: Around,
    [x, z]: [f64; 2],
    angle: Option<f64>,
    told: &Told<'_>,
) -> Sight {
    let turn = about(Vector::y(), angle.unwrap_or(0.0));
    let attitude = turn * about(Vector::x(), -FRAC_PI_2);
    let mut sight = body.sight(around, Vector::new(x, 0.0, z), attitude);
    sight.turned = angle.is_some();
    sight.turning(Vector::y(), told.vector(["omega", "l"]))
}

/// The rotation about an axis by an angle, rad.
pub(super) fn about(axis: Vector, angle: f64) -> UnitQuaternion<f64> {
    UnitQuaternion::from_scaled_axis(axis * angle)
}
