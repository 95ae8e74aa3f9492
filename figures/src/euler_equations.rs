//! Euler's equations as a flow on a sphere (tutorial 5.1), and the map of all tops (5.3).

mod triangle;

use spinning_bodies::euler_equations::{
    AxisMoments, Equilibrium, Nature, equilibria, fastest_flow, separatrix_slope, streamline,
};
use spinning_bodies::frame::BodyVector;
use spinning_bodies::inertia::PrincipalMoments;

use crate::prelude::*;

/// The figures of the chapter, in its order.
pub const FIGURES: &[Entry] = &[
    of("momentum-flow", FLOW, momentum_flow),
    of("triangle-of-tops", triangle::TRIANGLE, triangle::tops),
];

parameters! {
    FIRST: "first", "I_1", "kg m²", "first moment of inertia", [1.0, 2.0], 1.0;
    SECOND: "second", "I_2", "kg m²", "second moment of inertia", [2.0, 2.9], 2.0;
    THIRD: "third", "I_3", "kg m²", "third moment of inertia", [2.0, 3.0], 3.0;
}
/// The parameters: the moments.
pub const FLOW: &[Parameter] = &[FIRST, SECOND, THIRD];

/// Opacity of curves on the far side of the sphere.
const BEHIND: f64 = 0.22;
/// Steps of integration between two dots.
const STEPS: usize = 16;

/// One closed line of the flow, and the points it passes at equal times.
struct Orbit {
    curve: Vec<Vector>,
    /// Index in `curve` of the point at time zero; the dots are a multiple of [`STEPS`] away from it.
    zero: usize,
}

impl Orbit {
    /// From `start` both ways, until half of the way round `axis` is done, up to a saddle on it, or for `most` ticks (s).
    fn new(
        moments: &AxisMoments,
        start: BodyVector,
        axis: usize,
        (tick, most): (f64, usize),
    ) -> Result<Self> {
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let half = |step: f64| -> Result<Vec<Vector>> {
            let points = streamline(moments, start, step, most * STEPS)?;
            let angle = |p: &BodyVector| p.components()[k].atan2(p.components()[j]);
            let (mut swept, mut last) = (0.0, angle(&points[0]));
            let mut path = Vec::new();
            for point in &points {
                let now = angle(point);
                swept += (now - last + PI).rem_euclid(2.0 * PI) - PI;
                last = now;
                path.push(Vector::from(point.components()));
                // A thousandth from its axis it has come to a saddle; what rounding does from there on is no flow.
                if swept.abs() > PI || point.components()[axis].abs() > 1.0 - 5e-7 {
                    break;
                }
            }
            Ok(path)
        };
        let step = tick / STEPS as f64;
        let (ahead, back) = (half(step)?, half(-step)?);
        let zero = back.len() - 1;
        let mut curve: Vec<_> = back.into_iter().rev().collect();
        curve.extend(ahead.into_iter().skip(1));
        Ok(Self { curve, zero })
    }

    fn draw(&self, pen: &mut Pen, view: &View, width: f64) {
        let [seen, hidden] = view.halves(&self.curve);
        pen.lines(hidden, stroke(AngularMomentum, 0.8 * width).alpha(BEHIND));
        pen.lines(seen, stroke(AngularMomentum, width));
    }

    fn draw_dots(&self, pen: &mut Pen, view: &View, radius: f64, saddle: usize) {
        let dots = self.curve[self.zero % STEPS..].iter().step_by(STEPS);
        // At the rim and at the saddle the dots would overlap.
        for dot in dots.filter(|p| p.dot(&view.toward) > 0.1 && p[saddle].abs() < 0.99) {
            pen.disc(view.project(dot), radius, AngularMomentum, 1.0);
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
        let (Some(from), Some(to)) = (self.curve.get(at), self.curve.get(at + 1)) else {
            return;
        };
        let (from, to) = (view.project(from), view.project(to));
        let length = distance(to, from);
        let style = stroke(AngularMomentum, width);
        pen.arrow(between(to, from, 9.0 / length), to, style);
    }
}

/// A point of the unit sphere, `degrees` away from `axis` towards `other`.
fn off_axis(axis: usize, other: usize, sign: f64, degrees: f64) -> BodyVector {
    let mut p = [0.0; 3];
    let (s, c) = degrees.to_radians().sin_cos();
    (p[axis], p[other]) = (sign * c, s);
    BodyVector::new(p[0], p[1], p[2])
}

/// The flow of L on its sphere.
pub fn momentum_flow(values: &Values) -> Result<Figure> {
    let of = [0, 1, 2].map(|k| values.of(&FLOW[k]));
    let moments = AxisMoments::new(of[0], of[1], of[2])?;
    let sorted = PrincipalMoments::new(of[0], of[1], of[2])?;
    let still = equilibria(&moments);
    let mut order = [0, 1, 2];
    order.sort_by(|j, k| of[*j].total_cmp(&of[*k]));
    let [small, middle, large] = order;
    let is = |axis: usize, nature: Nature| still[2 * axis].nature == nature;
    let parted = is(middle, Nature::Saddle);
    let fastest = fastest_flow(&sorted);
    // A slow flow gets as many dots as a fast one, and a saddle that is left slowly not too many.
    let growth = still[2 * middle].growth_squared.max(0.0).sqrt();
    let pace = match parted {
        true => 1.075 * (fastest * growth.max(0.05 * fastest)).sqrt(),
        false => fastest,
    };
    let tick = match pace > 0.0 {
        true => (0.8 / (3.0 * pace) * 10.0).round() / 10.0,
        false => 1.0,
    };

    // Started where they are nearest to the saddle, in front: the odd gap between the last dots lies behind.
    let mut orbits = Vec::new();
    for (axis, circles) in [
        (small, &[14.0, 32.0, 51.0, 71.0][..]),
        (large, &[20.0, 44.0, 70.0]),
    ] {
        for sign in [1.0, -1.0] {
            for &degrees in circles.iter().filter(|_| is(axis, Nature::Center)) {
                let start = off_axis(axis, middle, sign, degrees);
                orbits.push(Orbit::new(&moments, start, axis, (tick, 400))?);
            }
        }
    }
    let slope = separatrix_slope(&sorted);
    let mut border = Vec::new();
    for side in [1.0, -1.0].into_iter().filter(|_| parted) {
        let tilt = side * slope.atan().to_degrees();
        for sign in [1.0, -1.0] {
            let start = off_axis(small, large, sign, tilt);
            border.push(Orbit::new(&moments, start, middle, (tick, 120))?);
        }
    }

    let claim = match orbits.len() {
        0 => "With three equal moments the angular momentum stays where it is in the body.".to_owned(),
        _ if parted => {
            "Without torque the angular momentum flows on a sphere, round four centres and past two saddles.".to_owned()
        }
        _ => {
            let other = if is(small, Nature::Center) { small } else { large };
            let name = ["first", "second", "third"][other];
            format!("With two equal moments the angular momentum runs round the {name} axis in circles, and rests at their two centres and half-way between them.")
        }
    };
    let named = |axis: usize| format!("x_{}", axis + 1);
    let saddles = format!(
        "Centres about $\\pm {}$ and $\\pm {}$, saddles at $\\pm {}$, from which $L$ departs at first as \
         $e^{{{}\\,t}}$. The heavy lines are two great circles, $L_{}=\\pm{}L_{}$. The flow is fastest, {fastest:.4} per second, halfway between ${}$ and ${}$.",
        named(small),
        named(large),
        named(middle),
        number(growth, 4),
        large + 1,
        number(slope, 4),
        small + 1,
        named(small),
        named(large),
    );
    let [rest, seen] = match orbits.len() {
        0 => [".", "No curve is on it."].map(str::to_owned),
        _ if parted => [
            format!("; a dot every {tick} s. {saddles}"),
            format!(
                "Closed curves circle the axis of the smallest moment and the axis of the largest one. At the axis of the middle moment two heavy great circles cross, \
                 inwards along one, outwards along the other; they divide the sphere into four parts. Dots stand {tick} s apart."
            ),
        ],
        _ => [
            format!(
                "; a dot every {tick} s. Nothing departs from the equator of the equal axes. The flow is nowhere faster than {fastest:.4} per second."
            ),
            format!(
                "Circles go round the axis whose moment differs from the other two. Dots stand {tick} s apart."
            ),
        ],
    };
    let [i1, i2, i3] = of.map(brief);
    let words = words!(
        "{claim}",
        "The sphere $\\lvert L\\rvert=1$ seen from a body with $I_1={i1}$, $I_2={i2}$, $I_3={i3}${rest}",
        "A sphere with the three principal axes of a body sticking out, moments {i1}, {i2} and {i3}. {seen}"
    );

    let center = [300.0, 214.0];
    let view = View::new(1.08, 0.44, center, RADIUS);
    let made = figure("momentum-flow", 424.0, words, |pen| {
        pen.disc(center, RADIUS, Shade, 1.0);
        for orbit in &orbits {
            orbit.draw(pen, &view, SECONDARY);
        }
        for line in &border {
            line.draw(pen, &view, 3.2);
        }
        pen.ring(center, RADIUS, inked(AXIS));
        for orbit in &orbits {
            orbit.draw_dots(pen, &view, 2.6, middle);
            orbit.draw_sense(pen, &view, DATA);
        }
        for line in &border {
            line.draw_dots(pen, &view, 3.3, middle);
            line.draw_sense(pen, &view, 2.8);
        }
        axes(pen, &view);
        for Equilibrium { direction, .. } in still {
            let p = Vector::from(direction.components());
            let alpha = if view.faces(&p) { 1.0 } else { BEHIND };
            pen.disc(view.project(&p), 5.0, Ink, alpha);
        }
        for (axis, at, anchor) in [
            (0, [66.0, 276.0], Middle),
            (1, [452.0, 350.0], Start),
            (2, [290.0, 22.0], End),
        ] {
            let shares = of.iter().filter(|moment| **moment == of[axis]).count();
            let size = match shares {
                1 if axis == small => "smallest moment:",
                1 if axis == large => "largest moment:",
                1 => "middle moment:",
                _ => "equal moments:",
            };
            let nature = match still[2 * axis].nature {
                Nature::Center => "a centre",
                Nature::Saddle => "a saddle",
                Nature::Degenerate => "at rest",
            };
            pen.label(at, anchor, &format!("*x*_{{{}}}", axis + 1));
            if axis == 2 {
                let text = format!("{size} {nature}");
                pen.label(shifted(at, [20.0, 0.0]), Start, &text);
                continue;
            }
            // Below each other, next to the sphere in short lines.
            let lines: Vec<&str> = match axis {
                0 => size.split(' ').chain([nature]).collect(),
                _ => vec![size, nature],
            };
            for (text, k) in lines.into_iter().zip(1_u8..) {
                let below = 3.0 + 19.0 * f64::from(k);
                pen.label(shifted(at, [0.0, below]), anchor, text);
            }
        }
        // Named where it leaves the picture's half of the sphere at the upper left.
        let seen = border.iter().flat_map(|line| &line.curve);
        let seen = seen.filter(|p| view.faces(p)).map(|p| view.project(p));
        let corner = seen.min_by(|a, b| (a[0] + a[1]).total_cmp(&(b[0] + b[1])));
        if let Some([x, y]) = corner {
            let places = [-11.0, -18.0, -25.0, -32.0].map(|up| [x - 46.0, y + up]);
            pen.name(places, "separatrix", label(AngularMomentum));
        }
    });
    let columns = "time (s) | L1 | L2 | L3";
    let lines = orbits.iter().map(|line| ("orbit", line));
    let lines = lines.chain(border.iter().map(|line| ("separatrix", line)));
    Ok(lines.enumerate().fold(made, |made, (n, (name, line))| {
        let table = line.curve.iter().enumerate().map(|(k, p)| {
            let time = (k as f64 - line.zero as f64) * tick / STEPS as f64;
            [time, p.x, p.y, p.z]
        });
        made.data(format!("{name} {}", n + 1), columns, table)
    }))
}

/// Radius of the sphere, units.
const RADIUS: f64 = 178.0;

/// The axes outside the sphere; faint and dotted where they are behind it.
fn axes(pen: &mut Pen, view: &View) {
    let sphere = Vector::new(1.0, 1.0, 1.0);
    for axis in 0..3 {
        for sign in [1.0, -1.0] {
            let mut p = Vector::zeros();
            p[axis] = sign;
            let line = segment(p, p * [1.3, 1.8, 1.26][axis], 80);
            let [seen, hidden] = view.split(&line, |p| !ellipsoid_hides(&sphere, p, &view.toward));
            pen.lines(seen, inked(SECONDARY));
            pen.lines(hidden, inked(AXIS).alpha(BEHIND).dotted());
        }
    }
}
