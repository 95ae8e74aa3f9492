//! The tippe top as a problem: a ball that slides on a table, C off its centre.

use nalgebra::Matrix3;

use crate::error::Result;
use crate::frame::BodyVector;
use crate::inertia::InertiaMatrix;
use crate::integrators::geometric::{Course, Follow, Kept, Phase, order_eight};
use crate::integrators::{Effort, Method, System, solve};
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
    inverse_moments: [f64; 3],
    radius: f64,
    offset: f64,
    friction: f64,
}

impl OnTable {
    /// With mass (kg), moments about C (kg m²), radius (m), height of the centre over C along the third axis (m), gravity (m/s²) and
    /// coefficient of friction (s/m).
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
        let ball = Ball {
            inverse_mass: 1.0 / mass,
            inverse_moments: moments.map(|moment| 1.0 / moment),
            radius,
            offset,
            friction,
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
    /// The equations of any body on a table, for a ball with C on its third axis: a third of the work, so that a method's own cost is not lost in that of the problem.
    ///
    /// In the notation of the general equations the arm from C to the contact is (0, 0, a) − Ru.
    #[inline]
    fn rate(&self, _: f64, y: &Numbers) -> Numbers {
        let [w, x, yy, z, o1, o2, o3, v1, v2, ..] = *y;
        let Ball {
            inverse_mass,
            inverse_moments,
            radius,
            offset,
            friction,
        } = self.ball;
        let omega = [o1, o2, o3];
        // The rows of the rotation, and the third again as a vector of the body: up.
        let scale = 1.0 / (w * w + x * x + yy * yy + z * z);
        let (s, t) = (2.0 * scale, 1.0);
        let right = [
            t - s * (yy * yy + z * z),
            s * (x * yy - w * z),
            s * (x * z + w * yy),
        ];
        let ahead = [
            s * (x * yy + w * z),
            t - s * (x * x + z * z),
            s * (yy * z - w * x),
        ];
        let up = [
            s * (x * z - w * yy),
            s * (yy * z + w * x),
            t - s * (x * x + yy * yy),
        ];
        let arm = [-radius * up[0], -radius * up[1], offset - radius * up[2]];
        let swing = cross(omega, arm);
        let climb = dot(up, swing);
        let slip: [f64; 3] =
            core::array::from_fn(|k| v1 * right[k] + v2 * ahead[k] + swing[k] - climb * up[k]);
        let traction = slip.map(|v| -friction * v);
        let torque = cross(arm, core::array::from_fn(|k| up[k] + traction[k]));
        let lever = [-offset * up[1], offset * up[0]];
        let [i1, i2, i3] = self.moments;
        let free = [
            (i3 - i2) * o2 * o3 * inverse_moments[0],
            (i1 - i3) * o3 * o1 * inverse_moments[1],
            (i2 - i1) * o1 * o2 * inverse_moments[2],
        ];
        let pushed: [f64; 3] = core::array::from_fn(|k| torque[k] * inverse_moments[k]);
        let turning = cross(up, omega);
        let whirl = cross(
            omega,
            core::array::from_fn(|k| swing[k] - radius * turning[k]),
        );
        let reaction = (self.table.gravity + lever[0] * free[0] + lever[1] * free[1]
            - dot(up, whirl))
            / (inverse_mass + lever[0] * pushed[0] + lever[1] * pushed[1]);
        let push = reaction * inverse_mass;
        [
            -0.5 * (x * o1 + yy * o2 + z * o3),
            0.5 * (w * o1 + yy * o3 - z * o2),
            0.5 * (w * o2 + z * o1 - x * o3),
            0.5 * (w * o3 + x * o2 - yy * o1),
            pushed[0] * reaction - free[0],
            pushed[1] * reaction - free[1],
            pushed[2] * reaction - free[2],
            push * dot(right, traction),
            push * dot(ahead, traction),
            v1,
            v2,
            -reaction * dot(traction, slip),
        ]
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
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
