//! Hard cases (chapter "Hard cases"): the error of the textbook's formula beside the error of ours.

use lab::hard_cases::{Comparison, Family, families};

use crate::prelude::*;

/// The figures of the chapter, in its order.
pub const FIGURES: &[Entry] = &[
    of("hard-cases", &[], overview),
    of("hard-cases-tops", &[], tops),
    of("hard-cases-bodies", &[], bodies),
];

/// Which error is shown: that of the textbook's formula or of ours.
const TEXTBOOK: Role = Muted;
const OURS: Role = Ink;

/// The range of errors shown, from a tenth of a rounding to 1, where no digit is right.
const SHOWN: [f64; 2] = [1e-17, 1.0];

/// The nearness at which the chapter's first picture is taken.
const CLOSE: f64 = 1e-6;

/// Twelve formulas at a distance of a millionth from their hard case.
pub fn overview(_: &Values) -> Result<Figure> {
    let all = families();
    let rows = tried(&all, |family| Ok((family, closest(family, CLOSE)?)))?;
    let worst = rows.iter().fold(0.0_f64, |m, (_, c)| m.max(c.ours));
    let (top, pitch) = (66.0, 64.0);
    let bottom = top + pitch * rows.len() as f64 - 14.0;
    let axis = Axis::log(SHOWN, [24.0, 580.0]);
    let (lost, tenfold) = (scientific(worst, 1), number(worst / SHOWN[0], 0));
    let words = words!(
        "The formula is the same, the digits are not.",
        "Twelve quantities of this book, each about a millionth away from the place where its formula loses its digits (after a million units of time, a million \
         bounces). Relative error of the formula as printed, and of the library, from the same doubles, against 36 digits. The library’s worst is ${lost}$.",
        "Twelve horizontal lines, one a case, on a logarithmic axis of errors from ten to the minus 17 to 1; above each what is asked and what is lost. The left end of each, the library, lies between ten to the minus 17 and {tenfold} times that. The \
         right end, the textbook, lies anywhere from ten to the minus 13 to beyond 1."
    );
    Ok(figure("hard-cases", bottom + 58.0, words, |pen| {
        for (value, text) in powers([-16, -12, -8, -4, 0]) {
            let x = axis.at(value);
            pen.line([[x, top - 12.0], [x, bottom]], inked(HAIR).alpha(0.18));
            pen.remark([x, bottom + 20.0], Middle, &text);
        }
        let place = [580.0, bottom + 44.0];
        pen.remark(place, End, "relative error");
        pen.text([axis.at(1e-16), 26.0], Middle, "ours", label(OURS).strong());
        let spot = [axis.at(1e-4), 26.0];
        pen.text(spot, Middle, "the textbook", label(TEXTBOOK).strong());
        for (n, (family, at)) in rows.iter().enumerate() {
            let y = top + pitch * n as f64 + 36.0;
            let [a, b] = [at.ours, at.textbook].map(|error| [axis.at(shown(error)), y]);
            let lost = format!("lost: {}", family.lost);
            pen.text([24.0, y - 30.0], Start, family.quantity, small(OURS));
            pen.text([24.0, y - 12.0], Start, &lost, small(TEXTBOOK));
            pen.line([a, b], muted(SECONDARY).alpha(0.7));
            pen.disc(a, 4.5, OURS, 1.0);
            pen.disc(b, 4.5, TEXTBOOK, 1.0);
        }
    }))
}

/// The families of tops: towards the separatrix, the axis, the sphere, and so on.
pub fn tops(_: &Values) -> Result<Figure> {
    let words = words!(
        "The textbook walks uphill, the library on a floor.",
        "Six walks of a top to a place where its formula loses digits: relative error against the distance that is left (for the fast top and the slow \
         precession, 4 over the spin). Grey: the formula as printed; ink: the library. What reaches the top has not one digit left.",
        "Six small panels with logarithmic axes. In each the line of the textbook climbs from ten to the minus 16 towards 1 as the distance shrinks, least far next to the separatrix, steeply for the sleeping and \
         the fast top; the line of the library stays at ten to the minus 16 throughout."
    );
    panels(
        "hard-cases-tops",
        words,
        [
            "near-separatrix",
            "near-axis",
            "nearly-sphere",
            "sleeping-top",
            "fast-top",
            "slow-precession",
        ],
    )
}

/// The other families.
pub fn bodies(_: &Values) -> Result<Figure> {
    let words = words!(
        "Long times, small angles and thin bodies cost digits, too.",
        "Six more walks: relative error against the distance that is left. For the long time and the bounces that is 1 over the time or their number, \
         for the tetrahedron its size over the distance from the origin.",
        "Six small panels with logarithmic axes: an ordinary top after a long time, a superball after many bounces, dn next to a quarter period, a small angle, a moment of a distant body, a needle. The line of the textbook climbs from \
         ten to the minus 16 towards 1 in each; the line of the library stays at the bottom."
    );
    panels(
        "hard-cases-bodies",
        words,
        [
            "long-time",
            "many-bounces",
            "quarter-period",
            "small-turn",
            "far-mesh",
            "needle",
        ],
    )
}

/// Two columns of three.
fn panels(name: &'static str, words: Words, names: [&str; 6]) -> Result<Figure> {
    let mut walks = Vec::new();
    for family in families() {
        if let Some(place) = names.iter().position(|&name| name == family.name) {
            walks.push((place, wrapped(family.quantity, 26), family.comparisons()?));
        }
    }
    Ok(figure(name, 786.0, words, |pen| {
        // In the order of the panels; the comparisons are in the order of the families.
        walks.sort_by_key(|walk| walk.0);
        let mut frames = Vec::new();
        for (place, title, steps) in &walks {
            let [column, row] = [place % 2, place / 2].map(|k| k as f64);
            let corner = [54.0 + 290.0 * column, 98.0 + 250.0 * row];
            frames.push(panel(pen, corner, title, steps));
        }
        for (first, last) in frames.iter().zip(frames.iter().skip(4)) {
            first.panel_names(pen, last, 78.0, ["distance left", "relative error"]);
        }
    }))
}

fn panel(pen: &mut Pen, corner: Point, title: &[String], steps: &[Comparison]) -> Frame {
    // The nearest at the right, as near as doubles allow.
    let (last, before) = title.split_last().expect("a title has a line");
    for (k, line) in before.iter().rev().enumerate() {
        let place = [corner[0], corner[1] - 34.0 - 20.0 * k as f64];
        pen.label(place, Start, line);
    }
    let across = [[1.0, 1e-16], SHOWN];
    let frame = Frame::panel(pen, last, corner, across, [&POWERS, &POWERS]);
    let known = |step: &&Comparison| (1e-16..=1.0).contains(&step.nearness);
    for (k, role) in [TEXTBOOK, OURS].into_iter().enumerate() {
        let errors = |step: &Comparison| [step.textbook, step.ours];
        let place = |step: &Comparison| frame.at(step.nearness, shown(errors(step)[k]));
        let line: Vec<Point> = steps.iter().filter(known).map(place).collect();
        beaded(pen, &line, stroke(role, DATA));
    }
    frame
}

const POWERS: [(f64, &str); 3] = [(1.0, "1"), (1e-8, "10^{−8}"), (1e-16, "10^{−16}")];

/// The step whose nearness is closest to this one, by ratio.
fn closest(family: &Family, nearness: f64) -> Result<Comparison> {
    let steps = family.comparisons()?;
    let off = |step: &Comparison| (step.nearness / nearness).ln().abs();
    let best = steps.into_iter().min_by(|a, b| off(a).total_cmp(&off(b)));
    best.ok_or(spinning_bodies::Error::Empty {
        quantity: "the steps of a family",
    })
}

/// An error as it is drawn; no answer counts as the greatest error.
fn shown(error: f64) -> f64 {
    match error.is_nan() {
        true => SHOWN[1],
        false => error.clamp(SHOWN[0], SHOWN[1]),
    }
}
