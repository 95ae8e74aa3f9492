//! The superball under the table (tutorial 4.6).

mod bounces;

use num_rational::Ratio;
use spinning_bodies::superball::{Motion, Surface, UnderTable, bounce_with};

use crate::prelude::*;
use crate::rolling;
use bounces::fraction_of;

/// The figures of the chapter, in its order.
pub const FIGURES: &[Entry] = &[
    of("superball", &[KAPPA, GRIP, SPIN], under_the_table),
    of("three-superballs", bounces::BALLS, bounces::three_balls),
    of("bounce-reflections", bounces::MIRRORS, bounces::reflections),
];

const KAPPA: Parameter = rolling::KAPPA.between([0.1, 0.65], 0.4);
parameters! {
    GRIP: "restitution", "e_t", "", "part of its contact speed that the ball gets back in a bounce", [0.0, 1.0], 1.0;
    SPIN: "spin", r"R\Omega/V", "", "rim speed of the thrown ball over its speed", [-0.8, 0.8], 0.0;
}

/// The place of the centre at the first bounce, units.
const FIRST: f64 = 290.0;
/// The distance that an undisturbed ball travels in one flight, units.
const FLIGHT: f64 = 190.0;
/// Radius of the ball, units.
const RADIUS: f64 = 17.0;
/// The floor and the underside of the table, units.
const FLOOR: f64 = 396.0;
const CEILING: f64 = 96.0;
/// Thickness of the table, units, and where its edge is, in flights from the first bounce.
const SLAB: f64 = 13.0;
const EDGE: f64 = -0.62;
/// Flashes per flight: because of the quarter, balls on the way up do not coincide with those on the way down.
const FLASHES: f64 = 4.25;
/// Where the picture ends on the right and at the top: flights.
const LEAVES: f64 = 1.2;

/// Where a ball is drawn: `x` in flights from the first bounce, `height` 0 on the floor and 1 at the ceiling.
fn place(x: f64, height: f64) -> Point {
    let (low, high) = (FLOOR - RADIUS, CEILING + RADIUS);
    [FIRST + FLIGHT * x, low + (high - low) * height]
}

/// Motions after floor, ceiling and floor.
fn three_bounces<T: Copy>(
    thrown: Motion<T>,
    bounce: impl Fn(Motion<T>, Surface) -> Motion<T>,
) -> [Motion<T>; 3] {
    let floor = bounce(thrown, Surface::Floor);
    let ceiling = bounce(floor, Surface::Ceiling);
    [floor, ceiling, bounce(ceiling, Surface::Floor)]
}

/// The exact number if that is short, for the text.
fn inline(value: f64, exact: Option<Ratio<i128>>) -> String {
    let Some(exact) = exact.filter(|exact| *exact.denom() < 1000) else {
        return brief(value);
    };
    exact.to_string().replace('-', "\u{2212}")
}

/// Where the picture ends to the left and to the right: flights.
const ENDS: [f64; 2] = [-1.36, 1.48];

/// The leg of a path: its beginning in flights, its motion, whether it goes up or down, and the part of a flight that is drawn.
struct Leg {
    from: f64,
    motion: Motion<f64>,
    down: bool,
    end: f64,
}

impl Leg {
    fn at(&self, t: f64) -> Point {
        let height = if self.down { 1.0 - t } else { t };
        place(self.from + self.motion.velocity * t, height)
    }
}

/// The three legs, as far as they are in the picture; the last one continues beyond the edge of the table.
fn legs(motions: [Motion<f64>; 3]) -> Vec<Leg> {
    let mut from = 0.0;
    let mut legs = Vec::new();
    for (k, motion) in motions.into_iter().enumerate() {
        let v = motion.velocity;
        let free = k == 2 && from + v < EDGE - 0.1;
        let wanted: f64 = if free { LEAVES } else { 1.0 };
        let there = if v > 0.0 { ENDS[1] } else { ENDS[0] };
        let end = match v {
            0.0 => wanted,
            _ => wanted.min((there - from) / v),
        };
        let down = k == 1;
        legs.push(Leg {
            from,
            motion,
            down,
            end,
        });
        if end < 1.0 {
            break;
        }
        from += v;
    }
    legs
}

/// The path of a superball thrown under a table, with its spin, and the path of a ball that gains no spin.
pub fn under_the_table(values: &Values) -> Result<Figure> {
    let [kappa, grip, spin] = values.each([KAPPA, GRIP, SPIN]);
    let thrown = Motion {
        velocity: 1.0,
        rim_speed: spin,
    };
    let motions = three_bounces(thrown, |motion, surface| {
        bounce_with(motion, surface, kappa, grip)
    });
    let exact = (|| {
        let (kappa, grip) = (fraction_of(kappa)?, fraction_of(grip)?);
        let thrown = Motion {
            velocity: Ratio::from_integer(1),
            rim_speed: fraction_of(spin)?,
        };
        Some(three_bounces(thrown, |motion, surface| {
            bounce_with(motion, surface, kappa, grip)
        }))
    })();
    let ghost: Vec<f64> = UnderTable::new(thrown, 0.0).positions().take(2).collect();
    let velocities = [0, 1, 2].map(|k| {
        let exactly = exact.map(|exact| exact[k].velocity);
        inline(motions[k].velocity, exactly)
    });
    let spins = [0, 1, 2].map(|k| {
        let exactly = exact.map(|exact| exact[k].rim_speed);
        inline(motions[k].rim_speed, exactly)
    });
    let second = motions[0].velocity + motions[1].velocity;
    let legs = legs(motions);
    let out = second + motions[2].velocity;
    let which = match grip == 1.0 {
        true => "A superball".to_owned(),
        false => {
            let part = match grip == 0.0 {
                true => "nothing".to_owned(),
                false => brief(grip),
            };
            format!("A ball that gets back {part} of its contact speed")
        }
    };
    let after = if out < EDGE {
        "comes back out"
    } else if motions[2].velocity < 0.0 {
        "turns back, but meets the table once more on its way"
    } else {
        "has not turned round: after three bounces it still goes on"
    };
    let plain = |text: &str| text.replace('\u{2212}', "-");
    let about_spin = match spin == 0.0 {
        true => "no spin".to_owned(),
        false => format!("rim speed ${}\\,V$", plain(&brief(spin))),
    };
    let inertia = inline(kappa, fraction_of(kappa));
    let [p1, p2, p3] = velocities.each_ref().map(|text| plain(text));
    let labels = velocities[..legs.len()].join(", ");
    let [s1, s2, s3] = spins.map(|text| plain(&text));
    let words = words!(
        "{which} {after}.",
        "Ball with $I = {inertia}\\,MR^2$, thrown with speed $V$ and {about_spin}. After floor, table and floor its velocity is ${p1}$, ${p2}$ and ${p3}$ of $V$, its rim speed \
         $R\\Omega$ is ${s1}$, ${s2}$ and ${s3}$ of $V$. Flashes at equal times; the blue hand is fixed to the ball. Dashed: a perfectly smooth ball, which takes \
         no spin.",
        "A table seen from the side. A ball flies in from the upper left and bounces on the floor, on the underside of \
         the table and on the floor again; it {after}. The legs of the path are \
         labelled with their velocities, {labels} of V, and a clock hand on the ball shows how it turns. \
         A dashed ghost without spin zigzags straight on under the table."
    );

    let made = figure("superball", 414.0, words, |pen| {
        room(pen);
        let ghost = ghost_ball(pen, &ghost);

        // On the way in: small dots at the flashes.
        let arrive = [place(-1.36, 1.36), place(0.0, 0.0)];
        pen.line(arrive, inked(SECONDARY));
        for k in 1..=5 {
            let t = f64::from(k) / FLASHES;
            pen.dot(place(-t, t), 2.2);
        }
        let [tail, tip] = [1.33, 1.21].map(|t| place(-t, t));
        pen.arrow(tail, tip, inked(DATA));

        let (mut turned, mut flash) = (0.0, 0_u32);
        let mut flashes: Vec<(Point, f64, f64)> = Vec::new();
        let mut path = vec![place(0.0, 0.0)];
        for (k, leg) in legs.iter().enumerate() {
            let spin = leg.motion.rim_speed * FLIGHT / RADIUS;
            loop {
                let t = f64::from(flash) / FLASHES - k as f64;
                if t >= leg.end.min(1.1) {
                    break;
                }
                // The sector is the turn since the flash before, or since the bounce if that is later.
                let swept = spin * t.min(1.0 / FLASHES);
                flashes.push((leg.at(t), turned + spin * t, swept));
                flash += 1;
            }
            path.push(leg.at(leg.end));
            turned += spin;
        }
        for &corner in &path[..path.len() - 1] {
            pen.ring(corner, RADIUS, inked(HAIR).alpha(0.45));
        }
        for &(center, _, _) in &flashes {
            pen.disc(center, RADIUS, Ink, 0.055);
        }
        pen.line(&path, inked(SECONDARY));
        for &(center, angle, swept) in &flashes {
            let hand = FRAC_PI_2 - angle;
            if swept != 0.0 {
                let mut sector = arc(center, 0.78 * RADIUS, hand + swept, hand);
                sector.push(center);
                pen.fill(&sector, Omega, 0.22);
            }
            pen.ring(center, RADIUS, inked(AXIS).alpha(0.75));
            pen.line([center, polar(center, RADIUS, hand)], stroke(Omega, DATA));
            pen.disc(center, 1.6, Omega, 1.0);
        }
        let last = path.len() - 1;
        let tip = between(path[last - 1], path[last], 0.93);
        pen.arrow(tip, path[last], inked(DATA));

        // Beside its arrow, on the other side where the ball comes out here.
        let beside = [[30.0, -12.0], [-14.0, 16.0], [-20.0, 24.0]];
        let beside = beside.map(|[x, y]| [tail[0] + x, tail[1] + y]);
        pen.name(beside, "*V*", label(Ink));
        for (leg, text) in legs.iter().zip(&velocities) {
            velocity_label(pen, leg, text);
        }
        let on = |k| between(ghost[0], ghost[1], 0.3 + 0.01 * f64::from(k));
        let right =
            |k| [50.0, 65.0, 80.0, 100.0, -50.0, -70.0].map(|far| [on(k)[0] + far, on(k)[1] + 4.0]);
        let beside = (0..50).flat_map(right);
        // Farther from a velocity than from each other, or the three would be one label.
        let [x, y] = pen.room(beside, [28.0, 34.0]);
        pen.remark([x, y - 4.0], Middle, "without");
        pen.remark([x, y + 13.0], Middle, "spin");
    });
    let row = |k: usize, from: f64| [[from, motions[k].velocity, motions[k].rim_speed]];
    let columns = "place (flights) | velocity (V) | rim speed (V)";
    Ok(made
        .data("after the floor", columns, row(0, 0.0))
        .data("after the table", columns, row(1, motions[0].velocity))
        .data("after the floor again", columns, row(2, second)))
}

/// The velocity of a leg beside it, where there is room.
fn velocity_label(pen: &mut Pen, leg: &Leg, text: &str) {
    let (sign, number) = match text.strip_prefix('\u{2212}') {
        Some(rest) => ("\u{2212}", rest),
        None => ("", text),
    };
    let letters = number.split('/').map(|part| part.chars().count()).max();
    let beside = if number.contains('/') { 20.0 } else { 12.0 };
    let half = 5.0 * letters.unwrap_or(0) as f64 + beside;
    let shares = [0.7, 0.6, 0.5, 0.8, 0.4, 0.9, 0.3, 0.2];
    let beside = |far: f64| {
        // Not beyond the line on which the ball comes in.
        let side = match leg.down {
            true => -far,
            false if leg.from > 0.0 => far,
            false => far * leg.motion.velocity.signum(),
        };
        shares.map(|share| {
            let on = leg.at(share * leg.end);
            [on[0] + side * (half + RADIUS + 8.0), on[1]]
        })
    };
    let far = [1.0, 1.3, 1.7, -1.0, -1.3, -1.7];
    let places = far.into_iter().flat_map(beside);
    let inside = places.filter(|p| (40.0..=560.0).contains(&p[0]) && p[1] > 30.0);
    let at = pen.room(inside, [half, 20.0]);
    match number.split_once('/') {
        Some((over, under)) => {
            pen.fraction(at, [sign, over, under, "*V*"], label(Ink));
        }
        None => {
            let text = format!("{text} *V*");
            pen.label([at[0], at[1] + 5.0], Middle, &text);
        }
    }
}

/// Floor and table.
fn room(pen: &mut Pen) {
    let edge = place(EDGE, 0.0)[0];
    let slab = boxed([edge, CEILING - SLAB], [590.0, CEILING]);
    pen.fill(slab, Ink, 0.16);
    let leg = [
        [560.0, CEILING],
        [572.0, CEILING],
        [569.0, FLOOR],
        [563.0, FLOOR],
    ];
    pen.fill(leg, Ink, 0.09);
    pen.outline(slab, inked(AXIS));
    pen.line([[10.0, FLOOR], [590.0, FLOOR]], inked(SECONDARY));
}

/// The ball that gains no spin, and its path.
fn ghost_ball(pen: &mut Pen, bounces: &[f64]) -> Vec<Point> {
    let heights = [1.0, 0.0].into_iter().cycle();
    let mut path = vec![place(0.0, 0.0)];
    let corners = bounces.iter().zip(heights);
    path.extend(corners.map(|(&x, height)| place(x, height)));
    // It leaves the picture on its second flight.
    let last = path.len() - 1;
    path[last] = between(path[last - 1], path[last], 0.56);
    pen.line(&path, muted(SECONDARY).dashed());
    for &corner in &path[1..last] {
        pen.ring(corner, RADIUS, muted(HAIR));
    }
    path
}
