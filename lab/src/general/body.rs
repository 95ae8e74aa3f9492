//! General methods applied to the motion of a body.

use spinning_bodies::Result;
use spinning_bodies::euler_equations::{AxisMoments, quaternion_rate};
use spinning_bodies::frame::BodyVector;
use spinning_bodies::integrators::geometric::{Phase, Torque};
use spinning_bodies::integrators::{Effort, Method, Solution, System};

use super::Run;
use crate::follow::Follow;

/// A body under a torque, followed by a general method as a system of seven equations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GeneralMethod<N> {
    moments: [f64; 3],
    torque: N,
    method: Method,
}

impl<N> GeneralMethod<N> {
    /// The method for a body with these moments, kg m², under this torque.
    ///
    /// # Errors
    /// Those of an invalid moment.
    pub fn new([i1, i2, i3]: [f64; 3], torque: N, method: Method) -> Result<Self> {
        Ok(Self {
            moments: AxisMoments::new(i1, i2, i3)?.values(),
            torque,
            method,
        })
    }
}

/// The order of a method with steps of one length; `None` where a tolerance chooses the steps, so that the order does not show.
pub const fn order(method: Method) -> Option<u32> {
    match method {
        Method::Rk4 => Some(4),
        Method::Gauss => Some(6),
        _ => None,
    }
}

impl<N: Torque<f64>> System<7> for GeneralMethod<N> {
    /// L′ = L∧Ω + N and q′ = ½qΩ.
    fn rate(&self, _: f64, y: &[f64; 7]) -> [f64; 7] {
        let [a, b, c, w, x, y, z] = *y;
        let phase = Phase {
            l: [a, b, c],
            q: [w, x, y, z],
        };
        let [i1, i2, i3] = self.moments;
        let [o1, o2, o3] = [a / i1, b / i2, c / i3];
        let [n1, n2, n3] = self.torque.torque(&phase);
        let [qw, qx, qy, qz] = quaternion_rate(phase.q, BodyVector::new(o1, o2, o3));
        let r1 = (i2 - i3) * o2 * o3 + n1;
        let r2 = (i3 - i1) * o3 * o1 + n2;
        let r3 = (i1 - i2) * o1 * o2 + n3;
        [r1, r2, r3, qw, qx, qy, qz]
    }
}

/// Compiled here, once for all torques.
#[inline(never)]
fn solved(run: Run<'_, 7>, start: &[f64; 7], times: &[f64]) -> Result<Solution<[f64; 7]>> {
    run.solve(start, times)
}

impl<N: Torque<f64> + core::fmt::Debug> Follow for GeneralMethod<N> {
    fn name(&self) -> String {
        self.method.name().to_owned()
    }

    fn order(&self) -> Option<u32> {
        order(self.method)
    }

    fn follow(&self, start: &Phase, times: &[f64], effort: Effort) -> Result<Solution<Phase>> {
        let [a, b, c] = start.l;
        let q = start.attitude()?.quaternion();
        let packed = [a, b, c, q.w, q.i, q.j, q.k];
        let size = a.hypot(b).hypot(c).max(f64::MIN_POSITIVE);
        let scales = [size, size, size, 1.0, 1.0, 1.0, 1.0];
        let run = solved(Run::new(self, &scales, self.method, effort), &packed, times)?;
        let phases = run.states.iter().map(|y| Phase {
            l: [y[0], y[1], y[2]],
            q: [y[3], y[4], y[5], y[6]],
        });
        Ok(Solution {
            states: phases.collect(),
            cost: run.cost,
        })
    }
}
