//! A motion to be computed, and what is known of it.

use super::sample::Sample;
use super::table_top::OnTable;
use crate::error::{Error, Result, finite};
use crate::integrators::geometric::Phase;

/// What moves.
#[derive(Debug, Clone, Copy)]
#[expect(
    clippy::large_enum_variant,
    reason = "there are some thirty of them, and they are copied once a sweep"
)]
pub enum Setting {
    /// A body with a fixed point, under its weight or none.
    Top {
        /// Moments along the body's axes, kg m².
        moments: [f64; 3],
        /// The lever MgC along the body's axes, N m.
        lever: [f64; 3],
    },
    /// A ball on a table, C off its centre.
    Table(OnTable),
}

/// A motion: a body, its start, the time it lasts, and samples of the truth.
#[derive(Debug, Clone)]
pub struct Problem {
    name: String,
    description: String,
    setting: Setting,
    start: Phase,
    turns: f64,
    truth: Vec<Sample>,
}

impl Problem {
    /// The motion of a top from `start` at time 0 through the samples of `truth`, in their order, at the last of which it ends; `turns` is
    /// about the number of turns until then, for the steps that methods begin with.
    ///
    /// # Errors
    /// [`Error::Empty`] without samples; [`Error::OutOfRange`] for sample times that do not ascend from 0; [`Error::NotFinite`].
    pub fn top(
        name: impl Into<String>,
        (moments, lever): ([f64; 3], [f64; 3]),
        start: Phase,
        turns: f64,
        truth: Vec<Sample>,
    ) -> Result<Self> {
        let setting = Setting::Top { moments, lever };
        Self::new(name.into(), String::new(), setting, start, turns, truth)
    }

    pub(super) fn new(
        name: String,
        description: String,
        setting: Setting,
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
            name,
            description,
            setting,
            start,
            turns,
            truth,
        })
    }

    /// Its name, as in the tables: `free-top/1000`, the number of turns last.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What it is, in a line; nothing for one made by [`Problem::top`].
    pub fn description(&self) -> &str {
        &self.description
    }

    /// What moves.
    pub const fn setting(&self) -> &Setting {
        &self.setting
    }

    /// Moments along the body's axes, kg m².
    pub const fn moments(&self) -> [f64; 3] {
        match &self.setting {
            Setting::Top { moments, .. } => *moments,
            Setting::Table(table) => table.moments(),
        }
    }

    /// L and attitude at time 0.
    pub const fn start(&self) -> &Phase {
        &self.start
    }

    /// About the number of turns.
    pub const fn turns(&self) -> f64 {
        self.turns
    }

    /// What is true, at ascending times.
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

    /// How long it lasts, s.
    pub fn end(&self) -> f64 {
        self.last().time()
    }
}
