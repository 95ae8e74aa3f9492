//! The wandering pole of the Earth (tutorial 6.5).

use core::f64::consts::TAU;

use nalgebra::Vector3;
use spinning_bodies::Result;
use spinning_bodies::euler_top::{SymmetricTop, earth};
use spinning_bodies::frame::BodyVector;

use crate::Figure;
use crate::solid::{View, ellipse, hull};
use crate::style::{
    AXIS, Anchor, DATA, HAIR, Pen, Point, Role, SECONDARY, Words, arc, figure, label, number,
    polar, small, stroke,
};

const CENTER: Point = [206.0, 208.0];
/// Days between two dots.
const STEP: f64 = 30.0;

/// One pole: its angle from the start at each dot, after the whole race, and how it is drawn.
struct Lane {
    radius: f64,
    angles: Vec<f64>,
    period: f64,
    outside: bool,
}

impl Lane {
    /// The pole of a top whose axial over transverse moment is `ratio`, turning once a day, for `days` days.
    fn new(ratio: f64, radius: f64, days: f64, outside: bool) -> Result<Self> {
        let top = SymmetricTop::new(1.0, ratio)?;
        let omega = BodyVector::new(1e-6, 0.0, TAU);
        let angle = |t: f64| {
            let now = top.omega_at(omega, t);
            now.y().atan2(now.x()).rem_euclid(TAU)
        };
        let dots = (days / STEP).round() as u32;
        Ok(Self {
            radius,
            angles: (0..=dots).map(|k| angle(STEP * f64::from(k))).collect(),
            period: top.wobble_period(omega.z()),
            outside,
        })
    }

    fn draw(&self, pen: &mut Pen) {
        let start = core::f64::consts::FRAC_PI_2;
        let (last, done) = (
            self.angles[self.angles.len() - 1],
            self.angles[self.angles.len() - 2],
        );
        // A full turn ends where it began; an angle cannot tell.
        let reached = if last < done { TAU } else { last };
        pen.ring(CENTER, self.radius, stroke(Role::Ink, HAIR).alpha(0.45));
        pen.arc(
            CENTER,
            self.radius,
            start,
            start + reached,
            stroke(Role::Omega, DATA),
        );
        for (k, &angle) in self.angles.iter().enumerate() {
            let at = polar(CENTER, self.radius, start + angle);
            let named = k % 2 == 0 && !(k == 0 || k == self.angles.len() - 1);
            pen.disc(at, if named { 4.2 } else { 3.0 }, Role::Omega, 1.0);
            if named {
                let out = if self.outside { 19.0 } else { -19.0 };
                let spot = polar(CENTER, self.radius + out, start + angle);
                let day = number(STEP * k as f64, 0);
                pen.text(
                    [spot[0], spot[1] + 4.8],
                    Anchor::Middle,
                    &day,
                    small(Role::Omega),
                );
            }
        }
    }
}

/// Two poles race for 300 days: that of a rigid Earth is home, that of the real one is not.
pub fn polar_circles() -> Result<Figure> {
    let days = earth::RIGID_TUTORIAL_PERIOD;
    let rigid = Lane::new(earth::TUTORIAL_AXIAL_OVER_TRANSVERSE, 112.0, days, false)?;
    // The top that would wobble at the observed rate: same law, its moments read off the period.
    let ratio = 1.0 + 1.0 / earth::CHANDLER_TUTORIAL_PERIOD;
    let real = Lane::new(ratio, 152.0, days, true)?;
    let lag = 360.0 - real.angles[real.angles.len() - 1].to_degrees();

    let words = Words {
        claim: "The pole of the real Earth circles more slowly than that of a rigid one."
            .to_owned(),
        details: format!(
            "Path of the axis of rotation over the ground about the axis of figure, seen from above the north pole; a dot \
             every {STEP} days, for {} days. Inner circle: rigid, $I_3/I_1 = 301/300$, period {} days. Outer circle: the \
             observed Chandler wobble at the tutorial's round {} days, {} degrees behind. The size of a circle is free; \
             the pace is not.",
            number(days, 0),
            number(rigid.period, 0),
            number(real.period, 0),
            number(lag, 0),
        ),
        alt: format!(
            "Two concentric circles round the pole of figure, walked anticlockwise from the top like lanes of a race \
             track, with a dot every thirty days. After {} days the inner runner, the rigid Earth, is back at the start; \
             the outer one, the real Earth with its period of {} days, is still {} degrees short.",
            number(days, 0),
            number(real.period, 0),
            number(lag, 0),
        ),
    };

    Ok(figure("polar-circles", 404.0, words, |pen| {
        let start = core::f64::consts::FRAC_PI_2;
        // What is missing.
        let end = start + real.angles[real.angles.len() - 1];
        let mut gap = arc(CENTER, 152.0, end, start + TAU);
        gap.push(CENTER);
        pen.fill(&gap, Role::Ink, 0.06);
        pen.line(
            &[CENTER, polar(CENTER, 172.0, start)],
            stroke(Role::Ink, AXIS),
        );
        pen.line(
            &[CENTER, polar(CENTER, 172.0, end)],
            stroke(Role::Ink, AXIS).dotted(),
        );
        rigid.draw(pen);
        real.draw(pen);
        // The axis of figure, end on.
        pen.ring(CENTER, 6.0, stroke(Role::Ink, SECONDARY));
        pen.disc(CENTER, 2.0, Role::Ink, 1.0);
        pen.text(
            [CENTER[0] - 12.0, CENTER[1] + 5.0],
            Anchor::End,
            "*x*_{3}",
            label(Role::Ink),
        );
        let home = polar(CENTER, 112.0, start);
        let short = polar(CENTER, 152.0, end);
        for at in [home, short] {
            pen.ring(at, 8.0, stroke(Role::Omega, SECONDARY));
        }
        pen.text([CENTER[0], 26.0], Anchor::Middle, "start", small(Role::Ink));
        let x = 400.0;
        let note = |pen: &mut Pen, y: f64, head: &str, tail: &str| {
            pen.text([x, y], Anchor::Start, head, label(Role::Omega).strong());
            pen.text([x, y + 20.0], Anchor::Start, tail, small(Role::Ink));
        };
        pen.text(
            [x, 106.0],
            Anchor::Start,
            &format!("after {} days", number(days, 0)),
            label(Role::Ink),
        );
        note(
            pen,
            148.0,
            &format!("rigid: {} days", number(rigid.period, 0)),
            "inner lane, back home",
        );
        note(
            pen,
            204.0,
            &format!("observed: {} days", number(real.period, 0)),
            &format!("outer lane, {}° to go", number(lag, 0)),
        );
    }))
}

/// Length of the sides of the cones, units.
const SIDE: f64 = 196.0;

/// A flat and a long body: the cone of the axis of rotation in the body rolls on the one in space.
pub fn precession_cones() -> Result<Figure> {
    let omega = BodyVector::new(0.56, 0.0, 1.0);
    let (flat, long) = (SymmetricTop::new(1.0, 1.7)?, SymmetricTop::new(1.0, 0.5)?);
    let (flat_cones, long_cones) = (flat.cones(omega)?, long.cones(omega)?);
    let degrees = |angle: f64| number(angle.to_degrees(), 1);

    let words = Words {
        claim: "A body cone rolls on a space cone: round it if the body is flat, on its outside if it is long.".to_owned(),
        details: format!(
            "The cones of a free symmetric top touch along $\\Omega$; the space cone, about $L$, stands still. Half-angles of \
             body cone and space cone: {} and {} degrees for $I_3/I_1 = {}$, {} and {} degrees for $I_3/I_1 = {}$, both with \
             $\\Omega_\\perp/\\Omega_3 = {}$.",
            degrees(flat_cones.body),
            degrees(flat_cones.space),
            flat.axial(),
            degrees(long_cones.body),
            degrees(long_cones.space),
            long.axial(),
            omega.x(),
        ),
        alt: format!(
            "Two pairs of cones with a common tip. Left, a flat body: the wide cone of {} degrees about the body's axis \
             surrounds the narrow cone of {} degrees about the vertical angular momentum. Right, a long body: the two cones \
             stand side by side. Each pair touches along the angular velocity, so one cone rolls on the other.",
            degrees(flat_cones.body),
            degrees(flat_cones.space),
        ),
    };

    Ok(figure("precession-cones", 372.0, words, |pen| {
        let panels = [
            (&flat_cones, -1.0, [166.0, 300.0], "flat"),
            (&long_cones, 1.0, [372.0, 300.0], "long"),
        ];
        for (cones, side, tip, name) in panels {
            // L upright; Omega on the right of it, the axis beyond L if the body is flat, beyond Omega if it is long.
            let view = View::new(-core::f64::consts::FRAC_PI_2, 0.3, tip, SIDE);
            let tilted = |angle: f64| Vector3::new(angle.sin(), 0.0, angle.cos());
            let (l, spin, axis) = (
                tilted(0.0),
                tilted(cones.space),
                tilted(side * cones.nutation),
            );
            cone(pen, &view, &axis, cones.body, Role::Ink);
            cone(pen, &view, &l, cones.space, Role::AngularMomentum);
            for (vector, text, role, width) in [
                (axis, "*x*_{3}", Role::Ink, SECONDARY),
                (l, "*L*", Role::AngularMomentum, DATA),
                (spin, "*Ω*", Role::Omega, 2.8),
            ] {
                let end = view.project(&(vector * 1.2));
                pen.arrow(tip, end, stroke(role, width));
                let beyond = view.project(&(vector * 1.29));
                pen.text(
                    [beyond[0], beyond[1] + 5.0],
                    Anchor::Middle,
                    text,
                    label(role),
                );
            }
            pen.text(
                [tip[0], tip[1] + 40.0],
                Anchor::Middle,
                name,
                label(Role::Ink),
            );
        }
        for (at, anchor, text, role) in [
            ([84.0, 290.0], Anchor::End, "body cone", Role::Ink),
            (
                [324.0, 240.0],
                Anchor::End,
                "space cone",
                Role::AngularMomentum,
            ),
            ([470.0, 306.0], Anchor::Start, "body cone", Role::Ink),
        ] {
            pen.text(at, anchor, text, small(role));
        }
    }))
}

/// A cone with its tip in the origin, seen from outside.
fn cone(pen: &mut Pen, view: &View, axis: &Vector3<f64>, half_angle: f64, role: Role) {
    let across = Vector3::y().cross(axis).normalize();
    let (s, c) = half_angle.sin_cos();
    let rim = view.trace(&ellipse(axis * c, across * s, Vector3::y() * s, 180));
    let mut outline = rim.clone();
    outline.push(view.project(&Vector3::zeros()));
    let outline = hull(&outline);
    pen.fill(&outline, role, 0.09);
    pen.outline(&outline, stroke(role, AXIS));
    pen.line(&rim, stroke(role, SECONDARY));
}
