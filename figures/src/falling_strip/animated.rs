//! Two strips of paper: one flutters, one tumbles.

use core::fmt::Write as _;

use spinning_bodies::falling_strip::{Coefficients, Fall, Sheet, Start};

use crate::finish;
use crate::prelude::*;

const NAME: &str = "strip-animated";
/// Widths, cm, names of the motions, starts of the paths, and half widths as drawn, units.
const STRIPS: [(f64, &str, Point, f64); 2] = [
    (24.0, "24 cm wide: flutters", [130.0, 84.0], 30.0),
    (2.0, "2 cm wide: tumbles", [300.0, 84.0], 7.0),
];
const PICTURES: u32 = 240;
/// Seconds of the film.
const SECONDS: f64 = 9.0;
/// Height of the picture that the paths cross, units.
const FALL: f64 = 320.0;
/// The room to each side, units.
const ASIDE: f64 = 264.0;

struct Film {
    name: &'static str,
    start: Point,
    half: f64,
    sheet: Sheet,
    /// Places and angles.
    pictures: Vec<(Point, f64)>,
    time: f64,
}

fn film((width, name, start, half): (f64, &'static str, Point, f64)) -> Result<Film> {
    let sheet = Sheet::of_paper(width / 100.0)?;
    let fall = Fall::new(sheet.mass_ratio(), Coefficients::PAPER)?;
    let run = fall.long_run(Start::TILTED, 200.0, 200.0)?;
    // As long as it takes to cross the picture, in whole periods if there is one.
    let crossing = (FALL / (half * run.descent)).min(ASIDE / (half * run.drift.abs()));
    let time = match run.period {
        Some(period) => (crossing / period).floor().max(1.0) * period,
        None => crossing,
    };
    let times = (0..=PICTURES).map(|k| 300.0 + time * f64::from(k) / f64::from(PICTURES));
    let path = fall.path(Start::TILTED, &times.collect::<Vec<_>>())?;
    let sign = if run.drift < -1e-6 { -1.0 } else { 1.0 };
    let [left, right] = extent(path.iter().map(|y| y[0]));
    let middle = match run.drift.abs() > 1e-6 {
        true => path[0][0],
        false => 0.5 * (left + right),
    };
    // Down is positive on the canvas.
    let picture = |y: &[f64; 7]| {
        let place = [sign * (y[0] - middle), y[1] - path[0][1]];
        (planned(start, half, place), -sign * y[2])
    };
    let pictures = path.iter().map(picture).collect();
    Ok(Film {
        name,
        start,
        half,
        sheet,
        pictures,
        time,
    })
}

/// A wide strip and a narrow one.
pub fn animated(_: &Values) -> Result<Figure> {
    let films = tried(STRIPS, film)?;
    let slow = |film: &Film| SECONDS / (film.time * film.sheet.time());
    let (wide, narrow) = (number(slow(&films[0]), 1), number(slow(&films[1]), 0));
    let words = words!(
        "Of the same paper the wide strip flutters down, the narrow one spins and sails away.",
        "Both seen along their length, each drawn in a scale of its own, paper of 80 g/m², coefficients fitted to paper; {wide} and {narrow} times slower than life.",
        "Two paths with a short line that moves along each. The line on the left swings from side to side and always shows the same face upward. The line on the right turns over \
         and over and slides down a straight slope to the right. Without motion: some of the positions on both paths."
    );
    let still = figure(NAME, 450.0, words, |pen| {
        for film in &films {
            let path = film.pictures.iter().map(|p| p.0);
            pen.line(path, muted(SECONDARY).alpha(0.8));
            for ([x, y], angle) in film.pictures.iter().step_by(6) {
                let (sine, cosine) = angle.sin_cos();
                let (dx, dy) = (film.half * cosine, film.half * sine);
                let ends = [[x - dx, y - dy], [x + dx, y + dy]];
                pen.line(ends, inked(SECONDARY).alpha(0.22));
            }
            let at = [film.start[0].max(130.0), 34.0];
            let anchor = match film.start[0] > 200.0 {
                true => Anchor::Start,
                false => Middle,
            };
            pen.label(at, anchor, film.name);
        }
        pen.remark([580.0, 436.0], End, "slow motion");
    });
    let (mut style, mut groups, mut all) = ("<style>".to_owned(), String::new(), String::new());
    for (film, part) in films.iter().zip(["wide", "narrow"]) {
        let name = format!("fig-{NAME}-{part}");
        let shares = spaced([0.0, 100.0], PICTURES).map(|share| format!("{share:.2}"));
        let frames = shares.zip(&film.pictures).map(|(share, ([x, y], angle))| {
            let (x, y) = (x * SCALE, y * SCALE);
            let moved = format!("translate({x:.0}px,{y:.0}px) rotate({angle:.3}rad)");
            (share, moved)
        });
        style += &finish::keyframes(&name, frames);
        style += &format!(".{name}{{animation:{name} {SECONDS}s linear infinite}}");
        let _ = write!(all, "{}.{name}", if all.is_empty() { "" } else { "," });
        let ([x, y], angle) = film.pictures[film.pictures.len() / 2];
        let (x, y, half) = (x * SCALE, y * SCALE, film.half * SCALE);
        let degrees = angle.to_degrees();
        let _ = writeln!(
            groups,
            "<g class=\"{name}\" transform=\"translate({x:.0} {y:.0}) rotate({degrees:.1})\">\
             <path d=\"M-{half:.0} 0L{half:.0} 0\" stroke=\"currentColor\" stroke-width=\"45\" stroke-linecap=\"round\"/></g>"
        );
    }
    style += &finish::stops(NAME, &all);
    Ok(still.moving(&(style + &groups)))
}
