//! A tippe top that turns itself over, seen by a camera that turns with its axis.

use spinning_bodies::scene::contact::State;

use super::ball::cap_outline;
use super::toys::*;
use crate::finish::{self, short};
use crate::prelude::*;

const NAME: &str = "tippe-top-animated";
/// Seconds of the run, and its pictures.
const END: f64 = 8.0;
const PICTURES: u32 = 160;
/// The picture that is shown without animation: half way over.
const STILL: usize = 100;
/// The ball: centre, radius, and where C is, over the radius.
const CENTER: Point = [150.0, 178.0];
const RADIUS: f64 = 104.0;

const FRAME: Frame = Frame::linear([0.0, END], [0.0, 180.0], [340.0, 574.0, 282.0, 34.0]);

/// The whole puzzle in eight seconds.
pub fn turning_over(_: &Values) -> Result<Figure> {
    let top = tippe(ALPHA.default, GAMMA.default)?;
    let scene = tippe_scene(&top, SPIN.default, VISCOUS.default)?;
    let rows = run(&scene, END, PICTURES)?;
    let (first, last) = (rows[0].1, rows[rows.len() - 1].1);
    let climbed = 1e3 * (last.position.z() - first.position.z());
    let [fast, slow, climbed] = numbers([first.spin(), last.spin(), climbed], 1);
    let words = words!(
        "Spun, a ball with a heavy foot turns itself upside down.",
        "Tippe top of 20 g, $R = 2$ cm, its centre of mass $C$ 6 mm below the centre $K$ of the ball, spun at 155 rad/s, in real time; the camera goes \
         round with the axis. Its spin about the vertical falls from {fast} to {slow} rad/s, $C$ rises by {climbed} mm.",
        "On the left a ball with a filled cap on top and its centre of mass below the centre. On the right its tilt against time. For three seconds \
         the tilt is small, then the ball leans over, passes the horizontal at five seconds, and at six the cap is at the bottom \
         and the centre of mass above. Without motion: the ball almost on its side."
    );
    let still = figure(NAME, 330.0, words, |pen| {
        let floor = CENTER[1] + RADIUS;
        pen.line([[18.0, floor], [282.0, floor]], inked(SECONDARY));
        pen.disc(CENTER, RADIUS, Shade, 1.0);
        let across = marks(&[0.0, 2.0, 4.0, 6.0, 8.0], "");
        let up = marks(&[0.0, 90.0, 180.0], "°");
        FRAME.draw(pen, &across, &up, ["time, s", "tilt"]);
        FRAME.curve(pen, tilts(&rows), inked(DATA));
        pen.remark(FRAME.at(0.3, 96.0), Start, "on its side");
        spin_arrow(pen);
    });
    Ok(still.moving(&moving(&rows)))
}

/// The arrow of the spin about the vertical, over the ball.
fn spin_arrow(pen: &mut Pen) {
    let [x, y] = CENTER;
    let angles = (0..=40).map(|k| 2.5 + 4.4 * f64::from(k) / 40.0);
    let points = angles.map(|a| [x + 44.0 * a.cos(), y - RADIUS - 24.0 - 10.0 * a.sin()]);
    let points: Vec<Point> = points.collect();
    pen.line(&points[..38], stroke(Omega, SECONDARY));
    pen.arrow(points[37], points[40], stroke(Omega, SECONDARY));
    pen.text([x + 56.0, y - RADIUS - 18.0], Start, "Ω", label(Omega));
}

/// The cap, the axis and C turn about K; the disc runs along the curve.
fn moving(rows: &[(f64, State)]) -> String {
    let mut style = String::from("<style>");
    let turn = |s: &State| format!("rotate({}deg)", short(degrees(s), 2));
    let shift = |t: f64, s: &State| {
        let [x, y] = FRAME.at(t, degrees(s));
        format!("translate({:.0}px,{:.0}px)", x * SCALE, y * SCALE)
    };
    let shares = || spaced([0.0, 100.0], PICTURES).map(|share| short(share, 3));
    let turns = rows.iter().map(|(_, s)| turn(s));
    let shifts = rows.iter().map(|(t, s)| shift(*t, s));
    let [ball, dot] = ["ball", "dot"].map(|part| format!("fig-{NAME}-{part}"));
    style += &finish::keyframes(&ball, shares().zip(turns));
    style += &finish::keyframes(&dot, shares().zip(shifts));
    for name in [&ball, &dot] {
        style += &format!(".{name}{{animation:{name} {END}s linear infinite}}");
    }
    style += &finish::stops(NAME, &format!(".{ball},.{dot}"));
    let (time, state) = &rows[STILL];
    let cap = cap_outline(RADIUS * SCALE).into_iter();
    let cap: Vec<String> = cap.map(|[x, y]| format!("{x:.0} {y:.0}")).collect();
    let cap = cap.join("L");
    let [x, y] = CENTER.map(|c| c * SCALE);
    let (r, c) = (RADIUS * SCALE, ALPHA.default * RADIUS * SCALE);
    let [dx, dy] = FRAME.at(*time, degrees(state)).map(|c| c * SCALE);
    format!(
        "{style}<g transform=\"translate({x:.0} {y:.0})\"><circle r=\"{r:.0}\" stroke=\"currentColor\" stroke-width=\"12\"/>\n\
         <g class=\"fig-{NAME}-ball\" transform=\"rotate({})\">\
         <path d=\"M{cap}Z\" fill=\"currentColor\" fill-opacity=\"0.55\"/>\
         <path d=\"M0 {r:.0}L0 -{r:.0}\" stroke=\"currentColor\" stroke-width=\"8\" stroke-dasharray=\"1 36\"/>\
         <circle r=\"32\" fill=\"currentColor\"/>\
         <circle cy=\"{c:.0}\" r=\"58\" fill=\"currentColor\"/></g></g>\n\
         <g class=\"fig-{NAME}-dot\" transform=\"translate({dx:.0} {dy:.0})\"><circle r=\"52\" fill=\"currentColor\"/></g>\n",
        short(degrees(state), 2),
    )
}
