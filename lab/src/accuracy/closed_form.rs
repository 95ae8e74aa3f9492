//! The closed forms, as methods.

use spinning_bodies::euler_equations::{AxisMoments, HeavyTop, Integrability};
use spinning_bodies::euler_top::EulerTop;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::integrators::geometric::Phase;
use spinning_bodies::integrators::{Cost, Effort, Solution};
use spinning_bodies::kovalevskaya_top::KovalevskayaTop;
use spinning_bodies::lagrange_top::LagrangeTop;
use spinning_bodies::{Error, Result};

use crate::follow::Follow;

/// The exact motion of a body with a closed form: free (6), or with a lever along axis 3 and I₁ = I₂ (7), or Kovalevskaya's (8).
///
/// It depends on no step and no tolerance. Cost: one evaluation for each time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClosedForm {
    moments: [f64; 3],
    lever: BodyVector,
    kind: Kind,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    Euler,
    Lagrange,
    Kovalevskaya,
}

impl ClosedForm {
    /// The closed form for a body with these moments, kg m², and this lever MgC, N m.
    ///
    /// # Errors
    /// Those of an invalid moment; [`Error::NotFinite`]; [`Error::Condition`] for a body without a closed form, or with its axis of symmetry not the third.
    pub fn new(moments: [f64; 3], lever: [f64; 3]) -> Result<Self> {
        let [i1, i2, i3] = moments;
        let [x, y, z] = lever;
        let lever = BodyVector::new(x, y, z);
        let top = HeavyTop::new(AxisMoments::new(i1, i2, i3)?, lever)?;
        let kind = match top.kind() {
            Integrability::Euler => Kind::Euler,
            Integrability::Lagrange(2) => Kind::Lagrange,
            Integrability::SphericalInertia if x == 0.0 && y == 0.0 => Kind::Lagrange,
            Integrability::Kovalevskaya(2) => Kind::Kovalevskaya,
            _ => {
                return Err(Error::Condition {
                    condition: "closed forms are for free bodies and for tops of Lagrange and Kovalevskaya about axis 3",
                    value: moments[2] / moments[0],
                });
            }
        };
        Ok(Self {
            moments,
            lever,
            kind,
        })
    }

    /// The phase with this angular velocity.
    fn phase(&self, omega: BodyVector, attitude: &Attitude) -> Phase {
        let omega: [f64; 3] = omega.components().into();
        let [x, y, z] = core::array::from_fn(|k| self.moments[k] * omega[k]);
        Phase::new(BodyVector::new(x, y, z), attitude)
    }
}

impl Follow for ClosedForm {
    fn name(&self) -> String {
        "closed form".to_owned()
    }

    fn order(&self) -> Option<u32> {
        None
    }

    fn follow(&self, start: &Phase, times: &[f64], _: Effort) -> Result<Solution<Phase>> {
        let attitude = start.attitude()?;
        let [x, y, z] = core::array::from_fn(|k| start.l[k] / self.moments[k]);
        let omega = BodyVector::new(x, y, z);
        let [i1, _, i3] = self.moments;
        let mut phases = Vec::with_capacity(times.len());
        match self.kind {
            Kind::Euler => {
                let top = EulerTop::new(self.moments, start.angular_momentum(), attitude)?;
                for &t in times {
                    let state = top.at(t)?;
                    phases.push(Phase::new(state.angular_momentum, &state.attitude));
                }
            }
            Kind::Lagrange => {
                let top = LagrangeTop::new(i1, i3, self.lever.z(), omega, attitude)?;
                for &t in times {
                    let state = top.at(t)?;
                    phases.push(self.phase(state.omega, &state.attitude));
                }
            }
            Kind::Kovalevskaya => {
                let top = KovalevskayaTop::new(self.moments, self.lever, omega, attitude)?;
                // Where power series are needed, each time continues from the one before.
                for state in top.states(times.iter().copied()) {
                    let state = state?;
                    phases.push(self.phase(state.omega, &state.attitude));
                }
            }
        }
        let cost = Cost {
            evaluations: times.len() as u64,
            steps: 0,
        };
        Ok(Solution {
            states: phases,
            cost,
        })
    }
}
