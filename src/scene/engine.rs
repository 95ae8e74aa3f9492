//! The engine of every scene that is stepped.
//!
//! A kind of scene describes its [`Flow`]: which equations hold in which phase, what ends a phase, and how the motion goes on. The engine
//! does the rest, in the order of this file: it follows the motion from phase to phase ([`Run::follow`]), sorts the times before and
//! after the start ([`Run::at`]), repeats the run with smaller tolerances until two runs agree within the accuracy ([`to_accuracy`]), and, where no
//! two do, measures how much the motion amplifies a change of its start. Every evaluation counts against the budget of the request.

use nalgebra::{Quaternion, Vector3};

use super::motion::OpenLedger;
use super::{Budget, Choice, Plan, Request, Solver};
use crate::error::{Error, Result, each_finite, stopped};
use crate::integrators::{
    AnyLeg, Cost, Effort, Kept, Leg, Passage, Stop, System, Watched, both_ways, growth_limiting,
};

/// A motion whose equations change from phase to phase. A state has N components.
pub(crate) trait Flow<const N: usize> {
    /// The phase, which decides which equations hold.
    type Phase: Copy + PartialEq + core::fmt::Debug;

    /// What is restored after every step.
    const KEPT: Kept = Kept::Nothing;

    /// The phase and the state at time 0.
    fn start(&self) -> Result<At<Self::Phase, N>>;

    /// Sizes below which each component counts as small.
    fn scales(&self) -> [f64; N];

    /// The rounding error of each initial component, for a motion that may amplify it, over this angle, rad: compared runs start this far apart. Otherwise zero.
    fn doubt(&self, _angle: f64) -> [f64; N] {
        [0.0; N]
    }

    /// The fastest rate of the motion, rad/s or 1/s. Times this, a duration becomes the angle by which errors are counted.
    fn pace(&self) -> f64;

    /// The greatest rate at which a departure from an equilibrium may grow, 1/s; 0 if none is known.
    fn growth_rate(&self) -> f64 {
        0.0
    }

    /// The rates of the components.
    fn rate(&self, phase: Self::Phase, t: f64, y: &[f64; N]) -> [f64; N];

    /// A margin that is positive while the phase lasts and whose fall through zero ends it. `None`, in any state, if only the clock ends the phase.
    fn margin(&self, _phase: Self::Phase, _t: f64, _y: &[f64; N]) -> Option<f64> {
        None
    }

    /// The time at which the clock ends the phase that begins at t, if no event does before. Finite only for scenes that cannot be run backward.
    fn lasts_until(&self, _phase: Self::Phase, _t: f64) -> f64 {
        f64::INFINITY
    }

    /// The phase that follows one ended so, at this time and in this state, which a jump may change.
    ///
    /// # Errors
    /// [`Error::Integration`] where the motion cannot go on.
    fn next(&self, phase: Self::Phase, _: Stop, _: f64, _: &mut [f64; N]) -> Result<Self::Phase> {
        Ok(phase)
    }

    /// The motion of a phase in closed form, if there is one: states at the times, up to the end of the phase or of the run. It counts its own evaluations.
    fn known(&self, _: Self::Phase, _: &Ahead<'_, N>) -> Option<Passed<N>> {
        None
    }

    /// The error of closed forms after this angle, rad, and so many phases.
    fn rounding(&self, angle: f64, phases: usize) -> f64 {
        OF_CLOSED_FORMS * (1.0 + angle + phases as f64)
    }

    /// Distance of two states that should be equal: the greater of radians and differences relative to the scale of a rate. By default, each component's
    /// difference relative to its scale, or to its own size where that is greater.
    fn distance(&self, a: &At<Self::Phase, N>, b: &At<Self::Phase, N>) -> f64 {
        relative(&a.1, &b.1, &self.scales())
    }

    /// The greatest distance of the states of two runs that should agree; `seen` are all known states of the motion.
    fn furthest_apart(
        &self,
        a: &[At<Self::Phase, N>],
        b: &[At<Self::Phase, N>],
        _seen: &[At<Self::Phase, N>],
    ) -> f64 {
        let distances = a.iter().zip(b).map(|(a, b)| self.distance(a, b));
        distances.fold(0.0, greater)
    }
}

/// A phase and a state in it.
pub(crate) type At<P, const N: usize> = (P, [f64; N]);

/// The passage of a leg, or why there is none.
pub(crate) type Passed<const N: usize> = Result<Passage<[f64; N]>>;

/// The state at a time, in closed form.
pub(crate) type Known<'a, const N: usize> = &'a dyn Fn(f64) -> Result<[f64; N]>;

/// The leg that is to be computed.
#[derive(Clone, Copy)]
pub(crate) struct Ahead<'a, const N: usize> {
    /// Initial time, s, and state.
    pub start: (f64, &'a [f64; N]),
    /// Times of the samples, s, in their order.
    pub times: &'a [f64],
    /// The latest end time, s.
    pub end: f64,
    /// Whether a solver can step where there is no closed form.
    pub stepped: bool,
    pub budget: &'a Budget,
}

impl<const N: usize> Ahead<'_, N> {
    /// The passage in closed form, up to an event at the time `event`, if there is one.
    pub fn in_closed_form(&self, event: Option<f64>, at: Known<'_, N>) -> Passed<N> {
        let time = event.unwrap_or(self.end);
        let before = self.times.iter().take_while(|&&t| t <= time);
        Ok(Passage {
            states: before.map(|&t| at(t)).collect::<Result<_>>()?,
            time,
            end: at(time)?,
            stopped: event.map_or(Stop::AtTheEnd, |_| Stop::AtTheEvent),
            cost: Cost::default(),
        })
    }
}

/// The time at which a phase began, s, the phase, and, if it took few steps, half the length of one and the duration of the phase, s.
type Followed<P> = (f64, P, Option<[f64; 2]>);

/// One motion through all its phases.
#[derive(Debug, Clone)]
pub(crate) struct Trace<P, const N: usize> {
    /// Phase and state at each of the times, in their order.
    pub samples: Vec<At<P, N>>,
    /// The phases, in the order in which they were followed.
    pub phases: Vec<Followed<P>>,
    pub cost: Cost,
    /// The greatest error of a sample, by [`Flow::distance`]; infinite where nothing vouches for the run.
    pub error: f64,
}

impl<P, const N: usize> Trace<P, N> {
    /// A motion in one phase, without cost.
    fn of(samples: Vec<At<P, N>>) -> Self {
        Self {
            samples,
            phases: Vec::new(),
            cost: Cost::default(),
            error: f64::INFINITY,
        }
    }

    /// The motion, each sample converted into a state of the scene.
    pub fn told<S>(
        &self,
        request: &Request,
        plan: Plan,
        state: impl Fn(f64, &P, &[f64; N]) -> S,
    ) -> OpenLedger<S> {
        let samples = request.times().iter().zip(&self.samples);
        let mut states = samples.map(|(&t, (phase, y))| state(t, phase, y));
        OpenLedger::of(request, plan, (self.cost, self.error), &mut states)
    }
}

/// The most phases of one run.
const MOST_PHASES: usize = 10_000_000;
/// The most phases in a row without duration.
const MOST_AT_ONCE: usize = 1000;

/// One run: a flow, a stepper, and its effort.
pub(crate) struct Run<'a, F: Flow<N>, const N: usize> {
    pub flow: &'a F,
    pub stepper: Stepper<'a>,
    pub effort: Effort,
    pub budget: &'a Budget,
    /// Rates that are added to those of the flow.
    pub drift: Option<[f64; N]>,
    /// The phases of another run: those that it took in few steps are taken in steps half as long or shorter, because two tolerances might lead to the same
    /// steps.
    pub other: &'a [Followed<F::Phase>],
}

/// Returns the passage of a leg.
type Follow<'a> = dyn Fn(&AnyLeg<'_>, Effort) -> Result<Passage<Vec<f64>>> + 'a;

/// The solver of a run.
#[derive(Clone, Copy)]
pub(crate) enum Stepper<'a> {
    /// The library's own method of order 8.
    OrderEight,
    /// Another method, and whether its steps have one length.
    Other(&'a Follow<'a>, bool),
    /// Closed forms from event to event, for a flow that knows every phase.
    Events,
}

impl<'a, F: Flow<N>, const N: usize> Run<'a, F, N> {
    const fn new(flow: &'a F, stepper: Stepper<'a>, effort: Effort, budget: &'a Budget) -> Self {
        Self {
            flow,
            stepper,
            effort,
            budget,
            drift: None,
            other: &[],
        }
    }

    /// Follows the motion from the start through all phases to the last of the times, which ascend, or descend into the past, after so many phases the other way.
    fn follow(
        &self,
        start: At<F::Phase, N>,
        times: &[f64],
        done: usize,
    ) -> Result<Trace<F::Phase, N>> {
        let (mut phase, mut y) = start;
        let end = times.last().copied().unwrap_or(0.0);
        self.budget.begin(end);
        let mut trace = Trace::of(Vec::with_capacity(times.len()));
        let (mut now, mut at_once) = (0.0, 0);
        loop {
            let left = &times[trace.samples.len()..];
            let clock = self.flow.lasts_until(phase, now);
            let until = if clock < end { clock } else { end };
            let leg = |until: f64, longest: f64| {
                let within = left.partition_point(|&t| (t - until) * end.signum() <= 0.0);
                let ahead = Ahead {
                    start: (now, &y),
                    times: &left[..within],
                    end: until,
                    stepped: !matches!(self.stepper, Stepper::Events),
                    budget: self.budget,
                };
                self.leg(phase, &ahead, longest)
            };
            let seen = self.other.get(done + trace.phases.len());
            let half = seen.and_then(|&(_, same, half)| half.filter(|_| same == phase));
            let halved = half.and_then(|[half, lasted]| {
                // The half steps are used if the phase ends by an event again; otherwise it is another phase.
                let later = now + 2.0 * lasted;
                let sooner = later.abs() < until.abs();
                let late = if sooner { later } else { until };
                let passage = leg(late, half).ok();
                passage.filter(|p| p.stopped == Stop::AtTheEvent || !sooner)
            });
            let passage = halved.map_or_else(|| leg(until, f64::INFINITY), Ok)?;
            let (steps, lasted) = (passage.cost.steps, passage.time - now);
            let few = matches!(self.stepper, Stepper::OrderEight)
                && (1..=FEW_STEPS).contains(&steps)
                && lasted != 0.0;
            let half = few.then(|| [lasted.abs() / (2 * steps) as f64, lasted]);
            trace.phases.push((now, phase, half));
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
            each_finite("the state after an event", y)?;
            self.budget.spend(1, now)?;
            if trace.phases.len() >= MOST_PHASES || at_once > MOST_AT_ONCE {
                let reason = "the events come too close to each other; end the run earlier, or let what changes so often be smooth";
                return stopped(reason, now);
            }
        }
        // Samples at the end time, where the last event took place.
        trace.samples.resize(times.len(), (phase, y));
        Ok(trace)
    }

    /// One phase, to its end or to the end of the leg, in steps of order 8 that are no longer than `longest`, s.
    fn leg(&self, phase: F::Phase, ahead: &Ahead<'_, N>, longest: f64) -> Passed<N> {
        if let Some(known) = self.flow.known(phase, ahead) {
            let passage = known?;
            self.budget.reached(passage.time)?;
            return Ok(passage);
        }
        let (flow, budget) = (self.flow, self.budget);
        let rate = |t: f64, y: &[f64; N]| {
            budget.count(1);
            let mut rates = flow.rate(phase, t, y);
            if let Some(drift) = &self.drift {
                add(&mut rates, 1.0, drift);
            }
            rates
        };
        let reached = |time: f64| budget.reached(time);
        let margin = |t: f64, y: &[f64; N]| flow.margin(phase, t, y).unwrap_or(f64::INFINITY);
        // A component that nothing moves has no scale, and 1 will do: a scale of zero would leave the tolerance without an inverse.
        let scales = flow.scales();
        let scales = scales.map(|size| if size > NOTHING { size } else { 1.0 });
        let ((now, y), times, end) = (ahead.start, ahead.times, ahead.end);
        let ends = flow.margin(phase, now, y).is_some();
        let stroke = STROKE / (flow.lasts_until(phase, now) - now);
        let limit = growth_limiting(longest, tolerance_of(self.effort, 1.0));
        let growth = greater(flow.growth_rate(), stroke).max(limit);
        let Stepper::Other(follow, _) = self.stepper else {
            let leg = Leg {
                system: &Watched(rate, reached, growth) as &dyn System<N>,
                kept: F::KEPT,
                start: (now, y),
                scales: &scales,
                times,
                end,
            };
            return leg.follow(ends.then_some(&margin), self.effort);
        };
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
        let passage = follow(&any, self.effort)?;
        Ok(Passage {
            states: passage.states.iter().map(|y| sized(y)).collect(),
            time: passage.time,
            end: sized(&passage.end),
            stopped: passage.stopped,
            cost: passage.cost,
        })
    }

    /// The samples at times in any order, before and after the start.
    pub fn at(&self, start: At<F::Phase, N>, times: &[f64]) -> Result<Trace<F::Phase, N>> {
        let mut whole = Trace::of(Vec::new());
        whole.samples = both_ways(times, &mut |times| {
            let trace = self.follow(start, times, whole.phases.len())?;
            whole.phases.extend(trace.phases);
            whole.cost += trace.cost;
            Ok(trace.samples)
        })?;
        Ok(whole)
    }

    /// The factor by which a change of the start has grown: from two runs whose starts differ by 10⁻¹⁰ of the scales, or by a multiple of the
    /// doubt.
    fn growth(&self, angle: f64, times: &[f64]) -> Result<f64> {
        let flow = self.flow;
        let (phase, start) = flow.start()?;
        let mut moved = beside(flow, angle, DOUBTS)?.1;
        if flow.doubt(angle) == [0.0; N] {
            // An arbitrary direction.
            for (n, scale) in flow.scales().iter().enumerate() {
                moved[n] += MOVED * scale * (2.0 + n as f64).sin();
            }
        }
        let here = self.at((phase, start), times)?;
        let there = self.at((phase, moved), times)?;
        let seen = &here.samples;
        let first = flow.furthest_apart(&[(phase, start)], &[(phase, moved)], seen);
        Ok(flow.furthest_apart(seen, &there.samples, seen) / first)
    }
}

/// The components of a slice of length N.
fn sized<const N: usize>(slice: &[f64]) -> [f64; N] {
    *slice.first_chunk().unwrap_or(&[0.0; N])
}

/// For a [`Flow::doubt`] several times the possible rounding error of a start: of a rate along each axis, as a fraction of the whole, and half the turn in space, rad. They
/// differ, so that the displacement lacks the symmetries of the motion.
pub(crate) const DOUBT: [f64; 6] = [2e-14, -1.5e-14, 1.8e-14, -1.2e-14, 1e-14, 8e-15];

/// What a turn in space by [`DOUBT`] adds to the quaternion. It is mostly a tilt: a turn about the vertical grows in no motion.
pub(crate) fn tilted(q: Quaternion<f64>) -> Quaternion<f64> {
    Quaternion::from_imag(Vector3::new(DOUBT[3], DOUBT[4], DOUBT[5])) * q
}

/// Ratio of the tolerances of two compared runs; by order 8 the tighter run costs half as much again as the looser.
const APART: f64 = 20.0;
/// The same for the last two, where no tolerance is left that is tighter.
const NEARER: f64 = 3.0;
/// How far beside the better run the looser one starts, in units of the doubt, and how far its rates lead it away besides.
const BESIDE: f64 = 0.2;
const DRIFT: f64 = 0.5;
/// The error of a run of a few steps, in units of its tolerance.
const OF_A_STEP: f64 = 10.0;
/// The least tolerance: with a smaller one the error is no longer smaller, for all that is left is what steps round. The next constant is the greatest one with a
/// meaning.
const LEAST_TOLERANCE: f64 = 5e-17;
const GREATEST_TOLERANCE: f64 = 1e-2;
/// The least number of times at which two runs are compared: at a single one they may agree by chance.
const CHECKS: usize = 8;
/// Below this angle, rad, runs are compared only at the requested times, for no quantity has returned to an earlier value.
const SHORT: f64 = 3.0;
/// The reported error, in units of twice the distance of two runs and the errors of the steps: of five thousand random scenes six were off by more than that sum, two by
/// more than twice as much.
const LUCK: f64 = 2.0;
/// Weight of the distance at times that were not requested, after the first pair.
const CHECKED: f64 = 0.1;
/// A phase of at most this many steps is compared with one of twice as many.
const FEW_STEPS: u64 = 3;
/// The rate of a path of shapes, times the duration of the phase that the clock ends: it limits the steps, as a growth rate does. A path begins and
/// ends so smoothly that no error is seen in steps as long as the phase.
const STROKE: f64 = 4.0;
/// Rounding error per radian of a motion that does not amplify it.
pub(crate) const ROUNDING: f64 = 4e-16;

/// The motion at the requested times with an error below the accuracy, or by a single run at the requested effort.
///
/// Two runs are compared, whose tolerances differ by a factor of twenty, or whose steps differ by a factor of two, as do those in phases of few
/// steps. Their distance is the error of the looser run; the better run, which is returned, is taken to be off by as much. Where that exceeds
/// the accuracy, one or two further runs take their place, and the better one must agree with them too. The reported error is larger: four times the
/// distance and twice the sum of the errors of the steps, as long as it is below the accuracy. A flow may depend on the tolerance of its run, which
/// `flow` receives.
///
/// Runs that begin with the same rounded state agree on what the motion makes of that rounding. If the flow states the [`doubt`](Flow::doubt) of its
/// start, the looser run begins beside the other and is led away from it on the way, so that the distance contains the effect; with tolerances
/// near rounding twice, once in each direction, and in the last pair what steps round counts twice.
///
/// # Errors
/// [`Error::Amplified`] where rounding, amplified by the motion, exceeds the accuracy, with the factor by which a change of the start
/// has grown; at once, where the sum of rounding errors alone exceeds it. Those of the run.
pub(crate) fn to_accuracy<const N: usize, F: Flow<N>>(
    request: &Request,
    solver: Solver,
    flow: &dyn Fn(f64) -> Result<F>,
) -> Result<Trace<F::Phase, N>> {
    match solver {
        Solver::General(method) => {
            let methods = request.methods()?;
            let follow = |leg: &AnyLeg<'_>, effort| methods.follow(method, leg, effort);
            let stepper = Stepper::Other(&follow, !method.is_adaptive());
            vouched(request, stepper, flow)
        }
        _ => vouched(request, Stepper::OrderEight, flow),
    }
}

/// The same by a given stepper.
///
/// # Errors
/// As for [`to_accuracy`].
pub(crate) fn vouched<const N: usize, F: Flow<N>>(
    request: &Request,
    stepper: Stepper<'_>,
    flow: &dyn Fn(f64) -> Result<F>,
) -> Result<Trace<F::Phase, N>> {
    let budget = &request.budget();
    if let Some(effort) = request.effort {
        let flow = &flow(tolerance_of(effort, OF_STEPS))?;
        let run = Run::new(flow, stepper, effort, budget);
        return run.at(flow.start()?, request.times());
    }
    let (accuracy, count) = (request.accuracy, request.times().len());
    let first = flow(accuracy)?;
    let angle = first.pace() * request.furthest.abs();
    let sure = first.doubt(angle) == [0.0; N];
    let times = with_checks(request, angle);
    let mut cost = Cost::default();
    // What steps round may be amplified more than a doubt of the start is, if there is time for both.
    let drifts = !sure && angle > SHORT;
    let mut run = |effort, off, other: &[Followed<F::Phase>]| -> Result<(F, Trace<F::Phase, N>)> {
        let flow = flow(tolerance_of(effort, accuracy))?;
        let mut run = Run::new(&flow, stepper, effort, budget);
        if off != 0.0 && drifts {
            let led = |doubt: f64| off * DRIFT * doubt / request.furthest;
            run.drift = Some(flow.doubt(angle).map(led));
        }
        run.other = other;
        let trace = run.at(beside(&flow, angle, off * BESIDE)?, &times)?;
        cost += trace.cost;
        Ok((flow, trace))
    };
    let rounding = ROUNDING * (10.0 + angle);
    let mut efforts = Efforts::new(stepper, accuracy, angle, request.furthest);
    if rounding > accuracy {
        // No run would do. The growth is measured within a small budget, if that suffices.
        let budget = &request.briefly(100).budget();
        let run = Run::new(&first, stepper, efforts.worse(), budget);
        let growth = run.growth(angle, &times);
        return Err(request.amplified(rounding, growth.unwrap_or(f64::NAN)));
    }
    // Runs beside the better one, the looser one last.
    let mut others = vec![run(efforts.worse(), 1.0, &[])?.1];
    loop {
        let (flow, mut better) = run(efforts.better(), 0.0, &others[others.len() - 1].phases)?;
        let seen = &better.samples;
        let floor = efforts.floor(better.phases.len());
        let told = |asked: &Trace<_, N>, checked: &Trace<_, N>, weight: f64| {
            let asked = flow.furthest_apart(&asked.samples[..count], &seen[..count], seen);
            let checked = flow.furthest_apart(&checked.samples[count..], &seen[count..], seen);
            greater(greater(asked, weight * checked), floor) + rounding
        };
        let most = |others: &[Trace<_, N>]| {
            let errors = others.iter().map(|run| told(run, run, efforts.weight));
            errors.fold(0.0, greater)
        };
        let mut error = most(&others);
        if !sure && efforts.near_rounding() && error <= accuracy {
            // The errors of the doubt and of the steps are of one size and may cancel: they cannot with both signs of the doubt.
            others.push(run(efforts.worse(), -1.0, &[])?.1);
            error = most(&others);
        }
        if error > accuracy {
            if efforts.tighten(accuracy, error) {
                // It stays beside the next: where the motion amplifies what steps round, two runs may agree by luck, three hardly.
                others = vec![better];
                if !sure {
                    efforts.spread(APART);
                    others.push(run(efforts.worse(), 1.0, &[])?.1);
                }
                continue;
            }
            // No tighter tolerance is left, but the worse run can be brought nearer. At times that were not requested, amplified rounding is no reason
            // for an error, so there the runs have the same start, and the distance counts less. One sense of the doubt alone may cancel what steps round; and
            // what two runs round may cancel in part, so it counts once more.
            efforts.spread(NEARER);
            let checked = run(efforts.worse(), 0.0, &[])?.1;
            let told = |asked: &Trace<_, N>| told(asked, &checked, CHECKED);
            let of_steps = told(&checked);
            error = of_steps;
            for off in [1.0, -1.0].into_iter().filter(|_| !sure) {
                let asked = told(&run(efforts.worse(), off, &[])?.1);
                error = greater(error, asked + of_steps - rounding);
            }
        }
        if error > accuracy {
            let run = Run::new(&flow, stepper, efforts.better(), budget);
            return Err(request.amplified(error, run.growth(angle, &times)?));
        }
        // The runs agree within the accuracy. Below it more is reported, with the sum of the steps' errors: both may have been lucky.
        let mut whole = 2.0 * error;
        if !efforts.even {
            whole += better.cost.steps as f64 * of_a_step(&flow, efforts.better, seen);
        }
        better.error = greater(error, (LUCK * whole).min(accuracy));
        better.samples.truncate(count);
        better.cost = cost;
        return Ok(better);
    }
}

/// Evaluations by which the integral of a smooth function is counted.
pub(crate) const AN_INTEGRAL: u64 = 60;

/// Error of closed forms for every radian of the motion and for every event: four times the observed one.
pub(crate) const OF_CLOSED_FORMS: f64 = 2e-15;

/// Phases and states at the requested times by the solver of the plan: in closed form, counted as `evaluations` a row; in closed forms from event
/// to event; or by steps.
///
/// # Errors
/// Those of [`to_accuracy`] and of the closed form.
pub(crate) fn solved<const N: usize, F: Flow<N> + Copy>(
    (flow, plan, request): (&F, &Plan, &Request),
    evaluations: u64,
    known: Known<'_, N>,
) -> Result<Trace<F::Phase, N>> {
    let (times, budget) = (request.times(), &request.budget());
    let mut trace = match plan.solver {
        Solver::Exact => {
            let (phase, mut samples) = (flow.start()?.0, Vec::with_capacity(times.len()));
            for &t in times {
                budget.spend(evaluations, t)?;
                samples.push((phase, known(t)?));
            }
            Trace::of(samples)
        }
        Solver::Events => {
            let (stepper, effort) = (Stepper::Events, Effort::Tolerance(OF_CLOSED_FORMS));
            let run = Run::new(flow, stepper, effort, budget);
            run.at(flow.start()?, times)?
        }
        _ => return to_accuracy(request, plan.solver, &|_| Ok(*flow)),
    };
    let angle = flow.pace() * request.furthest.abs();
    trace.error = flow.rounding(angle, trace.phases.len());
    Ok(trace)
}

/// The tolerance that a single run with steps of one length passes to its flow: small against the error of any step.
const OF_STEPS: f64 = 1e-14;

/// The start, displaced by `times` its doubt over this angle.
fn beside<const N: usize, F: Flow<N>>(flow: &F, angle: f64, times: f64) -> Result<At<F::Phase, N>> {
    let (phase, mut start) = flow.start()?;
    if times != 0.0 {
        add(&mut start, times, &flow.doubt(angle));
    }
    Ok((phase, start))
}

/// Adds `times` others to these numbers.
#[inline]
fn add(numbers: &mut [f64], times: f64, others: &[f64]) {
    for (number, other) in numbers.iter_mut().zip(others) {
        *number += times * other;
    }
}

/// The error of a step in the flow's distance: the tolerance in all components with one sign, or with alternating signs.
fn of_a_step<const N: usize, F: Flow<N>>(flow: &F, allowed: f64, seen: &[At<F::Phase, N>]) -> f64 {
    let scales = flow.scales();
    let off = |other: f64| {
        let mut there = seen.to_vec();
        for (_, y) in &mut there {
            for (n, number) in y.iter_mut().enumerate() {
                let sense = if n.is_multiple_of(2) { 1.0 } else { other };
                *number += sense * allowed * (number.abs() + scales[n]);
            }
        }
        flow.furthest_apart(&there, seen, seen)
    };
    greater(off(1.0), off(-1.0))
}

/// The greater of two numbers; not-a-number counts as greater.
pub(crate) fn greater(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

/// The greatest difference of components, each relative to its size.
pub(crate) fn apart(a: &[f64], b: &[f64], sizes: &[f64]) -> f64 {
    let parts = (0..a.len()).map(|n| (a[n] - b[n]).abs() / sizes[n]);
    parts.fold(0.0, greater)
}

/// The same, each relative to its scale, or to its own size where that is greater.
pub(crate) fn relative(a: &[f64], b: &[f64], scales: &[f64]) -> f64 {
    let parts = (0..a.len()).map(|n| (a[n] - b[n]).abs() / greater(scales[n], b[n].abs()));
    parts.fold(0.0, greater)
}

/// The tolerance of a run; for steps of one length, the requested accuracy.
fn tolerance_of(effort: Effort, accuracy: f64) -> f64 {
    match effort {
        Effort::Tolerance(tolerance) => tolerance,
        Effort::Step(_) => accuracy,
    }
}

/// The efforts of the two compared runs: lengths of their steps, s, or tolerances.
struct Efforts {
    kind: fn(f64) -> Effort,
    /// Whether the steps have one length.
    even: bool,
    worse: f64,
    better: f64,
    /// The error estimate of the last pair.
    reached: f64,
    /// The weight of the distance at times that were not requested: if the first pair parts there, a further one must agree.
    weight: f64,
}

/// The first length, s, for steps of one length: at most a quarter of a radian.
pub(crate) fn longest_step(angle: f64, last: f64) -> f64 {
    last.abs().max(f64::MIN_POSITIVE) / 64.0_f64.max(4.0 * angle)
}

/// An error smaller than this that does not decrease when the steps are halved is rounding.
const SMALL: f64 = 1e-6;

impl Efforts {
    fn new(stepper: Stepper<'_>, accuracy: f64, angle: f64, last: f64) -> Self {
        let even = matches!(stepper, Stepper::Other(_, true));
        // A steady motion is then off by much less than the accuracy, a fast top by nearly as much.
        let first = 0.5 * accuracy / angle.max(2.0);
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
            weight: 1.0,
        }
    }

    fn worse(&self) -> Effort {
        (self.kind)(self.worse)
    }

    fn better(&self) -> Effort {
        (self.kind)(self.better)
    }

    /// Whether rounding is at least a twentieth of the error that the better run allows a step.
    fn near_rounding(&self) -> bool {
        !self.even && self.better < APART * ROUNDING
    }

    /// The least error to be reported: where every phase takes few steps, two runs with the same steps agree.
    fn floor(&self, phases: usize) -> f64 {
        match self.even {
            true => 0.0,
            false => OF_A_STEP.max(phases as f64) * self.better,
        }
    }

    /// Passes to the next pair, whose worse run is the better one of the last; false if there is none.
    fn tighten(&mut self, accuracy: f64, error: f64) -> bool {
        // At least as much tighter as a first pair, for nearer runs may agree and both be wrong; at most four digits at once, for a greater
        // estimate says nothing.
        let less = (0.3 * accuracy / error).clamp(1e-4, 1.0 / APART);
        let tighter = (self.better * less).max(LEAST_TOLERANCE);
        let (is_last, next) = match self.even {
            true => (error >= self.reached && error < SMALL, 0.5 * self.better),
            false => (self.better <= LEAST_TOLERANCE, tighter),
        };
        if is_last || !error.is_finite() {
            return false;
        }
        (self.worse, self.better) = (self.better, next);
        (self.reached, self.weight) = (error, CHECKED);
        true
    }

    /// Sets the worse tolerance to `times` the better one.
    fn spread(&mut self, times: f64) {
        if !self.even {
            self.worse = times * self.better;
        }
    }
}

/// The requested times, and as many more as the comparison of two runs over this angle needs; one of them a radian after the start, for what is let go at rest
/// and damped is fastest there.
fn with_checks(request: &Request, angle: f64) -> Vec<f64> {
    let times = request.times();
    let wanted = if angle < SHORT { 0 } else { CHECKS };
    let missing = wanted.saturating_sub(times.len());
    let last = request.furthest;
    let more = (1..=missing).map(|n| last * n as f64 / (missing + 1) as f64);
    let early = (angle >= SHORT).then(|| last / angle);
    times.iter().copied().chain(more).chain(early).collect()
}

/// Scales up to this count as zero: times a tolerance they have no finite inverse.
const NOTHING: f64 = f64::MIN_POSITIVE / (f64::EPSILON * f64::EPSILON);
/// Displacement of the start, in units of the scales.
const MOVED: f64 = 1e-10;
/// Displacement of the start, in units of its doubt.
const DOUBTS: f64 = 1e4;

/// This plan, or the solver that the request names.
///
/// # Errors
/// [`Error::Solver`] lists the solvers of the kind.
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

/// The same for a scene that cannot be run backward.
///
/// # Errors
/// As for [`planned`]; [`Error::OutOfRange`] for a time before the start.
pub(crate) fn planned_forward(request: &Request, plan: Plan, has: &'static str) -> Result<Plan> {
    request.forward()?;
    planned(request, plan, has)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ball on a floor, with height and vertical velocity; every bounce leaves nine tenths of the speed.
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
        let refused = to_accuracy(&request, Solver::ORDER_EIGHT, &|_| Ok(Ball));
        let piled = matches!(refused, Err(Error::Integration { .. }));
        assert!(piled, "{refused:?}");
    }
}
