//! The angle of a point in two words.

use super::double_double::{DoubleDouble, RIGHT_ANGLE};
use super::logarithm::{FIFTH, THIRD};
use super::number::Number;

/// arctan(j/16) for j = 0…16, in two words each.
#[rustfmt::skip]
const ARCTANGENTS: [f64; 34] = [
    0.0,                  0.0,                    0.06241880999595735, -1.5490756308295046e-18,
    0.12435499454676144, -3.1253241424539383e-18, 0.18534794999569476,  4.180692268843079e-18,
    0.24497866312686414,  1.0698755618734451e-17, 0.3028848683749714,  -1.1010827903001369e-17,
    0.35877067027057225, -2.4623815582638635e-17, 0.4124104415973873,  -1.587652227770689e-17,
    0.4636476090008061,   2.2698777452961687e-17, 0.5123894603107377,  -2.5462781472855804e-17,
    0.5585993153435624,  -5.4556305485916264e-18, 0.6022873461349642,   2.950430737228402e-17,
    0.6435011087932844,   1.5834785051444286e-17, 0.6823165548747481,   6.943223671560008e-18,
    0.7188299996216245,  -2.1478388444456983e-17, 0.7531512809621944,  -2.4256934659182068e-17,
    core::f64::consts::FRAC_PI_4, 3.061616997868383e-17,
];

/// The angle of the point (cosine, sine), both not negative and not both zero, with an absolute error of about 2⁻⁹⁰.
pub(crate) fn angle(cosine: DoubleDouble, sine: DoubleDouble) -> DoubleDouble {
    let steep = sine.high() > cosine.high();
    let (along, across) = if steep {
        (sine, cosine)
    } else {
        (cosine, sine)
    };
    // The tangent in sixteenths, rounded.
    let index = ((across.high() / along.high() * 16.0 + 0.5) as usize).min(16);
    let (high, low) = (ARCTANGENTS[2 * index], ARCTANGENTS[2 * index + 1]);
    let slope = index as f64 / 16.0;
    let r = (across - along.times(slope)).quick_quotient(along.add_alike(across.times(slope)));
    let square = r * r;
    let y = square.value();
    // From the fourth term on one word suffices. A rate multiplies this angle by the number of quarter periods.
    let tail = 1.0 / 11.0 - y * (1.0 / 13.0 - y * (1.0 / 15.0 - y / 17.0));
    let tail = DoubleDouble::from(y * (1.0 / 7.0 - y * (1.0 / 9.0 - y * tail)));
    let series = DoubleDouble::from(1.0) - square * (THIRD - square * (FIFTH - tail));
    let small = r * series + DoubleDouble::sum(high, low);
    if steep { RIGHT_ANGLE - small } else { small }
}

#[cfg(test)]
mod tests {
    use super::angle;
    use crate::precise::{DoubleDouble, Number};

    #[test]
    fn angles_add_as_rotations_do() {
        for i in 0..200 {
            let t = f64::from(i) * 0.01 / 2.0;
            let (c, s) = (DoubleDouble::from(t.cos()), DoubleDouble::from(t.sin()));
            let c2 = c * c - s * s;
            let s2 = (c * s).scaled(2.0);
            if c2.value() < 0.0 {
                continue;
            }
            let rest = angle(c2, s2) - angle(c, s).scaled(2.0);
            assert!(rest.value().abs() < 5e-27, "{t}: {rest:?}");
            assert!((angle(c, s).value() - t).abs() < 2e-16);
        }
    }
}
