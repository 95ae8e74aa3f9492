//! The constants of a motion in a loop over lanes: one number for all lanes, or a row of them.

use super::rate::Rate;
use crate::elliptic::lanes::{Choice, difference_of_bits};

/// A constant of the motion in a loop over lanes: one number for all, or one a lane.
pub(super) trait Constant: Copy {
    fn lane(&self, i: usize) -> f64;
}

impl Constant for f64 {
    #[inline(always)]
    fn lane(&self, _: usize) -> f64 {
        *self
    }
}

impl<const W: usize> Constant for [f64; W] {
    #[inline(always)]
    fn lane(&self, i: usize) -> f64 {
        self[i]
    }
}

#[inline(always)]
pub(super) fn all<C: Constant, const N: usize>(constants: &[C; N], i: usize) -> [f64; N] {
    core::array::from_fn(|k| constants[k].lane(i))
}

#[inline(always)]
pub(super) fn four<C: Constant>(constants: &[[C; 4]; 4], i: usize) -> [[f64; 4]; 4] {
    [
        all(&constants[0], i),
        all(&constants[1], i),
        all(&constants[2], i),
        all(&constants[3], i),
    ]
}

/// Row k holds the k-th number of every lane.
fn rows<const N: usize, const W: usize>(each: [&[f64; N]; W]) -> [[f64; W]; N] {
    core::array::from_fn(|k| core::array::from_fn(|i| each[i][k]))
}

fn tables<const N: usize, const W: usize>(each: [&[[f64; 4]; N]; W]) -> [[[f64; W]; 4]; N] {
    core::array::from_fn(|j| rows(each.map(|x| &x[j])))
}

/// Ω stays: half the angle turned, and the attitudes at no turn and at a half turn.
#[derive(Debug, Clone, Copy)]
pub(super) struct Steady<C> {
    pub(super) half_rate: Rate<C>,
    pub(super) unturned: [C; 4],
    pub(super) turned: [C; 4],
    pub(super) l: [C; 3],
    pub(super) omega: [C; 3],
}

/// The phases: u, reduced by quarter periods, and half of what ψ is made of besides theta functions.
#[derive(Debug, Clone, Copy)]
pub(super) struct Phases<C> {
    pub(super) rate: Rate<C>,
    pub(super) start: [C; 2],
    pub(super) inverse: C,
    pub(super) parts: [C; 3],
    pub(super) pace: [C; 2],
    pub(super) half_turning: Rate<C>,
    /// Half the lag in three words, of which the first two are short.
    pub(super) half_lag: [C; 3],
}

/// What sn, cn, dn and the turn about L are multiplied with.
#[derive(Debug, Clone, Copy)]
pub(super) struct Amplitudes<C> {
    /// Of L, of Ω and of L/|L|, for cn, sn and dn.
    pub(super) l: [C; 3],
    pub(super) omega: [C; 3],
    pub(super) direction: [C; 3],
    /// P₁/P₂.
    pub(super) aspect: C,
    /// The attitude from the turn by ψ after the shortest rotation, with the renumbering of the axes.
    pub(super) base: [[C; 4]; 4],
}

/// Ω moves, m ≤ 1/2.
#[derive(Debug, Clone, Copy)]
pub(super) struct Circular<C> {
    pub(super) phases: Phases<C>,
    pub(super) amplitudes: Amplitudes<C>,
    pub(super) corrections: [[C; 4]; 4],
    pub(super) real: [C; 4],
    pub(super) imaginary: [C; 3],
}

/// N polynomials next to even multiples of K, and by which bits those next to odd ones differ.
#[derive(Debug, Clone, Copy)]
pub(super) struct Choices<C, const N: usize> {
    even: [[C; 4]; N],
    change: [[C; 4]; N],
}

impl<const N: usize> Choices<f64, N> {
    pub(super) fn new(even: [[f64; 4]; N], odd: [[f64; 4]; N]) -> Self {
        let change = |j: usize, k: usize| difference_of_bits(even[j][k], odd[j][k]);
        Self {
            even,
            change: core::array::from_fn(|j| core::array::from_fn(|k| change(j, k))),
        }
    }
}

impl<const N: usize, const W: usize> Choices<[f64; W], N> {
    fn zero() -> Self {
        Self {
            even: [[[0.0; W]; 4]; N],
            change: [[[0.0; W]; 4]; N],
        }
    }

    #[inline(always)]
    pub(super) fn put(&mut self, i: usize, even: [[f64; 4]; N], odd: [[f64; 4]; N]) {
        for j in 0..N {
            for k in 0..4 {
                self.even[j][k][i] = even[j][k];
                self.change[j][k][i] = difference_of_bits(even[j][k], odd[j][k]);
            }
        }
    }

    fn gather(each: [&Choices<f64, N>; W]) -> Self {
        Self {
            even: tables(each.map(|x| &x.even)),
            change: tables(each.map(|x| &x.change)),
        }
    }
}

impl<C: Constant, const N: usize> Choices<C, N> {
    #[inline(always)]
    pub(super) fn lane(&self, i: usize) -> [Choice; N] {
        core::array::from_fn(|j| Choice {
            even: all(&self.even[j], i),
            change: all(&self.change[j], i),
        })
    }
}

/// Ω moves, m > 1/2, the separatrix included.
#[derive(Debug, Clone, Copy)]
pub(super) struct Hyperbolic<C> {
    pub(super) phases: Phases<C>,
    pub(super) amplitudes: Amplitudes<C>,
    pub(super) corrections: Choices<C, 4>,
    /// 2q′^{1/4} and √mc.
    pub(super) roots: [C; 2],
    /// Real and imaginary part of the theta function.
    pub(super) theta: Choices<C, 2>,
}

impl<const W: usize> Steady<[f64; W]> {
    pub(super) fn zero() -> Self {
        Self {
            half_rate: Rate::zero(),
            unturned: [[0.0; W]; 4],
            turned: [[0.0; W]; 4],
            l: [[0.0; W]; 3],
            omega: [[0.0; W]; 3],
        }
    }

    pub(super) fn gather(each: [&Steady<f64>; W]) -> Self {
        Self {
            half_rate: Rate::gather(each.map(|x| &x.half_rate)),
            unturned: rows(each.map(|x| &x.unturned)),
            turned: rows(each.map(|x| &x.turned)),
            l: rows(each.map(|x| &x.l)),
            omega: rows(each.map(|x| &x.omega)),
        }
    }
}

impl<const W: usize> Phases<[f64; W]> {
    pub(super) fn zero() -> Self {
        Self {
            rate: Rate::zero(),
            start: [[0.0; W]; 2],
            inverse: [0.0; W],
            parts: [[0.0; W]; 3],
            pace: [[0.0; W]; 2],
            half_turning: Rate::zero(),
            half_lag: [[0.0; W]; 3],
        }
    }

    fn gather(each: [&Phases<f64>; W]) -> Self {
        Self {
            rate: Rate::gather(each.map(|x| &x.rate)),
            start: rows(each.map(|x| &x.start)),
            inverse: each.map(|x| x.inverse),
            parts: rows(each.map(|x| &x.parts)),
            pace: rows(each.map(|x| &x.pace)),
            half_turning: Rate::gather(each.map(|x| &x.half_turning)),
            half_lag: rows(each.map(|x| &x.half_lag)),
        }
    }
}

impl<const W: usize> Amplitudes<[f64; W]> {
    pub(super) fn zero() -> Self {
        Self {
            l: [[0.0; W]; 3],
            omega: [[0.0; W]; 3],
            direction: [[0.0; W]; 3],
            aspect: [0.0; W],
            base: [[[0.0; W]; 4]; 4],
        }
    }

    fn gather(each: [&Amplitudes<f64>; W]) -> Self {
        Self {
            l: rows(each.map(|x| &x.l)),
            omega: rows(each.map(|x| &x.omega)),
            direction: rows(each.map(|x| &x.direction)),
            aspect: each.map(|x| x.aspect),
            base: tables(each.map(|x| &x.base)),
        }
    }
}

impl<const W: usize> Circular<[f64; W]> {
    pub(super) fn zero() -> Self {
        Self {
            phases: Phases::zero(),
            amplitudes: Amplitudes::zero(),
            corrections: [[[0.0; W]; 4]; 4],
            real: [[0.0; W]; 4],
            imaginary: [[0.0; W]; 3],
        }
    }

    pub(super) fn gather(each: [&Circular<f64>; W]) -> Self {
        Self {
            phases: Phases::gather(each.map(|x| &x.phases)),
            amplitudes: Amplitudes::gather(each.map(|x| &x.amplitudes)),
            corrections: tables(each.map(|x| &x.corrections)),
            real: rows(each.map(|x| &x.real)),
            imaginary: rows(each.map(|x| &x.imaginary)),
        }
    }
}

impl<const W: usize> Hyperbolic<[f64; W]> {
    pub(super) fn zero() -> Self {
        Self {
            phases: Phases::zero(),
            amplitudes: Amplitudes::zero(),
            corrections: Choices::zero(),
            roots: [[0.0; W]; 2],
            theta: Choices::zero(),
        }
    }

    pub(super) fn gather(each: [&Hyperbolic<f64>; W]) -> Self {
        Self {
            phases: Phases::gather(each.map(|x| &x.phases)),
            amplitudes: Amplitudes::gather(each.map(|x| &x.amplitudes)),
            corrections: Choices::gather(each.map(|x| &x.corrections)),
            roots: rows(each.map(|x| &x.roots)),
            theta: Choices::gather(each.map(|x| &x.theta)),
        }
    }
}
