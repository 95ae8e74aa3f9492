//! The paper cat: it turns over like a shuttlecock, not like a real cat (tutorial 1.1).

use crate::error::{Result, finite, positive};

/// A folded sheet of paper whose centre of mass lies below the point at which the air pushes.
///
/// The model has one angle, the tilt a from feet-down, and the velocity of fall v: v′ = g − q/m and m k² a″ = −q d sin a − c|v|a′, with
/// q = ½ρSC v|v|. Air and gravity are effects of the scene; this type has the cat and the forces of the air on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PaperCat {
    /// Mass m, kg.
    pub mass: f64,
    /// Area S of the sheet, m².
    pub area: f64,
    /// Height d of the centre of pressure above the centre of mass, m, when the feet are down.
    pub lever: f64,
    /// Radius of gyration k, m.
    pub gyration: f64,
    /// Normal force coefficient C.
    pub coefficient: f64,
    /// Damping length squared, m²: the air resists turning with ½ρSC·(this)·|v|a′.
    pub damping: f64,
}

impl PaperCat {
    /// A cat cut from a postcard: 1.2 g, 40 cm², lever 6 mm, radius of gyration 2 cm.
    pub const POSTCARD: Self = Self {
        mass: 1.2e-3,
        area: 40e-4,
        lever: 6e-3,
        gyration: 2e-2,
        coefficient: 1.2,
        damping: 4e-4,
    };

    /// The same cat, if its numbers are admissible.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite); the lever may have any sign.
    pub(crate) fn checked(self) -> Result<Self> {
        positive("the mass", self.mass)?;
        positive("the area", self.area)?;
        positive("the radius of gyration", self.gyration)?;
        positive("the normal force coefficient", self.coefficient)?;
        positive("the damping", self.damping)?;
        finite("the lever", self.lever)?;
        Ok(self)
    }

    /// ½ρSC, kg/m, in air of density `air` (kg/m³).
    fn grip(&self, air: f64) -> f64 {
        0.5 * air * self.area * self.coefficient
    }

    /// The speed, m/s, at which air of density `air` (kg/m³) carries the weight under gravity `g` (m/s²): √(2mg/ρSC). For ρSC in the range of doubles.
    ///
    /// ```
    /// use spinning_bodies::phenomena::PaperCat;
    /// let speed = PaperCat::POSTCARD.terminal_speed(1.2, 9.81);
    /// assert!((speed * speed - 2.0 * 1.2e-3 * 9.81 / (1.2 * 40e-4 * 1.2)).abs() < 1e-14);
    /// ```
    pub fn terminal_speed(&self, air: f64, g: f64) -> f64 {
        (self.mass * g / self.grip(air)).sqrt()
    }

    /// Deceleration by the air, m/s², at this velocity of fall: q/m.
    pub(crate) fn drag(&self, air: f64, velocity: f64) -> f64 {
        self.grip(air) * velocity * velocity.abs() / self.mass
    }

    /// Angular acceleration by the air, rad/s².
    ///
    /// ```
    /// use spinning_bodies::phenomena::PaperCat;
    /// // Tilted one way, it is turned the other way.
    /// assert!(PaperCat::POSTCARD.righting(1.2, 2.0, 0.1, 0.0) < 0.0);
    /// ```
    pub fn righting(&self, air: f64, velocity: f64, tilt: f64, tilt_rate: f64) -> f64 {
        let per_moment = self.grip(air) * velocity.abs() / (self.mass * self.gyration.powi(2));
        -per_moment * (self.lever * velocity * tilt.sin() + self.damping * tilt_rate)
    }

    /// Extra fall, m, before a cat at terminal speed rights itself, for each factor of ten by which its start is closer to upside down:
    /// v_t ln 10/λ, where λ is the rate at which the deviation grows, mk²λ² + c v_t λ = mgd. For a positive lever in air; otherwise no deviation grows, and the result is infinite.
    ///
    /// ```
    /// use spinning_bodies::phenomena::PaperCat;
    /// // Aimed ten times as well, it falls this much further upside down.
    /// let fall = PaperCat::POSTCARD.fall_per_decade(1.2, 9.81);
    /// assert!(fall > 0.0 && fall < 1.0);
    /// // With its weight above the centre of pressure it stays upside down.
    /// let heavy_back = PaperCat { lever: -6e-3, ..PaperCat::POSTCARD };
    /// assert_eq!(heavy_back.fall_per_decade(1.2, 9.81), f64::INFINITY);
    /// assert_eq!(PaperCat::POSTCARD.fall_per_decade(0.0, 9.81), f64::INFINITY);
    /// ```
    pub fn fall_per_decade(&self, air: f64, g: f64) -> f64 {
        let speed = self.terminal_speed(air, g);
        let moment = self.mass * self.gyration.powi(2);
        let half = 0.5 * self.grip(air) * speed * self.damping / moment;
        let stiffness = self.mass * g * self.lever.max(0.0) / moment;
        // The positive root, formed without a difference.
        let rate = stiffness / (half + (half * half + stiffness).sqrt());
        match stiffness > 0.0 && speed < f64::INFINITY {
            true => speed * core::f64::consts::LN_10 / rate,
            false => f64::INFINITY,
        }
    }
}
