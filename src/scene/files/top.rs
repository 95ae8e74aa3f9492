//! `kind = "top"`, or no kind: a body with a fixed point.

use super::body::{Inertia, Matter};
use super::file::*;
use crate::scene::top::{Body as TopBody, Start, Top};

section! {
    /// `[body]`.
    Body {
        matter: Matter, "";
        center_of_mass: Option<BodyVector>, "the place of the centre of mass, from the pivot, along the body's axes in m";
        pivot: Option<BodyVector>, "the place where a shape is held, along its axes from its origin in m (its centre of mass by default)";
    }

    /// `[initial]`.
    Initial {
        attitude: Attitude, "a unit quaternion w x y z";
        omega: Option<BodyVector>, "an angular velocity in rad/s";
        angular_momentum: Option<BodyVector>, "an angular momentum in kg m²/s";
    }

    /// `[effects]`.
    Effects {
        gravity: Option<Gravity>, "an acceleration in m/s²";
        pivot_friction: Option<PivotFriction>, "a coefficient in N m s";
        bearing_friction: Option<BearingFriction>, "a coefficient in N m s";
        air_drag: Option<AirDrag>, "a coefficient in N m s²";
        tip_friction: Option<TipFriction>, "a torque in N m";
    }
}

pub fn top(file: &File<'_, Body, Initial, Effects>) -> Made<Top> {
    let effects = &file.effects;
    let made = made(file, &file.body, effects.gravity.is_some());
    let start = start(file, &file.initial);
    let omega = file.initial.omega;
    let key = omega.map_or("initial.angular_momentum", |_| "initial.omega");
    let (body, outline) = made?;
    let top = file.right(key, Top::new(body, start?))?;
    let acting = listed![
        effects.gravity,
        effects.pivot_friction,
        effects.bearing_friction,
        effects.air_drag,
        effects.tip_friction,
    ];
    let top = with(file, top, acting, Top::with)?;
    file.right(file.body.matter.key(), top.can_be_resisted())?;
    Some((top, free(outline, Around::Pivot)))
}

fn made(file: &Reader<'_>, body: &Body, heavy: bool) -> Option<(TopBody, Outline)> {
    let matter = &body.matter;
    let inertia = match matter.inertia(file)? {
        Inertia::Shape(_) if body.center_of_mass.is_some() => {
            let told = " follows from `shape` and `pivot`";
            return file.wrong("body.center_of_mass", told);
        }
        Inertia::Shape(solid) => {
            let pivot = body.pivot.unwrap_or(solid.center());
            let outline = matter.outline(&solid).moved(-pivot.components());
            let held = TopBody::held_at(&solid, pivot);
            return Some((file.right("body.pivot, body.shape", held)?, outline));
        }
        _ if body.pivot.is_some() => return file.wrong("body.pivot", " goes with `shape`"),
        Inertia::Matrix(..) if matter.moments == Some([0.0; 3]) => {
            let told = " must not all be zero: what has no inertia does not turn";
            return file.wrong("body.moments", told);
        }
        Inertia::Matrix(matrix) => matrix,
    };
    let made = file.right(matter.key(), TopBody::along_own_axes(&inertia))?;
    let outline = |mass, center: BodyVector| {
        Outline::of_inertia(inertia.second_moments(), mass, center.components())
    };
    match (matter.mass, body.center_of_mass) {
        (Some(mass), Some(center)) => {
            let made = made.with_center_of_mass(mass, center);
            let made = file.right("body.center_of_mass", made)?;
            Some((made, outline(mass, center)))
        }
        (None, _) if heavy => {
            let expected = "gravity acts on the centre of mass, a mass in kg";
            file.missing("body.mass", expected)
        }
        (mass, _) => Some((made, outline(mass.unwrap_or(1.0), BodyVector::zero()))),
    }
}

fn start(file: &Reader<'_>, initial: &Initial) -> Option<Start> {
    match (initial.omega, initial.angular_momentum) {
        (Some(omega), None) => Some(Start::with_omega(omega, initial.attitude)),
        (None, Some(l)) => Some(Start::with_angular_momentum(l, initial.attitude)),
        (Some(_), Some(_)) => file.exclude("initial.omega", "angular_momentum"),
        (None, None) => {
            let expected = "either `omega` in rad/s or `angular_momentum` in kg m²/s";
            file.missing("initial.omega", expected)
        }
    }
}
