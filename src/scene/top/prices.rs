//! What each way of computing a top costs, measured, and which is cheapest.

use crate::euler_equations::{Integrability, classify};
use crate::frame::BodyVector;

/// Microseconds on the machine that `bench/benches/planner.rs` names, by which they are measured: only their ratios count.
struct Price {
    preparing: f64,
    state: f64,
}

const FREE: Price = Price {
    preparing: 0.6,
    state: 0.3,
};
const LAGRANGE: Price = Price {
    preparing: 2.5,
    state: 0.6,
};
const KOVALEVSKAYA: Price = Price {
    preparing: 20.0,
    state: 4.0,
};
/// Of a step of order 8 of a body under its weight.
const STEP: f64 = 0.39;
/// Before the first step.
const STARTING: f64 = 0.15;
/// Steps of order 8 a radian, times tolerance^(1/8): observed 0.06 to 0.09.
const STEPS_A_RADIAN: f64 = 0.075;
/// Up to this multiple of a single run a closed form is taken: its error is rounding, and a run that knows its error costs as much.
const WORTH: f64 = 1.6;

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
