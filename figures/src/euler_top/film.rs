//! The racket's flip as a film strip (tutorial 6.3).

use spinning_bodies::Result;

use super::racket::{MOMENTS, Throw, draw, view};
use crate::Figure;
use crate::style::{AXIS, Anchor, DATA, Role, Words, figure, label, number, small, stroke};

/// Pictures, the first and the last included.
const FRAMES: usize = 9;
/// Heights of the two rows.
const ROWS: [f64; 2] = [116.0, 304.0];
const SCALE: f64 = 172.0;

/// Two throws, a degree apart.
pub fn film() -> Result<Figure> {
    let thrown = Throw::aimed()?;
    let exact = Throw::new(0.0)?;
    let time = |k: usize| thrown.flip_time() * k as f64 / (FRAMES - 1) as f64;
    let attitudes = (0..FRAMES)
        .map(|k| {
            Ok([
                exact.top.at(time(k))?.attitude,
                thrown.top.at(time(k))?.attitude,
            ])
        })
        .collect::<Result<Vec<_>>>()?;
    let degrees = thrown.tilt().to_degrees();
    let words = Words {
        claim: "Spun about its middle axis, a racket makes half a twist with every somersault."
            .to_owned(),
        details: format!(
            "Two throws at one turn a second, seen at {FRAMES} equal times. Above, exactly about the middle axis $x_2$: nothing else happens, \
             and no hand can do it. Below, with $L$ {} degrees off that axis: half a period of $\\Omega$, {} s, brings the handle \
             back and the other face to the front. One face is filled; the dot is the end of $x_2$, to which $\\Omega$ points at the throw. \
             $I = ({}, {}, {})$ kg m².",
            number(degrees, 2),
            number(thrown.flip_time(), 3),
            MOMENTS[0],
            MOMENTS[1],
            MOMENTS[2],
        ),
        alt: format!(
            "Two rows of {FRAMES} pictures of a tennis racket turning head over handle. In the upper row it turns in one plane and \
             ends as it began, the bare face to the front, the dot on the right. In the lower row, thrown {} degrees \
             differently, it twists half-way through about its handle and ends with the filled face to the front and the dot on \
             the left.",
            number(degrees, 1),
        ),
    };
    Ok(figure("racket-flip", 424.0, words, |pen| {
        let x = |k: usize| 40.0 + 62.5 * k as f64;
        let off = format!("thrown with *L* {}° off it", number(degrees, 1));
        for (y, text) in ROWS.into_iter().zip(["thrown exactly about *x*_{2}", &off]) {
            pen.text([10.0, y - 88.0], Anchor::Start, text, small(Role::Ink));
            pen.line(
                &[[10.0, y], [566.0, y]],
                stroke(Role::AngularMomentum, AXIS).dotted(),
            );
            pen.arrow([570.0, y], [594.0, y], stroke(Role::AngularMomentum, DATA));
            pen.text(
                [582.0, y - 8.0],
                Anchor::Middle,
                "*L*",
                label(Role::AngularMomentum),
            );
        }
        for (k, pair) in attitudes.iter().enumerate() {
            for (attitude, y) in pair.iter().zip(ROWS) {
                draw(pen, &view([x(k), y], SCALE), attitude, 1.0);
            }
            let text = if k == 0 {
                "0".to_owned()
            } else {
                format!("{} s", number(time(k), 2))
            };
            pen.text([x(k), 410.0], Anchor::Middle, &text, small(Role::Ink));
        }
    }))
}
