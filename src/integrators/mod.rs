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
