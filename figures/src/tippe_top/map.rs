//! Which releases turn the chiral top over: tilt and azimuth, both spins.

use super::toys::*;
use crate::prelude::*;

/// Tilts of the release, degrees, and azimuths per ring.
const TILTS: [f64; 6] = [2.0, 5.0, 10.0, 15.0, 20.0, 30.0];
const AZIMUTHS: u32 = 8;
/// The time of the outcome, s.
const END: f64 = 2.5;

/// Whether the top is on its head at the end.
fn over(sense: f64, tilt: f64, azimuth: f64) -> Result<bool> {
    let scene = chiral_scene(sense * CHIRAL_SPIN, tilt.to_radians(), azimuth, 0.3)?;
    let rows = run(&scene, END, 1)?;
    Ok(rows[1].1.tilt() > FRAC_PI_2)
}

fn rings(sense: f64) -> Result<Vec<Vec<bool>>> {
    let azimuths = (0..AZIMUTHS).map(|k| TAU * f64::from(k) / f64::from(AZIMUTHS));
    tried(TILTS, |tilt| {
        tried(azimuths.clone(), |azimuth| over(sense, tilt, azimuth))
    })
}

/// How carelessly it may be released. Ninety-six runs; the figure has no parameters.
pub fn outcomes(_: &Values) -> Result<Figure> {
    let (plus, minus) = (rings(1.0)?, rings(-1.0)?);
    let count = |ring: &[bool]| ring.iter().filter(|over| **over).count();
    let total = TILTS.len() * AZIMUTHS as usize;
    let counts = plus.iter().map(|ring| count(ring)).zip(TILTS);
    let some = counts.filter(|(over, _)| *over > 0);
    let told = some.map(|(over, tilt)| format!("{over} of {AZIMUTHS} at {tilt:.0}°"));
    let by_ring = told.collect::<Vec<_>>().join(", ");
    let [clockwise, other] = [&minus, &plus].map(|rings| count(&rings.concat()));
    let words = words!(
        "Clockwise it turns over from every release; anticlockwise only if you let it lean.",
        "Outcome after {END:.1} s of {total} releases each way: the ring gives the tilt of the release, 2°, 5°, 10°, 15°, 20° and 30°, the direction its \
         azimuth in the body. Full discs turn over: {clockwise} of {total} clockwise, {other} of {total} anticlockwise ({by_ring}). $\\mu = 0.3$ smoothed over 1 mm/s, 132.9 rad/s.",
        "Two targets of six rings with eight discs each. On the left, clockwise, all discs are full. On the right, anticlockwise, the \
         inner rings are empty and some discs of the outer rings are full."
    );
    Ok(figure("chiral-map", 330.0, words, |pen| {
        target(pen, [155.0, 168.0], &minus, "clockwise");
        target(pen, [445.0, 168.0], &plus, "anticlockwise");
    }))
}

fn target(pen: &mut Pen, center: Point, rings: &[Vec<bool>], name: &str) {
    let reach = |k: usize| 22.0 + 21.0 * k as f64;
    for (k, ring) in rings.iter().enumerate() {
        pen.ring(center, reach(k), muted(HAIR));
        for (j, over) in ring.iter().enumerate() {
            let angle = TAU * j as f64 / f64::from(AZIMUTHS);
            let at = polar(center, reach(k), angle);
            match over {
                true => pen.dot(at, 5.6),
                false => {
                    pen.disc(at, 5.0, Paper, 1.0);
                    pen.ring(at, 5.0, inked(AXIS));
                }
            }
        }
        // The innermost ring has no room for a name.
        if k == 2 || k == 5 {
            let place = shifted(polar(center, reach(k) + 11.0, 1.18), [0.0, 4.5]);
            pen.remark(place, Middle, &format!("{:.0}°", TILTS[k]));
        }
    }
    pen.label([center[0], center[1] + reach(5) + 29.0], Middle, name);
}
