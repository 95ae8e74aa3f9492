//! `kind = "strip"`: a strip that falls through a fluid or a vacuum (4.10).

use nalgebra::Vector3;

use super::file::*;
use crate::falling_strip::Plate;
use crate::scene::{Strip, StripStart};

tables! { StripKeys
    [body]
    width: f64, "a width in m", Positive;
    areal_density: f64, "a mass per area in kg/m²", Positive;
    fluid_density: f64 = 0.0, "a density in kg/m³", NotNegative;
    thickness_ratio: f64 = 0.0, "the thickness over the width, a number from 0 to 1";
    inertia_factor: Option<f64>, "a number, 1/3 for a thin plate", Positive;
    [initial]
    start: StripStart;
    [effects]
    gravity: Option<Gravity>, "an acceleration in m/s²";
    lift: Option<Lift>, "C_T and C_R";
    drag: Option<Drag>, "A and B";
    rotational_damping: Option<RotationalDamping>, "a rate in 1/s and mu_2", NotNegative;
    added_mass: Option<AddedMass>, "a factor, 1 for an ideal fluid", NotNegative;
}

keys! { StripStart
    angle: f64 = 0.0, "an angle in rad", From(-MOST_TURNED, MOST_TURNED);
    velocity: [f64; 2] = 0.0, "a velocity in m/s";
    omega: f64 = 0.0, "an angular velocity in rad/s";
}

pub fn strip(file: &Reader<'_>, given: StripKeys) -> Option<AnyScene> {
    let (width, ratio) = (given.width, given.thickness_ratio);
    let plate = |thickness| {
        let factor = given.inertia_factor.unwrap_or(1.0 / 3.0);
        let mass = given.areal_density * width;
        Plate::new(0.5 * width, mass, given.fluid_density, thickness, factor)
    };
    file.right("body.width, body.areal_density", plate(0.0))?;
    let plate = file.right("body.thickness_ratio", plate(ratio))?;
    let scene = file.right("initial", Strip::new(plate, given.start))?;
    let acting = acting![given: gravity, lift, drag, rotational_damping, added_mass];
    let scene = with(file, scene, acting, Strip::with)?;
    let edges = Vector3::new(1.0, 2.0, ratio.max(0.02)) * width;
    let outline = Outline::new("a strip, its length cut short", Solid::Cuboid(edges));
    drawn(scene, move |told| {
        let [x, z, angle, omega, l] = told.vector(["x", "y", "angle", "omega", "l"]);
        let attitude = about(Vector3::y(), -angle);
        let sight = outline.sight(Around::Space, Vector3::new(x, 0.0, z), attitude);
        sight.turning(Vector3::y(), [-omega, -l])
    })
}
