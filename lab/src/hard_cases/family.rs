//! A family of hard cases, and the errors of both formulas at each of its steps.

use spinning_bodies::{Error, Result};

use crate::table;

/// Rows of family, nearness, inputs and results of each step.
const TRUTH: &str = include_str!("../../../tests/reference/hard_cases.csv");

/// One step of a family: exact inputs, and the true results.
#[derive(Debug, Clone)]
struct Step {
    nearness: f64,
    inputs: Vec<f64>,
    /// Each result as the sum of two doubles.
    results: Vec<[f64; 2]>,
}

/// Computes the results of a step from its inputs.
pub type Formula = fn(&[f64]) -> Result<Vec<f64>>;

/// Cases that approach a place where a formula loses its digits.
#[derive(Debug, Clone, Copy)]
pub struct Family {
    /// The name by which [`named`](super::named) finds it.
    pub name: &'static str,
    /// The paragraph of the tutorial whose formula it is.
    pub paragraph: &'static str,
    /// What is computed, in Markdown.
    pub quantity: &'static str,
    /// Why the textbook's formula loses digits, in Markdown.
    pub lost: &'static str,
    /// The part of the printed formula that loses them, in LaTeX for KaTeX.
    pub printed: &'static str,
    /// The expression that the library uses there, also in LaTeX.
    pub cure: &'static str,
    /// The formula as printed, each operation rounded.
    pub textbook: Formula,
    /// The library's computation.
    pub ours: Formula,
}

/// The errors of both at one step, as |found − true|/|true| of the vector of results.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Comparison {
    /// The distance from the hard place, which is at 0; its meaning depends on the family: see the [list](super::families).
    pub nearness: f64,
    /// The relative error of the textbook's formula; NaN where it has no result.
    pub textbook: f64,
    /// The relative error of the library.
    pub ours: f64,
}

impl Family {
    fn steps(&self) -> Result<Vec<Step>> {
        table::rows(
            TRUTH,
            |name| name == self.name,
            |cells: [&'static str; 4]| {
                let [_, nearness, inputs, results] = cells;
                let (inputs, results) = (inputs.split(' '), results.split(' '));
                Ok(Step {
                    nearness: table::exact(nearness)?,
                    inputs: inputs.map(table::exact).collect::<Result<_>>()?,
                    results: results.map(table::decimal).collect::<Result<_>>()?,
                })
            },
        )
    }

    /// The errors of both at every step, the easiest first.
    ///
    /// # Errors
    /// Those of the library, which has none on these cases, and those of the reference table, should a line be invalid.
    pub fn comparisons(&self) -> Result<Vec<Comparison>> {
        let compared = |step: &Step| {
            Ok(Comparison {
                nearness: step.nearness,
                textbook: (self.textbook)(&step.inputs)
                    .map_or(f64::NAN, |found| step.error(&found)),
                ours: step.error(&(self.ours)(&step.inputs)?),
            })
        };
        self.steps()?.iter().map(compared).collect()
    }

    /// The inputs of each step.
    ///
    /// # Errors
    /// Those of the table.
    pub fn inputs(&self) -> Result<Vec<Vec<f64>>> {
        Ok(self.steps()?.into_iter().map(|step| step.inputs).collect())
    }
}

impl Step {
    /// |found − true|/|true|, with differences correct to 32 digits; NaN if the number of results differs.
    fn error(&self, found: &[f64]) -> f64 {
        if found.len() != self.results.len() {
            return f64::NAN;
        }
        // Scaled, because the squares of very small numbers would underflow.
        let greatest = self.results.iter().fold(0.0_f64, |m, r| m.max(r[0].abs()));
        let off = |(x, [high, low]): (&f64, &[f64; 2])| (((x - high) - low) / greatest).powi(2);
        let size = |r: &[f64; 2]| (r[0] / greatest).powi(2);
        let off: f64 = found.iter().zip(&self.results).map(off).sum();
        let size: f64 = self.results.iter().map(size).sum();
        (off / size).sqrt()
    }
}

/// The inputs of a case, as many as its formula takes.
pub fn numbers<const N: usize>(inputs: &[f64]) -> Result<[f64; N]> {
    inputs.try_into().map_err(|_| Error::Condition {
        condition: "a case must have as many inputs as its formula takes",
        value: inputs.len() as f64,
    })
}
