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

pub(crate) use order_eight::growth_limiting;
pub use order_eight::{Kept, Leg, order_eight};
pub use problem::{
    AnyLeg, Cost, Effort, Event, GeneralMethods, Method, Passage, Solution, Stop, System,
};

use crate::error::Result;
use crate::search::ascending;

/// States at times in any order, from `follow`, which takes ordered times and gives a state for each: first those before 0, backward from 0, then the others,
/// ascending.
///
/// # Errors
/// Those of `follow`.
///
/// ```
/// use spinning_bodies::integrators::both_ways;
/// let mut calls = Vec::new();
/// let states = both_ways(&[2.0, -1.0, 1.0, -3.0], &mut |times| {
///     calls.push(times.to_vec());
///     Ok(times.iter().map(|t| 10.0 * t).collect())
/// })?;
/// assert_eq!(states, [20.0, -10.0, 10.0, -30.0]);
/// assert_eq!(calls, [[-1.0, -3.0], [1.0, 2.0]]);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn both_ways<Y>(
    times: &[f64],
    follow: &mut dyn FnMut(&[f64]) -> Result<Vec<Y>>,
) -> Result<Vec<Y>> {
    let mut order = ascending(Vec::from_iter(0..times.len()), times);
    let before = order.partition_point(|&place| times[place] < 0.0);
    order[..before].reverse();
    let mut states = Vec::from_iter(times.iter().map(|_| None));
    for way in [&order[..before], &order[before..]] {
        if !way.is_empty() {
            let ordered: Vec<f64> = way.iter().map(|&place| times[place]).collect();
            for (&place, state) in way.iter().zip(follow(&ordered)?) {
                states[place] = Some(state);
            }
        }
    }
    Ok(states.into_iter().flatten().collect())
}
