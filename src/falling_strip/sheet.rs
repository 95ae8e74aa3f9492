//! A real strip of paper, and the ratio of its mass to that of the air around it.

use core::f64::consts::PI;

use super::fall::{Coefficients, Fall, Regime, Start};
use super::plate::Plate;
use crate::error::{Result, finite, positive, refused};
use crate::search::halved;

/// The Froude number at which flutter turns into tumbling: the measured value and its uncertainty.
///
/// Source: Belmonte, Eisenberg and Moses, Physical Review Letters 81 (1998), for flat strips falling between two walls.
pub const MEASURED_FROUDE: (f64, f64) = (0.67, 0.05);

/// A strip with its width (m), its mass per area (kg/m²), the density of the fluid (kg/m³) and g (m/s²).
///
/// Its length does not enter a two-dimensional model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sheet {
    width: f64,
    areal_density: f64,
    fluid_density: f64,
    gravity: f64,
}

impl Sheet {
    /// The strip of this width, mass per area, in this fluid, under this gravity.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::NotPositive`](crate::Error::NotPositive), also where a product in the mass ratio or in the unit of speed
    /// leaves the range of doubles.
    ///
    /// ```
    /// use spinning_bodies::falling_strip::Sheet;
    /// assert_eq!(Sheet::new(0.04, 0.08, 1.2, 9.81)?, Sheet::of_paper(0.04)?);
    /// assert!(Sheet::new(1.0, 1e308, 1e308, 1.0).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(width: f64, areal_density: f64, fluid_density: f64, gravity: f64) -> Result<Self> {
        let strip = Self {
            width: positive("the width of the strip", width)?,
            areal_density: positive("the mass per area", areal_density)?,
            fluid_density: positive("the density of the fluid", fluid_density)?,
            gravity: positive("gravity", gravity)?,
        };
        positive("the mass ratio", strip.mass_ratio())?;
        positive("the unit of speed", strip.speed())?;
        Ok(strip)
    }

    /// Office paper, 80 g/m², in air of 1.2 kg/m³, with g = 9.81 m/s².
    ///
    /// # Errors
    /// As [`new`](Self::new), for the width.
    ///
    /// ```
    /// use spinning_bodies::falling_strip::Sheet;
    /// let strip = Sheet::of_paper(0.04)?;
    /// // 4σ/(πρw).
    /// assert!((strip.mass_ratio() - 0.32 / (std::f64::consts::PI * 0.048)).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn of_paper(width: f64) -> Result<Self> {
        Self::new(width, 0.08, 1.2, 9.81)
    }

    /// The width at which a strip of this material has the given mass ratio: 4σ/(π ρ I*), m.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::NotPositive`](crate::Error::NotPositive).
    ///
    /// ```
    /// use spinning_bodies::falling_strip::Sheet;
    /// let strip = Sheet::of_paper(0.04)?;
    /// assert!((strip.width_for(strip.mass_ratio())? - 0.04).abs() < 1e-16);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn width_for(&self, mass_ratio: f64) -> Result<f64> {
        let ratio = positive("the mass ratio", mass_ratio)?;
        let width = 4.0 * self.areal_density / (PI * self.fluid_density * ratio);
        finite("the width of the strip", width)
    }

    /// Mass ratio I* = 4σ/(π ρ w): the mass of the strip over that of the cylinder of fluid around it. Dimensionless.
    ///
    /// ```
    /// use spinning_bodies::falling_strip::Sheet;
    /// // Half the width, twice the ratio.
    /// let [wide, narrow] = [Sheet::of_paper(0.04)?, Sheet::of_paper(0.02)?];
    /// assert!((narrow.mass_ratio() / wide.mass_ratio() - 2.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn mass_ratio(&self) -> f64 {
        4.0 * self.areal_density / (PI * self.fluid_density * self.width)
    }

    /// The unit of speed of the theory, U = √(2σg/(π ρ)), m/s: the same for every width.
    ///
    /// ```
    /// use spinning_bodies::falling_strip::Sheet;
    /// let strip = Sheet::of_paper(0.04)?;
    /// assert!((strip.speed() - (2.0 * 0.08 * 9.81 / (std::f64::consts::PI * 1.2)).sqrt()).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn speed(&self) -> f64 {
        (2.0 * self.areal_density * self.gravity / (PI * self.fluid_density)).sqrt()
    }

    /// Half the width, the unit of length of the theory, m.
    pub(crate) fn half_chord(&self) -> f64 {
        0.5 * self.width
    }

    /// The unit of time of the theory, a/U, s.
    ///
    /// ```
    /// use spinning_bodies::falling_strip::Sheet;
    /// let strip = Sheet::of_paper(0.04)?;
    /// assert!((strip.time() * strip.speed() - 0.02).abs() < 1e-17);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn time(&self) -> f64 {
        self.half_chord() / self.speed()
    }

    /// The strip as a flat [`Plate`].
    ///
    /// # Errors
    /// As [`Plate::new`].
    ///
    /// ```
    /// use spinning_bodies::falling_strip::{Plate, Sheet};
    /// let flat = Plate::new(0.02, 0.08 * 0.04, 1.2, 0.0, 1.0 / 3.0)?;
    /// assert_eq!(Sheet::of_paper(0.04)?.plate()?, flat);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn plate(&self) -> Result<Plate> {
        let mass = self.areal_density * self.width;
        Plate::new(self.half_chord(), mass, self.fluid_density, 0.0, 1.0 / 3.0)
    }
}

/// The mass ratio I* at which flutter ends, to `accuracy`, between `low`, where the plate must flutter, and `high`, where it must not.
///
/// Found by bisection on the regime [in the long run](Fall::long_run). Flutter ends where its period grows without bound,
/// so the last digits need long runs: `window` is the time for which the plate is watched, after a run-up of the same length, units a/U.
///
/// Cost: log₂((high − low)/accuracy) long runs.
///
/// # Errors
/// [`Error::Condition`](crate::Error::Condition) if the ends do not bracket the transition; as [`Fall::long_run`].
///
/// ```
/// use spinning_bodies::falling_strip::{Coefficients, transition};
/// // The authors of the coefficients give 1.2191.
/// let ends = transition(Coefficients::PUBLISHED, 1.2, 1.24, 0.005, 200.0)?;
/// assert!((ends - 1.2191).abs() < 0.005);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn transition(
    coefficients: Coefficients,
    low: f64,
    high: f64,
    accuracy: f64,
    window: f64,
) -> Result<f64> {
    let accuracy = positive("the accuracy of the transition", accuracy)?;
    let flutters = |ratio: f64| -> Result<bool> {
        let fall = Fall::new(ratio, coefficients)?;
        let run = fall.long_run(Start::TILTED, window, window)?;
        Ok(matches!(run.regime, Regime::Flutter | Regime::Steady))
    };
    for (ratio, expected) in [(low, true), (high, false)] {
        if flutters(ratio)? != expected {
            let condition =
                "the plate must flutter at the lower end of the bracket and not at the upper one";
            return refused(condition, ratio);
        }
    }
    let [low, high] = halved([low, high], accuracy, flutters)?;
    Ok(0.5 * (low + high))
}
