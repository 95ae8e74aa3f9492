//! Complete integrals of the first and second kind.

use super::carlson;
use super::incomplete::{self, Kind, real};
use super::third::Characteristic;
use crate::error::Result;
use crate::precise::{DoubleDouble as Dd, Extended, Number};

/// K = ∫₀^{π/2} dθ/√(1 − m sin²θ) for m ≤ 1, the quarter period; π/2 at m = 0, ln(4/√mc) for mc → 0, infinite at mc = 0.
///
/// An m below 0 is given as a [`Characteristic`].
///
/// Error 0.43 ε at most of 49 rows, mc to 5·10⁻³²⁴, m to −1.8·10³⁰⁸. Cost 80–280 ns: it is [`Modulus::new`](super::Modulus::new).
///
/// Source: Digital Library of Mathematical Functions, 19.2, 19.8.
///
/// ```
/// use spinning_bodies::elliptic::{Parameter, complete_first};
/// assert_eq!(complete_first(Parameter::from_parameter(0.0)?)?, std::f64::consts::FRAC_PI_2);
/// // Gauss's lemniscate: K(1/2) = Γ(1/4)²/(4 √π).
/// assert_eq!(complete_first(Parameter::from_parameter(0.5)?)?, 1.854_074_677_301_371_9);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
///
/// # Errors
///
/// For m > 1, where it is not real.
pub fn complete_first(parameter: impl Into<Characteristic>) -> Result<f64> {
    Ok(incomplete::complete(Kind::First, parameter.into())?.value())
}

/// E = ∫₀^{π/2} √(1 − m sin²θ) dθ for m ≤ 1, π/2 at m = 0 and 1 at m = 1; formed as B + mc D, where nothing cancels.
///
/// Error 0.40 ε at most of 49 rows. Cost 3 µs. Source: Digital Library of Mathematical Functions, 19.2, 19.25.
///
/// ```
/// use spinning_bodies::elliptic::{Parameter, complete_first, complete_second};
/// // Legendre's relation: E K′ + E′ K − K K′ = π/2.
/// let p = Parameter::from_parameter(0.3)?;
/// let (k, e) = (complete_first(p)?, complete_second(p)?);
/// let (l, f) = (complete_first(p.exchanged())?, complete_second(p.exchanged())?);
/// assert!((e * l + f * k - k * l - std::f64::consts::FRAC_PI_2).abs() < 2e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
///
/// # Errors
///
/// As for [`complete_first`].
pub fn complete_second(parameter: impl Into<Characteristic>) -> Result<f64> {
    Ok(incomplete::complete(Kind::Second, parameter.into())?.value())
}

/// E = B + mc D, where both terms are positive.
pub(super) fn second(parameter: Characteristic) -> Dd {
    if parameter.nc() == 0.0 {
        return Dd::from(1.0);
    }
    b_dd(parameter) + parameter.nc * d_dd(parameter)
}

/// D = ∫₀^{π/2} sin²θ/√(1 − m sin²θ) dθ = (K − E)/m for m ≤ 1, without that difference; π/4 at m = 0, infinite at mc = 0.
///
/// Error 0.45 ε at most of 49 rows, m and mc to 10⁻³⁰⁰ and less. Cost 2 µs. Source: R_D/3, Digital Library of
/// Mathematical Functions, 19.25.
///
/// # Errors
///
/// As for [`complete_first`].
pub fn complete_d(parameter: impl Into<Characteristic>) -> Result<f64> {
    let parameter = real(parameter.into())?;
    if parameter.nc() == 0.0 {
        return Ok(f64::INFINITY);
    }
    Ok(d_dd(parameter).value())
}

/// B = ∫₀^{π/2} cos²θ/√(1 − m sin²θ) dθ = (E − mc K)/m for m ≤ 1, without that difference; π/4 at m = 0, 1 at m = 1.
///
/// Error 0.35 ε at most of 49 rows. Cost 2 µs. Source: mc R_D/3, Digital Library of Mathematical Functions, 19.25.
///
/// # Errors
///
/// As for [`complete_first`].
pub fn complete_b(parameter: impl Into<Characteristic>) -> Result<f64> {
    Ok(b_dd(real(parameter.into())?).value())
}

fn d_dd(parameter: Characteristic) -> Dd {
    fn d<N: Number>(mc: N) -> N {
        let [zero, one, three] = [0.0, 1.0, 3.0].map(N::from_double);
        carlson::second([zero, mc, one]).quotient(three)
    }
    let mc = parameter.nc;
    if carlson::ordinary(&[mc.high()]) {
        d(mc)
    } else {
        d(Extended::from_narrow(mc)).narrow()
    }
}

fn b_dd(parameter: Characteristic) -> Dd {
    fn b<N: Number>(mc: N) -> N {
        let [zero, one, three] = [0.0, 1.0, 3.0].map(N::from_double);
        (mc * carlson::second([zero, one, mc])).quotient(three)
    }
    let mc = parameter.nc;
    // B − 1 = O(mc ln mc), far below the last place; at 0 there is no R_D.
    if mc.high() < 1e-60 {
        return Dd::from(1.0);
    }
    if carlson::ordinary(&[mc.high()]) {
        b(mc)
    } else {
        b(Extended::from_narrow(mc)).narrow()
    }
}
