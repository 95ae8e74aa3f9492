//! The equations of a body in contact with a level table: Newton, Euler, and the reaction in closed form.

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

use super::body::{ConvexBody, Start};
use super::friction::{Couple, Holding, Traction};
use crate::frame::Attitude;

/// Numbers of a state: quaternion 4, Ω 3 (body), level velocity of C 2, level position of C 2, work done against friction 1.
///
/// Height and vertical velocity of C are not among them: the contact decides both, so no step can violate it.
pub(crate) const NUMBERS: usize = 12;
/// A state as numbers.
pub(crate) type Numbers = [f64; NUMBERS];

/// A body and the laws at its contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Table<F, R> {
    pub(crate) body: ConvexBody,
    pub(crate) gravity: f64,
    pub(crate) friction: F,
    pub(crate) resistance: R,
}

/// What is known of the contact at a state, in body axes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Contact {
    /// Velocity of the point in contact.
    pub(crate) slip: Vector3<f64>,
    /// Normal reaction, N.
    pub(crate) reaction: f64,
    /// The level force of the table over the normal one.
    pub(crate) traction: Vector3<f64>,
    pub(crate) omega_rate: Vector3<f64>,
    /// Power of friction and couple, over the normal force; not positive.
    pub(crate) power: f64,
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
}

/// The state at a start, in units in which nothing has been done yet.
pub(crate) fn numbers(start: &Start) -> Numbers {
    let q = start.attitude.quaternion();
    let (omega, v) = (start.omega, start.velocity);
    [
        q.w,
        q.i,
        q.j,
        q.k,
        omega.x(),
        omega.y(),
        omega.z(),
        v.x(),
        v.y(),
        0.0,
        0.0,
        0.0,
    ]
}

impl<F: Traction, R: Couple> Table<F, R> {
    /// Sliding: accelerations, reaction and slip.
    ///
    /// The reaction N is linear in the accelerations it causes, since friction and couple are N times functions of the velocities:
    /// the vertical acceleration of the point in contact is zero, one linear equation for N.
    pub(crate) fn sliding(
        &self,
        up: &Vector3<f64>,
        omega: &Vector3<f64>,
        level: &Vector3<f64>,
    ) -> Contact {
        let body = &self.body;
        let (support, rate) = body.surface.support_and_rate(up, &up.cross(omega));
        let arm = body.center - support;
        let swing = omega.cross(&arm);
        // C moves up or down as the contact asks, which cancels the vertical part of the swing.
        let slip = level + swing - up * up.dot(&swing);
        let mut push = *up;
        let mut power = 0.0;
        let mut traction = Vector3::zeros();
        if F::ACTS {
            traction = self.friction.traction(&slip);
            push += traction;
            power += traction.dot(&slip);
        }
        let mut torque = arm.cross(&push);
        if R::ACTS {
            let couple = self.resistance.couple(omega, up);
            torque += couple;
            power += couple.dot(omega);
        }
        let lever = arm.cross(up);
        let free = body.inverse * omega.cross(&(body.inertia * omega));
        let pushed = body.inverse * torque;
        let whirl = omega.cross(&(swing - rate));
        let reaction = (self.gravity + lever.dot(&free) - up.dot(&whirl))
            / (1.0 / body.mass + lever.dot(&pushed));
        Contact {
            slip,
            reaction,
            traction,
            omega_rate: pushed * reaction - free,
            power,
        }
    }

    /// Pure rolling: V = −Ω∧ρ at all times, and the force that this takes.
    pub(crate) fn rolling(&self, up: &Vector3<f64>, omega: &Vector3<f64>) -> Contact {
        let body = &self.body;
        let mass = body.mass;
        let (support, rate) = body.surface.support_and_rate(up, &up.cross(omega));
        let arm = body.center - support;
        let swing = omega.cross(&arm);
        let whirl = omega.cross(&(swing - rate));
        let about_contact = body.inertia
            + (Matrix3::identity() * arm.norm_squared() - arm * arm.transpose()) * mass;
        // Positive definite; what is not finite makes the step fail.
        let inverse = about_contact
            .try_inverse()
            .unwrap_or_else(|| Matrix3::repeat(f64::NAN));
        let pull = arm.cross(&(up * self.gravity - whirl)) * mass;
        let mut omega_rate = inverse * (pull - omega.cross(&(body.inertia * omega)));
        let force =
            |omega_rate: &Vector3<f64>| (up * self.gravity - omega_rate.cross(&arm) - whirl) * mass;
        let mut push = force(&omega_rate);
        let mut reaction = up.dot(&push);
        let mut power = 0.0;
        if R::ACTS {
            let couple = self.resistance.couple(omega, up);
            let turned = inverse * couple;
            let change = up.dot(&turned.cross(&arm)) * mass;
            reaction /= 1.0 + change;
            omega_rate += turned * reaction;
            push = force(&omega_rate);
            power = couple.dot(omega);
        }
        Contact {
            slip: Vector3::zeros(),
            reaction,
            traction: push / reaction - up,
            omega_rate,
            power,
        }
    }
}

/// A body on a table as what follows its motion sees it: compiled once, with gravity, friction and resistance behind a call that costs
/// a hundredth of an evaluation.
pub(crate) trait Ground {
    fn body(&self) -> &ConvexBody;
    fn gravity(&self) -> f64;
    /// What is known of a contact that slides.
    fn slides(&self, pose: &Pose) -> Contact;
    /// What is known of a contact that rolls.
    fn rolls(&self, pose: &Pose) -> Contact;
    /// The rates of a state that slides.
    fn sliding_rates(&self, y: &Numbers) -> Numbers;
    /// The rates of a state that rolls; its velocity of C is what Ω makes it.
    fn rolling_rates(&self, y: &Numbers) -> Numbers;
    /// f(v), the level force over the normal one; and the slip over which it bends.
    fn traction(&self, slip: &Vector3<f64>) -> Vector3<f64>;
    /// As [`Traction::sharpness`].
    fn sharpness(&self) -> f64;
    /// As [`Traction::holding`].
    fn holding(&self) -> Holding;
}

impl<F: Traction, R: Couple> Ground for Table<F, R> {
    fn body(&self) -> &ConvexBody {
        &self.body
    }

    fn gravity(&self) -> f64 {
        self.gravity
    }

    fn slides(&self, pose: &Pose) -> Contact {
        self.sliding(&pose.up, &pose.omega, &pose.level)
    }

    fn rolls(&self, pose: &Pose) -> Contact {
        self.rolling(&pose.up, &pose.omega)
    }

    fn sliding_rates(&self, y: &Numbers) -> Numbers {
        let pose = Pose::of(y);
        rates(&self.body, y, &pose, &self.slides(&pose))
    }

    fn rolling_rates(&self, y: &Numbers) -> Numbers {
        let y = self.body.rolled(y);
        let pose = Pose::of(&y);
        rates(&self.body, &y, &pose, &self.rolls(&pose))
    }

    fn traction(&self, slip: &Vector3<f64>) -> Vector3<f64> {
        self.friction.traction(slip)
    }

    fn sharpness(&self) -> f64 {
        self.friction.sharpness()
    }

    fn holding(&self) -> Holding {
        self.friction.holding()
    }
}

/// Rates of the numbers of a state, from those of the contact.
fn rates(body: &ConvexBody, y: &Numbers, pose: &Pose, contact: &Contact) -> Numbers {
    let omega = &pose.omega;
    let q = Quaternion::new(y[0], y[1], y[2], y[3]) * Quaternion::from_imag(*omega) * 0.5;
    let acceleration = pose.turn * contact.traction * (contact.reaction / body.mass);
    let r = contact.omega_rate;
    [
        q.w,
        q.i,
        q.j,
        q.k,
        r.x,
        r.y,
        r.z,
        acceleration.x,
        acceleration.y,
        y[7],
        y[8],
        -contact.reaction * contact.power,
    ]
}

impl ConvexBody {
    /// The state with the velocity of C that pure rolling gives it.
    pub(crate) fn rolled(&self, y: &Numbers) -> Numbers {
        let pose = Pose::of(y);
        let velocity = pose.turn * -pose.omega.cross(&self.arm(&pose.up));
        let mut y = *y;
        (y[7], y[8]) = (velocity.x, velocity.y);
        y
    }

    /// Height of C over the table and its vertical velocity, in contact.
    pub(crate) fn height(&self, pose: &Pose) -> (f64, f64) {
        let arm = self.arm(&pose.up);
        (-pose.up.dot(&arm), -pose.up.dot(&pose.omega.cross(&arm)))
    }
}

/// The attitude in a state.
pub(crate) fn attitude(pose: &Pose) -> Attitude {
    Attitude::from_unit(pose.turn.into_inner())
}
