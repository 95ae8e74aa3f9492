//! The prepared modulus: quarter period to 101 bits and more, nome, and what takes quarter periods off an argument.

use super::landen::Landen;
use super::parameter::Parameter;
use super::series::{SMALL, Series};
use crate::precise::{
    DoubleDouble, Number, RIGHT_ANGLE, Words, logarithm, power_of_two_below, quick,
};

/// The greatest number of quarter periods that a double counts.
pub(super) const COUNTABLE: f64 = 9_007_199_254_740_992.0;

/// π to 106 bits.
pub(super) const PI: DoubleDouble =
    DoubleDouble::new(core::f64::consts::PI, 1.224_646_799_147_353_2e-16);

/// On which side of m = 1/2 the parameter lies, and so which nome is the small one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    /// m ≤ mc: sine and cosine with small corrections.
    Circular,
    /// m > mc: hyperbolic functions with small corrections.
    Hyperbolic,
}

/// Everything about a modulus that does not depend on the argument: K to 101 bits, the nome, and the coefficients of
/// the theta functions in powers of sin² or sinh².
///
/// Below m = 1/2 the functions are sine and cosine with corrections in the nome of m, above it hyperbolic functions
/// with corrections in the nome of mc; either nome is at most e^{−π}, so that three or four terms are the whole.
///
/// Cost on one core of a server, beside GSL's `gsl_sf_elljac_e` in the same run (`cargo bench -p lab --bench
/// elliptic`): `new` 80–280 ns; then 27–37 ns for sn, cn, dn of one argument (0.27–0.33 of GSL's time), 37–66 ns with the
/// amplitude, 8–18 ns in a batch (0.10–0.14). From scratch, [`sn_cn_dn`](super::sn_cn_dn), 107–250 ns (1.5–1.9). For tiny
/// m GSL has little to do, 53 ns; there the four are 0.51, 0.70, 0.16 and 2.0 of it.
///
/// Source: Digital Library of Mathematical Functions, 20.2, 22.2 and 19.8; the range reduction is our own.
///
/// ```
/// use spinning_bodies::elliptic::{Modulus, Parameter};
/// // Next to the separatrix: mc = 10⁻³⁰⁰, K = ln(4/√mc).
/// let modulus = Modulus::new(Parameter::from_complement(1e-300)?);
/// assert!((modulus.quarter_period() - (4f64.ln() + 150.0 * 10f64.ln())).abs() < 1e-13);
/// let far = modulus.jacobi(1e6 * modulus.quarter_period())?;
/// assert_eq!(far.cn, 1.0);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Modulus {
    pub(super) parameter: Parameter,
    pub(super) side: Side,
    /// K.
    pub(super) quarter: DoubleDouble,
    /// What the arguments of the theta functions are multiplied with: π/(2K), or π/(2K′) on the hyperbolic side.
    pub(super) rate: DoubleDouble,
    pub(super) reduction: Reduction,
    pub(super) series: Series,
}

/// What takes the quarter periods off an argument when there are at most 2²⁵ of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Reduction {
    /// 1/K.
    pub(super) inverse: f64,
    /// K in three words, of which the first two are so short that a count times either is exact.
    pub(super) parts: [f64; 3],
    /// The greatest argument.
    pub(super) limit: f64,
}

/// 2²⁵: with 27 bits of K the product still fits 53.
pub(crate) const EXACT_COUNT: f64 = 33_554_432.0;

impl Modulus {
    /// The modulus prepared for many arguments. Any parameter will do, the ends m = 0 and m = 1 included.
    pub fn new(parameter: Parameter) -> Self {
        Self::prepared(parameter)
    }

    #[inline(always)]
    pub(super) fn prepared(parameter: Parameter) -> Self {
        let (m, mc) = (parameter.m_dd(), parameter.mc_dd());
        let complementary_modulus = mc.value().sqrt();
        if m.value() <= mc.value() {
            let mean = Mean::new(mc, m);
            let q = Nome::new(m.value(), mean.product.value()).value();
            let quarter = DoubleDouble::quick_quotient(RIGHT_ANGLE, mean.value);
            let series = Series::circular(q, complementary_modulus);
            Self::assemble(parameter, Side::Circular, quarter, mean.value, series)
        } else {
            let mean = Mean::new(m, mc);
            let nome = Nome::new(mc.value(), mean.product.value());
            let quarter = if mc.value() == 0.0 {
                DoubleDouble::from(f64::INFINITY)
            } else {
                let logarithm = nome.logarithm(mc, mean.product);
                DoubleDouble::quick_quotient(logarithm.scaled(0.5), mean.value)
            };
            let series = Series::hyperbolic(
                nome.value().sqrt(),
                complementary_modulus,
                mean.value.value(),
            );
            Self::assemble(parameter, Side::Hyperbolic, quarter, mean.value, series)
        }
    }

    /// The modulus from a transformation of the lesser of m and mc; both are wanted, and √mc.
    pub(crate) fn from_landen<N: Number>(
        side: Side,
        parameter: Parameter,
        complementary_modulus: f64,
        landen: &Landen<N>,
    ) -> Self {
        let mean = landen.mean.two();
        let (quarter, series) = match side {
            Side::Circular => (
                landen.quarter(),
                Series::circular(landen.nome.value(), complementary_modulus),
            ),
            Side::Hyperbolic => {
                let half = landen.root_of_nome(complementary_modulus);
                (
                    landen.complementary_quarter(),
                    Series::hyperbolic(half, complementary_modulus, mean.value()),
                )
            }
        };
        Self::assemble(parameter, side, quarter, mean, series)
    }

    pub(crate) fn side(&self) -> Side {
        self.side
    }

    /// π/(2K), or π/(2K′) beyond m = 1/2.
    pub(crate) fn pace(&self) -> f64 {
        self.rate.high()
    }

    /// The greatest argument that still has a place: 2⁵³ quarter periods.
    pub(crate) fn greatest_argument(&self) -> f64 {
        COUNTABLE * self.quarter.high()
    }

    #[inline(always)]
    fn assemble(
        parameter: Parameter,
        side: Side,
        quarter: DoubleDouble,
        rate: DoubleDouble,
        series: Series,
    ) -> Self {
        let reduction = if quarter.high() == f64::INFINITY {
            Reduction {
                inverse: 0.0,
                parts: [0.0; 3],
                limit: f64::MAX,
            }
        } else {
            let (first, second) = quick::halves(quarter.high());
            Reduction {
                inverse: 1.0 / quarter.high(),
                parts: [first, second, quarter.low()],
                limit: EXACT_COUNT * quarter.high(),
            }
        };
        Self {
            parameter,
            side,
            quarter,
            rate,
            reduction,
            series,
        }
    }

    /// The parameter this was prepared for.
    pub fn parameter(&self) -> Parameter {
        self.parameter
    }

    /// The quarter period K = ∫₀^{π/2} dθ/√(1 − m sin²θ), rounded once from more than 100 bits; π/2 at m = 0,
    /// infinite at mc = 0.
    pub fn quarter_period(&self) -> f64 {
        self.quarter.high()
    }

    /// K to 101 bits and more.
    #[allow(dead_code, reason = "for phases inside the library")]
    pub(crate) fn quarter_period_dd(&self) -> DoubleDouble {
        self.quarter
    }
}

/// The arithmetic-geometric mean of 1 and √x for x in 1/2…1.
struct Mean {
    value: DoubleDouble,
    /// First mean times second mean, from which the nome follows.
    product: DoubleDouble,
}

impl Mean {
    /// Two rounds, and the third from its series. Pairs (number, error) are carried without being made canonical:
    /// that shortens the chain of operations, each of which waits for the one before.
    fn new(x: DoubleDouble, complement: DoubleDouble) -> Self {
        if complement.high() < SMALL {
            return Self::next_to_one(complement);
        }
        let (b0, b0_low) = quick::root(x.high(), x.low());
        let (sum, rest) = quick::ordered_sum(1.0, b0);
        let (a1, a1_low) = (0.5 * sum, 0.5 * (rest + b0_low));
        let (b1, b1_low) = quick::root(b0, b0_low);
        let (sum, rest) = quick::ordered_sum(a1, b1);
        let (a2, a2_low) = (0.5 * sum, 0.5 * (rest + (a1_low + b1_low)));
        let (square, rest) = quick::exact_product(a1, b1);
        let (b2, b2_low) = quick::root(square, rest + (a1 * b1_low + a1_low * b1));
        // With S = a2 + b2 and d = (a2 − b2)/S ≤ 1.4e-5:
        // agm(a2, b2) = S/2 (1 − d²/4 − 5 d⁴/64 − 11 d⁶/256 − …), where the first term needs both words.
        let (sum, rest) = quick::ordered_sum(a2, b2);
        let sum_low = rest + (a2_low + b2_low);
        let gap = DoubleDouble::sum(a2 - b2, a2_low - b2_low);
        let (gap2, error) = quick::exact_product(gap.high(), gap.high());
        let gap2_low = error + 2.0 * gap.high() * gap.low();
        let eight = 8.0 * sum;
        let inverse = 1.0 / eight;
        let less = gap2 * inverse;
        let (back, error) = quick::exact_product(less, eight);
        let less_low = (((gap2 - back) - error) + (gap2_low - 8.0 * less * sum_low)) * inverse;
        let d2 = 8.0 * less * (8.0 * inverse);
        let tail = 0.5 * sum * d2 * d2 * (5.0 / 64.0 + d2 * (11.0 / 256.0));
        let (high, low) = quick::ordered_sum(0.5 * sum, -less);
        let low = low + (0.5 * sum_low - less_low - tail);
        let (high, low) = quick::ordered_sum(high, low);
        let product = DoubleDouble::quick_product(
            DoubleDouble::new(a1, a1_low),
            DoubleDouble::new(a2, a2_low),
        );
        Self {
            value: DoubleDouble::new(high, low),
            product,
        }
    }
}

impl Mean {
    /// The mean and the product as series in 1 − x.
    fn next_to_one(c: DoubleDouble) -> Self {
        let x = c.high();
        let square = x * x;
        let series = |first: DoubleDouble, rest: f64| {
            let (high, low) = quick::ordered_sum(1.0, -first.high());
            DoubleDouble::new(high, low - (first.low() + rest))
        };
        Self {
            value: series(c.scaled(0.25), square * (5.0 / 64.0 + x * (11.0 / 256.0))),
            product: series(c.scaled(0.5), square * (5.0 / 64.0 + x * (5.0 / 128.0))),
        }
    }
}

/// The nome q, from l = (1 − √k′)/(2 (1 + √k′)) = m/(16 a1 a2) with the means of [`Mean`].
///
/// q = l + 2 l⁵ + 15 l⁹ + 150 l¹³ + 1707 l¹⁷ + …
struct Nome {
    l: f64,
    l4: f64,
}

impl Nome {
    /// From the lesser of m and mc, and the product of the first two means of the other.
    fn new(lesser: f64, product: f64) -> Self {
        let l = lesser / (16.0 * product);
        Self {
            l,
            l4: (l * l) * (l * l),
        }
    }

    fn value(&self) -> f64 {
        let y = self.l4;
        self.l * (1.0 + y * (2.0 + y * (15.0 + y * (150.0 + y * 1707.0))))
    }

    /// ln(1/q) to 101 bits and more, for q > 0.
    fn logarithm(&self, lesser: DoubleDouble, product: DoubleDouble) -> DoubleDouble {
        // ln(q/l) = 2 y + 13 y² + (368/3) y³ + …, y = l⁴ ≤ 3.6e-6.
        // The quotient is formed with a power of two taken off: mc may be as small as a double can be.
        let unit = power_of_two_below(lesser.high());
        let exponent = 1023 - (unit.to_bits() >> 52) as i32;
        let ratio = DoubleDouble::quick_quotient(product.scaled(16.0), lesser.scaled(1.0 / unit));
        let logarithm = logarithm(ratio, exponent);
        if self.l4 < 1e-34 {
            return logarithm;
        }
        // l in two words by one step of Newton, its fourth power, and 2 y + 13 y² with both words.
        let l = self.l;
        let (back, error) = quick::exact_product(l, ratio.high() / unit);
        let off = ((1.0 - back) - error) - l * (ratio.low() / unit);
        let (l2, l2_low) = quick::exact_product(l, l);
        let (y, error) = quick::exact_product(l2, l2);
        let (y, y_low) = quick::ordered_sum(y, error + 2.0 * l2 * l2_low + 4.0 * off * y);
        let (y2, error) = quick::exact_product(y, y);
        let y2_low = error + 2.0 * y * y_low;
        let (square, error) = quick::exact_product(13.0, y2);
        let rest =
            y * (368.0 / 3.0 + y * (2701.0 / 2.0 + y * (80912.0 / 5.0 + y * (613_720.0 / 3.0))));
        let low = 2.0 * y_low + (error + 13.0 * y2_low + rest * y2);
        let (high, carry) = quick::ordered_sum(2.0 * y, square);
        let correction = DoubleDouble::new(high, carry + low);
        logarithm - correction
    }
}

#[cfg(test)]
mod tests {
    use super::{DoubleDouble, Modulus, Parameter};
    use crate::elliptic::quarter;

    const COMPLEMENTS: [f64; 9] = [1.0, 0.9, 0.51, 0.5, 0.49, 0.3, 1e-3, 1e-9, 1e-300];

    #[test]
    fn quarter_period_agrees_with_the_plain_mean() -> crate::Result<()> {
        for mc in COMPLEMENTS {
            let modulus = Modulus::new(Parameter::from_complement(mc)?);
            let k = modulus.quarter_period_dd();
            let rest = quarter::remainder(modulus.parameter, k, 1.0);
            // Observed: 2⁻¹⁰¹·³ of K at mc = 0.49, where the series of the logarithm is longest.
            let allowed = k.value() * 2f64.powi(-101);
            assert!(rest.value().abs() <= allowed, "mc = {mc}: {rest:?}");
        }
        Ok(())
    }

    #[test]
    fn an_argument_of_two_words_keeps_its_phase_over_many_periods() -> crate::Result<()> {
        // 2¹⁰ quarter periods and a little, of which a double would keep 43 bits, and 2⁴⁶, of which it would keep 7.
        for mc in COMPLEMENTS {
            let modulus = Modulus::new(Parameter::from_complement(mc)?);
            let near = modulus.jacobi(0.3)?;
            for count in [2f64.powi(10), 2f64.powi(46)] {
                let turns = modulus.quarter_period_dd().scaled(count);
                let far = modulus.jacobi_dd(turns + DoubleDouble::from(0.3));
                // K times 2⁴⁶ is off by 2⁻⁵⁵ of K, which for mc = 10⁻³⁰⁰ is 350.
                let allowed = 4e-16 + modulus.quarter_period() * 2f64.powi(-54);
                for (a, b) in [(far.sn, near.sn), (far.cn, near.cn), (far.dn, near.dn)] {
                    assert!((a - b).abs() <= allowed, "mc = {mc}: {a}, {b}");
                }
            }
        }
        Ok(())
    }
}
