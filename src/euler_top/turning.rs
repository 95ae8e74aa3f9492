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
use crate::elliptic::theta::{Elevation, Exponentials, Theta, Which, dual_excess};
use crate::precise::{DoubleDouble, Number, RIGHT_ANGLE, Words};

/// Everything about ψ that does not depend on time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Turning {
    /// By how much ψ lags behind ν t after each quarter period, in radians.
    pub(super) lag: DoubleDouble,
    /// dψ/du less |L|/(I₂ λ): what the theta functions add to the rate, sign included.
    pub(super) excess: DoubleDouble,
    /// P₁/P₂.
    pub(super) aspect: f64,
    /// Z.
    pub(super) theta: Theta,
}

impl Turning {
    pub(super) fn new<N: Number>(
        descent: &Descent<N>,
        elevation: &Elevation<N>,
        aspect: f64,
    ) -> Self {
        match descent.side() {
            Side::Circular => Self::circular(&descent.landen, elevation, descent.m, aspect),
            Side::Hyperbolic => Self::hyperbolic(&descent.landen, elevation, descent.mc, aspect),
        }
    }

    /// For m ≤ 1/2.
    fn circular<N: Number>(
        landen: &Landen<N>,
        elevation: &Elevation<N>,
        m: N,
        aspect: f64,
    ) -> Self {
        let q = landen.nome;
        let Exponentials {
            rho,
            epsilon,
            sinh,
            growth,
            ..
        } = elevation.exponentials(landen, m);
        let one_less_rho = match elevation.which {
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
        let real = [
            at_zero,
            -2.0 * a1 - 8.0 * a2 - 18.0 * a3,
            8.0 * a2 + 48.0 * a3,
            -32.0 * a3,
        ];
        let imaginary = [
            -(2.0 * b1 + 4.0 * b2 + 6.0 * b3),
            8.0 * b2 + 32.0 * b3,
            -32.0 * b3,
            0.0,
        ];
        Self {
            lag: RIGHT_ANGLE,
            excess: excess.two(),
            aspect,
            theta: Theta {
                even: [real, imaginary],
                odd: [real, imaginary],
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
            theta: Theta::dual(landen.nome.value(), sine.value(), cosine.value()),
        }
    }
}

/// +(π/2K) Σ 4n q^{n²} sinh 2nw / ϑ₃(iw).
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
