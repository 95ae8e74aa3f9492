//! Inverse Jacobi functions.

use super::carlson;
use super::parameter::Parameter;
use crate::double_double::DoubleDouble as Dd;
use crate::error::{Error, Result, finite};

fn within(quantity: &'static str, value: f64, least: f64) -> Result<f64> {
    let value = finite(quantity, value)?;
    if (least..=1.0).contains(&value) {
        Ok(value)
    } else {
        Err(Error::OutOfRange {
            quantity,
            value,
            least,
            greatest: 1.0,
        })
    }
}

fn complement(x: f64) -> Dd {
    Dd::difference(1.0, x).multiply(Dd::sum(1.0, x))
}

/// The u in −K…K with sn u = x.
///
/// # Errors
///
/// If x is not finite or lies outside −1…1.
pub fn inverse_sn(x: f64, parameter: Parameter) -> Result<f64> {
    let x = within("value of sn", x, -1.0)?;
    let c2 = complement(x);
    let s2 = Dd::product(x, x);
    Ok(from_squares(Dd::from(x), s2, c2, parameter))
}

/// The u in 0…2K with cn u = x.
///
/// # Errors
///
/// If x is not finite or lies outside −1…1.
pub fn inverse_cn(x: f64, parameter: Parameter) -> Result<f64> {
    let x = within("value of cn", x, -1.0)?;
    let s2 = complement(x);
    let u = from_squares(s2.square_root(), s2, Dd::product(x, x), parameter);
    Ok(if x < 0.0 {
        2.0 * super::complete_first(parameter) - u
    } else {
        u
    })
}

/// The u in 0…K with dn u = x.
///
/// # Errors
///
/// If x is not finite or lies outside √mc…1.
pub fn inverse_dn(x: f64, parameter: Parameter) -> Result<f64> {
    let least = parameter.mc().sqrt();
    let x = within("value of dn", x, least)?;
    if parameter.m() == 0.0 {
        return Ok(0.0);
    }
    let m = parameter.m_dd();
    let s2 = complement(x).divide(m);
    let c2 = Dd::product(x, x).subtract(parameter.mc_dd()).divide(m);
    let c2 = if c2.value() < 0.0 { Dd::from(0.0) } else { c2 };
    Ok(from_squares(s2.square_root(), s2, c2, parameter))
}

fn from_squares(s: Dd, s2: Dd, c2: Dd, parameter: Parameter) -> f64 {
    if s.value() == 0.0 {
        return s.value();
    }
    let delta2 = c2.add(parameter.mc_dd().multiply(s2));
    if delta2.value() == 0.0 {
        return f64::INFINITY.copysign(s.value());
    }
    s.multiply(carlson::first(c2, delta2, Dd::from(1.0)))
        .value()
}
