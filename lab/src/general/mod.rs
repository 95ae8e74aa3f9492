//! Methods for any equations, those of the crate `differential-equations`: systems of N numbers, samples at given times, events.
//!
//! The library itself has order 8 and the methods for bodies; these judge it, and come to a scene with its request as
//! [`DifferentialEquations`].
//!
//! * this file: what is asked and what is answered;
//! * `run`: the crate's loop with one of its methods, and the short steps to samples and events;
//! * `clock`: the equations in times from 0 to 1;
//! * `track`: what a run leaves behind;
//! * `falling`: where between two steps a quantity falls through zero;
//! * `scaled`: the same equations with every number near 1;
//! * `body`: the motion of a body by such a method.

mod body;
mod clock;
mod falling;
mod run;
mod scaled;
mod track;

use spinning_bodies::integrators::{
    AnyLeg, Cost, Effort, Event, GeneralMethods, Method, Passage, Solution, System,
};
use spinning_bodies::{Error, Result};

pub use body::{GeneralMethod, order};
use run::{Run, finite};

/// States at all of `times` (s, in any order, before and after `start_time` alike).
///
/// `scales` are the sizes below which a component counts as small: the error of a step may be tolerance × (|y| + scale) in each.
/// Each sample is reached by a step of its own from the last step before it, not by dense output, which is less exact by up to
/// four digits; it costs the evaluations of one step.
///
/// # Errors
/// [`Error::NotFinite`] for times and start; [`Error::NotPositive`] for the effort;
/// [`Error::Integration`] where the method gives up.
pub fn solve<const N: usize>(
    system: &dyn System<N>,
    start_time: f64,
    start: &[f64; N],
    scales: &[f64; N],
    times: &[f64],
    method: Method,
    effort: Effort,
) -> Result<Solution<[f64; N]>> {
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
) -> Result<Passage<[f64; N]>> {
    Run {
        system,
        scales,
        method,
        effort,
    }
    .until(start_time, start, times, end_time, event)
}

/// The methods of the crate `differential-equations`, for scenes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DifferentialEquations;

impl GeneralMethods for DifferentialEquations {
    fn follow(
        &self,
        method: Method,
        leg: &AnyLeg<'_>,
        effort: Effort,
    ) -> Result<Passage<Vec<f64>>> {
        match leg.start.1.len() {
            1 => sized::<1>(method, leg, effort),
            2 => sized::<2>(method, leg, effort),
            3 => sized::<3>(method, leg, effort),
            4 => sized::<4>(method, leg, effort),
            5 => sized::<5>(method, leg, effort),
            6 => sized::<6>(method, leg, effort),
            7 => sized::<7>(method, leg, effort),
            8 => sized::<8>(method, leg, effort),
            12 => sized::<12>(method, leg, effort),
            count => Err(Error::Condition {
                condition: "the general methods are compiled for 1 to 8 and for 12 numbers",
                value: count as f64,
            }),
        }
    }
}

/// The same for a number of numbers that the compiler knows.
fn sized<const N: usize>(
    method: Method,
    leg: &AnyLeg<'_>,
    effort: Effort,
) -> Result<Passage<Vec<f64>>> {
    struct Slices<'a, 'b, const N: usize>(&'a AnyLeg<'b>);
    impl<const N: usize> System<N> for Slices<'_, '_, N> {
        fn rate(&self, t: f64, y: &[f64; N]) -> [f64; N] {
            let mut rate = [0.0; N];
            (self.0.rate)(t, y, &mut rate);
            rate
        }

        fn reached(&self, time: f64) -> Result<()> {
            (self.0.reached)(time)
        }
    }
    let of = |slice: &[f64]| -> [f64; N] { core::array::from_fn(|n| slice[n]) };
    let (time, start) = (leg.start.0, of(leg.start.1));
    let margin = |t: f64, y: &[f64; N]| leg.event.map_or(1.0, |event| event(t, y));
    let run = Run {
        system: &Slices::<N>(leg),
        scales: &of(leg.scales),
        method,
        effort,
    };
    let passage = run.until(time, &start, leg.times, leg.end, &margin)?;
    Ok(Passage {
        states: passage.states.iter().map(|y| y.to_vec()).collect(),
        time: passage.time,
        end: passage.end.to_vec(),
        stopped: passage.stopped,
        cost: passage.cost,
    })
}
