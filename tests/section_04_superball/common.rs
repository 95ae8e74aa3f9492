//! What the files of 4.6 share.

use num_rational::Ratio;
use spinning_bodies::superball::{Motion, UnderTable};

pub type Q = Ratio<i128>;

pub const BALL: f64 = 2.0 / 5.0;

pub fn q(numerator: i128, denominator: i128) -> Q {
    Q::new(numerator, denominator)
}

pub fn exact(velocity: Q, rim_speed: Q) -> Motion<Q> {
    Motion {
        velocity,
        rim_speed,
    }
}

pub fn thrown() -> UnderTable<Q> {
    UnderTable::new(exact(q(1, 1), q(0, 1)), q(2, 5))
}

pub fn times(a: [[Q; 2]; 2], b: [[Q; 2]; 2]) -> [[Q; 2]; 2] {
    [0, 1].map(|i| [0, 1].map(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j]))
}

pub fn determinant(a: [[Q; 2]; 2]) -> Q {
    a[0][0] * a[1][1] - a[0][1] * a[1][0]
}

pub fn kappas() -> [Q; 6] {
    [q(2, 5), q(2, 3), q(1, 2), q(1, 1), q(1, 3), q(0, 1)]
}
