//! Torques on a body.

use super::Phase;
use crate::error::{Result, each_finite};
use crate::integrators::real::{Real, cross};

/// A torque, N m along the body's axes, as a function of the phase. Closures implement it; `()` is no torque.
pub trait Torque<T: Real> {
    /// Whether there is a torque: without one, nothing is computed for it.
    const ACTS: bool = true;

    /// The torque at this phase.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::integrators::geometric::{Phase, Torque, Weight};
    /// let start = Phase::new(BodyVector::new(0.1, 2.0, 0.3), &Attitude::identity());
    /// // z ∧ MgC for a body that stands upright.
    /// assert_eq!(Weight::new([2.0, 0.0, 0.0])?.torque(&start), [0.0, 2.0, 0.0]);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    fn torque(&self, phase: &Phase<T>) -> [T; 3];
}

impl<T: Real, F: Fn(&Phase<T>) -> [T; 3]> Torque<T> for F {
    #[inline(always)]
    fn torque(&self, phase: &Phase<T>) -> [T; 3] {
        self(phase)
    }
}

/// No torque.
impl<T: Real> Torque<T> for () {
    const ACTS: bool = false;

    #[inline(always)]
    fn torque(&self, _: &Phase<T>) -> [T; 3] {
        [T::from_double(0.0); 3]
    }
}

/// Weight: the torque z∧MgC (8.1).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weight {
    lever: [f64; 3],
}

impl Weight {
    /// The weight with the lever MgC, N m along the body's axes, C the centre of mass relative to the pivot.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// use spinning_bodies::integrators::geometric::Weight;
    /// assert!(Weight::new([0.0, 0.0, 1.0]).is_ok() && Weight::new([0.0, 0.0, f64::NAN]).is_err());
    /// ```
    pub fn new(lever: [f64; 3]) -> Result<Self> {
        each_finite("the lever MgC", lever)?;
        Ok(Self { lever })
    }
}

impl<T: Real> Torque<T> for Weight {
    #[inline(always)]
    fn torque(&self, phase: &Phase<T>) -> [T; 3] {
        cross(phase.up(), self.lever.map(T::from_double))
    }
}
