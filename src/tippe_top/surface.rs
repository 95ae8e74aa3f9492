//! Smooth convex surfaces, described by the point at which they touch a level table.

use nalgebra::{Matrix3, Vector3};

use crate::error::{Result, each, positive, within};
use crate::frame::Attitude;

type Vector = Vector3<f64>;

/// The surface on which a body stands: a sphere, or an ellipsoid whose axes may be skew to those of inertia.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surface {
    /// A typical length, m: of a sphere the radius.
    pub(crate) size: f64,
    /// The matrix with the squares of the semi-axes as eigenvalues; `None` for a sphere.
    squares: Option<Matrix3<f64>>,
}

impl Surface {
    /// The sphere of this radius (m).
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// use spinning_bodies::tippe_top::Surface;
    /// assert!(Surface::sphere(0.02).is_ok() && Surface::sphere(0.0).is_err());
    /// ```
    pub fn sphere(radius: f64) -> Result<Self> {
        Ok(Self {
            size: positive("the radius of the surface", radius)?,
            squares: None,
        })
    }

    /// The ellipsoid with these semi-axes (m) along the body's axes.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite); the latter or [`Error::OutOfRange`](crate::Error::OutOfRange) for
    /// a semi-axis whose square no double holds to the last digits.
    ///
    /// ```
    /// use spinning_bodies::tippe_top::Surface;
    /// assert!(Surface::ellipsoid([0.2, 0.03, 0.02]).is_ok() && Surface::ellipsoid([0.2, 0.03, 0.0]).is_err());
    /// assert!(Surface::ellipsoid([1e-200; 3]).is_err() && Surface::ellipsoid([1e200; 3]).is_err());
    /// ```
    pub fn ellipsoid(semi_axes: [f64; 3]) -> Result<Self> {
        each(positive, "a semi-axis of the surface", semi_axes)?;
        let squares = Vector3::from(semi_axes).map(|axis| axis * axis);
        for &square in &squares {
            let quantity = "the square of a semi-axis of the surface";
            within(quantity, square, f64::MIN_POSITIVE, f64::MAX)?;
        }
        let size = (squares.sum() / 3.0).sqrt();
        let squares = Some(Matrix3::from_diagonal(&squares));
        Ok(Self { size, squares })
    }

    /// The same surface turned within the body: `turn` takes directions of the old surface to those of the new one.
    #[must_use]
    pub(crate) fn turned(&self, turn: &Attitude) -> Self {
        let rotation = turn.quaternion().to_rotation_matrix();
        let turned = |squares| rotation * squares * rotation.transpose();
        let squares = self.squares.map(turned);
        Self { squares, ..*self }
    }

    /// The mirror image in the plane through the first and the third axis.
    pub(crate) fn mirrored(&self) -> Self {
        let squares = self.squares.as_ref().map(mirrored);
        Self { squares, ..*self }
    }

    /// Radius (m), if the surface is a sphere.
    pub(crate) fn radius(&self) -> Option<f64> {
        self.squares.is_none().then_some(self.size)
    }

    /// The greatest distance of a point of the surface from its centre, m.
    pub(crate) fn greatest(&self) -> f64 {
        let squares = self.squares.as_ref();
        squares.map_or(self.size, |squares| squares.trace().sqrt())
    }

    /// The support map S(n): from the centre to the point whose outward normal is the unit vector n (models of tutorial 4.7).
    pub(crate) fn support(&self, n: &Vector) -> Vector {
        self.support_and_rate(n, &Vector3::zeros()).0
    }

    /// The support map, and its rate where n changes at `rate`, which is perpendicular to n.
    pub(crate) fn support_and_rate(&self, n: &Vector, rate: &Vector) -> (Vector, Vector) {
        let Some(squares) = &self.squares else {
            return (n * self.size, rate * self.size);
        };
        let image = squares * n;
        let size = n.dot(&image).sqrt();
        let support = image / size;
        let moved = squares * rate;
        let shift = support * (support.dot(rate) / size);
        (support, moved / size - shift)
    }
}

/// The matrix reflected in the plane of the first and third axis: entries odd in the second axis change sign.
pub(super) fn mirrored(matrix: &Matrix3<f64>) -> Matrix3<f64> {
    matrix.component_mul(&Matrix3::new(
        1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0,
    ))
}
