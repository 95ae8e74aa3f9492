//! Where to hit a billiard ball (tutorial 4.3).

mod slide;

pub use slide::lines;

use core::f64::consts::FRAC_PI_2;

use spinning_bodies::Result;
use spinning_bodies::rolling::{RoundBody, factor};

use crate::Figure;
use crate::style::{
    AXIS, Anchor, DATA, Point, Role, SECONDARY, Words, arc, figure, label, number, polar, small,
    stroke,
};

/// Five heights of the cue over the radius, and how they are written.
const HEIGHTS: [(f64, &str); 5] = [
    (0.5, "1/2"),
    (1.0, "1"),
    (1.2, "6/5"),
    (1.4, "7/5"),
    (1.8, "9/5"),
];
/// The ball: point of contact and radius, units.
const CONTACT: Point = [206.0, 318.0];
const RADIUS: f64 = 121.0;
/// Where the slip is zero, and the length of V', units.
const ZERO: f64 = 446.0;
const SPEED: f64 = 57.0;

/// The ball with five cues, and beside it the slip and the spin each of them gives.
pub fn billiard() -> Result<Figure> {
    let ball = RoundBody::new(1.0, 1.0, factor::BALL)?;
    let shots = HEIGHTS
        .map(|(height, name)| {
            ball.strike(height, 1.0)
                .map(|shot| (height, name, shot.slip(), shot.rim_speed()))
        })
        .into_iter()
        .collect::<Result<Vec<_>>>()?;
    let sweet = ball.pure_rolling_height();
    let slips: Vec<String> = shots.iter().map(|shot| number(shot.2, 2)).collect();

    let words = Words {
        claim: "Hit at seven tenths of its height, a billiard ball rolls at once.".to_owned(),
        details: format!(
            "Level cue at heights $H/R = 0.5, 1, 1.2, 1.4, 1.8$ above the table. The arrows at the right are the \
             velocity of the point of contact just after the stroke, {} of the ball's velocity $V'$: a straight line in \
             $H$, zero at $H = {}\\,R$. The blue sectors show how far the ball turns while it advances by $R$: by one radian \
             if it rolls.",
            slips.join(", "),
            number(sweet, 1),
        ),
        alt: format!(
            "A ball on a table and five level cues at different heights. To the right, at the same heights, arrows for \
             the slip of the contact point: {} and {} times the ball's speed. Their tips lie on a straight line which \
             crosses zero at {} radii. Hit lower, the ball skids with too little spin or backspin; higher, with too \
             much.",
            slips[..4].join(", "),
            slips[4],
            number(sweet, 1),
        ),
    };

    let level = |height: f64| CONTACT[1] - RADIUS * height;
    let center = [CONTACT[0], level(1.0)];
    Ok(figure("billiard", 362.0, words, |pen| {
        pen.line(
            &[[10.0, CONTACT[1]], [590.0, CONTACT[1]]],
            stroke(Role::Ink, SECONDARY),
        );
        pen.disc(center, RADIUS, Role::Shade, 0.75);
        pen.ring(center, RADIUS, stroke(Role::Ink, DATA));
        // The height of pure rolling goes across.
        pen.line(
            &[[42.0, level(sweet)], [590.0, level(sweet)]],
            stroke(Role::Ink, AXIS).dotted(),
        );
        pen.disc(center, 2.5, Role::Ink, 1.0);
        pen.line(&[center, CONTACT], stroke(Role::Ink, AXIS).alpha(0.6));
        pen.text(
            [center[0] + 8.0, center[1] + 0.55 * RADIUS],
            Anchor::Start,
            "*R*",
            label(Role::Ink),
        );

        pen.line(&[[ZERO, 48.0], [ZERO, CONTACT[1]]], stroke(Role::Ink, AXIS));
        let tip = |height: f64, slip: f64| [ZERO + SPEED * slip, level(height)];
        let (low, high) = (shots[0], shots[4]);
        pen.line(
            &[tip(low.0, low.2), tip(high.0, high.2)],
            stroke(Role::Ink, AXIS).dashed(),
        );

        for &(height, name, slip, rim_speed) in &shots {
            let y = level(height);
            let touch = CONTACT[0] - RADIUS * (1.0 - (height - 1.0).powi(2)).max(0.0).sqrt();
            let rolls = slip.abs() < 1e-9;
            let width = if rolls { 2.8 } else { SECONDARY };
            pen.arrow([42.0, y], [touch - 1.0, y], stroke(Role::Ink, width));
            let lettering = if rolls {
                label(Role::Ink).strong()
            } else {
                small(Role::Ink)
            };
            pen.text([36.0, y + 5.0], Anchor::End, name, lettering);

            let dial = [360.0, y];
            pen.ring(dial, 10.8, stroke(Role::Ink, AXIS));
            let mut sector = arc(dial, 10.8, FRAC_PI_2, FRAC_PI_2 - rim_speed);
            sector.push(dial);
            if rim_speed != 0.0 {
                pen.fill(&sector, Role::Omega, 0.25);
            }
            pen.line(
                &[dial, polar(dial, 10.8, FRAC_PI_2)],
                stroke(Role::Ink, AXIS),
            );
            pen.line(
                &[dial, polar(dial, 10.8, FRAC_PI_2 - rim_speed)],
                stroke(Role::Omega, DATA),
            );

            let end = tip(height, slip);
            if rolls {
                pen.disc(end, 5.5, Role::Ink, 1.0);
            } else {
                pen.arrow([ZERO, y], end, stroke(Role::Ink, DATA));
            }
        }
        pen.text([10.0, 30.0], Anchor::Start, "*H*/*R*", label(Role::Ink));
        pen.text([360.0, 30.0], Anchor::Middle, "spin", label(Role::Omega));
        pen.text([ZERO, 30.0], Anchor::Middle, "slip", label(Role::Ink));
        pen.text(
            [ZERO + 14.0, level(1.8) + 5.0],
            Anchor::Start,
            "turns too fast",
            small(Role::Ink),
        );
        pen.text(
            [ZERO + 14.0, level(sweet) - 6.0],
            Anchor::Start,
            "rolls",
            label(Role::Ink).strong(),
        );
        pen.text(
            [ZERO + 10.0, level(1.0) + 21.0],
            Anchor::Start,
            "turns",
            small(Role::Ink),
        );
        pen.text(
            [ZERO + 10.0, level(1.0) + 37.0],
            Anchor::Start,
            "too slowly",
            small(Role::Ink),
        );
        pen.text(
            [ZERO + 10.0, level(0.5) + 21.0],
            Anchor::Start,
            "turns backwards",
            small(Role::Ink),
        );
        let foot = CONTACT[1] + 9.0;
        for (k, name) in [
            (-1.0, "\u{2212}1"),
            (0.0, "0"),
            (1.0, "1"),
            (2.0, "2 *V*\u{2032}"),
        ] {
            let x = ZERO + SPEED * k;
            pen.line(
                &[[x, CONTACT[1]], [x, CONTACT[1] + 5.0]],
                stroke(Role::Ink, AXIS),
            );
            pen.text([x, foot + 14.0], Anchor::Middle, name, small(Role::Ink));
        }
    }))
}
