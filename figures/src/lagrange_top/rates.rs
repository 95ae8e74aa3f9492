//! Slow and fast rates of pure precession against the tilt, and where they cease (tutorial 7.3).

use spinning_bodies::Error;
use spinning_bodies::lagrange_top::Nutation;

use super::launch::*;
use crate::prelude::*;

// L₃ of the curves; two have their handle where the fast branch ends, for a hanging axis, the third on its rise: rings keep apart.
parameters! {
    THIN: "thin", "L_3", "", "axial momentum of the thin curve", [0.4, 3.3], 1.2, dragged(|values| hanging(values.of(&THIN)));
    MIDDLE: "middle", "L_3", "", "axial momentum of the middle curve", [0.4, 3.3], 2.0, dragged(|values| rising(values.of(&MIDDLE), 5.0));
    THICK: "thick", "L_3", "", "axial momentum of the thick curve", [0.4, 3.3], 3.0, dragged(|values| hanging(values.of(&THICK)));
}
/// The parameters.
pub const RATES: &[Parameter] = &[THIN, MIDDLE, THICK];

/// Left, right, bottom, top of the frame, and the rates there.
const FRAME: [f64; 4] = [62.0, 540.0, 332.0, 40.0];
const SHOWN: [f64; 2] = [-3.6, 6.2];

/// The fast rate w of a hanging axis: w² + L₃w = 1.
fn hanging(axial: f64) -> Point {
    let rates = pure_rates(-1.0, axial).unwrap_or_default();
    place(PI, rates[1])
}

/// Where the fast branch reaches the rate w: cos θ = (L₃w − 1)/w².
fn rising(axial: f64, rate: f64) -> Point {
    let height = (axial * rate - 1.0) / rate.powi(2);
    place(height.acos(), rate)
}

fn place(tilt: f64, rate: f64) -> Point {
    let [left, right, bottom, top] = FRAME;
    [
        left + (right - left) * tilt / PI,
        bottom - (bottom - top) * (rate - SHOWN[0]) / (SHOWN[1] - SHOWN[0]),
    ]
}

/// A branch made of tops that precess at constant tilt: the tilts, and the rates that the library reports.
fn branch(axial: f64, which: usize, tilts: [f64; 2]) -> Result<Vec<Point>> {
    const STEPS: u32 = 240;
    let mut points = Vec::new();
    for k in 1..STEPS {
        // Closer towards the ends, where the slow and the fast branch meet.
        let share = 0.5 - 0.5 * (PI * f64::from(k) / f64::from(STEPS)).cos();
        let tilt = tilts[0] + (tilts[1] - tilts[0]) * share;
        let rate = pure_rates(tilt.cos(), axial)?[which];
        if !(SHOWN[0]..=SHOWN[1]).contains(&rate) {
            continue;
        }
        let top = launch(tilt.cos(), rate, axial)?;
        let told = top.mean_precession_rate().unwrap_or(f64::NAN);
        let roots = top.roots();
        let off = (told - rate).abs().max(roots.h2 - roots.h1);
        // Next to the end of the branches the double root of the tilt is nearly a triple one.
        if top.kind() != Nutation::PurePrecession && (off.is_nan() || off >= 1e-6) {
            return Err(Error::OutOfRange {
                quantity: "the tilt of a pure precession",
                value: tilt,
                least: tilts[0],
                greatest: tilts[1],
            });
        }
        points.push([tilt, told]);
    }
    Ok(points)
}

/// Tilt beyond which pure precession exists, if not at every tilt.
fn least_tilt(axial: f64) -> f64 {
    (0.25 * axial * axial).min(1.0).acos()
}

/// Two rates at every tilt for a fast top; for a slow one they meet and cease.
pub fn precession_rates(values: &Values) -> Result<Figure> {
    let spins = values.each([THIN, MIDDLE, THICK]);
    let mut curves = Vec::new();
    for (axial, width) in spins.into_iter().zip([1.2, 2.0, 2.8]) {
        let from = least_tilt(axial);
        let name = brief(axial);
        let branches = [
            ("slow", 0, [from, PI]),
            ("fast", 1, [from, 0.5 * PI]),
            ("fast, hanging", 1, [0.5 * PI, PI]),
        ];
        for (branch_name, which, tilts) in branches {
            let name = format!("{branch_name}, L3 = {name}");
            curves.push((name, width, which == 1, branch(axial, which, tilts)?));
        }
    }
    let ends = spins.map(|axial| (axial, least_tilt(axial)));
    let slow: Vec<&(f64, f64)> = ends.iter().filter(|(axial, _)| *axial < 2.0).collect();
    let told = |(axial, end): &&(f64, f64)| {
        let (tilt, axial) = (number(end.to_degrees(), 2), brief(*axial));
        format!("{tilt}° for $L_3 = {axial}$")
    };
    let mut told: Vec<String> = slow.iter().map(told).collect();
    told.dedup();
    let (claim, meeting) = match told[..] {
        [] => (
            "Spun fast enough, a top can precess slowly or fast at every tilt.",
            "These three spin fast enough for all tilts: below $L_3 = 2$ the two branches would meet on the dotted line.".to_owned(),
        ),
        _ => (
            "A tilted top can precess slowly or fast; if its spin is too slow and its axis too steep, not at all.",
            format!("Dotted: where the two meet, at {}; a steeper axis has no rate at all.", told.join(", ")),
        ),
    };
    let [first, second, third] = spins.map(brief);
    let height: f64 = 0.5;
    let rates = pure_rates(height, spins[2])?;
    let example = match rates[0].is_finite() {
        true => format!("{} and {}", number(rates[0], 4), number(rates[1], 4)),
        false => "none".to_owned(),
    };
    let degrees = number(height.acos().to_degrees(), 0);
    let latest = slow.iter().map(|(_, end)| end.to_degrees());
    let latest = latest.fold(0.0, f64::max);
    let branches = match told[..] {
        [] => "All of them reach the upright axis.".to_owned(),
        _ => format!(
            "Both branches of a spin below 2 meet on a dotted curve, at {latest:.0} degrees for the slowest; to the left of it there is nothing."
        ),
    };
    let words = words!(
        "{claim}",
        "Rates of pure precession against the tilt for $L_3 = {first}$ (thin), {second} and {third} (thick), $I_1 = Mg\\ell = 1.$ Slow solid, fast dashed: {example} \
         for $L_3 = {third}$ at {degrees}°. {meeting}",
        "Rates of precession against the tilt from 0 to 180 degrees for the axial momenta {first}, {second} and {third}. For each a slow branch \
         falls to the right, and a fast branch rises from the left to infinity at 90 degrees and comes back from minus infinity beyond. {branches}"
    );
    let made = figure("precession-rates", 384.0, words, |pen| {
        let tilts = [0.0, 30.0, 60.0, 90.0, 120.0, 150.0, 180.0];
        let frame = Frame::linear([0.0, 180.0], SHOWN, FRAME);
        let rates = marks(&[-2.0, 0.0, 2.0, 4.0, 6.0], "");
        frame.draw(
            pen,
            &marks(&tilts, "°"),
            &rates,
            ["tilt *θ*", "*φ*\u{2032}"],
        );
        pen.line([place(0.0, 0.0), place(PI, 0.0)], inked(AXIS));
        let rule = [place(0.5 * PI, SHOWN[0]), place(0.5 * PI, SHOWN[1])];
        pen.line(rule, muted(HAIR));
        let meeting = spaced([0.0, 0.5 * PI], 300)
            .map(|tilt| (tilt, 1.0 / tilt.cos().sqrt()))
            .filter(|(_, rate)| *rate < SHOWN[1])
            .map(|(tilt, rate)| place(tilt, rate));
        pen.line(meeting, muted(1.6).dotted());
        for (_, width, fast, points) in &curves {
            let style = inked(*width);
            let points = points.iter().map(|&[tilt, rate]| place(tilt, rate));
            pen.line(points, if *fast { style.dashed() } else { style });
        }
        for (axial, end) in ends.iter().filter(|(axial, _)| *axial <= 2.0) {
            pen.dot(place(*end, 2.0 / axial), 3.6);
        }
        // The momenta are written where the fast branches leave the picture: cos θ = (L₃w − 1)/w² there.
        let out = spins.map(|axial| rising(axial, SHOWN[1])[0]);
        let out = spread(out, 30.0);
        for (x, axial) in out.into_iter().zip(spins) {
            let text = number(axial, 2);
            let text = text.strip_suffix('0').unwrap_or(&text);
            pen.text([x, FRAME[3] - 8.0], Middle, text, small(AngularMomentum));
        }
        let left = out.into_iter().fold(f64::INFINITY, f64::min);
        let name = [left - 20.0, FRAME[3] - 8.0];
        pen.text(name, End, "*L*_{3} =", small(AngularMomentum));
        for (tilt, rate, text) in [
            (140.0, 1.2, "slow"),
            (30.0, 5.4, "fast"),
            (96.0, -2.7, "fast"),
        ] {
            let at = shifted(place(f64::to_radians(tilt), rate), [14.0, -5.0]);
            let up = (0..8).map(|k| shifted(at, [0.0, -8.0 * f64::from(k)]));
            pen.name(up, text, small(Ink));
        }
    });
    let columns = "tilt (°) | rate of precession (√(Mgl/I1))";
    Ok(curves.into_iter().fold(made, |made, (name, _, _, points)| {
        let rows = points.into_iter();
        let rows = rows.map(|[tilt, rate]| [tilt.to_degrees(), rate]);
        made.data(name, columns, rows)
    }))
}
