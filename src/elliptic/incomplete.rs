//! Incomplete integrals of the first and second kind.

use super::carlson;
use super::kernel;
use super::modulus::{Modulus, PI};
use super::parameter::Parameter;
use crate::double_double::DoubleDouble as Dd;
use crate::error::{Error, Result, finite};

/// An angle as a multiple of π and a rest of at most π/2, with the sine and cosine of the rest to 106 bits.
pub(super) struct Angle {
    pub(super) halves: f64,
    pub(super) negative: bool,
    pub(super) sine: Dd,
    pub(super) cosine: Dd,
}

/// What π to 106 bits leaves over.
const PI_REST: f64 = -2.994_769_809_718_339_7e-33;

impl Angle {
    pub(super) fn new(phi: f64) -> Result<Self> {
        let phi = finite("angle phi", phi)?;
        const GREATEST: f64 = 9_007_199_254_740_992.0;
        if phi.abs() > GREATEST {
            return Err(Error::OutOfRange {
                quantity: "angle phi",
                value: phi,
                least: -GREATEST,
                greatest: GREATEST,
            });
        }
        let less = |x: Dd, halves: f64| {
            x.subtract(Dd::product(halves, PI.high()))
                .subtract(Dd::product(halves, PI.low()))
                .subtract(Dd::from(halves * PI_REST))
        };
        let mut halves = (phi / core::f64::consts::PI).round();
        let mut rest = less(Dd::from(phi), halves);
        // The quotient may be rounded to the wrong side of a quarter turn: there the rest itself decides.
        let beyond = |rest: Dd| {
            let size = if rest.high() < 0.0 {
                rest.negated()
            } else {
                rest
            };
            less(size, 0.5).value() > 0.0
        };
        if beyond(rest) {
            halves += 1.0_f64.copysign(rest.high());
            rest = less(Dd::from(phi), halves);
        }
        let negative = rest.high() < 0.0;
        if negative {
            rest = rest.negated();
        }
        let (sine, cosine) = if rest.high() <= core::f64::consts::FRAC_PI_4 {
            sine_cosine(rest)
        } else {
            // Both from the angle itself, so that the cosine has all its digits next to a quarter turn.
            let other = less(
                Dd::from(phi.abs()),
                halves.abs() + if negative == (phi > 0.0) { -0.5 } else { 0.5 },
            );
            let other = if other.high() < 0.0 {
                other.negated()
            } else {
                other
            };
            let (sine, cosine) = sine_cosine(other);
            (cosine, sine)
        };
        Ok(Self {
            halves,
            negative,
            sine,
            cosine,
        })
    }

    /// cos² + mc sin².
    pub(super) fn delta2(&self, parameter: Parameter) -> Dd {
        let s2 = self.sine.multiply(self.sine);
        self.cosine
            .multiply(self.cosine)
            .add(parameter.mc_dd().multiply(s2))
    }

    /// The value at the rest with its sign, and what each multiple of π adds.
    pub(super) fn assemble(&self, at_rest: Dd, half_period: impl FnOnce() -> Dd) -> f64 {
        let signed = if self.negative {
            at_rest.negated()
        } else {
            at_rest
        };
        if self.halves == 0.0 {
            return signed.value();
        }
        let half = half_period();
        let size = half.high() * self.halves;
        if size.is_infinite() {
            return size;
        }
        half.multiply(Dd::from(self.halves)).add(signed).value()
    }
}

/// Sine and cosine of 0 ≤ x ≤ π/4 by their series.
fn sine_cosine(x: Dd) -> (Dd, Dd) {
    let x2 = x.multiply(x).negated();
    let (mut sine, mut cosine) = (Dd::from(1.0), Dd::from(1.0));
    // From the inside out; the first term left out is 10⁻³⁴.
    for k in (1..=15).rev() {
        let k = f64::from(k);
        let next = |sum: Dd, divisor: f64| {
            let term = kernel::quotient(kernel::product(sum, x2), Dd::from(divisor));
            let (high, low) = kernel::ordered_sum(1.0, term.high());
            Dd::new(high, low + term.low())
        };
        sine = next(sine, 2.0 * k * (2.0 * k + 1.0));
        cosine = next(cosine, 2.0 * k * (2.0 * k - 1.0));
    }
    (sine.multiply(x), cosine)
}

/// F(φ) = ∫₀^φ dθ/√(1 − m sin²θ) at any angle, odd in φ, F(φ + π) = F(φ) + 2K; the inverse of am.
///
/// The multiple of π is taken off with 160 bits, and cos φ has all its digits next to quarter turns. Infinite at m = 1
/// beyond π/2.
///
/// Error 0.38 ε at most of 85 rows: φ from 10⁻³⁰⁰ to 10⁶ and at successive floats next to multiples of π/2, mc to 10⁻³⁰⁰ and 0.
/// Cost 2 µs. Source: Digital Library of Mathematical Functions, 19.25.5.
///
/// # Errors
///
/// If φ is not finite or beyond 2⁵³.
pub fn incomplete_first(phi: f64, parameter: Parameter) -> Result<f64> {
    let angle = Angle::new(phi)?;
    Ok(angle.assemble(first(&angle, parameter), || {
        Modulus::new(parameter).quarter_period_dd().scaled(2.0)
    }))
}

fn first(angle: &Angle, parameter: Parameter) -> Dd {
    if angle.sine.value() == 0.0 {
        return angle.sine;
    }
    let c2 = angle.cosine.multiply(angle.cosine);
    let f = carlson::first(c2, angle.delta2(parameter), Dd::from(1.0));
    angle.sine.multiply(f)
}

/// E(φ) = ∫₀^φ √(1 − m sin²θ) dθ at any angle, odd in φ, E(φ + π) = E(φ) + 2E; at m = 1 a staircase of sines.
///
/// Error 0.37 ε at most of 85 rows, as for [`incomplete_first`]. Cost 4 µs. Source: Digital Library of Mathematical
/// Functions, 19.25.10, of which all terms have one sign.
///
/// # Errors
///
/// If φ is not finite or beyond 2⁵³.
pub fn incomplete_second(phi: f64, parameter: Parameter) -> Result<f64> {
    let angle = Angle::new(phi)?;
    let e = second(&angle, parameter);
    Ok(angle.assemble(e, || super::complete::second(parameter).scaled(2.0)))
}

fn second(angle: &Angle, parameter: Parameter) -> Dd {
    let (s, c) = (angle.sine, angle.cosine);
    let (m, mc) = (parameter.m_dd(), parameter.mc_dd());
    if s.value() == 0.0 || mc.value() == 0.0 {
        return s;
    }
    let c2 = c.multiply(c);
    let delta2 = angle.delta2(parameter);
    let f = carlson::first(c2, delta2, Dd::from(1.0));
    let d = carlson::second(c2, Dd::from(1.0), delta2).divide(Dd::from(3.0));
    let s2 = s.multiply(s);
    // All terms positive (Digital Library of Mathematical Functions 19.25.10).
    mc.multiply(s)
        .multiply(f.add(m.multiply(s2).multiply(d)))
        .add(m.multiply(s).multiply(c).divide(delta2.square_root()))
}
