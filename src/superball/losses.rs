//! Imperfect superballs: restitution along and across the surface, and a contact that slips.

use num_traits::Num;

use super::{Motion, Surface};
use crate::error::{Result, not_negative, positive, refused, within};
use crate::rolling::Coulomb;
use crate::search::halved;

/// Coefficients of restitution for the two velocities of the contact point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Restitution {
    /// e_n.
    pub(crate) normal: f64,
    /// e_t.
    pub(crate) tangential: f64,
}

impl Restitution {
    /// Coefficients across the surface (0…1) and along it (−1…1), dimensionless: u' = −e_t u and V_z' = −e_n V_z.
    ///
    /// Along the surface, 1 is the superball, 0 a ball that leaves the surface rolling, −1 a frictionless ball.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange), [`Error::NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// use spinning_bodies::superball::Restitution;
    /// assert!(Restitution::new(0.9, -0.6).is_ok() && Restitution::new(1.1, 0.6).is_err());
    /// ```
    pub fn new(normal: f64, tangential: f64) -> Result<Self> {
        let normal = within("the coefficient of restitution", normal, 0.0, 1.0)?;
        let tangential = within("the tangential restitution", tangential, -1.0, 1.0)?;
        Ok(Self { normal, tangential })
    }

    /// Total path, up and down, of a ball in all its bounces after a drop from `height`, in the unit of the height: h(1+e_n²)/(1−e_n²), Zeno's sum.
    ///
    /// Infinite for e_n = 1, and beyond the range of doubles. Error: 2 ε, next to e_n = 1 as well, where 1 − e_n is exact. [`Flight::last_contact`](super::Flight::last_contact) gives the time at which the bounces end.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Negative`](crate::Error::Negative) for the height.
    ///
    /// ```
    /// let path = spinning_bodies::superball::Restitution::new(0.5, 1.0)?.path_of_a_drop(3.0)?;
    /// assert_eq!(path, 5.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn path_of_a_drop(&self, height: f64) -> Result<f64> {
        let e = self.normal;
        let height = not_negative("the height of the drop", height)?;
        if height == 0.0 {
            return Ok(0.0);
        }
        Ok(height * (1.0 + e * e) / ((1.0 - e) * (1.0 + e)))
    }

    /// The number of bounces after which a ball that first meets the floor at `speed` leaves it no faster than `least`, both in m/s: the least n with e_nⁿ·speed ≤ least.
    ///
    /// `None` if it never does: for e_n = 1, or `least` = 0 with e_n > 0. If e_nⁿ equals the ratio of the speeds to within 4 units in the last place of n, that n is taken. A count beyond 10¹⁴ is right to 6 ε n.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::Negative`](crate::Error::Negative) for a speed.
    ///
    /// ```
    /// let ball = spinning_bodies::superball::Restitution::new(0.5, 1.0)?;
    /// assert_eq!(ball.bounces_down_to(8.0, 1.0)?, Some(3));
    /// assert_eq!(ball.bounces_down_to(8.0, 0.99)?, Some(4));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn bounces_down_to(&self, speed: f64, least: f64) -> Result<Option<u64>> {
        let speed = not_negative("the speed of the ball", speed)?;
        let least = not_negative("the least speed", least)?;
        if speed <= least {
            return Ok(Some(0));
        }
        if self.normal == 0.0 {
            return Ok(Some(1));
        }
        let wanted = logarithm_of_ratio(least, speed) / logarithm_of_ratio(self.normal, 1.0);
        let count = (wanted * (1.0 - 4.0 * f64::EPSILON)).ceil();
        Ok(wanted.is_finite().then_some(count as u64))
    }
}

/// ln(part/whole): from their exact difference if the quotient is close to 1, from two logarithms if it is not a normal number.
fn logarithm_of_ratio(part: f64, whole: f64) -> f64 {
    match part / whole {
        ratio if ratio > 0.5 => ((part - whole) / whole).ln_1p(),
        ratio if ratio.is_normal() => ratio.ln(),
        _ => part.ln() - whole.ln(),
    }
}

/// A bounce that reverses the contact speed and multiplies it by `restitution`: V' = V − κ(1+e_t)u/(1+κ), RΩ' = RΩ ± (1+e_t)u/(1+κ) (4.6).
///
/// At e_t = 1 it is [`bounce`](super::bounce) to the bit. Energy κu²(1−e_t²)/(1+κ) (in the unit of [`Motion::energy`]) is lost. Panics as [`bounce`](super::bounce).
///
/// ```
/// use spinning_bodies::superball::{Motion, Surface, bounce_with};
/// let thrown = Motion { velocity: 1.0_f64, rim_speed: 0.0 };
/// // No contact speed is left: the ball rolls, V = RΩ.
/// let after = bounce_with(thrown, Surface::Floor, 0.4, 0.0);
/// assert!((after.velocity - after.rim_speed).abs() < 1e-15 && (after.velocity - 5.0 / 7.0).abs() < 1e-15);
/// ```
pub fn bounce_with<T: Num + Copy>(
    before: Motion<T>,
    surface: Surface,
    kappa: T,
    restitution: T,
) -> Motion<T> {
    let slip = before.contact_speed(surface);
    let turned = (slip + restitution * slip) / (T::one() + kappa);
    before.kicked(surface, kappa, turned)
}

/// The same bounce with Coulomb's law for impulses: the contact transmits at most its grip times the normal impulse `pressed` per mass (m/s); if that is
/// not enough it slips, and transmits the kinetic coefficient times `pressed`.
///
/// `pressed` is (1+e_n)|V_z|. At grazing incidence V_z is small and every ball slips.
///
/// ```
/// use spinning_bodies::{rolling::Coulomb, superball::{Motion, Surface, gripping_bounce}};
/// let thrown = Motion { velocity: 1.0, rim_speed: 0.0 };
/// // With too little grip, friction takes μ times the normal impulse from the velocity.
/// let slippery = gripping_bounce(thrown, Surface::Floor, 0.4, 1.0, Coulomb::new(0.1)?, 2.0);
/// assert!((slippery.velocity - 0.8).abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn gripping_bounce(
    before: Motion<f64>,
    surface: Surface,
    kappa: f64,
    restitution: f64,
    law: Coulomb,
    pressed: f64,
) -> Motion<f64> {
    let slip = before.contact_speed(surface);
    let mut turned = (slip + restitution * slip) / (1.0 + kappa);
    if kappa * turned.abs() > law.grip * pressed {
        turned = (law.kinetic * pressed / kappa).copysign(slip);
    }
    before.kicked(surface, kappa, turned)
}

/// The tangential restitution below which a ball thrown under a table without spin does not come back after three bounces, but goes on with V₃ > 0.
///
/// With a = (1+e_t)/(1+κ), V₃/V = 1 − κa(3 + (1−3κ)a + (1−κ)²a²), which falls with a; its root is found by bisection, to rounding. 0.13809 for κ = 2/5.
///
/// # Errors
/// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite) for κ; [`Error::OutOfRange`](crate::Error::OutOfRange) above 2/3, the thin shell's, where V₃ is no longer monotone;
/// [`Error::Condition`](crate::Error::Condition) below 0.0718, where the superball itself does not come back.
///
/// ```
/// use spinning_bodies::superball::{Motion, Surface, bounce_with, return_threshold};
/// let (kappa, threshold) = (0.4, return_threshold(0.4)?);
/// let mut motion = Motion { velocity: 1.0, rim_speed: 0.0 };
/// for surface in [Surface::Floor, Surface::Ceiling, Surface::Floor] {
///     motion = bounce_with(motion, surface, kappa, threshold);
/// }
/// assert!(motion.velocity.abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn return_threshold(kappa: f64) -> Result<f64> {
    positive("the inertia factor", kappa)?;
    within("the inertia factor", kappa, 0.0, 2.0 / 3.0)?;
    let (b, c) = (1.0 - 3.0 * kappa, (1.0 - kappa) * (1.0 - kappa));
    let most = 2.0 / (1.0 + kappa);
    // The slope 3 + 2ba + 3ca² has the discriminant 4b² − 36c, which is negative for κ < 2/3.
    let value = |a: f64| kappa * a * (3.0 + a * (b + a * c)) - 1.0;
    if value(most) < 0.0 {
        let condition = "the inertia factor must be large enough for a superball to come back after three bounces";
        return refused(condition, kappa);
    }
    let [_, root] = halved([0.0, most], 0.0, |a| Ok(value(a) < 0.0))?;
    Ok(root * (1.0 + kappa) - 1.0)
}
