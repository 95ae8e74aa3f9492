//! `kind = "swivel"`, `"skater"`, `"cat"`, `"paper-cat"`, `"crawler"`: what bodies do to themselves (1.1).
//!
//! Effects that need more than one number are tables of their own, such as `[effects.turnover]`; in all of them `pace` is `"even"`, if nothing is
//! said, or `"late"`.
//!
//! | kind | `[body]` | `[initial]` | effects |
//! |---|---|---|---|
//! | swivel | lower, upper | angular_momentum | four_phases (arms_out, arms_in, twist, duration), bearing_friction |
//! | skater | core, hand | reach, spin | draw (to, begin, duration), bearing_friction |
//! | cat | mass, axial, transverse, to_joint: of both halves | attitude | turnover (forward, back, duration), gravity |
//! | paper-cat | mass, area, lever, gyration, coefficient, damping | tilt | air, gravity |
//! | crawler | masses, gap, length, push, pull | | ground_friction (coefficient, gravity) |

use spinning_bodies::phenomena;
use spinning_bodies::phenomena::cat::Half;
use spinning_bodies::phenomena::crawler::Strokes;
use spinning_bodies::scene::shape::{
    Air, BearingFriction, Cat, Crawler, Draw, FourPhases, Gravity, GroundFriction, Pace, PaperCat,
    Skater, Swivel, Turnover,
};

use super::Ready;
use super::reader::Section;
use crate::Result;

const PACES: &[(&str, Pace)] = &[("even", Pace::Even), ("late", Pace::Late)];

/// The friction of a bearing, if it is listed.
fn bearing(effects: &Section<'_>) -> Result<Option<BearingFriction>> {
    const KEY: &str = "bearing_friction";
    let listed = effects.optional_not_negative(KEY, "a coefficient in N m s")?;
    Ok(listed.map(|resistance| BearingFriction { resistance }))
}

fn gravity(effects: &Section<'_>) -> Result<Option<Gravity>> {
    let listed = effects.optional("gravity", "an acceleration in m/s²")?;
    Ok(listed.map(|g| Gravity { g }))
}

/// An angle by which the spine of a cat bends.
fn bend(table: &Section<'_>, key: &'static str) -> Result<f64> {
    let angle = table.number(key, "an angle in radians")?;
    if (0.0..=core::f64::consts::PI).contains(&angle) {
        Ok(angle)
    } else {
        let told = format!("must be an angle in radians from 0 to pi, got {angle:?}");
        Err(table.refused(key, told))
    }
}

/// `kind = "swivel"`.
pub fn swivel(file: &Section<'_>) -> Result<Ready> {
    let body = file.section("body")?;
    let lower = body.positive("lower", "a moment in kg m²")?;
    let upper = body.positive("upper", "a moment in kg m²")?;
    let scene = Swivel::new(lower, upper).map_err(body.about("lower"))?;
    body.done()?;
    let initial = file.section("initial")?;
    let l = initial.number_or("angular_momentum", "an angular momentum in kg m²/s", 0.0)?;
    let scene = scene.with_angular_momentum(l);
    let scene = scene.map_err(initial.about("angular_momentum"))?;
    initial.done()?;
    let effects = file.section("effects")?;
    let friction = bearing(&effects)?;
    let change = if effects.has("four_phases") {
        let table = effects.section("four_phases")?;
        let change = FourPhases {
            arms_out: table.positive("arms_out", "a moment in kg m²")?,
            arms_in: table.positive("arms_in", "a moment in kg m²")?,
            twist: table.number("twist", "an angle in radians")?,
            duration: table.positive("duration", "a time in s")?,
            pace: table.word("pace", PACES)?,
        };
        table.done()?;
        Some(change)
    } else {
        None
    };
    let ready = match (change, friction) {
        (None, None) => Ready::scene(Box::new(scene)),
        (None, Some(f)) => Ready::scene(Box::new(scene.with_friction(f))),
        (Some(c), None) => Ready::scene(Box::new(
            scene
                .with_change(c)
                .map_err(effects.about("four_phases, twist"))?,
        )),
        (Some(c), Some(f)) => {
            let scene = scene
                .with_change(c)
                .map_err(effects.about("four_phases, twist"))?;
            Ready::scene(Box::new(scene.with_friction(f)))
        }
    };
    effects.done()?;
    Ok(ready)
}

/// `kind = "skater"`.
pub fn skater(file: &Section<'_>) -> Result<Ready> {
    let body = file.section("body")?;
    let core = body.positive("core", "a moment in kg m²")?;
    let hand = body.number("hand", "a mass in kg")?;
    let person = phenomena::skater::Skater::new(core, hand).map_err(body.about("hand"))?;
    body.done()?;
    let initial = file.section("initial")?;
    let reach = initial.number("reach", "a distance in m")?;
    let spin = initial.number("spin", "an angular velocity in rad/s")?;
    let scene = Skater::new(person, reach, spin).map_err(initial.about("reach"))?;
    initial.done()?;
    let effects = file.section("effects")?;
    let friction = bearing(&effects)?;
    let change = if effects.has("draw") {
        let table = effects.section("draw")?;
        let change = Draw {
            to: table
                .optional_not_negative("to", "a distance in m")?
                .ok_or_else(|| table.missing("to", "a distance in m"))?,
            begin: table
                .optional_not_negative("begin", "a time in s")?
                .unwrap_or(0.0),
            duration: table.positive("duration", "a time in s")?,
            pace: table.word("pace", PACES)?,
        };
        table.done()?;
        Some(change)
    } else {
        None
    };
    let ready = match (change, friction) {
        (None, None) => Ready::scene(Box::new(scene)),
        (None, Some(f)) => Ready::scene(Box::new(scene.with_friction(f))),
        (Some(c), None) => Ready::scene(Box::new(
            scene.with_change(c).map_err(effects.about("draw"))?,
        )),
        (Some(c), Some(f)) => {
            let scene = scene.with_change(c).map_err(effects.about("draw"))?;
            Ready::scene(Box::new(scene.with_friction(f)))
        }
    };
    effects.done()?;
    Ok(ready)
}

/// `kind = "cat"`.
pub fn cat(file: &Section<'_>) -> Result<Ready> {
    let body = file.section("body")?;
    let pair = |key, what: &str| body.positives::<2>(key, what);
    let mass = pair("mass", "two masses in kg")?;
    let axial = pair("axial", "two moments in kg m²")?;
    let transverse = pair("transverse", "two moments in kg m²")?;
    let to_joint = pair("to_joint", "two distances in m")?;
    let halves = [0, 1].map(|k| Half {
        mass: mass[k],
        axial: axial[k],
        transverse: transverse[k],
        to_joint: to_joint[k],
    });
    let animal = phenomena::cat::Cat::new(halves).map_err(body.about("axial, transverse"))?;
    body.done()?;
    let initial = file.section("initial")?;
    let scene = Cat::new(animal, initial.attitude()?);
    initial.done()?;
    let effects = file.section("effects")?;
    let weight = gravity(&effects)?;
    let change = if effects.has("turnover") {
        let table = effects.section("turnover")?;
        let change = Turnover {
            forward: bend(&table, "forward")?,
            back: bend(&table, "back")?,
            duration: table.positive("duration", "a time in s")?,
            pace: table.word("pace", PACES)?,
        };
        table.done()?;
        Some(change)
    } else {
        None
    };
    let ready = match (change, weight) {
        (None, None) => Ready::scene(Box::new(scene)),
        (None, Some(g)) => Ready::scene(Box::new(scene.with_gravity(g))),
        (Some(c), None) => Ready::scene(Box::new(
            scene.with_change(c).map_err(effects.about("turnover"))?,
        )),
        (Some(c), Some(g)) => {
            let scene = scene.with_change(c).map_err(effects.about("turnover"))?;
            Ready::scene(Box::new(scene.with_gravity(g)))
        }
    };
    effects.done()?;
    Ok(ready)
}

/// `kind = "paper-cat"`; what `[body]` does not say is as for a cat cut from a postcard.
pub fn paper_cat(file: &Section<'_>) -> Result<Ready> {
    let usual = phenomena::PaperCat::POSTCARD;
    let body = file.section("body")?;
    let positive = |key, what, usual| {
        let given = body.optional_positive(key, what)?;
        Ok::<f64, crate::Error>(given.unwrap_or(usual))
    };
    let sheet = phenomena::PaperCat {
        mass: positive("mass", "a mass in kg", usual.mass)?,
        area: positive("area", "an area in m²", usual.area)?,
        lever: body.number_or("lever", "a distance in m", usual.lever)?,
        gyration: positive("gyration", "a distance in m", usual.gyration)?,
        coefficient: positive("coefficient", "a number", usual.coefficient)?,
        damping: positive("damping", "an area in m²", usual.damping)?,
    };
    body.done()?;
    let initial = file.section("initial")?;
    let tilt = initial.number("tilt", "an angle in radians")?;
    initial.done()?;
    let scene = PaperCat::new(sheet, tilt).map_err(file.about("body"))?;
    let effects = file.section("effects")?;
    let weight = gravity(&effects)?;
    let air = effects.optional_not_negative("air", "a density in kg/m³")?;
    let air = air.map(|density| Air { density });
    effects.done()?;
    Ok(match (air, weight) {
        (None, None) => Ready::scene(Box::new(scene)),
        (None, Some(g)) => Ready::scene(Box::new(scene.with_gravity(g))),
        (Some(a), None) => Ready::scene(Box::new(scene.with_air(a))),
        (Some(a), Some(g)) => Ready::scene(Box::new(scene.with_air(a).with_gravity(g))),
    })
}

/// `kind = "crawler"`.
pub fn crawler(file: &Section<'_>) -> Result<Ready> {
    let body = file.section("body")?;
    let [rear, front] = body.positives("masses", "two masses in kg")?;
    let strokes = Strokes {
        gap: body.positive("gap", "a distance in m")?,
        length: body.positive("length", "a distance in m")?,
        push: body.positive("push", "a time in s")?,
        pull: body.positive("pull", "a time in s")?,
    };
    let animal = phenomena::crawler::Crawler::new(rear, front, strokes);
    let scene = Crawler::new(animal.map_err(body.about("length, push, pull"))?);
    body.done()?;
    let effects = file.section("effects")?;
    let ready = if effects.has("ground_friction") {
        let table = effects.section("ground_friction")?;
        let mu = table.number("coefficient", "a number")?;
        let g = table.positive("gravity", "an acceleration in m/s²")?;
        let ground = GroundFriction::new(mu, g).map_err(table.about("coefficient"))?;
        table.done()?;
        Ready::scene(Box::new(scene.with_friction(ground)))
    } else {
        Ready::scene(Box::new(scene))
    };
    effects.done()?;
    Ok(ready)
}
