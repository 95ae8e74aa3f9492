//! Dormand's and Prince's method of order 8 with nothing around it: arrays on the stack, equations compiled into the step.

use super::{Course, Follow, Phase, Torque, checked_moments, unit};
use crate::error::Result;
use crate::euler_equations::quaternion_rate;
use crate::frame::BodyVector;
use crate::integrators::{Effort, Kept, System, order_eight};

/// [`order_eight`] for a turning body under a torque: L and the attitude's quaternion, which keeps norm 1.
///
/// Explicit, neither symmetric nor symplectic: energy and L drift like the error, in proportion to the time. With [`Effort::Tolerance`] the
/// error of a step is judged relative to |L| and in the quaternion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DormandPrince8<N> {
    inverse: [f64; 3],
    /// (I₂ − I₃)/(I₂I₃) and so on: L₁′ is this times L₂L₃, nearly equal moments lose nothing.
    difference: [f64; 3],
    torque: N,
}

impl<N> DormandPrince8<N> {
    /// For the body with these moments under this torque.
    ///
    /// # Errors
    /// Those of the moments.
    pub fn new(moments: [f64; 3], torque: N) -> Result<Self> {
        let moments = checked_moments(moments)?;
        Ok(Self {
            inverse: moments.map(|moment| 1.0 / moment),
            difference: core::array::from_fn(|k| {
                let (a, b) = (moments[(k + 1) % 3], moments[(k + 2) % 3]);
                (a - b) / a / b
            }),
            torque,
        })
    }
}

impl<N: Torque<f64>> System<7> for DormandPrince8<N> {
    /// L′ = L∧Ω + N and q′ = ½qΩ.
    #[inline(always)]
    fn rate(&self, _: f64, y: &[f64; 7]) -> [f64; 7] {
        let [a, b, c, w, x, y, z] = *y;
        let phase = Phase {
            l: [a, b, c],
            q: [w, x, y, z],
        };
        let [d1, d2, d3] = self.difference;
        let [j1, j2, j3] = self.inverse;
        let mut n = [d1 * (b * c), d2 * (c * a), d3 * (a * b)];
        if N::ACTS {
            let torque = self.torque.torque(&phase);
            n = core::array::from_fn(|k| n[k] + torque[k]);
        }
        let omega = BodyVector::new(j1 * a, j2 * b, j3 * c);
        let [qw, qx, qy, qz] = quaternion_rate(phase.q, omega);
        [n[0], n[1], n[2], qw, qx, qy, qz]
    }
}

impl<N: Torque<f64>> Follow for DormandPrince8<N> {
    fn name(&self) -> String {
        "dormand-prince-8".to_owned()
    }

    fn order(&self) -> Option<u32> {
        Some(8)
    }

    fn follow(&self, start: &Phase, times: &[f64], effort: Effort) -> Result<Course> {
        start.check()?;
        let ([a, b, c], [w, x, y, z]) = (start.l, unit(start.q));
        let size = (a * a + b * b + c * c).sqrt().max(f64::MIN_POSITIVE);
        let scales = [size, size, size, 1.0, 1.0, 1.0, 1.0];
        let packed = [a, b, c, w, x, y, z];
        let kept = Kept::UnitQuaternion(3);
        let run = order_eight(self, kept, &packed, &scales, times, effort)?;
        let phases = run.states.iter().map(|&[a, b, c, w, x, y, z]| Phase {
            l: [a, b, c],
            q: unit([w, x, y, z]),
        });
        Ok(Course {
            phases: phases.collect(),
            cost: run.cost,
        })
    }
}
