//! Which way a spool rolls (tutorial 4.4, pictures e to g).

use spinning_bodies::rolling::{RoundBody, Spool, Tug, Way};

use crate::prelude::*;

/// The figures of the chapter, in its order.
pub const FIGURES: &[Entry] = &[
    of("spool", &[AXLE, LOW, STEEP], three_tugs),
    of("spool-dial", &[AXLE.dragged(critical_place), TENSION], dial),
];

parameters! {
    AXLE: "axle", "r/R", "", "radius of the axle over that of the discs", [0.05, 0.95], 0.4;
    LOW: "low", r"\theta_1", "°", "angle of the first tug above the ground", [0.0, 89.0], 25.0;
    STEEP: "steep", r"\theta_2", "°", "angle of the last tug above the ground", [0.0, 89.0], 85.0;
    TENSION: "tension", "T", "N", "pull of the string", [0.05, 0.5], 0.3;
}

/// M = 0.2 kg, R = 5 cm, a full disc.
fn reel(values: &Values) -> Result<Spool> {
    Spool::new(RoundBody::new(0.2, 0.05, 0.5)?, 0.05 * values.of(&AXLE))
}

/// Radius of the discs, and the ground, units.
const RADIUS: f64 = 62.0;
const GROUND: f64 = 214.0;

/// A spool tugged to the left at this angle, its line of force down to the foot, and the direction in which it rolls.
fn tugged(pen: &mut Pen, center: Point, ratio: f64, (angle, foot, way): (f64, f64, Way)) {
    let x = center[0];
    let r = ratio * RADIUS;
    let (sin, cos) = angle.sin_cos();
    // The tug goes to the left, as the tutorial draws it.
    let touch = shifted(center, [-r * sin, r * cos]);
    let along = |way: f64| shifted(touch, [-way * cos, -way * sin]);
    pen.disc(center, RADIUS, Shade, 0.6);
    pen.ring(center, RADIUS, inked(DATA));
    pen.ring(center, r, inked(SECONDARY));
    let end = match (foot - x).abs() < 82.0 {
        true => [foot, GROUND],
        false => along(-84.0),
    };
    let tip = along(98.0);
    pen.line([touch, end], inked(AXIS).dotted());
    pen.arrow(touch, tip, inked(2.6));
    pen.dot(center, 2.2);
    pen.dot([x, GROUND], 2.2);
    pen.ring([x, GROUND], 6.0, inked(SECONDARY));
    let spot = [(tip[0] - 2.0).max(24.0), tip[1] - 9.0];
    pen.note(spot, Middle, &degrees(angle));
    let below = GROUND + 26.0;
    let aside = match way {
        Way::Stays => 0.0,
        Way::WindsUp => 30.0,
        Way::PaysOut => -30.0,
    };
    pen.arrow([x + aside, below], [x - aside, below], inked(2.8));
    pen.note([x, below + 24.0], Middle, told(way));
}

fn told(way: Way) -> &'static str {
    match way {
        Way::Stays => "does not roll",
        Way::WindsUp => "comes and winds up",
        Way::PaysOut => "goes and pays out",
    }
}

/// In degrees, as the sliders give it.
fn degrees(angle: f64) -> String {
    brief(angle.to_degrees()) + "°"
}

/// The line of force above, through and below the point of contact.
pub fn three_tugs(values: &Values) -> Result<Figure> {
    let spool = reel(values)?;
    let critical = spool.critical_angle().unwrap_or(0.0);
    let [ratio, low, steep] = values.each([AXLE, LOW, STEEP]);
    let angles = [low.to_radians(), critical, steep.to_radians()];
    let [first, second, third] = angles.map(degrees);
    let ways = tried(angles, |angle| spool.way(angle))?;
    let feet = tried(angles, |angle| spool.foot_of_the_line(angle))?;
    let [low, steep] = [ways[0], ways[2]].map(told);
    let claim = match [ways[0], ways[2]] {
        [Way::WindsUp, Way::PaysOut] => {
            "The line of force decides: above the point of contact the spool comes, below it the spool goes."
                .to_owned()
        }
        _ if low == steep => format!(
            "Tugs at {first} and {third} do the same: both times the spool {low}."
        ),
        _ => format!(
            "The line of force decides: at {first} the spool {low}, at {third} it {steep}."
        ),
    };
    let axle = brief(ratio);
    let words = words!(
        "{claim}",
        "Axle {axle} of the discs, string leaving from below, tug to the left at {first}, {second} and {third} (the tutorial's pictures f, e \
         and g). Dotted: the line of force, prolonged. Ringed: the point of contact, about which friction has no moment. The arrow below: \
         the way the spool rolls.",
        "Three spools tugged to the left, and for each the prolonged line of force. At {first} the spool {low}. At {second} the line passes through the point \
         of contact, and the spool does not roll. At {third} it {steep}. The line that meets the ground on the far side winds the string up, the one that \
         meets it on the tug's side pays it out."
    );
    let made = figure("spool", 276.0, words, |pen| {
        pen.line([[8.0, GROUND], [592.0, GROUND]], inked(SECONDARY));
        for (k, x) in [120.0, 316.0, 512.0].into_iter().enumerate() {
            let foot = x - feet[k] / 0.05 * RADIUS;
            tugged(pen, [x, GROUND - RADIUS], ratio, (angles[k], foot, ways[k]));
        }
    });
    // A level tug has no foot.
    let rows = angles
        .iter()
        .zip(&feet)
        .map(|(angle, foot)| [angle.to_degrees(), *foot]);
    let rows = rows.filter(|row| row[1].is_finite());
    Ok(made.data("tug", "angle (°) | foot of the line (m)", rows))
}

/// The hub of the dial, its inner radius, and the longest ray, units.
const HUB: Point = [300.0, 262.0];
const INNER: f64 = 70.0;
const LONGEST: f64 = 179.2;

/// A place of the dial; angles from the left, where the tug of the first figure points.
fn place(radius: f64, angle: f64) -> Point {
    polar(HUB, radius, PI - angle)
}

/// The end of the dotted line: cos θ = r/R.
fn critical_place(values: &Values) -> Point {
    place(INNER + 62.0, values.of(&AXLE).acos())
}

/// Acceleration against the angle of the tug, all the way round.
pub fn dial(values: &Values) -> Result<Figure> {
    let spool = reel(values)?;
    let critical = spool.critical_angle().unwrap_or(0.0);
    let degrees = number(critical.to_degrees(), 2);
    let [ratio, tension] = values.each([AXLE, TENSION]);
    let at = |angle: f64| Ok(spool.rolling_acceleration(Tug::new(tension, angle)?));
    let rays = tried(spaced([0.0, PI], 36), |angle| Ok((angle, at(angle)?)))?;
    let (level, back) = (at(0.0)?, at(PI)?);
    let [axle, force] = briefs([ratio, tension]);
    let [most, away, after] = numbers([level, -at(PI / 2.0)?, -back], 2);
    let words = words!(
        "The spool comes for every tug lower than {degrees} degrees, runs away from a steeper one, and follows a hand beyond the vertical.",
        "Acceleration of a spool with $r/R = {axle}$, $M = 200$ g, $I = \\frac12MR^2$, tugged gently with {force} N: each ray points along the tug. Ink: it rolls to the left \
         and winds string up, {most} m/s² at most. Grey: to the right, and pays it out, up to {after} m/s².",
        "A half dial of rays over a spool, one every five degrees, counted from the left. Rays on the left, in ink, shrink from {most} at 0 degrees to nothing at {degrees} \
         degrees; grey rays grow from there over {away} at 90 degrees, where the spool runs away from the hand, to {after} at 180 degrees, where it follows the hand."
    );
    let unit = LONGEST / back.abs();
    let made = figure("spool-dial", 330.0, words, |pen| {
        pen.disc(HUB, 44.0, Shade, 0.6);
        pen.ring(HUB, 44.0, inked(DATA));
        pen.ring(HUB, 44.0 * ratio, inked(SECONDARY));
        let ends = [[20.0, HUB[1] + 44.0], [580.0, HUB[1] + 44.0]];
        pen.line(ends, inked(SECONDARY));
        pen.arc(HUB, INNER, 0.0, PI, inked(HAIR));
        for &(angle, a) in &rays {
            let ray = [place(INNER, angle), place(INNER + unit * a.abs(), angle)];
            let role = if a > 0.0 { Ink } else { Muted };
            pen.line(ray, stroke(role, DATA));
        }
        let outside = place(INNER + 62.0, critical);
        let ends = [place(44.0, critical), outside];
        pen.line(ends, inked(1.4).dotted());
        let name = place(INNER + 72.0, critical);
        let spot = shifted(name, [-9.0, -16.0]);
        pen.label(spot, End, "cos θ = *r*/*R*");
        let spot = shifted(name, [-9.0, 2.0]);
        pen.note(spot, End, &format!("θ = {degrees}°"));
        // The words are clear of the rays, however long these are.
        let tip = |k: usize| INNER + unit * rays[k].1.abs();
        let half = ((critical / PI * 18.0).round() as usize).min(18);
        let beside = place(tip(half) + 14.0, rays[half].0);
        pen.label(beside, End, "comes");
        let [x, y] = place(tip(18) + 34.0, PI / 2.0);
        pen.text([x + 4.0, y.min(76.0)], Middle, "runs away", label(Muted));
        pen.text([516.0, 104.0], Middle, "follows", label(Muted));
        let level = [HUB[0] - tip(0) - 8.0, HUB[1] + 6.0];
        pen.note(level, End, "0°");
        // Next to the vertical, the dotted line replaces it.
        if critical < 1.35 {
            let [x, y] = place(tip(18) + 8.0, PI / 2.0);
            pen.note([x + 4.0, y], End, "90°");
        }
        pen.note([580.0, HUB[1] + 24.0], End, "180°");
    });
    let rows = rays.iter().map(|&(angle, a)| [angle.to_degrees(), a]);
    Ok(made.data("spool", "angle (°) | acceleration (m/s²)", rows))
}
