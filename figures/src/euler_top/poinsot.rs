//! Poinsot's ellipsoid on its plane (tutorial 6.2).

use spinning_bodies::euler_top::{Poinsot, Sector};
use spinning_bodies::frame::{Attitude, BodyVector, SpaceVector};

use super::body::*;
use crate::prelude::*;

parameters! {
    FIRST: "first", r"\Omega_1", "rad/s", "angular velocity about the axis of the smallest moment", [0.1, 2.0], 1.3;
    SECOND: "second", r"\Omega_2", "rad/s", "angular velocity about the middle axis", [0.1, 2.0], 0.5;
    THIRD: "third", r"\Omega_3", "rad/s", "angular velocity about the axis of the largest moment", [0.1, 2.0], 0.5;
}
/// The parameters: the moments, and the angular velocity at time zero along the body's axes.
pub const POINSOT: &[Parameter] = &[SMALLEST, MIDDLE, LARGEST, FIRST, SECOND, THIRD];

/// The time of the picture, in periods of the polhode.
const NOW: f64 = 0.5;
/// Periods of the polhode for which the herpolhode is drawn, before and after the picture.
const BEFORE: f64 = 1.0;
const AFTER: f64 = 2.5;
/// Points of a curve for each period.
const STEPS: f64 = 160.0;
/// Half sides of the plane, in units of the distance; no less than room for the herpolhode.
const SHEET: [f64; 2] = [1.13, 0.98];
/// Where the picture stands, and how high L reaches over the plane, in distances.
const ROOM: [f64; 4] = [26.0, 14.0, 574.0, 452.0];
const HIGH: f64 = 0.72;
/// The view: azimuth and elevation.
const DIRECTION: [f64; 2] = [-1.05, 0.54];
/// The azimuth of the point of contact in that view, whatever the body.
const BESIDE: f64 = -1.6167773521573177;

/// Everything along the axes of space, the third of them along L.
struct Scene {
    view: View,
    /// By how much the sheet and the eye have turned with the point of contact.
    turn: f64,
    semi: [f64; 3],
    sector: Sector,
    /// Half sides of the plane.
    sheet: [f64; 2],
    distance: f64,
    attitude: Attitude,
    contact: Vector,
    polhode: Vec<Vector>,
    past: Vec<Vector>,
    future: Vec<Vector>,
    dots: [Vec<Vector>; 2],
}

/// The ellipsoid of inertia rolls on the invariable plane.
pub fn rolling(values: &Values) -> Result<Figure> {
    let moments = moments(values);
    let start_omega = values.each([FIRST, SECOND, THIRD]);
    let omega = BodyVector::from_components(start_omega.into());
    let l = BodyVector::from_components(Vector::from(moments).component_mul(&omega.components()));
    let picture = Poinsot::new(moments, l)?;
    // L upright.
    let upright = Vector::z();
    let tilt = l.components().angle(&upright);
    let axis = BodyVector::from_components(l.components().cross(&upright));
    let start = Attitude::about_axis(axis, tilt)?;
    let top = top_of(moments, omega, start)?;
    // On the separatrix there is no period; the picture shows part of its single half turn.
    let period = match top.period() {
        period if period.is_finite() => period,
        _ => 8.0 * TAU / omega.norm(),
    };
    let contact = |t: f64| -> Result<Vector> {
        let state = top.at(t)?;
        Ok(state.attitude.to_space(state.omega).components())
    };
    let path = |from: f64, to: f64| {
        let steps = ((to - from) * STEPS).round() as u32;
        tried(spaced([from, to], steps), |share| contact(period * share))
    };
    let now = top.at(NOW * period)?;
    let to_space = |v: BodyVector| now.attitude.to_space(v).components();
    let dots = (0..16).map(|k| (NOW - BEFORE + BEFORE * f64::from(k) / 16.0) * period);
    let on_the_body = |t: f64| Ok(to_space(top.at(t)?.omega));
    let [inner, outer] = picture.herpolhode_radii();
    let touch = contact(NOW * period)?;
    let turn = touch.y.atan2(touch.x) - BESIDE;
    let distance = picture.plane_distance;
    let room = 1.2 * outer / distance / SHEET[1];
    let mut scene = Scene {
        view: View::new(DIRECTION[0] + turn, DIRECTION[1], [0.0; 2], 1.0),
        turn,
        semi: picture.semi_axes,
        sector: picture.sector,
        sheet: SHEET.map(|half| half * distance * room.max(1.0)),
        distance,
        attitude: now.attitude,
        contact: touch,
        polhode: spaced([0.0, TAU], 240)
            .map(|turn| to_space(picture.polhode(turn)))
            .collect(),
        past: path(NOW - BEFORE, NOW)?,
        future: path(NOW, NOW + AFTER)?,
        dots: [tried(dots.clone(), on_the_body)?, tried(dots, contact)?],
    };
    let mut points = scene.outline();
    points.extend(scene.corners());
    points.push(Vector::z() * scene.tip());
    let direction = [DIRECTION[0] + turn, DIRECTION[1]];
    scene.view = View::fitted(direction, &points, ROOM, f64::INFINITY);
    let about = match scene.sector {
        Sector::AroundSmallest => "the axis of the smallest moment, the long one",
        Sector::AroundLargest => "the axis of the largest moment, the short one",
        _ => "neither axis but from one end of the middle axis to the other, on the separatrix",
    };

    let [inertia, spun] = [moments, start_omega].map(triple);
    let beyond = remark(moments);
    let words = words!(
        "The free top moves as if its ellipsoid of inertia were rolling on a plane that stands still.",
        "The ellipsoid $\\Theta$ touches the plane $\\Pi$ from below at $\\Omega$, which runs along polhode and herpolhode; dots at equal times: equal lengths on both. $\\Pi$ \
         is $2E/\\lvert L\\rvert = {distance:.4}$ from the centre $O$. The herpolhode stays between {inner:.4} and {outer:.4} from $L$, the polhode goes round {about}. $I = \
         {inertia}$ kg m², $\\Omega = {spun}$ rad/s.{beyond}",
        "An ellipsoid with a fine net of meridians touches a horizontal glass plane from below in one point, the tip of the \
         angular velocity. Round {about}, runs a curve, the polhode; on the plane the point \
         of contact winds round and round between two circles of radius {inner:.3} and {outer:.3} about the vertical angular \
         momentum: the herpolhode. One curve rolls on the other."
    );
    let made = figure("poinsot-ellipsoid", 466.0, words, |pen| {
        scene.solid(pen);
        scene.plane(pen, [inner, outer]);
        scene.labels(pen);
    });
    let columns = "Ω_x (rad/s) | Ω_y (rad/s) | Ω_z, along L (rad/s)";
    let rows = |curve: Vec<Vector>| curve.into_iter().map(<[f64; 3]>::from);
    Ok(made
        .data("polhode, as the body stands", columns, rows(scene.polhode))
        .data("herpolhode, behind", columns, rows(scene.past))
        .data("herpolhode, ahead", columns, rows(scene.future)))
}

impl Scene {
    /// A point of the body, in space.
    fn space(&self, p: Vector) -> Vector {
        turned(&self.attitude, p)
    }

    /// A direction in space, along the axes of the body.
    fn body(&self, v: Vector) -> Vector {
        let v = SpaceVector::from_components(v);
        self.attitude.to_body(v).components()
    }

    fn seen(&self, p: &Vector) -> bool {
        let toward = self.body(self.view.toward);
        !ellipsoid_hides(&self.semi.into(), &self.body(*p), &toward)
    }

    /// A point of the plane, along the sides of the sheet.
    fn on_the_plane(&self, x: f64, y: f64) -> Vector {
        let (s, c) = self.turn.sin_cos();
        Vector::new(c * x - s * y, s * x + c * y, self.distance)
    }

    fn corners(&self) -> [Vector; 4] {
        let [a, b] = self.sheet;
        [[-a, -b], [a, -b], [a, b], [-a, b]].map(|[x, y]| self.on_the_plane(x, y))
    }

    /// How high the arrow of L reaches.
    fn tip(&self) -> f64 {
        self.distance * (1.0 + HIGH)
    }

    /// The net: circles about the axis that the polhode goes round, and ellipses through its ends.
    fn net(&self) -> Vec<(Vec<Vector>, f64)> {
        let semi = Vector::from(self.semi);
        let curve = |center: Vector, u: Vector, v: Vector| -> Vec<Vector> {
            let round = ellipse(center, u, v, 180).into_iter();
            round.map(|p| self.space(p.component_mul(&semi))).collect()
        };
        let (x, y, z) = match self.sector {
            Sector::AroundLargest => (Vector::x(), Vector::y(), Vector::z()),
            _ => (Vector::y(), Vector::z(), Vector::x()),
        };
        let mut net = Vec::new();
        for k in -5..=5 {
            let (s, c) = (f64::from(k) * TAU / 24.0).sin_cos();
            net.push((curve(z * s, x * c, y * c), if k == 0 { 0.55 } else { 0.25 }));
        }
        for k in 0..12 {
            let (s, c) = (f64::from(k) * TAU / 24.0).sin_cos();
            let main = if k % 6 == 0 { 0.55 } else { 0.25 };
            net.push((curve(Vector::zeros(), x * c + y * s, z), main));
        }
        net
    }

    fn outline(&self) -> Vec<Vector> {
        let rim = rim(&self.semi.into(), &self.body(self.view.toward), 240);
        rim.into_iter().map(|p| self.space(p)).collect()
    }

    fn solid(&self, pen: &mut Pen) {
        let outline = self.view.trace(&self.outline());
        pen.fill(&outline, Shade, 1.0);
        for (curve, strength) in self.net() {
            let [seen, _] = self.view.split(&curve, |p| self.seen(p));
            pen.lines(seen, inked(HAIR).alpha(strength));
        }
        pen.outline(&outline, inked(SECONDARY));
        let [seen, hidden] = self.view.split(&self.polhode, |p| self.seen(p));
        pen.lines(hidden, inked(AXIS).alpha(0.35));
        pen.lines(seen, inked(DATA));
        for dot in self.dots[0].iter().filter(|p| self.seen(p)) {
            pen.dot(self.view.project(dot), 2.6);
        }
        // What is inside the body.
        let center = self.view.project(&Vector::zeros());
        let foot = self.view.project(&(Vector::z() * self.distance));
        pen.line([center, foot], stroke(AngularMomentum, SECONDARY).dotted());
        let rule = [center, self.view.project(&self.contact)];
        pen.line(rule, stroke(Omega, SECONDARY).dotted());
        pen.dot(center, 2.6);
    }

    fn plane(&self, pen: &mut Pen, radii: [f64; 2]) {
        let at = |x: f64, y: f64| self.on_the_plane(x, y);
        let [a, b] = self.sheet;
        let sheet = self.view.trace(&self.corners());
        pen.fill(&sheet, Ink, 0.05);
        let mesh = a / 6.0;
        for k in -6..=6 {
            let x = mesh * f64::from(k);
            for (inside, from, to) in [
                (x.abs() < 0.999 * a, at(x, -b), at(x, b)),
                (x.abs() < b, at(-a, x), at(a, x)),
            ] {
                if inside {
                    pen.line(self.view.trace(&[from, to]), inked(HAIR).alpha(0.16));
                }
            }
        }
        pen.outline(&sheet, inked(AXIS).alpha(0.7));
        for radius in radii {
            let ring = latitude(self.distance, radius, 120);
            pen.line(self.view.trace(&ring), muted(AXIS).dotted());
        }
        pen.line(self.view.trace(&self.future), stroke(Omega, 1.0).alpha(0.6));
        pen.line(self.view.trace(&self.past), stroke(Omega, DATA));
        for dot in &self.dots[1] {
            pen.disc(self.view.project(dot), 2.4, Omega, 1.0);
        }
        let foot = self.view.project(&at(0.0, 0.0));
        let tip = self.view.project(&(Vector::z() * self.tip()));
        pen.disc(foot, 2.0, AngularMomentum, 1.0);
        pen.arrow(foot, tip, stroke(AngularMomentum, 2.6));
    }

    fn labels(&self, pen: &mut Pen) {
        let contact = self.view.project(&self.contact);
        let center = self.view.project(&Vector::zeros());
        pen.arrow(between(center, contact, 0.82), contact, stroke(Omega, DATA));
        let tip = self.view.project(&(Vector::z() * self.tip()));
        // The lower right of the body, and the left corner of the sheet.
        let outline = self.view.trace(&self.outline());
        let lower = |a: &&Point, b: &&Point| (a[0] + a[1]).total_cmp(&(b[0] + b[1]));
        let corner = outline.iter().max_by(lower).copied().unwrap_or(center);
        let inside = self.sheet.map(|half| -0.72 * half);
        let inside = self.view.project(&self.on_the_plane(inside[0], inside[1]));
        // Round its point, in this direction if there is room.
        for (about, direction, text, role) in [
            (between(center, contact, 0.84), 3.6, "*Ω*", Omega),
            (tip, 0.4, "*L*", AngularMomentum),
            (center, 0.0, "*O*", Ink),
            (corner, -0.6, "*Θ*", Ink),
            (inside, 2.6, "*Π*", Ink),
        ] {
            let places = (0..72).map(|k| {
                let (far, turn) = (17 + 5 * (k / 24), f64::from((k % 24 + 1) / 2) * TAU / 24.0);
                let side = if k % 2 == 0 { turn } else { -turn };
                polar(about, f64::from(far), direction + side)
            });
            pen.name(places, text, label(role));
        }
        let seen = self.polhode.iter().filter(|p| self.seen(p)).copied();
        let seen: Vec<Vector> = seen.collect();
        // In a corner that the body leaves free.
        let over = ([[524.0, 35.0], [76.0, 35.0]], "herpolhode", Omega);
        let under = ([[52.0, 439.0], [548.0, 439.0]], "polhode", Ink);
        for ((places, text, role), curve) in [(over, &self.past), (under, &seen)] {
            let half = 3.7 * text.len() as f64;
            let [x, y] = pen.room(places, [half, 7.0]);
            pen.text([x, y + 5.0], Middle, text, small(role));
            let from = [x + (half + 3.0) * (300.0 - x).signum(), y];
            if let Some(to) = nearest(from, self.view.trace(curve)) {
                pen.line([from, to], stroke(role, HAIR));
            }
        }
    }
}
