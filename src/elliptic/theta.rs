//! Theta functions of complex arguments u + iη, of which the angles of the exact tops are made (tutorial 6.8, 7.2).

use super::kernel::select;
use super::landen::Landen;
use crate::precise::{Number, Words};

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
        let one = |part: usize, k: usize| select(mask, self.odd[part][k], self.even[part][k]);
        [
            [one(0, 0), one(0, 1), one(0, 2), one(0, 3)],
            [one(1, 0), one(1, 1), one(1, 2), one(1, 3)],
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
