//! The geometric methods for a top under gravity alone, when a request names one: steps of one length.

use super::equations::{Turning, phase};
use crate::error::{Error, Result, positive};
use crate::integrators::geometric::{
    FreeSplitting, HeavySplitting, Integrator, MoserVeselov, MuntheKaas, Weight, follow,
};
use crate::integrators::{AnyLeg, Cost, Effort, Passage, Stop};
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
        Ok(Passage {
            end: states.pop().unwrap_or_default(),
            states,
            time: leg.end,
            stopped: Stop::AtTheEnd,
            cost,
        })
    })
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
        Geometric::DormandPrince8 => {
            let condition = "dormand-prince-8 has no steps of one length";
            return Err(Error::Solver { condition });
        }
    })
}
