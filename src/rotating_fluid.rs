//! A rotating star of uniform density (tutorial 3.5): Maclaurin's spheroids and where Jacobi's ellipsoids branch off.
//!
//! The inertia matrix of a body that can deform depends on its motion. The simplest star, a
//! self-gravitating fluid of uniform density ρ turning at Ω, can settle into an ellipsoid whose shape depends on
//! one number, Ω²/(πGρ).
//!
//! ```
//! use spinning_bodies::rotating_fluid::MaclaurinSpheroid;
//!
//! let star = MaclaurinSpheroid::from_eccentricity(0.6)?;
//! assert!((star.rotation - 0.201_352_059_619_914_1).abs() < 1e-16);
//! # Ok::<(), spinning_bodies::Error>(())
//! ```

use core::convert::Infallible;
use core::f64::consts::FRAC_PI_2;

use crate::error::{Result, within};
use crate::search::halved;

/// An oblate spheroid in equilibrium: semi-axes a = b > c, turning about c.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MaclaurinSpheroid {
    /// Eccentricity e of the meridian.
    pub eccentricity: f64,
    /// Polar over equatorial axis c/a = √(1 − e²).
    pub axis_ratio: f64,
    /// Ω²/(πGρ) = 2√(1−e²)(3−2e²) arcsin(e)/e³ − 6(1−e²)/e² (Maclaurin 1742; tutorial 3.5), dimensionless.
    ///
    /// The textbook form above subtracts two numbers near 6/e² to get 8e²/15 and has no digit left at e = 10⁻⁴. The
    /// same function is (8/15) e² q (2/(1+q))^{5/2} ₂F₁(½, ½; 7/2; (1−q)/2) with q = c/a: a quadratic transformation of
    /// Gauss brings the argument down to 0…½, every term is positive, and nothing is subtracted.
    ///
    /// Domain: all spheroids; 0 for the sphere, → πq for the disc. Observed error: at most 8 ulp against 30 digits
    /// over e from 10⁻⁸ to 1 − 10⁻⁹. Cost: 36 terms of a series.
    pub rotation: f64,
    /// Kinetic over gravitational energy T/|W| = (3/(2e²))[1 − e√(1−e²)/arcsin e] − 1, dimensionless, 0…½.
    ///
    /// Computed as Ω²e/(4q arcsin e), with Ω² in units of πGρ: the same by algebra, without the subtraction. Observed error: at most 9 ulp, over the same e.
    pub energy_ratio: f64,
    /// Angular momentum L/√(GM³ā), dimensionless, with ā = (a²c)^{1/3}: (√3/5)(a/ā)² Ω/√(πGρ).
    ///
    /// It grows with e without bound, although Ω does not: beyond the fastest spheroid, more angular momentum goes with slower rotation.
    pub angular_momentum: f64,
}

impl MaclaurinSpheroid {
    /// The spheroid whose meridian has eccentricity e = √(1 − c²/a²), dimensionless, 0 ≤ e < 1.
    ///
    /// Near e = 1 the axis ratio suffers from the rounding of e; use [`MaclaurinSpheroid::from_axis_ratio`] there.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::OutOfRange`](crate::Error::OutOfRange).
    ///
    /// ```
    /// use spinning_bodies::rotating_fluid::MaclaurinSpheroid;
    /// assert!((MaclaurinSpheroid::from_eccentricity(0.6)?.axis_ratio - 0.8).abs() < 1e-16);
    /// // Newton's 8e²/15 for a star that is nearly round.
    /// let rotation = MaclaurinSpheroid::from_eccentricity(1e-4)?.rotation;
    /// assert!((rotation / (8e-8 / 15.0) - 1.0).abs() < 1e-8);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn from_eccentricity(e: f64) -> Result<Self> {
        let below_one = 1.0_f64.next_down();
        let e = within("the eccentricity of a spheroid", e, 0.0, below_one)?;
        Ok(Self::of([e, ((1.0 - e) * (1.0 + e)).sqrt()], e * e))
    }

    /// The spheroid with polar over equatorial axis c/a, dimensionless, 0 < c/a ≤ 1.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::OutOfRange`](crate::Error::OutOfRange).
    ///
    /// ```
    /// use spinning_bodies::rotating_fluid::MaclaurinSpheroid;
    /// assert!((MaclaurinSpheroid::from_axis_ratio(0.8)?.eccentricity - 0.6).abs() < 2e-16);
    /// // The kinetic energy of the disc is half its gravitational energy, that of the sphere zero.
    /// assert!((MaclaurinSpheroid::from_axis_ratio(1e-9)?.energy_ratio - 0.5).abs() < 1e-8);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn from_axis_ratio(c_over_a: f64) -> Result<Self> {
        let least = f64::MIN_POSITIVE;
        let q = within("the axis ratio of a spheroid", c_over_a, least, 1.0)?;
        Ok(Self::from_ratio(q))
    }

    /// The spheroid that turns fastest: e = 0.92995568545623299418 (Ω²/(πGρ) = 0.449331412…), where dΩ²/de = 0.
    ///
    /// With t = e/√(1−e²) the derivative vanishes where (9+t²) arctan t = t(9+7t²)/(1+t²); found by bisection to the
    /// last place of t. A search for the highest Ω² would lose half the digits. Cost: 60 arctangents.
    ///
    /// ```
    /// use spinning_bodies::rotating_fluid::MaclaurinSpheroid;
    /// assert!((MaclaurinSpheroid::fastest().eccentricity - 0.929_955_685_456_233).abs() < 1e-15);
    /// ```
    pub fn fastest() -> Self {
        let slope = |t: f64| (9.0 + t * t) * t.atan() - t * (9.0 + 7.0 * t * t) / (1.0 + t * t);
        let Ok([below, above]) = halved([2.0, 3.0], 0.0, |t| Ok::<_, Infallible>(slope(t) < 0.0));
        let t = 0.5 * (below + above);
        let secant = 1.0_f64.hypot(t);
        let e = t / secant;
        Self::of([e, 1.0 / secant], e * e)
    }

    /// The spheroid at which Jacobi's ellipsoids with three unequal axes branch off: e = 0.81267001061174294948 (Ω²/(πGρ) = 0.374229674…).
    ///
    /// The condition a⁴A₁₁ = c²A₃, that of [`JacobiEllipsoid`] at b = a, is solved for c/a. Beyond it a star with any
    /// viscosity turns into a Jacobi ellipsoid, which has the same angular momentum and less energy. Observed error: e is the double nearest the true value.
    ///
    /// ```
    /// use spinning_bodies::rotating_fluid::MaclaurinSpheroid;
    /// let branch = MaclaurinSpheroid::at_jacobi_bifurcation();
    /// assert!((branch.eccentricity - 0.812_670_010_611_743).abs() < 1e-15);
    /// ```
    pub fn at_jacobi_bifurcation() -> Self {
        Self::from_ratio(equilibrium_axis_ratio(1.0))
    }

    fn from_ratio(q: f64) -> Self {
        let square = (1.0 - q) * (1.0 + q);
        Self::of([square.sqrt(), q], square)
    }

    /// From e and q = c/a, with `square` = e² to full precision.
    fn of([e, q]: [f64; 2], square: f64) -> Self {
        // ANCHOR: maclaurin
        let x = square / (2.0 * (1.0 + q)); // (1 − q)/2 from e², without the subtraction
        let series = hypergeometric_half_half_seven_halves(x);
        let shape = 8.0 / 15.0 * q * (2.0 / (1.0 + q)).powf(2.5) * series;
        let rotation = square * shape;
        // ANCHOR_END: maclaurin
        let energy_ratio = if e == 0.0 {
            0.0
        } else {
            // arcsin e, accurate at both ends
            rotation / q * (e / (4.0 * e.atan2(q)))
        };
        Self {
            eccentricity: e,
            axis_ratio: q,
            rotation,
            energy_ratio,
            // Of a star so round that the square of e underflows, the root does not.
            angular_momentum: 3.0_f64.sqrt() / 5.0 * q.cbrt().powi(-2) * (e * shape.sqrt()),
        }
    }
}

/// An ellipsoid in equilibrium with semi-axes a ≥ b > c, turning about c (Jacobi 1834).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JacobiEllipsoid {
    /// The semi-axes over the longest one: (1, b/a, c/a), dimensionless.
    pub axes: [f64; 3],
    /// Ω²/(πGρ) = 2B₁₂ = 2abc ∫₀^∞ u du/(Δ(a²+u)(b²+u)), Δ² = (a²+u)(b²+u)(c²+u), dimensionless. It falls as the ellipsoid grows longer.
    pub rotation: f64,
    /// Angular momentum L/√(GM³ā), ā = (abc)^{1/3}, dimensionless: (√3/10)((a²+b²)/ā²) Ω/√(πGρ). It rises as the ellipsoid grows longer.
    pub angular_momentum: f64,
}

impl JacobiEllipsoid {
    /// The ellipsoid with middle over longest axis b/a, dimensionless, 10⁻³ ≤ b/a ≤ 1; at 1 it is the
    /// [bifurcating spheroid](MaclaurinSpheroid::at_jacobi_bifurcation).
    ///
    /// The shortest axis solves a²b²A₁₂ = c²A₃ (Chandrasekhar 1969), written as one integral so that b = a needs no
    /// limit. Observed relative error over 1200 ellipsoids: of c/a 3·10⁻¹⁶, of Ω² 1.8·10⁻¹⁵ for b/a ≥ 0.002, growing to 3·10⁻¹⁴ at 0.001,
    /// against Carlson's integrals in 40 digits. Cost: about 55 bisections of 221 integrand values.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::OutOfRange`](crate::Error::OutOfRange).
    ///
    /// ```
    /// use spinning_bodies::rotating_fluid::{JacobiEllipsoid, MaclaurinSpheroid};
    /// let (round, branch) = (JacobiEllipsoid::from_axis_ratio(1.0)?, MaclaurinSpheroid::at_jacobi_bifurcation());
    /// assert!((round.rotation - branch.rotation).abs() < 1e-14);
    /// let [stout, slender] = [JacobiEllipsoid::from_axis_ratio(0.9)?, JacobiEllipsoid::from_axis_ratio(0.3)?];
    /// assert!(slender.rotation < stout.rotation && slender.angular_momentum > stout.angular_momentum);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn from_axis_ratio(b_over_a: f64) -> Result<Self> {
        let quantity = "the axis ratio b/a of a Jacobi ellipsoid";
        let b = within(quantity, b_over_a, 1e-3, 1.0)?;
        let c = equilibrium_axis_ratio(b);
        let axes = [1.0, b, c];
        let rotation = 2.0 * potential_integral(axes, |u, [a, b, _]| u / ((a + u) * (b + u)));
        let mean = (b * c).cbrt();
        let angular_momentum =
            3.0_f64.sqrt() / 10.0 * (1.0 + b * b) / (mean * mean) * rotation.sqrt();
        Ok(Self {
            axes,
            rotation,
            angular_momentum,
        })
    }
}

/// ₂F₁(½, ½; 7/2; x) for 0 ≤ x ≤ ½: positive terms, each less than half the one before, the small ones first.
fn hypergeometric_half_half_seven_halves(x: f64) -> f64 {
    (0..36).rev().map(f64::from).fold(1.0, |rest, j| {
        1.0 + (j + 0.5) * (j + 0.5) / ((j + 3.5) * (j + 1.0)) * x * rest
    })
}

/// c/a of the equilibrium ellipsoid with a = 1 and this b: the root of a²b²A₁₂ − c²A₃, positive at c = 0, negative at c = b.
fn equilibrium_axis_ratio(b: f64) -> f64 {
    let excess = |c: f64| {
        potential_integral([1.0, b, c], |u, [aa, bb, cc]| {
            aa * bb / ((aa + u) * (bb + u)) - cc / (cc + u)
        })
    };
    let Ok([below, above]) = halved([1e-3 * b, b], 0.0, |c| {
        Ok::<_, Infallible>(excess(c) >= 0.0)
    });
    0.5 * (below + above)
}

/// abc ∫₀^∞ `factor`(u, [a², b², c²]) du/Δ by the trapezoidal rule in x, u = exp(π/2 sinh x) (Takahasi & Mori 1974).
///
/// The substitution makes the integrand fall doubly exponentially at both ends, so that the plain trapezoidal sum
/// converges geometrically: halving the step of 1/24 changes the Jacobi axes by less than 10⁻¹⁵.
fn potential_integral(axes: [f64; 3], factor: impl Fn(f64, [f64; 3]) -> f64) -> f64 {
    const STEP: f64 = 1.0 / 24.0;
    const REACH: i32 = 110;
    let squares = axes.map(|axis| axis * axis);
    let mut sum = 0.0;
    for i in -REACH..=REACH {
        let x = STEP * f64::from(i);
        let u = (FRAC_PI_2 * x.sinh()).exp();
        let delta: f64 = squares.iter().map(|square| (square + u).sqrt()).product();
        sum += factor(u, squares) / delta * u * FRAC_PI_2 * x.cosh();
    }
    axes.iter().product::<f64>() * STEP * sum
}
