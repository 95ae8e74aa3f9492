//! `kind = "strip"`: a strip that falls through a fluid or a vacuum (4.10).

use nalgebra::Vector3;

use super::file::*;
use crate::falling_strip::Plate;
use crate::scene::{Strip, StripStart};

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
