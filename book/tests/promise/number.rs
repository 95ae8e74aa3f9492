//! Sines, vectors and turns in double-doubles.

use std::sync::LazyLock;

use support::double_double::Dd;
pub use support::{cross, dot, turned};

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

pub type Vector = [Dd; 3];
pub type Matrix = [Vector; 3];

pub const NONE: Vector = [Dd::ZERO; 3];

pub fn plus(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn times(a: Vector, by: Dd) -> Vector {
    a.map(|x| x * by)
}

pub fn image(matrix: Matrix, v: Vector) -> Vector {
    matrix.map(|row| dot(row, v))
}

/// x with Mx = b, by Cramer's rule, from the columns of M.
pub fn solved([p, q, r]: Matrix, b: Vector) -> Vector {
    let whole = dot(p, cross(q, r));
    [
        dot(b, cross(q, r)) / whole,
        dot(p, cross(b, r)) / whole,
        dot(p, cross(q, b)) / whole,
    ]
}

/// Where a function whose differences are linear is nil.
pub fn root(f: impl Fn(Vector) -> Vector) -> Vector {
    let rest = f(NONE);
    let columns = diagonal([Dd::from(1.0); 3]).map(|unit| minus(f(unit), rest));
    solved(columns, rest.map(|x| -x))
}

/// The rotation of a quaternion of any length: its rows are the axes of space seen from the body.
pub fn rotation([w, x, y, z]: [Dd; 4]) -> Matrix {
    let (ww, xx, yy, zz) = (w * w, x * x, y * y, z * z);
    let rows = [
        [
            ww + xx - yy - zz,
            2.0 * (x * y - w * z),
            2.0 * (x * z + w * y),
        ],
        [
            2.0 * (x * y + w * z),
            ww + yy - xx - zz,
            2.0 * (y * z - w * x),
        ],
        [
            2.0 * (x * z - w * y),
            2.0 * (y * z + w * x),
            ww + zz - xx - yy,
        ],
    ];
    let part = 1.0 / (ww + xx + yy + zz);
    rows.map(|row| times(row, part))
}

pub fn diagonal(values: Vector) -> Matrix {
    core::array::from_fn(|i| core::array::from_fn(|j| if i == j { values[i] } else { Dd::ZERO }))
}

/// M⁻¹ of a symmetric matrix.
pub fn inverse(m: Matrix) -> Matrix {
    diagonal([Dd::from(1.0); 3]).map(|unit| solved(m, unit))
}

/// Rows as columns.
pub fn transposed(m: Matrix) -> Matrix {
    core::array::from_fn(|i| core::array::from_fn(|j| m[j][i]))
}
