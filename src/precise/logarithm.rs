//! The natural logarithm to 103 bits, for the quarter period next to the separatrix.

use super::double_double::{DoubleDouble, power_of_two_below};
use super::extended::{Extended, exponent_of};
use super::number::Number;
use super::quick;

const LN_2: DoubleDouble = DoubleDouble::new(core::f64::consts::LN_2, 2.319_046_813_846_299_6e-17);

pub(crate) const THIRD: DoubleDouble =
    DoubleDouble::new(0.333_333_333_333_333_3, 1.850_371_707_708_594e-17);

pub(crate) const FIFTH: DoubleDouble = DoubleDouble::new(0.2, -1.110_223_024_625_156_6e-17);

/// ln(j/32) for j = 32…64, in two words each.
#[rustfmt::skip]
const LOGARITHMS: [f64; 66] = [
    0.0,                  0.0,                    0.030771658666753687,  1.0431732029005968e-18,
    0.06062462181643484,  2.6424025938726934e-18, 0.08961215868968714,  -5.4268129336647135e-18,
    0.11778303565638346, -1.1971685747593677e-18, 0.1451820098444979,    8.242418783022475e-18,
    0.17185025692665923, -6.0224538210113705e-18, 0.19782574332991987,   1.2821194372980142e-17,
    0.22314355131420976, -9.091270597324799e-18,  0.24783616390458127,  -1.2432209578702523e-17,
    0.27193371548364176,  7.83319637697442e-19,   0.2954642128938359,   -2.16461086040599e-17,
    0.3184537311185346,   2.7114779367326236e-17, 0.3409265869705932,    1.7467136443544747e-17,
    0.3629054936893685,  -2.1492361455310972e-17, 0.38441169891033206,  -1.612149700764673e-17,
    0.4054651081081644,  -2.8811380259626426e-18, 0.4260843953109001,   -2.499176776547466e-17,
    0.44628710262841953, -1.8182541194649598e-17, 0.46608972992459924,  -1.4116523239904406e-17,
    0.4855078157817008,  -1.6618350693852048e-17, 0.5045560107523953,   -2.4888518873597905e-17,
    0.5232481437645479,  -3.1833882216350925e-17, 0.5415972824327444,   -3.748764246125639e-17,
    0.5596157879354227,   2.685492580212308e-17,  0.5773153650348236,   -8.903591846974013e-18,
    0.5947071077466928,   1.3751689964323675e-17, 0.6118015411059929,   -3.7397759448726e-17,
    0.6286086594223741,   4.3538742607970387e-17, 0.6451379613735847,    9.346960920120906e-19,
    0.661398482245365,   -7.603333785634003e-18,  0.6773988235918061,   -2.0978183882652005e-18,
    core::f64::consts::LN_2, 2.3190468138462996e-17,
];

/// ln(x · 2^exponent) for a positive x, to 103 bits of the result or of 1, whichever is greater.
pub(crate) fn logarithm(x: DoubleDouble, exponent: i32) -> DoubleDouble {
    let Extended { digits, exponent } = Extended::from(x).raised(exponent);
    logarithm_of_quotient(digits, DoubleDouble::from(1.0), exponent)
}

/// ln(n/d · 2^exponent) for n and d between 1 and 16, as exact; the quotient itself is not formed.
///
/// A power of two is split off, then the nearest c = j/32 times that; what remains is 2 artanh((n − cd)/(n + cd)), with an argument of at most 1/128.
pub(crate) fn logarithm_of_quotient(
    n: DoubleDouble,
    d: DoubleDouble,
    exponent: i32,
) -> DoubleDouble {
    let quotient = n.high() / d.high();
    let unit = power_of_two_below(quotient);
    let exponent = f64::from(exponent_of(unit) + exponent);
    let digits = quotient.to_bits() & ((1 << 52) - 1);
    let index = (f64::from_bits(digits | 1.0_f64.to_bits()) * 32.0 + 0.5) as usize;
    let (center, place) = (index as f64 / 32.0 * unit, 2 * (index.clamp(32, 64) - 32));
    let entry = DoubleDouble::new(LOGARITHMS[place], LOGARITHMS[place + 1]);
    let (near, error) = quick::exact_product(center, d.high());
    let near_low = error + center * d.low();
    let sum = DoubleDouble::sum(n.high(), near);
    // The difference of numbers so close is exact.
    let gap = DoubleDouble::sum(n.high() - near, n.low() - near_low);
    let low = sum.low() + (n.low() + near_low);
    let s = gap.quick_quotient(DoubleDouble::new(sum.high(), low));
    let s2 = s.quick_product(s);
    let y = s2.high();
    // From the fourth term on one word suffices, and so it does for the remainder of 1/5 after its leading word.
    let tail = y * (1.0 / 7.0 + y * (1.0 / 9.0 + y * (1.0 / 11.0 + y / 13.0)));
    let fifth = s2.quick_product(FIFTH.add_lesser(DoubleDouble::from(tail)));
    let more = s.quick_product(s2).quick_product(THIRD.add_lesser(fifth));
    let (power, error) = quick::exact_product(exponent, LN_2.high());
    // Summed in the order in which the terms become known; the sum of the first two is either zero or not small against the third.
    let first = DoubleDouble::sum(power, entry.high());
    let second = DoubleDouble::sum(first.high(), 2.0 * s.high());
    let all = DoubleDouble::sum(second.high(), 2.0 * more.high());
    let known = error + exponent * LN_2.low() + entry.low() + (first.low() + second.low());
    let low = (known + 2.0 * s.low()) + (all.low() + 2.0 * more.low());
    DoubleDouble::ordered_sum(all.high(), low)
}

#[cfg(test)]
mod tests {
    use super::logarithm;
    use crate::precise::DoubleDouble;
    use core::f64::consts::LN_2;

    #[test]
    fn logarithm_of_a_cube_is_three_logarithms() {
        // Independent of the table: the three factors are reduced to different entries.
        let mut x = 1.000_37_f64;
        while x < 1e100 {
            let one = DoubleDouble::from(x);
            let cube = one * one * one;
            let (ln, of_cube) = (logarithm(one, 0), logarithm(cube, 0));
            let rest = of_cube - ln * DoubleDouble::from(3.0);
            let allowed = 2f64.powi(-101) * of_cube.value().max(1.0);
            assert!(rest.value().abs() < allowed, "{x}: {rest:?}");
            assert!((ln.value() - x.ln()).abs() <= f64::EPSILON * ln.value());
            let scaled = logarithm(one, -3000).value();
            assert!((scaled - (x.ln() - 3000.0 * LN_2)).abs() < 1e-12);
            x *= 1.093;
        }
    }
}
