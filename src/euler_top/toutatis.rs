//! The asteroid 4179 Toutatis as a free top (tutorial 6.6, 6.8): its numbers, their sources, and what they predict.
//!
//! A potato of 4.6 × 2.4 × 1.9 km whose long axis, the axis of the smallest moment, goes round L while the body rolls about it.
//! Radar saw both periods in 1992. Computed here: the two periods, from the moments and one angular velocity. Quoted: moments, angular velocity, observed periods.

use super::EulerTop;
use crate::error::{Result, each, positive, refused, within};
use crate::frame::{Attitude, BodyVector};

/// Moments about the middle, the short and the long axis over that about the long one, dimensionless (quoted: radar, 1992 to
/// 2008, Takahashi, Busch and Scheeres 2013). In this order the axes are right-handed.
pub const MOMENTS: [f64; 3] = [3.0836, 3.235, 1.0];

/// Ω along the same axes at the epoch of the solution, 9 November 1992, 17:49:47 UT, degrees a day (quoted: the same).
const OMEGA: [f64; 3] = [14.51, 33.529, -98.709];

/// Toutatis as a free top. Time is in seconds from the epoch of the radar solution, where its attitude is taken as the identity.
///
/// Its moments are ratios, so energy and |L| are in units of the moment about the long axis. The torques of Sun and Earth, which
/// change both periods a little at each passage of the Earth, are left out.
///
/// # Errors
/// None for these numbers; those of [`EulerTop::from_omega`].
///
/// ```
/// use spinning_bodies::euler_top::{Regime, toutatis};
/// let asteroid = toutatis::top()?;
/// assert_eq!(asteroid.regime(), Regime::AroundSmallest);
/// assert!((asteroid.period() / 86_400.0 / 5.41 - 1.0).abs() < 0.01);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn top() -> Result<EulerTop> {
    let [x, y, z] = OMEGA.map(|rate| rate.to_radians() / 86_400.0);
    EulerTop::from_omega(MOMENTS, BodyVector::new(x, y, z), Attitude::identity())
}

/// A top of these moments (ascending) with 2E = 1 and L² = `ratio` · I₁, at the moment when Ω₂ = 0 and Ω₁, Ω₃ ≥ 0.
///
/// `ratio` is L²/(2EI₁), between 1 (rotation about the long axis) and I₃/I₁ (about the short one): the only number, besides the
/// moments, on which the ratio of the two periods depends. Error: six roundings in L.
///
/// # Errors
/// [`Error::NotPositive`](crate::Error::NotPositive) or [`Error::NotFinite`](crate::Error::NotFinite) for a moment; [`Error::Condition`](crate::Error::Condition) if they do not ascend; [`Error::OutOfRange`](crate::Error::OutOfRange) for the ratio; those of [`EulerTop::new`].
///
/// ```
/// use spinning_bodies::euler_top::toutatis::mode;
/// let moments = [1.0, 3.09, 3.22]; // Hudson and Ostro 1995
/// let asteroid = mode(moments, 1.69770)?;
/// let turns = asteroid.mean_precession_rate() * asteroid.period() / core::f64::consts::TAU;
/// assert!((turns - 5.41 / 7.35).abs() < 2e-6 && (asteroid.energy() - 0.5).abs() < 1e-15);
/// assert!(mode(moments, 0.99).is_err() && mode([1.0; 3], 1.0).is_err() && mode([2.0, 1.0, 3.0], 1.2).is_err());
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn mode(moments: [f64; 3], ratio: f64) -> Result<EulerTop> {
    each(positive, "a principal moment", moments)?;
    let [i1, i2, i3] = moments;
    if !(i1 <= i2 && i2 <= i3 && i1 < i3) {
        return refused("the moments must ascend and not all be equal", i3 - i1);
    }
    let greatest = i3 / i1;
    within("L² over 2E I₁", ratio, 1.0, greatest)?;
    // Sphere and ellipsoid with L₂ = 0: L₁² + L₃² = ratio I₁ and L₁²/I₁ + L₃²/I₃ = 1.
    // I₃ − L²/2E by one rounding: of a nearly round body the quotient above has few digits next to 1.
    let share = |part: f64| part.max(0.0) / (i3 - i1);
    let l1 = (i1 * share(ratio.mul_add(-i1, i3))).sqrt();
    let l3 = (i3 * share((ratio - 1.0) * i1)).sqrt();
    EulerTop::new(moments, BodyVector::new(l1, 0.0, l3), Attitude::identity())
}
