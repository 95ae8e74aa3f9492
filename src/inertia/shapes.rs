//! Closed formulas for homogeneous bodies (tutorial 2.6, 2.7).
//!
//! Every body has its centre of mass at the origin, except [`triangle_lamina`], which stays where its corners
//! are, [`ball_without_cap`] and [`racket`]. Axes of symmetry are along z; laminae lie in the plane of x and y. Lengths in metres, mass in kilograms.
//!
//! The mass must be positive. A length may be zero where the limit is a body: a box without height is a lamina.
//! All functions multiply mass·length first and then by length: as long as that product and each part's mass are normal numbers, nothing over- or
//! underflows before the result does, but for results within a factor of 20 of the greatest double. The tests of Section 2 hold every moment to 16 eps. Cost: a few dozen operations.
//!
//! Errors, the same for all: [`Error::NotPositive`](crate::Error::NotPositive), [`Error::Negative`](crate::Error::Negative) or [`Error::NotFinite`](crate::Error::NotFinite) for an argument, and
//! [`Error::NotFinite`](crate::Error::NotFinite) if a moment overflows.

use super::body::MassProperties;
use super::matrix::InertiaMatrix;
use super::platonic::PlatonicSolid;
use crate::error::{
    Result, each, each_finite, finite, not_negative, out_of_range, positive, within,
};
use crate::frame::BodyVector;

/// The body at the origin whose mass has the means ⟨x²⟩ = f₁a₁², ⟨y²⟩ = f₂a₂², ⟨z²⟩ = f₃a₃².
fn from_means(mass: f64, means: [(f64, f64); 3]) -> Result<MassProperties> {
    positive("the mass", mass)?;
    let mut s = [0.0; 3];
    for (s, (factor, length)) in s.iter_mut().zip(means) {
        not_negative("a length", length)?;
        *s = finite("a second moment", ((mass * length) * factor) * length)?;
    }
    let inertia = InertiaMatrix::diagonal(s[1] + s[2], s[2] + s[0], s[0] + s[1])?;
    MassProperties::new(mass, BodyVector::zero(), inertia)
}

/// A solid box with these edge lengths: M(b²+c²)/12 about the first edge, and so on (2.6, 2.7).
///
/// # Errors
/// See the [module](self).
///
/// ```
/// use spinning_bodies::inertia::shapes;
/// let brick = shapes::cuboid(12.0, [1.0, 2.0, 3.0])?;
/// assert_eq!(brick.inertia().matrix().diagonal().as_slice(), [13.0, 10.0, 5.0]);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn cuboid(mass: f64, edges: [f64; 3]) -> Result<MassProperties> {
    from_means(mass, edges.map(|edge| (1.0 / 3.0, 0.5 * edge)))
}

/// The six faces of a box, all of the same thickness and material: 5Ma²/18 for a cube (2.6).
///
/// ⟨x²⟩ = (a²/12)(1 + 2bc/(ab+bc+ca)). The edges must be positive.
///
/// # Errors
/// See the [module](self).
///
/// ```
/// use spinning_bodies::inertia::shapes;
/// let moment = shapes::hollow_box(18.0, [1.0, 1.0, 1.0])?.inertia().matrix()[(0, 0)];
/// assert!((moment - 5.0).abs() < 1e-14);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn hollow_box(mass: f64, edges: [f64; 3]) -> Result<MassProperties> {
    let shares = shares_at_ends(edges, |a, b, c| 1.0 / (1.0 + a / b + a / c))?;
    from_means(mass, combine(edges, shares))
}

/// The twelve edges of a box, all of the same wire: 7Ma²/18 for a cube (2.6).
///
/// ⟨x²⟩ = (a²/12)(1 + 2(b+c)/(a+b+c)). The edges must be positive.
///
/// # Errors
/// See the [module](self).
///
/// ```
/// use spinning_bodies::inertia::shapes;
/// let moment = shapes::wire_box(18.0, [1.0, 1.0, 1.0])?.inertia().matrix()[(0, 0)];
/// assert!((moment - 7.0).abs() < 1e-14);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn wire_box(mass: f64, edges: [f64; 3]) -> Result<MassProperties> {
    let shares = shares_at_ends(edges, |a, b, c| 1.0 / (1.0 + 0.5 * a / (0.5 * b + 0.5 * c)))?;
    from_means(mass, combine(edges, shares))
}

/// For each edge direction, the share of the mass at its two ends.
fn shares_at_ends(edges: [f64; 3], share: impl Fn(f64, f64, f64) -> f64) -> Result<[f64; 3]> {
    each(positive, "an edge", edges)?;
    let [a, b, c] = edges;
    Ok([share(a, b, c), share(b, c, a), share(c, a, b)])
}

/// In units of the half-edge squared, mass spread evenly along an edge has mean square 1/3, mass at its ends 1.
fn combine(edges: [f64; 3], at_ends: [f64; 3]) -> [(f64, f64); 3] {
    [0, 1, 2].map(|i| ((1.0 + 2.0 * at_ends[i]) / 3.0, 0.5 * edges[i]))
}

/// A solid ball: 2MR²/5 (2.7).
///
/// # Errors
/// See the [module](self).
///
/// ```
/// use spinning_bodies::inertia::shapes;
/// assert_eq!(shapes::ball(5.0, 2.0)?.inertia().matrix()[(0, 0)], 8.0);
/// // The lightest and greatest of balls.
/// assert!((shapes::ball(5e-324, 1e200)?.inertia().matrix()[(0, 0)] / (0.4 * (5e-324 * 1e200) * 1e200) - 1.0).abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn ball(mass: f64, radius: f64) -> Result<MassProperties> {
    from_means(mass, [(0.2, radius); 3])
}

/// A thin spherical shell: 2MR²/3 (2.7).
///
/// # Errors
/// See the [module](self).
///
/// ```
/// use spinning_bodies::inertia::shapes;
/// assert_eq!(shapes::spherical_shell(3.0, 2.0)?.inertia().matrix()[(0, 0)], 8.0);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn spherical_shell(mass: f64, radius: f64) -> Result<MassProperties> {
    from_means(mass, [(1.0 / 3.0, radius); 3])
}

/// A ball with a concentric cavity: (2/5)MR²·(1−s⁵)/(1−s³), s = inner/outer (2.7).
///
/// The common factor 1−s is divided out, (1+s+s²+s³+s⁴)/(1+s+s²), so the formula is as good for a thin shell
/// as for a thick one: `inner` = 0 is [`ball`], `inner` = `outer` is [`spherical_shell`], both to rounding.
///
/// # Errors
/// See the [module](self); `outer` must be positive, and [`Error::OutOfRange`](crate::Error::OutOfRange) unless 0 ≤ `inner` ≤ `outer`.
///
/// ```
/// use spinning_bodies::inertia::shapes;
/// // Without a cavity it is the ball, with a cavity as large as itself the thin shell.
/// assert_eq!(shapes::thick_shell(5.0, 0.0, 2.0)?, shapes::ball(5.0, 2.0)?);
/// assert!((shapes::thick_shell(3.0, 2.0, 2.0)?.inertia().matrix()[(0, 0)] - 8.0).abs() < 1e-14);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn thick_shell(mass: f64, inner: f64, outer: f64) -> Result<MassProperties> {
    let s = ratio(["the inner radius", "the outer radius"], inner, outer)?;
    let numerator = 1.0 + s * (1.0 + s * (1.0 + s * (1.0 + s)));
    let factor = numerator / (5.0 * (1.0 + s * (1.0 + s)));
    from_means(mass, [(factor, outer); 3])
}

/// The ratio of an inner to an outer radius, which must lie between 0 and 1; their names are for the errors.
fn ratio([inside, outside]: [&'static str; 2], less: f64, greater: f64) -> Result<f64> {
    positive(outside, greater)?;
    not_negative(inside, less)?;
    within(inside, less, 0.0, greater)?;
    Ok(less / greater)
}

/// A solid ellipsoid with these semi-axes: M(b²+c²)/5 about the first, and so on (2.7).
///
/// # Errors
/// See the [module](self).
///
/// ```
/// use spinning_bodies::inertia::shapes;
/// let moments = shapes::ellipsoid(5.0, [1.0, 2.0, 3.0])?.inertia().matrix().diagonal();
/// assert_eq!(moments.as_slice(), [13.0, 10.0, 5.0]);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn ellipsoid(mass: f64, semi_axes: [f64; 3]) -> Result<MassProperties> {
    from_means(mass, semi_axes.map(|a| (0.2, a)))
}

/// A solid circular cylinder: MR²/2 about its axis, M(R²/4 + h²/12) across (2.6, 2.7).
///
/// # Errors
/// See the [module](self).
///
/// ```
/// use spinning_bodies::inertia::shapes;
/// let moments = shapes::cylinder(12.0, 1.0, 3.0)?.inertia().matrix().diagonal();
/// assert_eq!(moments.as_slice(), [12.0, 12.0, 6.0]);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn cylinder(mass: f64, radius: f64, height: f64) -> Result<MassProperties> {
    elliptic_cylinder(mass, [radius; 2], height)
}

/// A solid cylinder on an ellipse with these semi-axes: M(a²+b²)/4 about its axis, M(b²/4 + h²/12) about the a-axis (2.7).
///
/// # Errors
/// See the [module](self).
///
/// ```
/// use spinning_bodies::inertia::shapes;
/// let moments = shapes::elliptic_cylinder(12.0, [1.0, 2.0], 1.0)?.inertia().matrix().diagonal();
/// assert_eq!(moments.as_slice(), [13.0, 4.0, 15.0]);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn elliptic_cylinder(mass: f64, [a, b]: [f64; 2], height: f64) -> Result<MassProperties> {
    from_means(mass, [(0.25, a), (0.25, b), (1.0 / 3.0, 0.5 * height)])
}

/// A thin straight rod along z: Ml²/12 across, nothing about itself (2.7).
///
/// # Errors
/// See the [module](self).
///
/// ```
/// use spinning_bodies::inertia::shapes;
/// let moments = shapes::rod(12.0, 2.0)?.inertia().matrix().diagonal();
/// assert_eq!(moments.as_slice(), [4.0, 4.0, 0.0]);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn rod(mass: f64, length: f64) -> Result<MassProperties> {
    let thin = (0.0, 0.0);
    from_means(mass, [thin, thin, (1.0 / 3.0, 0.5 * length)])
}

/// A thin hoop in the plane of x and y: MR² about its axis, MR²/2 about a diameter.
///
/// # Errors
/// See the [module](self).
///
/// ```
/// use spinning_bodies::inertia::shapes;
/// let moments = shapes::hoop(2.0, 3.0)?.inertia().matrix().diagonal();
/// assert_eq!(moments.as_slice(), [9.0, 9.0, 18.0]);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn hoop(mass: f64, radius: f64) -> Result<MassProperties> {
    from_means(mass, [(0.5, radius), (0.5, radius), (0.0, 0.0)])
}

/// A flat disc in the plane of x and y: MR²/2 about its axis, MR²/4 about a diameter (2.7).
///
/// # Errors
/// See the [module](self).
///
/// ```
/// use spinning_bodies::inertia::shapes;
/// let moments = shapes::disc(4.0, 1.0)?.inertia().matrix().diagonal();
/// assert_eq!(moments.as_slice(), [1.0, 1.0, 2.0]);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn disc(mass: f64, radius: f64) -> Result<MassProperties> {
    cylinder(mass, radius, 0.0)
}

/// A solid circular cone, apex up: 3MR²/10 about its axis (2.7); the base is h/4 below the origin.
///
/// Across, through the centre of mass: 3M(R² + h²/4)/20.
///
/// # Errors
/// See the [module](self).
///
/// ```
/// use spinning_bodies::inertia::shapes;
/// let cone = shapes::cone(10.0, 1.0, 2.0)?;
/// assert!((cone.inertia().matrix()[(2, 2)] - 3.0).abs() < 1e-14);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn cone(mass: f64, radius: f64, height: f64) -> Result<MassProperties> {
    let round = (0.15, radius);
    from_means(mass, [round, round, (0.15, 0.5 * height)])
}

/// A solid ball without the cap above a plane, `cut` over the ball's centre (below it if negative): 2MR²/5 about its axis for half a ball (2.7).
///
/// The origin is the centre of the ball, and the centre of mass below it. With h = R + `cut`, s = h/R and V = πh²(R − h/3): ⟨x²⟩ =
/// R²s(4/3 − s + s²/5)/(4 − 4s/3); the centre of mass is ¾R(2 − s)²/(3 − s) below the ball's, and the mean square distance from it along the
/// axis R²s²(1/18 − s/30 + s²/240)/(1 − s/3)².
///
/// # Errors
/// See the [module](self); the radius must be positive, and [`Error::OutOfRange`](crate::Error::OutOfRange) unless −R < `cut` ≤ R.
///
/// ```
/// use spinning_bodies::inertia::shapes;
/// // Half a ball has the moment of a whole one of the same mass about its axis; its centre lies 3R/8 below the plane.
/// let half = shapes::ball_without_cap(5.0, 8.0, 0.0)?;
/// assert!((half.inertia().matrix()[(2, 2)] - 128.0).abs() < 1e-12);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn ball_without_cap(mass: f64, radius: f64, cut: f64) -> Result<MassProperties> {
    positive("the radius", radius)?;
    let cut = finite("the height of the cut", cut)?;
    if !(-radius < cut && cut <= radius) {
        return Err(out_of_range(
            "the height of the cut",
            cut,
            [-radius, radius],
        ));
    }
    // The sum first: of a thin cap all the digits are in it. Halves of the greatest radii can be added.
    let s = (0.5 * radius + 0.5 * cut) / (0.5 * radius);
    let full = 1.0 - s / 3.0;
    let across = s * (4.0 / 3.0 + s * (s / 5.0 - 1.0)) / (4.0 * full);
    let along = s * s * (1.0 / 18.0 + s * (s / 240.0 - 1.0 / 30.0)) / (full * full);
    let round = (across, radius);
    let body = from_means(mass, [round, round, (along, radius)])?;
    let missing = (0.5 * radius - 0.5 * cut) / (0.5 * radius);
    let center = -0.75 * missing * missing / (1.0 + missing);
    body.moved(BodyVector::new(0.0, 0.0, center * radius))
}

/// A tennis racket of one wire: a ring of radius `head` in the plane of x and y, and a straight handle that goes on outward along −x.
///
/// The origin is the centre of the ring; axis 1 is along the handle, axis 3 normal to the plane. Composed of a [`hoop`] and a [`rod`].
///
/// # Errors
/// See the [module](self).
///
/// ```
/// use spinning_bodies::inertia::shapes;
/// // Flat: the moment about the normal is the sum of the other two.
/// let moments = shapes::racket(0.3, 0.13, 0.4)?.inertia().principal_axes().moments;
/// assert!((moments[2] - moments[0] - moments[1]).abs() < 1e-15 * moments[2]);
/// // A handle of next to no length: its share of the wire times −R.
/// let center = shapes::racket(1.0, 1.0, 1e-20)?.center().x();
/// assert!((center * std::f64::consts::TAU / -1e-20 - 1.0).abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn racket(mass: f64, head: f64, handle: f64) -> Result<MassProperties> {
    positive("the radius of the head", head)?;
    not_negative("the length of the handle", handle)?;
    let ring = core::f64::consts::TAU * head;
    let share = |length: f64| mass * (length / (ring + handle));
    if share(handle) == 0.0 {
        return hoop(mass, head);
    }
    let (along, thin) = ((1.0 / 3.0, 0.5 * handle), (0.0, 0.0));
    let rod = from_means(share(handle), [along, thin, thin])?;
    let rod = rod.moved(BodyVector::new(-(head + 0.5 * handle), 0.0, 0.0))?;
    if share(ring) == 0.0 {
        return Ok(rod);
    }
    MassProperties::compose(&[hoop(share(ring), head)?, rod])
}

/// A solid ring torus, tube radius r around a circle of radius R: M(R² + 3r²/4) about its axis.
///
/// About a diameter: M(R²/2 + 5r²/8).
///
/// # Errors
/// See the [module](self); [`Error::OutOfRange`](crate::Error::OutOfRange) unless 0 ≤ `tube_radius` ≤ `ring_radius`.
///
/// ```
/// use spinning_bodies::inertia::shapes;
/// let moment = shapes::torus(4.0, 2.0, 1.0)?.inertia().matrix()[(2, 2)];
/// assert_eq!(moment, 19.0);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn torus(mass: f64, ring_radius: f64, tube_radius: f64) -> Result<MassProperties> {
    let names = ["the radius of the tube", "the radius of the ring"];
    let s = ratio(names, tube_radius, ring_radius)?;
    let round = (0.5 + 0.375 * s * s, ring_radius);
    from_means(mass, [round, round, (0.25, tube_radius)])
}

/// A rectangular lamina with these edge lengths: normal M(a²+b²)/12 (2.7).
///
/// # Errors
/// See the [module](self).
///
/// ```
/// use spinning_bodies::inertia::shapes;
/// let moments = shapes::rectangle_lamina(12.0, [1.0, 2.0])?.inertia().matrix().diagonal();
/// assert_eq!(moments.as_slice(), [4.0, 1.0, 5.0]);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn rectangle_lamina(mass: f64, edges: [f64; 2]) -> Result<MassProperties> {
    cuboid(mass, [edges[0], edges[1], 0.0])
}

/// An elliptic lamina with these semi-axes: normal M(a²+b²)/4, about the a-axis Mb²/4 (2.7).
///
/// # Errors
/// See the [module](self).
///
/// ```
/// use spinning_bodies::inertia::shapes;
/// let moments = shapes::ellipse_lamina(4.0, [1.0, 2.0])?.inertia().matrix().diagonal();
/// assert_eq!(moments.as_slice(), [4.0, 1.0, 5.0]);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn ellipse_lamina(mass: f64, semi_axes: [f64; 2]) -> Result<MassProperties> {
    let [a, b] = semi_axes;
    from_means(mass, [(0.25, a), (0.25, b), (0.0, 0.0)])
}

/// A triangular lamina with these corners in the plane of x and y (2.6).
///
/// With corners p_i about the centroid, ∫x xᵀρ = (M/12) Σ p_i p_iᵀ; for an equilateral triangle Ma²/24 in the plane,
/// Ma²/12 normal to it. The corners are subtracted from each other before anything is multiplied.
///
/// # Errors
/// See the [module](self). A flat triangle is a rod and allowed.
///
/// ```
/// use spinning_bodies::inertia::shapes;
/// let triangle = shapes::triangle_lamina(36.0, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])?;
/// assert!((triangle.inertia().matrix()[(0, 0)] - 2.0).abs() < 1e-14);
/// assert!((triangle.center().x() - 1.0 / 3.0).abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn triangle_lamina(mass: f64, corners: [[f64; 2]; 3]) -> Result<MassProperties> {
    positive("the mass", mass)?;
    each_finite("a corner of the triangle", corners.into_iter().flatten())?;
    let [a, b, c] = corners;
    let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
    let centroid = [(u[0] + v[0]) / 3.0, (u[1] + v[1]) / 3.0];
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    for corner in [[0.0, 0.0], u, v] {
        let p = [corner[0] - centroid[0], corner[1] - centroid[1]];
        xx += ((mass * p[0]) / 12.0) * p[0];
        xy += ((mass * p[0]) / 12.0) * p[1];
        yy += ((mass * p[1]) / 12.0) * p[1];
    }
    let matrix = nalgebra::Matrix3::new(yy, -xy, 0.0, -xy, xx, 0.0, 0.0, 0.0, xx + yy);
    let center = BodyVector::new(a[0] + centroid[0], a[1] + centroid[1], 0.0);
    MassProperties::new(mass, center, InertiaMatrix::checked(matrix)?)
}

/// A solid Platonic body with this edge length, an inertial ball (2.6): I/(Ma²) is 1/20, 1/6, 1/10, (95 + 39√5)/300, (3 + √5)/20 by number of faces.
///
/// # Errors
/// See the [module](self).
///
/// ```
/// use spinning_bodies::inertia::{PlatonicSolid, shapes};
/// let cube = shapes::platonic(PlatonicSolid::Cube, 6.0, 1.0)?;
/// assert!((cube.inertia().matrix()[(0, 0)] - 1.0).abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn platonic(solid: PlatonicSolid, mass: f64, edge: f64) -> Result<MassProperties> {
    from_means(mass, [(0.5 * solid.inertia_factor(), edge); 3])
}
