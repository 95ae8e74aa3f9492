//! From sliding to rolling (tutorial 4.3): velocity and rim speed against time.

use spinning_bodies::Result;
use spinning_bodies::rolling::course::{Coulomb, Course, Load, Moment};
use spinning_bodies::rolling::{RoundBody, factor};

use crate::Figure;
use crate::style::{
    AXIS, Anchor, DATA, Role, SECONDARY, Words, figure, label, number, small, stroke,
};

const HEIGHTS: [(f64, &str); 5] = [
    (0.2, "1/5"),
    (0.7, "7/10"),
    (1.0, "1"),
    (1.4, "7/5"),
    (1.8, "9/5"),
];
const LEFT: f64 = 62.0;
const RIGHT: f64 = 492.0;
const ZERO: f64 = 196.0;
const METRE: f64 = 40.0;
const UNTIL: f64 = 1.0;

/// V and RΩ for five heights of the cue, meeting where rolling begins.
pub fn lines() -> Result<Figure> {
    let ball = RoundBody::new(0.17, 0.028_575, factor::BALL)?;
    let friction = Coulomb::new(0.2)?;
    let courses = HEIGHTS
        .iter()
        .map(|&(height, name)| {
            let shot = ball.strike(height, 2.0)?;
            let start = Moment {
                slip: shot.slip(),
                ..Moment::moving(shot.velocity(), shot.rim_speed())
            };
            let effects = (Some(friction), None, None);
            let course = Course::new(factor::BALL, Load::weight(9.81), effects, start, UNTIL)?;
            Ok((name, course))
        })
        .collect::<Result<Vec<_>>>()?;
    let finals: Vec<String> = courses
        .iter()
        .map(|(_, course)| number(course.at(UNTIL).velocity, 2))
        .collect();
    let words = Words {
        claim: "Wherever the cue strikes, velocity and rim speed meet, and from then on the ball rolls.".to_owned(),
        details: format!(
            "Ball struck at heights $H$ to the same velocity of 2 m/s, friction $\\mu = 0.2$. Black: velocity $V$ of the centre; blue: rim \
             speed $R\\Omega$. They meet at {} m/s. Skidding balls all slow down along one and the same line, and leave it one after the other; \
             struck above $7R/5$, the ball speeds up.",
            finals.join(", ")
        ),
        alt: format!(
            "Graph of speed against time. Five blue lines start at rim speeds from minus 4 to plus 4 metres a second, black lines at 2. \
             Each blue line meets the black one at a dot, and both go on level, at {} metres a second.",
            finals.join(", ")
        ),
    };
    let at = |t: f64, v: f64| [LEFT + (RIGHT - LEFT) * t / UNTIL, ZERO - METRE * v];
    Ok(figure("slide-to-roll", 396.0, words, |pen| {
        pen.line(&[at(0.0, 0.0), at(UNTIL, 0.0)], stroke(Role::Ink, AXIS));
        pen.line(&[at(0.0, -4.2), at(0.0, 4.3)], stroke(Role::Ink, AXIS));
        for v in [-4.0, -2.0, 2.0, 4.0] {
            let [x, y] = at(0.0, v);
            pen.line(&[[x - 5.0, y], [x, y]], stroke(Role::Ink, AXIS));
            pen.text(
                [x - 9.0, y + 5.0],
                Anchor::End,
                &number(v, 0),
                small(Role::Ink),
            );
        }
        pen.text([LEFT - 9.0, ZERO + 5.0], Anchor::End, "0", small(Role::Ink));
        pen.text([8.0, 20.0], Anchor::Start, "m/s", small(Role::Ink));
        for t in [0.25, 0.5, 0.75, 1.0] {
            let [x, y] = at(t, -4.2);
            pen.line(&[[x, y - 3.0], [x, y + 3.0]], stroke(Role::Ink, AXIS));
            pen.text(
                [x, y + 20.0],
                Anchor::Middle,
                &number(t, 2),
                small(Role::Ink),
            );
        }
        pen.text(
            [at(UNTIL, 0.0)[0] + 24.0, at(0.0, -4.2)[1] + 20.0],
            Anchor::Start,
            "s",
            small(Role::Ink),
        );
        for (name, course) in &courses {
            let start = course.at(0.0);
            let meets = course.events().first().map_or(0.0, |event| event.time);
            let rolls = course.at(meets);
            let end = course.at(UNTIL);
            let meeting = at(meets, rolls.velocity);
            pen.line(
                &[at(0.0, start.rim_speed), meeting],
                stroke(Role::Omega, DATA),
            );
            pen.line(&[at(0.0, start.velocity), meeting], stroke(Role::Ink, DATA));
            pen.line(
                &[meeting, at(UNTIL, end.velocity)],
                stroke(Role::Ink, SECONDARY),
            );
            pen.disc(meeting, 4.5, Role::Ink, 1.0);
            let [x, y] = at(UNTIL, end.velocity);
            pen.text(
                [x + 12.0, y + 5.0],
                Anchor::Start,
                &format!("*H* = {name} *R*"),
                small(Role::Ink),
            );
        }
        pen.text(
            at(0.17, 3.3),
            Anchor::Start,
            "*R*\u{03a9}, too fast",
            label(Role::Omega),
        );
        pen.text(
            at(0.42, -2.5),
            Anchor::Start,
            "*R*\u{03a9}, backspin",
            label(Role::Omega),
        );
        pen.text(at(0.055, 2.28), Anchor::Start, "*V*", label(Role::Ink));
    }))
}
