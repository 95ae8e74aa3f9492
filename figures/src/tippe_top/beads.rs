//! Six beads in a ball: a chiral top to build.

use spinning_bodies::frame::Attitude;
use spinning_bodies::tippe_top::{ConvexBody, beads as places, bodies};

use crate::prelude::*;

const RADIUS: f64 = 122.0;

/// Both beads of each rod, with C between them: in units of R, seen from K.
pub fn inside(body: &ConvexBody) -> Result<[[Vector; 2]; 3]> {
    let pairs = places(body.mass(), body.inertia(), &Attitude::identity())?;
    let mass = -body.center().components() / 0.02;
    Ok(pairs.map(|p| [mass + p.components() / 0.02, mass - p.components() / 0.02]))
}

/// Three rods, six beads, one ball.
pub fn beads(_: &Values) -> Result<Figure> {
    let body = bodies::chiral_top()?;
    let pairs = places(body.mass(), body.inertia(), &Attitude::identity())?;
    let beads = inside(&body)?;
    let farthest = beads.iter().flatten().map(Vector::norm).fold(0.0, f64::max);
    let deep = number(1e3 * body.center().norm(), 1);
    let [first, second, third] = pairs.map(|pair| number(1e3 * pair.norm(), 2));
    let upright = body.center().components().normalize();
    let leans = pairs.map(|rod| {
        rod.components()
            .normalize()
            .dot(&upright)
            .abs()
            .acos()
            .to_degrees()
    });
    let [left, right, lean] = numbers([90.0 - leans[0], 90.0 - leans[1], leans[2]], 1);
    let words = words!(
        "Six equal beads on three crossed rods make the chiral top.",
        "The ball from two sides; $K$ its centre, the rods cross at $C$, {deep} mm below it for $R = 2$ cm. Beads of a sixth of the mass each sit on the \
         principal axes at {first}, {second} and {third} mm from $C$; the farthest is {farthest:.3} of $R$ from $K$. One rod leans {lean}° from $CK$, the others \
         {left}° and {right}° from level, and that is the whole secret.",
        "Two views of a transparent ball. Three rods cross at a point C a little below the centre K, each with a bead at both ends, all inside the ball. One \
         rod is nearly vertical but visibly leans."
    );
    Ok(figure("chiral-beads", 300.0, words, |pen| {
        view(pen, ([150.0, 136.0], RADIUS), 0.95, &beads);
        view(pen, ([450.0, 136.0], RADIUS), 0.95 + FRAC_PI_2, &beads);
        pen.label([150.0, 288.0], Middle, "from the front");
        pen.label([450.0, 288.0], Middle, "from the side");
    }))
}

/// The ball of this radius, seen from `azimuth`.
pub fn view(pen: &mut Pen, (center, radius): (Point, f64), azimuth: f64, beads: &[[Vector; 2]; 3]) {
    let view = View::new(azimuth, 0.12, center, radius);
    pen.disc(center, radius, Shade, 0.6);
    pen.line(view.trace(&latitude(0.0, 1.0, 96)), muted(HAIR));
    pen.ring(center, radius, inked(AXIS));
    let axis = view.trace(&[-Vector::z(), Vector::z()]);
    pen.line(axis, muted(SECONDARY).dotted());
    let scale = radius / RADIUS;
    for pair in beads {
        pen.line(view.trace(pair), inked(SECONDARY));
        for end in pair {
            let depth = end.dot(&view.toward);
            let at = view.project(end);
            let size = (9.0 + 2.0 * depth) * scale;
            pen.disc(at, size, Ink, 0.65);
            pen.ring(at, size, inked(AXIS));
        }
    }
    let k = view.project(&Vector::zeros());
    let c = view.project(&(0.5 * (beads[0][0] + beads[0][1])));
    pen.dot(k, 3.2);
    pen.dot(c, 3.2);
    // Beside it, on the outer side first, and above or below the lines.
    let mut name = |at: Point, [x, y]: Point, text: &str, lettering| {
        let around = [
            [x, -y],
            [x, y],
            [x, -2.0 * y],
            [x, 2.0 * y],
            [0.0, -2.0 * y],
            [0.0, 2.8 * y],
            [1.4 * x, -y],
        ];
        pen.name(around.map(|by| shifted(at, by)), text, lettering);
    };
    for (n, pair) in beads.iter().enumerate() {
        let upper = usize::from(pair[0].z < pair[1].z);
        let at = view.project(&pair[upper]);
        let out = if at[0] < center[0] { -1.0 } else { 1.0 };
        let number = (n + 1).to_string();
        name(at, [out * (4.0 + 15.0 * scale), 9.0], &number, small(Ink));
    }
    name(k, [-15.0, 8.0], "*K*", label(Ink));
    name(c, [-15.0, 12.0], "*C*", label(Ink));
}
