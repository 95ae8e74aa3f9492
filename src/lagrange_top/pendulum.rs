//! The spherical pendulum as a top without spin, and its ellipse that turns (tutorial 7.6).

use std::f64::consts::PI;

use super::LagrangeTop;
use crate::error::{Error, Result, finite, positive};
use crate::frame::{Attitude, BodyVector};

/// The spherical pendulum that swings between two angles from the downward vertical, radians, from the smaller (7.6).
///
/// A Lagrange top with I₁ = 1 and without spin; `gravity` is Mgl/I₁ (s⁻²), which is g over the length for a bob. At the start
/// φ'² = gravity·sin²b/(sin²a cos((b−a)/2) cos((b+a)/2)). Equal angles make it a conical pendulum.
///
/// Domain: 4.5·10⁻³⁰⁸ ≤ a ≤ b, a + b < π (the two turning points of a pendulum have their middle below the pivot), gravity > 0.
///
/// # Errors
/// [`Error::NotFinite`], [`Error::NotPositive`], [`Error::OutOfRange`] for a and b.
pub fn pendulum_between(inner: f64, outer: f64, gravity: f64) -> Result<LagrangeTop> {
    positive("the smaller angle", inner)?;
    finite("the greater angle", outer)?;
    positive("gravity over length", gravity)?;
    let (half_sum, half_difference) = (0.5 * (inner + outer), 0.5 * (outer - inner));
    if outer < inner || half_sum >= 0.5 * PI {
        return Err(Error::OutOfRange {
            quantity: "the greater angle",
            value: outer,
            least: inner,
            greatest: PI - inner,
        });
    }
    // The start is half the angle, which must have its digits.
    let least = 2.0 * f64::MIN_POSITIVE;
    if inner < least {
        return Err(Error::OutOfRange {
            quantity: "the smaller angle",
            value: inner,
            least,
            greatest: 0.5 * PI,
        });
    }
    let across = outer.sin() * (gravity.sqrt() / (half_difference.cos() * half_sum.cos()).sqrt());
    let (s, c) = (0.5 * inner).sin_cos();
    let attitude = Attitude::from_quaternion(s, c, 0.0, 0.0)?;
    LagrangeTop::new(
        1.0,
        1.0,
        gravity,
        BodyVector::new(0.0, across, 0.0),
        attitude,
    )
}

/// The spherical pendulum with these integrals (7.6): L_vert/I₁ (rad/s) and the energy over I₁ (s⁻²), zero at rest at the height of the pivot, under
/// `gravity` Mgl/I₁ (s⁻²), which is g over the length for a bob. It starts where it is lowest.
///
/// A Lagrange top with I₁ = 1 and without spin. With L_vert = 0 a plane pendulum, which at energy = gravity, exactly, climbs to the upright position for ever
/// ([`Nutation::Waking`](super::Nutation::Waking)). Small swings, whose energy is next to −gravity, are better told by their angles
/// ([`pendulum_between`]). Domain: gravity > 0, each energy that a motion with this L_vert has. Cost: that of [`LagrangeTop::from_integrals`].
///
/// # Errors
/// [`Error::NotFinite`], [`Error::NotPositive`] for gravity, [`Error::Condition`] for an energy below that of the conical pendulum with this L_vert.
///
/// ```
/// use spinning_bodies::lagrange_top::{Nutation, pendulum_from_integrals};
/// let climbing = pendulum_from_integrals(0.0, 9.81, 9.81)?;
/// assert_eq!(climbing.kind(), Nutation::Waking);
/// // 1 − h = 2 sech²(√g t).
/// let state = climbing.at(50.0)?;
/// assert!((state.one_less / (2.0 / (9.81f64.sqrt() * 50.0).cosh().powi(2)) - 1.0).abs() < 1e-12);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn pendulum_from_integrals(l_vert: f64, energy: f64, gravity: f64) -> Result<LagrangeTop> {
    positive("gravity over length", gravity)?;
    LagrangeTop::from_integrals(1.0, 1.0, gravity, 0.0, l_vert, energy)
}

/// By how much the ellipse of a spherical pendulum turns from one greatest swing to the next (7.6).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Apsides {
    /// Azimuth gained from one smallest angle to the next less π, radians.
    pub advance: f64,
    /// (3/8)ab·π, radians: the same for small swings.
    pub small_swing: f64,
}

/// The advance of the apsides of a spherical pendulum between the angles a ≤ b, exactly and by the small-swing law (3/8)ab·π (7.6).
///
/// Both angles in radians from the downward vertical; the ellipse turns the way the bob goes. Independent of gravity. The exact
/// advance is a difference from π, with an absolute error of some 10⁻¹⁵ rad. The law falls short by the part b²/6 or so.
/// Domain as [`pendulum_between`]. Cost: one Lagrange top prepared.
///
/// # Errors
/// As [`pendulum_between`].
///
/// ```
/// let turn = spinning_bodies::lagrange_top::apsides(0.05, 0.1)?;
/// assert!((turn.advance.to_degrees() - 0.337984).abs() < 1e-6);
/// assert!((turn.small_swing.to_degrees() - 0.3375).abs() < 1e-12);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn apsides(inner: f64, outer: f64) -> Result<Apsides> {
    let top = pendulum_between(inner, outer, 1.0)?;
    let turned = top.precession_per_nutation().ok_or(Error::Condition {
        condition: "the pendulum must swing with a period",
        value: outer,
    })?;
    Ok(Apsides {
        advance: turned.abs() - PI,
        small_swing: 0.375 * inner * outer * PI,
    })
}
