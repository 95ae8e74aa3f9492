//! Euler's equations without Euler: six masses on stiff springs, and Newton's law for each (tutorial 5.1).

use super::AxisMoments;
use crate::error::{Result, each_finite, finite, positive};
use crate::frame::{BodyVector, finite_vector};
use nalgebra::{Matrix3, Vector3};

/// Mass of a particle, kg.
const MASS: f64 = 0.125;

/// Six particles at the corners of an octahedron, every two joined by a spring: nearly a rigid body.
///
/// Once it is started, nothing in it mentions angular velocity: it moves by Newton's law for particles and Hooke's for springs.
#[derive(Debug, Clone)]
pub struct SpringBody {
    moments: AxisMoments,
    stiffness: f64,
    rest: [[f64; 6]; 6],
    positions: [Vector3<f64>; 6],
    velocities: [Vector3<f64>; 6],
}

impl SpringBody {
    /// A body with these principal moments (kg m²), particles of ⅛ kg, springs of `stiffness` N/m at rest length, turning
    /// at `omega` (rad/s).
    ///
    /// The pairs stand on the axes at ±a_i with a_i² = 2(I_j + I_k − I_i). The springs start unstretched, so the body
    /// begins to vibrate, with an amplitude of about m|Ω|²/stiffness of its size.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) for the stiffness or for a lamina, whose pairs coincide; [`Error::NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// use spinning_bodies::{euler_equations::{AxisMoments, SpringBody}, frame::BodyVector};
    /// let moments = AxisMoments::new(2.0, 2.5, 3.0)?;
    /// let body = SpringBody::new(moments, 1e4, BodyVector::new(0.0, 0.0, 1.0))?;
    /// assert!((body.omega()?.z() - 1.0).abs() < 1e-12);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(moments: AxisMoments, stiffness: f64, omega: BodyVector) -> Result<Self> {
        positive("the stiffness", stiffness)?;
        finite_vector("the angular velocity", omega)?;
        let [i1, i2, i3] = moments.values();
        let squares = [i2 - i1 + i3, i3 - i2 + i1, i1 - i3 + i2];
        let mut positions = [Vector3::zeros(); 6];
        for (axis, square) in squares.into_iter().enumerate() {
            let distance = positive("a second moment", square)?.sqrt() * core::f64::consts::SQRT_2;
            positions[2 * axis][axis] = distance;
            positions[2 * axis + 1][axis] = -distance;
        }
        let rest = core::array::from_fn(|a| {
            core::array::from_fn(|b| (positions[a] - positions[b]).norm())
        });
        let omega = omega.components();
        Ok(Self {
            moments,
            stiffness,
            rest,
            positions,
            velocities: positions.map(|x| omega.cross(&x)),
        })
    }

    /// Advances by `duration` seconds in `steps` steps of the leapfrog method, at least one; error O(step²).
    ///
    /// The springs limit the step: below 2/√(12·stiffness/mass) it is stable, a tenth of that is accurate. Cost: fifteen springs a step.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite) if the step was too long and the body flew apart.
    ///
    /// ```
    /// use spinning_bodies::{euler_equations::{AxisMoments, SpringBody}, frame::BodyVector};
    /// let moments = AxisMoments::new(2.0, 2.5, 3.0)?;
    /// let mut body = SpringBody::new(moments, 1e4, BodyVector::new(0.0, 0.0, 1.0))?;
    /// body.advance(0.1, 200)?;
    /// // With stiff springs it keeps turning about its own axis.
    /// assert!((body.omega()?.z() - 1.0).abs() < 1e-2);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn advance(&mut self, duration: f64, steps: u32) -> Result<()> {
        finite("the duration", duration)?;
        let steps = steps.max(1);
        let h = duration / f64::from(steps);
        let mut forces = self.forces();
        for _ in 0..steps {
            self.kick(&forces, 0.5 * h);
            for (position, velocity) in self.positions.iter_mut().zip(&self.velocities) {
                *position += velocity * h;
            }
            forces = self.forces();
            self.kick(&forces, 0.5 * h);
        }
        each_finite("a position", self.positions.iter().map(|place| place.sum()))?;
        Ok(())
    }

    fn kick(&mut self, forces: &[Vector3<f64>; 6], time: f64) {
        for (velocity, force) in self.velocities.iter_mut().zip(forces) {
            *velocity += force * (time / MASS);
        }
    }

    fn forces(&self) -> [Vector3<f64>; 6] {
        let mut forces = [Vector3::zeros(); 6];
        for a in 0..6 {
            for b in a + 1..6 {
                let d = self.positions[b] - self.positions[a];
                let length = (d.x * d.x + d.y * d.y + d.z * d.z).sqrt();
                let pull = d * (self.stiffness * (1.0 - self.rest[a][b] / length));
                forces[a] += pull;
                forces[b] -= pull;
            }
        }
        forces
    }

    /// The angular velocity Ω = I⁻¹L, rad/s, with L taken along the body's present axes.
    ///
    /// L = Σ m x∧v is exact; the axes are read off the three pairs, orthogonalised. The stretch of the springs enters at first
    /// order: about m|Ω|²/stiffness, relative.
    ///
    /// # Errors
    /// [`Error::ZeroVector`](crate::Error::ZeroVector) if the body has collapsed, [`Error::NotFinite`](crate::Error::NotFinite) on overflow.
    ///
    /// ```
    /// use spinning_bodies::{euler_equations::{AxisMoments, SpringBody}, frame::BodyVector};
    /// let moments = AxisMoments::new(2.0, 2.5, 3.0)?;
    /// let body = SpringBody::new(moments, 1e4, BodyVector::new(0.5, 0.0, 1.0))?;
    /// assert!((body.omega()? - BodyVector::new(0.5, 0.0, 1.0)).norm() < 1e-12);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn omega(&self) -> Result<BodyVector> {
        let l: Vector3<f64> = (0..6)
            .map(|k| self.positions[k].cross(&self.velocities[k]) * MASS)
            .sum();
        let name = "an axis of the body";
        let pair = |k: usize| {
            let axis = self.positions[2 * k] - self.positions[2 * k + 1];
            BodyVector::from_components(axis).direction(name)
        };
        let (e1, second) = (pair(0)?, pair(1)?);
        let e3 = e1.cross(&second).direction(name)?;
        let axes = [e1, e3.cross(&e1), e3].map(|axis| axis.components());
        let seen = BodyVector::from_components(Matrix3::from_columns(&axes).tr_mul(&l));
        finite_vector("the angular velocity", self.moments.angular_velocity(seen))
    }
}
