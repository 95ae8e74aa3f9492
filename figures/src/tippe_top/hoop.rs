//! Pictures i and j: why the clay goes up.

use spinning_bodies::frame::SpaceVector;
use spinning_bodies::tippe_top::HoopWithClay;

use super::toys::*;
use crate::prelude::*;

const OFFSET: Parameter = ALPHA.between([0.25, 0.7], 0.42);
parameters! {
    LOW: "low", r"\theta_1", "°", "tilt with the clay below the horizontal", [15.0, 80.0], 42.0, dragged(|values| clay(0, values));
    HIGH: "high", r"\theta_2", "°", "tilt with the clay above the horizontal", [100.0, 165.0], 128.0, dragged(|values| clay(1, values));
}
/// The parameters; the clay is dragged.
pub const HOOP: &[Parameter] = &[OFFSET, LOW, HIGH, TURNS.between([1.0, 100.0], 50.0)];

/// Radius of the hoop, units.
const RADIUS: f64 = 104.0;
/// Level of the table, and where the hoops stand on it.
const FLOOR: f64 = 272.0;
const PLACES: [f64; 2] = [158.0, 446.0];
/// The estimate holds if the slip keeps its direction, which needs at least this εΩ² in units of μg.
const SURE: f64 = 10.0;

fn center(k: usize) -> Point {
    [PLACES[k], FLOOR - RADIUS]
}

/// The place of the lump on the rim.
fn clay(k: usize, values: &Values) -> Point {
    let tilt = values.of([&LOW, &HIGH][k]).to_radians();
    polar(center(k), RADIUS, 1.5 * PI - tilt)
}

/// Friction's torque pushes the clay up, below the horizontal and above it.
pub fn hoop_with_clay(values: &Values) -> Result<Figure> {
    let hoop: HoopWithClay = toy(values.of(&OFFSET), 1.0 / 3.0)?;
    let spin = TAU * values.of(&TURNS);
    let degrees = values.each([LOW, HIGH]);
    let tilts = degrees.map(f64::to_radians);
    let slips = tilts.map(|tilt| hoop.slip(tilt, spin));
    let torques = tilts.map(|tilt| hoop.torque(tilt));
    let force = hoop.validity(spin);
    let claim = if force >= SURE {
        "Friction at ⊙ pushes the clay up, below the horizontal and above it.".to_owned()
    } else {
        format!(
            "So slow a spin need not push the clay up: it swings the hoop about with {} times the force of friction, and the slip turns with it.",
            number(force, 2)
        )
    };
    let dips = torques.map(|n| (n.z() / n.x()).atan().to_degrees());
    let ([low, high], [dip, dive]) = (briefs(degrees), numbers(dips, 0));
    let turns = match brief(values.of(&TURNS)).as_str() {
        "1" => "once".to_owned(),
        turns => format!("{turns} times"),
    };
    let [first, second] = numbers(slips.map(|slip| slip.y()), 2);
    let off = brief(values.of(&OFFSET));
    let words = words!(
        "{claim}",
        "Pictures i and j of the tutorial. The hoop spins anticlockwise from above, {turns} a second. At tilts of {low}° and {high}° the contact plunges into the page, with \
         {first} and {second} m/s if $CK$ is {off} of $R$; so friction comes out of it. Its torque $N$ about $C$ points left and {dip}° and {dive}° down, and turns $CK$ away \
         from $L$.",
        "Two hoops on a table, seen along it, each with a lump of clay on its rim. On the left the clay is low and to the left, on the right \
         high and to the left. K is the hoop's centre, C lies between K and the clay. The vertical arrow L and the axis from C through K \
         enclose the angle theta, {low} and {high} degrees. Below K, where the hoop touches the table, friction comes out of the page. \
         A torque arrow points left from C and down, in both pictures."
    );
    let made = figure("hoop-with-clay", 314.0, words, |pen| {
        pen.line([[14.0, FLOOR], [586.0, FLOOR]], inked(SECONDARY));
        for k in 0..2 {
            one(pen, center(k), values.of(&OFFSET), (tilts[k], torques[k]));
        }
    });
    let columns = "tilt (°) | slip (m/s) | torque to the right (N m) | torque upwards (N m)";
    let row = |k: usize| [degrees[k], slips[k].y(), torques[k].x(), torques[k].z()];
    Ok(made
        .data("clay below", columns, [row(0)])
        .data("clay above", columns, [row(1)]))
}

fn one(pen: &mut Pen, k: Point, alpha: f64, (tilt, torque): (f64, SpaceVector)) {
    let (s, c) = tilt.sin_cos();
    let along = |d: f64| [k[0] + d * s, k[1] - d * c];
    let mass = along(-alpha * RADIUS);
    pen.ring(k, RADIUS, inked(3.0));
    // The clay: a lump on the inside of the rim, on the side of C.
    let down = FRAC_PI_2 - tilt + PI;
    let mut lump = crate::style::arc(k, RADIUS - 1.0, down - 0.34, down + 0.34);
    lump.extend((-20..=20).rev().map(|step| {
        let part = f64::from(step) / 20.0;
        let out = (1.0 - 0.21 * (1.0 - part * part)) * RADIUS - 1.0;
        polar(k, out, down + 0.34 * part)
    }));
    pen.fill(&lump, Ink, 0.6);
    // The axis, not through the table.
    let reach = (1.22 * RADIUS).min(0.96 * RADIUS / (-c).max(1e-3));
    pen.line([along(-RADIUS), along(reach)], inked(AXIS).dotted());
    let top = k[1] - 1.22 * RADIUS;
    pen.line([mass, [mass[0], top + 30.0]], muted(HAIR));
    let tip = shifted(mass, [0.0, -0.86 * RADIUS]);
    pen.arrow(mass, tip, stroke(AngularMomentum, DATA));
    let beside = [[-14.0, -82.0], [-14.0, -66.0], [14.0, -82.0], [14.0, -66.0]];
    let places = beside.map(|beside| shifted(mass, beside));
    pen.name(places, "*L*", label(AngularMomentum));
    pen.arc(mass, 34.0, FRAC_PI_2 - tilt, FRAC_PI_2, inked(AXIS));
    let half = FRAC_PI_2 - 0.5 * tilt;
    // The torque, in the plane of the picture.
    let scale = 0.5 * RADIUS / torque.norm();
    let tip = planned(mass, scale, [torque.x(), torque.z()]);
    pen.arrow(mass, tip, stroke(Torque, DATA));
    // Letters stand off the axis, which falls to the right where the clay is above.
    let above = tilt > FRAC_PI_2;
    let beside = if above { 16.0 } else { -14.0 };
    let places = [beside, -beside].map(|beside| {
        let on = [0.5, 0.3, 0.8].map(|share| between(mass, tip, share));
        on.map(|at| shifted(at, [-4.0, beside]))
    });
    pen.name(places.concat(), "*N*", label(Torque));
    pen.dot(mass, 4.0);
    pen.dot(k, 4.0);
    pen.name(
        [46.0, 58.0, 70.0].map(|far| polar(mass, far, half)),
        "*θ*",
        label(Ink),
    );
    let c = [shifted(mass, [14.0, 14.0]), polar(mass, 17.0, half)][usize::from(above)];
    let beside = if above { [-12.0, 17.0] } else { [17.0, 14.0] };
    pen.name([c], "*C*", label(Ink));
    pen.name([shifted(k, beside)], "*K*", label(Ink));
    let foot = shifted(k, [0.0, RADIUS]);
    pen.disc(foot, 7.5, Ink, 0.18);
    pen.ring(foot, 7.5, inked(1.4));
    pen.dot(foot, 2.2);
    let place = shifted(foot, [0.0, 29.0]);
    pen.note(place, Middle, "friction, out of the page");
}
