//! The free top integrated without one elliptic function: Taylor's series of Euler's equations and of q' = ½ q Ω, 24
//! terms at a time, in pairs of doubles. A step is wrong by 1e-24, and that is what energy and angular momentum show.

#![allow(
    dead_code,
    reason = "each of the tests that include this file uses its own part"
)]

use spinning_bodies::frame::{Attitude, BodyVector};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number as an unevaluated sum of two doubles, the second below half a unit of the first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair(pub f64, pub f64);

#[inline(always)]
fn sum(a: f64, b: f64) -> Pair {
    let high = a + b;
    let part = high - a;
    Pair(high, (a - (high - part)) + (b - part))
}

impl From<f64> for Pair {
    fn from(x: f64) -> Self {
        Self(x, 0.0)
    }
}

impl Add for Pair {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let (high, low) = (sum(self.0, other.0), sum(self.1, other.1));
        let middle = sum(high.0, high.1 + low.0);
        sum(middle.0, middle.1 + low.1)
    }
}

impl Neg for Pair {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl Sub for Pair {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Pair {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let high = self.0 * other.0;
        let low = self.0.mul_add(other.0, -high) + (self.0 * other.1 + self.1 * other.0);
        sum(high, low)
    }
}

impl Div for Pair {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = self.0 / other.0;
        let rest = self - other * Self::from(first);
        let second = rest.0 / other.0;
        let rest = rest - other * Self::from(second);
        sum(first, second) + Self::from(rest.0 / other.0)
    }
}

impl Pair {
    pub fn value(self) -> f64 {
        self.0 + self.1
    }
}

const TERMS: usize = 24;

type Series = [Pair; TERMS + 1];

/// L along the body's axes, and the attitude as a quaternion, from the identity.
#[derive(Debug, Clone, Copy)]
pub struct Flight {
    pub l: [Pair; 3],
    pub q: [Pair; 4],
    inverse: [Pair; 3],
    /// L_i' = c_i L_j L_k.
    coupling: [Pair; 3],
}

impl Flight {
    /// From L in the body; no moment may be zero.
    pub fn new(moments: [f64; 3], l: [f64; 3]) -> Self {
        let i = moments.map(Pair::from);
        let one = Pair::from(1.0);
        let zero = Pair::from(0.0);
        Self {
            l: l.map(Pair::from),
            q: [one, zero, zero, zero],
            inverse: i.map(|moment| one / moment),
            coupling: [0, 1, 2].map(|n| {
                let (j, k) = ((n + 1) % 3, (n + 2) % 3);
                (i[j] - i[k]) / (i[j] * i[k])
            }),
        }
    }

    /// From Ω in the body.
    pub fn from_omega(moments: [f64; 3], omega: [f64; 3]) -> Self {
        let mut flight = Self::new(moments, [0.0; 3]);
        flight.l = [0, 1, 2].map(|n| Pair::from(moments[n]) * Pair::from(omega[n]));
        flight
    }

    /// Further by the time t, either way.
    pub fn fly(&mut self, t: f64) -> Self {
        self.fly_in_steps(t, 0.157)
    }

    /// The same with an error of 1e-31 a step, for motions that magnify it.
    pub fn fly_finely(&mut self, t: f64) -> Self {
        self.fly_in_steps(t, 0.08)
    }

    fn fly_in_steps(&mut self, t: f64, angle: f64) -> Self {
        // The nearest complex singularity is at least π/2 over the greatest angular velocity of this energy away: a step of
        // a tenth of that leaves out 10⁻²⁵.
        let step = angle / self.greatest_omega();
        let count = (t.abs() / step).ceil().max(1.0);
        let h = Pair::from(t) / Pair::from(count);
        for _ in 0..count as u64 {
            self.step(h);
        }
        *self
    }

    /// √(2E/I₁).
    fn greatest_omega(&self) -> f64 {
        let steepest = self.inverse.iter().fold(0.0, |m: f64, x| m.max(x.0));
        (self.twice_energy().value() * steepest).sqrt()
    }

    fn step(&mut self, h: Pair) {
        let zero = Pair::from(0.0);
        let (mut l, mut o, mut q): ([Series; 3], [Series; 3], [Series; 4]) = (
            [[zero; TERMS + 1]; 3],
            [[zero; TERMS + 1]; 3],
            [[zero; TERMS + 1]; 4],
        );
        let half = Pair::from(0.5);
        for k in 0..3 {
            l[k][0] = self.l[k];
            o[k][0] = self.l[k] * self.inverse[k];
        }
        for (series, start) in q.iter_mut().zip(self.q) {
            series[0] = start;
        }
        let product = |a: &Series, b: &Series, n: usize| {
            (0..=n).fold(zero, |total, m| total + a[m] * b[n - m])
        };
        for n in 0..TERMS {
            let next = Pair::from((n + 1) as f64);
            let p = |a: usize, b: usize| product(&q[a], &o[b], n);
            let rates = [
                -(p(1, 0) + p(2, 1) + p(3, 2)),
                p(0, 0) + p(2, 2) - p(3, 1),
                p(0, 1) + p(3, 0) - p(1, 2),
                p(0, 2) + p(1, 1) - p(2, 0),
            ];
            let turns = [0, 1, 2].map(|i| product(&l[(i + 1) % 3], &l[(i + 2) % 3], n));
            for i in 0..4 {
                q[i][n + 1] = half * rates[i] / next;
            }
            for i in 0..3 {
                l[i][n + 1] = self.coupling[i] * turns[i] / next;
                o[i][n + 1] = l[i][n + 1] * self.inverse[i];
            }
        }
        let value = |series: &Series| series.iter().rev().fold(zero, |total, c| total * h + *c);
        self.l = [0, 1, 2].map(|i| value(&l[i]));
        self.q = [0, 1, 2, 3].map(|i| value(&q[i]));
    }

    /// L along the body's axes, rounded.
    pub fn angular_momentum(&self) -> BodyVector {
        BodyVector::from_components(self.l.map(Pair::value).into())
    }

    /// Ω along the body's axes, rounded.
    pub fn omega(&self) -> BodyVector {
        let omega = [0, 1, 2].map(|k| (self.l[k] * self.inverse[k]).value());
        BodyVector::from_components(omega.into())
    }

    /// The attitude, rounded.
    pub fn attitude(&self) -> Attitude {
        let [w, x, y, z] = self.q.map(Pair::value);
        Attitude::from_quaternion(w, x, y, z).expect("four numbers of norm one")
    }

    /// L along the axes of space, in pairs.
    pub fn l_in_space(&self) -> [Pair; 3] {
        let [w, x, y, z] = self.q;
        let l = self.l;
        let v = [x, y, z];
        let cross = |a: [Pair; 3], b: [Pair; 3]| {
            [0, 1, 2].map(|n| {
                let (j, k) = ((n + 1) % 3, (n + 2) % 3);
                a[j] * b[k] - a[k] * b[j]
            })
        };
        let two = Pair::from(2.0);
        let t = cross(v, l).map(|c| two * c);
        let u = cross(v, t);
        [0, 1, 2].map(|n| l[n] + w * t[n] + u[n])
    }

    /// 2E = Σ L_i²/I_i, in pairs.
    pub fn twice_energy(&self) -> Pair {
        (0..3).fold(Pair::from(0.0), |total, k| {
            total + self.l[k] * self.l[k] * self.inverse[k]
        })
    }
}
