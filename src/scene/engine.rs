//! The engine: what every stepped scene runs on.
//!
//! A kind of scene describes its [`Flow`]: which equations hold in which phase, what ends a phase, and how the motion goes on. The engine
//! does the rest, from top to bottom of this file: it follows the motion from phase to phase ([`Run::follow`]), sorts the times, before and
//! after the start ([`Run::at`]), repeats the run with a smaller tolerance until two runs vouch for the better one ([`to_accuracy`]), and, where none
//! will do, measures how much the motion amplifies a change of its start. Every evaluation counts against the budget of the request.

use super::motion::{Books, furthest};
use super::{Budget, Choice, Plan, Request, Solver};
use crate::error::{Error, Result, finite};
use crate::integrators::{
    AnyLeg, Cost, Effort, Kept, Leg, Passage, Stop, System, Watched, both_ways,
};

/// A motion whose equations change from phase to phase. States are N numbers.
pub(crate) trait Flow<const N: usize> {
    /// What decides which equations hold.
    type Phase: Copy + PartialEq + core::fmt::Debug;

    /// The phase and the numbers at time 0.
    fn start(&self) -> Result<(Self::Phase, [f64; N])>;

    /// Sizes below which each number counts as small.
    fn scales(&self) -> [f64; N];

    /// By how much rounding leaves the numbers at the start in doubt, for a motion that may amplify it: runs that are compared start so far apart.
    fn doubt(&self) -> [f64; N] {
        [0.0; N]
    }

    /// What every step gives back to the numbers.
    fn kept(&self) -> Kept {
        Kept::Nothing
    }

    /// The fastest rate of the motion, rad/s or 1/s: time is counted in its inverse.
    fn pace(&self) -> f64;

    /// The greatest rate at which a departure from an equilibrium may grow, 1/s; 0 if none is known.
    fn growth_rate(&self) -> f64 {
        0.0
    }

    /// The rates of the numbers.
    fn rate(&self, phase: Self::Phase, t: f64, y: &[f64; N]) -> [f64; N];

    /// Positive while the phase lasts; where it falls through zero, the phase ends. Nothing, whatever the numbers, if only the clock ends it.
    fn margin(&self, _phase: Self::Phase, _t: f64, _y: &[f64; N]) -> Option<f64> {
        None
    }

    /// When the phase that holds from time t on ends by the clock, at the latest; of what cannot be run backward.
    fn lasts_until(&self, _phase: Self::Phase, _t: f64) -> f64 {
        f64::INFINITY
    }

    /// How it goes on after the end of a phase, with the numbers there, which a jump may change.
    ///
    /// # Errors
    /// [`Error::Integration`] where it cannot go on.
    fn next(
        &self,
        phase: Self::Phase,
        _ended: Stop,
        _t: f64,
        _y: &mut [f64; N],
    ) -> Result<Self::Phase> {
        Ok(phase)
    }

    /// The motion of a phase in closed form, if there is one: numbers at the times, up to the end of the phase or of the run. What it evaluates it counts.
    fn known(&self, _: Self::Phase, _: &Ahead<'_, N>) -> Option<Result<Passage<[f64; N]>>> {
        None
    }

    /// By how much closed forms are off after so many radians and these phases.
    fn rounding(&self, angle: f64, phases: &[(f64, Self::Phase)]) -> f64 {
        OF_CLOSED_FORMS * (1.0 + angle + phases.len() as f64)
    }

    /// Distance of two states that should be the same: radians, or relative to the scale of a rate, whichever is more. If nothing else is
    /// said, each number counts in its scale, or in itself where it is more.
    fn distance(&self, a: &(Self::Phase, [f64; N]), b: &(Self::Phase, [f64; N])) -> f64 {
        let scales = self.scales();
        let sizes = core::array::from_fn(|n| greater(scales[n], b.1[n].abs()));
        apart(&a.1, &b.1, &sizes)
    }

    /// The most by which states of two runs that should be the same differ; `seen` is all that is known of the motion.
    fn furthest_apart(
        &self,
        a: &[(Self::Phase, [f64; N])],
        b: &[(Self::Phase, [f64; N])],
        _seen: &[(Self::Phase, [f64; N])],
    ) -> f64 {
        let distances = a.iter().zip(b).map(|(a, b)| self.distance(a, b));
        distances.fold(0.0, greater)
    }
}

/// What lies ahead of a motion.
#[derive(Clone, Copy)]
pub(crate) struct Ahead<'a, const N: usize> {
    /// Where it is, and when.
    pub start: (f64, &'a [f64; N]),
    /// When it is asked for, in its order.
    pub times: &'a [f64],
    /// When it ends at the latest.
    pub end: f64,
    /// Whether there is something that steps where no closed form does it.
    pub stepped: bool,
    pub budget: &'a Budget,
}

impl<const N: usize> Ahead<'_, N> {
    /// The passage in closed form, up to an event at this time, if there is one.
    pub fn in_closed_form(
        &self,
        event: Option<f64>,
        at: impl Fn(f64) -> Result<[f64; N]>,
    ) -> Result<Passage<[f64; N]>> {
        let time = event.unwrap_or(self.end);
        let times = self.times.iter().take_while(|&&t| t <= time);
        Ok(Passage {
            states: times.map(|&t| at(t)).collect::<Result<_>>()?,
            time,
            end: at(time)?,
            stopped: event.map_or(Stop::AtTheEnd, |_| Stop::AtTheEvent),
            cost: Cost::default(),
        })
    }
}

/// A phase and, if it took few steps, half of one and how long it lasted, s.
type Half<P> = (P, Option<[f64; 2]>);

/// One motion through all its phases.
#[derive(Debug, Clone)]
pub(crate) struct Trace<P, const N: usize> {
    /// Phase and numbers at the times, in their order.
    pub samples: Vec<(P, [f64; N])>,
    /// When each phase began, s, those after the start in order.
    pub phases: Vec<(f64, P)>,
    /// In the order in which the phases were followed.
    halves: Vec<Half<P>>,
    pub cost: Cost,
}

/// The same with what is known of its error.
#[derive(Debug, Clone)]
pub(crate) struct Answer<P, const N: usize> {
    pub trace: Trace<P, N>,
    /// The most by which any sample may be off, as [`Flow::distance`] counts.
    pub error: f64,
}

impl<P, const N: usize> Answer<P, N> {
    /// The motion, each sample told as a state.
    pub fn told<S>(
        &self,
        request: &Request,
        plan: Plan,
        state: impl Fn(f64, &P, &[f64; N]) -> S,
    ) -> Books<S> {
        let samples = request.times().iter().zip(&self.trace.samples);
        let states = samples.map(|(&t, (phase, y))| state(t, phase, y));
        Books::of(request, plan, (self.trace.cost, self.error), states)
    }
}

/// A motion that changes its phase more often than this is not followed further.
const MOST_PHASES: usize = 10_000_000;
/// So many phases in a row may have no duration.
const MOST_AT_ONCE: usize = 1000;

/// One run: a flow, a stepper, and how hard it works.
pub(crate) struct Run<'a, F, const N: usize> {
    pub flow: &'a F,
    pub stepper: Stepper<'a>,
    pub effort: Effort,
    pub budget: &'a Budget,
}

/// The passage of a leg.
type Follow<'a> = dyn Fn(&AnyLeg<'_>, Effort) -> Result<Passage<Vec<f64>>> + 'a;

/// What steps.
#[derive(Clone, Copy)]
pub(crate) enum Stepper<'a> {
    /// The library's own order 8.
    OrderEight,
    /// Another method, and whether its steps are of one length.
    Other(&'a Follow<'a>, bool),
    /// Closed forms from event to event: every phase must be known.
    Events,
}

impl<'a, F: Flow<N>, const N: usize> Run<'a, F, N> {
    const fn new(flow: &'a F, stepper: Stepper<'a>, effort: Effort, budget: &'a Budget) -> Self {
        Self {
            flow,
            stepper,
            effort,
            budget,
        }
    }

    /// From the start through all phases to the last of the times, which ascend, or descend into the past.
    fn follow(
        &self,
        start: (F::Phase, [f64; N]),
        times: &[f64],
        halves: &[Half<F::Phase>],
    ) -> Result<Trace<F::Phase, N>> {
        let (mut phase, mut y) = start;
        let end = times.last().copied().unwrap_or(0.0);
        self.budget.begin(end);
        let mut trace = Trace {
            samples: Vec::with_capacity(times.len()),
            phases: vec![(0.0, phase)],
            halves: Vec::new(),
            cost: Cost::default(),
        };
        let (mut now, mut at_once) = (0.0, 0);
        loop {
            let left = &times[trace.samples.len()..];
            let clock = self.flow.lasts_until(phase, now);
            let until = if clock < end { clock } else { end };
            let leg = |until: f64, effort: Effort| {
                let within = left.partition_point(|&t| (t - until) * end.signum() <= 0.0);
                let ahead = Ahead {
                    start: (now, &y),
                    times: &left[..within],
                    end: until,
                    stepped: !matches!(self.stepper, Stepper::Events),
                    budget: self.budget,
                };
                self.leg(phase, &ahead, effort)
            };
            let mut halved = None;
            if let Some(&(same, Some([half, lasted]))) = halves.get(trace.halves.len())
                && same == phase
            {
                // It ends as it did, or it is another phase.
                let late = now + 2.0 * lasted;
                let late = if late.abs() < until.abs() {
                    late
                } else {
                    until
                };
                // What even steps cannot follow is for those that are chosen.
                let passage = leg(late, Effort::Step(half)).ok();
                halved = passage.filter(|p| p.stopped == Stop::AtTheEvent || late == until);
            }
            let passage = match halved {
                Some(passage) => passage,
                None => leg(until, self.effort)?,
            };
            let (steps, lasted) = (passage.cost.steps, passage.time - now);
            let few = matches!(self.stepper, Stepper::OrderEight)
                && (1..=FEW_STEPS).contains(&steps)
                && lasted != 0.0;
            let half = few.then(|| [lasted.abs() / (2 * steps) as f64, lasted]);
            trace.halves.push((phase, half));
            trace.cost += passage.cost;
            self.budget
                .spend(passage.states.len() as u64 / 16, passage.time)?;
            let states = passage.states.into_iter();
            trace.samples.extend(states.map(|state| (phase, state)));
            at_once = if passage.time == now { at_once + 1 } else { 0 };
            (now, y) = (passage.time, passage.end);
            if passage.stopped == Stop::AtTheEnd && until == end {
                break;
            }
            phase = self.flow.next(phase, passage.stopped, now, &mut y)?;
            for &number in &y {
                finite("the state after an event", number)?;
            }
            trace.phases.push((now, phase));
            self.budget.spend(1, now)?;
            if trace.phases.len() > MOST_PHASES || at_once > MOST_AT_ONCE {
                return Err(Error::Integration {
                    reason: "the events come too close to each other; end the run earlier, or let what changes so often be smooth",
                    time: now,
                });
            }
        }
        // Samples at the very end that an event has taken the time of.
        trace.samples.resize(times.len(), (phase, y));
        Ok(trace)
    }

    /// One phase, to its end or to this time.
    fn leg(
        &self,
        phase: F::Phase,
        ahead: &Ahead<'_, N>,
        effort: Effort,
    ) -> Result<Passage<[f64; N]>> {
        if let Some(known) = self.flow.known(phase, ahead) {
            let passage = known?;
            self.budget.reached(passage.time)?;
            return Ok(passage);
        }
        let (flow, budget) = (self.flow, self.budget);
        let rate = |t: f64, y: &[f64; N]| {
            budget.count(1);
            flow.rate(phase, t, y)
        };
        let reached = |time: f64| budget.reached(time);
        let margin = |t: f64, y: &[f64; N]| flow.margin(phase, t, y).unwrap_or(f64::INFINITY);
        // What nothing moves has no size of its own, and any will do: a tolerance of nothing has no inverse.
        let sized_or_one = |size: f64| if size > NOTHING { size } else { 1.0 };
        let scales = flow.scales().map(sized_or_one);
        let ((now, y), times, end) = (ahead.start, ahead.times, ahead.end);
        let ends = flow.margin(phase, now, y).is_some();
        let any_margin = |t: f64, y: &[f64]| margin(t, &sized(y));
        let any = AnyLeg {
            rate: &|t, y, rates| rates.copy_from_slice(&rate(t, &sized(y))),
            reached: &reached,
            event: ends.then_some(&any_margin),
            start: (now, y),
            scales: &scales,
            times,
            end,
        };
        let passage = match self.stepper {
            Stepper::OrderEight => {
                let leg = Leg {
                    system: &Watched(rate, reached, flow.growth_rate()) as &dyn System<N>,
                    kept: flow.kept(),
                    start: (now, y),
                    scales: &scales,
                    times,
                    end,
                };
                return leg.follow(ends.then_some(&margin), effort);
            }
            Stepper::Other(follow, _) => follow(&any, effort)?,
            Stepper::Events => return Err(NO_STEPS),
        };
        Ok(Passage {
            states: passage.states.iter().map(|y| sized(y)).collect(),
            time: passage.time,
            end: sized(&passage.end),
            stopped: passage.stopped,
            cost: passage.cost,
        })
    }

    /// The samples at times in any order, before and after the start alike. Phases that another run has taken in few steps are taken in twice as many:
    /// two tolerances might give both the same.
    pub fn at(
        &self,
        start: (F::Phase, [f64; N]),
        times: &[f64],
        halves: &[Half<F::Phase>],
    ) -> Result<Trace<F::Phase, N>> {
        let (mut phases, mut passed, mut cost) = (Vec::new(), Vec::new(), Cost::default());
        let samples = both_ways(times, |times| {
            let done = passed.len().min(halves.len());
            let trace = self.follow(start, times, &halves[done..])?;
            passed.extend(trace.halves);
            cost += trace.cost;
            phases = trace.phases;
            Ok(trace.samples)
        })?;
        Ok(Trace {
            samples,
            phases,
            halves: passed,
            cost,
        })
    }
}

const NO_STEPS: Error = Error::Solver {
    condition: "the solver events must be given a scene with closed forms between events",
};
const ONLY_FOR_TOPS: Error = Error::Solver {
    condition: "the geometric solvers (rotations, moser-veselov, kick-drift, munthe-kaas, dormand-prince-8) are for tops",
};

/// So many numbers of a slice; it has as many.
fn sized<const N: usize>(slice: &[f64]) -> [f64; N] {
    core::array::from_fn(|n| slice[n])
}

/// Tolerances of two runs that are compared: of order 8 the looser run costs half as much as the tighter.
const APART: f64 = 100.0;
/// Of the distance of two runs, the error of the better one is taken for this share times [`APART`] over the ratio of their tolerances.
/// Errors in proportion to the tolerance would make it a hundredth.
const SHARE: f64 = 0.2;
/// Two runs further apart than this have nothing to say of each other: then the distance itself is told.
const TOGETHER: f64 = 0.05;
/// The error of a run of a few steps, in units of its tolerance.
const OF_A_STEP: f64 = 10.0;
/// The looser run of the first pair has this times the accuracy a radian: of a steady motion it is then off by the accuracy, of a fast top by four
/// times that.
const FIRST: f64 = 2.5;
/// Below this the error estimate of a step is rounding; above that it means nothing.
const LEAST_TOLERANCE: f64 = 4e-16;
const GREATEST_TOLERANCE: f64 = 1e-2;
/// Two runs are compared at so many times at least: at a single one they may agree by chance.
const CHECKS: usize = 8;
/// Shorter runs (radians) are compared where they are asked for: nothing has come back to where it was.
const SHORT: f64 = 3.0;
/// What the runs differ by at a time that was not asked for counts so much.
const CHECKED: f64 = 0.5;
/// A phase of at most so many steps is compared with one of twice as many.
const FEW_STEPS: u64 = 3;
/// What rounding does to a motion that amplifies nothing, for every radian.
pub(crate) const ROUNDING: f64 = 4e-16;

/// The motion at the times of the request, with an error below its accuracy; or one run at the effort asked for.
///
/// Two runs are compared, whose tolerances lie a factor hundred apart, or whose steps lie a factor two apart, as those of every phase of few steps
/// do. Their distance is the error of the looser one; the better one, which is returned, is taken to be off by a fifth of that. Where a fifth is more
/// than the accuracy, a further run or two take their place. What is told is more: all of the distance, and what the steps may add up to, as long as it
/// is below the accuracy. A flow may depend on the tolerance of its run, which `flow` makes for it.
///
/// Runs that begin with the same rounded numbers agree on what becomes of the rounding. A flow that states the [`doubt`](Flow::doubt) about its
/// start has the looser run begin that far off, so that what the motion makes of it is part of the distance; with tolerances near rounding, twice, one way and the other.
///
/// # Errors
/// [`Error::Amplified`] where rounding, amplified by the motion, is more than the accuracy asked for: it tells by how much a change of the start
/// has grown, and at once where what rounding adds up to alone is more. Those of the run.
pub(crate) fn to_accuracy<const N: usize, F: Flow<N>>(
    request: &Request,
    solver: Solver,
    flow: impl Fn(f64) -> Result<F>,
) -> Result<Answer<F::Phase, N>> {
    match solver {
        Solver::General(method) => {
            let methods = request.methods()?;
            let follow = |leg: &AnyLeg<'_>, effort| methods.follow(method, leg, effort);
            vouched(
                request,
                Stepper::Other(&follow, !method.is_adaptive()),
                flow,
            )
        }
        Solver::ORDER_EIGHT => vouched(request, Stepper::OrderEight, flow),
        Solver::Events | Solver::Exact => vouched(request, Stepper::Events, flow),
        Solver::Geometric(_) => Err(ONLY_FOR_TOPS),
    }
}

/// The same by what steps.
///
/// # Errors
/// As for [`to_accuracy`].
pub(crate) fn vouched<const N: usize, F: Flow<N>>(
    request: &Request,
    stepper: Stepper<'_>,
    flow: impl Fn(f64) -> Result<F>,
) -> Result<Answer<F::Phase, N>> {
    let budget = &request.budget();
    if let Some(effort) = request.effort {
        let flow = &flow(tolerance_of(effort, OF_STEPS))?;
        let run = Run::new(flow, stepper, effort, budget);
        let trace = run.at(flow.start()?, request.times(), &[])?;
        let error = f64::INFINITY;
        return Ok(Answer { trace, error });
    }
    let (accuracy, count) = (request.accuracy, request.times().len());
    let first = flow(accuracy)?;
    let angle = first.pace() * request.furthest.abs();
    let sure = first.doubt() == [0.0; N];
    let times = with_checks(request, angle);
    let mut cost = Cost::default();
    let mut run = |effort, off, halves: &[Half<F::Phase>]| -> Result<(F, Trace<F::Phase, N>)> {
        let flow = flow(tolerance_of(effort, accuracy))?;
        let run = Run::new(&flow, stepper, effort, budget);
        let trace = run.at(beside(&flow, off)?, &times, halves)?;
        cost += trace.cost;
        Ok((flow, trace))
    };
    let rounding = ROUNDING * (10.0 + angle);
    let mut efforts = Efforts::new(stepper, accuracy, angle, furthest(&times));
    if rounding > accuracy {
        // No run would do. What a moment tells of the growth is told; a change of the rates grows by the angle.
        let growth = growth(&first, stepper, efforts.worse(), &times, &request.moment());
        return Err(request.amplified(rounding, growth.unwrap_or(angle)));
    }
    let mut worse = run(efforts.worse(), 1.0, &[])?.1;
    loop {
        let (flow, mut better) = run(efforts.better(), 0.0, &worse.halves)?;
        let seen = &better.samples;
        let floor = efforts.floor(better.phases.len());
        let told = |asked: &Trace<_, N>, checked: &Trace<_, N>, share: f64| {
            let asked = flow.furthest_apart(&asked.samples[..count], &seen[..count], seen);
            let checked = flow.furthest_apart(&checked.samples[count..], &seen[count..], seen);
            let apart = greater(asked, CHECKED * checked);
            let share = if apart < TOGETHER { share } else { 1.0 };
            greater(share * apart, floor) + rounding
        };
        let mut error = told(&worse, &worse, efforts.share());
        if !sure && efforts.near_rounding() {
            // Where the doubt and the steps move the run as far, they may do so against each other: not with the doubt the other way as well.
            let other = run(efforts.worse(), -1.0, &[])?.1;
            error = greater(error, told(&other, &other, efforts.share()));
        }
        if error > accuracy {
            if efforts.tighten(accuracy, error) {
                worse = if sure {
                    better
                } else {
                    efforts.spread(APART);
                    run(efforts.worse(), 1.0, &[])?.1
                };
                continue;
            }
            // Nothing is tighter, but the worse run can come nearer: then all of the distance is told. What the motion makes of rounding where nobody
            // has asked is no reason to refuse it.
            efforts.spread(APART.sqrt());
            let asked = run(efforts.worse(), SHARE, &[])?.1;
            let checked = run(efforts.worse(), 0.0, &[])?.1;
            error = told(&asked, &checked, 1.0);
        }
        if error > accuracy {
            let growth = growth(&flow, stepper, efforts.better(), &times, budget)?;
            return Err(request.amplified(error, growth));
        }
        // The runs vouch for the accuracy. Below it all of their distance is told, and what the steps may add up to: both runs may have been lucky.
        let mut whole = told(&worse, &worse, 1.0);
        if !efforts.even {
            whole += better.cost.steps as f64 * of_a_step(&flow, efforts.better, seen);
        }
        error = greater(error, whole.min(accuracy));
        better.samples.truncate(count);
        better.cost = cost;
        let trace = better;
        return Ok(Answer { trace, error });
    }
}

/// Evaluations that stand for an integral of a smooth function.
pub(crate) const AN_INTEGRAL: u64 = 60;

/// What closed forms are off by for every radian of the motion and for every event. Observed: a quarter of it.
pub(crate) const OF_CLOSED_FORMS: f64 = 2e-15;

/// Phases and numbers at the times of a request by the solver of a plan: in closed form, at so many evaluations a row; in closed forms from event
/// to event; or by steps.
///
/// # Errors
/// Those of [`to_accuracy`] and of the closed form.
pub(crate) fn solved<const N: usize, F: Flow<N> + Copy>(
    (flow, plan, request): (&F, &Plan, &Request),
    evaluations: u64,
    known: impl Fn(f64) -> Result<[f64; N]>,
) -> Result<Answer<F::Phase, N>> {
    let (times, budget) = (request.times(), &request.budget());
    let trace = match plan.solver {
        Solver::Exact => {
            let phase = flow.start()?.0;
            let mut samples = Vec::with_capacity(times.len());
            for &t in times {
                budget.spend(evaluations, t)?;
                samples.push((phase, known(t)?));
            }
            Trace {
                samples,
                phases: Vec::new(),
                halves: Vec::new(),
                cost: Cost::default(),
            }
        }
        Solver::Events => {
            let (stepper, effort) = (Stepper::Events, Effort::Tolerance(OF_CLOSED_FORMS));
            let run = Run::new(flow, stepper, effort, budget);
            run.at(flow.start()?, times, &[])?
        }
        _ => return to_accuracy(request, plan.solver, |_| Ok(*flow)),
    };
    let angle = flow.pace() * request.furthest.abs();
    let error = flow.rounding(angle, &trace.phases);
    Ok(Answer { trace, error })
}

/// What a single run of even steps is told to be within, for a flow that depends on it: little beside the error of any step.
const OF_STEPS: f64 = 1e-14;

/// The start, or one that is off by so many times the doubt about it.
fn beside<const N: usize, F: Flow<N>>(flow: &F, times: f64) -> Result<(F::Phase, [f64; N])> {
    let (phase, mut start) = flow.start()?;
    if times != 0.0 {
        for (number, doubt) in start.iter_mut().zip(flow.doubt()) {
            *number += times * doubt;
        }
    }
    Ok((phase, start))
}

/// What a step may be off by, as the motion counts it: the tolerance in all of its numbers, or in every other of them the other way.
fn of_a_step<const N: usize, F: Flow<N>>(
    flow: &F,
    tolerance: f64,
    seen: &[(F::Phase, [f64; N])],
) -> f64 {
    let scales = flow.scales();
    let off = |other: f64| {
        let moved = |y: &[f64; N], n: usize| {
            let sense = if n.is_multiple_of(2) { 1.0 } else { other };
            y[n] + sense * tolerance * (y[n].abs() + scales[n])
        };
        let there =
            |(phase, y): &(F::Phase, [f64; N])| (*phase, core::array::from_fn(|n| moved(y, n)));
        let there: Vec<_> = seen.iter().map(there).collect();
        flow.furthest_apart(&there, seen, seen)
    };
    greater(off(1.0), off(-1.0))
}

/// The greater of two; what is not a number must not pass for small.
pub(crate) fn greater(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

/// The most by which numbers differ, each in its own size.
pub(crate) fn apart<const N: usize>(a: &[f64; N], b: &[f64; N], sizes: &[f64; N]) -> f64 {
    let parts = (0..N).map(|n| (a[n] - b[n]).abs() / sizes[n]);
    parts.fold(0.0, greater)
}

/// The tolerance of a run; a run of even steps has that of its aim.
fn tolerance_of(effort: Effort, accuracy: f64) -> f64 {
    match effort {
        Effort::Tolerance(tolerance) => tolerance,
        Effort::Step(_) => accuracy,
    }
}

/// The efforts of the two runs that are compared: their steps, s, or their tolerances.
struct Efforts {
    kind: fn(f64) -> Effort,
    /// Whether their steps are of one length.
    even: bool,
    worse: f64,
    better: f64,
    /// The error that the last pair has told.
    reached: f64,
}

/// Steps of one length begin with this one, s: a quarter of a radian, or less.
pub(crate) fn longest_step(angle: f64, last: f64) -> f64 {
    last.abs().max(f64::MIN_POSITIVE) / 64.0_f64.max(4.0 * angle)
}

/// An error as small as this that halving the steps does not lessen is rounding.
const SMALL: f64 = 1e-6;

impl Efforts {
    fn new(stepper: Stepper<'_>, accuracy: f64, angle: f64, last: f64) -> Self {
        let even = matches!(stepper, Stepper::Other(_, true));
        let first = FIRST * accuracy / angle.max(2.0);
        let tolerance = first.clamp(LEAST_TOLERANCE * APART, GREATEST_TOLERANCE);
        let (kind, worse, apart): (fn(f64) -> Effort, f64, f64) = match even {
            true => (Effort::Step, longest_step(angle, last), 2.0),
            false => (Effort::Tolerance, tolerance, APART),
        };
        Self {
            kind,
            even,
            worse,
            better: worse / apart,
            reached: f64::INFINITY,
        }
    }

    fn worse(&self) -> Effort {
        (self.kind)(self.worse)
    }

    fn better(&self) -> Effort {
        (self.kind)(self.better)
    }

    /// The share of the distance of both that is taken for the error of the better.
    fn share(&self) -> f64 {
        match self.even {
            // A third for order 2, a fifteenth for order 4.
            true => 0.5,
            false => (SHARE * APART * self.better / self.worse).min(1.0),
        }
    }

    /// Whether what rounding does in a step is a hundredth, or more, of what the better run lets a step be off by.
    fn near_rounding(&self) -> bool {
        !self.even && self.better < APART * LEAST_TOLERANCE
    }

    /// Less does no pair suffice for: where every phase has few steps, two runs of the same steps agree.
    fn floor(&self, phases: usize) -> f64 {
        match self.even {
            true => 0.0,
            false => OF_A_STEP.max(phases as f64) * self.better,
        }
    }

    /// The next pair, the better of today being its worse; false if there is none.
    fn tighten(&mut self, accuracy: f64, error: f64) -> bool {
        // At least half a digit more, at most four at once: an estimate that large is none.
        let less = (0.3 * accuracy / error).clamp(1e-4, 0.3);
        let (is_last, next) = match self.even {
            true => (error >= self.reached && error < SMALL, 0.5 * self.better),
            false => (
                self.better <= LEAST_TOLERANCE,
                (self.better * less).max(LEAST_TOLERANCE),
            ),
        };
        if is_last || !error.is_finite() {
            return false;
        }
        (self.worse, self.better, self.reached) = (self.better, next, error);
        true
    }

    /// The worse of a pair of tolerances so many times the better.
    fn spread(&mut self, times: f64) {
        if !self.even {
            self.worse = times * self.better;
        }
    }
}

/// The times asked for, and so many more that two runs over this angle have something to compare.
fn with_checks(request: &Request, angle: f64) -> Vec<f64> {
    let times = request.times();
    let missing = if angle < SHORT {
        0
    } else {
        CHECKS.saturating_sub(times.len())
    };
    let last = request.furthest;
    let more = (1..=missing).map(|n| last * n as f64 / (missing + 1) as f64);
    times.iter().copied().chain(more).collect()
}

/// By what factor a change of the start has grown: a run from a start that is moved by a ten-thousand-millionth of the scales, against one from the
/// start itself.
fn growth<const N: usize, F: Flow<N>>(
    flow: &F,
    stepper: Stepper<'_>,
    effort: Effort,
    times: &[f64],
    budget: &Budget,
) -> Result<f64> {
    let (phase, start) = flow.start()?;
    let scales = flow.scales();
    let moved = if flow.doubt() == [0.0; N] {
        // In a direction of no particular meaning.
        core::array::from_fn(|n| start[n] + MOVED * scales[n] * (2.0 + n as f64).sin())
    } else {
        beside(flow, DOUBTS)?.1
    };
    let run = Run::new(flow, stepper, effort, budget);
    let here = run.at((phase, start), times, &[])?;
    let there = run.at((phase, moved), times, &[])?;
    let seen = &here.samples;
    let first = flow.furthest_apart(&[(phase, start)], &[(phase, moved)], seen);
    Ok(flow.furthest_apart(seen, &there.samples, seen) / first)
}

/// A number of this size is none: times a tolerance it has no inverse among doubles.
const NOTHING: f64 = f64::MIN_POSITIVE / (f64::EPSILON * f64::EPSILON);
/// A small displacement of the start, in units of the scales.
const MOVED: f64 = 1e-10;
/// The same in units of the doubt about the start.
const DOUBTS: f64 = 1e4;

/// This plan, or what the request asks for by its name.
///
/// # Errors
/// [`Error::Solver`] says which solvers the kind has.
pub(crate) fn planned(request: &Request, plan: Plan, has: &'static str) -> Result<Plan> {
    let asked = |solver| Ok(Plan::new(solver, "asked for"));
    match request.choice {
        Choice::Auto => Ok(plan),
        Choice::Use(Solver::ORDER_EIGHT) => asked(Solver::ORDER_EIGHT),
        Choice::Use(solver @ Solver::General(_)) => {
            request.methods()?;
            asked(solver)
        }
        Choice::Use(solver) if solver == plan.solver => Ok(plan),
        Choice::Use(_) => Err(Error::Solver { condition: has }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ball on a floor: height and climb; every bounce leaves nine tenths of the speed.
    #[derive(Clone, Copy)]
    struct Ball;

    impl Flow<2> for Ball {
        type Phase = ();

        fn start(&self) -> Result<((), [f64; 2])> {
            Ok(((), [0.5, 0.0]))
        }

        fn scales(&self) -> [f64; 2] {
            [1.0; 2]
        }

        fn pace(&self) -> f64 {
            1.0
        }

        fn rate(&self, (): (), _: f64, y: &[f64; 2]) -> [f64; 2] {
            [y[1], -1.0]
        }

        fn margin(&self, (): (), _: f64, y: &[f64; 2]) -> Option<f64> {
            Some(y[0])
        }

        fn next(&self, (): (), _: Stop, _: f64, y: &mut [f64; 2]) -> Result<()> {
            *y = [0.0, -0.9 * y[1]];
            Ok(())
        }
    }

    #[test]
    fn bounces_that_pile_up_are_refused() {
        let request = Request::at([20.0]).unwrap();
        let refused = to_accuracy(&request, Solver::ORDER_EIGHT, |_| Ok(Ball));
        let piled = matches!(refused, Err(Error::Integration { .. }));
        assert!(piled, "{refused:?}");
    }
}
