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
use spinning_bodies::scene::effects::{
    Air, BearingFriction, Coulomb, Draw, Effect, FourPhases, Gravity, Pace, Turnover,
};
use spinning_bodies::scene::shape::{Cat, Crawler, PaperCat, Skater, Swivel};

use super::AnyScene;
use super::reader::Section;
use crate::Result;

const PACES: &[(&str, Pace)] = &[("even", Pace::Even), ("late", Pace::Late)];

/// An effect of one number, if that is listed.
pub fn made<E: Into<Effect>>(
    effects: &Section<'_>,
    key: &'static str,
    listed: Option<f64>,
    new: fn(f64) -> spinning_bodies::Result<E>,
) -> Result<Option<Effect>> {
    let made = listed.map(new).transpose().map_err(effects.about(key))?;
    Ok(made.map(Into::into))
}

/// The friction of a bearing, if it is listed.
fn bearing(effects: &Section<'_>) -> Result<Option<Effect>> {
    const KEY: &str = "bearing_friction";
    let listed = effects.optional_not_negative(KEY, "a coefficient in N m s")?;
    made(effects, KEY, listed, BearingFriction::new)
}

fn gravity(effects: &Section<'_>) -> Result<Option<Effect>> {
    let listed = effects.optional("gravity", "an acceleration in m/s²")?;
    made(effects, "gravity", listed, Gravity::new)
}

/// The scene with those of these effects that are listed.
pub fn with<S>(
    mut scene: S,
    effects: &Section<'_>,
    listed: impl IntoIterator<Item = Option<Effect>>,
    add: impl Fn(S, Effect) -> spinning_bodies::Result<S>,
) -> Result<S> {
    for effect in listed.into_iter().flatten() {
        let name = effect.name();
        scene = add(scene, effect).map_err(effects.about(name))?;
    }
    Ok(scene)
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
pub fn swivel(file: &Section<'_>) -> Result<AnyScene> {
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
    let listed = [change.map(Effect::from), friction];
    let scene = with(scene, &effects, listed, Swivel::with)?;
    effects.done()?;
    Ok(AnyScene::scene(Box::new(scene)))
}

/// `kind = "skater"`.
pub fn skater(file: &Section<'_>) -> Result<AnyScene> {
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
    let listed = [change.map(Effect::from), friction];
    let scene = with(scene, &effects, listed, Skater::with)?;
    effects.done()?;
    Ok(AnyScene::scene(Box::new(scene)))
}

/// `kind = "cat"`.
pub fn cat(file: &Section<'_>) -> Result<AnyScene> {
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
    let listed = [change.map(Effect::from), weight];
    let scene = with(scene, &effects, listed, Cat::with)?;
    effects.done()?;
    Ok(AnyScene::scene(Box::new(scene)))
}

/// `kind = "paper-cat"`; what `[body]` does not say is as for a cat cut from a postcard.
pub fn paper_cat(file: &Section<'_>) -> Result<AnyScene> {
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
    let listed = [made(&effects, "air", air, Air::new)?, weight];
    let scene = with(scene, &effects, listed, PaperCat::with)?;
    effects.done()?;
    Ok(AnyScene::scene(Box::new(scene)))
}

/// `kind = "crawler"`.
pub fn crawler(file: &Section<'_>) -> Result<AnyScene> {
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
    let scene = if effects.has("ground_friction") {
        let table = effects.section("ground_friction")?;
        let mu = table.number("coefficient", "a number")?;
        let g = table.positive("gravity", "an acceleration in m/s²")?;
        let friction = Coulomb::new(mu).map_err(table.about("coefficient"))?;
        let scene = scene.with(friction).map_err(table.about("coefficient"))?;
        let weight = Gravity::new(g).and_then(|gravity| scene.with(gravity));
        let scene = weight.map_err(table.about("gravity"))?;
        table.done()?;
        scene
    } else {
        scene
    };
    effects.done()?;
    Ok(AnyScene::scene(Box::new(scene)))
}
