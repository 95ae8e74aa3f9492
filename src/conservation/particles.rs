//! Point masses: their momentum, angular momentum and energy, about any point.

use super::force::ForceAndTorque;
use crate::error::{Result, finite, not_empty, positive};
use crate::frame::{SpaceVector, finite_vector};

/// A point mass, its position and its velocity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Particle {
    /// Mass, kg.
    pub mass: f64,
    /// Position, m.
    pub position: SpaceVector,
    /// Velocity, m/s.
    pub velocity: SpaceVector,
}

impl Particle {
    fn motion(&self) -> [SpaceVector; 2] {
        [self.position, self.velocity]
    }
}

/// Kinetic energy in its two parts (tutorial 2.3), joules.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EnergyParts {
    /// ½MV²: the whole mass moving with the centre of mass.
    pub translational: f64,
    /// ½Σm(v−V)²: motion relative to the centre of mass; for a rigid body ½⟨IΩ, Ω⟩.
    pub relative: f64,
}

/// Angular momentum about a point in its two parts (tutorial 2.2), kg m²/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AngularMomentumParts {
    /// (C−O)∧P: the whole mass moving with the centre of mass.
    pub orbital: SpaceVector,
    /// Σ(x−C)∧m(v−V): the same about every point O; for a rigid body IΩ.
    pub spin: SpaceVector,
}

/// A collection of point masses, not empty, with positive masses and finite motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Particles {
    particles: Vec<Particle>,
    mass: f64,
    /// Place and velocity of the centre of mass, rounded, and what they are more than that.
    rounded: [SpaceVector; 2],
    rest: [SpaceVector; 2],
}

impl Particles {
    /// The collection of these particles.
    ///
    /// # Errors
    /// [`Error::Empty`](crate::Error::Empty); [`Error::NotPositive`](crate::Error::NotPositive) for a mass; [`Error::NotFinite`](crate::Error::NotFinite) for a mass, position, velocity,
    /// or if the total mass or the centre's place or velocity overflows. Momentum and energy may still exceed the greatest double.
    ///
    /// ```
    /// use spinning_bodies::{conservation::{Particle, Particles}, frame::SpaceVector};
    /// let at = |x, v| Particle { mass: 1.0, position: SpaceVector::new(x, 0.0, 0.0), velocity: SpaceVector::new(0.0, v, 0.0) };
    /// let pair = Particles::new([at(-1.0, 1.0), at(3.0, 5.0)])?;
    /// assert_eq!(pair.center(), SpaceVector::new(1.0, 0.0, 0.0));
    /// assert!(Particles::new([]).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(particles: impl Into<Vec<Particle>>) -> Result<Self> {
        let particles = particles.into();
        not_empty("the list of particles", &particles)?;
        for particle in &particles {
            positive("the mass of a particle", particle.mass)?;
            finite_vector("the position of a particle", particle.position)?;
            finite_vector("the velocity of a particle", particle.velocity)?;
        }
        let mass = finite("the total mass", particles.iter().map(|p| p.mass).sum())?;
        // A mean and what it lacks, so that nothing is lost far away or at great speed.
        let mean = |k: usize, from: SpaceVector| -> SpaceVector {
            let parts = particles
                .iter()
                .map(|p| (p.mass / mass) * (p.motion()[k] - from));
            parts.sum()
        };
        let rounded = [0, 1].map(|k| mean(k, SpaceVector::zero()));
        let rest = [0, 1].map(|k| mean(k, rounded[k]));
        let particles = Self {
            particles,
            mass,
            rounded,
            rest,
        };
        finite_vector("the centre of mass", particles.center())?;
        finite_vector("the velocity of the centre", particles.velocity())?;
        Ok(particles)
    }

    /// Centre of mass C = Σmx/M, m.
    ///
    /// ```
    /// use spinning_bodies::{conservation::{Particle, Particles}, frame::SpaceVector};
    /// let at = |x, v| Particle { mass: 1.0, position: SpaceVector::new(x, 0.0, 0.0), velocity: SpaceVector::new(0.0, v, 0.0) };
    /// let pair = Particles::new([at(-1.0, 1.0), at(3.0, 5.0)])?;
    /// assert_eq!(pair.center(), SpaceVector::new(1.0, 0.0, 0.0));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn center(&self) -> SpaceVector {
        self.rounded[0] + self.rest[0]
    }

    fn velocity(&self) -> SpaceVector {
        self.rounded[1] + self.rest[1]
    }

    /// Position and velocity of a particle less those of the centre of mass.
    fn relative(&self, particle: &Particle) -> [SpaceVector; 2] {
        let motion = particle.motion();
        [0, 1].map(|k| (motion[k] - self.rounded[k]) - self.rest[k])
    }

    /// Momentum P = Σmv (tutorial 2.2), kg m/s.
    ///
    /// ```
    /// use spinning_bodies::{conservation::{Particle, Particles}, frame::SpaceVector};
    /// let at = |x, v| Particle { mass: 1.0, position: SpaceVector::new(x, 0.0, 0.0), velocity: SpaceVector::new(0.0, v, 0.0) };
    /// let pair = Particles::new([at(-1.0, 1.0), at(3.0, 5.0)])?;
    /// assert_eq!(pair.momentum(), SpaceVector::new(0.0, 6.0, 0.0));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn momentum(&self) -> SpaceVector {
        self.particles.iter().map(|p| p.mass * p.velocity).sum()
    }

    /// Angular momentum about `point`, L = Σ(x−O)∧mv (tutorial 2.2), kg m²/s.
    ///
    /// Positions are subtracted before anything is multiplied, so that far from the origin the error is that of the positions.
    ///
    /// ```
    /// use spinning_bodies::{conservation::{Particle, Particles}, frame::SpaceVector};
    /// let at = |x, v| Particle { mass: 1.0, position: SpaceVector::new(x, 0.0, 0.0), velocity: SpaceVector::new(0.0, v, 0.0) };
    /// let pair = Particles::new([at(-1.0, 1.0), at(3.0, 5.0)])?;
    /// // −1·1 + 3·5.
    /// assert_eq!(pair.angular_momentum_about(SpaceVector::zero()).z(), 14.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn angular_momentum_about(&self, point: SpaceVector) -> SpaceVector {
        self.particles
            .iter()
            .map(|p| (p.position - point).cross(&(p.mass * p.velocity)))
            .sum()
    }

    /// Angular momentum about `point`, split into that of the centre of mass and that about it (tutorial 2.2).
    ///
    /// The spin is summed from relative positions and relative velocities, and the point is subtracted before the centre is rounded: a fast or distant swarm keeps its digits.
    ///
    /// ```
    /// use spinning_bodies::{conservation::{Particle, Particles}, frame::SpaceVector};
    /// let at = |x, v| Particle { mass: 1.0, position: SpaceVector::new(x, 0.0, 0.0), velocity: SpaceVector::new(0.0, v, 0.0) };
    /// let pair = Particles::new([at(-1.0, 1.0), at(3.0, 5.0)])?;
    /// let parts = pair.angular_momentum_split(SpaceVector::zero());
    /// assert_eq!((parts.orbital.z(), parts.spin.z()), (6.0, 8.0));
    /// // Two metres long, and so far away that doubles are two metres apart: its middle is no double.
    /// let far = |y| Particle { mass: 1.0, position: SpaceVector::new(0.0, 1e16 + y, 0.0), velocity: SpaceVector::new(1.0, 0.0, 0.0) };
    /// let parts = Particles::new([far(0.0), far(2.0)])?.angular_momentum_split(SpaceVector::new(0.0, 1e16, 0.0));
    /// assert_eq!((parts.orbital.z(), parts.spin.z()), (-2.0, 0.0));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn angular_momentum_split(&self, point: SpaceVector) -> AngularMomentumParts {
        let spin = self.particles.iter().map(|p| {
            let [arm, velocity] = self.relative(p);
            arm.cross(&(p.mass * velocity))
        });
        AngularMomentumParts {
            orbital: ((self.rounded[0] - point) + self.rest[0])
                .cross(&(self.mass * self.velocity())),
            spin: spin.sum(),
        }
    }

    /// Kinetic energy ½Σmv², split into that of the centre of mass and that relative to it (tutorial 2.3).
    ///
    /// Both parts are sums of squares, neither is a difference of the other two.
    ///
    /// ```
    /// use spinning_bodies::{conservation::{Particle, Particles}, frame::SpaceVector};
    /// let at = |x, v| Particle { mass: 1.0, position: SpaceVector::new(x, 0.0, 0.0), velocity: SpaceVector::new(0.0, v, 0.0) };
    /// let pair = Particles::new([at(-1.0, 1.0), at(3.0, 5.0)])?;
    /// let parts = pair.energy_split();
    /// assert_eq!((parts.translational, parts.relative), (9.0, 4.0));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn energy_split(&self) -> EnergyParts {
        let relative = self.particles.iter().map(|p| {
            let [_, v] = self.relative(p);
            0.5 * (p.mass * v).dot(&v)
        });
        EnergyParts {
            translational: 0.5 * (self.mass * self.velocity()).dot(&self.velocity()),
            relative: relative.sum(),
        }
    }

    /// Total force and total torque about `point` of a field of force (tutorial 3.2): F = Σf, N = Σ(x−O)∧f.
    ///
    /// `field` gives the force on a particle in newtons; it may look at mass, position and velocity.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite) if the field or a total is not finite.
    ///
    /// ```
    /// use spinning_bodies::{conservation::{Particle, Particles}, frame::SpaceVector};
    /// let at = |x, v| Particle { mass: 1.0, position: SpaceVector::new(x, 0.0, 0.0), velocity: SpaceVector::new(0.0, v, 0.0) };
    /// let pair = Particles::new([at(-1.0, 1.0), at(3.0, 5.0)])?;
    /// let down = SpaceVector::new(0.0, 0.0, -10.0);
    /// let pull = pair.force_and_torque(SpaceVector::zero(), |particle| particle.mass * down)?;
    /// assert_eq!((pull.force.z(), pull.torque.y()), (-20.0, 20.0));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn force_and_torque(
        &self,
        point: SpaceVector,
        mut field: impl FnMut(&Particle) -> SpaceVector,
    ) -> Result<ForceAndTorque> {
        let mut total = ForceAndTorque {
            force: SpaceVector::zero(),
            torque: SpaceVector::zero(),
        };
        for particle in &self.particles {
            let force = finite_vector("the force on a particle", field(particle))?;
            total.force += force;
            total.torque += (particle.position - point).cross(&force);
        }
        finite_vector("the total force", total.force)?;
        finite_vector("the total torque", total.torque)?;
        Ok(total)
    }

    /// Total torque of the forces that the particles exert on each other (tutorial 3.4), newton metres.
    ///
    /// `force_on_first(a, b)` is the force of b on a; b gets the opposite force, so the total force is zero and the
    /// torque the same about every point: Σ(x_a − x_b)∧f over the pairs. It vanishes if the forces are central, and in
    /// general only then: "equal and opposite" is not enough for dL/dt = N.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite) if a force or the total is not finite. Cost: one call for each of the n(n−1)/2 pairs.
    ///
    /// ```
    /// use spinning_bodies::{conservation::{Particle, Particles}, frame::SpaceVector};
    /// let at = |x, v| Particle { mass: 1.0, position: SpaceVector::new(x, 0.0, 0.0), velocity: SpaceVector::new(0.0, v, 0.0) };
    /// let pair = Particles::new([at(-1.0, 1.0), at(3.0, 5.0)])?;
    /// // Equal, opposite and along the line between them: no torque.
    /// let torque = pair.internal_torque(|a, b| 3.0 * (b.position - a.position))?;
    /// assert_eq!(torque, SpaceVector::zero());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn internal_torque(
        &self,
        mut force_on_first: impl FnMut(&Particle, &Particle) -> SpaceVector,
    ) -> Result<SpaceVector> {
        let mut torque = SpaceVector::zero();
        for (i, first) in self.particles.iter().enumerate() {
            for second in &self.particles[i + 1..] {
                let force = force_on_first(first, second);
                let force = finite_vector("the force between two particles", force)?;
                torque += (first.position - second.position).cross(&force);
            }
        }
        finite_vector("the internal torque", torque)
    }
}
