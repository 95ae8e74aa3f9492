//! The equations of a top for any method: L along the body's axes, the attitude's quaternion and, where something resists, the work it takes.

use super::body::Body;
use super::effects::{Resistance, Turning, Weight};
use crate::euler_equations::quaternion_rate;
use crate::frame::{Attitude, BodyVector};
use crate::integrators::System;

/// A body and the torques on it, each effect a type.
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

/// The same with all divisions done: an evaluation waits for each of its operations, and for a division three times as long as for a sum.
#[derive(Debug, Clone, Copy)]
pub(super) struct Divided<E> {
    effects: E,
    inverse: [f64; 3],
    /// (I₂ − I₃)/(I₂I₃) and so on: L₁′ is this times L₂L₃, nearly equal moments lose nothing.
    difference: [f64; 3],
    lever: [f64; 3],
}

impl<G: Weight, F: Resistance, B: Resistance, D: Resistance, T: Resistance>
    Equations<G, F, B, D, T>
{
    /// For moments that are not zero.
    pub fn divided(self) -> Divided<Self> {
        Divided {
            inverse: self.moments.map(|moment| 1.0 / moment),
            difference: core::array::from_fn(|k| {
                let (a, b) = (self.moments[(k + 1) % 3], self.moments[(k + 2) % 3]);
                (a - b) / a / b
            }),
            lever: self.gravity.lever(self.arm),
            effects: self,
        }
    }

    /// What resists.
    #[inline(always)]
    fn resistance(&self, turning: &Turning) -> [f64; 3] {
        let mut torque = [0.0; 3];
        self.pivot_friction.add_torque(turning, &mut torque);
        self.bearing_friction.add_torque(turning, &mut torque);
        self.air_drag.add_torque(turning, &mut torque);
        self.tip_friction.add_torque(turning, &mut torque);
        torque
    }
}

impl<G: Weight, F: Resistance, B: Resistance, D: Resistance, T: Resistance>
    Divided<Equations<G, F, B, D, T>>
{
    /// L′ = L∧Ω + N and q′ = ½qΩ, and the power that the resistance takes.
    #[inline(always)]
    fn rates(&self, y: &[f64; 7]) -> ([f64; 7], f64) {
        let [a, b, c, w, x, y, z] = *y;
        let [j1, j2, j3] = self.inverse;
        let omega = [j1 * a, j2 * b, j3 * c];
        // The third row of the rotation matrix, for |q| = 1: off it the equations go on smoothly, and q stays on it as well as it is computed.
        let up = [
            2.0 * (x * z - w * y),
            2.0 * (y * z + w * x),
            (w * w + z * z) - (x * x + y * y),
        ];
        let resistance = self.effects.resistance(&Turning { omega, up });
        let [d1, d2, d3] = self.difference;
        let mut n = [d1 * (b * c), d2 * (c * a), d3 * (a * b)];
        if G::PRESENT {
            let [x, y, z] = self.lever;
            n[0] += up[1] * z - up[2] * y;
            n[1] += up[2] * x - up[0] * z;
            n[2] += up[0] * y - up[1] * x;
        }
        let [n1, n2, n3] = core::array::from_fn(|k| n[k] + resistance[k]);
        let [o1, o2, o3] = omega;
        let power = -(resistance[0] * o1 + resistance[1] * o2 + resistance[2] * o3);
        let [qw, qx, qy, qz] = quaternion_rate([w, x, y, z], BodyVector::new(o1, o2, o3));
        ([n1, n2, n3, qw, qx, qy, qz], power)
    }
}

/// Nothing resists: seven numbers.
pub(super) struct Lossless<E>(pub Divided<E>);

impl<G: Weight, F: Resistance, B: Resistance, D: Resistance, T: Resistance> System<7>
    for Lossless<Equations<G, F, B, D, T>>
{
    fn rate(&self, _: f64, y: &[f64; 7]) -> [f64; 7] {
        self.0.rates(y).0
    }
}

/// Something resists: the eighth number is the energy that it has taken.
pub(super) struct Lossy<E>(pub Divided<E>);

impl<G: Weight, F: Resistance, B: Resistance, D: Resistance, T: Resistance> System<8>
    for Lossy<Equations<G, F, B, D, T>>
{
    fn rate(&self, _: f64, y: &[f64; 8]) -> [f64; 8] {
        let [a, b, c, w, x, y, z, _] = *y;
        let ([n1, n2, n3, qw, qx, qy, qz], power) = self.0.rates(&[a, b, c, w, x, y, z]);
        [n1, n2, n3, qw, qx, qy, qz, power]
    }
}

/// Attitude and Ω of a state.
pub(super) fn unpacked(moments: [f64; 3], y: &[f64]) -> (Attitude, BodyVector) {
    let quaternion = nalgebra::Quaternion::new(y[3], y[4], y[5], y[6]);
    let [o1, o2, o3] = core::array::from_fn(|k| y[k] / moments[k]);
    (
        Attitude::from_unit(quaternion / quaternion.norm()),
        BodyVector::new(o1, o2, o3),
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
