//! The superball under the table (tutorial 4.6).

mod bounces;

pub use bounces::{reflections, three_balls};

use core::f64::consts::FRAC_PI_2;

use num_rational::Ratio;
use spinning_bodies::Result;
use spinning_bodies::rolling::factor;
use spinning_bodies::superball::{Motion, UnderTable};

use crate::Figure;
use crate::style::{
    AXIS, Anchor, DATA, Fraction, HAIR, Pen, Point, Role, SECONDARY, Words, arc, between, figure,
    label, polar, small, stroke,
};

/// Where the centre first is at bouncing height above the floor, units.
const FIRST: f64 = 290.0;
/// The way an undisturbed ball makes in one flight, units.
const FLIGHT: f64 = 190.0;
/// Radius of the ball, units.
const RADIUS: f64 = 17.0;
/// The floor and the underside of the table, units.
const FLOOR: f64 = 396.0;
const CEILING: f64 = 96.0;
/// Thickness of the table, units, and where its edge is, in flights from the first bounce.
const SLAB: f64 = 13.0;
const EDGE: f64 = -0.62;
/// Flashes in a flight: the quarter keeps the balls going up clear of those coming down.
const FLASHES: f64 = 6.25;
/// Where the picture ends on the right and at the top: flights.
const LEAVES: f64 = 1.2;

/// Where a ball is drawn: `x` in flights from the first bounce, `height` 0 on the floor and 1 at the ceiling.
fn place(x: f64, height: f64) -> Point {
    let (low, high) = (FLOOR - RADIUS, CEILING + RADIUS);
    [FIRST + FLIGHT * x, low + (high - low) * height]
}

/// A fraction for a label: sign, numerator, denominator.
fn signed(value: Ratio<i128>) -> (&'static str, String, String) {
    let sign = if *value.numer() < 0 { "\u{2212}" } else { "" };
    (
        sign,
        value.numer().abs().to_string(),
        value.denom().to_string(),
    )
}

fn inline(value: Ratio<i128>) -> String {
    format!("{}/{}", value.numer(), value.denom())
}

/// The path of a superball thrown under a table, with its spin, and of a ball that takes no spin.
pub fn under_the_table() -> Result<Figure> {
    let (zero, one) = (Ratio::from_integer(0_i128), Ratio::from_integer(1));
    let exact = UnderTable::new(
        Motion {
            velocity: one,
            rim_speed: zero,
        },
        Ratio::new(2, 5),
    );
    let motions: Vec<Motion<Ratio<i128>>> = exact.take(3).collect();
    let places: Vec<Ratio<i128>> = exact.positions().take(3).collect();
    let thrown = Motion {
        velocity: 1.0,
        rim_speed: 0.0,
    };
    let float: Vec<Motion<f64>> = UnderTable::new(thrown, factor::BALL).take(3).collect();
    let bounces: Vec<f64> = UnderTable::new(thrown, factor::BALL)
        .positions()
        .take(3)
        .collect();
    let ghost: Vec<f64> = UnderTable::new(thrown, 0.0).positions().take(2).collect();

    let [v1, v2, v3] = [0, 1, 2].map(|k| inline(motions[k].velocity));
    let words = Words {
        claim: "A superball thrown under a table comes back out.".to_owned(),
        details: format!(
            "Solid ball, thrown with speed $V$ and no spin. After floor, table and floor its velocity is ${v1}$, \
             ${v2}$ and ${v3}$ of $V$, its rim speed $R\\Omega$ is ${}$, ${}$ and ${}$ of $V$. It meets the table at \
             ${}$ and the floor again at ${}$ of the way it would have made in one flight. Flashes at equal times, {FLASHES} a flight; the blue hand is fixed to the ball. Dashed: a ball with all its mass in the middle, which takes \
             no spin.",
            inline(motions[0].rim_speed),
            inline(motions[1].rim_speed),
            inline(motions[2].rim_speed),
            inline(places[0]),
            inline(places[1]),
        ),
        alt: format!(
            "A table seen from the side. A ball flies in from the upper left, bounces on the floor, on the underside of \
             the table and on the floor again, and flies out on the side it came from. The legs of the path are \
             labelled with the velocities {v1}, {v2} and {v3} of V, and a clock hand on the ball shows it turning one \
             way, then the other. A dashed ghost without spin zigzags straight on under the table."
        ),
    };

    Ok(figure("superball", 430.0, words, |pen| {
        room(pen);
        ghost_ball(pen, &ghost);

        // In without spin: small dots at the flashes.
        let arrive = [place(-1.36, 1.36), place(0.0, 0.0)];
        pen.line(&arrive, stroke(Role::Ink, SECONDARY));
        for k in 1..=8 {
            let t = f64::from(k) / FLASHES;
            pen.disc(place(-t, t), 2.2, Role::Ink, 1.0);
        }
        pen.arrow(
            place(-1.265, 1.265),
            place(-1.145, 1.145),
            stroke(Role::Ink, DATA),
        );

        // Three legs; the last goes on, for there is no table above it any more.
        let (mut turned, mut from, mut flash) = (0.0, 0.0, 0_u32);
        let mut flashes: Vec<(Point, f64, f64)> = Vec::new();
        let mut path = vec![place(0.0, 0.0)];
        for (leg, motion) in float.iter().enumerate() {
            let end = if leg == 2 { LEAVES } else { 1.0 };
            let height = |t: f64| if leg == 1 { 1.0 - t } else { t };
            let spin = motion.rim_speed * FLIGHT / RADIUS;
            loop {
                let t = f64::from(flash) / FLASHES - leg as f64;
                if t >= end.min(1.1) {
                    break;
                }
                // The sector is the turn since the flash before, or since the bounce if that is later.
                let swept = spin * t.min(1.0 / FLASHES);
                flashes.push((
                    place(from + motion.velocity * t, height(t)),
                    turned + spin * t,
                    swept,
                ));
                flash += 1;
            }
            path.push(place(from + motion.velocity * end, height(end)));
            turned += spin;
            from = bounces[leg];
        }
        for &corner in &path[..3] {
            pen.ring(corner, RADIUS, stroke(Role::Ink, HAIR).alpha(0.45));
        }
        for &(center, _, _) in &flashes {
            pen.disc(center, RADIUS, Role::Ink, 0.055);
        }
        pen.line(&path, stroke(Role::Ink, SECONDARY));
        for &(center, angle, swept) in &flashes {
            let hand = FRAC_PI_2 - angle;
            if swept != 0.0 {
                let mut sector = arc(center, 0.78 * RADIUS, hand + swept, hand);
                sector.push(center);
                pen.fill(&sector, Role::Omega, 0.22);
            }
            pen.ring(center, RADIUS, stroke(Role::Ink, AXIS).alpha(0.75));
            pen.line(
                &[center, polar(center, RADIUS, hand)],
                stroke(Role::Omega, DATA),
            );
            pen.disc(center, 1.6, Role::Omega, 1.0);
        }
        pen.arrow(
            between(path[2], path[3], 0.93),
            path[3],
            stroke(Role::Ink, DATA),
        );

        velocities(pen, &motions);
    }))
}

/// Floor and table.
fn room(pen: &mut Pen) {
    let edge = place(EDGE, 0.0)[0];
    let slab = [
        [edge, CEILING - SLAB],
        [590.0, CEILING - SLAB],
        [590.0, CEILING],
        [edge, CEILING],
    ];
    pen.fill(&slab, Role::Ink, 0.16);
    let leg = [
        [560.0, CEILING],
        [572.0, CEILING],
        [569.0, FLOOR],
        [563.0, FLOOR],
    ];
    pen.fill(&leg, Role::Ink, 0.09);
    pen.outline(&slab, stroke(Role::Ink, AXIS));
    pen.line(
        &[[10.0, FLOOR], [590.0, FLOOR]],
        stroke(Role::Ink, SECONDARY),
    );
}

/// The ball that takes no spin.
fn ghost_ball(pen: &mut Pen, bounces: &[f64]) {
    let mut path = vec![place(0.0, 0.0)];
    path.extend(
        bounces
            .iter()
            .enumerate()
            .map(|(k, &x)| place(x, f64::from(u8::from(k % 2 == 0)))),
    );
    // It leaves the picture on its second flight.
    let last = path.len() - 1;
    path[last] = between(path[last - 1], path[last], 0.56);
    pen.line(&path, stroke(Role::Muted, SECONDARY).dashed());
    for &corner in &path[1..last] {
        pen.ring(corner, RADIUS, stroke(Role::Muted, HAIR));
    }
    let at = between(path[0], path[1], 0.42);
    pen.text(
        [at[0] + 22.0, at[1] - 2.0],
        Anchor::Start,
        "without",
        small(Role::Muted),
    );
    pen.text(
        [at[0] + 22.0, at[1] + 15.0],
        Anchor::Start,
        "spin",
        small(Role::Muted),
    );
}

/// The exact velocities beside the legs of the path.
fn velocities(pen: &mut Pen, motions: &[Motion<Ratio<i128>>]) {
    let at = place(-1.13, 1.19);
    pen.text([at[0] + 8.0, at[1]], Anchor::Start, "*V*", label(Role::Ink));
    let spots = [place(0.53, 0.72), place(-0.3, 0.76), place(-1.05, 0.45)];
    for (spot, motion) in spots.into_iter().zip(motions) {
        let (before, over, under) = signed(motion.velocity);
        let parts = Fraction {
            before,
            over: &over,
            under: &under,
            after: "*V*",
        };
        pen.fraction(spot, parts, label(Role::Ink));
    }
}
