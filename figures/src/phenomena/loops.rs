//! The turn as an area in the shape plane, for the swivel and the cat (tutorial 1.1).

use spinning_bodies::phenomena::{EqualHalves, Hub, ShapePlane, Step, Swivel, Waist, turn_within};

use super::body::RATIO;
use super::swivel::{IN, LOWER, OUT};
use crate::prelude::*;

parameters! {
    BEND: "forward", r"\gamma", "°", "bend of the cat forward", [70.0, 115.0], 90.0, dragged(|values| cat_at(values.of(&BEND).to_radians(), 0.0));
}

/// The parameters of the two loops; the handle is the far end of the cat's.
pub const SHAPE_LOOPS: &[Parameter] = &[OUT, IN, LOWER, BEND];

/// The swivel's plane: ψ to the right, A upward.
const PLANE: Frame = Frame::linear([0.0, 2.0], [0.0, 2.5], [62.0, 262.0, 270.0, 50.0]);
/// The cat's disc: the bend from the middle.
const CENTER: Point = [431.0, 164.0];
const RADIUS: f64 = 124.0;
const WIDEST: f64 = 2.0 * PI / 3.0;

fn cat_at(bend: f64, psi: f64) -> Point {
    polar(CENTER, RADIUS * bend / WIDEST, psi)
}

/// Two planes, two loops.
pub fn shape_loops(values: &Values) -> Result<Figure> {
    let waist = Waist {
        upper_arms_out: values.of(&OUT),
        upper_arms_in: values.of(&IN),
        lower: values.of(&LOWER),
    };
    let plane = Swivel { lower: waist.lower };
    let cat = EqualHalves::new(1.0, RATIO)?;
    let forward = values.of(&BEND).to_radians();
    // The bend that makes a half turn, or the forward bend where none is enough.
    let back = cat.back_bend_for_half_turn(forward)?.unwrap_or(forward);
    let path = |s: f64| Step {
        shape: [0.5 * (forward + back) + 0.5 * (forward - back) * s.cos(), s],
        rate: [-0.5 * (forward - back) * s.sin(), 1.0],
    };
    let round = || spaced([0.0, TAU], 240).map(|s| path(s).shape);
    let turn = turn_within(&cat, path, Hub::Pole)?.to_degrees();
    let net = waist.swivel_angle(FRAC_PI_2)?.to_degrees();
    let [below, out, near] = briefs([waist.lower, waist.upper_arms_out, waist.upper_arms_in]);
    let [held, holds] = [3, 1].map(|digits| number(net.abs(), digits));
    let widest = number(WIDEST.to_degrees(), 0);
    let bent = brief(forward.to_degrees());
    let [behind, backward] = [2, 1].map(|digits| number(back.to_degrees(), digits));
    let charge = short(turn.abs(), 4);
    let words = words!(
        "The turn is the shading that the loop of shapes encloses.",
        "Left, the swivel: twist $\\psi$ to the right, moment $A$ of the upper body upward, density $B/(A+B)^2$, $B = {below}$ kg m²; the rectangle of one cycle, arms out {out} \
         kg m² and in {near} kg m², holds {held}°. Right, the cat seen along its spine: bend $\\gamma$ outward to {widest}°, direction $\\psi$ around; the loop goes {bent}° \
         forward and {behind}° backward, and holds {charge}°.",
        "Left, a plane shaded darker towards small moments of inertia, with a rectangular loop run through in four strokes, which holds {holds} degrees. Right, a disc \
         shaded in rings, with an oval loop around its centre that reaches out to {bent} degrees on one side and to {backward} on the other."
    );
    let made = figure("shape-loops", 344.0, words, |pen| {
        // Densities relative to the greatest shown.
        const BANDS: u32 = 75;
        let ([left, right], [bottom, top]) = (PLANE.x.ends, PLANE.y.ends);
        let (least, greatest) = (0.0, PLANE.y.shown[1]);
        let most = plane.curvature(least);
        for k in 0..BANDS {
            let band = |k: u32| least + (greatest - least) * f64::from(k) / f64::from(BANDS);
            let (low, high) = (band(k), band(k + 1));
            let tone = 0.4 * plane.curvature(0.5 * (low + high)) / most;
            let band = boxed(PLANE.at(0.0, low), PLANE.at(2.0, high));
            pen.fill(band, Ink, tone);
        }
        let axis = inked(AXIS);
        pen.line([[left, top], [left, bottom], [right, bottom]], axis);
        pen.label([right, bottom + 24.0], End, "*ψ*");
        pen.label([left, top - 9.0], Middle, "*A*");
        pen.tick_below(PLANE.at(FRAC_PI_2, 0.0), 22.0, "90°");
        let (out, near) = (waist.upper_arms_out, waist.upper_arms_in);
        // Their names need a little more than the least difference.
        let heights = spread([out, near].map(|upper| PLANE.y.at(upper)), 16.0);
        for (height, name) in heights.into_iter().zip(["out", "in"]) {
            pen.tick_beside([left, height], name);
        }
        let corners = boxed(PLANE.at(0.0, out), PLANE.at(FRAC_PI_2, near));
        pen.outline(corners, inked(DATA));
        for k in 0..4 {
            let (a, b) = (corners[k], corners[(k + 1) % 4]);
            pen.arrow(between(a, b, 0.42), between(a, b, 0.6), inked(DATA));
        }
        // Inside, or beside a flat rectangle.
        let middle = between(corners[0], corners[2], 0.5);
        let (at, anchor) = match corners[3][1] - corners[0][1] > 34.0 {
            true => ([middle[0], middle[1] + 6.0], Middle),
            false => ([corners[1][0] + 10.0, middle[1] + 6.0], Start),
        };
        let text = format!("{}°", number(net.abs(), 1));
        pen.label(at, anchor, &text);
        pen.label([162.0, 334.0], Middle, "the swivel");

        // Charge per area of the flat disc: a′(γ)/γ.
        const RINGS: u32 = 24;
        let density = |bend: f64| cat.curvature(bend) / bend;
        let bends = || (0..RINGS).map(|k| WIDEST * (f64::from(k) + 0.5) / f64::from(RINGS));
        let greatest = bends().map(density).fold(0.0, f64::max);
        for bend in bends() {
            let half = 0.5 * WIDEST / f64::from(RINGS);
            let ring = |at: f64| spaced([0.0, TAU], 60).map(move |psi| cat_at(at, psi));
            let mut outline: Vec<Point> = ring(bend + half).collect();
            outline.extend(ring(bend - half).collect::<Vec<_>>().into_iter().rev());
            pen.fill(&outline, Ink, 0.4 * density(bend) / greatest);
        }
        pen.ring(CENTER, RADIUS, axis);
        let oval = round().map(|[bend, psi]| cat_at(bend, psi));
        let oval: Vec<Point> = oval.collect();
        pen.line([cat_at(0.0, 0.0), cat_at(forward, 0.0)], inked(SECONDARY));
        pen.line(&oval, inked(DATA));
        pen.arrow(oval[52], oval[60], inked(DATA));
        for degrees in [30.0_f64, 60.0, 90.0] {
            let radius = RADIUS * degrees.to_radians() / WIDEST;
            pen.ring(CENTER, radius, inked(AXIS).alpha(0.5).dotted());
            let round =
                (0..40).map(|k| polar(CENTER, radius + 12.0, -0.62 * PI - 0.12 * f64::from(k)));
            let text = format!("{}°", number(degrees, 0));
            pen.name(round, &text, small(Ink));
        }
        pen.dot(CENTER, 3.6);
        pen.note([CENTER[0] + RADIUS + 5.0, CENTER[1] - 8.0], Start, "belly");
        pen.note([CENTER[0] - RADIUS - 6.0, CENTER[1] - 8.0], End, "back");
        pen.label([CENTER[0], 334.0], Middle, "the cat");
    });
    // ψ and A of the corners, ψ and γ of the oval.
    let columns = "direction (°) | moment (kg m²) | bend (°)";
    let (out, near) = (waist.upper_arms_out, waist.upper_arms_in);
    let corners = boxed([0.0, out], [90.0, near]).map(|[psi, upper]| [psi, upper, 0.0]);
    let bends = round().map(|[bend, psi]| [psi.to_degrees(), 0.0, bend.to_degrees()]);
    Ok(made
        .data("swivel", columns, corners)
        .data("cat", columns, bends))
}
