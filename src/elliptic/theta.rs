//! Theta functions as polynomials: of real arguments, as corrections of the elementary functions; of complex arguments u + iη, of which
//! the angles of the exact tops are made (tutorial 6.8, 7.2).

use super::landen::{Landen, SMALL};
use crate::precise::quick::select;
use crate::precise::{Number, Words};

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

impl Corrections {
    /// The set for as many quarter periods as the lowest bit says, without a branch.
    #[inline(always)]
    pub(super) fn chosen(series: &Series, bits: u64) -> Self {
        let odd = (bits & 1).wrapping_neg();
        let choose = |a: &[f64; 4], b: &[f64; 4]| core::array::from_fn(|k| select(odd, b[k], a[k]));
        let Series { even, odd, .. } = series;
        Self {
            denominator: choose(&even.denominator, &odd.denominator),
            sn: choose(&even.sn, &odd.sn),
            cn: choose(&even.cn, &odd.cn),
            dn: choose(&even.dn, &odd.dn),
        }
    }
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

/// The four theta functions divided by sin, cos, 1, 1 and by 2q^{1/4} where it is due, as polynomials in sin² = z.
///
/// `p` gives q^a z^j with the powers of q that the change of variable z → −sinh² leaves.
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

/// The same for a small nome, from p(1, 0), p(1, 1) and p(2, 0), p(2, 1): what is left out has q³ and less.
fn few_thetas([[p10, p11], [p20, p21]]: [[f64; 2]; 2]) -> [[f64; 4]; 4] {
    [
        [1.0 - 3.0 * p20, 4.0 * p21, 0.0, 0.0],
        [1.0 + p20, -4.0 * p21, 0.0, 0.0],
        [1.0 + 2.0 * p10, -4.0 * p11, 0.0, 0.0],
        [1.0 - 2.0 * p10, 4.0 * p11, 0.0, 0.0],
    ]
}

/// factor · numerator − denominator.
#[inline(always)]
fn correction(factor: f64, numerator: [f64; 4], denominator: [f64; 4]) -> [f64; 4] {
    core::array::from_fn(|k| factor * numerator[k] - denominator[k])
}

impl Series {
    pub(super) fn circular(q: f64, complementary_modulus: f64) -> Self {
        let thetas = if q < SMALL {
            few_thetas([[q, q], [q * q, q * q]])
        } else {
            circular_thetas(q)
        };
        let even = circular_corrections(thetas);
        Self {
            even,
            odd: even,
            root: 0.0,
            complementary_modulus,
        }
    }

    pub(super) fn hyperbolic(half: f64, complementary_modulus: f64, rate: f64) -> Self {
        let q = half * half;
        let thetas = if q < SMALL {
            few_thetas([[q, -0.25 * half], [q * q, -0.25 * half * q]])
        } else {
            hyperbolic_thetas(half)
        };
        let [even, odd] = hyperbolic_corrections(thetas, rate);
        Self {
            even,
            odd,
            root: 2.0 * half.sqrt(),
            complementary_modulus,
        }
    }
}

/// For any nome q.
#[inline(always)]
pub(super) fn circular_thetas(q: f64) -> [[f64; 4]; 4] {
    let powers = powers(q);
    thetas(|a, _| powers[a])
}

/// For any nome, from its root.
#[inline(always)]
pub(super) fn hyperbolic_thetas(half: f64) -> [[f64; 4]; 4] {
    // sin² = −sinh² = −z/(4 √q): q^a sin^2j becomes q^(a − j/2) (−z/4)^j.
    const QUARTERS: [f64; 4] = [1.0, -1.0 / 4.0, 1.0 / 16.0, -1.0 / 64.0];
    let powers = powers(half);
    thetas(|a, j| powers[2 * a - j.min(2 * a)] * QUARTERS[j])
}

#[inline(always)]
pub(super) fn circular_corrections([t1, t2, t3, t4]: [[f64; 4]; 4]) -> Corrections {
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

/// Next to even and next to odd multiples of K; `rate` is π/(2K′).
#[inline(always)]
pub(super) fn hyperbolic_corrections(
    [t1, t2, t3, t4]: [[f64; 4]; 4],
    rate: f64,
) -> [Corrections; 2] {
    let slope = 1.0 / (rate * t1[0]);
    [
        Corrections {
            denominator: t2,
            sn: correction(slope * t2[0], t1, t2),
            cn: correction(t2[0] / t4[0], t4, t2),
            dn: correction(t2[0] / t3[0], t3, t2),
        },
        Corrections {
            denominator: t3,
            sn: correction(t3[0] / t4[0], t4, t3),
            cn: correction(slope * t3[0], t1, t3),
            dn: correction(t3[0] / t2[0], t2, t3),
        },
    ]
}

/// One of the two equivalent arguments η and ξ = K′ − η, by its functions for the complementary modulus.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Elevation<N> {
    pub(crate) which: Which,
    /// sn² = `rise`/`slope`, cn² = `run`/`slope`.
    pub(crate) rise: N,
    pub(crate) run: N,
    pub(crate) slope: N,
}

/// Which of them: the smaller, so that its functions are far from their ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Which {
    Eta,
    Xi,
}

/// The powers of q and e that a theta function of a complex argument has as coefficients, w = πη/2K, for m ≤ 1/2.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Exponentials<W> {
    /// ρ = q e^{2w}.
    pub(crate) rho: W,
    /// ε = e^{−2w}.
    pub(crate) epsilon: W,
    /// sinh x, e^x and e^{−x} of the smaller argument x, w or πξ/2K. One of ρ and ε is e^{−2x}, and 1 less it 2 sinh x · e^{−x}.
    pub(crate) sinh: W,
    pub(crate) growth: W,
    pub(crate) decay: W,
}

impl<W: Words> Exponentials<W> {
    /// From sinh x and the nome q.
    #[inline(always)]
    fn new(which: Which, sinh: W, q: W) -> Self {
        let growth = sinh.add_alike(sinh.hypotenuse_with_one());
        let decay = W::from_double(1.0).quotient(growth);
        let lesser = decay * decay;
        // No more than 10³⁰¹ is e^{2x}: if q has underflowed, this is zero.
        let other = q * growth * growth;
        // For ξ in place of η they change roles.
        let (rho, epsilon) = match which {
            Which::Eta => (other, lesser),
            Which::Xi => (lesser, other),
        };
        Self {
            rho,
            epsilon,
            sinh,
            growth,
            decay,
        }
    }
}

impl<N: Number> Elevation<N> {
    /// From `rise` and `run` of both: the smaller of them, with the `slope` that belongs to it.
    #[inline(always)]
    pub(crate) fn smaller(eta: [N; 2], xi: [N; 2], slope: impl Fn(Which) -> N) -> Self {
        let (which, [rise, run]) = if (xi[0] * eta[1]).exceeds(eta[0] * xi[1]) {
            (Which::Eta, eta)
        } else {
            (Which::Xi, xi)
        };
        Self {
            which,
            rise,
            run,
            slope: slope(which),
        }
    }

    /// For m ≤ 1/2.
    #[inline]
    pub(crate) fn exponentials(&self, landen: &Landen<N>, m: N) -> Exponentials<N::Narrow> {
        let sinh = if self.run.is_zero() {
            N::Narrow::from_double(1e150)
        } else {
            self.hyperbolic_sine(landen, m)
        };
        Exponentials::new(self.which, sinh, landen.nome)
    }

    /// sinh(πη/2K), or of ξ, for m ≤ 1/2.
    #[inline(always)]
    fn hyperbolic_sine(&self, landen: &Landen<N>, m: N) -> N::Narrow {
        // sc² and dc² = 1 + m sc².
        let sc2 = self.rise.quotient(self.run);
        let dc2 = N::Narrow::from_double(1.0).add_alike((m * sc2).narrow());
        let sc = sc2.square_root().narrow();
        // Beyond this e^{−2x} is nothing to anything it is added to, and what follows might overflow.
        let sc = if sc.leading() > 1e150 {
            N::Narrow::from_double(1e150)
        } else {
            sc
        };
        landen.hyperbolic_sine(sc, dc2.square_root())
    }

    /// Sine and cosine of v = πη/2K′, for mc < 1/2.
    #[inline(always)]
    pub(crate) fn angle(&self, landen: &Landen<N>, mc: N) -> (N::Narrow, N::Narrow) {
        let one = N::Narrow::from_double(1.0);
        let sn2 = self.rise.quotient(self.slope).narrow();
        let dn2 = one - mc.narrow() * sn2;
        let lesser = landen.sine(sn2.square_root(), dn2.square_root());
        let greater = (one - lesser * lesser).square_root();
        match self.which {
            Which::Eta => (lesser, greater),
            Which::Xi => (greater, lesser),
        }
    }
}

/// A theta function of u + iη as polynomials: real part, and imaginary part over the odd factor. For m ≤ 1/2 in sin² z, z = πu/2K, and alike everywhere; beyond in
/// 4√q′ sinh² x, x = πu/2K′, next to even and next to odd multiples of K.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Theta {
    pub(crate) even: [[f64; 4]; 2],
    pub(crate) odd: [[f64; 4]; 2],
}

impl Theta {
    /// ϑ₂(ix − v), nome q′, from the sine and cosine of v; ϑ₃ next to odd multiples of K.
    #[inline(always)]
    pub(crate) fn dual(q: f64, s: f64, c: f64) -> Self {
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
        let (q4, q9, q10, q11) = (q2 * q2, q3 * q6, q5 * q5, q5 * q6);
        let even_real = [
            c + c3 * q2 + c5 * q6,
            root * (c3 * q + 3.0 * c5 * q5),
            c5 * q5 + 5.0 * c7 * q11,
            root * (c7 * q10),
        ];
        let even_imaginary = [
            s + 3.0 * k3 * q2 + 5.0 * k5 * q6,
            root * (k3 * q + 5.0 * k5 * q5),
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

    /// The polynomials next to even multiples of K, or where the mask is ones next to odd ones.
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

/// d arg ϑ₂(ix − v)/du at u = K: (π/2K′) Σ 4n q′^{n²} sin 2nv / ϑ₃(v).
#[inline(always)]
pub(crate) fn dual_excess<N: Number>(
    landen: &Landen<N>,
    sine: N::Narrow,
    cosine: N::Narrow,
) -> N::Narrow {
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
    let numerator = N::Narrow::from_double(12.0 * x9 * s6 + 16.0 * x16 * s8)
        .add_alike((q4 * s4).scaled(8.0))
        .add_alike((q * s2).scaled(4.0));
    let denominator = N::Narrow::from_double(2.0 * (x9 * c6 + x16 * c8))
        .add_alike((q4 * c4).scaled(2.0))
        .add_alike((q * c2).scaled(2.0))
        .add_alike(N::Narrow::from_double(1.0));
    (landen.mean * numerator).quotient(denominator)
}
