//! The falling cat as an animation (tutorial 1.1): a sequence of complete pictures, because its shape changes.

use core::fmt::Write as _;

use spinning_bodies::scene::shape::CatState;

use super::body::{FORWARD, RATIO, cat, pieces, turned, turnover};
use super::film::{AZIMUTH, ELEVATION};
use crate::prelude::*;
use crate::style::SCALE as CANVAS;

const NAME: &str = "cat-animated";
const SCALE: f64 = 540.0;
const CENTER: Point = [300.0, 145.0];
/// Pictures of the turnover, and how many times as long the last one is shown.
const PICTURES: usize = 56;
const PAUSE: f64 = 10.0;
/// The picture that is shown without animation.
const STILL: usize = 22;
/// Duration of the loop, s.
const LOOP: f64 = 4.2;

/// A falling cat, repeated for ever.
pub fn cat_animated(_: &Values) -> Result<Figure> {
    let fractions: Vec<f64> = spaced([0.0, 1.0], PICTURES as u32 - 1).collect();
    let states = turnover(&fractions)?;
    let turn = short(turned(&states[PICTURES - 1]).to_degrees(), 4);
    let forward = number(FORWARD.to_degrees(), 0);
    let words = words!(
        "Let go on its back, the cat lands on its feet, and nothing has pushed it.",
        "Two cylinders with $I/J = {RATIO:.0}$ that bend by up to {forward}° turn by {turn}°, with angular momentum 0 all the \
         time. Slowed down about twelve times; the fall itself is left out, for it changes nothing.",
        "A cat of two round halves with head, legs and tail lies in the air on its back, bends, lets the bend run once round its spine, \
         straightens and has its feet below. Without motion: the cat on its way, bent forward and to the side."
    );
    let still = figure(NAME, 280.0, words, |pen| {
        pen.remark([590.0, 268.0], End, "angular momentum 0");
    });
    Ok(still.moving(&moving(&states)?))
}

/// A style sheet that shows one picture after the other, and the pictures.
fn moving(states: &[CatState]) -> Result<String> {
    let body = cat()?;
    let view = View::new(AZIMUTH, ELEVATION, CENTER, SCALE);
    let shares = PICTURES as f64 - 1.0 + PAUSE;
    let mut style = format!(
        "<style>.fig-{NAME}-p{{visibility:hidden;animation:{LOOP}s step-end infinite}}\
         .fig-{NAME}-s{{visibility:visible}}"
    );
    let mut groups = String::new();
    for (k, state) in states.iter().enumerate() {
        let [from, to] = [k, k + 1].map(|pictures| 100.0 * pictures as f64 / shares);
        let begin = if k == 0 { "" } else { "0%{visibility:hidden}" };
        let end = match k + 1 {
            PICTURES => String::new(),
            _ => format!("{to:.2}%{{visibility:hidden}}"),
        };
        let _ = write!(
            style,
            "@keyframes fig-{NAME}-{k}{{{begin}{from:.2}%{{visibility:visible}}{end}}}\
             .fig-{NAME}-{k}{{animation-name:fig-{NAME}-{k}}}"
        );
        let class = match k {
            STILL => format!(" fig-{NAME}-s"),
            _ => String::new(),
        };
        let _ = writeln!(
            groups,
            "<g class=\"fig-{NAME}-p fig-{NAME}-{k}{class}\" stroke=\"currentColor\" stroke-width=\"12\">"
        );
        for piece in pieces(&body, state, &view) {
            let d = closed(&piece.outline);
            if piece.dark {
                let _ = writeln!(groups, "<path d=\"{d}\" fill=\"currentColor\"/>");
                continue;
            }
            let _ = writeln!(groups, "<path d=\"{d}\" fill=\"var(--bg, Canvas)\"/>");
            let lines: String = piece.hatch.iter().map(|line| open(line)).collect();
            if !lines.is_empty() {
                let _ = writeln!(groups, "<path d=\"{lines}\" stroke-width=\"5\"/>");
            }
        }
        groups.push_str("</g>\n");
    }
    let _ = writeln!(
        style,
        "#fig-{NAME}-svg:hover .fig-{NAME}-p{{animation-play-state:paused}}\
         @media (prefers-reduced-motion:reduce){{.fig-{NAME}-p{{animation:none}}}}\
         @media print{{.fig-{NAME}-p{{animation:none}}}}</style>"
    );
    Ok(style + &groups)
}

/// A path, each point by its distance from the last; points nearer than half a unit are left out.
fn open(points: &[Point]) -> String {
    let mut places = points
        .iter()
        .map(|point| point.map(|c| (c * CANVAS).round() as i64));
    let mut last = places.next().unwrap_or_default();
    let mut d = format!("M{} {}l", last[0], last[1]);
    while let Some(here) = places.next() {
        let (x, y) = (here[0] - last[0], here[1] - last[1]);
        if x * x + y * y >= 20 * 20 || places.len() == 0 {
            let _ = write!(d, "{x} {y} ");
            last = here;
        }
    }
    d.trim_end().to_owned()
}

fn closed(points: &[Point]) -> String {
    open(points) + "z"
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The last picture is the first one, on its feet: the loop may begin again.
    #[test]
    fn the_cat_ends_as_it_began_but_for_half_a_turn() {
        let states = turnover(&[0.0, 1.0]).expect("two states");
        assert_eq!(states[1].bend.angle, 0.0);
        // Observed: 3e-15.
        assert!((turned(&states[1]) - PI).abs() < 1e-13);
        for state in &states {
            assert!(state.angular_momentum.norm() < 1e-15);
        }
    }
}
