//! A heavy top by power series of order 30, any moments, with the attitude: the independent method for section 8.
//!
//! Steps so short that the last terms are below rounding; nothing is projected, so the drift of the constants shows the error.
//! In doubles, or in double-doubles for 30 digits.

use crate::double_double::Dd;
use crate::{Field, greatest};

pub const ORDER: usize = 30;

/// Ω, z and attitude quaternion.
pub type Whole<T = f64> = [T; 10];

/// What the series are made of.
pub trait Number: Field + Default + From<f64> {
    /// Below this, as a part of the first, the last terms are dropped.
    const TINY: f64;
    fn double(self) -> f64;
}

impl Number for f64 {
    const TINY: f64 = 1e-18;
    fn double(self) -> f64 {
        self
    }
}

impl Number for Dd {
    const TINY: f64 = 1e-32;
    fn double(self) -> f64 {
        self.value()
    }
}

/// Euler–Poisson equations I dΩ/dt = IΩ∧Ω + z∧MgC, dz/dt = z∧Ω, dq/dt = ½qΩ.
#[derive(Debug, Clone, Copy)]
pub struct Top {
    pub moments: [f64; 3],
    pub lever: [f64; 3],
}

impl Top {
    pub fn after<T: Number>(&self, start: Whole<T>, t: f64) -> Whole<T> {
        let (mut y, mut done) = (start, 0.0);
        while done != t {
            let terms = self.series(&y);
            let size = |n: usize| greatest(terms[n].map(|x| x.double().abs()));
            let [one, other] =
                [ORDER - 1, ORDER].map(|n| (T::TINY * size(0) / size(n)).powf(1.0 / n as f64));
            let (reach, rest): (f64, f64) = (one.min(other), t - done);
            // The clock in steps that a double can count without rounding.
            let step = (rest.abs().min(reach) * 1048576.0).floor() / 1048576.0;
            let next = if rest.abs() <= reach {
                t
            } else {
                done + step.copysign(rest)
            };
            let h = T::from(next - done);
            let mut sum = [T::default(); 10];
            for term in terms.iter().rev() {
                for (s, x) in sum.iter_mut().zip(term) {
                    *s = h * *s + *x;
                }
            }
            (y, done) = (sum, next);
        }
        y
    }

    fn series<T: Number>(&self, y: &Whole<T>) -> Vec<Whole<T>> {
        let [i1, i2, i3] = self.moments.map(T::from);
        let [c1, c2, c3] = self.lever.map(T::from);
        let half = T::from(0.5);
        let mut terms = vec![*y];
        for n in 0..ORDER {
            let of = |a: usize, b: usize| {
                (0..=n).fold(T::default(), |sum, m| sum + terms[m][a] * terms[n - m][b])
            };
            let [z1, z2, z3] = [terms[n][3], terms[n][4], terms[n][5]];
            let next = [
                ((i2 - i3) * of(1, 2) + z2 * c3 - z3 * c2) / i1,
                ((i3 - i1) * of(2, 0) + z3 * c1 - z1 * c3) / i2,
                ((i1 - i2) * of(0, 1) + z1 * c2 - z2 * c1) / i3,
                of(4, 2) - of(5, 1),
                of(5, 0) - of(3, 2),
                of(3, 1) - of(4, 0),
                T::default() - half * (of(7, 0) + of(8, 1) + of(9, 2)),
                half * (of(6, 0) + of(8, 2) - of(9, 1)),
                half * (of(6, 1) + of(9, 0) - of(7, 2)),
                half * (of(6, 2) + of(7, 1) - of(8, 0)),
            ];
            terms.push(next.map(|x| x / T::from((n + 1) as f64)));
        }
        terms
    }
}
