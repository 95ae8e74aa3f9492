//! The steps of a run in succession.

use super::leg::Leg;
use super::tableau::{Between, Step, step, sum};
use crate::error::{Result, stopped};
use crate::integrators::real::Sums;
use crate::integrators::{Cost, System};

/// Most steps of one run: about a minute of computing.
pub(super) const MOST_STEPS: u64 = 200_000_000;

pub(super) struct Walk<'a, const N: usize, S: ?Sized> {
    pub(super) leg: &'a Leg<'a, N, S>,
    /// 1 forward in time, −1 backward.
    pub(super) sense: f64,
    pub(super) state: Sums<f64, N>,
    pub(super) time: Sums<f64, 1>,
    /// The rate at the present state.
    pub(super) rate: [f64; N],
    /// Length of the next step.
    pub(super) length: f64,
    pub(super) states: Vec<[f64; N]>,
    pub(super) cost: Cost,
}

impl<'a, const N: usize, S: System<N> + ?Sized> Walk<'a, N, S> {
    pub(super) fn new(leg: &'a Leg<'a, N, S>) -> Self {
        let (time, state) = leg.start;
        Self {
            leg,
            sense: if leg.end < time { -1.0 } else { 1.0 },
            state: Sums::new(*state),
            time: Sums::new([time]),
            rate: leg.system.rate(time, state),
            length: 0.0,
            states: Vec::with_capacity(leg.times.len()),
            cost: Cost {
                evaluations: 1,
                steps: 0,
            },
        }
    }

    /// Time left to the end, with the rounding error of the summed time.
    pub(super) fn left(&self) -> f64 {
        (self.leg.end - self.time.values[0]) - self.time.left[0]
    }

    /// A step of the fixed length, or the last one.
    pub(super) fn even(&mut self) -> Step<N> {
        let left = self.left();
        // The number of steps is whole, but for rounding.
        let last = left.abs() < 1.5 * self.length;
        let h = if last { left } else { self.length * self.sense };
        let step = self.step(h);
        self.accept(&step, last);
        step
    }

    /// A step as long as the tolerance allows.
    pub(super) fn free(&mut self, tolerance: f64) -> Result<Step<N>> {
        let mut most_growth = MOST_GROWTH;
        loop {
            let left = self.left();
            // The last two steps share what is left, so that no tiny step remains at the end.
            let cut = if left.abs() <= self.length {
                left
            } else if left.abs() < 2.0 * self.length {
                0.5 * left
            } else {
                self.length * self.sense
            };
            let step = self.step(cut);
            let error = step.error(self.leg.scales, tolerance);
            // error^(1/8), as in DOP853.
            let growth = SAFETY / error.sqrt().sqrt().sqrt();
            if error <= 1.0 {
                let length = cut.abs() * growth.clamp(LEAST_GROWTH, most_growth);
                self.length = length.min(growth_limiting(self.leg.system.growth_rate(), tolerance));
                self.accept(&step, cut == left);
                return Ok(step);
            }
            self.cost.evaluations += STAGES - 1;
            // An error that is not a number shortens the step as far as possible.
            self.length = cut.abs() * growth.max(LEAST_GROWTH);
            most_growth = 1.0;
            let time = self.time.values[0];
            if self.length <= f64::EPSILON * time.abs() || self.length == 0.0 {
                let reason = "the step became too small: the tolerance is below rounding, or the motion is not finite";
                return stopped(reason, time);
            }
            self.leg.system.reached(time)?;
        }
    }

    fn step(&self, h: f64) -> Step<N> {
        let time = self.time.values[0];
        step(self.leg.system, time, &self.state.values, &self.rate, h)
    }

    fn accept(&mut self, step: &Step<N>, last: bool) {
        self.state.add_all(step.change);
        let excess = self.leg.kept.excess(&self.state.values);
        self.state.add_all(excess);
        if last {
            self.time = Sums::new([self.leg.end]);
        } else {
            self.time.add(0, step.length);
        }
        self.rate = (self.leg.system).rate(self.time.values[0], &self.state.values);
        self.cost.evaluations += STAGES;
        self.cost.steps += 1;
    }

    /// The state a time `h` after the beginning of a step, by a step of its own.
    pub(super) fn short(&mut self, taken: &Step<N>, h: f64) -> [f64; N] {
        self.cost.evaluations += STAGES - 1;
        let short = step(self.leg.system, taken.time, &taken.state, &taken.used[0], h);
        self.restored(sum([1.0, 1.0], [&taken.state, &short.change]))
    }

    pub(super) fn between(&mut self, taken: &Step<N>) -> Between<N> {
        self.cost.evaluations += 3;
        Between::of(self.leg.system, taken, &self.rate)
    }

    pub(super) fn restored(&self, state: [f64; N]) -> [f64; N] {
        let excess = self.leg.kept.excess(&state);
        sum([1.0, 1.0], [&state, &excess])
    }

    /// The root mean square of these changes of the components, each relative to its size.
    pub(super) fn size(&self, change: &[f64; N]) -> f64 {
        let (state, scales) = (&self.state.values, self.leg.scales);
        let weighted = |n: usize| change[n] / (state[n].abs() + scales[n]);
        let squares: f64 = (0..N).map(|n| weighted(n) * weighted(n)).sum();
        (squares / N as f64).sqrt()
    }

    /// A first guess at the length of a step, from the rates and their change over a short Euler step (Hairer, Nørsett, Wanner, II.4).
    pub(super) fn first_length(&mut self, tolerance: f64) -> f64 {
        let (span, state) = (self.left(), &self.state.values);
        let rate = self.size(&self.rate);
        let short = (0.01 / rate).min(span.abs());
        let h = short.copysign(span);
        let moved = sum([1.0, h], [state, &self.rate]);
        let there = self.leg.system.rate(self.time.values[0] + h, &moved);
        let bend = self.size(&sum([1.0, -1.0], [&there, &self.rate])) / short;
        // Both are rates: the size of the first derivative and the root of the second's, which counts for components at rest.
        let pace = rate.max(bend.sqrt());
        let guess = tolerance.min(1.0).sqrt().sqrt().sqrt() * FIRST / pace;
        self.cost.evaluations += 1;
        let longest = growth_limiting(self.leg.system.growth_rate(), tolerance);
        let most = span.abs().min(longest);
        if guess > 0.0 { guess.min(most) } else { most }
    }
}

/// The length, s, of the longest step that the tolerance allows at this growth rate, 1/s; or the growth rate at which it allows steps of this length.
pub(crate) fn growth_limiting(step: f64, tolerance: f64) -> f64 {
    LONGEST * tolerance.min(1.0).sqrt().sqrt().sqrt() / step
}

/// Length of the first step as a multiple of tolerance^(1/8) divided by the rate.
const FIRST: f64 = 4.0;
/// Greatest length, likewise: twice what the tolerance would allow a motion of size 1.
const LONGEST: f64 = 14.0;
/// The constants of DOP853.
const SAFETY: f64 = 0.9;
const LEAST_GROWTH: f64 = 0.2;
const MOST_GROWTH: f64 = 6.0;
const STAGES: u64 = 12;

/// The refusal of a run beyond [`MOST_STEPS`].
pub(super) fn too_many<T>(time: f64) -> Result<T> {
    stopped("it takes more than two hundred million steps", time)
}
