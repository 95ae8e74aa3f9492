//! Routh's rule (tutorial 2.7): divide the sum of squares of the perpendicular semi-axes by 3, 4 or 5.
//!
//! Three for rectangles and boxes, four for ellipses, five for ellipsoids. The reason is
//! [`mean_square`]: over a homogeneous ellipsoid of d dimensions the mean of x² is a²/(d+2). A rod is
//! such an ellipsoid with d = 1, a disc with d = 2, a ball with d = 3. A product of bodies adds one term for each
//! factor, so a box gets three for every axis, and a cylinder gets four for its round directions and three along
//! its axis: that is why no single denominator serves the cylinder.

use crate::error::{Error, Result, finite, not_negative, positive, within};

/// A kind of homogeneous body, which Routh's rule covers or not.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Form {
    /// A straight thin rod, about an axis across it.
    Rod,
    /// A rectangular lamina, about an axis along an edge direction or the normal.
    Rectangle,
    /// A solid box, about an axis along an edge direction.
    Cuboid,
    /// An elliptic or circular lamina, about an axis of the ellipse or the normal.
    Ellipse,
    /// A solid cylinder, circular or elliptic, about its own axis (a stack of ellipses).
    CylinderAboutItsAxis,
    /// A solid ellipsoid or ball, about an axis of the ellipsoid.
    Ellipsoid,
    /// A cylinder about an axis across it: round in one direction, straight in the other.
    CylinderAcross,
    /// Anything hollow: a spherical shell, a hoop, the faces of a box.
    Hollow,
    /// A cone or a pyramid.
    Cone,
    /// A triangular lamina.
    Triangle,
}

impl Form {
    /// The denominator 3, 4 or 5, or an error for a body that the rule does not cover (2.7).
    const fn denominator(self) -> Result<u32> {
        let body = match self {
            Self::Rod | Self::Rectangle | Self::Cuboid => return Ok(3),
            Self::Ellipse | Self::CylinderAboutItsAxis => return Ok(4),
            Self::Ellipsoid => return Ok(5),
            Self::CylinderAcross => {
                "a cylinder about an axis across it, which is round in one direction and straight in the other"
            }
            Self::Hollow => "a hollow body",
            Self::Cone => "a cone",
            Self::Triangle => "a triangle",
        };
        Err(Error::RouthDoesNotApply { body })
    }
}

/// Moment of inertia by Routh's rule, kg m²: M(b² + c²)/3, /4 or /5 (2.7).
///
/// `semi_axes` are the two half-extents perpendicular to the axis, m; zero where the body has no extent (a rod,
/// or a lamina about an axis in its plane). The axis must be an axis of symmetry through the centre and parallel to
/// one of the semi-axes: about the diagonal of a square the rule does not hold. Error 3 ulp.
///
/// # Errors
/// [`Error::RouthDoesNotApply`] for a form without a denominator; [`Error::NotPositive`] for the mass,
/// [`Error::Negative`] for a semi-axis, [`Error::NotFinite`] for either or on overflow.
///
/// ```
/// use spinning_bodies::inertia::routh::{Form, moment};
/// assert_eq!(moment(1.0, Form::Ellipsoid, [1.0, 1.0])?, 2.0 / 5.0);
/// assert!(moment(1.0, Form::Hollow, [1.0, 1.0]).is_err());
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn moment(mass: f64, form: Form, semi_axes: [f64; 2]) -> Result<f64> {
    let denominator = f64::from(form.denominator()?);
    positive("the mass", mass)?;
    let mut sum = 0.0;
    for a in semi_axes {
        sum += (mass * (not_negative("a semi-axis", a)? / denominator)) * a;
    }
    finite("the moment of inertia", sum)
}

/// Mean of x² over a homogeneous ellipsoid of `dimension` dimensions, m²: a²/(d+2) (2.7).
///
/// `semi_axis` is a, the half-extent along x. Error 1.5 ulp.
///
/// # Errors
/// [`Error::Negative`] or [`Error::NotFinite`] for the semi-axis or on overflow; [`Error::OutOfRange`] for dimension 0.
///
/// ```
/// use spinning_bodies::inertia::routh::mean_square;
/// assert_eq!(mean_square(1.0, 3)?, 1.0 / 5.0);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn mean_square(semi_axis: f64, dimension: u32) -> Result<f64> {
    not_negative("the semi-axis", semi_axis)?;
    let dimension = within("the dimension", dimension.into(), 1.0, u32::MAX.into())?;
    finite("the mean square", semi_axis / (dimension + 2.0) * semi_axis)
}
