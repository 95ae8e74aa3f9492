//! What each way of computing a top costs, measured, and which is cheapest.
//!
//! Least squares over the tops of the suite in `tests/planner` (`cargo bench -p lab --bench planner -- prices` for the closed forms) on an AMD EPYC
//! (2 cores, KVM), Rust 1.95. Kovalevskaya's top is the dear one to prepare; for a few turns a run is cheaper by far.

use super::foreseen::Foreseen;
use super::methods::{Heavy, longest};
use super::steered;
use crate::euler_equations::Integrability;
use crate::integrators::geometric::{Order, VeselovOrder};
use crate::scene::plan::Geometric;

/// Microseconds; only their ratios count.
struct Price {
    /// Before the first step, or preparing a closed form.
    start: f64,
    step: f64,
    sample: f64,
}

const fn price(start: f64, step: f64, sample: f64) -> Price {
    Price {
        start,
        step,
        sample,
    }
}

const FREE: Price = price(2.7, 0.0, 0.28);
const LAGRANGE: Price = price(5.0, 0.0, 0.33);
const KOVALEVSKAYA: Price = price(270.0, 0.0, 4.0);
/// Her top from a start exactly upright, where two roots of her polynomial meet: without theta functions.
const UPRIGHT: Price = price(150.0, 0.0, 380.0);
const ORDER_EIGHT: Price = price(0.58, 0.45, 0.12);

const fn of_steps(method: Geometric) -> Price {
    match method {
        Geometric::Rotations(Order::Two) => price(0.71, 0.038, 0.23),
        Geometric::Rotations(Order::Four) => price(0.79, 0.22, 0.21),
        Geometric::MoserVeselov(VeselovOrder::Ten) => price(0.86, 0.087, 0.68),
        Geometric::KickDrift(Order::Two) => price(0.55, 0.046, 0.18),
        Geometric::KickDrift(Order::Four) => price(0.58, 0.27, 0.18),
        Geometric::KickDrift(Order::Six) => price(0.60, 0.49, 0.18),
        _ => price(f64::INFINITY, 0.0, 0.0),
    }
}

/// Steps of order 8 a radian, times tolerance^(1/8): observed 0.08 to 0.14.
const STEPS_A_RADIAN: f64 = 0.1;
/// Up to this multiple of the cheapest run a closed form is taken: its error is rounding.
const WORTH: f64 = 1.6;

/// Which way is cheapest.
#[derive(Debug, Clone, Copy)]
pub(super) enum Cheapest {
    ClosedForm,
    /// There being no closed form.
    OnlyOrderEight,
    OrderEight,
    Steps(Foreseen),
}

/// A top and what is asked of it, as far as the price goes.
pub(super) struct Task {
    pub moments: [f64; 3],
    /// L along the axes at the start.
    pub l: [f64; 3],
    pub kind: Integrability,
    /// Whether the third axis is exactly vertical at the start.
    pub upright: bool,
    /// The weight's share of the energies.
    pub weight: f64,
    /// How fast L and the vertical change along the body's axes, as a share of the fastest rate: 0 in steady motions.
    pub liveliness: f64,
    pub fastest: f64,
    pub span: f64,
    pub samples: usize,
    pub accuracy: f64,
}

/// Kicks lose little energy near steady motions, whatever their error.
const LIVELY: f64 = 0.3;

impl Task {
    pub fn of(heavy: &Heavy<'_>, kind: Integrability, accuracy: f64) -> Self {
        let weight = heavy.lever.iter().map(|x| x * x).sum::<f64>().sqrt();
        let [x, y, _] = heavy.start.up();
        Self {
            moments: heavy.moments,
            l: heavy.start.l,
            kind,
            upright: x == 0.0 && y == 0.0,
            weight: weight / heavy.energy,
            liveliness: heavy.liveliness(),
            fastest: heavy.fastest,
            span: longest(heavy.times),
            samples: heavy.times.len(),
            accuracy,
        }
    }

    pub fn cheapest(&self) -> Cheapest {
        let (closed, foreseen) = match self.kind {
            Integrability::Euler => (FREE, self.free()),
            Integrability::Lagrange(_) | Integrability::SphericalInertia => {
                (LAGRANGE, self.kicked())
            }
            Integrability::Kovalevskaya(_) if self.upright => (UPRIGHT, self.kicked()),
            Integrability::Kovalevskaya(_) => (KOVALEVSKAYA, self.kicked()),
            Integrability::OnLevelZero(_) | Integrability::None => {
                return Cheapest::OnlyOrderEight;
            }
        };
        if self.moments.contains(&0.0) || self.span == 0.0 {
            return Cheapest::ClosedForm;
        }
        let samples = self.samples as f64;
        let angle = self.fastest * self.span;
        let tolerance = steered::tolerance(angle, self.accuracy);
        let radian = STEPS_A_RADIAN / tolerance.sqrt().sqrt().sqrt();
        let steps = (radian * angle + 0.5 * (samples - 1.0)).max(samples);
        let sum =
            |price: Price, steps: f64| price.start + steps * price.step + samples * price.sample;
        let mut best = (sum(ORDER_EIGHT, steps), Cheapest::OrderEight);
        for foreseen in foreseen.into_iter().flatten() {
            let step = foreseen.step(self.accuracy);
            let steps = (self.span / step + 0.5 * (samples - 1.0)).max(samples);
            let cost = sum(of_steps(foreseen.method), steps);
            if cost < best.0 {
                best = (cost, Cheapest::Steps(foreseen));
            }
        }
        if sum(closed, 0.0) <= WORTH * best.0 {
            Cheapest::ClosedForm
        } else {
            best.1
        }
    }

    fn free(&self) -> [Option<Foreseen>; 3] {
        Foreseen::free(self.moments, self.l, self.fastest, self.span)
    }

    fn kicked(&self) -> [Option<Foreseen>; 3] {
        if self.liveliness < LIVELY {
            return [None; 3];
        }
        Foreseen::kicked(self.weight, self.fastest, self.span)
    }
}
