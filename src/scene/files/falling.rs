//! `kind = "yo-yo"`, let go or thrown (4.9), and `"strip"`, which falls through a fluid or a vacuum (4.10).

use nalgebra::Vector3;

use super::file::{File, Made, listed, with};
use super::keys::Bound::{NotNegative, Positive};
use super::look::{Outline, about, rolling};
use super::reader::Reader;
use super::values::{keys, section};
use crate::falling_strip::Plate;
use crate::scene::effects::{
    AddedMass, AirDrag, AxleFriction, Drag, Gravity, Hand, Lift, RotationalDamping, Sleep, TurnLoss,
};
use crate::scene::sight::Look;
use crate::scene::{Around, Play, Solid, Strip, StripStart};
use crate::yo_yo::YoYo;

section! {
    /// `[body]` of a yo-yo.
    YoYoBody {
        mass: f64, "a mass in kg", Positive;
        inertia: Option<f64>, "a moment of inertia in kg m²", Positive;
        radius: Option<f64>, "the radius of the disc in m", Positive;
        length: f64, "the length of the string in m", Positive;
        axle: f64, "the radius of the axle in m", Positive;
        wound: Option<f64>, "the radius of the wound string in m", Positive;
    }

    /// `[initial]` of a yo-yo.
    YoYoInitial {
        throw: f64 = 0.0, "a speed in m/s", NotNegative;
    }

    /// `[effects]` of a yo-yo.
    YoYoEffects {
        gravity: Option<Gravity>, "an acceleration in m/s²", Positive;
        turn_loss: Option<TurnLoss>, "the part of the spin that a turn leaves", NotNegative;
        hand: Option<Hand>, "the work of the hand at a turn in J", NotNegative;
        sleep: Option<Sleep>, "a time in s", NotNegative;
        axle_friction: Option<AxleFriction>, "a torque in N m", NotNegative;
        air_drag: Option<AirDrag>, "a coefficient in kg m²", NotNegative;
    }
}

pub fn yo_yo(file: &File<'_, YoYoBody, YoYoInitial, YoYoEffects>) -> Made<Play> {
    let toy = toy(file, &file.body)?;
    // Without another value, the radius of the disc with this mass and inertia.
    let of_disc = (2.0 * toy.inertia / toy.mass).sqrt();
    let radius = file.body.radius.unwrap_or(of_disc);
    let outline = Outline::new("a yo-yo", Solid::wheel(radius, 0.8 * radius));
    let look = rolling(outline, Around::String, |told| {
        let [depth] = told.vector(["depth"]);
        ([0.0, -depth], None)
    });
    let scene = file.right("initial.throw", Play::new(toy, file.initial.throw))?;
    let effects = &file.effects;
    let acting = listed![
        effects.gravity,
        effects.turn_loss,
        effects.hand,
        effects.sleep,
        effects.axle_friction,
        effects.air_drag,
    ];
    Some((with(file, scene, acting, Play::with)?, look))
}

fn toy(file: &Reader<'_>, body: &YoYoBody) -> Option<YoYo> {
    let (mass, length, axle) = (body.mass, body.length, body.axle);
    let toy = match (body.inertia, body.radius) {
        (Some(inertia), None) => {
            let made = YoYo::new(mass, inertia, length, axle);
            file.right("body.axle, body.length", made)
        }
        (None, Some(radius)) if axle > radius => {
            let told = format!(" must not exceed `radius`, {radius:?}, got {axle:?}");
            file.wrong("body.axle", told)
        }
        (None, Some(radius)) => {
            let keys = "body.axle, body.length, body.mass, body.radius";
            file.right(keys, YoYo::disc(mass, radius, length, axle))
        }
        (Some(_), Some(_)) => file.wrong("body.inertia", " and `radius` exclude each other"),
        (None, None) => {
            let expected = "either `inertia` in kg m² or `radius` of a disc in m";
            file.missing("body.inertia", expected)
        }
    }?;
    let wound = body.wound.map_or(Ok(toy), |wound| toy.wound_to(wound));
    file.right("body.wound", wound)
}

section! {
    /// `[body]` of a strip.
    StripBody {
        width: f64, "a width in m", Positive;
        areal_density: f64, "a mass per area in kg/m²", Positive;
        fluid_density: f64 = 0.0, "a density in kg/m³", NotNegative;
        thickness_ratio: f64 = 0.0, "a number from 0 to 1";
        inertia_factor: Option<f64>, "a number, 1/3 for a thin plate", Positive;
    }
}

keys! {
    StripStart {
        angle: f64 = 0.0, "an angle in rad";
        velocity: [f64; 2] = [0.0, 0.0], "a velocity in m/s";
        omega: f64 = 0.0, "an angular velocity in rad/s";
    }
}

section! {
    /// `[effects]` of a strip.
    StripEffects {
        gravity: Option<Gravity>, "an acceleration in m/s²";
        lift: Option<[f64; 2]>, "C_T and C_R";
        drag: Option<[f64; 2]>, "A and B";
        rotational_damping: Option<[f64; 2]>, "a rate in 1/s and mu_2", NotNegative;
        added_mass: Option<f64>, "a factor, 1 for an ideal fluid", NotNegative;
    }
}

pub fn strip(file: &File<'_, StripBody, StripStart, StripEffects>) -> Made<Strip> {
    let plate = |thickness| {
        let (half, fluid) = (0.5 * file.body.width, file.body.fluid_density);
        let factor = file.body.inertia_factor.unwrap_or(1.0 / 3.0);
        let mass = file.body.areal_density * file.body.width;
        Plate::new(half, mass, fluid, thickness, factor)
    };
    file.right("body.width, body.areal_density", plate(0.0))?;
    let plate = file.right("body.thickness_ratio", plate(file.body.thickness_ratio))?;
    let scene = file.right("initial", Strip::new(plate, file.initial))?;
    let effects = &file.effects;
    let lift = effects.lift.map(|[translational, rotational]| Lift {
        translational,
        rotational,
    });
    let drag = effects.drag.map(|[mean, contrast]| Drag { mean, contrast });
    let damping = effects.rotational_damping;
    let damping = damping.map(|[linear, quadratic]| RotationalDamping { linear, quadratic });
    let added = effects.added_mass.map(|factor| AddedMass { factor });
    let acting = listed![effects.gravity, lift, drag, damping, added];
    let scene = with(file, scene, acting, Strip::with)?;
    let edges = Vector3::new(1.0, 2.0, file.body.thickness_ratio.max(0.02)) * file.body.width;
    let outline = Outline::new("a strip, its length cut short", Solid::Cuboid(edges));
    let look: Look = Box::new(move |told| {
        let [x, z, angle, omega, l] = told.vector(["x", "y", "angle", "omega", "l"]);
        let attitude = about(Vector3::y(), -angle);
        let sight = outline.sight(Around::Space, Vector3::new(x, 0.0, z), attitude);
        sight.turning(Vector3::y(), [-omega, -l])
    });
    Some((scene, look))
}
