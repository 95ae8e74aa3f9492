//! What the files of 4.6 share.

use super::*;

pub const BALL: f64 = 2.0 / 5.0;
pub const KAPPA: R = R::new_raw(2, 5);

pub fn moving<T: Copy>(velocity: T, rim_speed: T) -> Motion<T> {
    Motion {
        velocity,
        rim_speed,
    }
}

pub fn thrown() -> UnderTable<R> {
    UnderTable::new(moving(ONE, ZERO), KAPPA)
}

pub fn times(a: [[R; 2]; 2], b: [[R; 2]; 2]) -> [[R; 2]; 2] {
    [0, 1].map(|i| [0, 1].map(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j]))
}

pub fn determinant(a: [[R; 2]; 2]) -> R {
    a[0][0] * a[1][1] - a[0][1] * a[1][0]
}

pub fn kappas() -> [R; 6] {
    [(2, 5), (2, 3), (1, 2), (1, 1), (1, 3), (0, 1)].map(|(n, d)| rational(n, d))
}
