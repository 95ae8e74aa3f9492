//! The prepared modulus: quarter period to 106 bits, nome, and the coefficients of the theta functions.

use super::jacobi::COUNTABLE;
use super::landen::Landen;
use super::parameter::Parameter;
use crate::double_double::DoubleDouble;

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
        let side = if m.value() <= mc.value() {
            Side::Circular
        } else {
            Side::Hyperbolic
        };
        let (lesser, greater) = match side {
            Side::Circular => (m, mc),
            Side::Hyperbolic => (mc, m),
        };
        let mean = Mean::new(greater);
        let rate = mean.value;
        let quarter = match side {
            Side::Circular => PI.scaled(0.5).divide(rate),
            Side::Hyperbolic if mc.value() == 0.0 => DoubleDouble::from(f64::INFINITY),
            Side::Hyperbolic => PI.scaled(0.5).divide(slow_mean(mc)),
        };
        let nome = Nome::new(lesser.value(), mean.product);
        let series = match side {
            Side::Circular => Series::circular(&nome, mc.value().sqrt()),
            Side::Hyperbolic => Series::hyperbolic(&nome, mc.value().sqrt(), rate.value()),
        };
        Self {
            parameter,
            side,
            quarter,
            rate,
            series,
        }
    }

    /// The modulus from k and k′, both to 106 bits, and the transformation of the lesser of the two.
    pub(crate) fn from_landen(k: DoubleDouble, k_prime: DoubleDouble, landen: &Landen) -> Self {
        let parameter = Parameter::from_both(k.multiply(k), k_prime.multiply(k_prime));
        let complementary = k_prime.value();
        let (side, lesser) = if k.high() <= complementary {
            (Side::Circular, k.value())
        } else {
            (Side::Hyperbolic, complementary)
        };
        let quarter = match side {
            Side::Circular => PI.scaled(0.5).divide(landen.mean),
            Side::Hyperbolic => landen.complementary_quarter(),
        };
        let nome = Nome {
            q: landen.nome.value(),
            root: landen.fourth_root_of_nome(lesser),
        };
        let series = match side {
            Side::Circular => Series::circular(&nome, complementary),
            Side::Hyperbolic => Series::hyperbolic(&nome, complementary, landen.mean.value()),
        };
        Self {
            parameter,
            side,
            quarter,
            rate: landen.mean,
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

    pub(crate) fn side(&self) -> Side {
        self.side
    }

    /// The greatest argument that still has a place: 2⁵³ quarter periods.
    pub(crate) fn greatest_argument(&self) -> f64 {
        COUNTABLE * self.quarter.high()
    }

    /// K to 106 bits.
    #[allow(dead_code, reason = "for phases inside the library")]
    pub(crate) fn quarter_period_dd(&self) -> DoubleDouble {
        self.quarter
    }
}

/// The arithmetic-geometric mean of 1 and √x for x in 1/2…1.
struct Mean {
    value: DoubleDouble,
    /// First mean times second mean, from which the nome follows.
    product: f64,
}

impl Mean {
    fn new(x: DoubleDouble) -> Self {
        let one = DoubleDouble::from(1.0);
        let b0 = x.square_root();
        let a1 = one.add(b0).scaled(0.5);
        let b1 = b0.square_root();
        let a2 = a1.add(b1).scaled(0.5);
        let b2 = a1.multiply(b1).square_root();
        // 1/agm(1 + d, 1 − d) = 1 + d²/4 + 9 d⁴/64 + 25 d⁶/256 + …, and here d ≤ 1.4e-5.
        let sum = a2.add(b2);
        let d = a2.subtract(b2).divide(sum);
        let d2 = d.multiply(d);
        let x = d2.value();
        let tail = x * x * (9.0 / 64.0 + x * (25.0 / 256.0));
        let inverse = one.add(d2.scaled(0.25).add(DoubleDouble::from(tail)));
        Self {
            value: sum.scaled(0.5).divide(inverse),
            product: a1.value() * a2.value(),
        }
    }
}

/// The arithmetic-geometric mean of 1 and √x for any x in 0…1.
fn slow_mean(x: DoubleDouble) -> DoubleDouble {
    let mut a = DoubleDouble::from(1.0);
    let mut b = x.square_root();
    if b.value() == 0.0 {
        return DoubleDouble::from(0.0);
    }
    for _ in 0..16 {
        let next = a.add(b).scaled(0.5);
        let gap = a.subtract(b).value();
        if gap <= 1e-17 * a.value() {
            return next;
        }
        b = a.multiply(b).square_root();
        a = next;
    }
    a
}

/// The nome q and its fourth root.
struct Nome {
    q: f64,
    root: f64,
}

impl Nome {
    /// From the lesser of m and mc, and the product of the first two means of the other.
    ///
    /// With l = (1 − √k′)/(2 (1 + √k′)) = m/(16 a1 a2): q = l + 2 l⁵ + 15 l⁹ + 150 l¹³ + 1707 l¹⁷ + …
    fn new(lesser: f64, product: f64) -> Self {
        let l = lesser / (16.0 * product);
        let l4 = (l * l) * (l * l);
        let series = 1.0 + l4 * (2.0 + l4 * (15.0 + l4 * (150.0 + l4 * 1707.0)));
        Self {
            q: l * series,
            root: 0.5 * lesser.sqrt().sqrt() * (series / product).sqrt().sqrt(),
        }
    }
}

/// The four theta functions divided by sin, cos, 1, 1 and by 2q^{1/4} where it is due, as polynomials in sin² = z.
///
/// `p` gives q^a z^j with the powers of q that the change of variable z → −sinh² leaves.
fn thetas(p: impl Fn(i32, usize) -> f64) -> [[f64; 4]; 4] {
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
    fn circular(nome: &Nome, complementary_modulus: f64) -> Self {
        let [t1, t2, t3, t4] = thetas(|a, _| nome.q.powi(a));
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
        let [t1, t2, t3, t4] =
            thetas(|a, j| nome.root.powi(4 * a - 2 * j as i32) * (-0.25_f64).powi(j as i32));
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
            root: 2.0 * nome.root,
            complementary_modulus,
        }
    }
}
