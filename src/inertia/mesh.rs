//! Mass, centre and inertia of a body given by its surface: a closed mesh of triangles (tutorial 2.6, 2.7).

use nalgebra::{Matrix3, Vector3};

use super::body::MassProperties;
use super::matrix::{InertiaMatrix, SLACK_OF_SUMS};
use crate::error::{Error, Result, not_empty, positive};
use crate::frame::BodyVector;
use crate::precise::{Extended, Number, shifted};

mod formats;
mod icosphere;
mod sums;

pub use formats::{mesh_of_obj, mesh_of_stl};
pub use icosphere::{Mesh, icosphere};
use sums::{PAIRS, Sums, Surface};

/// Mass properties of the homogeneous body that a closed triangle mesh encloses (2.6, 2.7).
///
/// `vertices` in metres, `triangles` as triples of vertex numbers, counter-clockwise seen from outside, `density` in
/// kg/m³. With a vertex of the mesh as apex every triangle spans a tetrahedron, positive or negative; volume,
/// centre and second moments of a tetrahedron are polynomials of its corners, so the sum over triangles is exact but for
/// rounding, whatever the shape, convex or not.
///
/// * One pass over the triangles. The apex is subtracted before anything is multiplied, so a body a million
///   diameters from the origin loses nothing beyond the rounding of its coordinates.
/// * The ten sums are gathered in blocks, so that rounding does not grow with the number of triangles.
/// * Any size of mesh: if the sums leave the normal range they are repeated in a unit that is a power of two,
///   which rounds nothing. Only the results must be in range; a moment below 1e-308 kg m² underflows.
/// * The same pass checks that every edge is run along equally often in both directions. It adds up a signed 64-bit
///   hash of each edge; an open mesh passes with probability 2⁻⁶⁴. Triangles must share vertices: weld duplicates first.
/// * A vertex that no triangle names is ignored.
///
/// # Errors
/// [`Error::Empty`], [`Error::NotPositive`] or [`Error::NotFinite`] for the density, [`Error::VertexIndex`],
/// [`Error::NotFinite`] for a vertex, [`Error::OpenMesh`], [`Error::NoVolume`] for a flat or inside-out mesh,
/// [`Error::TriangleInequality`] or [`Error::Negative`] for a surface that crosses itself so that no body has its
/// moments.
///
/// ```
/// use spinning_bodies::inertia::mesh_mass_properties;
/// // The corner of a cube: volume 1/6, centre (1/4, 1/4, 1/4), ∫(y²+z²)dV = 1/30 about the corner.
/// let vertices = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let corner = mesh_mass_properties(&vertices, &[[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]], 6.0)?;
/// assert_eq!(corner.mass(), 1.0);
/// assert_eq!(corner.center().x(), 0.25);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn mesh_mass_properties(
    vertices: &[[f64; 3]],
    triangles: &[[u32; 3]],
    density: f64,
) -> Result<MassProperties> {
    positive("the density", density)?;
    not_empty("the list of vertices", vertices)?;
    let first = triangles.first().ok_or(Error::Empty {
        quantity: "the list of triangles",
    })?;
    // A number out of range is refused by the sums, as for every other triangle.
    let apex = vertices.get(first[0] as usize).copied().unwrap_or_default();
    let mut surface = Surface {
        vertices,
        triangles,
        apex,
    };
    let scaled;
    let mut exponent = 0;
    let mut total = surface.sums()?;
    if total.edges != 0 {
        surface.all_finite()?;
        return Err(Error::OpenMesh);
    }
    if !total.in_normal_range() {
        surface.all_finite()?;
        (scaled, exponent) = surface.scaled();
        (surface.vertices, surface.apex) = (&scaled, [0.0; 3]);
        total = surface.sums()?;
    }
    require_volume(&total, exponent, &surface)?;
    mass_properties(&total, exponent, apex, density)
}

/// Refuses a mesh whose volume is negative, or no greater than rounding can make that of a flat one. Lengths are in 2^exponent metres.
fn require_volume(total: &Sums, exponent: i32, surface: &Surface) -> Result<()> {
    let determinant = total.determinant;
    let refuse = |hint| {
        let volume = shifted(determinant / 6.0, 3 * exponent);
        Err(Error::NoVolume { volume, hint })
    };
    // Only a body that is very thin for its size can be a flat mesh plus rounding; the mean square distance from the
    // apex, (tr S)/V, tells the size.
    let size = (total.trace() / determinant).abs().sqrt();
    // False for NaN, from a determinant of zero, too.
    let clearly_solid = determinant.abs() > 1e-6 * size * size * size;
    if !clearly_solid && determinant.abs() <= surface.largest_rounding_of_volume() {
        return refuse("; its triangles lie in one plane");
    }
    if determinant < 0.0 {
        return refuse("; it is inside out: swap two vertices of every triangle");
    }
    Ok(())
}

/// Mass, centre and inertia about the centre, from the ten sums.
fn mass_properties(
    total: &Sums,
    exponent: i32,
    apex: [f64; 3],
    density: f64,
) -> Result<MassProperties> {
    let volume = total.determinant / 6.0;
    let c = total.first.map(|sum| sum / (4.0 * total.determinant));
    let about_center = |k: usize| {
        let (i, j) = PAIRS[k];
        total.second[k] / 120.0 - (volume * c[i]) * c[j]
    };
    let [xx, yy, zz] = [0, 1, 2].map(|k| about_center(k).max(0.0));
    let [xy, xz, yz] = [3, 4, 5].map(about_center);
    let matrix = Matrix3::new(yy + zz, -xy, -xz, -xy, zz + xx, -yz, -xz, -yz, xx + yy);
    // In range wherever the result is.
    let density = Extended::from_double(density);
    let (digits, unit) = (density.digits.high(), density.exponent);
    let weighed = |value: f64, degree: i32| shifted(value * digits, degree * exponent + unit);
    let mass = positive("the mass", weighed(volume, 3))?;
    let inertia = matrix.map(|entry| weighed(entry, 5));
    let center = Vector3::from(apex) + Vector3::from(c.map(|c| shifted(c, exponent)));
    MassProperties::new(
        mass,
        BodyVector::from_components(center),
        InertiaMatrix::with_slack(inertia, SLACK_OF_SUMS)?,
    )
}
