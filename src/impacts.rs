//! A meteorite strikes a planet and sticks (tutorial 4.2): the exact answer, and what the tutorial's formula leaves out.
//!
//! Two balances decide everything: of momentum, and of angular momentum about the point where C is at the moment of impact.
//!
//! * MV + mv = MV' + m(V' + Ω'∧x),
//! * IΩ + x∧mv = IΩ' + x∧m(V' + Ω'∧x).
//!
//! All vectors are written along the planet's axes as they stand at that moment: during the impact the planet has no time to turn.
//!
//! ```
//! use spinning_bodies::frame::BodyVector;
//! use spinning_bodies::impacts::{Meteorite, Planet, strike};
//!
//! let planet = Planet::spherical(1.0, 0.4, BodyVector::zero(), BodyVector::new(0.0, 0.0, 1.0))?;
//! let meteorite = Meteorite::new(0.01, BodyVector::new(-10.0, -20.0, 5.0))?;
//! let hit = strike(&planet, &meteorite, BodyVector::new(0.6, 0.0, 0.8))?;
//! assert!((hit.omega_after.x() - 412.0 / 1035.0).abs() < 1e-15);
//! # Ok::<(), spinning_bodies::Error>(())
//! ```

use nalgebra::{Matrix3, Vector3};

use crate::error::{Error, Result, finite, positive, within};
use crate::frame::{BodyVector, finite_vector};
use crate::inertia::InertiaMatrix;

/// A planet just before the impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Planet {
    /// Mass M, kg.
    pub mass: f64,
    /// Inertia matrix I about the centre.
    pub inertia: InertiaMatrix,
    /// Velocity V of the centre before the impact, m/s.
    pub velocity: BodyVector,
    /// Angular velocity Ω before the impact, rad/s.
    pub omega: BodyVector,
}

impl Planet {
    /// A planet of mass M (kg) and inertia matrix I about its centre (kg m²), with velocity V of the centre (m/s) and
    /// angular velocity Ω (rad/s).
    ///
    /// # Errors
    /// [`Error::NotPositive`] for the mass or if the inertia has a vanishing moment (a needle, a point),
    /// [`Error::NotFinite`] for any argument.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, impacts::Planet, inertia::InertiaMatrix};
    /// let inertia = InertiaMatrix::diagonal(4.0, 4.0, 5.0)?;
    /// let planet = Planet::new(10.0, inertia, BodyVector::zero(), BodyVector::new(0.0, 0.0, 1.0))?;
    /// assert_eq!(planet.inertia, inertia);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(
        mass: f64,
        inertia: InertiaMatrix,
        velocity: BodyVector,
        omega: BodyVector,
    ) -> Result<Self> {
        let mass = positive("the planet's mass", mass)?;
        let velocity = finite_vector("the planet's velocity", velocity)?;
        let omega = finite_vector("the planet's angular velocity", omega)?;
        // Solved once here, so that no later division by I can fail.
        solve(&inertia.matrix(), Vector3::zeros())?;
        Ok(Self {
            mass,
            inertia,
            velocity,
            omega,
        })
    }

    /// A planet with the same moment of inertia (kg m²) about every axis through its centre.
    ///
    /// # Errors
    /// As [`Planet::new`].
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, impacts::Planet};
    /// let planet = Planet::spherical(10.0, 4.0, BodyVector::zero(), BodyVector::zero())?;
    /// assert_eq!(planet.inertia.matrix()[(1, 1)], 4.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn spherical(
        mass: f64,
        moment: f64,
        velocity: BodyVector,
        omega: BodyVector,
    ) -> Result<Self> {
        let moment = positive("the planet's moment of inertia", moment)?;
        let inertia = InertiaMatrix::diagonal(moment, moment, moment)?;
        Self::new(mass, inertia, velocity, omega)
    }
}

/// A meteorite just before the impact: a point mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Meteorite {
    /// Mass m, kg.
    pub mass: f64,
    /// Velocity v, m/s.
    pub velocity: BodyVector,
}

impl Meteorite {
    /// A meteorite of mass m (kg) and velocity v (m/s).
    ///
    /// # Errors
    /// [`Error::NotPositive`] for the mass, [`Error::NotFinite`] for the mass or the velocity.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, impacts::Meteorite};
    /// assert!(Meteorite::new(10.0, BodyVector::zero()).is_ok());
    /// assert!(Meteorite::new(0.0, BodyVector::zero()).is_err());
    /// ```
    pub fn new(mass: f64, velocity: BodyVector) -> Result<Self> {
        Ok(Self {
            mass: positive("the meteorite's mass", mass)?,
            velocity: finite_vector("the meteorite's velocity", velocity)?,
        })
    }
}

/// Where a meteorite strikes: the effect of a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Impact {
    /// The meteorite, velocity along the planet's axes.
    pub meteorite: Meteorite,
    /// The point of impact from the planet's centre, along the same axes, m.
    pub at: BodyVector,
}

/// An impact, before and after.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strike {
    /// The planet before the impact.
    pub planet: Planet,
    /// The meteorite before the impact.
    pub meteorite: Meteorite,
    /// The point of impact x, metres from C.
    pub at: BodyVector,
    /// Ω' − Ω, rad/s.
    change: BodyVector,
    /// Velocity V' of the planet's own centre C after the impact, m/s.
    pub velocity_after: BodyVector,
    /// Angular velocity Ω' after the impact, rad/s.
    pub omega_after: BodyVector,
    /// Kinetic energy turned into heat, joules, never negative beyond rounding: ½⟨w, J⟩, half the closing velocity times
    /// the impulse. No large energies are subtracted, and the value is the same in every frame.
    pub energy_lost: f64,
}

/// The meteorite hits the planet at the point `at` (x, metres from the centre C) and sticks (tutorial 4.2).
///
/// Exact, for any masses, any inertia matrix and any frame. With μ = mM/(M+m) and the closing velocity
/// w = v − V − Ω∧x of the meteorite seen from the ground,
///
/// \[I + μ(|x|²δ − x xᵀ)\](Ω' − Ω) = μ x∧w.
///
/// The matrix is the inertia of planet plus meteorite about their common centre of mass. The equation is the tutorial's
/// two balances with V' eliminated, solved for the *change* of Ω: even the change by a pebble keeps all its digits.
/// `at` is not required to lie on a surface, nor the meteorite to come from outside: see [`Strike::closing_speed`].
///
/// Observed error: 3 ulp of the largest component against exact rationals; as many times more where μ|x|² exceeds the moments, for a point far out, where the moments differ, and
/// where |x||w| exceeds |x∧w|, for a hit towards the centre, and where Ω' − Ω exceeds Ω', for a hit that all but stops the spin.
/// Cost: one 3×3 Cholesky solution.
///
/// # Errors
/// [`Error::NotFinite`] for x, or if the result overflows; [`Error::NotPositive`] where the moments vanish beside μ|x|².
///
/// ```
/// use spinning_bodies::{frame::BodyVector, impacts::{Meteorite, Planet, strike}};
/// let planet = Planet::spherical(10.0, 4.0, BodyVector::zero(), BodyVector::zero())?;
/// let meteorite = Meteorite::new(10.0, BodyVector::new(0.0, 2.0, 0.0))?;
/// let hit = strike(&planet, &meteorite, BodyVector::new(1.0, 0.0, 0.0))?;
/// // (4 + 5)Ω' = 5·2 with the reduced mass of 5 kg.
/// assert!((hit.omega_after.z() - 10.0 / 9.0).abs() < 1e-15);
/// // Both at 10⁹ m/s, and the ground at 0.3 m/s beside: (4 + 5)(Ω' − 0.3) = 5·(2 − 0.3).
/// let planet = Planet::spherical(10.0, 4.0, BodyVector::new(0.0, 1e9, 0.0), BodyVector::new(0.0, 0.0, 0.3))?;
/// let meteorite = Meteorite::new(10.0, BodyVector::new(0.0, 1e9 + 2.0, 0.0))?;
/// let hit = strike(&planet, &meteorite, BodyVector::new(1.0, 0.0, 0.0))?;
/// assert!((hit.omega_after.z() - (0.3 + 8.5 / 9.0)).abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn strike(planet: &Planet, meteorite: &Meteorite, at: BodyVector) -> Result<Strike> {
    // ANCHOR: strike
    let at = finite_vector("the point of impact", at)?;
    let (m, big_m) = (meteorite.mass, planet.mass);
    let mu = m.min(big_m) / (1.0 + m.min(big_m) / m.max(big_m)); // mM/(M + m), without the product
    // The velocities of the bodies first: in a fast frame they are all but equal.
    let closing = meteorite.velocity - planet.velocity - planet.omega.cross(&at);

    let together = planet.inertia.matrix() + InertiaMatrix::of_particle(mu, at)?.matrix();
    let change = solve(&together, mu * at.cross(&closing).components())?;

    let impulse = mu * (closing - change.cross(&at));
    let velocity_after = planet.velocity + impulse / big_m;
    let omega_after = planet.omega + change;
    // ANCHOR_END: strike
    Ok(Strike {
        planet: *planet,
        meteorite: *meteorite,
        at,
        change,
        velocity_after: finite_vector("the velocity after the impact", velocity_after)?,
        omega_after: finite_vector("the angular velocity after the impact", omega_after)?,
        energy_lost: finite("the energy lost", 0.5 * closing.dot(&impulse))?,
    })
}

impl Strike {
    /// Speed at which the meteorite comes in along the radius, −⟨x, v−V⟩/|x|, m/s: positive if it comes from outside a
    /// round planet.
    ///
    /// # Errors
    /// [`Error::ZeroVector`] for a hit at the centre.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, impacts::{Meteorite, Planet, strike}};
    /// let planet = Planet::spherical(10.0, 4.0, BodyVector::zero(), BodyVector::zero())?;
    /// let meteorite = Meteorite::new(10.0, BodyVector::new(-1.0, 2.0, 0.0))?;
    /// let hit = strike(&planet, &meteorite, BodyVector::new(1.0, 0.0, 0.0))?;
    /// assert_eq!(hit.closing_speed()?, 1.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn closing_speed(&self) -> Result<f64> {
        let outward = self.at.direction("the point of impact")?;
        Ok(-outward.dot(&(self.meteorite.velocity - self.planet.velocity)))
    }

    /// Angle between Ω and Ω', radians, 0…π: how far the axis of rotation is tilted.
    ///
    /// Formed from sine and cosine, the sine from the change of Ω, so that a tilt of 10⁻¹² rad keeps its digits, and so does one near π.
    ///
    /// # Errors
    /// [`Error::ZeroVector`] if the planet does not spin before or after.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, impacts::{Meteorite, Planet, strike}};
    /// let planet = Planet::spherical(10.0, 4.0, BodyVector::zero(), BodyVector::new(0.0, 0.0, 1.0))?;
    /// let meteorite = Meteorite::new(10.0, BodyVector::new(0.0, 1.0, -1.8))?;
    /// let hit = strike(&planet, &meteorite, BodyVector::new(1.0, 0.0, 0.0))?;
    /// // 1 rad/s about y is added to 1 rad/s about z.
    /// assert!((hit.tilt()? - std::f64::consts::FRAC_PI_4).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn tilt(&self) -> Result<f64> {
        let (before, after) = (self.planet.omega, self.omega_after);
        let before = before.direction("the angular velocity before the impact")?;
        after.direction("the angular velocity after the impact")?;
        Ok(before.cross(&self.change).norm().atan2(before.dot(&after)))
    }

    /// The tutorial's approximation Ω' ≈ Ω + I⁻¹(x∧mv), rad/s, exactly as printed in 4.2.
    ///
    /// It uses v, so its value depends on the frame: it is right for m ≪ M in the frame where the planet is at rest, and there
    /// equals [`Strike::first_order_at_rest`]. For a uniform ball at rest, hit tangentially, its change of Ω is too large by
    /// exactly the factor 1 + (7/2)m/M.
    ///
    /// # Errors
    /// [`Error::NotFinite`] on overflow.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, impacts::{Meteorite, Planet, strike}};
    /// let planet = Planet::spherical(10.0, 4.0, BodyVector::zero(), BodyVector::zero())?;
    /// let meteorite = Meteorite::new(10.0, BodyVector::new(-1.0, 2.0, 0.0))?;
    /// let hit = strike(&planet, &meteorite, BodyVector::new(1.0, 0.0, 0.0))?;
    /// // The exact result is 10/9 rad/s: a meteorite as heavy as the planet is not small.
    /// assert_eq!(hit.first_order()?.z(), 5.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn first_order(&self) -> Result<BodyVector> {
        self.approximation(self.meteorite.velocity)
    }

    /// The approximation with v−V in place of v, rad/s: the same in every frame.
    ///
    /// # Errors
    /// [`Error::NotFinite`] on overflow.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, impacts::{Meteorite, Planet, strike}};
    /// let planet = Planet::spherical(10.0, 4.0, BodyVector::zero(), BodyVector::zero())?;
    /// let meteorite = Meteorite::new(10.0, BodyVector::new(-1.0, 2.0, 0.0))?;
    /// let hit = strike(&planet, &meteorite, BodyVector::new(1.0, 0.0, 0.0))?;
    /// // The planet was at rest.
    /// assert_eq!(hit.first_order_at_rest()?, hit.first_order()?);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn first_order_at_rest(&self) -> Result<BodyVector> {
        self.approximation(self.meteorite.velocity - self.planet.velocity)
    }

    fn approximation(&self, velocity: BodyVector) -> Result<BodyVector> {
        let kick = self.at.cross(&(self.meteorite.mass * velocity));
        let change = solve(&self.planet.inertia.matrix(), kick.components())?;
        let omega = self.planet.omega + change;
        finite_vector("the first-order angular velocity", omega)
    }
}

/// Solution of `matrix` y = `right` for a symmetric positive definite matrix of any magnitude: it is scaled before Cholesky's method.
fn solve(matrix: &Matrix3<f64>, right: Vector3<f64>) -> Result<BodyVector> {
    let scale = positive("the largest moment of inertia", matrix.amax())?;
    let factors = (matrix / scale).cholesky().ok_or(Error::NotPositive {
        quantity: "the smallest principal moment of inertia",
        value: 0.0,
    })?;
    Ok(BodyVector::from_components(factors.solve(&(right / scale))))
}

/// Mass ratio m/M of a meteorite that tilts the axis by `tilt` (radians, 0…π) in a grazing hit without changing |L|: 2κ(RΩ/v) sin(tilt/2).
///
/// The angular momenta before and after are the equal sides of a triangle whose base is what the meteorite brings, m v R;
/// `inertia_factor` κ = I/(MR²), `rim_speed` RΩ and `impact_speed` v in m/s. An order of magnitude: the planet's recoil
/// and the meteorite's own share of the inertia, both of relative size m/M, are left out.
///
/// # Errors
/// [`Error::NotPositive`], [`Error::OutOfRange`] for a tilt outside 0…π, [`Error::NotFinite`].
///
/// ```
/// use spinning_bodies::impacts::grazing_mass_ratio;
/// assert!((grazing_mass_ratio(0.4, 1.0, 8.0, std::f64::consts::PI)? - 0.1).abs() < 1e-16);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn grazing_mass_ratio(
    inertia_factor: f64,
    rim_speed: f64,
    impact_speed: f64,
    tilt: f64,
) -> Result<f64> {
    let kappa = positive("the inertia factor", inertia_factor)?;
    let rim_speed = positive("the speed of the rim", rim_speed)?;
    let impact_speed = positive("the speed of the impact", impact_speed)?;
    within("the tilt", tilt, 0.0, core::f64::consts::PI)?;
    let ratio = 2.0 * kappa * (rim_speed / impact_speed) * (0.5 * tilt).sin();
    finite("the mass ratio", ratio)
}

/// What is known of a planet and its rotation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Observed {
    /// Mass, kg.
    pub mass: f64,
    /// Equatorial radius, m.
    pub radius: f64,
    /// Period of rotation, s.
    pub period: f64,
    /// Escape speed, m/s.
    pub escape_speed: f64,
    /// Angle between the axis of rotation and the normal to the orbit, radians.
    pub obliquity: f64,
    /// I/(MR²), dimensionless.
    pub inertia_factor: f64,
}

/// Uranus, from the NASA Planetary Fact Sheet (D. R. Williams, Goddard Space Flight Center). Its rotation is retrograde, which the obliquity of 97.77°
/// already expresses; models of the interior reach an inertia factor of 0.23.
///
/// ```
/// use spinning_bodies::impacts::{URANUS, grazing_mass_ratio};
/// // A grazing hit at escape speed that tilts Uranus as far as it is tilted, without changing its rate of spin.
/// let rim_speed = URANUS.radius * std::f64::consts::TAU / URANUS.period;
/// let ratio = grazing_mass_ratio(URANUS.inertia_factor, rim_speed, URANUS.escape_speed, URANUS.obliquity)?;
/// assert!((ratio - 0.041).abs() < 5e-4);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub const URANUS: Observed = Observed {
    mass: 8.681e25,
    radius: 25_559e3,
    period: 17.24 * 3600.0,
    escape_speed: 21.3e3,
    obliquity: 97.77 * core::f64::consts::PI / 180.0,
    inertia_factor: 0.225,
};
