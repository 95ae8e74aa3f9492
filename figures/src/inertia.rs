//! The ellipsoid of inertia (tutorial 2.4) and the cube quiz (2.6).

use spinning_bodies::frame::BodyVector;
use spinning_bodies::inertia::{InertiaMatrix, PlatonicSolid, ellipsoid_of_inertia, shapes};

use crate::prelude::*;
use leaning::{LONG, MIDDLE, SHORT};

mod leaning;

/// The figures of the chapter, in its order.
pub const FIGURES: &[Entry] = &[
    of("cube-quiz", &[], quiz),
    of("leaning", &leaning::LEANING, leaning::leaning),
    of(
        "ellipsoid-of-inertia",
        &[LONG, MIDDLE, SHORT, MASS],
        ellipsoid,
    ),
    of("cube-rosettes", &[], rosettes),
];

parameters! {
    MASS: "mass", "M", "kg", "mass of the box", [0.5, 10.0], 3.0;
}

/// A box inside its ellipsoid of inertia, with the principal axes and moments.
pub fn ellipsoid(values: &Values) -> Result<Figure> {
    let mass = values.of(&MASS);
    let edges = values.each([LONG, MIDDLE, SHORT]);
    let body = shapes::cuboid(mass, edges)?;
    let principal = body.inertia().principal_axes();
    let moments = principal.moments;
    let semi = ellipsoid_of_inertia(mass, &principal.principal_moments())?;
    let half = Vector::from(edges) / 2.0;

    let (heavy, times) = (brief(mass), number(semi[0] / half[0], 3));
    let [a, b, c] = briefs(edges);
    let [p, q, r] = numbers(semi, 3);
    let [i1, i2, i3] = moments.map(|moment| short(moment, 2));
    let which = match moments[0] < moments[1] * (1.0 - 1e-9) {
        true => "the long axis has the small moment",
        false => "the short axis has the large moment",
    };
    let words = words!(
        "As far as spinning goes, this box is its ellipsoid of inertia.",
        "A box of {heavy} kg with edges of {a}, {b} and {c} m, and the homogeneous ellipsoid of the same mass and \
         the same inertia: semi-axes {p}, {q} and {r} m, each the half edge times {times}. Both have the principal moments \
         $I_1 = {i1}$, $I_2 = {i2}$, $I_3 = {i3}$ kg m²; {which}.",
        "A rectangular box seen from above a corner. A shaded ellipsoid with the same centre and axes bulges out of \
         every face, while the eight corners stick out of the ellipsoid. Three principal axes leave the tips, \
         labelled with the moments {i1}, {i2} and {i3}: smallest along the longest edge, largest along the shortest."
    );

    let semi = Vector::from(semi);
    // As large as the tips of the axes allow; all axes project from it by the same length on the page.
    let reach = [1.2, 1.5, 1.5];
    let whole = View::new(-0.9, 0.46, [0.0, 0.0], 1.0);
    let scale = (0..3).map(|k| {
        let [x, y] = whole.project(&Vector::ith(k, 1.0));
        let room = (198.0 / x.abs()).min(176.0 / y.abs());
        (room - 54.0 * reach[k]) / semi[k]
    });
    let scale = scale.fold(54.0, f64::min);
    let reach = reach.map(|far| far * 54.0 / scale);
    let view = View::new(-0.9, 0.46, [300.0, 190.0], scale);
    let made = figure("ellipsoid-of-inertia", 382.0, words, |pen| {
        box_with_bulges(pen, &view, &half, &semi);
        let names = [0, 1, 2].map(|k| format!("*I*_{{{}}} = {}", k + 1, short(moments[k], 2)));
        let texts = [
            ([10.0, 5.0], Start),
            ([-8.0, 14.0], End),
            ([0.0, -9.0], Middle),
        ];
        for k in 0..3 {
            let along = |t: f64| Vector::ith(k, t);
            let line = segment(along(-semi[k] - reach[k]), along(semi[k] + reach[k]), 400);
            let visible = |p: &Vector| {
                !box_hides(&half, p, &view.toward) && !ellipsoid_hides(&semi, p, &view.toward)
            };
            let [seen, hidden] = view.split(&line, visible);
            pen.lines(seen, inked(SECONDARY));
            pen.lines(hidden, inked(AXIS).alpha(HIDDEN).dotted());
            // The middle axis is named at its near end.
            let side = if k == 1 { -1.0 } else { 1.0 };
            let tip = view.project(&along(side * (semi[k] + reach[k])));
            let (beside, anchor) = texts[k];
            pen.label(shifted(tip, beside), anchor, &names[k]);
        }
    });
    let rows = |k: usize| [edges[k], semi[k], moments[k]];
    let columns = "edge (m) | semi-axis (m) | moment (kg m²)";
    Ok((0..3).fold(made, |made, k| {
        made.data(format!("axis {}", k + 1), columns, [rows(k)])
    }))
}

/// The body that is the union of a box and an ellipsoid with the same axes.
fn box_with_bulges(pen: &mut Pen, view: &View, half: &Vector, semi: &Vector) {
    // The semi-axes of a body along the k-th axis and the two that follow it.
    let axes = |of: &Vector, k: usize| [k, (k + 1) % 3, (k + 2) % 3].map(|j| Vector::ith(j, of[j]));
    let cap = |pen: &mut Pen, k: usize, side: f64| {
        let [n, u, v] = axes(semi, k);
        let n = n * view.toward[k].signum() * side;
        let rim = (half[k] / semi[k]).acos();
        let cap = spaced([0.0, rim], 40).flat_map(|angle| {
            let (s, c) = angle.sin_cos();
            view.trace(&ellipse(n * c, u * s, v * s, 180))
        });
        pen.fill(hull(&cap.collect::<Vec<_>>()), Shade, 1.0);
    };
    // The caps behind, the three faces towards the eye, and the caps on them.
    for k in 0..3 {
        cap(pen, k, -1.0);
    }
    for (k, alpha) in [(2, 0.05), (0, 0.1), (1, 0.17)] {
        let [n, u, v] = axes(half, k);
        let middle = n * view.toward[k].signum();
        let corners = [u + v, u - v, -u - v, v - u].map(|corner| middle + corner);
        pen.fill(view.trace(&corners), Paper, 1.0);
        pen.fill(view.trace(&corners), Ink, alpha);
    }
    for k in [1, 0, 2] {
        cap(pen, k, 1.0);
    }

    let mut curves: Vec<(Vec<Vector>, f64)> = Vec::new();
    for k in 0..3 {
        let [a, u, v] = axes(half, k);
        for b in [u + v, u - v, -u - v, v - u] {
            curves.push((segment(b - a, b + a, 240), SECONDARY));
        }
        // The curves in which the ellipsoid crosses the faces.
        let sine = (1.0 - (half[k] / semi[k]).powi(2)).sqrt();
        let [_, u, v] = axes(semi, k).map(|axis| axis * sine);
        for middle in [a, -a] {
            curves.push((ellipse(middle, u, v, 240), AXIS));
        }
    }
    // The outline: where the surface is seen edge on.
    curves.push((rim(semi, &view.toward, 360), SECONDARY));
    for (curve, width) in curves {
        let [seen, hidden] = view.split(&curve, |p| {
            !box_hides(half, p, &view.toward) && !ellipsoid_hides(semi, p, &view.toward)
        });
        // Rims at the back are not drawn, because they would only confuse.
        let hidden = if width == AXIS { Vec::new() } else { hidden };
        pen.lines(hidden, inked(HAIR).alpha(HIDDEN));
        pen.lines(seen, inked(width));
    }
}

/// Units of the design for a moment of one.
const MOMENT_SCALE: f64 = 426.0;
/// Units of the design for an edge of the cube.
const BODY_SCALE: f64 = 48.0;

/// The moment about every axis of a plane, for a cube and for a brick, and the five regular solids below. The seven bodies are given, so the figure has no parameters.
pub fn rosettes(_: &Values) -> Result<Figure> {
    let cube = shapes::cuboid(1.0, [1.0, 1.0, 1.0])?.inertia();
    let brick = shapes::cuboid(1.0, [1.0, 1.0, 2.0])?.inertia();
    let cube = Rosette::new(&cube, [1.0, 1.0, 1.0])?;
    let brick = Rosette::new(&brick, [1.0, 1.0, 2.0])?;
    let five = tried(PlatonicSolid::ALL, |solid| {
        let inertia = shapes::platonic(solid, 1.0, 1.0)?.inertia();
        Ok((solid, inertia.moment_about(BodyVector::new(1.0, 2.0, 3.0))?))
    })?;

    let [face, vertex, edge] = cube.quiz.map(|(_, moment)| number(moment, 4));
    let [up, slant, side] = brick.quiz.map(|(_, moment)| number(moment, 4));
    let words = words!(
        "A cube has the same moment of inertia about every axis through its centre, and so has each of the \
         five regular solids.",
        "Distance from the centre: the moment about the axis in that direction. Cube of mass $M$ and edge $a$: {face}, {vertex} and {edge} $Ma^2$, a circle. Brick $a \\times a \
         \\times 2a$ of the same mass: {up}, {slant} and {side} $Ma^2$. Below, $I/Ma^2$ for edge $a$.",
        "Two polar curves on the same scale. Around the cross-section of a cube the curve is a perfect circle, and \
         the axes through a face, an edge and a vertex meet it at equal distances, {face} each. Around a brick \
         twice as long the curve is a peanut, three axes, three distances. Below, the five regular solids, each in \
         a circle, with its one number."
    );

    Ok(figure("cube-rosettes", 412.0, words, |pen| {
        let (left, right) = ([104.0, 128.0], [398.0, 128.0]);
        cube.draw(pen, left);
        brick.draw(pen, right);
        let [up, slant, side] = cube.quiz;
        let at = |center: Point, (angle, moment): (f64, f64), out: f64| {
            polar(center, MOMENT_SCALE * moment + out, angle)
        };
        let put = |pen: &mut Pen, p: Point, anchor, text: &str| {
            pen.note(shifted(p, [0.0, 4.5]), anchor, text);
        };
        put(pen, at(left, up, 12.0), Middle, "face");
        put(pen, at(left, slant, 9.0), Start, "vertex");
        put(pen, at(left, side, 8.0), Start, "edge");
        let [up, slant, side] = brick.quiz;
        let [face, vertex, edge] = brick.quiz.map(|(_, moment)| number(moment, 3));
        put(pen, at(right, up, 34.0), Middle, &format!("face {face}"));
        let text = format!("vertex {vertex}");
        put(pen, at(right, slant, 13.0), Start, &text);
        let inside = shifted(at(right, side, -8.0), [0.0, -6.0]);
        pen.note(inside, End, &format!("edge {edge}"));
        let foot = 234.0;
        let all = format!("cube: {} *Ma*^{{2}}", number(cube.quiz[0].1, 3));
        pen.label([left[0], foot], Middle, &all);
        pen.label([right[0], foot], Middle, "brick: depends on the axis");

        for (k, (solid, moment)) in five.iter().enumerate() {
            let center = [68.0 + 116.0 * k as f64, 318.0];
            pen.ring(center, 46.0, inked(SECONDARY));
            regular_solid(pen, *solid, center, 41.0);
            pen.label([center[0], 390.0], Middle, &number(*moment, 3));
        }
    }))
}

/// The moment about the axes of the plane through a face, an edge and a vertex of a box with square base.
struct Rosette {
    curve: Vec<(f64, f64)>,
    /// Angle and moment of the axes through face, vertex and edge.
    quiz: [(f64, f64); 3],
    /// Half width and half height of the box's cross-section.
    section: Point,
}

impl Rosette {
    fn new(inertia: &InertiaMatrix, edges: [f64; 3]) -> Result<Self> {
        let about = |angle: f64| {
            let (s, c) = angle.sin_cos();
            let across = c * core::f64::consts::FRAC_1_SQRT_2;
            let axis = BodyVector::new(across, across, s);
            Ok((angle, inertia.moment_about(axis)?))
        };
        let section @ [half, up] = [edges[0].hypot(edges[1]) / 2.0, edges[2] / 2.0];
        Ok(Self {
            curve: tried(0..360, |k| about(TAU * f64::from(k) / 360.0))?,
            quiz: [about(FRAC_PI_2)?, about(up.atan2(half))?, about(0.0)?],
            section,
        })
    }

    fn draw(&self, pen: &mut Pen, center: Point) {
        let on = |&(angle, moment): &(f64, f64)| polar(center, MOMENT_SCALE * moment, angle);
        let curve: Vec<Point> = self.curve.iter().map(on).collect();
        pen.fill(&curve, Ink, 0.05);
        let [w, h] = self.section.map(|c| BODY_SCALE * c);
        let corners = boxed(shifted(center, [-w, -h]), shifted(center, [w, h]));
        pen.fill(corners, Ink, 0.12);
        pen.outline(corners, inked(AXIS));
        for (angle, moment) in self.quiz {
            let r = MOMENT_SCALE * moment;
            let rule = [polar(center, -r, angle), polar(center, r, angle)];
            pen.line(rule, inked(AXIS).alpha(0.6));
        }
        pen.outline(&curve, inked(DATA));
        for axis in &self.quiz {
            pen.dot(on(axis), 4.0);
        }
    }
}

/// The three axes of the quiz, without the answer. The figure has no parameters.
pub fn quiz(_: &Values) -> Result<Figure> {
    let cube = PlatonicSolid::Cube;
    let corners = cube.vertices(1.0)?.len();
    let faces = cube.faces().len();
    // Euler: corners and faces are two more than edges.
    let edges = corners + faces - 2;
    let [first, second, third] = [corners, edges, faces].map(|ends| ends / 2);
    let words = words!(
        "An axle can go through two corners of a cube, through two edges or through two faces.",
        "There are {first} axles of the first kind, {second} of the second and {third} of the third, all through the centre. About which is the cube hardest to turn?",
        "Three equal cubes, each on an axle through its centre with a bent arrow round it. The first axle goes through opposite corners, the second through the midpoints of \
         opposite edges, the third through the centres of opposite faces. Nothing tells which cube is hardest to turn."
    );
    Ok(figure("cube-quiz", 236.0, words, |pen| {
        let half = Vector::repeat(0.5);
        let kinds = [
            ("corners", [0.5, -0.5, 0.5]),
            ("edges", [0.5, -0.5, 0.0]),
            ("faces", [0.0, 0.0, 0.5]),
        ];
        for (k, (name, through)) in kinds.into_iter().enumerate() {
            let center = [108.0 + 192.0 * k as f64, 108.0];
            let Some(view) = regular_solid(pen, cube, center, 74.0) else {
                continue;
            };
            let through = Vector::from(through);
            let end = through + through.normalize() * 0.42;
            let line = segment(-end, end, 400);
            let [seen, hidden] = view.split(&line, |p| !box_hides(&half, p, &view.toward));
            pen.lines(hidden, inked(AXIS).dotted());
            pen.lines(seen, inked(DATA));
            // Round the upper end, open towards the back.
            let level = through.cross(&view.toward).normalize();
            let (u, v) = (level * 0.19, through.normalize().cross(&level) * 0.19);
            let rings = ellipse(end - through.normalize() * 0.12, u, v, 60);
            let rings = view.trace(&rings);
            pen.line(&rings[24..], inked(SECONDARY));
            pen.arrow(rings[56], rings[60], inked(SECONDARY));
            let text = format!("through {name}");
            pen.label([center[0], 226.0], Middle, &text);
        }
    }))
}

/// A regular solid that just fits into a circle, faces towards the eye shaded by their slope, and how it is seen.
fn regular_solid(pen: &mut Pen, solid: PlatonicSolid, center: Point, radius: f64) -> Option<View> {
    let vertices = solid.vertices(1.0).ok()?;
    let corners: Vec<Vector> = vertices.into_iter().map(Vector::from).collect();
    let size = corners.iter().map(Vector::norm).fold(0.0, f64::max);
    let (azimuth, elevation) = match solid {
        PlatonicSolid::Icosahedron => (0.3, 0.22),
        _ => (0.42, 0.36),
    };
    let view = View::new(azimuth, elevation, center, radius / size);
    polyhedron(pen, &view, &solid.faces(), |k| corners[k as usize]);
    Some(view)
}
