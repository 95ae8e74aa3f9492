//! `kind = "yo-yo"`: a yo-yo, let go or thrown.
//!
//! `[body]` mass, inertia or radius (of a solid disc), length, axle, wound (radius of the wound string; absent: a thin string);
//! `[initial]` throw (m/s, absent: let go); `[effects]` gravity, turn_loss (spin left by a turn), hand (J a turn), sleep (s), axle_friction (N m),
//! air_drag (kg m²).

use spinning_bodies::scene::yo_yo::{
    AirDrag, AxleFriction, Gravity, Hand, Listed, Sleep, TurnLoss,
};
use spinning_bodies::yo_yo::YoYo;

use super::Ready;
use super::reader::Section;
use crate::Result;

pub fn read(file: &Section<'_>) -> Result<Ready> {
    let effects = file.section("effects")?;
    let listed = listed(&effects)?;
    let section = file.section("body")?;
    let toy = toy(&section)?;
    section.done()?;
    let section = file.section("initial")?;
    let throw = section.optional_not_negative("throw", "a speed in m/s")?;
    section.done()?;
    // Each of the others is examined at its own key.
    let scene = listed.on(toy, throw.unwrap_or(0.0));
    let scene = scene.map_err(effects.about("turn_loss"))?;
    effects.done()?;
    Ok(Ready::scene(scene))
}

fn listed(section: &Section<'_>) -> Result<Listed> {
    let effect = |key: &'static str, what| section.optional_not_negative(key, what);
    Ok(Listed {
        gravity: section
            .optional_positive("gravity", "an acceleration in m/s²")?
            .map(|acceleration| Gravity { acceleration }),
        turn_loss: effect("turn_loss", "the part of the spin that a turn leaves")?
            .map(|restitution| TurnLoss { restitution }),
        hand: effect("hand", "the work of the hand at a turn in J")?.map(|work| Hand { work }),
        sleep: effect("sleep", "a time in s")?.map(|duration| Sleep { duration }),
        axle_friction: effect("axle_friction", "a torque in N m")?
            .map(|torque| AxleFriction { torque }),
        air_drag: effect("air_drag", "a coefficient in kg m²")?
            .map(|coefficient| AirDrag { coefficient }),
    })
}

fn toy(section: &Section<'_>) -> Result<YoYo> {
    let mass = section.positive("mass", "a mass in kg")?;
    let inertia = section.optional_positive("inertia", "a moment of inertia in kg m²")?;
    let radius = section.optional_positive("radius", "the radius of the disc in m")?;
    let length = section.positive("length", "the length of the string in m")?;
    let axle = section.positive("axle", "the radius of the axle in m")?;
    if let Some(radius) = radius
        && axle > radius
    {
        let told = format!("must not exceed `radius`, {radius:?}, got {axle:?}");
        return Err(section.refused("axle", told));
    }
    let toy = match (inertia, radius) {
        (Some(inertia), None) => YoYo::new(mass, inertia, length, axle),
        (None, Some(radius)) => YoYo::disc(mass, radius, length, axle),
        (Some(_), Some(_)) => {
            return Err(section.refused("inertia", "and `radius` exclude each other"));
        }
        (None, None) => {
            let told =
                "is missing: either `inertia` in kg m² or `radius` of a disc in m is expected";
            return Err(section.refused("inertia", told));
        }
    };
    let toy = toy.map_err(section.about(if radius.is_some() {
        "axle, length, mass, radius"
    } else {
        "axle, length"
    }))?;
    match section.optional_positive("wound", "the radius of the wound string in m")? {
        Some(wound) => toy.wound_to(wound).map_err(section.about("wound")),
        None => Ok(toy),
    }
}
