//! The superball (tutorial 4.6): a ball that bounces tangentially as well as normally.
//!
//! The motion is planar; a bounce reverses the velocity of the contact point and conserves energy, or keeps a part of both ([`Restitution`]). Bounces
//! are generic over the scalar: with `f64` they compute, with `num_rational::Ratio<i128>` they prove. Slipping bounces, flights and closed forms take doubles.
//!
//! ```
//! use num_rational::Ratio;
//! use spinning_bodies::superball::{Motion, UnderTable};
//!
//! let start = Motion { velocity: Ratio::from(1i128), rim_speed: Ratio::from(0) };
//! let third = UnderTable::new(start, Ratio::new(2, 5)).nth(2).unwrap();
//! assert_eq!(third.velocity, Ratio::new(-333, 343)); // it comes back out
//! ```

mod flight;
mod losses;

pub use flight::{Flight, InFlight};
pub use losses::{Restitution, bounce_with, gripping_bounce, return_threshold};

use core::f64::consts::PI;
use core::ops::{Add, Mul, Sub};

use num_rational::Ratio;
use num_traits::{CheckedAdd, CheckedDiv, CheckedMul, CheckedSub, Num};

use crate::error::{Result, finite, not_negative, positive, within};
use crate::precise::DoubleDouble;

/// Velocity and rim speed, which a bounce changes, in the same unit of speed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Motion<T> {
    /// Horizontal velocity V of the centre.
    pub velocity: T,
    /// Rim speed RΩ, positive when the ball turns as if it rolled forward on the floor.
    pub rim_speed: T,
}

/// The surface that the ball bounces off.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Surface {
    /// Below the ball: the contact point moves at V − RΩ.
    Floor,
    /// Above the ball: the contact point moves at V + RΩ.
    Ceiling,
}

impl Surface {
    /// The other surface.
    ///
    /// ```
    /// use spinning_bodies::superball::Surface;
    /// assert_eq!(Surface::Floor.opposite(), Surface::Ceiling);
    /// ```
    pub fn opposite(self) -> Self {
        match self {
            Self::Floor => Self::Ceiling,
            Self::Ceiling => Self::Floor,
        }
    }
}

impl<T> Motion<T>
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T>,
{
    const fn new(velocity: T, rim_speed: T) -> Self {
        Self {
            velocity,
            rim_speed,
        }
    }

    /// Velocity of the contact point: V − RΩ at the floor, V + RΩ at the ceiling (4.6).
    ///
    /// ```
    /// use spinning_bodies::superball::{Motion, Surface};
    /// let rolling = Motion { velocity: 2.0, rim_speed: 2.0 };
    /// assert_eq!((rolling.contact_speed(Surface::Floor), rolling.contact_speed(Surface::Ceiling)), (0.0, 4.0));
    /// ```
    pub fn contact_speed(&self, surface: Surface) -> T {
        match surface {
            Surface::Floor => self.velocity - self.rim_speed,
            Surface::Ceiling => self.velocity + self.rim_speed,
        }
    }

    /// Horizontal and rotational kinetic energy per half mass: V² + κ(RΩ)², which every bounce conserves (4.6).
    ///
    /// ```
    /// use spinning_bodies::superball::Motion;
    /// assert_eq!(Motion { velocity: 2.0, rim_speed: 3.0 }.energy(0.5), 8.5);
    /// ```
    pub fn energy(&self, kappa: T) -> T {
        self.velocity * self.velocity + kappa * self.rim_speed * self.rim_speed
    }

    /// The motion after a bounce that adds `turned` to the rim speed at the floor and subtracts it at the ceiling; V + κRΩ at the floor, V − κRΩ at the
    /// ceiling does not change.
    // ANCHOR: kicked
    fn kicked(self, surface: Surface, kappa: T, turned: T) -> Self {
        let rim_speed = match surface {
            Surface::Floor => self.rim_speed + turned,
            Surface::Ceiling => self.rim_speed - turned,
        };
        Self {
            velocity: self.velocity - kappa * turned,
            rim_speed,
        }
    }
    // ANCHOR_END: kicked
}

/// The motion after one bounce (4.6): V' − RΩ' = −(V − RΩ) at the floor, with energy conserved.
///
/// Written as increments, V' = V − 2κu/(1+κ) and RΩ' = RΩ ± 2u/(1+κ), with u the speed of the contact point, so that a ball that
/// already rolls, u = 0, is unchanged to the bit. In exact arithmetic this is [`bounce_matrix`].
///
/// `kappa` is I/(MR²), 2/5 for the ball, from 0 (all mass at the centre) to 1 (all on the rim). Numbers outside that range
/// belong to no body, but give a result. In floating point each bounce is right to a few roundings, but 1+κ is rounded the same way
/// every time, so the energy drifts in proportion to the number of bounces. Observed: at most 2e-16 a bounce (κ = 2/5:
/// 1.6e-9 after ten million). [`UnderTable`] and [`BounceRotation`] do not drift. Cost: one multiplication, one division, five additions.
///
/// With `f64` nothing panics. Fractions of fixed-width integers panic at κ = −1 and on overflow, as all their arithmetic
/// does; [`checked_bounce`] does not.
///
/// ```
/// use spinning_bodies::superball::{Motion, Surface, bounce};
/// // A hoop, κ = 1, exchanges velocity and rim speed.
/// let after = bounce(Motion { velocity: 1.0, rim_speed: 0.0 }, Surface::Floor, 1.0);
/// assert_eq!(after, Motion { velocity: 0.0, rim_speed: 1.0 });
/// ```
pub fn bounce<T: Num + Copy>(before: Motion<T>, surface: Surface, kappa: T) -> Motion<T> {
    // ANCHOR: bounce
    let slip = before.contact_speed(surface);
    before.kicked(surface, kappa, (slip + slip) / (T::one() + kappa))
    // ANCHOR_END: bounce
}

/// [`bounce`] for fractions of fixed-width integers: `None` where a numerator or denominator would overflow, or κ = −1.
///
/// For `Ratio<i128>` and κ = 2/5 the denominators are powers of seven, and the first 43 bounces fit.
///
/// ```
/// use num_rational::Ratio;
/// use spinning_bodies::superball::{Motion, Surface, checked_bounce};
/// let thrown = Motion { velocity: Ratio::new(1_i64, 1), rim_speed: Ratio::new(0, 1) };
/// let after = checked_bounce(thrown, Surface::Floor, Ratio::new(2, 5)).unwrap();
/// assert_eq!((after.velocity, after.rim_speed), (Ratio::new(3, 7), Ratio::new(10, 7)));
/// ```
pub fn checked_bounce<T>(before: Motion<T>, surface: Surface, kappa: T) -> Option<Motion<T>>
where
    T: Num + Copy + CheckedAdd + CheckedSub + CheckedMul + CheckedDiv,
{
    let slip = match surface {
        Surface::Floor => before.velocity.checked_sub(&before.rim_speed)?,
        Surface::Ceiling => before.velocity.checked_add(&before.rim_speed)?,
    };
    let turned = slip
        .checked_add(&slip)?
        .checked_div(&T::one().checked_add(&kappa)?)?;
    let rim_speed = match surface {
        Surface::Floor => before.rim_speed.checked_add(&turned)?,
        Surface::Ceiling => before.rim_speed.checked_sub(&turned)?,
    };
    let velocity = before.velocity.checked_sub(&kappa.checked_mul(&turned)?)?;
    Some(Motion::new(velocity, rim_speed))
}

/// The matrix of a bounce on the column (V, RΩ): [[1−κ, ±2κ], [±2, −(1−κ)]]/(1+κ), plus at the floor (4.6).
///
/// Indexed by row, then column. For the ball [[3, ±4], [±10, −3]]/7. Determinant −1, square 1: a reflection. Panics as [`bounce`].
///
/// ```
/// use spinning_bodies::superball::{Surface, bounce_matrix};
/// assert_eq!(bounce_matrix(Surface::Floor, 1.0), [[0.0, 1.0], [1.0, 0.0]]);
/// ```
pub fn bounce_matrix<T: Num + Copy>(surface: Surface, kappa: T) -> [[T; 2]; 2] {
    let (zero, one) = (T::zero(), T::one());
    let two = one + one;
    let whole = one + kappa;
    let diagonal = (one - kappa) / whole;
    let (upper, lower) = (two * kappa / whole, two / whole);
    match surface {
        Surface::Floor => [[diagonal, upper], [lower, zero - diagonal]],
        Surface::Ceiling => [[diagonal, zero - upper], [zero - lower, zero - diagonal]],
    }
}

/// The motions after bounces 1, 2, 3, … off floor, ceiling, floor, … (4.6). Endless.
///
/// In (V, √κ RΩ) two bounces are a rotation, and with `f64` they remain one: the motion is carried in twice the precision. The n-th
/// motion is that of the κ and the start given, to half a unit in the last place each and n·2⁻¹⁰⁰ in phase; observed after 2·10⁶ bounces, against
/// 40 digits: energy 3e-16, motion 2e-16. Cost: some ten times that of [`bounce`].
/// In fractions each step is one [`bounce`], and panics where that does: with `Ratio<i128>` after 43 bounces of the ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnderTable<T> {
    motion: Motion<T>,
    /// The low words of the motion, which rounding to doubles leaves out; zero in exact arithmetic.
    rest: Motion<T>,
    kappa: T,
    next: Surface,
}

impl<T: Num + Copy> UnderTable<T> {
    /// A ball of inertia factor `kappa` that is thrown with motion `start` and meets the floor first.
    ///
    /// ```
    /// use num_rational::Ratio;
    /// use spinning_bodies::superball::{Motion, UnderTable};
    /// let thrown = Motion { velocity: Ratio::new(1_i64, 1), rim_speed: Ratio::new(0, 1) };
    /// let mut places = UnderTable::new(thrown, Ratio::new(2, 5)).positions();
    /// assert_eq!(places.next(), Some(Ratio::new(3, 7)));
    /// ```
    pub fn new(start: Motion<T>, kappa: T) -> Self {
        Self {
            motion: start,
            rest: Motion::new(T::zero(), T::zero()),
            kappa,
            next: Surface::Floor,
        }
    }

    /// Positions x₁, x₂, x₃, … of bounces 2, 3, 4, …, from the first floor contact at x = 0.
    ///
    /// In units of (speed) × (flight time): x_n is the sum of the velocities after bounces 1…n. All flights between floor and
    /// ceiling take the same time, with gravity too, because the flight up is the flight down reversed.
    ///
    /// ```
    /// use num_rational::Ratio;
    /// use spinning_bodies::superball::{Motion, UnderTable};
    /// let thrown = Motion { velocity: Ratio::new(1_i64, 1), rim_speed: Ratio::new(0, 1) };
    /// let places: Vec<_> = UnderTable::new(thrown, Ratio::new(2, 5)).positions().take(3).collect();
    /// assert_eq!(places, [Ratio::new(3, 7), Ratio::new(-10, 49), Ratio::new(-403, 343)]);
    /// ```
    pub fn positions(self) -> impl Iterator<Item = T>
    where
        Self: Iterator<Item = Motion<T>>,
    {
        self.scan(T::zero(), |x, motion| {
            *x = *x + motion.velocity;
            Some(*x)
        })
    }
}

impl Iterator for UnderTable<f64> {
    type Item = Motion<f64>;

    fn next(&mut self) -> Option<Motion<f64>> {
        let before = Motion {
            velocity: DoubleDouble::new(self.motion.velocity, self.rest.velocity),
            rim_speed: DoubleDouble::new(self.motion.rim_speed, self.rest.rim_speed),
        };
        // As in [`bounce`].
        let slip = before.contact_speed(self.next);
        let turned = (slip + slip) / DoubleDouble::sum(1.0, self.kappa);
        let after = before.kicked(self.next, DoubleDouble::from(self.kappa), turned);
        let part =
            |of: fn(DoubleDouble) -> f64| Motion::new(of(after.velocity), of(after.rim_speed));
        (self.motion, self.rest) = (part(DoubleDouble::high), part(DoubleDouble::low));
        self.next = self.next.opposite();
        Some(self.motion)
    }
}

impl<I> Iterator for UnderTable<Ratio<I>>
where
    Ratio<I>: Num + Copy,
{
    type Item = Motion<Ratio<I>>;

    fn next(&mut self) -> Option<Motion<Ratio<I>>> {
        self.motion = bounce(self.motion, self.next, self.kappa);
        self.next = self.next.opposite();
        Some(self.motion)
    }
}

/// The bounds between which all bounces between two endless plates lie, for a ball thrown without spin: −½ ± ½√((1+κ)/κ) (4.6).
///
/// In the units of [`UnderTable::positions`], least first; for the ball −½ ± √(7/8). They follow from x_n = −½ + sin((n+½)δ)/(2 sin(δ/2)).
/// As κ → 0 the reach becomes infinite: the ball passes straight through. Error: two units in the last place.
///
/// # Errors
/// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::NotPositive`](crate::Error::NotPositive) for κ.
///
/// ```
/// let [least, most] = spinning_bodies::superball::reach(0.4)?;
/// assert!((least + 1.0 + most).abs() < 1e-15 && (most - 0.5 * (3.5_f64.sqrt() - 1.0)).abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn reach(kappa: f64) -> Result<[f64; 2]> {
    let kappa = positive("the inertia factor", kappa)?;
    let inverse = finite("the reach", kappa.recip())?;
    let width = (1.0 + inverse).sqrt();
    // ½(√(1 + 1/κ) − 1) without the difference.
    Ok([-0.5 - 0.5 * width, 0.5 * inverse / (width + 1.0)])
}

/// The sequence of bounces in closed form (4.6): in the metric of the energy a double bounce is a rotation by 2δ, cos δ = (1−κ)/(1+κ).
///
/// It works in the ring of numbers p + q√−κ, where a bounce is a conjugation followed by multiplication with g = (1−κ + 2√−κ)/(1+κ), a number of
/// modulus 1. [`Self::after`] raises g to the n-th power by squaring, in double-double arithmetic: no angle is ever formed,
/// so none has to be reduced.
#[derive(Debug, Clone, Copy)]
pub struct BounceRotation {
    kappa: DoubleDouble,
    /// p and q of the number g.
    unit: [DoubleDouble; 2],
}

impl BounceRotation {
    /// For an inertia factor given as a double.
    ///
    /// Mind that 0.4 is not 2/5: the difference of 2e-17 adds 3e-17 rad to the angle of every bounce. For fractions use
    /// [`Self::of_fraction`].
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::OutOfRange`](crate::Error::OutOfRange) outside 0…1.
    ///
    /// ```
    /// use spinning_bodies::superball::BounceRotation;
    /// assert_eq!(BounceRotation::new(1.0)?.angle(), std::f64::consts::FRAC_PI_2);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(kappa: f64) -> Result<Self> {
        Self::of(DoubleDouble::from(kappa))
    }

    /// For the inertia factor `numerator`/`denominator`, such as 2/5, to 31 digits.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) if the denominator is zero; [`Error::OutOfRange`](crate::Error::OutOfRange) outside 0…1.
    ///
    /// ```
    /// use spinning_bodies::superball::BounceRotation;
    /// let turn = BounceRotation::of_fraction(2, 5)?.angle();
    /// assert!((turn.cos() - 3.0 / 7.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn of_fraction(numerator: u32, denominator: u32) -> Result<Self> {
        let denominator = positive("the denominator", f64::from(denominator))?;
        Self::of(DoubleDouble::from(f64::from(numerator)) / DoubleDouble::from(denominator))
    }

    fn of(kappa: DoubleDouble) -> Result<Self> {
        within("the inertia factor", kappa.value(), 0.0, 1.0)?;
        let one = DoubleDouble::from(1.0);
        let whole = one + kappa;
        let unit = [(one - kappa) / whole, DoubleDouble::from(2.0) / whole];
        Ok(Self { kappa, unit })
    }

    /// Angle δ of one bounce, radians: cos δ = (1−κ)/(1+κ), formed as 2 arctan √κ. Error: 1.5 units in the last place.
    ///
    /// ```
    /// use spinning_bodies::superball::BounceRotation;
    /// // κ = 1/3: a third of a half turn.
    /// assert!((BounceRotation::of_fraction(1, 3)?.angle() - std::f64::consts::FRAC_PI_3).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn angle(&self) -> f64 {
        2.0 * self.kappa.value().sqrt().atan()
    }

    /// The motion after `bounces` bounces, floor first: V_n = V cos nδ + √κ RΩ sin nδ, and likewise the rim speed (4.6).
    ///
    /// For a start without spin these are the Chebyshev polynomials V T_n and ±2/(1+κ) V U_{n−1} at cos δ.
    /// Error: about n·2⁻¹⁰² in phase plus two units in the last place of the larger part. Observed for n = 10¹²: 3e-16. The energy is
    /// right to a few roundings for every n. Cost: at most 128 products of two pairs, whatever n. A start that is not
    /// finite gives a motion that is not finite.
    ///
    /// ```
    /// use spinning_bodies::superball::{BounceRotation, Motion};
    /// let after = BounceRotation::of_fraction(2, 5)?.after(Motion { velocity: 1.0, rim_speed: 0.0 }, 3);
    /// assert!((after.velocity + 333.0 / 343.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn after(&self, start: Motion<f64>, bounces: u64) -> Motion<f64> {
        let [p, q] = self.power(bounces);
        let kappa = self.kappa.value();
        // The modulus of g is 1; the modulus that rounding gives to the product of n factors is divided out.
        let modulus = p.mul_add(p, kappa * q * q).sqrt();
        let (p, q) = (p / modulus, q / modulus);
        let across = q * start.velocity - p * start.rim_speed;
        let even = bounces.is_multiple_of(2);
        let rim_speed = if even { -across } else { across };
        Motion::new(p * start.velocity + kappa * q * start.rim_speed, rim_speed)
    }

    /// V₁ + V₂ + … + V_n, the velocities after bounces 1…n, floor first: the position of bounce n+1, in flight times (4.6).
    ///
    /// The sum of a geometric series of rotations: with gⁿ = p + q√−κ it is ½(p − 1 + q)V + ½(κq − p + 1)RΩ, so it never leaves
    /// [`reach`]. Error and cost as [`Self::after`].
    pub(crate) fn place(&self, start: Motion<f64>, bounces: u64) -> f64 {
        let [p, q] = self.power(bounces);
        let kappa = self.kappa.value();
        0.5 * ((p - 1.0 + q) * start.velocity + (kappa * q - p + 1.0) * start.rim_speed)
    }

    fn power(&self, mut exponent: u64) -> [f64; 2] {
        let mut power = [DoubleDouble::from(1.0), DoubleDouble::from(0.0)];
        let mut square = self.unit;
        while exponent > 0 {
            if exponent % 2 == 1 {
                power = self.product(power, square);
            }
            square = self.product(square, square);
            exponent /= 2;
        }
        power.map(DoubleDouble::value)
    }

    /// (p + q√−κ)(r + s√−κ).
    fn product(&self, [p, q]: [DoubleDouble; 2], [r, s]: [DoubleDouble; 2]) -> [DoubleDouble; 2] {
        [p * r - self.kappa * (q * s), p * s + q * r]
    }
}

/// The result of a bounce through a contact with two springs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpringBounce {
    /// The motion as the ball leaves the surface.
    pub motion: Motion<f64>,
    /// Energy that stays in the stretched tangential spring, as a fraction of that of the contact speed,
    /// dimensionless in 0…1; it is lost to the ball.
    pub kept_by_spring: f64,
}

/// A bounce through a contact with a linear spring across the surface and one along it (4.6, a mechanism for it).
///
/// The normal spring k_n holds the ball for half of its period; in that time the contact speed u swings as a cosine on the
/// tangential spring k_t. `tuning` is k_t over κk_n/(1+κ), dimensionless: at 1 both half-periods agree, u is reversed
/// and this is [`bounce`], exactly; otherwise u' = u cos(π√tuning) and energy remains in the spring. 0 is a frictionless surface.
/// Error: a few units in the last place times (1 + √tuning).
///
/// # Errors
/// [`Error::NotFinite`](crate::Error::NotFinite), also for speeds that overflow; [`Error::NotPositive`](crate::Error::NotPositive) for κ;
/// [`Error::Negative`](crate::Error::Negative) for the tuning.
///
/// ```
/// use spinning_bodies::superball::{Motion, Surface, spring_bounce};
/// let thrown = Motion { velocity: 1.0, rim_speed: 0.0 };
/// let tuned = spring_bounce(thrown, Surface::Floor, 0.4, 1.0)?;
/// assert!((tuned.motion.velocity - 3.0 / 7.0).abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn spring_bounce(
    before: Motion<f64>,
    surface: Surface,
    kappa: f64,
    tuning: f64,
) -> Result<SpringBounce> {
    let kappa = positive("the inertia factor", kappa)?;
    let half_phase = 0.5 * PI * not_negative("the tuning", tuning)?.sqrt();
    finite("the velocity", before.velocity)?;
    finite("the rim speed", before.rim_speed)?;
    let (sin, cos) = half_phase.sin_cos();
    // 1 − cos of the whole phase, over 2: the part of the full bounce that takes place.
    let part = sin * sin;
    let slip = before.contact_speed(surface);
    let motion = before.kicked(surface, kappa, part * (slip + slip) / (1.0 + kappa));
    finite("the velocity after the bounce", motion.velocity)?;
    finite("the rim speed after the bounce", motion.rim_speed)?;
    Ok(SpringBounce {
        motion,
        kept_by_spring: (2.0 * sin * cos).powi(2),
    })
}
