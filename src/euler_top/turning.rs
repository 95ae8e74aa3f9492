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

use crate::double_double::DoubleDouble;
use crate::elliptic::landen::{Landen, right_angle};
use crate::elliptic::local::{Crest, Local, Place};
use crate::extended::{Wide, angle};

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
    aspect: f64,
    theta: Theta,
}

/// Z as polynomials: real part, and imaginary part over the odd factor.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Theta {
    /// In sin² z.
    Circular { real: [f64; 4], imaginary: [f64; 3] },
    /// In 4√q′ sinh² x, next to an even and next to an odd multiple of K.
    Hyperbolic {
        even_real: [f64; 4],
        even_imaginary: [f64; 4],
        odd_real: [f64; 4],
        odd_imaginary: [f64; 3],
    },
}

/// One of the two equivalent arguments η and ξ = K′ − η, by its functions for the complementary modulus.
#[derive(Debug, Clone, Copy)]
pub(super) struct Elevation<N> {
    pub(super) which: Which,
    /// sn² = `rise`/`slope`, cn² = `run`/`slope`.
    pub(super) rise: N,
    pub(super) run: N,
    pub(super) slope: N,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Which {
    Eta,
    Xi,
}

impl Turning {
    /// For m ≤ 1/2.
    pub(super) fn circular<N: Wide>(
        landen: &Landen,
        elevation: &Elevation<N>,
        m: N,
        aspect: f64,
    ) -> Self {
        let one = DoubleDouble::from(1.0);
        let q = landen.nome;
        // sc² and dc² = 1 + m sc².
        let sc2 = elevation.rise.divide(elevation.run);
        let dc2 = one.add_alike(m.multiply(sc2).narrow());
        let sc = sc2.square_root().narrow();
        // Beyond this e^{−2x} is nothing to anything it is added to, and what follows might overflow.
        let sc = if sc.high() > 1e150 {
            DoubleDouble::from(1e150)
        } else {
            sc
        };
        let sinh = landen.hyperbolic_sine(sc, dc2.square_root());
        let exponential = sinh.add_alike(sinh.hypotenuse_with_one());
        let inverse = one.divide(exponential);
        let decay = inverse.multiply(inverse);
        // ρ = q e^{2w} and ε = e^{−2w}; for ξ in place of η they change roles. 1 − e^{−2x} = 2 sinh x · e^{−x}.
        let other = if q.high() == 0.0 {
            q
        } else {
            q.multiply(exponential).multiply(exponential)
        };
        let (rho, epsilon, one_less_rho) = match elevation.which {
            Which::Xi => (decay, other, 2.0 * sinh.value() / exponential.value()),
            Which::Eta => (other, decay, 1.0 - other.value()),
        };
        let excess = circular_excess(landen, rho, epsilon);
        let (q, rho, epsilon) = (q.value(), rho.value(), epsilon.value());
        // ϑ₄(iw) with the factor 1 − ρ in front: it vanishes with it.
        let (x, r2) = (q * epsilon, rho * rho);
        let (g1, g2, g3) = (1.0 + rho + r2, rho * r2 + r2 * r2, r2 * r2 * (rho + r2));
        let at_zero = one_less_rho
            * (1.0 - x * (g1 - (q * q) * x * ((g1 + g2) - q.powi(4) * x * (g1 + g2 + g3))));
        let pair = |n: i32| {
            let up = q.powi(n * n - n) * rho.powi(n);
            let down = q.powi(n * n) * epsilon.powi(n);
            let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
            (sign * (up + down), sign * (up - down))
        };
        let [(a1, b1), (a2, b2), (a3, b3)] = [1, 2, 3].map(pair);
        Self {
            lag: right_angle(),
            excess,
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
    pub(super) fn hyperbolic<N: Wide>(
        landen: &Landen,
        elevation: &Elevation<N>,
        mc: N,
        aspect: f64,
    ) -> Self {
        let one = DoubleDouble::from(1.0);
        let sn2 = elevation.rise.divide(elevation.slope).narrow();
        let dn2 = one.subtract(mc.narrow().multiply(sn2));
        let lesser = landen.sine(sn2.square_root(), dn2.square_root());
        let greater = one.subtract(lesser.multiply(lesser)).square_root();
        let (sine, cosine) = match elevation.which {
            Which::Eta => (lesser, greater),
            Which::Xi => (greater, lesser),
        };
        let excess = hyperbolic_excess(landen, sine, cosine);
        let lag = angle(sine, cosine);
        let (s, c) = (sine.value(), cosine.value());
        let q = landen.nome.value();
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
        let power = |whole: i32, halves: i32| q.powi(whole) * if halves == 1 { root } else { 1.0 };
        Self {
            lag,
            excess,
            aspect,
            theta: Theta::Hyperbolic {
                even_real: [
                    c + c3 * power(2, 0) + c5 * power(6, 0),
                    c3 * power(1, 1) + 3.0 * c5 * power(5, 1),
                    c5 * power(5, 0) + 5.0 * c7 * power(11, 0),
                    c7 * power(10, 1),
                ],
                even_imaginary: [
                    s + 3.0 * k3 * power(2, 0) + 5.0 * k5 * power(6, 0),
                    k3 * power(1, 1) + 5.0 * k5 * power(5, 1),
                    k5 * power(5, 0) + 7.0 * k7 * power(11, 0),
                    k7 * power(10, 1),
                ],
                odd_real: [
                    1.0 + 2.0 * (e2 * q + e4 * power(4, 0) + e6 * power(9, 0)),
                    e2 * root + 4.0 * e4 * power(3, 1) + 9.0 * e6 * power(8, 1),
                    e4 * power(3, 0) + 6.0 * e6 * power(8, 0),
                    e6 * power(7, 1),
                ],
                odd_imaginary: [
                    root * (f2 + 2.0 * f4 * power(3, 0) + 3.0 * f6 * power(8, 0)),
                    root * (f4 * power(2, 1) + 4.0 * f6 * power(7, 1)),
                    root * f6 * power(7, 0),
                ],
            },
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
        let (along, aside) = if along.abs().max(aside.abs()) < TINY {
            (along / TINY, aside / TINY)
        } else {
            (along, aside)
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
            (
                Theta::Hyperbolic {
                    even_real,
                    even_imaginary,
                    odd_real,
                    odd_imaginary,
                },
                Local::Hyperbolic(Crest { sign, wave, z }),
            ) => {
                let (sine, cosine) = (wave.sine, wave.cosine);
                let sign = 1.0_f64.copysign(f64::from_bits(*sign));
                if (place.quarters as i64) & 1 == 0 {
                    (
                        cosine * polynomial(even_real, *z),
                        sign * sine * polynomial(even_imaginary, *z),
                    )
                } else {
                    // 4√q′ sinh cosh = z cosh/sinh.
                    let product = if sine == 0.0 { 0.0 } else { z * cosine / sine };
                    (
                        polynomial(odd_real, *z),
                        sign * product * polynomial(odd_imaginary, *z),
                    )
                }
            }
            // The modulus and ψ are prepared by the same decision.
            _ => (1.0, 0.0),
        }
    }
}

/// +(π/2K) Σ 4n q^{n²} sinh 2nw / ϑ₃(iw).
fn circular_excess(landen: &Landen, rho: DoubleDouble, epsilon: DoubleDouble) -> DoubleDouble {
    let q = landen.nome;
    let q2 = q.multiply(q);
    let (up1, down1) = (rho, q.multiply(epsilon));
    let (up2, down2) = (
        q2.multiply(rho.multiply(rho)),
        q2.multiply(down1.multiply(down1)),
    );
    let up3 = up2.multiply(up1).multiply(q2.multiply(q2));
    let down3 = down2.multiply(down1).multiply(q2.multiply(q2));
    let (x, r, e) = (q.high(), rho.high(), epsilon.high());
    let x3 = x * x * x;
    let up4 = up3.high() * x3 * x3 * r;
    let down4 = down3.high() * x3 * x3 * x * e;
    let half = DoubleDouble::from(4.0 * (up4 - down4))
        .add_alike(
            up3.add_alike(down3.negated())
                .multiply(DoubleDouble::from(3.0)),
        )
        .add_alike(up2.add_alike(down2.negated()).scaled(2.0))
        .add_alike(up1.add_alike(down1.negated()));
    let denominator = DoubleDouble::from(up4 + down4)
        .add_alike(up3.add_alike(down3))
        .add_alike(up2.add_alike(down2))
        .add_alike(up1.add_alike(down1))
        .add_alike(DoubleDouble::from(1.0));
    landen.mean.multiply(half.scaled(2.0)).divide(denominator)
}

/// −(π/2K′) Σ 4n q′^{n²} sin 2nv / ϑ₃(v).
fn hyperbolic_excess(landen: &Landen, sine: DoubleDouble, cosine: DoubleDouble) -> DoubleDouble {
    let q = landen.nome;
    let q2 = q.multiply(q);
    let q4 = q2.multiply(q2);
    let s2 = sine.multiply(cosine).scaled(2.0);
    let c2 = cosine.subtract(sine).multiply(cosine.add(sine));
    let s4 = s2.multiply(c2).scaled(2.0);
    let c4 = c2.subtract(s2).multiply(c2.add(s2));
    let (x, s2v, c2v, s4v, c4v) = (q.value(), s2.value(), c2.value(), s4.value(), c4.value());
    let (s6, c6) = (s2v * c4v + c2v * s4v, c2v * c4v - s2v * s4v);
    let (s8, c8) = (2.0 * s4v * c4v, c4v * c4v - s4v * s4v);
    let numerator = DoubleDouble::from(12.0 * x.powi(9) * s6 + 16.0 * x.powi(16) * s8)
        .add(q4.multiply(s4).scaled(8.0))
        .add(q.multiply(s2).scaled(4.0));
    let denominator = DoubleDouble::from(2.0 * (x.powi(9) * c6 + x.powi(16) * c8))
        .add(q4.multiply(c4).scaled(2.0))
        .add(q.multiply(c2).scaled(2.0))
        .add(DoubleDouble::from(1.0));
    landen
        .mean
        .multiply(numerator)
        .divide(denominator)
        .negated()
}

#[inline(always)]
fn polynomial<const N: usize>(coefficients: &[f64; N], x: f64) -> f64 {
    let mut sum = coefficients[N - 1];
    for i in (0..N - 1).rev() {
        sum = sum * x + coefficients[i];
    }
    sum
}
