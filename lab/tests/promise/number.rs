//! Sines, vectors and turns in double-doubles.

use std::sync::LazyLock;

use nalgebra::{Matrix3, Vector3};
use support::double_double::Dd;

/// Sine and cosine.
pub trait Angle: Sized {
    fn sine_cosine(self) -> (Self, Self);
}

impl Angle for Dd {
    /// By the series for an eighth of what is left of the angle beside the nearest quarter turn.
    fn sine_cosine(self) -> (Self, Self) {
        let turns = (self.hi / QUARTER.hi).round();
        let angle = (self - turns * QUARTER) * 0.125;
        let square = angle * angle;
        let (mut sine, mut versed) = (Self::ZERO, Self::ZERO);
        for [even, odd] in FACTORIALS.iter().rev() {
            sine = *odd - square * sine;
            versed = *even - square * versed;
        }
        // 1 - cos and sin, doubled three times.
        let (mut sine, mut versed) = (angle - angle * square * sine, square * versed);
        for _ in 0..3 {
            (sine, versed) = (2.0 * sine * (1.0 - versed), 2.0 * sine * sine);
        }
        let cosine = 1.0 - versed;
        match (turns as i64).rem_euclid(4) {
            0 => (sine, cosine),
            1 => (cosine, -sine),
            2 => (-sine, -cosine),
            _ => (-cosine, sine),
        }
    }
}

/// 1/(2n)! and 1/(2n + 1)! from n = 1 on.
static FACTORIALS: LazyLock<[[Dd; 2]; 12]> = LazyLock::new(|| {
    let mut factorial = Dd::from(1.0);
    core::array::from_fn(|n| {
        [2 * n + 2, 2 * n + 3].map(|m| {
            factorial = factorial * m as f64;
            1.0 / factorial
        })
    })
});

const QUARTER: Dd = Dd {
    hi: core::f64::consts::FRAC_PI_2,
    lo: 6.123_233_995_736_766e-17,
};

/// π.
pub const PI: Dd = Dd {
    hi: core::f64::consts::PI,
    lo: 1.224_646_799_147_353_2e-16,
};

pub type Vector = Vector3<Dd>;
pub type Matrix = Matrix3<Dd>;

/// M⁻¹, by Cramer's rule.
pub fn inverse(m: &Matrix) -> Matrix {
    let [p, q, r] = [0, 1, 2].map(|k| m.column(k).into_owned());
    let rows = [q.cross(&r), r.cross(&p), p.cross(&q)];
    Matrix::from_columns(&rows).transpose() / p.dot(&rows[0])
}

/// Where a function whose differences are linear is nil.
pub fn root(f: impl Fn(Vector) -> Vector) -> Vector {
    let rest = f(Vector::zeros());
    let columns = [Vector::x(), Vector::y(), Vector::z()].map(|unit| f(unit) - rest);
    -(inverse(&Matrix::from_columns(&columns)) * rest)
}

/// The rotation of a quaternion of any length: its rows are the axes of space seen from the body.
pub fn rotation([w, x, y, z]: [Dd; 4]) -> Matrix {
    let v = Vector::new(x, y, z);
    let [ww, vv] = [w * w, v.dot(&v)];
    let zero = Dd::ZERO;
    let across = Matrix::new(zero, -z, y, z, zero, -x, -y, x, zero);
    let turned = v * v.transpose() + across * w;
    (turned * Dd::from(2.0) + Matrix::from_diagonal_element(ww - vv)) / (ww + vv)
}
