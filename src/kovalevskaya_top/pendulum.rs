//! The motions in which C keeps to a vertical plane: a pendulum about axis 2 or axis 3, or none, with C right above O or below (8.2).
//!
//! Ω along axis 2 or 3 with z at right angles to it stays so, and Ω along axis 1 with z along the same does not change at all. Two or more of the five roots are one. With axis 1 called the third,
//! all three are motions of Lagrange's top without spin about C, or asleep: [`LagrangeTop`] has them from the very numbers given, next to the separatrix and on it.

use nalgebra::Quaternion;

use super::constants::{Constants, WidePhase};
use super::taylor::Carried;
use crate::error::Result;
use crate::lagrange_top::{Exact, LagrangeTop};
use crate::precise::{DoubleDouble, Extended, Number};

/// A motion about an axis that stays.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Pendulum {
    /// Its axes 1, 2, 3 are 2, 3, 1 here.
    top: LagrangeTop,
    /// About which of our axes it turns, counted from 0.
    axis: usize,
    /// The inverse of its attitude at time 0, and ours.
    back: Quaternion<f64>,
    start: Quaternion<f64>,
}

impl Pendulum {
    /// None if the start is not in such a plane, exactly.
    pub fn find(constants: &Constants, wide: &WidePhase, &(_, start): &Carried) -> Option<Self> {
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
        // Any turn of z onto the vertical will do: here one of which no number is small.
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

    /// The state and how it stands.
    pub fn carried(&self, t: f64) -> Result<Carried> {
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
