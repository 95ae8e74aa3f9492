//! The motions that have formulas of their own (tutorial 7.3 to 7.6): pure precession, slow and fast; the dip of a top released from rest;
//! the spin with which it sleeps, and how far a kick tilts it; the spherical pendulum, a top without spin, and its turning ellipse.
//!
//! Every difference that can cancel is formed in 106 bits with exponents of any size, and only the results are rounded.

use std::f64::consts::PI;

use super::motion::LagrangeTop;
use crate::error::{Error, Result, finite, not_negative, out_of_range, positive, refused, within};
use crate::frame::{Attitude, BodyVector};
use crate::precise::{Extended, Number, shifted, sum_of_products};

/// The rates dφ/dt at which the axis can precess at a given tilt without nutation, rad/s (7.3).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PurePrecession {
    /// L₃² < 4I₁Mgl cos θ, or a horizontal axis without spin: no rate keeps this tilt.
    None,
    /// One rate: for a horizontal axis, or for equality in the condition, where the two coincide.
    One(f64),
    /// Two rates, the slower and the faster by magnitude; of opposite signs below the horizon.
    Two {
        /// The rate due to gravity, Mgl/L₃ in the limit of fast spin.
        slow: f64,
        /// The rate that remains without gravity, L₃/(I₁cos θ) in the limit of fast spin.
        fast: f64,
    },
    /// Neither spin nor gravity, and a horizontal axis: every rate is possible.
    Any,
}

/// The rates of pure precession: the roots w of I₁cos θ w² − L₃w + Mgl = 0 (7.3).
///
/// `transverse` is I₁ about the pivot (kg m²), `weight_moment` Mgl (N m, of either sign), `l3` = I₃Ω₃ (kg m²/s), `height` = cos θ
/// of the tilt. The faster root is a sum, the slower the quotient Mgl/(I₁cos θ·fast): nothing cancels. At cos θ = ±1, where
/// the axis does not precess, they are the limits for a vanishing tilt (7.5).
///
/// Domain: all finite numbers with I₁ > 0 and |cos θ| ≤ 1. Error: one unit in the last place of each rate, also next to the
/// double root. The condition is decided in 106 bits, so it is exact for numbers of 35 bits. A rate beyond the greatest
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
    Ok(if leading.is_zero() {
        match (l3.is_zero(), weight.is_zero()) {
            (true, true) => PurePrecession::Any,
            (true, false) => PurePrecession::None,
            (false, _) => PurePrecession::One(weight.quotient(l3).value()),
        }
    } else if discriminant.is_zero() {
        PurePrecession::One(l3.quotient(leading).times(0.5).value())
    } else if discriminant.leading() < 0.0 {
        PurePrecession::None
    } else {
        // Of the sign of L₃: a sum of two numbers of one sign.
        let root = discriminant.square_root();
        let far = (l3.magnitude() + root).times(0.5).signed(l3.leading());
        PurePrecession::Two {
            slow: weight.quotient(far).value(),
            fast: far.quotient(leading).value(),
        }
    })
}

/// The least |L₃| with which a top can precess purely at this tilt: 2√(I₁Mgl cos θ), kg m²/s; zero if the centre of mass is no higher than the pivot (7.3).
///
/// Arguments as for [`pure_precession`]. Error: one rounding, at any scale; infinite beyond the greatest double. Cost: a square root of 106 bits.
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
    Ok(product.square_root().value())
}

/// The limits of the two rates when spin overwhelms gravity (7.3).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FastSpin {
    /// Mgl/L₃, rad/s: too small by the fraction x, to first order.
    pub slow: f64,
    /// L₃/(I₁cos θ), rad/s: too large by the fraction x, to first order; infinite for a horizontal axis.
    pub fast: f64,
    /// x = I₁Mgl cos θ/L₃², dimensionless; pure precession needs x ≤ ¼.
    pub x: f64,
}

/// The limits Mgl/L₃ and L₃/(I₁cos θ) of the two rates for fast spin, with the number x that measures their error (7.3).
///
/// Arguments as for [`pure_precession`]. The rates themselves are slow·(1 + x + 2x² + 5x³ + …) and fast·(1 − x − x² − 2x³ − …),
/// convergent for |x| ≤ ¼. Error: one rounding each. Cost: a few divisions.
///
/// # Errors
/// As [`pure_precession`]; [`Error::Condition`] without spin, where there is no such limit.
///
/// ```
/// let limits = spinning_bodies::lagrange_top::fast_spin(1.0, 2.0, 10.0, 0.5)?;
/// assert_eq!((limits.slow, limits.fast, limits.x), (0.2, 20.0, 0.01));
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn fast_spin(transverse: f64, weight_moment: f64, l3: f64, height: f64) -> Result<FastSpin> {
    let [leading, weight, momentum] = quadratic(transverse, weight_moment, l3, height)?;
    if momentum.is_zero() {
        return refused("the axial angular momentum must not be zero", l3);
    }
    let fast = if leading.is_zero() {
        l3.signum() * f64::INFINITY
    } else {
        momentum.quotient(leading).value()
    };
    Ok(FastSpin {
        slow: weight.quotient(momentum).value(),
        fast,
        x: (leading * weight).quotient(momentum.square()).value(),
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

/// The dip of a spinning top whose axis is released from rest (7.4).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dip {
    /// h₁ = cos θ at the lowest point; the start is h₂.
    pub lowest_height: f64,
    /// θ at the lowest point, radians.
    pub lowest_tilt: f64,
    /// The growth of θ from the start to the lowest point, radians.
    pub depth: f64,
    /// The curve that the trace of the axis approaches for fast spin.
    pub cycloid: Cycloid,
}

/// The cycloid θ − θ₀ = a(1 − cos u), φ sin θ₀ = a(u − sin u), which the axis traces in the limit of fast spin (7.4).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cycloid {
    /// a = I₁Mgl sin θ₀/L₃², radians: the radius of the wheel that draws the curve.
    pub radius: f64,
    /// sin θ₀: azimuths exceed arcs by the factor 1/sin θ₀.
    pub sine: f64,
}

impl Cycloid {
    /// θ − θ₀ and φ, radians, when the wheel has turned by u (one turn is one nutation).
    ///
    /// Error: a few units in the last place, for small u too, as far as u² and the results are in the range of doubles. NaN if u is not finite. Cost: a sine and a cosine.
    ///
    /// ```
    /// use spinning_bodies::lagrange_top::Cycloid;
    /// // After half a turn of the wheel the axis is at its lowest point, half way along the arch.
    /// let [fall, turn] = Cycloid { radius: 1e-3, sine: 0.5 }.at(std::f64::consts::PI);
    /// assert!((fall - 2e-3).abs() < 1e-18 && (turn - 2e-3 * std::f64::consts::PI).abs() < 1e-17);
    /// ```
    pub fn at(&self, u: f64) -> [f64; 2] {
        let half = (0.5 * u).sin();
        // The radius first: u³ may underflow where the product does not.
        let arc = match u.abs() > 1.0 {
            true => self.radius * (u - u.sin()),
            false => self.radius * u * less_its_sine(u),
        };
        [2.0 * self.radius * half * half, arc / self.sine]
    }
}

/// 1 − sin u/u for |u| ≤ 1, where twelve terms of the series leave less than 10⁻²⁸ of the sum; beyond, the difference u − sin u loses three bits at most.
fn less_its_sine(u: f64) -> f64 {
    let square = u * u;
    let tail = (2..14).rev().fold(0.0, |sum, k| {
        let n = f64::from(2 * k);
        (1.0 - sum) * square / (n * (n + 1.0))
    });
    square / 6.0 * (1.0 - tail)
}

/// The lowest point of a top released at the tilt θ₀ with its axis at rest and the angular momentum L₃ about it (7.4).
///
/// h₁ = λ − √(λ² − 2λh₀ + 1) with λ = L₃²/(4I₁Mgl): the start is the upper turning point h₂, so the top can only sink. The dip
/// h₀ − h₁ is the positive root of d² + 2(λ − h₀)d = sin²θ₀, 1 − h₁ is 1 − h₀ plus that, and 1 + h₁ = 2λ(1 + h₀)/(1 + λ + √…).
///
/// Domain: I₁, Mgl > 0, any finite L₃ (without spin the axis falls through the hanging position, θ = π), 0 < θ₀ < π. Error: a few units in the
/// last place, of the depth too however small it is; of a height near zero 10⁻¹⁶. Cost: two square roots of 106 bits, a few sines.
///
/// # Errors
/// [`Error::NotFinite`], [`Error::NotPositive`], [`Error::OutOfRange`] for θ₀.
///
/// ```
/// use spinning_bodies::lagrange_top::dip;
/// // With L₃ = 2 it sinks from 60° to the horizontal.
/// let sunk = dip(1.0, 1.0, 2.0, std::f64::consts::FRAC_PI_3)?;
/// assert!(sunk.lowest_height.abs() < 3e-16 && (sunk.depth.to_degrees() - 30.0).abs() < 1e-13);
/// // A wheel of 1e320 radians in front of a sine of 1e-20.
/// assert!((dip(1.0, 1.0, 1e-160, 1e-20)?.cycloid.radius / 1e300 - 1.0).abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn dip(transverse: f64, weight_moment: f64, l3: f64, tilt: f64) -> Result<Dip> {
    positive("the transverse moment", transverse)?;
    positive("the weight moment Mgl", weight_moment)?;
    finite("the axial angular momentum", l3)?;
    positive("the tilt", tilt)?;
    within("the tilt", tilt, 0.0, PI.next_down())?;
    let number = Extended::from_double;
    let (s, c) = (0.5 * tilt).sin_cos();
    let [below, above] = [s, c].map(|x| number(x).square().times(2.0)); // 1 ∓ cos θ₀
    let product = number(transverse) * number(weight_moment);
    let square = number(l3).square();
    let lambda = square.quotient(product.times(4.0));
    let one = number(1.0);
    // λ − h₀ = (λ − 1) + (1 − h₀), and the root of its square and sin²θ₀.
    let lead = lambda - one + below;
    let sine2 = below * above;
    let root = (lead.square() + sine2).square_root();
    let fall = if lead.leading() < 0.0 {
        root - lead
    } else {
        sine2.quotient(root + lead)
    };
    let one_less = below + fall;
    let whole = one + lambda + root;
    let one_more = (lambda * above).times(2.0).quotient(whole);
    let more = one_more.value();
    // Next to upright in a unit like the lowest tilt, whose square may underflow.
    let unit = one_less.exponent.div_euclid(2);
    let [less, fall] = [one_less, fall].map(|x| x.raised(-2 * unit).value());
    let lowest_tilt = 2.0 * shifted(less.sqrt(), unit).atan2(more.sqrt());
    // cos θ₀ − cos θ₁ = 2 sin((θ₁ − θ₀)/2) sin((θ₁ + θ₀)/2).
    let middle = shifted(s, -unit) * (0.5 * more).sqrt() + c * (0.5 * less).sqrt();
    let half = shifted(0.5 * fall / middle, unit);
    // For a deep fall the arcsine is ill-conditioned, while the difference of the tilts loses nothing: at 60° both are right to a few units.
    let depth = if half < 0.5 {
        2.0 * half.asin()
    } else {
        // Halving the least tilt may have rounded it to zero.
        (lowest_tilt - tilt).max(0.0)
    };
    let sine = tilt.sin();
    Ok(Dip {
        lowest_height: 0.5 * (more - one_less.value()),
        lowest_tilt,
        depth,
        cycloid: Cycloid {
            radius: if square.is_zero() {
                f64::INFINITY
            } else {
                (product.quotient(square) * Extended::from_double(sine)).value()
            },
            sine,
        },
    })
}

/// The least spin Ω₃ with which a top sleeps, 2√(I₁Mgl)/I₃, rad/s (7.5).
///
/// The top sleeps if Ω₃² ≥ 4I₁Mgl/I₃². The tutorial has >; at equality f = −2I₁Mgl(1 − h)³ is still negative below h = 1,
/// and the top is still stable. Domain: I₁, I₃ > 0, Mgl ≥ 0. Error: one rounding. Cost: a square root.
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
    let number = Extended::from_double;
    let root = (number(transverse) * number(weight_moment)).square_root();
    Ok(root.times(2.0).quotient(number(axial)).value())
}

/// The greatest tilt, radians, of an upright top with L₃ that is kicked sideways with `kick` rad/s (7.5).
///
/// With u = 1 − cos θ: −2gu² + (4g − ε² − l²)u + 2ε² = 0, g = Mgl/I₁, l = L₃/I₁, ε the kick. So the tilt is proportional to ε
/// above the threshold l² = 4g, to √ε on it, and below it never less than that of cos θ = l²/2g − 1.
///
/// Domain: I₁ > 0, Mgl ≥ 0, L₃ and kick finite. Error: a few units in the last place, next to the threshold too. An upright top that is
/// not kicked stays upright. Cost: one square root of 106 bits.
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
    // 4g − l² exactly, for next to the threshold nothing else is left.
    let fall = [transverse, weight_moment];
    let above = sum_of_products(&[fall, fall, fall, fall, [l3, -l3]]);
    let linear = above.quotient(number(transverse).square()) - kick2;
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
    if one_more.is_zero() {
        return Ok(PI);
    }
    Ok(2.0 * one_less.root_of_quotient(one_more).atan())
}

/// The spherical pendulum that swings between two angles from the downward vertical, radians, starting at the smaller (7.6).
///
/// A Lagrange top with I₁ = 1 and without spin; `gravity` is Mgl/I₁ (s⁻²), which is g over the length for a bob. At the start
/// φ'² = gravity·sin²b/(sin²a cos((b−a)/2) cos((b+a)/2)). Equal angles make it a conical pendulum. The rounding of that rate moves a
/// greater angle next to π by some eps/(π − b).
///
/// Domain: 4.5·10⁻³⁰⁸ ≤ a ≤ b, a + b < π also as doubles add (the mean height of a pendulum's turning points is below the pivot), gravity > 0.
///
/// # Errors
/// [`Error::NotFinite`], [`Error::NotPositive`], [`Error::OutOfRange`] for a and b.
///
/// ```
/// use spinning_bodies::lagrange_top::{Nutation, pendulum_between};
/// let pendulum = pendulum_between(0.2, 0.5, 9.81)?;
/// assert_eq!(pendulum.kind(), Nutation::SphericalPendulum);
/// let half = 0.5 * pendulum.period();
/// let [a, b] = [pendulum.at(0.0)?, pendulum.at(half)?].map(|state| state.attitude.euler_angles().theta);
/// assert!((a + b - (2.0 * std::f64::consts::PI - 0.2 - 0.5)).abs() < 1e-14);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn pendulum_between(inner: f64, outer: f64, gravity: f64) -> Result<LagrangeTop> {
    positive("the smaller angle", inner)?;
    finite("the greater angle", outer)?;
    positive("gravity over length", gravity)?;
    let (half_sum, half_difference) = (0.5 * (inner + outer), 0.5 * (outer - inner));
    if outer < inner || half_sum >= 0.5 * PI {
        return Err(out_of_range(
            "the greater angle",
            outer,
            [inner, (PI - inner).next_down()],
        ));
    }
    // The quaternion of the start has half the angle, which must be a normal number.
    let least = 2.0 * f64::MIN_POSITIVE;
    within("the smaller angle", inner, least, 0.5 * PI)?;
    let across = outer.sin() * (gravity.sqrt() / (half_difference.cos() * half_sum.cos()).sqrt());
    let (s, c) = (0.5 * inner).sin_cos();
    let attitude = Attitude::from_quaternion(s, c, 0.0, 0.0)?;
    let omega = BodyVector::new(0.0, across, 0.0);
    LagrangeTop::new(1.0, 1.0, gravity, omega, attitude)
}

/// The spherical pendulum with these integrals (7.6): L_vert/I₁ (rad/s) and the energy over I₁ (s⁻²), zero at rest at the height of the pivot, under
/// `gravity` Mgl/I₁ (s⁻²), which is g over the length for a bob. It starts where it is lowest.
///
/// A Lagrange top with I₁ = 1 and without spin. With L_vert = 0 it is a plane pendulum; if moreover energy = gravity exactly, it approaches the upright position for ever
/// ([`Nutation::Waking`](super::Nutation::Waking)). Small swings, whose energy is next to −gravity, are better given by their angles
/// ([`pendulum_between`]). Domain: gravity > 0, every energy that a motion with this L_vert can have. Cost: that of [`LagrangeTop::from_integrals`].
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

/// The angle by which the ellipse of a spherical pendulum turns from one greatest swing to the next (7.6).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Apsides {
    /// Azimuth gained from one smallest angle to the next, less π, radians.
    pub advance: f64,
    /// (3/8)ab·π, radians: the law for small swings.
    pub small_swing: f64,
}

/// The advance of the apsides of a spherical pendulum between the angles a ≤ b, exactly and by the small-swing law (3/8)ab·π (7.6).
///
/// Both angles in radians from the downward vertical; the ellipse turns in the direction of the bob. Independent of gravity. The exact
/// advance is a difference from π, with an absolute error of some 10⁻¹⁵ rad, and of 10⁻¹⁵/(π − b)² where b is close to π. The law is too small by a fraction of about b²/6.
/// Domain as [`pendulum_between`]. Cost: preparing one Lagrange top.
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
