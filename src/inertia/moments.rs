//! Three principal moments, sorted, and checked that a body can have them.

use crate::error::{Error, Result, each, not_negative};

/// Principal moments I₁ ≤ I₂ ≤ I₃ in kg m², checked that a body can have them.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "[f64; 3]")
)]
pub struct PrincipalMoments([f64; 3]);

#[cfg(feature = "serde")]
impl TryFrom<[f64; 3]> for PrincipalMoments {
    type Error = Error;

    fn try_from([a, b, c]: [f64; 3]) -> Result<Self> {
        Self::new(a, b, c)
    }
}

impl PrincipalMoments {
    /// The three moments in ascending order, checked (2.4).
    ///
    /// Domain: finite, not negative, and I₁ + I₂ ≥ I₃ up to 4 eps·I₃, because a lamina, where equality
    /// holds, may have been rounded. Equality means that all mass lies in a plane; I₁ = 0 that it lies on
    /// a line. Cost: a few comparisons.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::Negative`], [`Error::TriangleInequality`].
    ///
    /// ```
    /// use spinning_bodies::inertia::PrincipalMoments;
    /// assert_eq!(PrincipalMoments::new(4.0, 2.0, 3.0)?.values(), [2.0, 3.0, 4.0]);
    /// assert!(PrincipalMoments::new(1.0, 2.0, 3.5).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(a: f64, b: f64, c: f64) -> Result<Self> {
        each(not_negative, "a principal moment", [a, b, c])?;
        // Adding 0.0 turns −0 into +0: quotients and roots would carry the sign on.
        let mut sorted = [a, b, c].map(|moment| moment + 0.0);
        sorted.sort_by(f64::total_cmp);
        possible(sorted, 4.0 * f64::EPSILON * sorted[2])?;
        Ok(Self(sorted))
    }

    /// For moments already ascending and admissible up to rounding: pulls them onto the boundary.
    pub(crate) fn nearest(ascending: [f64; 3]) -> Self {
        let smallest = ascending[0].max(0.0);
        let middle = ascending[1].max(smallest);
        let excess = (ascending[2] - middle - smallest).max(0.0);
        Self([smallest, middle, (ascending[2] - excess).max(middle)])
    }

    /// I₁ ≤ I₂ ≤ I₃, kg m².
    ///
    /// ```
    /// use spinning_bodies::inertia::PrincipalMoments;
    /// assert_eq!(PrincipalMoments::new(3.0, 1.0, 2.0)?.values(), [1.0, 2.0, 3.0]);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn values(&self) -> [f64; 3] {
        self.0
    }

    /// The greatest angle that L can make with Ω, radians: arccos(2√(I₁I₃)/(I₁+I₃)) (2.2).
    ///
    /// Attained in the plane of axes 1 and 3, where tan² of the angle between Ω and axis 1 is I₁/I₃
    /// ([`Self::widest_omega`]); zero if all moments are equal, a right angle for a rod. Computed as
    /// an arctangent of (I₃−I₁) and 2√(I₁I₃), so that it keeps its digits when the moments nearly agree.
    /// Cost: two roots and an arctangent.
    ///
    /// ```
    /// use spinning_bodies::inertia::PrincipalMoments;
    /// // A cube and a rod.
    /// assert_eq!(PrincipalMoments::new(1.0, 1.0, 1.0)?.greatest_angle(), 0.0);
    /// assert_eq!(PrincipalMoments::new(0.0, 1.0, 1.0)?.greatest_angle(), std::f64::consts::FRAC_PI_2);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn greatest_angle(&self) -> f64 {
        let [i1, _, i3] = self.0;
        (0.5 * (i3 - i1)).atan2(i1.sqrt() * i3.sqrt())
    }

    /// The unit angular velocity, along the principal axes, at which L leans furthest from Ω (2.2).
    ///
    /// (√I₃, 0, √I₁)/√(I₁+I₃); the first axis if all moments are zero.
    ///
    /// ```
    /// use spinning_bodies::inertia::PrincipalMoments;
    /// let [x, y, z] = PrincipalMoments::new(1.0, 2.0, 3.0)?.widest_omega();
    /// assert!((x - 0.75_f64.sqrt()).abs() < 1e-15 && y == 0.0 && (z - 0.5).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn widest_omega(&self) -> [f64; 3] {
        let [i1, _, i3] = self.0;
        let (root1, root3) = (i1.sqrt(), i3.sqrt());
        let length = root1.hypot(root3);
        if length > 0.0 {
            [root3 / length, 0.0, root1 / length]
        } else {
            [1.0, 0.0, 0.0]
        }
    }
}

/// Refuses ascending moments that no body has, beyond this slack.
pub(crate) fn possible([smallest, middle, largest]: [f64; 3], slack: f64) -> Result<()> {
    // I3 − I2 ≤ I1 rather than I1 + I2 ≥ I3: the sum may overflow, and the difference is exact wherever the decision is close (I3 ≤ 2 I2).
    if largest - middle > smallest + slack {
        return Err(Error::TriangleInequality {
            smallest,
            middle,
            largest,
        });
    }
    Ok(())
}
