//! Pure precession of Lagrange's top, slow and fast (tutorial 7.3).
//!
//! Every difference that can cancel is formed in 106 bits with exponents of any size, and only results are rounded.

use crate::error::{Error, Result, finite, positive, within};
use crate::precise::{Extended, Number};

/// The rates dφ/dt at which the axis can go round at one tilt without nutation, rad/s (7.3).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PurePrecession {
    /// L₃² < 4I₁Mgl cos θ, or a horizontal axis without spin: no rate keeps this tilt.
    None,
    /// One rate: a horizontal axis, or equality in the condition, where both have met.
    One(f64),
    /// Two rates, the slower in size and the faster; of opposite sign below the horizon.
    Two {
        /// The one that gravity causes, Mgl/L₃ in the limit of fast spin.
        slow: f64,
        /// The one that needs no gravity, L₃/(I₁cos θ) in the limit.
        fast: f64,
    },
    /// Neither spin nor gravity, and a horizontal axis: every rate will do.
    Any,
}

/// Both rates of pure precession: the roots w of I₁cos θ w² − L₃w + Mgl = 0 (7.3).
///
/// `transverse` is I₁ about the pivot (kg m²), `weight_moment` Mgl (N m, of either sign), `l3` = I₃Ω₃ (kg m²/s), `height` = cos θ
/// of the tilt. The faster root is a sum, the slower the quotient Mgl/(I₁cos θ·fast): nothing cancels. At the poles, where
/// nothing precesses, these are the rates of a vanishing tilt (7.5).
///
/// Domain: all finite numbers with I₁ > 0 and |cos θ| ≤ 1. Each rate is right to one unit in the last place, next to the
/// double root as well; the condition is decided in 106 bits, so it is exact for numbers of 35 bits. A rate beyond the greatest
/// double is returned as infinite. Cost: a square root and two divisions of 106 bits.
///
/// # Errors
/// [`Error::NotFinite`], [`Error::NotPositive`] for I₁, [`Error::OutOfRange`] for cos θ.
///
/// ```
/// use spinning_bodies::lagrange_top::{PurePrecession, pure_precession};
/// let PurePrecession::Two { slow, fast } = pure_precession(1.0, 1.0, 3.0, 0.5)? else { panic!() };
/// assert!((slow - (3.0 - 7f64.sqrt())).abs() < 3e-16 && (fast - (3.0 + 7f64.sqrt())).abs() < 1e-15);
/// assert_eq!(pure_precession(1.0, 1.0, 1.4, 0.5)?, PurePrecession::None);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn pure_precession(
    transverse: f64,
    weight_moment: f64,
    l3: f64,
    height: f64,
) -> Result<PurePrecession> {
    let [leading, weight, l3] = quadratic(transverse, weight_moment, l3, height)?;
    let discriminant = l3.square() - (leading * weight).times(4.0);
    let rounded = |x: Extended| x.narrow().value();
    Ok(if leading.is_zero() {
        match (l3.is_zero(), weight.is_zero()) {
            (true, true) => PurePrecession::Any,
            (true, false) => PurePrecession::None,
            (false, _) => PurePrecession::One(rounded(weight.quotient(l3))),
        }
    } else if discriminant.is_zero() {
        PurePrecession::One(rounded(l3.quotient(leading).times(0.5)))
    } else if discriminant.leading() < 0.0 {
        PurePrecession::None
    } else {
        // Of the sign of L₃: a sum of two numbers of one sign.
        let root = discriminant.square_root();
        let far = (l3.magnitude() + root).times(0.5);
        let far = if l3.leading() < 0.0 { -far } else { far };
        PurePrecession::Two {
            slow: rounded(weight.quotient(far)),
            fast: rounded(far.quotient(leading)),
        }
    })
}

/// The least |L₃| with which a top can precess purely at this tilt: 2√(I₁Mgl cos θ), kg m²/s; zero for a centre of mass that hangs (7.3).
///
/// Arguments as for [`pure_precession`]. One rounding, at any scale; infinite beyond the greatest double. Cost: a square root of 106 bits.
///
/// # Errors
/// As [`pure_precession`].
///
/// ```
/// use spinning_bodies::lagrange_top::least_axial_angular_momentum;
/// assert_eq!(least_axial_angular_momentum(1.0, 8.0, 0.5)?, 4.0);
/// assert_eq!(least_axial_angular_momentum(1.0, 8.0, -0.5)?, 0.0);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn least_axial_angular_momentum(
    transverse: f64,
    weight_moment: f64,
    height: f64,
) -> Result<f64> {
    let [leading, weight, _] = quadratic(transverse, weight_moment, 0.0, height)?;
    let product = (leading * weight).times(4.0);
    if product.leading() <= 0.0 {
        return Ok(0.0);
    }
    Ok(product.square_root().narrow().value())
}

/// What the two rates become when spin overwhelms gravity (7.3).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FastSpin {
    /// Mgl/L₃, rad/s: too small by the part x in the first order.
    pub slow: f64,
    /// L₃/(I₁cos θ), rad/s: too large by the part x; infinite for a horizontal axis.
    pub fast: f64,
    /// x = I₁Mgl cos θ/L₃², no unit; pure precession needs x ≤ ¼.
    pub x: f64,
}

/// Mgl/L₃ and L₃/(I₁cos θ), the large-spin limits of both rates, with the number x that says how far off they are (7.3).
///
/// Arguments as for [`pure_precession`]. The rates themselves are slow·(1 + x + 2x² + 5x³ + …) and fast·(1 − x − x² − 2x³ − …),
/// convergent for |x| ≤ ¼. One rounding each. Cost: a few divisions.
///
/// # Errors
/// As [`pure_precession`]; [`Error::Condition`] without spin, where there is no such limit.
pub fn fast_spin(transverse: f64, weight_moment: f64, l3: f64, height: f64) -> Result<FastSpin> {
    let [leading, weight, momentum] = quadratic(transverse, weight_moment, l3, height)?;
    if momentum.is_zero() {
        return Err(Error::Condition {
            condition: "the axial angular momentum must not be zero",
            value: l3,
        });
    }
    let fast = if leading.is_zero() {
        l3.signum() * f64::INFINITY
    } else {
        momentum.quotient(leading).narrow().value()
    };
    Ok(FastSpin {
        slow: weight.quotient(momentum).narrow().value(),
        fast,
        x: (leading * weight)
            .quotient(momentum.square())
            .narrow()
            .value(),
    })
}

/// I₁cos θ, Mgl and L₃ after their checks.
fn quadratic(transverse: f64, weight_moment: f64, l3: f64, height: f64) -> Result<[Extended; 3]> {
    positive("the transverse moment", transverse)?;
    finite("the weight moment Mgl", weight_moment)?;
    finite("the axial angular momentum", l3)?;
    within("the height cos θ", height, -1.0, 1.0)?;
    let leading = Extended::from_double(transverse) * Extended::from_double(height);
    Ok([
        leading,
        Extended::from_double(weight_moment),
        Extended::from_double(l3),
    ])
}
