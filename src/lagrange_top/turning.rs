//! The two Cayley–Klein parameters of Lagrange's top, each one theta function (tutorial 7.2).
//!
//! α = cos(θ/2) e^{i(φ+ψ)/2} and β = sin(θ/2) e^{i(φ−ψ)/2} have |α|² = (1 + h)/2 and |β|² = (1 − h)/2, where h moves between h₁
//! and h₂ like sn². So |α| vanishes at a complex place u = ±iη only, |β| at u = K ± iη′, and Jacobi's
//! integrals of the third kind become
//!
//! α ∝ ϑ₁(π(u ± iη)/2K) e^{iμt}, β ∝ ϑ₂(π(u ± iη′)/2K) e^{iμ′t}.
//!
//! Through the upright and the hanging position nothing happens to them: there one of the two is zero, and passes on.

use crate::elliptic::Side;
use crate::elliptic::descent::Descent;
use crate::elliptic::landen::Landen;
use crate::elliptic::theta::{Elevation, Exponentials, Theta, Which, dual_excess};
use crate::precise::{DoubleDouble, Number, Words};

/// ϑ₁(π(u + iη)/2K), or its conjugate, without the factor that grows with η.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Parameter {
    /// 1, or −1 for the conjugate.
    pub(super) sense: f64,
    /// By how much the argument falls with each quarter period beyond what the local expansion shows, radians.
    pub(super) lag: DoubleDouble,
    /// d arg/du at u = K.
    pub(super) slope: DoubleDouble,
    /// On the circular side the second pair of polynomials is that of the derivatives.
    pub(super) theta: Theta,
}

/// A complex number.
pub(super) type Complex = nalgebra::Complex<f64>;

impl Parameter {
    /// Of ϑ₁(π(u + iη)/2K), or of its conjugate if `sense` is −1.
    pub(super) fn new<N: Number>(
        descent: &Descent<N>,
        elevation: &Elevation<N>,
        sense: f64,
    ) -> Self {
        match descent.side() {
            Side::Circular => Self::circular(&descent.landen, elevation, descent.m, sense),
            Side::Hyperbolic => Self::hyperbolic(&descent.landen, elevation, descent.mc, sense),
        }
    }

    /// For m ≤ 1/2.
    fn circular<N: Number>(landen: &Landen<N>, elevation: &Elevation<N>, m: N, sense: f64) -> Self {
        let one = N::Narrow::from_double(1.0);
        let q = landen.nome;
        let Exponentials {
            rho,
            epsilon,
            sinh,
            decay,
            ..
        } = elevation.exponentials(landen, m);
        // 1 − ε.
        let rest = match elevation.which {
            Which::Eta => sinh.scaled(2.0) * decay,
            Which::Xi => one - epsilon,
        };
        // q^{n²} ρⁿ (1 ± ε^{2n+1}) for n = 0, 1, 2, 3.
        let square = epsilon * epsilon;
        let (e1, e3) = (epsilon, epsilon * square);
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
            one.add_alike(e1),
            factor1 * one.add_alike(e3),
            factor2 * one.add_alike(e5),
        ];
        let x = q.leading();
        let factor3 = factor2.leading() * factor1.leading() * x * x * x * x;
        let e7 = e5.leading() * square.leading();
        let (plus3, minus3) = (factor3 * (1.0 + e7), factor3 * (1.0 - e7));
        // At z = π/2: cos(2n+1)z' sums with the sign that ϑ₂ has.
        let numerator = N::Narrow::from_double(7.0 * minus3)
            .add_alike(minus[2] * N::Narrow::from_double(5.0))
            .add_alike(minus[1] * N::Narrow::from_double(3.0))
            .add_alike(minus[0]);
        let denominator = N::Narrow::from_double(plus3)
            .add_alike(plus[2])
            .add_alike(plus[1])
            .add_alike(plus[0]);
        let slope = -(landen.mean * numerator).quotient(denominator).two();
        let a = [plus[0].value(), -plus[1].value(), plus[2].value(), -plus3];
        let b = [
            minus[0].value(),
            -minus[1].value(),
            minus[2].value(),
            -minus3,
        ];
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
        let q4 = |k: usize| if k < 4 { imaginary[k] } else { 0.0 };
        let real_slope = core::array::from_fn(|k| (2 * k + 1) as f64 * real[k]);
        let imaginary_slope = core::array::from_fn(|k| {
            2.0 * (k + 1) as f64 * q4(k + 1) - (2 * k + 1) as f64 * imaginary[k]
        });
        Self {
            sense,
            lag: DoubleDouble::from(0.0),
            slope,
            theta: Theta {
                even: [real, imaginary],
                odd: [real_slope, imaginary_slope],
            },
        }
    }

    /// For m > 1/2: ϑ₂(ix − v) with v = πη/2K′ − π/2.
    fn hyperbolic<N: Number>(
        landen: &Landen<N>,
        elevation: &Elevation<N>,
        mc: N,
        sense: f64,
    ) -> Self {
        let (sine, cosine) = elevation.angle(landen, mc);
        let (s, c) = (-cosine, sine);
        Self {
            sense,
            lag: N::Narrow::angle(sine, cosine).two(),
            slope: dual_excess(landen, s, c).two(),
            theta: Theta::dual(landen.nome.value(), s.value(), c.value()),
        }
    }
}
