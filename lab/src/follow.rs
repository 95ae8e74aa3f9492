//! A common trait by which every method, geometric, general or closed form, returns the motion of a body.

use core::fmt::Debug;

use spinning_bodies::euler_equations::{AxisMoments, quaternion_rate};
use spinning_bodies::frame::BodyVector;
use spinning_bodies::integrators::geometric::{Integrator, Phase, Torque, follow};
use spinning_bodies::integrators::{Effort, Kept, Solution, System, order_eight};
use spinning_bodies::{Error, Result};

/// A method that returns the motion of a body, by steps or to a tolerance.
pub trait Follow: Debug {
    /// Its name in the tables.
    fn name(&self) -> String;

    /// Its order, where it has one.
    fn order(&self) -> Option<u32>;

    /// Phases at `times` (s, either side of 0, in any order) of the motion that starts with `start` at time 0.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NotPositive`] for times and effort; [`Error::Integration`], [`Error::Accuracy`] where the method fails;
    /// [`Error::Solver`] for a tolerance if the method has steps of one length.
    fn follow(&self, start: &Phase, times: &[f64], effort: Effort) -> Result<Solution<Phase>>;
}

/// Between two samples the steps have one length, at most the given one.
impl<I: Integrator + Debug> Follow for I {
    fn name(&self) -> String {
        Integrator::name(self)
    }

    fn order(&self) -> Option<u32> {
        Some(Integrator::order(self))
    }

    fn follow(&self, start: &Phase, times: &[f64], effort: Effort) -> Result<Solution<Phase>> {
        let Effort::Step(step) = effort else {
            return Err(Error::Solver {
                condition: "a method with steps of one length must be given a step",
            });
        };
        follow(self, start, times, step, &mut |_, _| Ok(()))
    }
}

/// [`order_eight`] for a turning body under a torque: L and the attitude's quaternion, which keeps norm 1.
///
/// Explicit, neither symmetric nor symplectic: energy and L drift with the error, in proportion to the time. With [`Effort::Tolerance`] the
/// error of a step is judged relative to |L| and in the quaternion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DormandPrince8<N> {
    inverse: [f64; 3],
    /// (I₂ − I₃)/(I₂I₃) and cyclic: L₁′ is this times L₂L₃, so that nearly equal moments lose no digits.
    difference: [f64; 3],
    torque: N,
}

impl<N> DormandPrince8<N> {
    /// The method for a body with these moments, kg m², under this torque.
    ///
    /// # Errors
    /// Those of an invalid moment.
    pub fn new([i1, i2, i3]: [f64; 3], torque: N) -> Result<Self> {
        let moments = AxisMoments::new(i1, i2, i3)?.values();
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

impl<N: Torque<f64> + Debug> Follow for DormandPrince8<N> {
    fn name(&self) -> String {
        "dormand-prince-8".to_owned()
    }

    fn order(&self) -> Option<u32> {
        Some(8)
    }

    fn follow(&self, start: &Phase, times: &[f64], effort: Effort) -> Result<Solution<Phase>> {
        let ([a, b, c], [w, x, y, z]) = (start.l, unit(start)?);
        let size = (a * a + b * b + c * c).sqrt().max(f64::MIN_POSITIVE);
        let scales = [size, size, size, 1.0, 1.0, 1.0, 1.0];
        let packed = [a, b, c, w, x, y, z];
        let kept = Kept::UnitQuaternion(3);
        let run = order_eight(self, kept, &packed, &scales, times, effort)?;
        let phases = run.states.iter().map(|&[a, b, c, w, x, y, z]| {
            let (l, q) = ([a, b, c], [w, x, y, z]);
            let q = unit(&Phase { l, q })?;
            Ok(Phase { l, q })
        });
        Ok(Solution {
            states: phases.collect::<Result<_>>()?,
            cost: run.cost,
        })
    }
}

/// The quaternion of the attitude with norm 1.
fn unit(phase: &Phase) -> Result<[f64; 4]> {
    let q = phase.attitude()?.quaternion();
    Ok([q.w, q.i, q.j, q.k])
}
