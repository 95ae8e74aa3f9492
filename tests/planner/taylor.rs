//! The truth for bodies without a closed form: Taylor series of order 22 in two words a number.

use spinning_bodies::integrators::geometric::{Phase, Real, TwoWords};

/// A body under its weight and friction −cΩ.
pub struct Series {
    inverse: [TwoWords; 3],
    difference: [TwoWords; 3],
    lever: [TwoWords; 3],
    friction: TwoWords,
    order: usize,
}

/// Size of the last term that is taken, in units of L and of the quaternion.
const LAST: f64 = 1e-22;

impl Series {
    pub fn new(moments: [f64; 3], lever: [f64; 3], friction: f64, order: usize) -> Self {
        let moments = moments.map(TwoWords::from_double);
        Self {
            inverse: moments.map(Real::reciprocal),
            difference: core::array::from_fn(|k| {
                let (a, b) = (moments[(k + 1) % 3], moments[(k + 2) % 3]);
                (a - b) * (a * b).reciprocal()
            }),
            lever: lever.map(TwoWords::from_double),
            friction: TwoWords::from_double(friction),
            order,
        }
    }

    /// The phase at `t`, rounded.
    pub fn at(&self, start: &Phase, t: f64) -> Phase {
        let mut phase = start.cast::<TwoWords>();
        let norm = phase
            .q
            .iter()
            .fold(TwoWords::from_double(0.0), |s, &x| s + x * x);
        let scale = norm.square_root().reciprocal();
        phase.q = phase.q.map(|x| x * scale);
        let size = start.l.iter().map(|x| x * x).sum::<f64>().sqrt().max(1e-3);
        let mut left = TwoWords::from_double(t);
        while left.to_double() != 0.0 {
            let (l, q) = self.terms(&phase);
            let mut longest = f64::INFINITY;
            for k in [self.order - 1, self.order] {
                let of_l = l[k].iter().map(|x| x.to_double().abs() / size);
                let of_q = q[k].iter().map(|x| x.to_double().abs());
                let last = of_l.chain(of_q).fold(0.0, f64::max);
                longest = longest.min((LAST / last).powf(1.0 / k as f64));
            }
            let h = if longest < left.to_double().abs() {
                TwoWords::from_double(longest.copysign(t))
            } else {
                left
            };
            phase = Phase {
                l: core::array::from_fn(|n| sum(&l, n, h)),
                q: core::array::from_fn(|n| sum(&q, n, h)),
            };
            left = left - h;
        }
        phase.cast::<f64>()
    }

    fn terms(&self, phase: &Phase<TwoWords>) -> (Vec<[TwoWords; 3]>, Vec<[TwoWords; 4]>) {
        let zero = TwoWords::from_double(0.0);
        let two = TwoWords::from_double(2.0);
        let half = TwoWords::from_double(0.5);
        let (mut l, mut q) = (vec![phase.l], vec![phase.q]);
        let mut omega: Vec<[TwoWords; 3]> = Vec::new();
        for k in 0..self.order {
            omega.push(core::array::from_fn(|n| self.inverse[n] * l[k][n]));
            let (mut moved, mut up, mut turned) = ([zero; 3], [zero; 3], [zero; 4]);
            for i in 0..=k {
                let (a, b) = (&l[i], &l[k - i]);
                for n in 0..3 {
                    moved[n] = moved[n] + a[(n + 1) % 3] * b[(n + 2) % 3];
                }
                let ([w, x, y, z], [d, e, f, g]) = (q[i], q[k - i]);
                up[0] = up[0] + (x * g - w * f);
                up[1] = up[1] + (y * g + w * e);
                up[2] = up[2] + ((w * d + z * g) - (x * e + y * f));
                let [o1, o2, o3] = omega[k - i];
                turned[0] = turned[0] - (x * o1 + y * o2 + z * o3);
                turned[1] = turned[1] + (w * o1 + y * o3 - z * o2);
                turned[2] = turned[2] + (w * o2 + z * o1 - x * o3);
                turned[3] = turned[3] + (w * o3 + x * o2 - y * o1);
            }
            up = [two * up[0], two * up[1], up[2]];
            let part = TwoWords::from_double((k + 1) as f64).reciprocal();
            l.push(core::array::from_fn(|n| {
                let (a, b) = ((n + 1) % 3, (n + 2) % 3);
                let weight = up[a] * self.lever[b] - up[b] * self.lever[a];
                part * (self.difference[n] * moved[n] + weight - self.friction * omega[k][n])
            }));
            q.push(turned.map(|x| half * part * x));
        }
        (l, q)
    }
}

fn sum<const N: usize>(terms: &[[TwoWords; N]], n: usize, h: TwoWords) -> TwoWords {
    let zero = TwoWords::from_double(0.0);
    terms.iter().rev().fold(zero, |s, term| s * h + term[n])
}
