//! The tippe top as a problem: a ball that slides on a table, C off its centre.

use nalgebra::Matrix3;

use crate::error::{Error, Result};
use crate::frame::BodyVector;
use crate::inertia::InertiaMatrix;
use crate::integrators::geometric::{Course, Follow, Phase};
use crate::integrators::{Effort, Method, System, solve};
use crate::integrators::{Kept, order_eight};
use crate::scene::Absent;
use crate::tippe_top::equations::{NUMBERS, Numbers, Table, numbers};
use crate::tippe_top::{ConvexBody, Start, Surface, Viscous};

/// A ball on a table with viscous friction, C on its third axis off the centre.
#[derive(Debug, Clone, Copy)]
pub struct OnTable {
    table: Table<Viscous, Absent>,
    moments: [f64; 3],
    ball: Ball,
}

/// What the rates of a ball need, divided out beforehand.
#[derive(Debug, Clone, Copy)]
struct Ball {
    inverse_mass: f64,
    /// 1/I₁ and 1/I₃.
    inverse: [f64; 2],
    /// I₃/I₁, and what it is above 1.
    oblateness: [f64; 2],
    radius: f64,
    offset: f64,
    friction: f64,
    gravity: f64,
}

impl OnTable {
    /// With mass (kg), moments about C (kg m²), the first two alike, radius (m), height of the centre over C along the third axis (m),
    /// gravity (m/s²) and coefficient of friction (s/m).
    pub(super) fn new(
        mass: f64,
        moments: [f64; 3],
        radius: f64,
        offset: f64,
        gravity: f64,
        friction: f64,
    ) -> Result<Self> {
        let inertia = InertiaMatrix::from_matrix(Matrix3::from_diagonal(&moments.into()))?;
        let surface = Surface::sphere(radius)?;
        let center = BodyVector::new(0.0, 0.0, offset);
        let table = Table {
            body: ConvexBody::new(mass, inertia, surface, center)?,
            gravity,
            friction: Viscous::new(friction)?,
            resistance: Absent,
        };
        let [transverse, same, axial] = moments;
        if transverse != same {
            return Err(Error::Condition {
                condition: "a ball on a table must have I1 = I2",
                value: same / transverse,
            });
        }
        let ball = Ball {
            inverse_mass: 1.0 / mass,
            inverse: [1.0 / transverse, 1.0 / axial],
            oblateness: [axial / transverse, (axial - transverse) / transverse],
            radius,
            offset,
            friction,
            gravity,
        };
        Ok(Self {
            table,
            moments,
            ball,
        })
    }

    /// Moments about C, kg m².
    pub const fn moments(&self) -> [f64; 3] {
        self.moments
    }

    /// The numbers of the equations for this phase, C at rest but for what the contact makes of it.
    fn numbers(&self, phase: &Phase) -> Result<Numbers> {
        let [x, y, z] = core::array::from_fn(|k| phase.l[k] / self.moments[k]);
        let start = Start::spinning(phase.attitude()?, BodyVector::new(x, y, z))?;
        Ok(numbers(&start))
    }

    /// The size below which each number counts as small.
    fn scales(&self, y: &Numbers) -> Numbers {
        let size = self.table.body.surface().size();
        let omega = y[4].hypot(y[5]).hypot(y[6]);
        let turn = omega + (self.table.gravity / size).sqrt();
        let speed = size * turn;
        let energy = self.table.body.mass() * speed * speed;
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

impl System<NUMBERS> for OnTable {
    #[inline]
    fn rate(&self, _: f64, y: &Numbers) -> Numbers {
        self.ball.rate(y)
    }
}

impl Ball {
    /// The equations of any body on a table, for a ball with I₁ = I₂ and C on its third axis: a third of the work, so that a method's own cost is not lost in
    /// that of the problem.
    ///
    /// In the notation of the general equations the arm ρ from C to the contact is (0, 0, a) − Ru. With it the vertical acceleration of C is
    /// that of a u₃: what turns about u alone falls out. An evaluation waits for its longest chain of operations rather than for
    /// their number, so the slip is put together along the body's axes, where it needs no second rotation, and factors are applied as late as they can be.
    #[inline]
    fn rate(&self, y: &Numbers) -> Numbers {
        let [w, x, y2, z, o1, o2, o3, v1, v2, ..] = *y;
        let Self {
            inverse_mass,
            inverse: [j1, j3],
            oblateness: [ratio, excess],
            radius,
            offset: a,
            friction,
            gravity,
        } = *self;
        // The rows of the rotation times |q|², and the third again as a vector of the body: up.
        let (ww, xx, yy, zz) = (w * w, x * x, y2 * y2, z * z);
        let (dw, dx, dy) = (w + w, x + x, y2 + y2);
        let (xy, xz, yz, wx, wy, wz) = (dx * y2, dx * z, dy * z, dw * x, dw * y2, dw * z);
        let (a1, a2, a3) = ((ww + xx) - (yy + zz), xy - wz, xz + wy);
        let (b1, b2, b3) = (xy + wz, (ww + yy) - (xx + zz), yz - wx);
        let (n1, n2, n3) = (xz - wy, yz + wx, (ww + zz) - (xx + yy));
        // 1/|q|² but for the square of what |q|² is off: without it the drift of |q| costs a general method a factor of fifty in its error.
        let unit = 2.0 - ((ww + zz) + (xx + yy));
        let (u1, u2, u3) = (unit * n1, unit * n2, unit * n3);
        // Slip: V + Ω∧ρ without its vertical part. Of that, Ru∧Ω is level.
        let (r1, r2, r3) = (radius * o1, radius * o2, radius * o3);
        let climb = (a * unit) * (n1 * o2 - n2 * o1);
        let s1 = (unit * ((v1 * a1 + v2 * b1) - (r2 * n3 - r3 * n2)) + a * o2) - climb * u1;
        let s2 = (unit * ((v1 * a2 + v2 * b2) - (r3 * n1 - r1 * n3)) - a * o1) - climb * u2;
        let s3 = unit * ((v1 * a3 + v2 * b3) - (r1 * n2 - r2 * n1)) - climb * u3;
        // Torque over reaction: ρ∧(u − cs), of which the part with u is a(−u₂, u₁, 0); and −cρ.
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

/// A general method on a table: asked for phases like any other, though its numbers are twelve.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sliding {
    pub(super) table: OnTable,
    pub(super) method: Method,
}

impl Follow for Sliding {
    fn name(&self) -> String {
        self.method.name().to_owned()
    }

    fn order(&self) -> Option<u32> {
        match self.method {
            Method::Rk4 => Some(4),
            Method::Gauss => Some(6),
            _ => None,
        }
    }

    fn follow(&self, start: &Phase, times: &[f64], effort: Effort) -> Result<Course> {
        let y = self.table.numbers(start)?;
        let scales = self.table.scales(&y);
        let run = solve(&self.table, 0.0, &y, &scales, times, self.method, effort)?;
        Ok(Course {
            phases: run.states.iter().map(|y| self.table.phase(y)).collect(),
            cost: run.cost,
        })
    }
}

/// Our own method of order 8 on a table.
#[derive(Debug, Clone, Copy)]
pub(super) struct SlidingOrderEight {
    pub(super) table: OnTable,
}

impl Follow for SlidingOrderEight {
    fn name(&self) -> String {
        "dormand-prince-8".to_owned()
    }

    fn order(&self) -> Option<u32> {
        Some(8)
    }

    fn follow(&self, start: &Phase, times: &[f64], effort: Effort) -> Result<Course> {
        let y = self.table.numbers(start)?;
        let scales = self.table.scales(&y);
        let kept = Kept::UnitQuaternion(0);
        let run = order_eight(&self.table, kept, &y, &scales, times, effort)?;
        Ok(Course {
            phases: run.states.iter().map(|y| self.table.phase(y)).collect(),
            cost: run.cost,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::OnTable;
    use crate::integrators::System;
    use crate::tippe_top::equations::Ground;

    #[test]
    fn the_ball_is_a_body_on_a_table() {
        let ball = OnTable::new(0.02, [3e-6, 3e-6, 3.2e-6], 0.02, 0.006, 9.81, 0.3).unwrap();
        let states = [
            [
                0.9, 0.1, -0.3, 0.2, 8.0, -3.0, 155.0, 0.1, -0.2, 0.3, 0.4, 1e-3,
            ],
            [
                0.1, 0.7, 0.6, -0.3, -40.0, 90.0, -20.0, -0.5, 0.0, 0.0, 0.0, 0.0,
            ],
        ];
        for mut y in states {
            let size = y[..4].iter().map(|q| q * q).sum::<f64>().sqrt();
            y[..4].iter_mut().for_each(|q| *q /= size);
            let (own, general) = (ball.rate(0.0, &y), ball.table.sliding_rates(&y));
            for (k, (a, b)) in own.iter().zip(general).enumerate() {
                // Observed: 4e-16 of the largest.
                let scale = if k < 4 {
                    100.0
                } else if k < 7 {
                    1e4
                } else {
                    10.0
                };
                assert!((a - b).abs() < 2e-15 * scale, "{k}: {a} {b}");
            }
        }
    }
}
