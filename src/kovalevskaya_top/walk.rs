//! The attitude where it has no closed form: the angle about the vertical, carried along from stretch to stretch (8.2).

use nalgebra::Quaternion;

use super::constants::{Phase, WidePhase};
use super::taylor::{Carried, Series, shortest};
use super::top::{KovalevskayaTop, LONGEST, Motion, State};
use crate::error::{Error, Result};
use crate::precise::{DoubleDouble, Number};

/// Units of time that are walked at most.
const LONGEST_WALK: f64 = 4096.0;

/// How far off a walk in doubles may have come where one in 106 bits is trusted: that one is then off by at most 2⁻⁴⁸ times as much, 1e-13.
const LOST: f64 = 28.0;

/// A place on the way, from which the next is reached.
pub(super) struct Walk<'a> {
    pub top: &'a KovalevskayaTop,
    pub time: f64,
    pub here: Carried,
    /// The same Ω and z in 106 bits.
    wide: WidePhase,
    /// By how much a walk in doubles would be off here: what rounding came to, as the motion has amplified it.
    off: Phase,
}

impl<'a> Walk<'a> {
    pub fn from_start(top: &'a KovalevskayaTop) -> Self {
        Self {
            top,
            time: 0.0,
            here: top.start,
            wide: top.wide,
            off: [0.0; 6],
        }
    }

    pub fn to(&mut self, t: f64) -> Result<State> {
        let top = self.top;
        let far = || top.inward_time(t, LONGEST);
        let carried = match &top.motion {
            Motion::Free(free) => return top.free(free, t),
            _ if t == 0.0 => top.start,
            Motion::Upright(upright) => upright.carried(&top.constants, far()?),
            Motion::Pendulum(pendulum) => pendulum.carried(far()?)?,
            Motion::Separated(separated) => separated.carried(&top.constants, far()?),
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
        let next = if step == rest || next == self.time {
            target
        } else {
            next
        };
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
