//! What a top conserves, or may only lose.

use super::body::Body;
use super::{State, Top};
use crate::conservation::Law;
use crate::error::{Result, finite};
use crate::euler_equations::{Integrability, classify};
use crate::frame::{Attitude, BodyVector, SpaceVector};
use crate::scene::Request;
use crate::scene::motion::Accounts;

/// The body and its start, as the ledger needs them.
pub(super) struct Conserved {
    body: Body,
    lever: BodyVector,
    /// What is conserved besides.
    pub kind: Integrability,
    pub start: State,
    /// Size of the energies at play, J; positive.
    pub energy_scale: f64,
    /// Size of the angular momenta at play, kg m²/s; positive.
    pub momentum_scale: f64,
}

/// A closed form keeps its constants by construction; reading that many of its rows shows whether it did.
const MOST_READ: usize = 256;

impl Conserved {
    pub fn of(top: &Top) -> Result<Self> {
        let (body, start, lever) = (top.body, top.start, BodyVector::from(top.lever()));
        let omega = start.omega(body.moments)?;
        let mut conserved = Self {
            body,
            lever,
            kind: classify(body.moments, lever),
            start: State {
                attitude: start.attitude,
                omega,
                energy: 0.0,
            },
            energy_scale: 0.0,
            momentum_scale: 0.0,
        };
        let weight = lever.norm();
        let greatest = body.moments.iter().fold(0.0_f64, |a, &b| a.max(b));
        conserved.start.energy = finite("the energy", conserved.energy(&start.attitude, omega))?;
        conserved.energy_scale = (conserved.kinetic(omega) + weight).max(f64::MIN_POSITIVE);
        let turning = body.angular_momentum(omega).norm();
        conserved.momentum_scale = turning
            .hypot((greatest * weight).sqrt())
            .max(f64::MIN_POSITIVE);
        finite("the angular momentum", conserved.momentum_scale)?;
        Ok(conserved)
    }

    fn kinetic(&self, omega: BodyVector) -> f64 {
        0.5 * self.body.angular_momentum(omega).dot(&omega)
    }

    /// The state with this attitude and Ω.
    #[inline]
    pub fn state(&self, attitude: Attitude, omega: BodyVector) -> State {
        State {
            attitude,
            omega,
            energy: self.energy(&attitude, omega),
        }
    }

    #[inline]
    /// ½⟨IΩ, Ω⟩ + ⟨MgC, z⟩, J.
    fn energy(&self, attitude: &Attitude, omega: BodyVector) -> f64 {
        match self.kind {
            // Without a lever there is no height to ask for.
            Integrability::Euler => self.kinetic(omega),
            _ => self.kinetic(omega) + self.lever.dot(&up(attitude)),
        }
    }

    /// No torque resists: E is kept; L, or of it what gravity leaves; the fourth integral of tops that have one.
    pub fn lossless(&self, request: &Request, states: &[State]) -> Result<Accounts> {
        let mut accounts = Accounts::over(request, MOST_READ);
        let (first, scale) = (self.start.energy, self.energy_scale);
        accounts.conserved("energy", scale, first, |k| states[k].energy)?;
        let momentum = |state: &State| {
            state
                .attitude
                .to_space(self.body.angular_momentum(state.omega))
        };
        let (first, scale) = (momentum(&self.start), self.momentum_scale);
        if matches!(self.kind, Integrability::Euler) {
            accounts.conserved("angular momentum", scale, first, |k| momentum(&states[k]))?;
            return Ok(accounts);
        }
        let name = "angular momentum about the vertical";
        accounts.conserved(name, scale, first.z(), |k| momentum(&states[k]).z())?;
        if let Some((name, first, scale)) = self.fourth(&self.start) {
            let fourth = |k| self.fourth(&states[k]).map_or(first, |(_, value, _)| value);
            accounts.conserved(name, scale, first, fourth)?;
        }
        Ok(accounts)
    }

    /// Something resists: the energy can only fall, and with what was lost it is kept; without gravity |L| can only fall.
    pub fn lossy(&self, request: &Request, states: &[State], losses: &[f64]) -> Result<Accounts> {
        let mut accounts = Accounts::of(request);
        // The motion may be asked for before the start: monotone quantities begin with the earliest row.
        let earliest = accounts.order.first().map_or(&self.start, |&k| &states[k]);
        let scale = self.energy_scale;
        let falling = ("energy", Law::NonIncreasing, scale);
        accounts.keep(falling, earliest.energy, |k| states[k].energy)?;
        let (name, first) = ("energy and what resistance took", self.start.energy);
        accounts.conserved(name, scale, first, |k| states[k].energy + losses[k])?;
        if matches!(self.kind, Integrability::Euler) {
            let size = |state: &State| self.body.angular_momentum(state.omega).norm();
            let name = "size of the angular momentum";
            let falling = (name, Law::NonIncreasing, self.momentum_scale);
            accounts.keep(falling, size(earliest), |k| size(&states[k]))?;
        }
        Ok(accounts)
    }

    /// Name, value and scale of the fourth integral: L along the axis of symmetry, or Kovalevskaya's.
    fn fourth(&self, state: &State) -> Option<(&'static str, f64, f64)> {
        let l = self.body.angular_momentum(state.omega);
        match self.kind {
            Integrability::Lagrange(axis) => Some((
                "angular momentum about the axis of symmetry",
                l.components()[axis],
                self.momentum_scale,
            )),
            Integrability::SphericalInertia => Some((
                "angular momentum about the line to the centre of mass",
                l.dot(&self.lever) / self.lever.norm(),
                self.momentum_scale,
            )),
            Integrability::Kovalevskaya(axis) => {
                let turned = |v: BodyVector| {
                    let c = v.components();
                    [c[(axis + 1) % 3], c[(axis + 2) % 3]]
                };
                let [o1, o2] = turned(state.omega);
                let [z1, z2] = turned(up(&state.attitude));
                let [c1, c2] = turned(self.lever).map(|c| c / self.body.moments[axis]);
                let re = o1 * o1 - o2 * o2 - (c1 * z1 - c2 * z2);
                let im = 2.0 * o1 * o2 - (c1 * z2 + c2 * z1);
                let scale = self.energy_scale / self.body.moments[axis];
                Some(("Kovalevskaya's constant", re.hypot(im), scale))
            }
            _ => None,
        }
    }
}

pub(super) fn up(attitude: &Attitude) -> BodyVector {
    attitude.to_body(SpaceVector::new(0.0, 0.0, 1.0))
}
