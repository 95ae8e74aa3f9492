//! The methods for a top under gravity alone: the geometric ones, in steps of one length, when a request names one; and power series.

use super::effects::Top;
use super::equations::{Turning, phase};
use crate::error::{Error, Result, positive, stopped};
use crate::euler_equations::{AxisMoments, Coefficients, Series};
use crate::integrators::geometric::{
    FreeSplitting, HeavySplitting, Integrator, MoserVeselov, MuntheKaas, Phase, Weight, follow,
    unit,
};
use crate::integrators::{AnyLeg, Cost, Effort, Passage, Stop};
use crate::precise::{DoubleDouble, Extended, Number, power_of_two_below};
use crate::scene::engine::{Flow, longest_step};
use crate::scene::{Geometric, Request};

/// The stepper for the engine: between two samples the steps have one length, and half of it gives twice as many.
///
/// # Errors
/// [`Error::Solver`] for a method that cannot run this top, or a single run to a tolerance.
pub(super) fn steps(
    turning: &Turning,
    method: Geometric,
    request: &Request,
) -> Result<impl Fn(&AnyLeg<'_>, Effort) -> Result<Passage<Vec<f64>>>> {
    let method = method_for(turning, method)?;
    let budget = request.budget();
    let angle = Flow::<7>::pace(turning) * request.furthest.abs();
    let longest = match request.effort {
        None => longest_step(angle, request.furthest),
        Some(Effort::Step(step)) => positive("the step", step)?,
        Some(Effort::Tolerance(_)) => {
            let condition = "a method with steps of one length must be given a step";
            return Err(Error::Solver { condition });
        }
    };
    Ok(move |leg: &AnyLeg<'_>, effort: Effort| {
        let (Effort::Step(step) | Effort::Tolerance(step)) = effort;
        let (mut now, y) = leg.start;
        budget.begin(leg.end);
        let mut phase = phase(y);
        let (mut states, mut cost) = (Vec::with_capacity(leg.times.len()), Cost::default());
        for &time in leg.times.iter().chain([&leg.end]) {
            let gap = time - now;
            let count = (gap.abs() / longest).ceil() * (longest / step).round();
            if count > 0.0 {
                let (begun, mut paid) = (now, 0);
                let mut watch = |since: f64, spent: Cost| {
                    let evaluations = spent.evaluations - paid;
                    paid = spent.evaluations;
                    budget.spend(evaluations, begun + since)
                };
                // Rounded up, or rounding might add a step.
                let step = (gap.abs() / count).next_up();
                let course = follow(&*method, &phase, &[gap], step, &mut watch)?;
                (phase, now) = (course.states[0], time);
                cost += course.cost;
            }
            states.push([&phase.l[..], &phase.q[..]].concat());
        }
        Ok(passed(states, leg.end, cost))
    })
}

/// The passage of a leg to its end, whose state is the last.
fn passed(mut states: Vec<Vec<f64>>, time: f64, cost: Cost) -> Passage<Vec<f64>> {
    Passage {
        end: states.pop().unwrap_or_default(),
        states,
        time,
        stopped: Stop::AtTheEnd,
        cost,
    }
}

/// The method for this top, if it can run it.
fn method_for(turning: &Turning, method: Geometric) -> Result<Box<dyn Integrator>> {
    let (moments, lever) = (turning.moments, turning.lever.unwrap_or_default());
    let free = lever == [0.0; 3];
    let weight = Weight::new(lever)?;
    Ok(match method {
        Geometric::Rotations(order) if free => Box::new(FreeSplitting::new(moments, order)?),
        Geometric::MoserVeselov(order) if free => Box::new(MoserVeselov::new(moments, order)?),
        Geometric::Rotations(_) | Geometric::MoserVeselov(_) => {
            let condition =
                "the solvers rotations and moser-veselov are for tops that no torque acts on";
            return Err(Error::Solver { condition });
        }
        Geometric::KickDrift(order) => Box::new(HeavySplitting::new(moments, weight, order)?),
        Geometric::MuntheKaas => Box::new(MuntheKaas::new(moments, weight)?),
        Geometric::DormandPrince8 | Geometric::PowerSeries => {
            let condition = "dormand-prince-8 and power-series have no steps of one length";
            return Err(Error::Solver { condition });
        }
    })
}

/// The order of a series.
const ORDER: usize = 36;
/// Its last terms as a part of its first, in units of the tolerance, which a step's error does not reach before a motion has amplified it 10¹⁶ times.
const PART: f64 = 1e-16;
/// Evaluations by which a series is counted: as many take its time.
const A_SERIES: u64 = 2000;

/// The stepper by power series: Ω, the vertical and the attitude are carried in 106 bits, the weight and the moments are the exact ones of the doubles given.
///
/// # Errors
/// [`Error::Solver`] for a body whose principal moments were computed, and so rounded.
pub(super) fn power_series(
    top: &Top,
    turning: &Turning,
    request: &Request,
) -> Result<impl Fn(&AnyLeg<'_>, Effort) -> Result<Passage<Vec<f64>>>> {
    if top.body.own.is_some() {
        let condition = "the solver power-series is for bodies whose own axes are principal axes";
        return Err(Error::Solver { condition });
    }
    let (budget, moments) = (request.budget(), turning.moments);
    // The unit of rates: in another, Ω and the attitude would be of different sizes, and the last terms of one would hide those of the other.
    let rate = power_of_two_below(Flow::<7>::pace(turning));
    let scales = [turning.unit, rate, rate];
    let scaled = |part: Extended| scales.iter().fold(part, |part, by| part.scaled(1.0 / by));
    let lever = top.body.exact_lever(top.g());
    let lever = lever.map(|part| scaled(part).as_number());
    let coefficients = Coefficients::new(&AxisMoments::allowing_rods(moments), lever);
    Ok(move |leg: &AnyLeg<'_>, effort: Effort| {
        let Effort::Tolerance(tolerance) = effort else {
            let condition = "the solver power-series must be given a tolerance";
            return Err(Error::Solver { condition });
        };
        let part = PART * positive("the tolerance", tolerance)?;
        let (mut now, y) = leg.start;
        budget.begin(leg.end);
        let (mut here, mut cost) = (wide(y, moments, rate), Cost::default());
        let (times, mut states) = ([leg.times, &[leg.end]].concat(), Vec::new());
        loop {
            budget.spend(A_SERIES, now)?;
            cost += Cost {
                evaluations: A_SERIES,
                steps: 1,
            };
            let series = Series::about(&coefficients, here, ORDER, part);
            let left = &times[states.len()..];
            let within = left.partition_point(|&t| (t - now).abs() * rate <= series.reach);
            let after = |t: f64| series.after(DoubleDouble::difference(t, now).scaled(rate));
            let state = |&t: &f64| narrow(after(t), moments, rate);
            states.extend(left[..within].iter().map(state));
            if within == left.len() {
                break;
            }
            let later = now + (series.reach / rate).copysign(leg.end);
            if !later.is_finite() || later == now {
                return stopped("the power series reaches no further", now);
            }
            (here, now) = (after(later), later);
        }
        Ok(passed(states, leg.end, cost))
    })
}

/// Ω in this unit, the vertical and the attitude, from L and a quaternion that need not be normalised.
fn wide(y: &[f64], moments: [f64; 3], rate: f64) -> [DoubleDouble; 10] {
    let Phase { l, q } = phase(y).cast::<DoubleDouble>();
    let phase = Phase { l, q: unit(q) };
    let omega = |k: usize| (l[k] / moments[k].into()).scaled(1.0 / rate);
    let ([o1, o2, o3], [z1, z2, z3]) = ([0, 1, 2].map(omega), phase.up());
    let [w, x, y, z] = phase.q;
    [o1, o2, o3, z1, z2, z3, w, x, y, z]
}

/// L and the quaternion, rounded.
fn narrow(state: [DoubleDouble; 10], moments: [f64; 3], rate: f64) -> Vec<f64> {
    let [o1, o2, o3, _, _, _, q @ ..] = state.map(DoubleDouble::value);
    let [l1, l2, l3] = [o1 * moments[0], o2 * moments[1], o3 * moments[2]].map(|l| l * rate);
    [&[l1, l2, l3][..], &q].concat()
}
