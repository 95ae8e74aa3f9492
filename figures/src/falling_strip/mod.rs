//! The falling strip (tutorial 4.10).

mod animated;
mod regimes;

use spinning_bodies::falling_strip::{Coefficients, Fall, Regime, Sheet, Start};

use crate::prelude::*;

/// The figures of the chapter, in its order.
pub const FIGURES: &[Entry] = &[
    of("strip-animated", &[], animated::animated),
    of("strip-paths", &[], paths),
    of("strip-regimes", &[], regimes::regimes),
    of("strip-rate", &[], rate),
];

/// Panels: mass ratio, name of the motion, place, start and duration, units of time.
const PANELS: [(f64, &str, Point, f64, f64); 6] = [
    (1.1, "flutter", [88.0, 46.0], 406.0, 32.0),
    (1.4, "tumbling", [258.0, 46.0], 400.0, 22.0),
    (1.45, "tumbling in two steps", [462.0, 46.0], 400.0, 22.0),
    (1.6, "now this, now that", [100.0, 310.0], 410.0, 30.0),
    (2.2, "chaos", [300.0, 310.0], 420.0, 30.0),
    (3.0, "broadside flutter", [500.0, 310.0], 400.0, 18.0),
];
/// Design units to half a width of the plate.
const UNIT: f64 = 10.4;

/// Six ways to fall: mass ratios and times are chosen by hand to fit each panel.
pub fn paths(_: &Values) -> Result<Figure> {
    let drawn = tried(PANELS, |(ratio, _, _, from, lasts)| {
        let fall = Fall::new(ratio, Coefficients::PUBLISHED)?;
        let times = (0..=400).map(|k| from + lasts * f64::from(k) / 400.0);
        let path = fall.path(Start::TILTED, &times.collect::<Vec<_>>())?;
        let run = fall.long_run(Start::TILTED, 400.0, 400.0)?;
        Ok((path, run.period.map_or("none".to_owned(), |p| number(p, 2))))
    })?;
    let [a, b, c, d, e, f] = [0, 1, 2, 3, 4, 5].map(|k: usize| &drawn[k].1);
    let words = words!(
        "One plate, six weights, six ways to fall.",
        "The equations of Andersen, Pesavento and Wang with their coefficients; the mass ratio $I^*$ is the plate's mass over that of the fluid cylinder around it. \
         Plates to scale at equal times, after the beginnings are forgotten. Periods, in units $a/U$, the two sides of a plate being alike: {a}, {b}, {c}, {d}, {e} and {f}.",
        "Six panels with a falling plate drawn again and again as a short line. It swings from side to side; it turns over and over and sails down a straight slope; \
         it does so with long and short steps in turn; it changes between swinging and turning over; it does both without a rule; and it rocks a little \
         on its way nearly straight down."
    );
    Ok(figure("strip-paths", 590.0, words, |pen| {
        for ((ratio, name, corner, ..), (path, _)) in PANELS.iter().zip(&drawn) {
            let [low, high] = extent(path.iter().map(|y| y[0]));
            let middle = 0.5 * (low + high);
            // Always to the right, so that panels can be compared.
            let sign = if path[400][0] < path[0][0] { -1.0 } else { 1.0 };
            let place = |x: f64, y: f64| {
                let place = [sign * (x - middle), y - path[0][1]];
                planned(shifted(*corner, [0.0, 16.0]), UNIT, place)
            };
            let center = path.iter().map(|y| place(y[0], y[1]));
            pen.line(center, muted(AXIS));
            for y in path.iter().step_by(10) {
                let (sine, cosine) = y[2].sin_cos();
                let ends = [1.0, -1.0].map(|s| place(y[0] + s * cosine, y[1] + s * sine));
                pen.line(ends, inked(SECONDARY).alpha(0.7));
            }
            let text = format!("*I*^{{\u{2217}}} = {ratio}");
            pen.label(shifted(*corner, [0.0, -24.0]), Middle, &text);
            pen.remark(shifted(*corner, [0.0, -7.0]), Middle, name);
        }
    }))
}

/// Rotation rate of strips of paper against their width. It takes fifty long runs, so the figure has no parameters.
pub fn rate(_: &Values) -> Result<Figure> {
    let widths = (0..48).map(|k| 0.5 * 36_f64.powf(f64::from(k) / 47.0));
    let widths: Vec<f64> = widths.collect();
    let sheets = tried(&widths, |w| Sheet::of_paper(w / 100.0))?;
    let ratios: Vec<f64> = sheets.iter().map(Sheet::mass_ratio).collect();
    let runs = tried(&ratios, |&ratio| {
        Fall::new(ratio, Coefficients::PAPER)?.long_run(Start::TILTED, 300.0, 300.0)
    })?;
    let frame = Frame::log([0.4, 24.0], [0.4, 40.0], [76.0, 570.0, 330.0, 40.0]);
    let hertz = |k: usize| runs[k].rotation.abs() / sheets[k].time() / TAU;
    let curve: Vec<Point> = (0..runs.len())
        .filter(|&k| runs[k].regime == Regime::Tumble)
        .map(|k| frame.at(widths[k], hertz(k)))
        .collect();
    // The strip whose width is nearest to this one.
    let at = |width: f64| {
        let off = |k: &usize| (widths[*k] - width).abs();
        (0..widths.len())
            .min_by(|a, b| off(a).total_cmp(&off(b)))
            .unwrap_or(0)
    };
    let one = hertz(at(1.0));
    let law = [0.45, 20.0].map(|w| frame.at(w, one / w));
    let (a, b) = (at(0.78), at(2.8));
    let slope = (hertz(a) / hertz(b)).ln() / (widths[a] / widths[b]).ln();
    let power = number(slope, 2);
    let words = words!(
        "The narrower the strip, the faster it spins.",
        "Paper of 80 g/m² in air, with the coefficients fitted to paper. Between 0.8 and 2.8 cm the rate goes as the width to the power ${power}$; the scaling law of Mahadevan, Ryu and Samuel, \
         dashed, has $-1$. Between 10 and 14 cm long and short half turns alternate. The curve ends where the strip is so wide that it flutters.",
        "Turns per second against width, both on logarithmic axes. The curve falls from about twenty-four turns a second at half a centimetre to one at fifteen, \
         a little less steeply than the dashed line of the scaling law, and ends with a drop at sixteen centimetres."
    );
    Ok(figure("strip-rate", 390.0, words, |pen| {
        let ticks = marks(&[0.5, 1.0, 2.0, 5.0, 10.0, 20.0], "");
        frame.draw(pen, &ticks, &ticks, ["width, cm", "turns per second"]);
        pen.line(law, muted(SECONDARY).dashed());
        pen.line(&curve, inked(DATA));
        let below = shifted(frame.at(4.6, one / 4.6), [-14.0, 22.0]);
        pen.remark(below, End, "rate ~ 1/width");
        let above = shifted(frame.at(1.3, 13.0), [12.0, -6.0]);
        pen.label(above, Anchor::Start, "paper, 80 g/m²");
        if let Some(&end) = curve.last() {
            pen.dot(end, 4.0);
            pen.note(shifted(end, [-10.0, 5.0]), End, "flutter begins");
        }
    }))
}
