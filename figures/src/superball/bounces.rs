//! Bounces as reflections, and paths under the table for three balls (tutorial 4.6).

use num_rational::Ratio;
use spinning_bodies::superball::{BounceRotation, Motion, UnderTable, return_threshold};

use crate::prelude::*;
use crate::rolling;

const THROWN: Motion<f64> = Motion {
    velocity: 1.0,
    rim_speed: 0.0,
};

const KAPPA: Parameter = rolling::KAPPA
    .between([0.05, 0.65], 0.4)
    .dragged(mirror_place);
parameters! {
    BOUNCES: "bounces", "n", "", "bounces that are drawn", [1.0, 9.0], 3.0, whole;
}

/// The parameters of the reflections.
pub const MIRRORS: &[Parameter] = &[KAPPA, BOUNCES];

/// A number of few digits as a fraction.
pub fn fraction_of(value: f64) -> Option<Ratio<i128>> {
    let with = |under: u32| {
        let over = (value * f64::from(under)).round();
        let near = (value * f64::from(under) - over).abs() < 1e-12;
        near.then(|| Ratio::new(over as i128, i128::from(under)))
    };
    (1..=12).find_map(with)
}

const CENTER: Point = [300.0, 184.0];
const SIZE: f64 = 150.0;
/// The end of a mirror.
const MIRROR: f64 = 190.0;

fn mirror_place(values: &Values) -> Point {
    polar(CENTER, MIRROR, values.of(&KAPPA).sqrt().atan())
}

/// Each bounce reflects the point (V, √κ RΩ) of the unit circle in one of two lines.
pub fn reflections(values: &Values) -> Result<Figure> {
    let kappa = values.of(&KAPPA);
    let root = kappa.sqrt();
    let count = values.of(&BOUNCES) as usize;
    let motions: Vec<Motion<f64>> = core::iter::once(THROWN)
        .chain(UnderTable::new(THROWN, kappa).take(count))
        .collect();
    let beta = 0.5 * BounceRotation::new(kappa)?.angle();
    let degrees = number(beta.to_degrees(), 1);
    let angle = |m: &Motion<f64>| (root * m.rim_speed).atan2(m.velocity);
    let angles: Vec<f64> = motions.iter().map(angle).collect();
    let missing = (PI - angles[count].abs()).to_degrees();
    let last = if missing < 0.05 {
        "exactly at the opposite point".to_owned()
    } else if missing > 179.95 {
        "where it began".to_owned()
    } else {
        format!("{}° from the opposite point", number(missing, 1))
    };
    let plural = if count == 1 { "" } else { "s" };
    let told = |(n, angle): (usize, &f64)| format!("{n} at {}", number(angle.to_degrees(), 1));
    let listed: Vec<String> = angles.iter().enumerate().map(told).collect();
    let (factor, listed) = (brief(kappa), listed.join(", "));
    let words = words!(
        "A bounce is a reflection; floor and ceiling have a mirror each.",
        "The motion of a superball is a point of a circle: across, the velocity $V$; upward, the spin as $\\sqrt{{\\kappa}}\\,R\\Omega$. The floor reflects it \
         in the upper dashed line, the ceiling in the lower, both {degrees}° from the axis ($\\tan\\beta = \\sqrt{{\\kappa}}$, $\\kappa = {factor}$). \
         Start at 0, thrown without spin; after {count} bounce{plural}, floor first, the ball is at {count}, {last}.",
        "A circle with two dashed mirror lines at plus and minus {degrees} degrees. Points of the circle, joined by arrows that cross the upper and the lower mirror in turn: {listed} degrees."
    );
    let point = |m: &Motion<f64>| planned(CENTER, SIZE, [m.velocity, root * m.rim_speed]);
    let made = figure("bounce-reflections", 368.0, words, |pen| {
        pen.ring(CENTER, SIZE, inked(SECONDARY));
        let [x, y] = CENTER;
        let axes = [[[x - 190.0, y], [x + 190.0, y]], [[x, 14.0], [x, 354.0]]];
        pen.lines(axes, inked(AXIS));
        pen.label([CENTER[0] + 196.0, CENTER[1] + 5.0], Start, "*V*");
        for (angle, name) in [(beta, "floor"), (-beta, "ceiling")] {
            let ends = [polar(CENTER, MIRROR, angle), polar(CENTER, -MIRROR, angle)];
            pen.line(ends, muted(DATA).dashed());
            // Clear of the ring with which the upper one is dragged.
            pen.text(shifted(ends[0], [16.0, 5.0]), Start, name, label(Muted));
        }
        for pair in motions.windows(2) {
            let (from, to) = (point(&pair[0]), point(&pair[1]));
            let tip = between(from, to, 0.965);
            pen.arrow(from, tip, inked(DATA));
        }
        let mut named: Vec<Point> = Vec::new();
        for (n, m) in motions.iter().enumerate() {
            let p = point(m);
            pen.dot(p, 5.5);
            // A single name where the ball returns to an earlier point.
            if named.iter().any(|q| distance(*q, p) < 14.0) {
                continue;
            }
            named.push(p);
            let turns = (0..40).map(|k| {
                let aside = f64::from((k + 1) / 2) * if k % 2 == 0 { 0.012 } else { -0.012 };
                polar(CENTER, SIZE + 18.0, angles[n] + aside)
            });
            pen.name(turns, &n.to_string(), label(Ink).strong());
        }
        let beside = [34.0, -34.0, 52.0, -52.0, 80.0].map(|x| [CENTER[0] + x, 15.0]);
        pen.name(beside, "√κ *R*\u{03a9}", label(Omega));
    });
    let rows = motions.iter().enumerate();
    let rows = rows.map(|(n, m)| [n as f64, m.velocity, m.rim_speed]);
    Ok(made.data("ball", "bounces | velocity (V) | rim speed (V)", rows))
}

parameters! {
    DENSE: "dense", r"\kappa_1", "", "moment of inertia of the ball with a dense core over MR²", [0.05, 0.37], 1.0 / 3.0, dragged(|values| apex(values.of(&DENSE)));
    HOLLOW: "hollow", r"\kappa_3", "", "moment of inertia of the hollow ball over MR²", [0.43, 2.0 / 3.0], 2.0 / 3.0, dragged(|values| apex(values.of(&HOLLOW)));
}

/// The parameters of three balls; their handles are the places where they meet the table.
pub const BALLS: &[Parameter] = &[DENSE, HOLLOW];

const FLOOR: f64 = 244.0;
const CEILING: f64 = 44.0;
const FIRST: f64 = 352.0;
const FLIGHT: f64 = 200.0;
/// The right end of the drawing, flights.
const RIGHT: f64 = 1.15;

fn place(x: f64, height: f64) -> Point {
    [FIRST + FLIGHT * x, FLOOR - (FLOOR - CEILING) * height]
}

/// The place where a ball meets the table: (1−κ)/(1+κ) of a flight.
fn apex(kappa: f64) -> Point {
    place((1.0 - kappa) / (1.0 + kappa), 1.0)
}

/// The direction of a ball after three bounces, by its angle in the circle of reflections: half of the circle means back.
fn comes_back(kappa: f64, last: &Motion<f64>) -> Result<&'static str> {
    let over = (3.0 * BounceRotation::new(kappa)?.angle() - PI).to_degrees();
    Ok(if last.velocity >= 0.0 {
        "does not come back"
    } else if over.abs() < 0.05 {
        "comes back exactly"
    } else if over > 0.0 {
        "turns too far"
    } else {
        "turns too little"
    })
}

/// Three balls thrown alike.
pub fn three_balls(values: &Values) -> Result<Figure> {
    let balls = [
        (values.of(&DENSE), inked(DATA).dashed()),
        (0.4, inked(DATA)),
        (values.of(&HOLLOW), muted(DATA)),
    ];
    let motions = balls.map(|(kappa, _)| {
        let mut motions = UnderTable::new(THROWN, kappa);
        [0; 3].map(|_| motions.next().unwrap_or(THROWN))
    });
    let told = |k: usize| comes_back(balls[k].0, &motions[k][2]);
    let threshold = number(return_threshold(0.4)?, 3);
    let last = motions.map(|of| number(of[2].velocity, 3)).join(", ");
    let name = |kappa: f64| match fraction_of(kappa) {
        Some(exact) => exact.to_string(),
        None => brief(kappa),
    };
    let names = balls.map(|(kappa, _)| name(kappa));
    let exactly = match told(0)? {
        "comes back exactly" => "; the first leaves without spin, on the path it came",
        _ => "",
    };
    let turns = motions.map(|of| number(of[0].velocity, 2)).join(", ");
    let (dense, hollow) = (told(0)?, told(2)?);
    let hollow = if hollow == dense {
        "does the same"
    } else {
        hollow
    };
    let [first, second, third] = &names;
    let words = words!(
        "With a dense core it {dense}; a hollow one {hollow}.",
        "Balls with $\\kappa = I/MR^2$ of {first} (dense core), {second} (solid) and {third} (hollow), thrown alike without spin, drawn without gravity. After floor, ceiling, floor their velocities are \
         {last} of $V${exactly}. A solid ball that gets back less than {threshold} of its contact speed has not turned round by then.",
        "Zigzag paths between floor and table of three balls thrown from the left at one point of the floor. They go on by {turns} of a flight to the table, come down to the floor, and leave it \
         with velocities {last} of the first; negative ones lead back out to the left."
    );
    let made = figure("three-superballs", 268.0, words, |pen| {
        pen.line([[10.0, FLOOR], [590.0, FLOOR]], inked(SECONDARY));
        let slab = boxed([250.0, CEILING - 12.0], [590.0, CEILING]);
        pen.fill(slab, Ink, 0.16);
        pen.line(&slab[2..], inked(AXIS));
        let arrives = [place(-1.17, 1.17), place(0.0, 0.0)];
        pen.line(arrives, inked(HAIR).dashed());
        pen.arrow(place(-1.05, 1.05), place(-0.93, 0.93), inked(DATA));
        let mut ends = Vec::new();
        for (of, (_, line)) in motions.iter().zip(balls) {
            let out = 0.62;
            let (mut x, mut path) = (0.0, vec![place(0.0, 0.0)]);
            for (motion, (up, height)) in of.iter().zip([(1.0, 1.0), (1.0, 0.0), (out, out)]) {
                let next = x + up * motion.velocity;
                let from = path[path.len() - 1];
                if next > RIGHT {
                    let share = (RIGHT - x) / (next - x);
                    path.push(between(from, place(next, height), share));
                    break;
                }
                path.push(place(next, height));
                x = next;
            }
            let last = path.len() - 1;
            pen.line(&path[..last], line);
            pen.arrow(path[last - 1], path[last], line);
            ends.push(between(path[last - 1], path[last], 0.9));
        }
        let mut write = |at: Point, text: &str, lettering| {
            let wide = 32.0 / 7.0 * text.chars().count() as f64;
            let places = (0..80).map(|k| {
                let (far, turn) = (1.0 + f64::from(k / 20) * 0.5, f64::from(k % 20) * PI / 10.0);
                let [x, y] = polar([0.0; 2], 1.0, turn);
                shifted(at, [(wide + 12.0) * far * x, 18.0 * far * y])
            });
            let inside = within([wide + 4.0, 596.0 - wide], [14.0, 268.0]);
            pen.name(places.filter(inside), text, lettering);
        };
        write(place(-0.99, 0.99), "thrown", small(Ink));
        for (end, name) in ends.into_iter().zip(&names) {
            let text = format!("κ = {name}");
            write(end, &text, label(Ink));
        }
    });
    let hollow = number(-motions[2][2].velocity, 3);
    let mut made = made.value("threshold", threshold).value("hollow", hollow);
    for (of, name) in motions.iter().zip(&names) {
        let rows = of.iter().zip([1.0, 2.0, 3.0]);
        let rows = rows.map(|(m, n)| [n, m.velocity, m.rim_speed]);
        let columns = "bounces | velocity (V) | rim speed (V)";
        made = made.data(format!("κ = {name}"), columns, rows);
    }
    Ok(made)
}
