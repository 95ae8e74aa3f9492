//! The equations of a top in steps: L along the body's axes, the attitude's quaternion and, with resistance, the energy lost.

use nalgebra::Vector3;

use super::effects::{State, Top};
use super::ledger::{self, Conserved};
use crate::euler_equations::{AxisMoments, quaternion_rate};
use crate::integrators::geometric::Phase;
use crate::precise::power_of_two_below;
use crate::scene::engine::{DOUBT, tilted};
use crate::scene::prelude::*;

/// A top as a flow of seven components, L and the quaternion, and with resistance an eighth, the energy lost.
///
/// An absent effect is `None` and costs nothing in an evaluation. Quotients are precomputed, because the operations of an evaluation
/// depend on each other. Masses are counted in a unit of which the greatest moment is between one and two, or the product of two components of L
/// might leave the range of doubles; the unit is a power of two, which rounds nothing.
#[derive(Clone)]
pub(super) struct Turning {
    /// The unit, kg.
    pub unit: f64,
    pub moments: [f64; 3],
    inverse: Vector3<f64>,
    /// (I₂ − I₃)/(I₂I₃) and cyclic: L₁′ is this times L₂L₃, so that nearly equal moments lose no digits.
    difference: [f64; 3],
    pub lever: Option<[f64; 3]>,
    pivot_friction: Option<f64>,
    bearing_friction: Option<f64>,
    air_drag: Option<f64>,
    /// The torque of dry friction at the tip, with the sign of the initial spin.
    tip_friction: Option<f64>,
    start: Phase,
    pace: f64,
    /// The rate at which the weight makes a top at rest fall, rad/s.
    falling: f64,
    energy: f64,
}

/// Whether dry friction at the tip brakes the spin.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Spin {
    /// It does, if the scene has it.
    Spinning,
    /// It has brought L₃ to zero, where L₃ stays.
    Stopped,
}

impl Turning {
    /// The flow of a top, with `energy` (J) as the scale of the energy lost.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) for a body with an axis without moment.
    pub fn new(top: &Top, energy: f64) -> Result<Self> {
        top.body.has_every_moment()?;
        let unit = power_of_two_below(top.body.moments.iter().copied().fold(0.0, f64::max));
        let moments = top.body.moments.map(|moment| moment / unit);
        let mut start = top.start.phase(&top.body)?;
        start.l = start.l.map(|part| part / unit);
        let spin = start.l[2];
        Ok(Self {
            unit,
            moments,
            inverse: Vector3::from(moments).map(|moment| 1.0 / moment),
            difference: core::array::from_fn(|k| {
                let (a, b) = (moments[(k + 1) % 3], moments[(k + 2) % 3]);
                (a - b) / a / b
            }),
            lever: top.gravity.map(|_| top.lever().map(|part| part / unit)),
            pivot_friction: top.pivot_friction.map(|friction| friction.value() / unit),
            bearing_friction: top.bearing_friction.map(|friction| friction.value() / unit),
            air_drag: top.air_drag.map(|drag| drag.value() / unit),
            tip_friction: top
                .tip_friction
                .map(|friction| (friction.value() / unit).copysign(spin)),
            start,
            pace: top.pace()?,
            falling: top.falling(),
            energy: (energy / unit).max(f64::MIN_POSITIVE),
        })
    }

    // ANCHOR: resistance
    /// The torque of all resistances, N m.
    fn resistance(&self, spin: Spin, omega: &Vector3<f64>) -> Vector3<f64> {
        let mut torque = Vector3::zeros();
        if let Some(c) = self.pivot_friction {
            torque -= c * omega;
        }
        if let Some(c) = self.bearing_friction {
            torque -= c * Vector3::new(omega.x, omega.y, 0.0);
        }
        if let Some(k) = self.air_drag {
            // Not by `hypot`, which would take longer than all the rest.
            torque -= k * omega.norm() * omega;
        }
        if let Some(dry) = self.tip_friction
            && spin == Spin::Spinning
        {
            torque.z -= dry;
        }
        torque
    }
    // ANCHOR_END: resistance

    /// The state with these components.
    pub fn state<const N: usize>(&self, numbers: &[f64; N], conserved: &Conserved) -> State {
        let Phase { l, q } = phase(numbers);
        let [w, x, y, z] = q;
        let quaternion = nalgebra::Quaternion::new(w, x, y, z);
        let omega: [f64; 3] = core::array::from_fn(|k| l[k] / self.moments[k]);
        let attitude = Attitude::from_unit(quaternion.normalize());
        ledger::state(&conserved.heavy, attitude, omega.into())
    }

    /// Ω̇ along the body's axes, rad/s², at this attitude and Ω, before dry friction stops the spin; what that does about the third axis does not move C, which lies on it.
    pub fn acceleration(&self, attitude: &Attitude, omega: BodyVector) -> BodyVector {
        let l = AxisMoments::allowing_rods(self.moments).angular_momentum(omega);
        let Phase { l, q } = Phase::new(l, attitude);
        let y = numbers(l, q, 0.0);
        let [n1, n2, n3, ..] = Flow::<8>::rate(self, Spin::Spinning, 0.0, &y);
        BodyVector::from_components(self.omega([n1, n2, n3]))
    }

    /// Ω, rad/s, for this L; and Ω̇ for this torque.
    #[inline]
    fn omega(&self, l: [f64; 3]) -> Vector3<f64> {
        self.inverse.component_mul(&Vector3::from(l))
    }

    /// |Ω|, rad/s, for this L.
    fn speed(&self, l: [f64; 3]) -> f64 {
        BodyVector::from_components(self.omega(l)).norm()
    }
}

impl<const N: usize> Flow<N> for Turning {
    type Phase = Spin;
    const KEPT: Kept = Kept::UnitQuaternion(3);

    fn start(&self) -> Result<(Spin, [f64; N])> {
        let rests = self.tip_friction.is_some() && self.start.l[2] == 0.0;
        let spin = if rests { Spin::Stopped } else { Spin::Spinning };
        Ok((spin, numbers(self.start.l, self.start.q, 0.0)))
    }

    fn scales(&self) -> [f64; N] {
        let momenta = self.moments.map(|moment| moment * self.pace);
        numbers(momenta, [1.0; 4], self.energy)
    }

    fn doubt(&self, _: f64) -> [f64; N] {
        let rate = self.speed(self.start.l);
        let [w, x, y, z] = self.start.q;
        let q = tilted(nalgebra::Quaternion::new(w, x, y, z));
        let mut l = core::array::from_fn(|n| DOUBT[n] * self.moments[n] * rate);
        if self.tip_friction.is_some() && self.start.l[2] == 0.0 {
            // A spin stopped by dry friction is exactly 0.
            l[2] = 0.0;
        }
        numbers(l, [q.w, q.i, q.j, q.k], 0.0)
    }

    fn pace(&self) -> f64 {
        self.pace
    }

    /// Near an equilibrium the motion is at first smaller than any tolerance.
    fn growth_rate(&self) -> f64 {
        self.falling
    }

    /// L′ = L∧Ω + N, q′ = ½qΩ, and the power lost to resistance.
    fn rate(&self, spin: Spin, _: f64, y: &[f64; N]) -> [f64; N] {
        let phase = phase(y);
        let ([a, b, c], [d1, d2, d3]) = (phase.l, self.difference);
        let omega = self.omega(phase.l);
        let mut torque = Vector3::new(d1 * (b * c), d2 * (c * a), d3 * (a * b));
        if let Some(lever) = self.lever {
            // The third row of the rotation matrix for |q| = 1; the equations are smooth off that norm, too, and every step restores it.
            torque += Vector3::from(phase.up()).cross(&Vector3::from(lever));
        }
        let turned = quaternion_rate(phase.q, BodyVector::from_components(omega));
        let mut power = 0.0;
        // With seven components nothing resists.
        if N > 7 {
            let resistance = self.resistance(spin, &omega);
            torque += resistance;
            power -= resistance.dot(&omega);
        }
        numbers(torque.into(), turned, power)
    }

    fn margin(&self, spin: Spin, _: f64, y: &[f64; N]) -> Option<f64> {
        let brakes = self.tip_friction.is_some() && spin == Spin::Spinning;
        brakes.then(|| y[2] * self.start.l[2].signum())
    }

    fn next(&self, _: Spin, _: Stop, _: f64, y: &mut [f64; N]) -> Result<Spin> {
        y[2] = 0.0;
        Ok(Spin::Stopped)
    }

    fn furthest_apart(&self, a: &[At<Spin, N>], b: &[At<Spin, N>], seen: &[At<Spin, N>]) -> f64 {
        // A lower bound of the fastest rate of the motion, rad/s.
        let start = self.speed(self.start.l);
        let speeds = seen.iter().map(|(_, y)| self.speed(phase(y).l));
        let fastest = match speeds.fold(start, f64::max) {
            0.0 => self.pace,
            fastest => fastest,
        };
        // The greatest of: the angle between the attitudes (radians), the difference of Ω over the fastest rate, that of the energy lost over its scale.
        let apart = |a: &[f64; N], b: &[f64; N]| {
            let between: [f64; N] = core::array::from_fn(|n| a[n] - b[n]);
            let Phase { l, q } = phase(&between);
            let turned: f64 = q.iter().map(|part| part.powi(2)).sum();
            let lost = between.get(7).map_or(0.0, |lost| lost.abs() / self.energy);
            let turning = (2.0 * turned.sqrt()).max(self.speed(l) / fastest);
            greater(turning, lost)
        };
        let apart = a.iter().zip(b).map(|((_, a), (_, b))| apart(a, b));
        apart.fold(0.0, greater)
    }
}

/// L and the quaternion.
pub(super) fn phase(y: &[f64]) -> Phase {
    let (l, q) = ([y[0], y[1], y[2]], [y[3], y[4], y[5], y[6]]);
    Phase { l, q }
}

/// The components: L, the quaternion and, if there are eight, the energy lost; or the same of their rates or scales.
#[inline]
fn numbers<const N: usize>(l: [f64; 3], q: [f64; 4], lost: f64) -> [f64; N] {
    let mut all = [lost; N];
    all[..3].copy_from_slice(&l);
    all[3..7].copy_from_slice(&q);
    all
}
