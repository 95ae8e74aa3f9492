//! The rattleback from above: the axes of its belly, and those of its inertia, which are out of line with them.

use nalgebra::Matrix3;
use spinning_bodies::frame::BodyVector;
use spinning_bodies::inertia::InertiaMatrix;
use spinning_bodies::tippe_top::{ConvexBody, Surface, rolling_growth_rates};

use super::toys::*;
use crate::prelude::*;

parameters! {
    PRODUCT: "product", "I_{12}/M", "cm²", "product of inertia over the mass", [-0.5, 0.5], -0.2;
}
/// The parameters.
pub const STONE: [Parameter; 2] = [PRODUCT, SPIN.between([1.0, 8.0], 5.0)];

/// Half axes of the belly, m; its middle on the page; units per metre.
const BELLY: [f64; 3] = [0.2, 0.03, 0.02];
const MIDDLE: Point = [300.0, 82.0];
const METRE: f64 = 1250.0;
/// The lens at the tip: its middle, radius and magnification.
const LENS: (Point, f64, f64) = ([494.0, 232.0], 74.0, 6.0);

/// The stone of Kane and Levinson with this product of inertia (m²).
fn stone(product: f64) -> Result<ConvexBody> {
    let inertia = Matrix3::new(2e-4, product, 0.0, product, 16e-4, 0.0, 0.0, 0.0, 17e-4);
    let surface = Surface::ellipsoid(BELLY)?;
    let up = BodyVector::new(0.0, 0.0, 0.01);
    ConvexBody::new(1.0, InertiaMatrix::from_matrix(inertia)?, surface, up)
}

/// Its outline with both pairs of axes, the tip enlarged.
pub fn two_pairs_of_axes(values: &Values) -> Result<Figure> {
    let [product, spin] = values.each(STONE);
    let body = stone(1e-4 * product)?;
    let axes = body.inertia().principal_axes().axes;
    let angle = (axes[(1, 0)] / axes[(0, 0)]).atan();
    let growth = |spin: f64| -> Result<f64> { Ok(rolling_growth_rates(&body, G, spin)?[0].growth) };
    let rates = [growth(-spin)?, growth(spin)?];
    let (fast, slow) = (rates[0].max(rates[1]), rates[0].min(rates[1]));
    let out = number(angle.abs().to_degrees(), 2);
    let none = 1e-4;
    let told = rates.map(|rate| match rate > none {
        true if rate < 0.995 => format!("grows at {rate:.4} per second"),
        true => format!("grows at {rate:.3} per second"),
        false => "does not grow".to_owned(),
    });
    let claim = match (fast > none, slow > none) {
        (true, true) => format!(
            "The stone's axes of inertia stand {out}° out of line with those of its belly, and rattling grows {} times as fast in one sense of spin as in the other.",
            number(fast / slow, 1)
        ),
        (true, false) => format!(
            "The stone's axes of inertia stand {out}° out of line with those of its belly, and rattling grows in one sense of spin only."
        ),
        _ if angle == 0.0 => "With its axes of inertia in line with those of its belly, rattling grows in neither sense of spin.".to_owned(),
        _ => format!("At this spin rattling grows in neither sense, though the stone's axes stand {out}° out of line."),
    };
    let off = brief(product).replace('\u{2212}', "-");
    let (times, spun) = (LENS.2, brief(spin));
    let [clockwise, other] = &told;
    let passes = match angle == 0.0 {
        true => "lies on it",
        false => "passes beside it",
    };
    let words = words!(
        "{claim}",
        "Kane and Levinson's stone from above, semi-axes 20 and 3 cm, to scale; per unit of mass, moments of 2 and 16 cm² and a product of ${off}$ cm². Solid: the axes of \
         inertia; in the lens the tip, {times} times as large. The rates are for a steady spin of {spun} rad/s in pure rolling.",
        "The outline of a long stone from above with two crosses of axes through its middle, one dashed along the outline and one solid, turned by {out} degrees. A lens enlarges the tip, \
         where the dashed axis meets the outline and the solid one {passes}. Two bent arrows tell what each sense of spin does: clockwise rattling {clockwise}, anticlockwise it {other}."
    );
    let made = figure("rattleback-stone", 322.0, words, |pen| {
        let belly = inked(SECONDARY).dashed();
        let inertia = inked(DATA);
        let outline: Vec<Point> = spaced([0.0, TAU], 720)
            .map(f64::sin_cos)
            .map(|(s, c)| [METRE * BELLY[0] * c, METRE * BELLY[1] * s])
            .collect();
        let placed = outline.iter().map(|p| planned(MIDDLE, 1.0, *p));
        let placed: Vec<Point> = placed.collect();
        pen.fill(&placed, Ink, 0.08);
        pen.outline(&placed, inked(SECONDARY));
        let cross = |pen: &mut Pen, turned: f64, style: Stroke| {
            for (turned, half) in [(turned, 284.0), (turned + FRAC_PI_2, 70.0)] {
                let ends = [turned + PI, turned].map(|way| polar(MIDDLE, half, way));
                pen.line(ends, style);
            }
        };
        cross(pen, 0.0, belly);
        cross(pen, angle, inertia);
        pen.dot(MIDDLE, 3.5);
        lens(pen, &outline, angle, [belly, inertia]);
        for (way, text, y, [from, to]) in [
            ("clockwise", clockwise, 204.0, [2.6, 0.5]),
            ("anticlockwise", other, 278.0, [0.5, 2.6]),
        ] {
            pen.arc_arrow([54.0, y + 6.0], 24.0, from, to, inked(DATA));
            pen.label([98.0, y - 4.0], Start, way);
            pen.note([98.0, y + 18.0], Start, &format!("rattling {text}"));
        }
    });
    let columns = "angle (°) | growth clockwise (1/s) | growth anticlockwise (1/s)";
    let row = [angle.to_degrees(), rates[0], rates[1]];
    Ok(made.data("stone", columns, [row]).value("angle", out))
}

/// The tip enlarged, with both axes that leave it.
fn lens(pen: &mut Pen, outline: &[Point], angle: f64, [belly, inertia]: [Stroke; 2]) {
    let (center, radius, times) = LENS;
    let tip = METRE * BELLY[0];
    // The tip stands right of the middle of the lens.
    let origin = shifted(center, [0.4 * radius, 0.0]);
    let place = |p: &Point| planned(origin, times, [p[0] - tip, p[1]]);
    let within = |p: &Point| distance(*p, center) < radius - 1.0;
    let axis = |turned: f64| -> Vec<Point> {
        (-400..=400)
            .map(|k| tip + 0.05 * f64::from(k))
            .map(|x| [x, x * turned.tan()])
            .collect()
    };
    pen.dot([MIDDLE[0] + tip, MIDDLE[1]], 3.5);
    pen.ring(center, radius, muted(AXIS));
    let to = [MIDDLE[0] + tip, MIDDLE[1] + 8.0];
    let ends = [to, [to[0] - 4.0, center[1] - radius]];
    pen.line(ends, muted(AXIS).dotted());
    for (curve, style) in [
        (outline.to_vec(), inked(SECONDARY)),
        (axis(0.0), belly),
        (axis(angle), inertia),
    ] {
        let placed: Vec<Point> = curve.iter().map(place).collect();
        pen.lines(placed.split(|p| !within(p)), style);
    }
    // Each name outside, where its axis enters.
    let left = tip - 1.4 * radius / times;
    let heights = [0.0, angle].map(|turned| place(&[left, left * turned.tan()])[1]);
    for (text, y) in ["belly", "inertia"].into_iter().zip(spread(heights, 18.0)) {
        let out = (radius.powi(2) - (y - center[1]).powi(2)).max(0.0).sqrt();
        pen.note([center[0] - out - 6.0, y + 5.0], End, text);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The stone of the book is the library's, its axes are those of a two by two matrix, and its mirror image does the opposite.
    #[test]
    fn the_stone_is_the_one_of_the_chapter() {
        let stones = [-0.2, 0.0, 0.2].map(|product| {
            let values = Values::default()
                .with(&PRODUCT, product)
                .expect("a product");
            two_pairs_of_axes(&values).expect("a figure").data.rows[0]
                .1
                .clone()
        });
        let [book, straight, image] = &stones;
        let angle = 0.5 * (2.0 * 0.2 / 14.0_f64).atan().to_degrees();
        assert!((book[0] - angle).abs() < 1e-13, "{}", book[0]);
        // Kane and Levinson's stone: the rates that the chapter asserts of the library's body.
        assert!((book[1] - 2.121).abs() < 6e-4 && (book[2] - 0.2025).abs() < 6e-4);
        assert!(straight[0] == 0.0 && straight[1].abs().max(straight[2].abs()) < 1e-5);
        assert!((image[0] + book[0]).abs() < 1e-13);
        for k in [1, 2] {
            assert!((image[3 - k] - book[k]).abs() < 1e-6, "{image:?}");
        }
    }
}
