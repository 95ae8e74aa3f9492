//! The attitude at any time: in closed form, and where there is none carried along from stretch to stretch (8.2).

use nalgebra::Quaternion;

use super::constants::{Phase, WidePhase};
use super::taylor::{Carried, Series, about_third, shortest};
use super::top::{KovalevskayaTop, LONGEST, Motion, State};
use crate::error::{Error, Result};
use crate::euler_equations::TopState;
use crate::frame::{Attitude, BodyVector, SpaceVector};
use crate::precise::{DoubleDouble, Number};

impl KovalevskayaTop {
    /// Ω, z and attitude at time t (s).
    ///
    /// The angle about the vertical takes one more quadrature, by four theta functions. Cost: 1.6 µs whatever the time, 2.7 for a start with axis 3 exactly upright. By power series, times up to 4096 units of the motion are walked, Ω and z in 106 bits from the very doubles given: on
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

    /// To the units and axes of the body.
    fn placed(&self, (state, attitude): &Carried) -> State {
        let TopState { omega, up } = self.outward(state);
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

/// Units of time that are walked at most.
const LONGEST_WALK: f64 = 4096.0;

/// How far off a walk in doubles may have come where one in 106 bits is trusted: that one is then off by at most 2⁻⁴⁸ times as much, 1e-13.
const LOST: f64 = 28.0;

/// A place on the way, from which the next is reached.
struct Walk<'a> {
    top: &'a KovalevskayaTop,
    time: f64,
    here: Carried,
    /// The same Ω and z in 106 bits.
    wide: WidePhase,
    /// By how much a walk in doubles would be off here: what rounding came to, as the motion has amplified it.
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
        let carried = match &top.motion {
            _ if t == 0.0 => top.start,
            Motion::Free(free) => {
                let state = free.at(top.inward_time(t, f64::MAX)?)?;
                let up = state.attitude.to_body(SpaceVector::new(0.0, 0.0, 1.0));
                let attitude = state.attitude.quaternion().into_inner();
                let [p, q, r]: [f64; 3] = state.omega.components().into();
                ([p, q, r, up.x(), up.y(), up.z()], attitude)
            }
            Motion::Pendulum(pendulum) => pendulum.carried(top.inward_time(t, LONGEST)?)?,
            Motion::Separated(separated) => {
                separated.carried(&top.constants, top.inward_time(t, LONGEST)?)
            }
            Motion::Stepped(_) => {
                let target = top.inward_time(t, LONGEST_WALK)?;
                while self.time != target {
                    self.stretch(target)?;
                }
                self.here
            }
        };
        Ok(top.placed(&carried))
    }

    /// Towards a target as far as the series reach. Ω and z are carried in 106 bits, and beside them what a walk in doubles would be off by: what came of its rounding before, by the
    /// linear equations of a motion nearby, and the rounding of this stretch.
    fn stretch(&mut self, target: f64) -> Result<()> {
        let c = self.top.constants.c;
        let series = Series::<f64, 10>::of(c.value(), &self.here);
        let wide = Series::<DoubleDouble, 6>::of(c, &self.wide);
        let reach = wide.reach.min(series.reach);
        let rest = target - self.time;
        let step = rest.clamp(-reach, reach);
        let next = self.time + step;
        // A stretch too short to move the clock cannot be; if it were, this ends the walk.
        let last = step == rest || next == self.time;
        let next = if last { target } else { next };
        let h = DoubleDouble::difference(next, self.time);
        let (rounded, carried) = series.carried(h.value());
        let grown = series.nearby(c.value(), &self.off, h.value());
        (self.time, self.wide) = (next, wide.after(h));
        self.off = core::array::from_fn(|n| {
            grown[n] + (DoubleDouble::from(rounded[n]) - self.wide[n]).value()
        });
        if !self.off.iter().all(|x| x.abs() < LOST) {
            return Err(Error::Integration {
                reason: "rounding has been amplified 10^17 times by then, more than 106 bits allow",
                time: self.time / self.top.unit,
            });
        }
        let state = self.wide.map(DoubleDouble::value);
        let carried = carried / carried.norm();
        let [.., z1, z2, z3] = state;
        // Where the body's z stands in space now it must stand upright.
        let vertical = carried * Quaternion::new(0.0, z1, z2, z3) * carried.conjugate();
        let upright = shortest([vertical.i, vertical.j, vertical.k]) * carried;
        self.here = (state, upright);
        Ok(())
    }
}
