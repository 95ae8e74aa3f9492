//! Pictures i and j: why the clay goes up.

use spinning_bodies::Result;
use spinning_bodies::frame::SpaceVector;

use super::{TOY_SPIN, toy};
use crate::Figure;
use crate::style::{
    AXIS, Anchor, DATA, HAIR, Pen, Point, Role, SECONDARY, Words, figure, label, number, polar,
    small, stroke,
};

/// Radius of the hoop, units; how far C is from K in the picture, over the radius.
const RADIUS: f64 = 104.0;
const ALPHA: f64 = 0.42;
/// Level of the table.
const FLOOR: f64 = 318.0;

/// Friction's torque pushes the clay up, below the horizontal and above it.
pub fn hoop_with_clay() -> Result<Figure> {
    let hoop = toy(ALPHA)?;
    let tilts = [42_f64.to_radians(), 128_f64.to_radians()];
    let slips = tilts.map(|tilt| hoop.slip(tilt, TOY_SPIN));
    let torques = tilts.map(|tilt| hoop.torque(tilt));
    let words = Words {
        claim: "Friction at ⊙ pushes the clay up, below the horizontal and above it.".to_owned(),
        details: format!(
            "Pictures i and j of the tutorial. The hoop spins about the vertical, anticlockwise from above. At tilts of 42° and 128° the \
             contact plunges into the page, with {} and {} m/s in the toy if $CK$ were {} of $R$; so friction comes out of it, and its \
             torque about $C$ points left and {}° and {}° down. It turns the axis $CK$ away from $L$ both times.",
            number(slips[0].y(), 2),
            number(slips[1].y(), 2),
            number(ALPHA, 2),
            number((torques[0].z() / torques[0].x()).atan().to_degrees(), 0),
            number((torques[1].z() / torques[1].x()).atan().to_degrees(), 0),
        ),
        alt: "Two hoops on a table, seen along it, each with a lump of clay on its rim. On the left the clay is low and to the left, on the right \
              high and to the left. K is the hoop's centre, C lies between K and the clay. The vertical arrow L and the axis from C through K \
              enclose the angle theta. Below K, where the hoop touches the table, friction comes out of the page. \
              A torque arrow points left from C and slightly down, in both pictures."
            .to_owned(),
    };
    Ok(figure("hoop-with-clay", 366.0, words, |pen| {
        pen.line(
            &[[14.0, FLOOR], [586.0, FLOOR]],
            stroke(Role::Ink, SECONDARY),
        );
        for (k, x) in [158.0, 446.0].into_iter().enumerate() {
            one(pen, [x, FLOOR - RADIUS], tilts[k], torques[k]);
        }
    }))
}

fn one(pen: &mut Pen, k: Point, tilt: f64, torque: SpaceVector) {
    let (s, c) = tilt.sin_cos();
    let along = |d: f64| [k[0] + d * s, k[1] - d * c];
    let mass = along(-ALPHA * RADIUS);
    pen.ring(k, RADIUS, stroke(Role::Ink, 3.0));
    // The clay: a lump on the inside of the rim, on the side of C.
    let down = core::f64::consts::FRAC_PI_2 - tilt + core::f64::consts::PI;
    let mut lump = crate::style::arc(k, RADIUS - 1.0, down - 0.34, down + 0.34);
    lump.extend((-20..=20).rev().map(|step| {
        let part = f64::from(step) / 20.0;
        polar(
            k,
            (1.0 - 0.21 * (1.0 - part * part)) * RADIUS - 1.0,
            down + 0.34 * part,
        )
    }));
    pen.fill(&lump, Role::Ink, 0.6);
    pen.line(
        &[along(-RADIUS), along(1.22 * RADIUS)],
        stroke(Role::Ink, AXIS).dotted(),
    );
    let top = k[1] - 1.22 * RADIUS;
    pen.line(
        &[[mass[0], mass[1]], [mass[0], top + 30.0]],
        stroke(Role::Muted, HAIR),
    );
    pen.arrow(
        mass,
        [mass[0], mass[1] - 0.86 * RADIUS],
        stroke(Role::AngularMomentum, DATA),
    );
    pen.text(
        [mass[0] - 8.0, mass[1] - 0.74 * RADIUS],
        Anchor::End,
        "*L*",
        label(Role::AngularMomentum),
    );
    pen.arc(
        mass,
        34.0,
        core::f64::consts::FRAC_PI_2 - tilt,
        core::f64::consts::FRAC_PI_2,
        stroke(Role::Ink, AXIS),
    );
    let half = core::f64::consts::FRAC_PI_2 - 0.5 * tilt;
    let [x, y] = polar(mass, 46.0, half);
    pen.text([x, y + 5.0], Anchor::Middle, "*θ*", label(Role::Ink));
    // The torque, in the plane of the picture.
    let scale = 0.62 * RADIUS / torque.norm();
    let tip = [mass[0] + scale * torque.x(), mass[1] - scale * torque.z()];
    pen.arrow(mass, tip, stroke(Role::Torque, DATA));
    pen.text(
        [tip[0] + 4.0, tip[1] + if tilt < 1.5 { -10.0 } else { 22.0 }],
        Anchor::Start,
        "*N*",
        label(Role::Torque),
    );
    pen.disc(mass, 4.0, Role::Ink, 1.0);
    pen.disc(k, 4.0, Role::Ink, 1.0);
    pen.text(
        [k[0] + 9.0, k[1] + 16.0],
        Anchor::Start,
        "*K*",
        label(Role::Ink),
    );
    pen.text(
        [mass[0] + 8.0, mass[1] + 19.0],
        Anchor::Start,
        "*C*",
        label(Role::Ink),
    );
    let foot = [k[0], k[1] + RADIUS];
    pen.disc(foot, 7.5, Role::Torque, 0.18);
    pen.ring(foot, 7.5, stroke(Role::Torque, 1.4));
    pen.disc(foot, 2.2, Role::Torque, 1.0);
    pen.text(
        [foot[0], foot[1] + 29.0],
        Anchor::Middle,
        "friction, out of the page",
        small(Role::Torque),
    );
}
