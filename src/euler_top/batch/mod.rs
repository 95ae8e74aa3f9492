//! Many states at once: one body at many times, or many bodies at one (tutorial 6.6, 6.8).
//!
//! The closed form without a branch, over rows of lanes that the compiler lays out side by side: a lane is a time or a body. Which
//! closed form it is, and up to which time, is decided once a body; beyond that time each state is [`EulerTop::at`]'s. Bodies from
//! scratch are prepared in the same way: sorted by kind, then eight at a time.

mod at_once;
mod beginning;
mod constants;
mod ensemble;
mod lanes;
mod prepared;
mod rate;
mod release;

use nalgebra::Quaternion;

pub use at_once::released_states;
pub use ensemble::Ensemble;
pub use release::Release;

use constants::Steady;
use lanes::{Motion, Rows, Work};
use prepared::{Kind, Prepared};

use super::motion::{EulerTop, State};
use crate::error::{Error, Result};
use crate::frame::{Attitude, BodyVector};

/// So many times are worked on side by side.
const TIMES: usize = 32;

/// So many bodies.
const BODIES: usize = 8;

/// Which row is which of the body's own axes.
type Axes = [usize; 3];

/// Which row is which of the body's own axes, and the other way round.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Rowing([usize; 3]);

impl Rowing {
    /// From the body's own axes of the rows.
    fn new(axis: Axes) -> Self {
        let mut own = [0; 3];
        for k in 0..3 {
            own[axis[k]] = k;
        }
        Self(own)
    }
}

impl<const W: usize> Rows<W> {
    /// Hands out the states of the lanes one by one, along axes that are the same for all.
    #[inline(always)]
    fn each(&self, Rowing(own): Rowing, mut give: impl FnMut(usize, State)) {
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

    /// The state of one lane.
    #[inline(always)]
    fn one(&self, i: usize, Rowing([a, b, c]): Rowing) -> State {
        let (l, omega) = (&self.l, &self.omega);
        let [w, x, y, z] = &self.attitude;
        State {
            omega: BodyVector::new(omega[a][i], omega[b][i], omega[c][i]),
            angular_momentum: BodyVector::new(l[a][i], l[b][i], l[c][i]),
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

/// A lane for each time, and whether all are within reach. The lanes of a last chunk that is not full are at time 0.
fn lanes_of(times: &[f64], reach: f64) -> ([f64; TIMES], bool) {
    let mut lanes = [0.0; TIMES];
    lanes[..times.len()].copy_from_slice(times);
    // So counted that not-a-number is beyond.
    let within = lanes.iter().filter(|t| t.abs() <= reach).count();
    (lanes, within == TIMES)
}

impl EulerTop {
    /// Ω, L and attitude at each of these times (s), in any order, into a slice of the same length (6.6, 6.8).
    ///
    /// Domain: that of [`at`](Self::at). Up to some 8·10⁶ turns from the start, and unless the amplitudes or the rates are in ratios of
    /// 10⁶⁰ and more, 32 states are formed side by side; what lies beyond is handed to [`at`](Self::at), one by one.
    ///
    /// Error: the states are those of [`at`](Self::at) up to rounding; against the same 998 references of 32 digits the attitude is off by
    /// at most 7e-16 rad (1.5e-15, as [`at`](Self::at) is, for bodies one unit in the last place from a sphere), Ω and L by 5e-16.
    ///
    /// Cost: beside [`at`](Self::at) in the same run (`cargo bench -p lab --bench ensembles`), with the instructions every processor of the kind
    /// has: 0.19 of the time a state where m ≤ 1/2, 0.24 where m > 1/2, 0.27 where Ω stays and [`at`](Self::at) has little to do. The constants
    /// of a batch cost as much as one state. States are independent of each other: parts of the slices may be filled by different threads.
    ///
    /// # Errors
    /// [`Error::Condition`] if the slices differ in length; otherwise that of the first time that [`at`](Self::at) refuses, the states being partly
    /// written.
    ///
    /// ```
    /// use spinning_bodies::euler_top::{EulerTop, State};
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// let start = BodyVector::new(1.8, 0.4, -0.9);
    /// let top = EulerTop::new([0.6, 0.8, 1.0], start, Attitude::identity())?;
    /// let times: Vec<f64> = (0..100).map(|k| 0.1 * f64::from(k)).collect();
    /// let mut states = [State::default(); 100];
    /// top.states_at(&times, &mut states)?;
    /// assert!(states[70].attitude.angle_to(&top.at(times[70])?.attitude) < 2e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn states_at(&self, times: &[f64], states: &mut [State]) -> Result<()> {
        same_length(times.len(), states.len())?;
        let Some(Prepared { kind, axis, reach }) = Prepared::new(self) else {
            return self.fill_singly(times, states);
        };
        match &kind {
            Kind::Steady(motion) => self.fill_turning(motion, reach, times, states),
            Kind::Circular(motion) => self.fill(motion, axis, reach, times, states),
            Kind::Hyperbolic(motion) => self.fill(motion, axis, reach, times, states),
        }
    }

    /// Ω and L stay: they are written, not formed again.
    fn fill_turning(
        &self,
        motion: &Steady<f64>,
        reach: f64,
        times: &[f64],
        states: &mut [State],
    ) -> Result<()> {
        let ([a, b, c], [x, y, z]) = (motion.omega, motion.l);
        let (omega, angular_momentum) = (BodyVector::new(a, b, c), BodyVector::new(x, y, z));
        let mut rows = [[0.0; TIMES]; 4];
        for (times, states) in times.chunks(TIMES).zip(states.chunks_mut(TIMES)) {
            let (lanes, within) = lanes_of(times, reach);
            motion.turn(&lanes, &mut rows);
            let [w, x, y, z] = &rows;
            for (i, state) in states.iter_mut().take(TIMES).enumerate() {
                *state = State {
                    omega,
                    angular_momentum,
                    attitude: Attitude::from_unit(Quaternion::new(w[i], x[i], y[i], z[i])),
                };
            }
            if !within {
                self.fill_singly(times, states)?;
            }
        }
        Ok(())
    }

    fn fill_singly(&self, times: &[f64], states: &mut [State]) -> Result<()> {
        for (t, state) in times.iter().zip(states) {
            *state = self.at(*t)?;
        }
        Ok(())
    }

    fn fill(
        &self,
        motion: &impl Motion,
        axis: Axes,
        reach: f64,
        times: &[f64],
        states: &mut [State],
    ) -> Result<()> {
        let axis = Rowing::new(axis);
        let (mut work, mut rows) = (Work::<TIMES>::new(), Rows::<TIMES>::zero());
        for (times, states) in times.chunks(TIMES).zip(states.chunks_mut(TIMES)) {
            let (lanes, within) = lanes_of(times, reach);
            motion.at(&lanes, &mut work, &mut rows);
            if let Ok(states) = <&mut [State; TIMES]>::try_from(&mut *states) {
                rows.each(axis, |i, state| states[i] = state);
            } else {
                for (i, state) in states.iter_mut().enumerate() {
                    *state = rows.one(i, axis);
                }
            }
            if !within {
                self.fill_singly(times, states)?;
            }
        }
        Ok(())
    }
}
