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

/// The times before 0, descending, and the others, ascending; and the place of each time in this order.
fn ways(times: &[f64]) -> ([Vec<f64>; 2], Vec<usize>) {
    let (mut ways, mut places) = ([const { Vec::new() }; 2], vec![0; times.len()]);
    let mut order = ascending(Vec::from_iter(0..times.len()), times);
    let before = order.partition_point(|&i| times[i] < 0.0);
    order[..before].reverse();
    for (place, i) in order.into_iter().enumerate() {
        places[i] = place;
        ways[usize::from(place >= before)].push(times[i]);
    }
    (ways, places)
}

/// States at times in any order, from `follow`, which takes ordered times and gives a state for each: first those before 0, backward from 0, then the others,
/// ascending.
pub(crate) fn both_ways<Y: Clone>(
    times: &[f64],
    follow: &mut dyn FnMut(&[f64]) -> Result<Vec<Y>>,
) -> Result<Vec<Y>> {
    let ((ways, places), mut states) = (ways(times), Vec::new());
    for way in ways.iter().filter(|way| !way.is_empty()) {
        states.append(&mut follow(way)?);
    }
    Ok(places.iter().map(|&place| states[place].clone()).collect())
}
