//! Theta functions as polynomials: of real arguments, where they correct the elementary functions; and of complex ones, u + iη, from whose phases the
//! angles of the exact tops are made (tutorial 6.8, 7.2): the phase as a function of u, in 106 bits where it grows with time, as polynomials where it
//! repeats.

use super::landen::{Landen, SMALL};
use super::parameter::Side;
use crate::precise::quick::select;
use crate::precise::{DoubleDouble as Dd, Number};

/// Coefficients in powers of z: z = sin² on the circular side, z = 4 √q′ sinh² on the hyperbolic one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Series {
    pub(super) corrections: Corrections,
    /// 2 q′^{1/4}: its square times sinh² is z.
    pub(super) root: f64,
    /// √mc.
    pub(super) complementary_modulus: f64,
}

/// Each Jacobi function is an elementary function times 1 + (its polynomial)/(denominator);
/// on the hyperbolic side near even multiples of K.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Corrections {
    pub(super) denominator: [f64; 4],
    pub(super) sn: [f64; 4],
    pub(super) cn: [f64; 4],
    pub(super) dn: [f64; 4],
}

/// q⁰, q^½, q, … q¹² by products that the processor can form side by side.
#[inline(always)]
fn powers(root: f64) -> [f64; 25] {
    let mut powers = [1.0; 25];
    powers[1] = root;
    for i in 2..25 {
        powers[i] = powers[i / 2] * powers[i - i / 2];
    }
    powers
}

/// The four theta functions as polynomials in z = sin²: ϑ₁ divided by 2q^{1/4} sin, ϑ₂ by 2q^{1/4} cos, ϑ₃ and ϑ₄ as they are.
///
/// `p(a, j)` gives q^a z^j, with the powers of q that the change of variable z → −sinh² leaves.
#[inline(always)]
fn thetas(p: impl Fn(usize, usize) -> f64) -> [[f64; 4]; 4] {
    let theta1 = [
        1.0 - (3.0 * p(2, 0) - 5.0 * p(6, 0) + 7.0 * p(12, 0)),
        4.0 * p(2, 1) - 20.0 * p(6, 1) + 56.0 * p(12, 1),
        16.0 * p(6, 2) - 112.0 * p(12, 2),
        64.0 * p(12, 3),
    ];
    let theta2 = [
        1.0 + (p(2, 0) + p(6, 0) + p(12, 0)),
        -4.0 * p(2, 1) - 12.0 * p(6, 1) - 24.0 * p(12, 1),
        16.0 * p(6, 2) + 80.0 * p(12, 2),
        -64.0 * p(12, 3),
    ];
    let theta3 = [
        1.0 + 2.0 * (p(1, 0) + p(4, 0) + p(9, 0)),
        -4.0 * p(1, 1) - 16.0 * p(4, 1) - 36.0 * p(9, 1),
        16.0 * p(4, 2) + 96.0 * p(9, 2),
        -64.0 * p(9, 3),
    ];
    let theta4 = [
        1.0 - 2.0 * (p(1, 0) - p(4, 0) + p(9, 0)),
        4.0 * p(1, 1) - 16.0 * p(4, 1) + 36.0 * p(9, 1),
        16.0 * p(4, 2) - 96.0 * p(9, 2),
        64.0 * p(9, 3),
    ];
    [theta1, theta2, theta3, theta4]
}

/// factor · numerator − denominator.
#[inline(always)]
fn correction(factor: f64, numerator: [f64; 4], denominator: [f64; 4]) -> [f64; 4] {
    core::array::from_fn(|k| factor * numerator[k] - denominator[k])
}

impl Series {
    #[inline(always)]
    pub(super) fn circular(q: f64, complementary_modulus: f64) -> Self {
        // Below it terms in q² are 3·10⁻¹⁸ at most.
        let corrections = if 16.0 * q < SMALL {
            Corrections {
                denominator: [1.0 - 2.0 * q, 4.0 * q, 0.0, 0.0],
                sn: [4.0 * q, 0.0, 0.0, 0.0],
                cn: [-4.0 * q, 0.0, 0.0, 0.0],
                dn: [-8.0 * q, 0.0, 0.0, 0.0],
            }
        } else {
            let powers = powers(q);
            circular_corrections(thetas(|a, _| powers[a]))
        };
        Self {
            corrections,
            root: 0.0,
            complementary_modulus,
        }
    }

    #[inline(always)]
    pub(super) fn hyperbolic(half: f64, complementary_modulus: f64, rate: f64) -> Self {
        Self {
            corrections: hyperbolic_corrections(hyperbolic_thetas(half), rate),
            root: 2.0 * half.sqrt(),
            complementary_modulus,
        }
    }
}

/// For any nome, from its root.
#[inline(always)]
fn hyperbolic_thetas(half: f64) -> [[f64; 4]; 4] {
    // sin² = −sinh² = −z/(4 √q): q^a sin^2j becomes q^(a − j/2) (−z/4)^j.
    const QUARTERS: [f64; 4] = [1.0, -1.0 / 4.0, 1.0 / 16.0, -1.0 / 64.0];
    let powers = powers(half);
    thetas(|a, j| powers[2 * a - j.min(2 * a)] * QUARTERS[j])
}

#[inline(always)]
fn circular_corrections([t1, t2, t3, t4]: [[f64; 4]; 4]) -> Corrections {
    // sn = 1 at z = 1: the correction has the factor 1 − z, which is divided out.
    let at_one = |t: [f64; 4]| ((t[3] + t[2]) + t[1]) + t[0];
    let r = correction(at_one(t4) / at_one(t1), t1, t4);
    // cn = cos and dn = 1 at z = 0: the factor z is divided out.
    let c = correction(t4[0] / t2[0], t2, t4);
    let d = correction(t4[0] / t3[0], t3, t4);
    Corrections {
        denominator: t4,
        sn: [r[0], r[0] + r[1], -r[3], 0.0],
        cn: [c[1], c[2], c[3], 0.0],
        dn: [d[1], d[2], d[3], 0.0],
    }
}

/// The corrections near even multiples of K; `rate` is π/(2K′).
#[inline(always)]
fn hyperbolic_corrections([t1, t2, t3, t4]: [[f64; 4]; 4], rate: f64) -> Corrections {
    let slope = 1.0 / (rate * t1[0]);
    Corrections {
        denominator: t2,
        sn: correction(slope * t2[0], t1, t2),
        cn: correction(t2[0] / t4[0], t4, t2),
        dn: correction(t2[0] / t3[0], t3, t2),
    }
}

/// One of the two equivalent arguments η and ξ = K′ − η, given by its elliptic functions of the complementary modulus.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Elevation<N> {
    which: Which,
    /// sn² and cn² in one unit, and that unit.
    rise: N,
    run: N,
    unit: N,
}

/// Which of the two it is: the smaller, so that its functions stay away from their extremes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Which {
    Eta,
    Xi,
}

impl<N: Number> Elevation<N> {
    /// The smaller of the two, each given by sn² and cn² in one unit, and that unit.
    #[inline(always)]
    pub(crate) fn smaller(eta: [N; 3], xi: [N; 3]) -> Self {
        let (which, [rise, run, unit]) = if (xi[0] * eta[1]).exceeds(eta[0] * xi[1]) {
            (Which::Eta, eta)
        } else {
            (Which::Xi, xi)
        };
        Self {
            which,
            rise,
            run,
            unit,
        }
    }

    /// ρ = q e^{2w} and ε = e^{−2w}, w = πη/2K, whose powers are the coefficients of a theta function of a complex argument, and 1 − ε. For m ≤ 1/2.
    #[inline]
    fn exponentials(&self, landen: &Landen<N>) -> [Dd; 3] {
        let one = Dd::from(1.0);
        // Beyond this e^{−2x} is negligible wherever it is added, and later steps could overflow.
        let most = Dd::from(1e150);
        // sinh x of the smaller argument x, w or πξ/2K.
        let sinh = if self.run.is_zero() {
            most
        } else {
            // sc² and dc² = 1 + m sc².
            let sc2 = self.rise.quotient(self.run);
            let dc2 = one.add_alike((landen.parameter * sc2).narrow());
            let sc = sc2.square_root().narrow();
            // By the leading words: no difference with infinity is a number.
            let sc = if sc.high() > most.high() { most } else { sc };
            landen.sine(sc, dc2.square_root(), -1.0)
        };
        let growth = sinh.add_alike(one.add_alike(sinh * sinh).square_root());
        let decay = one.quotient(growth);
        let lesser = decay * decay;
        // e^{2x} is at most 10³⁰¹, so this is zero if q has underflowed.
        let other = landen.nome * growth * growth;
        // For ξ in place of η they change roles.
        match self.which {
            Which::Eta => [other, lesser, sinh.scaled(2.0) * decay],
            Which::Xi => [lesser, other, one - other],
        }
    }

    /// Sine and cosine of v = πη/2K′, for mc < 1/2.
    #[inline(always)]
    fn angle(&self, landen: &Landen<N>) -> (Dd, Dd) {
        let one = Dd::from(1.0);
        let sn2 = self.rise.quotient(self.unit).narrow();
        let dn2 = one - landen.parameter.narrow() * sn2;
        let lesser = landen.sine(sn2.square_root(), dn2.square_root(), 1.0);
        let greater = (one - lesser * lesser).square_root();
        match self.which {
            Which::Eta => (lesser, greater),
            Which::Xi => (greater, lesser),
        }
    }
}

/// A theta function of u + iη as polynomials: real part, and imaginary part over its odd factor. For m ≤ 1/2 they are polynomials in sin² z, z = πu/2K, the same for all u; beyond in
/// 4√q′ sinh² x, x = πu/2K′, one set near even and one near odd multiples of K.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Theta {
    pub(crate) even: [[f64; 4]; 2],
    pub(crate) odd: [[f64; 4]; 2],
}

impl Theta {
    /// ϑ₂(ix − v), nome q′, from the sine and cosine of v; ϑ₃ next to odd multiples of K.
    #[inline(always)]
    fn dual(q: f64, s: f64, c: f64) -> Self {
        let (s2, s4) = (s * s, s * s * s * s);
        let root = q.sqrt();
        // cos (2j+1)v and sin (2j+1)v.
        let (c3, c5) = (c * (1.0 - 4.0 * s2), c * (1.0 - 12.0 * s2 + 16.0 * s4));
        let c7 = c * (1.0 - 24.0 * s2 + 80.0 * s4 - 64.0 * s4 * s2);
        let (k3, k5) = (s * (3.0 - 4.0 * s2), s * (5.0 - 20.0 * s2 + 16.0 * s4));
        let k7 = s * (7.0 - 56.0 * s2 + 112.0 * s4 - 64.0 * s4 * s2);
        // cos 2jv and sin 2jv.
        let (e2, f2) = ((c - s) * (c + s), 2.0 * s * c);
        let (e4, f4) = ((e2 - f2) * (e2 + f2), 2.0 * f2 * e2);
        let (e6, f6) = (e2 * e4 - f2 * f4, f2 * e4 + e2 * f4);
        let (q2, q3) = (q * q, q * q * q);
        let (q5, q6, q7, q8) = (q2 * q3, q3 * q3, q2 * q2 * q3, q2 * q3 * q3);
        let (q4, q9, q10, q11, q12) = (q2 * q2, q3 * q6, q5 * q5, q5 * q6, q6 * q6);
        let even_real = [
            c + c3 * q2 + c5 * q6 + c7 * q12,
            root * (c3 * q + 3.0 * c5 * q5 + 6.0 * c7 * q11),
            c5 * q5 + 5.0 * c7 * q11,
            root * (c7 * q10),
        ];
        let even_imaginary = [
            s + 3.0 * k3 * q2 + 5.0 * k5 * q6 + 7.0 * k7 * q12,
            root * (k3 * q + 5.0 * k5 * q5 + 14.0 * k7 * q11),
            k5 * q5 + 7.0 * k7 * q11,
            root * (k7 * q10),
        ];
        let odd_real = [
            1.0 + 2.0 * (e2 * q + e4 * q4 + e6 * q9),
            root * (e2 + 4.0 * e4 * q3 + 9.0 * e6 * q8),
            e4 * q3 + 6.0 * e6 * q8,
            root * (e6 * q7),
        ];
        let odd_imaginary = [
            root * (f2 + 2.0 * f4 * q3 + 3.0 * f6 * q8),
            // √q · √q.
            q * (f4 * q2 + 4.0 * f6 * q7),
            root * f6 * q7,
            0.0,
        ];
        Self {
            even: [even_real, even_imaginary],
            odd: [odd_real, odd_imaginary],
        }
    }

    /// The polynomials near even multiples of K, or near odd ones if all bits of the mask are set.
    #[inline(always)]
    pub(crate) fn chosen(&self, mask: u64) -> [[f64; 4]; 2] {
        let part =
            |odd: [f64; 4], even: [f64; 4]| core::array::from_fn(|k| select(mask, odd[k], even[k]));
        [
            part(self.odd[0], self.even[0]),
            part(self.odd[1], self.even[1]),
        ]
    }
}

/// The phase of a theta function of u + iη as a function of u: a lag for each quarter period, a slope, and polynomials for the rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Turning {
    /// Fall of the phase with each quarter period that the polynomials do not contain, radians.
    pub(crate) lag: Dd,
    /// Derivative of the phase by u at u = K.
    pub(crate) slope: Dd,
    pub(crate) theta: Theta,
}

impl Turning {
    /// For ϑ₁(π(u + iη)/2K), without the factor that grows with η; beyond m = 1/2 of ϑ₂(ix − v) with v = πη/2K′ − π/2. On the circular side there is no lag, and the
    /// second pair of polynomials is that of the derivatives.
    pub(crate) fn new<N: Number>(side: Side, landen: &Landen<N>, elevation: &Elevation<N>) -> Self {
        if side == Side::Hyperbolic {
            let (sine, cosine) = elevation.angle(landen);
            let (s, c) = (-cosine, sine);
            return Self {
                lag: Dd::angle(sine, cosine),
                slope: dual_slope(landen, s, c),
                theta: Theta::dual(landen.nome.value(), s.value(), c.value()),
            };
        }
        let one = Dd::from(1.0);
        let q = landen.nome;
        let [rho, epsilon, rest] = elevation.exponentials(landen);
        // q^{n²} ρⁿ (1 ± ε^{2n+1}) for n = 0, 1, 2, 3, and 4 for the slope alone.
        let square = epsilon * epsilon;
        let e3 = epsilon * square;
        let e5 = e3 * square;
        let factor1 = q * rho;
        let factor2 = factor1 * factor1 * (q * q);
        let geometric3 = one.add_alike(epsilon).add_alike(square);
        let geometric5 = geometric3.add_alike(e3).add_alike(square * square);
        let minus = [
            rest,
            factor1 * (rest * geometric3),
            factor2 * (rest * geometric5),
        ];
        let plus = [
            one.add_alike(epsilon),
            factor1 * one.add_alike(e3),
            factor2 * one.add_alike(e5),
        ];
        let x = q.leading();
        let factor3 = factor2.leading() * factor1.leading() * x * x * x * x;
        let e7 = e5.leading() * square.leading();
        let (plus3, minus3) = (factor3 * (1.0 + e7), factor3 * (1.0 - e7));
        // At z = π/2: cos(2n+1)z' sums with the sign that ϑ₂ has.
        let factor4 = factor3 * rho.leading() * x.powi(7);
        let numerator = sum_upward(7.0 * minus3 + 9.0 * factor4, minus, [1.0, 3.0, 5.0]);
        let denominator = sum_upward(plus3 + factor4, plus, [1.0; 3]);
        let slope = -(landen.mean * numerator).quotient(denominator);
        let with_signs =
            |[x0, x1, x2]: [Dd; 3], x3: f64| [x0.value(), -x1.value(), x2.value(), -x3];
        let (a, b) = (with_signs(plus, plus3), with_signs(minus, minus3));
        let real = [
            a[0] + 3.0 * a[1] + 5.0 * a[2] + 7.0 * a[3],
            -4.0 * a[1] - 20.0 * a[2] - 56.0 * a[3],
            16.0 * a[2] + 112.0 * a[3],
            -64.0 * a[3],
        ];
        let imaginary = [
            b[0] + b[1] + b[2] + b[3],
            -4.0 * b[1] - 12.0 * b[2] - 24.0 * b[3],
            16.0 * b[2] + 80.0 * b[3],
            -64.0 * b[3],
        ];
        let next = [imaginary[1], imaginary[2], imaginary[3], 0.0];
        let real_slope = core::array::from_fn(|k| (2 * k + 1) as f64 * real[k]);
        let imaginary_slope = core::array::from_fn(|k| {
            2.0 * (k + 1) as f64 * next[k] - (2 * k + 1) as f64 * imaginary[k]
        });
        Self {
            lag: Dd::from(0.0),
            slope,
            theta: Theta {
                even: [real, imaginary],
                odd: [real_slope, imaginary_slope],
            },
        }
    }
}

/// A small first term and weighted ones that grow, added from the smallest to the greatest.
fn sum_upward(least: f64, terms: [Dd; 3], weights: [f64; 3]) -> Dd {
    (0..3).rev().fold(Dd::from(least), |sum, k| {
        sum.add_alike(terms[k].times(weights[k]))
    })
}

/// d arg ϑ₂(ix − v)/du at u = K: (π/2K′) Σ 4n q′^{n²} sin 2nv / ϑ₃(v).
fn dual_slope<N: Number>(landen: &Landen<N>, sine: Dd, cosine: Dd) -> Dd {
    let q = landen.nome;
    let q2 = q * q;
    let q4 = q2 * q2;
    let s2 = (sine * cosine).scaled(2.0);
    let c2 = (cosine - sine) * cosine.add_alike(sine);
    let s4 = (s2 * c2).scaled(2.0);
    let c4 = (c2 - s2) * (c2 + s2);
    let (x, s2v, c2v, s4v, c4v) = (q.value(), s2.value(), c2.value(), s4.value(), c4.value());
    let (x3, x4) = (x * x * x, x * x * (x * x));
    let (x9, x16) = (x3 * x3 * x3, x4 * x4 * (x4 * x4));
    let (s6, c6) = (s2v * c4v + c2v * s4v, c2v * c4v - s2v * s4v);
    let (s8, c8) = (2.0 * s4v * c4v, c4v * c4v - s4v * s4v);
    let numerator = Dd::from(12.0 * x9 * s6 + 16.0 * x16 * s8)
        .add_alike((q4 * s4).scaled(8.0))
        .add_alike((q * s2).scaled(4.0));
    let denominator = Dd::from(2.0 * (x9 * c6 + x16 * c8))
        .add_alike((q4 * c4).scaled(2.0))
        .add_alike((q * c2).scaled(2.0))
        .add_alike(Dd::from(1.0));
    (landen.mean * numerator).quotient(denominator)
}
