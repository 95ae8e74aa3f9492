//! The half turn at the end of the string.

use core::f64::consts::{FRAC_2_PI, FRAC_PI_4};

use super::YoYo;
use crate::elliptic::{Modulus, Parameter, incomplete_first};
use crate::error::{Result, finite, not_negative, positive, refused};

/// The turn at the end of the string: the string is all out, and the yo-yo swings half a turn about the string's end.
///
/// The end of the string, at the side of the axle, stays at rest; the yo-yo is a physical pendulum that goes from α = 0, with its centre
/// level with the string's end on one side, through the lowest point to α = π on the other side. α'² = ω² + 2n sin α, n = m g r/(I + m r²), so the spin after the turn equals
/// the spin before, since both are at the same height. Held still, as by a finger, the end of the string takes a sideways pull; on a long free string the
/// centre would keep to its plumb line, and the turn take 1.4 per cent less time with the numbers of the chapter.
#[derive(Debug, Clone, Copy)]
pub struct Turn {
    /// Spin at its beginning and at its end, rad/s.
    pub omega: f64,
    /// Spin at the lowest point, rad/s.
    pub fastest: f64,
    /// Duration, s: a little less than π/ω.
    pub duration: f64,
    /// Mean pull of the string during the turn, N: the weight plus twice the momentum over the duration.
    pub mean_tension: f64,
    /// The same at constant spin, N: m g + (2/π) m r ω², which for a yo-yo let go at the hand is m g [1 + (4/π)(l/r)/(1 + I/(m r²))].
    ///
    /// It neglects the effect of gravity on the spin during the turn, and is too small by a fraction of the order n/ω² = r/(2l).
    pub mean_tension_at_constant_spin: f64,
    toy: YoYo,
    gravity: f64,
    modulus: Modulus,
}

/// The yo-yo in its turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurnState {
    /// Angle α of the turn, rad, 0…π.
    pub angle: f64,
    /// Spin, rad/s.
    pub omega: f64,
    /// Depth of the centre, m: the length of the string plus r sin α.
    pub depth: f64,
    /// Velocity downward, m/s.
    pub velocity: f64,
    /// Vertical pull of the string, N.
    pub tension: f64,
}

impl Turn {
    /// The turn that begins with this spin (rad/s) under `gravity` (m/s²).
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::NotPositive`](crate::Error::NotPositive), [`Error::Negative`](crate::Error::Negative); [`Error::Condition`](crate::Error::Condition) if the spin is less than after
    /// a fall of one radius of the axle: the yo-yo would climb no higher than that, and is said to hang.
    ///
    /// ```
    /// use spinning_bodies::yo_yo::{Turn, YoYo};
    /// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
    /// let turn = Turn::new(toy, 8.0, 200.0)?;
    /// assert!((turn.fastest - 40_400.0_f64.sqrt()).abs() < 1e-12);
    /// // The weight, plus the reversal of a momentum of 2 N s.
    /// assert!((turn.mean_tension - 8.0 - 4.0 / turn.duration).abs() < 1e-12);
    /// // Too slow to be carried round.
    /// assert!(Turn::new(toy, 8.0, 10.0).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(toy: YoYo, gravity: f64, omega: f64) -> Result<Self> {
        let omega = positive("the spin at the end of the string", omega)?;
        let gravity = not_negative("gravity", gravity)?;
        let r = toy.axle;
        let pull = toy.pull(gravity);
        let (slack, fastest) = (omega * omega - 2.0 * pull, omega * omega + 2.0 * pull);
        if slack <= 0.0 {
            let condition = "the spin at the end of the string must carry the axle round it, omega² > 2 m g r/(I + m r²)";
            return refused(condition, omega);
        }
        let parameter = Parameter::new(4.0 * pull / fastest, slack / fastest)?;
        let fastest = fastest.sqrt();
        let duration = 4.0 * incomplete_first(FRAC_PI_4, parameter)? / fastest;
        let weight = toy.mass * gravity;
        let swung = 2.0 * toy.mass * r * omega / duration;
        let at_constant_spin = FRAC_2_PI * toy.mass * r * omega * omega;
        let pull_of = |swung| finite("the pull of the string", weight + swung);
        Ok(Self {
            omega,
            fastest,
            duration,
            mean_tension: pull_of(swung)?,
            mean_tension_at_constant_spin: pull_of(at_constant_spin)?,
            toy,
            gravity,
            modulus: Modulus::new(parameter),
        })
    }

    /// The state at a time after the beginning of the turn (s; clamped to the turn).
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// use spinning_bodies::yo_yo::{Turn, YoYo};
    /// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
    /// let turn = Turn::new(toy, 8.0, 200.0)?;
    /// let lowest = turn.at(0.5 * turn.duration)?;
    /// assert!((lowest.depth - 1.01).abs() < 1e-15 && (lowest.omega - turn.fastest).abs() < 1e-11);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn at(&self, time: f64) -> Result<TurnState> {
        let since_middle = time.clamp(0.0, self.duration) - 0.5 * self.duration;
        let jacobi = self.modulus.jacobi(0.5 * self.fastest * since_middle)?;
        let (sine, cosine) = (jacobi.sn, jacobi.cn);
        let omega = self.fastest * jacobi.dn;
        // α = π/2 + 2 am: its sine and cosine follow from those of twice the amplitude.
        let (sin_alpha, cos_alpha) = ((cosine - sine) * (cosine + sine), -2.0 * sine * cosine);
        let r = self.toy.axle;
        let pull = self.toy.pull(self.gravity);
        let centripetal = r * (omega * omega * sin_alpha - pull * cos_alpha * cos_alpha);
        Ok(TurnState {
            angle: core::f64::consts::FRAC_PI_2 + 2.0 * jacobi.am,
            omega,
            depth: self.toy.length + r * sin_alpha,
            velocity: r * omega * cos_alpha,
            tension: self.toy.mass * (self.gravity + centripetal),
        })
    }

    /// The work, J, that the hand does on the yo-yo if it rises by `lift` (m) during the turn with a speed proportional to sin α.
    ///
    /// The spin grows by Δ = ω c d/(2 − c d/2), c = (π/2) r/(r² + I/m), and the energy by (I + m r²)(ωΔ + Δ²/2): for a small lift
    /// (π/4) m r ω² d. It neglects gravity during the turn; observed error 0.4 per cent for lifts up to 1 cm. Domain: lifts below 2/c.
    ///
    /// ```
    /// use spinning_bodies::yo_yo::{Turn, YoYo};
    /// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
    /// let turn = Turn::new(toy, 8.0, 200.0)?;
    /// assert_eq!(turn.work_of_lift(0.0), 0.0);
    /// // Far more than work against the weight alone.
    /// assert!(turn.work_of_lift(0.01) > 10.0 * 8.0 * 0.01);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn work_of_lift(&self, lift: f64) -> f64 {
        let r = self.toy.axle;
        let square = r * r + self.toy.gyration_squared();
        let reach = core::f64::consts::FRAC_PI_2 * r / square * lift;
        let gain = self.omega * reach / (2.0 - 0.5 * reach);
        self.toy.mass * square * gain * (self.omega + 0.5 * gain)
    }
}
