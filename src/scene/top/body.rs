//! The body of a top and how it starts.

use crate::error::{Error, Result, finite, not_negative};
use crate::euler_equations::finite_vector;
use crate::frame::{Attitude, BodyVector};
use crate::inertia::PrincipalMoments;

/// A rigid body as a top sees it: mass, principal moments about the pivot in the order of the axes, centre of mass from the pivot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    pub(super) mass: f64,
    pub(super) moments: [f64; 3],
    pub(super) center: [f64; 3],
}

impl Body {
    /// The body with these moments (kg m², any order), and neither mass nor arm: gravity does not turn it.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::Negative`], [`Error::TriangleInequality`].
    pub fn new(moments: [f64; 3]) -> Result<Self> {
        let [i1, i2, i3] = moments;
        for moment in moments {
            not_negative("a principal moment", finite("a principal moment", moment)?)?;
        }
        PrincipalMoments::new(i1, i2, i3)?;
        Ok(Self {
            mass: 0.0,
            moments,
            center: [0.0; 3],
        })
    }

    /// The same with mass (kg) and centre of mass C, seen from the pivot along the principal axes (m).
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::Negative`] for the mass.
    pub fn with_center_of_mass(self, mass: f64, center: BodyVector) -> Result<Self> {
        let center = finite_vector("the centre of mass", center)?;
        let [x, y, z]: [f64; 3] = center.components().into();
        let mass = not_negative("the mass", mass)?;
        for arm in [mass * x, mass * y, mass * z] {
            finite("mass times centre of mass", arm)?;
        }
        Ok(Self {
            mass,
            center: [x, y, z],
            ..self
        })
    }

    /// MC, kg m.
    pub(super) fn arm(&self) -> [f64; 3] {
        self.center.map(|component| self.mass * component)
    }

    /// Whether axis 3 is an axis of symmetry, C on it.
    pub(super) fn is_symmetric_about_third(&self) -> bool {
        let [x, y, _] = self.arm();
        self.moments[0] == self.moments[1] && x == 0.0 && y == 0.0
    }
}

/// How a top starts: its attitude, and Ω or L along the principal axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Start {
    pub(super) attitude: Attitude,
    pub(super) spin: Spin,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Spin {
    Omega(BodyVector),
    AngularMomentum(BodyVector),
}

impl Start {
    /// Turning with Ω, rad/s.
    pub const fn with_omega(omega: BodyVector, attitude: Attitude) -> Self {
        Self {
            attitude,
            spin: Spin::Omega(omega),
        }
    }

    /// Turning with L, kg m²/s. The closed forms take it as it is, without a division.
    pub const fn with_angular_momentum(l: BodyVector, attitude: Attitude) -> Self {
        Self {
            attitude,
            spin: Spin::AngularMomentum(l),
        }
    }

    /// Ω, rad/s.
    pub(super) fn omega(&self, moments: [f64; 3]) -> Result<BodyVector> {
        match self.spin {
            Spin::Omega(omega) => finite_vector("the angular velocity", omega),
            Spin::AngularMomentum(l) => {
                let l: [f64; 3] = finite_vector("the angular momentum", l)?
                    .components()
                    .into();
                let mut omega = [0.0; 3];
                for k in 0..3 {
                    // About an axis without moment there is no angular momentum.
                    if l[k] == 0.0 {
                        continue;
                    }
                    if moments[k] == 0.0 {
                        return Err(Error::Condition {
                            condition: "the angular momentum about an axis without moment must be zero",
                            value: l[k],
                        });
                    }
                    omega[k] = finite("a component of the angular velocity", l[k] / moments[k])?;
                }
                Ok(BodyVector::new(omega[0], omega[1], omega[2]))
            }
        }
    }
}
