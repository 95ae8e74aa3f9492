//! One way to ask every method, geometric or general, for a motion.

use super::{Integrator, Phase};
use crate::error::{Error, Result, finite, positive};
use crate::integrators::{Cost, Effort};

/// Phases at the times asked for, in their order, and what they have cost.
#[derive(Debug, Clone, PartialEq)]
pub struct Course {
    /// One a time.
    pub phases: Vec<Phase>,
    /// Sine pairs, torques or Newton's rounds, whichever the method lives by; and steps.
    pub cost: Cost,
}

/// A method that can be asked for a motion by step or by tolerance.
pub trait Follow {
    /// Its name, as in the tables.
    fn name(&self) -> String;

    /// Its order, where it has one.
    fn order(&self) -> Option<u32>;

    /// Phases at `times` (s, either side of 0, in any order) of the motion that starts with `start` at time 0.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NotPositive`] for times and effort; [`Error::Integration`], [`Error::Accuracy`] where the method cannot.
    fn follow(&self, start: &Phase, times: &[f64], effort: Effort) -> Result<Course>;
}

/// A method with steps of one length that shows its phase on the way.
pub trait Watched: Follow {
    /// Phases at `times`, as [`Follow::follow`] gives them with [`Effort::Step`]; every `stride` steps, and at each of the times, `watch` sees the time,
    /// the phase, and the cost so far.
    ///
    /// # Errors
    /// As there; those of `watch`, which end the run.
    fn watched(
        &self,
        start: &Phase,
        times: &[f64],
        step: f64,
        stride: u64,
        watch: &mut dyn FnMut(f64, &Phase, Cost) -> Result<()>,
    ) -> Result<Course>;
}

impl<I: Integrator<f64>> Watched for I {
    fn watched(
        &self,
        start: &Phase,
        times: &[f64],
        step: f64,
        stride: u64,
        watch: &mut dyn FnMut(f64, &Phase, Cost) -> Result<()>,
    ) -> Result<Course> {
        for &t in times {
            finite("the time", t)?;
        }
        let step = positive("the step", step)?;
        let mut cost = Cost::default();
        let mut order: Vec<usize> = (0..times.len()).collect();
        order.sort_by(|&i, &j| times[i].total_cmp(&times[j]));
        let first_after = order.partition_point(|&i| times[i] < 0.0);
        let (before, after) = order.split_at(first_after);
        let mut phases = vec![*start; times.len()];
        let before: Vec<usize> = before.iter().rev().copied().collect();
        for places in [before.as_slice(), after] {
            let (mut phase, mut time) = (*start, 0.0);
            for &place in places {
                let leg = times[place] - time;
                let count = (leg.abs() / step).ceil();
                if count > MOST_STEPS {
                    return Err(Error::Integration {
                        reason: "more than 10^10 steps between two samples",
                        time,
                    });
                }
                let mut left = count as u64;
                while left > 0 {
                    let next = left.min(stride.max(1));
                    cost += self.advance(&mut phase, leg / count, next)?;
                    left -= next;
                    let now = times[place] - leg * (left as f64 / count);
                    watch(now, &phase, cost)?;
                }
                time = times[place];
                phases[place] = phase;
            }
        }
        Ok(Course { phases, cost })
    }
}

/// With [`Effort::Step`]: between two samples steps of one length, not above the one given. With [`Effort::Tolerance`]: the same, with the longest
/// step whose error, by comparison of one with two halves for the first four, is below the tolerance times |L| and in radians.
impl<I: Integrator<f64>> Follow for I {
    fn name(&self) -> String {
        Integrator::name(self)
    }

    fn order(&self) -> Option<u32> {
        Some(Integrator::order(self))
    }

    fn follow(&self, start: &Phase, times: &[f64], effort: Effort) -> Result<Course> {
        let mut trials = Cost::default();
        let step = match effort {
            Effort::Step(step) => step,
            Effort::Tolerance(tolerance) => {
                for &t in times {
                    finite("the time", t)?;
                }
                let tolerance = positive("the tolerance", tolerance)?;
                let longest = times.iter().fold(0.0_f64, |a, &b| a.max(b.abs()));
                longest_step(self, start, longest, tolerance, &mut trials)?
            }
        };
        let mut course = self.watched(start, times, step, u64::MAX, &mut |_, _, _| Ok(()))?;
        course.cost += trials;
        Ok(course)
    }
}

const MOST_STEPS: f64 = 1e10;

/// The longest step with an error below the tolerance, from trials at the start.
fn longest_step(
    method: &(impl Integrator<f64> + ?Sized),
    start: &Phase,
    span: f64,
    tolerance: f64,
    cost: &mut Cost,
) -> Result<f64> {
    if span == 0.0 {
        return Ok(1.0);
    }
    let size = start.l.iter().map(|x| x * x).sum::<f64>().sqrt();
    let order = f64::from(method.order());
    let (mut step, mut error) = (span, f64::INFINITY);
    for _ in 0..60 {
        error = match trial(method, start, step, size, cost) {
            Ok(error) => error,
            // Too long for an implicit method to have a solution.
            Err(Error::Integration { .. }) => f64::INFINITY,
            Err(error) => return Err(error),
        };
        if error <= tolerance {
            return Ok(step);
        }
        let shrink = 0.9 * (tolerance / error).powf(1.0 / (order + 1.0));
        step *= shrink.clamp(0.1, 0.9);
    }
    Err(Error::Accuracy {
        asked: tolerance,
        reached: error,
    })
}

/// By how much one step and two halves differ, at worst of a few steps in a row: a single one may be right by chance.
fn trial(
    method: &(impl Integrator<f64> + ?Sized),
    start: &Phase,
    step: f64,
    size: f64,
    cost: &mut Cost,
) -> Result<f64> {
    let unit = size.max(f64::MIN_POSITIVE);
    let mut here = *start;
    let mut worst = 0.0_f64;
    for _ in 0..4 {
        let mut whole = here;
        *cost += method.advance(&mut whole, step, 1)?;
        *cost += method.advance(&mut here, 0.5 * step, 2)?;
        let l = (0..3).map(|k| ((whole.l[k] - here.l[k]) / unit).abs());
        let q = (0..4).map(|k| 2.0 * (whole.q[k] - here.q[k]).abs());
        worst = l.chain(q).fold(worst, f64::max);
    }
    Ok(worst)
}
