//! What accuracy costs (chapter "What accuracy costs"): orders, long runs, three kinds of numbers, and the price of a digit.
//!
//! Everything here but `map` and `seconds`, which are measured, is computed when it is drawn.

mod drift;
mod growth;
mod map;
mod numbers;
mod orders;
mod problem;
mod seconds;

use crate::prelude::*;

/// The figures of the chapter, in its order.
pub const FIGURES: &[Entry] = &[
    of("accuracy-map", &[], map::map),
    of("accuracy-seconds", &[], seconds::seconds),
    of("accuracy-orders", &[], orders::orders),
    of("accuracy-numbers", &[], numbers::three_numbers),
    of("accuracy-growth", &[], growth::growth),
    of("accuracy-drift", &[], drift::energy_drift),
];
