//! L leans away from Ω (tutorial 2.2): a box spun about an axis between two of its own.

use spinning_bodies::frame::BodyVector;
use spinning_bodies::inertia::shapes;

use crate::prelude::*;

parameters! {
    pub LONG: "long", "a", "m", "longest edge of the box", [4.0, 9.0], 6.0;
    pub MIDDLE: "middle", "b", "m", "middle edge of the box", [2.0, 4.0], 4.0;
    pub SHORT: "short", "c", "m", "shortest edge of the box", [0.5, 2.0], 2.0;
    DIRECTION: "direction", r"\varphi", "°", "direction of Ω, from the long edge to the short one", [0.0, 90.0], 20.0, dragged(|values| polar(CENTER, OMEGA, values.of(&DIRECTION).to_radians()));
}
/// The parameters; the tip of Ω is the handle of its direction.
pub const LEANING: [Parameter; 4] = [
    DIRECTION,
    LONG.between([6.0, 12.0], 10.0),
    MIDDLE.between([4.0, 6.0], 6.0),
    SHORT.between([0.5, 4.0], 4.0),
];

/// The centre of the box, units; units to a metre; how long Ω is drawn, and L along the short edge.
const CENTER: Point = [204.0, 268.0];
const METRE: f64 = 26.0;
const OMEGA: f64 = 196.0;
const MOMENTUM: f64 = 232.0;

/// Both arrows from one point, and the curves of their tips when Ω turns.
pub fn leaning(values: &Values) -> Result<Figure> {
    let [direction, long, middle, thin] = values.each(LEANING);
    let body = shapes::cuboid(1.0, [long, middle, thin])?;
    let inertia = body.inertia();
    let moments = inertia.principal_axes().principal_moments();
    let [smallest, _, largest] = moments.values();
    let [along_long, _, along_thin] = moments.widest_omega();
    let (worst, at_worst) = (moments.greatest_angle(), along_thin.atan2(along_long));
    let spin = |angle: f64| BodyVector::new(angle.cos(), 0.0, angle.sin());
    let momentum = |angle: f64| inertia.angular_momentum(spin(angle));
    let angle = direction.to_radians();
    let lean = inertia.angle_between_l_and_omega(spin(angle))?.to_degrees();
    let (told, shown) = (brief(direction), number(lean, 1));
    let parallel = lean < 0.05;
    let claim = match parallel {
            true => "Spun about a principal axis, the box has its angular momentum along the axis of rotation.".to_owned(),
            false => format!(
                "Spun about an axis {told}° off its long edge, the box has an angular momentum that leans {shown}° away from that axis."
            ),
        };
    let [a, b, c] = briefs([long, middle, thin]);
    let ratio = number(largest / smallest, 2);
    let [most, at] = numbers([worst, at_worst].map(f64::to_degrees), 1);
    let stands = match parallel {
        true => "lies along it".to_owned(),
        false => format!("stands {shown} degrees nearer to the short axis"),
    };
    let words = words!(
        "{claim}",
        "A box of 1 kg with edges of {a}, {b} and {c} m, seen along the middle one. Blue: $\\Omega$; orange: $L = I\\Omega$. A part along the short edge counts {ratio} times \
         one along the long edge, {largest:.2} against {smallest:.2} kg m². Dotted: where the tips go when $\\Omega$ turns; $L$ leans furthest, {most}°, for $\\Omega$ at {at}°.",
        "A rectangle, long side level, and two arrows from its middle. The blue one, the angular velocity, points {told} degrees above the long axis; the orange one, the \
         angular momentum, {stands}. Two dotted curves from axis to axis: a quarter of a circle for the blue tip, a quarter of an upright ellipse for the orange one."
    );
    let tips = |angle: f64| -> [Point; 2] {
        let l = momentum(angle) / largest * MOMENTUM;
        let l = planned(CENTER, 1.0, [l.x(), l.z()]);
        [polar(CENTER, OMEGA, angle), l]
    };
    let made = figure("leaning", 338.0, words, |pen| {
        let [half, up] = [long, thin].map(|edge| 0.5 * edge * METRE);
        let [x, y] = CENTER;
        let corners = boxed([x - half, y + up], [x + half, y - up]);
        pen.fill(corners, Ink, 0.08);
        pen.outline(corners, inked(SECONDARY));
        let axes = [[[x - 172.0, y], [x + 214.0, y]], [[x, y + 64.0], [x, 14.0]]];
        pen.lines(axes, inked(AXIS).alpha(0.6));
        let mut arrows = Vec::new();
        let names = [(Omega, "*Ω*"), (AngularMomentum, "*L*")];
        for (k, (role, name)) in names.into_iter().enumerate() {
            let path = (0..=90).map(|degrees| tips(f64::from(degrees).to_radians())[k]);
            pen.line(path.collect::<Vec<_>>(), stroke(role, AXIS).dotted());
            arrows.push((tips(angle)[k], role, name));
        }
        // The shorter one over the longer one.
        let length = |tip: Point| distance(tip, CENTER);
        arrows.sort_by(|a, b| length(b.0).total_cmp(&length(a.0)));
        for &(tip, role, _) in &arrows {
            pen.arrow(CENTER, tip, stroke(role, 2.6));
        }
        let l = momentum(angle);
        let leaned = l.z().atan2(l.x());
        pen.arc(CENTER, 46.0, angle, leaned, inked(AXIS));
        let at = [x + 222.0, y + 5.0];
        let text = format!("*I*_{{1}} = {smallest:.2} kg m²");
        pen.note(at, Start, &text);
        let text = format!("*I*_{{3}} = {largest:.2} kg m²");
        pen.note([x - 10.0, 26.0], End, &text);
        if !parallel {
            let on = |k: u32, from: f64, angle| polar(CENTER, from + 4.0 * f64::from(k), angle);
            let between = (0..40).map(|k| on(k, 66.0, 0.5 * (angle + leaned)));
            // Beside a narrow angle, if not within.
            let beside = (0..30).map(|k| shifted(on(k, 60.0, angle), [32.0, 0.0]));
            pen.name(between.chain(beside), &format!("{shown}°"), label(Ink));
        }
        // Each letter on its side of the angle, if there is room.
        for (tip, role, name) in arrows {
            let (first, way) = match role {
                Omega => (angle - FRAC_PI_2, 1.0),
                _ => (leaned + FRAC_PI_2, -1.0),
            };
            let around =
                (0..24).map(|k| polar(tip, 20.0, first + way * f64::from(k) * FRAC_PI_2 / 6.0));
            pen.name(around, name, label(role));
        }
    });
    let columns = "direction of Ω (°) | direction of L (°) | L over Ω (kg m²)";
    let row = |k: i32| {
        let l = momentum(f64::from(k).to_radians());
        let leaned = l.z().atan2(l.x()).to_degrees();
        [f64::from(k), leaned, l.norm()]
    };
    Ok(made
        .data("box", columns, (0..=90).map(row))
        .value("lean", shown)
        .value("worst", number(worst.to_degrees(), 1)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solid::Vector;

    /// Eight equal masses where the rule of Gauss puts them have the inertia of the box, whatever the library says.
    #[test]
    fn eight_masses_lean_alike() {
        for direction in [0.0_f64, 1.0, 30.0, 77.0, 90.0] {
            let values = Values::default().with(&DIRECTION, direction);
            let values = values.expect("a direction");
            let (s, c) = direction.to_radians().sin_cos();
            let omega = Vector::new(c, 0.0, s);
            let l: Vector = (0..8)
                .map(|k| Vector::from_fn(|i, _| f64::from((k >> i & 1) * 2 - 1)))
                .map(|x| x.component_mul(&Vector::new(5.0, 3.0, 2.0)) / 3.0_f64.sqrt())
                .map(|x| x.cross(&omega.cross(&x)) / 8.0)
                .sum();
            let lean = number(l.angle(&omega).to_degrees(), 1);
            let figure = leaning(&values).expect("a figure");
            assert_eq!(figure.values[0], ("lean", lean.clone()));
            assert_eq!(figure.claim.contains("leans"), lean != "0.0", "{lean}");
        }
    }
}
