//! `kind = "yo-yo"`: a yo-yo, let go or thrown.
//!
//! `[body]` mass, inertia or radius (of a solid disc), length, axle, wound (radius of the wound string; absent: a thin string);
//! `[initial]` throw (m/s, absent: let go); `[effects]` gravity, turn_loss (spin left by a turn), hand (J a turn), sleep (s), axle_friction (N m),
//! air_drag (kg m²).

use spinning_bodies::scene::effects::{
    AirDrag, AxleFriction, Effect, Gravity, Hand, Sleep, TurnLoss,
};
use spinning_bodies::scene::yo_yo::Play;
use spinning_bodies::yo_yo::YoYo;

use super::AnyScene;
use super::reader::Section;
use super::shape::{made, with};
use crate::Result;

pub fn read(file: &Section<'_>) -> Result<AnyScene> {
    let effects = file.section("effects")?;
    let listed = listed(&effects)?;
    let section = file.section("body")?;
    let toy = toy(&section)?;
    section.done()?;
    let section = file.section("initial")?;
    let throw = section.optional_not_negative("throw", "a speed in m/s")?;
    let scene = Play::new(toy, throw.unwrap_or(0.0)).map_err(section.about("throw"))?;
    section.done()?;
    let scene = with(scene, &effects, listed, Play::with)?;
    effects.done()?;
    Ok(AnyScene::scene(Box::new(scene)))
}

fn listed(section: &Section<'_>) -> Result<[Option<Effect>; 6]> {
    let gravity = section.optional_positive("gravity", "an acceleration in m/s²")?;
    Ok([
        made(section, "gravity", gravity, Gravity::new)?,
        effect(
            section,
            "turn_loss",
            "the part of the spin that a turn leaves",
            TurnLoss::new,
        )?,
        effect(
            section,
            "hand",
            "the work of the hand at a turn in J",
            Hand::new,
        )?,
        effect(section, "sleep", "a time in s", Sleep::new)?,
        effect(
            section,
            "axle_friction",
            "a torque in N m",
            AxleFriction::new,
        )?,
        effect(section, "air_drag", "a coefficient in kg m²", AirDrag::new)?,
    ])
}

/// An effect of one number that is not negative, if it is listed.
fn effect<E: Into<Effect>>(
    section: &Section<'_>,
    key: &'static str,
    what: &str,
    new: fn(f64) -> spinning_bodies::Result<E>,
) -> Result<Option<Effect>> {
    made(section, key, section.optional_not_negative(key, what)?, new)
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
