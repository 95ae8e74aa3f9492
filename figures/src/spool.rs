//! Which way a spool rolls (tutorial 4.4, pictures e to g).

use core::f64::consts::PI;

use spinning_bodies::Result;
use spinning_bodies::rolling::RoundBody;
use spinning_bodies::rolling::spool::{Spool, Tug, Way};

use crate::Figure;
use crate::style::{
    AXIS, Anchor, DATA, HAIR, Pen, Point, Role, SECONDARY, Words, figure, label, number, polar,
    small, stroke,
};

/// M = 0.2 kg, r = 2 cm, R = 5 cm, a full disc, tugged with 0.3 N.
fn reel() -> Result<Spool> {
    Spool::new(RoundBody::new(0.2, 0.05, 0.5)?, 0.02)
}

const TENSION: f64 = 0.3;
/// Radius of the discs, and the ground, units.
const RADIUS: f64 = 62.0;
const GROUND: f64 = 214.0;

/// A spool tugged to the left, its line of force, and the way it rolls.
fn tugged(pen: &mut Pen<'_>, spool: &Spool, x: f64, angle: f64, names: [&str; 2]) -> Result<()> {
    let center = [x, GROUND - RADIUS];
    let contact = [x, GROUND];
    let r = spool.ratio() * RADIUS;
    let (sin, cos) = angle.sin_cos();
    // The tug goes to the left, as the tutorial draws it.
    let touch = [x - r * sin, center[1] + r * cos];
    let along = |from: Point, way: f64| [from[0] - way * cos, from[1] - way * sin];
    let foot = [x - spool.foot_of_the_line(angle)? / 0.05 * RADIUS, GROUND];
    pen.disc(center, RADIUS, Role::Shade, 0.6);
    pen.ring(center, RADIUS, stroke(Role::Ink, DATA));
    pen.ring(center, r, stroke(Role::Ink, SECONDARY));
    let shown = (foot[0] - x).abs() < 105.0;
    let end = if shown { foot } else { along(touch, -118.0) };
    pen.line(&[touch, end], stroke(Role::Ink, AXIS).dotted());
    pen.arrow(touch, along(touch, 98.0), stroke(Role::Ink, 2.6));
    pen.disc(center, 2.2, Role::Ink, 1.0);
    pen.disc(contact, 5.0, Role::Torque, 1.0);
    let tip = along(touch, 98.0);
    pen.text(
        [tip[0] - 2.0, tip[1] - 9.0],
        Anchor::Middle,
        names[0],
        small(Role::Ink),
    );
    let below = GROUND + 26.0;
    match spool.way(angle)? {
        Way::Stays => {}
        Way::WindsUp => pen.arrow(
            [x + 30.0, below],
            [x - 30.0, below],
            stroke(Role::Omega, 2.8),
        ),
        Way::PaysOut => pen.arrow(
            [x - 30.0, below],
            [x + 30.0, below],
            stroke(Role::Omega, 2.8),
        ),
    }
    pen.text(
        [x, below + 24.0],
        Anchor::Middle,
        names[1],
        small(Role::Ink),
    );
    Ok(())
}

/// The line of force above, through and below the point of contact.
pub fn three_tugs() -> Result<Figure> {
    let spool = reel()?;
    let critical = spool.critical_angle().unwrap_or(0.0);
    let degrees = number(critical.to_degrees(), 1);
    let words = Words {
        claim: "The line of force decides: above the point of contact the spool comes, below it the spool goes.".to_owned(),
        details: format!(
            "Axle two fifths of the discs, string leaving from below, tug to the left at 25, {degrees} and 85 degrees (the tutorial's pictures f, e \
             and g). Dotted: the line of force, prolonged. Purple: the point of contact, about which friction has no moment. Blue: the way the \
             spool rolls."
        ),
        alt: format!(
            "Three spools tugged to the left. At 25 degrees the prolonged line of force passes above the point of contact and meets the ground on the far side; the spool \
             rolls left and winds string. At {degrees} degrees it passes through the point of contact; no rolling. At 85 degrees it meets the ground on the tug's side; the spool \
             rolls right and pays string out."
        ),
    };
    let mut drawn = Ok(());
    let made = figure("spool", 276.0, words, |pen| {
        pen.line(
            &[[8.0, GROUND], [592.0, GROUND]],
            stroke(Role::Ink, SECONDARY),
        );
        let names = format!("{degrees}°");
        drawn = tugged(
            pen,
            &spool,
            124.0,
            25_f64.to_radians(),
            ["25°", "comes, winds up"],
        )
        .and_then(|()| tugged(pen, &spool, 322.0, critical, [&names, "does not roll"]))
        .and_then(|()| {
            tugged(
                pen,
                &spool,
                494.0,
                85_f64.to_radians(),
                ["85°", "goes, pays out"],
            )
        });
    });
    drawn.map(|()| made)
}

/// Acceleration against the angle of the tug, all the way round.
pub fn dial() -> Result<Figure> {
    let spool = reel()?;
    let critical = spool.critical_angle().unwrap_or(0.0);
    let degrees = number(critical.to_degrees(), 2);
    let at = |angle: f64| Ok(spool.rolling_acceleration(Tug::new(TENSION, angle)?));
    let rays = (0..=36)
        .map(|k| PI * f64::from(k) / 36.0)
        .map(|angle| at(angle).map(|a| (angle, a)))
        .collect::<Result<Vec<_>>>()?;
    let level = at(0.0)?;
    let back = at(PI)?;
    let words = Words {
        claim: format!(
            "The spool comes for every tug lower than {degrees} degrees, runs away from a steeper one, and follows a hand beyond the vertical."
        ),
        details: format!(
            "Acceleration of a spool with $r/R = 0.4$, $M = 200$ g, $I = \\frac12MR^2$, tugged gently to the left with {TENSION} N, and steeper and steeper \
             until the hand is on the right. Each ray points along the tug and is as long as the acceleration is large. Black: the spool rolls to the left and \
             winds string up, {} m/s² at most. Grey: it rolls to the right and pays string out, up to {} m/s² when the string is pulled back over the axle.",
            number(level, 1),
            number(-back, 1),
        ),
        alt: format!(
            "A half dial of rays over a spool, one every five degrees, counted from the left. Black rays on the left shrink from {} at 0 degrees to nothing at {degrees} \
             degrees; grey rays grow from there over {} at 90 degrees, where the spool runs away from the hand, to {} at 180 degrees, where it follows the hand.",
            number(level, 1),
            number(-at(PI / 2.0)?, 1),
            number(-back, 1),
        ),
    };
    const HUB: Point = [300.0, 262.0];
    const INNER: f64 = 70.0;
    const UNIT: f64 = 128.0;
    Ok(figure("spool-dial", 330.0, words, |pen| {
        pen.disc(HUB, 44.0, Role::Shade, 0.6);
        pen.ring(HUB, 44.0, stroke(Role::Ink, DATA));
        pen.ring(HUB, 17.6, stroke(Role::Ink, SECONDARY));
        pen.line(
            &[[20.0, HUB[1] + 44.0], [580.0, HUB[1] + 44.0]],
            stroke(Role::Ink, SECONDARY),
        );
        pen.arc(HUB, INNER, 0.0, PI, stroke(Role::Ink, HAIR));
        // From the left, where the tug of the first figure points.
        let place = |radius: f64, angle: f64| polar(HUB, radius, PI - angle);
        for &(angle, a) in &rays {
            let ray = [place(INNER, angle), place(INNER + UNIT * a.abs(), angle)];
            let role = if a > 0.0 { Role::Ink } else { Role::Muted };
            pen.line(&ray, stroke(role, DATA));
        }
        let outside = place(INNER + 62.0, critical);
        pen.line(
            &[place(44.0, critical), outside],
            stroke(Role::Torque, 1.4).dotted(),
        );
        let name = place(INNER + 72.0, critical);
        pen.text(
            [name[0] + 4.0, name[1] - 16.0],
            Anchor::End,
            "cos θ = *r*/*R*",
            label(Role::Torque),
        );
        pen.text(
            [name[0] + 4.0, name[1] + 2.0],
            Anchor::End,
            &format!("θ = {degrees}°"),
            small(Role::Torque),
        );
        pen.text([145.0, 216.0], Anchor::End, "comes", label(Role::Ink));
        pen.text(
            [304.0, 96.0],
            Anchor::Middle,
            "runs away",
            label(Role::Muted),
        );
        pen.text(
            [516.0, 104.0],
            Anchor::Middle,
            "follows",
            label(Role::Muted),
        );
        pen.text([144.0, HUB[1] + 6.0], Anchor::End, "0°", small(Role::Ink));
        let up = place(INNER + UNIT * 0.4, PI / 2.0);
        pen.text(
            [up[0] + 4.0, up[1] - 8.0],
            Anchor::End,
            "90°",
            small(Role::Ink),
        );
        pen.text(
            [580.0, HUB[1] + 24.0],
            Anchor::End,
            "180°",
            small(Role::Ink),
        );
    }))
}
