//! The angle by which a free top turns about its angular momentum (tutorial 6.8): theta functions instead of an integral.
//!
//! Let axis 3 be the one whose component of L keeps its sign (that of dn), let P(L) be the shortest rotation that carries L
//! onto it, and write the attitude as a turn by ψ about L after P(L). Then ψ' = 2E/|L| − (1 − cos θ) φ', an elliptic integral of
//! the third kind. With P₁, P₂, P₃ the amplitudes of cn, sn, dn, the elevation of L at sn = 0 is the amplitude of η for
//! the complementary modulus: sn η = P₃/|L|, cn η = P₁/|L|, dn η = P₂/|L|; and ξ = K′ − η depends on the moments alone.
//! Jacobi's transformation of the integral into theta functions leaves
//!
//! ψ = ν t + arg Z(u) − arg (P₁ cn u + i P₂ sn u),
//!
//! where Z is ϑ₄(z + iw) for m ≤ 1/2, z + iw = π(u + iη)/(2K), and ϑ₂(v − ix), v − ix = π(η − iu)/(2K′), beyond. The rate is
//! |L|/I₂, that of a body upright on its middle axis, and a theta quotient that vanishes at the separatrix: nothing
//! is left that could cancel. (C. G. J. Jacobi, Sur la rotation d'un corps, 1849; that the rate is |L|/I₂ and a theta
//! quotient follows from his formulas at u = K, where L₁ = 0.)

use crate::elliptic::Side;
use crate::elliptic::descent::Descent;
use crate::elliptic::landen::Landen;
use crate::elliptic::local::{Local, Place};
use crate::elliptic::theta::{DualTheta, Elevation, Exponentials, Which, dual_excess, polynomial};
use crate::precise::{DoubleDouble, Number, RIGHT_ANGLE, Words};

/// Below this a square underflows; only needles of an aspect of 10⁻⁷⁰ come near.
const TINY: f64 = 1e-150;

/// Everything about ψ that does not depend on time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Turning {
    /// By how much ψ lags behind ν t after each quarter period, in radians.
    pub(super) lag: DoubleDouble,
    /// dψ/du less |L|/(I₂ λ): what the theta functions add to the rate, sign included.
    pub(super) excess: DoubleDouble,
    /// P₁/P₂.
    pub(super) aspect: f64,
    pub(super) theta: Theta,
}

/// Z as polynomials: real part, and imaginary part over the odd factor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Theta {
    /// In sin² z.
    Circular { real: [f64; 4], imaginary: [f64; 3] },
    /// In 4√q′ sinh² x.
    Hyperbolic(DualTheta),
}

impl Turning {
    pub(super) fn new<N: Number>(
        descent: &Descent<N>,
        elevation: &Elevation<N>,
        aspect: f64,
    ) -> Self {
        match descent.side() {
            Side::Circular => {
                let exponentials = elevation.exponentials(&descent.landen, descent.m);
                Self::circular(&descent.landen, elevation.which, exponentials, aspect)
            }
            Side::Hyperbolic => Self::hyperbolic(&descent.landen, elevation, descent.mc, aspect),
        }
    }

    /// For m ≤ 1/2.
    #[inline(always)]
    pub(super) fn circular<N: Number>(
        landen: &Landen<N>,
        which: Which,
        exponentials: Exponentials<N::Narrow>,
        aspect: f64,
    ) -> Self {
        let q = landen.nome;
        let Exponentials {
            rho,
            epsilon,
            sinh,
            growth,
            ..
        } = exponentials;
        let one_less_rho = match which {
            Which::Xi => 2.0 * sinh.value() / growth.value(),
            Which::Eta => 1.0 - rho.value(),
        };
        let excess = circular_excess(landen, rho, epsilon);
        let (q, rho, epsilon) = (q.value(), rho.value(), epsilon.value());
        // ϑ₄(iw) with the factor 1 − ρ in front: it vanishes with it.
        let (x, r2) = (q * epsilon, rho * rho);
        let (g1, g2, g3) = (1.0 + rho + r2, rho * r2 + r2 * r2, r2 * r2 * (rho + r2));
        let (q2, q4) = (q * q, q * q * (q * q));
        let at_zero =
            one_less_rho * (1.0 - x * (g1 - q2 * x * ((g1 + g2) - q4 * x * (g1 + g2 + g3))));
        // (−1)ⁿ (q^{n²−n} ρⁿ ± q^{n²} εⁿ).
        let (up2, down2) = (q2 * r2, q2 * (x * x));
        let (up3, down3) = (q4 * up2 * rho, q4 * down2 * x);
        let (a1, b1) = (-(rho + x), -(rho - x));
        let (a2, b2) = (up2 + down2, up2 - down2);
        let (a3, b3) = (-(up3 + down3), -(up3 - down3));
        Self {
            lag: RIGHT_ANGLE,
            excess: excess.two(),
            aspect,
            theta: Theta::Circular {
                real: [
                    at_zero,
                    -2.0 * a1 - 8.0 * a2 - 18.0 * a3,
                    8.0 * a2 + 48.0 * a3,
                    -32.0 * a3,
                ],
                imaginary: [
                    -(2.0 * b1 + 4.0 * b2 + 6.0 * b3),
                    8.0 * b2 + 32.0 * b3,
                    -32.0 * b3,
                ],
            },
        }
    }

    /// For m > 1/2, the separatrix included.
    fn hyperbolic<N: Number>(
        landen: &Landen<N>,
        elevation: &Elevation<N>,
        mc: N,
        aspect: f64,
    ) -> Self {
        let (sine, cosine) = elevation.angle(landen, mc);
        Self {
            lag: N::Narrow::angle(sine, cosine).two(),
            excess: -dual_excess(landen, sine, cosine).two(),
            aspect,
            theta: Theta::Hyperbolic(DualTheta::new(
                landen.nome.value(),
                sine.value(),
                cosine.value(),
            )),
        }
    }

    /// (cos, sin) of half of arg Z − arg (P₁ cn + i P₂ sn), with the turns by the quarter periods taken off both; not normalised.
    pub(super) fn half_angle(&self, place: &Place, sn: f64, cn: f64) -> (f64, f64) {
        let (real, imaginary) = self.theta(place);
        let across = self.aspect * cn;
        let (x, y) = match (place.quarters as i64) & 3 {
            0 => (across, sn),
            1 => (sn, -across),
            2 => (-across, -sn),
            _ => (-sn, across),
        };
        // Z times the conjugate: both arguments have the same sign, so the difference stays within a right angle.
        let (along, aside) = (real * x + imaginary * y, imaginary * x - real * y);
        let largest = along.abs().max(aside.abs());
        let (along, aside) = if largest >= TINY {
            (along, aside)
        } else if largest > 0.0 {
            (along / largest, aside / largest)
        } else {
            (1.0, 0.0)
        };
        let length = (along * along + aside * aside).sqrt();
        (length + along, aside)
    }

    fn theta(&self, place: &Place) -> (f64, f64) {
        match (&self.theta, &place.local) {
            (Theta::Circular { real, imaginary }, Local::Circular { sine, cosine }) => {
                let s2 = sine * sine;
                (
                    polynomial(real, s2),
                    sine * cosine * polynomial(imaginary, s2),
                )
            }
            (Theta::Hyperbolic(dual), Local::Hyperbolic(crest)) => dual.at(place.quarters, crest),
            // The modulus and ψ are prepared by the same decision.
            _ => (1.0, 0.0),
        }
    }
}

/// +(π/2K) Σ 4n q^{n²} sinh 2nw / ϑ₃(iw).
#[inline(always)]
fn circular_excess<N: Number>(landen: &Landen<N>, rho: N::Narrow, epsilon: N::Narrow) -> N::Narrow {
    let q = landen.nome;
    let q2 = q * q;
    let (up1, down1) = (rho, q * epsilon);
    let (up2, down2) = (q2 * (rho * rho), q2 * (down1 * down1));
    let up3 = up2 * up1 * (q2 * q2);
    let down3 = down2 * down1 * (q2 * q2);
    let (x, r, e) = (q.leading(), rho.leading(), epsilon.leading());
    let x3 = x * x * x;
    let up4 = up3.leading() * x3 * x3 * r;
    let down4 = down3.leading() * x3 * x3 * x * e;
    let half = N::Narrow::from_double(4.0 * (up4 - down4))
        .add_alike(up3.add_alike(-down3) * N::Narrow::from_double(3.0))
        .add_alike(up2.add_alike(-down2).scaled(2.0))
        .add_alike(up1.add_alike(-down1));
    let denominator = N::Narrow::from_double(up4 + down4)
        .add_alike(up3.add_alike(down3))
        .add_alike(up2.add_alike(down2))
        .add_alike(up1.add_alike(down1))
        .add_alike(N::Narrow::from_double(1.0));
    (landen.mean * half.scaled(2.0)).quotient(denominator)
}
