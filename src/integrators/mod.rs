//! Integrators, for equations that have no closed form.
//!
//! [`order_eight`] and [`Leg`]: an explicit Runge–Kutta method of order 8 for any system of first-order equations, with samples and events.
//! [`geometric`]: methods for a turning body alone, which keep its conserved quantities. Both take the accuracy as an [`Effort`] and report a
//! [`Cost`]. Other [`GeneralMethods`] come from outside the library.

pub mod geometric;
mod order_eight;
mod problem;
mod real;

pub(crate) use problem::Watched;

pub use order_eight::{Kept, Leg, order_eight};
pub use problem::{
    AnyLeg, Cost, Effort, Event, GeneralMethods, Method, Passage, Solution, Stop, System,
};

use crate::error::Result;

/// The last number found for which a condition holds and the first for which it fails, by bisection between two such numbers: no further apart
/// than `width`, or neighbouring doubles.
pub(crate) fn halved(
    [mut holds, mut fails]: [f64; 2],
    width: f64,
    condition: impl Fn(f64) -> Result<bool>,
) -> Result<[f64; 2]> {
    while (fails - holds).abs() > width {
        let middle = 0.5 * (holds + fails);
        if middle == holds || middle == fails {
            break;
        }
        if condition(middle)? {
            holds = middle;
        } else {
            fails = middle;
        }
    }
    Ok([holds, fails])
}

/// The places of these numbers, in ascending order of the numbers.
pub(crate) fn ascending_places(numbers: &[f64]) -> Vec<usize> {
    let mut places: Vec<usize> = (0..numbers.len()).collect();
    places.sort_by(|&i, &j| numbers[i].total_cmp(&numbers[j]));
    places
}

/// States at times in any order, from `follow`, which takes ordered times: first those before 0, backward from 0, then the others, ascending.
pub(crate) fn both_ways<Y: Clone>(
    times: &[f64],
    mut follow: impl FnMut(&[f64]) -> Result<Vec<Y>>,
) -> Result<Vec<Y>> {
    let mut before = ascending_places(times);
    let after = before.split_off(before.partition_point(|&i| times[i] < 0.0));
    before.reverse();
    let mut states = vec![None; times.len()];
    for places in [before, after].iter().filter(|way| !way.is_empty()) {
        let ordered: Vec<f64> = places.iter().map(|&place| times[place]).collect();
        for (&place, state) in places.iter().zip(follow(&ordered)?) {
            states[place] = Some(state);
        }
    }
    Ok(states.into_iter().flatten().collect())
}
