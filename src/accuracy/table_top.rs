//! The tippe top as a problem: a ball that slides on a table, C off its centre.

use nalgebra::Matrix3;

use crate::error::Result;
use crate::frame::BodyVector;
use crate::inertia::InertiaMatrix;
use crate::integrators::geometric::{Course, Follow, Kept, Phase, order_eight};
use crate::integrators::{Effort, Method, System, solve};
use crate::scene::Absent;
use crate::tippe_top::equations::{Ground, NUMBERS, Numbers, Table, numbers};
use crate::tippe_top::{ConvexBody, Start, Surface, Viscous};

/// A ball on a table with viscous friction, C on its third axis off the centre.
#[derive(Debug, Clone, Copy)]
pub struct OnTable {
    table: Table<Viscous, Absent>,
    moments: [f64; 3],
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
        Ok(Self { table, moments })
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
    fn rate(&self, _: f64, y: &Numbers) -> Numbers {
        self.table.sliding_rates(y)
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
