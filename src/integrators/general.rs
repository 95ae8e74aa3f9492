//! The adapter to the crate `differential-equations`: systems of N numbers, samples at given times, events.

use differential_equations::error::Error as Refusal;
use differential_equations::interpolate::Interpolation;
use differential_equations::methods::ExplicitRungeKutta;
use differential_equations::ode::{ODE, OrdinaryNumericalMethod, solve_ode};
use differential_equations::prelude::{ControlFlag, Status};
use differential_equations::solout::{
    CrossingDirection, Event as Crossing, EventConfig, EventWrappedSolout, Solout,
};
use differential_equations::solution::Solution as Finished;

use crate::error::{Error, Result, finite, positive};

/// Equations y' = f(t, y) for N numbers.
pub trait System<const N: usize> {
    /// f(t, y). May be called at states that the motion never reaches; a result that is not finite makes the step fail.
    fn rate(&self, t: f64, y: &[f64; N]) -> [f64; N];
}

impl<const N: usize, F: Fn(f64, &[f64; N]) -> [f64; N]> System<N> for F {
    fn rate(&self, t: f64, y: &[f64; N]) -> [f64; N] {
        self(t, y)
    }
}

/// A method of the crate `differential-equations`, by its usual name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Method {
    /// The classical Runge–Kutta method, order 4, fixed steps.
    Rk4,
    /// Dormand and Prince, order 5(4).
    Dopri5,
    /// Dormand and Prince as programmed by Hairer, order 8(5,3).
    Dop853,
    /// Verner's most efficient pair, order 9(8).
    Verner98,
}

impl Method {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Rk4, Self::Dopri5, Self::Dop853, Self::Verner98];

    /// The name by which it is asked for.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rk4 => "rk4",
            Self::Dopri5 => "dopri5",
            Self::Dop853 => "dop853",
            Self::Verner98 => "verner98",
        }
    }

    /// Whether the step is chosen by an error estimate, and [`Effort::Tolerance`] asked for; if not, [`Effort::Step`].
    pub const fn is_adaptive(self) -> bool {
        !matches!(self, Self::Rk4)
    }
}

/// How hard a method works.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Effort {
    /// Steps of this length at most, s.
    Step(f64),
    /// Error of one step: this times |y| + scale, component by component.
    Tolerance(f64),
}

/// What a run has cost. The same on every machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Cost {
    /// Evaluations of the right-hand side.
    pub evaluations: u64,
    /// Steps taken, accepted ones.
    pub steps: u64,
}

impl core::ops::AddAssign for Cost {
    fn add_assign(&mut self, other: Self) {
        self.evaluations += other.evaluations;
        self.steps += other.steps;
    }
}

/// States at the times asked for, in their order.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution<const N: usize> {
    /// One state a time.
    pub states: Vec<[f64; N]>,
    /// What it has cost.
    pub cost: Cost,
}

/// A quantity whose zero ends a run.
pub trait Event<const N: usize> {
    /// g(t, y); the run ends where it falls through zero.
    fn value(&self, t: f64, y: &[f64; N]) -> f64;
}

impl<const N: usize, F: Fn(f64, &[f64; N]) -> f64> Event<N> for F {
    fn value(&self, t: f64, y: &[f64; N]) -> f64 {
        self(t, y)
    }
}

/// A run that ended by an event, or at its end.
#[derive(Debug, Clone, PartialEq)]
pub struct Passage<const N: usize> {
    /// States at those of the times asked for that were reached.
    pub states: Vec<[f64; N]>,
    /// Time at which the run ended.
    pub time: f64,
    /// State there.
    pub end: [f64; N],
    /// Whether an event ended it.
    pub stopped: Stop,
    /// What it has cost.
    pub cost: Cost,
}

/// What ended a [`Passage`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stop {
    /// The time was up.
    AtTheEnd,
    /// The event's quantity fell through zero.
    AtTheEvent,
}

/// Most steps of one run; more than a minute of computing.
const MOST_STEPS: usize = 20_000_000;

/// States at all of `times` (s, in any order, before and after `start_time` alike).
///
/// `scales` are the sizes below which a component counts as small: the error of a step may be tolerance × (|y| + scale) in each.
/// Each sample is reached by a step of its own from the last step before it, not by dense output, which is less exact by up to
/// four digits; it costs the evaluations of one step.
///
/// # Errors
/// [`Error::NotFinite`] for times and start; [`Error::NotPositive`] for the effort; [`Error::Integration`] where the method gives up.
pub fn solve<const N: usize>(
    system: &(impl System<N> + ?Sized),
    start_time: f64,
    start: &[f64; N],
    scales: &[f64; N],
    times: &[f64],
    method: Method,
    effort: Effort,
) -> Result<Solution<N>> {
    for &t in times {
        finite("the time", t)?;
    }
    let mut order: Vec<usize> = (0..times.len()).collect();
    order.sort_by(|&i, &j| times[i].total_cmp(&times[j]));
    let first_after = order.partition_point(|&i| times[i] < start_time);
    let (before, after) = order.split_at(first_after);
    let before: Vec<usize> = before.iter().rev().copied().collect();
    let mut states = vec![*start; times.len()];
    let mut cost = Cost::default();
    for places in [before.as_slice(), after] {
        let Some(&last) = places.last() else { continue };
        let ordered: Vec<f64> = places.iter().map(|&i| times[i]).collect();
        let never = |_: f64, _: &[f64; N]| 1.0;
        let run = Run {
            system,
            scales,
            method,
            effort,
        };
        let passage = run.until(start_time, start, &ordered, times[last], &never)?;
        cost += passage.cost;
        for (&place, state) in places.iter().zip(passage.states) {
            states[place] = state;
        }
    }
    Ok(Solution { states, cost })
}

/// From `start` at `start_time` towards `end_time`, with states at `times` (ordered, all between the two), until the event's quantity
/// falls through zero.
///
/// A quantity that is zero at the start, or negative, does not count as falling. The event is found on the method's dense output and
/// then located by secants through states that the method itself reaches; observed error: that of the run.
///
/// # Errors
/// As for [`solve`].
#[expect(
    clippy::too_many_arguments,
    reason = "a problem, its samples, its end and a method: nothing can be left out"
)]
pub fn until<const N: usize>(
    system: &(impl System<N> + ?Sized),
    start_time: f64,
    start: &[f64; N],
    scales: &[f64; N],
    times: &[f64],
    end_time: f64,
    event: &(impl Event<N> + ?Sized),
    method: Method,
    effort: Effort,
) -> Result<Passage<N>> {
    Run {
        system,
        scales,
        method,
        effort,
    }
    .until(start_time, start, times, end_time, event)
}

struct Run<'a, const N: usize, S: ?Sized> {
    system: &'a S,
    scales: &'a [f64; N],
    method: Method,
    effort: Effort,
}

impl<const N: usize, S: System<N> + ?Sized> Run<'_, N, S> {
    fn until(
        &self,
        start_time: f64,
        start: &[f64; N],
        times: &[f64],
        end_time: f64,
        event: &(impl Event<N> + ?Sized),
    ) -> Result<Passage<N>> {
        finite("the time", end_time)?;
        for &component in start {
            finite("the state at the start", component)?;
        }
        let clock = Clock {
            start: start_time,
            span: end_time - start_time,
        };
        // Components with their own tolerances: tolerance × (|y| + scale).
        let absolute = |tolerance: f64| self.scales.map(|scale| tolerance * scale);
        match (self.method, self.effort) {
            (Method::Rk4, Effort::Step(step)) => {
                let step = positive("the step", step)? / clock.span.abs();
                let make = |length: f64| {
                    let count = (length / step).ceil().max(1.0);
                    ExplicitRungeKutta::rk4(length / count).max_steps(MOST_STEPS)
                };
                self.drive(make, clock, start, times, event)
            }
            (Method::Dopri5, Effort::Tolerance(tolerance)) => {
                let tolerance = positive("the tolerance", tolerance)?;
                let make = |length: f64| {
                    let method = ExplicitRungeKutta::dopri5().max_steps(MOST_STEPS);
                    let method = method.rtol(tolerance).atol(absolute(tolerance));
                    method.h0(first_step(length))
                };
                self.drive(make, clock, start, times, event)
            }
            (Method::Dop853, Effort::Tolerance(tolerance)) => {
                let tolerance = positive("the tolerance", tolerance)?;
                let make = |length: f64| {
                    let method = ExplicitRungeKutta::dop853().max_steps(MOST_STEPS);
                    let method = method.rtol(tolerance).atol(absolute(tolerance));
                    method.h0(first_step(length))
                };
                self.drive(make, clock, start, times, event)
            }
            (Method::Verner98, Effort::Tolerance(tolerance)) => {
                let tolerance = positive("the tolerance", tolerance)?;
                let make = |length: f64| {
                    let method = ExplicitRungeKutta::rkv989e().max_steps(MOST_STEPS);
                    let method = method.rtol(tolerance).atol(absolute(tolerance));
                    method.h0(first_step(length))
                };
                self.drive(make, clock, start, times, event)
            }
            _ => Err(Error::Integration {
                reason: "rk4 must be given a step, every other method a tolerance",
                time: start_time,
            }),
        }
    }

    /// One run of the crate's loop from phase 0 to 1, then a short one to each sample and to the event, from the step before it: dense
    /// output loses up to four digits against the steps, so it serves to find the event and nothing else.
    fn drive<M>(
        &self,
        make: impl Fn(f64) -> M,
        clock: Clock,
        start: &[f64; N],
        times: &[f64],
        event: &(impl Event<N> + ?Sized),
    ) -> Result<Passage<N>>
    where
        M: OrdinaryNumericalMethod<f64, [f64; N]> + Interpolation<f64, [f64; N]>,
    {
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
        let phases: Vec<f64> = times.iter().map(|&t| clock.phase(t)).collect();
        let timed = Timed {
            system: self.system,
            clock,
        };
        let crossing = Falling { event, clock };
        let mut track = Track {
            places: Vec::with_capacity(phases.len()),
            last: (0.0, *start),
            before: (0.0, *start),
        };
        let recorder = Recorder {
            phases: &phases,
            track: &mut track,
        };
        let mut output = EventWrappedSolout::new(recorder, &crossing, 0.0, 1.0);
        let run = solve_ode(&mut make(1.0), &timed, 0.0, 1.0, start, &mut output);
        let run = run.map_err(|refusal| refused(&refusal, clock))?;
        cost += spent(&run);
        let mut reach = |from: (f64, [f64; N]), to: f64| -> Result<[f64; N]> {
            let length = to - from.0;
            if length <= NO_TIME {
                return Ok(carried(&timed, from, to));
            }
            let mut end = Last(from);
            let run = solve_ode(&mut make(length), &timed, from.0, to, &from.1, &mut end);
            cost += spent(&run.map_err(|refusal| refused(&refusal, clock))?);
            Ok(carried(&timed, end.0, to))
        };
        let (stopped, end) = match (run.status, run.t.last()) {
            (Status::Interrupted, Some(&found)) => {
                let place = falling(&timed, &crossing, track.before, found, &mut reach)?;
                (Stop::AtTheEvent, place)
            }
            _ => (Stop::AtTheEnd, (1.0, carried(&timed, track.last, 1.0))),
        };
        track.places.resize(phases.len(), track.last);
        let mut states = Vec::with_capacity(phases.len());
        for (&phase, &place) in phases.iter().zip(&track.places) {
            if phase > end.0 {
                break;
            }
            states.push(reach(place, phase)?);
        }
        for &component in states.iter().chain([&end.1]).flatten() {
            finite("the state after integration", component)?;
        }
        let time = match stopped {
            Stop::AtTheEnd => clock.start + clock.span,
            Stop::AtTheEvent => clock.time(end.0),
        };
        Ok(Passage {
            states,
            time,
            end: end.1,
            stopped,
            cost,
        })
    }
}

/// Phases nearer than this are one step of Euler's method apart: the crate's loop ends within 2e-15 of its end.
const NO_TIME: f64 = 1e-14;

/// The first step: chosen by the method for the whole run, a single one for what is left of a step.
fn first_step(length: f64) -> f64 {
    if length < 1.0 { length } else { 0.0 }
}

fn spent<const N: usize>(run: &Finished<f64, [f64; N]>) -> Cost {
    Cost {
        evaluations: run.evals.function as u64,
        steps: run.steps.accepted as u64,
    }
}

/// Where the event's quantity is zero, near a phase found on dense output: Newton's method through states that the method itself
/// reaches, kept between two of which one lies before the event and one after it.
///
/// The phase found may be off by a good part of a step: where the motion is a polynomial the steps grow long, and dense output is poor.
fn falling<const N: usize, S: System<N> + ?Sized>(
    timed: &Timed<'_, S>,
    crossing: &Falling<'_, impl Event<N> + ?Sized>,
    before: (f64, [f64; N]),
    found: f64,
    reach: &mut impl FnMut((f64, [f64; N]), f64) -> Result<[f64; N]>,
) -> Result<(f64, [f64; N])> {
    let mut low = before.0;
    let mut place = (found, reach(before, found)?);
    let mut stride = (found - low).max(NO_TIME);
    while crossing.event(place.0, &place.1) > 0.0 && place.0 < 1.0 {
        low = place.0;
        stride *= 2.0;
        let phase = (place.0 + stride).min(1.0);
        place = (phase, reach(before, phase)?);
    }
    let mut high = place.0;
    for _ in 0..100 {
        let here = crossing.event(place.0, &place.1);
        if here > 0.0 {
            low = place.0;
        } else {
            high = place.0;
        }
        let there = crossing.event(place.0 + PROBE, &carried(timed, place, place.0 + PROBE));
        let correction = -here * PROBE / (there - here);
        let newton = place.0 + correction;
        // Rounding may carry the last step across a bound.
        let inside = newton >= low - NO_TIME && newton <= high + NO_TIME;
        let phase = if inside {
            newton.clamp(low, high)
        } else {
            0.5 * (low + high)
        };
        let moved = (phase - place.0).abs();
        place = (phase, reach(before, phase)?);
        if moved <= NO_TIME || high - low <= NO_TIME {
            break;
        }
    }
    Ok(place)
}

/// Step of the difference quotient that tells how fast the event's quantity falls, in phase.
const PROBE: f64 = 1e-8;

/// The state a very short while later, by one Euler step.
fn carried<const N: usize, S: System<N> + ?Sized>(
    timed: &Timed<'_, S>,
    (phase, state): (f64, [f64; N]),
    to: f64,
) -> [f64; N] {
    let mut rate = [0.0; N];
    timed.diff(phase, &state, &mut rate);
    core::array::from_fn(|i| state[i] + rate[i] * (to - phase))
}

/// The crate compares times with 2e-15 absolute, so every run is made to last from 0 to 1.
#[derive(Clone, Copy)]
struct Clock {
    start: f64,
    span: f64,
}

impl Clock {
    fn time(self, phase: f64) -> f64 {
        self.start + phase * self.span
    }

    fn phase(self, time: f64) -> f64 {
        if self.span == 0.0 {
            return 0.0;
        }
        ((time - self.start) / self.span).clamp(0.0, 1.0)
    }
}

struct Timed<'a, S: ?Sized> {
    system: &'a S,
    clock: Clock,
}

impl<const N: usize, S: System<N> + ?Sized> ODE<f64, [f64; N]> for Timed<'_, S> {
    fn diff(&self, phase: f64, y: &[f64; N], rate: &mut [f64; N]) {
        *rate = self.system.rate(self.clock.time(phase), y);
        for component in rate {
            *component *= self.clock.span;
        }
    }
}

struct Falling<'a, E: ?Sized> {
    event: &'a E,
    clock: Clock,
}

impl<const N: usize, E: Event<N> + ?Sized> Crossing<f64, [f64; N]> for Falling<'_, E> {
    fn config(&self) -> EventConfig {
        EventConfig::new(CrossingDirection::Negative, Some(1))
    }

    fn event(&self, phase: f64, y: &[f64; N]) -> f64 {
        self.event.value(self.clock.time(phase), y)
    }
}

/// What a run leaves behind: for each sample the last step before it, and the last two steps.
struct Track<const N: usize> {
    places: Vec<(f64, [f64; N])>,
    last: (f64, [f64; N]),
    before: (f64, [f64; N]),
}

/// Keeps the samples apart from the crate's own list, which then holds the event and nothing else.
struct Recorder<'a, const N: usize> {
    phases: &'a [f64],
    track: &'a mut Track<N>,
}

impl<const N: usize> Solout<f64, [f64; N]> for Recorder<'_, N> {
    fn solout<I>(
        &mut self,
        now: f64,
        before: f64,
        state: &[f64; N],
        state_before: &[f64; N],
        _interpolator: &mut I,
        _solution: &mut Finished<f64, [f64; N]>,
    ) -> ControlFlag<f64, [f64; N]>
    where
        I: Interpolation<f64, [f64; N]> + ?Sized,
    {
        let track = &mut *self.track;
        while let Some(&phase) = self.phases.get(track.places.len())
            && phase <= now
        {
            let from = if phase < now {
                (before, *state_before)
            } else {
                (now, *state)
            };
            track.places.push(from);
        }
        (track.before, track.last) = ((before, *state_before), (now, *state));
        ControlFlag::Continue
    }
}

/// Keeps the last state only.
struct Last<const N: usize>((f64, [f64; N]));

impl<const N: usize> Solout<f64, [f64; N]> for Last<N> {
    fn solout<I>(
        &mut self,
        now: f64,
        _before: f64,
        state: &[f64; N],
        _state_before: &[f64; N],
        _interpolator: &mut I,
        _solution: &mut Finished<f64, [f64; N]>,
    ) -> ControlFlag<f64, [f64; N]>
    where
        I: Interpolation<f64, [f64; N]> + ?Sized,
    {
        self.0 = (now, *state);
        ControlFlag::Continue
    }
}

fn refused<const N: usize>(refusal: &Refusal<f64, [f64; N]>, clock: Clock) -> Error {
    let (reason, phase) = match refusal {
        Refusal::MaxSteps { t, .. } => ("it takes more than twenty million steps", *t),
        Refusal::StepSize { t, .. } => (
            "the step became too small: the tolerance is below rounding, or the motion is not finite",
            *t,
        ),
        Refusal::Stiffness { t, .. } => ("the equations are stiff", *t),
        _ => ("the method gave up", 0.0),
    };
    Error::Integration {
        reason,
        time: clock.time(phase),
    }
}
