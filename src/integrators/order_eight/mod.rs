//! The explicit Runge–Kutta method of order 8 of Dormand and Prince, with samples and located events: arrays on the stack, equations
//! compiled into the step.
//!
//! * `tableau`: the coefficients, one step, and the polynomial between its ends;
//! * `event`: where within a step a quantity falls through zero;
//! * this file: the run.

mod event;
pub(in crate::integrators) mod tableau;

use super::real::Sums;
use super::{Cost, Effort, Event, Passage, Solution, Stop, System};
use crate::error::{Error, Result, finite, positive};
use event::Watch;
use tableau::{Between, Step, step};

/// What every step gives back to the state.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kept {
    /// Nothing: any system of equations.
    Nothing,
    /// Norm 1 of the quaternion that begins with this component.
    UnitQuaternion(usize),
}

impl Kept {
    /// What the state lacks of what is kept.
    #[inline(always)]
    pub(in crate::integrators) fn excess<const N: usize>(self, state: &[f64; N]) -> [f64; N] {
        let mut excess = [0.0; N];
        if let Self::UnitQuaternion(first) = self
            && let Some(&[w, x, y, z]) = state[first.min(N)..].first_chunk()
        {
            // 1/|q| - 1, from 1 - |q|².
            let square = w * w + x * x + y * y + z * z;
            let share = (1.0 - square) / (square + square.sqrt());
            for (n, component) in [w, x, y, z].into_iter().enumerate() {
                excess[first + n] = component * share;
            }
        }
        excess
    }
}

/// Equations, where they start, and what is asked of them.
#[derive(Debug, Clone, Copy)]
pub struct Leg<'a, const N: usize, S: ?Sized> {
    /// The equations.
    pub system: &'a S,
    /// What every step gives back to the state.
    pub kept: Kept,
    /// When it starts, s, and with what.
    pub start: (f64, &'a [f64; N]),
    /// Sizes below which a component counts as small: the error of a step is judged relative to |y| + scale.
    pub scales: &'a [f64; N],
    /// Samples, ordered from the start to the end, s.
    pub times: &'a [f64],
    /// When it ends, before or after the start, s.
    pub end: f64,
}

impl<const N: usize, S: System<N> + ?Sized> Leg<'_, N, S> {
    /// The states at the samples, up to the end or to the event.
    ///
    /// The error of a step is estimated as in Hairer's DOP853, from formulas of orders 5 and 3 at once, and kept below tolerance ×
    /// (|y| + scale) in the mean square of the components; or the steps have one length. The steps know nothing of the samples: one or two
    /// in a step are reached by short steps from its start, more by a polynomial of order 7 through it. State and time are sums that keep
    /// what rounding leaves over (Kahan).
    ///
    /// The event is asked for at the end of every step, and within a step where its quantity may have dipped. It is located on the polynomial
    /// and then, by Newton's method, on states that a step of the method reaches: to rounding. What counts: a quantity that is zero at the
    /// start falls only after it has risen. Of several crossings in a step one is found.
    ///
    /// Observed: order 8.0; of a free body after 25 turns the error is 40 times the tolerance, 4e-13 at 1e-14. Cost: twelve evaluations a
    /// step, eleven a sample or three a step with more than two, some thirty an event; no allocation but for the samples.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for times and start; [`Error::NotPositive`] for the effort; [`Error::Integration`] where the step would become
    /// nothing, or there are more than 2·10⁸ of them; those of [`System::reached`].
    ///
    /// Source: E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential Equations I*, II.5, II.6 and II.10.
    pub fn follow(
        &self,
        event: Option<&dyn Event<N>>,
        effort: Effort,
    ) -> Result<Passage<[f64; N]>> {
        for &t in self.times.iter().chain([&self.start.0, &self.end]) {
            finite("the time", t)?;
        }
        for &component in self.start.1 {
            finite("the state at the start", component)?;
        }
        let pace = match effort {
            Effort::Step(step) => Pace::Even(positive("the step", step)?),
            Effort::Tolerance(tolerance) => Pace::Free(positive("the tolerance", tolerance)?),
        };
        Walk::new(self).follow(event, pace)
    }
}

/// States at all of `times` (s, in any order, before and after 0 alike) of the motion that starts with `start` at time 0: [`Leg::follow`], both ways.
///
/// # Errors
/// As there.
///
/// ```
/// use spinning_bodies::integrators::{Effort, Kept, order_eight};
/// let pendulum = |_: f64, y: &[f64; 2]| [y[1], -y[0].sin()];
/// let run = order_eight(&pendulum, Kept::Nothing, &[0.0, 1.0], &[1.0; 2], &[10.0], Effort::Tolerance(1e-12))?;
/// let [angle, rate] = run.states[0];
/// assert!((rate * rate / 2.0 - angle.cos() + 0.5).abs() < 1e-12);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn order_eight<const N: usize, S: System<N> + ?Sized>(
    system: &S,
    kept: Kept,
    start: &[f64; N],
    scales: &[f64; N],
    times: &[f64],
    effort: Effort,
) -> Result<Solution<N>> {
    let mut order: Vec<usize> = (0..times.len()).collect();
    order.sort_by(|&i, &j| times[i].total_cmp(&times[j]));
    let (before, after) = order.split_at(order.partition_point(|&i| times[i] < 0.0));
    let before: Vec<usize> = before.iter().rev().copied().collect();
    let mut states = vec![*start; times.len()];
    let mut cost = Cost::default();
    for places in [before.as_slice(), after] {
        let ordered: Vec<f64> = places.iter().map(|&i| times[i]).collect();
        let Some(&end) = ordered.last() else { continue };
        let leg = Leg {
            system,
            kept,
            start: (0.0, start),
            scales,
            times: &ordered,
            end,
        };
        let passage = leg.follow(None, effort)?;
        cost += passage.cost;
        for (&place, state) in places.iter().zip(passage.states) {
            states[place] = state;
        }
    }
    Ok(Solution { states, cost })
}

#[derive(Clone, Copy)]
enum Pace {
    Even(f64),
    Free(f64),
}

/// Most steps of one run; about a minute of computing.
const MOST_STEPS: u64 = 200_000_000;

/// Samples in a step that are worth a step of their own each.
const FEW: usize = 2;

struct Walk<'a, const N: usize, S: ?Sized> {
    leg: &'a Leg<'a, N, S>,
    /// Backward or forward in time.
    sense: f64,
    state: Sums<f64, N>,
    time: Sums<f64, 1>,
    /// The rate here.
    rate: [f64; N],
    /// Length of the next step.
    length: f64,
    states: Vec<[f64; N]>,
    cost: Cost,
}

/// A step that was taken.
struct Taken<const N: usize> {
    step: Step<N>,
    /// Where it began.
    time: f64,
    state: [f64; N],
    rate: [f64; N],
    length: f64,
}

impl<'a, const N: usize, S: System<N> + ?Sized> Walk<'a, N, S> {
    fn new(leg: &'a Leg<'a, N, S>) -> Self {
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

    fn follow(mut self, event: Option<&dyn Event<N>>, pace: Pace) -> Result<Passage<[f64; N]>> {
        let leg = self.leg;
        let first = leg.start.1;
        while leg.times.get(self.states.len()) == Some(&leg.start.0) {
            self.states.push(*first);
        }
        let mut watch = event.map(|event| Watch::new(event, &self));
        if let Pace::Free(tolerance) = pace {
            self.length = self.first_length(tolerance);
        } else if let Pace::Even(longest) = pace {
            let count = (self.left().abs() / longest).ceil();
            if count > MOST_STEPS as f64 {
                return Err(too_many(leg.start.0));
            }
            self.length = self.left().abs() / count.max(1.0);
        }
        while self.left() * self.sense > 0.0 {
            let taken = match pace {
                Pace::Even(_) => self.even(),
                Pace::Free(tolerance) => self.free(tolerance)?,
            };
            leg.system.reached(self.time.values[0])?;
            if self.cost.steps > MOST_STEPS {
                return Err(too_many(taken.time));
            }
            for &component in &self.state.values {
                finite("the state after integration", component)?;
            }
            if let Some(watch) = &mut watch
                && let Some(part) = watch.falls(&mut self, &taken)
            {
                let (time, end) = watch.located(&mut self, &taken, part);
                self.sample(&taken, time);
                return Ok(self.passage(time, end, Stop::AtTheEvent));
            }
            let now = self.time.values[0];
            self.sample(&taken, now);
        }
        let end = self.state.values;
        // Samples at the very end.
        self.states.resize(leg.times.len(), end);
        Ok(self.passage(leg.end, end, Stop::AtTheEnd))
    }

    fn passage(self, time: f64, end: [f64; N], stopped: Stop) -> Passage<[f64; N]> {
        Passage {
            states: self.states,
            time,
            end,
            stopped,
            cost: self.cost,
        }
    }

    /// From here to the end; with what rounding has left of the time so far.
    fn left(&self) -> f64 {
        (self.leg.end - self.time.values[0]) - self.time.left[0]
    }

    /// A step of the one length, or the last of them.
    fn even(&mut self) -> Taken<N> {
        let left = self.left();
        // The count of steps is whole, but for rounding.
        let last = left.abs() < 1.5 * self.length;
        let h = if last { left } else { self.length * self.sense };
        let step = self.step(h);
        self.accept(step, h, last)
    }

    /// A step as long as the tolerance allows.
    fn free(&mut self, tolerance: f64) -> Result<Taken<N>> {
        let mut most_growth = MOST_GROWTH;
        loop {
            let left = self.left();
            // The last two steps share what is left: no crumb at the end.
            let cut = if left.abs() <= self.length {
                left
            } else if left.abs() < 2.0 * self.length {
                0.5 * left
            } else {
                self.length * self.sense
            };
            let step = self.step(cut);
            let error = step.error(&self.state.values, self.leg.scales, tolerance, cut);
            // error^(1/8), as DOP853 has it.
            let growth = SAFETY / error.sqrt().sqrt().sqrt();
            if error <= 1.0 {
                self.length = cut.abs() * growth.clamp(LEAST_GROWTH, most_growth);
                return Ok(self.accept(step, cut, cut == left));
            }
            self.cost.evaluations += STAGES - 1;
            // Not a number: as far off as can be.
            let shrink = if growth > LEAST_GROWTH {
                growth
            } else {
                LEAST_GROWTH
            };
            self.length = cut.abs() * shrink;
            most_growth = 1.0;
            let time = self.time.values[0];
            if self.length <= f64::EPSILON * time.abs() || self.length == 0.0 {
                return Err(Error::Integration {
                    reason: "the step became too small: the tolerance is below rounding, or the motion is not finite",
                    time,
                });
            }
            self.leg.system.reached(time)?;
        }
    }

    fn step(&self, h: f64) -> Step<N> {
        let time = self.time.values[0];
        step(self.leg.system, time, &self.state.values, &self.rate, h)
    }

    fn accept(&mut self, step: Step<N>, h: f64, last: bool) -> Taken<N> {
        let taken = Taken {
            time: self.time.values[0],
            state: self.state.values,
            rate: self.rate,
            length: h,
            step,
        };
        self.state.add_all(taken.step.change);
        let excess = self.leg.kept.excess(&self.state.values);
        self.state.add_all(excess);
        if last {
            self.time = Sums::new([self.leg.end]);
        } else {
            self.time.add(0, h);
        }
        self.rate = (self.leg.system).rate(self.time.values[0], &self.state.values);
        self.cost.evaluations += STAGES;
        self.cost.steps += 1;
        taken
    }

    /// The state a part of a step after its beginning, by a step of its own.
    fn short(&mut self, taken: &Taken<N>, h: f64) -> [f64; N] {
        self.cost.evaluations += STAGES - 1;
        let short = step(self.leg.system, taken.time, &taken.state, &taken.rate, h);
        self.restored(core::array::from_fn(|n| taken.state[n] + short.change[n]))
    }

    fn between(&mut self, taken: &Taken<N>) -> Between<N> {
        self.cost.evaluations += 3;
        let whole = (&taken.step, &self.rate);
        Between::of(
            self.leg.system,
            taken.time,
            &taken.state,
            whole,
            taken.length,
        )
    }

    fn restored(&self, state: [f64; N]) -> [f64; N] {
        let excess = self.leg.kept.excess(&state);
        core::array::from_fn(|n| state[n] + excess[n])
    }

    /// The samples of a step up to this time within it.
    fn sample(&mut self, taken: &Taken<N>, until: f64) {
        let times = &self.leg.times[self.states.len()..];
        let count = times.partition_point(|&t| (t - until) * self.sense <= 0.0);
        let end = taken.time + taken.length;
        let inner = times[..count].partition_point(|&t| (t - end) * self.sense < 0.0);
        let state = |walk: &Self| walk.state.values;
        if inner > FEW {
            let between = self.between(taken);
            for &t in &times[..inner] {
                let part = (t - taken.time) / taken.length;
                self.states.push(self.restored(between.at(part)));
            }
        } else {
            for &t in &times[..inner] {
                let short = self.short(taken, t - taken.time);
                self.states.push(short);
            }
        }
        for _ in inner..count {
            self.states.push(state(self));
        }
    }

    /// A first guess at the length of a step: rates and their change over a short Euler step (Hairer, Nørsett, Wanner, II.4).
    fn first_length(&mut self, tolerance: f64) -> f64 {
        let (span, state) = (self.left(), &self.state.values);
        let size = |v: &[f64; N]| {
            let weighted = |n: usize| v[n] / (state[n].abs() + self.leg.scales[n]);
            let squares: f64 = (0..N).map(|n| weighted(n) * weighted(n)).sum();
            (squares / N as f64).sqrt()
        };
        let rate = size(&self.rate);
        let short = (0.01 / rate).min(span.abs());
        let h = short.copysign(span);
        let moved = core::array::from_fn(|n| state[n] + h * self.rate[n]);
        let there = self.leg.system.rate(self.time.values[0] + h, &moved);
        let bend = size(&core::array::from_fn(|n| there[n] - self.rate[n])) / short;
        // From the first derivative's size; for the part of a body at rest, the second's square root is a rate as well.
        let pace = rate.max(bend.sqrt());
        let length = tolerance.min(1.0).sqrt().sqrt().sqrt() * FIRST / pace;
        self.cost.evaluations += 1;
        if length.is_finite() && length > 0.0 {
            length.min(span.abs())
        } else {
            span.abs()
        }
    }
}

/// Length of the first step as a multiple of tolerance^(1/8) over the rate.
const FIRST: f64 = 4.0;
/// Those of DOP853.
const SAFETY: f64 = 0.9;
const LEAST_GROWTH: f64 = 1.0 / 3.0;
const MOST_GROWTH: f64 = 6.0;
const STAGES: u64 = 12;

fn too_many(time: f64) -> Error {
    Error::Integration {
        reason: "it takes more than two hundred million steps",
        time,
    }
}
