//! The attitude where it has no closed form: the angle about the vertical, carried along from stretch to stretch (8.2).

use nalgebra::Quaternion;

use super::taylor::{Carried, Series, project};
use super::top::{KovalevskayaTop, LONGEST, Motion, State};
use crate::error::Result;

/// Units of time that are walked rather than leapt over by the series on a grid, which costs as much to prepare as this or a few times as
/// much. The choice depends on the time alone, not on what was asked for before, and so does the result.
const FAR: f64 = 256.0;

/// Units of time that are walked at most.
const LONGEST_WALK: f64 = 1e6;

/// A place on the way, from which the next is reached.
pub(super) struct Walk<'a> {
    pub top: &'a KovalevskayaTop,
    pub time: f64,
    pub here: Carried,
}

impl Walk<'_> {
    pub fn to(&mut self, t: f64) -> Result<State> {
        if let Motion::Free(free) = &self.top.motion {
            return self.top.free(free, t);
        }
        if t == 0.0 {
            return Ok(self.top.placed(&self.top.start));
        }
        if let Some(series) = self.top.theta_series() {
            return series.at(t);
        }
        let target = self.top.inward_time(t, LONGEST)?;
        if (target - self.time).abs() > FAR {
            if let Some(series) = self.top.attitude_series() {
                (self.time, self.here) = (target, series.carried(target));
            } else {
                self.top.inward_time(t, LONGEST_WALK)?;
            }
        }
        while self.time != target {
            self.stretch(target);
        }
        Ok(self.top.placed(&self.here))
    }

    fn stretch(&mut self, target: f64) {
        let constants = &self.top.constants;
        let series = Series::at(constants.c, &self.here);
        let rest = target - self.time;
        let step = rest.clamp(-series.reach, series.reach);
        let next = self.time + step;
        // A stretch too short to move the clock cannot be; if it were, this ends the walk.
        let next = if step == rest || next == self.time {
            target
        } else {
            next
        };
        let (state, [w, i, j, k]) = series.after(next - self.time);
        self.time = next;
        let state = match &self.top.motion {
            Motion::Separated(exact) => exact.state(constants, next),
            _ => project(constants, &state),
        };
        let carried = Quaternion::new(w, i, j, k);
        let carried = carried / carried.norm();
        let [.., z1, z2, z3] = state;
        // Where the body's z stands in space now it must stand upright.
        let vertical = carried * Quaternion::new(0.0, z1, z2, z3) * carried.conjugate();
        let upright = shortest([vertical.i, vertical.j, vertical.k]) * carried;
        self.here = (state, [upright.w, upright.i, upright.j, upright.k]);
    }
}

pub(super) fn about_third(angle: f64) -> Quaternion<f64> {
    let (sine, cosine) = (0.5 * angle).sin_cos();
    Quaternion::new(cosine, 0.0, 0.0, sine)
}

/// The shortest turn of a unit vector onto the third axis, as a unit quaternion; from below by way of half a turn about axis 1.
pub(super) fn shortest([x, y, z]: [f64; 3]) -> Quaternion<f64> {
    let onto = |x: f64, y: f64, z: f64| {
        let turn = Quaternion::new(1.0 + z, y, -x, 0.0);
        turn / turn.norm()
    };
    if z < 0.0 {
        onto(x, -y, -z) * Quaternion::new(0.0, 1.0, 0.0, 0.0)
    } else {
        onto(x, y, z)
    }
}
