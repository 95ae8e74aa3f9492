//! The attitude at any time: by theta functions, and where those are out of reach walked (8.2).

use nalgebra::Quaternion;

use super::exact::{Exact, Reason};
use super::precession::Precession;
use super::taylor::{Carried, about_third};
use super::top::{KovalevskayaTop, LONGEST, Motion, State};
use super::walk::Walk;
use crate::error::Result;
use crate::euler_equations::TopState;
use crate::euler_top::EulerTop;
use crate::frame::{Attitude, BodyVector, SpaceVector};

/// How the attitude at a distant time is had.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum AttitudeMethod {
    /// By [`AttitudeSeries`], at any time at the same cost.
    Series,
    /// z along axis 3 at the start, or a pendulum that keeps to its plane: algebraic in Ω and z, at any time at the same cost.
    Algebraic,
    /// Step by step from time 0, Ω and z in 106 bits: the motion is not separated, or the theta functions of the attitude lose digits, for this reason.
    Stepped(Reason),
    /// C = O: the exact free top of section 6.
    FreeTop,
}

/// Ω, z and the attitude of a separated motion at any time at the same cost (8.2).
///
/// Ω and z are functions of two angles v₁, v₂ that advance evenly, and so is the azimuth of the third axis, less αt and the arguments of four theta functions θ(v − a):
/// this is Kötter's quadrature of 1893. The sums have 260 terms in the median of 100 random starts, 850 in the worst, since the terms fall like a Gauss curve.
/// The constants a come from one integral to the point s = l² − l₁ of the curve w² = P(s), l and l₁ being L_vert/2 and E/3 in units of I₃, and α = l − ½ (a mean).
///
/// The error is in proportion to time, [as that of Ω and z](super).
#[derive(Debug, Clone, Copy)]
pub struct AttitudeSeries<'a> {
    top: &'a KovalevskayaTop,
    exact: &'a Exact,
    precession: &'a Precession,
}

impl AttitudeSeries<'_> {
    /// Ω, z and attitude at time t (s), short or long.
    ///
    /// Cost: [`omega_and_up`](KovalevskayaTop::omega_and_up) and 3 ns a term: 2 µs in the median of 200 random starts, 3 µs at most in 95 per cent, 5 µs in the worst.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::OutOfRange`](crate::Error::OutOfRange) for |t| beyond 10⁹ units of the motion.
    ///
    /// ```
    /// # use spinning_bodies::{frame::BodyVector, kovalevskaya_top::*};
    /// # let (lever, omega) = (BodyVector::new(1.0, 0.0, 0.0), BodyVector::new(1.0, 0.5, 0.3));
    /// # let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, omega, BodyVector::new(2.0, -1.0, 2.0))?;
    /// let series = top.attitude_series().expect("theta functions");
    /// let state = series.at(1e6)?;
    /// let up = state.attitude.to_space(state.up);
    /// assert!((up - spinning_bodies::frame::SpaceVector::new(0.0, 0.0, 1.0)).norm() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn at(&self, t: f64) -> Result<State> {
        let time = self.top.inward_time(t, LONGEST)?;
        Ok(self.top.placed(&self.carried(time)))
    }

    pub(super) fn carried(&self, time: f64) -> Carried {
        self.precession
            .carried(&self.top.constants, self.exact, time)
    }

    /// c₀, the mean rate at which the body goes round the vertical, rad/s.
    ///
    /// It is the rate of the third axis, if that is never vertical. Otherwise whole multiples of half the two
    /// [`frequencies`](KovalevskayaTop::frequencies) (times 2π) may be added to c₀, since a body that passes through the vertical can be counted as going round
    /// on either side; this is the rate of the direction from which the third axis goes round least on the torus.
    ///
    /// ```
    /// # use spinning_bodies::{frame::BodyVector, kovalevskaya_top::*};
    /// # let (lever, omega) = (BodyVector::new(1.0, 0.0, 0.0), BodyVector::new(1.0, 0.5, 0.3));
    /// # let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, omega, BodyVector::new(2.0, -1.0, 2.0))?;
    /// let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, BodyVector::new(0.1, 0.2, 3.0), BodyVector::new(0.95, 0.1, 0.3))?;
    /// let series = top.attitude_series().expect("theta functions");
    /// let azimuth = |t: f64| {
    ///     let axis = series.at(t)?.attitude.to_space(BodyVector::new(0.0, 0.0, 1.0));
    ///     Ok::<f64, spinning_bodies::Error>(axis.y().atan2(axis.x()))
    /// };
    /// let (mut turned, tau) = (0.0, std::f64::consts::TAU);
    /// for n in 0..4000 {
    ///     let step = azimuth(0.05 * f64::from(n + 1))? - azimuth(0.05 * f64::from(n))?;
    ///     turned += step - tau * (step / tau).round();
    /// }
    /// assert!((turned / 200.0 - series.mean_precession_rate()).abs() < 0.02);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn mean_precession_rate(&self) -> f64 {
        self.precession.mean() * self.top.unit
    }
}

impl KovalevskayaTop {
    /// Ω, z and attitude at time t (s).
    ///
    /// The angle about the vertical takes one more quadrature, by [`attitude_series`](Self::attitude_series). Cost: 2 µs whatever the time, after 0.06 ms of
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

    /// Ω, z and attitude at any time at the same cost; nothing where [`attitude_method`](Self::attitude_method) is another.
    ///
    /// Prepared when first asked for, and kept. Cost, over 200 random starts: 0.06 ms in the median, 0.11 ms at most in 95 per cent, 0.2 ms in the worst.
    ///
    /// ```
    /// # use spinning_bodies::{frame::BodyVector, kovalevskaya_top::*};
    /// # let (lever, omega) = (BodyVector::new(1.0, 0.0, 0.0), BodyVector::new(1.0, 0.5, 0.3));
    /// # let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, omega, BodyVector::new(2.0, -1.0, 2.0))?;
    /// assert!(top.attitude_series().is_some());
    /// let upright = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, omega, BodyVector::new(0.0, 0.0, 1.0))?;
    /// assert!(upright.attitude_series().is_none());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn attitude_series(&self) -> Option<AttitudeSeries<'_>> {
        let exact = self.separated()?;
        let prepare = || Precession::prepare(&self.constants, exact).map(Box::new);
        let precession = self.prepared.theta.get_or_init(prepare).as_deref()?;
        Some(AttitudeSeries {
            top: self,
            exact,
            precession,
        })
    }

    /// How the attitude at a distant time is had. Cost: that of [`attitude_series`](Self::attitude_series).
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
            Motion::Separated(_) if self.attitude_series().is_some() => AttitudeMethod::Series,
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
    pub(super) fn placed(&self, (state, [w, i, j, k]): &Carried) -> State {
        let TopState { omega, up } = self.outward(state);
        let turned = Quaternion::new(*w, *i, *j, *k) * about_third(-self.heading);
        self.state(omega, up, Attitude::from_unit(turned / turned.norm()))
    }
}
