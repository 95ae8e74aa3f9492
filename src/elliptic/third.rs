//! Integrals of the third kind.

use super::carlson;
use super::incomplete::Angle;
use super::modulus::Modulus;
use super::parameter::Parameter;
use crate::double_double::DoubleDouble as Dd;
use crate::error::{Error, Result, finite};

/// The characteristic n of Π together with its complement nc = 1 − n.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Characteristic {
    n: Dd,
    nc: Dd,
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
        let defect = Dd::sum(n, nc).subtract(Dd::from(1.0)).value();
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

    /// The characteristic n.
    pub fn n(self) -> f64 {
        self.n.value()
    }

    /// The complement nc = 1 − n.
    pub fn nc(self) -> f64 {
        self.nc.value()
    }
}

/// Π(n) = ∫₀^{π/2} dθ/((1 − n sin²θ)√(1 − m sin²θ)); the principal value for n > 1.
///
/// # Errors
///
/// At n = 1, where it is infinite.
pub fn complete_third(characteristic: Characteristic, parameter: Parameter) -> Result<f64> {
    Ok(complete_third_dd(characteristic, parameter)?.value())
}

fn complete_third_dd(characteristic: Characteristic, parameter: Parameter) -> Result<Dd> {
    incomplete_part(
        Dd::from(1.0),
        Dd::from(0.0),
        parameter.mc_dd(),
        characteristic,
        parameter,
    )
}

/// Π(φ, n) = ∫₀^φ dθ/((1 − n sin²θ)√(1 − m sin²θ)); the principal value where n sin² passes 1.
///
/// # Errors
///
/// If φ is not finite or beyond 2⁵³, or if n sin²φ = 1.
pub fn incomplete_third(
    phi: f64,
    characteristic: Characteristic,
    parameter: Parameter,
) -> Result<f64> {
    let angle = Angle::new(phi)?;
    let rest = incomplete_part(
        angle.sine,
        angle.cosine,
        angle.delta2(parameter),
        characteristic,
        parameter,
    )?;
    let half = if angle.halves == 0.0 {
        Dd::from(0.0)
    } else {
        complete_third_dd(characteristic, parameter)?.scaled(2.0)
    };
    Ok(angle.assemble(rest, || half))
}

fn incomplete_part(
    s: Dd,
    c: Dd,
    delta2: Dd,
    characteristic: Characteristic,
    parameter: Parameter,
) -> Result<Dd> {
    if s.value() == 0.0 {
        return Ok(s);
    }
    let Characteristic { n, nc } = characteristic;
    let (m, mc) = (parameter.m_dd(), parameter.mc_dd());
    let one = Dd::from(1.0);
    let three = Dd::from(3.0);
    let (s2, c2) = (s.multiply(s), c.multiply(c));
    let s3 = s2.multiply(s);
    let first = || {
        if c.value() == 0.0 {
            Modulus::new(parameter).quarter_period_dd()
        } else {
            s.multiply(carlson::first(c2, delta2, one))
        }
    };
    let p = c2.add(nc.multiply(s2));
    if p.value() == 0.0 {
        return Err(Error::Condition {
            condition: "n sin² phi must not be 1, where the integral of the third kind is infinite",
            value: n.value(),
        });
    }
    if delta2.value() == 0.0 {
        return Ok(Dd::from(if p.value() > 0.0 {
            f64::INFINITY
        } else {
            f64::NEG_INFINITY
        }));
    }
    if n.value() < 0.0 {
        // To the characteristic (m − n)/(1 − n) between m and 1.
        let q = c2.add(mc.multiply(s2).divide(nc));
        let weight = n.negated().divide(nc);
        let tail = mc
            .multiply(s3)
            .divide(nc)
            .divide(three)
            .multiply(carlson::third(c2, delta2, one, q));
        let arc = s
            .multiply(c)
            .multiply(carlson::elementary(delta2, p.multiply(q)));
        return Ok(first().divide(nc).add(weight.multiply(arc.add(tail))));
    }
    if p.value() > 0.0 {
        let tail = n.multiply(s3).divide(three);
        return Ok(first().add(tail.multiply(carlson::third(c2, delta2, one, p))));
    }
    // To the characteristic m/n between 0 and m.
    let ratio = m.divide(n);
    let q = c2.add(one.subtract(ratio).multiply(s2));
    let tail = ratio
        .multiply(s3)
        .divide(three)
        .multiply(carlson::third(c2, delta2, one, q));
    let arc = if c.value() == 0.0 {
        Dd::from(0.0)
    } else {
        s.multiply(carlson::elementary(c2.multiply(delta2), p.multiply(q)))
    };
    Ok(arc.subtract(tail))
}
