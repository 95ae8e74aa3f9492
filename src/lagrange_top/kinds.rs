//! What the axis does, and between which heights (tutorial 7.2, 7.5).

use super::roots::Distances;
use crate::precise::{Number, Words};

/// What kind of motion the axis makes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Nutation {
    /// φ' keeps its sign (7.2, picture k).
    Waves,
    /// φ' vanishes at the upper turning point: released from rest, say (7.4, picture l).
    Cusps,
    /// φ' changes its sign in between (7.2, picture m).
    Loops,
    /// The tilt stays (7.3, picture n).
    PurePrecession,
    /// Upright (7.5).
    Sleeping {
        /// Whether it stays so when disturbed: L₃² ≥ 4I₁Mgl.
        stable: bool,
    },
    /// Falls from the upright position, or rises to it, in infinite time (7.5).
    Waking,
    /// Hanging straight down.
    Hanging,
    /// L₃ = 0: a spherical pendulum (7.6).
    SphericalPendulum,
    /// L₃ = L_vert = 0: a pendulum in one plane (7.6).
    PlanePendulum,
    /// No gravity and no swing: the body turns about its own axis.
    Spinning,
}

/// The roots of the cubic, h₁ ≤ h₂ ≤ 1 ≤ h₃, with their distances from ±1 (7.2). With gravity upwards, those of −h.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Roots {
    /// h₁, the lower turning point of cos θ.
    pub h1: f64,
    /// h₂, the upper one.
    pub h2: f64,
    /// h₃; infinite without gravity.
    pub h3: f64,
    /// 1 − h₁ and 1 − h₂.
    pub one_less: [f64; 2],
    /// 1 + h₁ and 1 + h₂.
    pub one_more: [f64; 2],
    /// h₃ − 1; infinite without gravity.
    pub third_less_one: f64,
}

impl Roots {
    pub(super) fn new(one_less: [f64; 2], one_more: [f64; 2], third_less_one: f64) -> Self {
        let root = |k: usize| 0.5 * (one_more[k] - one_less[k]);
        Self {
            h1: root(0),
            h2: root(1),
            h3: 1.0 + third_less_one,
            one_less,
            one_more,
            third_less_one,
        }
    }

    pub(super) fn of<N: Number>(d: &Distances<N>, gravity: N) -> Self {
        let value = |x: N| x.narrow().value();
        let third = if gravity.is_zero() {
            f64::INFINITY
        } else {
            value(d.third[0].quotient(gravity.times(2.0)))
        };
        Self::new(d.top.map(value), d.bottom.map(value), third)
    }
}

/// Decided by exact zeros and signs; φ' has the sign of (L_vert − L₃h)/I₁, given at both turning points.
pub(super) fn kind<N: Number>(spin: N, [lower, upper]: [N; 2], d: &Distances<N>) -> Nutation {
    if d.third[3].is_zero() {
        Nutation::Waking
    } else if spin.is_zero() && d.sum.is_zero() {
        Nutation::PlanePendulum
    } else if d.band.is_zero() {
        Nutation::PurePrecession
    } else if spin.is_zero() {
        Nutation::SphericalPendulum
    } else if upper.is_zero() {
        Nutation::Cusps
    } else if upper.leading() * lower.leading() < 0.0 {
        Nutation::Loops
    } else {
        Nutation::Waves
    }
}
