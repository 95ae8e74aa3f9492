//! The prepared modulus: quarter period to 101 bits and more, nome, and the constants that reduce an argument by quarter periods; and the
//! modulus as an exact top prepares it, from m and mc in all their digits.

use core::f64::consts::FRAC_2_PI;

use super::landen::{Landen, Mean, Nome, SMALL, quarter_next_to_zero};
use super::parameter::{Parameter, Side};
use super::theta::Series;
use crate::precise::quick;
use crate::precise::{DoubleDouble, Number, RIGHT_ANGLE};

/// Everything about a modulus that does not depend on the argument: K to 101 bits, the nome, and the coefficients of
/// the theta functions in powers of sin² or sinh².
///
/// Below m = 1/2 the functions are sine and cosine with corrections in the nome of m, above it hyperbolic functions
/// with corrections in the nome of mc; either nome is at most e^{−π}, so that three or four terms suffice.
///
/// Cost on one core of a server, beside GSL's `gsl_sf_elljac_e` in the same run (`cargo bench -p lab --bench
/// elliptic`): `new` 30–110 ns; then 16–28 ns for sn, cn, dn of one argument (0.30–0.36 of GSL's time), 24–46 ns with the
/// amplitude (0.43–0.59). From scratch, [`Parameter::new`] and [`sn_cn_dn`](super::sn_cn_dn), 80–160 ns: 1.3–1.8,
/// and 1.9–2.0 next to m = 1. For tiny m GSL takes only 34 ns; there the three ratios are 0.49, 0.71 and 1.5.
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
    pub(crate) parameter: Parameter,
    /// The factor from u to the argument of the theta functions: π/(2K), or π/(2K′) on the hyperbolic side.
    pub(super) rate: DoubleDouble,
    pub(super) reduction: Reduction,
    pub(super) series: Series,
}

/// The constants that subtract quarter periods from an argument, when there are at most 2²⁵ of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Reduction {
    /// 1/K, to an ulp or two.
    pub(super) inverse: f64,
    /// K in three words, of which the first two are so short that a count times either is exact; zero where K is infinite.
    pub(super) parts: [f64; 3],
}

impl Modulus {
    /// The modulus prepared for many arguments. Any parameter will do, the ends m = 0 and m = 1 included.
    ///
    /// ```
    /// use spinning_bodies::elliptic::{Modulus, Parameter};
    /// let modulus = Modulus::new(Parameter::from_parameter(1.0)?);
    /// assert!((modulus.sn_cn_dn(0.5)?.0 - 0.5_f64.tanh()).abs() < 1e-16);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(parameter: Parameter) -> Self {
        Self::prepared(parameter)
    }

    #[inline(always)]
    pub(super) fn prepared(parameter: Parameter) -> Self {
        let (m, mc) = (parameter.m_dd(), parameter.mc_dd());
        let complementary_modulus = mc.value().sqrt();
        if parameter.side == Side::Circular {
            let (quarter, rate, q) = if m.high() < SMALL {
                // q = m/16 (1 + m/2 + …).
                let q = m.high() * (1.0 / 16.0 + m.high() / 32.0);
                (quarter_next_to_zero(m), Mean::next_to_one(m).value, q)
            } else {
                let mean = Mean::new(mc, m);
                let quarter = DoubleDouble::quick_quotient(RIGHT_ANGLE, mean.value);
                let nome = Nome::new(m.value(), mean.product.value());
                (quarter, mean.value, nome.value())
            };
            let series = Series::circular(q, complementary_modulus);
            let inverse = rate.high() * FRAC_2_PI;
            Self::assemble(parameter, (quarter, inverse), rate, series)
        } else {
            let mean = Mean::new(m, mc);
            let nome = Nome::new(mc.value(), mean.product.value());
            let (quarter, inverse) = if mc.value() == 0.0 {
                (DoubleDouble::from(f64::INFINITY), 0.0)
            } else {
                let half = nome.logarithm(mc, mean.product).scaled(0.5);
                // Not from the quotient, which would have to be waited for.
                let inverse = mean.value.high() / half.high();
                (DoubleDouble::quick_quotient(half, mean.value), inverse)
            };
            let (half, rate) = (nome.value().sqrt(), mean.value);
            let series = Series::hyperbolic(half, complementary_modulus, rate.value());
            Self::assemble(parameter, (quarter, inverse), rate, series)
        }
    }

    pub(crate) fn side(&self) -> Side {
        self.parameter.side
    }

    /// π/(2K), or π/(2K′) beyond m = 1/2.
    pub(crate) fn pace(&self) -> f64 {
        self.rate.high()
    }

    /// The greatest argument whose quarter periods can be counted: 2⁵³ of them, if that is a double.
    pub(crate) fn greatest_argument(&self) -> f64 {
        (9_007_199_254_740_992.0 * self.quarter_period()).min(f64::MAX)
    }

    #[inline(always)]
    fn assemble(
        parameter: Parameter,
        (quarter, inverse): (DoubleDouble, f64),
        rate: DoubleDouble,
        series: Series,
    ) -> Self {
        let parts = if inverse == 0.0 {
            [0.0; 3]
        } else {
            let (first, second) = quick::halves(quarter.high());
            [first, second, quarter.low()]
        };
        Self {
            parameter,
            rate,
            reduction: Reduction { inverse, parts },
            series,
        }
    }

    /// The quarter period K = ∫₀^{π/2} dθ/√(1 − m sin²θ), rounded once from more than 100 bits; π/2 at m = 0,
    /// infinite at mc = 0.
    ///
    /// ```
    /// use spinning_bodies::elliptic::{Modulus, Parameter};
    /// assert_eq!(Modulus::new(Parameter::from_parameter(0.5)?).quarter_period(), 1.854_074_677_301_371_9);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn quarter_period(&self) -> f64 {
        self.quarter_period_dd().high()
    }

    /// K to 101 bits and more.
    pub(crate) fn quarter_period_dd(&self) -> DoubleDouble {
        let Reduction { inverse, parts } = self.reduction;
        match inverse {
            0.0 => DoubleDouble::from(f64::INFINITY),
            _ => DoubleDouble::new(parts[0] + parts[1], parts[2]),
        }
    }
}

/// A modulus prepared from all the digits of m and mc, with the transformation that prepared it.
#[derive(Clone, Copy)]
pub(crate) struct Descent<N: Number> {
    mc: N,
    pub(crate) modulus: Modulus,
    /// Gauss's transformation of the lesser of m and mc.
    pub(crate) landen: Landen<N>,
}

/// The squares of the three functions at one argument, as numerators over units, so that neither m nor a difference is formed again.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Squares<N> {
    pub(crate) sn: N,
    pub(crate) cn: N,
    /// sn² + cn² in the same unit.
    pub(crate) whole: N,
    pub(crate) dn: N,
    /// dn² + m sn² in the unit of `dn`.
    pub(crate) dn_whole: N,
}

impl<N: Number> Descent<N> {
    /// Takes m and mc as they are: each must be right to all its digits, neither formed from the other.
    #[inline]
    pub(crate) fn new(m: N, mc: N) -> Self {
        let parameter = Parameter::from_both(m.narrow(), mc.narrow());
        let (lesser, greater) = match parameter.side {
            Side::Circular => (m, mc),
            Side::Hyperbolic => (mc, m),
        };
        let landen = Landen::new(lesser, greater.narrow().square_root());
        let complementary_modulus = mc.root_of_quotient(N::from_double(1.0));
        let (quarter, series) = match parameter.side {
            Side::Circular => (
                RIGHT_ANGLE.quotient(landen.mean),
                Series::circular(landen.nome.value(), complementary_modulus),
            ),
            Side::Hyperbolic => {
                // √q is still in range where q underflows.
                let half = complementary_modulus * landen.nome_over_square.value().sqrt();
                let rate = landen.mean.value();
                let series = Series::hyperbolic(half, complementary_modulus, rate);
                (landen.complementary_quarter(), series)
            }
        };
        Self {
            mc,
            modulus: Modulus::assemble(
                parameter,
                (quarter, 1.0 / quarter.high()),
                landen.mean,
                series,
            ),
            landen,
        }
    }

    /// The u in 0…K with these functions, to double precision.
    #[inline]
    pub(crate) fn argument(&self, squares: &Squares<N>) -> DoubleDouble {
        let Squares { sn, cn, dn, .. } = *squares;
        let (whole, dn_whole) = (squares.whole, squares.dn_whole);
        // Beyond the middle of the quarter period, where mc sn⁴ > cn⁴, u is counted back from K: sn(K − u) is cn/dn, dn(K − u) is k′/dn.
        let from_end = (self.mc * sn.square()).exceeds(cn.square());
        let angle = match self.modulus.side() {
            Side::Circular => {
                let [s, d] = if from_end {
                    [
                        (cn * dn_whole).root_of_quotient(dn * whole),
                        (self.mc * dn_whole).root_of_quotient(dn),
                    ]
                } else {
                    [sn.root_of_quotient(whole), dn.root_of_quotient(dn_whole)]
                };
                N::from_double(self.landen.nearest_sine(s, d, 1.0).asin())
            }
            Side::Hyperbolic => {
                let [s, d] = if from_end {
                    [
                        cn.root_of_quotient(self.mc * sn),
                        whole.root_of_quotient(sn),
                    ]
                } else {
                    [
                        sn.root_of_quotient(cn),
                        (dn * whole).root_of_quotient(cn * dn_whole),
                    ]
                };
                let sinh = self.landen.nearest_sine(s, d, -1.0);
                N::from(N::from_double(sinh + sinh.hypot(1.0)).logarithm())
            }
        };
        let rest = angle.quotient(N::from(self.landen.mean)).narrow();
        if from_end {
            self.modulus.quarter_period_dd() - rest
        } else {
            rest
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Descent, Modulus, Parameter};
    use crate::elliptic::landen;

    #[test]
    fn quarter_period_agrees_with_the_plain_mean() -> crate::Result<()> {
        for mc in [1.0, 0.9, 0.51, 0.5, 0.49, 0.3, 1e-3, 1e-9, 1e-300] {
            let parameter = Parameter::from_complement(mc)?;
            let descent = Descent::new(parameter.m_dd(), parameter.mc_dd()).modulus;
            // Observed: 2⁻¹⁰¹·³ of K at mc = 0.49, where the series of the logarithm is longest; as a top prepares it 2⁻¹⁰⁰·⁶.
            for (modulus, bits) in [(Modulus::new(parameter), 101), (descent, 100)] {
                let k = modulus.quarter_period_dd();
                let rest = landen::remainder(parameter, k, 1.0).value();
                let allowed = k.value() * 2f64.powi(-bits);
                assert!(rest.abs() <= allowed, "mc = {mc}: {rest:e}");
            }
        }
        Ok(())
    }
}
