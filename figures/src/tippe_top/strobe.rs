//! Strobed pictures of the chiral top, both ways.

use spinning_bodies::Result;
use spinning_bodies::scene::contact::State;

use super::ball::{ball, table};
use super::{CHIRAL_SPIN, chiral_scene, run};
use crate::Figure;
use crate::style::{Anchor, DATA, Pen, Role, Words, figure, label, number, small, stroke};

/// Pictures of a row, and seconds between them.
const PICTURES: u32 = 7;
const STEP: f64 = 0.3;
const RADIUS: f64 = 36.0;

/// Seven looks at one top, spun one way and the other.
pub fn strobed() -> Result<Figure> {
    let tilt = 3_f64.to_radians();
    let end = STEP * f64::from(PICTURES - 1);
    let rows = [-1.0, 1.0].map(|sense| {
        run(
            &chiral_scene(sense * CHIRAL_SPIN, tilt, 0.0)?,
            end,
            PICTURES - 1,
            1e-2,
        )
    });
    let [over, stays] = rows;
    let (over, stays) = (over?, stays?);
    let words = Words {
        claim: "Seven looks at one top: clockwise above, anticlockwise below.".to_owned(),
        details: format!(
            "The runs of the last figure every {} s. The dark cap is on the light side of the ball, so it is on top at the start and at the \
             bottom at the end of the upper row. Under each ball its tilt.",
            number(STEP, 1),
        ),
        alt: "Two rows of seven balls with a dark cap. In the upper row the cap wobbles, tips to the side in the sixth picture and is at the bottom in \
              the last. In the lower row it stays on top, but for a small wobble."
            .to_owned(),
    };
    Ok(figure("chiral-strobe", 300.0, words, |pen| {
        row(pen, &over, 106.0, "clockwise", Role::Omega);
        row(pen, &stays, 240.0, "anticlockwise", Role::AngularMomentum);
    }))
}

fn row(pen: &mut Pen, rows: &[(f64, State)], floor: f64, name: &str, role: Role) {
    table(pen, 8.0, 592.0, floor);
    pen.text(
        [10.0, floor - 2.0 * RADIUS - 14.0],
        Anchor::Start,
        name,
        label(role),
    );
    let x = 116.0;
    let y = floor - 2.0 * RADIUS - 19.0;
    let arrow = stroke(role, DATA);
    let from = if name.len() > 9 { x + 10.0 } else { x - 22.0 };
    let (a, b) = ([from, y], [from + 34.0, y]);
    if name.len() > 9 {
        pen.arrow(a, b, arrow);
    } else {
        pen.arrow(b, a, arrow);
    }
    for (k, (time, state)) in rows.iter().enumerate() {
        let center = [50.0 + 83.3 * k as f64, floor - RADIUS];
        ball(pen, &state.attitude, center, RADIUS, 0.6);
        let text = format!("{}°", number(state.tilt().to_degrees(), 0));
        pen.text(
            [center[0], floor + 20.0],
            Anchor::Middle,
            &text,
            small(Role::Ink),
        );
        if floor > 200.0 {
            let text = format!("{} s", number(*time, 1));
            pen.text(
                [center[0], floor + 42.0],
                Anchor::Middle,
                &text,
                small(Role::Muted),
            );
        }
    }
}
