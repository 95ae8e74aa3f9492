//! The free top integrated without one elliptic function: Taylor's series of Euler's equations and of q' = ½ q Ω, 24
//! terms at a time, in pairs of doubles. A step is wrong by 1e-24, and that is what energy and angular momentum show.

use crate::double_double::Dd;
use spinning_bodies::frame::{Attitude, BodyVector};

const TERMS: usize = 24;

type Series = [Dd; TERMS + 1];

/// L along the body's axes, and the attitude as a quaternion, from the identity.
#[derive(Debug, Clone, Copy)]
pub struct Flight {
    pub l: [Dd; 3],
    pub q: [Dd; 4],
    inverse: [Dd; 3],
    /// L_i' = c_i L_j L_k.
    coupling: [Dd; 3],
}

impl Flight {
    /// From L in the body; no moment may be zero.
    pub fn new(moments: [f64; 3], l: [f64; 3]) -> Self {
        let i = moments.map(Dd::from);
        let one = Dd::from(1.0);
        let zero = Dd::from(0.0);
        Self {
            l: l.map(Dd::from),
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
        flight.l = [0, 1, 2].map(|n| Dd::from(moments[n]) * Dd::from(omega[n]));
        flight
    }

    /// Further by the time t, either way.
    pub fn fly(&mut self, t: f64) -> Self {
        // The nearest complex singularity is at least π/2 over the greatest angular velocity of this energy away: a step of
        // a tenth of that leaves out 10⁻²⁵.
        let step = 0.157 / self.greatest_omega();
        let count = (t.abs() / step).ceil().max(1.0);
        let h = Dd::from(t) / Dd::from(count);
        for _ in 0..count as u64 {
            self.step(h);
        }
        *self
    }

    /// √(2E/I₁).
    fn greatest_omega(&self) -> f64 {
        let steepest = self.inverse.iter().fold(0.0, |m: f64, x| m.max(x.hi));
        (self.twice_energy().value() * steepest).sqrt()
    }

    fn step(&mut self, h: Dd) {
        let zero = Dd::from(0.0);
        let (mut l, mut o, mut q): ([Series; 3], [Series; 3], [Series; 4]) = (
            [[zero; TERMS + 1]; 3],
            [[zero; TERMS + 1]; 3],
            [[zero; TERMS + 1]; 4],
        );
        let half = Dd::from(0.5);
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
            let next = Dd::from((n + 1) as f64);
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
        BodyVector::from_components(self.l.map(Dd::value).into())
    }

    /// Ω along the body's axes, rounded.
    pub fn omega(&self) -> BodyVector {
        let omega = [0, 1, 2].map(|k| (self.l[k] * self.inverse[k]).value());
        BodyVector::from_components(omega.into())
    }

    /// The attitude, rounded.
    pub fn attitude(&self) -> Attitude {
        let [w, x, y, z] = self.q.map(Dd::value);
        Attitude::from_quaternion(w, x, y, z).expect("four numbers of norm one")
    }

    /// 2E = Σ L_i²/I_i, in pairs.
    pub fn twice_energy(&self) -> Dd {
        (0..3).fold(Dd::from(0.0), |total, k| {
            total + self.l[k] * self.l[k] * self.inverse[k]
        })
    }
}
