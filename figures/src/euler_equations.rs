//! Euler's equations as a flow on a sphere (tutorial 5.1), and the map of all tops (5.3).

use core::f64::consts::PI;

use nalgebra::Vector3;
use spinning_bodies::Result;
use spinning_bodies::euler_equations::{
    AxisMoments, Equilibrium, Nature, equilibria, fastest_flow, separatrix_slope, streamline,
};
use spinning_bodies::euler_top::earth;
use spinning_bodies::frame::BodyVector;
use spinning_bodies::inertia::{MassProperties, PrincipalMoments, shapes};

use crate::Figure;
use crate::solid::{View, ellipse};
use crate::style::{
    AXIS, Anchor, DATA, HAIR, Pen, Point, Role, SECONDARY, Words, between, figure, label, number,
    small, stroke,
};

/// Strength of what lies on the far side of the sphere.
const BEHIND: f64 = 0.3;
/// Seconds between two dots.
const TICK: f64 = 0.6;
/// Steps of integration between two dots.
const STEPS: usize = 12;

/// One closed line of the flow, and the points it passes at equal times.
struct Orbit {
    curve: Vec<Vector3<f64>>,
    dots: Vec<Vector3<f64>>,
}

impl Orbit {
    /// From `start` both ways, until half of the way round `axis` is done, or for `most` ticks.
    fn new(moments: &AxisMoments, start: BodyVector, axis: usize, most: usize) -> Result<Self> {
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let half = |step: f64| -> Result<Vec<Vector3<f64>>> {
            let points = streamline(moments, start, step, most * STEPS)?;
            let angle = |p: &BodyVector| p.components()[k].atan2(p.components()[j]);
            let (mut swept, mut last) = (0.0, angle(&points[0]));
            let mut path = Vec::new();
            for point in &points {
                let now = angle(point);
                swept += (now - last + PI).rem_euclid(2.0 * PI) - PI;
                last = now;
                path.push(Vector3::from(point.components()));
                if swept.abs() > PI {
                    break;
                }
            }
            Ok(path)
        };
        let step = TICK / STEPS as f64;
        let (ahead, back) = (half(step)?, half(-step)?);
        let ticks = |path: &[Vector3<f64>]| -> Vec<Vector3<f64>> {
            path.iter().copied().step_by(STEPS).collect()
        };
        let mut dots = ticks(&ahead);
        dots.extend(&ticks(&back)[1..]);
        let mut curve: Vec<_> = back.into_iter().rev().collect();
        curve.extend(ahead.into_iter().skip(1));
        Ok(Self { curve, dots })
    }

    fn draw(&self, pen: &mut Pen<'_>, view: &View, width: f64) {
        let front = |p: &Vector3<f64>| p.dot(&view.toward) > 0.0;
        let [seen, hidden] = view.split(&self.curve, front);
        for piece in hidden {
            pen.line(
                &piece,
                stroke(Role::AngularMomentum, 0.8 * width).alpha(BEHIND),
            );
        }
        for piece in seen {
            pen.line(&piece, stroke(Role::AngularMomentum, width));
        }
    }

    fn draw_dots(&self, pen: &mut Pen<'_>, view: &View, radius: f64) {
        for dot in self.dots.iter().filter(|p| p.dot(&view.toward) > 0.12) {
            pen.disc(view.project(dot), radius, Role::AngularMomentum, 1.0);
        }
    }

    /// An arrow's head where the curve has done this fraction of its way.
    fn draw_sense(&self, pen: &mut Pen<'_>, view: &View, fraction: f64) {
        let at = ((self.curve.len() - 2) as f64 * fraction) as usize;
        let (from, to) = (
            view.project(&self.curve[at]),
            view.project(&self.curve[at + 1]),
        );
        let length = (to[0] - from[0]).hypot(to[1] - from[1]);
        pen.arrow(
            between(to, from, 9.0 / length),
            to,
            stroke(Role::AngularMomentum, DATA),
        );
    }
}

/// A point of the unit sphere, `degrees` away from `axis` towards `other`.
fn off_axis(axis: usize, other: usize, sign: f64, degrees: f64) -> BodyVector {
    let mut p = [0.0; 3];
    let (s, c) = degrees.to_radians().sin_cos();
    (p[axis], p[other]) = (sign * c, s);
    BodyVector::new(p[0], p[1], p[2])
}

/// The flow of L on its sphere for the moments 1, 2, 3.
pub fn momentum_flow() -> Result<Figure> {
    let moments = AxisMoments::new(1.0, 2.0, 3.0)?;
    let sorted = PrincipalMoments::new(1.0, 2.0, 3.0)?;
    let (still, slope) = (equilibria(&moments), separatrix_slope(&sorted));
    // Started where they are nearest to the saddle x₂, in front: the odd gap between the last dots lies behind.
    let mut orbits = Vec::new();
    for sign in [1.0, -1.0] {
        for degrees in [14.0, 31.0, 49.0, 67.0, 82.0] {
            orbits.push(Orbit::new(
                &moments,
                off_axis(0, 1, sign, degrees),
                0,
                200,
            )?);
        }
        for degrees in [20.0, 44.0, 68.0, 82.0] {
            orbits.push(Orbit::new(
                &moments,
                off_axis(2, 1, sign, degrees),
                2,
                200,
            )?);
        }
    }
    let tilt = slope.atan();
    let mut border = Vec::new();
    for (s, c) in [1.0, -1.0].map(|side| (side * tilt).sin_cos()) {
        for sign in [1.0, -1.0] {
            let start = BodyVector::new(sign * c, 0.0, sign * s);
            border.push(Orbit::new(&moments, start, 1, 20)?);
        }
    }

    let fastest = fastest_flow(&sorted);
    let growth = still[2].growth_squared.sqrt();
    let words = Words {
        claim: "Without torque the angular momentum flows on a sphere, round four centres and past two saddles.".to_owned(),
        details: format!(
            "The sphere $\\lvert L\\rvert=1$ seen from a body with $I_1={}$, $I_2={}$, $I_3={}$; a dot every {TICK} seconds. \
             Centres about $\\pm x_1$ and $\\pm x_3$, saddles at $\\pm x_2$, from which $L$ departs at first as \
             $e^{{{}\\,t}}$. The heavy lines are two great circles, $L_3=\\pm{}L_1$. The flow is fastest, {} per second, \
             halfway between $x_1$ and $x_3$.",
            moments.values()[0],
            moments.values()[1],
            moments.values()[2],
            number(growth, 4),
            number(slope, 4),
            number(fastest, 4),
        ),
        alt: format!(
            "A sphere with the three principal axes of a body sticking out. Closed curves circle the axis of the smallest \
             moment and the axis of the largest one. At the axis of the middle moment two heavy great circles cross, \
             inwards along one, outwards along the other; they divide the sphere into four parts. Dots every {TICK} seconds \
             crowd together towards that crossing.",
        ),
    };

    let view = View::new(0.92, 0.4, [300.0, 222.0], 178.0);
    Ok(figure("momentum-flow", 432.0, words, |pen| {
        pen.disc([300.0, 222.0], 178.0, Role::Shade, 1.0);
        axes(pen, &view, -1.0);
        for orbit in &orbits {
            orbit.draw(pen, &view, SECONDARY);
        }
        for line in &border {
            line.draw(pen, &view, 3.0);
        }
        for orbit in &orbits {
            orbit.draw_dots(pen, &view, 2.4);
        }
        for line in &border {
            line.draw_dots(pen, &view, 3.4);
        }
        for (n, fraction) in [(2, 0.62), (7, 0.4)] {
            orbits[n].draw_sense(pen, &view, fraction);
        }
        pen.ring([300.0, 222.0], 178.0, stroke(Role::Ink, AXIS));
        axes(pen, &view, 1.0);
        for Equilibrium {
            direction, nature, ..
        } in still
        {
            let p = Vector3::from(direction.components());
            let at = view.project(&p);
            if p.dot(&view.toward) > 0.0 {
                pen.disc(at, 4.6, Role::Ink, 1.0);
                let _ = nature == Nature::Center;
            }
        }
    }))
}

/// The axes outside the sphere, those that point to the eye (`side` 1) or away from it (−1).
fn axes(pen: &mut Pen<'_>, view: &View, side: f64) {
    for axis in 0..3 {
        for sign in [1.0, -1.0] {
            let mut p = Vector3::zeros();
            p[axis] = sign;
            if p.dot(&view.toward) * side > 0.0 {
                let (from, to) = (view.project(&p), view.project(&(p * 1.3)));
                pen.line(&[from, to], stroke(Role::Ink, SECONDARY));
            }
        }
    }
}
