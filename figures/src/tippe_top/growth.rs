//! Growth rates of the chiral top's slow swing against friction.

use spinning_bodies::tippe_top::bodies::{chiral_top, eccentric_ball};
use spinning_bodies::tippe_top::{Regularised, quasi_steady};

use super::toys::*;
use crate::prelude::*;

parameters! {
    RATE_OF_SPIN: "spin", r"\Omega\sqrt{R/g}", "", "spin in units of the natural rate", [4.0, 12.0], 6.0;
    SKEW: "skew", "s", "", "skewness of the inertia matrix, over that of the book's top", [0.1, 1.5], 1.0;
}
/// The parameters.
pub const GROWTH: [Parameter; 3] = [RATE_OF_SPIN, SKEW, ALPHA.between([0.15, 0.25], 0.19)];

/// Friction and rates shown.
const MU: [f64; 2] = [1e-3, 0.25];
const RATE: [f64; 2] = [5e-7, 0.2];
/// Ratio of neighbouring coefficients of friction.
const STEP: f64 = 1.258_925_411_794_167_2;

/// Handedness is of second order in friction.
pub fn growth_rates(values: &Values) -> Result<Figure> {
    let (natural, speed) = ((G / 0.02).sqrt(), (G * 0.02).sqrt());
    let [spin, skew, alpha] = values.each(GROWTH);
    let mut inertia = chiral_top()?.inertia().matrix() / 0.02_f64.powi(3);
    for (i, j) in [(0, 1), (0, 2), (1, 2)] {
        (inertia[(i, j)], inertia[(j, i)]) = (skew * inertia[(i, j)], skew * inertia[(j, i)]);
    }
    let body = eccentric_ball(0.02, 0.02, alpha, inertia)?;
    let swing = |mu: f64, sense: f64| -> Result<f64> {
        let law = Regularised::new(mu, 1e-3 * speed)?;
        let steady = quasi_steady(&body, G, law, sense * spin * natural)?;
        Ok(steady.slow_swing.growth / natural)
    };
    // If the top has no such state, nothing is drawn.
    let both = |mu: f64| Some((mu, swing(mu, 1.0).ok()?, swing(mu, -1.0).ok()?));
    let points: Vec<(f64, [f64; 2])> = (0..=22)
        .filter_map(|k| both(10_f64.powf(-2.9) * STEP.powi(k)))
        .map(|(mu, plus, minus)| (mu, [0.5 * (minus - plus), 0.5 * (minus + plus)]))
        .collect();
    let slopes = [0, 1].map(|which| {
        let pair = points.windows(2).next()?;
        let (a, b) = (pair[0].1[which], pair[1].1[which]);
        (a > 1e-8 && b > 1e-8).then(|| (b / a).ln() / (pair[1].0 / pair[0].0).ln())
    });
    let near =
        |slope: Option<f64>, power: f64| slope.is_some_and(|slope| (slope - power).abs() < 0.1);
    let claim = match slopes {
        [difference, mean] if near(difference, 2.0) && near(mean, 1.0) => {
            "What both spins share grows like the friction; what tells them apart, like its square.".to_owned()
        }
        [None, _] => "With little friction this top rather turns over anticlockwise, if at all: the difference has changed its sign.".to_owned(),
        [Some(_), None] if points.first().is_some_and(|(_, [half, mean])| half.abs() > -mean) => {
            "With little friction the spins share a swing that dies, and what tells them apart is enough to make one of them grow.".to_owned()
        }
        [Some(_), None] => "With little friction the swing dies whichever way the top is spun.".to_owned(),
        [Some(difference), Some(mean)] => format!(
            "Even at the least friction shown, what tells the spins apart grows like its power {}, what they share like its power {}.",
            number(difference, 1),
            number(mean, 1)
        ),
    };
    let told =
        slopes.map(|slope| slope.map_or("not to be had".to_owned(), |slope| number(slope, 2)));
    let [first, second] = &told;
    let absent = match !points.is_empty() && points.iter().all(|(_, [_, mean])| *mean <= 0.0) {
        true => " The mean is negative throughout, and a logarithmic axis has no place for it.",
        false => "",
    };
    let ends = match points.last() {
        Some((mu, _)) if *mu < 0.19 => " Where both lines end, no such state is found any more.",
        _ => "",
    };
    let [around, skewed, lever] = briefs([spin, skew, alpha]);
    let skewed = if skew == 1.0 {
        String::new()
    } else {
        skewed + " times "
    };
    let words = words!(
        "{claim}",
        "Growth rates of the chiral top's slow swing about its quasi-steady state, in units of $\\sqrt{{g/R}}$, at ${around}\\sqrt{{g/R}}$, $\\alpha = {lever}$, with \
         {skewed}the book's products of inertia: half the difference of the two senses and their mean. Dotted: slopes 2 and 1. Where a curve falls off it changes sign.{ends}{absent}",
        "Two curves on doubly logarithmic axes, friction from 0.001 to 0.25. The half difference of the growth rates starts with slope {first}. The mean, \
         grey, starts with slope {second}. Dotted lines of slopes two and one for comparison."
    );
    let made = figure("chiral-growth", 410.0, words, |pen| {
        let frame = Frame::log(MU, RATE, [74.0, 560.0, 360.0, 34.0]);
        let across = marks(&[1e-3, 1e-2, 1e-1], "");
        let up = powers((1..=6).map(|k| -k));
        frame.draw(
            pen,
            &across,
            &up,
            ["friction *μ*", "growth rate, √(*g*/*R*)"],
        );
        let shown = |rate: f64| rate > RATE[0] && rate < RATE[1];
        for (which, power) in [(0, 2.0), (1, 1.0)] {
            let role = [Ink, Muted][which];
            let seen = |p: &&(f64, [f64; 2])| shown(p.1[which]);
            if let Some((mu, rates)) = points.iter().find(seen) {
                let ray = (0..=20).map(|t| mu * (MU[1] / mu).powf(f64::from(t) / 20.0));
                let ray = ray.map(|at| [at, rates[which] * (at / mu).powf(power)]);
                let inside = ray.filter(|p| p[1] < RATE[1]);
                frame.curve(pen, inside, muted(SECONDARY).dotted());
            }
            for piece in points.split(|p| !shown(p.1[which])) {
                let line: Vec<Point> = piece.iter().map(|p| frame.at(p.0, p.1[which])).collect();
                beaded(pen, &line, stroke(role, DATA));
            }
        }
        // Both curves rise: there is room above the upper one to the left, and below the lower one to the right, most where they are far apart.
        let apart = |rates: [f64; 2]| (rates[0] / rates[1]).abs().ln().abs();
        let mut ordered = points.clone();
        ordered.sort_by(|a, b| apart(b.1).total_cmp(&apart(a.1)));
        for (which, name) in ["half the difference", "mean"].into_iter().enumerate() {
            let slope = slopes[which].map(|slope| format!(": slope {}", number(slope, 1)));
            let text = name.to_owned() + &slope.unwrap_or_default();
            let half = 4.2 * text.chars().count() as f64;
            let seen = ordered.iter().filter(|p| shown(p.1[which]));
            let beside = seen.map(|&(mu, rates)| {
                let [x, y] = frame.at(mu, rates[which]);
                let side = (rates[1 - which] - rates[which]).signum();
                let x = x + side * half;
                [x.clamp(84.0 + half, 556.0 - half), y + 18.0 * side]
            });
            let places: Vec<Point> = beside.collect();
            if !places.is_empty() {
                pen.name(places, &text, label([Ink, Muted][which]));
            }
        }
    });
    let columns = "friction | half the difference over √(g/R) | mean over √(g/R)";
    let rows = points.iter().map(|(mu, [half, mean])| [*mu, *half, *mean]);
    Ok(made.data("slow swing", columns, rows))
}
