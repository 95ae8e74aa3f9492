//! Pythagoras by rotation (tutorial 9): a box of gas on a hinge does not turn by itself, and that is his theorem.
//!
//! Torques are per unit of pressure × height, so they come in m²; anticlockwise is positive. If the corners A, R, B run
//! anticlockwise and R is a right angle, the gas on AR and on RB pushes clockwise, that on AB anticlockwise. For the
//! mirror image all three change sign, see [`GasBox::orientation`].
//!
//! ```
//! use spinning_bodies::pythagoras::GasBox;
//!
//! let torques = GasBox::new([0.0, 0.0], [4.0, 0.0], [4.0, 3.0])?.side_torques();
//! assert_eq!([torques.ar, torques.rb, torques.ab], [-8.0, -4.5, 12.5]);
//! # Ok::<(), spinning_bodies::Error>(())
//! ```

use crate::error::{Result, each_finite, finite, positive, refused, within};
use crate::precise::{DoubleDouble, Extended, Number, power_of_two_below, sum_of_products};

/// The sense in which the corners A, R, B run round the triangle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Orientation {
    /// Against the clock.
    Anticlockwise,
    /// With the clock: the mirror image.
    Clockwise,
}

/// The torque or the lever arm of the gas on each side of the box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BySide {
    /// On AR.
    pub ar: f64,
    /// On RB.
    pub rb: f64,
    /// On AB.
    pub ab: f64,
}

/// A vector in the plane; its components are exact differences of doubles.
type Edge = [DoubleDouble; 2];

/// A box on a triangular base A R B, hinged at A.
///
/// Edges are kept as exact differences of the corners, and their products are summed exactly and rounded once, so that neither a
/// needle nor a tiny or huge triangle loses digits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GasBox {
    /// From A to R.
    ar: Edge,
    /// From R to B.
    rb: Edge,
    /// From A to B.
    ab: Edge,
    /// Twice the area, positive if the corners run anticlockwise.
    area: Extended,
}

impl GasBox {
    /// The box whose base has corners `a` (the hinge), `r` and `b`, m.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite) for a corner or an edge; [`Error::Condition`](crate::Error::Condition) if the corners lie on a line.
    ///
    /// ```
    /// use spinning_bodies::pythagoras::GasBox;
    /// let gas = GasBox::new([0.0, 0.0], [3.0, 0.0], [3.0, 4.0])?;
    /// assert_eq!(gas.sides(), [3.0, 4.0, 5.0]);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(a: [f64; 2], r: [f64; 2], b: [f64; 2]) -> Result<Self> {
        let edge = |from: [f64; 2], to: [f64; 2]| {
            let edge = [0, 1].map(|k| DoubleDouble::difference(to[k], from[k]));
            each_finite("an edge of the triangle", edge.map(DoubleDouble::high))?;
            Ok(edge)
        };
        let (ar, rb, ab) = (edge(a, r)?, edge(r, b)?, edge(a, b)?);
        let area = wedge(ar, rb);
        if area.is_zero() {
            return refused("the triangle must enclose an area", 0.0);
        }
        Ok(Self { ar, rb, ab, area })
    }

    /// The box with sides AR and RB (m) and the angle `gamma` between them at R (radians), A at the origin, R on the x-axis.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::NotPositive`](crate::Error::NotPositive) for a side; [`Error::OutOfRange`](crate::Error::OutOfRange) unless 0 ≤ γ ≤ π; otherwise as [`Self::new`], which refuses γ = 0.
    ///
    /// ```
    /// use spinning_bodies::pythagoras::GasBox;
    /// let gas = GasBox::from_sides(3.0, 4.0, std::f64::consts::FRAC_PI_2)?;
    /// assert!((gas.sides()[2] - 5.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn from_sides(ar: f64, rb: f64, gamma: f64) -> Result<Self> {
        let ar = positive("the side AR", ar)?;
        let rb = positive("the side RB", rb)?;
        let (sin, cos) = angle_of_triangle(gamma)?.sin_cos();
        Self::new([0.0, 0.0], [ar, 0.0], [ar - rb * cos, rb * sin])
    }

    /// The sense in which the corners A, R, B run.
    ///
    /// ```
    /// use spinning_bodies::pythagoras::{GasBox, Orientation};
    /// let gas = GasBox::new([0.0, 0.0], [3.0, 0.0], [3.0, 4.0])?;
    /// assert_eq!(gas.orientation(), Orientation::Anticlockwise);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn orientation(&self) -> Orientation {
        if self.area.leading() > 0.0 {
            Orientation::Anticlockwise
        } else {
            Orientation::Clockwise
        }
    }

    /// The lengths AR, RB, AB, m. One rounding each.
    ///
    /// ```
    /// use spinning_bodies::pythagoras::GasBox;
    /// let gas = GasBox::new([0.0, 0.0], [3.0, 0.0], [3.0, 4.0])?;
    /// assert_eq!(gas.sides(), [3.0, 4.0, 5.0]);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn sides(&self) -> [f64; 3] {
        [self.ar, self.rb, self.ab].map(|edge| length(edge).value())
    }

    /// Torques of the gas on the sides about the hinge A, per unit pressure × height, m², anticlockwise positive; from the pressure integrated along each: −(midpoint − A)·(edge) if the corners
    /// run anticlockwise (9.1). They are −½AR², −(½RB² − AR·RB cos γ) and +½AB², and their sum vanishes.
    ///
    /// Each is rounded once, needles and RB at its change of sign included; infinite beyond the greatest double.
    ///
    /// ```
    /// use spinning_bodies::pythagoras::GasBox;
    /// let gas = GasBox::new([0.0, 0.0], [3.0, 0.0], [3.0, 4.0])?;
    /// // ½·9 and ½·16 in one sense, ½·25 in the other.
    /// let torques = gas.side_torques();
    /// assert_eq!((torques.ar, torques.rb, torques.ab), (-4.5, -8.0, 12.5));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    // ANCHOR: side-torques
    pub fn side_torques(&self) -> BySide {
        let sense = self.area.leading();
        let half = |product: Extended| product.times(0.5).signed(sense).value();
        BySide {
            ar: half(-dot(self.ar, self.ar)),
            rb: half(-self.rb_product()),
            ab: half(dot(self.ab, self.ab)),
        }
    }
    // ANCHOR_END: side-torques

    /// Lever arms about the hinge A, m: torque over side (9.1, 9.2), each positive if the gas on that side pushes the same way as in a right-angled box. They are
    /// AR/2, RB/2 − AR cos γ, with γ the angle at R, and AB/2: the second is negative where the gas on RB pushes the other way. Accuracy as
    /// [`Self::side_torques`].
    ///
    /// ```
    /// use spinning_bodies::pythagoras::GasBox;
    /// let gas = GasBox::new([0.0, 0.0], [3.0, 0.0], [3.0, 4.0])?;
    /// let arms = gas.arms();
    /// assert_eq!((arms.ar, arms.rb, arms.ab), (1.5, 2.0, 2.5));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn arms(&self) -> BySide {
        let half = |length: Extended| length.times(0.5).value();
        BySide {
            ar: half(length(self.ar)),
            rb: half(self.rb_product().quotient(length(self.rb))),
            ab: half(length(self.ab)),
        }
    }

    /// AR² + RB² − AB² = 2 AR·RB cos γ, m²: zero at a right angle, the term that the cosine law adds otherwise (9.2).
    ///
    /// Formed without a difference of squares, as −2 (R−A)·(B−R), summed exactly and rounded once, for any triangle.
    ///
    /// ```
    /// use spinning_bodies::pythagoras::GasBox;
    /// let gas = GasBox::new([0.0, 0.0], [3.0, 0.0], [3.0, 4.0])?;
    /// assert_eq!(gas.right_angle_defect(), 0.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn right_angle_defect(&self) -> f64 {
        dot(self.ar, self.rb).times(-2.0).value()
    }

    /// Angle γ at R, radians, in 0…π. Formed from sine and cosine together, so right to a few units in the last place near 0, π/2 and π alike.
    ///
    /// ```
    /// use spinning_bodies::pythagoras::GasBox;
    /// let gas = GasBox::new([0.0, 0.0], [3.0, 0.0], [3.0, 4.0])?;
    /// assert_eq!(gas.angle_at_r(), std::f64::consts::FRAC_PI_2);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn angle_at_r(&self) -> f64 {
        let size = length(self.ar) * length(self.rb);
        let cosine = -dot(self.ar, self.rb).quotient(size).value();
        self.area.magnitude().quotient(size).value().atan2(cosine)
    }

    /// Twice (midpoint of RB − A)·(B − R), which is AB² − AR².
    fn rb_product(&self) -> Extended {
        combined(&[(1.0, self.ab, self.ab), (-1.0, self.ar, self.ar)])
    }
}

/// The side AB from AR, RB and the angle γ between them (9.2): √((AR−RB)² + 4 AR·RB sin²(γ/2)), m.
///
/// The cosine law without its cancellation: for γ → 0 and AR ≈ RB the usual form loses half the digits, this one none. Observed error: four units in the
/// last place; AR and RB may be huge or tiny, and γ tiny.
///
/// # Errors
/// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::NotPositive`](crate::Error::NotPositive) for a side; [`Error::OutOfRange`](crate::Error::OutOfRange) unless 0 ≤ γ ≤ π.
///
/// ```
/// use spinning_bodies::pythagoras::opposite_side;
/// assert!((opposite_side(1.0, 1.0, std::f64::consts::FRAC_PI_3)? - 1.0).abs() < 1e-15);
/// assert!((opposite_side(1e300, 1e300, 5e-324)? / (1e300 * 5e-324) - 1.0).abs() < 1e-15, "the least of angles");
/// assert!((opposite_side(1e13, 1e13, 1e-318)? / (1e13 * 1e-318) - 1.0).abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn opposite_side(ar: f64, rb: f64, gamma: f64) -> Result<f64> {
    let ar = positive("the side AR", ar)?;
    let rb = positive("the side RB", rb)?;
    // 2 sin(γ/2) without the half of γ, which may be rounded to zero.
    let chord = angle_of_triangle(gamma)?.sin() / (0.5 * gamma).cos();
    // The roots first: the chord of a tiny angle has few digits for another product to keep.
    let across = chord * (ar.sqrt() * rb.sqrt());
    finite("the side AB", (ar - rb).hypot(across))
}

/// The angle γ at which the torque of the gas on RB changes sign (9.2): arccos(RB/(2AR)), radians; `None` if RB > 2AR, when it never does.
///
/// Formed as 2 arctan √((2AR−RB)/(2AR+RB)), accurate down to γ = 0.
///
/// # Errors
/// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::NotPositive`](crate::Error::NotPositive) for a side.
///
/// ```
/// use spinning_bodies::pythagoras::reversal_angle;
/// assert!((reversal_angle(1.0, 1.0)?.unwrap() - std::f64::consts::FRAC_PI_3).abs() < 1e-15);
/// assert_eq!(reversal_angle(1.0, 3.0)?, None);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn reversal_angle(ar: f64, rb: f64) -> Result<Option<f64>> {
    let ar = positive("the side AR", ar)?;
    let rb = positive("the side RB", rb)?;
    // Scaled so that doubling cannot overflow nor halving underflow; next to γ = 0 the difference of the two is exact.
    let unit = power_of_two_below(ar.max(rb));
    let (ar, half) = (ar / unit, 0.5 * (rb / unit));
    Ok((half <= ar).then(|| 2.0 * ((ar - half) / (ar + half)).sqrt().atan()))
}

/// Torques of a gas on the sides of any polygon about any hinge, per unit pressure × height, m², anticlockwise positive (9.1).
///
/// Side k runs from vertex k to the next. The sum is zero: ½|P|² telescopes round the polygon. The vertices run anticlockwise
/// with the gas inside; if they run clockwise all signs change. Each is summed exactly and rounded once.
///
/// # Errors
/// [`Error::Condition`](crate::Error::Condition) for fewer than three vertices; [`Error::NotFinite`](crate::Error::NotFinite) for a coordinate or a torque that overflows.
///
/// ```
/// use spinning_bodies::pythagoras::polygon_torques;
/// // Gas does not turn a closed box.
/// let torques = polygon_torques(&[[0.0, 0.0], [2.0, 0.0], [3.0, 1.0], [1.0, 4.0]], [0.3, 0.7])?;
/// assert!(torques.iter().sum::<f64>().abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn polygon_torques(vertices: &[[f64; 2]], hinge: [f64; 2]) -> Result<Vec<f64>> {
    let count = vertices.len() as f64;
    if count < 3.0 {
        return refused("a polygon must have at least three vertices", count);
    }
    let next = vertices.iter().cycle().skip(1);
    vertices
        .iter()
        .zip(next)
        .map(|(&from, &to)| side_torque(from, to, hinge))
        .collect()
}

/// −(midpoint of the side)·(side), seen from the hinge: half of what the squared distance of its end is less than that of its beginning.
fn side_torque(from: [f64; 2], to: [f64; 2], hinge: [f64; 2]) -> Result<f64> {
    let [start, end] = [from, to].map(|p| [0, 1].map(|k| DoubleDouble::difference(p[k], hinge[k])));
    for arm in [start, end] {
        each_finite("an arm of a torque", arm.map(DoubleDouble::high))?;
    }
    let twice = combined(&[(1.0, start, start), (-1.0, end, end)]);
    finite("the torque on a side", twice.times(0.5).value())
}

/// Outward area vectors of the four faces of a tetrahedron, m²: face k is the one opposite vertex k (9.1, a dimension up).
///
/// Multiplied by the pressure they are the forces of the gas; their sum is zero. At a corner with three right angles this
/// is the theorem A² = A₁² + A₂² + A₃². Whether there is a volume, and which side is out, is told from exact sums; each component is rounded once.
///
/// # Errors
/// [`Error::NotFinite`](crate::Error::NotFinite) for an edge or an area; [`Error::Condition`](crate::Error::Condition) if the volume is zero.
///
/// ```
/// use spinning_bodies::pythagoras::tetrahedron_areas;
/// let corner = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// // Three right-angled faces and the fourth: areas squared, ¼ + ¼ + ¼ = ¾.
/// assert_eq!(tetrahedron_areas(corner)?[0].map(|area| area * area).iter().sum::<f64>(), 0.75);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn tetrahedron_areas(vertices: [[f64; 3]; 4]) -> Result<[[f64; 3]; 4]> {
    let mut areas = [[0.0; 3]; 4];
    let edge = |from: usize, to: usize| -> Result<[DoubleDouble; 3]> {
        let edge = [0, 1, 2].map(|k| DoubleDouble::difference(vertices[to][k], vertices[from][k]));
        each_finite("an edge of the tetrahedron", edge.map(DoubleDouble::high))?;
        Ok(edge)
    };
    let [u, v, w] = [edge(0, 1)?, edge(0, 2)?, edge(0, 3)?];
    let plane = |edge: [DoubleDouble; 3], k: usize| [edge[(k + 1) % 3], edge[(k + 2) % 3]];
    // (u∧v)·w, which is det(u, v, w): six products of three differences of two words.
    let mut products = Vec::new();
    for (k, w) in w.into_iter().enumerate() {
        let ([u1, u2], [v1, v2]) = (plane(u, k), plane(v, k));
        for (a, b) in [(u1, v2), (-u2, v1)] {
            for (x, y) in words(a, b) {
                products.extend([w.high(), w.low()].map(|z| [x, y, z]));
            }
        }
    }
    let volume = sum_of_products(&products).leading();
    if volume == 0.0 {
        return refused("the tetrahedron must enclose a volume", volume);
    }
    for (k, area) in areas.iter_mut().enumerate() {
        // The three corners of the face in ascending order: with the apex last, that order is even or odd by turns.
        let face: Vec<usize> = (0..4).filter(|&j| j != k).collect();
        let (u, v) = (edge(face[0], face[1])?, edge(face[0], face[2])?);
        let outward = if k % 2 == 0 { 0.5 } else { -0.5 } * volume.signum();
        *area = [0, 1, 2].map(|k| wedge(plane(u, k), plane(v, k)).times(outward).value());
        each_finite("a face of the tetrahedron", *area)?;
    }
    Ok(areas)
}

fn angle_of_triangle(gamma: f64) -> Result<f64> {
    within("the angle at R", gamma, 0.0, core::f64::consts::PI)
}

fn length(edge: Edge) -> Extended {
    dot(edge, edge).square_root()
}

fn dot(u: Edge, v: Edge) -> Extended {
    combined(&[(1.0, u, v)])
}

/// u∧v, the area that both span, with its sign.
fn wedge(u: Edge, v: Edge) -> Extended {
    dot(u, [v[1], -v[0]])
}

/// The sum of scalar products, each with a weight ±1: 106 bits of it, whatever cancels.
fn combined(terms: &[(f64, Edge, Edge)]) -> Extended {
    let mut products = Vec::new();
    for &(weight, u, v) in terms {
        for k in 0..2 {
            products.extend(words(u[k], v[k]).map(|(x, y)| [weight * x, y]));
        }
    }
    sum_of_products(&products)
}

/// The words of two numbers in pairs, of which the product is the sum.
fn words(a: DoubleDouble, b: DoubleDouble) -> [(f64, f64); 4] {
    let ([x, rest], [y, other]) = ([a.high(), a.low()], [b.high(), b.low()]);
    [(x, y), (x, other), (rest, y), (rest, other)]
}
