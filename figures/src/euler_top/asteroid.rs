//! Toutatis on its sky (tutorial 6.8): a motion of two periods that never repeats.

use core::f64::consts::TAU;

use nalgebra::{Rotation3, Vector3};
use spinning_bodies::Result;
use spinning_bodies::euler_top::toutatis::{DAY, top};
use spinning_bodies::frame::BodyVector;

use crate::Figure;
use crate::solid::{View, ellipse, segment};
use crate::style::{
    AXIS, Anchor, HAIR, Point, Role, SECONDARY, Words, figure, label, number, small, stroke,
};

/// How long it is followed, days, and points drawn in a day.
const DAYS: u32 = 60;
const A_DAY: u32 = 24;
/// Dots, one a day.
const DOTS: usize = 8;
/// How far the arrow of L reaches beyond the sphere.
const BEYOND: f64 = 1.22;

/// Where the long and the short axis point for two months.
pub fn two_axes_in_the_sky() -> Result<Figure> {
    let asteroid = top()?;
    let l = asteroid.angular_momentum_in_space().components();
    let upright = Rotation3::rotation_between(&l, &Vector3::z()).unwrap_or_default();
    // The end of the long axis that stands on the side of L, and one end of the short axis.
    let ends = [
        BodyVector::new(0.0, 0.0, -1.0),
        BodyVector::new(0.0, 1.0, 0.0),
    ];
    let steps = (0..=DAYS * A_DAY).map(|k| f64::from(k) * DAY / f64::from(A_DAY));
    let states = asteroid.states(steps).collect::<Result<Vec<_>>>()?;
    let [long, short] = ends.map(|end| -> Vec<Vector3<f64>> {
        let in_the_sky =
            |a: &spinning_bodies::euler_top::State| upright * a.attitude.to_space(end).components();
        states.iter().map(in_the_sky).collect()
    });
    let angle = |a: &Vector3<f64>| a.z.acos().to_degrees();
    let lowest = |axis: &[Vector3<f64>]| axis.iter().map(angle).fold(f64::INFINITY, f64::min);
    let highest = |axis: &[Vector3<f64>]| axis.iter().map(angle).fold(0.0, f64::max);
    let periods = [
        asteroid.period() / DAY,
        TAU / asteroid.mean_precession_rate() / DAY,
    ];

    let words = Words {
        claim: "Toutatis has two periods, and they do not fit together.".to_owned(),
        details: format!(
            "Where its long axis (in ink, a dot a day in the first week) and its short axis (thin) point for {DAYS} days from 9 November 1992, on a sphere with \
             $L$ upright. The long axis keeps between {} and {} degrees from $L$ and goes round in {} days; about it \
             the body rolls in {} days, and the short axis draws a net without end, from {} to {} degrees.",
            number(lowest(&long), 1),
            number(highest(&long), 1),
            number(periods[1], 2),
            number(periods[0], 2),
            number(lowest(&short), 1),
            number(highest(&short), 1),
        ),
        alt: format!(
            "A sphere with the angular momentum pointing up. The long axis of the asteroid runs round it in a circle of latitude, always \
             {} degrees from the top, {} times in {DAYS} days. The short axis draws loops from high in the north to the far south; no loop falls \
             on another, and in the end a fine net covers a broad belt of the sphere.",
            number(highest(&long), 0),
            number(f64::from(DAYS) / periods[1], 0),
        ),
    };
    Ok(figure("toutatis", 400.0, words, |pen| {
        let view = View::new(0.5, 0.42, [300.0, 218.0], 160.0);
        let facing = |p: &Vector3<f64>| p.dot(&view.toward) >= 0.0;
        let u = view.toward.cross(&Vector3::z()).normalize();
        let outline = view.trace(&ellipse(Vector3::zeros(), u, view.toward.cross(&u), 240));
        pen.fill(&outline, Role::Shade, 1.0);
        let axis = segment(Vector3::zeros(), Vector3::z(), 2);
        pen.line(
            &view.trace(&axis),
            stroke(Role::AngularMomentum, AXIS).dotted(),
        );
        let [seen, hidden] = view.split(&short, facing);
        for piece in hidden {
            pen.line(&piece, stroke(Role::Muted, HAIR).alpha(0.35));
        }
        let [ring, behind] = view.split(&long, facing);
        for piece in behind {
            pen.line(&piece, stroke(Role::Ink, SECONDARY).alpha(0.3));
        }
        for piece in seen {
            pen.line(&piece, stroke(Role::Omega, AXIS));
        }
        pen.outline(&outline, stroke(Role::Ink, SECONDARY));
        for piece in ring {
            pen.line(&piece, stroke(Role::Ink, SECONDARY));
        }
        for day in long
            .iter()
            .step_by(A_DAY as usize)
            .take(DOTS)
            .filter(|p| facing(p))
        {
            pen.disc(view.project(day), 3.0, Role::Ink, 1.0);
        }
        let tip = view.project(&(Vector3::z() * BEYOND));
        pen.arrow(
            view.project(&Vector3::z()),
            tip,
            stroke(Role::AngularMomentum, 2.0),
        );
        pen.text(
            [tip[0] + 14.0, tip[1] + 12.0],
            Anchor::Start,
            "*L*",
            label(Role::AngularMomentum),
        );
        let remarks: [(Point, Anchor, &str, Role, Point, Point); 2] = [
            (
                [112.0, 96.0],
                Anchor::End,
                "long axis",
                Role::Ink,
                [116.0, 92.0],
                [176.0, 119.0],
            ),
            (
                [500.0, 318.0],
                Anchor::Start,
                "short axis",
                Role::Omega,
                [496.0, 313.0],
                [420.0, 270.0],
            ),
        ];
        for (at, anchor, text, role, from, to) in remarks {
            pen.line(&[from, to], stroke(role, HAIR));
            pen.text(at, anchor, text, small(role));
        }
    }))
}
