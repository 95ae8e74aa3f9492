//! Theta functions of real arguments as polynomials, which correct the elementary functions.

use super::landen::SMALL;
use crate::precise::quick::select;

/// Coefficients in powers of z: z = sin² on the circular side, z = 4 √q′ sinh² on the hyperbolic one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Series {
    /// Near even multiples of K; on the circular side for every argument.
    pub(super) even: Corrections,
    /// Near odd multiples of K, on the hyperbolic side only.
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
    /// The set for an even or odd number of quarter periods, by the lowest of `bits`, without a branch.
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

/// The same beyond m = 1/2 for a small nome, from `half` = √q; terms of order q³ are left out.
fn few_thetas(half: f64) -> [[f64; 4]; 4] {
    let (q, q2) = (half * half, half * half * (half * half));
    let (z, z2) = (-0.25 * half, -0.25 * half * q);
    [
        [1.0 - 3.0 * q2, 4.0 * z2, 0.0, 0.0],
        [1.0 + q2, -4.0 * z2, 0.0, 0.0],
        [1.0 + 2.0 * q, -4.0 * z, 0.0, 0.0],
        [1.0 - 2.0 * q, 4.0 * z, 0.0, 0.0],
    ]
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
        let even = if 16.0 * q < SMALL {
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
            even,
            odd: even,
            root: 0.0,
            complementary_modulus,
        }
    }

    #[inline(always)]
    pub(super) fn hyperbolic(half: f64, complementary_modulus: f64, rate: f64) -> Self {
        let thetas = if half * half < SMALL {
            few_thetas(half)
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

/// The corrections near even and near odd multiples of K; `rate` is π/(2K′).
#[inline(always)]
fn hyperbolic_corrections([t1, t2, t3, t4]: [[f64; 4]; 4], rate: f64) -> [Corrections; 2] {
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
