//! Complete integrals of the first and second kind.

use super::incomplete::{self, Kind, real};
use super::third::Characteristic;
use crate::error::Result;
use crate::precise::{DoubleDouble as Dd, Number, RIGHT_ANGLE};

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
/// Error 0.40 ε at most of 49 rows. Cost 180–290 ns, 1.3–2.6 times that of K. Source: Digital Library of Mathematical Functions, 19.2, 19.8.
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
    let [b, d] = second_kind(parameter);
    b + parameter.nc * d
}

/// D = ∫₀^{π/2} sin²θ/√(1 − m sin²θ) dθ = (K − E)/m for m ≤ 1, without that difference; π/4 at m = 0, infinite at mc = 0.
///
/// Error 0.45 ε at most of 49 rows, m and mc to 10⁻³⁰⁰ and less. Cost 160–280 ns. Source: Digital Library of
/// Mathematical Functions, 19.8.
///
/// # Errors
///
/// As for [`complete_first`].
pub fn complete_d(parameter: impl Into<Characteristic>) -> Result<f64> {
    let parameter = real(parameter.into())?;
    if parameter.nc() == 0.0 {
        return Ok(f64::INFINITY);
    }
    Ok(second_kind(parameter)[1].value())
}

/// B = ∫₀^{π/2} cos²θ/√(1 − m sin²θ) dθ = (E − mc K)/m for m ≤ 1, without that difference; π/4 at m = 0, 1 at m = 1.
///
/// Error 0.35 ε at most of 49 rows. Cost 160–280 ns. Source: Digital Library of Mathematical Functions, 19.8.
///
/// # Errors
///
/// As for [`complete_first`].
pub fn complete_b(parameter: impl Into<Characteristic>) -> Result<f64> {
    let parameter = real(parameter.into())?;
    if parameter.nc() == 0.0 {
        return Ok(1.0);
    }
    Ok(second_kind(parameter)[0].value())
}

/// K − π/2 for m ≤ 1, without that difference: πm/8 next to m = 0, negative for m < 0, infinite at m = 1.
///
/// What a pendulum's period has more than that of small swings, or a top's polhode more than the circle. With cₙ and aₙ of the arithmetic–geometric mean it
/// is π/2 Σcₙ/a. Error 0.44 ε at most of 40 rows, m and mc to 10⁻³⁰⁰ and less. Cost 160–280 ns.
///
/// ```
/// use spinning_bodies::elliptic::{Parameter, complete_first_excess};
/// let tiny = complete_first_excess(Parameter::from_parameter(1e-20)?)?;
/// assert_eq!(tiny, std::f64::consts::PI * 1e-20 / 8.0);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
///
/// # Errors
///
/// As for [`complete_first`].
pub fn complete_first_excess(parameter: impl Into<Characteristic>) -> Result<f64> {
    let parameter = real(parameter.into())?;
    let (m, mc) = (parameter.n, parameter.nc);
    if mc.high() == 0.0 {
        return Ok(f64::INFINITY);
    }
    if m.high() < -1.0 {
        // Nothing cancels there, and squares of √mc may have no room.
        return Ok((incomplete::complete(Kind::First, parameter)? - RIGHT_ANGLE).value());
    }
    Ok((from_the_mean(m, mc)[2] * m).value())
}

/// B and D for m < 1.
fn second_kind(parameter: Characteristic) -> [Dd; 2] {
    let (m, mc) = (parameter.n, parameter.nc);
    if m.high() >= 0.0 {
        let [b, d, _] = from_the_mean(m, mc);
        return [b, d];
    }
    // The imaginary modulus, cosine for sine: B(m) = D(−m/mc)/√mc, and the other way round.
    let [b, d, _] = from_the_mean(-m / mc, Dd::from(1.0) / mc);
    // Of a quarter of mc, for the square of the root of the greatest double is beyond it.
    let root = mc.scaled(0.25).square_root().scaled(2.0);
    [d / root, b / root]
}

/// B, D and (K − π/2)/m by the arithmetic–geometric mean that gives K; the first two for 0 ≤ m < 1.
///
/// With c₀² = m and cₙ = (aₙ₋₁ − bₙ₋₁)/2, which is cₙ₋₁²/(4aₙ), (K − E)/K = Σ 2ⁿ⁻¹cₙ² and 1 − a = Σ cₙ. Here rₙ = cₙ/m and uₙ = cₙ²/m are carried: nothing is
/// lost next to m = 0, where the first terms are all. Next to m = 1 the rest of Σ 2ⁿ⁻¹uₙ to 1 is about 1/K, of which two words lose three digits at most. Source:
/// Digital Library of Mathematical Functions, 19.8.
fn from_the_mean(m: Dd, mc: Dd) -> [Dd; 3] {
    let mut b = mc.square_root();
    let mut a = Dd::from(1.0).add_alike(b).scaled(0.5);
    b = b.square_root();
    let mut r = Dd::from(0.25) / a;
    let (mut u, mut weight) = (m * r.square(), 1.0);
    let (mut squares, mut gaps) = (Dd::from(0.5) + u, r);
    loop {
        let last = (weight * u.high()).abs() <= 1e-33;
        (a, b) = (a.add_alike(b).scaled(0.5), (a * b).square_root());
        r = u.scaled(0.25) / a;
        gaps = gaps + r;
        if last {
            break;
        }
        weight *= 2.0;
        u = m * r.square();
        squares = squares + u.scaled(weight);
    }
    let quarter = RIGHT_ANGLE / a;
    [
        quarter * (Dd::from(1.0) - squares),
        quarter * squares,
        quarter * gaps,
    ]
}

/// Π for n < 1 and m < 1, where it is an integral of what is positive: Bulirsch's transformation, in which all terms are, too.
///
/// Source: R. Bulirsch, Numerical calculation of elliptic integrals and elliptic functions III, Numerische Mathematik 13 (1969) 305–315.
pub(super) fn third_kind(nc: Dd, mc: Dd) -> Dd {
    let one = Dd::from(1.0);
    let (mut root, mut p) = (mc.square_root(), nc.square_root());
    let (mut a, mut b) = (one, one / p);
    let (mut product, mut mean) = (root, one);
    loop {
        let inverse = one / p;
        let (before, g) = (a, product * inverse);
        a = a.add_alike(b * inverse);
        b = b.add_alike(before * g).scaled(2.0);
        p = p.add_alike(g);
        let last = mean;
        mean = mean.add_alike(root);
        // Then the next gap is its square, below the last of two words.
        if (last - root).high().abs() <= 1e-17 * last.high() {
            return RIGHT_ANGLE * b.add_alike(a * mean) / (mean * mean.add_alike(p));
        }
        root = product.square_root().scaled(2.0);
        product = root * mean;
    }
}
