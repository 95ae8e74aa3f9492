//! What each way of computing a top costs, measured, and which is cheapest.
//!
//! Medians over the tops of the suite in `tests/planner`, by `cargo bench -p bench --bench planner -- prices` on an AMD EPYC (2 cores, KVM),
//! Rust 1.95. Kovalevskaya's states are the dear ones, 75 to 1700 µs: each separates the variables anew; for a few turns a run is cheaper by far.

use crate::euler_equations::{Integrability, classify};
use crate::frame::BodyVector;

/// Microseconds; only their ratios count.
struct Price {
    preparing: f64,
    state: f64,
}

const FREE: Price = Price {
    preparing: 2.0,
    state: 0.22,
};
const LAGRANGE: Price = Price {
    preparing: 3.9,
    state: 0.25,
};
const KOVALEVSKAYA: Price = Price {
    preparing: 150.0,
    state: 380.0,
};
/// Of a step of order 8 of a body under its weight.
const STEP: f64 = 0.44;
/// Before the first step.
const STARTING: f64 = 0.15;
/// Steps of order 8 a radian, times tolerance^(1/8): observed 0.08 to 0.14.
const STEPS_A_RADIAN: f64 = 0.1;
/// Up to this multiple of a single run a closed form is taken: its error is rounding, and a run that knows its error costs as much
/// (observed: the second run and the margins make it 1.8 to 3 of the cheapest single one).
const WORTH: f64 = 2.5;

/// Which way is cheapest.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Cheapest {
    ClosedForm,
    Run,
    /// The same, there being no closed form.
    OnlyRun,
}

/// For a top with these moments and this lever that turns by `angle` (radians) in the time of `samples` samples.
pub(super) fn cheapest(
    moments: [f64; 3],
    lever: [f64; 3],
    angle: f64,
    samples: usize,
    accuracy: f64,
) -> Cheapest {
    let [x, y, z] = lever;
    let price = match classify(moments, BodyVector::new(x, y, z)) {
        Integrability::Euler => FREE,
        Integrability::Lagrange(_) | Integrability::SphericalInertia => LAGRANGE,
        Integrability::Kovalevskaya(_) => KOVALEVSKAYA,
        Integrability::OnLevelZero(_) | Integrability::None => return Cheapest::OnlyRun,
    };
    if moments.contains(&0.0) {
        return Cheapest::ClosedForm;
    }
    let samples = samples as f64;
    let closed = price.preparing + samples * price.state;
    let turns = (angle / core::f64::consts::TAU).max(1.0);
    let tolerance = accuracy / (1.6 * turns.powf(1.4));
    let steps = (STEPS_A_RADIAN * angle * tolerance.powf(-0.125)).max(1.0);
    let run = STARTING + STEP * (steps + 0.5 * (samples - 1.0)).max(samples);
    if closed <= WORTH * run {
        Cheapest::ClosedForm
    } else {
        Cheapest::Run
    }
}
