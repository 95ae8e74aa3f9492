//! Off the table and back: a free body in closed form, and the blow with which it lands.

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

use super::body::ConvexBody;
use super::equations::{Numbers, Pose, Table, Yielding};
use super::friction::Friction;
use crate::error::{Error, Result};
use crate::euler_top::EulerTop;
use crate::frame::{Attitude, BodyVector};
use crate::integrators::{Effort, Kept, Leg, Stop, System, order_eight};

/// A free body with its centre of mass on a parabola.
#[derive(Debug, Clone)]
pub(crate) struct Flight {
    body: ConvexBody,
    /// In principal axes; `None` where the body is at rest, which an Euler top cannot be.
    top: Option<EulerTop>,
    principal: UnitQuaternion<f64>,
    start: Numbers,
    takeoff: TakeOff,
    gravity: f64,
}

/// What a body in the air has from its start, beside its numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TakeOff {
    /// When, s.
    pub(crate) time: f64,
    /// Height of C, m.
    pub(crate) height: f64,
    /// Its vertical velocity, m/s.
    pub(crate) climb: f64,
}

impl TakeOff {
    /// Height and vertical velocity of C at a time.
    pub(crate) fn at(&self, time: f64, gravity: f64) -> (f64, f64) {
        let t = time - self.time;
        let height = self.height + t * (self.climb - 0.5 * gravity * t);
        (height, self.climb - gravity * t)
    }
}

/// Samples of the gap in the search for a landing; seconds of computing.
const MOST_SAMPLES: u32 = 10_000_000;

impl Flight {
    /// From a state that leaves the table.
    pub(crate) fn from(
        body: &ConvexBody,
        gravity: f64,
        start: &Numbers,
        takeoff: TakeOff,
    ) -> Result<Self> {
        let pose = Pose::of(start);
        let axes = body.principal();
        let principal =
            UnitQuaternion::from_matrix_eps(&axes.axes, 1e-15, 100, UnitQuaternion::identity());
        let l = axes.axes.tr_mul(&(body.inertia * pose.omega));
        let top = if l.amax() == 0.0 {
            None
        } else {
            let attitude = (pose.turn * principal).into_inner();
            Some(EulerTop::new(
                axes.moments,
                BodyVector::from_components(l),
                Attitude::from_unit(attitude),
            )?)
        };
        Ok(Self {
            body: *body,
            top,
            principal,
            start: *start,
            takeoff,
            gravity,
        })
    }

    /// The numbers at a time.
    pub(crate) fn at(&self, time: f64) -> Result<Numbers> {
        let t = time - self.takeoff.time;
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
        Ok(y)
    }

    /// Height of the lowest point.
    fn gap(&self, time: f64) -> Result<f64> {
        let pose = Pose::of(&self.at(time)?);
        let (height, _) = self.takeoff.at(time, self.gravity);
        Ok(height + pose.up.dot(&self.body.arm(&pose.up)))
    }

    /// When the body is back on the table, if that is before the time `until`: to rounding of the time.
    ///
    /// No point of the body moves faster than C and its rotation allow, so nothing can touch before the gap is closed at that speed. Below a
    /// thousandth of a turn a touch that leaves the gap open again is missed.
    ///
    /// # Errors
    /// [`Error::Integration`] for a body that turns a hundred thousand times before it lands.
    pub(crate) fn landing(&self, until: f64) -> Result<Option<f64>> {
        let turning = Pose::of(&self.start).omega.norm() * self.body.slenderness();
        let reach = self.body.reach();
        let natural = (self.gravity / reach).sqrt();
        let stride = 0.1 / (turning + natural);
        let start = self.takeoff.time;
        let (mut before, mut after) = (start, (start + stride).min(until));
        for _ in 0..MOST_SAMPLES {
            let gap = self.gap(after)?;
            if gap <= 0.0 {
                return self.located(before, after).map(Some);
            }
            if after >= until {
                return Ok(None);
            }
            before = after;
            let (height, climb) = self.takeoff.at(before, self.gravity);
            let squared = |drop: f64| 2.0 * self.gravity * drop.max(0.0) + climb * climb;
            // Not before the parabola has brought C down to where a point could touch.
            let aloft = if height > reach {
                (climb + squared(height - reach).sqrt()) / self.gravity
            } else {
                0.0
            };
            let nearing = gap / (squared(height).sqrt() + turning * reach);
            after = (before + nearing.max(aloft).max(0.01 * stride)).min(until);
        }
        Err(Error::Integration {
            reason: "the body turns too often before it lands; end the run earlier",
            time: before,
        })
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

impl ConvexBody {
    /// No point of the surface is further from C, m.
    fn reach(&self) -> f64 {
        self.center.norm() + self.surface.greatest()
    }

    /// No angular velocity of the free body exceeds the one at the start by more than this factor: energy is conserved.
    fn slenderness(&self) -> f64 {
        let moments = self.principal().moments;
        (moments[2] / moments[0]).sqrt()
    }
}

impl Table {
    /// The state after the inelastic blow of a landing with this vertical velocity of C: the normal velocity of the point in contact is
    /// lost, the level one as far as friction goes.
    ///
    /// During the blow the level force is N f(v) as at any time, with v changing as the impulse p grows (Routh 1905): dv/dp = K (n + f(v)) until
    /// v·n = 0, where K is the inverse effective mass of the point in contact. So a blow only takes energy.
    ///
    /// # Errors
    /// [`Error::Condition`] where friction presses the body into the table harder than it comes (Painlevé's paradox).
    pub(crate) fn landed(&self, y: &Numbers, climb: f64) -> Result<Numbers> {
        let body = &self.body;
        let pose = Pose::of(y);
        let velocity = pose.level + pose.up * climb;
        let arm = body.arm(&pose.up);
        let contact = velocity + pose.omega.cross(&arm);
        let matrix = body.yielding(&arm);
        let after = self.blow(&pose.up, &contact, matrix)?;
        let inverse = matrix.try_inverse().unwrap_or_else(Matrix3::zeros);
        Ok(body.struck(y, &pose, &velocity, &arm, &(inverse * (after - contact))))
    }

    /// The state with all velocity of the point in contact taken away by a blow.
    pub(crate) fn held(&self, y: &Numbers) -> Numbers {
        let body = &self.body;
        let pose = Pose::of(y);
        let arm = body.arm(&pose.up);
        let (_, climb) = body.height(&pose);
        let velocity = pose.level + pose.up * climb;
        let contact = velocity + pose.omega.cross(&arm);
        let inverse = body.yielding(&arm).try_inverse();
        let impulse = inverse.map_or_else(Vector3::zeros, |inverse| inverse * -contact);
        body.struck(y, &pose, &velocity, &arm, &impulse)
    }

    /// The velocity of the point in contact after a blow.
    fn blow(
        &self,
        up: &Vector3<f64>,
        contact: &Vector3<f64>,
        matrix: Matrix3<f64>,
    ) -> Result<Vector3<f64>> {
        let fall = -up.dot(contact);
        if fall <= 0.0 {
            return Ok(contact - up * up.dot(contact));
        }
        let yielding = Yielding {
            matrix,
            free: -up,
            up: *up,
        };
        let slip = contact + up * fall;
        // The impulse per velocity of approach lost, at least as long as the blow is not over: friction must not take all of it.
        let painleve = |push: &Vector3<f64>| {
            let gain = up.dot(&(matrix * push));
            if gain > 0.0 {
                Ok(gain)
            } else {
                Err(Error::Condition {
                    condition: "friction at a landing must not press the body into the table faster than it falls",
                    value: fall,
                })
            }
        };
        match self.friction {
            None => {
                let rate = matrix * up / painleve(up)?;
                Ok(slip + (rate - up) * fall)
            }
            Some(Friction::NoSlip) => Ok(Vector3::zeros()),
            Some(Friction::Coulomb(law)) => {
                let push = yielding.holding();
                let normal = up.dot(&push);
                let holds = |grip: f64| (push - up * normal).norm() <= grip * normal;
                if slip.norm() > 0.0 {
                    painleve(&(up + self.traction(&slip)))?;
                }
                let (slip, left) = self.slowed(&yielding, &slip, fall)?;
                if left <= 0.0 {
                    return Ok(slip);
                }
                if holds(law.grip()) {
                    return Ok(Vector3::zeros());
                }
                let along = yielding.gives_way(law.kinetic());
                let push = up - along * law.kinetic();
                let rate = matrix * push / painleve(&push)?;
                Ok(along * (rate.dot(&along) * left))
            }
            Some(law) => {
                painleve(&(up + law.traction(&slip)))?;
                let rate = |_: f64, v: &[f64; 3]| {
                    let slip = Vector3::from(*v);
                    let pushed = matrix * (up + law.traction(&slip));
                    (pushed / up.dot(&pushed) - up).into()
                };
                let scales = [contact.norm(); 3];
                let run = order_eight(
                    &rate,
                    Kept::Nothing,
                    &slip.into(),
                    &scales,
                    &[fall],
                    Effort::Tolerance(IN_A_BLOW),
                )?;
                Ok(Vector3::from(run.states[0]))
            }
        }
    }

    /// The level slip under Coulomb's law at the end of a blow, or where it comes to nothing, and what velocity of approach is left then.
    ///
    /// Counted is not the velocity u lost but ∫du/|v|: the direction of a slip that goes to nothing then turns at a finite rate.
    fn slowed(
        &self,
        yielding: &Yielding,
        slip: &Vector3<f64>,
        fall: f64,
    ) -> Result<(Vector3<f64>, f64)> {
        let size = slip.norm();
        if size <= NO_SLIP * fall {
            return Ok((Vector3::zeros(), fall));
        }
        let up = yielding.up;
        let rate = |_: f64, y: &[f64; 4]| {
            let slip = Vector3::new(y[0], y[1], y[2]);
            let size = slip.norm();
            let pushed = yielding.matrix * (up + self.traction(&slip));
            let change = (pushed / up.dot(&pushed) - up) * size;
            [change.x, change.y, change.z, size]
        };
        let margin = |_: f64, y: &[f64; 4]| {
            let slip = Vector3::new(y[0], y[1], y[2]).norm() / size;
            (1.0 - y[3] / fall).min(slip - NO_SLIP)
        };
        let leg = Leg {
            system: &rate as &dyn System<4>,
            kept: Kept::Nothing,
            start: (0.0, &[slip.x, slip.y, slip.z, 0.0]),
            scales: &[NO_SLIP * size, NO_SLIP * size, NO_SLIP * size, fall],
            times: &[],
            end: f64::MAX.sqrt(),
        };
        let passage = leg.follow(Some(&margin), Effort::Tolerance(IN_A_BLOW))?;
        let [x, y, z, lost] = passage.end;
        let slip = Vector3::new(x, y, z);
        let over = slip.norm() > 2.0 * NO_SLIP * size || passage.stopped == Stop::AtTheEnd;
        Ok((slip, if over { 0.0 } else { fall - lost }))
    }

    fn traction(&self, slip: &Vector3<f64>) -> Vector3<f64> {
        self.friction
            .map_or_else(Vector3::zeros, |law| law.traction(slip))
    }
}

/// Error of a step within a blow.
const IN_A_BLOW: f64 = 1e-13;
/// What slips less than this part of the velocity at the beginning of a blow has come to rest.
const NO_SLIP: f64 = 1e-15;

impl ConvexBody {
    /// The state after this impulse at the contact.
    fn struck(
        &self,
        y: &Numbers,
        pose: &Pose,
        velocity: &Vector3<f64>,
        arm: &Vector3<f64>,
        impulse: &Vector3<f64>,
    ) -> Numbers {
        let omega = pose.omega + self.inverse * arm.cross(impulse);
        let after = velocity + impulse / self.mass;
        let level = pose.turn * after;
        let lost = self.kinetic_energy(&pose.omega, velocity) - self.kinetic_energy(&omega, &after);
        let mut y = *y;
        (y[4], y[5], y[6]) = (omega.x, omega.y, omega.z);
        (y[7], y[8]) = (level.x, level.y);
        y[11] += lost;
        y
    }
}
