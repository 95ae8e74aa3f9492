//! The three components of Ω against time, close to the separatrix (tutorial 6.6).

use spinning_bodies::euler_top::Regime;
use spinning_bodies::frame::{Attitude, BodyVector};

use super::body::*;
use crate::prelude::*;

parameters! {
    FIRST: "first", r"\Omega_1(0)", "rad/s", "angular velocity about the axis of the smallest moment at the start", [1e-4, 2.0], 0.01, logarithmic;
    THIRD: "third", r"\Omega_3(0)", "rad/s", "angular velocity about the axis of the largest moment at the start", [1e-4, 2.0], 0.01, logarithmic;
}
/// The parameters; about the middle axis the start has 1 rad/s.
pub const SOLUTION: &[Parameter] = &[SMALLEST, MIDDLE, LARGEST, FIRST, THIRD];

const STEPS: usize = 480;
/// Periods looked at: the curves end where Ω₂ vanishes in the last half of one.
const LENGTH: f64 = 1.5;
/// Left and right end of the time axis, height of zero, half the height of the picture.
const FRAME: [f64; 4] = [52.0, 540.0, 132.0, 84.0];
/// A rest is longer than a swing if Ω₂ is nearly at its greatest for more than half of the time.
const NEARLY: f64 = 0.9;

/// Ω₂ is nearly a square wave, Ω₁ and Ω₃ are pulses.
pub fn solution(values: &Values) -> Result<Figure> {
    let start = [values.of(&FIRST), 1.0, values.of(&THIRD)];
    let moments = moments(values);
    let omega = BodyVector::new(start[0], start[1], start[2]);
    let top = top_of(moments, omega, Attitude::identity())?;
    // On the separatrix there is no period; sixty seconds show the one swing.
    let period = Some(top.period()).filter(|period| period.is_finite());
    let step = period.map_or(60.0, |period| LENGTH * period) / STEPS as f64;
    let times = (0..=STEPS).map(|k| step * k as f64);
    let mut states = tried(top.states(times), |state| {
        Ok(<[f64; 3]>::from(state?.omega.components()))
    })?;
    let greatest = |k: usize| {
        states
            .iter()
            .map(|omega| omega[k].abs())
            .fold(0.0, f64::max)
    };
    let most = greatest(1);
    let largest = [0, 1, 2].map(greatest).into_iter().fold(0.0, f64::max);
    let in_a_period = &states[..(STEPS as f64 / LENGTH) as usize];
    let near = |omega: &&[f64; 3]| omega[1].abs() > NEARLY * most;
    // Half percents, rounded up to whole ones.
    let percent = (200 * in_a_period.iter().filter(near).count() / in_a_period.len()).div_ceil(2);
    let rests = percent > 50;
    if let Some(last) = (1..=STEPS).rfind(|&k| states[k - 1][1] * states[k][1] <= 0.0)
        && period.is_some()
    {
        states.truncate(last + 1);
    }
    let kept = match top.regime() {
        Regime::AroundSmallest => 0,
        _ => 2,
    };
    let [name, turned] = [["\\Omega_1", "\\Omega_3"], ["\\Omega_3", "\\Omega_1"]][kept / 2];
    let functions = ["dn", "sn", "cn"];
    let [first, third] = [functions[kept], functions[2 - kept]];
    let about = ["first", "second", "third"][kept];
    let course = match period {
        Some(period) => format!(
            "$\\Omega_2$ goes as sn, $\\Omega_1$ as {first}, $\\Omega_3$ as {third}. Period {period:.3} s; after half of it ${turned}$ and $\\Omega_2$ have changed \
             sign and ${name}$ has its old value."
        ),
        None => "there is no period on the separatrix, and here no swing is left.".to_owned(),
    };
    let claim = match (period, rests) {
        (None, _) => "On the separatrix the top swings over at most once and then rests about its middle axis for ever.".to_owned(),
        (_, true) => "Next to the separatrix the top rests about its middle axis and swings over in between.".to_owned(),
        (_, false) => format!("Far from the separatrix the top goes round its {about} axis, and nothing rests."),
    };
    let [inertia, begun] = [moments, start].map(triple);
    let (size, beyond) = (brief(most), remark(moments));
    let (wave, pulses) = match rests {
        true => (
            "almost a square wave",
            "Between these pulses both are small: the top seems to rotate steadily about its middle axis.",
        ),
        false => ("a wave", "Then all is repeated."),
    };
    let seen = match period {
        Some(period) => format!(
            "Three curves over at least a period of {period:.1} seconds. The second component of the angular velocity is {wave} between plus and minus {size}. The {about} \
             component keeps its sign and is greatest when the second one vanishes; the other changes its sign and is greatest at the same times, up and down \
             in turn. {pulses}"
        ),
        None => format!(
            "Three curves over a minute. The second component of the angular velocity ends steady, {size} in size; the other two die away."
        ),
    };
    let words = words!(
        "{claim}",
        "Components of $\\Omega$ in the body, rad/s, for $I = {inertia}$, $\\Omega(0) = {begun}$: {course} {percent} % of the time $\\Omega_2$ is within a tenth of its \
         greatest size, {size} rad/s.{beyond}",
        "{seen}"
    );
    let [left, right, zero, half] = FRAME;
    let length = step * (states.len() - 1) as f64;
    let x = |t: f64| left + (right - left) * t / length;
    let y = |value: f64| zero - half * value / largest;
    let curve = |k: usize| {
        let states = states.iter().enumerate();
        states.map(move |(n, omega)| [x(step * n as f64), y(omega[k])])
    };
    let made = figure("euler-solution", 274.0, words, |pen| {
        let [over, bottom] = [zero - half - 12.0, zero + half + 14.0];
        pen.line([[left, zero], [right, zero]], inked(HAIR));
        pen.line([[left, over], [left, bottom], [right, bottom]], inked(AXIS));
        let name = [left - 30.0, over - 12.0];
        pen.text(name, Start, "*Ω*, rad/s", label(Omega));
        let upward = Axis::linear([-largest, largest], [zero + half, zero - half]);
        for (value, text) in upward.ticks(50.0) {
            pen.tick_beside([left, y(value)], &text);
        }
        let whole = period.unwrap_or(length);
        for (share, text) in [(0.0, "0"), (0.5, "half a period"), (1.0, "a period")] {
            let at = x(share * whole);
            pen.line([[at, bottom], [at, bottom + 5.0]], inked(AXIS));
            if share > 0.0 {
                let line = [[at, over], [at, bottom]];
                pen.line(line, muted(AXIS).dotted());
                let time = format!("{} s", number(share * whole, 2));
                pen.note([at, bottom + 38.0], Middle, &time);
            }
            let named = period.is_some() || share == 0.0;
            pen.note([at, bottom + 21.0], Middle, if named { text } else { "" });
        }
        let styles = [
            stroke(Omega, SECONDARY).dashed(),
            stroke(Omega, 2.6),
            stroke(Omega, SECONDARY),
        ];
        for (k, style) in styles.into_iter().enumerate() {
            pen.line(curve(k), style);
        }
        let end = states.last().copied().unwrap_or(start);
        let ends = end.map(|value| y(value) + 5.0);
        for (y, name) in spread(ends, 19.0).into_iter().zip(["1", "2", "3"]) {
            let text = format!("*Ω*_{{{name}}}");
            pen.text([right + 8.0, y], Start, &text, label(Omega));
        }
    });
    let rows = states.iter().enumerate();
    let rows = rows.map(|(n, [first, second, third])| [step * n as f64, *first, *second, *third]);
    let columns = "time (s) | Ω₁ (rad/s) | Ω₂ (rad/s) | Ω₃ (rad/s)";
    Ok(made.data("top", columns, rows))
}
