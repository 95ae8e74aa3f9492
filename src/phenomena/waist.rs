//! Two parts on one axis: the swivel on ice (tutorial 1.1, picture b).

use super::holonomy::ShapePlane;
use crate::error::{Result, finite, not_negative, positive};

/// The two shapes of a body that twists at the waist: moments of inertia about the common axis, kg m².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Waist {
    /// Upper part with the arms stretched out.
    pub upper_arms_out: f64,
    /// Upper part with the arms pulled in.
    pub upper_arms_in: f64,
    /// Lower part.
    pub lower: f64,
}

impl Waist {
    /// Net turn of the lower body, radians, after twisting by `twist` with the arms out and untwisting with the arms in,
    /// at angular momentum zero throughout (tutorial 1.1, picture b; 3.5):
    /// Δ = −Ψ B (A_out − A_in) / ((A_out + B)(A_in + B)).
    ///
    /// The two turns nearly cancel, so the difference is formed between the moments, before anything is rounded.
    /// Zero for A_out = A_in, for B = 0, and in the limit B → ∞. The pace does not matter. Observed error: 4 ulp.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) for an upper moment,
    /// [`Error::Negative`](crate::Error::Negative) for the lower, [`Error::NotFinite`](crate::Error::NotFinite) for any.
    ///
    /// ```
    /// use spinning_bodies::phenomena::Waist;
    /// let waist = Waist { upper_arms_out: 3.0, upper_arms_in: 1.0, lower: 1.0 };
    /// // −1·(3 − 1)/(4·2).
    /// assert_eq!(waist.swivel_angle(1.0)?, -0.25);
    /// let odd = Waist { upper_arms_out: 1e-160, upper_arms_in: 1e160, lower: 1e-200 };
    /// assert!((odd.swivel_angle(1.0)? / 1e-40 - 1.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn swivel_angle(&self, twist: f64) -> Result<f64> {
        let [outstretched, folded] = self.upper()?;
        let lower = not_negative("the lower moment", self.lower)?;
        let twist = finite("the twist", twist)?;
        // Quotients of at most 1, because a product of two moments could overflow.
        let share = lower / (folded.min(outstretched) + lower);
        let turn = -twist * share * ((outstretched - folded) / (folded.max(outstretched) + lower));
        finite("the swivel angle", turn)
    }

    /// Turns of the lower body, radians, in the two phases in which it turns: while the upper body twists by `twist` with the arms out,
    /// −A_out Ψ/(A_out + B), and while it untwists with the arms in, +A_in Ψ/(A_in + B). The second is the smaller.
    /// Observed error: 2.5 ulp, as far as A/(A + B) is in the range of doubles.
    ///
    /// # Errors
    /// As [`swivel_angle`](Self::swivel_angle).
    ///
    /// ```
    /// use spinning_bodies::phenomena::Waist;
    /// let waist = Waist { upper_arms_out: 3.0, upper_arms_in: 1.0, lower: 1.0 };
    /// assert_eq!(waist.phases(1.0)?, [-0.75, 0.5]);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn phases(&self, twist: f64) -> Result<[f64; 2]> {
        let upper = self.upper()?;
        let lower = not_negative("the lower moment", self.lower)?;
        let twist = finite("the twist", twist)?;
        let [out, back] = upper.map(|moment| twist * Swivel { lower }.turn_back(moment));
        Ok([-out, back])
    }

    /// The lower moment, kg m², for which these arms turn the body furthest: B = √(A_in A_out). The turn is then
    /// Ψ (√A_out − √A_in)/(√A_out + √A_in), always less than the twist.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite) for an upper moment.
    ///
    /// ```
    /// use spinning_bodies::phenomena::Waist;
    /// let waist = Waist { upper_arms_out: 3.0, upper_arms_in: 1.0, lower: 1.0 };
    /// assert!((waist.best_lower()? - 3.0_f64.sqrt()).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn best_lower(&self) -> Result<f64> {
        let [outstretched, folded] = self.upper()?;
        Ok(outstretched.sqrt() * folded.sqrt())
    }

    /// The moments of the upper part, arms out and in.
    fn upper(&self) -> Result<[f64; 2]> {
        Ok([
            positive("the upper moment with arms out", self.upper_arms_out)?,
            positive("the upper moment with arms in", self.upper_arms_in)?,
        ])
    }
}

/// The shape plane of a body of two parts on one axis: x is the moment A of the upper part, ψ its twist against the lower part.
///
/// At angular momentum zero A(β′ + ψ′) + Bβ′ = 0, so the lower part turns by β′ = −A/(A + B) ψ′.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swivel {
    /// Moment B of the lower part, kg m².
    pub lower: f64,
}

impl Swivel {
    /// Rate of the lower part, rad/s, at angular momentum L: β′ = (L − Aψ′)/(A + B), the part due to L and the part due to the shape.
    pub(crate) fn rate(&self, angular_momentum: f64, upper: f64, twist_rate: f64) -> f64 {
        angular_momentum / (upper + self.lower) - self.turn_back(upper) * twist_rate
    }
}

impl ShapePlane for Swivel {
    fn turn_back(&self, upper: f64) -> f64 {
        // Tends to 0 for a heavy lower part, is 1 for one of no moment.
        upper / (upper + self.lower)
    }

    fn curvature(&self, upper: f64) -> f64 {
        let whole = upper + self.lower;
        self.lower / whole / whole
    }
}
