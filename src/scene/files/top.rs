//! `kind = "top"`, or no kind: a body with a fixed point.

use super::body::{Inertia, Matter};
use super::file::*;
use crate::scene::top::{Body, Start, Top};

tables! { TopKeys
    [body]
    matter: Matter;
    center_of_mass: Option<BodyVector>, "the place of the centre of mass, from the pivot, along the body's axes in m";
    pivot: Option<BodyVector>, "the place where a shape is held, along its axes from its origin in m (its centre of mass by default)";
    [initial]
    attitude: Attitude, "a unit quaternion w x y z";
    omega: Option<BodyVector>, "an angular velocity in rad/s";
    angular_momentum: Option<BodyVector>, "an angular momentum in kg m²/s";
    [effects]
    gravity: Option<Gravity>, "an acceleration in m/s²";
    pivot_friction: Option<PivotFriction>, "against all of the angular velocity, a coefficient in N m s", NotNegative;
    bearing_friction: Option<BearingFriction>, "against what is across axis 3, a coefficient in N m s", NotNegative;
    air_drag: Option<AirDrag>, "a coefficient in N m s²", NotNegative;
    tip_friction: Option<TipFriction>, "a torque in N m", NotNegative;
}

pub fn top(file: &Reader<'_>, given: TopKeys) -> Option<AnyScene> {
    let held = given.held(file);
    let start = given.start(file);
    let (body, outline) = held?;
    let key = (given.omega).map_or("initial.angular_momentum", |_| "initial.omega");
    let top = file.right(key, Top::new(body, start?))?;
    let mut acting = acting![given: gravity, pivot_friction, bearing_friction, air_drag];
    let keys = "effects.tip_friction, body.moments, body.center_of_mass";
    acting.push((keys, given.tip_friction.map(Effect::from)));
    let top = with(file, top, acting, Top::with)?;
    file.right(given.matter.key(), top.can_be_resisted())?;
    drawn(top, move |told| posed(&outline, Around::Pivot, told))
}

impl TopKeys {
    fn held(&self, file: &Reader<'_>) -> Option<(Body, Outline)> {
        let matter = &self.matter;
        let inertia = match matter.inertia(file)? {
            Inertia::Shape(_) if self.center_of_mass.is_some() => {
                let told = " follows from `shape` and `pivot`";
                return file.wrong("body.center_of_mass", told);
            }
            Inertia::Shape(solid) => {
                let pivot = self.pivot.unwrap_or(solid.center());
                let outline = matter.outline(&solid).moved(-pivot.components());
                let held = Body::held_at(&solid, pivot);
                return Some((file.right("body.pivot, body.shape", held)?, outline));
            }
            _ if self.pivot.is_some() => return file.wrong("body.pivot", " goes with `shape`"),
            Inertia::Matrix(..) if matter.moments == Some([0.0; 3]) => {
                let told = " must not all be zero: what has no inertia does not turn";
                return file.wrong("body.moments", told);
            }
            Inertia::Matrix(matrix) => matrix,
        };
        let body = file.right(matter.key(), Body::along_own_axes(&inertia))?;
        let outline = |mass, center: BodyVector| {
            Outline::of_inertia(inertia.second_moments(), mass, center.components())
        };
        match (matter.mass, self.center_of_mass) {
            (Some(mass), Some(center)) => {
                let body = body.with_center_of_mass(mass, center);
                let body = file.right("body.center_of_mass", body)?;
                Some((body, outline(mass, center)))
            }
            (None, _) if self.gravity.is_some() => {
                let expected = "gravity acts on the centre of mass, a mass in kg";
                file.missing("body.mass", expected)
            }
            (_, None) if self.gravity.is_some() => {
                let expected = "gravity acts on it, the place of the centre of mass in m";
                file.missing("body.center_of_mass", expected)
            }
            (mass, _) => Some((body, outline(mass.unwrap_or(1.0), BodyVector::zero()))),
        }
    }

    fn start(&self, file: &Reader<'_>) -> Option<Start> {
        match (self.omega, self.angular_momentum) {
            (Some(omega), None) => Some(Start::with_omega(omega, self.attitude)),
            (None, Some(l)) => Some(Start::with_angular_momentum(l, self.attitude)),
            (Some(_), Some(_)) => file.exclude("initial.omega", "angular_momentum"),
            (None, None) => {
                let expected = "either `omega` in rad/s or `angular_momentum` in kg m²/s";
                file.missing("initial.omega", expected)
            }
        }
    }
}
