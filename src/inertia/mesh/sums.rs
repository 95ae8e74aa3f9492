//! The ten sums over the triangles, and the check of the edges in the same pass.

use nalgebra::Vector3;

use crate::error::{Error, Result, each_finite};
use crate::precise::{exponent_of, power, power_of_two_below};

/// Triangles gathered in registers before they are added to the next level.
const BLOCK: usize = 128;
/// Blocks gathered before they are added to the total.
const BLOCKS: usize = 128;

/// The entries of a symmetric matrix, those of its diagonal first.
pub(super) const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// Sums over triangles with corners p, q, r from the apex, d = det(p, q, r), s = p + q + r.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Sums {
    /// Σ d: six times the volume.
    pub determinant: f64,
    /// Σ d s: 24 times ∫x dV.
    pub first: [f64; 3],
    /// Σ d (s sᵀ + p pᵀ + q qᵀ + r rᵀ), entries xx, yy, zz, xy, xz, yz: 120 times ∫x xᵀ dV.
    pub second: [f64; 6],
    /// Signed hash of the edges: zero if each is run along equally often in both directions.
    pub edges: u64,
}

impl Sums {
    /// Adds another set of sums.
    fn add(&mut self, other: &Self) {
        self.determinant += other.determinant;
        for (sum, term) in self.first.iter_mut().zip(other.first) {
            *sum += term;
        }
        for (sum, term) in self.second.iter_mut().zip(other.second) {
            *sum += term;
        }
        self.edges = self.edges.wrapping_add(other.edges);
    }

    /// Σ d(…)/20 over the diagonal: (tr S)·6, so that its ratio to `determinant` is the mean square distance.
    pub(super) fn trace(&self) -> f64 {
        (self.second[0] + self.second[1] + self.second[2]) / 20.0
    }

    /// Whether no sum has overflowed, and none that matters has lost digits to underflow.
    pub(super) fn in_normal_range(&self) -> bool {
        // A term that underflows is wrong by 5e-324; against 1e-280 that is nothing, for any number of triangles.
        let safe = 1e-280..1e300;
        safe.contains(&self.determinant.abs())
            && self.second[..3].iter().all(|sum| sum.is_finite())
            && self.second.iter().any(|sum| safe.contains(&sum.abs()))
            && self.first.iter().all(|sum| sum.is_finite())
    }
}

/// A mesh, and the vertex that is the apex of all its tetrahedra.
#[derive(Debug, Clone, Copy)]
pub(super) struct Surface<'a> {
    pub vertices: &'a [[f64; 3]],
    pub triangles: &'a [[u32; 3]],
    pub apex: [f64; 3],
}

impl Surface<'_> {
    /// One pass over the triangles.
    pub(super) fn sums(&self) -> Result<Sums> {
        self.gathered().ok_or_else(|| self.bad_index())
    }

    /// Three levels of summation: triangles into blocks, blocks into groups, groups into the total; `None` if a triangle names a vertex that does not exist.
    fn gathered(self) -> Option<Sums> {
        let mut total = Sums::default();
        for group in self.triangles.chunks(BLOCK * BLOCKS) {
            let mut sum = Sums::default();
            for block in group.chunks(BLOCK) {
                sum.add(&block_sums(self.vertices, self.apex, block)?);
            }
            total.add(&sum);
        }
        Some(total)
    }

    /// The error that names the first triangle with a vertex number out of range.
    fn bad_index(&self) -> Error {
        let vertices = self.vertices.len();
        let mut corners = self.triangles.as_flattened().iter().zip(0..);
        let bad = corners.find(|(index, _)| **index as usize >= vertices);
        // Only called after an index was out of range.
        bad.map_or(Error::OpenMesh, |(&index, place)| Error::VertexIndex {
            triangle: place / 3,
            index,
            vertices,
        })
    }

    /// The vertices of all triangles, whose numbers must have been checked.
    fn corners(&self) -> impl Iterator<Item = [f64; 3]> {
        let indices = self.triangles.as_flattened().iter();
        indices.map(|&index| self.vertices[index as usize])
    }

    /// Refuses a mesh one of whose triangles has a corner that is not finite.
    pub(super) fn all_finite(&self) -> Result<()> {
        each_finite("a coordinate of a vertex", self.corners().flatten())
    }

    /// The vertices from the apex in a unit next to the size of the mesh, 2^exponent metres. All coordinates and indices must have been checked.
    pub(super) fn scaled(&self) -> (Vec<[f64; 3]>, i32) {
        let greater = |most: f64, x: f64| most.max(x.abs());
        let farthest = self.corners().flatten().fold(0.0, greater);
        // The difference of two coordinates may overflow, that of their quarters cannot.
        let (shrink, undo) = if farthest > 1e300 {
            (0.25, 2)
        } else {
            (1.0, 0)
        };
        let relative =
            |corner: [f64; 3]| [0, 1, 2].map(|i| corner[i] * shrink - self.apex[i] * shrink);
        let distances = self.corners().flat_map(relative);
        let size = distances.fold(f64::MIN_POSITIVE, greater);
        let exponent = exponent_of(power_of_two_below(size));
        // In two factors, since it may itself be out of range.
        let [f, g] = [exponent / 2, exponent - exponent / 2].map(|part| power(-part));
        let vertices = self.vertices.iter().copied().map(relative);
        let scaled = vertices.map(|corner| corner.map(|x| x * f * g));
        (scaled.collect(), exponent + undo)
    }

    /// Bound on the rounding error of six times the volume: 8 eps times the sum of |p| |q| |r|, whichever way the mesh is turned.
    ///
    /// The products of a determinant add up to at most 2/√3 of |p| |q| |r|. Three roundings each, one for each difference of coordinates, make 6 eps.
    pub(super) fn largest_rounding_of_volume(&self) -> f64 {
        let apex = Vector3::from(self.apex);
        let distance = |index: u32| (Vector3::from(self.vertices[index as usize]) - apex).norm();
        let products = self.triangles.iter().map(|corners| {
            let [p, q, r] = corners.map(distance);
            p * q * r
        });
        8.0 * f64::EPSILON * products.sum::<f64>()
    }
}

/// The sums over one block of triangles.
#[inline(always)]
fn block_sums(vertices: &[[f64; 3]], apex: [f64; 3], block: &[[u32; 3]]) -> Option<Sums> {
    let from_apex = |index: u32| {
        let corner = vertices.get(index as usize)?;
        Some([0, 1, 2].map(|i| corner[i] - apex[i]))
    };
    let mut sums = Sums::default();
    for &[a, b, c] in block {
        let (p, q, r) = (from_apex(a)?, from_apex(b)?, from_apex(c)?);
        let d = p[0] * (q[1] * r[2] - q[2] * r[1])
            + p[1] * (q[2] * r[0] - q[0] * r[2])
            + p[2] * (q[0] * r[1] - q[1] * r[0]);
        let s = [0, 1, 2].map(|i| p[i] + q[i] + r[i]);
        sums.determinant += d;
        for (sum, s) in sums.first.iter_mut().zip(s) {
            *sum += d * s;
        }
        for (sum, (i, j)) in sums.second.iter_mut().zip(PAIRS) {
            *sum += d * (s[i] * s[j] + p[i] * p[j] + q[i] * q[j] + r[i] * r[j]);
        }
        let (ab, bc, ca) = (edge(a, b), edge(b, c), edge(c, a));
        sums.edges = sums
            .edges
            .wrapping_add(ab)
            .wrapping_add(bc)
            .wrapping_add(ca);
    }
    Some(sums)
}

/// Hash of the edge between two vertices, negated if it is run along from the higher number to the lower.
///
/// Not linear in the vertex numbers, so that the edges of an open mesh do not cancel by arithmetic.
#[inline(always)]
fn edge(from: u32, to: u32) -> u64 {
    let (low, high) = (from.min(to), from.max(to));
    let mut hash = ((u64::from(low) << 32) | u64::from(high)).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    hash ^= hash >> 32;
    hash = hash.wrapping_mul(0xd6e8_feb8_6659_fd93);
    hash ^= hash >> 32;
    // +1, −1, or 0 for an edge from a vertex to itself.
    let sign = u64::from(from < to).wrapping_sub(u64::from(from > to));
    hash.wrapping_mul(sign)
}
