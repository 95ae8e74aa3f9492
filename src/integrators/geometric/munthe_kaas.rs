//! Munthe-Kaas' Runge–Kutta method on the rotations.

use super::stepper::{Run, Steps, checked_moments};
use super::{Integrator, Phase, Stepper, Torque};
use crate::error::Result;
use crate::integrators::real::{Real, cross, exponential, product};

/// The classical Runge–Kutta method, order 4, for the rotation vector u since the start of the step and for L along the body's axes at that start.
///
/// u′ = Ω + ½u∧Ω + u∧(u∧Ω)/12 is Munthe-Kaas' equation to the terms that order 4 needs (Numer. Math. 1998); the step ends with q exp(u).
/// Conserved without torque, to rounding: |L| and L in space; the norm of the attitude always. The energy drifts by O(step⁵) a step, for the method is
/// explicit and neither symmetric nor symplectic. Domain: steps with h|L| at most a radian or two times the least moment, which for a thin body is
/// far less than its turn. Cost: four torques and four pairs of sine and cosine a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MuntheKaas<N> {
    inverse: [f64; 3],
    torque: N,
}

impl<N> MuntheKaas<N> {
    /// The method for a body with these principal moments, kg m², under this torque.
    ///
    /// # Errors
    /// Those of an invalid moment.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::integrators::geometric::{Integrator, MuntheKaas, Phase};
    /// let start = Phase::new(BodyVector::new(0.1, 2.0, 0.3), &Attitude::identity());
    /// let method = MuntheKaas::new([1.0, 2.0, 2.5], ())?;
    /// let mut run = method.start(&start, 0.01)?;
    /// run.advance(100)?;
    /// assert!((run.phase()?.angular_momentum().norm() / start.angular_momentum().norm() - 1.0).abs() < 1e-12);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(moments: [f64; 3], torque: N) -> Result<Self> {
        Ok(Self {
            inverse: checked_moments(moments)?.map(|moment| 1.0 / moment),
            torque,
        })
    }

    /// The rates of u, and of L along the body's axes at the start of the step, as functions of u and that L.
    #[inline(always)]
    fn rates<T: Real>(&self, q: [T; 4], u: [T; 3], l: [T; 3]) -> ([T; 3], [T; 3])
    where
        N: Torque<T>,
    {
        let (half, twelfth) = (T::from_double(0.5), T::from_double(1.0 / 12.0));
        let turn = exponential(u.map(|component| half * component));
        let seen = back(turn, l);
        let here: [T; 3] = core::array::from_fn(|k| l[k] + seen[k]);
        let omega = core::array::from_fn(|k| T::from_double(self.inverse[k]) * here[k]);
        let first = cross(u, omega);
        let second = cross(u, first);
        let rate = core::array::from_fn(|k| omega[k] + half * first[k] + twelfth * second[k]);
        if !N::ACTS {
            return (rate, [T::from_double(0.0); 3]);
        }
        let change = product(q, turn);
        let phase = Phase {
            l: here,
            q: core::array::from_fn(|k| q[k] + change[k]),
        };
        let torque = self.torque.torque(&phase);
        let [w, x, y, z] = turn;
        let forward = back([w, -x, -y, -z], torque);
        (rate, core::array::from_fn(|k| torque[k] + forward[k]))
    }
}

impl<T: Real, N: Torque<T>> Integrator<T> for MuntheKaas<N> {
    fn name(&self) -> String {
        "Munthe-Kaas 4".to_owned()
    }

    fn order(&self) -> u32 {
        4
    }

    fn start(&self, phase: &Phase<T>, step: T) -> Result<Box<dyn Stepper<T> + '_>> {
        let half = T::from_double(0.5) * step;
        let sixth = step * T::from_double(6.0).reciprocal();
        let two = T::from_double(2.0);
        let moved = |l: [T; 3], h: T, rate: [T; 3]| core::array::from_fn(|k| l[k] + h * rate[k]);
        let scaled = |h: T, rate: [T; 3]| rate.map(|component| h * component);
        let one_step = move |run: &mut Run<T>| {
            let Phase { l, q } = run.phase();
            let u1 = core::array::from_fn(|k| T::from_double(self.inverse[k]) * l[k]);
            let n1 = self.torque.torque(&Phase { l, q });
            let (u2, n2) = self.rates(q, scaled(half, u1), moved(l, half, n1));
            let (u3, n3) = self.rates(q, scaled(half, u2), moved(l, half, n2));
            let (u4, n4) = self.rates(q, scaled(step, u3), moved(l, step, n3));
            let mean = |a: [T; 3], b: [T; 3], c: [T; 3], d: [T; 3]| -> [T; 3] {
                core::array::from_fn(|k| sixth * (a[k] + two * (b[k] + c[k]) + d[k]))
            };
            let gained = mean(n1, n2, n3, n4);
            let turn = exponential(scaled(T::from_double(0.5), mean(u1, u2, u3, u4)));
            let seen = back(turn, core::array::from_fn(|k| l[k] + gained[k]));
            run.turn(turn, core::array::from_fn(|k| gained[k] + seen[k]));
            Ok(4)
        };
        Ok(Steps::boxed(Run::new(phase, step)?, one_step))
    }
}

/// The change of a constant vector's components along axes that are turned by the rotation 1 + `turn`.
#[inline(always)]
fn back<T: Real>([w, x, y, z]: [T; 4], v: [T; 3]) -> [T; 3] {
    let p = [x, y, z];
    let first = cross(p, v);
    let second = cross(p, first);
    let (one, two) = (T::from_double(1.0), T::from_double(2.0));
    core::array::from_fn(|k| two * (second[k] - (one + w) * first[k]))
}
