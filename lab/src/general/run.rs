//! The crate's integration loop with one of its methods, and the short steps to samples and events.

use differential_equations::error::Error as Refusal;
use differential_equations::interpolate::Interpolation;
use differential_equations::methods::{ExplicitRungeKutta, ImplicitRungeKutta};
use differential_equations::ode::{OrdinaryNumericalMethod, solve_ode};
use differential_equations::solution::Solution as Finished;

use spinning_bodies::integrators::{
    Cost, Effort, Event, Method, Passage, Solution, Stop, System, both_ways,
};
use spinning_bodies::{Error, Result};

use crate::finite;

use super::clock::{Clock, Timed, carried};
use super::falling::{Falling, falling};
use super::scaled::Scaled;
use super::track::Track;

/// Most steps of one run; more than a minute of computing.
const MOST_STEPS: usize = 20_000_000;

/// One of the crate's methods applied to some equations at some effort.
#[derive(Clone, Copy)]
pub struct Run<'a, const N: usize> {
    system: &'a dyn System<N>,
    scales: &'a [f64; N],
    method: Method,
    effort: Effort,
}

impl<const N: usize> core::fmt::Debug for Run<'_, N> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "{} with {:?}", self.method.name(), self.effort)
    }
}

impl<'a, const N: usize> Run<'a, N> {
    /// A run of this method; the error of a step may be tolerance × (|y| + scale) in each component, `scales` being the sizes below which it counts as small.
    pub const fn new(
        system: &'a dyn System<N>,
        scales: &'a [f64; N],
        method: Method,
        effort: Effort,
    ) -> Self {
        Self {
            system,
            scales,
            method,
            effort,
        }
    }

    /// States at all of `times` (s, in any order, before and after the start at 0).
    ///
    /// Each sample is reached by a step of its own from the last step before it, not by dense output, which is less exact by up to
    /// four digits; it costs the evaluations of one step.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for times and start; [`Error::NotPositive`] for the effort;
    /// [`Error::Integration`] if the method fails.
    pub fn solve(&self, start: &[f64; N], times: &[f64]) -> Result<Solution<[f64; N]>> {
        for &t in times {
            finite("the time", t)?;
        }
        let mut cost = Cost::default();
        let states = both_ways(times, &mut |times| {
            let never = |_: f64, _: &[f64; N]| 1.0;
            let passage = self.until(0.0, start, times, times[times.len() - 1], &never)?;
            cost += passage.cost;
            Ok(passage.states)
        })?;
        Ok(Solution { states, cost })
    }

    /// The passage from `start` at `start_time` towards `end_time`, with states at `times` (ordered, all between the two), until the event's quantity
    /// falls through zero.
    ///
    /// The quantity is evaluated at the end of every step and at seven places within it. Once it has fallen, its zero is bracketed between states that
    /// the method itself reaches, by secants within the bracket and by bisection, down to rounding. Dense output is not used, so quantities with
    /// corners (the least of several) are located as well as smooth ones. Observed error: that of the run. Cost: one step of the
    /// method for each of some ten trials.
    ///
    /// A quantity that is zero at the start can fall only after it has risen, and one that is negative at the start only after a
    /// step has ended with it positive. A quantity that falls and rises again within an eighth of a step is missed, and so is one that touches zero
    /// without passing through; use one that changes sign instead.
    ///
    /// # Errors
    /// Those of [`solve`](Self::solve).
    pub fn until(
        &self,
        start_time: f64,
        start: &[f64; N],
        times: &[f64],
        end_time: f64,
        event: &Event<'_, N>,
    ) -> Result<Passage<[f64; N]>> {
        finite("the time", end_time)?;
        for &component in start {
            finite("the state at the start", component)?;
        }
        let clock = Clock {
            start: start_time,
            span: end_time - start_time,
        };
        // Absolute tolerances: tolerance × scale for each component.
        let absolute = |tolerance: f64| self.scales.map(|scale| tolerance * scale);
        // The length in phase of equal steps, at most the given one, that fill the run.
        let even = |step: f64| -> Result<_> {
            let step = positive("the step", step)? / clock.span.abs();
            Ok(move |length: f64| length / (length / step).ceil().max(1.0))
        };
        // A macro, because each method is a type of its own.
        macro_rules! by_tolerance {
            ($method:ident, $tolerance:expr) => {{
                let tolerance = positive("the tolerance", $tolerance)?;
                let make = |length: f64| {
                    let method = ExplicitRungeKutta::$method().max_steps(MOST_STEPS);
                    let method = method.rtol(tolerance).atol(absolute(tolerance));
                    // Chosen by the method for a whole run; the whole length for what is left of a step.
                    method.h0(if length < 1.0 { length } else { 0.0 })
                };
                self.drive(&*solved(make), clock, start, times, event)
            }};
        }
        match (self.method, self.effort) {
            (Method::Rk4, Effort::Step(step)) => {
                let step = even(step)?;
                let make = |length| ExplicitRungeKutta::rk4(step(length)).max_steps(MOST_STEPS);
                self.drive(&*solved(make), clock, start, times, event)
            }
            (Method::Dopri5, Effort::Tolerance(most)) => by_tolerance!(dopri5, most),
            (Method::Dop853, Effort::Tolerance(most)) => by_tolerance!(dop853, most),
            (Method::Verner98, Effort::Tolerance(most)) => by_tolerance!(rkv989e, most),
            (Method::Gauss, Effort::Step(step)) => {
                let step = even(step)?;
                let make = |length| held(ImplicitRungeKutta::gauss_legendre_6(), step(length));
                let mut sizes = *self.scales;
                loop {
                    // Newton's method has one tolerance for all components, so they are scaled to similar magnitude.
                    let scaled = Scaled::new(self.system, event, &sizes);
                    let run = Run::new(&scaled, &[1.0; N], self.method, self.effort);
                    let start = scaled.to_units(start);
                    let value = |t: f64, y: &[f64; N]| scaled.value(t, y);
                    let driven = run.drive(&*solved(make), clock, &start, times, &value);
                    // A component that outgrows its size has rounding errors above that tolerance.
                    let stalled = matches!(driven, Err(Error::Integration { reason: STIFF, .. }));
                    if !stalled || sizes == scaled.sizes.get() {
                        return Ok(scaled.passage(driven?));
                    }
                    sizes = scaled.sizes.get();
                }
            }
            _ => Err(Error::Integration {
                reason: "rk4 and gauss must be given a step, every other method a tolerance",
                time: start_time,
            }),
        }
    }

    /// One run of the crate's loop from phase 0 to 1, then a short one from the step before it to each sample and to the event: dense
    /// output loses up to four digits against the steps.
    fn drive(
        &self,
        solve: &Solve<'_, N>,
        clock: Clock,
        start: &[f64; N],
        times: &[f64],
        event: &Event<'_, N>,
    ) -> Result<Passage<[f64; N]>> {
        let mut cost = Cost::default();
        if clock.span == 0.0 {
            return Ok(Passage {
                states: vec![*start; times.len()],
                time: clock.start,
                end: *start,
                stopped: Stop::AtTheEnd,
                cost,
            });
        }
        let timed = Timed {
            system: self.system,
            clock,
        };
        // With a rate that is not finite the crate would shorten its first step twenty million times.
        for rate in timed.system.rate(clock.start, start) {
            finite("a rate at the start", rate)?;
        }
        let crossing = Falling { event, clock };
        let mut track = Track::new(&timed, times, Some(&crossing), (0.0, *start));
        track.armed = crossing.is_armed(&timed, start);
        cost += solve(&timed, (0.0, start), 1.0, &mut track)?;
        track.went_on.clone()?;
        let mut reach = |from: (f64, [f64; N]), to: f64| -> Result<[f64; N]> {
            if to - from.0 <= NO_TIME {
                return Ok(carried(&timed, from, to));
            }
            let mut end = Track::new(&timed, &[], None, from);
            cost += solve(&timed, (from.0, &from.1), to, &mut end)?;
            end.went_on?;
            Ok(carried(&timed, end.last, to))
        };
        let (stopped, end) = if track.fallen {
            let place = falling(&crossing, track.before, track.last, &mut reach)?;
            (Stop::AtTheEvent, place)
        } else {
            (Stop::AtTheEnd, (1.0, carried(&timed, track.last, 1.0)))
        };
        // The samples replace the steps in the list, for there may be millions, and one list of them is enough.
        let mut states = track.states;
        let passed = times.partition_point(|&time| clock.phase(time) <= end.0);
        states.resize(passed, track.last.1);
        for (n, state) in states.iter_mut().enumerate() {
            let from = track.phases.get(n).unwrap_or(&track.last.0);
            *state = reach((*from, *state), clock.phase(times[n]))?;
        }
        for &component in states.iter().chain([&end.1]).flatten() {
            finite("the state after integration", component)?;
        }
        Ok(Passage {
            states,
            time: clock.time(end.0),
            end: end.1,
            stopped,
            cost,
        })
    }
}

/// The crate's loop from a phase and a state to another phase, recorded in a track: a pointer, so that all around it is compiled once for all methods.
type Solve<'a, const N: usize> =
    dyn Fn(&Timed<'_, N>, (f64, &[f64; N]), f64, &mut Track<'_, N>) -> Result<Cost> + 'a;

/// The crate's loop with the method that is made for a length in phase.
fn solved<'a, M, const N: usize>(make: impl Fn(f64) -> M + 'a) -> Box<Solve<'a, N>>
where
    M: OrdinaryNumericalMethod<f64, [f64; N]> + Interpolation<f64, [f64; N]>,
{
    Box::new(move |timed, (from, start), to, track| {
        let run = solve_ode(&mut make(to - from), timed, from, to, start, track);
        let run = run.map_err(|refusal| refused(&refusal, timed.clock))?;
        Ok(spent(&run))
    })
}

/// A difference in phase below this is bridged by one Euler step: the crate's loop ends within 2e-15 of its end.
const NO_TIME: f64 = 1e-14;

/// An implicit method with steps of one length: no error is too large, and no step may grow.
fn held<E, F, const N: usize, const O: usize, const S: usize, const I: usize>(
    method: ImplicitRungeKutta<E, F, f64, [f64; N], O, S, I>,
    step: f64,
) -> ImplicitRungeKutta<E, F, f64, [f64; N], O, S, I> {
    let method = method.max_steps(MOST_STEPS).h0(step).h_max(step);
    method.atol(f64::MAX).newton_tol(NEWTON)
}

/// Residual allowed in the stage equations, in units of the scales: a few rounding errors.
const NEWTON: f64 = 4.0 * f64::EPSILON;

fn spent<const N: usize>(run: &Finished<f64, [f64; N]>) -> Cost {
    // An implicit method differentiates by differences: one evaluation for each component, and one for all.
    let differences = run.evals.jacobian * (N + 1);
    Cost {
        evaluations: (run.evals.function + differences) as u64,
        steps: run.steps.accepted as u64,
    }
}

const STIFF: &str = "the equations are stiff: some effect is over long before a step is; without it, or to a looser accuracy, they may not be";

fn refused<const N: usize>(refusal: &Refusal<f64, [f64; N]>, clock: Clock) -> Error {
    let (reason, phase) = match refusal {
        Refusal::MaxSteps { t, .. } => (
            "it takes more than twenty million steps; a looser accuracy, an earlier end or another solver would need fewer",
            *t,
        ),
        Refusal::StepSize { t, .. } => (
            "the step became too small: the tolerance is below rounding, or the motion is not finite",
            *t,
        ),
        Refusal::Stiffness { t, .. } => (STIFF, *t),
        Refusal::LinearAlgebra { t, .. } => (
            "the implicit steps have no solution: the motion is not finite, or the step too long; a method that chooses its steps may do",
            *t,
        ),
        _ => (
            "the method cannot run these equations as they are; another solver may do",
            0.0,
        ),
    };
    Error::Integration {
        reason,
        time: clock.time(phase),
    }
}

fn positive(quantity: &'static str, value: f64) -> Result<f64> {
    if finite(quantity, value)? > 0.0 {
        Ok(value)
    } else {
        Err(Error::NotPositive { quantity, value })
    }
}
