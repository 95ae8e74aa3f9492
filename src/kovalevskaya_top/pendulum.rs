//! The motions in which C stays in a vertical plane: a pendulum about axis 2 or axis 3, or rotation about axis 1 with C right above O or right below (8.2).
//!
//! If Ω is along axis 2 or 3 and z at right angles to it, both stay so; if Ω and z are along axis 1, neither changes. Two or more of the five roots coincide. With axis 1 called the third,
//! all three are motions of Lagrange's top, without spin about C or asleep: [`LagrangeTop`] solves them from the exact numbers given, near the separatrix and on it.

use nalgebra::Quaternion;

use super::constants::{Constants, WidePhase};
use super::taylor::FullState;
use crate::error::Result;
use crate::lagrange_top::{Exact, LagrangeTop};
use crate::precise::{DoubleDouble, Extended, Number};

/// A motion about a fixed axis.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Pendulum {
    /// The Lagrange top whose axes 1, 2, 3 are axes 2, 3, 1 of this one.
    top: LagrangeTop,
    /// The axis of this top about which it turns, counted from 0.
    axis: usize,
    /// The inverse of the Lagrange top's attitude at time 0, and the attitude of this one.
    back: Quaternion<f64>,
    start: Quaternion<f64>,
}

impl Pendulum {
    /// `None` unless the start is exactly of this kind.
    pub fn find(constants: &Constants, wide: &WidePhase, &(_, start): &FullState) -> Option<Self> {
        let [p, q, r, z1, z2, z3] = *wide;
        let none = |all: &[DoubleDouble]| all.iter().all(|x| x.high() == 0.0);
        let axis = if none(&[p, r, z2]) {
            1
        } else if none(&[p, q, z3]) {
            2
        } else if none(&[q, r, z2, z3]) {
            0
        } else {
            return None;
        };
        let (one, zero) = (DoubleDouble::from(1.0), DoubleDouble::from(0.0));
        // Any rotation of z onto the vertical will do; this one has no small denominator.
        let (far, turn) = if z1.high() < 0.0 {
            (one - z1, [z3, one - z1, zero, z2])
        } else {
            (one + z1, [one + z1, z3, -z2, zero])
        };
        let length = far.scaled(2.0).square_root();
        let turn = turn.map(|x| x / length);
        let exact = Exact {
            weight_moment: Extended::from(constants.c),
            omega: [q, r, p].map(Extended::from),
            quaternion: turn.map(Extended::from),
        };
        let moment = if axis == 2 { 1.0 } else { 2.0 };
        let [a, b, c, d] = turn.map(DoubleDouble::value);
        Some(Self {
            top: LagrangeTop::exactly(moment, moment, &exact).ok()?,
            axis,
            back: Quaternion::new(a, -b, -c, -d),
            start,
        })
    }

    /// The state with its attitude at time `t`.
    pub fn full_state(&self, t: f64) -> Result<FullState> {
        let state = self.top.at(t)?;
        let [q, r, p]: [f64; 3] = state.omega.components().into();
        let [z2, z3, z1]: [f64; 3] = state.up.components().into();
        let (mut omega, mut up) = ([0.0; 3], [z1, z2, z3]);
        omega[self.axis] = [p, q, r][self.axis];
        if self.axis > 0 {
            up[self.axis] = 0.0;
        }
        let turned = self.back * state.attitude.quaternion().into_inner();
        let mut turn = [0.0; 3];
        turn[self.axis] = [turned.k, turned.i, turned.j][self.axis];
        let attitude = self.start * Quaternion::from_parts(turned.w, turn.into());
        let ([p, q, r], [z1, z2, z3]) = (omega, up);
        Ok(([p, q, r, z1, z2, z3], attitude))
    }
}
