//! The explicit Runge–Kutta method of order 8 of Dormand and Prince, with samples and located events. Its arrays stand on the stack, and
//! the equations are compiled into the step.
//!
//! * `tableau`: the coefficients, one step, and the polynomials within it;
//! * `leg`: the arguments of a run;
//! * `walk`: the steps in succession;
//! * `event`: where within a step an event's quantity falls through zero;
//! * this file: the run, its samples and its end.

mod event;
mod leg;
mod tableau;
mod walk;

use super::{Cost, Effort, Event, Passage, Solution, Stop, System, both_ways};
use crate::error::{Result, each_finite, not_negative, positive};
use event::Watch;
use tableau::Step;
use walk::{MOST_STEPS, Walk, too_many};

pub(crate) use walk::growth_limiting;

pub use leg::{Kept, Leg};

impl<const N: usize, S: System<N> + ?Sized> Leg<'_, N, S> {
    /// The states at the samples, up to the end or to the event.
    ///
    /// The error of a step is estimated as in Hairer's DOP853, from formulas of orders 5 and 3 together, and kept below tolerance ×
    /// (|y| + scale) in the root mean square of the components; or all steps have one length. Samples do not change the steps: one or two
    /// within a step are reached by short steps from its start, more of them by a polynomial of order 7 through the step. State and time are
    /// summed with their rounding errors (Kahan).
    ///
    /// The event's quantity is evaluated at the end of every step, and within a step where it may have dipped or, before it was ever positive, risen. Its zero is located on the
    /// polynomial and then, by Newton's method, on states reached by a step of the method: to rounding. A quantity that is zero at the
    /// start falls only after it has risen. Of several crossings in a step the first is found where the quantity bends like a parabola, unless they are within a
    /// sixteenth of the step; one that turns more often within a step, or more sharply, may dip unseen.
    ///
    /// Observed: order 8.0; of a free body after 25 turns the error is 40 times the tolerance, 4e-13 at 1e-14. Cost: twelve evaluations a
    /// step, eleven a sample or, where stability does not limit the steps, three a step with more than two samples, some thirty an event; only the samples are
    /// allocated.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite) for times and start; [`Error::Negative`](crate::Error::Negative) for a scale; [`Error::NotPositive`](crate::Error::NotPositive) for the effort; [`Error::Integration`](crate::Error::Integration) where the step would become
    /// zero, or there are more than 2·10⁸ of them; those of [`System::reached`].
    ///
    /// Source: E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential Equations I*, II.5, II.6 and II.10.
    ///
    /// ```
    /// use spinning_bodies::integrators::{Effort, Kept, Leg, Stop};
    /// // A swing that is let go at 1 passes through zero after a quarter period.
    /// let swing = |_: f64, y: &[f64; 2]| [y[1], -y[0]];
    /// let leg = Leg { system: &swing, kept: Kept::Nothing, start: (0.0, &[1.0, 0.0]), scales: &[1.0; 2], times: &[], end: 9.0 };
    /// let height = |_: f64, y: &[f64; 2]| y[0];
    /// let passage = leg.follow(Some(&height), Effort::Tolerance(1e-13))?;
    /// assert_eq!(passage.stopped, Stop::AtTheEvent);
    /// assert!((passage.time - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn follow(
        &self,
        event: Option<&Event<'_, N>>,
        effort: Effort,
    ) -> Result<Passage<[f64; N]>> {
        let ends = [self.start.0, self.end];
        each_finite("the time", self.times.iter().copied().chain(ends))?;
        each_finite("the state at the start", *self.start.1)?;
        for &scale in self.scales.iter().filter(|&&scale| scale != f64::INFINITY) {
            not_negative("the scale of a component", scale)?;
        }
        match effort {
            Effort::Step(step) => positive("the step", step)?,
            Effort::Tolerance(tolerance) => positive("the tolerance", tolerance)?,
        };
        Walk::new(self).follow(event, effort)
    }
}

/// States at all of `times` (s, in any order, before and after 0) of the motion that starts with `start` at time 0, by [`Leg::follow`] in both directions.
///
/// # Errors
/// Those of [`Leg::follow`].
///
/// ```
/// use spinning_bodies::integrators::{Effort, Kept, order_eight};
/// let pendulum = |_: f64, y: &[f64; 2]| [y[1], -y[0].sin()];
/// let run = order_eight(&pendulum, Kept::Nothing, &[0.0, 1.0], &[1.0; 2], &[10.0], Effort::Tolerance(1e-12))?;
/// let [angle, rate] = run.states[0];
/// assert!((rate * rate / 2.0 - angle.cos() + 0.5).abs() < 1e-12);
/// // One step takes powers of time up to the eighth exactly; the polynomial within it, up to the seventh.
/// let eighths: Vec<f64> = (0..=8).map(|n| 0.0625 * f64::from(n)).collect();
/// let error = |n: i32| -> spinning_bodies::Result<[f64; 2]> {
///     let power = |t: f64, _: &[f64; 1]| [f64::from(n) * (1.0 + t).powi(n - 1)];
///     let run = order_eight(&power, Kept::Nothing, &[1.0], &[1.0], &eighths, Effort::Step(0.5))?;
///     let off = |place: usize| (run.states[place][0] / (1.0 + eighths[place]).powi(n) - 1.0).abs();
///     Ok([(0..8).map(off).fold(0.0, f64::max), off(8)])
/// };
/// // Observed 3.2e-15 at the end and 6.9e-15 within, where the weights reach 530.
/// assert!(error(8)?[1] < 6e-15 && error(9)?[1] > 1e-9);
/// assert!(error(7)?[0] < 2e-14 && error(8)?[0] > 1e-9);
/// // Where stability limits the steps, what lies within them is as exact as what lies between them.
/// let stiff = |t: f64, y: &[f64; 1]| [1e3 * (t.cos() - y[0])];
/// let times: Vec<f64> = (0..2000).map(|n| 1e-3 * f64::from(n)).collect();
/// let run = order_eight(&stiff, Kept::Nothing, &[1.0], &[1.0], &times, Effort::Tolerance(1e-4))?;
/// let exact = |t: f64| (1e6 * t.cos() + 1e3 * t.sin() + (-1e3 * t).exp()) / (1e6 + 1.0);
/// assert!(times.iter().zip(&run.states).all(|(&t, state)| (state[0] - exact(t)).abs() < 3e-4));
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn order_eight<const N: usize, S: System<N> + ?Sized>(
    system: &S,
    kept: Kept,
    start: &[f64; N],
    scales: &[f64; N],
    times: &[f64],
    effort: Effort,
) -> Result<Solution<[f64; N]>> {
    let mut cost = Cost::default();
    let states = both_ways(times, &mut |times| {
        let leg = Leg {
            system,
            kept,
            start: (0.0, start),
            scales,
            times,
            end: times[times.len() - 1],
        };
        let passage = leg.follow(None, effort)?;
        cost += passage.cost;
        Ok(passage.states)
    })?;
    Ok(Solution { states, cost })
}

/// The greatest number of samples in a step for which a short step each is cheaper than the polynomial.
const FEW: usize = 2;
/// The last coefficient of the polynomial, in units of tolerance^(7/8), up to which a motion counts as smooth: observed in those that are, 360 at most; where samples go
/// astray, 900 and more.
const SMOOTH: f64 = 500.0;

impl<const N: usize, S: System<N> + ?Sized> Walk<'_, N, S> {
    fn follow(mut self, event: Option<&Event<'_, N>>, effort: Effort) -> Result<Passage<[f64; N]>> {
        let leg = self.leg;
        let first = leg.start.1;
        while leg.times.get(self.states.len()) == Some(&leg.start.0) {
            self.states.push(*first);
        }
        let rough;
        (self.length, rough) = match effort {
            Effort::Tolerance(tolerance) => (self.first_length(tolerance), tolerance.powf(0.875)),
            Effort::Step(longest) => {
                let count = (self.left().abs() / longest).ceil();
                if count > MOST_STEPS as f64 {
                    return too_many(leg.start.0);
                }
                (self.left().abs() / count.max(1.0), f64::INFINITY)
            }
        };
        let mut watch = event.map(|event| Watch::new(event, &self));
        let mut fall = None;
        while fall.is_none() && self.left() * self.sense > 0.0 {
            let taken = match effort {
                Effort::Step(_) => self.even(),
                Effort::Tolerance(tolerance) => self.free(tolerance)?,
            };
            leg.system.reached(self.time.values[0])?;
            if self.cost.steps > MOST_STEPS {
                return too_many(taken.time);
            }
            each_finite("the state after integration", self.state.values)?;
            fall = watch
                .as_mut()
                .and_then(|watch| watch.fall(&mut self, &taken));
            let until = fall.map_or(self.time.values[0], |(time, _)| time);
            self.sample(&taken, until, rough);
        }
        let (time, end, stopped) = match fall {
            Some((time, end)) => (time, end, Stop::AtTheEvent),
            None => (leg.end, self.state.values, Stop::AtTheEnd),
        };
        if stopped == Stop::AtTheEnd {
            // Samples at the end time itself.
            self.states.resize(leg.times.len(), end);
        }
        Ok(Passage {
            states: self.states,
            time,
            end,
            stopped,
            cost: self.cost,
        })
    }

    /// Adds the samples of a step up to the time `until` within it. `rough` is tolerance^(7/8).
    fn sample(&mut self, taken: &Step<N>, until: f64, rough: f64) {
        let times = &self.leg.times[self.states.len()..];
        let count = times.partition_point(|&t| (t - until) * self.sense <= 0.0);
        let end = self.time.values[0];
        let inner = times[..count].partition_point(|&t| (t - end) * self.sense < 0.0);
        let between = (inner > FEW).then(|| self.between(taken));
        // Where stability limits a step, the rates within it swing, and a polynomial through them goes astray.
        let between = between.filter(|between| self.size(between.last()) < SMOOTH * rough);
        for &t in &times[..inner] {
            let since = t - taken.time;
            let state = match &between {
                Some(between) => self.restored(between.at(since / taken.length)),
                None => self.short(taken, since),
            };
            self.states.push(state);
        }
        let seen = self.states.len() + count - inner;
        self.states.resize(seen, self.state.values);
    }
}
