//! Tops under gravity alone by the methods for turning bodies, for those who ask for one by its name: steps of one length.

use super::body::DOUBTED;
use super::equations::Turning;
use super::held::Top;
use crate::error::{Error, Result};
use crate::integrators::geometric::{
    FreeSplitting, HeavySplitting, Integrator, MoserVeselov, MuntheKaas, Phase, Weight, follow,
};
use crate::integrators::{Cost, Effort, Solution};
use crate::scene::engine::{ROUNDING, greater, with_checks};
use crate::scene::motion::furthest;
use crate::scene::{Geometric, Request};

/// Phases at the times of a request.
pub(super) struct Halved {
    pub phases: Vec<Phase>,
    pub error: f64,
    pub cost: Cost,
}

/// The longest step, in radians.
const LONGEST_STEP: f64 = 0.5;
/// An order that has not shown itself in the last halving vouches for nothing.
const SHOWN: f64 = 1.5;
/// The factor between what two runs tell of the error and what is told of it.
const CAUTION: f64 = 4.0;
/// Where halving takes nothing off any more, so many times the greater of the last two distances is told.
const TWICE_THE_SAME: f64 = 10.0;

/// Steps halved until two runs vouch for each other, at the times asked for and a few more; or one run, if that is what is asked for.
///
/// Of the better run the error is the distance of both over what halving the step takes off it, less one; and that is what the last halving took
/// off it or 2ᵖ, whichever is less. To vouch for one run therefore takes three. A fourth starts a little beside the coarser of the two: what the
/// motion makes of rounding shows in it alone.
///
/// # Errors
/// [`Error::Solver`] for a method that cannot run this top; [`Error::Amplified`]; those of the method.
pub(super) fn halved(
    top: &Top,
    turning: &Turning,
    method: Geometric,
    request: &Request,
) -> Result<Halved> {
    let method = &*method_for(top, method)?;
    let order = f64::from(method.order());
    let budget = &request.budget();
    let (accuracy, angle) = (request.accuracy(), turning.angle(request.times()));
    let times = with_checks(request, angle);
    let start = top.start.phase(top.body.moments)?;
    let mut cost = Cost::default();
    let mut run = |from: &Phase, step: f64| -> Result<Solution<Phase>> {
        let mut paid = 0;
        let mut watch = |time: f64, cost: Cost| {
            let evaluations = cost.evaluations - paid;
            paid = cost.evaluations;
            budget.spend(evaluations, time)
        };
        let course = follow(method, from, &times, step, &mut watch)?;
        cost += course.cost;
        Ok(course)
    };
    if let Some(effort) = request.effort() {
        let Effort::Step(step) = effort else {
            return Err(Error::Solver {
                condition: "a method with steps of one length must be given a step",
            });
        };
        let phases = run(&start, step)?.states;
        let error = f64::INFINITY;
        return Ok(Halved {
            phases,
            error,
            cost,
        });
    }
    let distance = |a: &Solution<Phase>, b: &Solution<Phase>| {
        let fastest = turning.fastest(b.states.iter().copied());
        let pairs = a.states.iter().zip(&b.states);
        let apart = pairs.map(|(a, b)| turning.apart(a, b, fastest));
        apart.fold(0.0, greater)
    };
    let slowest = turning.fastest(core::iter::empty());
    let beside = |moved: &Phase| turning.apart(moved, &start, slowest);
    let longest = furthest(&times).abs() * (LONGEST_STEP / angle.max(LONGEST_STEP));
    let mut step = longest.max(f64::MIN_POSITIVE);
    let mut worse = run(&start, step)?;
    let (mut before, mut reached) = (f64::INFINITY, f64::INFINITY);
    loop {
        let better = run(&start, 0.5 * step)?;
        let apart = distance(&worse, &better);
        // Between two samples both may have taken the one step.
        let halved = 10 * better.cost.steps >= 19 * worse.cost.steps;
        let taken_off = (before / apart).min(order.exp2());
        let error = if !halved || before == f64::INFINITY {
            f64::INFINITY
        } else if taken_off > SHOWN {
            CAUTION * apart / (taken_off - 1.0)
        } else {
            // Rounding, or not yet of any order.
            TWICE_THE_SAME * greater(before, apart)
        };
        let error = error + ROUNDING * (1.0 + angle);
        if error <= accuracy {
            let moved = turning.moved(1.0);
            let grown = DOUBTED * distance(&run(&moved, step)?, &worse);
            if error + grown > accuracy {
                return Err(Error::Amplified {
                    asked: accuracy,
                    reached: error + grown,
                    growth: grown / (DOUBTED * beside(&moved)),
                });
            }
            let mut phases = better.states;
            phases.truncate(request.times().len());
            return Ok(Halved {
                phases,
                error: error + grown,
                cost,
            });
        }
        // Rounding: shorter steps no longer help.
        if halved && apart >= before && apart < 1e-6 || step < f64::EPSILON * longest {
            let moved = turning.moved(MOVED);
            let grown = distance(&run(&moved, step)?, &worse);
            return Err(Error::Amplified {
                asked: accuracy,
                reached: reached.min(apart),
                growth: grown / beside(&moved),
            });
        }
        reached = reached.min(error);
        before = if halved { apart } else { f64::INFINITY };
        (worse, step) = (better, 0.5 * step);
    }
}

/// A displacement that shows how a change of the start grows, in units of the doubt.
const MOVED: f64 = 1e4;

/// The method, if it can run this top.
fn method_for(top: &Top, method: Geometric) -> Result<Box<dyn Integrator>> {
    let (moments, lever) = (top.body.moments, top.lever());
    let free = lever == [0.0; 3];
    let weight = Weight::new(lever)?;
    Ok(match method {
        Geometric::Rotations(order) if free => Box::new(FreeSplitting::new(moments, order)?),
        Geometric::MoserVeselov(order) if free => Box::new(MoserVeselov::new(moments, order)?),
        Geometric::Rotations(_) | Geometric::MoserVeselov(_) => {
            return Err(Error::Solver {
                condition: "the solvers rotations and moser-veselov are for tops that no torque acts on",
            });
        }
        Geometric::KickDrift(order) => Box::new(HeavySplitting::new(moments, weight, order)?),
        Geometric::MuntheKaas => Box::new(MuntheKaas::new(moments, weight)?),
        Geometric::DormandPrince8 => {
            return Err(Error::Solver {
                condition: "dormand-prince-8 has no steps of one length",
            });
        }
    })
}
