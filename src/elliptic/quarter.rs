//! The quarter period to 150 bits, for arguments that lie unluckily close to a multiple of it.
//!
//! Some doubles of size 10¹⁵ lie within 10⁻¹⁷ of their size and less of a multiple of K. What remains after the
//! multiple is taken off needs more than the 104 bits of the prepared K. Such arguments are rare; for them K is
//! computed again with three words, by the plain arithmetic-geometric mean.

use core::ops::{Add, Div, Mul};

use super::parameter::Parameter;
use crate::precise::DoubleDouble;

/// A sum of three doubles, each below the last place of the one before: about 150 bits.
#[derive(Debug, Clone, Copy)]
struct Triple([f64; 3]);

/// π/2.
const HALF_PI: Triple = Triple([
    core::f64::consts::FRAC_PI_2,
    6.123_233_995_736_766e-17,
    -1.497_384_904_859_169_8e-33,
]);

impl Triple {
    /// The sum of terms of any size: each pass carries what is lost one place down.
    fn sum<const N: usize>(mut terms: [f64; N]) -> Self {
        for _ in 0..4 {
            for i in (1..N).rev() {
                let pair = DoubleDouble::sum(terms[i - 1], terms[i]);
                terms[i - 1] = pair.high();
                terms[i] = pair.low();
            }
        }
        let last = DoubleDouble::sum(terms[1], terms[2] + terms[3]);
        Self([terms[0], last.high(), last.low()])
    }

    fn pair(value: DoubleDouble) -> Self {
        Self([value.high(), value.low(), 0.0])
    }

    fn leading(self) -> DoubleDouble {
        DoubleDouble::sum(self.0[0], self.0[1])
    }

    fn scaled(self, factor: f64) -> Self {
        Self(self.0.map(|x| x * factor))
    }

    /// One step of Newton from the root of 104 bits.
    fn square_root(self) -> Self {
        let root = self.leading().square_root();
        let near = Self::pair(root);
        let rest = (self + (near * near).scaled(-1.0)).leading();
        near + Self::pair(rest.scaled(0.5) / root)
    }
}

impl Add for Triple {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let ([a, b, c], [d, e, f]) = (self.0, other.0);
        Self::sum([a, d, b, e, c, f])
    }
}

impl Mul for Triple {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let ([a, b, c], [d, e, f]) = (self.0, other.0);
        let (ad, ae, bd) = (
            DoubleDouble::product(a, d),
            DoubleDouble::product(a, e),
            DoubleDouble::product(b, d),
        );
        let be = DoubleDouble::product(b, e);
        let small = a * f + c * d + (b * f + c * e);
        Self::sum([
            ad.high(),
            ad.low(),
            ae.high(),
            bd.high(),
            ae.low(),
            bd.low(),
            be.high(),
            small,
        ])
    }
}

impl Div for Triple {
    type Output = Self;

    fn div(self, divisor: Self) -> Self {
        let by = divisor.leading();
        let near = Self::pair(self.leading() / by);
        let rest = (self + (near * divisor).scaled(-1.0)).leading();
        near + Self::pair(rest / by)
    }
}

/// K in three words, for mc > 0.
fn quarter_period(parameter: Parameter) -> Triple {
    let (m, mc) = (parameter.m_dd(), parameter.mc_dd());
    // The greater of m and mc is formed again from the lesser, whose 106 bits are the truth.
    let (mc, power) = if m.value() <= mc.value() {
        let mc = Triple::sum([1.0, -m.high(), -m.low(), 0.0]);
        (mc, 1.0)
    } else {
        // √mc from a number near 1, so that no word underflows.
        let exponent = (mc.high().log2() * 0.5).floor() as i32;
        let step = 0.5_f64.powi(exponent);
        (
            Triple::pair(mc.scaled(step).scaled(step)),
            2.0_f64.powi(exponent),
        )
    };
    let mut a = Triple([1.0, 0.0, 0.0]);
    let mut b = mc.square_root().scaled(power);
    // Twelve rounds for the least mc there is. The gap left is squared once more by the last mean.
    for _ in 0..16 {
        let next = (a + b).scaled(0.5);
        let gap = (a + b.scaled(-1.0)).0[0];
        if gap < 1e-25 * a.0[0] {
            a = next;
            break;
        }
        b = (a * b).square_root();
        a = next;
    }
    HALF_PI / a
}

/// `u − count K`, where the prepared K leaves too few bits.
pub(super) fn remainder(parameter: Parameter, u: DoubleDouble, count: f64) -> DoubleDouble {
    let Triple([first, second, third]) = quarter_period(parameter);
    let rest = u - DoubleDouble::product(count, first);
    rest - DoubleDouble::product(count, second) - DoubleDouble::from(count * third)
}
