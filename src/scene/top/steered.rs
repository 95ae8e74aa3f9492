//! A run of order 8 that knows its own error: a loose run beside it, and what the loose run lost of what is conserved.

use crate::error::{Error, Result};
use crate::integrators::Cost;

/// What came out.
pub(super) struct Steered<S> {
    pub states: Vec<S>,
    /// The most that any of them may be off.
    pub error: f64,
    pub cost: Cost,
}

/// A problem as the steering sees it.
pub(super) struct Wheel<R, D, I> {
    /// One run with this tolerance.
    pub run: R,
    /// The distance of two states.
    pub distance: D,
    /// By how much a state fails what is conserved, relative.
    pub drift: I,
    /// Angle that the body turns by in the whole run, radians, or would at its fastest.
    pub angle: f64,
    pub accuracy: f64,
}

/// The least tolerance; below it the error estimate of a step is rounding.
const LEAST: f64 = 1e-15;
const GREATEST: f64 = 1e-2;
/// How much looser the loose run is: for order 8 it costs 0.56 and 0.42 of the other.
const LOOSER: f64 = 100.0;
const MUCH_LOOSER: f64 = 1000.0;
/// By this the estimates are multiplied.
const MARGIN: f64 = 1.5;

impl<S, R, D, I> Wheel<R, D, I>
where
    R: Fn(f64) -> Result<(Vec<S>, Cost)>,
    D: Fn(&S, &S) -> f64,
    I: Fn(&S) -> f64,
{
    /// The states, with an error below the accuracy.
    ///
    /// The error of a run follows its tolerance in proportion, with a factor that grows with the turns (observed: 0.1 to 800). The loose run shows that
    /// factor by what it lost of the energy, the better one is run with the tolerance that follows, and the distance of the two is the error of the
    /// loose one: in proportion of the tolerances, or of the eighth powers of the steps where they are few, that of the better. What rounding does is
    /// magnified by the same factor. Where this is not enough there is a further run, compared with the last.
    pub fn steer(&self) -> Result<Steered<S>> {
        let turns = (self.angle / core::f64::consts::TAU).max(1.0);
        let usual = 1.6 * turns.powf(1.4);
        let looser = if self.accuracy < 3e-7 {
            MUCH_LOOSER
        } else {
            LOOSER
        };
        let mut worse = (looser * self.accuracy / usual).clamp(30.0 * LEAST, GREATEST);
        let (mut before, mut cost) = (self.run)(worse)?;
        let mut steps = cost.steps;
        let mut lost = self.lost(&before);
        let factor = (lost * (1.0 + self.angle) / worse).clamp(usual / 30.0, usual * 30.0);
        let mut tolerance = (self.accuracy / (MARGIN * factor)).clamp(LEAST, worse / 10.0);
        loop {
            let (states, spent) = (self.run)(tolerance)?;
            cost += spent;
            let apart = greatest(before.iter().zip(&states), |(a, b)| (self.distance)(a, b));
            let error_before = apart.max(0.5 * lost);
            let mut share = tolerance / worse;
            if spent.steps < FEW {
                let ratio = steps as f64 / spent.steps.max(1) as f64;
                share = share.max(ratio.powi(8)).min(1.0);
            }
            let margin = MARGIN * (1.0 + 1.0 / spent.steps.max(1) as f64);
            let error = margin * error_before * share + error_before / worse * ROUNDING;
            if error <= self.accuracy {
                return Ok(Steered {
                    states,
                    error,
                    cost,
                });
            }
            if tolerance <= LEAST || !error.is_finite() {
                return Err(Error::Accuracy {
                    asked: self.accuracy,
                    reached: error,
                });
            }
            let next = tolerance * (0.5 * self.accuracy / error).clamp(1e-4, 0.3);
            lost = self.lost(&states);
            (before, worse, steps) = (states, tolerance, spent.steps);
            tolerance = next.max(LEAST);
        }
    }

    fn lost(&self, states: &[S]) -> f64 {
        greatest(states.iter(), |state| (self.drift)(state))
    }
}

/// Steps below this number are too few for the error to follow the tolerance.
const FEW: u64 = 8;

/// What rounding adds to the tolerance.
const ROUNDING: f64 = 4e-16;

fn greatest<T>(items: impl Iterator<Item = T>, size: impl Fn(T) -> f64) -> f64 {
    // What is not a number must not pass for small.
    items.map(size).fold(0.0, |m, d| if d <= m { m } else { d })
}
