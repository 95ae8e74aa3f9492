//! The boiled egg: picture h, and how far an egg with too little spin rises.

use spinning_bodies::scene::contact::passage;

use super::toys::*;
use crate::prelude::*;

/// Half length and half thickness in the film, units.
const HALF: [f64; 2] = [51.0, 34.0];
/// The parameters of the film.
pub const FILM: [Parameter; 2] = [
    TURNS.between([8.0, 30.0], 20.0),
    FRICTION.between([0.05, 0.3], 0.1),
];
/// Turns per second of the runs in the curve.
const SPINS: [f64; 7] = [8.0, 9.0, 10.0, 12.0, 14.0, 16.0, 20.0];

/// Degrees from the vertical, whichever end is up.
fn slope(tilt: f64) -> f64 {
    tilt.to_degrees().min(180.0 - tilt.to_degrees())
}

/// The outline of an egg lying with its long axis at `tilt` from the vertical, about its centre, and the height of that.
fn outline(tilt: f64) -> (Vec<Point>, f64) {
    let (s, c) = tilt.sin_cos();
    let points: Vec<Point> = spaced([0.0, TAU], 90)
        .map(|a| [HALF[0] * a.cos(), HALF[1] * a.sin()])
        .map(|[u, v]| [u * s + v * c, v * s - u * c])
        .collect();
    let low = points.iter().map(|p| p[1]).fold(f64::MIN, f64::max);
    (points, low)
}

/// An egg that was laid down and spun stands up.
pub fn egg_film(values: &Values) -> Result<Figure> {
    let [turns, mu] = values.each(FILM);
    let rows = run(&egg_scene(turns, mu)?, 2.5 * 0.1 / mu, 500)?;
    let last = slope(rows[500].1.tilt());
    let levels = [70.0, 50.0, 30.0, 6.0].map(|level| {
        let time = passage(&rows, |s| -slope(s.tilt()), -level);
        time.map(|time| (time, level.to_radians()))
    });
    let mut frames = vec![(0.0, 88_f64.to_radians())];
    frames.extend(levels.into_iter().flatten());
    // An egg that stops on the way is shown at the end of the run, too.
    if frames.len() < 5 {
        frames.push((rows[500].0, last.to_radians()));
    }
    let (ends, after) = (number(last, 0), number(rows[500].0, 1));
    let claim = match frames.len() {
        2 if last > 86.0 => format!(
            "Laid down and spun so sluggishly, a boiled egg has not risen after {after} seconds: its axis is {ends} degrees from the vertical."
        ),
        _ if last > 7.0 => format!(
            "Laid down and spun, a boiled egg rises part of the way in {after} seconds, to {ends} degrees from the vertical."
        ),
        _ => "Laid down and spun hard, a boiled egg stands up.".to_owned(),
    };
    let told = |(time, tilt): &(f64, f64)| {
        let (angle, time) = (number(tilt.to_degrees(), 0), number(*time, 2));
        format!("{angle} degrees at {time} s")
    };
    let times = Vec::from_iter(frames.iter().map(told)).join(", ");
    let [turns, mu] = briefs([turns, mu]);
    let words = words!(
        "{claim}",
        "Picture h of the tutorial. An egg of 6 by 4 cm and 60 g at {turns} turns a second, $\\mu = {mu}$ smoothed over 2 mm/s, drawn when its long axis first stands at \
         the angles marked; the camera goes round with it.",
        "Pictures of an egg on a table, from left to right with its long axis this far from the vertical: {times}."
    );
    let made = figure("egg-film", 178.0, words, |pen| {
        let floor = 128.0;
        pen.line([[8.0, floor], [592.0, floor]], inked(SECONDARY));
        for (k, &(time, tilt)) in frames.iter().enumerate() {
            one(pen, [66.0 + 117.0 * k as f64, floor], time, tilt);
        }
    });
    let table = rows.iter().map(|(t, s)| [*t, slope(s.tilt())]);
    Ok(made.data("egg", "time (s) | angle from the vertical (°)", table))
}

fn one(pen: &mut Pen, foot: Point, time: f64, tilt: f64) {
    let (points, low) = outline(tilt);
    let center = [foot[0], foot[1] - low];
    let moved = points.iter().map(|p| shifted(center, *p));
    let moved: Vec<Point> = moved.collect();
    pen.fill(&moved, Ink, 0.09);
    pen.outline(&moved, inked(1.4));
    let tips = [1.0, -1.0].map(|side| polar(center, side * HALF[0], FRAC_PI_2 - tilt));
    pen.line(tips, inked(HAIR).alpha(0.7));
    pen.dot(center, 2.8);
    let place = [foot[0], foot[1] + 22.0];
    pen.note(place, Middle, &format!("{}°", number(tilt.to_degrees(), 0)));
    pen.remark([foot[0], foot[1] + 41.0], Middle, &format!("{time:.2} s"));
}

/// How far an egg rises in eight seconds: with too little spin, part of the way. Seven runs of eight seconds; the figure has no parameters.
pub fn how_far_eggs_rise(_: &Values) -> Result<Figure> {
    let ends = tried(SPINS, |turns| {
        let rows = run(&egg_scene(turns, 0.1)?, 8.0, 8)?;
        Ok(slope(rows[8].1.tilt()))
    })?;
    let [eight, nine, ten] = numbers([ends[0], ends[1], ends[2]], 0);
    let twenty = number(ends[6], 1);
    let words = words!(
        "Spun lazily, an egg is still on its way up after eight seconds, or never starts.",
        "Angle between the long axis and the vertical after 8 s, against the spin given to the lying egg ($6\\times4$ cm, 60 g, $\\mu = 0.1$ smoothed over 2 mm/s). At 8 \
         turns a second it stays at {eight}°, at 10 it has come to {ten}°, at 20 to {twenty}°.",
        "Angle from the vertical after eight seconds against turns a second. At eight turns the egg stays at {eight} degrees, at nine it lifts to {nine}. Then \
         the angle falls: {ten} at ten turns, and {twenty} at twenty."
    );
    Ok(figure("egg-angle", 348.0, words, |pen| {
        let frame = Frame::linear([7.0, 21.0], [0.0, 95.0], [62.0, 572.0, 296.0, 34.0]);
        frame.draw(
            pen,
            &marks(&[8.0, 10.0, 12.0, 14.0, 16.0, 18.0, 20.0], ""),
            &marks(&[0.0, 30.0, 60.0, 90.0], "°"),
            ["turns a second", "angle from the vertical"],
        );
        let curve = SPINS.into_iter().zip(ends).map(|(turns, end)| [turns, end]);
        frame.curve(pen, curve.clone(), inked(AXIS).dotted());
        for [turns, end] in curve {
            pen.dot(frame.at(turns, end), 4.6);
            if let 10.0 | 14.0 = turns {
                let [x, y] = frame.at(turns, end);
                let (points, _) = outline(end.to_radians());
                let small = |p: &Point| [x + 62.0 + 0.62 * p[0], y - 12.0 + 0.62 * p[1]];
                let small_egg: Vec<Point> = points.iter().map(small).collect();
                pen.fill(&small_egg, Ink, 0.09);
                pen.outline(&small_egg, inked(DATA * 0.6));
            }
        }
        pen.label(frame.at(8.0, 80.0), Middle, "lies");
        pen.label(frame.at(20.0, 7.0), Middle, "stands");
    }))
}
