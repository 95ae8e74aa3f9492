//! The tippe top as a problem: a ball sliding on a table, with C off its centre.

use spinning_bodies::Result;
use spinning_bodies::integrators::geometric::Phase;
use spinning_bodies::integrators::{Effort, Kept, Method, Solution, System, order_eight};

use crate::follow::Follow;
use crate::general::Run;

/// The quaternion, Ω along the body's axes, horizontal velocity of C, its horizontal position, work done against friction.
type Numbers = [f64; 12];

/// A ball with I₁ = I₂ on a table with viscous friction, C on its third axis off the centre; quotients that its rates need are precomputed.
#[derive(Debug, Clone, Copy)]
pub struct SlidingBall {
    mass: f64,
    moments: [f64; 3],
    inverse_mass: f64,
    /// 1/I₁ and 1/I₃.
    inverse: [f64; 2],
    /// I₃/I₁, and I₃/I₁ − 1.
    oblateness: [f64; 2],
    radius: f64,
    offset: f64,
    friction: f64,
    gravity: f64,
}

impl SlidingBall {
    /// The tippe top: 20 g, moments 3e-6 and 3.2e-6 kg m² about C, radius 2 cm, the centre 6 mm over C, friction 0.3 s/m.
    pub(super) const TIPPE_TOP: Self = {
        let (mass, transverse, axial) = (0.02, 3e-6, 3.2e-6);
        Self {
            mass,
            moments: [transverse, transverse, axial],
            inverse_mass: 1.0 / mass,
            inverse: [1.0 / transverse, 1.0 / axial],
            oblateness: [axial / transverse, (axial - transverse) / transverse],
            radius: 0.02,
            offset: 0.006,
            friction: 0.3,
            gravity: 9.81,
        }
    };

    /// Moments about C, kg m².
    pub const fn moments(&self) -> [f64; 3] {
        self.moments
    }

    /// The components of the equations for this phase, with C at rest.
    fn numbers(&self, phase: &Phase) -> Result<Numbers> {
        let q = phase.attitude()?.quaternion();
        let [a, b, c] = core::array::from_fn(|k| phase.l[k] / self.moments[k]);
        Ok([q.w, q.i, q.j, q.k, a, b, c, 0.0, 0.0, 0.0, 0.0, 0.0])
    }

    /// The size below which each component counts as small.
    fn scales(&self, y: &Numbers) -> Numbers {
        let size = self.radius;
        let omega = y[4].hypot(y[5]).hypot(y[6]);
        let turn = omega + (self.gravity / size).sqrt();
        let speed = size * turn;
        let energy = self.mass * speed * speed;
        let (q, w, v) = (1.0, turn, speed);
        [q, q, q, q, w, w, w, v, v, size, size, energy]
    }

    fn phase(&self, y: &Numbers) -> Phase {
        Phase {
            l: core::array::from_fn(|k| self.moments[k] * y[4 + k]),
            q: [y[0], y[1], y[2], y[3]],
        }
    }
}

impl System<12> for SlidingBall {
    /// The equations of any body on a table, simplified for a ball with I₁ = I₂ and C on its third axis: a third of the work, so that the cost of a method
    /// does not disappear in that of the problem.
    ///
    /// In the notation of the general equations the arm ρ from C to the contact is (0, 0, a) − Ru. With it the vertical acceleration of C is
    /// that of a u₃: the rotation about u drops out. The time of an evaluation depends on its longest chain of dependent operations, not on
    /// their number, so the slip is formed along the body's axes, where it needs no second rotation, and factors are applied as late as possible.
    #[inline]
    fn rate(&self, _: f64, y: &Numbers) -> Numbers {
        let [w, x, y2, z, o1, o2, o3, v1, v2, ..] = *y;
        let Self {
            inverse_mass,
            inverse: [j1, j3],
            oblateness: [ratio, excess],
            radius,
            offset: a,
            friction,
            gravity,
            ..
        } = *self;
        // The rows of the rotation matrix times |q|²; the third also as a vector of the body, up.
        let (ww, xx, yy, zz) = (w * w, x * x, y2 * y2, z * z);
        let (dw, dx, dy) = (w + w, x + x, y2 + y2);
        let (xy, xz, yz, wx, wy, wz) = (dx * y2, dx * z, dy * z, dw * x, dw * y2, dw * z);
        let (a1, a2, a3) = ((ww + xx) - (yy + zz), xy - wz, xz + wy);
        let (b1, b2, b3) = (xy + wz, (ww + yy) - (xx + zz), yz - wx);
        let (n1, n2, n3) = (xz - wy, yz + wx, (ww + zz) - (xx + yy));
        // 1/|q|² to first order in |q|² − 1: without this the drift of |q| costs a general method a factor of fifty in its error.
        let unit = 2.0 - ((ww + zz) + (xx + yy));
        let (u1, u2, u3) = (unit * n1, unit * n2, unit * n3);
        // Slip: V + Ω∧ρ without its vertical part, in which Ru∧Ω is horizontal.
        let (r1, r2, r3) = (radius * o1, radius * o2, radius * o3);
        let climb = (a * unit) * (n1 * o2 - n2 * o1);
        let s1 = (unit * ((v1 * a1 + v2 * b1) - (r2 * n3 - r3 * n2)) + a * o2) - climb * u1;
        let s2 = (unit * ((v1 * a2 + v2 * b2) - (r3 * n1 - r1 * n3)) - a * o1) - climb * u2;
        let s3 = unit * ((v1 * a3 + v2 * b3) - (r1 * n2 - r2 * n1)) - climb * u3;
        // Torque over reaction: ρ∧(u − cs). Its part with u is a(−u₂, u₁, 0); the other needs −cρ.
        let pull = friction * radius;
        let (p1, p2, p3) = (pull * u1, pull * u2, pull * u3 - friction * a);
        let t1 = (p2 * s3 - p3 * s2) - a * u2;
        let t2 = (p3 * s1 - p1 * s3) + a * u1;
        let t3 = p1 * s2 - p2 * s1;
        let tilt = a * j1;
        let fall = (ratio * o3) * (u1 * o1 + u2 * o2) - u3 * (o1 * o1 + o2 * o2);
        let reaction =
            (gravity - a * fall) / (inverse_mass + ((tilt * u1) * t2 - (tilt * u2) * t1));
        // Slip along the table's axes.
        let (e1, e2) = (
            unit * (a1 * s1 + a2 * s2 + a3 * s3),
            unit * (b1 * s1 + b2 * s2 + b3 * s3),
        );
        let push = -(reaction * (inverse_mass * friction));
        let whirl = excess * o3;
        [
            -0.5 * (x * o1 + y2 * o2 + z * o3),
            0.5 * (w * o1 + (y2 * o3 - z * o2)),
            0.5 * (w * o2 + (z * o1 - x * o3)),
            0.5 * (w * o3 + (x * o2 - y2 * o1)),
            reaction * (j1 * t1) - whirl * o2,
            reaction * (j1 * t2) + whirl * o1,
            reaction * (j3 * t3),
            push * e1,
            push * e2,
            v1,
            v2,
            (reaction * friction) * (e1 * e1 + e2 * e2),
        ]
    }
}

/// A ball followed by a general method or by the library's order 8: it returns phases like any other method, though its state has twelve components.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sliding {
    pub(super) ball: SlidingBall,
    /// `None` for the library's order 8.
    pub(super) general: Option<Method>,
}

impl Follow for Sliding {
    fn name(&self) -> String {
        self.general
            .map_or("dormand-prince-8", Method::name)
            .to_owned()
    }

    fn order(&self) -> Option<u32> {
        self.general.map_or(Some(8), crate::general::order)
    }

    fn follow(&self, start: &Phase, times: &[f64], effort: Effort) -> Result<Solution<Phase>> {
        let y = self.ball.numbers(start)?;
        let scales = self.ball.scales(&y);
        let run = match self.general {
            Some(method) => Run::new(&self.ball, &scales, method, effort).solve(&y, times)?,
            None => {
                let kept = Kept::UnitQuaternion(0);
                order_eight(&self.ball, kept, &y, &scales, times, effort)?
            }
        };
        Ok(Solution {
            states: run.states.iter().map(|y| self.ball.phase(y)).collect(),
            cost: run.cost,
        })
    }
}
