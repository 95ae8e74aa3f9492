//! The falling strip (tutorial 4.10).

mod animated;
mod regimes;

use crate::prelude::*;
use spinning_bodies::falling_strip::{Coefficients, Fall, LongRun, Regime, Sheet, Start};

/// The figures of the chapter, in its order.
pub const FIGURES: &[Entry] = &[
    of("strip-animated", &[], animated::animated),
    of("strip-paths", &[], paths),
    of("strip-regimes", &[], regimes::regimes),
    of("strip-rate", &[], rate),
];

/// Long runs of all these mass ratios.
fn scan(ratios: &[f64], coefficients: Coefficients) -> Result<Vec<LongRun>> {
    ratios
        .iter()
        .map(|&ratio| Fall::new(ratio, coefficients)?.long_run(Start::TILTED, 300.0, 300.0))
        .collect()
}

/// Panels: mass ratio, what it shows, where, from when on and how long, units of time.
const PANELS: [(f64, &str, Point, f64, f64); 6] = [
    (1.1, "flutter", [88.0, 46.0], 406.0, 32.0),
    (1.4, "tumbling", [258.0, 46.0], 400.0, 22.0),
    (1.45, "tumbling in two steps", [462.0, 46.0], 400.0, 22.0),
    (1.6, "now this, now that", [100.0, 310.0], 410.0, 30.0),
    (2.2, "chaos", [300.0, 310.0], 420.0, 30.0),
    (3.0, "broadside flutter", [500.0, 310.0], 400.0, 18.0),
];
/// Design units to half a width of the plate.
const UNIT: f64 = 9.5;

/// Six ways to fall: mass ratios and moments chosen by hand, for each panel has its own room.
pub fn paths(_: &Values) -> Result<Figure> {
    let drawn: Vec<(Vec<[f64; 7]>, LongRun)> = PANELS
        .iter()
        .map(|&(ratio, _, _, from, lasts)| {
            let fall = Fall::new(ratio, Coefficients::PUBLISHED)?;
            let times = (0..=400).map(|k| from + lasts * f64::from(k) / 400.0);
            let times: Vec<f64> = times.collect();
            let path = fall.path(Start::TILTED, &times)?;
            Ok((path, fall.long_run(Start::TILTED, 400.0, 400.0)?))
        })
        .collect::<Result<_>>()?;
    let told = |k: usize| {
        drawn[k]
            .1
            .period
            .map_or("none".to_owned(), |p| number(p, 2))
    };
    let [a, b, c, d, e, f] = [0, 1, 2, 3, 4, 5].map(told);
    let words = words!(
        "One plate, six weights, six ways to fall.",
        "The equations of Andersen, Pesavento and Wang with their coefficients; the mass ratio $I^*$ is the plate's mass over that of the fluid cylinder around it. \
         Plates to scale at equal times, after the beginnings are forgotten. Periods, in units $a/U$, up to a half turn: {a}, {b}, {c}, {d}, {e} and {f}.",
        "Six panels with a falling plate drawn again and again as a short line. It swings from side to side; it turns over and over and sails down a straight slope; \
         it does so with long and short steps in turn; it changes between swinging and turning over; it does both without a rule; and it rocks a little \
         on its way nearly straight down."
    );
    Ok(figure("strip-paths", 590.0, words, |pen| {
        for ((ratio, name, corner, ..), (path, _)) in PANELS.iter().zip(&drawn) {
            let xs = || path.iter().map(|y| y[0]);
            let (low, high) = xs().fold((f64::MAX, f64::MIN), |(l, h), x| (l.min(x), h.max(x)));
            let middle = 0.5 * (low + high);
            // Always to the right, so that panels can be compared.
            let sign = if path[400][0] < path[0][0] { -1.0 } else { 1.0 };
            let place = |x: f64, y: f64| -> Point {
                [
                    corner[0] + UNIT * sign * (x - middle),
                    corner[1] + 16.0 - UNIT * (y - path[0][1]),
                ]
            };
            let center = path.iter().map(|y| place(y[0], y[1]));
            pen.line(center, muted(SECONDARY).alpha(0.9));
            for y in path.iter().step_by(10) {
                let (sine, cosine) = y[2].sin_cos();
                let ends = [1.0, -1.0].map(|s| place(y[0] + s * cosine, y[1] + s * sine));
                pen.line(ends, inked(1.5).alpha(0.75));
            }
            let [x, y] = *corner;
            let text = format!("*I*^{{\u{2217}}} = {ratio}");
            pen.label([x, y - 24.0], Middle, &text);
            pen.remark([x, y - 7.0], Middle, name);
        }
    }))
}

/// Rotation rate of strips of paper against their width. Fifty long runs: it stays as the book has it.
pub fn rate(_: &Values) -> Result<Figure> {
    let widths = (0..48).map(|k| 0.5 * 36_f64.powf(f64::from(k) / 47.0));
    let widths: Vec<f64> = widths.collect();
    let sheets = widths.iter().map(|w| Sheet::of_paper(w / 100.0));
    let sheets: Vec<Sheet> = sheets.collect::<Result<_>>()?;
    let ratios: Vec<f64> = sheets.iter().map(Sheet::mass_ratio).collect();
    let runs = scan(&ratios, Coefficients::PAPER)?;
    let frame = Frame::log([0.4, 24.0], [0.4, 40.0], [76.0, 570.0, 330.0, 40.0]);
    let hertz = |k: usize| runs[k].rotation.abs() / sheets[k].time() / TAU;
    let curve: Vec<Point> = (0..runs.len())
        .filter(|&k| runs[k].regime == Regime::Tumble)
        .map(|k| frame.at(widths[k], hertz(k)))
        .collect();
    let at = |width: f64| {
        (0..widths.len()).min_by(|&a, &b| {
            (widths[a] - width)
                .abs()
                .total_cmp(&(widths[b] - width).abs())
        })
    };
    let one = at(1.0).map_or(f64::NAN, hertz);
    let law = [0.45, 20.0].map(|w| frame.at(w, one / w));
    let exponent = |low: f64, high: f64| {
        let [a, b] = [low, high].map(|w| at(w).unwrap_or(0));
        (hertz(a) / hertz(b)).ln() / (widths[a] / widths[b]).ln()
    };
    let slope = exponent(0.78, 2.8);
    let power = number(slope, 2);
    let words = words!(
        "The narrower the strip, the faster it spins.",
        "Paper of 80 g/m² in air, with the coefficients fitted to paper. Between 0.8 and 2.8 cm the rate goes as the width to the power ${power}$; the scaling law of Mahadevan, Ryu and Samuel, \
         dashed, has $-1$. Beyond 10 cm long and short half turns take turns. The curve ends where the strip is so wide that it flutters.",
        "Turns per second against width, both on logarithmic axes. The curve falls from about twenty-five turns a second at half a centimetre to one at fifteen, \
         a little less steeply than the dashed line of the scaling law, and ends with a drop at sixteen centimetres."
    );
    Ok(figure("strip-rate", 390.0, words, |pen| {
        frame.draw(
            pen,
            &marks(&[0.5, 1.0, 2.0, 5.0, 10.0, 20.0], ""),
            &marks(&[0.5, 1.0, 2.0, 5.0, 10.0, 20.0], ""),
            ["width, cm", "turns per second"],
        );
        pen.line(law, muted(SECONDARY).dashed());
        pen.line(&curve, inked(DATA));
        let [x, y] = frame.at(4.6, one / 4.6);
        pen.remark([x - 14.0, y + 22.0], End, "rate ~ 1/width");
        let [x, y] = frame.at(1.3, 13.0);
        pen.label([x + 12.0, y - 6.0], Anchor::Start, "paper, 80 g/m²");
        if let Some(end) = curve.last() {
            pen.dot(*end, 4.0);
            pen.note([end[0] - 10.0, end[1] + 5.0], End, "flutter begins");
        }
    }))
}
