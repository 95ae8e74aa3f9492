//! Bodies that change their shape (tutorial 1.1): swivel, skater, cat, crawler; and a cat of paper, which does not.
//!
//! | kind | effects | plan |
//! |---|---|---|
//! | [`Swivel`] | change of shape, bearing friction | one integral along the path of shapes; with friction a general method |
//! | [`Skater`] | change of shape, bearing friction | Ω = L/I; with friction a general method |
//! | [`Cat`] | change of shape, gravity | equal halves without angular momentum: one integral; otherwise a general method |
//! | [`Crawler`] | ground friction | closed forms from event to event |
//! | [`PaperCat`] | air, gravity | with air a general method |
//!
//! A change of shape is an effect like any other: absent, the body is rigid. What muscles can do is prescribed as a path of shapes; how hard
//! they must work for it comes out.

mod cat;
mod crawler;
mod paper_cat;
mod skater;
mod swivel;

pub use cat::{Bending, Cat, CatState, Falling, Gravity, Turnover};
pub use crawler::{Crawler, CrawlerState, Ground, GroundFriction};
pub use paper_cat::{Air, Atmosphere, PaperCat, PaperCatState, Righting};
pub use skater::{Draw, Drawing, Skater, SkaterState};
pub use swivel::{FourPhases, RoundTrip, Swivel, SwivelState, Twist, Twisting};

use super::{Absent, Budget, Choice, Effect, Plan, Request, Solver};
use crate::error::{Error, Result, not_negative};
use crate::integrators::{Cost, Effort, Method, Solution, System, solve};

/// How a stroke of a muscle is spread over its time: from 0 to 1, at rest at both ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Pace {
    /// The same forward and backward: u³(10 − 15u + 6u²).
    #[default]
    Even,
    /// Slow at first and hasty at the end: the same of u².
    Late,
}

impl Pace {
    /// Value, rate and acceleration after a fraction `u` of the stroke.
    pub fn at(self, u: f64) -> [f64; 3] {
        let u = u.clamp(0.0, 1.0);
        match self {
            Self::Even => even(u),
            Self::Late => {
                let [value, rate, acceleration] = even(u * u);
                [
                    value,
                    2.0 * u * rate,
                    2.0 * rate + 4.0 * u * u * acceleration,
                ]
            }
        }
    }
}

fn even(u: f64) -> [f64; 3] {
    let left = 1.0 - u;
    [
        u * u * u * (10.0 + u * (-15.0 + 6.0 * u)),
        30.0 * u * u * left * left,
        60.0 * u * left * (1.0 - 2.0 * u),
    ]
}

/// What resists the turning of a body on its bearing: the ice under a skate, the axle of a swivel chair.
pub trait Bearing: Effect {
    /// The torque about the axis, N m, with what friction does at this rate (rad/s).
    fn resisted(&self, torque: f64, rate: f64) -> f64;

    /// The heat made, W, with what friction adds at this rate.
    fn heated(&self, heating: f64, rate: f64) -> f64;

    /// An angular momentum and what the bearing has taken of it while the body turned by `turned`: kept.
    fn restored(&self, angular_momentum: f64, turned: f64) -> f64;
}

impl Bearing for Absent {
    fn resisted(&self, torque: f64, _: f64) -> f64 {
        torque
    }

    fn heated(&self, heating: f64, _: f64) -> f64 {
        heating
    }

    fn restored(&self, angular_momentum: f64, _: f64) -> f64 {
        angular_momentum
    }
}

/// Viscous friction of a bearing: torque −cΩ.
///
/// Small as it may be, it has the last word: L falls by exactly c times the angle turned, so a body that comes to rest without
/// angular momentum has turned back to where it began.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingFriction {
    /// c, N m s.
    pub resistance: f64,
}

impl Effect for BearingFriction {
    const PRESENT: bool = true;
    const NAME: &'static str = "bearing_friction";
}

impl Bearing for BearingFriction {
    fn resisted(&self, torque: f64, rate: f64) -> f64 {
        torque - self.resistance * rate
    }

    fn heated(&self, heating: f64, rate: f64) -> f64 {
        heating + self.resistance * rate * rate
    }

    fn restored(&self, angular_momentum: f64, turned: f64) -> f64 {
        angular_momentum + self.resistance * turned
    }
}

/// The plan of a scene with or without a closed form.
fn planned(
    request: &Request,
    closed: core::result::Result<(Solver, &str), &str>,
    refusal: &'static str,
) -> Result<Plan> {
    let refused = || Error::Solver { condition: refusal };
    match (request.choice(), closed) {
        (Choice::Auto, Ok((solver, reason))) => Ok(Plan::new(solver, reason)),
        (Choice::Auto, Err(reason)) => Ok(Plan::new(Solver::General(Method::Dop853), reason)),
        (Choice::Use(solver @ Solver::General(method)), _) if method.is_adaptive() => {
            Ok(Plan::new(solver, "asked for"))
        }
        (Choice::Use(solver), Ok((other, _))) if solver == other => {
            Ok(Plan::new(solver, "asked for"))
        }
        (Choice::Use(_), _) => Err(refused()),
    }
}

/// The times asked for, in ascending order, with those at which a path of shapes has a corner among them.
fn with_corners(request: &Request, order: &[usize], corners: &[f64]) -> Vec<f64> {
    let mut stops: Vec<f64> = order.iter().map(|&i| request.times()[i]).collect();
    let last = stops.last().copied().unwrap_or(0.0);
    stops.extend(corners.iter().filter(|&&t| t > 0.0 && t < last));
    stops.sort_by(f64::total_cmp);
    stops.dedup();
    stops
}

/// States at the stops by a general method, to an error below `accuracy` by `distance`: from corner to corner, since a step across one would
/// be a bad one, and a path at rest between two looks like a path at rest for ever. Refined as [`refined`](crate::integrators::refined) is. System and distance come
/// as trait objects, so that this is compiled once for each size of state and not for every list of effects.
struct Pieced<'a, const N: usize> {
    start: [f64; N],
    scales: [f64; N],
    stops: &'a [f64],
    corners: &'a [f64],
    method: Method,
    request: &'a Request,
}

impl<const N: usize> Pieced<'_, N> {
    fn follow(
        &self,
        system: &dyn System<N>,
        distance: &dyn Fn(&[f64; N], &[f64; N]) -> f64,
    ) -> Result<Solution<N>> {
        let budget = Budget::asked(self.request);
        let (system, accuracy) = (&budget.counted(system), self.request.accuracy());
        let mut tolerance = (0.01 * accuracy).clamp(LEAST_TOLERANCE, 1e-6);
        let mut last = self.run(system, tolerance)?;
        let mut cost = last.cost;
        loop {
            tolerance = (tolerance / 30.0).max(LEAST_TOLERANCE);
            let next = self.run(system, tolerance)?;
            cost += next.cost;
            let pairs = last.states.iter().zip(&next.states);
            let apart = pairs.map(|(a, b)| distance(a, b)).fold(0.0, f64::max);
            if apart <= 0.5 * accuracy {
                return Ok(Solution { cost, ..next });
            }
            if tolerance == LEAST_TOLERANCE || !apart.is_finite() {
                return Err(Error::Accuracy {
                    asked: accuracy,
                    reached: apart,
                });
            }
            last = next;
        }
    }

    fn run(&self, system: &dyn System<N>, tolerance: f64) -> Result<Solution<N>> {
        let mut solution = Solution {
            states: Vec::with_capacity(self.stops.len()),
            cost: Cost::default(),
        };
        let (mut from, mut state) = (0.0, self.start);
        let ends = self.corners.iter().copied().chain([f64::INFINITY]);
        for end in ends {
            let first = solution.states.len();
            let count = self.stops[first..].partition_point(|&t| t <= end);
            let samples = &self.stops[first..first + count];
            // The corner itself is among the stops, unless all are before it.
            let Some(&to) = samples.last() else { continue };
            let effort = Effort::Tolerance(tolerance);
            let leg = solve(
                system,
                from,
                &state,
                &self.scales,
                samples,
                self.method,
                effort,
            )?;
            solution.cost += leg.cost;
            if let Some(&reached) = leg.states.last() {
                (from, state) = (to, reached);
            }
            solution.states.extend(leg.states);
        }
        Ok(solution)
    }
}

/// Evaluations of a function that is smooth from stop to stop.
const AN_INTEGRAL: u64 = 60;

/// Below this the error estimate of a step is rounding.
const LEAST_TOLERANCE: f64 = 1e-15;

/// Values at the stops, brought into the order of the request.
fn in_order<S: Copy>(request: &Request, stops: &[f64], values: &[S]) -> Vec<(f64, S)> {
    let times = request.times().iter();
    times
        .filter_map(|&t| {
            let place = stops.partition_point(|&stop| stop < t);
            values.get(place).map(|&value| (t, value))
        })
        .collect()
}

/// Corners of a path that repeats itself: `marks` are fractions of the period.
fn repeated(period: f64, marks: &[f64], until: f64) -> Result<Vec<f64>> {
    let periods = (not_negative("the time", until)? / period).ceil();
    if periods.is_nan() || periods > MOST_PERIODS {
        return Err(Error::Condition {
            condition: "a path of shapes must be asked for no more than 100000 rounds",
            value: periods,
        });
    }
    let rounds = 0..periods as u64;
    Ok(rounds
        .flat_map(|k| marks.iter().map(move |mark| (k as f64 + mark) * period))
        .collect())
}

const MOST_PERIODS: f64 = 1e5;
