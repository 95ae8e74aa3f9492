//! The paper cat (tutorial 1.1): the forces on it, and the fall for its first degree.

use core::f64::consts::LN_10;

use spinning_bodies::phenomena::PaperCat;
use spinning_bodies::scene::effects::{Air, Gravity};
use spinning_bodies::scene::shape;
use spinning_bodies::scene::{Request, Scene};

use crate::prelude::*;

parameters! {
    LEVER: "lever", "d", "mm", "height of the point at which the air pushes over the centre of mass", [2.0, 12.0], 6.0;
    MASS: "mass", "m", "g", "mass of the cat", [0.5, 3.0], 1.2;
    THICK: "air", r"\rho", "kg/m³", "density of the air", [0.6, 2.4], 1.2;
    SHY: "error", r"\varepsilon", "°", "angle by which it is not upside down when it is let go", [1.0, 60.0], 10.0, logarithmic;
}

/// The parameters of the paper cat.
pub const PAPER_CAT: &[Parameter] = &[SHY, LEVER, MASS, THICK];
/// The parameters of its fall.
pub const FALL: &[Parameter] = &[LEVER, MASS, THICK];

const GRAVITY: f64 = 9.81;

fn cat(values: &Values) -> PaperCat {
    PaperCat {
        mass: values.of(&MASS) / 1e3,
        lever: values.of(&LEVER) / 1e3,
        ..PaperCat::POSTCARD
    }
}

fn released(values: &Values, error: f64) -> Result<shape::PaperCat> {
    let scene = shape::PaperCat::new(cat(values), PI - error)?;
    scene
        .with(Air::new(values.of(&THICK))?)?
        .with(Gravity::new(GRAVITY)?)
}

/// A folded sheet seen from the side: back up at tilt 0, legs at the two ends.
const SHEET: [Point; 15] = [
    [-62.0, 30.0],
    [-62.0, -6.0],
    [-56.0, -22.0],
    [-70.0, -30.0],
    [-84.0, -26.0],
    [-86.0, -40.0],
    [-78.0, -52.0],
    [-72.0, -60.0],
    [-66.0, -50.0],
    [-56.0, -44.0],
    [-44.0, -32.0],
    [46.0, -32.0],
    [62.0, -20.0],
    [66.0, 30.0],
    [54.0, 30.0],
];

/// Turned by `tilt` about the centre of mass.
fn turned([x, y]: Point, center: Point, tilt: f64) -> Point {
    let (s, c) = tilt.sin_cos();
    [center[0] + c * x + s * y, center[1] - s * x + c * y]
}

/// The sheet, and drag as a part of its weight.
fn sheet(pen: &mut Pen, center: Point, tilt: f64, drag: f64) {
    let mut outline: Vec<Point> = SHEET.to_vec();
    outline.extend([[50.0, -4.0], [-44.0, -4.0], [-48.0, 30.0]]);
    let outline = Vec::from_iter(outline.into_iter().map(|p| turned(p, center, tilt)));
    pen.fill(&outline, Ink, 0.1);
    pen.outline(&outline, inked(SECONDARY));
    let push = turned([0.0, -44.0], center, tilt);
    pen.line([center, push], inked(SECONDARY).dotted());
    if drag > 0.0 {
        pen.arrow([push[0], push[1] + 54.0 * drag], push, inked(DATA));
    }
    pen.arrow(center, [center[0], center[1] + 54.0], inked(DATA));
    pen.dot(center, 4.5);
    pen.dot(push, 4.5);
}

/// Three tilts in the air, and the sheet to fold.
pub fn paper_cat(values: &Values) -> Result<Figure> {
    let error = values.of(&SHY).to_radians();
    let (cat, air) = (cat(values), values.of(&THICK));
    let scene = released(values, error)?;
    let righted = scene.rights_itself(30.0)?;
    let (time, fall) = righted.map_or((1.0, 0.0), |r| (r.time, r.fall));
    // Let go, on its side, and nearly upright, to the hundredth of a second.
    let times = [0.0, 0.66, 0.84].map(|share| (100.0 * share * time).round() / 100.0);
    let rows = scene.simulate(&Request::at(times)?)?.rows;
    let terminal = cat.terminal_speed(air, GRAVITY);
    let tilts = [0, 1, 2].map(|n| rows[n].1.tilt);
    let drags = [0, 1, 2].map(|n| (rows[n].1.velocity / terminal).powi(2));
    let [lever, shy, mass, dense] = briefs(values.each([LEVER, SHY, MASS, THICK]));
    let [first, second, third] = numbers(tilts.map(f64::to_degrees), 0);
    let [_, early, late] = numbers(times, 2);
    let speed = number(terminal, 3);
    let words = words!(
        "The paper cat is turned by the air, like a shuttlecock.",
        "Its centre of mass lies {lever} mm below the point at which the air pushes; weight and drag turn the feet down from every tilt but exactly upside down. Let go {shy}° from upside down, it \
         tilts by {second}° after {early} s and {third}° after {late} s, and first points its feet down after {fall:.3} m of fall. Terminal speed {speed} m/s, mass {mass} g, \
         air of {dense} kg/m³. Lever drawn larger than it is.",
        "A cat cut from stiff paper in three positions, tilted by {first}, {second} and {third} degrees. In each an arrow of weight points down from a \
         dot; in the second and third, which fall fast, an arrow of drag points up to the middle of the back."
    );
    let made = figure("paper-cat", 280.0, words, |pen| {
        for ((tilt, drag), x) in tilts.into_iter().zip(drags).zip([108.0, 312.0, 500.0]) {
            sheet(pen, [x, 132.0], tilt, drag);
            let spot = [x, 270.0];
            pen.label(spot, Middle, &format!("{}°", number(tilt.to_degrees(), 0)));
        }
        let beside = (0..12).flat_map(|k| {
            let y = 174.0 + 3.0 * f64::from(k);
            [[534.0, y], [466.0, y], [546.0, y], [454.0, y]]
        });
        pen.name(beside, "weight", small(Ink));
        let push = turned([0.0, -44.0], [500.0, 132.0], tilts[2]);
        let beside = (0..12).flat_map(|k| {
            let y = 24.0 + 4.0 * f64::from(k);
            [-26.0, 26.0, -40.0, 40.0].map(|x| shifted(push, [x, y]))
        });
        pen.name(beside, "drag", small(Ink));
    });
    let rows = times.into_iter().zip(tilts);
    let rows = rows.map(|(time, tilt)| [time, tilt.to_degrees()]);
    Ok(made.data("paper cat", "time (s) | tilt (°)", rows))
}

const LEFT: f64 = 66.0;
const RIGHT: f64 = 566.0;
const BOTTOM: f64 = 290.0;
const TOP: f64 = 36.0;

/// How far it falls, for errors from 90° to a ten-thousandth of a degree.
pub fn paper_cat_fall(values: &Values) -> Result<Figure> {
    let fall = |degrees: f64| -> Result<f64> {
        let righted = released(values, degrees.to_radians())?.rights_itself(60.0)?;
        Ok(righted.map_or(0.0, |r| r.fall))
    };
    let curve = tried(0..=100, |k| {
        let degrees = 90.0 * (-LN_10 * 6.0 * f64::from(k) / 100.0).exp();
        Ok([degrees, fall(degrees)?])
    })?;
    let errors = [30.0, 10.0, 5.0, 1.0];
    let falls = tried(errors, fall)?;
    let cat = cat(values);
    let decade = cat.fall_per_decade(values.of(&THICK), GRAVITY);
    let [a, b, c, d] = [0, 1, 2, 3].map(|k: usize| number(falls[k], 3));
    let [lever, mass, air] = briefs(values.each([LEVER, MASS, THICK]));
    let words = words!(
        "Ten times nearer to upside down costs the paper cat the same fall again.",
        "Height of fall after which the feet first point down, against the angle by which the cat was not upside down. 30°, 10°, 5° and 1° take {a}, {b}, {c} and {d} m; \
         each further factor of ten takes {decade:.3} m. At 0° it takes for ever. Lever {lever} mm, {mass} g, air of {air} kg/m³.",
        "A curve that soon becomes a straight line: the fall grows by {decade:.3} m with each factor of ten by which the angle of the release comes closer \
         to upside down."
    );
    let deepest = curve.last().map_or(1.0, |last| last[1]);
    let frame = Frame {
        x: Axis::log([90.0, 90e-6], [LEFT, RIGHT]),
        y: Axis::linear([0.0, 1.06 * deepest], [BOTTOM, TOP]),
    };
    let place = |[degrees, fall]: Point| frame.at(degrees, fall);
    let made = figure("paper-cat-fall", 344.0, words, |pen| {
        let degrees = marks(&[10.0, 1.0, 0.1, 0.01, 0.001], "°");
        let names = ["short of upside down by", "fall, m"];
        frame.draw(pen, &degrees, &frame.y.ticks(50.0), names);
        let points = curve.iter().map(|point| place(*point));
        pen.line(points, inked(DATA));
        for (k, (&degrees, &fall)) in errors.iter().zip(&falls).enumerate() {
            let at = place([degrees, fall]);
            pen.dot(at, 4.0);
            // Above and below the curve in turn: the marks are close together.
            let (aside, anchor) = match k % 2 {
                0 => ([-4.0, -12.0], End),
                _ => ([6.0, 22.0], Start),
            };
            let told = number(fall, 3);
            // Clear of the axes.
            let half = if anchor == End { 9.0 } else { 0.0 };
            let left = LEFT + 4.0 + half * told.len() as f64;
            let [x, y] = shifted(at, aside);
            pen.note([x.max(left), y.min(BOTTOM - 8.0)], anchor, &told);
        }
    });
    Ok(made
        .data("paper cat", "short of upside down (°) | fall (m)", curve)
        .value("from-10", b)
        .value("from-1", d)
        .value("decade", number(decade, 3)))
}
