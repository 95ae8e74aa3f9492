//! `kind = "strip"`: a strip that falls through a fluid, or through none.
//!
//! `[body]` width (m), areal_density (kg/m²), fluid_density (kg/m³, absent: 0), thickness_ratio, inertia_factor (absent: 1/3);
//! `[initial]` angle, velocity (right, up), omega; `[effects]` gravity, lift = [C_T, C_R], drag = [A, B], rotational_damping = [1/s, μ₂], added_mass (1).

use spinning_bodies::falling_strip::Plate;
use spinning_bodies::scene::effects::{AddedMass, Drag, Effect, Gravity, Lift, RotationalDamping};
use spinning_bodies::scene::strip::{Strip, StripStart};

use super::AnyScene;
use super::reader::Section;
use super::shape::{made, with};
use crate::Result;

const DAMPING: &str = "a rate in 1/s and mu_2";

pub fn read(file: &Section<'_>) -> Result<AnyScene> {
    let effects = file.section("effects")?;
    let listed = listed(&effects)?;
    let section = file.section("body")?;
    let plate = plate(&section)?;
    section.done()?;
    let section = file.section("initial")?;
    let start = StripStart {
        angle: section.number_or("angle", "an angle in rad", 0.0)?,
        velocity: section
            .optional_list("velocity", "a velocity in m/s")?
            .unwrap_or_default(),
        omega: section.number_or("omega", "an angular velocity in rad/s", 0.0)?,
    };
    section.done()?;
    let scene = Strip::new(plate, start).map_err(file.about("initial"))?;
    let scene = with(scene, &effects, listed, Strip::with)?;
    effects.done()?;
    Ok(AnyScene::scene(Box::new(scene)))
}

fn listed(section: &Section<'_>) -> Result<[Option<Effect>; 5]> {
    let gravity = section.optional("gravity", "an acceleration in m/s²")?;
    let lift = section.optional_list("lift", "C_T and C_R")?;
    let drag = section.optional_list("drag", "A and B")?;
    let damping = section.optional_list("rotational_damping", DAMPING)?;
    for number in damping.into_iter().flatten() {
        let right = number >= 0.0;
        section.held("rotational_damping", DAMPING, number, right, "not negative")?;
    }
    let added = section.optional_not_negative("added_mass", "a factor, 1 for an ideal fluid")?;
    Ok([
        made(section, "gravity", gravity, Gravity::new)?,
        lift.map(|[translational, rotational]| {
            Effect::from(Lift {
                translational,
                rotational,
            })
        }),
        drag.map(|[mean, contrast]| Effect::from(Drag { mean, contrast })),
        damping.map(|[linear, quadratic]| Effect::from(RotationalDamping { linear, quadratic })),
        added.map(|factor| Effect::from(AddedMass { factor })),
    ])
}

fn plate(section: &Section<'_>) -> Result<Plate> {
    let width = section.positive("width", "a width in m")?;
    let density = section.positive("areal_density", "a mass per area in kg/m²")?;
    let fluid = section.optional_not_negative("fluid_density", "a density in kg/m³")?;
    let thickness = section.number_or("thickness_ratio", "a number from 0 to 1", 0.0)?;
    let factor = section.optional_positive("inertia_factor", "a positive number")?;
    let fluid = fluid.unwrap_or(0.0);
    let plate = |thickness| {
        let factor = factor.unwrap_or(1.0 / 3.0);
        Plate::new(0.5 * width, density * width, fluid, thickness, factor)
    };
    plate(0.0).map_err(section.about("width, areal_density"))?;
    plate(thickness).map_err(section.about("thickness_ratio"))
}
