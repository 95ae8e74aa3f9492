//! Euler's equations as a flow on a sphere (tutorial 5.1), and the map of all tops (5.3).

mod triangle;

pub use triangle::triangle_of_tops;

use core::f64::consts::PI;

use nalgebra::Vector3;
use spinning_bodies::Result;
use spinning_bodies::euler_equations::{
    AxisMoments, Equilibrium, equilibria, fastest_flow, separatrix_slope, streamline,
};
use spinning_bodies::frame::BodyVector;
use spinning_bodies::inertia::PrincipalMoments;

use crate::Figure;
use crate::solid::{View, ellipsoid_hides, segment};
use crate::style::{
    AXIS, Anchor, DATA, Pen, Role, SECONDARY, Words, between, figure, label, number, stroke,
};

/// Strength of what lies on the far side of the sphere.
const BEHIND: f64 = 0.22;
/// Seconds between two dots.
const TICK: f64 = 0.8;
/// Steps of integration between two dots.
const STEPS: usize = 16;

/// One closed line of the flow, and the points it passes at equal times.
struct Orbit {
    curve: Vec<Vector3<f64>>,
    /// Place in `curve` of the point at time zero; the dots are a multiple of [`STEPS`] away from it.
    zero: usize,
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
        let zero = back.len() - 1;
        let mut curve: Vec<_> = back.into_iter().rev().collect();
        curve.extend(ahead.into_iter().skip(1));
        Ok(Self { curve, zero })
    }

    fn draw(&self, pen: &mut Pen, view: &View, width: f64) {
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

    fn draw_dots(&self, pen: &mut Pen, view: &View, radius: f64) {
        let dots = self.curve[self.zero % STEPS..].iter().step_by(STEPS);
        // At the rim and at the saddle they would be a blot.
        for dot in dots.filter(|p| p.dot(&view.toward) > 0.1 && p.y.abs() < 0.99) {
            pen.disc(view.project(dot), radius, Role::AngularMomentum, 1.0);
        }
    }

    /// An arrow's head in the middle of what is seen of it, between two dots.
    fn draw_sense(&self, pen: &mut Pen, view: &View, width: f64) {
        let seen = |k: &usize| self.curve[*k].dot(&view.toward) > 0.15;
        let places: Vec<usize> = (1..self.curve.len()).filter(seen).collect();
        let stride = |k: &usize| (self.curve[*k] - self.curve[*k - 1]).norm();
        let length: f64 = places.iter().map(stride).sum();
        let mut done = 0.0;
        let Some(&middle) = places.iter().find(|k| {
            done += stride(k);
            done >= 0.5 * length
        }) else {
            return;
        };
        let at = middle - (middle + STEPS - self.zero % STEPS) % STEPS + STEPS * 5 / 8;
        let (from, to) = (
            view.project(&self.curve[at]),
            view.project(&self.curve[at + 1]),
        );
        let length = (to[0] - from[0]).hypot(to[1] - from[1]);
        pen.arrow(
            between(to, from, 9.0 / length),
            to,
            stroke(Role::AngularMomentum, width),
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
        for degrees in [14.0, 32.0, 51.0, 71.0] {
            orbits.push(Orbit::new(&moments, off_axis(0, 1, sign, degrees), 0, 200)?);
        }
        for degrees in [20.0, 44.0, 70.0] {
            orbits.push(Orbit::new(&moments, off_axis(2, 1, sign, degrees), 2, 200)?);
        }
    }
    let tilt = slope.atan();
    let mut border = Vec::new();
    for (s, c) in [1.0, -1.0].map(|side| (side * tilt).sin_cos()) {
        for sign in [1.0, -1.0] {
            let start = BodyVector::new(sign * c, 0.0, sign * s);
            border.push(Orbit::new(&moments, start, 1, 40)?);
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

    let center = [300.0, 214.0];
    let view = View::new(1.08, 0.44, center, RADIUS);
    Ok(figure("momentum-flow", 424.0, words, |pen| {
        pen.disc(center, RADIUS, Role::Shade, 1.0);
        for orbit in &orbits {
            orbit.draw(pen, &view, SECONDARY);
        }
        for line in &border {
            line.draw(pen, &view, 3.2);
        }
        pen.ring(center, RADIUS, stroke(Role::Ink, AXIS));
        for orbit in &orbits {
            orbit.draw_dots(pen, &view, 2.6);
            orbit.draw_sense(pen, &view, DATA);
        }
        for line in &border {
            line.draw_dots(pen, &view, 3.3);
            line.draw_sense(pen, &view, 2.8);
        }
        axes(pen, &view);
        for Equilibrium { direction, .. } in still {
            let p = Vector3::from(direction.components());
            let seen = p.dot(&view.toward) > 0.0;
            pen.disc(
                view.project(&p),
                5.0,
                Role::Ink,
                if seen { 1.0 } else { BEHIND },
            );
        }
        let remarks = [
            (
                [70.0, 274.0],
                Anchor::Middle,
                "*x*_{1}",
                ["smallest", "moment:", "a centre"],
            ),
            (
                [452.0, 346.0],
                Anchor::Start,
                "*x*_{2}",
                ["middle moment:", "a saddle", ""],
            ),
            ([290.0, 22.0], Anchor::End, "*x*_{3}", ["", "", ""]),
        ];
        for (at, anchor, name, lines) in remarks {
            pen.text(at, anchor, name, label(Role::Ink));
            for (k, line) in lines
                .into_iter()
                .enumerate()
                .filter(|(_, line)| !line.is_empty())
            {
                let below = at[1] + 22.0 + 19.0 * k as f64;
                pen.text([at[0], below], anchor, line, label(Role::Ink));
            }
        }
        pen.text(
            [310.0, 22.0],
            Anchor::Start,
            "largest moment: a centre",
            label(Role::Ink),
        );
        pen.text(
            [182.0, 58.0],
            Anchor::End,
            "separatrix",
            label(Role::AngularMomentum),
        );
    }))
}

/// Radius of the sphere, units.
const RADIUS: f64 = 178.0;

/// The axes outside the sphere; faint and dotted behind it.
fn axes(pen: &mut Pen, view: &View) {
    let sphere = Vector3::new(1.0, 1.0, 1.0);
    for axis in 0..3 {
        for sign in [1.0, -1.0] {
            let mut p = Vector3::zeros();
            p[axis] = sign;
            let line = segment(p, p * [1.3, 1.8, 1.26][axis], 80);
            let [seen, hidden] = view.split(&line, |p| !ellipsoid_hides(&sphere, p, &view.toward));
            for piece in seen {
                pen.line(&piece, stroke(Role::Ink, SECONDARY));
            }
            for piece in hidden {
                pen.line(&piece, stroke(Role::Ink, AXIS).alpha(BEHIND).dotted());
            }
        }
    }
}
