//! The equations with time rescaled to 0 … 1.

use differential_equations::ode::ODE;

use spinning_bodies::integrators::System;

/// The crate compares times with an absolute tolerance of 2e-15, so every run is rescaled to last from 0 to 1.
#[derive(Clone, Copy)]
pub(super) struct Clock {
    pub start: f64,
    pub span: f64,
}

impl Clock {
    pub fn time(self, phase: f64) -> f64 {
        self.start + phase * self.span
    }

    pub fn phase(self, time: f64) -> f64 {
        if self.span == 0.0 {
            return 0.0;
        }
        ((time - self.start) / self.span).clamp(0.0, 1.0)
    }
}

/// The equations with the rescaled time, the phase, as variable.
pub(super) struct Timed<'a, const N: usize> {
    pub system: &'a dyn System<N>,
    pub clock: Clock,
}

impl<const N: usize> ODE<f64, [f64; N]> for Timed<'_, N> {
    fn diff(&self, phase: f64, y: &[f64; N], rate: &mut [f64; N]) {
        *rate = self.system.rate(self.clock.time(phase), y);
        for component in rate {
            *component *= self.clock.span;
        }
    }
}

/// The state a very short time later, by one Euler step.
pub(super) fn carried<const N: usize>(
    timed: &Timed<'_, N>,
    (phase, state): (f64, [f64; N]),
    to: f64,
) -> [f64; N] {
    let mut rate = [0.0; N];
    timed.diff(phase, &state, &mut rate);
    core::array::from_fn(|i| state[i] + rate[i] * (to - phase))
}
