//! How a yo-yo works (tutorial 4.9): unwinding, the turn at the end of the string, the sleep.
//!
//! | phase | module item | solved by |
//! |---|---|---|
//! | down and up | [`Unwinding`] | constant acceleration (thin string); an elliptic integral of the second kind (thick string) |
//! | the turn | [`Turn`] | half a revolution of a physical pendulum: Jacobi functions |
//! | asleep | [`sleeping_spin`] | elementary |
//!
//! Depth is measured down from the position with the string fully wound, and energy is zero at rest there. SI units.

mod sleep;
mod turn;
mod unwinding;

pub use sleep::{sleeping_spin, spin_after_waking};
pub use turn::{Turn, TurnState};
pub use unwinding::Unwinding;

use crate::error::{Result, finite, positive, within};

/// A yo-yo: two discs on an axle, a string wound round it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YoYo {
    /// Mass, kg.
    pub(crate) mass: f64,
    /// Moment of inertia about the axle, kg m².
    pub(crate) inertia: f64,
    /// Length of the string, m.
    pub(crate) length: f64,
    /// Radius of the axle, m.
    pub(crate) axle: f64,
    /// r_w², m²: at the depth x the string leaves at a radius r(x) with r² = r_w² − q x.
    wound_squared: f64,
    /// q = −d(r²)/dx, m; 0 for a thin string.
    pub(crate) slope: f64,
}

impl YoYo {
    /// A yo-yo of this mass (kg) and moment of inertia about its axle (kg m²), on a thin string of this length (m) round an axle of this radius (m).
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::NotPositive`](crate::Error::NotPositive);
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) for an axle thicker than half the length of the string.
    ///
    /// ```
    /// use spinning_bodies::yo_yo::YoYo;
    /// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
    /// assert!((toy.acceleration(0.0, 0.0, 8.0) - 2.0).abs() < 1e-15); // g/(1 + 3)
    /// // r² overflows, or is nothing; I/m overflows.
    /// assert!(YoYo::new(1.0, 3e-4, 1e250, 1e200).is_err() && YoYo::new(1.0, 3e-4, 1.0, 1e-200).is_err());
    /// assert!(YoYo::new(1e-200, 1e200, 1.0, 0.01).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(mass: f64, inertia: f64, length: f64, axle: f64) -> Result<Self> {
        let length = positive("the length of the string", length)?;
        let axle = positive("the radius of the axle", axle)?;
        within("the radius of the axle", axle, 0.0, 0.5 * length)?;
        let toy = Self {
            mass: positive("the mass of the yo-yo", mass)?,
            inertia: positive("the moment of inertia of the yo-yo", inertia)?,
            length,
            axle,
            wound_squared: positive("the square of the radius of the axle", axle * axle)?,
            slope: 0.0,
        };
        finite("the inertia over the mass", toy.gyration_squared())?;
        Ok(toy)
    }

    /// A solid disc of this mass (kg) and radius (m), I = mR²/2; the rest as for [`new`](Self::new).
    ///
    /// # Errors
    /// As [`new`](Self::new).
    ///
    /// ```
    /// use spinning_bodies::yo_yo::YoYo;
    /// assert!((YoYo::disc(2.0, 0.1, 1.0, 0.01)?.acceleration(0.0, 0.0, 51.0) - 1.0).abs() < 1e-13); // I = 50 m r²
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn disc(mass: f64, radius: f64, length: f64, axle: f64) -> Result<Self> {
        let radius = positive("the radius of the yo-yo", radius)?;
        Self::new(mass, 0.5 * mass * radius * radius, length, axle)
    }

    /// The same with a string so thick that, fully wound, it reaches this radius (m): r(x)² = r_w² − (r_w² − r₀²)x/l.
    ///
    /// The cross-section of the wound string shrinks in proportion to the length unwound.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::OutOfRange`](crate::Error::OutOfRange) below the radius of the axle or beyond half the length.
    ///
    /// ```
    /// use spinning_bodies::yo_yo::YoYo;
    /// let thick = YoYo::new(1.0, 3e-4, 1.0, 0.01)?.wound_to(0.02)?;
    /// assert_eq!((thick.radius(0.0), thick.radius(1.0)), (0.02, 0.01));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn wound_to(mut self, radius: f64) -> Result<Self> {
        let most = 0.5 * self.length;
        within("the radius of the wound string", radius, self.axle, most)?;
        self.wound_squared = finite("the square of the radius", radius * radius)?;
        self.slope = (radius - self.axle) * (radius + self.axle) / self.length;
        Ok(self)
    }

    /// k² = I/m, m².
    pub(crate) fn gyration_squared(&self) -> f64 {
        self.inertia / self.mass
    }

    /// n = m g r/(I + m r²) with r the radius of the axle, s⁻²: half the increase of ω² in a fall by that radius at the end of the string.
    pub(crate) fn pull(&self, gravity: f64) -> f64 {
        let r = self.axle;
        gravity * r / (r * r + self.gyration_squared())
    }

    /// r², m², at a depth; above the hand and below the end of the string that of the nearer one.
    pub(crate) fn radius_squared(&self, depth: f64) -> f64 {
        let depth = depth.clamp(0.0, self.length);
        // Counted from the nearer end, so that both ends are exact.
        if depth < 0.5 * self.length {
            self.wound_squared - self.slope * depth
        } else {
            self.axle * self.axle + self.slope * (self.length - depth)
        }
    }

    /// The radius at which the string leaves, m, at a depth between 0 and the length of the string.
    ///
    /// ```
    /// use spinning_bodies::yo_yo::YoYo;
    /// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
    /// assert_eq!(toy.radius(0.7), 0.01);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn radius(&self, depth: f64) -> f64 {
        self.radius_squared(depth).sqrt()
    }

    /// Downward acceleration, m/s², at this depth and spin (rad/s); it is the same going down and going up.
    ///
    /// (g r² − q k² ω²/2)/(r² + k²) with q = −d(r²)/dx; on a thin string g/(1 + I/(m r²)).
    ///
    /// ```
    /// use spinning_bodies::yo_yo::YoYo;
    /// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
    /// assert!((toy.acceleration(0.5, 100.0, 8.0) - 2.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn acceleration(&self, depth: f64, omega: f64, gravity: f64) -> f64 {
        let square = self.radius_squared(depth);
        let brake = 0.5 * self.slope * self.gyration_squared() * omega * omega;
        (gravity * square - brake) / (square + self.gyration_squared())
    }

    /// Tension of the string m(g − a), N, while it unwinds or winds.
    ///
    /// Formed as m(g k² + q k² ω²/2)/(r² + k²), where nothing cancels.
    ///
    /// ```
    /// use spinning_bodies::yo_yo::YoYo;
    /// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
    /// assert!((toy.tension(0.5, 100.0, 8.0) - 6.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn tension(&self, depth: f64, omega: f64, gravity: f64) -> f64 {
        let square = self.radius_squared(depth);
        let pull = gravity + 0.5 * self.slope * omega * omega;
        self.inertia * pull / (square + self.gyration_squared())
    }

    /// Kinetic energy ½(I + m r²)ω², J, with the radius at this depth.
    ///
    /// ```
    /// use spinning_bodies::yo_yo::YoYo;
    /// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
    /// assert!((toy.kinetic_energy(0.5, 100.0) - 2.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn kinetic_energy(&self, depth: f64, omega: f64) -> f64 {
        let square = self.radius_squared(depth);
        0.5 * (self.inertia + self.mass * square) * omega * omega
    }
}
