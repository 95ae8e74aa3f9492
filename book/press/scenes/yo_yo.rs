//! `kind = "yo-yo"`: a yo-yo, let go or thrown.
//!
//! `[body]` mass, inertia or radius (of a solid disc), length, axle, wound (radius of the wound string; absent: a thin string);
//! `[initial]` throw (m/s, absent: let go); `[effects]` gravity, turn_loss (spin left by a turn), hand (J a turn), sleep (s), axle_friction (N m),
//! air_drag (kg m²).

use spinning_bodies::error::Number;
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
    effects.done()?;
    let section = file.section("body")?;
    let toy = toy(&section)?;
    section.done()?;
    let section = file.section("initial")?;
    let throw = section.number_or("throw", "a speed in m/s", 0.0)?;
    if throw < 0.0 {
        return Err(section.refused(
            "throw",
            format!("must not be negative, got {}", Number(throw)),
        ));
    }
    section.done()?;
    let scene = listed.on(toy, throw).map_err(file.about("effects"))?;
    Ok(Ready::scene(scene))
}

fn listed(section: &Section<'_>) -> Result<Listed> {
    let effect = |key: &'static str, what| section.optional(key, what);
    Ok(Listed {
        gravity: effect("gravity", "an acceleration in m/s²")?
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
    let mass = section.number("mass", "a mass in kg")?;
    let inertia = section.optional("inertia", "a moment of inertia in kg m²")?;
    let radius = section.optional("radius", "the radius of the disc in m")?;
    let length = section.number("length", "the length of the string in m")?;
    let axle = section.number("axle", "the radius of the axle in m")?;
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
    let toy = toy.map_err(section.about("mass, inertia, radius, length, axle"))?;
    match section.optional("wound", "the radius of the wound string in m")? {
        Some(wound) => toy.wound_to(wound).map_err(section.about("wound")),
        None => Ok(toy),
    }
}
