//! The box of gas that proves Pythagoras (tutorial 9.1).

use spinning_bodies::pythagoras::GasBox;

use crate::prelude::*;

/// The figures of the chapter, in its order.
pub const FIGURES: &[Entry] = &[of("gas-box", &[AR, RB, ANGLE], gas_box)];

parameters! {
    AR: "ar", "AR", "", "side from the hinge", [1.0, 5.0], 4.0, dragged(|values| corner(values, 1));
    RB: "rb", "RB", "", "the other side at R", [1.0, 5.0], 3.0;
    ANGLE: "angle", r"\gamma", "°", "angle at R", [30.0, 150.0], 90.0, dragged(|values| corner(values, 2));
}

/// Units for the force on a side of length one, over those for the length.
const FORCE: f64 = 2.0 / 7.0;

/// The box, and where it stands in the picture.
struct Drawn {
    gas: GasBox,
    /// A, R and B, in units of the box.
    base: [Point; 3],
    /// Units of the design for a unit of length.
    length: f64,
    /// The hinge, units.
    hinge: Point,
}

impl Drawn {
    /// The box, as large as its arrows and arms allow.
    fn of(values: &Values) -> Result<Self> {
        let [ar, rb, angle] = values.each([AR, RB, ANGLE]);
        let gamma = angle.to_radians();
        let base = [
            [0.0, 0.0],
            [ar, 0.0],
            [ar - rb * gamma.cos(), rb * gamma.sin()],
        ];
        let gas = GasBox::from_sides(ar, rb, gamma)?;
        let mut box_of = base.to_vec();
        for (k, from) in base.into_iter().enumerate() {
            let to = base[(k + 1) % 3];
            let out = [to[1] - from[1], to[0] - from[0]];
            box_of.push(planned(between(from, to, 0.5), FORCE, out));
        }
        // The foot of the line of force through the middle of RB.
        let arm = 0.5 * rb - ar * gamma.cos();
        box_of.push([-arm * gamma.cos(), arm * gamma.sin()]);
        let [[left, right], [bottom, top]] = [0, 1].map(|k| extent(box_of.iter().map(|p| p[k])));
        let length = (436.0 / (right - left))
            .min(276.0 / (top - bottom))
            .min(70.0);
        let middle = 0.5 * length * (right + left);
        Ok(Self {
            gas,
            base,
            length,
            hinge: [300.0 - middle, 372.0 + length * bottom],
        })
    }

    fn corners(&self) -> [Point; 3] {
        self.base.map(|p| planned(self.hinge, self.length, p))
    }
}

fn corner(values: &Values, k: usize) -> Point {
    Drawn::of(values).map_or([0.0; 2], |drawn| drawn.corners()[k])
}

/// A triangular box of gas hinged at A, the forces on its sides, their arms and torques.
pub fn gas_box(values: &Values) -> Result<Figure> {
    let drawn = Drawn::of(values)?;
    let gas = drawn.gas;
    let (sides, arms, torques) = (gas.sides(), gas.arms(), gas.side_torques());
    let arms = [arms.ar, arms.rb, arms.ab];
    let torques = [torques.ar, torques.rb, torques.ab];
    let shown = torques.map(halves);
    let defect = gas.right_angle_defect();
    let right = defect.abs() < 1e-12 * sides[2] * sides[2];
    let (theorem, half, so) = match right {
        true => (
            "theorem of Pythagoras",
            ", half the side each time",
            ", so the squares over the legs make up the square over the hypotenuse",
        ),
        false => ("law of cosines", "", ""),
    };
    let law = match right {
        true => "that is $\\tfrac12 AR^2$, $\\tfrac12 RB^2$ and $\\tfrac12 AB^2$ with their signs"
            .to_owned(),
        false => format!(
            "that is $\\tfrac12 AR^2$, $\\tfrac12 RB^2-AR\\cdot RB\\cos\\gamma$ and $\\tfrac12 AB^2$ with their signs, where $AR^2+RB^2-AB^2={}$",
            halves(defect).replace('\u{2212}', "-")
        ),
    };
    let angle = brief(values.of(&ANGLE));
    let turns = match torques[1] < 0.0 {
        true => "clockwise",
        false => "anticlockwise",
    };
    let [ar, rb, ab] = briefs(sides);
    let [arm_ar, arm_rb, arm_ab] = arms.map(halves);
    let [first, second, third] = &shown;
    let [one, two] = [first, second].map(|torque| torque.replace('\u{2212}', "-"));
    let sum = short(torques.iter().sum(), 2);
    let words = words!(
        "A box of gas does not start to turn by itself, and that is the {theorem}.",
        "Sides $AR = {ar}$, $RB = {rb}$, $AB = {ab}$, $\\gamma = {angle}$° at $R$. The gas pushes on each side with a force proportional to its length, \
         at its middle; the arms about the hinge $A$ are {arm_ar}, {arm_rb} and {arm_ab}{half}. Torques \
         ${one}$, ${two}$ and ${third}$, {law}; the sum is ${sum}$.",
        "A triangle A R B with an angle of {angle} degrees at R and a hinge at A, filled with gas. Small arrows \
         press on every side; at the middle of each side a large arrow shows the whole force. The force on AR turns the box clockwise with torque {first}, that on RB {turns} \
         with {second}, that on AB turns it back with {third}. They cancel{so}."
    );

    let corners @ [a, r, b] = drawn.corners();
    let made = figure("gas-box", 404.0, words, |pen| {
        pen.fill([a, r, b], Ink, 0.06);

        // Ends of each side, run along with the gas at the left.
        let around = [(a, r, sides[0]), (r, b, sides[1]), (b, a, sides[2])];
        for (from, to, length) in around {
            let outward = outward(from, to);
            let count = (2.0 * length) as u32;
            for k in 0..count {
                let t = (f64::from(k) + 0.5) / f64::from(count);
                let on = between(from, to, t);
                let inside = [on[0] - 17.0 * outward[0], on[1] - 17.0 * outward[1]];
                // Near a corner there is no room for one.
                if !well_inside(inside, [a, r, b]) {
                    continue;
                }
                let style = inked(HAIR).alpha(0.55);
                pen.arrow(inside, [on[0] - outward[0], on[1] - outward[1]], style);
            }
        }

        // Arms: from the hinge to the foot of each line of force.
        let (middle, [u, v]) = (between(r, b, 0.5), outward(r, b));
        let along = (a[0] - middle[0]) * u + (a[1] - middle[1]) * v;
        let foot = [middle[0] + along * u, middle[1] + along * v];
        let feet = [between(a, r, 0.5), foot, between(b, a, 0.5)];
        pen.line([feet[1], between(r, b, 0.5)], stroke(Torque, AXIS).dotted());
        for foot in feet {
            pen.line([a, foot], stroke(Torque, 8.0).alpha(0.35));
        }
        pen.outline([a, r, b], inked(DATA));
        if right {
            let square = [[-13.0, 0.0], [-13.0, -13.0], [0.0, -13.0]];
            pen.line(square.map(|corner| shifted(r, corner)), inked(AXIS));
        } else {
            let to = PI - values.of(&ANGLE).to_radians();
            pen.arc(r, 20.0, PI, to, inked(AXIS));
        }

        // The hinge, and the sense of each torque.
        pen.dot(a, 5.0);
        pen.ring(a, 9.5, inked(SECONDARY));
        // Each corner's letter stands away from the middle of the box.
        let middle = between(a, between(r, b, 0.5), 2.0 / 3.0);
        for (corner, name) in corners.into_iter().zip(["*A*", "*R*", "*B*"]) {
            let out = between(corner, middle, -26.0 / distance(corner, middle));
            pen.label(shifted(out, [0.0, 6.0]), Middle, name);
        }
        for (k, (from, to, length)) in around.into_iter().enumerate() {
            let middle = between(from, to, 0.5);
            let outward = outward(from, to);
            let reach = FORCE * drawn.length * length;
            let tip = shifted(middle, outward.map(|part| reach * part));
            pen.arrow(middle, tip, inked(2.8));
            let sign = if torques[k] > 0.0 { "+" } else { "" };
            let text = format!("{sign}{}", shown[k]);
            // Beyond the tip, level with it where the arrow is more level than steep, or further round.
            let half = 10.0 + 4.6 * text.chars().count() as f64;
            let [side, down] = [outward[0] * half, outward[1].signum() * 16.0];
            let mut places = vec![[0.0, down], [side.signum() * half, 0.0]];
            if outward[1].abs() < 0.75 {
                places.swap(0, 1);
            }
            let further = [half, -half]
                .map(|across| [0.0, down, -down, -2.0 * down].map(|y| [1.2 * across, y]));
            places.extend(further.concat());
            let places = places.into_iter().map(|beside| shifted(tip, beside));
            pen.name(places, &text, sized(Torque, 20.0));
        }
        let sign = |k: usize| match shown[k].strip_prefix('\u{2212}') {
            Some(rest) => format!("\u{2212} {rest}"),
            None => format!("+ {}", shown[k]),
        };
        let sum = format!("{} {} {} = 0", shown[0], sign(1), sign(2));
        pen.text([30.0, 32.0], Start, "torques about *A*", label(Torque));
        pen.text([30.0, 58.0], Start, &sum, sized(Torque, 18.0));
    });
    let columns = "side | arm | torque";
    let rows = |k: usize| [[sides[k], arms[k], torques[k]]];
    Ok(made
        .data("AR", columns, rows(0))
        .data("RB", columns, rows(1))
        .data("AB", columns, rows(2)))
}

/// The unit vector out of the box across a side that is run along with the gas at the left.
fn outward(from: Point, to: Point) -> Point {
    let length = distance(to, from);
    [(from[1] - to[1]) / length, (to[0] - from[0]) / length]
}

/// Whether a point is more than a few units from every side of a triangle, corners anticlockwise on the page.
fn well_inside(p: Point, corners: [Point; 3]) -> bool {
    (0..3).all(|k| {
        let (a, b) = (corners[k], corners[(k + 1) % 3]);
        let (u, v) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
        (u[1] * v[0] - u[0] * v[1]) / u[0].hypot(u[1]) > 9.0
    })
}

/// A multiple of one half as a whole number or a fraction, anything else with two decimals.
fn halves(value: f64) -> String {
    let doubled = (2.0 * value).round();
    if (2.0 * value - doubled).abs() > 1e-9 {
        number(value, 2)
    } else if doubled % 2.0 == 0.0 {
        number(value, 0)
    } else {
        format!("{}/2", number(doubled, 0))
    }
}
