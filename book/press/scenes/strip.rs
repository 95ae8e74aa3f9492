//! `kind = "strip"`: a strip that falls through a fluid, or through none.
//!
//! `[body]` width (m), areal_density (kg/m²), fluid_density (kg/m³, absent: 0), thickness_ratio, inertia_factor (absent: 1/3);
//! `[initial]` angle, velocity (right, up), omega; `[effects]` gravity, lift = [C_T, C_R], drag = [A, B], rotational_damping = [1/s, μ₂], added_mass (1).

use spinning_bodies::falling_strip::{AddedMass, Drag, Gravity, Lift, Plate, RotationalDamping};
use spinning_bodies::scene::strip::{Listed, StripStart};

use super::Ready;
use super::reader::Section;
use crate::Result;

const DAMPING: &str = "a rate in 1/s and mu_2";

pub fn read(file: &Section<'_>) -> Result<Ready> {
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
    // Each of the others is examined at its own key.
    let scene = listed.on(plate, start).map_err(effects.about("drag"))?;
    effects.done()?;
    Ok(Ready::scene(scene))
}

fn listed(section: &Section<'_>) -> Result<Listed> {
    Ok(Listed {
        gravity: section
            .optional("gravity", "an acceleration in m/s²")?
            .map(|acceleration| Gravity { acceleration }),
        lift: section
            .optional_list("lift", "C_T and C_R")?
            .map(|[translational, rotational]| Lift {
                translational,
                rotational,
            }),
        drag: section
            .optional_list("drag", "A and B")?
            .map(|[mean, contrast]| Drag { mean, contrast }),
        rotational_damping: section
            .optional_list("rotational_damping", DAMPING)?
            .map(|[linear, quadratic]| {
                for number in [linear, quadratic] {
                    let right = number >= 0.0;
                    section.held("rotational_damping", DAMPING, number, right, "not negative")?;
                }
                Ok(RotationalDamping { linear, quadratic })
            })
            .transpose()?,
        added_mass: section
            .optional_not_negative("added_mass", "a factor, 1 for an ideal fluid")?
            .map(|factor| AddedMass { factor }),
    })
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
