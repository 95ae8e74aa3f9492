//! The wooden top of the chapter's puzzle (tutorial 7.4): tilted, spun, held still; and let go.

use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::lagrange_top::LagrangeTop;

use super::launch::*;
use crate::prelude::*;

/// Moments, kg m², mass, kg, and the height of C above the tip, m.
const ACROSS: f64 = 2e-4;
const ALONG: f64 = 7e-5;
const MASS: f64 = 0.1;
const ARM: f64 = 0.04;
const GRAVITY: f64 = 9.81;
/// Distance of the nose from the tip, m, and duration of its path, s.
const NOSE: f64 = 0.085;
const SHOWN: f64 = 1.0;

parameters! {
    TILT: "tilt", r"\theta_0", "°", "tilt of the top that is held", [10.0, 45.0], 30.0, dragged(|values| tip(values, MIDDLE));
    TURNS: "turns", "n", "turns/s", "spin of the top", [20.0, 60.0], 30.0;
}
/// The parameters; the nose is the handle of the tilt.
pub const WOODEN: &[Parameter] = &[TILT, TURNS];
/// Those of the question.
pub const ASKED: &[Parameter] = &[TILT.dragged(|values| tip(values, ASIDE)), TURNS];

/// Where the tip of the axle stands, units: under the middle of the path, and so that the top alone is in the middle.
const MIDDLE: f64 = 292.0;
const ASIDE: f64 = 360.0;

fn view(foot: f64) -> View {
    View::new(0.0, 0.5, [foot, 350.0], 3300.0)
}

fn tip(values: &Values, foot: f64) -> Point {
    let (sin, cos) = values.of(&TILT).to_radians().sin_cos();
    view(foot).project(&(Vector::new(0.0, -sin, cos) * NOSE))
}

/// The top and its motion from rest of the axis.
fn launched(values: &Values) -> Result<LagrangeTop> {
    let [tilt, turns] = values.each([TILT, TURNS]);
    let tilted = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), tilt.to_radians())?;
    let spin = BodyVector::new(0.0, 0.0, TAU * turns);
    LagrangeTop::new(ACROSS, ALONG, MASS * GRAVITY * ARM, spin, tilted)
}

/// The part of the caption that the figures share.
fn described(values: &Values) -> String {
    let [tilt, turns] = briefs(values.each([TILT, TURNS]));
    format!(
        "A wooden top of 100 g, its centre of mass 4 cm above the tip, $I_1 = 2 \\cdot 10^{{-4}}$ and $I_3 = 7 \\cdot 10^{{-5}}$ kg m², tilted by {tilt}° and spun at {turns} turns a second; \
         the disc is the thin one of the same $I_3$."
    )
}

/// The question: which way?
pub fn wooden_top(values: &Values) -> Result<Figure> {
    let (body, tilt) = (described(values), brief(values.of(&TILT)));
    let words = words!(
        "A spinning top leans, and a finger holds its axis still.",
        "{body} Which way does the nose go when the finger lets go?",
        "A disc on an axle that stands on its tip, {tilt} degrees off the vertical, which is dotted. From the nose four dashed arrows with question marks: up, down, to one side, to the other."
    );
    drawn("wooden-top", values, words, false)
}

/// The answer: the path of the nose.
pub fn let_go(values: &Values) -> Result<Figure> {
    let top = launched(values)?;
    let lowest = top.at(0.5 * top.period())?.height.acos().to_degrees();
    let further = top.precession_per_nutation().unwrap_or(0.0).to_degrees();
    let [fallen, aside] = numbers([lowest - values.of(&TILT), further], 2);
    let (back, arches) = (number(top.period(), 4), number(360.0 / further, 1));
    let body = described(values);
    let words = words!(
        "Let go, the nose falls by {fallen}°, turns aside, and is back at the height of the finger after {back} s, {aside}° further round.",
        "{body} The nose for {SHOWN} s, a dot every hundredth of a second.",
        "The same top, and the path of its nose: arches that hang from one level circle and meet in upright cusps, {arches} of them in a full turn. In the cusps the dots crowd."
    );
    drawn("wooden-top-let-go", values, words, true)
}

fn drawn(name: &'static str, values: &Values, words: Words, path: bool) -> Result<Figure> {
    let view = view(if path { MIDDLE } else { ASIDE });
    let top = launched(values)?;
    let times = spaced([0.0, SHOWN], 2000);
    let noses = tried(times.clone(), |t| nose(&top, t))?;
    let held = noses[0];
    let roots = top.roots();
    let made = figure(name, 392.0, words, |pen| {
        let at = |p: &Vector| view.project(p);
        let [foot, hub, tip] = [0.0, ARM, NOSE].map(|out| held * out);
        let rim = (2.0 * ALONG / MASS).sqrt();
        let level = held.cross(&Vector::z()).normalize();
        let rim = ellipse(hub, level * rim, held.cross(&level) * rim, 120);
        let rim = view.trace(&rim);
        let upright = [foot, Vector::z() * NOSE].map(|p| at(&p));
        pen.line(upright, muted(AXIS).dotted());
        pen.line([at(&foot), at(&hub)], inked(DATA));
        pen.fill(&rim, Ink, 0.1);
        pen.outline(&rim, inked(SECONDARY));
        pen.line([at(&hub), at(&tip)], inked(DATA));
        pen.dot(at(&foot), 3.0);
        pen.dot(at(&tip), 5.0);
        if path {
            let line: Vec<Point> = noses.iter().map(|p| at(&(p * NOSE))).collect();
            for height in [roots.h1, roots.h2] {
                let out = NOSE * (1.0 - height * height).sqrt();
                let circle = latitude(NOSE * height, out, 180);
                pen.line(view.trace(&circle), muted(AXIS).dotted());
            }
            pen.line(&line, inked(SECONDARY));
            for dot in line.iter().step_by(20) {
                pen.dot(*dot, 2.4);
            }
        } else {
            let (aside, down) = (level * 0.02, held.cross(&level) * 0.02);
            for way in [aside, -aside, down, -down] {
                let [from, to] = [0.3, 1.0].map(|share| at(&(tip + way * share)));
                pen.arrow(from, to, inked(SECONDARY).dashed());
                let beyond = (0..24).map(|k| polar(to, 14.0, 0.262 * f64::from(k)));
                pen.name(beyond, "?", label(Ink));
            }
        }
        let tilt = brief(values.of(&TILT)) + "°";
        let between = (0..40).map(|k| at(&((Vector::z() + held) * (0.01 + 0.001 * f64::from(k)))));
        pen.name(between, &tilt, small(Ink));
    });
    let columns = "time (s) | tilt (°) | azimuth (°)";
    let shown = if path { noses.len() } else { 1 };
    let rows = times.zip(noses).take(shown);
    Ok(made.data("nose", columns, rows.map(angles)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Newton in space, e' = L ∧ e / I₁ and L' = Mgl z ∧ e, by the midpoint rule: the nose is where the figure has it.
    #[test]
    fn small_steps_draw_the_same_arches() {
        let figure = let_go(&Values::default()).expect("a figure");
        let weight = 0.1 * 9.81 * 0.04;
        let (sin, cos) = 30_f64.to_radians().sin_cos();
        let mut e = Vector::new(0.0, -sin, cos);
        let mut l = e * 7e-5 * 60.0 * PI;
        let rate = |e: Vector, l: Vector| (l.cross(&e) / 2e-4, Vector::z().cross(&e) * weight);
        let steps = 50;
        let step = 0.5 / 1000.0 / f64::from(steps);
        for (_, row) in figure.data.rows.iter().take(1000) {
            let azimuth = e.y.atan2(e.x).to_degrees();
            let tilt = e.x.hypot(e.y).atan2(e.z).to_degrees();
            let off = (row[1] - tilt).hypot((row[2] - azimuth + 540.0).rem_euclid(360.0) - 180.0);
            assert!(off < 1e-4, "{row:?}: {tilt} {azimuth}");
            for _ in 0..steps {
                let (turn, push) = rate(e, l);
                let (turn, push) = rate(e + 0.5 * step * turn, l + 0.5 * step * push);
                (e, l) = (e + step * turn, l + step * push);
            }
        }
    }
}
