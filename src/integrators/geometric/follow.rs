//! Samples of a motion by a geometric method.

use super::{Integrator, Phase};
use crate::error::{Result, each_finite, positive, stopped};
use crate::integrators::{Cost, Solution, both_ways};

/// Phases at `times` (s, on either side of 0, in any order) of the motion that starts with `start` at time 0, by steps of one length between two samples,
/// at most `step` (s). `watch` is called with the time and the cost so far at each sample and every 65,536 steps.
///
/// # Errors
/// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::NotPositive`](crate::Error::NotPositive) for times and step; [`Error::Integration`](crate::Error::Integration) where the method fails; those of `watch`, which end the run.
///
/// ```
/// use spinning_bodies::frame::{Attitude, BodyVector};
/// use spinning_bodies::{euler_top::EulerTop, integrators::geometric::{FreeSplitting, Order, Phase, follow}};
/// let start = Phase::new(BodyVector::new(0.1, 2.0, 0.3), &Attitude::identity());
/// let method = FreeSplitting::new([1.0, 2.0, 2.5], Order::Six)?;
/// let course = follow(&method, &start, &[1.0, -1.0], 0.01, &mut |_, _| Ok(()))?;
/// let exact = EulerTop::new([1.0, 2.0, 2.5], start.angular_momentum(), Attitude::identity())?;
/// assert!((course.states[0].angular_momentum() - exact.at(1.0)?.angular_momentum).norm() < 1e-10);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn follow(
    method: &dyn Integrator,
    start: &Phase,
    times: &[f64],
    step: f64,
    watch: &mut dyn FnMut(f64, Cost) -> Result<()>,
) -> Result<Solution<Phase>> {
    each_finite("the time", times.iter().copied())?;
    let step = positive("the step", step)?;
    start.check()?;
    let mut cost = Cost::default();
    let states = both_ways(times, &mut |times| {
        let (mut phase, mut time, mut states) = (*start, 0.0, Vec::new());
        for &next in times {
            let leg = next - time;
            let count = (leg.abs() / step).ceil();
            if count > MOST_STEPS {
                return stopped("more than 10^10 steps between two samples", time);
            }
            if count > 0.0 {
                let (mut stepper, spent) = (method.start(&phase, leg / count)?, cost);
                let mut left = count as u64;
                while left > 0 {
                    let steps = left.min(STRIDE);
                    stepper.advance(steps)?;
                    left -= steps;
                    cost = spent;
                    cost += stepper.cost();
                    watch(next - leg * (left as f64 / count), cost)?;
                }
                phase = stepper.phase()?;
            }
            time = next;
            states.push(phase);
        }
        Ok(states)
    })?;
    Ok(Solution { states, cost })
}

const MOST_STEPS: f64 = 1e10;
/// Steps between two calls of `watch`.
const STRIDE: u64 = 65_536;
