//! The tilt of the hoop with clay against the tutorial's straight line.

use spinning_bodies::scene::contact::passage;

use super::toys::*;
use crate::prelude::*;

parameters! {
    LIGHT: "light", r"\alpha_1", "", "offset of the centre of mass over the radius, lighter clay", [0.02, 0.08], 0.05;
    HEAVY: "heavy", r"\alpha_2", "", "offset of the centre of mass over the radius, heavier clay", [0.09, 0.25], 0.1;
}
/// The parameters. Heavier and faster the ball hops so often that the motion amplifies rounding errors.
pub const TIP_OVER: &[Parameter] = &[LIGHT, HEAVY, TURNS.between([15.0, 60.0], 50.0), FRICTION];

/// Tilt at the release, rad.
const START: f64 = 0.1;

/// A crude estimate that is right to a few per cent.
pub fn tip_over(values: &Values) -> Result<Figure> {
    let alphas = values.each([LIGHT, HEAVY]);
    let (spin, mu) = (TAU * values.of(&TURNS), values.of(&FRICTION));
    let hoop = toy(alphas[1], mu)?;
    let rate = hoop.tip_rate(spin);
    let end = 1.087 * hoop.tip_over_time(spin);
    let runs = tried(alphas, |alpha| run(&toy_scene(alpha, spin, mu)?, end, 250))?;
    // Between 30° and 150°, if it gets there.
    let mean = |k: usize| -> Option<f64> {
        let at = |level: f64| passage(&runs[k], degrees, level);
        Some(120.0 / (at(150.0)? - at(30.0)?))
    };
    let means = [mean(0), mean(1)];
    let off = means.map(|mean| mean.map(|mean| 100.0 * (mean / rate.to_degrees() - 1.0).abs()));
    let named = briefs(alphas);
    let claim = match off {
        [Some(light), Some(heavy)] => {
            let worst = light.max(heavy);
            let better = if light < heavy { "lighter" } else { "heavier" };
            format!(
                "The tutorial's straight line has the right slope to {worst:.0} %, the better for the {better} clay."
            )
        }
        [None, Some(_)] => format!(
            "Clay of α = {} is too light to tip the ball over in the time that the tutorial's straight line allows.",
            named[0]
        ),
        [_, None] => "Neither ball keeps up with the tutorial's straight line.".to_owned(),
    };
    let told = means.map(|mean| match mean {
        Some(mean) => format!("{}° a second", number(mean, 1)),
        None => "none yet".to_owned(),
    });
    let [turns, mu] = briefs([values.of(&TURNS), mu]);
    let slope = number(rate.to_degrees(), 2);
    let ([slow, fast], [light, heavy]) = (&told, &named);
    let reached = number((PI - START) / rate, 1);
    let [low, high] = [0, 1].map(|k: usize| number(degrees(&runs[k][250].1), 0));
    let words = words!(
        "{claim}",
        "Tilt of the tutorial's toy, a ball with $R = 2$ cm, $I = \\frac25MR^2$, {turns} turns a second, $\\mu = {mu}$ smoothed over 1 mm/s, released at {START} rad. Dashed: \
         the estimate, {slope}° a second. Mean pace from 30° to 150°: {slow} for $\\alpha = {light}$, {fast} for $\\alpha = {heavy}$. Dotted: by Jellett's integral, for \
         $\\alpha = {heavy}$.",
        "Tilt in degrees against time in seconds. A dashed straight line rises from near zero to 180 degrees at {reached} seconds. A grey curve is for the lighter clay, \
         one in ink for the heavier clay; after {end:.2} seconds they stand at {low} and {high} degrees. \
         A dotted curve is the refined estimate for the heavier clay."
    );
    let made = figure("tip-over", 404.0, words, |pen| {
        let frame = Frame::linear([0.0, end], [0.0, 180.0], [58.0, 572.0, 352.0, 34.0]);
        tilt_against_time(pen, &frame);
        let line = (0..=1).map(|k| {
            let t = f64::from(k) * (PI - START) / rate;
            [t, (START + rate * t).to_degrees()]
        });
        frame.curve(pen, line, inked(SECONDARY).dashed());
        let refined = (0..=120).map(|k| {
            let tilt = START + (PI - START) * f64::from(k) / 120.0;
            [hoop.refined_time(spin, START, tilt), tilt.to_degrees()]
        });
        frame.curve(pen, refined, inked(SECONDARY).dotted());
        for (rows, role) in runs.iter().zip([Muted, Ink]) {
            frame.curve(pen, tilts(rows), stroke(role, DATA));
        }
        let estimate = frame.at(75_f64.to_radians() / rate, 75.0 + START.to_degrees());
        let spot = shifted(estimate, [-10.0, -4.0]);
        pen.text(spot, End, "the estimate, *RμMg*/*IΩ*", small(Ink));
        // Each name beside its curve, the lighter clay's rather below it, the heavier's above.
        for (k, side, role) in [(0, 1.0, Muted), (1, -1.0, Ink)] {
            let places = [165, 130, 200, 90, 240, 50].into_iter().flat_map(|row| {
                let (t, state) = &runs[k][row];
                let on = frame.at(*t, degrees(state));
                [side, -side].map(|side| shifted(on, [42.0 * side, 10.0 * side]))
            });
            let inside = within([100.0, 540.0], [44.0, 338.0]);
            let text = format!("*α* = {}", named[k]);
            pen.name(places.filter(inside), &text, label(role));
        }
    });
    let columns = "time (s) | tilt (°)";
    let [light, heavy] = alphas.map(|alpha| format!("alpha = {alpha}"));
    Ok(made
        .data(light, columns, tilts(&runs[0]))
        .data(heavy, columns, tilts(&runs[1]))
        .value("estimate", number(rate.to_degrees(), 2))
        .value("light", number(means[0].unwrap_or(0.0), 1))
        .value("heavy", number(means[1].unwrap_or(0.0), 1)))
}
