//! The equations of a top for a general method: Ω, the attitude's quaternion and, where something resists, the work it takes.

use super::body::Body;
use super::effects::{Resistance, Turning, Weight};
use crate::euler_equations::quaternion_rate;
use crate::frame::{Attitude, BodyVector};
use crate::integrators::System;

/// Euler's equations with the torques of the effects, each a type.
#[derive(Debug, Clone, Copy)]
pub(super) struct Equations<G, F, B, D, T> {
    pub moments: [f64; 3],
    pub arm: [f64; 3],
    pub gravity: G,
    pub pivot_friction: F,
    pub bearing_friction: B,
    pub air_drag: D,
    pub tip_friction: T,
}

impl<G: Weight, F: Resistance, B: Resistance, D: Resistance, T: Resistance>
    Equations<G, F, B, D, T>
{
    /// dΩ/dt and dq/dt, and the torque that resists.
    #[inline]
    fn rates(&self, y: &[f64; 7]) -> ([f64; 7], [f64; 3]) {
        let [o1, o2, o3, w, x, y, z] = *y;
        let omega = [o1, o2, o3];
        // The third row of the rotation matrix; the quaternion's length drifts off 1 within the tolerance.
        let square = w * w + x * x + y * y + z * z;
        let up = [
            2.0 * (x * z - w * y) / square,
            2.0 * (y * z + w * x) / square,
            ((w * w + z * z) - (x * x + y * y)) / square,
        ];
        let turning = Turning { omega, up };
        let mut resistance = [0.0; 3];
        self.pivot_friction.add_torque(&turning, &mut resistance);
        self.bearing_friction.add_torque(&turning, &mut resistance);
        self.air_drag.add_torque(&turning, &mut resistance);
        self.tip_friction.add_torque(&turning, &mut resistance);
        let mut torque = resistance;
        self.gravity.add_torque(self.arm, up, &mut torque);
        let [i1, i2, i3] = self.moments;
        let [qw, qx, qy, qz] = quaternion_rate([w, x, y, z], BodyVector::new(o1, o2, o3));
        let rates = [
            ((i2 - i3) * o2 * o3 + torque[0]) / i1,
            ((i3 - i1) * o3 * o1 + torque[1]) / i2,
            ((i1 - i2) * o1 * o2 + torque[2]) / i3,
            qw,
            qx,
            qy,
            qz,
        ];
        (rates, resistance)
    }
}

/// Nothing resists: seven numbers.
pub(super) struct Lossless<'a, E>(pub &'a E);

impl<G: Weight, F: Resistance, B: Resistance, D: Resistance, T: Resistance> System<7>
    for Lossless<'_, Equations<G, F, B, D, T>>
{
    fn rate(&self, _: f64, y: &[f64; 7]) -> [f64; 7] {
        self.0.rates(y).0
    }
}

/// Something resists: the eighth number is the energy that it has taken.
pub(super) struct Lossy<'a, E>(pub &'a E);

impl<G: Weight, F: Resistance, B: Resistance, D: Resistance, T: Resistance> System<8>
    for Lossy<'_, Equations<G, F, B, D, T>>
{
    fn rate(&self, _: f64, y: &[f64; 8]) -> [f64; 8] {
        let [o1, o2, o3, w, x, y, z, _] = *y;
        let (rates, [n1, n2, n3]) = self.0.rates(&[o1, o2, o3, w, x, y, z]);
        let [a1, a2, a3, qw, qx, qy, qz] = rates;
        let power = -(n1 * o1 + n2 * o2 + n3 * o3);
        [a1, a2, a3, qw, qx, qy, qz, power]
    }
}

/// Ω and attitude as the first seven numbers.
pub(super) fn packed(omega: BodyVector, attitude: &Attitude) -> [f64; 7] {
    let q = attitude.quaternion();
    [omega.x(), omega.y(), omega.z(), q.w, q.i, q.j, q.k]
}

pub(super) fn unpacked(y: &[f64]) -> (Attitude, BodyVector) {
    let quaternion = nalgebra::Quaternion::new(y[3], y[4], y[5], y[6]);
    (
        Attitude::from_unit(quaternion / quaternion.norm()),
        BodyVector::new(y[0], y[1], y[2]),
    )
}

/// The rate that this top turns at, or would if it fell from upright, rad/s: the scale of Ω.
pub(super) fn fastest(body: &Body, lever: [f64; 3], omega: BodyVector) -> f64 {
    let least = body.moments.iter().fold(f64::INFINITY, |a, &b| a.min(b));
    let [x, y, z] = lever;
    omega
        .norm()
        .hypot((2.0 * x.hypot(y).hypot(z) / least).sqrt())
}
