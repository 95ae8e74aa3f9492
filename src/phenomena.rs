//! Strange rotational phenomena (tutorial 1.1): bodies that turn without angular momentum.

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
    /// The two turns nearly cancel; the difference is taken between the moments, before anything is rounded.
    /// Zero for A_out = A_in, for B = 0, and in the limit B → ∞. The pace does not matter. Observed error: 3 ulp.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) for an upper moment,
    /// [`Error::Negative`](crate::Error::Negative) for the lower, [`Error::NotFinite`](crate::Error::NotFinite) for any.
    pub fn swivel_angle(&self, twist: f64) -> Result<f64> {
        let outstretched = positive("the upper moment with arms out", self.upper_arms_out)?;
        let folded = positive("the upper moment with arms in", self.upper_arms_in)?;
        let lower = not_negative("the lower moment", self.lower)?;
        let twist = finite("the twist", twist)?;
        // Quotients of like magnitude: no product of two moments that might overflow.
        let share = lower / (folded + lower);
        finite(
            "the swivel angle",
            -twist * share * ((outstretched - folded) / (outstretched + lower)),
        )
    }
}
