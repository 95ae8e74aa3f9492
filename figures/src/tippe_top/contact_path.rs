//! The path of the contact point on the ball.

use spinning_bodies::scene::contact::Support;

use super::toys::*;
use crate::prelude::*;

/// The parameters; in the book slow enough to be followed with the eye.
pub const PATH: [Parameter; 3] = [
    SPIN.between([100.0, 400.0], 200.0),
    ALPHA.between([0.05, 0.4], 0.2),
    FRICTION,
];

/// The point of contact moves from the heavy pole to the light one.
pub fn path(values: &Values) -> Result<Figure> {
    let [spin, alpha, mu] = values.each(PATH);
    // Four fifths of the time that the estimate allows.
    let end = 1.25 * (spin / 200.0) / (3.0 * mu);
    let rows = run(&toy_scene(alpha, spin, mu)?, end, 4000)?;
    let aloft = rows.iter().filter(|row| row.1.support == Support::Airborne);
    let aloft = 100.0 * aloft.count() as f64 / rows.len() as f64;
    // The contact lies opposite to the vertical, seen from K in the body's axes.
    let path: Vec<Vector> = rows.iter().map(|(_, s)| -s.up().components()).collect();
    let turned = path.windows(2).map(|pair| {
        let angle = |p: &Vector| p.y.atan2(p.x);
        let step = angle(&pair[1]) - angle(&pair[0]);
        (step + PI).rem_euclid(TAU) - PI
    });
    let turns = turned.sum::<f64>().abs() / TAU;
    let tilt = degrees(&rows[rows.len() - 1].1);
    let claim = if tilt > 150.0 {
        "On the ball, the point of contact walks from the heavy pole to the light one.".to_owned()
    } else if tilt > 15.0 {
        format!(
            "On the ball, the point of contact walks away from the heavy pole, by {tilt:.0} degrees so far."
        )
    } else {
        let most = number(greatest_tilt(&rows), 0);
        format!("On the ball, the point of contact stays within {most} degrees of the heavy pole.")
    };
    let [spun, lever, rough] = briefs([spin, alpha, mu]);
    let rounds = number(turns, 1);
    let flight = match number(aloft, if aloft < 1.0 { 2 } else { 0 }) {
        _ if aloft == 0.0 => ", and the ball never leaves the table".to_owned(),
        aloft => format!("; for {aloft} per cent of that time the ball is in the air"),
    };
    let spins = rows.iter().map(|(_, s)| s.spin()).sum::<f64>();
    let whole = number(spins * end / rows.len() as f64 / TAU, 0);
    let words = words!(
        "{claim}",
        "A ball of $R = 2$ cm, $\\alpha = {lever}$, $\\mu = {rough}$ smoothed over 1 mm/s, spun about the vertical at {spun} rad/s: the place that touches the table, seen from \
         the ball, during {end:.2} s. The ball turns {whole} times about the vertical meanwhile; the path on it goes round {rounds} times while the tilt grows to {tilt:.0}°{flight}.",
        "A ball with the centre of mass below its centre. A line on its surface starts near the south pole, goes round {rounds} times and ends {tilt:.0} degrees from there; \
         behind the ball it is faint."
    );
    let made = figure("contact-path", 360.0, words, |pen| {
        let (center, radius): (Point, f64) = ([300.0, 180.0], 164.0);
        let view = View::new(0.4, 0.3, center, radius);
        pen.disc(center, radius, Shade, 1.0);
        let [front, _] = view.halves(&latitude(0.0, 1.0, 120));
        pen.lines(front, muted(HAIR));
        let [front, back] = view.halves(&path);
        pen.lines(back, inked(SECONDARY).alpha(0.45));
        pen.lines(front, inked(DATA));
        pen.ring(center, radius, inked(AXIS));
        let [k, c] = [0.0, -alpha].map(|z| view.project(&(Vector::z() * z)));
        pen.line([k, c], inked(AXIS));
        pen.dot(k, 3.6);
        pen.dot(c, 3.6);
        for (at, down, text) in [(k, -5.0, "*K*"), (c, 7.0, "*C*")] {
            let beside = [down, -down, 2.5 * down].map(|y| [[15.0, y], [-15.0, y], [22.0, y]]);
            let places = beside.concat().into_iter().map(|by| shifted(at, by));
            pen.name(places, text, label(Ink));
        }
        for (touched, name) in [(path[0], "start"), (path[path.len() - 1], "end")] {
            let at = view.project(&touched);
            pen.dot(at, 4.0);
            let beside = [0.0, -18.0, 18.0, -26.0, 26.0].map(|y| [[28.0, y], [-28.0, y], [0.0, y]]);
            let beside = beside.concat().into_iter().map(|by| shifted(at, by));
            let inside = within([30.0, 570.0], [16.0, 344.0]);
            pen.name(beside.filter(inside), name, small(Ink));
        }
    });
    let columns = "time (s) | x over R | y over R | z over R";
    let table = rows.iter().zip(&path).step_by(10);
    let table = table.map(|((t, _), p)| [*t, p.x, p.y, p.z]);
    Ok(made.data("contact on the ball", columns, table))
}
