//! From a prepared motion to the constants of a lane.

use nalgebra::Quaternion;

use super::constants::{Amplitudes, Choices, Circular, Hyperbolic, Phases, Steady};
use super::rate::{Rate, halves};
use crate::elliptic::lanes::{Coefficients, EXACT_COUNT};
use crate::euler_top::motion::{EulerTop, Motion};
use crate::euler_top::preparation::Constants;
use crate::euler_top::start::ratio;
use crate::euler_top::turning::Theta;

/// Rates outside 10^±280 would overflow or underflow in halves; ratios outside 10^±60 in a fourth power.
const RATES: core::ops::RangeInclusive<f64> = 1e-280..=1e280;
const RATIOS: core::ops::RangeInclusive<f64> = 1e-60..=1e60;

/// A little less than all.
const NEARLY: f64 = 0.99;

/// One body, ready for a lane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Prepared {
    pub(super) kind: Kind,
    /// The body's own axes of the three components.
    pub(super) axis: [usize; 3],
    /// The greatest time, s.
    pub(super) reach: f64,
}

#[derive(Debug, Clone, Copy)]
#[allow(
    clippy::large_enum_variant,
    reason = "the large ones are the common ones"
)]
pub(super) enum Kind {
    Steady(Steady<f64>),
    Circular(Circular<f64>),
    Hyperbolic(Hyperbolic<f64>),
}

fn list(q: Quaternion<f64>) -> [f64; 4] {
    [q.w, q.i, q.j, q.k]
}

impl Prepared {
    /// The constants; none for a body that only [`EulerTop::at`] can do.
    pub(super) fn new(top: &EulerTop) -> Option<Self> {
        match &top.motion {
            Motion::Steady {
                omega,
                rate,
                direction: [x, y, z],
            } => {
                let size = rate.high().abs();
                if size != 0.0 && !RATES.contains(&size) {
                    return None;
                }
                let unturned = top.attitude.quaternion().into_inner();
                let steady = Steady {
                    half_rate: Rate::new(rate.scaled(0.5)),
                    unturned: list(unturned),
                    turned: list(unturned * Quaternion::new(0.0, *x, *y, *z)),
                    l: top.angular_momentum.components().into(),
                    omega: *omega,
                };
                Some(Self {
                    kind: Kind::Steady(steady),
                    axis: [0, 1, 2],
                    reach: turning_reach(size),
                })
            }
            Motion::Moving { constants, base } => moving(constants, *base, top.moments),
        }
    }
}

/// 2²⁴ half turns at this rate: with the lag, no more than twice as many right angles of half the angle.
#[inline(always)]
pub(super) fn turning_reach(rate: f64) -> f64 {
    (NEARLY * 0.5 * EXACT_COUNT * core::f64::consts::PI / rate).min(1e290)
}

/// As many quarter periods at this rate of u.
#[inline(always)]
pub(super) fn quarters_reach(quarter: f64, rate: f64) -> f64 {
    (NEARLY * EXACT_COUNT - 1.0) * quarter / rate
}

fn moving(constants: &Constants, base: Quaternion<f64>, moments: [f64; 3]) -> Option<Prepared> {
    let (rate, turning_rate) = (constants.rate.high().abs(), constants.turning_rate.high());
    let [p1, p2, p3] = constants.amplitudes;
    let size = p1.hypot(p3);
    let tame = RATES.contains(&rate)
        && RATES.contains(&turning_rate)
        && RATIOS.contains(&(p1 / size))
        && RATIOS.contains(&(p1 / p2));
    if !tame {
        return None;
    }
    let coefficients = constants.modulus.coefficients();
    let phases = phases(constants, &coefficients);
    let amplitudes = amplitudes(constants, base, moments, size);
    let Coefficients {
        even,
        odd,
        root,
        complementary_modulus,
        ..
    } = coefficients;
    let kind = match &constants.turning.theta {
        Theta::Circular { real, imaginary } => Kind::Circular(Circular {
            phases,
            amplitudes,
            corrections: even,
            real: *real,
            imaginary: *imaginary,
        }),
        Theta::Hyperbolic(theta) => Kind::Hyperbolic(Hyperbolic {
            phases,
            amplitudes,
            corrections: Choices::new(even, odd),
            roots: [root, complementary_modulus],
            theta: {
                let [even, odd] = theta.coefficients();
                Choices::new(even, odd)
            },
        }),
    };
    let quarters = quarters_reach(constants.modulus.quarter_period(), rate);
    Some(Prepared {
        kind,
        axis: constants.axes.axis,
        reach: quarters.min(turning_reach(turning_rate)),
    })
}

fn phases(constants: &Constants, coefficients: &Coefficients) -> Phases<f64> {
    let half_lag = constants.turning.lag.scaled(0.5);
    let [first, second] = halves(half_lag.high());
    Phases {
        rate: Rate::new(constants.rate),
        start: [constants.start.high(), constants.start.low()],
        inverse: coefficients.inverse,
        parts: coefficients.parts,
        pace: coefficients.pace,
        half_turning: Rate::new(constants.turning_rate.scaled(0.5)),
        half_lag: [first, second, half_lag.low()],
    }
}

fn amplitudes(
    constants: &Constants,
    base: Quaternion<f64>,
    moments: [f64; 3],
    size: f64,
) -> Amplitudes<f64> {
    let axes = &constants.axes;
    let own = axes.there(axes.back(constants.amplitudes));
    let unit = |k: usize| {
        let mut unit = [0.0; 3];
        unit[k] = 1.0;
        let [x, y, z] = axes.back(unit);
        list(base * Quaternion::new(0.0, x, y, z))
    };
    let columns = [list(base), unit(0), unit(1), unit(2)];
    Amplitudes {
        l: own,
        omega: ratio(own, axes.there(moments)),
        direction: constants.amplitudes.map(|x| x / size),
        aspect: constants.turning.aspect,
        base: core::array::from_fn(|row| core::array::from_fn(|column| columns[column][row])),
    }
}
