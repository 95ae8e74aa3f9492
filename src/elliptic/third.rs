//! Integrals of the third kind.

use super::incomplete::{Kind, at_angle, complete};
use super::parameter::Parameter;
use crate::error::{Error, Result, finite};
use crate::precise::DoubleDouble as Dd;

/// The factor n of sin² in an integral, together with its complement nc = 1 − n: any finite n.
///
/// It is the characteristic of Π, and a parameter m outside 0…1 of F, E and Π. (Within, a [`Parameter`] will do
/// in its place.) Next to n = 1 an integral goes as 1/√nc or ln nc; there nc is what must be known. The one given is exact, the
/// other is one minus it to 106 bits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Characteristic {
    pub(super) n: Dd,
    pub(super) nc: Dd,
}

impl Characteristic {
    /// From both n and nc; the one of lesser size is believed.
    ///
    /// # Errors
    ///
    /// If one is not finite, or if n + nc differs from 1 by more than 4 ε of the greater.
    pub fn new(n: f64, nc: f64) -> Result<Self> {
        let n = finite("characteristic n", n)?;
        let nc = finite("complementary characteristic nc", nc)?;
        let defect = (Dd::sum(n, nc) - Dd::from(1.0)).value();
        if defect.abs() > 4.0 * f64::EPSILON * n.abs().max(nc.abs()) {
            return Err(Error::Condition {
                condition: "n + nc must be 1 to within 4 eps",
                value: n + nc,
            });
        }
        if n.abs() <= nc.abs() {
            Self::from_characteristic(n)
        } else {
            Self::from_complement(nc)
        }
    }

    /// From n, taken as exact.
    ///
    /// # Errors
    ///
    /// If n is not finite.
    pub fn from_characteristic(n: f64) -> Result<Self> {
        let n = finite("characteristic n", n)?;
        Ok(Self {
            n: Dd::from(n),
            nc: Dd::difference(1.0, n),
        })
    }

    /// From nc = 1 − n, taken as exact.
    ///
    /// # Errors
    ///
    /// If nc is not finite.
    pub fn from_complement(nc: f64) -> Result<Self> {
        let nc = finite("complementary characteristic nc", nc)?;
        Ok(Self {
            n: Dd::difference(1.0, nc),
            nc: Dd::from(nc),
        })
    }

    /// The characteristic n, rounded to a double.
    pub fn n(self) -> f64 {
        self.n.value()
    }

    /// The complement nc = 1 − n, rounded to a double.
    pub fn nc(self) -> f64 {
        self.nc.value()
    }
}

impl From<Parameter> for Characteristic {
    fn from(parameter: Parameter) -> Self {
        Self {
            n: parameter.m_dd(),
            nc: parameter.mc_dd(),
        }
    }
}

/// Π(n) = ∫₀^{π/2} dθ/((1 − n sin²θ)√(1 − m sin²θ)) for m ≤ 1; the principal value for n > 1; infinite at m = 1, and
/// where it exceeds the greatest double.
///
/// n < 0 and n > 1 are carried to other characteristics, so that no sum cancels.
///
/// Error 0.46 ε at most of 160 rows: any n, nc and mc to ±10⁻³⁰⁰, n within an ulp of m. Cost 180–320 ns for n < 1; beyond,
/// where it is a principal value, 4–9 µs; and up to 0.1 ms where one of the
/// numbers is beyond 10^±60.
/// Source: Bulirsch (1969) for n < 1; Digital Library of Mathematical Functions, 19.7, 19.25.14; its sign of n.
///
/// # Errors
///
/// At n = 1, where it is infinite, and for m > 1, where it is not real.
pub fn complete_third(
    characteristic: Characteristic,
    parameter: impl Into<Characteristic>,
) -> Result<f64> {
    Ok(complete(Kind::Third(characteristic), parameter.into())?.value())
}

/// Π(φ, n) = ∫₀^φ dθ/((1 − n sin²θ)√(1 − m sin²θ)) for any n and m; the principal value where n sin² passes 1.
///
/// Odd in φ, and for m ≤ 1 at any angle: each π adds 2Π(n), the principal value's period included. For m > 1 as far as it is real,
/// m sin²φ ≤ 1. Infinite at m = 1 beyond π/2.
///
/// Error 0.47 ε at most of 560 rows, as for [`complete_third`] and with φ as for [`super::incomplete_first`]. Cost 1.5–1.7 µs within a quarter turn for n < 1; 4–9 µs
/// for principal values.
/// Source: Digital Library of Mathematical Functions, 19.7, 19.25.14; its sign of n.
///
/// # Errors
///
/// If φ is not finite or beyond 2⁵³, if n sin²φ = 1, or if m sin² exceeds 1 on the way to φ.
pub fn incomplete_third(
    phi: f64,
    characteristic: Characteristic,
    parameter: impl Into<Characteristic>,
) -> Result<f64> {
    at_angle(Kind::Third(characteristic), phi, parameter.into())
}
