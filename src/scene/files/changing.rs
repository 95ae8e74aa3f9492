//! `kind = "swivel"`, `"skater"`, `"cat"`, `"paper-cat"`, `"crawler"`: what bodies do to themselves (1.1). Effects that need more than one number are
//! tables of their own, such as `[effects.turnover]`.

use core::f64::consts::PI;

use super::keys::Bound::{From, NotNegative, Positive};
use super::reader::Reader;
use super::values::{Flat, keys, section};
use super::{listed, with};
use crate::frame::Attitude;
use crate::phenomena;
use crate::phenomena::cat::Half;
use crate::phenomena::crawler::Strokes;
use crate::scene::effects::{
    Air, BearingFriction, Coulomb, Draw, FourPhases, Gravity, Pace, Turnover,
};
use crate::scene::shape::{Cat, Crawler, PaperCat, Skater, Swivel};

section! {
    /// `[body]` of a swivel.
    SwivelBody {
        lower: f64, "a moment in kg m²", Positive;
        upper: f64, "a moment in kg m²", Positive;
    }

    /// `[initial]` of a swivel.
    SwivelInitial {
        angular_momentum: f64 = 0.0, "an angular momentum in kg m²/s";
    }

    /// `[effects]` of a swivel.
    SwivelEffects {
        bearing_friction: Option<BearingFriction>, "a coefficient in N m s", NotNegative;
        four_phases: Option<FourPhases>, "";
    }
}

keys! {
    FourPhases {
        arms_out: f64, "a moment in kg m²", Positive;
        arms_in: f64, "a moment in kg m²", Positive;
        twist: f64, "an angle in rad";
        duration: f64, "a time in s", Positive;
        pace: Pace, "";
    }
}

pub fn swivel(
    file: &Reader<'_>,
    body: SwivelBody,
    initial: SwivelInitial,
    effects: SwivelEffects,
) -> Option<Swivel> {
    let scene = file.right("body.lower", Swivel::new(body.lower, body.upper))?;
    let l = initial.angular_momentum;
    let scene = file.right("initial.angular_momentum", scene.with_angular_momentum(l))?;
    with(
        file,
        scene,
        listed![effects.four_phases, effects.bearing_friction],
        Swivel::with,
    )
}

section! {
    /// `[body]` of a skater.
    SkaterBody {
        core: f64, "a moment in kg m²", Positive;
        hand: f64, "a mass in kg";
    }

    /// `[initial]` of a skater.
    SkaterInitial {
        reach: f64, "a distance in m";
        spin: f64, "an angular velocity in rad/s";
    }

    /// `[effects]` of a skater.
    SkaterEffects {
        bearing_friction: Option<BearingFriction>, "a coefficient in N m s", NotNegative;
        draw: Option<Draw>, "";
    }
}

keys! {
    Draw {
        to: f64, "a distance in m", NotNegative;
        begin: f64 = 0.0, "a time in s", NotNegative;
        duration: f64, "a time in s", Positive;
        pace: Pace, "";
    }
}

pub fn skater(
    file: &Reader<'_>,
    body: SkaterBody,
    initial: SkaterInitial,
    effects: SkaterEffects,
) -> Option<Skater> {
    let person = phenomena::skater::Skater::new(body.core, body.hand);
    let person = file.right("body.hand", person)?;
    let scene = Skater::new(person, initial.reach, initial.spin);
    let scene = file.right("initial.reach", scene)?;
    with(
        file,
        scene,
        listed![effects.draw, effects.bearing_friction],
        Skater::with,
    )
}

section! {
    /// `[body]` of a cat: every list has one number for the front and one for the rear.
    CatBody {
        mass: [f64; 2], "two masses in kg", Positive;
        axial: [f64; 2], "two moments in kg m²", Positive;
        transverse: [f64; 2], "two moments in kg m²", Positive;
        to_joint: [f64; 2], "two distances in m", Positive;
    }

    /// `[initial]` of a cat.
    CatInitial {
        attitude: Attitude, "a unit quaternion w x y z";
    }

    /// `[effects]` of a cat.
    CatEffects {
        gravity: Option<Gravity>, "an acceleration in m/s²";
        turnover: Option<Turnover>, "";
    }
}

keys! {
    Turnover {
        forward: f64, "an angle in rad", From(0.0, PI);
        back: f64, "an angle in rad", From(0.0, PI);
        duration: f64, "a time in s", Positive;
        pace: Pace, "";
    }
}

pub fn cat(
    file: &Reader<'_>,
    body: CatBody,
    initial: CatInitial,
    effects: CatEffects,
) -> Option<Cat> {
    let halves = [0, 1].map(|k| Half {
        mass: body.mass[k],
        axial: body.axial[k],
        transverse: body.transverse[k],
        to_joint: body.to_joint[k],
    });
    let animal = phenomena::cat::Cat::new(halves);
    let animal = file.right("body.axial, body.transverse", animal)?;
    let scene = Cat::new(animal, initial.attitude);
    with(
        file,
        scene,
        listed![effects.turnover, effects.gravity],
        Cat::with,
    )
}

/// What `[body]` does not say is as for a cat cut from a postcard.
const POSTCARD: phenomena::PaperCat = phenomena::PaperCat::POSTCARD;

keys! {
    phenomena::PaperCat {
        mass: f64 = POSTCARD.mass, "a mass in kg", Positive;
        area: f64 = POSTCARD.area, "an area in m²", Positive;
        lever: f64 = POSTCARD.lever, "a distance in m";
        gyration: f64 = POSTCARD.gyration, "a distance in m", Positive;
        coefficient: f64 = POSTCARD.coefficient, "a number", Positive;
        damping: f64 = POSTCARD.damping, "an area in m²", Positive;
    }
}

section! {
    /// `[initial]` of a cat of paper.
    PaperCatInitial {
        tilt: f64, "an angle in rad";
    }

    /// `[effects]` of a cat of paper.
    PaperCatEffects {
        gravity: Option<Gravity>, "an acceleration in m/s²";
        air: Option<Air>, "a density in kg/m³", NotNegative;
    }
}

pub fn paper_cat(
    file: &Reader<'_>,
    sheet: phenomena::PaperCat,
    initial: PaperCatInitial,
    effects: PaperCatEffects,
) -> Option<PaperCat> {
    let scene = file.right("body", PaperCat::new(sheet, initial.tilt))?;
    with(
        file,
        scene,
        listed![effects.air, effects.gravity],
        PaperCat::with,
    )
}

section! {
    /// `[body]` of a crawler.
    CrawlerBody {
        masses: [f64; 2], "two masses in kg", Positive;
        strokes: Flat<Strokes>, "";
    }
}

keys! {
    Strokes {
        gap: f64, "a distance in m", Positive;
        length: f64, "a distance in m", Positive;
        push: f64, "a time in s", Positive;
        pull: f64, "a time in s", Positive;
    }
}

section! {
    /// `[initial]` of a crawler.
    CrawlerInitial {}

    /// `[effects]` of a crawler.
    CrawlerEffects {
        ground_friction: Option<GroundFriction>, "";
    }

    /// `[effects.ground_friction]`.
    GroundFriction {
        coefficient: f64, "a number";
        gravity: f64, "an acceleration in m/s²", Positive;
    }
}

pub fn crawler(
    file: &Reader<'_>,
    body: CrawlerBody,
    _: CrawlerInitial,
    effects: CrawlerEffects,
) -> Option<Crawler> {
    let [rear, front] = body.masses;
    let animal = phenomena::crawler::Crawler::new(rear, front, body.strokes.0);
    let keys = "body.length, body.push, body.pull";
    let scene = Crawler::new(file.right(keys, animal)?);
    let Some(table) = effects.ground_friction else {
        return Some(scene);
    };
    let friction = Coulomb::new(table.coefficient).and_then(|friction| scene.with(friction));
    let scene = file.right("effects.ground_friction.coefficient", friction)?;
    let weight = Gravity::new(table.gravity).and_then(|gravity| scene.with(gravity));
    file.right("effects.ground_friction.gravity", weight)
}
