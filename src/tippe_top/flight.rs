//! Off the table and back: a free body in closed form, and the blow with which it lands.

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

use super::body::ConvexBody;
use super::equations::{Ground, Numbers, Pose};
use super::friction::Holding;
use crate::error::{Error, Result};
use crate::euler_top::EulerTop;
use crate::frame::{Attitude, BodyVector};
use crate::integrators::{Cost, Effort, Method, System, solve};

/// A free body with its centre of mass on a parabola.
#[derive(Debug, Clone)]
pub(crate) struct Flight {
    body: ConvexBody,
    /// In principal axes; `None` where the body is at rest, which an Euler top cannot be.
    top: Option<EulerTop>,
    principal: UnitQuaternion<f64>,
    start: Numbers,
    height: f64,
    climb: f64,
    gravity: f64,
}

/// A place on a flight.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Airborne {
    pub(crate) pose: Pose,
    pub(crate) numbers: Numbers,
    pub(crate) height: f64,
    pub(crate) climb: f64,
}

impl Flight {
    /// From a state of contact, C at `height` and climbing at `climb`.
    pub(crate) fn from(
        body: &ConvexBody,
        gravity: f64,
        start: &Numbers,
        height: f64,
        climb: f64,
    ) -> Result<Self> {
        let pose = Pose::of(start);
        let axes = body.principal();
        let principal =
            UnitQuaternion::from_matrix_eps(&axes.axes(), 1e-15, 100, UnitQuaternion::identity());
        let l = axes.axes().tr_mul(&(body.inertia * pose.omega));
        let top = if l.amax() == 0.0 {
            None
        } else {
            let attitude = Attitude::from_unit((pose.turn * principal).into_inner());
            Some(EulerTop::new(
                axes.moments(),
                BodyVector::from_components(l),
                attitude,
            )?)
        };
        Ok(Self {
            body: *body,
            top,
            principal,
            start: *start,
            height,
            climb,
            gravity,
        })
    }

    /// `t` seconds after the start of the flight.
    pub(crate) fn at(&self, t: f64) -> Result<Airborne> {
        let mut y = self.start;
        if let Some(top) = &self.top {
            let state = top.at(t)?;
            let q: Quaternion<f64> =
                (state.attitude.quaternion() * self.principal.inverse()).into_inner();
            let omega = self.principal * state.omega.components();
            (y[0], y[1], y[2], y[3]) = (q.w, q.i, q.j, q.k);
            (y[4], y[5], y[6]) = (omega.x, omega.y, omega.z);
        }
        y[9] += y[7] * t;
        y[10] += y[8] * t;
        Ok(Airborne {
            pose: Pose::of(&y),
            numbers: y,
            height: self.height + t * (self.climb - 0.5 * self.gravity * t),
            climb: self.climb - self.gravity * t,
        })
    }

    /// Height of the lowest point.
    fn gap(&self, t: f64) -> Result<f64> {
        let place = self.at(t)?;
        Ok(place.height + place.pose.up.dot(&self.body.arm(&place.pose.up)))
    }

    /// When the body is back on the table, if that is within `longest` seconds: to rounding of the time.
    ///
    /// The gap is sampled 60 times a turn; a touch between two samples that leaves the gap open on both sides is missed.
    /// `looked` hears of every sample; its error ends the search.
    pub(crate) fn landing(
        &self,
        longest: f64,
        looked: &dyn Fn(f64) -> Result<()>,
    ) -> Result<Option<f64>> {
        let pose = Pose::of(&self.start);
        let rate = pose.omega.norm() + (self.gravity / self.body.surface.size()).sqrt();
        let stride = 0.1 / rate;
        let mut before = 0.0;
        loop {
            let after = (before + stride).min(longest);
            looked(after)?;
            if self.gap(after)? <= 0.0 {
                return self.located(before, after).map(Some);
            }
            if after >= longest {
                return Ok(None);
            }
            before = after;
        }
    }

    /// Bisection: 50 halvings of a stride are below a unit in the last place of any time that matters.
    fn located(&self, mut open: f64, mut closed: f64) -> Result<f64> {
        for _ in 0..50 {
            let middle = 0.5 * (open + closed);
            if self.gap(middle)? > 0.0 {
                open = middle;
            } else {
                closed = middle;
            }
        }
        Ok(closed)
    }
}

impl dyn Ground + '_ {
    /// The inelastic blow of a landing: the normal velocity of the point in contact is lost, the level one as far as friction goes.
    ///
    /// During the blow the level force is N f(v) as at any time, with v changing as the impulse p grows (Routh 1905):
    /// dv/dp = A (n + f(v)) until v·n = 0, where A is the inverse effective mass of the point in contact. So a blow only takes energy.
    ///
    /// # Errors
    /// [`Error::Condition`] where friction presses the body into the table harder than it comes (Painlevé's paradox).
    pub(crate) fn land(&self, place: &Airborne, hold: Holding) -> Result<(Numbers, Cost)> {
        let body = self.body();
        let Pose {
            turn,
            up,
            omega,
            level,
        } = place.pose;
        let velocity = level + up * place.climb;
        let arm = body.arm(&up);
        let before = body.kinetic_energy(&omega, &velocity);
        let contact = velocity + omega.cross(&arm);
        let cross = arm.cross_matrix();
        let yielding: Matrix3<f64> = Matrix3::identity() / body.mass - cross * body.inverse * cross;
        let gripping = yielding
            .try_inverse()
            .map(|resistance| resistance * -contact)
            .unwrap_or_else(Vector3::zeros);
        let normal = up.dot(&gripping);
        let sideways = (gripping - up * normal).norm();
        let held = match hold {
            Holding::Grips => true,
            Holding::Cone { mu } => sideways <= mu * normal,
            Holding::Slides => false,
        };
        let (impulse, cost) = if held {
            (gripping, Cost::default())
        } else {
            self.blow(&up, &contact, &yielding)?
        };
        let after_omega = omega + body.inverse * arm.cross(&impulse);
        let after = velocity + impulse / body.mass;
        let mut y = place.numbers;
        (y[4], y[5], y[6]) = (after_omega.x, after_omega.y, after_omega.z);
        let level = turn * after;
        (y[7], y[8]) = (level.x, level.y);
        y[11] += before - body.kinetic_energy(&after_omega, &after);
        Ok((y, cost))
    }

    /// The impulse of a blow under the friction law, with the lost normal velocity as the clock.
    fn blow(
        &self,
        up: &Vector3<f64>,
        contact: &Vector3<f64>,
        yielding: &Matrix3<f64>,
    ) -> Result<(Vector3<f64>, Cost)> {
        let fall = -up.dot(contact);
        let size = contact.norm();
        if fall <= 0.0 {
            return Ok((Vector3::zeros(), Cost::default()));
        }
        // Coulomb's sign function bends over a millionth of the blow's speed: what slips less is at rest for the length of a blow.
        let bend = 1e-6 * size;
        let rate = |_: f64, p: &[f64; 3]| {
            let moving = contact + yielding * Vector3::from(*p);
            let slip = moving - up * up.dot(&moving);
            let mut push = *up;
            let soft = if self.sharpness() == 0.0 {
                let length = slip.norm();
                length / length.hypot(bend)
            } else {
                1.0
            };
            push += self.traction(&slip) * soft;
            let gain = up.dot(&(yielding * push));
            (push / gain).into()
        };
        let start: [f64; 3] = rate(0.0, &[0.0; 3]);
        if Vector3::from(start).dot(up) <= 0.0 {
            return Err(Error::Condition {
                condition: "friction at a landing must not press the body into the table faster than it falls",
                value: fall,
            });
        }
        let scale = self.body().mass * size;
        let rate: &dyn System<3> = &rate;
        let run = solve(
            rate,
            0.0,
            &[0.0; 3],
            &[scale; 3],
            &[fall],
            Method::Dop853,
            Effort::Tolerance(1e-13),
        )?;
        Ok((Vector3::from(run.states[0]), run.cost))
    }
}
