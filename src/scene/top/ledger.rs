//! The quantities that a top conserves, or may only lose.

use super::effects::{State, Top};
use crate::euler_equations::{HeavyTop, Integrability, TopState};
use crate::scene::prelude::*;

/// A top and its start, with the scales for its ledger.
pub(super) struct Conserved {
    /// The heavy top, which names its further integral.
    pub heavy: HeavyTop,
    pub start: State,
    /// Size of the energies in the motion, J; positive.
    pub energy_scale: f64,
    /// Size of the angular momenta in the motion, kg m²/s; positive.
    pub momentum_scale: f64,
}

/// The ledger of a top that is being written.
type Open = OpenLedger<State>;

/// The most rows of a closed form that are checked: it keeps its constants by construction.
const MOST_READ: usize = 256;

impl Conserved {
    pub fn of(top: &Top) -> Result<Self> {
        let (body, start, lever) = (top.body, top.start, BodyVector::from(top.lever()));
        let omega = start.omega(body.moments)?;
        let heavy = HeavyTop::new(body.axis_moments(), lever)?;
        let (weight, turning) = (lever.norm(), heavy.moments.angular_momentum(omega).norm());
        let greatest = body.moments.into_iter().fold(0.0, f64::max);
        // Root by root: the product of moment and torque may leave the range of doubles.
        let falling = greatest.sqrt() * weight.sqrt();
        let momentum_scale = turning.hypot(falling);
        let energy_scale = heavy.moments.energy(omega) + weight;
        let conserved = Self {
            heavy,
            start: state(&heavy, start.attitude, omega),
            energy_scale: energy_scale.max(f64::MIN_POSITIVE),
            momentum_scale: momentum_scale.max(f64::MIN_POSITIVE),
        };
        finite("the energy", conserved.start.energy)?;
        finite("the angular momentum", conserved.momentum_scale)?;
        Ok(conserved)
    }

    /// Without resistance: E is conserved; L, or the component that gravity leaves; the fourth integral of tops that have one.
    pub fn lossless(&self, ledger: Open) -> Result<Open> {
        let mut ledger = ledger.reading(MOST_READ);
        let (first, scale) = (self.start.energy, self.energy_scale);
        ledger.conserved("energy", scale, first, |_, state| state.energy)?;
        let moments = &self.heavy.moments;
        let momentum = |s: &State| s.attitude.to_space(moments.angular_momentum(s.omega));
        let (first, scale) = (momentum(&self.start), self.momentum_scale);
        if matches!(self.heavy.kind(), Integrability::Euler) {
            ledger.conserved("angular momentum", scale, first, |_, state| momentum(state))?;
            return Ok(ledger);
        }
        let name = "angular momentum about the vertical";
        ledger.conserved(name, scale, first.z(), |_, state| momentum(state).z())?;
        if let Some((name, first, scale)) = self.fourth(&self.start) {
            let fourth = |state: &State| self.fourth(state).map_or(first, |(_, value, _)| value);
            ledger.conserved(name, scale, first, |_, state| fourth(state))?;
        }
        Ok(ledger)
    }

    /// With resistance: the energy may only fall, and its sum with the energy lost is conserved; without gravity |L| may only fall.
    pub fn lossy(&self, mut ledger: Open, lost: impl Fn(usize) -> f64) -> Result<Open> {
        // Requested times may precede the start: monotone quantities begin with the earliest row.
        let (earliest, scale) = (*ledger.earliest(), self.energy_scale);
        let falling = ("energy", Law::NonIncreasing, scale);
        ledger.keep(falling, earliest.energy, |_, state| state.energy)?;
        let (name, first) = ("energy and what resistance took", self.start.energy);
        ledger.conserved(name, scale, first, |k, state| state.energy + lost(k))?;
        if matches!(self.heavy.kind(), Integrability::Euler) {
            let size = |state: &State| self.heavy.moments.angular_momentum(state.omega).norm();
            let name = "size of the angular momentum";
            let falling = (name, Law::NonIncreasing, self.momentum_scale);
            ledger.keep(falling, size(&earliest), |_, state| size(state))?;
        }
        Ok(ledger)
    }

    /// Name, value and scale of the fourth integral: L along the axis of symmetry or the line to C, or Kovalevskaya's constant.
    fn fourth(&self, state: &State) -> Option<(&'static str, f64, f64)> {
        let (heavy, scale) = (&self.heavy, self.momentum_scale);
        let (omega, up) = (state.omega, up(&state.attitude));
        let seen = TopState { omega, up };
        let value = heavy.further_integral(&seen)?.value;
        match heavy.kind() {
            Integrability::Lagrange(_) => {
                Some(("angular momentum about the axis of symmetry", value, scale))
            }
            Integrability::SphericalInertia => {
                let name = "angular momentum about the line to the centre of mass";
                Some((name, value / heavy.lever.norm(), scale))
            }
            Integrability::Kovalevskaya(axis) => {
                let [re, im] = heavy.kovalevskaya(&seen, axis);
                let scale = self.energy_scale / heavy.moments.values()[axis];
                Some(("Kovalevskaya's constant", re.hypot(im), scale))
            }
            _ => None,
        }
    }
}

/// The state with this attitude and Ω.
#[inline]
pub(super) fn state(heavy: &HeavyTop, attitude: Attitude, omega: BodyVector) -> State {
    let energy = match heavy.kind() {
        // Without a lever there is no potential energy.
        Integrability::Euler => heavy.moments.energy(omega),
        _ => heavy.energy(&TopState {
            omega,
            up: up(&attitude),
        }),
    };
    State {
        attitude,
        omega,
        energy,
    }
}

#[inline]
pub(super) fn up(attitude: &Attitude) -> BodyVector {
    attitude.to_body(SpaceVector::new(0.0, 0.0, 1.0))
}
