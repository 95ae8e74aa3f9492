//! Smooth convex surfaces, described by the point at which they touch a level table.

use nalgebra::{Matrix3, Vector3};

use crate::error::{Result, positive};
use crate::frame::Attitude;

/// The surface on which a body stands: a sphere, or an ellipsoid whose axes may be skew to those of inertia.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surface(Shape);

#[derive(Debug, Clone, Copy, PartialEq)]
enum Shape {
    Sphere { radius: f64 },
    Ellipsoid { squares: Matrix3<f64> },
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
        let radius = positive("the radius of the surface", radius)?;
        Ok(Self(Shape::Sphere { radius }))
    }

    /// The ellipsoid with these semi-axes (m) along the body's axes.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// use spinning_bodies::tippe_top::Surface;
    /// assert!(Surface::ellipsoid([0.2, 0.03, 0.02]).is_ok() && Surface::ellipsoid([0.2, 0.03, 0.0]).is_err());
    /// ```
    pub fn ellipsoid(semi_axes: [f64; 3]) -> Result<Self> {
        for axis in semi_axes {
            positive("a semi-axis of the surface", axis)?;
        }
        let squares = Vector3::from(semi_axes).map(|axis| axis * axis);
        Ok(Self(Shape::Ellipsoid {
            squares: Matrix3::from_diagonal(&squares),
        }))
    }

    /// The same surface turned within the body: `turn` takes directions of the old surface to those of the new one.
    #[must_use]
    pub(crate) fn turned(&self, turn: &Attitude) -> Self {
        match self.0 {
            Shape::Sphere { .. } => *self,
            Shape::Ellipsoid { squares } => {
                let rotation = turn.quaternion().to_rotation_matrix();
                Self(Shape::Ellipsoid {
                    squares: rotation * squares * rotation.transpose(),
                })
            }
        }
    }

    /// The mirror image in the plane through the first and the third axis.
    pub(crate) fn mirrored(&self) -> Self {
        match self.0 {
            Shape::Sphere { .. } => *self,
            Shape::Ellipsoid { squares } => Self(Shape::Ellipsoid {
                squares: mirrored(&squares),
            }),
        }
    }

    /// Radius (m), if the surface is a sphere.
    pub(crate) const fn radius(&self) -> Option<f64> {
        match self.0 {
            Shape::Sphere { radius } => Some(radius),
            Shape::Ellipsoid { .. } => None,
        }
    }

    /// A typical length of the surface, m.
    pub(crate) fn size(&self) -> f64 {
        match self.0 {
            Shape::Sphere { radius } => radius,
            Shape::Ellipsoid { squares } => (squares.trace() / 3.0).sqrt(),
        }
    }

    /// The greatest distance of a point of the surface from its centre, m.
    pub(crate) fn greatest(&self) -> f64 {
        match self.0 {
            Shape::Sphere { radius } => radius,
            Shape::Ellipsoid { squares } => squares.trace().sqrt(),
        }
    }

    /// The support map S(n): from the centre to the point whose outward normal is the unit vector n (models of tutorial 4.7).
    pub(crate) fn support(&self, n: &Vector3<f64>) -> Vector3<f64> {
        self.support_and_rate(n, &Vector3::zeros()).0
    }

    /// The support map, and its rate where n changes at `rate`, which is perpendicular to n.
    pub(crate) fn support_and_rate(
        &self,
        n: &Vector3<f64>,
        rate: &Vector3<f64>,
    ) -> (Vector3<f64>, Vector3<f64>) {
        match self.0 {
            Shape::Sphere { radius } => (n * radius, rate * radius),
            Shape::Ellipsoid { squares } => {
                let image = squares * n;
                let size = n.dot(&image).sqrt();
                let support = image / size;
                let moved = squares * rate;
                let shift = support * (support.dot(rate) / size);
                (support, moved / size - shift)
            }
        }
    }
}

/// The matrix reflected in the plane of the first and third axis: entries odd in the second axis change sign.
pub(super) fn mirrored(matrix: &Matrix3<f64>) -> Matrix3<f64> {
    matrix.component_mul(&Matrix3::new(
        1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0,
    ))
}
