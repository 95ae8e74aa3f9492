//! The map of all tops: principal moments as a point of a triangle (tutorial 2.4, 5.3).

use spinning_bodies::euler_top::earth;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::inertia::{MassProperties, shapes};

use crate::prelude::*;

parameters! {
    LENGTH: "length", "a", "mm", "length of the brick", [20.0, 400.0], 240.0;
    WIDTH: "width", "b", "mm", "width of the brick", [20.0, 400.0], 115.0;
    HEIGHT: "height", "c", "mm", "height of the brick", [5.0, 400.0], 71.0;
}
/// The parameters: the edges of the brick.
pub const TRIANGLE: &[Parameter] = &[LENGTH, WIDTH, HEIGHT];

/// The big triangle: its right angle, the disc, is at `CORNER`; it is `WIDE` wide and `WIDE`/√3 high.
const CORNER: Point = [572.0, 384.0];
const WIDE: f64 = 544.0;

/// The place of ordered moments on the map.
///
/// In the triangle of all moments with sum 1 the corners are at equal distances; the ordered ones fill this sixth of it.
fn place(moments: [f64; 3], corner: Point, wide: f64) -> Point {
    let [i1, i2, i3] = shares(moments);
    let up = 2.0 * 3.0_f64.sqrt() * wide * (0.5 - i3);
    shifted(corner, [-2.0 * wide * (i2 - i1), -up])
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

/// All rigid bodies, by the ratios of their principal moments, in one triangle.
pub fn tops(values: &Values) -> Result<Figure> {
    let of = |body: MassProperties| body.inertia().principal_axes().moments;
    let millimetres = |edges: [f64; 3]| shapes::cuboid(1.0, edges.map(|edge| edge / 1e3)).map(of);
    let book = millimetres([240.0, 165.0, 30.0])?;
    let phone = millimetres([147.0, 72.0, 8.0])?;
    let edges = values.each([LENGTH, WIDTH, HEIGHT]);
    let brick = millimetres(edges)?;
    let (racket, water) = (of(racket()?), of(water()?));
    let coin = of(shapes::cylinder(1.0, 0.011_6, 0.002_3)?);
    let (rod, disc) = (of(shapes::rod(1.0, 1.0)?), of(shapes::disc(1.0, 1.0)?));
    let cube = of(shapes::cuboid(1.0, [1.0; 3])?);
    let egg = of(shapes::ellipsoid(1.0, [0.022, 0.022, 0.029])?);
    let doughnut = of(shapes::torus(1.0, 0.035, 0.015)?);
    let h = earth::DYNAMICAL_ELLIPTICITY;
    let earth = [1.0 - h, 1.0 - h, 1.0];
    // The largest moment is between a third of the sum, for the sphere, and a half, for the disc.
    let flatness = 6.0 * (shares(earth)[2] - 1.0 / 3.0);
    let [i1, i2, i3] = shares(brick);
    let inside = (i2 - i1).min(i3 - i2).min(i1 + i2 - i3) > 0.02;
    let listed = |m: [f64; 3]| shares(m).map(|i| number(i, 3)).join(", ");

    let [a, b, c, d, e] = [book, phone, racket, brick, water].map(listed);
    let [length, width, height] = briefs(edges);
    let way = number(flatness, 4);
    let lies = if inside { "inside" } else { "close to an edge" };
    let words = words!(
        "Every rigid body that ever spun is a point of this triangle.",
        "Principal moments $I_1\\le I_2\\le I_3$ over their sum. The small triangle has them in every order; its shaded sixth is drawn large. Shares of the book: {a}; \
         telephone: {b}; racket: {c}; brick, {length} by {width} by {height} mm: {d}; water: {e}. The Earth is {way} of the way from sphere to disc.",
        "A right triangle, the map of all ordered principal moments. Bottom edge, the laminae: from the rod at the left \
         to the disc at the right, with a racket, a telephone, a molecule of water and almost a book on it, and a coin \
         close to the disc. Right edge, the oblate tops: a doughnut low down, and the sphere on top, where cube and Earth \
         sit. Slanting edge, the prolate tops from the rod to the sphere: the ratios four to four to one and two to two \
         to one, and an egg. A brick lies {lies}. A small equilateral triangle shows the large one as one of its six \
         mirror images."
    );

    let made = figure("triangle-of-tops", 438.0, words, |pen| {
        let at = |m: [f64; 3]| place(m, CORNER, WIDE);
        let corners = [at(rod), at(disc), at(cube)];
        pen.fill(corners, Ink, 0.07);
        pen.outline(corners, inked(DATA));
        inset(pen, [rod, disc, cube]);
        let name = label(Muted);
        pen.text([112.0, 174.0], Middle, "any order of the axes", name);
        let (above, below) = ([0.0, -11.0], [0.0, 23.0]);
        let left = [-11.0, 5.0];
        for (name, m, beside, anchor) in [
            ("racket", racket, below, Middle),
            ("phone", phone, below, Middle),
            ("water", water, below, Middle),
            ("book", book, above, Middle),
            ("coin", coin, [-11.0, -1.0], End),
            ("doughnut", doughnut, left, End),
            ("egg", egg, [-9.0, -7.0], End),
            ("cube, Earth", cube, [-12.0, -3.0], End),
        ] {
            pen.dot(at(m), 4.4);
            pen.label(shifted(at(m), beside), anchor, name);
        }
        for (m, who, ratio) in [
            ([1.0, 4.0, 4.0], "Goryachev, Chaplygin", "4 : 4 : 1"),
            ([1.0, 2.0, 2.0], "Kovalevskaya", "2 : 2 : 1"),
        ] {
            pen.ring(at(m), 5.2, inked(DATA));
            pen.label(shifted(at(m), [-11.0, -23.0]), End, who);
            pen.label(shifted(at(m), [-11.0, -5.0]), End, ratio);
        }
        // The corners and the edges.
        let [rod, disc, sphere] = corners;
        let (flat, slant) = (between(rod, disc, 0.5), between(rod, sphere, 0.8));
        let oblate = [disc[0] - 10.0, 222.0];
        let laminae = "laminae, *I*_{3} = *I*_{1} + *I*_{2}";
        for (at, beside, anchor, text) in [
            (rod, [-6.0, 23.0], Start, "rod"),
            (disc, [6.0, 23.0], End, "disc"),
            (sphere, [6.0, -24.0], End, "sphere"),
            (flat, [0.0, 44.0], Middle, laminae),
            (oblate, [0.0, 0.0], End, "oblate,"),
            (oblate, [0.0, 21.0], End, "*I*_{1} = *I*_{2}"),
            (slant, [-46.0, 5.0], End, "prolate, *I*_{2} = *I*_{3}"),
        ] {
            pen.text(shifted(at, beside), anchor, text, label(Muted));
        }
        // The brick moves: its name is where it hides nothing.
        let brick = at(brick);
        pen.dot(brick, 5.4);
        let places = (0..48).map(|k| {
            let (far, turn) = (18 + 8 * (k / 12), f64::from(k % 12) * PI / 6.0);
            let [x, y] = polar([0.0; 2], f64::from(far), FRAC_PI_2 + turn);
            shifted(brick, [1.7 * x, y])
        });
        let inside = within([24.0, 576.0], [12.0, 430.0]);
        pen.name(places.filter(inside), "brick", label(Ink).strong());
    });
    let bodies = [
        ("book", book),
        ("telephone", phone),
        ("brick", brick),
        ("racket", racket),
        ("water", water),
        ("coin", coin),
        ("egg", egg),
        ("doughnut", doughnut),
        ("Earth", earth),
    ];
    let columns = "I1 over the sum | I2 over the sum | I3 over the sum";
    Ok(bodies.into_iter().fold(made, |made, (name, moments)| {
        made.data(name, columns, [shares(moments)])
    }))
}

/// The triangle of all moments in any order, and the ordered sixth: rod, disc and sphere in the order of the axes.
fn inset(pen: &mut Pen, sixth: [[f64; 3]; 3]) {
    let at = |m| place(m, [112.0, 154.0], 84.0);
    pen.fill(sixth.map(at), Ink, 0.3);
    let turned = |m: [f64; 3], by: usize| core::array::from_fn(|k| m[(k + by) % 3]);
    let rods = [0, 1, 2].map(|by| at(turned(sixth[0], by)));
    pen.outline(rods, inked(SECONDARY));
    for (by, rod) in rods.into_iter().enumerate() {
        // The axis of a disc is the axis of the rod opposite to it.
        let opposite = at(turned(sixth[1], by + 2));
        pen.line([rod, opposite], inked(HAIR));
    }
}
