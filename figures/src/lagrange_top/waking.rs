//! Tilt against spin while dry friction takes a sleeping top through the threshold (tutorial 7.5).

use spinning_bodies::Result;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::lagrange_top::{sleeping_threshold, tilt_after_kick};
use spinning_bodies::scene::top::{Body, Gravity, Start, TipFriction, Top};
use spinning_bodies::scene::{Request, Scene};

use crate::Figure;
use crate::plot::{Axis, Frame};
use crate::style::{Anchor, DATA, Point, Role, SECONDARY, Words, figure, number, small, stroke};

const MOMENTS: [f64; 3] = [2.0e-4, 2.0e-4, 7.0e-5];
const WEIGHT_MOMENT: f64 = 0.1 * 9.81 * 0.04;
/// 12.9 turns a second, upright but for a thousandth of a radian.
const SPIN: f64 = 12.9 * core::f64::consts::TAU;
const TILT: f64 = 0.001;
const TORQUE: f64 = 6.54e-5;
const SECONDS: f64 = 3.5;
const SAMPLES: u32 = 1401;

/// The tilt that gravity allows opens at the threshold; the top notices late.
pub fn waking() -> Result<Figure> {
    let body = Body::new(MOMENTS)?.with_center_of_mass(0.1, BodyVector::new(0.0, 0.0, 0.04))?;
    let tilted = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), TILT)?;
    let start = Start::with_omega(BodyVector::new(0.0, 0.0, SPIN), tilted);
    let top = Top::new(body, start)?
        .with(Gravity::new(9.81)?)?
        .with(TipFriction::new(TORQUE)?)?;
    let last = f64::from(SAMPLES - 1);
    let times: Vec<f64> = (0..SAMPLES)
        .map(|k| SECONDS * f64::from(k) / last)
        .collect();
    let motion = top.simulate(&Request::at(times)?.to_accuracy(1e-4)?)?;
    let axis = BodyVector::new(0.0, 0.0, 1.0);
    let course: Vec<[f64; 3]> = motion
        .rows
        .iter()
        .map(|(t, state)| {
            let height = state.attitude.to_space(axis).z();
            let tilt = height.clamp(-1.0, 1.0).acos().to_degrees();
            [*t, state.omega.z(), tilt]
        })
        .collect();
    let threshold = sleeping_threshold(MOMENTS[0], MOMENTS[2], WEIGHT_MOMENT)?;
    let crossed = course.iter().find(|[_, spin, _]| *spin < threshold);
    let awake = course.iter().find(|[_, _, tilt]| *tilt > 1.0);
    let [crossed, awake] = [crossed, awake].map(|row| row.copied().unwrap_or([f64::NAN; 3]));
    let deepest = course.iter().map(|row| row[2]).fold(0.0, f64::max);
    let words = Words {
        claim: "A sleeping top wakes late: its spin is through the threshold before its tilt shows anything.".to_owned(),
        details: format!(
            "The wooden top, upright but for a thousandth of a radian, loses spin to the friction at its tip. Dashed: how far gravity \
             would let a top of that spin fall. The spin passes the threshold, {} rad/s, after {} s; the tilt passes one degree {} s \
             later, at {} rad/s, and then runs up to {}° within the picture.",
            number(threshold, 2),
            number(crossed[0], 2),
            number(awake[0] - crossed[0], 2),
            number(awake[1], 2),
            number(deepest, 0),
        ),
        alt: "Tilt of a top against its spin, the spin falling to the right. A dashed curve leaves zero steeply at the threshold, marked by a \
              dotted upright line. The solid curve of the motion stays at zero through the threshold and beyond it, then climbs steeply \
              towards the dashed curve."
            .to_owned(),
    };
    let frame = Frame {
        x: Axis::linear([81.5, 77.5], [60.0, 580.0]),
        y: Axis::linear([0.0, 40.0], [300.0, 34.0]),
    };
    let mut allowed: Vec<Point> = Vec::new();
    for k in 0..=200_u32 {
        let spin = threshold - (threshold - 77.8) * (f64::from(k) / 200.0).powi(2);
        let tilt = tilt_after_kick(MOMENTS[0], WEIGHT_MOMENT, MOMENTS[2] * spin, 1e-9)?;
        allowed.push(frame.at(spin, tilt.to_degrees()));
    }
    Ok(figure("sleep-ends", 352.0, words, |pen| {
        frame.draw(
            pen,
            &[(81.0, "81"), (80.0, "80"), (79.0, "79"), (78.0, "78")],
            &[(0.0, "0°"), (10.0, "10°"), (20.0, "20°"), (30.0, "30°")],
            ["spin, rad/s", "tilt"],
        );
        let x = frame.x.at(threshold);
        pen.line(
            &[[x, 34.0], [x, 300.0]],
            stroke(Role::Muted, SECONDARY).dotted(),
        );
        pen.text(
            [x - 6.0, 48.0],
            Anchor::End,
            "threshold",
            small(Role::Muted),
        );
        pen.line(&allowed, stroke(Role::Muted, SECONDARY).dashed());
        let told = frame.at(78.55, 34.0);
        pen.text(told, Anchor::End, "what gravity allows", small(Role::Muted));
        let points: Vec<Point> = course
            .iter()
            .filter(|row| row[1] >= 77.5 && row[2] <= 40.0)
            .map(|row| frame.at(row[1], row[2]))
            .collect();
        pen.line(&points, stroke(Role::Omega, DATA));
        pen.text(
            frame.at(80.9, 1.4),
            Anchor::Start,
            "asleep",
            small(Role::Omega),
        );
    }))
}
