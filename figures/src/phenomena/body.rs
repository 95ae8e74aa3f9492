//! A cat of round pieces: two halves, head, legs, tail; nearer pieces hide those behind them.

use spinning_bodies::frame::Attitude;
use spinning_bodies::phenomena::{Cat, EqualHalves, Half};
use spinning_bodies::scene::effects::{Pace, Turnover};
use spinning_bodies::scene::shape::{self, CatState};
use spinning_bodies::scene::{Request, Scene};

use crate::prelude::*;

/// I/J of a half.
pub const RATIO: f64 = 4.0;
/// Bend forward, radians.
pub const FORWARD: f64 = FRAC_PI_2;
/// Duration of a turnover, s.
pub const DURATION: f64 = 0.3;

/// A cat of 3 kg in two halves.
pub fn cat() -> Result<Cat> {
    let half = Half {
        mass: 1.5,
        axial: 0.0025,
        transverse: 0.0025 * RATIO,
        to_joint: 0.11,
    };
    Cat::new([half, half])
}

/// The bend backward, radians, that makes a turnover half a turn.
pub fn back() -> Result<f64> {
    let equal = EqualHalves::new(1.0, RATIO)?;
    Ok(equal.back_bend_for_half_turn(FORWARD)?.unwrap_or(f64::NAN))
}

/// States of a cat released on its back, at these fractions of the turnover.
pub fn turnover(fractions: &[f64]) -> Result<Vec<CatState>> {
    let change = Turnover {
        forward: FORWARD,
        back: back()?,
        duration: DURATION,
        pace: Pace::Even,
    };
    let scene = shape::Cat::new(cat()?, shape::Cat::on_its_back()).with(change)?;
    let times: Vec<f64> = fractions.iter().map(|u| u * DURATION).collect();
    let motion = scene.simulate(&Request::at(times)?)?;
    Ok(motion.rows.into_iter().map(|(_, state)| state).collect())
}

/// A piece: what it covers, and lines on its surface.
pub struct Piece {
    depth: f64,
    /// Its outline.
    pub outline: Vec<Point>,
    /// Lines that shade it.
    pub hatch: Vec<Vec<Point>>,
    /// Whether it is a dark spot: an eye, a nose.
    pub dark: bool,
}

/// The pieces of a cat seen like this, the farthest first.
pub fn pieces(cat: &Cat, state: &CatState, view: &View) -> Vec<Piece> {
    let mut drawing = Drawing {
        view,
        pieces: Vec::new(),
    };
    let first = &state.attitude;
    let relative = state.bend.relative();
    let turn = |v: Vector| crate::solid::turned(first, v);
    // Axes of each half: outward along its spine, towards the belly, to one side.
    let second = |v: Vector| turn(relative.quaternion() * v);
    let joint = turn(cat.places(&state.bend)[0].components());
    let front = [-Vector::x(), Vector::y(), Vector::z()].map(turn);
    let rear = [Vector::x(), Vector::y(), Vector::z()].map(second);
    drawing.half(joint, &front, 0.056);
    drawing.half(joint, &rear, 0.062);
    let at = |axes: &[Vector; 3], out: f64, belly: f64, side: f64| {
        joint + axes[0] * out + axes[1] * belly + axes[2] * side
    };
    // Toes of the front point ahead, and those of the rear as well.
    for (axes, out, lean, toes) in [(&front, 0.165, 0.02, 0.012), (&rear, 0.175, 0.01, -0.012)] {
        for side in [-0.034, 0.034] {
            let hip = at(axes, out, 0.03, side);
            let paw = at(axes, out + lean, 0.15, 1.15 * side);
            drawing.round([hip, paw], [0.022, 0.013], 0);
            let toe = paw + axes[0] * toes;
            drawing.round([paw, toe], [0.015, 0.013], 0);
        }
    }
    let head = at(&front, 0.275, -0.02, 0.0);
    drawing.round([head, head], [0.052, 0.052], 0);
    for side in [-1.0, 1.0] {
        let root = at(&front, 0.272, -0.052, 0.03 * side);
        let tip = at(&front, 0.262, -0.096, 0.04 * side);
        drawing.round([root, tip], [0.017, 0.004], 0);
        drawing.spot(head, at(&front, 0.32, -0.034, 0.02 * side), 0.0065);
    }
    drawing.spot(head, at(&front, 0.3265, -0.012, 0.0), 0.0075);
    // The tail rises in the plane of the rear half.
    let tail = |u: f64| {
        let up = -0.03 - 0.15 * (1.0 - u.cos());
        at(&rear, 0.225 + 0.12 * u.sin(), up, 0.02 * (2.0 * u).sin())
    };
    for k in 0..9 {
        let u = |k: u8| 1.7 * f64::from(k) / 9.0;
        drawing.round([tail(u(k)), tail(u(k + 1))], [0.0125, 0.0125], 0);
    }
    let mut pieces = drawing.pieces;
    pieces.sort_by(|a, b| a.depth.total_cmp(&b.depth));
    pieces
}

/// A circle as a polygon with enough corners to look round.
pub fn circle(center: Point, radius: f64) -> Vec<Point> {
    let corners = (4.5 * radius.sqrt()).clamp(8.0, 48.0) as u32;
    let angle = |k: u32| TAU * f64::from(k) / f64::from(corners);
    (0..corners)
        .map(|k| polar(center, radius, angle(k)))
        .collect()
}

struct Drawing<'a> {
    view: &'a View,
    pieces: Vec<Piece>,
}

impl Drawing<'_> {
    fn half(&mut self, joint: Vector, axes: &[Vector; 3], radius: f64) {
        self.round([joint, joint + axes[0] * 0.2], [0.046, radius], 9);
    }

    /// Two balls and what lies between them, with `rings` lines around it on the side away from the light.
    fn round(&mut self, ends: [Vector; 2], radii: [f64; 2], rings: u32) {
        let mut points = Vec::new();
        for (end, radius) in ends.iter().zip(radii) {
            points.extend(circle(self.view.project(end), radius * self.view.scale()));
        }
        let axis = ends[1] - ends[0];
        let mut hatch = Vec::new();
        if rings > 0 {
            let along = axis.normalize();
            let across = along.cross(&self.view.toward).try_normalize(1e-9);
            let u = across.unwrap_or(Vector::z());
            let v = along.cross(&u);
            let light = Vector::new(0.25, -0.45, 0.85).normalize();
            for ring in 0..rings {
                let part = (f64::from(ring) + 0.5) / f64::from(rings);
                let center = ends[0] + axis * part;
                let radius = radii[0] + (radii[1] - radii[0]) * part;
                // Every second ring is drawn only in the deeper shade.
                let limit = if ring % 2 == 0 { 0.25 } else { -0.12 };
                let dark = |n: &Vector| self.view.faces(n) && n.dot(&light) < limit;
                let place = |n: &Vector| self.view.project(&(center + n * radius));
                let around = ellipse(Vector::zeros(), u, v, 36);
                let lines = around.split(|n| !dark(n)).filter(|line| line.len() > 1);
                hatch.extend(lines.map(|line| line.iter().map(place).collect::<Vec<_>>()));
            }
        }
        let near = |k: usize| ends[k].dot(&self.view.toward) + 0.3 * radii[k];
        self.pieces.push(Piece {
            depth: 0.5 * (near(0) + near(1)),
            outline: hull(&points),
            hatch,
            dark: false,
        });
    }

    /// A dark spot on the head, if it is on the near side.
    fn spot(&mut self, head: Vector, place: Vector, radius: f64) {
        let out = place - head;
        if out.dot(&self.view.toward) > 0.1 * out.norm() {
            self.pieces.push(Piece {
                depth: head.dot(&self.view.toward) + 0.06,
                outline: circle(self.view.project(&place), radius * self.view.scale()),
                hatch: Vec::new(),
                dark: true,
            });
        }
    }
}

/// Draws the pieces.
pub fn draw(pen: &mut Pen, pieces: &[Piece]) {
    for piece in pieces {
        if piece.dark {
            pen.fill(&piece.outline, Ink, 1.0);
            continue;
        }
        pen.fill(&piece.outline, Paper, 1.0);
        pen.lines(&piece.hatch, inked(HAIR).alpha(0.75));
        pen.outline(&piece.outline, inked(AXIS + 0.3));
    }
}

/// How far the cat has turned from lying on its back, radians: the angle between the attitudes of its front half.
pub fn turned(state: &CatState) -> f64 {
    let start = shape::Cat::on_its_back();
    Attitude::angle_to(&state.attitude, &start)
}
