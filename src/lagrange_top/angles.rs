//! Tilt, precession and spin as angles (7.1): for drawing and for reading, not for computing.

use super::evaluation::State;
use super::kinds::Roots;
use super::motion::LagrangeTop;
use crate::frame::EulerAngles;

impl State {
    /// θ, φ, ψ in radians (7.1).
    ///
    /// θ keeps its digits next to 0 and π, from 1 ∓ h. There only φ + ψ, or φ − ψ, means anything: it is exact to rounding, while their
    /// difference, or sum, loses what the attitude has lost of it; with θ = 0 or π exactly it counts as zero. Cost: three arctangents.
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, lagrange_top::LagrangeTop};
    /// let tilted = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), 0.5)?;
    /// let top = LagrangeTop::new(1.0, 0.5, 1.0, BodyVector::new(0.0, 0.0, 9.0), tilted)?;
    /// let angles = top.at(0.0)?.angles();
    /// assert!((angles.theta - 0.5).abs() < 1e-15 && angles.phi.abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn angles(&self) -> EulerAngles {
        EulerAngles {
            theta: tilt(self.one_less, self.one_more),
            ..self.attitude.euler_angles()
        }
    }
}

impl LagrangeTop {
    /// The two tilts between which the axis moves, radians, the smaller first (7.2); equal where the tilt stays.
    pub fn turning_angles(&self) -> [f64; 2] {
        let Roots {
            one_less, one_more, ..
        } = self.roots();
        // With gravity upwards the roots are those of −h.
        if self.pulls_up() {
            [
                tilt(one_more[0], one_less[0]),
                tilt(one_more[1], one_less[1]),
            ]
        } else {
            [
                tilt(one_less[1], one_more[1]),
                tilt(one_less[0], one_more[0]),
            ]
        }
    }
}

/// The angle whose cosine is h, from 1 − h and 1 + h.
fn tilt(one_less: f64, one_more: f64) -> f64 {
    2.0 * one_less.sqrt().atan2(one_more.sqrt())
}
