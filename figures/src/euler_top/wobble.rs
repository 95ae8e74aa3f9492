//! The wandering pole of the Earth (tutorial 6.5).

use spinning_bodies::euler_top::{Cones, Shape, SymmetricTop};
use spinning_bodies::frame::BodyVector;

use crate::prelude::*;

const CENTER: Point = [206.0, 208.0];
/// Days between two dots.
const STEP: f64 = 30.0;

parameters! {
    RIGID: "rigid", r"T_0", "days", "period of the wobble of a rigid body of these moments, I₁/(I₃ − I₁) of its days", [100.0, 600.0], 300.0, whole;
    OBSERVED: "observed", "T", "days", "period of the wobble that is observed", [100.0, 600.0], 433.0, whole;
}
/// The parameters of the race of the poles.
pub const CIRCLES: &[Parameter] = &[RIGID, OBSERVED];

/// One pole: how far it goes in a day, and how it is drawn. Angles from the start.
struct Lane {
    radius: f64,
    /// Radians a day.
    rate: f64,
    /// How far outside of it the days stand.
    aside: f64,
}

impl Lane {
    /// The pole of a top that turns once a day and wobbles in `period` days.
    fn new(period: f64, radius: f64, aside: f64) -> Result<Self> {
        let top = SymmetricTop::new(1.0, 1.0 + 1.0 / period)?;
        Ok(Self {
            radius,
            rate: top.wobble_rate(TAU),
            aside,
        })
    }

    fn at(&self, out: f64, angle: f64) -> Point {
        polar(CENTER, self.radius + out, START + angle)
    }

    /// The way of so many days, at most once round; `lines` are angles that numbers keep off.
    fn draw(&self, pen: &mut Pen, days: f64, lines: [f64; 2]) {
        let reached = (self.rate * days).min(TAU);
        pen.ring(CENTER, self.radius, inked(HAIR).alpha(0.45));
        let style = stroke(Omega, DATA);
        pen.arc(CENTER, self.radius, START, START + reached, style);
        let dots = (0..).map(|k| (k, self.rate * STEP * f64::from(k)));
        for (k, angle) in dots.take_while(|(_, angle)| *angle < reached + 1e-6) {
            let near = |line: &f64| (0.5 * (angle - line)).sin().abs() < 0.11;
            let named = k % 2 == 0 && !lines.iter().any(near);
            let size = if named { 4.2 } else { 3.0 };
            pen.disc(self.at(0.0, angle), size, Omega, 1.0);
            if named {
                let beside = shifted(self.at(self.aside, angle), [0.0, 4.8]);
                let day = number(STEP * f64::from(k), 0);
                pen.text(beside, Middle, &day, small(Omega));
            }
        }
    }
}

/// Where the race starts: at the top.
const START: f64 = FRAC_PI_2;

/// Two poles race until that of a rigid Earth is home; that of the real one is not.
pub fn polar_circles(values: &Values) -> Result<Figure> {
    let [days, period] = values.each([RIGID, OBSERVED]);
    let rigid = Lane::new(days, 112.0, -20.0)?;
    let real = Lane::new(period, 152.0, 20.0)?;
    let reached = real.rate * days;
    // The angle that it still has to go, if any.
    let lag = TAU - reached;
    let degrees = number(lag.abs().to_degrees(), 0);
    let earth = (days, period) == (RIGID.default, OBSERVED.default);
    let slower = match earth {
        true => "The pole of the real Earth circles more slowly than that of a rigid one.",
        false => "This pole circles more slowly than that of a rigid body: the body gives way.",
    };
    let (claim, [behind, seen, told]) = match lag {
        _ if degrees == "0" => (
            "A pole that wobbles as that of a rigid body walks beside it.",
            ["at the same place", "back at the start too", "home as well"].map(str::to_owned),
        ),
        _ if lag > 0.0 => (
            slower,
            [
                format!("{degrees}° behind"),
                format!("still {degrees}° short"),
                format!("{degrees}° to go"),
            ],
        ),
        _ => (
            "This pole circles faster than that of a rigid body: no body that gives way does so.",
            [
                format!("{degrees}° ahead"),
                format!("{degrees}° beyond it"),
                format!("{degrees}° beyond"),
            ],
        ),
    };
    let longer = days + 1.0;
    let whose = [", Chandler's,", ""][usize::from(period != OBSERVED.default)];
    let words = words!(
        "{claim}",
        "Path of the axis of rotation over the ground about the axis of figure, seen from above the north pole; a dot \
         every {STEP} days, for {days} days or once round. Inner circle: rigid, $I_3/I_1 = {longer}/{days}$, period {days} days. Outer circle: an \
         observed wobble{whose} of {period} days, {behind}. The size of a circle is free; \
         the pace is not.",
        "Two concentric circles round the pole of figure, walked anticlockwise from the top like lanes of a race \
         track, with a dot every thirty days. After {days} days the inner runner, the rigid Earth, is back at the start; \
         the outer one, with its period of {period} days, is {seen}."
    );
    let made = figure("polar-circles", 392.0, words, |pen| {
        let end = START + reached;
        // The angle that is missing or in excess.
        if lag.abs() > 1e-6 {
            let [from, to] = match lag > 0.0 {
                true => [end, START + TAU],
                false => [START, START + (-lag).min(TAU)],
            };
            let mut gap = arc(CENTER, 152.0, from, to);
            gap.push(CENTER);
            pen.fill(&gap, Ink, 0.06);
        }
        let sides = [(START, inked(AXIS)), (end, inked(AXIS).dotted())];
        for (angle, style) in sides {
            pen.line([CENTER, polar(CENTER, 172.0, angle)], style);
        }
        rigid.draw(pen, days, [0.0, reached]);
        real.draw(pen, days, [0.0, reached]);
        // The axis of figure, end on.
        pen.ring(CENTER, 6.0, inked(SECONDARY));
        pen.dot(CENTER, 2.0);
        // On the side of the axis that the dotted line does not take.
        let taken = (reached - 0.25 * TAU).sin().abs() < 0.55 && reached.sin() > 0.0;
        let (side, anchor) = if taken { (12.0, Start) } else { (-12.0, End) };
        pen.label(shifted(CENTER, [side, 5.0]), anchor, "*x*_{3}");
        for at in [rigid.at(0.0, 0.0), real.at(0.0, reached)] {
            pen.ring(at, 8.0, stroke(Omega, SECONDARY));
        }
        pen.note([CENTER[0], 26.0], Middle, "start");
        let x = 400.0;
        pen.label([x, 156.0], Start, &format!("after {days} days"));
        for (y, whose, period, tail) in [
            (198.0, "rigid", days, "inner lane, back home"),
            (254.0, "observed", period, &format!("outer lane, {told}")),
        ] {
            let head = format!("{whose}: {period} days");
            pen.text([x, y], Start, &head, label(Omega).strong());
            pen.note([x, y + 20.0], Start, tail);
        }
    });
    let columns = "time (days) | angle about the axis of figure (°)";
    let dots = (0..).map(|k| STEP * f64::from(k));
    let dots = dots.take_while(|day| *day <= days);
    let rows = |rate: f64| {
        let dots = dots.clone();
        dots.map(move |day| [day, (rate * day).to_degrees()])
    };
    Ok(made
        .data("rigid", columns, rows(rigid.rate))
        .data("observed", columns, rows(real.rate)))
}

parameters! {
    FLAT: "flat", "I_3/I_1", "", "moment about the axis over that across it, left body", [1.0, 2.0], 1.7;
    LONG: "long", "I_3/I_1", "", "moment about the axis over that across it, right body", [0.05, 1.0], 0.5;
    LEAN: "lean", r"\Omega_\perp/\Omega_3", "", "angular velocity across the axis over that about it", [0.1, 1.2], 0.56;
}
/// The parameters of the rolling cones.
pub const CONES: &[Parameter] = &[FLAT, LONG, LEAN];

/// Where the two bodies are drawn: left, top, right, bottom.
const PANELS: [[f64; 4]; 2] = [[20.0, 36.0, 288.0, 262.0], [312.0, 36.0, 580.0, 262.0]];
/// Length of the arrows, and where their letters stand, in sides of the cones.
const ARROW: f64 = 1.2;
const LETTER: f64 = 1.31;

/// A flat and a long body: the cone of the axis of rotation in the body rolls on the one in space.
pub fn precession_cones(values: &Values) -> Result<Figure> {
    let omega = BodyVector::new(values.of(&LEAN), 0.0, 1.0);
    let tops = values.each([FLAT, LONG]);
    let tops = tried(tops, |ratio| SymmetricTop::new(1.0, ratio))?;
    let pairs = [
        Pair::new("flat", tops[0], omega, -1.0)?,
        Pair::new("long", tops[1], omega, 1.0)?,
    ];
    let degrees = |angle: f64| number(angle.to_degrees(), 1);
    let round = pairs
        .each_ref()
        .map(|pair| pair.top.shape == Shape::Spherical);
    let claim = match round {
        [false, false] => {
            "A body cone rolls on a space cone: round it if the body is flat, on its outside if it is long."
        }
        [true, false] => {
            "A body cone rolls on a space cone, on its outside if the body is long; of a round body the space cone is a line, and nothing rolls."
        }
        [false, true] => {
            "A body cone rolls on a space cone, round it if the body is flat; of a round body the space cone is a line, and nothing rolls."
        }
        [true, true] => "Of a round body the space cone is a line along L, and nothing rolls.",
    };
    let cones = |pair: &Pair| [pair.cones.body, pair.cones.space].map(degrees);
    let [[wide, narrow], [slim, broad]] = pairs.each_ref().map(cones);
    let [left, right] = pairs.each_ref().map(|pair| brief(pair.top.axial()));
    let lean = brief(omega.x());
    let pair = [
        format!(
            "the wide cone of {wide} degrees about the body's axis surrounds the narrow cone of {narrow} degrees about the vertical angular momentum"
        ),
        format!("two cones, of {slim} and {broad} degrees, stand side by side"),
    ];
    let one = "one cone, about the body's axis, with the vertical angular momentum on its side";
    let [round_it, beside] = [0, 1].map(|k| if round[k] { one } else { &pair[k] });
    let words = words!(
        "{claim}",
        "The cones of a free symmetric top touch along $\\Omega$; the space cone, about $L$, stands still. Half-angles of \
         body cone and space cone: {wide}° and {narrow}° for $I_3/I_1 = {left}$, {slim}° and {broad}° for $I_3/I_1 = {right}$, both with \
         $\\Omega_\\perp/\\Omega_3 = {lean}$.",
        "Cones with a common tip. Left, a body with a moment ratio of {left}: {round_it}. Right, a body with a ratio of {right}: {beside}. \
         Two cones touch along the angular velocity, so one rolls on the other."
    );
    // One scale for both.
    let views =
        [0, 1].map(|k| View::fitted(DIRECTION, &pairs[k].reach(), PANELS[k], f64::INFINITY));
    let scale = views[0].scale().min(views[1].scale());
    let made = figure("precession-cones", 320.0, words, |pen| {
        for (pair, panel) in pairs.iter().zip(PANELS) {
            pair.draw(pen, &View::fitted(DIRECTION, &pair.reach(), panel, scale));
            let middle = 0.5 * (panel[0] + panel[2]);
            let name = match pair.top.shape {
                Shape::Spherical => "round",
                _ => pair.name,
            };
            let ratio = brief(pair.top.axial());
            let name = format!("{name}, *I*_{{3}}/*I*_{{1}} = {ratio}");
            pen.label([middle, 286.0], Middle, &name);
            let [body, space] = cones(pair);
            let body = format!("body cone {body}°");
            pen.note([middle - 8.0, 308.0], End, &body);
            let (role, space) = (AngularMomentum, format!("space cone {space}°"));
            pen.text([middle + 8.0, 308.0], Start, &space, small(role));
        }
    });
    let columns = "I3/I1 (ratio) | body cone (°) | space cone (°) | axis from L (°)";
    let [left, right] = pairs.map(|Pair { top, cones, .. }| {
        let [body, space, lean] = [cones.body, cones.space, cones.nutation].map(f64::to_degrees);
        [[top.axial(), body, space, lean]]
    });
    Ok(made
        .data("left", columns, left)
        .data("right", columns, right))
}

/// The view of the cones: azimuth and elevation.
const DIRECTION: [f64; 2] = [-FRAC_PI_2, 0.3];

/// Both cones of a body.
struct Pair {
    name: &'static str,
    top: SymmetricTop,
    cones: Cones,
    /// Axis of the body, L and Ω, of length one.
    axis: Vector,
    l: Vector,
    omega: Vector,
}

impl Pair {
    /// L upright; Ω on the right of it, the axis beyond L if the body is flat, beyond Ω if it is long.
    fn new(name: &'static str, top: SymmetricTop, omega: BodyVector, side: f64) -> Result<Self> {
        let tilted = |angle: f64| Vector::new(angle.sin(), 0.0, angle.cos());
        let cones = top.cones(omega)?;
        Ok(Self {
            name,
            top,
            axis: tilted(side * cones.nutation),
            l: tilted(0.0),
            omega: tilted(cones.space),
            cones,
        })
    }

    /// The points that must fit into the picture.
    fn reach(&self) -> Vec<Vector> {
        let mut points = rim(&self.axis, self.cones.body);
        points.extend(rim(&self.l, self.cones.space));
        points.extend([self.axis, self.l, self.omega].map(|v| v * LETTER));
        points.push(Vector::zeros());
        points
    }

    fn draw(&self, pen: &mut Pen, view: &View) {
        cone(pen, view, &self.axis, self.cones.body, Ink);
        cone(pen, view, &self.l, self.cones.space, AngularMomentum);
        let tip = view.project(&Vector::zeros());
        let arrows = [
            (self.axis, "*x*_{3}", Ink, SECONDARY),
            (self.l, "*L*", AngularMomentum, DATA),
            (self.omega, "*Ω*", Omega, 2.8),
        ];
        let letters = arrows.map(|(vector, ..)| view.project(&(vector * LETTER)));
        // Arrows side by side have letters side by side.
        let across = spread(letters.map(|at| at[0]), 24.0);
        for ((vector, text, role, width), (x, at)) in
            arrows.into_iter().zip(across.into_iter().zip(letters))
        {
            pen.arrow(tip, view.project(&(vector * ARROW)), stroke(role, width));
            pen.text([x, at[1] + 5.0], Middle, text, label(role));
        }
    }
}

/// The rim of a cone with its tip in the origin.
fn rim(axis: &Vector, half_angle: f64) -> Vec<Vector> {
    let across = Vector::y().cross(axis).normalize();
    let (s, c) = half_angle.sin_cos();
    ellipse(axis * c, across * s, Vector::y() * s, 180)
}

/// A cone with its tip in the origin, seen from outside.
fn cone(pen: &mut Pen, view: &View, axis: &Vector, half_angle: f64, role: Role) {
    let rim = view.trace(&rim(axis, half_angle));
    let mut outline = rim.clone();
    outline.push(view.project(&Vector::zeros()));
    let outline = hull(&outline);
    pen.fill(&outline, role, 0.09);
    pen.outline(&outline, stroke(role, AXIS));
    pen.line(&rim, stroke(role, SECONDARY));
}
