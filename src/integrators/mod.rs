//! Ways to follow equations that have no closed form.
//!
//! [`solve`] and [`until`]: Runge–Kutta methods of the crate `differential-equations`, for any system of first-order equations, with
//! samples and events. [`refined`]: the same with a bound on the error of the whole run. One way to ask for accuracy ([`Effort`]),
//! one report of cost ([`Cost`]). [`geometric`]: methods for a turning body alone, which keep what it keeps.

mod general;
pub mod geometric;
mod order_eight;
mod problem;
mod real;
mod refined;
mod scaled;

pub use general::{DifferentialEquations, solve, until};
pub use order_eight::{Kept, Leg, order_eight};
pub use problem::{
    AnyEvent, AnyLeg, AnyRate, Cost, Effort, Event, GeneralMethods, Method, Passage, Solution,
    Stop, System,
};
pub use refined::{halved, refined, tightened};
