//! How far a motion is from the separatrix, to all digits whatever cancels (tutorial 6.3, 6.6).

use super::start::Start;
use crate::error::{Error, Result, positive};
use crate::precise::{DoubleDouble, Extended, Number};

/// 1/I_i − 1/I_j all multiplied by I₁I₂I₃, from exact differences: c₁ = I₁(I₃ − I₂), c₂ = I₂(I₃ − I₁), c₃ = I₃(I₂ − I₁),
/// for ascending moments.
pub(super) fn differences<N: Number>(i: [f64; 3]) -> [N; 3] {
    [
        N::difference(i[2], i[1]).times(i[0]),
        N::difference(i[2], i[0]).times(i[1]),
        N::difference(i[1], i[0]).times(i[2]),
    ]
}

/// (L² − 2EI₂) I₁I₃ = c₁ L₃² − c₃ L₁²: its sign decides about which axis L goes, its size how close the separatrix is.
pub(super) fn separation<N: Number>(i: [f64; 3], order: [usize; 3], start: Start) -> N {
    let x = order.map(|k| start.components()[k]);
    let l: [N; 3] = start.with(x).angular_momentum(i);
    let c = differences::<N>(i);
    let third = c[0] * l[2].square();
    let first = c[2] * l[0].square();
    let difference = third - first;
    let scale = third.times(1.0 / 1024.0);
    if difference.magnitude().exceeds(scale) {
        return difference;
    }
    // More than ten of the 106 bits have cancelled; from the exact products none is lost.
    N::from_extended(match start {
        Start::AngularMomentum(_) => {
            exact_difference([i[0], i[2], i[1], x[2]], [i[2], i[1], i[0], x[0]])
        }
        Start::Omega(_) => exact_difference([i[2], i[2], i[1], x[2]], [i[0], i[1], i[0], x[0]])
            .times(i[0])
            .times(i[2]),
    })
}

/// The same rounded to a double.
pub(super) fn rounded_separation(i: [f64; 3], order: [usize; 3], start: Start) -> f64 {
    separation::<DoubleDouble>(i, order, start).value()
}

/// a (b − c) d² for the first four less the same for the second four, to 106 bits whatever cancels.
fn exact_difference(minuend: [f64; 4], subtrahend: [f64; 4]) -> Extended {
    let (third, exponent) = expansion(minuend);
    let (first, other) = expansion(subtrahend);
    let shift = Extended::power_of_two(other - exponent);
    let mut terms = [0.0; 32];
    for k in 0..16 {
        terms[k] = third[k];
        terms[k + 16] = -first[k] * shift;
    }
    // Error-free sums leave ever smaller remainders in front: after four rounds nothing of the first 200 bits is missing.
    for _ in 0..4 {
        for k in 1..32 {
            let sum = DoubleDouble::sum(terms[k], terms[k - 1]);
            terms[k] = sum.high();
            terms[k - 1] = sum.low();
        }
    }
    let total = terms.iter().fold(DoubleDouble::from(0.0), |sum, term| {
        sum + DoubleDouble::from(*term)
    });
    let mut result = Extended::from(total);
    if !result.is_zero() {
        result.exponent += exponent;
    }
    result
}

/// a (b − c) d² as sixteen doubles and a power of two, exactly.
fn expansion([a, b, c, d]: [f64; 4]) -> ([f64; 16], i32) {
    let (a, d) = (Extended::from_double(a), Extended::from_double(d));
    let difference = Extended::difference(b, c);
    let square = DoubleDouble::product(d.digits.high(), d.digits.high());
    let mut terms = [0.0; 16];
    let mut place = 0;
    for part in [difference.digits.high(), difference.digits.low()] {
        let product = DoubleDouble::product(a.digits.high(), part);
        for x in [product.high(), product.low()] {
            for y in [square.high(), square.low()] {
                let exact = DoubleDouble::product(x, y);
                terms[place] = exact.high();
                terms[place + 1] = exact.low();
                place += 2;
            }
        }
    }
    (terms, a.exponent + difference.exponent + 2 * d.exponent)
}

/// Slope |Ω₃/Ω₁| = √(I₁(I₂−I₁)/(I₃(I₃−I₂))) of the two planes L² = 2EI₂ that hold the separatrix (6.3), dimensionless.
///
/// For ascending positive moments. Infinite if I₂ = I₃ (the planes are one, and hold x₃), zero if I₁ = I₂, not a number for a sphere.
///
/// # Errors
/// [`Error::NotFinite`], [`Error::NotPositive`]; [`Error::Condition`] if the moments do not ascend.
///
/// ```
/// use spinning_bodies::euler_top::separatrix_slope;
/// assert!((separatrix_slope([1.0, 2.0, 3.0])? - 3f64.sqrt().recip()).abs() < 2e-16);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn separatrix_slope(moments: [f64; 3]) -> Result<f64> {
    for moment in moments {
        positive("a principal moment", moment)?;
    }
    let [i1, i2, i3] = moments;
    for (less, more) in [(i1, i2), (i2, i3)] {
        if less > more {
            return Err(Error::Condition {
                condition: "the moments must ascend",
                value: more,
            });
        }
    }
    Ok((i1 / i3).sqrt() * ((i2 - i1) / (i3 - i2)).sqrt())
}
