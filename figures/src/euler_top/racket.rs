//! The tennis racket, thrown almost about its middle axis (tutorial 6.3, 6.7): the throw, and what the racket looks like.

use spinning_bodies::euler_top::EulerTop;
use spinning_bodies::frame::{Attitude, BodyVector};

use super::body::top_of;
use crate::prelude::*;

/// Principal moments of a racket, kg m²: about the handle, across the handle in the plane of the strings, across the strings
/// (Ashbaugh, Chicone, Cushman 1991).
pub const MOMENTS: [f64; 3] = [0.00121, 0.01638, 0.01748];

/// Turns per second about the middle axis in the book's throw.
pub const TURNS: f64 = 1.0;

/// A throw and the motion after it. Space axes: x towards the reader, y to the right, z up; L along y.
#[derive(Debug, Clone, Copy)]
pub struct Throw {
    /// The motion.
    pub top: EulerTop,
    /// Angular velocity at the throw, body axes, rad/s.
    pub omega: BodyVector,
}

impl Throw {
    /// An upright throw with these turns per second about the middle axis and this angle between it and L, radians.
    pub fn off(moments: [f64; 3], turns: f64, tilt: f64) -> Result<Self> {
        let twist = moments[1] / moments[0] * TAU * turns * tilt.tan();
        Self::new(moments, turns, twist)
    }

    /// Upright, so many turns a second about the middle axis and `twist` rad/s about the handle.
    fn new(moments: [f64; 3], turns: f64, twist: f64) -> Result<Self> {
        let omega = BodyVector::new(twist, TAU * turns, 0.0);
        // x₁ up, x₂ to the right, x₃ away from the reader; then L exactly to the right.
        let upright = Attitude::from_quaternion(1.0, 0.0, -1.0, 0.0)?;
        let lean = (moments[0] * twist).atan2(moments[1] * omega.y());
        let straight = Attitude::about_axis(BodyVector::new(0.0, 0.0, 1.0), lean)?;
        let start = (upright.quaternion() * straight.quaternion()).into_inner();
        let start = Attitude::from_quaternion(start.w, start.i, start.j, start.k)?;
        let top = top_of(moments, omega, start)?;
        Ok(Self { top, omega })
    }

    /// The throw after which half a period of Ω is one somersault and half a twist: the handle comes back to the hand,
    /// the face is reversed.
    pub fn aimed() -> Result<Self> {
        // Less twist at the throw, a later flip, a somersault too far.
        let thrown = |twist| Self::new(MOMENTS, TURNS, twist);
        let past = |twist| Ok(thrown(twist)?.overshoot()? > 0.0);
        thrown(border([0.5, 3.0], past)?)
    }

    /// Time from one side of the flip to the other, s.
    pub fn flip_time(&self) -> f64 {
        0.5 * self.top.period()
    }

    /// How far past the upright the handle is after half a period, radians in −π…π.
    fn overshoot(&self) -> Result<f64> {
        let handle = turned(&self.top.at(self.flip_time())?.attitude, Vector::x());
        Ok(handle.x.atan2(handle.z))
    }

    /// Somersaults of the handle in that time. L is next to the middle axis, on the side of the handle, which goes round it.
    pub fn somersaults(&self) -> f64 {
        self.top.mean_precession_rate() * self.flip_time() / TAU
    }
}

/// The view of all rackets: a little from above and from the right.
pub fn view(center: Point, scale: f64) -> View {
    View::new(0.3, 0.26, center, scale)
}

/// Balance point to butt, and to the tip of the head, metres.
pub const BUTT: f64 = 0.325;
const TIP: f64 = 0.36;
/// Half axes of the head, outside and inside of the frame.
const HEAD: [f64; 2] = [0.170, 0.132];
/// Centre of the head.
const MIDDLE: f64 = TIP - HEAD[0];
/// Where the throat ends and the grip begins.
const FORK: f64 = -0.06;
const GRIP: f64 = -0.13;
/// Half distance of the places where the throat leaves the head.
const SHOULDER: f64 = 0.075;
const STRINGS: usize = 5;

/// A line in the plane of the strings: points (along the handle, across it), metres.
pub type Flat = Vec<[f64; 2]>;

/// The parts of the racket, flat.
#[derive(Debug, Clone)]
pub struct Parts {
    /// The head's frame, closed.
    pub head: Flat,
    /// Both sides of the throat.
    pub throat: [Flat; 2],
    /// The grip.
    pub grip: Flat,
    /// The strings.
    pub strings: Vec<Flat>,
    /// The mark on the rim, on the side of x₂.
    pub mark: [f64; 2],
}

/// The racket.
pub fn parts() -> Parts {
    let [a, b] = HEAD;
    let head = (0..72).map(|k| (TAU * f64::from(k) / 72.0).sin_cos());
    let head = head.map(|(s, c)| [MIDDLE + a * c, b * s]).collect();
    // Where the throat leaves the head.
    let leave = MIDDLE - a * (1.0 - (SHOULDER / b).powi(2)).sqrt();
    let throat = [[leave, SHOULDER], [FORK, 0.008], [GRIP, 0.008]];
    let throat = [1.0, -1.0].map(|side| throat.map(|[x, y]| [x, side * y]).into());
    let mut strings = Vec::new();
    for k in 1..=STRINGS {
        let u = 2.0 * k as f64 / (STRINGS + 1) as f64 - 1.0;
        let half = (1.0 - u * u).sqrt();
        let across = [-half, half].map(|end| [MIDDLE + a * end, b * u]);
        let along = [-half, half].map(|end| [MIDDLE + a * u, b * end]);
        strings.extend([across.into(), along.into()]);
    }
    Parts {
        head,
        throat,
        grip: vec![[GRIP, 0.0], [-BUTT, 0.0]],
        strings,
        mark: [MIDDLE, b],
    }
}

/// Which face the reader sees.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Face {
    /// The face that is towards the reader at the throw: bare strings.
    Front,
    /// The other one: filled.
    Back,
}

/// The face that is seen.
pub fn face(attitude: &Attitude, view: &View) -> Face {
    match view.faces(&turned(attitude, Vector::z())) {
        true => Face::Back,
        false => Face::Front,
    }
}

/// Draws the racket as it stands.
pub fn draw(pen: &mut Pen, view: &View, attitude: &Attitude, strength: f64) {
    let parts = parts();
    let at = |&[x, y]: &[f64; 2]| view.project(&turned(attitude, Vector::new(x, y, 0.0)));
    let trace = |line: &Flat| line.iter().map(at).collect::<Vec<_>>();
    let style = |width: f64| -> Stroke { inked(width).alpha(strength) };
    let head = trace(&parts.head);
    if face(attitude, view) == Face::Back {
        pen.fill(&head, Ink, 0.55 * strength);
    }
    pen.lines(parts.strings.iter().map(trace), style(HAIR));
    pen.lines(parts.throat.iter().map(trace), style(SECONDARY));
    pen.outline(&head, style(DATA));
    pen.line(trace(&parts.grip), style(5.0));
    pen.disc(at(&parts.mark), 4.0, Ink, strength);
}
