//! The Earth as a symmetric top (tutorial 6.5): its numbers, their sources, and what they predict.
//!
//! Computed here: the period of a rigid Earth, and how much elasticity lengthens it in the simplest model. Quoted from geodesy: the
//! ellipticity, the Love number, the observed period.

use crate::error::{Result, finite, positive, within};

/// Dynamical ellipticity H = (I₃ − I₁)/I₃, dimensionless (quoted: from the precession of the equinoxes).
pub const DYNAMICAL_ELLIPTICITY: f64 = 1.0 / 305.456;

/// One turn of the Earth, in solar days: 86 164.0905 s of 86 400 s (quoted).
pub const SIDEREAL_DAY: f64 = 86_164.090_5 / 86_400.0;

/// Mean rotation rate, rad/s (quoted).
pub(crate) const ROTATION_RATE: f64 = 7.292_115e-5;

/// GM of the Earth, m³/s² (quoted).
pub(crate) const GRAVITATIONAL_PARAMETER: f64 = 3.986_004_418e14;

/// Equatorial radius, m (quoted).
pub(crate) const EQUATORIAL_RADIUS: f64 = 6_378_136.6;

/// J₂ = (I₃ − I₁)/(Ma²), dimensionless (quoted: from satellite orbits).
pub(crate) const DYNAMICAL_FORM_FACTOR: f64 = 1.082_635_9e-3;

/// Period of the free wobble of a rigid Earth, in turns of the Earth: 1/(I₃/I₁ − 1) = 1/H − 1 for H = (I₃ − I₁)/I₃ (6.5).
///
/// # Errors
/// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::NotPositive`](crate::Error::NotPositive); [`Error::OutOfRange`](crate::Error::OutOfRange) for H above ½, which no body with I₁ = I₂ has (2.4).
///
/// ```
/// use spinning_bodies::euler_top::earth::{DYNAMICAL_ELLIPTICITY, rigid_period};
/// assert_eq!(rigid_period(1.0 / 305.0)?.round(), 304.0);
/// assert!((rigid_period(DYNAMICAL_ELLIPTICITY)? - 304.5).abs() < 0.5);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn rigid_period(ellipticity: f64) -> Result<f64> {
    let value = positive("the dynamical ellipticity", ellipticity)?;
    within("the dynamical ellipticity", value, 0.0, 0.5)?;
    finite("the rigid period", (1.0 - value) / value)
}

/// Secular Love number k_s = 3 J₂ GM/(a³Ω²), dimensionless: the k₂ that an Earth yielding like a fluid would have.
///
/// About 0.94 from the constants above.
///
/// ```
/// let secular = spinning_bodies::euler_top::earth::secular_love_number();
/// assert!((secular - 0.94).abs() < 0.01);
/// ```
pub fn secular_love_number() -> f64 {
    let speed_squared = (EQUATORIAL_RADIUS * ROTATION_RATE).powi(2);
    3.0 * DYNAMICAL_FORM_FACTOR * (GRAVITATIONAL_PARAMETER / EQUATORIAL_RADIUS) / speed_squared
}

/// Period of the wobble of an elastic body: T = T_rigid/(1 − k₂/k_s), in the unit of `rigid`.
///
/// The fraction k₂/k_s of the bulge follows the axis at once and gives no restoring torque (Newcomb 1892, Love 1909). The
/// model takes the whole Earth as one elastic body, without the ocean, which would lengthen the period further, and without the
/// fluid core, which shortens it.
///
/// # Errors
/// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::NotPositive`](crate::Error::NotPositive) for the period or k_s; [`Error::OutOfRange`](crate::Error::OutOfRange) unless 0 ≤ k₂ < k_s.
///
/// ```
/// use spinning_bodies::euler_top::earth::elastic_period;
/// // A body that yields half as much as a fluid would takes twice as long.
/// assert_eq!(elastic_period(300.0, 0.25, 0.5)?, 600.0);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn elastic_period(rigid: f64, love_number: f64, secular: f64) -> Result<f64> {
    let rigid = positive("the rigid period", rigid)?;
    let secular = positive("the secular Love number", secular)?;
    let value = within("the Love number", love_number, 0.0, secular.next_down())?;
    finite("the elastic period", rigid / ((secular - value) / secular))
}
