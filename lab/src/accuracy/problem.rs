//! A motion to be computed, and the reference values for it.

use spinning_bodies::integrators::geometric::Phase;
use spinning_bodies::{Error, Result};

use crate::finite;

use super::sample::Sample;
use super::table_top::SlidingBall;

/// The moving system.
#[derive(Debug, Clone, Copy)]
pub enum Model {
    /// A body with a fixed point, free or under its weight.
    Top {
        /// Moments along the body's axes, kg m².
        moments: [f64; 3],
        /// The lever MgC along the body's axes, N m.
        lever: [f64; 3],
    },
    /// A ball on a table, with C off its centre.
    Table(SlidingBall),
}

/// A motion: a body, its start, its duration, and samples of the truth.
#[derive(Debug, Clone)]
pub struct Problem {
    name: String,
    description: &'static str,
    model: Model,
    start: Phase,
    turns: f64,
    truth: Vec<Sample>,
}

impl Problem {
    /// The motion from `start` at time 0 to the last sample of `truth`; `turns` is about the number of turns
    /// until then, from which the first steps of the methods are chosen.
    ///
    /// # Errors
    /// [`Error::Empty`] without samples; [`Error::OutOfRange`] unless the times of the samples ascend from 0; [`Error::NotFinite`].
    pub fn new(
        name: impl Into<String>,
        model: Model,
        start: Phase,
        turns: f64,
        truth: Vec<Sample>,
    ) -> Result<Self> {
        finite("the number of turns", turns)?;
        if truth.is_empty() {
            return Err(Error::Empty {
                quantity: "the truth",
            });
        }
        let mut before = 0.0;
        for sample in &truth {
            let time = finite("the time of a sample", sample.time())?;
            if time <= before {
                return Err(Error::OutOfRange {
                    quantity: "the time of a sample",
                    value: time,
                    least: before,
                    greatest: f64::INFINITY,
                });
            }
            before = time;
        }
        Ok(Self {
            name: name.into(),
            description: "",
            model,
            start,
            turns,
            truth,
        })
    }

    /// Sets a one-line description.
    pub(super) const fn described(mut self, description: &'static str) -> Self {
        self.description = description;
        self
    }

    /// Its name in the tables: `free-top/1000`, with the number of turns last.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its description in one line; empty for a problem that is not in the list.
    pub const fn description(&self) -> &'static str {
        self.description
    }

    /// The moving system.
    pub const fn model(&self) -> &Model {
        &self.model
    }

    /// Moments along the body's axes, kg m².
    pub const fn moments(&self) -> [f64; 3] {
        match &self.model {
            Model::Top { moments, .. } => *moments,
            Model::Table(ball) => ball.moments(),
        }
    }

    /// L and attitude at time 0.
    pub const fn start(&self) -> &Phase {
        &self.start
    }

    /// About the number of turns of the motion.
    pub const fn turns(&self) -> f64 {
        self.turns
    }

    /// The samples of the truth, at ascending times.
    pub fn truth(&self) -> &[Sample] {
        &self.truth
    }

    /// The times of the samples, s.
    pub fn times(&self) -> Vec<f64> {
        self.truth.iter().map(Sample::time).collect()
    }

    /// The last sample.
    pub fn last(&self) -> &Sample {
        &self.truth[self.truth.len() - 1]
    }

    /// Its duration, s.
    pub fn end(&self) -> f64 {
        self.last().time()
    }
}
