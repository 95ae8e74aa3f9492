//! Poinsot's ellipsoid on its plane (tutorial 6.2).

use core::f64::consts::TAU;

use nalgebra::Vector3;
use spinning_bodies::Result;
use spinning_bodies::euler_top::{EulerTop, Poinsot};
use spinning_bodies::frame::{Attitude, BodyVector, SpaceVector};

use crate::Figure;
use crate::solid::{View, ellipse, ellipsoid_hides};
use crate::style::{
    AXIS, Anchor, DATA, HAIR, Pen, Point, Role, SECONDARY, Words, between, figure, label, number,
    small, stroke,
};

const MOMENTS: [f64; 3] = [1.0, 2.0, 3.0];
/// Angular velocity at time zero, along the body's axes.
const OMEGA: [f64; 3] = [1.3, 0.5, 0.5];
/// When the picture is taken, in periods of the polhode.
const NOW: f64 = 0.5;
/// Periods of the polhode that the herpolhode has behind it, and before it.
const BEFORE: f64 = 1.0;
const AFTER: f64 = 2.5;
/// Points of a curve for each period.
const STEPS: usize = 120;
/// Half sides of the plane.
const SHEET: [f64; 2] = [1.5, 1.3];

/// Everything along the axes of space, the third of them along L.
struct Scene {
    view: View,
    semi: [f64; 3],
    distance: f64,
    attitude: Attitude,
    contact: Vector3<f64>,
    polhode: Vec<Vector3<f64>>,
    past: Vec<Vector3<f64>>,
    future: Vec<Vector3<f64>>,
    dots: [Vec<Vector3<f64>>; 2],
}

/// The ellipsoid of inertia rolls on the invariable plane.
pub fn rolling_ellipsoid() -> Result<Figure> {
    let omega = BodyVector::new(OMEGA[0], OMEGA[1], OMEGA[2]);
    let l = BodyVector::from_components(Vector3::from(MOMENTS).component_mul(&omega.components()));
    let picture = Poinsot::new(MOMENTS, l)?;
    // L upright.
    let upright = Vector3::z();
    let tilt = l.components().angle(&upright);
    let start = Attitude::about_axis(
        BodyVector::from_components(l.components().cross(&upright)),
        tilt,
    )?;
    let top = EulerTop::from_omega(MOMENTS, omega, start)?;
    let period = top.period();
    let contact = |t: f64| -> Result<Vector3<f64>> {
        let state = top.at(t)?;
        Ok(state.attitude.to_space(state.omega).components())
    };
    let path = |from: f64, to: f64| -> Result<Vec<Vector3<f64>>> {
        let steps = ((to - from).abs() * STEPS as f64).round();
        (0..=steps as usize)
            .map(|k| contact(period * (from + (to - from) * k as f64 / steps)))
            .collect()
    };
    let now = top.at(NOW * period)?;
    let to_space = |v: BodyVector| now.attitude.to_space(v).components();
    let dots = (0..16)
        .map(|k| (NOW - BEFORE + BEFORE * f64::from(k) / 16.0) * period)
        .map(|t| Ok((to_space(top.at(t)?.omega), contact(t)?)))
        .collect::<Result<Vec<_>>>()?;
    let [inner, outer] = picture.herpolhode_radii();
    let scene = Scene {
        view: View::new(-1.05, 0.54, [300.0, 296.0], 140.0),
        semi: picture.semi_axes(),
        distance: picture.plane_distance(),
        attitude: now.attitude,
        contact: contact(NOW * period)?,
        polhode: (0..=240)
            .map(|k| to_space(picture.polhode(TAU * f64::from(k) / 240.0)))
            .collect(),
        past: path(NOW - BEFORE, NOW)?,
        future: path(NOW, NOW + AFTER)?,
        dots: [
            dots.iter().map(|d| d.0).collect(),
            dots.iter().map(|d| d.1).collect(),
        ],
    };

    let words = Words {
        claim: "The free top moves as if its ellipsoid of inertia were rolling on a plane that stands still."
            .to_owned(),
        details: format!(
            "The ellipsoid $\\Theta$ hangs by its centre $O$ and presses from below against the glass plane $\\Pi$, at distance \
             $2E/\\lvert L\\rvert = {}$. The point of contact is $\\Omega$; it runs along the polhode on the body and the herpolhode \
             on the plane, which stays between {} and {} from the foot of $L$. Dots at equal times: equal lengths on both \
             curves. $I = (1, 2, 3)$, $\\Omega = ({}, {}, {})$.",
            number(scene.distance, 4),
            number(inner, 4),
            number(outer, 4),
            OMEGA[0],
            OMEGA[1],
            OMEGA[2],
        ),
        alt: format!(
            "An ellipsoid with a fine net of meridians touches a horizontal glass plane from below in one point, the tip of the \
             angular velocity. Round the end of its longest axis runs a closed curve, the polhode; on the plane the point \
             of contact winds round and round between two circles of radius {} and {} about the vertical angular \
             momentum: the herpolhode. One curve rolls on the other.",
            number(inner, 3),
            number(outer, 3),
        ),
    };
    Ok(figure("poinsot-ellipsoid", 466.0, words, |pen| {
        scene.body(pen);
        scene.plane(pen, [inner, outer]);
        scene.labels(pen);
    }))
}

impl Scene {
    /// A point of the body, in space.
    fn space(&self, p: Vector3<f64>) -> Vector3<f64> {
        self.attitude
            .to_space(BodyVector::from_components(p))
            .components()
    }

    fn seen(&self, p: &Vector3<f64>) -> bool {
        let body = |v: &Vector3<f64>| {
            self.attitude
                .to_body(SpaceVector::from_components(*v))
                .components()
        };
        !ellipsoid_hides(&self.semi.into(), &body(p), &body(&self.view.toward))
    }

    /// The net: circles about x₁, the axis that the polhode goes round, and ellipses through its ends.
    fn net(&self) -> Vec<(Vec<Vector3<f64>>, f64)> {
        let semi = Vector3::from(self.semi);
        let curve = |center: Vector3<f64>, u: Vector3<f64>, v: Vector3<f64>| {
            ellipse(center, u, v, 180)
                .into_iter()
                .map(|p| self.space(p.component_mul(&semi)))
                .collect::<Vec<_>>()
        };
        let (x, y, z) = (Vector3::y(), Vector3::z(), Vector3::x());
        let mut net = Vec::new();
        for k in -5..=5 {
            let (s, c) = (f64::from(k) * TAU / 24.0).sin_cos();
            net.push((curve(z * s, x * c, y * c), if k == 0 { 0.55 } else { 0.25 }));
        }
        for k in 0..12 {
            let (s, c) = (f64::from(k) * TAU / 24.0).sin_cos();
            let main = if k % 6 == 0 { 0.55 } else { 0.25 };
            net.push((curve(Vector3::zeros(), x * c + y * s, z), main));
        }
        net
    }

    fn outline(&self) -> Vec<Point> {
        let semi = Vector3::from(self.semi);
        let toward = self
            .attitude
            .to_body(SpaceVector::from_components(self.view.toward))
            .components();
        let n = toward.component_div(&semi).normalize();
        let u = n.cross(&Vector3::z()).normalize();
        let v = n.cross(&u);
        let rim = ellipse(Vector3::zeros(), u, v, 240);
        rim.into_iter()
            .map(|p| self.view.project(&self.space(p.component_mul(&semi))))
            .collect()
    }

    fn body(&self, pen: &mut Pen) {
        let outline = self.outline();
        pen.fill(&outline, Role::Shade, 1.0);
        for (curve, strength) in self.net() {
            let [seen, _] = self.view.split(&curve, |p| self.seen(p));
            for piece in seen {
                pen.line(&piece, stroke(Role::Ink, HAIR).alpha(strength));
            }
        }
        pen.outline(&outline, stroke(Role::Ink, SECONDARY));
        let [seen, hidden] = self.view.split(&self.polhode, |p| self.seen(p));
        for piece in hidden {
            pen.line(&piece, stroke(Role::Ink, AXIS).alpha(0.35));
        }
        for piece in seen {
            pen.line(&piece, stroke(Role::Ink, DATA));
        }
        for dot in self.dots[0].iter().filter(|p| self.seen(p)) {
            pen.disc(self.view.project(dot), 2.6, Role::Ink, 1.0);
        }
        // What is inside the body.
        let center = self.view.project(&Vector3::zeros());
        let foot = self.view.project(&(Vector3::z() * self.distance));
        pen.line(
            &[center, foot],
            stroke(Role::AngularMomentum, SECONDARY).dotted(),
        );
        pen.line(
            &[center, self.view.project(&self.contact)],
            stroke(Role::Omega, SECONDARY).dotted(),
        );
        pen.disc(center, 2.6, Role::Ink, 1.0);
    }

    fn plane(&self, pen: &mut Pen, radii: [f64; 2]) {
        let at = |x: f64, y: f64| Vector3::new(x, y, self.distance);
        let [a, b] = SHEET;
        let sheet = self
            .view
            .trace(&[at(-a, -b), at(a, -b), at(a, b), at(-a, b)]);
        pen.fill(&sheet, Role::Ink, 0.05);
        for k in -20..=20 {
            let x = 0.25 * f64::from(k);
            for (inside, from, to) in [
                (x.abs() < a, at(x, -b), at(x, b)),
                (x.abs() < b, at(-a, x), at(a, x)),
            ] {
                if inside {
                    pen.line(
                        &self.view.trace(&[from, to]),
                        stroke(Role::Ink, HAIR).alpha(0.16),
                    );
                }
            }
        }
        pen.outline(&sheet, stroke(Role::Ink, AXIS).alpha(0.7));
        for radius in radii {
            let ring = ellipse(
                at(0.0, 0.0),
                Vector3::x() * radius,
                Vector3::y() * radius,
                120,
            );
            pen.line(&self.view.trace(&ring), stroke(Role::Muted, AXIS).dotted());
        }
        pen.line(
            &self.view.trace(&self.future),
            stroke(Role::Omega, 1.0).alpha(0.6),
        );
        pen.line(&self.view.trace(&self.past), stroke(Role::Omega, DATA));
        for dot in &self.dots[1] {
            pen.disc(self.view.project(dot), 2.4, Role::Omega, 1.0);
        }
        let foot = self.view.project(&at(0.0, 0.0));
        let tip = self.view.project(&(Vector3::z() * (self.distance + 1.0)));
        pen.disc(foot, 2.0, Role::AngularMomentum, 1.0);
        pen.arrow(foot, tip, stroke(Role::AngularMomentum, 2.6));
    }

    fn labels(&self, pen: &mut Pen) {
        let contact = self.view.project(&self.contact);
        let center = self.view.project(&Vector3::zeros());
        pen.arrow(
            between(center, contact, 0.82),
            contact,
            stroke(Role::Omega, DATA),
        );
        let tip = self.view.project(&(Vector3::z() * (self.distance + 1.0)));
        for (at, anchor, text, role) in [
            (
                [contact[0] - 3.0, contact[1] + 26.0],
                Anchor::End,
                "*Ω*",
                Role::Omega,
            ),
            (
                [tip[0] + 10.0, tip[1] + 12.0],
                Anchor::Start,
                "*L*",
                Role::AngularMomentum,
            ),
            (
                [center[0] - 10.0, center[1] + 14.0],
                Anchor::End,
                "*O*",
                Role::Ink,
            ),
            ([508.0, 424.0], Anchor::Start, "*Θ*", Role::Ink),
            ([84.0, 160.0], Anchor::Start, "*Π*", Role::Ink),
        ] {
            pen.text(at, anchor, text, label(role));
        }
        for (at, anchor, text, role, from, to) in [
            (
                [136.0, 62.0],
                Anchor::End,
                "herpolhode",
                Role::Omega,
                [139.0, 62.0],
                [238.0, 104.0],
            ),
            (
                [84.0, 374.0],
                Anchor::End,
                "polhode",
                Role::Ink,
                [88.0, 369.0],
                [152.0, 322.0],
            ),
        ] {
            pen.text(at, anchor, text, small(role));
            pen.line(&[from, to], stroke(role, HAIR));
        }
    }
}
