//! The attitude at any time: by theta functions, and where those are out of reach walked (8.2).

use super::exact::{Exact, Reason};
use super::precession::Precession;
use super::taylor::{Carried, about_third};
use super::top::{KovalevskayaTop, Motion, State};
use super::walk::Walk;
use crate::error::Result;
use crate::euler_equations::TopState;
use crate::euler_top::EulerTop;
use crate::frame::{Attitude, BodyVector, SpaceVector};

/// How the attitude at a distant time is had.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum AttitudeMethod {
    /// By theta functions, at any time at the same cost: Ω and z are functions of two angles v₁, v₂ that advance evenly, and so is the azimuth of the third axis, less αt and the
    /// arguments of four theta functions θ(v − a), which is Kötter's quadrature of 1893.
    Series,
    /// z along axis 3 at the start, or a pendulum that keeps to its plane: algebraic in Ω and z, at any time at the same cost.
    Algebraic,
    /// Step by step from time 0, Ω and z in 106 bits: the motion is not separated, or the theta functions of the attitude lose digits, for this reason.
    Stepped(Reason),
    /// C = O: the exact free top of section 6.
    FreeTop,
}

impl KovalevskayaTop {
    /// Ω, z and attitude at time t (s).
    ///
    /// The angle about the vertical takes one more quadrature, by four theta functions ([`AttitudeMethod::Series`]). Cost: 1.6 µs whatever the time, after 0.05 ms of
    /// preparation at the first call. Where the theta functions are out of reach, times up to 4096 units of the motion are walked, Ω and z in 106 bits from the very doubles given: on
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

    /// Prepared when first asked for, and kept; nothing where the theta functions of the attitude lose digits.
    pub(super) fn precession(&self, exact: &Exact) -> Option<&Precession> {
        let prepare = || Precession::prepare(&self.constants, exact).map(Box::new);
        self.prepared.theta.get_or_init(prepare).as_deref()
    }

    /// How the attitude at a distant time is had. Cost: none, or that preparation.
    ///
    /// ```
    /// # use spinning_bodies::{frame::BodyVector, kovalevskaya_top::*};
    /// # let (lever, omega) = (BodyVector::new(1.0, 0.0, 0.0), BodyVector::new(1.0, 0.5, 0.3));
    /// # let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, omega, BodyVector::new(2.0, -1.0, 2.0))?;
    /// assert_eq!(top.attitude_method(), AttitudeMethod::Series);
    /// let upright = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, omega, BodyVector::new(0.0, 0.0, 1.0))?;
    /// assert_eq!(upright.attitude_method(), AttitudeMethod::Algebraic);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn attitude_method(&self) -> AttitudeMethod {
        match &self.motion {
            Motion::Free(_) => AttitudeMethod::FreeTop,
            Motion::Upright(_) | Motion::Pendulum(_) => AttitudeMethod::Algebraic,
            Motion::Stepped(reason) => AttitudeMethod::Stepped(*reason),
            Motion::Separated(exact) if self.precession(exact).is_some() => AttitudeMethod::Series,
            Motion::Separated(_) => AttitudeMethod::Stepped(Reason::DoubleRoot),
        }
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
