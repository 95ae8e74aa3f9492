//! The hoop with clay: the tutorial's estimate of how fast it tips over, and a refinement of it.

use super::bodies::{height, offset};
use crate::error::{Result, positive};
use crate::frame::SpaceVector;
use crate::precise::{Extended, Number};

/// The hoop with clay of tutorial 4.7: radius R, inertia I about C in every direction, C a distance ε = α R from the centre of curvature K,
/// sliding with friction μ M g.
///
/// θ is the angle between L, which is vertical, and the axis from C to K. The axes of the picture: x to the right, y into the page, z up; C is
/// below K and to the left of it, so that e = (sin θ, 0, cos θ).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HoopWithClay {
    mass: f64,
    radius: f64,
    alpha: f64,
    /// μ M g, N.
    friction: f64,
    /// R μ M g/I, s⁻².
    tipping: f64,
    /// μ g/R, s⁻².
    grip: f64,
}

impl HoopWithClay {
    /// The hoop of this mass (kg), radius (m), α = ε/R, I/(M R²), μ, g (m/s²).
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite), also if friction, R μ M g/I or μ g/R leaves the range of doubles; [`Error::OutOfRange`](crate::Error::OutOfRange) unless 0 ≤ α < 1.
    ///
    /// ```
    /// use spinning_bodies::tippe_top::HoopWithClay;
    /// assert!(HoopWithClay::new(1.0, 1.0, 0.5, 0.5, 0.125, 8.0).is_ok() && HoopWithClay::new(1.0, 1.0, 1.5, 0.5, 0.125, 8.0).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(
        mass: f64,
        radius: f64,
        alpha: f64,
        inertia_factor: f64,
        mu: f64,
        gravity: f64,
    ) -> Result<Self> {
        let mass = positive("the mass", mass)?;
        let radius = positive("the radius", radius)?;
        let factor = positive("the moment of inertia over M R²", inertia_factor)?;
        offset(alpha)?;
        let mu = positive("the coefficient of friction", mu)?;
        let gravity = positive("gravity", gravity)?;
        // Intermediate products may leave the range of doubles where the quotient does not.
        let number = Extended::from_double;
        let deceleration = number(mu) * number(gravity);
        let grip = deceleration.quotient(number(radius));
        let tipping = grip.quotient(number(factor)).value();
        let friction = (deceleration * number(mass)).value();
        Ok(Self {
            mass,
            radius,
            alpha,
            friction: positive("friction, μ M g", friction)?,
            tipping: positive("R μ M g/I", tipping)?,
            grip: positive("μ g/R", grip.value())?,
        })
    }

    /// CO, from C to the point of contact, in the picture's axes, m: r = ε e − R z.
    fn arm(&self, tilt: f64) -> SpaceVector {
        let across = self.alpha * self.radius * tilt.sin();
        SpaceVector::new(across, 0.0, -self.radius * height(self.alpha, tilt))
    }

    /// Velocity of the point of contact, Ω∧r (m/s), for upward spin Ω (rad/s): Ω ε sin θ, into the page. The motion of C is left out.
    ///
    /// ```
    /// use spinning_bodies::tippe_top::HoopWithClay;
    /// let hoop = HoopWithClay::new(1.0, 1.0, 0.5, 0.5, 0.125, 8.0)?; // I = ½ kg m², f = 1 N
    /// assert_eq!(hoop.slip(std::f64::consts::FRAC_PI_2, 2.0).y(), 1.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn slip(&self, tilt: f64, spin: f64) -> SpaceVector {
        SpaceVector::new(0.0, 0.0, spin).cross(&self.arm(tilt))
    }

    /// Torque of friction about C (N m), with friction out of the page: N = −f (R − ε cos θ) x − f ε sin θ z.
    ///
    /// ```
    /// use spinning_bodies::tippe_top::HoopWithClay;
    /// let hoop = HoopWithClay::new(1.0, 1.0, 0.5, 0.5, 0.125, 8.0)?; // I = ½ kg m², f = 1 N
    /// assert_eq!(hoop.torque(0.0).x(), -0.5);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn torque(&self, tilt: f64) -> SpaceVector {
        self.arm(tilt)
            .cross(&SpaceVector::new(0.0, -self.friction, 0.0))
    }

    /// The tutorial's estimate dθ/dt ≈ R μ M g/(I Ω), rad/s. Domain: Ω > 0 with ε Ω² ≫ μ g.
    ///
    /// ```
    /// use spinning_bodies::tippe_top::HoopWithClay;
    /// let hoop = HoopWithClay::new(1.0, 1.0, 0.5, 0.5, 0.125, 8.0)?; // I = ½ kg m², f = 1 N
    /// assert_eq!(hoop.tip_rate(4.0), 0.5);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn tip_rate(&self, spin: f64) -> f64 {
        self.tipping / spin
    }

    /// The tutorial's time to tip over, π I Ω/(R μ M g), s.
    ///
    /// ```
    /// use spinning_bodies::tippe_top::HoopWithClay;
    /// let hoop = HoopWithClay::new(1.0, 1.0, 0.5, 0.5, 0.125, 8.0)?; // I = ½ kg m², f = 1 N
    /// assert_eq!(hoop.tip_over_time(4.0), 2.0 * std::f64::consts::PI);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn tip_over_time(&self, spin: f64) -> f64 {
        core::f64::consts::PI / self.tip_rate(spin)
    }

    /// dθ/dt with |L| from the constancy of Jellett's integral J, f (R − ε cos θ)²/J, rad/s; J = I Ω (R − ε cos θ₀) for spin Ω about the vertical at
    /// tilt θ₀.
    ///
    /// ```
    /// use spinning_bodies::tippe_top::HoopWithClay;
    /// let hoop = HoopWithClay::new(1.0, 1.0, 0.5, 0.5, 0.125, 8.0)?; // I = ½ kg m², f = 1 N
    /// // Upright the arm is only R − ε, half of the R in the estimate.
    /// assert_eq!(hoop.refined_rate(4.0, 0.0, 0.0), 0.25);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn refined_rate(&self, spin: f64, start: f64, tilt: f64) -> f64 {
        self.tip_rate(spin) * height(self.alpha, tilt) * self.spin_ratio(tilt, start)
    }

    /// Time from tilt θ₀, where the spin about the vertical is Ω, to tilt θ₁ with [`refined_rate`](Self::refined_rate): s.
    ///
    /// In closed form, to rounding for a short way as well; but the relative error grows like (1−α)^(−3/2) as α approaches 1. From 0 to π it is [`tip_over_time`](Self::tip_over_time) × (1+α)^(−3/2) (1−α)^(−1/2). Domain: 0 ≤ θ₀, θ₁ ≤ π, and a rate of tipping in the range of doubles.
    ///
    /// ```
    /// use spinning_bodies::tippe_top::HoopWithClay;
    /// let hoop = HoopWithClay::new(1.0, 1.0, 0.5, 0.5, 0.125, 8.0)?; // I = ½ kg m², f = 1 N
    /// let time = hoop.refined_time(4.0, 0.0, std::f64::consts::PI);
    /// assert!((time / hoop.tip_over_time(4.0) - 1.5_f64.powf(-1.5) * 0.5_f64.powf(-0.5)).abs() < 1e-15);
    /// // A short way, at the rate that it begins with.
    /// let way = (1.0 + 1e-9) - 1.0;
    /// let time = hoop.refined_time(4.0, 1.0, 1.0 + 1e-9);
    /// assert!((time * hoop.refined_rate(4.0, 1.0, 1.0) / way - 1.0).abs() < 2e-9);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn refined_time(&self, spin: f64, start: f64, end: f64) -> f64 {
        let a = self.alpha;
        let (low, high) = (1.0 - a, 1.0 + a);
        let [(s, c), (sin, cos)] = [start, end].map(|tilt| (0.5 * tilt).sin_cos());
        // With tan v/2 = √((1+α)/(1−α)) tan θ/2 the integral of 1/(1 − α cos θ)² is that of (1 + α cos v)/(1 − α²)^(3/2). Half the way in v, and its middle:
        let root = (low * high).sqrt();
        let half = (root * (0.5 * (end - start)).sin()).atan2(low * c * cos + high * s * sin);
        let middle = 2.0 * (high.sqrt() * s).atan2(low.sqrt() * c) + half;
        let integral = 2.0 * (half + a * half.sin() * middle.cos()) / (low * high * root);
        integral * height(self.alpha, start) / self.tip_rate(spin)
    }

    /// |L| at tilt θ₁ over |L| at θ₀, by Jellett's integral: (1 − α cos θ₀)/(1 − α cos θ₁).
    ///
    /// ```
    /// use spinning_bodies::tippe_top::HoopWithClay;
    /// let hoop = HoopWithClay::new(1.0, 1.0, 0.5, 0.5, 0.125, 8.0)?; // I = ½ kg m², f = 1 N
    /// assert!((hoop.spin_ratio(0.0, std::f64::consts::PI) - 1.0 / 3.0).abs() < 1e-16);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn spin_ratio(&self, start: f64, end: f64) -> f64 {
        height(self.alpha, start) / height(self.alpha, end)
    }

    /// ε Ω²/(μ g), which must be large for the estimate, so that the slip keeps its direction.
    ///
    /// ```
    /// use spinning_bodies::tippe_top::HoopWithClay;
    /// let hoop = HoopWithClay::new(1.0, 1.0, 0.5, 0.5, 0.125, 8.0)?; // I = ½ kg m², f = 1 N
    /// assert_eq!(hoop.validity(4.0), 8.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn validity(&self, spin: f64) -> f64 {
        self.alpha * spin * (spin / self.grip)
    }

    /// Centrifugal potential −½ M Ω² ε² sin² θ (J), least for a horizontal axis: centrifugal force alone would bring C to that height from both sides, and no higher.
    ///
    /// ```
    /// use spinning_bodies::tippe_top::HoopWithClay;
    /// let hoop = HoopWithClay::new(1.0, 1.0, 0.5, 0.5, 0.125, 8.0)?; // I = ½ kg m², f = 1 N
    /// assert_eq!(hoop.centrifugal_potential(std::f64::consts::FRAC_PI_2, 2.0), -0.5);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn centrifugal_potential(&self, tilt: f64, spin: f64) -> f64 {
        let arm = self.alpha * self.radius * tilt.sin() * spin;
        -0.5 * self.mass * arm * arm
    }
}
