//! Hard cases: what textbook formulas lose, and what is left when the cancellation is taken out by algebra.
//!
//! Twelve families of cases, each walking towards a place where a formula that is right on paper loses its digits in doubles: the separatrix, an axis,
//! the sphere, a long time, a top almost upright. At each step both are computed from the same doubles and held against a
//! committed table of 32 digits, made by two routes (`tests/reference/hard_cases.py`): the formula as the tutorial prints it, and the library's way.
//!
//! | family | the textbook | the library |
//! |---|---|---|
//! | 2, 6, 7 | differences of rounded numbers | the same differences formed by algebra before anything is rounded |
//! | 6.6 | 1 − k² | k² and 1 − k² side by side, both from the mechanics |
//! | 6.6, 4.6 | a rate times a long time | the rate in two words, reduced before it is rounded |
//!
//! ```
//! use spinning_bodies::hard_cases::named;
//! let family = named("near-axis").expect("it is in the list");
//! let closest = family.comparisons()?.last().copied().expect("there are steps");
//! assert!(closest.textbook > 0.1 && closest.ours < 1e-15);
//! # Ok::<(), spinning_bodies::Error>(())
//! ```

mod attitude;
mod elliptic;
mod free_top;
mod inertia;
mod lagrange_top;
mod superball;
#[rustfmt::skip]
mod truth;

use crate::error::{Error, Result};

/// One step of a family: exact inputs, and what is right.
#[derive(Debug)]
struct Row {
    nearness: f64,
    inputs: &'static [f64],
    /// Each number as the sum of two.
    results: &'static [[f64; 2]],
}

/// A way of computing the results of a row from its inputs.
type Formula = fn(&[f64]) -> Result<Vec<f64>>;

/// Cases that come closer and closer to where a formula loses its digits.
#[derive(Debug, Clone, Copy)]
pub struct Family {
    name: &'static str,
    paragraph: &'static str,
    quantity: &'static str,
    lost: &'static str,
    rows: &'static [Row],
    textbook: Formula,
    ours: Formula,
}

/// Both ways at one step. An error is |found − true|/|true| of the vector of results.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Comparison {
    /// How close to the hard place, 0 being there; what it measures is the family's: see the [list](families).
    pub nearness: f64,
    /// The relative error of the textbook's formula; not a number where it has no answer.
    pub textbook: f64,
    /// That of the library.
    pub ours: f64,
}

impl Family {
    /// The name by which [`named`] finds it.
    pub const fn name(&self) -> &'static str {
        self.name
    }

    /// The paragraph of the tutorial whose formula it is.
    pub const fn paragraph(&self) -> &'static str {
        self.paragraph
    }

    /// What is computed.
    pub const fn quantity(&self) -> &'static str {
        self.quantity
    }

    /// Where the textbook's digits go.
    pub const fn lost(&self) -> &'static str {
        self.lost
    }

    /// Both ways at every step, the easiest first. Cost: some microseconds a step.
    ///
    /// # Errors
    /// Those of the library's way, which has none on these cases.
    pub fn comparisons(&self) -> Result<Vec<Comparison>> {
        let compared = |row: &Row| {
            Ok(Comparison {
                nearness: row.nearness,
                textbook: (self.textbook)(row.inputs).map_or(f64::NAN, |found| row.error(&found)),
                ours: row.error(&(self.ours)(row.inputs)?),
            })
        };
        self.rows.iter().map(compared).collect()
    }

    /// How many steps there are.
    pub const fn steps(&self) -> usize {
        self.rows.len()
    }

    /// One way once, at one step: for those who measure what it costs.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a step that is not there; those of the library's way.
    pub fn run(&self, step: usize, way: Way) -> Result<Vec<f64>> {
        let row = self.rows.get(step).ok_or(Error::OutOfRange {
            quantity: "the step",
            value: step as f64,
            least: 0.0,
            greatest: self.rows.len() as f64 - 1.0,
        })?;
        match way {
            Way::Textbook => (self.textbook)(row.inputs),
            Way::Ours => (self.ours)(row.inputs),
        }
    }
}

/// Whose formula.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// As printed, each operation rounded.
    Textbook,
    /// The library's.
    Ours,
}

impl Row {
    /// |found − true|/|true|, the differences exact to 32 digits.
    fn error(&self, found: &[f64]) -> f64 {
        let square = |x: f64| x * x;
        let pairs = || found.iter().zip(self.results);
        // Scaled: the numbers may be as small as their squares are nothing.
        let greatest = self.results.iter().fold(0.0_f64, |m, r| m.max(r[0].abs()));
        let off: f64 = pairs()
            .map(|(x, [high, low])| square(((x - high) - low) / greatest))
            .sum();
        let size: f64 = pairs().map(|(_, [high, _])| square(high / greatest)).sum();
        (off / size).sqrt()
    }
}

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

/// The family of this name, if there is one.
pub fn named(name: &str) -> Option<Family> {
    families().into_iter().find(|family| family.name == name)
}
