//! Sines, vectors and turns in double-doubles.

use std::sync::LazyLock;

use support::double_double::Dd;
pub use support::{cross, dot};

/// Sine and cosine.
pub trait Angle: Sized {
    fn sine_cosine(self) -> (Self, Self);
}

impl Angle for Dd {
    /// By the series for an eighth of what is left of the angle beside the nearest quarter turn.
    fn sine_cosine(self) -> (Self, Self) {
        let turns = (self.hi / QUARTER.hi).round();
        let angle = (self - Self::from(turns) * QUARTER) * Self::from(0.125);
        let square = angle * angle;
        let (mut sine, mut versed) = (Self::ZERO, Self::ZERO);
        for [even, odd] in FACTORIALS.iter().rev() {
            sine = *odd - square * sine;
            versed = *even - square * versed;
        }
        // 1 - cos and sin, doubled three times.
        let (mut sine, mut versed) = (angle - angle * square * sine, square * versed);
        for _ in 0..3 {
            let two = Self::from(2.0);
            (sine, versed) = (two * sine * (Self::from(1.0) - versed), two * sine * sine);
        }
        let cosine = Self::from(1.0) - versed;
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
            factorial = factorial * Dd::from(m as f64);
            Dd::from(1.0) / factorial
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

pub fn plus(a: [Dd; 3], b: [Dd; 3]) -> [Dd; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn times(a: [Dd; 3], by: Dd) -> [Dd; 3] {
    a.map(|x| x * by)
}

pub fn image(matrix: [[Dd; 3]; 3], v: [Dd; 3]) -> [Dd; 3] {
    matrix.map(|row| dot(row, v))
}

/// x with Mx = b, by Cramer's rule.
pub fn solved(matrix: [[Dd; 3]; 3], b: [Dd; 3]) -> [Dd; 3] {
    let columns: [[Dd; 3]; 3] = core::array::from_fn(|j| core::array::from_fn(|i| matrix[i][j]));
    let [p, q, r] = columns;
    let whole = dot(p, cross(q, r));
    [
        dot(b, cross(q, r)) / whole,
        dot(p, cross(b, r)) / whole,
        dot(p, cross(q, b)) / whole,
    ]
}

/// The rate of a quaternion (w, x, y, z) that turns body axes into those of space: half of q∘Ω, Ω along body axes.
pub fn turned([w, x, y, z]: [Dd; 4], [a, b, c]: [Dd; 3]) -> [Dd; 4] {
    let half = Dd::from(0.5);
    [
        -half * (x * a + y * b + z * c),
        half * (w * a + y * c - z * b),
        half * (w * b + z * a - x * c),
        half * (w * c + x * b - y * a),
    ]
}

/// The rotation of a quaternion of any length: its rows are the axes of space seen from the body.
pub fn rotation(q: [Dd; 4]) -> [[Dd; 3]; 3] {
    let [w, x, y, z] = q;
    let two = Dd::from(2.0);
    let square = w * w + x * x + y * y + z * z;
    let rows = [
        [
            w * w + x * x - y * y - z * z,
            two * (x * y - w * z),
            two * (x * z + w * y),
        ],
        [
            two * (x * y + w * z),
            w * w + y * y - x * x - z * z,
            two * (y * z - w * x),
        ],
        [
            two * (x * z - w * y),
            two * (y * z + w * x),
            w * w + z * z - x * x - y * y,
        ],
    ];
    let part = Dd::from(1.0) / square;
    rows.map(|row| row.map(|x| x * part))
}

/// M⁻¹ of a symmetric matrix.
pub fn inverse(m: [[Dd; 3]; 3]) -> [[Dd; 3]; 3] {
    core::array::from_fn(|k| {
        solved(
            m,
            core::array::from_fn(|j| Dd::from(if j == k { 1.0 } else { 0.0 })),
        )
    })
}

/// Rows as columns.
pub fn transposed(m: [[Dd; 3]; 3]) -> [[Dd; 3]; 3] {
    core::array::from_fn(|i| core::array::from_fn(|j| m[j][i]))
}
