//! The prepared modulus: quarter period to 106 bits, nome, and the coefficients of the theta functions.

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
pub(super) enum Side {
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
    pub(super) series: Series,
}

/// Coefficients in powers of z: z = sin² on the circular side, z = 4 √q′ sinh² on the hyperbolic one.
///
/// Each Jacobi function is an elementary function times 1 + (correction)/(denominator).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Series {
    /// Denominator of sn, cn, dn near a multiple of 2K.
    pub(super) even: [f64; 4],
    /// Denominator near an odd multiple of K (hyperbolic side only).
    pub(super) odd: [f64; 4],
    pub(super) sn: [f64; 4],
    pub(super) cn: [f64; 4],
    pub(super) dn: [f64; 4],
    pub(super) sn_odd: [f64; 4],
    pub(super) cn_odd: [f64; 4],
    pub(super) dn_odd: [f64; 4],
    /// 2 q′^{1/4}: its square times sinh² is z.
    pub(super) root: f64,
    /// √mc.
    pub(super) complementary_modulus: f64,
}

impl Modulus {
    /// The modulus prepared for many arguments.
    pub fn new(parameter: Parameter) -> Self {
        let (m, mc) = (parameter.m_dd(), parameter.mc_dd());
        if m.value() <= mc.value() {
            let mean = Mean::new(mc);
            let q = Nome::new(m.value(), mean.product.value()).value();
            Self {
                parameter,
                side: Side::Circular,
                quarter: HALF_PI.divide(mean.value),
                rate: mean.value,
                series: Series::circular(q, mc.value().sqrt()),
            }
        } else {
            let mean = Mean::new(m);
            let nome = Nome::new(mc.value(), mean.product.value());
            Self {
                parameter,
                side: Side::Hyperbolic,
                quarter: if mc.value() == 0.0 {
                    DoubleDouble::from(f64::INFINITY)
                } else {
                    nome.logarithm(mc, mean.product)
                        .scaled(0.5)
                        .divide(mean.value)
                },
                rate: mean.value,
                series: Series::hyperbolic(&nome, mc.value().sqrt(), mean.value.value()),
            }
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
    fn new(x: DoubleDouble) -> Self {
        let one = DoubleDouble::from(1.0);
        let b0 = x.square_root();
        let a1 = one.add(b0).scaled(0.5);
        let b1 = b0.square_root();
        let a2 = a1.add(b1).scaled(0.5);
        let b2 = a1.multiply(b1).square_root();
        // agm(1 + d, 1 − d) = 1 − d²/4 − 5 d⁴/64 − 11 d⁶/256 − …, and here d ≤ 1.4e-5.
        let sum = a2.add(b2);
        let d = a2.subtract(b2).divide(sum);
        let d2 = d.multiply(d);
        let x = d2.value();
        let tail = x * x * (5.0 / 64.0 + x * (11.0 / 256.0));
        let less = d2.scaled(0.25).add(DoubleDouble::from(tail));
        let half = sum.scaled(0.5);
        Self {
            value: half.subtract(half.multiply(less)),
            product: a1.multiply(a2),
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
        let l = lesser.divide(product.scaled(16.0));
        let l2 = l.multiply(l);
        let y = l2.multiply(l2);
        let t = y.value();
        let third = 2701.0 / 2.0 + t * (80912.0 / 5.0 + t * (613_720.0 / 3.0));
        let second = y.multiply(DoubleDouble::sum(368.0 / 3.0, t * third));
        let first = y.multiply(second.add(DoubleDouble::from(13.0)));
        let correction = y.multiply(first.add(DoubleDouble::from(2.0)));
        // The quotient is formed with a power of two taken off: mc may be as small as a double can be.
        let unit = power_of_two_below(lesser.high());
        let exponent = 1023 - (unit.to_bits() >> 52) as i32;
        product
            .scaled(16.0)
            .divide(lesser.scaled(1.0 / unit))
            .ln(exponent)
            .subtract(correction)
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
        let sn = [r[0], r[0] + r[1], -r[3], 0.0];
        // cn = cos and dn = 1 at z = 0: the factor z is divided out.
        let c = correction(t4[0] / t2[0], t2, t4);
        let d = correction(t4[0] / t3[0], t3, t4);
        let none = [0.0; 4];
        Self {
            even: t4,
            odd: none,
            sn,
            cn: [c[1], c[2], c[3], 0.0],
            dn: [d[1], d[2], d[3], 0.0],
            sn_odd: none,
            cn_odd: none,
            dn_odd: none,
            root: 0.0,
            complementary_modulus,
        }
    }

    fn hyperbolic(nome: &Nome, complementary_modulus: f64, rate: f64) -> Self {
        // sin² = −sinh² = −z/(4 √q): q^a sin^2j becomes q^(a − j/2) (−z/4)^j.
        let half = nome.value().sqrt();
        let powers = powers(half);
        const QUARTERS: [f64; 4] = [1.0, -1.0 / 4.0, 1.0 / 16.0, -1.0 / 64.0];
        let [t1, t2, t3, t4] = thetas(|a, j| powers[2 * a - j.min(2 * a)] * QUARTERS[j]);
        let slope = 1.0 / rate;
        Self {
            even: t2,
            odd: t3,
            sn: correction(slope * t2[0] / t1[0], t1, t2),
            cn: correction(t2[0] / t4[0], t4, t2),
            dn: correction(t2[0] / t3[0], t3, t2),
            sn_odd: correction(t3[0] / t4[0], t4, t3),
            cn_odd: correction(slope * t3[0] / t1[0], t1, t3),
            dn_odd: correction(t3[0] / t2[0], t2, t3),
            root: 2.0 * half.sqrt(),
            complementary_modulus,
        }
    }
}
