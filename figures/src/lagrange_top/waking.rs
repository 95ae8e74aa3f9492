//! Tilt against spin while dry friction takes a sleeping top through the threshold (tutorial 7.5).

use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::lagrange_top::{sleeping_threshold, tilt_after_kick};
use spinning_bodies::scene::top::{Body, Gravity, Start, TipFriction, Top};
use spinning_bodies::scene::{Request, Scene};

use crate::prelude::*;

const MOMENTS: [f64; 3] = [2.0e-4, 2.0e-4, 7.0e-5];
const WEIGHT_MOMENT: f64 = 0.1 * 9.81 * 0.04;
/// The smallest visible tilt, degrees.
const AWAKE: f64 = 1.0;
/// The spin at the start, 12.9 turns per second, and the spin at the end of the picture, rad/s.
const SPIN: f64 = 12.9 * TAU;
const LAST: f64 = 77.5;
const SAMPLES: u32 = 1001;
/// The greatest tilt shown, degrees.
const STEEPEST: f64 = 40.0;

parameters! {
    TILT: "tilt", r"\theta", "rad", "tilt at the start", [1e-4, 0.02], 0.001, logarithmic;
    TORQUE: "torque", "N", "N m", "torque of the friction at the tip", [3e-5, 3e-4], 6.54e-5, logarithmic;
}
/// The parameters.
pub const WAKING: &[Parameter] = &[TILT, TORQUE];

/// At the threshold gravity begins to allow a tilt; the top follows late.
pub fn waking(values: &Values) -> Result<Figure> {
    let [tilt, torque] = values.each([TILT, TORQUE]);
    let threshold = sleeping_threshold(MOMENTS[0], MOMENTS[2], WEIGHT_MOMENT)?;
    let body = Body::new(MOMENTS)?.with_center_of_mass(0.1, BodyVector::new(0.0, 0.0, 0.04))?;
    let tilted = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), tilt)?;
    let start = Start::with_omega(BodyVector::new(0.0, 0.0, SPIN), tilted);
    let top = Top::new(body, start)?
        .with(Gravity::new(9.81)?)?
        .with(TipFriction::new(torque)?)?;
    let seconds = MOMENTS[2] * (SPIN - LAST) / torque;
    let step = seconds / f64::from(SAMPLES - 1);
    let times: Vec<f64> = (0..SAMPLES).map(|k| step * f64::from(k)).collect();
    let motion = top.simulate(&Request::at(times)?.to_accuracy(1e-4)?)?;
    let axis = BodyVector::new(0.0, 0.0, 1.0);
    let course = motion.rows.iter().map(|(t, state)| {
        let height = state.attitude.to_space(axis).z();
        let tilt = height.clamp(-1.0, 1.0).acos().to_degrees();
        [*t, state.omega.z(), tilt]
    });
    let course: Vec<[f64; 3]> = course.collect();
    let crossed = course.iter().find(|[_, spin, _]| *spin < threshold);
    let awake = course.iter().find(|[_, _, tilt]| *tilt > AWAKE);
    let deepest = course.iter().map(|row| row[2]).fold(0.0, f64::max);
    let both = crossed.zip(awake);
    let late = both.map(|(crossed, awake)| (awake[0] - crossed[0], awake[1]));
    let passes = match late {
        Some((late, spin)) if late > 0.0 => format!(
            "the tilt passes one degree {late:.2} s later, at {spin:.2} rad/s, and then runs up to {deepest:.0}° within the picture."
        ),
        Some(_) => format!(
            "the tilt swings past one degree even before, for the top was not upright, and then runs up to {deepest:.0}° within the picture."
        ),
        None => format!(
            "the tilt is still below one degree, at most {deepest:.2}°, where the picture ends."
        ),
    };
    let claim = match late {
        Some((late, _)) if late <= 0.0 => {
            "A top that starts askew does not sleep, but it falls only after its spin is through the threshold."
        }
        Some(_) => {
            "A sleeping top wakes late: its spin is through the threshold before its tilt shows anything."
        }
        None => {
            "A sleeping top wakes late: its spin is well through the threshold, and its tilt still shows nothing."
        }
    };
    let (askew, braked) = (brief(tilt), scientific(torque, 3));
    let passed = number(crossed.map_or(seconds, |row| row[0]), 2);
    let words = words!(
        "{claim}",
        "The wooden top, upright but for {askew} rad, loses spin to the friction at its tip, ${braked}$ N m. Dashed: how far gravity \
         would let a top of that spin fall. The spin passes the threshold, {threshold:.2} rad/s, after {passed} s; {passes}",
        "Tilt of a top against its spin, the spin falling to the right. A dashed curve leaves zero steeply at the threshold, {threshold:.2} radians a second, marked by a \
         dotted upright line. The solid curve of the motion, begun at a tilt of {askew} radians, is low through the threshold and reaches {deepest:.1} degrees within the picture."
    );
    let frame = Frame::linear([81.5, LAST], [0.0, STEEPEST], [60.0, 580.0, 276.0, 34.0]);
    let allowed = tried(spaced([0.0, 1.0], 200), |share| {
        let spin = threshold - (threshold - LAST) * share.powi(2);
        let tilt = tilt_after_kick(MOMENTS[0], WEIGHT_MOMENT, MOMENTS[2] * spin, 1e-9)?;
        Ok([spin, tilt.to_degrees()])
    })?;
    let made = figure("sleep-ends", 322.0, words, |pen| {
        let spins = marks(&[81.0, 80.0, 79.0, 78.0], "");
        let tilts = marks(&[0.0, 10.0, 20.0, 30.0], "°");
        frame.draw(pen, &spins, &tilts, ["spin, rad/s", "tilt"]);
        let x = frame.x.at(threshold);
        pen.line([[x, 34.0], [x, 276.0]], muted(SECONDARY).dotted());
        pen.remark([x - 6.0, 48.0], End, "threshold");
        pen.line(frame.trace(allowed), muted(SECONDARY).dashed());
        pen.remark(frame.at(78.55, 31.0), End, "what gravity allows");
        let shown = |row: &&[f64; 3]| row[1] >= LAST && row[2] <= STEEPEST;
        let points = course.iter().take_while(shown);
        pen.line(points.map(|row| frame.at(row[1], row[2])), inked(DATA));
        if deepest < STEEPEST && awake.is_none() {
            pen.note(frame.at(79.0, 3.5), Middle, "still asleep");
        } else if late.is_some_and(|(late, _)| late > 0.0) {
            pen.note(frame.at(80.9, 1.7), Anchor::Start, "asleep");
        }
    });
    let columns = "time (s) | spin (rad/s) | tilt (°)";
    Ok(made.data("top", columns, course))
}
