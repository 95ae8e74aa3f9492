//! `kind = "table-top"`: a body that stands on a table (4.7).
//!
//! | section | keys |
//! |---|---|
//! | `[body]` | mass; radius or semi_axes (and surface_turn about the third axis); surface_center, CK; inertia about C: I11 I22 I33 I12 I13 I23 |
//! | `[initial]` | tilt, azimuth, and vertical_spin or axial_spin; or attitude and omega; velocity |
//! | `[effects]` | gravity; friction_law ("coulomb", "smoothed", "viscous", "no-slip"), friction, friction_slip; rolling_resistance, pivoting_resistance |

use nalgebra::Matrix3;
use spinning_bodies::frame::{Attitude, BodyVector, SpaceVector};
use spinning_bodies::inertia::InertiaMatrix;
use spinning_bodies::scene::contact::TableTop;
use spinning_bodies::scene::effects::{
    Coulomb, Effect, Gravity, NoSlip, Regularised, Resistance, Viscous,
};
use spinning_bodies::tippe_top::{ConvexBody, Start, Surface};

use super::AnyScene;
use super::reader::Section;
use crate::Result;

pub fn read(file: &Section<'_>) -> Result<AnyScene> {
    let section = file.section("body")?;
    let body = body(&section)?;
    section.done()?;
    let section = file.section("initial")?;
    let start = start(&section)?;
    section.done()?;
    let effects = file.section("effects")?;
    let gravity = effects
        .optional_positive("gravity", "an acceleration in m/s²")?
        .map(Gravity::new)
        .transpose()
        .map_err(effects.about("gravity"))?;
    let law = law(&effects)?;
    let resistance = resistance(&effects)?;
    effects.done()?;
    let mut scene = TableTop::new(body, start);
    let listed: [Option<Effect>; 3] = [gravity.map(Effect::from), law, resistance];
    for effect in listed.into_iter().flatten() {
        scene = scene.with(effect).map_err(file.about("effects"))?;
    }
    Ok(AnyScene::scene(Box::new(scene)))
}

fn body(section: &Section<'_>) -> Result<ConvexBody> {
    let mass = section.positive("mass", "a mass in kg")?;
    let [a, b, c, ab, ac, bc] =
        section.list("inertia", "I11 I22 I33 I12 I13 I23 about C in kg m²")?;
    let matrix = Matrix3::new(a, ab, ac, ab, b, bc, ac, bc, c);
    let inertia = InertiaMatrix::from_matrix(matrix).map_err(section.about("inertia"))?;
    let center = section.optional_vector("surface_center", "a place in m")?;
    let surface = surface(section)?;
    ConvexBody::new(
        mass,
        inertia,
        surface,
        center.unwrap_or_else(BodyVector::zero),
    )
    .map_err(section.about("inertia"))
}

fn surface(section: &Section<'_>) -> Result<Surface> {
    let radius = section.optional_positive("radius", "a radius in m")?;
    let axes = section.optional_list::<3>("semi_axes", "half axes in m")?;
    let turn = section.number_or("surface_turn", "an angle in rad", 0.0)?;
    let surface = match (radius, axes) {
        (Some(radius), None) => Surface::sphere(radius).map_err(section.about("radius"))?,
        (None, Some(axes)) => Surface::ellipsoid(axes).map_err(section.about("semi_axes"))?,
        (Some(_), Some(_)) => {
            return Err(section.refused("radius", "and `semi_axes` exclude each other"));
        }
        (None, None) => {
            return Err(section.refused(
                "radius",
                "is missing: either `radius` or `semi_axes` in m is expected",
            ));
        }
    };
    if turn == 0.0 {
        return Ok(surface);
    }
    let turn = Attitude::about_axis(BodyVector::new(0.0, 0.0, 1.0), turn);
    Ok(surface.turned(&turn.map_err(section.about("surface_turn"))?))
}

fn start(section: &Section<'_>) -> Result<Start> {
    const SPIN: &str = "an angular velocity in rad/s";
    let vertical = section.optional("vertical_spin", SPIN)?;
    let axial = section.optional("axial_spin", SPIN)?;
    let omega = section.optional_vector("omega", SPIN)?;
    let tilt = section.number_or("tilt", "an angle in rad", 0.0)?;
    let azimuth = section.number_or("azimuth", "an angle in rad", 0.0)?;
    let velocity = section.optional_list::<3>("velocity", "a velocity in m/s")?;
    let mut start = match (vertical, axial, omega) {
        (Some(spin), None, None) => {
            Start::about_vertical(tilt, azimuth, spin).map_err(section.about("vertical_spin"))?
        }
        (None, Some(spin), None) => {
            Start::about_third_axis(tilt, azimuth, spin).map_err(section.about("axial_spin"))?
        }
        (None, None, Some(omega)) => {
            if section.has("tilt") || section.has("azimuth") {
                return Err(section.refused("omega", "goes with `attitude`, not with `tilt`"));
            }
            Start::spinning(section.attitude()?, omega).map_err(section.about("omega"))?
        }
        _ => {
            return Err(section.refused(
                "vertical_spin",
                "or `axial_spin` or `omega` is expected, exactly one of the three",
            ));
        }
    };
    if let Some([x, y, z]) = velocity {
        start.velocity = SpaceVector::new(x, y, z);
    }
    Ok(start)
}

fn law(section: &Section<'_>) -> Result<Option<Effect>> {
    const RATIO: &str = "a coefficient of friction, s/m for the viscous law";
    let named = section.has("friction_law");
    let friction = section.optional_not_negative("friction", RATIO)?;
    let slip = section.optional_positive("friction_slip", "a speed in m/s")?;
    if !named {
        return match (friction, slip) {
            (None, None) => Ok(None),
            _ => Err(section.refused("friction_law", "is missing: it says what `friction` means")),
        };
    }
    let laws = [
        ("coulomb", 0),
        ("smoothed", 1),
        ("viscous", 2),
        ("no-slip", 3),
    ];
    let about = || section.about("friction");
    match (section.word("friction_law", &laws)?, friction, slip) {
        (0, Some(mu), None) => Coulomb::new(mu).map(|law| Some(law.into())).map_err(about()),
        (1, Some(mu), Some(slip)) => Regularised::new(mu, slip)
            .map(|law| Some(law.into()))
            .map_err(about()),
        (2, Some(c), None) => Viscous::new(c).map(|law| Some(law.into())).map_err(about()),
        (3, None, None) => Ok(Some(NoSlip.into())),
        _ => Err(section.refused(
            "friction_law",
            "\"coulomb\" and \"viscous\" need `friction`, \"smoothed\" `friction_slip` as well, \"no-slip\" neither",
        )),
    }
}

fn resistance(section: &Section<'_>) -> Result<Option<Effect>> {
    const LENGTH: &str = "a coefficient in m s";
    let rolling = section.optional_not_negative("rolling_resistance", LENGTH)?;
    let pivoting = section.optional_not_negative("pivoting_resistance", LENGTH)?;
    if rolling.is_none() && pivoting.is_none() {
        return Ok(None);
    }
    Resistance::new(rolling.unwrap_or(0.0), pivoting.unwrap_or(0.0))
        .map(|law| Some(law.into()))
        .map_err(section.about("rolling_resistance"))
}
