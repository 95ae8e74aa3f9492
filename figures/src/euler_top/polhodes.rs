//! The polhodes, with dots at equal times that show the pace (tutorial 6.3).

use spinning_bodies::euler_top::{EulerTop, Poinsot, Sector};
use spinning_bodies::frame::{Attitude, BodyVector};

use super::body::*;
use crate::prelude::*;

/// Where polhodes cross the plane of x₁ and x₃: shares of the way from x₁, and from x₃, to the separatrix, in the circle that
/// the ellipse is stretched from.
const SHARES: [f64; 4] = [8.0 / 45.0, 18.0 / 45.0, 29.0 / 45.0, 41.0 / 45.0];
/// Time between two dots, in units of a radian over √(2E/I₂).
const STEP: f64 = 0.5;
const DIRECTION: [f64; 2] = [0.98, 0.36];
/// Where the ellipsoid and its axes are drawn: left, top, right, bottom.
const ROOM: [f64; 4] = [130.0, 24.0, 470.0, 436.0];
/// How far the axes reach beyond the ellipsoid, in its longest half axis.
const REACH: [f64; 3] = [0.21, 0.36, 0.21];

parameters! {
    CROSSING: "crossing", r"\alpha", "°", "where the thick polhode crosses the plane of x₁ and x₃, with the ellipsoid stretched to a sphere: 0° at x₁, 90° at x₃", [1.0, 89.0], 23.0, dragged(|values| {
        let (_, view, arms) = stage(values);
        let (sin, cos) = values.of(&CROSSING).to_radians().sin_cos();
        view.project(&(arms[0] * cos + arms[2] * sin))
    });
}
/// The parameters; the handle stands on the thick polhode.
pub const POLHODES: &[Parameter] = &[SMALLEST, MIDDLE, LARGEST, CROSSING];

/// The semi-axes of the ellipsoid, how it is seen, and its axes.
fn stage(values: &Values) -> (Vector, View, [Vector; 3]) {
    let semi = Vector::from(moments(values).map(f64::sqrt));
    let arms = [0, 1, 2].map(|k| Vector::ith(k, semi[k]));
    let mut points: Vec<Vector> = arms.iter().flat_map(|arm| [*arm, -arm]).collect();
    let plain = View::new(DIRECTION[0], DIRECTION[1], [0.0; 2], 1.0);
    points.extend(rim(&semi, &plain.toward, 240));
    points.extend([0, 1, 2].map(|k| Vector::ith(k, semi[k] + REACH[k] * semi[2])));
    let view = View::fitted(DIRECTION, &points, ROOM, f64::INFINITY);
    (semi, view, arms)
}

/// A polhode of L on the ellipsoid of constant energy, and its dots.
struct Curve {
    semi: Vector,
    points: Vec<Vector>,
    dots: Vec<Vector>,
    sector: Sector,
    /// In radians over √(2E/I₂).
    period: f64,
}

impl Curve {
    /// The polhode through the point at `crossing` in the plane of x₁ and x₃, 2E = 1.
    fn new(moments: [f64; 3], crossing: f64, signs: [f64; 2]) -> Result<Self> {
        let semi = moments.map(f64::sqrt);
        let (sin, cos) = crossing.to_radians().sin_cos();
        let l = BodyVector::new(signs[0] * semi[0] * cos, 0.0, signs[1] * semi[2] * sin);
        let picture = Poinsot::new(moments, l)?;
        let top = EulerTop::beyond_bodies(moments, l, Attitude::identity())?;
        // Half a period each way; on the separatrix it would be infinite.
        let step = STEP * semi[1];
        let most = (0.5 * top.period() / step).min(16.0) as i32;
        Ok(Self {
            semi: semi.into(),
            points: spaced([0.0, TAU], 180)
                .map(|turn| picture.polhode_of_l(turn).components())
                .collect(),
            dots: tried(-most..=most, |k| {
                Ok(top.at(step * f64::from(k))?.angular_momentum.components())
            })?,
            sector: picture.sector,
            period: top.period() / semi[1],
        })
    }

    fn draw(&self, pen: &mut Pen, view: &View, style: Stroke, dot: (Role, f64)) {
        let shown = |p: &Vector| !ellipsoid_hides(&self.semi, p, &view.toward);
        let [seen, hidden] = view.split(&self.points, shown);
        pen.lines(hidden, stroke(dot.0, HAIR).alpha(0.3));
        pen.lines(seen, style);
        for p in self.dots.iter().filter(|p| shown(p)) {
            pen.disc(view.project(p), dot.1, dot.0, 1.0);
        }
    }
}

/// What is seen of the sector about x₁ (about −x₁ if `side` is −1), which reaches from −x₂ to x₂ and up to `crossing` from
/// the equator, on the sphere that the ellipsoid is stretched from.
fn sector(view: &View, semi: &Vector, crossing: f64, side: f64) -> Vec<Point> {
    let toward = view.toward.component_div(semi).normalize();
    let edge = |end: f64| {
        (-90..=90)
            .map(|k| f64::from(k).to_radians().sin_cos())
            .map(|(s, c)| Vector::new(side * c * crossing.cos(), s, end * c * crossing.sin()))
            .filter(|p| p.dot(&toward) > 0.0)
            .collect::<Vec<_>>()
    };
    // From the rim of what is seen along one edge to the pole x₂, back along the other, then along the rim.
    let (mut there, mut back) = (edge(1.0), edge(-1.0));
    back.reverse();
    let u = toward.cross(&Vector::z()).normalize();
    // The rim begins next to x₃, outside of both sectors.
    let rim = ellipse(Vector::zeros(), toward.cross(&u), u, 720);
    let inside = |p: &&Vector| side * p.x > 0.0 && (p.z / p.x).abs() < crossing.tan();
    let mut along: Vec<Vector> = rim.iter().filter(inside).copied().collect();
    if let (Some(end), Some(first), Some(last)) = (back.last(), along.first(), along.last())
        && (end - last).norm() < (end - first).norm()
    {
        along.reverse();
    }
    there.append(&mut back);
    there.append(&mut along);
    let places = there.iter().map(|p| view.project(&p.component_mul(semi)));
    places.collect()
}

/// Polhodes on the ellipsoid of constant energy, with dots at equal times.
pub fn polhodes(values: &Values) -> Result<Figure> {
    let moments = moments(values);
    let (semi, view, arms) = stage(values);
    let [i1, i2, i3] = moments;
    // Ω₃/Ω₁ on the separatrix, L² = 2EI₂, of moments that no body has as well.
    let slope = (i1 * (i2 - i1) / (i3 * (i3 - i2))).sqrt();
    // From Omega to the circle that the ellipse of L is stretched from.
    let parting = (slope * (moments[2] / moments[0]).sqrt()).atan();
    let crossing = parting.to_degrees();
    let sides = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];
    let mut family = Vec::new();
    for share in SHARES {
        // One of each pair of signs lies on the same curve.
        for (angle, opposite) in [
            (share * crossing, [-1.0, 1.0]),
            (90.0 - share * (90.0 - crossing), [1.0, -1.0]),
        ] {
            for signs in [[1.0, 1.0], opposite] {
                family.push(Curve::new(moments, angle, signs)?);
            }
        }
    }
    let separatrix = tried(sides, |signs| Curve::new(moments, crossing, signs))?;
    let angle = values.of(&CROSSING);
    let yours = Curve::new(moments, angle, [1.0, 1.0])?;
    let period = number(yours.period / TAU, 2);
    let beside = (angle - crossing).abs() > 1e-9;
    let about = match yours.sector {
        Sector::AroundSmallest if beside => format!("goes round $x_1$ in the time of {period}"),
        Sector::AroundLargest if beside => format!("goes round $x_3$ in the time of {period}"),
        _ => "lies on the separatrix, and takes longer than any number of".to_owned(),
    };

    let (inertia, beyond) = (triple(moments), remark(moments));
    let (steep, thick) = (number(slope, 4), brief(angle));
    let words = words!(
        "Round the first and the third axis a polhode stays close; next to the second it dawdles, then runs across to the \
         far side.",
        "Polhodes of $L$ in the body on the ellipsoid $\\sum L_i^2/2EI_i = 1$ for $I = {inertia}$. Dots at equal times, {STEP:.1} of a radian at the rate $\\sqrt{{2E/I_2}}$. \
         The separatrix, in ink, is two plane ellipses $\\Omega_3 = \\pm{steep}\\,\\Omega_1$. The thick polhode, from the ring at {thick}° between $x_1$ and $x_3$ once the ellipsoid is stretched to a sphere (the \
         separatrix is at {crossing:.1}°), {about} turns at that rate.{beyond}",
        "An ellipsoid with its longest axis upright, its semi-axes as the roots of {inertia}, covered by closed curves: flat rings round the upright third axis, upright \
         rings round the first axis on the left. Two crossing ellipses, the separatrix, part them and meet on the second \
         axis, which points at the reader's right. Dots at equal times are wide apart where a curve swings across and \
         crowd together next to the crossing: there the top dawdles, and from there it runs across to the far side. One curve is thick, on a sphere {thick}° from the \
         first axis."
    );
    let made = figure("polhodes", 448.0, words, |pen| {
        let outline = view.trace(&rim(&semi, &view.toward, 240));
        pen.fill(&outline, Shade, 1.0);
        for side in [1.0, -1.0] {
            pen.fill(sector(&view, &semi, parting, side), Ink, 0.1);
        }
        pen.outline(&outline, inked(SECONDARY));
        let role = AngularMomentum;
        for curve in &family {
            curve.draw(pen, &view, stroke(role, AXIS), (role, 2.0));
        }
        for curve in &separatrix {
            curve.draw(pen, &view, inked(SECONDARY), (Ink, 2.3));
        }
        yours.draw(pen, &view, stroke(role, 2.8), (role, 3.6));
        let (sin, cos) = angle.to_radians().sin_cos();
        let ring = view.project(&(arms[0] * cos + arms[2] * sin));
        pen.disc(ring, 6.0, Paper, 1.0);
        pen.ring(ring, 6.0, stroke(role, DATA));
        for (k, name) in ["*x*_{1}", "*x*_{2}", "*x*_{3}"].iter().enumerate() {
            let reach = Vector::ith(k, semi[k] + REACH[k] * semi[2]);
            let to = view.project(&reach);
            pen.arrow(view.project(&arms[k]), to, inked(AXIS));
            let places = [1.0, 1.4, 1.8].map(|far| match k {
                2 => shifted(to, [14.0, 5.0]),
                _ => view.project(&(reach * (1.0 + 0.085 * far * semi[2] / semi[k]))),
            });
            pen.name(places, name, label(Ink));
        }
        // On the separatrix between −x₂ and the upper crossing, next to x₂ on it, and on the first ring about x₁.
        let on = |along: f64, sign: f64| {
            let (s, c) = along.sin_cos();
            let (high, wide) = parting.sin_cos();
            view.project(&Vector::new(wide * c, s, sign * high * c).component_mul(&semi))
        };
        let [parts, dawdles] = [["separatrix", ""], ["next to *x*_{2}", "it dawdles"]];
        for (at, anchor, lines, to) in [
            ([150.0, 76.0], End, parts, on(-0.45, 1.0)),
            ([478.0, 352.0], Start, dawdles, on(1.32, -1.0)),
            (
                [112.0, 366.0],
                End,
                ["far from it", "it hurries"],
                on(0.0, -1.0),
            ),
        ] {
            let beside = if anchor == End { 4.0 } else { -6.0 };
            pen.note(at, anchor, lines[0]);
            pen.note(shifted(at, [0.0, 19.0]), anchor, lines[1]);
            pen.line([shifted(at, [beside, -4.0]), to], inked(HAIR));
        }
    });
    let columns = "L₁ (√(2E kg m²)) | L₂ (√(2E kg m²)) | L₃ (√(2E kg m²))";
    let named = family.iter().map(|curve| ("polhode", curve));
    let named = named.chain(separatrix.iter().map(|curve| ("separatrix", curve)));
    let named = named.chain([("thick polhode", &yours)]);
    Ok(named.enumerate().fold(made, |made, (k, (name, curve))| {
        let rows = curve.points.iter().map(|p| [p.x, p.y, p.z]);
        made.data(format!("{name} {}", k + 1), columns, rows)
    }))
}
