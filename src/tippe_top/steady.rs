//! The axisymmetric tippe top in closed form: the tilts at which it can end, and the spin needed to get there.

use core::f64::consts::PI;

use nalgebra::{Matrix3, Vector3};

use super::bodies::{eccentric_ball, height, offset};
use super::body::ConvexBody;
use crate::error::{Result, finite, positive};
use crate::search::halved;

/// An axisymmetric top on a sphere: mass M, radius R, C at α R from the centre, moments I1 across the axis and I3 about it.
///
/// Any friction dissipates energy and conserves Jellett's integral λ = ⟨L, R z − ε e⟩. So the tilt moves down the effective potential
/// V(θ) = λ²/(2 R² D(θ)) + M g R (1 − α cos θ), D = I1 sin² θ + I3 (cos θ − α)², until it reaches a minimum, where the top neither slips nor
/// rises.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TippeTop {
    mass: f64,
    radius: f64,
    alpha: f64,
    transverse: f64,
    axial: f64,
    gravity: f64,
}

/// How far spin can turn an axisymmetric tippe top over (Ueda, Sasaki and Watanabe 2005), by γ = I1/I3.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Inversion {
    /// γ ≤ 1 − α: upright, C low, is stable at any spin.
    Never,
    /// 1 − α < γ < 1 + α: spun fast enough, it turns over completely.
    Complete,
    /// γ ≥ 1 + α: spun fast enough, it rises to a tilt short of π.
    Partial,
}

impl TippeTop {
    /// The top of this mass (kg), radius (m), α, moments I1, I3 about C (kg m²), under gravity g (m/s²).
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite); [`Error::OutOfRange`](crate::Error::OutOfRange) unless 0 < α < 1.
    ///
    /// ```
    /// use spinning_bodies::tippe_top::TippeTop;
    /// let unit = 0.02 * 0.02 * 0.02; // MR²
    /// let top = TippeTop::new(0.02, 0.02, 0.3, 131.0 / 350.0 * unit, 0.4 * unit, 9.81)?;
    /// assert_eq!(top.body()?.mass(), 0.02);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(
        mass: f64,
        radius: f64,
        alpha: f64,
        transverse: f64,
        axial: f64,
        gravity: f64,
    ) -> Result<Self> {
        offset(alpha)?;
        Ok(Self {
            mass: positive("the mass", mass)?,
            radius: positive("the radius", radius)?,
            alpha: positive("the offset of C over the radius", alpha)?,
            transverse: positive("the transverse moment of inertia", transverse)?,
            axial: positive("the axial moment of inertia", axial)?,
            gravity: positive("gravity", gravity)?,
        })
    }

    /// The same top as a body for a scene.
    ///
    /// # Errors
    /// As for [`ConvexBody::new`], and [`Error::TriangleInequality`](crate::Error::TriangleInequality) for moments that no body has.
    ///
    /// ```
    /// use spinning_bodies::tippe_top::TippeTop;
    /// let unit = 0.02 * 0.02 * 0.02; // MR²
    /// let top = TippeTop::new(0.02, 0.02, 0.3, 131.0 / 350.0 * unit, 0.4 * unit, 9.81)?;
    /// assert_eq!(top.body()?.center().z(), 0.3 * 0.02);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn body(&self) -> Result<ConvexBody> {
        let unit = self.mass * self.radius * self.radius;
        let moments = Vector3::new(self.transverse, self.transverse, self.axial) / unit;
        let inertia = Matrix3::from_diagonal(&moments);
        eccentric_ball(self.mass, self.radius, self.alpha, inertia)
    }

    /// How far spin can turn it over.
    ///
    /// ```
    /// use spinning_bodies::tippe_top::{Inversion, TippeTop};
    /// let unit = 0.02 * 0.02 * 0.02; // MR²
    /// let top = TippeTop::new(0.02, 0.02, 0.3, 131.0 / 350.0 * unit, 0.4 * unit, 9.81)?;
    /// assert_eq!(top.inversion(), Inversion::Complete);
    /// // With equal moments it turns over, however little C is off the centre.
    /// let nearly_central = TippeTop::new(0.02, 0.02, 1e-17, unit, unit, 9.81)?;
    /// assert_eq!(nearly_central.inversion(), Inversion::Complete);
    /// // γ = 1 − α: no spin makes it rise, and none is told.
    /// let limit = TippeTop::new(1.0, 1.0, 0.4, 0.42, 0.7, 9.81)?;
    /// assert_eq!((limit.inversion(), limit.least_spin_to_rise()), (Inversion::Never, None));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn inversion(&self) -> Inversion {
        match [0.0, PI].map(|tilt| self.precession(tilt)) {
            [None, _] => Inversion::Never,
            [_, Some(_)] => Inversion::Complete,
            [_, None] => Inversion::Partial,
        }
    }

    /// λ = R I3 ω (cos θ − α) for spin ω (rad/s) about the axis at tilt θ: J s m.
    ///
    /// ```
    /// use spinning_bodies::tippe_top::TippeTop;
    /// let unit = 0.02 * 0.02 * 0.02; // MR²
    /// let top = TippeTop::new(0.02, 0.02, 0.3, 131.0 / 350.0 * unit, 0.4 * unit, 9.81)?;
    /// let jellett = 0.02 * 0.4 * unit * 100.0 * (1.0 - 0.3);
    /// assert!((top.jellett_of_spin(100.0, 0.0) / jellett - 1.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn jellett_of_spin(&self, spin: f64, tilt: f64) -> f64 {
        self.radius * self.axial * spin * self.arm(tilt)
    }

    /// cos θ − α, for small tilts from 1 − cos θ, which the cosine would lose beside a small 1 − α.
    fn arm(&self, tilt: f64) -> f64 {
        let half = (0.5 * tilt).sin();
        match tilt.abs() < 1.0 {
            true => (1.0 - self.alpha) - 2.0 * half * half,
            false => tilt.cos() - self.alpha,
        }
    }

    /// D(θ) = I1 sin² θ + I3 (cos θ − α)², kg m².
    fn effective_inertia(&self, tilt: f64) -> f64 {
        let (sin, arm) = (tilt.sin(), self.arm(tilt));
        self.transverse * sin * sin + self.axial * arm * arm
    }

    /// φ̇ of the steady state at tilt θ, if there is one.
    fn precession(&self, tilt: f64) -> Option<f64> {
        let steadying = self.axial * self.alpha - (self.axial - self.transverse) * tilt.cos();
        let pull = self.mass * self.gravity * self.alpha * self.radius;
        (steadying > 0.0).then(|| (pull / steadying).sqrt())
    }

    /// V(θ), the least energy at tilt θ and Jellett's integral λ: J.
    ///
    /// ```
    /// use spinning_bodies::tippe_top::TippeTop;
    /// let unit = 0.02 * 0.02 * 0.02; // MR²
    /// let top = TippeTop::new(0.02, 0.02, 0.3, 131.0 / 350.0 * unit, 0.4 * unit, 9.81)?;
    /// // Without spin only the height of C counts: 2MgRα from upright to inverted.
    /// let lift = top.effective_potential(std::f64::consts::PI, 0.0) - top.effective_potential(0.0, 0.0);
    /// assert!((lift / (2.0 * 0.02 * 9.81 * 0.02 * 0.3) - 1.0).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn effective_potential(&self, tilt: f64, jellett: f64) -> f64 {
        let spin = jellett / self.radius;
        0.5 * spin * (spin / self.effective_inertia(tilt))
            + self.mass * self.gravity * self.radius * height(self.alpha, tilt)
    }

    /// Jellett's integral λ = R φ̇ D(θ) of the steady state at tilt θ, if there is one: no slip, C at rest, Ω = φ̇ (z − α e), φ̇² = M g α R/(I3 α − (I3 − I1) cos θ).
    ///
    /// At θ = 0 it is the least λ at which the upright position with C low is unstable, λ² = M g R³ I3 α (1−α)⁴/(γ − 1 + α); at θ = π the least
    /// at which the inverted one is stable, √(M g R³ I3 α) (1+α)²/√(1 + α − γ).
    ///
    /// ```
    /// use spinning_bodies::tippe_top::TippeTop;
    /// let unit = 0.02 * 0.02 * 0.02; // MR²
    /// let top = TippeTop::new(0.02, 0.02, 0.3, 131.0 / 350.0 * unit, 0.4 * unit, 9.81)?;
    /// // At the steady state the effective potential is flat.
    /// let (tilt, step) = (1.0, 1e-4);
    /// let jellett = top.steady_jellett(tilt).unwrap();
    /// let [below, here, above] = [tilt - step, tilt, tilt + step].map(|tilt| top.effective_potential(tilt, jellett));
    /// assert!((above - below).abs() < 1e-7 * here);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn steady_jellett(&self, tilt: f64) -> Option<f64> {
        let precession = self.precession(tilt)?;
        Some(self.radius * precession * self.effective_inertia(tilt))
    }

    /// Least spin (rad/s) about the upright axis at which the top rises, if any.
    ///
    /// ```
    /// use spinning_bodies::tippe_top::TippeTop;
    /// let unit = 0.02 * 0.02 * 0.02; // MR²
    /// let top = TippeTop::new(0.02, 0.02, 0.3, 131.0 / 350.0 * unit, 0.4 * unit, 9.81)?;
    /// assert!(top.least_spin_to_rise().unwrap() < top.least_spin_to_invert().unwrap());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn least_spin_to_rise(&self) -> Option<f64> {
        let precession = self.precession(0.0)?;
        Some(precession * (1.0 - self.alpha))
    }

    /// Least spin (rad/s) about the upright axis at which the top turns over completely, if any: enough to rise, and enough to stand inverted.
    ///
    /// No tilt in between holds it, because λ of the [steady states](Self::steady_jellett) is greatest at one of the ends. Usually the inverted position needs more; for γ
    /// slightly above 1 − α, rising does.
    ///
    /// ```
    /// use spinning_bodies::tippe_top::TippeTop;
    /// let unit = 0.02 * 0.02 * 0.02; // MR²
    /// let top = TippeTop::new(0.02, 0.02, 0.3, 131.0 / 350.0 * unit, 0.4 * unit, 9.81)?;
    /// let spin = top.least_spin_to_invert().unwrap();
    /// let ends = top.final_tilt(top.jellett_of_spin(1.01 * spin, 0.0), 0.0)?;
    /// assert_eq!(ends, std::f64::consts::PI);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn least_spin_to_invert(&self) -> Option<f64> {
        let (low, high) = (1.0 - self.alpha, 1.0 + self.alpha);
        let stand = self.precession(PI)? * high * (high / low);
        Some(self.least_spin_to_rise()?.max(stand))
    }

    /// The final tilt (rad) of a top with Jellett's integral λ that starts at tilt `start` without excess energy: the first
    /// minimum of the effective potential downhill, or if there is none π for a rising top, 0 for a sinking one.
    ///
    /// The sign of V′ is that of the steady state's λ less this one; it is scanned in 4096 steps of θ and the change located to
    /// rounding. A start with much excess energy (a slow top spun about its own tilted axis) may leave that valley.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// use spinning_bodies::tippe_top::TippeTop;
    /// let unit = 0.02 * 0.02 * 0.02; // MR²
    /// let top = TippeTop::new(0.02, 0.02, 0.3, 131.0 / 350.0 * unit, 0.4 * unit, 9.81)?;
    /// // Slightly too slow to turn over completely, it ends short of that.
    /// let spin = 0.99 * top.least_spin_to_invert().unwrap();
    /// assert!(top.final_tilt(top.jellett_of_spin(spin, 0.0), 0.0)? < std::f64::consts::PI);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn final_tilt(&self, jellett: f64, start: f64) -> Result<f64> {
        let lambda = finite("Jellett's integral", jellett)?;
        let start = finite("the tilt at the start", start)?.clamp(0.0, PI);
        // V falls with θ where λ is greater than that of a steady state.
        let rises = |tilt: f64| {
            let steady = self.steady_jellett(tilt);
            steady.is_some_and(|steady| lambda.abs() > steady)
        };
        let rising = rises(start);
        let still = |tilt: f64| rises(tilt) == rising;
        let goal = if rising { PI } else { 0.0 };
        let tilt = |step: u32| start + (goal - start) * f64::from(step) / f64::from(STEPS);
        let Some(step) = (1..=STEPS).find(|&step| !still(tilt(step))) else {
            return Ok(goal);
        };
        let bracket = [tilt(step - 1), tilt(step)];
        let [before, after] = halved(bracket, 0.0, |tilt| Ok(still(tilt)))?;
        Ok(0.5 * (before + after))
    }
}

/// Steps in which the range of the tilt is scanned.
const STEPS: u32 = 4096;
