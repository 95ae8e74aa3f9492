//! Numbers that nobody chose.

use crate::{R, rational, vector};
use proptest::prelude::*;
use spinning_bodies::frame::{Attitude, BodyVector};

/// Every bit pattern a double can have, moderate numbers, and the extremes more often than chance would have them.
pub fn any() -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => prop::num::u64::ANY.prop_map(f64::from_bits),
        3 => -10.0..10.0_f64,
        2 => (-1.0..1.0_f64, -1074..1024_i32).prop_map(|(x, e)| x * 2f64.powi(e / 2) * 2f64.powi(e - e / 2)),
        3 => prop::sample::select(vec![
            0.0, -0.0, 1.0, -1.0, 0.5, 2.0, 4.0, 1.0 + f64::EPSILON, 1.0 - f64::EPSILON, f64::MAX, f64::MIN,
            f64::MIN_POSITIVE, -f64::MIN_POSITIVE, 5e-324, -5e-324, 1e300, -1e300, 1e-300, 1e150, 1e-150, 1e18, 1e9,
            f64::INFINITY, f64::NEG_INFINITY, f64::NAN,
        ]),
    ]
}

/// Splitmix64: numbers uniform in 0..1, the same on every machine.
pub struct Uniform(pub u64);

impl Uniform {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    #[expect(
        clippy::should_implement_trait,
        reason = "it never ends, and gives a number"
    )]
    pub fn next(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn signed(&mut self) -> f64 {
        2.0 * self.next() - 1.0
    }

    pub fn vector(&mut self) -> BodyVector {
        vector([0; 3].map(|_| self.signed()))
    }

    pub fn attitude(&mut self) -> Attitude {
        let [w, x, y, z] = [0; 4].map(|_| self.signed());
        Attitude::from_quaternion(w, x, y, z).expect("four random numbers are not all zero")
    }

    pub fn point_masses(&mut self, count: usize) -> Vec<(f64, [f64; 3])> {
        (0..count)
            .map(|_| (0.1 + self.next(), [0; 3].map(|_| self.signed())))
            .collect()
    }
}

/// A number n/12 with n not zero.
pub fn ration(numbers: &mut Uniform) -> R {
    let n = 1 + (numbers.next() * 40.0) as i128;
    rational(if numbers.next() < 0.5 { -n } else { n }, 12)
}
