//! The attitude at any time: in closed form, or where there is none by power series, step by step (8.2).

use nalgebra::Quaternion;

use super::constants::{Phase, WidePhase};
use super::taylor::{FullState, about_third, coefficients, full_state, series, shortest};
use super::top::{KovalevskayaTop, LONGEST, Motion, State};
use crate::error::{Result, stopped};
use crate::euler_equations::{Series, TopState};
use crate::frame::{Attitude, BodyVector, SpaceVector};
use crate::precise::{DoubleDouble, Number};

impl KovalevskayaTop {
    /// Ω, z and attitude at time t (s).
    ///
    /// The angle about the vertical takes one more quadrature, by four theta functions. Cost: 1.6 µs whatever the time, 2.7 for a start with axis 3 exactly upright. Where there is no closed form, power series go step by step, up to 4096 units of the motion, with Ω and z in 106 bits from the exact doubles given. In
    /// each step the attitude follows from the series of Ω, and its tilt is corrected by z, so that only the azimuth accumulates errors; 0.4 ms a unit. Error: [`stated_error`](Self::stated_error).
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::OutOfRange`](crate::Error::OutOfRange) for |t| beyond 10⁹ units of the motion (4096 where there is no series), [as for Ω and z](Self::omega_and_up);
    /// [`Error::Integration`](crate::Error::Integration) if the motion has amplified rounding more than 10¹⁷ times by then, with the time at which it does.
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

    /// The states at these times, one after another. Power series go on from one time to the next, so ascending order is best.
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

    /// Converts a state to SI units and the body's axes.
    fn restored(&self, (state, attitude): &FullState) -> State {
        let TopState { omega, up } = self.restored_state(state);
        let turned = attitude * about_third(-self.heading);
        State {
            omega,
            angular_momentum: BodyVector::new(2.0 * omega.x(), 2.0 * omega.y(), omega.z())
                * self.axial,
            attitude: Attitude::from_unit(turned / turned.norm()),
            up,
        }
    }
}

/// The longest time, in units of the motion, that power series follow.
const LONGEST_WALK: f64 = 4096.0;

/// The greatest error of a walk in doubles up to which a walk in 106 bits is trusted: its error is then at most 2⁻⁴⁸ times this, 1e-13.
const LOST: f64 = 28.0;

/// A state on the way through time, from which the next is reached by power series.
struct Walk<'a> {
    top: &'a KovalevskayaTop,
    time: f64,
    here: FullState,
    /// The same Ω and z in 106 bits.
    wide: WidePhase,
    /// The error that a walk in doubles would have here: its rounding, amplified by the motion.
    off: Phase,
}

impl<'a> Walk<'a> {
    fn from_start(top: &'a KovalevskayaTop) -> Self {
        Self {
            top,
            time: 0.0,
            here: top.start,
            wide: top.wide,
            off: [0.0; 6],
        }
    }

    fn to(&mut self, t: f64) -> Result<State> {
        let top = self.top;
        let state = match &top.motion {
            _ if t == 0.0 => top.start,
            Motion::Free(free) => {
                let state = free.at(top.scaled_time(t, f64::MAX)?)?;
                let up = state.attitude.to_body(SpaceVector::new(0.0, 0.0, 1.0));
                let attitude = state.attitude.quaternion().into_inner();
                let [p, q, r]: [f64; 3] = state.omega.components().into();
                ([p, q, r, up.x(), up.y(), up.z()], attitude)
            }
            Motion::Pendulum(pendulum) => pendulum.full_state(top.scaled_time(t, LONGEST)?)?,
            Motion::Separated(separated) => {
                separated.full_state(&top.constants, top.scaled_time(t, LONGEST)?)
            }
            Motion::Stepped(_) => {
                let target = top.scaled_time(t, LONGEST_WALK)?;
                while self.time != target {
                    self.stretch(target)?;
                }
                self.here
            }
        };
        Ok(top.restored(&state))
    }

    /// Goes towards a target time as far as the series converge. Ω and z are carried in 106 bits, together with the error of a walk in doubles: its earlier rounding, propagated by the
    /// linearised equations, plus the rounding of this stretch.
    fn stretch(&mut self, target: f64) -> Result<()> {
        let c = self.top.constants.c;
        let series = series(c.value(), &self.here);
        let wide = Series::about(&coefficients(c), self.wide, 36, 1e-33);
        let reach = wide.reach.min(series.reach);
        let rest = target - self.time;
        let step = rest.clamp(-reach, reach);
        let next = self.time + step;
        // A stretch too short to advance the time cannot occur; if it did, this would end the walk.
        let last = step == rest || next == self.time;
        let next = if last { target } else { next };
        let h = DoubleDouble::difference(next, self.time);
        let (rounded, attitude) = full_state(&series, h.value());
        let grown = series.nearby(&coefficients(c.value()), &self.off, h.value());
        (self.time, self.wide) = (next, wide.after(h));
        self.off = core::array::from_fn(|n| {
            grown[n] + (DoubleDouble::from(rounded[n]) - self.wide[n]).value()
        });
        if !self.off.iter().all(|x| x.abs() < LOST) {
            let reason =
                "the motion has amplified rounding 10^17 times by then, more than 106 bits allow";
            return stopped(reason, self.time / self.top.unit);
        }
        let state = self.wide.map(DoubleDouble::value);
        let attitude = attitude / attitude.norm();
        let [.., z1, z2, z3] = state;
        // z, carried into space by this attitude, must be vertical.
        let vertical = attitude * Quaternion::new(0.0, z1, z2, z3) * attitude.conjugate();
        let upright = shortest([vertical.i, vertical.j, vertical.k]) * attitude;
        self.here = (state, upright);
        Ok(())
    }
}
