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
    /// Hands out the states of the lanes one by one, along the body's own axes.
    #[inline(always)]
    fn each(&self, axis: [usize; 3], mut give: impl FnMut(usize, State)) {
        let mut own = [0; 3];
        for k in 0..3 {
            own[axis[k]] = k;
        }
        let [l1, l2, l3] = own.map(|k| &self.l[k]);
        let [o1, o2, o3] = own.map(|k| &self.omega[k]);
        let [w, x, y, z] = &self.attitude;
        for i in 0..W {
            let state = State {
                omega: BodyVector::new(o1[i], o2[i], o3[i]),
                angular_momentum: BodyVector::new(l1[i], l2[i], l3[i]),
                attitude: Attitude::from_unit(Quaternion::new(w[i], x[i], y[i], z[i])),
            };
            give(i, state);
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
            if let Ok(all) = <&mut [State; TIMES]>::try_from(&mut *states) {
                rows.each(axis, |i, state| all[i] = state);
            } else {
                rows.each(axis, |i, state| {
                    if let Some(place) = states.get_mut(i) {
                        *place = state;
                    }
                });
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
    axis: [usize; 3],
    reach: f64,
}

/// A body of one kind: which it is, its axes, its reach and its constants.
type Body<One> = (usize, [usize; 3], f64, One);

/// Bodies with the same axes are put side by side.
fn groups<One: Copy, M>(
    mut bodies: Vec<Body<One>>,
    gather: impl Fn([One; BODIES]) -> M,
) -> Vec<Group<M>> {
    bodies.sort_by_key(|body| body.1);
    bodies
        .chunk_by(|a, b| a.1 == b.1)
        .flat_map(|alike| alike.chunks(BODIES))
        .map(|chunk| {
            let body = |i: usize| chunk[i.min(chunk.len() - 1)];
            Group {
                motion: gather(core::array::from_fn(|i| body(i).3)),
                place: core::array::from_fn(|i| body(i).0),
                axis: body(0).1,
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
            steady: groups(steady, Steady::gather),
            circular: groups(circular, Circular::gather),
            hyperbolic: groups(hyperbolic, Hyperbolic::gather),
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
                rows.each(group.axis, |i, state| states[group.place[i]] = state);
            } else {
                for place in group.place {
                    states[place] = self.tops[place].at(t)?;
                }
            }
        }
        Ok(())
    }
}
