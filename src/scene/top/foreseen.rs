//! Steps of one length whose error is known before the run: what the error is proportional to follows from the parts that a method splits a motion into.

use super::steered::Steered;
use crate::error::{Error, Result};
use crate::integrators::Cost;
use crate::integrators::geometric::{Order, VeselovOrder};
use crate::scene::plan::Geometric;

/// error ≤ scale·hᵖ for steps up to the longest.
#[derive(Debug, Clone, Copy)]
pub(super) struct Foreseen {
    pub method: Geometric,
    order: f64,
    scale: f64,
    longest: f64,
    check: Check,
}

/// Whether the formula is taken at its word.
#[derive(Debug, Clone, Copy)]
enum Check {
    /// Over all tops observed it is a bound.
    None,
    /// The energy, which such a method lets oscillate by what it does wrong: that times the angle (radians) and this share is an error, too.
    Energy { share: f64, angle: f64 },
}

/// What rounding adds, a radian.
const ROUNDING: f64 = 4e-16;
/// The check by energy may be small by chance: an error is told as no less than this share of the formula.
const FLOOR: f64 = 0.15;

/// Where the accuracy leaves room for it, so much more is told than the energy tells.
const ROOM: f64 = 2.5;

impl Foreseen {
    /// A free body, L along its axes, by the methods for it; nothing where what is a little off grows like an exponential.
    ///
    /// Rotations: the error is a commutator of their parts, so it has as factors both differences of 1/I and vanishes with either: T hᵖ d₁d₂(d₁ + d₂)ᵖ⁻¹|L|ᵖ⁺¹.
    /// The discrete top leaves out powers of h from the tenth on. Observed in 208 tops with d₁d₂(LT)² < 16: below 0.064 and 7.2·10⁻⁵ times that of orders 2
    /// and 4, of the discrete top 1.4·10⁻⁶ times Ω T (h Ω)¹⁰, 4·10⁻⁸ in the middle.
    pub fn free(moments: [f64; 3], l: [f64; 3], fastest: f64, span: f64) -> [Option<Self>; 3] {
        let mut sorted = moments;
        sorted.sort_by(f64::total_cmp);
        let [a, b, c] = sorted;
        // Differences first: the moments may be nearly equal.
        let (first, second) = ((b - a) / (a * b), (c - b) / (b * c));
        let size = l.iter().map(|x| x * x).sum::<f64>().sqrt();
        // A body with two equal moments has a closed form that is as short as a step.
        if first * second == 0.0 || (size * span).powi(2) * first * second > 16.0 {
            return [None; 3];
        }
        let both = size * (first + second);
        let parts = span * size * size * size * first * second * (first + second);
        let discrete = Self {
            method: Geometric::MoserVeselov(VeselovOrder::Ten),
            order: 10.0,
            scale: 9e-7 * span * fastest * fastest.powi(10),
            // With longer steps the implicit equation has other solutions.
            longest: 1.0 / fastest,
            check: Check::None,
        };
        let rotations = |order: Order, scale: f64| Self {
            method: Geometric::Rotations(order),
            order: f64::from(order.number()),
            scale,
            longest: span,
            check: Check::None,
        };
        [
            Some(rotations(Order::Two, 0.06 * parts)),
            Some(rotations(Order::Four, 7e-5 * parts * both * both)),
            Some(discrete),
        ]
    }

    /// A symmetric body under its weight by kicks between exact free motions, of every order.
    ///
    /// Without weight there is no error: it is proportional to the weight's share of the energies, `weight`, to the angle and to (hω)ᵖ. Observed in 320 tops: in the
    /// middle 10⁻², 2·10⁻⁷ and 4·10⁻⁹ times that for orders 2, 4 and 6; in one of twenty five to eight times as much as that.
    pub fn kicked(weight: f64, fastest: f64, span: f64) -> [Option<Self>; 3] {
        let angle = fastest * span;
        // In long runs rates are off as well, and what they are off by adds up: observed ten times the proportional at 90 rad, once in 19200 cases.
        let angle = angle * (1.0 + (angle / 60.0).powi(2));
        let each = |(order, constant, longest, share): (Order, f64, f64, f64)| {
            let power = order.number();
            Some(Self {
                method: Geometric::KickDrift(order),
                order: f64::from(power),
                scale: constant * weight * angle * fastest.powi(power as i32),
                longest: longest / fastest,
                check: Check::Energy { share, angle },
            })
        };
        [
            (Order::Two, 0.025, 1.0, 0.5),
            (Order::Four, 8e-7, 2.0, 0.5),
            (Order::Six, 3.5e-8, 4.0, 1.0),
        ]
        .map(each)
    }

    /// The step for an accuracy.
    pub fn step(&self, accuracy: f64) -> f64 {
        let ratio = accuracy / self.scale;
        let root = if self.order == 2.0 {
            ratio.sqrt()
        } else if self.order == 4.0 {
            ratio.sqrt().sqrt()
        } else {
            ratio.powf(1.0 / self.order)
        };
        root.min(self.longest)
    }

    /// Runs until the error is below the accuracy. `run` gives states, cost, and by how much the energy was off at most, relative.
    ///
    /// # Errors
    /// [`Error::Accuracy`] where three runs were not enough; those of the run.
    pub fn steer<S>(
        &self,
        accuracy: f64,
        run: impl Fn(f64) -> Result<(Vec<S>, Cost, f64)>,
    ) -> Result<Steered<S>> {
        let mut step = self.step(accuracy);
        let mut cost = Cost::default();
        let mut reached = f64::INFINITY;
        for _ in 0..3 {
            let (states, spent, drift) = run(step)?;
            cost += spent;
            // A step beyond the span has no power that is finite.
            let formula = (self.scale * step.powf(self.order)).min(accuracy);
            let error = match self.check {
                // What has left the right solution is off by more than its share in energy, too.
                Check::None => formula.max(0.1 * drift) + ROUNDING,
                Check::Energy { share, angle } => {
                    let by_energy = share * (1.0 + angle) * drift;
                    by_energy.max(FLOOR * formula) + ROUNDING * (1.0 + angle)
                }
            };
            if error <= accuracy * (1.0 + 1e-9) + ROUNDING {
                return Ok(Steered {
                    states,
                    error: match self.check {
                        Check::None => error,
                        Check::Energy { .. } => accuracy.min(ROOM * error),
                    },
                    cost,
                });
            }
            reached = reached.min(error);
            if !error.is_finite() {
                break;
            }
            step *= (0.4 * accuracy / error)
                .powf(1.0 / self.order)
                .clamp(0.2, 0.8);
        }
        Err(Error::Accuracy {
            asked: accuracy,
            reached,
        })
    }
}
