//! The box of gas that proves Pythagoras (tutorial 9.1).

use spinning_bodies::Result;
use spinning_bodies::pythagoras::GasBox;

use crate::Figure;
use crate::style::{
    AXIS, Anchor, DATA, HAIR, Point, Role, SECONDARY, Words, between, figure, label, number, sized,
    stroke,
};

/// Units of the design for a unit of length, and for the force on a side of length one.
const LENGTH: f64 = 70.0;
const FORCE: f64 = 20.0;
/// The hinge, units.
const HINGE: Point = [152.0, 292.0];

/// A triangular box of gas hinged at A, the forces on its sides, their arms and torques.
pub fn gas_box() -> Result<Figure> {
    let corners = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0]];
    let gas = GasBox::new(corners[0], corners[1], corners[2])?;
    let (sides, arms, torques) = (gas.sides(), gas.arms(), gas.side_torques());
    let arms = [arms.ar, arms.rb, arms.ab];
    let torques = [torques.ar, torques.rb, torques.ab];
    let shown = torques.map(halves);
    let total = halves(torques.iter().sum());

    let words = Words {
        claim:
            "A box of gas does not start to turn by itself, and that is the theorem of Pythagoras."
                .to_owned(),
        details: format!(
            "Sides $AR = {}$, $RB = {}$, $AB = {}$. The gas pushes on each side with a force proportional to its length, \
             at its middle; the arms about the hinge $A$ are {}, {} and {}, half the side each time. Torques \
             ${}$, ${}$ and $+{}$, that is $\\tfrac12 AR^2$, $\\tfrac12 RB^2$ and $\\tfrac12 AB^2$ with their signs; the sum \
             is ${total}$.",
            number(sides[0], 0),
            number(sides[1], 0),
            number(sides[2], 0),
            number(arms[0], 1),
            number(arms[1], 1),
            number(arms[2], 1),
            shown[0].replace('\u{2212}', "-"),
            shown[1].replace('\u{2212}', "-"),
            shown[2],
        ),
        alt: format!(
            "A right-angled triangle A R B with the right angle at R and a hinge at A, filled with gas. Small arrows \
             press on every side; at the middle of each side a large arrow shows the whole force. The forces on the \
             two legs turn the box clockwise with torques {} and {}, the force on the hypotenuse turns it back with {}. \
             They cancel, so the squares over the legs make up the square over the hypotenuse.",
            shown[0], shown[1], shown[2]
        ),
    };

    let place = |p: Point| [HINGE[0] + LENGTH * p[0], HINGE[1] - LENGTH * p[1]];
    let [a, r, b] = corners.map(place);
    Ok(figure("gas-box", 392.0, words, |pen| {
        pen.fill(&[a, r, b], Role::Ink, 0.06);

        // Ends of each side, run along with the gas at the left.
        let around = [(a, r, sides[0]), (r, b, sides[1]), (b, a, sides[2])];
        for (from, to, length) in around {
            let outward = [
                (from[1] - to[1]) / (LENGTH * length),
                (to[0] - from[0]) / (LENGTH * length),
            ];
            let count = (2.0 * length) as u32;
            for k in 0..count {
                let t = (f64::from(k) + 0.5) / f64::from(count);
                let on = between(from, to, t);
                let inside = [on[0] - 17.0 * outward[0], on[1] - 17.0 * outward[1]];
                pen.arrow(
                    inside,
                    [on[0] - outward[0], on[1] - outward[1]],
                    stroke(Role::Ink, HAIR).alpha(0.55),
                );
            }
        }

        // Arms: from the hinge to the foot of each line of force.
        let feet = [
            between(a, r, 0.5),
            [a[0], between(r, b, 0.5)[1]],
            between(b, a, 0.5),
        ];
        pen.line(
            &[feet[1], between(r, b, 0.5)],
            stroke(Role::Torque, AXIS).dotted(),
        );
        for foot in feet {
            pen.line(&[a, foot], stroke(Role::Torque, 8.0).alpha(0.35));
        }
        pen.outline(&[a, r, b], stroke(Role::Ink, DATA));
        pen.line(
            &[
                [r[0] - 13.0, r[1]],
                [r[0] - 13.0, r[1] - 13.0],
                [r[0], r[1] - 13.0],
            ],
            stroke(Role::Ink, AXIS),
        );

        let texts = [
            (12.0, 2.0, Anchor::Start),
            (9.0, 7.0, Anchor::Start),
            (10.0, 2.0, Anchor::Start),
        ];
        for (k, (from, to, length)) in around.into_iter().enumerate() {
            let middle = between(from, to, 0.5);
            let outward = [
                (from[1] - to[1]) / (LENGTH * length),
                (to[0] - from[0]) / (LENGTH * length),
            ];
            let tip = [
                middle[0] + FORCE * length * outward[0],
                middle[1] + FORCE * length * outward[1],
            ];
            pen.arrow(middle, tip, stroke(Role::Ink, 2.8));
            let sign = if torques[k] > 0.0 { "+" } else { "" };
            let (dx, dy, anchor) = texts[k];
            let text = format!("{sign}{}", shown[k]);
            pen.text(
                [tip[0] + dx, tip[1] + dy],
                anchor,
                &text,
                sized(Role::Torque, 20.0),
            );
        }
        // The hinge, and which way each torque turns.
        pen.disc(a, 5.0, Role::Ink, 1.0);
        pen.ring(a, 9.5, stroke(Role::Ink, SECONDARY));
        pen.text(
            [a[0] - 20.0, a[1] + 18.0],
            Anchor::Middle,
            "*A*",
            label(Role::Ink),
        );
        pen.text(
            [r[0] + 14.0, r[1] + 16.0],
            Anchor::Middle,
            "*R*",
            label(Role::Ink),
        );
        pen.text(
            [b[0] + 14.0, b[1] - 4.0],
            Anchor::Middle,
            "*B*",
            label(Role::Ink),
        );
        let sum = format!(
            "{} {} + {} = {total}",
            shown[0],
            shown[1].replace('\u{2212}', "\u{2212} "),
            shown[2]
        );
        pen.text(
            [40.0, 46.0],
            Anchor::Start,
            "torques about *A*",
            label(Role::Torque),
        );
        pen.text([40.0, 72.0], Anchor::Start, &sum, sized(Role::Torque, 18.0));
    }))
}

/// A multiple of one half as a whole number or a fraction, anything else with two decimals.
fn halves(value: f64) -> String {
    let doubled = 2.0 * value;
    if doubled.fract() != 0.0 {
        number(value, 2)
    } else if doubled % 2.0 == 0.0 {
        number(value, 0)
    } else {
        format!("{}/2", number(doubled, 0))
    }
}
