//! Where to hit a billiard ball (tutorial 4.3).

mod slide;

use spinning_bodies::rolling::RoundBody;

use crate::prelude::*;
pub use slide::KAPPA;

/// The figures of the chapter, in its order.
pub const FIGURES: &[Entry] = &[
    of("billiard", &[CUE, KAPPA], billiard),
    of("slide-to-roll", slide::LINES, slide::lines),
];

parameters! {
    CUE: "cue", "H/R", "", "height of one of the cues above the table, over the radius", [0.4, 1.9], 1.2, dragged(cue_place);
}

/// The ball: point of contact and radius, units.
const CONTACT: Point = [206.0, 318.0];
const RADIUS: f64 = 121.0;
/// The places where cues begin, and where the slip is zero, units.
const BUTT: f64 = 54.0;
const ZERO: f64 = 446.0;
/// Where the spin is shown, units.
const DIAL: f64 = 348.0;
/// Two cues are this far from each other, radii.
const APART: f64 = 0.17;

fn level(height: f64) -> f64 {
    CONTACT[1] - RADIUS * height
}

fn cue_place(values: &Values) -> Point {
    [BUTT, level(values.of(&CUE))]
}

/// The ball with its cues, and beside it the slip and the spin that each of them causes.
pub fn billiard(values: &Values) -> Result<Figure> {
    let kappa = values.of(&KAPPA);
    let ball = RoundBody::new(1.0, 1.0, kappa)?;
    let sweet = ball.pure_rolling_height();
    let mut heights = vec![values.of(&CUE)];
    for height in [sweet, 1.0, 0.5, (sweet + 0.4).min(1.9)] {
        if heights.iter().all(|other| (other - height).abs() >= APART) {
            heights.push(height);
        }
    }
    heights.sort_by(f64::total_cmp);
    let shots = tried(heights, |height| {
        let shot = ball.strike(height, 1.0)?;
        Ok([height, shot.slip, shot.rim_speed])
    })?;
    let listed = |k: usize, digits: usize| {
        let texts: Vec<String> = shots.iter().map(|shot| short(shot[k], digits)).collect();
        let (last, others) = texts.split_last().unwrap_or((&texts[0], &[]));
        format!("{} and {last}", others.join(", "))
    };
    let which = match kappa == 0.4 {
        true => "a billiard ball".to_owned(),
        false => format!("a ball of inertia factor {}", brief(kappa)),
    };
    let [heights, slips] = [(0, 3), (1, 2)].map(|(k, digits)| listed(k, digits));
    let (factor, height) = (brief(kappa), short(sweet, 3));
    let percent = short(50.0 * sweet, 1);
    let words = words!(
        "Hit at {percent} per cent of its height, {which} rolls at once.",
        "Level cues at heights $H/R$ of {heights} above the table, $\\kappa = I/MR^2 = {factor}$. Arrows: the velocity of the point of contact just after the stroke, {slips} of \
         the ball's velocity $V'$, zero at $H = (1 + \\kappa)R = {height}\\,R$. Blue: how far the ball turns while it advances by $R$, one radian if it rolls.",
        "A ball on a table and level cues at heights of {heights} radii. To the right, at the same heights, arrows for \
         the slip of the contact point: {slips} times the ball's speed. Their tips lie on a straight line which \
         crosses zero at {height} radii. Hit lower, the ball skids with too little spin or backspin; higher, with too \
         much."
    );

    let center = [CONTACT[0], level(1.0)];
    let (low, high) = (shots[0], shots[shots.len() - 1]);
    // Units for a slip of V'.
    let speed = (57.0 * kappa / 0.4)
        .min(128.0 / low[1])
        .min(62.0 / (-high[1]).max(0.1));
    let tip = |shot: &[f64; 3]| [ZERO + speed * shot[1], level(shot[0])];
    let made = figure("billiard", 362.0, words, |pen| {
        pen.line([[10.0, CONTACT[1]], [590.0, CONTACT[1]]], inked(SECONDARY));
        pen.disc(center, RADIUS, Shade, 0.75);
        pen.ring(center, RADIUS, inked(DATA));
        // A line across at the height of pure rolling.
        let ends = [[BUTT, level(sweet)], [590.0, level(sweet)]];
        pen.line(ends, inked(AXIS).dotted());
        pen.dot(center, 2.5);
        pen.line([center, CONTACT], inked(AXIS).alpha(0.6));
        let beside = shifted(center, [8.0, 0.55 * RADIUS]);
        pen.label(beside, Start, "*R*");
        pen.line([[ZERO, 48.0], [ZERO, CONTACT[1]]], inked(AXIS));
        pen.line([tip(&low), tip(&high)], inked(AXIS).dashed());

        for shot in &shots {
            let [height, slip, rim_speed] = *shot;
            let y = level(height);
            let touch = CONTACT[0] - RADIUS * (1.0 - (height - 1.0).powi(2)).max(0.0).sqrt();
            let rolls = slip.abs() < 1e-9;
            let (width, lettering) = match rolls {
                true => (2.8, label(Ink).strong()),
                false => (SECONDARY, small(Ink)),
            };
            pen.arrow([BUTT, y], [touch - 1.0, y], inked(width));
            let name = short(height, 2);
            pen.text([BUTT - 14.0, y + 5.0], End, &name, lettering);

            let dial = [DIAL, y];
            let hand = FRAC_PI_2 - rim_speed;
            pen.ring(dial, 9.8, inked(AXIS));
            if rim_speed != 0.0 {
                let mut sector = arc(dial, 9.8, FRAC_PI_2, hand);
                sector.push(dial);
                pen.fill(&sector, Omega, 0.25);
            }
            let up = [dial, polar(dial, 9.8, FRAC_PI_2)];
            pen.line(up, inked(AXIS));
            pen.line([dial, polar(dial, 9.8, hand)], stroke(Omega, DATA));
            if !rolls {
                pen.arrow([ZERO, y], tip(shot), inked(DATA));
            }
        }
        pen.dot([ZERO, level(sweet)], 5.5);
        pen.label([10.0, 30.0], Start, "*H*/*R*");
        pen.text([DIAL, 30.0], Middle, "spin", label(Omega));
        pen.label([ZERO, 30.0], Middle, "slip / *V*\u{200a}\u{2032}");
        // Arrows go to the right below the height of rolling, to the left above it: words stand on the other side.
        pen.note([ZERO + 14.0, level(2.0) + 2.0], Start, "turns too fast");
        for (height, text) in [(0.5 * (1.0 + sweet), "too slowly"), (0.5, "backwards")] {
            pen.note([ZERO - 6.0, level(height) - 3.0], End, "turns");
            pen.note([ZERO - 6.0, level(height) + 13.0], End, text);
        }
        let rolls = [ZERO + 14.0, level(sweet) - 6.0];
        pen.text(rolls, Start, "rolls", label(Ink).strong());
        let [left, right] = [high[1].min(-1.0), low[1].max(1.0)];
        let slips = Axis::linear([left, right], [ZERO + speed * left, ZERO + speed * right]);
        for (slip, text) in slips.ticks(40.0) {
            pen.tick_below([slips.at(slip), CONTACT[1]], 23.0, &text);
        }
    });
    let columns = "height of the cue (R) | slip (V') | rim speed (V')";
    Ok(made.data("ball", columns, shots))
}
