//! The wandering pole of the Earth (tutorial 6.5).

use core::f64::consts::TAU;

use spinning_bodies::Result;
use spinning_bodies::euler_top::{SymmetricTop, earth};
use spinning_bodies::frame::BodyVector;

use crate::Figure;
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

    fn draw(&self, pen: &mut Pen<'_>) {
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
        let note = |pen: &mut Pen<'_>, y: f64, head: &str, tail: &str| {
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
            "inner lane, back at the start",
        );
        note(
            pen,
            204.0,
            &format!("observed: {} days", number(real.period, 0)),
            &format!("outer lane, {}° to go", number(lag, 0)),
        );
    }))
}
