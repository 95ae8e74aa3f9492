//! Down the string and up again.

use super::YoYo;
use crate::elliptic::{rd, rf};
use crate::error::{Error, Result, finite, not_negative, positive, within};

/// A way down the string, or, run backwards, a way up: from its upper end to the end of the string.
///
/// The upper end is the hand, if the yo-yo comes there with speed, or else the depth at which it is at rest. With
/// V² = 2(e + g x) r²/(r² + k²), e the energy over the mass, the time from depth x₀ to x is
///
/// * on a thin string that of a constant acceleration;
/// * on a thick one √(2(P + ε)/g) [E(φ|m) − E(φ₀|m)], tan²φ = (x + ε)/(p − x), ε = e/g, p and P the depths at which r² and r² + k²
///   would be zero, m = (p + ε)/(P + ε); the radius that shrinks is an ellipse that straightens. Here as one integral from x₀ to x by Carlson's
///   functions (*A table of elliptic integrals of the second kind*, Math. Comp. 49, 1987): all terms are positive, and no difference is taken;
/// * on a thick one without gravity an inverse hyperbolic sine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unwinding {
    toy: YoYo,
    gravity: f64,
    energy: f64,
    top: f64,
    law: Law,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Law {
    /// Speed at the upper end, acceleration.
    Uniform { speed: f64, acceleration: f64 },
    /// From the upper end on.
    Elliptic(Arc),
    /// √(2e).
    Free { speed: f64 },
}

/// The way of a thick string under gravity from its upper end on, m.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Arc {
    gravity: f64,
    /// ε + x₀: from where it would be at rest to the upper end.
    above: f64,
    /// p − x₀, to where r² would be zero; and P − p, from there to where r² + k² would be.
    left: f64,
    beyond: f64,
}

impl Arc {
    /// The time of this way, s: ∫ √((P − x)/(2g(x + ε)(p − x))) dx.
    fn time(&self, way: f64) -> Result<f64> {
        if way == 0.0 {
            return Ok(0.0);
        }
        let roots = |way: f64| {
            let left = (self.left - way).max(0.0);
            [left, self.above + way, self.beyond + left].map(f64::sqrt)
        };
        let ([a, b, c], [a0, b0, c0]) = (roots(way), roots(0.0));
        // Over this sum nothing vanishes or overflows where the way is short.
        let (sum, s) = (b + b0, way / (b + b0));
        let [x, y, z] = [
            a * b * c0 + a0 * b0 * c,
            a * c * b0 + a0 * c0 * b,
            a * b0 * c0 + a0 * b * c,
        ]
        .map(|x| x / sum);
        let second = (self.left + self.above) / 3.0 * s * s * rd(x * x, y * y, z * z)?;
        let first = rf(x * x, y * y, z * z)?;
        let integral = s * (self.beyond * (first + second) + a * a0 / z);
        Ok(integral * (2.0 / self.gravity).sqrt())
    }

    /// The way that takes this time, up to the longest with its duration: by Newton's method in s, with way = s(s + 2√above), in which the motion from
    /// rest is no exception.
    fn way(&self, time: f64, [longest, duration]: [f64; 2]) -> Result<f64> {
        let root = self.above.sqrt();
        let way = |s: f64| s * (s + 2.0 * root);
        let most = longest / ((self.above + longest).sqrt() + root);
        // The time bends upward, so that steps come from above after the first and cannot overshoot.
        let s = newton(most * (time / duration), most, |s| {
            let left = self.left - way(s);
            let pace = (2.0 * (self.beyond + left) / (self.gravity * left)).sqrt();
            Ok((self.time(way(s))? - time) / pace)
        })?;
        Ok(way(s))
    }
}

/// Newton's method between 0 and `most`, to rounding.
fn newton(first: f64, most: f64, correction: impl Fn(f64) -> Result<f64>) -> Result<f64> {
    let mut root = first;
    for _ in 0..100 {
        let next = (root - correction(root)?).clamp(0.0, most);
        let step = (next - root).abs();
        root = next;
        if step <= 2.0 * f64::EPSILON * root {
            break;
        }
    }
    Ok(root)
}

impl Unwinding {
    /// The way of this yo-yo under `gravity` (m/s², not negative) with the energy `energy` (J, zero for rest at the hand).
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::Negative`]; [`Error::Condition`] if it has not energy enough to be anywhere above the end of the
    /// string, or, without gravity, none.
    ///
    /// ```
    /// use spinning_bodies::yo_yo::{Unwinding, YoYo};
    /// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
    /// let way = Unwinding::new(toy, 8.0, 0.0)?; // 8 m/s²/(1 + 3)
    /// assert!((way.duration()? - 1.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(toy: YoYo, gravity: f64, energy: f64) -> Result<Self> {
        let gravity = not_negative("gravity", gravity)?;
        let energy = finite("the energy of the yo-yo", energy)?;
        let e = energy / toy.mass;
        let top = if e < 0.0 { -e / gravity } else { 0.0 };
        if (gravity == 0.0 && energy <= 0.0) || top >= toy.length {
            return Err(Error::Condition {
                condition: "the yo-yo must have energy enough to leave the end of the string",
                value: energy,
            });
        }
        let law = law(&toy, gravity, e, top);
        Ok(Self {
            toy,
            gravity,
            energy,
            top,
            law,
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

    /// Spin, rad/s, at such a depth.
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

    /// The same where it is known how far below the upper end that is.
    fn omega_below(&self, depth: f64, way: f64) -> f64 {
        // From rest the fall below the upper end is what counts.
        let fall = if self.energy < 0.0 {
            self.gravity * way
        } else {
            self.energy / self.toy.mass + self.gravity * depth
        };
        let square = self.toy.radius_squared(depth.clamp(0.0, self.toy.length));
        (2.0 * fall.max(0.0) / (square + self.toy.gyration_squared())).sqrt()
    }

    /// Time from the upper end to this depth, s. Observed error: 1e-14.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] outside the way.
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
        Ok(match self.law {
            Law::Uniform {
                speed,
                acceleration,
            } => {
                let way = depth - self.top;
                if way == 0.0 {
                    0.0
                } else {
                    2.0 * way / (speed + (speed * speed + 2.0 * acceleration * way).sqrt())
                }
            }
            Law::Elliptic(arc) => arc.time(depth - self.top)?,
            Law::Free { speed } => self.free_time(depth) / speed,
        })
    }

    /// ∫ √((r² + k²)/r²) dx from the upper end: in s = r², the difference of √(s(s + k²)) + k² asinh √(s/k²) between both ends over q, by formulas
    /// in which q cancels.
    fn free_time(&self, depth: f64) -> f64 {
        let (k2, q, way) = (
            self.toy.gyration_squared(),
            self.toy.thinning(),
            depth - self.top,
        );
        let [from, to] = [self.top, depth].map(|x| self.toy.radius_squared(x));
        let [a, b] = [from, to].map(|s| (s / k2).sqrt());
        let roots = (from * (from + k2)).sqrt() + (to * (to + k2)).sqrt();
        let mixed = a * (1.0 + b * b).sqrt() + b * (1.0 + a * a).sqrt();
        way * (from + to + k2) / roots + k2 * (q * way / (k2 * mixed)).asinh() / q
    }

    /// Time from the upper end to the end of the string, s.
    ///
    /// # Errors
    /// None that [`new`](Self::new) has not reported; [`Error::NotFinite`] where the time overflows.
    ///
    /// ```
    /// use spinning_bodies::yo_yo::{Unwinding, YoYo};
    /// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
    /// let way = Unwinding::new(toy, 8.0, 0.0)?; // 8 m/s²/(1 + 3)
    /// assert!((way.duration()? - 1.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn duration(&self) -> Result<f64> {
        finite("the time of the way down", self.time_at(self.toy.length)?)
    }

    /// Depth (m) so long after the upper end (s, between 0 and the [duration](Self::duration)).
    ///
    /// Thin string: a formula. Thick: Newton's method on the time, an integral that is one short sum: some microseconds.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] outside the way.
    ///
    /// ```
    /// use spinning_bodies::yo_yo::{Unwinding, YoYo};
    /// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
    /// let way = Unwinding::new(toy, 8.0, 0.0)?; // 8 m/s²/(1 + 3)
    /// assert!((way.depth_at(0.5)? - 0.25).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn depth_at(&self, time: f64) -> Result<f64> {
        Ok(self.at(time)?[0])
    }

    /// Depth (m) and spin (rad/s) so long after the upper end. Next to a rest the spin has more digits than the depth could give it.
    pub(crate) fn at(&self, time: f64) -> Result<[f64; 2]> {
        let length = self.toy.length;
        let duration = self.duration()?;
        if within("the time on the way down", time, 0.0, duration)? == duration {
            return Ok([length, self.omega(length)]);
        }
        let way = match self.law {
            Law::Uniform {
                speed,
                acceleration,
            } => time * (speed + 0.5 * acceleration * time),
            Law::Elliptic(arc) => arc.way(time, [length - self.top, duration])?,
            Law::Free { speed } => newton(length * (time / duration), length, |depth| {
                Ok((self.free_time(depth) / speed - time) * self.speed(depth))
            })?,
        };
        let depth = (self.top + way).clamp(self.top, length);
        Ok([depth, self.omega_below(depth, way.max(0.0))])
    }

    /// The energy, J, with which a yo-yo leaves this depth (m) at this speed (m/s, either way) under `gravity`.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::Negative`]; [`Error::OutOfRange`](crate::Error::OutOfRange) for a depth that is not on the string.
    ///
    /// ```
    /// use spinning_bodies::yo_yo::{Unwinding, YoYo};
    /// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
    /// // As fast as a fall from the hand makes it.
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

/// The law of the way from `top` on, for this energy over the mass.
fn law(toy: &YoYo, gravity: f64, e: f64, top: f64) -> Law {
    let slope = toy.thinning();
    if slope == 0.0 {
        let factor = 1.0 + toy.inertia_factor();
        Law::Uniform {
            // From rest below the hand.
            speed: (2.0 * e.max(0.0) / factor).sqrt(),
            acceleration: gravity / factor,
        }
    } else if gravity == 0.0 {
        Law::Free {
            speed: (2.0 * e).sqrt(),
        }
    } else {
        Law::Elliptic(Arc {
            gravity,
            // Zero, not nearly zero, where the yo-yo starts from rest.
            above: if e <= 0.0 { 0.0 } else { e / gravity },
            left: toy.radius_squared(top) / slope,
            beyond: toy.gyration_squared() / slope,
        })
    }
}
