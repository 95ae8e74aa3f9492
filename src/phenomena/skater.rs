//! The skater: a spin that grows as the arms come in (tutorial 1.1).

use crate::error::{Result, each_finite, finite, not_negative, positive};

/// A core that spins about its axis, with two hands at equal distances from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Skater {
    core: f64,
    /// Mass of one hand, kg.
    pub(crate) hand: f64,
}

impl Skater {
    /// The skater with a core of moment `core` (kg m²) and two hands of mass `hand` (kg) each.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) for the core, [`Error::Negative`](crate::Error::Negative) for the hands,
    /// [`Error::NotFinite`](crate::Error::NotFinite) for either.
    ///
    /// ```
    /// use spinning_bodies::phenomena::Skater;
    /// assert!(Skater::new(1.0, 2.0).is_ok() && Skater::new(0.0, 2.0).is_err());
    /// ```
    pub fn new(core: f64, hand: f64) -> Result<Self> {
        let core = positive("the moment of inertia of the core", core)?;
        let hand = not_negative("the mass of a hand", hand)?;
        Ok(Self { core, hand })
    }

    /// Moment of inertia with the hands at this distance (m) from the axis, kg m²: I = I_core + 2mr².
    pub(crate) fn moment(&self, reach: f64) -> f64 {
        self.core + 2.0 * self.hand * reach * reach
    }

    /// Distance of the hands from the axis, m, that gives this moment of inertia (kg m²).
    ///
    /// # Errors
    /// [`Error::Negative`](crate::Error::Negative) if that is less than the core's own;
    /// [`Error::NotPositive`](crate::Error::NotPositive) if the hands have no mass.
    ///
    /// ```
    /// use spinning_bodies::phenomena::Skater;
    /// let skater = Skater::new(1.0, 2.0)?;
    /// // 1 + 2·2·1² kg m².
    /// assert_eq!(skater.reach(5.0)?, 1.0);
    /// assert!((Skater::new(1.0, 2e-320)?.reach(5.0)? / 1e160 - 1.0).abs() < 1e-4);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn reach(&self, moment: f64) -> Result<f64> {
        let hand = positive("the mass of a hand", self.hand)?;
        let rest = moment - self.core;
        let rest = not_negative("the moment of inertia left to the hands", rest)?;
        Ok((0.5 * rest).sqrt() / hand.sqrt())
    }

    /// Angular velocity, rad/s, at angular momentum `l` (kg m²/s) with the hands at this distance: Ω = L/I.
    ///
    /// ```
    /// use spinning_bodies::phenomena::Skater;
    /// let skater = Skater::new(1.0, 2.0)?;
    /// assert_eq!(skater.spin(10.0, 1.0), 2.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn spin(&self, l: f64, reach: f64) -> f64 {
        l / self.moment(reach)
    }

    /// Work of both arms, J, in moving the hands from rest at `from` to rest at `to`, at angular momentum `l`: the gain in rotational energy,
    /// (L²/2)(1/I′ − 1/I) = L² m (r² − r′²)/(I I′), without a difference of large numbers. Observed error: 7 ulp.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite) if it or a moment of inertia overflows.
    ///
    /// ```
    /// use spinning_bodies::phenomena::Skater;
    /// let skater = Skater::new(1.0, 2.0)?;
    /// // ½L²(½ − ⅕).
    /// assert!((skater.work(10.0, 1.0, 0.5)? - 15.0).abs() < 1e-14);
    /// assert!(skater.work(1.0, 1e155, 1.0).is_err(), "a moment beyond the doubles");
    /// assert!((Skater::new(1e-100, 1.0)?.work(1e100, 1e-150, 0.0)? / 1e100 - 1.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn work(&self, l: f64, from: f64, to: f64) -> Result<f64> {
        each_finite("the moment of inertia", [from, to].map(|r| self.moment(r)))?;
        let (spin, other) = (self.spin(l, from), self.spin(l, to));
        let work = spin * (from - to) * self.hand * (other * (from + to));
        finite("the work of the arms", work)
    }

    /// Power of both arms against the centrifugal force, W: −2 m r r′ Ω².
    pub(crate) fn power(&self, spin: f64, reach: f64, reach_rate: f64) -> f64 {
        -2.0 * self.hand * reach * reach_rate * spin * spin
    }

    /// Kinetic energy, J, of the rotation and of the hands' motion along the arms: IΩ²/2 + m r′².
    ///
    /// ```
    /// use spinning_bodies::phenomena::Skater;
    /// let skater = Skater::new(1.0, 2.0)?;
    /// assert_eq!(skater.energy(2.0, 1.0, 0.5), 10.5);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn energy(&self, spin: f64, reach: f64, reach_rate: f64) -> f64 {
        0.5 * self.moment(reach) * spin * spin + self.hand * reach_rate * reach_rate
    }
}
