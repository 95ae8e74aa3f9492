//! Down the string and up again.

use super::{Winding, YoYo};
use crate::elliptic::Parameter;
use crate::error::{Error, Result, finite, not_negative, positive, within};
use crate::phenomena::quadrature;

/// A way down the string, or, run backwards, a way up: from its upper end to the end of the string.
///
/// The upper end is the hand, if the yo-yo comes there with speed, or else the depth at which it is at rest. With
/// V² = 2(e + g x) r²/(r² + k²), e the energy over the mass, the time from depth x₀ to x is
///
/// * on a thin string that of a constant acceleration;
/// * on a thick one √(2(P + ε)/g) [E(φ|m) − E(φ₀|m)], tan²φ = (x + ε)/(p − x), ε = e/g, p and P the depths at which r² and r² + k²
///   would be zero, m = (p + ε)/(P + ε); the radius that shrinks is an ellipse that straightens;
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
    /// √(2(P + ε)/g), and how φ and E grow.
    Elliptic { scale: f64, arc: Arc },
    /// √(2e).
    Free { speed: f64 },
}

/// A stretch of the elliptic integral of the second kind: by how much E(φ|m) grows while φ does, from the upper end on.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Arc {
    parameter: Parameter,
    /// p − top and ε + top: as cos² and sin² of φ at the upper end.
    left: f64,
    above: f64,
    /// φ at the upper end, and what it lacks of a quarter turn; by how much φ and E grow to the end of the string.
    angle: f64,
    rest: f64,
    turned: f64,
    whole: f64,
}

impl Arc {
    fn new(parameter: Parameter, left: f64, above: f64, length: f64) -> Self {
        let mut arc = Self {
            parameter,
            left,
            above,
            angle: above.sqrt().atan2(left.sqrt()),
            rest: left.sqrt().atan2(above.sqrt()),
            turned: 0.0,
            whole: 0.0,
        };
        arc.turned = arc.turned_at(length);
        arc.whole = arc.growth(arc.turned);
        arc
    }

    /// By how much φ has grown on this way (m): from its sine and cosine, of which all terms have one sign.
    fn turned_at(&self, way: f64) -> f64 {
        if way == 0.0 {
            return 0.0;
        }
        let [sine, cosine] = [way + self.above, (self.left - way).max(0.0)].map(f64::sqrt);
        let [sine_before, cosine_before] = [self.above, self.left].map(f64::sqrt);
        let across = way / (sine * cosine_before + cosine * sine_before);
        let along = (cosine * cosine_before + sine * sine_before) / (self.left + self.above);
        across.atan2(along)
    }

    /// The way on which φ grows so much: D(sin²φ − sin²φ₀), and no difference of squares.
    fn way(&self, turned: f64) -> f64 {
        // The same sine twice, from the smaller angle.
        let sum = if self.angle < self.rest {
            2.0 * self.angle + turned
        } else {
            2.0 * self.rest - turned
        };
        (self.left + self.above) * turned.sin() * sum.sin()
    }

    /// Δ = √(1 − m sin²φ).
    fn delta(&self, turned: f64) -> f64 {
        let cosine = (self.rest - turned).sin();
        let (m, mc) = (self.parameter.m(), self.parameter.mc());
        m.mul_add(cosine * cosine, mc).sqrt()
    }

    /// By how much E has grown when φ has: sums with 20 points over stretches no longer than the distance to the next singularity of Δ, on which
    /// they are exact (their error is 10⁻²⁵). Singularities are where sin²φ = 1/m, asinh √(mc/m) off the real axis at a quarter turn, so a
    /// stretch can be the longer the earlier it ends.
    fn growth(&self, turned: f64) -> f64 {
        let off_axis = (self.parameter.mc() / self.parameter.m()).sqrt().asinh();
        let (mut sum, mut to) = (0.0, turned);
        while to > 0.0 {
            let from = (to - off_axis.hypot(self.rest - to)).max(0.0);
            sum += quadrature::panel(&|turned| self.delta(turned), from, to);
            if from == to {
                break;
            }
            to = from;
        }
        sum
    }

    /// By how much φ has grown when E has.
    fn turned_when(&self, grown: f64) -> f64 {
        // Δ falls, so Newton's steps come from below after the first and cannot overshoot.
        newton(self.turned * (grown / self.whole), self.turned, |turned| {
            (self.growth(turned) - grown) / self.delta(turned)
        })
    }
}

/// Newton's method between 0 and `most`, to rounding.
fn newton(first: f64, most: f64, correction: impl Fn(f64) -> f64) -> f64 {
    let mut root = first;
    for _ in 0..100 {
        let next = (root - correction(root)).clamp(0.0, most);
        let step = (next - root).abs();
        root = next;
        if step <= 2.0 * f64::EPSILON * root {
            break;
        }
    }
    root
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
        let law = law(&toy, gravity, e, top)?;
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
            Law::Elliptic { scale, arc } => scale * arc.growth(arc.turned_at(depth - self.top)),
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
            Law::Elliptic { scale, arc } => arc.way(arc.turned_when(time / scale)),
            Law::Free { speed } => newton(length * (time / duration), length, |depth| {
                (self.free_time(depth) / speed - time) * self.speed(depth)
            }),
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
fn law(toy: &YoYo, gravity: f64, e: f64, top: f64) -> Result<Law> {
    let k2 = toy.gyration_squared();
    Ok(match toy.winding() {
        Winding::Thin => {
            let acceleration = gravity / (1.0 + toy.inertia_factor());
            Law::Uniform {
                // From rest below the hand.
                speed: (2.0 * e.max(0.0) / (1.0 + toy.inertia_factor())).sqrt(),
                acceleration,
            }
        }
        Winding::Thick { .. } if gravity == 0.0 => Law::Free {
            speed: (2.0 * e).sqrt(),
        },
        Winding::Thick {
            wound_squared,
            slope,
        } => {
            let height = e / gravity;
            // P + ε times q, of three parts that do not cancel: ε is not below −l, and q l < r_w².
            let whole = wound_squared + k2 + slope * height;
            let parameter = Parameter::from_complement(k2 / whole)?;
            let bare = wound_squared / slope;
            // Zero, not nearly zero, where the yo-yo starts from rest.
            let above = if e <= 0.0 { 0.0 } else { height };
            Law::Elliptic {
                scale: (2.0 * whole / (slope * gravity)).sqrt(),
                arc: Arc::new(parameter, bare - top, above, toy.length - top),
            }
        }
    })
}
