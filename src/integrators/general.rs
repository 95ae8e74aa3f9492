//! The adapter to the crate `differential-equations`: systems of N numbers, samples at given times, events.

use differential_equations::error::Error as Refusal;
use differential_equations::interpolate::Interpolation;
use differential_equations::methods::{ExplicitRungeKutta, ImplicitRungeKutta};
use differential_equations::ode::{ODE, OrdinaryNumericalMethod, solve_ode};
use differential_equations::prelude::ControlFlag;
use differential_equations::solout::Solout;
use differential_equations::solution::Solution as Finished;

use super::scaled::Scaled;
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
    /// Gauss and Legendre's implicit method with three stages, order 6, fixed steps: symplectic and symmetric in time. A step costs ten times
    /// the evaluations of one of RK4 and several hundred times its time, for Newton's method differentiates by differences and solves 3N
    /// equations with matrices from the heap.
    ///
    /// The crate offers it with error control alone, by an estimate of order 2 that shrinks steps as if it were of order 6; and it counts
    /// rejected steps from the start of the run and calls the equations stiff at the hundredth. Here the step is held and nothing is rejected.
    Gauss,
}

impl Method {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Rk4,
        Self::Dopri5,
        Self::Dop853,
        Self::Verner98,
        Self::Gauss,
    ];

    /// The name by which it is asked for.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rk4 => "rk4",
            Self::Dopri5 => "dopri5",
            Self::Dop853 => "dop853",
            Self::Verner98 => "verner98",
            Self::Gauss => "gauss",
        }
    }

    /// Whether the step is chosen by an error estimate, and [`Effort::Tolerance`] asked for; if not, [`Effort::Step`].
    pub const fn is_adaptive(self) -> bool {
        !matches!(self, Self::Rk4 | Self::Gauss)
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
    system: &dyn System<N>,
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
/// It is asked for at the end of every step. Where a step ends without it that began with it, the moment is enclosed between states that
/// the method itself reaches, by secants kept within the enclosure and by halving, down to rounding: corners (the least of several
/// quantities) are no worse than smooth ones, and dense output has no part in it. Observed error: that of the run. Cost: one step of the
/// method for each of some ten trials.
///
/// What counts: a quantity that is zero at the start falls only after it has risen, and one that is negative at the start only after a
/// step has ended with it positive. What is missed: a quantity that falls and rises again within one step, and one that touches zero
/// without going through; give such a one a quantity that changes its sign. Of three crossings in one step one is found, not
/// necessarily the first.
///
/// # Errors
/// As for [`solve`].
#[expect(
    clippy::too_many_arguments,
    reason = "a problem, its samples, its end and a method: nothing can be left out"
)]
pub fn until<const N: usize>(
    system: &dyn System<N>,
    start_time: f64,
    start: &[f64; N],
    scales: &[f64; N],
    times: &[f64],
    end_time: f64,
    event: &dyn Event<N>,
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

struct Run<'a, const N: usize> {
    system: &'a dyn System<N>,
    scales: &'a [f64; N],
    method: Method,
    effort: Effort,
}

impl<const N: usize> Run<'_, N> {
    fn until(
        &self,
        start_time: f64,
        start: &[f64; N],
        times: &[f64],
        end_time: f64,
        event: &dyn Event<N>,
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
            (Method::Gauss, Effort::Step(step)) => {
                let step = positive("the step", step)? / clock.span.abs();
                let make = |length: f64| {
                    let count = (length / step).ceil().max(1.0);
                    held(ImplicitRungeKutta::gauss_legendre_6(), length / count)
                };
                // Newton's method stops at one size for all components: they are made alike.
                let scaled = Scaled::new(self.system, event, self.scales);
                let run = Run {
                    system: &scaled,
                    scales: &[1.0; N],
                    ..*self
                };
                let start = scaled.to_units(start);
                let passage = run.drive(make, clock, &start, times, &scaled)?;
                Ok(scaled.passage(passage))
            }
            _ => Err(Error::Integration {
                reason: "rk4 and gauss must be given a step, every other method a tolerance",
                time: start_time,
            }),
        }
    }

    /// One run of the crate's loop from phase 0 to 1, then a short one to each sample and to the event, from the step before it: dense
    /// output loses up to four digits against the steps.
    fn drive<M>(
        &self,
        make: impl Fn(f64) -> M,
        clock: Clock,
        start: &[f64; N],
        times: &[f64],
        event: &dyn Event<N>,
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
        let mut track = Track::new(&phases, Some(&crossing), (0.0, *start));
        track.armed = crossing.is_armed(&timed, start);
        let run = solve_ode(&mut make(1.0), &timed, 0.0, 1.0, start, &mut track);
        cost += spent(&run.map_err(|refusal| refused(&refusal, clock))?);
        let mut reach = |from: (f64, [f64; N]), to: f64| -> Result<[f64; N]> {
            let length = to - from.0;
            if length <= NO_TIME {
                return Ok(carried(&timed, from, to));
            }
            let mut end = Track::new(&[], None, from);
            let run = solve_ode(&mut make(length), &timed, from.0, to, &from.1, &mut end);
            cost += spent(&run.map_err(|refusal| refused(&refusal, clock))?);
            Ok(carried(&timed, end.last, to))
        };
        let (stopped, end) = if track.fallen {
            let place = falling(&crossing, track.before, track.last, &mut reach)?;
            (Stop::AtTheEvent, place)
        } else {
            (Stop::AtTheEnd, (1.0, carried(&timed, track.last, 1.0)))
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

/// An implicit method with steps of one length: no error is too large, and no step may grow.
fn held<E, F, const N: usize, const O: usize, const S: usize, const I: usize>(
    method: ImplicitRungeKutta<E, F, f64, [f64; N], O, S, I>,
    step: f64,
) -> ImplicitRungeKutta<E, F, f64, [f64; N], O, S, I> {
    let method = method.max_steps(MOST_STEPS).h0(step).h_max(step);
    method.atol(f64::MAX).newton_tol(NEWTON)
}

/// What may be left of the stage equations, in units of the scales: a few roundings.
const NEWTON: f64 = 4.0 * f64::EPSILON;

/// The first step: chosen by the method for the whole run, a single one for what is left of a step.
fn first_step(length: f64) -> f64 {
    if length < 1.0 { length } else { 0.0 }
}

fn spent<const N: usize>(run: &Finished<f64, [f64; N]>) -> Cost {
    // An implicit method differentiates by differences: one evaluation a component, and one between them.
    let differences = run.evals.jacobian * (N + 1);
    Cost {
        evaluations: (run.evals.function + differences) as u64,
        steps: run.steps.accepted as u64,
    }
}

/// Where the event's quantity is zero, between the two ends of a step of which the second is past it.
///
/// Secants, with the value at an end that stays twice halved (the Illinois rule), and halving whenever three trials have not made the
/// enclosure eight times smaller: that also finds the way out of a start at zero, whose secant leads nowhere.
fn falling<const N: usize>(
    crossing: &Falling<'_, N>,
    before: (f64, [f64; N]),
    after: (f64, [f64; N]),
    reach: &mut impl FnMut((f64, [f64; N]), f64) -> Result<[f64; N]>,
) -> Result<(f64, [f64; N])> {
    let (mut low, mut high) = (before, after);
    let (mut above, mut below) = (
        crossing.value(low.0, &low.1),
        crossing.value(high.0, &high.1),
    );
    // The ordinates of the secant: the values, or a part of them.
    let (mut left, mut right, mut moved) = (above, below, None);
    let (mut width, mut trials) = (high.0 - low.0, 0);
    for _ in 0..MOST_TRIALS {
        let rounding = 2.0 * f64::EPSILON * high.0;
        if high.0 - low.0 <= 2.0 * rounding || below == 0.0 {
            break;
        }
        trials += 1;
        let secant = low.0 + (high.0 - low.0) * (left / (left - right));
        let slow = trials == 3 && high.0 - low.0 > 0.125 * width;
        let phase = if slow || above <= 0.0 || !secant.is_finite() {
            0.5 * (low.0 + high.0)
        } else {
            // A step beyond the zero, so that the far end comes near as well.
            secant.clamp(low.0 + rounding, high.0 - rounding)
        };
        if trials == 3 {
            (width, trials) = (high.0 - low.0, 0);
        }
        let place = (phase, reach(before, phase)?);
        let here = crossing.value(place.0, &place.1);
        if here > 0.0 {
            if moved == Some(End::Low) {
                right *= 0.5;
            }
            (low, above, left, moved) = (place, here, here, Some(End::Low));
        } else {
            if moved == Some(End::High) {
                left *= 0.5;
            }
            (high, below, right, moved) = (place, here, here, Some(End::High));
        }
    }
    Ok(if above > 0.0 && above < -below {
        low
    } else {
        high
    })
}

/// An end of the enclosure.
#[derive(Clone, Copy, PartialEq)]
enum End {
    Low,
    High,
}

/// Trials at most; halving alone would need sixty.
const MOST_TRIALS: usize = 200;

/// The state a very short while later, by one Euler step.
fn carried<const N: usize>(
    timed: &Timed<'_, N>,
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

struct Timed<'a, const N: usize> {
    system: &'a dyn System<N>,
    clock: Clock,
}

impl<const N: usize> ODE<f64, [f64; N]> for Timed<'_, N> {
    fn diff(&self, phase: f64, y: &[f64; N], rate: &mut [f64; N]) {
        *rate = self.system.rate(self.clock.time(phase), y);
        for component in rate {
            *component *= self.clock.span;
        }
    }
}

struct Falling<'a, const N: usize> {
    event: &'a dyn Event<N>,
    clock: Clock,
}

impl<const N: usize> Falling<'_, N> {
    fn value(&self, phase: f64, y: &[f64; N]) -> f64 {
        self.event.value(self.clock.time(phase), y)
    }

    /// Whether the quantity can fall from the start on: it is positive, or zero and about to rise.
    fn is_armed(&self, timed: &Timed<'_, N>, start: &[f64; N]) -> bool {
        let here = self.value(0.0, start);
        here > 0.0 || here == 0.0 && self.value(PROBE, &carried(timed, (0.0, *start), PROBE)) > 0.0
    }
}

/// Step of the difference that tells whether a quantity rises from zero, in phase.
const PROBE: f64 = 1e-8;

/// What a run leaves behind: for each sample the last step before it, and the last two steps. Ends the run when the event is past.
struct Track<'a, const N: usize> {
    phases: &'a [f64],
    crossing: Option<&'a Falling<'a, N>>,
    places: Vec<(f64, [f64; N])>,
    last: (f64, [f64; N]),
    before: (f64, [f64; N]),
    /// The quantity has been positive.
    armed: bool,
    /// And is no longer.
    fallen: bool,
}

impl<'a, const N: usize> Track<'a, N> {
    fn new(
        phases: &'a [f64],
        crossing: Option<&'a Falling<'a, N>>,
        start: (f64, [f64; N]),
    ) -> Self {
        Self {
            phases,
            crossing,
            places: Vec::with_capacity(phases.len()),
            last: start,
            before: start,
            armed: false,
            fallen: false,
        }
    }
}

impl<const N: usize> Solout<f64, [f64; N]> for Track<'_, N> {
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
        while let Some(&phase) = self.phases.get(self.places.len())
            && phase <= now
        {
            let from = if phase < now {
                (before, *state_before)
            } else {
                (now, *state)
            };
            self.places.push(from);
        }
        // The first call comes before the first step.
        let stepped = now > self.last.0;
        self.before = self.last;
        self.last = (now, *state);
        if let Some(crossing) = self.crossing
            && stepped
        {
            let here = crossing.value(now, state);
            self.fallen = self.armed && here <= 0.0;
            self.armed |= here > 0.0;
        }
        if self.fallen {
            ControlFlag::Terminate
        } else {
            ControlFlag::Continue
        }
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
