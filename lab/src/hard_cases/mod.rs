//! Hard cases: the digits that textbook formulas lose, and the accuracy reached once cancellation is removed by algebra.
//!
//! Twelve families of cases, each approaching a place where a formula that is exact in real numbers loses its digits in doubles: the separatrix, an axis,
//! the sphere, a long time, a top almost upright. At each step the tutorial's printed formula and the library's method are evaluated for the same doubles and compared
//! with a committed table of 36 digits, made by two routes (`tests/reference/hard_cases.csv` and `.py`).
//!
//! | family | the textbook | the library |
//! |---|---|---|
//! | 2, 6, 7 | differences of rounded numbers | the same differences, formed by algebra before rounding |
//! | 6.6 | 1 − k² | k² and 1 − k² separately, both from the mechanics |
//! | 6.6, 4.6 | a rate times a long time | the rate in two words, and the angle reduced before it is rounded |
//!
//! ```
//! use lab::hard_cases::named;
//! let family = named("near-axis").expect("it is in the list");
//! let closest = family.comparisons()?.last().copied().expect("there are steps");
//! assert!(closest.textbook > 0.1 && closest.ours < 1e-15);
//! # Ok::<(), spinning_bodies::Error>(())
//! ```

mod attitude;
mod elliptic;
mod family;
mod free_top;
mod inertia;
mod lagrange_top;
mod superball;

pub use family::{Comparison, Family, Formula};

/// All families, in the order of the book.
pub fn families() -> [Family; 12] {
    [
        free_top::NEAR_SEPARATRIX,
        free_top::NEAR_AXIS,
        free_top::NEARLY_SPHERE,
        free_top::LONG_TIME,
        elliptic::QUARTER_PERIOD,
        lagrange_top::SLEEPING_TOP,
        lagrange_top::FAST_TOP,
        lagrange_top::SLOW_PRECESSION,
        inertia::FAR_MESH,
        inertia::NEEDLE,
        attitude::SMALL_TURN,
        superball::MANY_BOUNCES,
    ]
}

/// The family with this name, if there is one.
pub fn named(name: &str) -> Option<Family> {
    families().into_iter().find(|family| family.name == name)
}
