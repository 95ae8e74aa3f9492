//! The ball on a withdrawn sheet (tutorial 4.5).

use std::fmt::Write as _;

use spinning_bodies::Result;
use spinning_bodies::rolling::course::{Coulomb, Course, Happening, Load, Moment};
use spinning_bodies::rolling::factor;
use spinning_bodies::rolling::sheet::{Sheet, SheetSpeeds};

use crate::Figure;
use crate::style::{
    AXIS, Anchor, DATA, HAIR, Role, SCALE, SECONDARY, Words, figure, label, number, small, stroke,
};

const MARGIN: f64 = 0.15;

/// μ = 0.3 on the sheet and 0.2 on the table, 3 m/s within 0.02 s, edge 15 cm behind.
fn withdrawn(speeds: &SheetSpeeds) -> Result<Course> {
    let sheet = Sheet::new(Coulomb::new(0.3)?, speeds.clone(), MARGIN)?;
    let effects = (Some(Coulomb::new(0.2)?), None, Some(&sheet));
    Course::new(
        factor::BALL,
        Load::weight(9.81),
        effects,
        Moment::at_rest(),
        0.4,
    )
}

fn time_of(course: &Course, what: Happening) -> f64 {
    course.first(what).map_or(0.0, |event| event.time)
}

/// Velocity, rim speed and slip against time.
pub fn speeds() -> Result<Figure> {
    let sheet = SheetSpeeds::ramp(3.0, 0.02)?;
    let course = withdrawn(&sheet)?;
    let leaves = time_of(&course, Happening::LeavesSheet);
    let stops = course.events().last().map_or(0.0, |event| event.time);
    let then = course.at(leaves);
    let place = course.at(stops).position;
    let words = Words {
        claim: "Velocity and spin reach zero in the same instant: the ball stops dead.".to_owned(),
        details: format!(
            "A sheet jerked away at 3 m/s. On it friction drives the ball forward and spins it backward; off it, after {} ms, the table's friction does \
             the opposite, in the same proportion. Velocity and rim speed stay in the ratio 2 to −5 throughout, so both are zero after {} ms, {} mm from the start. \
             Below: the slip of the contact point over whatever it touches.",
            number(1e3 * leaves, 1),
            number(1e3 * stops, 0),
            number(1e3 * place, 1),
        ),
        alt: format!(
            "Two graphs against time. Above: velocity rises in a straight line to {} metres a second while the rim speed falls to {}, until the sheet has gone; then both return in straight \
             lines to zero at the same moment. Below: the slip goes to minus 2.4, jumps to plus 0.6 as the sheet leaves, and ends at zero at that moment.",
            number(then.velocity, 2),
            number(then.rim_speed, 2)
        ),
    };
    let x = |t: f64| 66.0 + 2750.0 * t;
    let upper = |v: f64| 96.0 - 260.0 * v;
    let lower = |u: f64| 286.0 - 26.0 * u;
    Ok(figure("withdrawn-sheet", 380.0, words, |pen| {
        let edge = x(leaves);
        let shade = [[x(0.0), 20.0], [edge, 20.0], [edge, 356.0], [x(0.0), 356.0]];
        pen.fill(&shade, Role::Ink, 0.06);
        pen.text(
            [0.5 * (x(0.0) + edge), 38.0],
            Anchor::Middle,
            "on the sheet",
            small(Role::Ink),
        );
        pen.text(
            [edge + 10.0, 38.0],
            Anchor::Start,
            "on the table",
            small(Role::Ink),
        );
        for y in [upper(0.0), lower(0.0)] {
            pen.line(&[[x(0.0), y], [x(0.18), y]], stroke(Role::Ink, AXIS));
        }
        pen.line(&[[x(0.0), 20.0], [x(0.0), 356.0]], stroke(Role::Ink, AXIS));
        pen.line(
            &[[x(stops), 60.0], [x(stops), 356.0]],
            stroke(Role::Ink, HAIR).dashed(),
        );
        for v in [0.0, -0.2, -0.4] {
            pen.text(
                [x(0.0) - 8.0, upper(v) + 5.0],
                Anchor::End,
                &number(v, 1),
                small(Role::Ink),
            );
        }
        for u in [0.0, -2.0] {
            pen.text(
                [x(0.0) - 8.0, lower(u) + 5.0],
                Anchor::End,
                &number(u, 0),
                small(Role::Ink),
            );
        }
        pen.text([8.0, 30.0], Anchor::Start, "m/s", small(Role::Ink));
        for t in [0.05, 0.1, 0.15] {
            pen.line(&[[x(t), 353.0], [x(t), 359.0]], stroke(Role::Ink, AXIS));
            pen.text(
                [x(t), 376.0],
                Anchor::Middle,
                &number(1e3 * t, 0),
                small(Role::Ink),
            );
        }
        pen.text([x(0.18), 376.0], Anchor::End, "ms", small(Role::Ink));
        let corners = [0.0, leaves, stops, 0.18];
        let velocity: Vec<_> = corners
            .iter()
            .map(|&t| [x(t), upper(course.at(t).velocity)])
            .collect();
        let rim: Vec<_> = corners
            .iter()
            .map(|&t| [x(t), upper(course.at(t).rim_speed)])
            .collect();
        pen.line(&velocity, stroke(Role::Ink, 2.6));
        pen.line(&rim, stroke(Role::Omega, 2.6));
        pen.text(
            [x(0.092), upper(0.15)],
            Anchor::Start,
            "*V*",
            label(Role::Ink),
        );
        pen.text(
            [x(0.088), upper(-0.4)],
            Anchor::Start,
            "*R*\u{03a9}",
            label(Role::Omega),
        );
        pen.text(
            [x(stops) + 8.0, upper(0.0) + 22.0],
            Anchor::Start,
            "both zero",
            small(Role::Ink),
        );
        let slip = |t: f64| [x(t), lower(course.at(t).slip)];
        let just = leaves * (1.0 - 1e-12);
        pen.line(
            &[
                slip(0.0),
                slip(0.02),
                slip(just),
                slip(leaves),
                slip(stops),
                slip(0.18),
            ],
            stroke(Role::Ink, DATA),
        );
        pen.text(
            [x(0.066), lower(-1.4)],
            Anchor::Start,
            "slip",
            label(Role::Ink),
        );
        pen.line(
            &[[x(0.0), 232.0], [x(0.18), 232.0]],
            stroke(Role::Ink, SECONDARY).alpha(0.15),
        );
    })
    .value("way", number(1e3 * place, 0)))
}

const NAME: &str = "sheet-animated";
/// Pictures in a round, seconds of the film in it, and how much slower than the ball it runs.
const PICTURES: usize = 60;
const LASTS: f64 = 0.2;
const SLOWNESS: f64 = 20.0;
const TABLE: f64 = 112.0;
const RADIUS: f64 = 44.0;
/// Units a metre.
const METRE: f64 = 44.0 / 0.02;
const FIRST: f64 = 352.0;

/// The same in motion.
pub fn animated() -> Result<Figure> {
    let sheet = SheetSpeeds::ramp(3.0, 0.02)?;
    let course = withdrawn(&sheet)?;
    let place = course.at(LASTS).position;
    let words = Words {
        claim: "The sheet goes, the ball moves a little, and stops dead.".to_owned(),
        details: format!(
            "A ball of 2 cm radius on a sheet that is jerked to the right at 3 m/s, twenty times slower than life. While the sheet is under it, it is dragged along and spun backward; \
             the table undoes both at once. It ends {} mm from where it began (the mark). Point at the picture to hold it.",
            number(1e3 * place, 1)
        ),
        alt: "A ball with a clock hand on a sheet of paper. The sheet slides out to the right; the ball creeps right while turning backward, the sheet's edge passes, and the ball \
              comes to rest, neither moving nor turning. Without motion: the ball as the sheet's edge comes."
            .to_owned(),
    };
    let still = figure(NAME, 160.0, words, |pen| {
        pen.line(
            &[[8.0, TABLE], [592.0, TABLE]],
            stroke(Role::Ink, SECONDARY),
        );
        pen.line(
            &[[FIRST, TABLE], [FIRST, TABLE + 18.0]],
            stroke(Role::Ink, AXIS),
        );
        pen.text(
            [FIRST, TABLE + 36.0],
            Anchor::Middle,
            "began here",
            small(Role::Ink),
        );
    });
    let mut style = String::from("<style>");
    let mut frames = [String::new(), String::new(), String::new()];
    let mut rest = [String::new(), String::new(), String::new()];
    for n in 0..=PICTURES {
        let t = LASTS * n as f64 / PICTURES as f64;
        let m = course.at(t);
        let x = (FIRST + METRE * m.position) * SCALE;
        let y = (TABLE - RADIUS - 2.0) * SCALE;
        let angle = (m.turned / 0.02).to_degrees();
        let margin = course.margin(t).unwrap_or(0.0);
        let edge = (FIRST + METRE * (m.position - margin)) * SCALE;
        let values = [
            format!("translate({x:.0}px,{y:.0}px)"),
            format!("rotate({angle:.1}deg)"),
            format!("translate({edge:.0}px,0px)"),
        ];
        for ((frame, rest), value) in frames.iter_mut().zip(&mut rest).zip(values) {
            let percent = 100.0 * n as f64 / PICTURES as f64;
            let _ = write!(frame, "{percent:.2}%{{transform:{value}}}");
            if n == PICTURES * 3 / 10 {
                *rest = value.replace("px", "").replace("deg", "");
            }
        }
    }
    let parts = ["ball", "hand", "paper"];
    let names = parts.map(|part| format!("fig-{NAME}-{part}"));
    for (name, frame) in names.iter().zip(&frames) {
        let _ = write!(
            style,
            "@keyframes {name}{{{frame}}}.{name}{{animation:{name} {}s linear infinite}}",
            SLOWNESS * LASTS
        );
    }
    let all = names
        .iter()
        .map(|n| format!(".{n}"))
        .collect::<Vec<_>>()
        .join(",");
    let _ = writeln!(
        style,
        "#fig-{NAME}-svg:hover :is({all}){{animation-play-state:paused}}@media (prefers-reduced-motion:reduce){{{all}{{animation:none}}}}@media print{{{all}{{animation:none}}}}</style>"
    );
    let (r, top) = (RADIUS * SCALE, (TABLE - 2.0) * SCALE);
    let long = 1200.0 * SCALE;
    let (thick, thin) = (2.6 * SCALE, 2.0 * SCALE);
    let groups = format!(
        "<defs><clipPath id=\"fig-{NAME}-room\"><path d=\"M80 0H5920V1600H80Z\"/></clipPath></defs>\n\
         <g clip-path=\"url(#fig-{NAME}-room)\"><g class=\"{paper}\" transform=\"{at2}\"><path d=\"M0 {top:.0}L{long:.0} {top:.0}\" stroke=\"var(--torque, #6b1a6b)\" stroke-width=\"{thick:.0}\"/></g></g>\n\
         <g class=\"{ball}\" transform=\"{at0}\"><g class=\"{hand}\" transform=\"{at1}\">\
         <circle r=\"{r:.0}\" fill=\"currentColor\" fill-opacity=\"0.1\" stroke=\"currentColor\" stroke-width=\"{thin:.0}\"/>\
         <path d=\"M0 0L0 -{r:.0}\" stroke=\"var(--omega, #0b6bcb)\" stroke-width=\"{thick:.0}\"/></g></g>\n",
        ball = names[0],
        hand = names[1],
        paper = names[2],
        at0 = rest[0],
        at1 = rest[1],
        at2 = rest[2],
    );
    Ok(still.moving(&(style + &groups)))
}
