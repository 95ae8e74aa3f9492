//! The equations of a body in contact with a level table: those of Newton and Euler, with the reaction in closed form.

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

use super::body::{ConvexBody, Start, inverse};
use super::friction::{Friction, Resistance};
use crate::frame::Attitude;

/// Number of numbers in a state: quaternion 4, Ω 3 (body), level velocity of C 2, level position of C 2, work done against friction 1.
///
/// Height and vertical velocity of C are not among them: both follow from the contact, so no step can violate it.
pub(crate) const NUMBERS: usize = 12;
/// A state as numbers.
pub(crate) type Numbers = [f64; NUMBERS];

/// A body and the forces at its contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Table {
    pub(crate) body: ConvexBody,
    pub(crate) gravity: f64,
    pub(crate) friction: Option<Friction>,
    pub(crate) resistance: Option<Resistance>,
}

impl Table {
    /// A body under gravity (m/s²), without friction and resistance.
    pub(crate) const fn new(body: ConvexBody, gravity: f64) -> Self {
        Self {
            body,
            gravity,
            friction: None,
            resistance: None,
        }
    }
}

/// The contact at a state, in body axes.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Contact {
    /// Velocity of the point in contact.
    pub(crate) slip: Vector3<f64>,
    /// Normal reaction, N.
    pub(crate) reaction: f64,
    /// Upward acceleration of the point in contact for every newton of reaction, over that without friction and couple. Where it is negative, friction presses the
    /// body into the table by more than the reaction lifts it (Painlevé 1895).
    pub(crate) lift: f64,
    /// The level force of the table divided by the normal one.
    pub(crate) traction: Vector3<f64>,
    /// Ω̇, rad/s².
    pub(crate) omega_rate: Vector3<f64>,
    /// Power of friction and couple, divided by the normal force; not positive.
    pub(crate) power: f64,
}

impl Contact {
    /// The contact of a body in the air: no force.
    pub(crate) fn none(body: &ConvexBody, omega: &Vector3<f64>) -> Self {
        Self {
            omega_rate: body.inverse * -omega.cross(&(body.inertia.matrix() * omega)),
            ..Self::default()
        }
    }
}

/// A state, unpacked into the body's axes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pose {
    pub(crate) turn: UnitQuaternion<f64>,
    pub(crate) up: Vector3<f64>,
    pub(crate) omega: Vector3<f64>,
    /// Level velocity of C, body axes.
    pub(crate) level: Vector3<f64>,
}

impl Pose {
    /// A pose given in the body's axes; the turn about the vertical, which makes no difference to the contact, is left open.
    pub(crate) fn seen(up: Vector3<f64>, omega: Vector3<f64>, level: Vector3<f64>) -> Self {
        Self {
            turn: UnitQuaternion::identity(),
            up,
            omega,
            level,
        }
    }

    pub(crate) fn of(y: &Numbers) -> Self {
        let turn = UnitQuaternion::from_quaternion(Quaternion::new(y[0], y[1], y[2], y[3]));
        let rotation: Matrix3<f64> = turn.to_rotation_matrix().into_inner();
        Self {
            turn,
            up: rotation.row(2).transpose(),
            omega: Vector3::new(y[4], y[5], y[6]),
            level: rotation.tr_mul(&Vector3::new(y[7], y[8], 0.0)),
        }
    }

    /// The attitude.
    pub(crate) fn attitude(&self) -> Attitude {
        self.turn.into()
    }
}

/// The numbers at a start, with no work done yet.
pub(crate) fn numbers(start: &Start) -> Numbers {
    let q = start.attitude.quaternion();
    let [p, r, s] = start.omega.components().into();
    let v = start.velocity;
    [q.w, q.i, q.j, q.k, p, r, s, v.x(), v.y(), 0.0, 0.0, 0.0]
}

/// The point in contact: its arm from C, its velocity, and the terms of its acceleration without any force.
struct Touch<'a> {
    table: &'a Table,
    pose: &'a Pose,
    arm: Vector3<f64>,
    slip: Vector3<f64>,
    /// Ω∧ρ̇, ρ̇ in space.
    whirl: Vector3<f64>,
    /// −Ω̇ of a free body.
    free: Vector3<f64>,
    couple: Option<Vector3<f64>>,
}

impl Touch<'_> {
    /// The contact under this level force per normal force, `None` without friction, and this reaction N, if it is known.
    ///
    /// Otherwise N is linear in the accelerations it causes, since friction and couple are N times functions of the velocities:
    /// the vertical acceleration of the point in contact is zero, one linear equation for N.
    #[inline]
    fn pushed(&self, traction: Option<Vector3<f64>>, reaction: Option<f64>) -> Contact {
        let Table { body, gravity, .. } = self.table;
        let Pose { up, omega, .. } = self.pose;
        let mut push = *up;
        let mut power = 0.0;
        if let Some(traction) = &traction {
            push += traction;
            power += traction.dot(&self.slip);
        }
        let mut torque = self.arm.cross(&push);
        if let Some(couple) = &self.couple {
            torque += couple;
            power += couple.dot(omega);
        }
        let lever = self.arm.cross(up);
        let pushed = body.inverse * torque;
        let lifted = 1.0 / body.mass + lever.dot(&pushed);
        let reaction = reaction
            .unwrap_or_else(|| (gravity + lever.dot(&self.free) - up.dot(&self.whirl)) / lifted);
        Contact {
            slip: self.slip,
            reaction,
            lift: lifted / (1.0 / body.mass + lever.dot(&(body.inverse * lever))),
            traction: traction.unwrap_or_else(Vector3::zeros),
            omega_rate: pushed * reaction - self.free,
            power,
        }
    }

    /// The response of the point in contact to a force.
    fn yielding(&self) -> Yielding {
        let (body, up) = (&self.table.body, self.pose.up);
        let mut matrix = body.yielding(&self.arm);
        if let Some(couple) = &self.couple {
            matrix += (body.inverse * couple).cross(&self.arm) * up.transpose();
        }
        Yielding {
            matrix,
            free: self.whirl - self.free.cross(&self.arm) - up * self.table.gravity,
            up,
        }
    }
}

impl Table {
    #[inline]
    fn touch<'a>(&'a self, pose: &'a Pose) -> Touch<'a> {
        let (body, up, omega) = (&self.body, &pose.up, &pose.omega);
        let (support, rate) = body.surface.support_and_rate(up, &up.cross(omega));
        let arm = body.center - support;
        let swing = omega.cross(&arm);
        Touch {
            table: self,
            pose,
            arm,
            // C moves up or down as the contact requires, which cancels the vertical part of the swing.
            slip: pose.level + swing - up * up.dot(&swing),
            whirl: omega.cross(&(swing - rate)),
            free: body.inverse * omega.cross(&(body.inertia.matrix() * omega)),
            couple: self.resistance.map(|law| law.couple(omega, up)),
        }
    }

    /// The contact of a sliding body: accelerations, reaction and slip.
    #[inline]
    pub(crate) fn slides(&self, pose: &Pose) -> Contact {
        let touch = self.touch(pose);
        touch.pushed(self.friction.map(|law| law.traction(&touch.slip)), None)
    }

    /// The contact in pure rolling: V = −Ω∧ρ at all times, and the force that this takes.
    pub(crate) fn rolls(&self, pose: &Pose) -> Contact {
        let mut touch = self.touch(pose);
        touch.slip = Vector3::zeros();
        let push = touch.yielding().holding();
        let reaction = pose.up.dot(&push);
        touch.pushed(Some(push / reaction - pose.up), Some(reaction))
    }

    /// The contact of a body that begins to slide out of rolling by Coulomb's law, with coefficient `mu` while it slides.
    ///
    /// While the slip s is very small, friction turns it into a definite direction within a time of s/μg, much less than any other time of the motion, which
    /// explicit steps cannot follow. To first order in s the direction e is the one that the slip keeps while e itself turns,
    /// ẇ⊥(e) = s φ̇, where ẇ is the acceleration of the point in contact and φ̇ the rate at which the direction for s = 0 turns.
    pub(crate) fn leaving(&self, pose: &Pose, mu: f64) -> Contact {
        let Pose { up, omega, .. } = pose;
        let touch = self.touch(pose);
        let yielding = touch.yielding();
        let along = yielding.gives_way(mu);
        let [tilting, turning, drift] = self.drift(pose, &touch.pushed(Some(along * -mu), None));
        // The direction a short time later.
        let size = self.body.surface.size;
        let moment = MOMENT / (omega.norm() + self.body.speed_scale(self.gravity) / size);
        let (spin, level) = (omega + turning * moment, pose.level + drift * moment);
        let later = Pose::seen((up + tilting * moment).normalize(), spin, level);
        let along_later = self.touch(&later).yielding().gives_way(mu);
        let turned = (along_later - along) / moment + omega.cross(&along);
        let turning = turned.dot(&up.cross(&along));
        let slip = touch.slip.dot(&along);
        let along = yielding.direction(mu, &along, slip * turning);
        touch.pushed(Some(along * -mu), None)
    }

    /// The rates of the vertical, of Ω and of the level velocity of C with this contact, as seen from the body.
    pub(super) fn drift(&self, pose: &Pose, contact: &Contact) -> [Vector3<f64>; 3] {
        let push = contact.traction * (contact.reaction / self.body.mass);
        let drift = push - pose.omega.cross(&pose.level);
        [pose.up.cross(&pose.omega), contact.omega_rate, drift]
    }

    /// The rates of a state with this contact.
    pub(crate) fn rates(&self, y: &Numbers, pose: &Pose, contact: &Contact) -> Numbers {
        let q = Quaternion::new(y[0], y[1], y[2], y[3]) * Quaternion::from_imag(pose.omega) * 0.5;
        let push = pose.turn * contact.traction * (contact.reaction / self.body.mass);
        let r = contact.omega_rate;
        let power = -contact.reaction * contact.power;
        [
            q.w, q.i, q.j, q.k, r.x, r.y, r.z, push.x, push.y, y[7], y[8], power,
        ]
    }
}

/// A short time, in the natural unit of the motion.
const MOMENT: f64 = 1e-5;

/// The response of the point in contact to a force: its acceleration under the force p is `matrix` p + `free`. In an impact the same holds for
/// impulses and velocities.
pub(crate) struct Yielding {
    pub(crate) matrix: Matrix3<f64>,
    pub(crate) free: Vector3<f64>,
    pub(crate) up: Vector3<f64>,
}

impl Yielding {
    /// The force that holds the point at rest.
    pub(crate) fn holding(&self) -> Vector3<f64> {
        // The matrix is positive definite except for the couple; a result that is not finite makes the step fail.
        let inverse = inverse(&self.matrix);
        inverse.map_or_else(|| Vector3::repeat(f64::NAN), |inverse| inverse * -self.free)
    }

    /// The direction in which a point at rest begins to slip if friction `mu` cannot hold it.
    pub(crate) fn gives_way(&self, mu: f64) -> Vector3<f64> {
        let push = self.holding();
        let level = push - self.up * self.up.dot(&push);
        self.direction(mu, &(level / -level.norm()), 0.0)
    }

    /// The direction e near `guess` for which, under friction −μe, the acceleration of the point perpendicular to e is `across`.
    fn direction(&self, mu: f64, guess: &Vector3<f64>, across: f64) -> Vector3<f64> {
        let mut along = *guess;
        for _ in 0..NEWTON {
            let side = self.up.cross(&along);
            let pushed = self.matrix * (self.up - along * mu);
            let pushed_aside = self.matrix * side * -mu;
            let gain = self.up.dot(&pushed);
            let reaction = -self.up.dot(&self.free) / gain;
            let acceleration = self.free + pushed * reaction;
            let change = (pushed_aside - pushed * (self.up.dot(&pushed_aside) / gain)) * reaction;
            let slope = change.dot(&side) - acceleration.dot(&along);
            let angle = (across - acceleration.dot(&side)) / slope;
            along = (along + side * angle.clamp(-0.5, 0.5)).normalize();
            if angle.abs() <= 4.0 * f64::EPSILON {
                break;
            }
        }
        along
    }
}

/// Most rounds of Newton's method; at most four have been observed.
const NEWTON: usize = 20;

impl ConvexBody {
    /// The inverse effective mass of the point at this arm from C.
    pub(crate) fn yielding(&self, arm: &Vector3<f64>) -> Matrix3<f64> {
        let cross = arm.cross_matrix();
        Matrix3::identity() / self.mass - cross * self.inverse * cross
    }

    /// The state with the velocity of C replaced by that of pure rolling.
    pub(crate) fn rolled(&self, y: &Numbers) -> Numbers {
        self.rolling(y, &Pose::of(y))
    }

    /// The same, where the pose is known; its own level velocity makes no difference.
    pub(crate) fn rolling(&self, y: &Numbers, pose: &Pose) -> Numbers {
        let velocity = pose.turn * -pose.omega.cross(&self.arm(&pose.up));
        let mut y = *y;
        (y[7], y[8]) = (velocity.x, velocity.y);
        y
    }

    /// Height of C above the table and its vertical velocity, in contact.
    pub(crate) fn height(&self, pose: &Pose) -> (f64, f64) {
        let arm = self.arm(&pose.up);
        (-pose.up.dot(&arm), -pose.up.dot(&pose.omega.cross(&arm)))
    }
}
