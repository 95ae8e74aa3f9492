//! Which strips flutter and which tumble: the regimes along the axis of the mass ratio.

use core::f64::consts::FRAC_PI_4;

use spinning_bodies::falling_strip::{
    Coefficients, Fall, MEASURED_FROUDE, Regime, Sheet, Start, transition,
};

use crate::prelude::*;

const LINE: Axis = Axis::log([0.25, 12.0], [40.0, 580.0]);
/// Widths of the strips that are drawn, cm, and units to a centimetre.
const STRIPS: [f64; 4] = [30.0, 15.0, 5.0, 1.0];
const CENTIMETRE: f64 = 3.0;

/// The regimes of these mass ratios, six by six: those at the ends, and where these two differ, all.
fn stretches(ratios: &[f64], coefficients: Coefficients) -> Result<Vec<Regime>> {
    let regime = |ratio: &f64| -> Result<Regime> {
        let run = Fall::new(*ratio, coefficients)?.long_run(Start::TILTED, 200.0, 200.0)?;
        Ok(run.regime)
    };
    let mut all = Vec::new();
    for part in ratios.chunks(6) {
        let ends = [regime(&part[0])?, regime(&part[part.len() - 1])?];
        match ends[0] == ends[1] {
            true => all.extend(part.iter().map(|_| ends[0])),
            false => all.extend(tried(part, regime)?),
        }
    }
    Ok(all)
}

/// Regimes against the mass ratio, for both sets of coefficients and for paper. It takes a hundred long runs, so the figure has no parameters.
pub fn regimes(_: &Values) -> Result<Figure> {
    let ratios = Vec::from_iter((0..=150).map(|k| 0.25 * 48_f64.powf(f64::from(k) / 150.0)));
    let sets = [Coefficients::PAPER, Coefficients::PUBLISHED];
    let rows = tried(sets, |set| stretches(&ratios, set))?;
    let ends = [
        transition(sets[0], 0.4, 0.6, 1e-4, 400.0)?,
        transition(sets[1], 1.1, 1.3, 1e-4, 400.0)?,
    ];
    let sheet = Sheet::of_paper(0.01)?;
    let (froude, error) = MEASURED_FROUDE;
    let measured = [froude - error, froude, froude + error].map(|f| f * f / FRAC_PI_4);
    let width = |ratio: f64| sheet.width_for(ratio).map(|w| 100.0 * w);
    let widths = [width(ends[0])?, width(measured[1])?, width(ends[1])?];
    let [ours, theirs] = numbers(ends, 3);
    let seen = number(measured[1], 2);
    let [first, second, third] = numbers(widths, 1);
    let words = words!(
        "Wide strips flutter, narrow ones tumble; where the one becomes the other, experiment decides.",
        "Mass ratio $I^* = 4\\sigma/(\\pi\\rho b)$, $b$ the width. Flutter ends at $I^* = {ours}$ with the coefficients fitted to paper, at {theirs} with the published ones; measured is \
         {seen} (Froude number $0.67 \\pm 0.05$, grey band). For paper of 80 g/m² these are widths of {first}, {third} and {second} cm. Above: strips end on, to one scale.",
        "Two bars along a logarithmic axis of the mass ratio from a quarter to twelve. In the upper one, for paper, flutter ends at 0.53, within a grey band that marks the measured transition, and all the rest \
         is tumbling. In the lower one, with the published coefficients, flutter reaches to 1.22, a short stretch of tumbling follows, then mixed and chaotic motion, then \
         flutter again. Above the bars four strips of paper, of 30, 15, 5 and 1 centimetres width, each at its mass ratio."
    );
    Ok(figure("strip-regimes", 370.0, words, |pen| {
        // The measured band.
        let [low, middle, high] = measured.map(|ratio| LINE.at(ratio));
        pen.fill(boxed([low, 128.0], [high, 300.0]), Muted, 0.16);
        pen.line([[middle, 128.0], [middle, 300.0]], muted(AXIS).dashed());
        pen.remark([middle, 122.0], Middle, "measured");
        // Strips end on, to scale, over their mass ratio.
        for (k, centimetres) in STRIPS.into_iter().enumerate() {
            let ratio = sheet.mass_ratio() / centimetres;
            let x = LINE.at(ratio);
            let half = 0.5 * CENTIMETRE * centimetres;
            let y = if k == 1 { 84.0 } else { 56.0 };
            pen.line([[x - half, y], [x + half, y]], inked(3.0));
            let text = format!("{centimetres:.0} cm");
            pen.note([x, y - 10.0], Middle, &text);
        }
        pen.remark([580.0, 100.0], End, "strips of paper, end on");
        for (row, (name, y)) in rows.iter().zip([("our fit", 170.0), ("published", 256.0)]) {
            pen.label([40.0, y - 20.0], Start, name);
            // Stretches of one regime.
            let mut k = 0;
            for part in row.chunk_by(|a, b| a == b) {
                let from = k;
                k += part.len();
                // Half-way between two ratios; at the ends, the ratio there.
                let edge = |i: usize| {
                    let two = [i.saturating_sub(1), i.min(row.len() - 1)];
                    0.5 * two.map(|i| LINE.at(ratios[i])).iter().sum::<f64>()
                };
                let (left, right) = (edge(from), edge(k));
                let (alpha, name) = match part[0] {
                    Regime::Steady => (0.12, "steady"),
                    Regime::Flutter => (0.12, "flutter"),
                    Regime::Tumble => (0.62, "tumble"),
                    Regime::Mixed => (0.34, "mixed, chaotic"),
                };
                pen.fill(boxed([left, y - 12.0], [right, y + 12.0]), Ink, alpha);
                if right - left > 56.0 {
                    // Next to the line of the measured values, not over it.
                    let at = 0.5 * (left + right);
                    let over = (at - middle).abs() < 40.0;
                    let at = if over { left + 50.0 } else { at };
                    pen.note([at, y + 30.0], Middle, name);
                }
            }
        }
        for (ratio, y) in ends.into_iter().zip([170.0, 256.0]) {
            let x = LINE.at(ratio);
            pen.line([[x, y - 14.0], [x, y + 14.0]], inked(DATA));
        }
        pen.line([[40.0, 318.0], [580.0, 318.0]], inked(SECONDARY));
        for (ratio, text) in marks(&[0.25, 0.5, 1.0, 2.0, 5.0, 10.0], "") {
            let x = LINE.at(ratio);
            pen.line([[x, 318.0], [x, 324.0]], inked(AXIS));
            pen.remark([x, 339.0], Middle, &text);
        }
        pen.label([580.0, 360.0], End, "mass ratio *I*^{\u{2217}}");
    }))
}
