//! The spin with which Lagrange's top sleeps, and how far a kick tilts it (tutorial 7.5).
//!
//! Every difference that can cancel is formed in 106 bits with exponents of any size, and only results are rounded.

use std::f64::consts::PI;

use crate::error::{Result, finite, not_negative, positive};
use crate::precise::{Extended, Number};

/// The least spin Ω₃ with which a top sleeps, 2√(I₁Mgl)/I₃, rad/s (7.5).
///
/// The top sleeps if Ω₃² ≥ 4I₁Mgl/I₃². The tutorial displays >; at equality f = −2I₁Mgl(1 − h)³ is still negative below h = 1,
/// and the top is still stable. Domain: I₁, I₃ > 0, Mgl ≥ 0. One rounding. Cost: a square root.
///
/// # Errors
/// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::NotPositive`](crate::Error::NotPositive), [`Error::Negative`](crate::Error::Negative).
///
/// ```
/// assert_eq!(spinning_bodies::lagrange_top::sleeping_threshold(1.0, 0.5, 1.0)?, 4.0);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn sleeping_threshold(transverse: f64, axial: f64, weight_moment: f64) -> Result<f64> {
    positive("the transverse moment", transverse)?;
    positive("the axial moment", axial)?;
    not_negative("the weight moment Mgl", weight_moment)?;
    if weight_moment == 0.0 {
        return Ok(0.0);
    }
    let number = Extended::from_double;
    let root = (number(transverse) * number(weight_moment)).square_root();
    Ok(root.times(2.0).quotient(number(axial)).narrow().value())
}

/// The greatest tilt, radians, of an upright top with L₃ that is kicked sideways with `kick` rad/s (7.5).
///
/// With u = 1 − cos θ: −2gu² + (4g − ε² − l²)u + 2ε² = 0, g = Mgl/I₁, l = L₃/I₁, ε the kick. So the tilt is proportional to ε
/// above the threshold l² = 4g, to √ε on it, and below it never less than that of cos θ = l²/2g − 1.
///
/// Domain: I₁ > 0, Mgl ≥ 0, L₃ and kick finite. Few units in the last place, next to the threshold too. An upright top that is
/// not kicked stays. Cost: one square root of 106 bits.
///
/// # Errors
/// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::NotPositive`](crate::Error::NotPositive), [`Error::Negative`](crate::Error::Negative).
///
/// ```
/// use spinning_bodies::lagrange_top::tilt_after_kick;
/// assert!(tilt_after_kick(1.0, 1.0, 2.5, 0.01)? < 0.0134);
/// assert!(tilt_after_kick(1.0, 1.0, 1.9, 0.01)? > 0.635);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn tilt_after_kick(transverse: f64, weight_moment: f64, l3: f64, kick: f64) -> Result<f64> {
    positive("the transverse moment", transverse)?;
    not_negative("the weight moment Mgl", weight_moment)?;
    finite("the axial angular momentum", l3)?;
    finite("the kick", kick)?;
    if kick == 0.0 {
        return Ok(0.0);
    }
    let number = Extended::from_double;
    let gravity = number(weight_moment).quotient(number(transverse));
    let spin2 = number(l3).quotient(number(transverse)).square();
    let kick2 = number(kick).square();
    let linear = gravity.times(4.0) - kick2 - spin2;
    let product = (gravity * kick2).times(16.0);
    let root = (linear.square() + product).square_root();
    // u, and 2 − u from the product of the roots of its own equation: both without a difference.
    let one_less = if linear.leading() > 0.0 {
        (linear + root).quotient(gravity.times(4.0))
    } else {
        kick2.times(4.0).quotient(root - linear)
    };
    let sum = gravity.times(4.0) + kick2 + spin2 + root;
    let one_more = spin2.times(4.0).quotient(sum);
    let quotient = if one_more.is_zero() {
        return Ok(PI);
    } else {
        one_less.quotient(one_more).square_root()
    };
    Ok(2.0 * quotient.narrow().value().atan())
}
