//! Inverse Jacobi functions.

use super::carlson;
use super::modulus::Modulus;
use super::parameter::Parameter;
use crate::error::{Error, Result, finite, within};
use crate::precise::{DoubleDouble as Dd, power_of_two_below};

fn complement(x: f64) -> Dd {
    Dd::difference(1.0, x) * Dd::sum(1.0, x)
}

/// The u in −K…K with sn u = x; ±infinity at m = 1, x = ±1.
///
/// Error 0.4 ε at most of 48 rows, x from 10⁻³⁰⁰ to the float below 1. What the rounding of x itself does to u is another
/// matter: 1/(cn dn) times that, without bound next to ±1, where [`inverse_cn`] or [`inverse_cn_sn`] should be asked.
/// Cost 0.3 µs. Source: Digital Library of Mathematical Functions, 19.25.31, 22.15.
///
/// # Errors
///
/// If x is not finite or lies outside −1…1.
pub fn inverse_sn(x: f64, parameter: Parameter) -> Result<f64> {
    let x = within("value of sn", x, -1.0, 1.0)?;
    let c2 = complement(x);
    let s2 = Dd::product(x, x);
    Ok(from_squares(Dd::from(x), s2, c2, parameter).value())
}

/// The u in 0…2K with cn u = x; infinite at m = 1, x ≤ 0.
///
/// Error 0.6 ε at most of 48 rows, x from 10⁻³⁰⁰ to the float below 1, both signs. Ill-conditioned next to ±1, as
/// [`inverse_sn`] is. Cost 1–2 µs. Source: Digital Library of Mathematical Functions, 19.25.31, 22.15.
///
/// # Errors
///
/// If x is not finite or lies outside −1…1.
pub fn inverse_cn(x: f64, parameter: Parameter) -> Result<f64> {
    let x = within("value of cn", x, -1.0, 1.0)?;
    let s2 = complement(x);
    let u = from_squares(s2.square_root(), s2, Dd::product(x, x), parameter);
    Ok(reflected(u, x < 0.0, parameter))
}

/// `u`, or 2K − u where the cosine is negative.
fn reflected(u: Dd, negative: bool, parameter: Parameter) -> f64 {
    if !negative {
        return u.value();
    }
    let half = Modulus::new(parameter).quarter_period_dd().scaled(2.0);
    if half.high().is_infinite() {
        return half.high();
    }
    (half - u).value()
}

/// The u in −2K…2K at which (cn u, sn u) has the direction of (x, y); −2K itself is not given.
///
/// Well conditioned for every direction, where the inverses from one value alone lose half the digits next to the
/// extremes of that value. The length of (x, y) does not matter. ±infinity at m = 1, x ≤ 0.
///
/// Error: u within 0.41 of what 4 ε in y/x make. Cost 1–2 µs.
///
/// # Errors
///
/// If x or y is not finite, or both are zero.
pub fn inverse_cn_sn(x: f64, y: f64, parameter: Parameter) -> Result<f64> {
    let x = finite("x along cn", x)?;
    let y = finite("y along sn", y)?;
    let size = x.abs().max(y.abs());
    if size == 0.0 {
        return Err(Error::ZeroVector {
            quantity: "direction (cn, sn)",
        });
    }
    let unit = power_of_two_below(size);
    let (c, s) = (x / unit, y.abs() / unit);
    let u = if s == 0.0 {
        Dd::from(s)
    } else {
        let (c2, s2) = (Dd::product(c, c), Dd::product(s, s));
        let delta2 = c2 + parameter.mc_dd() * s2;
        if delta2.value() == 0.0 {
            return Ok(f64::INFINITY.copysign(y));
        }
        Dd::from(s) * carlson::first([c2, delta2, c2 + s2])
    };
    Ok(reflected(u, x < 0.0, parameter).copysign(y))
}

/// The u in 0…K with dn u = x; 0 at m = 0.
///
/// Error 0.5 ε at most of 30 rows. Ill-conditioned next to 1 and to √mc, and everywhere for small m: there
/// [`inverse_cn_sn`] should be asked. Cost 1–2 µs. Source: Digital Library of Mathematical Functions, 19.25.31, 22.15.
///
/// # Errors
///
/// If x is not finite or lies outside √mc…1.
pub fn inverse_dn(x: f64, parameter: Parameter) -> Result<f64> {
    let least = parameter.mc().sqrt();
    let x = within("value of dn", x, least, 1.0)?;
    if parameter.m() == 0.0 {
        return Ok(0.0);
    }
    let m = parameter.m_dd();
    let s2 = complement(x) / m;
    let c2 = (Dd::product(x, x) - parameter.mc_dd()) / m;
    let c2 = if c2.value() < 0.0 { Dd::from(0.0) } else { c2 };
    Ok(from_squares(s2.square_root(), s2, c2, parameter).value())
}

fn from_squares(s: Dd, s2: Dd, c2: Dd, parameter: Parameter) -> Dd {
    if s.value() == 0.0 {
        return s;
    }
    let delta2 = c2 + parameter.mc_dd() * s2;
    if delta2.value() == 0.0 {
        return Dd::from(f64::INFINITY.copysign(s.value()));
    }
    s * carlson::first([c2, delta2, Dd::from(1.0)])
}
