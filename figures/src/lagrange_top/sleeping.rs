//! f(h) and its roots while the spin of a sleeping top falls through the threshold (tutorial 7.5).

use spinning_bodies::lagrange_top::{Roots, tilt_after_kick};

use super::launch::launch;
use crate::prelude::*;

parameters! {
    ABOVE: "above", "L_3", "", "axial momentum of the fastest top", [2.05, 3.0], 2.4;
    BELOW: "below", "L_3", "", "axial momentum of the slowest top", [1.2, 1.95], 1.7, dragged(|values| shown(values).at(loner(values.of(&BELOW)), 0.0));
    KICK: "kick", r"\Omega_\perp", "", "angular velocity across the axis after a kick, in units of the square root of Mgℓ/I₁", [1e-4, 0.1], 0.01, logarithmic;
}
/// The parameters; the handle is the root of the slowest top.
pub const CHOSEN: &[Parameter] = &[ABOVE, BELOW, KICK];

/// L₃ at the threshold.
const THRESHOLD: f64 = 2.0;
/// The height of zero, and of the lowest and the highest place of a curve, units.
const ZERO: f64 = 140.0;
const ENDS: [f64; 2] = [303.0, 30.0];
/// Units above zero that the highest crest takes.
const CREST: f64 = 44.0;

/// The root, for a top that spins upright, other than the double one (7.5): h = L₃²/2I₁Mgl − 1.
fn loner(axial: f64) -> f64 {
    0.5 * axial * axial - 1.0
}

/// The part of the plane of h and f that is shown: from left of the slowest top's root, whose crest is 8(1 − root)³/27 high.
fn shown(values: &Values) -> Frame {
    let root = loner(values.of(&BELOW));
    let crest = 8.0 / 27.0 * (1.0 - root).powi(3);
    let left = (root - 0.045).min(0.4);
    let unit = (CREST / crest).min(760.0);
    let [low, high] = ENDS.map(|y| (ZERO - y) / unit);
    let right = 1.0 + (1.0 - left) * 14.0 / 15.0;
    Frame {
        x: Axis::linear([left, right], [44.0, 556.0]),
        y: Axis::linear([low, high], ENDS),
    }
}

fn axes(pen: &mut Pen, shown: &Frame) {
    let ink = inked(AXIS);
    let ([left, right], [low, high]) = (shown.x.ends, ENDS);
    pen.line([[left, ZERO], [right, ZERO]], ink);
    pen.line([[left, low], [left, high]], ink);
    let x = shown.x.at(1.0);
    pen.line([[x, low], [x, high]], muted(HAIR).dotted());
    for (h, text) in shown.x.ticks(150.0) {
        let at = shown.at(h, 0.0);
        pen.line([at, shifted(at, [0.0, 5.0])], ink);
        if at[0] > left + 5.0 {
            // On the side that the curves leave free.
            let half = 4.0 * text.chars().count() as f64;
            let places = [[4.0 + half, 19.0], [-4.0 - half, 19.0], [4.0 + half, 30.0]];
            pen.name(places.map(|by| shifted(at, by)), &text, small(Ink));
        }
    }
    pen.label([left + 10.0, high - 6.0], Start, "*f*(*h*)");
    pen.label([right + 9.0, ZERO + 5.0], Start, "*h*");
}

/// f(h) from its roots (7.2), I₁ = Mgl = 1.
fn cubic(roots: &Roots, h: f64) -> f64 {
    2.0 * (h - roots.h1) * (h - roots.h2) * (h - roots.h3)
}

/// The third root goes through the double one, and the sign of f next to h = 1 changes.
pub fn threshold(values: &Values) -> Result<Figure> {
    let [above, below, kick] = values.each([ABOVE, BELOW, KICK]);
    let [faster, slower] = [above, below].map(|spin| 0.5 * (spin + THRESHOLD));
    let spins = [above, faster, THRESHOLD, slower, below];
    let shown = shown(values);
    let [lowest, highest] = shown.y.shown;
    let curves = tried(spins, |axial| {
        let roots = launch(1.0, 0.0, axial)?.roots();
        let curve = spaced(shown.x.shown, 600)
            .map(|h| [h, cubic(&roots, h)])
            .filter(|[_, f]| (lowest..=highest).contains(f));
        Ok((axial, curve.collect::<Vec<Point>>()))
    })?;
    let tilt = |axial: f64| -> Result<String> {
        let tilt = tilt_after_kick(1.0, 1.0, axial, kick)?;
        Ok(number(tilt.to_degrees(), 2))
    };
    let (fast, at, slow) = (tilt(above)?, tilt(THRESHOLD)?, tilt(below)?);
    let root = number(loner(below), 3);
    let [above, below] = [above, below].map(brief);
    let push = brief(kick);
    let words = words!(
        "A top sleeps until its third root has come down past the upright position.",
        "$f(h)$ of an upright top, $I_1 = Mg\\ell = 1$, as $L_3$ falls from {above} to {below}. The motion needs $f\\ge0$: shaded, the room \
         below $h = 1$ that opens under the threshold $L_3 = 2$, thick, down to $\\cos\\theta = {root}$ for {below}. A sideways kick of {push} tilts the \
         top by {fast}° at $L_3 = {above}$, by {at}° at 2 and by {slow}° at {below}.",
        "Five cubics that all touch or cross zero at h = 1. For fast spin the curve touches zero from below at 1 and crosses further right. \
         As the spin falls the crossing moves left, reaches 1 at the threshold, where the curve has a flat crossing, and goes on to {root} for \
         the slowest top, of axial momentum {below}: there the curve is positive between the crossing and 1, and the top falls over as far as that."
    );
    let made = figure("sleeping-threshold", 332.0, words, |pen| {
        for (axial, curve) in &curves {
            let points = shown.trace(curve.iter().copied());
            let style = match axial.total_cmp(&THRESHOLD) {
                core::cmp::Ordering::Greater => inked(SECONDARY),
                core::cmp::Ordering::Equal => inked(2.8),
                core::cmp::Ordering::Less => inked(SECONDARY).dashed(),
            };
            if *axial < THRESHOLD {
                // The interval into which the top may fall.
                let inside = |p: &&Point| p[0] <= shown.x.at(1.0) && p[1] <= ZERO;
                let room = points.iter().filter(inside).copied();
                pen.fill(room, Ink, 0.13);
            }
            pen.line(&points, style);
            let root = loner(*axial);
            if root < shown.x.shown[1] {
                pen.dot(shown.at(root, 0.0), 3.6);
            }
        }
        axes(pen, &shown);
        // The number stands at the lower end of its curve, that of the last one over its crest.
        let feet = [0, 1, 2, 3].map(|k: usize| {
            let foot = curves[k].1.first().map_or(1.0, |at| at[0]);
            shown.x.at(foot)
        });
        let across = spread(feet, 42.0);
        for (x, axial) in across.into_iter().zip(spins) {
            pen.note([x, ENDS[0] + 19.0], Middle, &brief(axial));
        }
        let root = loner(spins[4]);
        let crest = shown.at((1.0 + 2.0 * root) / 3.0, 8.0 / 27.0 * (1.0 - root).powi(3));
        let text = format!("*L*_{{3}} = {below}");
        let over = [0.0, -20.0, -40.0].map(|aside| shifted(crest, [aside, -13.5]));
        pen.name(over, &text, small(Ink));
    });
    let columns = "h = cos θ | f(h) (Mgl/I1)";
    Ok(curves.into_iter().fold(made, |made, (axial, curve)| {
        let name = format!("L3 = {}", brief(axial));
        made.data(name, columns, curve)
    }))
}
