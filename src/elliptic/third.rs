//! Integrals of the third kind.

use super::carlson;
use super::incomplete::Angle;
use super::modulus::{Modulus, PI};
use super::parameter::Parameter;
use crate::double_double::DoubleDouble as Dd;
use crate::error::{Error, Result, finite};

/// The characteristic n of Π together with its complement nc = 1 − n: any finite n.
///
/// Next to n = 1 the integral goes as 1/√nc; there nc is what must be known. The one given is exact, the other is one
/// minus it to 106 bits.
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

    /// The characteristic n, rounded to a double.
    pub fn n(self) -> f64 {
        self.n.value()
    }

    /// The complement nc = 1 − n, rounded to a double.
    pub fn nc(self) -> f64 {
        self.nc.value()
    }
}

/// Π(n) = ∫₀^{π/2} dθ/((1 − n sin²θ)√(1 − m sin²θ)); the principal value for n > 1; infinite at m = 1.
///
/// n < 0 is carried to a characteristic between m and 1, n > 1 to one between 0 and m, so that no sum cancels; below
/// n = −10⁴⁰ it is π/(2√nc).
///
/// Error 0.46 ε at most of 118 rows: n from −10³⁰⁰ to 10³⁰⁰, nc and mc to ±10⁻³⁰⁰, n within an ulp of m. Cost 5–15 µs.
/// Source: Digital Library of Mathematical Functions, 19.7, 19.25.14; its sign of n.
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
/// At any angle: odd in φ, and each π adds 2Π(n), the principal value's period included. Infinite at m = 1 beyond π/2.
///
/// Error 0.45 ε at most of 435 rows, as for [`complete_third`] and with φ as for [`super::incomplete_first`]. Cost 5–7 µs.
/// Source: Digital Library of Mathematical Functions, 19.7, 19.25.14; its sign of n.
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

/// 2⁵⁰⁰: the arguments of R_J are multiplied with it, so that the least of them does not underflow on the way.
const SCALE: f64 = f64::from_bits((1023 + 500) << 52);

/// weight · R_J(c², Δ², 1, p), which may exceed a double next to n = 1 and m = 1 at once: then infinite.
fn weighted(weight: Dd, c2: Dd, delta2: Dd, p: Dd) -> Dd {
    // Only where p is tiny; there the weight is not. The value is the same either way.
    let scale = if p.value() < 1e-150 { SCALE } else { 1.0 };
    let third = carlson::third(
        c2.scaled(scale),
        delta2.scaled(scale),
        Dd::from(scale),
        p.scaled(scale),
    );
    let value = weight.scaled(scale).multiply(third);
    let size = value.high() * scale.sqrt();
    if size.is_infinite() {
        return Dd::from(size);
    }
    value.scaled(scale.sqrt())
}

/// Beyond this nc the integral is arctan(√nc tan φ)/√nc. With t = tan θ it is ∫ dt/((1 + nc t²) Δ); what 1/Δ has above 1
/// adds less than F(φ)/nc, and F < 760: against the whole less than 760/√nc = 8·10⁻¹⁸, so both sides agree.
const FAR_NEGATIVE: f64 = 1e40;

fn far_negative(s: Dd, c: Dd, nc: Dd) -> Dd {
    let root = nc.square_root();
    if c.value() == 0.0 {
        return PI.scaled(0.5).divide(root);
    }
    let slope = s.multiply(root).divide(c).value();
    Dd::from(slope.atan()).divide(root)
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
    if nc.value() > FAR_NEGATIVE {
        return Ok(far_negative(s, c, nc));
    }
    if n.value() < 0.0 {
        // To the characteristic (m − n)/(1 − n) between m and 1; mc/nc alone might underflow.
        let few = mc.scaled(SCALE).multiply(s2).divide(nc);
        let q = c2.scaled(SCALE).add(few);
        let weight = n.negated().divide(nc);
        let scaled = [c2.scaled(SCALE), delta2.scaled(SCALE), one.scaled(SCALE)];
        let tail = few
            .multiply(s)
            .divide(three)
            .multiply(carlson::third(scaled[0], scaled[1], scaled[2], q))
            .scaled(SCALE.sqrt());
        let arc = if c.value() == 0.0 {
            c
        } else {
            let q = q.scaled(1.0 / SCALE);
            s.multiply(c)
                .multiply(carlson::elementary(delta2, p.multiply(q)))
        };
        return Ok(first().divide(nc).add(weight.multiply(arc.add(tail))));
    }
    if p.value() > 0.0 {
        let weight = n.multiply(s2).multiply(s).divide(three);
        let tail = weighted(weight, c2, delta2, p);
        if tail.high().is_infinite() {
            return Ok(tail);
        }
        return Ok(first().add(tail));
    }
    // To the characteristic m/n between 0 and m.
    let ratio = m.divide(n);
    // 1 − m/n = (mc − nc)/n, which does not cancel: mc is not negative and nc is.
    let q = c2.add(mc.subtract(nc).divide(n).multiply(s2));
    let weight = ratio.multiply(s2).multiply(s).divide(three);
    let tail = weighted(weight, c2, delta2, q);
    if tail.high().is_infinite() {
        return Ok(tail.negated());
    }
    let arc = if c.value() == 0.0 {
        Dd::from(0.0)
    } else {
        // R_C is of degree −1/2; p may be all of what a double holds.
        let few = if p.value() < -1e200 {
            0.5_f64.powi(400)
        } else {
            1.0
        };
        let x = c2.multiply(delta2).scaled(few);
        let y = p.scaled(few).multiply(q);
        s.multiply(carlson::elementary(x, y)).scaled(few.sqrt())
    };
    Ok(arc.subtract(tail))
}
