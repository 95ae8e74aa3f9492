//! Euler's equations as a flow on a sphere (tutorial 5.1), and the map of all tops (5.3).

use core::f64::consts::{FRAC_PI_2, PI};

use nalgebra::Vector3;
use spinning_bodies::Result;
use spinning_bodies::euler_equations::{
    AxisMoments, Equilibrium, equilibria, fastest_flow, separatrix_slope, streamline,
};
use spinning_bodies::euler_top::earth;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::inertia::{MassProperties, PrincipalMoments, shapes};

use crate::Figure;
use crate::solid::{View, ellipsoid_hides, segment};
use crate::style::{
    AXIS, Anchor, DATA, HAIR, Pen, Point, Role, SECONDARY, Words, between, figure, label, number,
    small, stroke,
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

    fn draw(&self, pen: &mut Pen<'_>, view: &View, width: f64) {
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

    fn draw_dots(&self, pen: &mut Pen<'_>, view: &View, radius: f64) {
        let dots = self.curve[self.zero % STEPS..].iter().step_by(STEPS);
        // At the rim and at the saddle they would be a blot.
        for dot in dots.filter(|p| p.dot(&view.toward) > 0.1 && p.y.abs() < 0.99) {
            pen.disc(view.project(dot), radius, Role::AngularMomentum, 1.0);
        }
    }

    /// An arrow's head in the middle of what is seen of it, between two dots.
    fn draw_sense(&self, pen: &mut Pen<'_>, view: &View, width: f64) {
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
                let below = at[1] + 21.0 + 17.0 * k as f64;
                pen.text([at[0], below], anchor, line, small(Role::Ink));
            }
        }
        pen.text(
            [310.0, 22.0],
            Anchor::Start,
            "largest moment: a centre",
            small(Role::Ink),
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
fn axes(pen: &mut Pen<'_>, view: &View) {
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

/// The big triangle: its right angle, the disc, is at `CORNER`; it is `WIDE` wide and `WIDE`/√3 high.
const CORNER: Point = [572.0, 384.0];
const WIDE: f64 = 544.0;

/// Where ordered moments stand on the map.
///
/// In the triangle of all moments with sum 1 the corners are at equal distances; the ordered ones fill this sixth of it.
fn place(moments: [f64; 3], corner: Point, wide: f64) -> Point {
    let [i1, i2, i3] = shares(moments);
    [
        corner[0] - 2.0 * wide * (i2 - i1),
        corner[1] - 2.0 * 3.0_f64.sqrt() * wide * (0.5 - i3),
    ]
}

/// Moments divided by their sum.
fn shares(moments: [f64; 3]) -> [f64; 3] {
    let sum: f64 = moments.iter().sum();
    moments.map(|i| i / sum)
}

/// A racket of 0.3 kg: a frame that is a hoop, strings that are a disc, and a rod for throat and handle. Metres.
fn racket() -> Result<MassProperties> {
    let along = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), FRAC_PI_2)?;
    let handle = shapes::rod(0.15, 0.42)?.turned(&along);
    MassProperties::compose(&[
        shapes::hoop(0.13, 0.13)?,
        shapes::disc(0.02, 0.13)?,
        handle.moved(BodyVector::new(0.0, -0.34, 0.0))?,
    ])
}

/// A molecule of water: three particles, in atomic mass units and ångströms (quoted: 0.9584 Å, 104.45°).
fn water() -> Result<MassProperties> {
    let (s, c) = (0.5 * 104.45_f64).to_radians().sin_cos();
    let bond = |side: f64| BodyVector::new(side * 0.9584 * s, 0.9584 * c, 0.0);
    MassProperties::compose(&[
        MassProperties::particle(15.999, BodyVector::zero())?,
        MassProperties::particle(1.008, bond(1.0))?,
        MassProperties::particle(1.008, bond(-1.0))?,
    ])
}

/// All rigid bodies, as far as spinning goes, in one triangle.
pub fn triangle_of_tops() -> Result<Figure> {
    let of = |body: MassProperties| body.inertia().principal_axes().moments();
    let millimetres = |edges: [f64; 3]| shapes::cuboid(1.0, edges.map(|edge| edge / 1e3)).map(of);
    let book = millimetres([240.0, 165.0, 30.0])?;
    let phone = millimetres([147.0, 72.0, 8.0])?;
    let brick = millimetres([240.0, 115.0, 71.0])?;
    let (racket, water) = (of(racket()?), of(water()?));
    let coin = of(shapes::cylinder(1.0, 0.011_6, 0.002_3)?);
    let (rod, disc) = (of(shapes::rod(1.0, 1.0)?), of(shapes::disc(1.0, 1.0)?));
    let (cube, egg) = (
        of(shapes::cuboid(1.0, [1.0; 3])?),
        of(shapes::ellipsoid(1.0, [0.022, 0.022, 0.029])?),
    );
    let doughnut = of(shapes::torus(1.0, 0.035, 0.015)?);
    let h = earth::DYNAMICAL_ELLIPTICITY;
    let earth = [1.0 - h, 1.0 - h, 1.0];
    // The share of the largest moment goes from a third, the sphere, to a half, the disc.
    let flatness = 6.0 * (shares(earth)[2] - 1.0 / 3.0);
    let listed = |m: [f64; 3]| shares(m).map(|i| number(i, 3)).join(", ");

    let words = Words {
        claim: "Every rigid body that ever spun is a point of this triangle.".to_owned(),
        details: format!(
            "Principal moments $I_1\\le I_2\\le I_3$, divided by their sum. In every order of the axes, the bodies fill the \
             small triangle, whose corners are rods and whose middle is the sphere; the shaded sixth of it is drawn large. Beyond its \
             edges there is nothing. The shares of the book are {}; of the telephone {}; of the racket {}; of the brick {}; of a molecule of \
             water {}. The Earth is {} of the way from the sphere to the disc, under the same dot as the cube.",
            listed(book),
            listed(phone),
            listed(racket),
            listed(brick),
            listed(water),
            number(flatness, 4),
        ),
        alt: "A right triangle, the map of all ordered principal moments. Bottom edge, the laminae: from the rod at the left \
              to the disc at the right, with a racket, a telephone, a molecule of water and almost a book on it, and a coin \
              close to the disc. Right edge, the oblate tops: a doughnut low down, and the sphere on top, where cube and Earth \
              sit. Slanting edge, the prolate tops from the rod to the sphere: the ratios four to four to one and two to two \
              to one, and an egg. A brick lies inside. A small equilateral triangle shows the large one as one of its six \
              mirror images."
            .to_owned(),
    };

    Ok(figure("triangle-of-tops", 438.0, words, |pen| {
        let at = |m: [f64; 3]| place(m, CORNER, WIDE);
        let corners = [at(rod), at(disc), at(cube)];
        pen.fill(&corners, Role::Ink, 0.07);
        pen.outline(&corners, stroke(Role::Ink, DATA));
        inset(pen, [rod, disc, cube]);
        let caption = "in any order of the axes";
        pen.text([112.0, 174.0], Anchor::Middle, caption, small(Role::Muted));
        let (above, below) = ([0.0, -11.0], [0.0, 23.0]);
        let left = [-11.0, 5.0];
        for (name, m, [dx, dy], anchor) in [
            ("racket", racket, below, Anchor::Middle),
            ("phone", phone, below, Anchor::Middle),
            ("water", water, below, Anchor::Middle),
            ("book", book, above, Anchor::Middle),
            ("brick", brick, above, Anchor::Middle),
            ("coin", coin, [-11.0, -1.0], Anchor::End),
            ("doughnut", doughnut, left, Anchor::End),
            ("egg", egg, [-9.0, -7.0], Anchor::End),
            ("cube, Earth", cube, [-12.0, -3.0], Anchor::End),
        ] {
            let [x, y] = at(m);
            pen.disc([x, y], 4.4, Role::Ink, 1.0);
            pen.text([x + dx, y + dy], anchor, name, label(Role::Ink));
        }
        for (m, who, ratio) in [
            ([1.0, 4.0, 4.0], "Goryachev, Chaplygin", "4 : 4 : 1"),
            ([1.0, 2.0, 2.0], "Kovalevskaya", "2 : 2 : 1"),
        ] {
            let [x, y] = at(m);
            pen.ring([x, y], 5.2, stroke(Role::Ink, DATA));
            let mut line = |up: f64, text: &str| {
                pen.text([x - 11.0, y - up], Anchor::End, text, small(Role::Ink));
            };
            line(21.0, who);
            line(5.0, ratio);
        }
        // The corners and the edges.
        let edge = |pen: &mut Pen<'_>, at: Point, anchor, text: &str| {
            pen.text(at, anchor, text, small(Role::Muted));
        };
        let [rod, disc, sphere] = corners;
        edge(pen, [rod[0] - 6.0, rod[1] + 23.0], Anchor::Start, "rod");
        edge(pen, [disc[0] + 6.0, disc[1] + 23.0], Anchor::End, "disc");
        edge(
            pen,
            [sphere[0] + 6.0, sphere[1] - 23.0],
            Anchor::End,
            "sphere",
        );
        let middle = between(rod, disc, 0.5);
        let laminae = "laminae, *I*_{3} = *I*_{1} + *I*_{2}";
        edge(pen, [middle[0], middle[1] + 44.0], Anchor::Middle, laminae);
        edge(pen, [disc[0] - 10.0, 222.0], Anchor::End, "oblate,");
        edge(
            pen,
            [disc[0] - 10.0, 240.0],
            Anchor::End,
            "*I*_{1} = *I*_{2}",
        );
        let slant = between(rod, sphere, 0.8);
        edge(
            pen,
            [slant[0] - 46.0, slant[1] + 5.0],
            Anchor::End,
            "prolate, *I*_{2} = *I*_{3}",
        );
    }))
}

/// The triangle of all moments in any order, and the ordered sixth: rod, disc and sphere in the order of the axes.
fn inset(pen: &mut Pen<'_>, sixth: [[f64; 3]; 3]) {
    let at = |m| place(m, [112.0, 154.0], 84.0);
    pen.fill(&sixth.map(at), Role::Ink, 0.3);
    let turned = |m: [f64; 3], by: usize| core::array::from_fn(|k| m[(k + by) % 3]);
    let rods = [0, 1, 2].map(|by| at(turned(sixth[0], by)));
    pen.outline(&rods, stroke(Role::Ink, SECONDARY));
    for by in 0..3 {
        // The disc opposite a rod has the rod's odd axis for its own.
        let opposite = at(turned(sixth[1], by + 2));
        pen.line(&[rods[by], opposite], stroke(Role::Ink, HAIR));
    }
}
