//! Ways to follow equations that have no closed form.
//!
//! [`order_eight`] and [`Leg`]: an explicit Runge–Kutta method of order 8 for any system of first-order equations, with samples and events. One way
//! to ask for accuracy ([`Effort`]), one report of cost ([`Cost`]). [`geometric`]: methods for a turning body alone, which keep what it keeps.
//! Other [`GeneralMethods`] are brought by who has them.

pub mod geometric;
mod order_eight;
mod problem;
mod real;

pub use order_eight::{Kept, Leg, order_eight};
pub use problem::{
    AnyLeg, Cost, Effort, Event, GeneralMethods, Method, Passage, Solution, Stop, System,
};

/// The places of the times before 0, from there backward, and of the others in ascending order.
pub(crate) fn both_ways(times: &[f64]) -> [Vec<usize>; 2] {
    let mut before: Vec<usize> = (0..times.len()).collect();
    before.sort_by(|&i, &j| times[i].total_cmp(&times[j]));
    let after = before.split_off(before.partition_point(|&i| times[i] < 0.0));
    before.reverse();
    [before, after]
}
