//! `kind = "meteorite"`, `"roller"`, `"spool"`, `"superball"`: what strikes, skids, rolls and bounces (4.2 to 4.6).
//!
//! | kind | `[body]` | `[initial]` | `[effects]` |
//! |---|---|---|---|
//! | meteorite | mass, moments | velocity, omega | impact_mass, impact_velocity, impact_at |
//! | roller | mass, radius, inertia_factor | velocity, rim_speed or cue_height (in radii) | friction, static_friction, rolling_resistance, sheet_friction, sheet_times, sheet_speeds, sheet_margin |
//! | spool | the same and axle | velocity, rim_speed | tension, tug_angle, and friction as above |
//! | superball | mass, inertia_factor | height, climb, velocity, rim_speed | ceiling, restitution, tangential_restitution, grip |
//!
//! All but the first take `gravity`; what lies on a table must have it.

use spinning_bodies::frame::BodyVector;
use spinning_bodies::impacts::{Impact, Meteorite, Planet};
use spinning_bodies::inertia::InertiaMatrix;
use spinning_bodies::rolling::RoundBody;
use spinning_bodies::rolling::sheet::SheetSpeeds;
use spinning_bodies::rolling::spool::Spool;
use spinning_bodies::scene::effects::{
    Coulomb, Effect, Gravity, Restitution, RollingResistance, Sheet, Tug,
};
use spinning_bodies::scene::meteorite::StruckPlanet;
use spinning_bodies::scene::roller::Roller;
use spinning_bodies::scene::spool::TuggedSpool;
use spinning_bodies::scene::superball::Superball;
use spinning_bodies::superball::Motion;
use spinning_bodies::superball::flight::InFlight;

use super::AnyScene;
use super::reader::Section;
use super::shape::with;
use crate::Result;

const BALL: f64 = 0.4;
const GRAVITY: &str = "an acceleration in m/s²";
const HEIGHT: &str = "a height in m";
const MASS: &str = "a mass in kg";
const SPEED: &str = "a speed in m/s";
const RATIO: &str = "a ratio without a unit";

fn round(section: &Section<'_>) -> Result<RoundBody> {
    let mass = section.positive("mass", MASS)?;
    let radius = section.positive("radius", "a radius in m")?;
    let kappa = section.number_or("inertia_factor", RATIO, BALL)?;
    RoundBody::new(mass, radius, kappa).map_err(section.about("inertia_factor"))
}

fn friction(section: &Section<'_>) -> Result<Option<Coulomb>> {
    let kinetic = section.optional_not_negative("friction", RATIO)?;
    let grip = section.optional_not_negative("static_friction", RATIO)?;
    match (kinetic, grip) {
        (Some(kinetic), grip) => Coulomb::with_grip(kinetic, grip.unwrap_or(kinetic))
            .map(Some)
            .map_err(section.about("static_friction, friction")),
        (None, None) => Ok(None),
        (None, Some(_)) => Err(section.refused("static_friction", "needs `friction` beside it")),
    }
}

fn resistance(section: &Section<'_>) -> Result<Option<RollingResistance>> {
    const KEY: &str = "rolling_resistance";
    let arm = section.optional(KEY, RATIO)?;
    arm.map(RollingResistance::new)
        .transpose()
        .map_err(section.about(KEY))
}

fn sheet(section: &Section<'_>) -> Result<Option<Sheet>> {
    let keys = [
        "sheet_friction",
        "sheet_times",
        "sheet_speeds",
        "sheet_margin",
    ];
    if !keys.iter().any(|key| section.has(key)) {
        return Ok(None);
    }
    let law = section.optional_not_negative(keys[0], RATIO)?;
    let law = law.ok_or_else(|| section.missing(keys[0], RATIO))?;
    let law = Coulomb::new(law).map_err(section.about(keys[0]))?;
    let list = |key, what: &str| {
        let numbers = section.optional_numbers(key, what)?;
        numbers.ok_or_else(|| section.missing(key, what))
    };
    let times = list(keys[1], "a list of times in s")?;
    let speeds = list(keys[2], "a list of speeds in m/s")?;
    if times.len() != speeds.len() {
        let told = format!(
            "must be as many as sheet_times, {}, got {}",
            times.len(),
            speeds.len()
        );
        return Err(section.refused(keys[2], told));
    }
    let points: Vec<(f64, f64)> = times.into_iter().zip(speeds).collect();
    let speeds = SheetSpeeds::through(points).map_err(section.about(keys[1]))?;
    let margin = section.positive(keys[3], "a distance in m")?;
    let sheet = Sheet::new(law, speeds, margin).map_err(section.about(keys[3]))?;
    Ok(Some(sheet))
}

pub fn roller(file: &Section<'_>) -> Result<AnyScene> {
    let section = file.section("body")?;
    let body = round(&section)?;
    section.done()?;
    let effects = file.section("effects")?;
    let gravity = effects.positive("gravity", GRAVITY)?;
    let listed = [
        friction(&effects)?.map(Effect::from),
        resistance(&effects)?.map(Effect::from),
        sheet(&effects)?.map(Effect::from),
    ];
    let section = file.section("initial")?;
    let rim = section.optional("rim_speed", SPEED)?;
    let scene = match (rim, section.optional("cue_height", RATIO)?) {
        (Some(_), Some(_)) => {
            return Err(section.refused("rim_speed", "and `cue_height` exclude each other"));
        }
        (None, Some(height)) => {
            let velocity = section.positive("velocity", SPEED)?;
            body.strike(height, velocity)
                .and_then(|shot| Roller::after(&shot, gravity))
                .map_err(section.about("cue_height, velocity"))?
        }
        (rim, None) => {
            let velocity = section.number_or("velocity", SPEED, 0.0)?;
            Roller::new(body, gravity, velocity, rim.unwrap_or(0.0))
                .map_err(section.about("velocity, rim_speed"))?
        }
    };
    section.done()?;
    let scene = with(scene, &effects, listed, Roller::with)?;
    effects.done()?;
    Ok(AnyScene::scene(Box::new(scene)))
}

pub fn spool(file: &Section<'_>) -> Result<AnyScene> {
    let section = file.section("body")?;
    let body = round(&section)?;
    let axle = section.positive("axle", "a radius in m")?;
    if axle > body.radius() {
        let told = format!(
            "must not exceed `radius`, {:?}, got {axle:?}",
            body.radius()
        );
        return Err(section.refused("axle", told));
    }
    let reel = Spool::new(body, axle).map_err(section.about("axle"))?;
    section.done()?;
    let effects = file.section("effects")?;
    let gravity = effects.positive("gravity", GRAVITY)?;
    let (law, arm) = (friction(&effects)?, resistance(&effects)?);
    let tension = effects.optional_not_negative("tension", "a force in N")?;
    let tug = match (tension, effects.optional("tug_angle", "an angle in rad")?) {
        (Some(tension), Some(angle)) => {
            let tug = Tug::new(tension, angle).map_err(effects.about("tug_angle"))?;
            Some(tug)
        }
        (None, None) => None,
        _ => return Err(effects.refused("tension", "and `tug_angle` belong together")),
    };
    let mut scene = TuggedSpool::new(reel, gravity).map_err(effects.about("gravity"))?;
    if let Some(tug) = tug {
        let keys = "tension, tug_angle, gravity, mass";
        scene = scene.with(tug).map_err(file.about(keys))?;
    }
    let listed = [law.map(Effect::from), arm.map(Effect::from)];
    let scene = with(scene, &effects, listed, TuggedSpool::with)?;
    effects.done()?;
    let section = file.section("initial")?;
    let velocity = section.number_or("velocity", SPEED, 0.0)?;
    let scene = scene.moving(velocity, section.number_or("rim_speed", SPEED, 0.0)?);
    section.done()?;
    Ok(AnyScene::scene(Box::new(scene)))
}

pub fn superball(file: &Section<'_>) -> Result<AnyScene> {
    let section = file.section("initial")?;
    let start = InFlight {
        position: 0.0,
        height: section
            .optional_not_negative("height", HEIGHT)?
            .ok_or_else(|| section.missing("height", HEIGHT))?,
        climb: section.number_or("climb", SPEED, 0.0)?,
        motion: Motion {
            velocity: section.number_or("velocity", SPEED, 0.0)?,
            rim_speed: section.number_or("rim_speed", SPEED, 0.0)?,
        },
        bounces: 0,
    };
    section.done()?;
    let section = file.section("body")?;
    let mass = section.positive("mass", MASS)?;
    let kappa = section.number_or("inertia_factor", RATIO, BALL)?;
    let ball = Superball::new(mass, kappa, start).map_err(section.about("mass"))?;
    section.held(
        "inertia_factor",
        RATIO,
        kappa,
        kappa > 0.0 && kappa <= 1.0,
        "from 0 to 1",
    )?;
    ball.flight().map_err(file.about("height, climb"))?;
    section.done()?;
    let effects = file.section("effects")?;
    let room = effects.optional_positive("ceiling", HEIGHT)?;
    let ball = ball.under(room.unwrap_or(f64::INFINITY));
    ball.flight().map_err(file.about("ceiling, height"))?;
    let gravity = effects.optional("gravity", GRAVITY)?;
    let gravity = gravity.map(Gravity::new).transpose();
    let gravity = gravity.map_err(effects.about("gravity"))?;
    let normal = effects.optional("restitution", RATIO)?;
    let tangential = effects.optional("tangential_restitution", RATIO)?;
    let restitution = if normal.is_some() || tangential.is_some() {
        let normal = normal.unwrap_or(1.0);
        Restitution::new(normal, 1.0).map_err(effects.about("restitution"))?;
        let both = Restitution::new(normal, tangential.unwrap_or(1.0));
        Some(both.map_err(effects.about("tangential_restitution"))?)
    } else {
        None
    };
    let grip = effects.optional("grip", RATIO)?.map(Coulomb::new);
    let grip = grip.transpose().map_err(effects.about("grip"))?;
    let listed = [
        gravity.map(Effect::from),
        restitution.map(Effect::from),
        grip.map(Effect::from),
    ];
    let scene = with(ball, &effects, listed, Superball::with)?;
    effects.done()?;
    Ok(AnyScene::scene(Box::new(scene)))
}

pub fn meteorite(file: &Section<'_>) -> Result<AnyScene> {
    let section = file.section("initial")?;
    let zero = BodyVector::zero;
    let velocity = section
        .optional_vector("velocity", "a velocity in m/s")?
        .unwrap_or_else(zero);
    let omega = section.optional_vector("omega", "an angular velocity in rad/s")?;
    section.done()?;
    let section = file.section("body")?;
    let mass = section.positive("mass", MASS)?;
    let [a, b, c] = section.list("moments", "principal moments in kg m²")?;
    let inertia = InertiaMatrix::diagonal(a, b, c).map_err(section.about("moments"))?;
    let planet = Planet::new(mass, inertia, velocity, omega.unwrap_or_else(zero))
        .map_err(section.about("moments"))?;
    section.done()?;
    let effects = file.section("effects")?;
    let impact_mass = effects.optional_positive("impact_mass", MASS)?;
    let flight = effects.optional_vector("impact_velocity", "a velocity in m/s")?;
    let at = effects.optional_vector("impact_at", "a place in m")?;
    let planet = StruckPlanet::new(planet);
    let scene = match (impact_mass, flight, at) {
        (Some(mass), Some(velocity), Some(at)) => {
            let meteorite = Meteorite::new(mass, velocity)
                .map_err(effects.about("impact_mass, impact_velocity"))?;
            let impact = Impact { meteorite, at };
            planet.with(impact).map_err(effects.about("impact_at"))?
        }
        (None, None, None) => planet,
        _ => {
            let keys = "impact_mass, impact_velocity, impact_at";
            return Err(effects.refused(keys, "belong together"));
        }
    };
    effects.done()?;
    Ok(AnyScene::scene(Box::new(scene)))
}
