//! Many states at once: one body at many times, or many bodies at one (tutorial 6.6, 6.8).

mod lanes;
mod prepared;

use lanes::{Circular, Hyperbolic, Motion, Rows, Steady};
use prepared::{Kind, Prepared};

use super::motion::{EulerTop, State};
use crate::error::{Error, Result};
use crate::frame::{Attitude, BodyVector};
use nalgebra::Quaternion;

/// So many times are worked on side by side.
const TIMES: usize = 32;

/// So many bodies.
const BODIES: usize = 16;

impl<const W: usize> Rows<W> {
    #[inline(always)]
    fn state(&self, i: usize, axis: [usize; 3]) -> State {
        let along = |rows: &[[f64; W]; 3]| {
            let mut components = [0.0; 3];
            for k in 0..3 {
                components[axis[k]] = rows[k][i];
            }
            let [x, y, z] = components;
            BodyVector::new(x, y, z)
        };
        let [w, x, y, z] = &self.attitude;
        State {
            omega: along(&self.omega),
            angular_momentum: along(&self.l),
            attitude: Attitude::from_unit(Quaternion::new(w[i], x[i], y[i], z[i])),
        }
    }
}

fn same_length(wanted: usize, found: usize) -> Result<()> {
    if wanted == found {
        return Ok(());
    }
    Err(Error::Condition {
        condition: "there must be one place for each state",
        value: found as f64,
    })
}

impl EulerTop {
    /// Ω, L and attitude at each of these times (s), into a slice of the same length (6.6, 6.8).
    pub fn states_at(&self, times: &[f64], states: &mut [State]) -> Result<()> {
        same_length(times.len(), states.len())?;
        let Some(Prepared { kind, axis, reach }) = Prepared::new(self) else {
            for (t, state) in times.iter().zip(states) {
                *state = self.at(*t)?;
            }
            return Ok(());
        };
        match &kind {
            Kind::Steady(motion) => self.fill(motion, axis, reach, times, states),
            Kind::Circular(motion) => self.fill(motion, axis, reach, times, states),
            Kind::Hyperbolic(motion) => self.fill(motion, axis, reach, times, states),
        }
    }

    fn fill(
        &self,
        motion: &impl Motion,
        axis: [usize; 3],
        reach: f64,
        times: &[f64],
        states: &mut [State],
    ) -> Result<()> {
        let mut rows = Rows::<TIMES>::zero();
        for (times, states) in times.chunks(TIMES).zip(states.chunks_mut(TIMES)) {
            let mut lanes = [0.0; TIMES];
            lanes[..times.len()].copy_from_slice(times);
            let mut near = true;
            for t in &lanes {
                near &= t.abs() <= reach;
            }
            motion.at(&lanes, &mut rows);
            for (i, state) in states.iter_mut().enumerate() {
                *state = rows.state(i, axis);
            }
            if !near {
                for (t, state) in times.iter().zip(states) {
                    if !(t.abs() <= reach) {
                        *state = self.at(*t)?;
                    }
                }
            }
        }
        Ok(())
    }
}

/// Free bodies.
#[derive(Debug, Clone)]
pub struct Ensemble {
    tops: Vec<EulerTop>,
    steady: Vec<Group<Steady<[f64; BODIES]>>>,
    circular: Vec<Group<Circular<[f64; BODIES]>>>,
    hyperbolic: Vec<Group<Hyperbolic<[f64; BODIES]>>>,
    /// Those that are done one by one.
    single: Vec<usize>,
}

/// Bodies side by side.
#[derive(Debug, Clone)]
struct Group<M> {
    motion: M,
    /// Which bodies they are; the last is repeated where there are too few.
    place: [usize; BODIES],
    axis: [[usize; 3]; BODIES],
    reach: f64,
}

fn groups<One: Copy, M>(
    bodies: &[(usize, [usize; 3], f64, One)],
    gather: impl Fn([One; BODIES]) -> M,
) -> Vec<Group<M>> {
    bodies
        .chunks(BODIES)
        .map(|chunk| {
            let body = |i: usize| chunk[i.min(chunk.len() - 1)];
            Group {
                motion: gather(core::array::from_fn(|i| body(i).3)),
                place: core::array::from_fn(|i| body(i).0),
                axis: core::array::from_fn(|i| body(i).1),
                reach: chunk
                    .iter()
                    .fold(f64::INFINITY, |reach, body| reach.min(body.2)),
            }
        })
        .collect()
}

impl Ensemble {
    /// These bodies, side by side.
    pub fn new(tops: Vec<EulerTop>) -> Self {
        let (mut steady, mut circular, mut hyperbolic, mut single) =
            (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for (i, top) in tops.iter().enumerate() {
            match Prepared::new(top) {
                None => single.push(i),
                Some(Prepared { kind, axis, reach }) => match kind {
                    Kind::Steady(motion) => steady.push((i, axis, reach, motion)),
                    Kind::Circular(motion) => circular.push((i, axis, reach, motion)),
                    Kind::Hyperbolic(motion) => hyperbolic.push((i, axis, reach, motion)),
                },
            }
        }
        Self {
            tops,
            steady: groups(&steady, Steady::gather),
            circular: groups(&circular, Circular::gather),
            hyperbolic: groups(&hyperbolic, Hyperbolic::gather),
            single,
        }
    }

    /// The bodies, in the order they were given.
    pub fn tops(&self) -> &[EulerTop] {
        &self.tops
    }

    /// Ω, L and attitude of every body at time t (s), in the order of the bodies.
    pub fn states_at(&self, t: f64, states: &mut [State]) -> Result<()> {
        same_length(self.tops.len(), states.len())?;
        for i in &self.single {
            states[*i] = self.tops[*i].at(t)?;
        }
        self.fill(&self.steady, t, states)?;
        self.fill(&self.circular, t, states)?;
        self.fill(&self.hyperbolic, t, states)
    }

    fn fill<M: Motion>(&self, groups: &[Group<M>], t: f64, states: &mut [State]) -> Result<()> {
        let times = [t; BODIES];
        let mut rows = Rows::zero();
        for group in groups {
            if t.abs() <= group.reach {
                group.motion.at(&times, &mut rows);
                for (i, (place, axis)) in group.place.iter().zip(group.axis).enumerate() {
                    states[*place] = rows.state(i, axis);
                }
            } else {
                for place in group.place {
                    states[place] = self.tops[place].at(t)?;
                }
            }
        }
        Ok(())
    }
}
