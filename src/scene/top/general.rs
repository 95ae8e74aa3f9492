//! A top by a general method: in one run, or up to the moment at which dry friction has stopped the spin, and on from there.

use super::steered::{CALM, Shown, Wheel};
use crate::error::Result;
use crate::integrators::geometric::{Phase, order_eight_watched};
use crate::integrators::{
    Cost, Effort, Kept, Method, Solution, Stop, System, halved, refined, solve, tightened, until,
};

/// The problem as the integrators see it. The equations come as a trait object, so that the methods are compiled once and not for
/// every list of effects; compiled into the step an evaluation would take a twenty-fifth less.
pub(super) struct Problem<'a> {
    pub moments: [f64; 3],
    /// MgC, N m.
    pub lever: [f64; 3],
    pub start: Phase,
    /// Scale of Ω, rad/s.
    pub fastest: f64,
    /// Scale of the energy, J.
    pub energy: f64,
    pub times: &'a [f64],
    pub accuracy: f64,
}

/// L and attitude as seven numbers, and the energy lost, at each time.
pub(super) struct Followed {
    pub states: Vec<([f64; 7], f64)>,
    pub cost: Cost,
    /// By how much the states may be off, where the method tells.
    pub error: Option<f64>,
}

/// Whether dry friction will stop the spin.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Spin {
    GoesOn,
    MayStop,
}

impl Problem<'_> {
    /// Nothing resists.
    pub fn lossless(&self, system: &dyn System<7>, method: Method) -> Result<Followed> {
        let [l1, l2, l3] = self.moments.map(|moment| moment * self.fastest);
        let scales = [l1, l2, l3, 1.0, 1.0, 1.0, 1.0];
        let ([a, b, c], [w, x, y, z]) = (self.start.l, self.start.q);
        let (times, accuracy) = (self.times, self.accuracy);
        let distance = |a: &[f64; 7], b: &[f64; 7]| self.apart(a, b);
        let run = refined(
            system,
            &[a, b, c, w, x, y, z],
            &scales,
            times,
            method,
            accuracy,
            distance,
        )?;
        Ok(Followed {
            states: run.states.into_iter().map(|y| (y, 0.0)).collect(),
            cost: run.cost,
            error: None,
        })
    }

    /// Something resists: the eighth number is the energy that it has taken.
    pub fn lossy(&self, system: &dyn System<8>, method: Method, spin: Spin) -> Result<Followed> {
        let (start, scales) = self.with_loss();
        let distance = |a: &[f64; 8], b: &[f64; 8]| self.apart_with_loss(a, b);
        let (times, accuracy) = (self.times, self.accuracy);
        let run = if spin == Spin::MayStop && start[2] != 0.0 {
            let stopping = |effort| spun_down(system, &start, &scales, times, method, effort);
            if method.is_adaptive() {
                tightened(|t| stopping(Effort::Tolerance(t)), accuracy, distance)?
            } else {
                let longest = times.iter().fold(0.0_f64, |a, &b| a.max(b.abs()));
                let first = longest.max(f64::MIN_POSITIVE) / 64.0;
                halved(|h| stopping(Effort::Step(h)), first, accuracy, distance)?
            }
        } else {
            refined(system, &start, &scales, times, method, accuracy, distance)?
        };
        let split = |y: [f64; 8]| (core::array::from_fn(|k| y[k]), y[7]);
        Ok(Followed {
            states: run.states.into_iter().map(split).collect(),
            cost: run.cost,
            error: None,
        })
    }

    /// Something resists, smoothly: by the method of order 8 that is ours.
    pub fn steered(&self, system: &dyn System<8>) -> Result<Followed> {
        let (start, scales) = self.with_loss();
        let first = self.total(&start);
        let wheel = Wheel {
            run: |tolerance, times: &[f64]| {
                let (kept, effort) = (Kept::UnitQuaternion(3), Effort::Tolerance(tolerance));
                let mut drift = 0.0_f64;
                let watch = |_, y: &[f64; 8]| {
                    drift = drift.max((self.total(y) - first).abs() / self.energy);
                };
                let run = order_eight_watched(system, kept, &start, &scales, times, effort, watch)?;
                Ok(Shown {
                    states: run.states,
                    cost: run.cost,
                    drift,
                })
            },
            distance: |a: &[f64; 8], b: &[f64; 8]| self.apart_with_loss(a, b),
            times: self.times,
            fastest: self.fastest,
            calm: CALM,
            accuracy: self.accuracy,
        };
        let run = wheel.steer()?;
        let split = |y: [f64; 8]| (core::array::from_fn(|k| y[k]), y[7]);
        Ok(Followed {
            states: run.states.into_iter().map(split).collect(),
            cost: run.cost,
            error: Some(run.error),
        })
    }

    /// The start, nothing lost, and the scales of the eight numbers.
    fn with_loss(&self) -> ([f64; 8], [f64; 8]) {
        let ([a, b, c], [w, x, y, z]) = (self.start.l, self.start.q);
        let [l1, l2, l3] = self.moments.map(|moment| moment * self.fastest);
        let scales = [l1, l2, l3, 1.0, 1.0, 1.0, 1.0, self.energy];
        ([a, b, c, w, x, y, z, 0.0], scales)
    }

    /// Energy and what was lost of it, J: asked for at every step.
    fn total(&self, y: &[f64; 8]) -> f64 {
        let [a, b, c, w, x, y, z, lost] = *y;
        let phase = Phase {
            l: [a, b, c],
            q: [w, x, y, z],
        };
        let up = phase.up();
        let part =
            |k: usize| 0.5 * phase.l[k] * phase.l[k] / self.moments[k] + self.lever[k] * up[k];
        part(0) + part(1) + part(2) + lost
    }

    /// Angle between two attitudes, radians, or the distance of the angular velocities in their scale, whichever is more.
    fn apart(&self, a: &[f64], b: &[f64]) -> f64 {
        let square = |x: f64| x * x;
        let faster = (0..3).map(|k| square((a[k] - b[k]) / self.moments[k]));
        let turned = (3..7).map(|k| square(a[k] - b[k]));
        let root = |squares: f64| squares.sqrt();
        (2.0 * root(turned.sum())).max(root(faster.sum()) / self.fastest)
    }

    /// The same, or the distance of the energies lost.
    fn apart_with_loss(&self, a: &[f64; 8], b: &[f64; 8]) -> f64 {
        let lost = (a[7] - b[7]).abs() / self.energy;
        self.apart(a, b).max(lost)
    }
}

/// A run that is cut where L₃ comes to zero: there dry friction changes from a torque that brakes to one that holds.
fn spun_down(
    system: &dyn System<8>,
    start: &[f64; 8],
    scales: &[f64; 8],
    times: &[f64],
    method: Method,
    effort: Effort,
) -> Result<Solution<8>> {
    let mut order: Vec<usize> = (0..times.len()).collect();
    order.sort_by(|&i, &j| times[i].total_cmp(&times[j]));
    let (before, after) = order.split_at(order.partition_point(|&i| times[i] < 0.0));
    let mut states = vec![*start; times.len()];
    let before_times: Vec<f64> = before.iter().map(|&i| times[i]).collect();
    let earlier = solve(system, 0.0, start, scales, &before_times, method, effort)?;
    let mut cost = earlier.cost;
    for (&place, state) in before.iter().zip(earlier.states) {
        states[place] = state;
    }
    let sense = start[2].signum();
    let spin = |_: f64, y: &[f64; 8]| y[2] * sense;
    let (mut time, mut state, mut left) = (0.0, *start, after);
    while let Some(&last) = left.last() {
        let ordered: Vec<f64> = left.iter().map(|&i| times[i]).collect();
        let end = times[last];
        let leg = until(
            system, time, &state, scales, &ordered, end, &spin, method, effort,
        )?;
        cost += leg.cost;
        let reached = leg.states.len();
        for (&place, sample) in left.iter().zip(leg.states) {
            states[place] = sample;
        }
        if leg.stopped == Stop::AtTheEnd {
            break;
        }
        (time, state, left) = (leg.time, leg.end, &left[reached..]);
        state[2] = 0.0;
    }
    Ok(Solution { states, cost })
}
