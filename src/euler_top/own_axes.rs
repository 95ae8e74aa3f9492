//! A free body along axes of its own, which need not be principal ones (tutorial 2.3, 6.6).

use nalgebra::UnitQuaternion;

use super::evaluation::State;
use super::motion::EulerTop;
use crate::error::Result;
use crate::frame::{Attitude, BodyVector};
use crate::inertia::InertiaMatrix;

/// A free body of any inertia matrix, its motion prepared: [`EulerTop`] inside, Ω, L and attitude along the axes of the matrix outside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeBody {
    principal: EulerTop,
    /// Turns components along the principal axes into those along the body's own.
    own: UnitQuaternion<f64>,
}

impl FreeBody {
    /// The body with this inertia matrix about its centre of mass (kg m²), with this Ω (rad/s) and this attitude at time 0, all along its own axes (2.3, 6.6).
    ///
    /// Error: that of [`EulerTop`], and a rounding or two of the principal moments, which the angle turned multiplies. Cost: [`EulerTop::new`] and
    /// [`InertiaMatrix::principal_axes`]; a state costs that of [`EulerTop::at`] and three turns.
    ///
    /// # Errors
    /// As for [`EulerTop::from_omega`].
    ///
    /// ```
    /// use nalgebra::Matrix3;
    /// use spinning_bodies::{euler_top::FreeBody, frame::{Attitude, BodyVector}, inertia::InertiaMatrix};
    /// let matrix = Matrix3::new(2.0, -0.5, 0.1, -0.5, 2.5, 0.3, 0.1, 0.3, 3.0);
    /// let inertia = InertiaMatrix::from_matrix(matrix)?;
    /// let body = FreeBody::new(&inertia, BodyVector::new(1.0, -2.0, 0.5), Attitude::identity())?;
    /// let state = body.at(10.0)?;
    /// let l = inertia.angular_momentum(state.omega);
    /// assert!((l - state.angular_momentum).norm() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(inertia: &InertiaMatrix, omega: BodyVector, attitude: Attitude) -> Result<Self> {
        let axes = inertia.principal_axes();
        let own = axes.turn();
        // From Ω, not from L: what rounding leaves of a rod's own moment is next to nothing to divide by.
        let omega = own.inverse_transform_vector(&omega.components());
        let principal = EulerTop::from_omega(
            axes.principal_moments().values(),
            BodyVector::from_components(omega),
            attitude * Attitude::from(own),
        )?;
        Ok(Self { principal, own })
    }

    /// The motion along the principal axes: period, regime, integrals.
    pub const fn principal(&self) -> &EulerTop {
        &self.principal
    }

    /// Ω, L and attitude at time t (s), of the body's own axes (6.6, 6.8).
    ///
    /// # Errors
    /// As for [`EulerTop::at`].
    pub fn at(&self, t: f64) -> Result<State> {
        let state = self.principal.at(t)?;
        let outward = |v: BodyVector| BodyVector::from_components(self.own * v.components());
        Ok(State {
            omega: outward(state.omega),
            angular_momentum: outward(state.angular_momentum),
            attitude: state.attitude * Attitude::from(self.own.inverse()),
        })
    }
}
