//! The chiral top beside its mirror image, both spun clockwise.

use spinning_bodies::scene::contact::passage;
use spinning_bodies::tippe_top::bodies;

use super::ball::ball;
use super::beads::{inside, view};
use super::chiral::BOTH_SPINS;
use super::toys::*;
use crate::prelude::*;

/// Duration of the motion, s; pictures of each top; radius of a picture.
const END: f64 = 3.0;
const PICTURES: usize = 4;
const RADIUS: f64 = 30.0;

/// A body and its mirror image with the same spin, and their different motions.
pub fn twins(values: &Values) -> Result<Figure> {
    let [spin, tilt, mu] = values.each(BOTH_SPINS);
    let top = bodies::chiral_top()?;
    let tops = [top, top.mirrored()];
    let rods = tried(&tops, inside)?;
    let runs = tried(tops, |body| {
        let scene = body_scene(body, -spin, tilt.to_radians(), 0.0, mu)?;
        run(&scene, END, 600)
    })?;
    let side = [0, 1].map(|k| passage(&runs[k], degrees, 90.0));
    let most = [0, 1].map(|k| greatest_tilt(&runs[k]));
    let claim = match side.map(|time| time.is_some()) {
        [true, false] if degrees(&runs[0][600].1) > 150.0 => {
            "Spun the same way, the top goes over on its head, and its mirror image does not."
        }
        [true, false] => "Spun the same way, the top falls over, and its mirror image does not.",
        [false, true] => {
            "Spun the same way, the top stays on its foot, and its mirror image goes over."
        }
        [true, true] => "Released like this, the top and its mirror image both go over.",
        [false, false] => {
            "Released like this, neither the top nor its mirror image goes over within three seconds."
        }
    };
    let told = [0, 1].map(|k| match side[k] {
        Some(time) => format!("is on its side after {time:.2} s"),
        None => format!("stays below {}°", number(most[k], 1)),
    });
    let [spun, askew, mu] = briefs([spin, tilt, mu]);
    let every = number(END / (PICTURES - 1) as f64, 0);
    let [own, image] = told;
    let words = words!(
        "{claim}",
        "Above: the three rods in the chiral top and in its image in a mirror between them. Below: both, spun clockwise at {spun} rad/s and {askew}° from the vertical, $\\mu = {mu}$ smoothed over 1 mm/s, every {every} s. \
         The top {own}, its image {image}.",
        "Left and right of a dotted line two transparent balls, each with three crossed rods that lean opposite ways. Below each a row of {PICTURES} balls with a filled cap, from release to {END} \
         seconds later. The top on the left {own}, its mirror image on the right {image}."
    );
    let made = figure("chiral-twins", 346.0, words, |pen| {
        pen.line([[300.0, 12.0], [300.0, 334.0]], muted(AXIS).dotted());
        let names = ["the top", "its mirror image"];
        for k in [0, 1] {
            let middle = 152.0 + 296.0 * k as f64;
            view(pen, ([middle, 90.0], 78.0), [0.95, -0.95][k], &rods[k]);
            pen.label([middle, 198.0], Middle, names[k]);
            let floor = 290.0;
            let ends = [-136.0, 136.0].map(|aside| [middle + aside, floor]);
            pen.line(ends, inked(SECONDARY));
            for picture in 0..PICTURES {
                let (time, state) = &runs[k][picture * 600 / (PICTURES - 1)];
                let x = middle + 68.0 * (picture as f64 - 1.5);
                ball(pen, &state.attitude, [x, floor - RADIUS], RADIUS);
                let tilt = format!("{}°", number(degrees(state), 0));
                pen.note([x, floor + 20.0], Middle, &tilt);
                let time = format!("{} s", number(*time, 0));
                pen.remark([x, floor + 42.0], Middle, &time);
            }
            // Clockwise, seen from above: the near side goes to the left.
            let [from, to] = [middle + 18.0, middle - 18.0].map(|x| [x, 212.0]);
            pen.arrow(from, to, inked(DATA));
        }
    });
    let columns = "time (s) | tilt (°)";
    Ok(made.data("the top", columns, tilts(&runs[0])).data(
        "its mirror image",
        columns,
        tilts(&runs[1]),
    ))
}

#[cfg(test)]
mod tests {
    use super::super::chiral::both_spins;
    use super::*;

    /// In a mirror that stands on the table the image spins the other way: its curve is that of the top spun anticlockwise.
    #[test]
    fn the_image_does_what_the_top_does_the_other_way() {
        let values = Values::default();
        let [one, two] = [twins, both_spins].map(|draw| draw(&values).expect("a figure").data.rows);
        assert_eq!(one.len(), two.len());
        for (a, b) in one.iter().zip(&two) {
            assert!(
                (a.1[1] - b.1[1]).abs() < 1e-2,
                "{} {:?} {:?}",
                a.0,
                a.1,
                b.1
            );
        }
    }
}
