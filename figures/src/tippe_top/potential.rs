//! The effective potential of the tippe top, deformed by spin.

use spinning_bodies::tippe_top::{Inversion, TippeTop};

use super::toys::*;
use crate::prelude::*;

/// Spins of the other curves, rad/s: the first and the last set the scale.
const SPINS: [f64; 4] = [20.0, 40.0, 50.0, 90.0];

const CHOSEN: Parameter = SPIN.between([SPINS[0], SPINS[3]], 65.0).dragged(head);
/// The parameters; the end of the heavy curve is dragged.
pub const POTENTIAL: &[Parameter] = &[CHOSEN, ALPHA, GAMMA];

/// M g R of the top, J.
const UNIT: f64 = 0.02 * G_TIPPE * 0.02;

/// V(θ) − V(0) over MgR for a spin about the upright axis.
fn height(top: &TippeTop, spin: f64, tilt: f64) -> f64 {
    let jellett = top.jellett_of_spin(spin, 0.0);
    (top.effective_potential(tilt, jellett) - top.effective_potential(0.0, jellett)) / UNIT
}

/// The diagram: from the deepest place to the highest. At every tilt the height is linear in the square of the spin, so the first and the last curve hold all.
fn frame(top: &TippeTop) -> Frame {
    let heights = |spin: f64| spaced([0.0, PI], 60).map(move |tilt| height(top, spin, tilt));
    let [low, high] = extent(heights(SPINS[0]).chain(heights(SPINS[3])));
    let room = 0.06 * (high - low);
    let places = [58.0, 500.0, 352.0, 36.0];
    Frame::linear([0.0, 180.0], [low - room, high + room], places)
}

/// Where the heavy curve ends.
fn head(values: &Values) -> Point {
    tippe(values.of(&ALPHA), values.of(&GAMMA)).map_or([0.0; 2], |top| {
        frame(&top).at(180.0, height(&top, values.of(&CHOSEN), PI))
    })
}

/// With spin the minimum moves from the upright to the inverted position.
pub fn effective(values: &Values) -> Result<Figure> {
    let [chosen, alpha, gamma] = values.each([CHOSEN, ALPHA, GAMMA]);
    let top = tippe(alpha, gamma)?;
    let mut spins: Vec<f64> = SPINS.into_iter().chain([chosen]).collect();
    spins.sort_by(f64::total_cmp);
    spins.dedup();
    let ends = tried(&spins, |&spin| {
        top.final_tilt(top.jellett_of_spin(spin, 0.0), 1e-3)
    })?;
    let told = |tilt: &f64| format!("{}°", number(tilt.to_degrees(), 1));
    let listed: Vec<String> = ends.iter().map(told).collect();
    let (greatest, farthest) = (ends[ends.len() - 1], &listed[ends.len() - 1]);
    let rise = top.least_spin_to_rise();
    let fastest = number(SPINS[3], 0);
    let claim = match (top.inversion(), top.least_spin_to_invert()) {
        (Inversion::Never, _) => "However fast this top is spun, the upright place stays a hollow, and friction leaves it there.".to_owned(),
        _ if greatest < 0.01 => format!(
            "Spin up to {fastest} rad/s leaves a hollow at the upright place, and the top in it: it begins to rise at {} rad/s.",
            number(rise.unwrap_or(0.0), 1)
        ),
        (Inversion::Partial, _) => format!(
            "Spin moves the lowest place from upright as far as {farthest} at {fastest} rad/s, and at no spin to the head; friction brings the top there."
        ),
        (Inversion::Complete, Some(invert)) if invert > SPINS[3] => format!(
            "Spin moves the lowest place from upright as far as {farthest} at {fastest} rad/s, and to the head at {invert:.1} rad/s; friction brings the top there."
        ),
        (Inversion::Complete, _) => "Spin moves the lowest place from upright to upside down, and friction brings the top there.".to_owned(),
    };
    let lost = match rise {
        Some(rise) => format!("Upright is lost at {rise:.2} rad/s"),
        None => "Upright is never lost".to_owned(),
    };
    let reached = match top.least_spin_to_invert() {
        Some(invert) => format!("the head is reached from {invert:.2} rad/s on"),
        None => "the head is never reached".to_owned(),
    };
    let [heavy, alpha, gamma] = briefs([chosen, alpha, gamma]);
    let (count, listed) = (spins.len(), listed.join(", "));
    let words = words!(
        "{claim}",
        "Effective potential $V(\\theta)$ of a tippe top with $\\alpha = {alpha}$, $I_1/I_3 = {gamma}$, less $V(0)$, over $MgR$, for {count} spins about the upright axis; \
         heavy: {heavy} rad/s. Discs: where a top ends, at {listed}. {lost}, {reached}.",
        "Curves over the tilt from 0 to 180 degrees, all from the same point at 0. A disc marks the place where a top of each ends: \
         from the slowest to the fastest at {listed}."
    );
    let curve = |spin: f64| {
        let tilts = (0..=180).map(f64::from);
        tilts.map(move |tilt| [tilt, height(&top, spin, tilt.to_radians())])
    };
    let made = figure("tippe-potential", 400.0, words, |pen| {
        let frame = frame(&top);
        let names = ["tilt *θ*", "(*V* − *V* (0))/*MgR*"];
        frame.draw(pen, &marks(&TILTS, "°"), &frame.y.ticks(45.0), names);
        let right = spins.iter().map(|&spin| frame.y.at(height(&top, spin, PI)));
        let right: Vec<f64> = right.collect();
        let labels = apart(&right, 18.0, 352.0);
        for (k, &spin) in spins.iter().enumerate() {
            let (width, role) = match spin == chosen {
                true => (1.5 * DATA, Ink),
                false => (SECONDARY, Muted),
            };
            frame.curve(pen, curve(spin), stroke(role, width));
            let at = frame.at(ends[k].to_degrees(), height(&top, spin, ends[k]));
            pen.dot(at, 5.0);
            let text = brief(spin) + " rad/s";
            pen.text([516.0, labels[k] + 5.0], Start, &text, small(role));
        }
    });
    let columns = "tilt (°) | (V − V(0))/MgR";
    Ok(spins.iter().fold(made, |made, &spin| {
        made.data(format!("{spin} rad/s"), columns, curve(spin))
    }))
}
