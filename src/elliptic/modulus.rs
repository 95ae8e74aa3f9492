//! The prepared modulus: quarter period to 106 bits, nome, and the coefficients of the theta functions.

use super::jacobi::COUNTABLE;
use super::kernel;
use super::landen::Landen;
use super::logarithm::logarithm;
use super::parameter::Parameter;
use crate::double_double::{DoubleDouble, power_of_two_below};

/// π/2 to 106 bits.
const HALF_PI: DoubleDouble =
    DoubleDouble::new(core::f64::consts::FRAC_PI_2, 6.123_233_995_736_766e-17);

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

/// Everything about a modulus that does not depend on the argument.
///
/// # Cost
///
/// See `cargo bench -p bench --bench elliptic`.
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
pub(super) const EXACT_COUNT: f64 = 33_554_432.0;

/// Coefficients in powers of z: z = sin² on the circular side, z = 4 √q′ sinh² on the hyperbolic one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Series {
    /// Near an even multiple of K; on the circular side for every argument.
    pub(super) even: Corrections,
    /// Near an odd multiple of K, on the hyperbolic side only.
    pub(super) odd: Corrections,
    /// 2 q′^{1/4}: its square times sinh² is z.
    pub(super) root: f64,
    /// √mc.
    pub(super) complementary_modulus: f64,
}

/// Each Jacobi function is an elementary function times 1 + (its polynomial)/(denominator).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Corrections {
    pub(super) denominator: [f64; 4],
    pub(super) sn: [f64; 4],
    pub(super) cn: [f64; 4],
    pub(super) dn: [f64; 4],
}

impl Modulus {
    /// The modulus prepared for many arguments.
    pub fn new(parameter: Parameter) -> Self {
        let (m, mc) = (parameter.m_dd(), parameter.mc_dd());
        let complementary_modulus = mc.value().sqrt();
        if m.value() <= mc.value() {
            let mean = Mean::new(mc);
            let q = Nome::new(m.value(), mean.product.value()).value();
            let quarter = kernel::quotient(HALF_PI, mean.value);
            let series = Series::circular(q, complementary_modulus);
            Self::assemble(parameter, Side::Circular, quarter, mean.value, series)
        } else {
            let mean = Mean::new(m);
            let nome = Nome::new(mc.value(), mean.product.value());
            let quarter = if mc.value() == 0.0 {
                DoubleDouble::from(f64::INFINITY)
            } else {
                let logarithm = nome.logarithm(mc, mean.product);
                kernel::quotient(logarithm.scaled(0.5), mean.value)
            };
            let series = Series::hyperbolic(
                nome.value().sqrt(),
                complementary_modulus,
                mean.value.value(),
            );
            Self::assemble(parameter, Side::Hyperbolic, quarter, mean.value, series)
        }
    }

    /// The modulus from a transformation of the lesser of m and mc; both are wanted to 106 bits, and √mc.
    pub(crate) fn from_landen(
        side: Side,
        parameter: Parameter,
        complementary_modulus: f64,
        landen: &Landen,
    ) -> Self {
        let mean = landen.mean;
        let (quarter, series) = match side {
            Side::Circular => (
                HALF_PI.divide(mean),
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

    /// The greatest argument that still has a place: 2⁵³ quarter periods.
    pub(crate) fn greatest_argument(&self) -> f64 {
        COUNTABLE * self.quarter.high()
    }

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
            let (first, second) = kernel::halves(quarter.high());
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

    /// The quarter period K; infinite at mc = 0.
    pub fn quarter_period(&self) -> f64 {
        self.quarter.high()
    }

    /// K to 104 bits.
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
    fn new(x: DoubleDouble) -> Self {
        let (b0, b0_low) = kernel::root(x.high(), x.low());
        let (sum, rest) = kernel::ordered_sum(1.0, b0);
        let (a1, a1_low) = (0.5 * sum, 0.5 * (rest + b0_low));
        let (b1, b1_low) = kernel::root(b0, b0_low);
        let (sum, rest) = kernel::ordered_sum(a1, b1);
        let (a2, a2_low) = (0.5 * sum, 0.5 * (rest + (a1_low + b1_low)));
        let (square, rest) = kernel::exact_product(a1, b1);
        let (b2, b2_low) = kernel::root(square, rest + (a1 * b1_low + a1_low * b1));
        // With S = a2 + b2 and d = (a2 − b2)/S ≤ 1.4e-5:
        // agm(a2, b2) = S/2 (1 − d²/4 − 5 d⁴/64 − 11 d⁶/256 − …), where the first term needs both words.
        let (sum, rest) = kernel::ordered_sum(a2, b2);
        let sum_low = rest + (a2_low + b2_low);
        let gap = DoubleDouble::sum(a2 - b2, a2_low - b2_low);
        let (gap2, error) = kernel::exact_product(gap.high(), gap.high());
        let gap2_low = error + 2.0 * gap.high() * gap.low();
        let eight = 8.0 * sum;
        let inverse = 1.0 / eight;
        let less = gap2 * inverse;
        let (back, error) = kernel::exact_product(less, eight);
        let less_low = (((gap2 - back) - error) + (gap2_low - 8.0 * less * sum_low)) * inverse;
        let d2 = 8.0 * less * (8.0 * inverse);
        let tail = 0.5 * sum * d2 * d2 * (5.0 / 64.0 + d2 * (11.0 / 256.0));
        let (high, low) = kernel::ordered_sum(0.5 * sum, -less);
        let low = low + (0.5 * sum_low - less_low - tail);
        let (high, low) = kernel::ordered_sum(high, low);
        let product = kernel::product(DoubleDouble::new(a1, a1_low), DoubleDouble::new(a2, a2_low));
        Self {
            value: DoubleDouble::new(high, low),
            product,
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

    /// ln(1/q) to 104 bits, for q > 0.
    fn logarithm(&self, lesser: DoubleDouble, product: DoubleDouble) -> DoubleDouble {
        // ln(q/l) = 2 y + 13 y² + (368/3) y³ + …, y = l⁴ ≤ 3.6e-6.
        // The quotient is formed with a power of two taken off: mc may be as small as a double can be.
        let unit = power_of_two_below(lesser.high());
        let exponent = 1023 - (unit.to_bits() >> 52) as i32;
        let ratio = kernel::quotient(product.scaled(16.0), lesser.scaled(1.0 / unit));
        let logarithm = logarithm(ratio, exponent);
        if self.l4 < 1e-34 {
            return logarithm;
        }
        let l = kernel::quotient(lesser, product.scaled(16.0));
        let l2 = kernel::product(l, l);
        let y = kernel::product(l2, l2);
        let t = y.value();
        let third = 2701.0 / 2.0 + t * (80912.0 / 5.0 + t * (613_720.0 / 3.0));
        let second = kernel::product(y, DoubleDouble::sum(368.0 / 3.0, t * third));
        let first = kernel::product(y, second.add(DoubleDouble::from(13.0)));
        let correction = kernel::product(y, first.add(DoubleDouble::from(2.0)));
        logarithm.subtract(correction)
    }
}

/// q⁰, q^½, q, … q¹² by products that the processor can form side by side.
fn powers(root: f64) -> [f64; 25] {
    let mut powers = [1.0; 25];
    powers[1] = root;
    for i in 2..25 {
        powers[i] = powers[i / 2] * powers[i - i / 2];
    }
    powers
}

/// The four theta functions divided by sin, cos, 1, 1 and by 2q^{1/4} where it is due, as polynomials in sin² = z.
///
/// `p` gives q^a z^j with the powers of q that the change of variable z → −sinh² leaves.
fn thetas(p: impl Fn(usize, usize) -> f64) -> [[f64; 4]; 4] {
    let [q1, q4, q9] = [1, 4, 9].map(|a| [0, 1, 2, 3].map(|j| 2.0 * p(a, j)));
    let [q2, q6, q12] = [2, 6, 12].map(|a| [0, 1, 2, 3].map(|j| p(a, j)));
    let theta1 = [
        1.0 - (3.0 * q2[0] - 5.0 * q6[0] + 7.0 * q12[0]),
        4.0 * q2[1] - 20.0 * q6[1] + 56.0 * q12[1],
        16.0 * q6[2] - 112.0 * q12[2],
        64.0 * q12[3],
    ];
    let theta2 = [
        1.0 + (q2[0] + q6[0] + q12[0]),
        -4.0 * q2[1] - 12.0 * q6[1] - 24.0 * q12[1],
        16.0 * q6[2] + 80.0 * q12[2],
        -64.0 * q12[3],
    ];
    let theta3 = [
        1.0 + (q1[0] + q4[0] + q9[0]),
        -2.0 * q1[1] - 8.0 * q4[1] - 18.0 * q9[1],
        8.0 * q4[2] + 48.0 * q9[2],
        -32.0 * q9[3],
    ];
    let theta4 = [
        1.0 - (q1[0] - q4[0] + q9[0]),
        2.0 * q1[1] - 8.0 * q4[1] + 18.0 * q9[1],
        8.0 * q4[2] - 48.0 * q9[2],
        32.0 * q9[3],
    ];
    [theta1, theta2, theta3, theta4]
}

/// factor · numerator − denominator.
fn correction(factor: f64, numerator: [f64; 4], denominator: [f64; 4]) -> [f64; 4] {
    [0, 1, 2, 3].map(|j| factor * numerator[j] - denominator[j])
}

impl Series {
    fn circular(q: f64, complementary_modulus: f64) -> Self {
        let powers = powers(q);
        let [t1, t2, t3, t4] = thetas(|a, _| powers[a]);
        // sn = 1 at z = 1: the correction has the factor 1 − z, which is divided out.
        let at_one = |t: [f64; 4]| ((t[3] + t[2]) + t[1]) + t[0];
        let r = correction(at_one(t4) / at_one(t1), t1, t4);
        // cn = cos and dn = 1 at z = 0: the factor z is divided out.
        let c = correction(t4[0] / t2[0], t2, t4);
        let d = correction(t4[0] / t3[0], t3, t4);
        let even = Corrections {
            denominator: t4,
            sn: [r[0], r[0] + r[1], -r[3], 0.0],
            cn: [c[1], c[2], c[3], 0.0],
            dn: [d[1], d[2], d[3], 0.0],
        };
        Self {
            even,
            odd: even,
            root: 0.0,
            complementary_modulus,
        }
    }

    fn hyperbolic(half: f64, complementary_modulus: f64, rate: f64) -> Self {
        // sin² = −sinh² = −z/(4 √q): q^a sin^2j becomes q^(a − j/2) (−z/4)^j.
        let powers = powers(half);
        const QUARTERS: [f64; 4] = [1.0, -1.0 / 4.0, 1.0 / 16.0, -1.0 / 64.0];
        let [t1, t2, t3, t4] = thetas(|a, j| powers[2 * a - j.min(2 * a)] * QUARTERS[j]);
        let slope = 1.0 / (rate * t1[0]);
        Self {
            even: Corrections {
                denominator: t2,
                sn: correction(slope * t2[0], t1, t2),
                cn: correction(t2[0] / t4[0], t4, t2),
                dn: correction(t2[0] / t3[0], t3, t2),
            },
            odd: Corrections {
                denominator: t3,
                sn: correction(t3[0] / t4[0], t4, t3),
                cn: correction(slope * t3[0], t1, t3),
                dn: correction(t3[0] / t2[0], t2, t3),
            },
            root: 2.0 * half.sqrt(),
            complementary_modulus,
        }
    }
}
