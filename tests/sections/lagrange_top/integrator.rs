//! Lagrange's top integrated along the axes of space, without angles and without elliptic functions: e' = L∧e/I₁,
//! L' = Mgl ẑ∧e and q' = ½ωq with ω = L/I₁ + (Ω₃ − L₃/I₁)e, by Taylor's series of 24 terms. There are no poles here.

use spinning_bodies::frame::{Attitude, BodyVector};

const TERMS: usize = 24;

/// Moments about the pivot and Mgl.
#[derive(Debug, Clone, Copy)]
pub struct Body {
    pub transverse: f64,
    pub axial: f64,
    pub weight_moment: f64,
}

/// The unit top of this section.
pub const UNIT: Body = Body {
    transverse: 1.0,
    axial: super::common::AXIAL,
    weight_moment: 1.0,
};

#[derive(Debug, Clone, Copy)]
pub struct Motion {
    pub axis: [f64; 3],
    pub momentum: [f64; 3],
    pub attitude: [f64; 4],
    /// Azimuth of the axis gained since the start, where it does not pass through a pole.
    pub azimuth: f64,
    body: Body,
    spin: f64,
}

type Series = [f64; TERMS + 1];

fn product(a: &Series, b: &Series, n: usize) -> f64 {
    (0..=n).map(|k| a[k] * b[n - k]).sum()
}

impl Motion {
    pub fn start(body: Body, omega: BodyVector, attitude: Attitude) -> Self {
        let l = BodyVector::new(
            body.transverse * omega.x(),
            body.transverse * omega.y(),
            body.axial * omega.z(),
        );
        let q = attitude.quaternion();
        let axis = attitude.to_space(BodyVector::new(0.0, 0.0, 1.0));
        Self {
            axis: axis.components().into(),
            momentum: attitude.to_space(l).components().into(),
            attitude: [q.w, q.i, q.j, q.k],
            azimuth: 0.0,
            body,
            spin: omega.z() * (1.0 - body.axial / body.transverse),
        }
    }

    /// The motion t later.
    pub fn after(mut self, t: f64) -> Self {
        let mut left = t.abs();
        while left > 0.0 {
            left = self.step(left, t.signum());
        }
        self
    }

    /// Angle to an attitude, radians.
    pub fn angle_to(&self, attitude: &Attitude) -> f64 {
        let [w, x, y, z] = self.attitude;
        Attitude::from_quaternion(w, x, y, z)
            .unwrap()
            .angle_to(attitude)
    }

    fn step(&mut self, left: f64, sign: f64) -> f64 {
        let mut e = [[0.0; TERMS + 1]; 3];
        let mut l = e;
        let mut q = [[0.0; TERMS + 1]; 4];
        for k in 0..3 {
            (e[k][0], l[k][0]) = (self.axis[k], self.momentum[k]);
        }
        for (series, start) in q.iter_mut().zip(self.attitude) {
            series[0] = start;
        }
        let Body {
            transverse,
            weight_moment,
            ..
        } = self.body;
        let mut omega = e;
        for n in 0..TERMS {
            for k in 0..3 {
                omega[k][n] = l[k][n] / transverse + self.spin * e[k][n];
            }
            let over = sign / (n as f64 + 1.0);
            for k in 0..3 {
                let (a, b) = ((k + 1) % 3, (k + 2) % 3);
                e[k][n + 1] =
                    (product(&l[a], &e[b], n) - product(&l[b], &e[a], n)) / transverse * over;
            }
            l[0][n + 1] = -weight_moment * e[1][n] * over;
            l[1][n + 1] = weight_moment * e[0][n] * over;
            let [x, y, z] = omega;
            let [p, i, j, k] = q;
            let half = 0.5 * over;
            q[0][n + 1] = -half * (product(&x, &i, n) + product(&y, &j, n) + product(&z, &k, n));
            q[1][n + 1] = half * (product(&x, &p, n) + product(&y, &k, n) - product(&z, &j, n));
            q[2][n + 1] = half * (product(&y, &p, n) + product(&z, &i, n) - product(&x, &k, n));
            q[3][n + 1] = half * (product(&z, &p, n) + product(&x, &j, n) - product(&y, &i, n));
        }
        // The last terms say how far the series reaches; a fifth of that leaves 1e-17 of them.
        let reach = |s: &Series| {
            let root = |n: usize| s[n].abs().powf(1.0 / n as f64);
            root(TERMS).max(root(TERMS - 1))
        };
        let fastest = e.iter().chain(&l).chain(&q).map(reach).fold(0.0, f64::max);
        let step = if fastest > 0.0 {
            (0.2 / fastest).min(left)
        } else {
            left
        };
        let value = |s: &Series| s.iter().rev().fold(0.0, |sum, c| sum * step + c);
        let before = self.axis;
        self.axis = [0, 1, 2].map(|k| value(&e[k]));
        self.momentum = [0, 1, 2].map(|k| value(&l[k]));
        self.attitude = [0, 1, 2, 3].map(|k| value(&q[k]));
        let [x, y, _] = self.axis;
        let turned = (before[0] * y - before[1] * x).atan2(before[0] * x + before[1] * y);
        self.azimuth += turned;
        left - step
    }
}
