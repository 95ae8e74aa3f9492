//! `kind = "top"`, or no kind: a body with a fixed point.
//!
//! `[body]` mass, moments, center_of_mass; `[initial]` attitude, omega or angular_momentum; `[effects]` gravity, pivot_friction,
//! bearing_friction, air_drag, tip_friction.

use spinning_bodies::scene::effects::Effect;
use spinning_bodies::scene::top::{
    AirDrag, BearingFriction, Body, Gravity, PivotFriction, Start, TipFriction, Top,
};

use super::AnyScene;
use super::reader::Section;
use crate::Result;

pub fn read(file: &Section<'_>) -> Result<AnyScene> {
    let effects = file.section("effects")?;
    let listed = listed(&effects)?;
    let section = file.section("body")?;
    let heavy = listed.iter().any(|e| matches!(e, Effect::Gravity(_)));
    let body = body(&section, heavy)?;
    section.done()?;
    let section = file.section("initial")?;
    let start = start(&section)?;
    let key = if section.has("omega") {
        "omega"
    } else {
        "angular_momentum"
    };
    let mut top = Top::new(body, start).map_err(section.about(key))?;
    section.done()?;
    for effect in listed {
        let with = top.with(effect);
        top = with.map_err(file.about("tip_friction, moments, center_of_mass"))?;
    }
    effects.done()?;
    Ok(AnyScene::scene(Box::new(top)))
}

/// The effects that are there.
fn listed(section: &Section<'_>) -> Result<Vec<Effect>> {
    let mut listed = Vec::new();
    let mut take = |key: &'static str, what, made: fn(f64) -> spinning_bodies::Result<Effect>| {
        if let Some(value) = section.optional(key, what)? {
            listed.push(made(value).map_err(section.about(key))?);
        }
        Result::Ok(())
    };
    take("gravity", "an acceleration in m/s²", |g| {
        Gravity::new(g).map(Effect::from)
    })?;
    take("pivot_friction", "a coefficient in N m s", |c| {
        PivotFriction::new(c).map(Effect::from)
    })?;
    take("bearing_friction", "a coefficient in N m s", |c| {
        BearingFriction::new(c).map(Effect::from)
    })?;
    take("air_drag", "a coefficient in N m s²", |k| {
        AirDrag::new(k).map(Effect::from)
    })?;
    take("tip_friction", "a torque in N m", |n| {
        TipFriction::new(n).map(Effect::from)
    })?;
    Ok(listed)
}

fn body(section: &Section<'_>, heavy: bool) -> Result<Body> {
    let moments = section.list("moments", "principal moments in kg m²")?;
    let body = Body::new(moments).map_err(section.about("moments"))?;
    if moments == [0.0; 3] {
        let told = "must not all be zero: what has no inertia does not turn";
        return Err(section.refused("moments", told));
    }
    let mass = section.optional_positive("mass", "a mass in kg")?;
    let center = section.optional_vector("center_of_mass", "a place in m")?;
    match (mass, center) {
        (Some(mass), Some(center)) => {
            let body = body.with_center_of_mass(mass, center);
            body.map_err(section.about("center_of_mass"))
        }
        (None, _) if heavy => Err(section.refused(
            "mass",
            "is missing: gravity acts on the centre of mass, a mass in kg is expected",
        )),
        _ => Ok(body),
    }
}

fn start(section: &Section<'_>) -> Result<Start> {
    let attitude = section.attitude()?;
    let omega = section.optional_vector("omega", "an angular velocity in rad/s")?;
    let l = section.optional_vector("angular_momentum", "an angular momentum in kg m²/s")?;
    match (omega, l) {
        (Some(omega), None) => Ok(Start::with_omega(omega, attitude)),
        (None, Some(l)) => Ok(Start::with_angular_momentum(l, attitude)),
        (Some(_), Some(_)) => {
            Err(section.refused("omega", "and `angular_momentum` exclude each other"))
        }
        (None, None) => Err(section.refused(
            "omega",
            "is missing: either `omega` in rad/s or `angular_momentum` in kg m²/s is expected",
        )),
    }
}
