//! The polhodes, with the pace the picture does not tell (tutorial 6.3).

use core::f64::consts::TAU;

use nalgebra::Vector3;
use spinning_bodies::Result;
use spinning_bodies::euler_top::{EulerTop, Poinsot, separatrix_slope};
use spinning_bodies::frame::{Attitude, BodyVector};

use crate::Figure;
use crate::solid::{View, ellipse, ellipsoid_hides};
use crate::style::{
    AXIS, Anchor, HAIR, Pen, Point, Role, SECONDARY, Stroke, Words, figure, label, number, small,
    stroke,
};

const MOMENTS: [f64; 3] = [1.0, 2.0, 3.0];
/// Where a polhode crosses the plane of x₁ and x₃: degrees from x₁ in the circle that the ellipse is stretched from.
/// The separatrix is at 45.
const CROSSINGS: [f64; 8] = [8.0, 18.0, 29.0, 41.0, 49.0, 61.0, 72.0, 82.0];
/// Time between two dots, in units of a radian over √(2E/I₂).
const STEP: f64 = 0.5;

/// A polhode of L on the ellipsoid of constant energy, and its dots.
struct Curve {
    points: Vec<Vector3<f64>>,
    dots: Vec<Vector3<f64>>,
}

impl Curve {
    /// The polhode through the point at `crossing` in the plane of x₁ and x₃, 2E = 1.
    fn new(crossing: f64, signs: [f64; 2]) -> Result<Self> {
        let semi = MOMENTS.map(f64::sqrt);
        let (sin, cos) = crossing.to_radians().sin_cos();
        let l = BodyVector::new(signs[0] * semi[0] * cos, 0.0, signs[1] * semi[2] * sin);
        let picture = Poinsot::new(MOMENTS, l)?;
        let omega =
            BodyVector::from_components(l.components().component_div(&Vector3::from(MOMENTS)));
        let top = EulerTop::from_omega(MOMENTS, omega, Attitude::identity())?;
        // Half a period each way; the separatrix would take for ever.
        let step = STEP * semi[1];
        let most = (0.5 * top.period() / step).min(16.0) as i32;
        Ok(Self {
            points: (0..=180)
                .map(|k| {
                    picture
                        .polhode_of_l(TAU * f64::from(k) / 180.0)
                        .components()
                })
                .collect(),
            dots: (-most..=most)
                .map(|k| Ok(top.at(step * f64::from(k))?.angular_momentum.components()))
                .collect::<Result<_>>()?,
        })
    }

    fn draw(&self, pen: &mut Pen, view: &View, style: Stroke, dot: (Role, f64)) {
        let semi = Vector3::from(MOMENTS.map(f64::sqrt));
        let shown = |p: &Vector3<f64>| !ellipsoid_hides(&semi, p, &view.toward);
        let [seen, hidden] = view.split(&self.points, shown);
        for piece in hidden {
            pen.line(&piece, stroke(dot.0, HAIR).alpha(0.3));
        }
        for piece in seen {
            pen.line(&piece, style);
        }
        for p in self.dots.iter().filter(|p| shown(p)) {
            pen.disc(view.project(p), dot.1, dot.0, 1.0);
        }
    }
}

/// What is seen of the sector about x₁ (about −x₁ if `side` is −1), which reaches from −x₂ to x₂ and up to `crossing` from
/// the equator, on the sphere that the ellipsoid is stretched from.
fn sector(view: &View, crossing: f64, side: f64) -> Vec<Point> {
    let semi = Vector3::from(MOMENTS.map(f64::sqrt));
    let toward = view.toward.component_div(&semi).normalize();
    let edge = |end: f64| {
        (-90..=90)
            .map(|k| f64::from(k).to_radians().sin_cos())
            .map(|(s, c)| Vector3::new(side * c * crossing.cos(), s, end * c * crossing.sin()))
            .filter(|p| p.dot(&toward) > 0.0)
            .collect::<Vec<_>>()
    };
    // From the rim of what is seen along one edge to the pole x₂, back along the other, then along the rim.
    let (mut there, mut back) = (edge(1.0), edge(-1.0));
    back.reverse();
    let u = toward.cross(&Vector3::z()).normalize();
    // The rim begins next to x₃, outside of both sectors.
    let rim = ellipse(Vector3::zeros(), toward.cross(&u), u, 720);
    let inside = |p: &&Vector3<f64>| side * p.x > 0.0 && (p.z / p.x).abs() < crossing.tan();
    let mut along: Vec<Vector3<f64>> = rim.iter().filter(inside).copied().collect();
    if let (Some(end), Some(first), Some(last)) = (back.last(), along.first(), along.last())
        && (end - last).norm() < (end - first).norm()
    {
        along.reverse();
    }
    there.append(&mut back);
    there.append(&mut along);
    there
        .iter()
        .map(|p| view.project(&p.component_mul(&semi)))
        .collect()
}

/// Polhodes on the ellipsoid of constant energy, with dots at equal times.
pub fn polhodes() -> Result<Figure> {
    let slope = separatrix_slope(MOMENTS)?;
    // From Omega to the circle that the ellipse of L is stretched from.
    let crossing = (slope * (MOMENTS[2] / MOMENTS[0]).sqrt())
        .atan()
        .to_degrees();
    let view = View::new(0.98, 0.36, [300.0, 232.0], 116.0);
    let sides = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];
    let mut family = Vec::new();
    for angle in CROSSINGS {
        // One of each pair of signs lies on the same curve.
        let opposite = if angle < crossing {
            [-1.0, 1.0]
        } else {
            [1.0, -1.0]
        };
        for signs in [[1.0, 1.0], opposite] {
            family.push(Curve::new(angle, signs)?);
        }
    }
    let separatrix = sides
        .into_iter()
        .map(|signs| Curve::new(crossing, signs))
        .collect::<Result<Vec<_>>>()?;

    let words = Words {
        claim: "Round the first and the third axis a polhode stays close; next to the second it dawdles, then swings over to the \
                other side."
            .to_owned(),
        details: format!(
            "Polhodes of $L$ in the body on the ellipsoid $\\sum L_i^2/2EI_i = 1$ for $I = (1, 2, 3)$. Dots at equal times, {} \
             of a radian at the rate $\\sqrt{{2E/I_2}}$. The separatrix, in ink, is two plane ellipses \
             $\\Omega_3 = \\pm{}\\,\\Omega_1$ that cross on $x_2$ and leave four sectors, the two about $x_1$ shaded.",
            number(STEP, 1),
            number(slope, 4),
        ),
        alt: "An ellipsoid with its longest axis upright, covered by closed curves: flat rings round the upright third axis, upright \
              rings round the first axis on the left. Two crossing ellipses, the separatrix, part them and meet on the second \
              axis, which points at the reader's right. Dots at equal times are wide apart where a curve swings across and \
              crowd together next to the crossing: there the top dawdles, and from there it swings over to the other side."
            .to_owned(),
    };
    Ok(figure("polhodes", 448.0, words, |pen| {
        let semi = Vector3::from(MOMENTS.map(f64::sqrt));
        let n = view.toward.component_div(&semi).normalize();
        let u = n.cross(&Vector3::z()).normalize();
        let v = n.cross(&u);
        let outline = view.trace(&ellipse(
            Vector3::zeros(),
            u.component_mul(&semi),
            v.component_mul(&semi),
            240,
        ));
        pen.fill(&outline, Role::Shade, 1.0);
        for side in [1.0, -1.0] {
            pen.fill(&sector(&view, crossing.to_radians(), side), Role::Ink, 0.1);
        }
        pen.outline(&outline, stroke(Role::Ink, SECONDARY));
        for curve in &family {
            let role = Role::AngularMomentum;
            curve.draw(pen, &view, stroke(role, SECONDARY), (role, 2.3));
        }
        for curve in &separatrix {
            curve.draw(pen, &view, stroke(Role::Ink, SECONDARY), (Role::Ink, 2.3));
        }
        for (k, name) in ["*x*_{1}", "*x*_{2}", "*x*_{3}"].iter().enumerate() {
            let direction = Vector3::ith(k, 1.0);
            let reach = [0.36, 0.62, 0.36][k];
            let from = view.project(&(direction * semi[k]));
            let to = view.project(&(direction * (semi[k] + reach)));
            pen.arrow(from, to, stroke(Role::Ink, AXIS));
            let beyond = view.project(&(direction * (semi[k] + reach + 0.14)));
            let at = if k == 2 {
                [to[0] + 14.0, to[1] + 10.0]
            } else {
                [beyond[0], beyond[1] + 5.0]
            };
            pen.text(at, Anchor::Middle, name, label(Role::Ink));
        }
        for (at, anchor, lines, role, from, to) in [
            (
                [150.0, 76.0],
                Anchor::End,
                &["separatrix"][..],
                Role::Ink,
                [154.0, 72.0],
                [203.0, 113.0],
            ),
            (
                [458.0, 352.0],
                Anchor::Start,
                &["next to *x*_{2}", "it dawdles"][..],
                Role::Ink,
                [452.0, 343.0],
                [388.0, 276.0],
            ),
            (
                [128.0, 356.0],
                Anchor::End,
                &["far from it", "it hurries"][..],
                Role::AngularMomentum,
                [132.0, 359.0],
                [245.0, 341.0],
            ),
        ] {
            for (k, line) in lines.iter().enumerate() {
                let y = at[1] + 19.0 * k as f64;
                pen.text([at[0], y], anchor, line, small(role));
            }
            pen.line(&[from, to], stroke(role, HAIR));
        }
    }))
}
