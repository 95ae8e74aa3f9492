//! Down the string and up again, in closed form.

use super::YoYo;
use crate::elliptic::{rd, rf};
use crate::error::{Result, finite, not_negative, positive, refused, within};

/// A motion down the string, or, run backwards, up it: from its upper end to the end of the string.
///
/// The upper end is the hand, if the yo-yo has speed there, or else the depth at which it is at rest. With
/// V² = 2(e + g x) r²/(r² + k²), e the energy over the mass, the time from depth x₀ to x is
///
/// * on a thin string that of a constant acceleration;
/// * on a thick one √(2(P + ε)/g) [E(φ|m) − E(φ₀|m)], tan²φ = (x + ε)/(p − x), ε = e/g, p and P the depths at which r² and r² + k²
///   would be zero, m = (p + ε)/(P + ε). It is computed as one integral from x₀ to x by Carlson's
///   functions (*A table of elliptic integrals of the second kind*, Math. Comp. 49, 1987), as a multiple of the time on a string that stays as thick as
///   at x₀: all terms are positive, no difference is taken, and neither a motion without gravity nor one from rest is an exception.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unwinding {
    toy: YoYo,
    gravity: f64,
    energy: f64,
    /// Depth of the upper end, m.
    top: f64,
    /// At the upper end: the speed, and the acceleration if the string stayed as thick as there.
    speed: f64,
    acceleration: f64,
}

impl Unwinding {
    /// The motion of this yo-yo under `gravity` (m/s², not negative) with the energy `energy` (J, zero for rest at the hand).
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Negative`](crate::Error::Negative); [`Error::Condition`](crate::Error::Condition) if its energy is too small for it to be anywhere above the end of the
    /// string, or, without gravity, zero.
    ///
    /// ```
    /// use spinning_bodies::yo_yo::{Unwinding, YoYo};
    /// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
    /// let way = Unwinding::new(toy, 8.0, 0.0)?; // 8 m/s²/(1 + 3)
    /// assert!((way.duration()? - 1.0).abs() < 1e-15);
    /// // As much energy for each kilogram as no double holds.
    /// assert!(Unwinding::new(YoYo::new(1e-200, 3e-204, 1.0, 0.01)?, 8.0, 1e200).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(toy: YoYo, gravity: f64, energy: f64) -> Result<Self> {
        let gravity = not_negative("gravity", gravity)?;
        let e = finite("the energy of the yo-yo", energy / toy.mass)?;
        let top = if e < 0.0 { -e / gravity } else { 0.0 };
        if (gravity == 0.0 && energy <= 0.0) || top >= toy.length {
            let condition = "the yo-yo must have enough energy to leave the end of the string";
            return refused(condition, energy);
        }
        let factor = 1.0 + toy.gyration_squared() / toy.radius_squared(top);
        Ok(Self {
            toy,
            gravity,
            energy,
            top,
            // Zero if it starts from rest below the hand.
            speed: (2.0 * e.max(0.0) / factor).sqrt(),
            acceleration: gravity / factor,
        })
    }

    /// |V|, m/s, at a depth between the upper end and the end of the string.
    ///
    /// ```
    /// use spinning_bodies::yo_yo::{Unwinding, YoYo};
    /// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
    /// let way = Unwinding::new(toy, 8.0, 0.0)?; // 8 m/s²/(1 + 3)
    /// assert!((way.speed(1.0) - 2.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn speed(&self, depth: f64) -> f64 {
        self.omega(depth) * self.toy.radius(depth)
    }

    /// Spin, rad/s, at a depth between the upper end and the end of the string.
    ///
    /// ```
    /// use spinning_bodies::yo_yo::{Unwinding, YoYo};
    /// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
    /// let way = Unwinding::new(toy, 8.0, 0.0)?; // 8 m/s²/(1 + 3)
    /// assert!((way.omega(1.0) - 200.0).abs() < 1e-13);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn omega(&self, depth: f64) -> f64 {
        self.omega_below(depth, depth - self.top)
    }

    /// The same if the distance below the upper end, `way`, is known as well.
    fn omega_below(&self, depth: f64, way: f64) -> f64 {
        // From rest, the fall from the upper end determines the speed.
        let fall = if self.energy < 0.0 {
            self.gravity * way
        } else {
            self.energy / self.toy.mass + self.gravity * depth
        };
        let square = self.toy.radius_squared(depth);
        (2.0 * fall.max(0.0) / (square + self.toy.gyration_squared())).sqrt()
    }

    /// Time from the upper end to this depth, s. Observed error: 1e-14 times the depth over the way from the upper end.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) for a depth outside the motion; [`Error::NotFinite`](crate::Error::NotFinite) where the time overflows.
    ///
    /// ```
    /// use spinning_bodies::yo_yo::{Unwinding, YoYo};
    /// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
    /// let way = Unwinding::new(toy, 8.0, 0.0)?; // 8 m/s²/(1 + 3)
    /// assert!((way.time_at(0.25)? - 0.5).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn time_at(&self, depth: f64) -> Result<f64> {
        within("the depth of the yo-yo", depth, self.top, self.toy.length)?;
        finite("the time down the string", self.time_of(depth - self.top)?)
    }

    /// The time from the upper end to the distance `way` below it, s.
    fn time_of(&self, way: f64) -> Result<f64> {
        if way == 0.0 {
            return Ok(0.0);
        }
        let (speed, acceleration) = (self.speed, self.acceleration);
        let even = self.even_time(way);
        let later = speed + acceleration * even;
        let q = self.toy.slope / self.toy.radius_squared(self.top);
        if q == 0.0 {
            return Ok(even);
        }
        // ∫ √(1 + k²/r²)/√(2(e + g x)) dx, divided by its value with r constant as at the upper end.
        let ([_, b0], [a, b]) = (self.roots(0.0), self.roots(way));
        let [c0, c] = [speed, later].map(|v| v / (speed + later));
        let (x, y) = (a * b0 * c + b * c0, b0 * c + a * b * c0);
        let z = b * c + a * b0 * c0;
        let bend = q * even * even * (2.0 * acceleration + q * speed * speed);
        let second = bend / 12.0 * rd(x * x, y * y, z * z)?;
        let first = rf(x * x, y * y, z * z)?;
        let gyration = self.toy.gyration_squared() / self.toy.radius_squared(self.top);
        Ok(even * ((gyration * (first + second) + a / z) / b0))
    }

    /// The same on a string that stays as thick as at the upper end.
    fn even_time(&self, way: f64) -> f64 {
        let square = self.speed * self.speed + 2.0 * self.acceleration * way;
        2.0 * way / (self.speed + square.sqrt())
    }

    /// √r² and √(r² + k²) at the distance `way` below the upper end, both divided by r at the upper end.
    fn roots(&self, way: f64) -> [f64; 2] {
        let depths = [self.top, self.top + way];
        let [from, here] = depths.map(|depth| self.toy.radius_squared(depth));
        [here, here + self.toy.gyration_squared()].map(|square| (square / from).sqrt())
    }

    /// Time from the upper end to the end of the string, s.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite) where the time overflows.
    ///
    /// ```
    /// use spinning_bodies::yo_yo::{Unwinding, YoYo};
    /// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
    /// let way = Unwinding::new(toy, 8.0, 0.0)?; // 8 m/s²/(1 + 3)
    /// assert!((way.duration()? - 1.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn duration(&self) -> Result<f64> {
        self.time_at(self.toy.length)
    }

    /// Depth (m) and spin (rad/s) at a time after the upper end (s, between 0 and the [duration](Self::duration)).
    ///
    /// Thin string: a formula. Thick string: Newton's method on the time, some microseconds. Close to rest the spin keeps digits that
    /// it would lose if computed from the depth.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) for a time outside the motion.
    ///
    /// ```
    /// use spinning_bodies::yo_yo::{Unwinding, YoYo};
    /// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
    /// let way = Unwinding::new(toy, 8.0, 0.0)?; // 8 m/s²/(1 + 3)
    /// assert!((way.at(0.5)?[0] - 0.25).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn at(&self, time: f64) -> Result<[f64; 2]> {
        let length = self.toy.length;
        let duration = self.duration()?;
        if within("the time on the way down", time, 0.0, duration)? == duration {
            return Ok([length, self.omega(length)]);
        }
        let way = self.way_of(time, duration)?;
        let depth = (self.top + way).clamp(self.top, length);
        Ok([depth, self.omega_below(depth, way.max(0.0))])
    }

    /// The distance from the upper end covered in this time, by Newton's method; its variable is the time on a string that stays as thick as at the upper end.
    fn way_of(&self, time: f64, duration: f64) -> Result<f64> {
        let way = |even: f64| even * (self.speed + 0.5 * self.acceleration * even);
        if self.toy.slope == 0.0 {
            return Ok(way(time));
        }
        let [_, b0] = self.roots(0.0);
        let most = self.even_time(self.toy.length - self.top);
        let mut even = most * (time / duration);
        // The time is convex, so that all steps after the first come from above and cannot overshoot.
        for _ in 0..100 {
            let [a, b] = self.roots(way(even));
            let step = (self.time_of(way(even))? - time) * (a * b0 / b);
            even = (even - step).clamp(0.0, most);
            if step.abs() <= 2.0 * f64::EPSILON * even {
                break;
            }
        }
        Ok(way(even))
    }

    /// The energy, J, of a yo-yo at this depth (m) with this speed (m/s, up or down) under `gravity`.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Negative`](crate::Error::Negative); [`Error::OutOfRange`](crate::Error::OutOfRange) for a depth outside 0 … the length of the string.
    ///
    /// ```
    /// use spinning_bodies::yo_yo::{Unwinding, YoYo};
    /// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
    /// // The speed is that of a fall from the hand.
    /// assert!(Unwinding::energy_at(&toy, 8.0, 0.25, 1.0)?.abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn energy_at(toy: &YoYo, gravity: f64, depth: f64, speed: f64) -> Result<f64> {
        within("the depth of the yo-yo", depth, 0.0, toy.length)?;
        finite("the speed of the yo-yo", speed)?;
        let omega = speed / positive("the winding radius", toy.radius(depth))?;
        let fallen = toy.mass * not_negative("gravity", gravity)? * depth;
        finite("the energy", toy.kinetic_energy(depth, omega) - fallen)
    }
}
