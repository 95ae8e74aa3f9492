//! A heavy top as a differential equation, for methods that integrate any of them.

use differential_equations::ode::ODE;
use differential_equations::prelude::{ExplicitRungeKutta, IVP};
use spinning_bodies::euler_equations::{AxisMoments, HeavyTop, TopState, quaternion_rate};
use spinning_bodies::frame::BodyVector;

/// Ω along the body's axes and the attitude quaternion.
pub type Point = [f64; 7];

/// The Euler–Poisson equations of the library, z taken from the attitude.
pub struct Heavy(HeavyTop);

impl Heavy {
    /// With these moments about the pivot and MgC.
    pub fn new(moments: [f64; 3], lever: [f64; 3]) -> spinning_bodies::Result<Self> {
        let [i1, i2, i3] = moments;
        let [x, y, z] = lever;
        let moments = AxisMoments::new(i1, i2, i3)?;
        Ok(Self(HeavyTop::new(moments, BodyVector::new(x, y, z))?))
    }

    fn rate(&self, p: &Point) -> Point {
        let [a, b, c, w, x, y, z] = *p;
        let omega = BodyVector::new(a, b, c);
        let up = BodyVector::new(
            2.0 * (x * z - w * y),
            2.0 * (y * z + w * x),
            w * w - x * x - y * y + z * z,
        );
        let turning = self.0.rate(&TopState { omega, up }).omega;
        let [dw, dx, dy, dz] = quaternion_rate([w, x, y, z], omega);
        [turning.x(), turning.y(), turning.z(), dw, dx, dy, dz]
    }

    /// The classical method of Runge and Kutta in steps of one length.
    pub fn runge_kutta(&self, start: Point, t: f64, steps: u32) -> Point {
        let h = t / f64::from(steps);
        let moved = |p: &Point, h: f64, rate: &Point| -> Point {
            core::array::from_fn(|k| p[k] + h * rate[k])
        };
        let mut p = start;
        for _ in 0..steps {
            let a = self.rate(&p);
            let b = self.rate(&moved(&p, h / 2.0, &a));
            let c = self.rate(&moved(&p, h / 2.0, &b));
            let d = self.rate(&moved(&p, h, &c));
            p = core::array::from_fn(|k| p[k] + h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]));
        }
        p
    }
}

/// The method of order 8 by Dormand and Prince, relative and absolute tolerance alike: the point at time t, and in how many steps.
pub fn dop853<const N: usize>(
    system: &impl ODE<f64, [f64; N]>,
    start: [f64; N],
    t: f64,
    tolerance: f64,
) -> Option<([f64; N], usize)> {
    let method = ExplicitRungeKutta::dop853()
        .rtol(tolerance)
        .atol(tolerance)
        .max_steps(1_000_000_000);
    let solution = IVP::ode(system, 0.0, t, start)
        .t_eval([t])
        .method(method)
        .solve()
        .ok()?;
    let steps = solution.steps.accepted + solution.steps.rejected;
    Some((*solution.y.last()?, steps))
}

impl ODE<f64, Point> for Heavy {
    fn diff(&self, _: f64, y: &Point, dydt: &mut Point) {
        *dydt = self.rate(y);
    }
}
