//! The attitude at any time: by theta functions, and where those are out of reach walked (8.2).

use super::taylor::{Carried, about_third};
use super::top::{KovalevskayaTop, State};
use super::walk::Walk;
use crate::error::Result;
use crate::euler_equations::TopState;
use crate::euler_top::EulerTop;
use crate::frame::{Attitude, BodyVector, SpaceVector};

impl KovalevskayaTop {
    /// Ω, z and attitude at time t (s).
    ///
    /// The angle about the vertical takes one more quadrature, by four theta functions. Cost: 1.6 µs whatever the time. By power series, times up to 4096 units of the motion are walked, Ω and z in 106 bits from the very doubles given: on
    /// each short stretch the attitude follows from the power series of Ω, and its tilt from z, so that only the angle collects errors; 0.4 ms a unit. Error: [`stated_error`](Self::stated_error).
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::OutOfRange`](crate::Error::OutOfRange) for |t| beyond 10⁹ units of the motion (4096 where there is no series), [as for Ω and z](Self::omega_and_up);
    /// [`Error::Integration`](crate::Error::Integration) where the motion amplifies what is rounded more than 10¹⁷ times until then, with the time at which that much is reached.
    ///
    /// ```
    /// use spinning_bodies::{frame::{BodyVector, SpaceVector}, kovalevskaya_top::KovalevskayaTop};
    /// let (lever, omega) = (BodyVector::new(1.0, 0.0, 0.0), BodyVector::new(1.0, 0.5, 0.3));
    /// let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, omega, BodyVector::new(2.0, -1.0, 2.0))?;
    /// let state = top.at(1e8)?;
    /// let up = state.attitude.to_body(SpaceVector::new(0.0, 0.0, 1.0));
    /// assert!((up - state.up).norm() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn at(&self, t: f64) -> Result<State> {
        Walk::from_start(self).to(t)
    }

    /// The states at these times, one after another; where they have to be walked to, each from the one before: best in ascending order.
    ///
    /// # Errors
    /// Each as for [`at`](Self::at).
    ///
    /// ```
    /// # use spinning_bodies::{frame::BodyVector, kovalevskaya_top::*};
    /// # let (lever, omega) = (BodyVector::new(1.0, 0.0, 0.0), BodyVector::new(1.0, 0.5, 0.3));
    /// # let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, omega, BodyVector::new(2.0, -1.0, 2.0))?;
    /// for (state, t) in top.states([1.0, 2.0]).zip([1.0, 2.0]) {
    ///     assert_eq!(state?.omega, top.omega_and_up(t)?.omega);
    /// }
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn states(
        &self,
        times: impl IntoIterator<Item = f64>,
    ) -> impl Iterator<Item = Result<State>> {
        let mut walk = Walk::from_start(self);
        times.into_iter().map(move |t| walk.to(t))
    }

    pub(super) fn free(&self, free: &EulerTop, t: f64) -> Result<State> {
        let state = free.at(self.inward_time(t, f64::MAX)?)?;
        let up = state.attitude.to_body(SpaceVector::new(0.0, 0.0, 1.0));
        Ok(self.state(state.omega * self.unit, up, state.attitude))
    }

    fn state(&self, omega: BodyVector, up: BodyVector, attitude: Attitude) -> State {
        let [x, y, z]: [f64; 3] = omega.components().into();
        State {
            omega,
            angular_momentum: BodyVector::new(2.0 * x, 2.0 * y, z) * self.axial,
            attitude,
            up,
        }
    }

    /// To the units and axes of the body.
    pub(super) fn placed(&self, (state, attitude): &Carried) -> State {
        let TopState { omega, up } = self.outward(state);
        let turned = attitude * about_third(-self.heading);
        self.state(omega, up, Attitude::from_unit(turned / turned.norm()))
    }
}
