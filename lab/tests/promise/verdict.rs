//! The verdict on each answer, and the tables of all.

use std::collections::BTreeMap;
use std::fmt;

/// What a scene gave back, judged by the truth.
#[derive(Debug, Clone)]
pub enum Given {
    Answer(Answer),
    Refused {
        /// By how much a small change of the start has grown, at most, at the times asked for.
        growth: f64,
        why: String,
    },
    /// Even thirty digits do not tell where such a motion goes.
    BeyondTheTruth,
}

#[derive(Debug, Clone)]
pub struct Answer {
    /// The most over all rows.
    pub error: f64,
    pub estimate: f64,
    pub evaluations: u64,
    /// Those of the cheapest run of order 8 that would have done.
    pub cheapest: Option<u64>,
    pub solver: String,
}

#[derive(Debug, Clone)]
pub struct Outcome {
    pub accuracy: f64,
    /// A free or Lagrange top.
    pub known: bool,
    pub given: Given,
}

/// What is wrong with an answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Fault {
    /// The error is above the accuracy asked for.
    Inexact,
    /// The error is above the estimate.
    Bold,
    /// Refused, though the motion does not amplify so much.
    Refused,
    /// The refusal does not name the growth.
    Unnamed,
}

impl Fault {
    const ALL: [Self; 4] = [Self::Inexact, Self::Bold, Self::Refused, Self::Unnamed];
}

/// A change of the start that no one can help.
const ROUNDING: f64 = 1e-15;
/// Of finer accuracies nothing is promised but honesty.
const FINEST: f64 = 1e-10;

impl Outcome {
    pub fn faults(&self) -> Vec<Fault> {
        let mut faults = Vec::new();
        match &self.given {
            Given::Answer(answer) => {
                // An error that is not a number is told as an infinite one.
                if answer.error > self.accuracy {
                    faults.push(Fault::Inexact);
                }
                // Nor an estimate that is none.
                let order = answer.error.partial_cmp(&answer.estimate);
                if order.is_none_or(|order| order.is_gt()) {
                    faults.push(Fault::Bold);
                }
            }
            Given::Refused { growth, why } => {
                // The decade asked for may be off by its rounding.
                let promised = self.accuracy >= FINEST * (1.0 - 1e-9);
                let grown = growth * ROUNDING >= 0.1 * self.accuracy;
                if promised && (self.known || !grown) {
                    faults.push(Fault::Refused);
                }
                if !why.contains("grow") {
                    faults.push(Fault::Unnamed);
                }
            }
            Given::BeyondTheTruth => {}
        }
        faults
    }

    fn answer(&self) -> Option<&Answer> {
        match &self.given {
            Given::Answer(answer) => Some(answer),
            _ => None,
        }
    }

    /// The error as a part of the accuracy asked for.
    fn of_accuracy(&self) -> Option<f64> {
        Some(self.answer()?.error / self.accuracy)
    }

    /// The error as a part of the estimate.
    fn of_estimate(&self) -> Option<f64> {
        let answer = self.answer()?;
        Some(answer.error / answer.estimate)
    }

    /// How bad a fault is.
    fn size(&self, fault: Fault) -> f64 {
        let size = match fault {
            Fault::Inexact => self.of_accuracy(),
            Fault::Bold => self.of_estimate(),
            Fault::Refused | Fault::Unnamed => match self.given {
                Given::Refused { growth, .. } => Some(self.accuracy / growth),
                _ => None,
            },
        };
        size.unwrap_or(0.0)
    }

    /// Evaluations over those of the cheapest.
    fn ratio(&self) -> Option<f64> {
        let answer = self.answer()?;
        Some(answer.evaluations as f64 / answer.cheapest? as f64)
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let asked = self.accuracy;
        match &self.given {
            Given::Answer(answer) => {
                let Answer {
                    error, estimate, ..
                } = answer;
                let [of_accuracy, of_estimate] = [error / asked, error / estimate];
                write!(
                    f,
                    "{}: error {error:.2e}, {of_accuracy:.3} of the accuracy {asked:.2e}, {of_estimate:.3} ({estimate:.2e}) of the estimate; {} evaluations, cheapest {:?}",
                    answer.solver, answer.evaluations, answer.cheapest
                )
            }
            Given::Refused { growth, why } => write!(
                f,
                "refused at accuracy {asked:.2e}; growth {growth:.2e}, so {:.2e} of the accuracy: {why}",
                growth * ROUNDING / asked
            ),
            Given::BeyondTheTruth => f.write_str("not judged"),
        }
    }
}

fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers.get(numbers.len() / 2).copied().unwrap_or(f64::NAN)
}

/// One case, judged.
#[derive(Debug)]
pub struct Judged {
    pub stratum: &'static str,
    pub number: usize,
    pub outcome: Outcome,
    /// The scene file.
    pub text: String,
}

/// One line a stratum.
pub fn table(all: &[Judged]) -> String {
    let mut strata: BTreeMap<&str, Vec<&Outcome>> = BTreeMap::new();
    for judged in all {
        let outcome = &judged.outcome;
        strata.entry(judged.stratum).or_default().push(outcome);
        strata.entry("~ all").or_default().push(outcome);
    }
    let head = "cases inexact  bold refused wrongly unnamed   err/acc   err/est   cost";
    let mut text = format!("{:46} {head}\n", "");
    for (name, all) in strata {
        let count = |fault: Fault| all.iter().filter(|o| o.faults().contains(&fault)).count();
        let is_refused = |o: &&&Outcome| matches!(o.given, Given::Refused { .. });
        let parts = |of: fn(&Outcome) -> Option<f64>| all.iter().filter_map(move |o| of(o));
        let ratio = median(parts(Outcome::ratio).collect());
        text += &format!(
            "{name:46} {:>5} {:>7} {:>5} {:>7} {:>7} {:>7} {:>9.2e} {:>9.2e} {ratio:>6.2}\n",
            all.len(),
            count(Fault::Inexact),
            count(Fault::Bold),
            all.iter().filter(is_refused).count(),
            count(Fault::Refused),
            count(Fault::Unnamed),
            parts(Outcome::of_accuracy).fold(0.0, f64::max),
            parts(Outcome::of_estimate).fold(0.0, f64::max),
        );
    }
    text
}

/// The table, and the worst of each fault of each stratum with their scene files.
pub fn report(all: &[Judged], each: usize) -> String {
    let mut text = table(all);
    let mut strata: Vec<&str> = all.iter().map(|judged| judged.stratum).collect();
    strata.dedup();
    for stratum in strata {
        for fault in Fault::ALL {
            let here = all.iter().filter(|judged| judged.stratum == stratum);
            let faulty = here.filter(|judged| judged.outcome.faults().contains(&fault));
            let mut faulty: Vec<&Judged> = faulty.collect();
            faulty.sort_by(|a, b| b.outcome.size(fault).total_cmp(&a.outcome.size(fault)));
            for judged in faulty.iter().take(each) {
                let (number, outcome, scene) = (judged.number, &judged.outcome, &judged.text);
                text += &format!("\n{fault:?}: {stratum} {number}\n{outcome}\n{scene}");
            }
        }
    }
    text
}

/// The median over all that ran of evaluations over those of the cheapest.
pub fn cost(all: &[Judged]) -> f64 {
    let ratios = all.iter().filter_map(|judged| judged.outcome.ratio());
    median(ratios.collect())
}
