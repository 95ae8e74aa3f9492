//! The tops with a closed form: which of them a scene is, and the same top along the axes of its solution.

use nalgebra::{Quaternion, UnitQuaternion};

use super::body::{Body, Spin, Start, onto_third};
use crate::euler_equations::{Integrability, classify};
use crate::euler_top::EulerTop;
use crate::integrators::both_ways;
use crate::kovalevskaya_top::{KovalevskayaTop, State as Turned};
use crate::lagrange_top::{self, Exact, LagrangeTop};
use crate::precise::{DoubleDouble, Extended, sum_of_products};
use crate::scene::Budget;
use crate::scene::prelude::*;

/// A motion in closed form.
#[derive(Debug, Clone)]
#[allow(
    clippy::large_enum_variant,
    reason = "a scene has one of these, and asks it often"
)]
pub(crate) enum ClosedForm {
    /// No torque (6).
    Free(EulerTop),
    /// Gravity on a body that is symmetric about the line from the pivot to its centre of mass (7).
    Lagrange(LagrangeTop, Axes),
    /// Gravity on Kovalevskaya's body (8).
    Kovalevskaya(Box<KovalevskayaTop>, Axes),
}

/// The turn from the body's axes to those of the solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Axes {
    onto: UnitQuaternion<f64>,
    /// The number of places of a cyclic exchange of the axes, if the turn is only that.
    shift: Option<usize>,
}

/// The reason for a plan without a closed form.
pub(super) const NONE: &str = "gravity on a body without a fourth integral: no closed form exists";

impl ClosedForm {
    /// The closed form of a top under this gravity alone, if there is one.
    pub(super) fn find(body: &Body, gravity: f64, start: &Start) -> Result<Option<Self>> {
        let moments = body.moments;
        let lever_vector = body.arm().map(|component| component * gravity).into();
        let weights = body.exact_lever(gravity);
        let axes = match classify(moments, lever_vector) {
            Integrability::Euler => {
                let top = match start.spin {
                    Spin::Omega(omega) => EulerTop::from_omega(moments, omega, start.attitude),
                    Spin::AngularMomentum(l) => EulerTop::new(moments, l, start.attitude),
                };
                return Ok(Some(Self::Free(top?)));
            }
            // With three equal moments all axes are principal: the line to C becomes the third, by the shortest turn.
            Integrability::SphericalInertia => Axes {
                onto: onto_third(lever_vector),
                shift: None,
            },
            Integrability::Lagrange(axis) => Axes::third_from(axis),
            Integrability::Kovalevskaya(axis) => {
                let axes = Axes::third_from(axis);
                let double = |number: Extended| number.as_number::<DoubleDouble>();
                let top = KovalevskayaTop::exactly(
                    axes.exchanged(moments),
                    axes.exchanged(weights).map(double),
                    axes.exchanged(start.exact_omega(moments)).map(double),
                    axes.exact_attitude(&start.attitude).map(double),
                )?;
                return Ok(Some(Self::Kovalevskaya(Box::new(top), axes)));
            }
            Integrability::GoryachevChaplygin(_) | Integrability::None => return Ok(None),
        };
        let [transverse, _, axial] = axes.exchanged(moments);
        let top = match axes.shift {
            // Without rounding, which a motion next to its separatrix would amplify.
            Some(_) => {
                let [_, _, weight_moment] = axes.exchanged(weights);
                let exact = Exact {
                    weight_moment,
                    omega: axes.exchanged(start.exact_omega(moments)),
                    quaternion: axes.exact_attitude(&start.attitude),
                };
                LagrangeTop::exactly(transverse, axial, &exact)?
            }
            None => {
                let omega = axes.onto * start.omega(moments)?.components();
                let omega = BodyVector::from_components(omega);
                let attitude = start.attitude.quaternion() * axes.onto.inverse();
                let weight_moment = lever_vector.norm();
                LagrangeTop::new(transverse, axial, weight_moment, omega, attitude.into())?
            }
        };
        Ok(Some(Self::Lagrange(top, axes)))
    }

    /// The reason for the plan.
    pub(super) fn reason(&self) -> &'static str {
        match self {
            Self::Free(_) => "no torque: closed form",
            Self::Lagrange(..) => "gravity on a symmetric top: closed form",
            Self::Kovalevskaya(..) => "gravity on Kovalevskaya's top: separation of variables",
        }
    }

    /// Whether the solution has received the start without rounding.
    pub(super) fn is_exact(&self) -> bool {
        match self {
            Self::Free(_) => true,
            Self::Lagrange(_, axes) | Self::Kovalevskaya(_, axes) => axes.shift.is_some(),
        }
    }

    /// The rounding error at time t (s), after `angle` radians at the pace: attitude in radians, Ω relative.
    pub(super) fn rounding(&self, t: f64, angle: f64) -> f64 {
        match self {
            // The phases are carried in 106 bits; [`EulerTop::at`] states the error of the angle.
            Self::Free(_) => 4e-15 + 1e-25 * angle,
            Self::Lagrange(_, axes) if axes.shift.is_some() => 6e-14 + 1e-22 * angle,
            // Ω is rounded by the turn to the axis, and the phases with it.
            Self::Lagrange(..) => 6e-14 + 1e-15 * angle,
            Self::Kovalevskaya(top, _) => top.stated_error(t),
        }
    }

    /// The additional relative error of an Ω much slower than the pace (both rad/s), as just after a release: two roundings of the pace, or the stated error in units of the pace.
    pub(super) fn hardly_moving(&self, pace: f64, fastest: impl Fn() -> f64) -> f64 {
        let slowed = |fastest: f64| if fastest > 0.0 { pace / fastest } else { 0.0 };
        match self {
            Self::Free(_) => 0.0,
            Self::Lagrange(..) => 2.0 * f64::EPSILON * slowed(fastest()),
            Self::Kovalevskaya(top, _) => {
                top.stated_error(0.0) * (slowed(fastest()) - 1.0).max(0.0)
            }
        }
    }

    /// Attitude and Ω at each of these times (s), in their order. Kovalevskaya's solution continues each time from the one before.
    pub(super) fn at(&self, times: &[f64], budget: &Budget) -> Result<Vec<(Attitude, BodyVector)>> {
        match self {
            Self::Free(top) => {
                let fill = |times: &_, states: &mut _| top.states_at(times, states);
                batched(times, budget, top.at(0.0)?, fill, |s| (s.attitude, s.omega))
            }
            Self::Lagrange(top, axes) => {
                let fill = |times: &_, states: &mut _| top.states_at(times, states);
                let outward = |s: &lagrange_top::State| axes.outward(s.attitude, s.omega);
                batched(times, budget, top.at(0.0)?, fill, outward)
            }
            // Outward from the start: on its way back a continuation would lose more digits.
            Self::Kovalevskaya(top, axes) => both_ways(times, &mut |times| {
                let states = top.states(times.iter().copied()).zip(times);
                let outward = |s: Turned| axes.outward(s.attitude, s.omega);
                let counted = |(state, &t)| budget.spend(1, t).and(state).map(outward);
                states.map(counted).collect()
            }),
        }
    }
}

/// How many states are filled in one go: a few kilobytes, which stay in the cache.
const BATCH: usize = 32;

/// The states that `fill` gives at these times, a batch at a time, each turned outward; `any` state, to begin with.
fn batched<S: Copy>(
    times: &[f64],
    budget: &Budget,
    any: S,
    fill: impl Fn(&[f64], &mut [S]) -> Result<()>,
    outward: impl Fn(&S) -> (Attitude, BodyVector),
) -> Result<Vec<(Attitude, BodyVector)>> {
    let (mut all, mut batch) = (Vec::with_capacity(times.len()), [any; BATCH]);
    for times in times.chunks(BATCH) {
        times.iter().try_for_each(|&t| budget.spend(1, t))?;
        let states = &mut batch[..times.len()];
        fill(times, states)?;
        all.extend(states.iter().map(&outward));
    }
    Ok(all)
}

impl Axes {
    /// The body's axis of this number becomes the third, and the others follow in cyclic order.
    fn third_from(axis: usize) -> Self {
        let shift = (axis + 1) % 3;
        let half = [(1.0, 0.0), (0.5, -0.5), (0.5, 0.5)][shift];
        let onto = Quaternion::new(half.0, half.1, half.1, half.1);
        let (onto, shift) = (UnitQuaternion::new_unchecked(onto), Some(shift));
        Self { onto, shift }
    }

    fn exchanged<T: Copy>(&self, components: [T; 3]) -> [T; 3] {
        exchanged(components, self.shift.unwrap_or(0))
    }

    /// The quaternion of the solution's axes: that of the attitude times the inverse of the turn onto them, whose components are halves, so to 106 bits.
    fn exact_attitude(&self, attitude: &Attitude) -> [Extended; 4] {
        let (q, onto) = (attitude.quaternion(), self.onto);
        let sum = |products: [[f64; 2]; 4]| sum_of_products(&products);
        let (a, b, c, d) = (q.w, q.i, q.j, q.k);
        let (w, x, y, z) = (onto.w, -onto.i, -onto.j, -onto.k);
        [
            sum([[a, w], [-b, x], [-c, y], [-d, z]]),
            sum([[a, x], [b, w], [c, z], [-d, y]]),
            sum([[a, y], [-b, z], [c, w], [d, x]]),
            sum([[a, z], [b, y], [-c, x], [d, w]]),
        ]
    }

    /// Attitude and Ω along the body's axes, from those along the axes of the solution.
    fn outward(&self, attitude: Attitude, omega: BodyVector) -> (Attitude, BodyVector) {
        let omega = match self.shift {
            Some(shift) => exchanged::<f64>(omega.into(), 3 - shift).into(),
            None => BodyVector::from_components(self.onto.inverse() * omega.components()),
        };
        ((attitude.quaternion() * self.onto).into(), omega)
    }
}

/// The components, exchanged cyclically by this number of places.
fn exchanged<T: Copy>(components: [T; 3], places: usize) -> [T; 3] {
    core::array::from_fn(|k| components[(k + places) % 3])
}
