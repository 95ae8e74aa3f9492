//! The ten sums over the triangles, and the check of the edges in the same pass.

use nalgebra::Vector3;

use crate::error::{Error, Result, each_finite};
use crate::precise::{Extended, Number, power, shifted};

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

/// The unit in which the sums are formed: coordinates are multiplied by `shrink`, then their difference by 2^-exponent.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scale {
    /// 1, or 1/4 for coordinates whose difference would overflow.
    shrink: f64,
    /// 2^-exponent as a product of two factors, since it may itself be out of range.
    factors: [f64; 2],
    /// The unit is 2^exponent metres.
    exponent: i32,
}

impl Scale {
    /// The metre.
    pub(super) const ONE: Self = Self {
        shrink: 1.0,
        factors: [1.0; 2],
        exponent: 0,
    };

    /// The power of two next to the size of the mesh. All coordinates and indices must have been checked.
    pub(super) fn fitting(surface: &Surface) -> Self {
        let pairs = || {
            let corners = surface.corners();
            corners.flat_map(|corner| corner.into_iter().zip(surface.apex))
        };
        let farthest = pairs().fold(0.0, |m: f64, (x, _)| m.max(x.abs()));
        let (shrink, undo) = if farthest > 1e300 {
            (0.25, 2)
        } else {
            (1.0, 0)
        };
        let size = pairs().fold(0.0, |m: f64, (x, o)| m.max((x * shrink - o * shrink).abs()));
        if size == 0.0 {
            return Self::ONE;
        }
        let exponent = Extended::from_double(size).exponent;
        let half = exponent / 2;
        Self {
            shrink,
            factors: [power(-half), power(half - exponent)],
            exponent: exponent + undo,
        }
    }

    /// A sum of degree `degree` in the lengths, converted back to metres.
    pub(super) fn restore(self, value: f64, degree: i32) -> f64 {
        self.restore_times(1.0, value, degree)
    }

    /// The same, times a positive density: in range wherever the result is.
    pub(super) fn restore_times(self, density: f64, value: f64, degree: i32) -> f64 {
        let density = Extended::from_double(density);
        let exponent = self.exponent * degree + density.exponent;
        shifted(value * density.digits.high(), exponent)
    }

    /// Corner minus apex, in this unit.
    #[inline(always)]
    fn relative(self, corner: [f64; 3], apex: [f64; 3]) -> [f64; 3] {
        let [f, g] = self.factors;
        [0, 1, 2].map(|i| (corner[i] * self.shrink - apex[i] * self.shrink) * f * g)
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
    pub(super) fn sums(&self, scale: Scale) -> Result<Sums> {
        let apex = self.apex;
        if scale.exponent == 0 && scale.shrink == 1.0 {
            self.gather(|corner| [0, 1, 2].map(|i| corner[i] - apex[i]))
        } else {
            self.gather(|corner| scale.relative(corner, apex))
        }
        .ok_or_else(|| self.bad_index())
    }

    /// Three levels of summation: triangles into blocks, blocks into groups, groups into the total; `None` if a triangle names a vertex that does not exist.
    fn gather(&self, relative: impl Fn([f64; 3]) -> [f64; 3] + Copy) -> Option<Sums> {
        let mut total = Sums::default();
        for group in self.triangles.chunks(BLOCK * BLOCKS) {
            let mut sum = Sums::default();
            for block in group.chunks(BLOCK) {
                sum.add(&block_sums(self.vertices, block, relative)?);
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

    /// Bound on the rounding error of six times the volume: 8 eps times the sum of |p| |q| |r|, whichever way the mesh is turned.
    ///
    /// The products of a determinant add up to at most 2/√3 of |p| |q| |r|. Three roundings each, one for each difference of coordinates, make 6 eps.
    pub(super) fn largest_rounding_of_volume(&self, scale: Scale) -> f64 {
        let mut bound = 0.0;
        for corners in self.triangles {
            let [p, q, r] = corners.map(|index| {
                let corner = self.vertices[index as usize];
                Vector3::from(scale.relative(corner, self.apex)).norm()
            });
            bound += p * q * r;
        }
        8.0 * f64::EPSILON * bound
    }
}

/// The sums over one block of triangles.
#[inline(always)]
fn block_sums(
    vertices: &[[f64; 3]],
    block: &[[u32; 3]],
    relative: impl Fn([f64; 3]) -> [f64; 3],
) -> Option<Sums> {
    let mut sums = Sums::default();
    for &[a, b, c] in block {
        let p = relative(*vertices.get(a as usize)?);
        let q = relative(*vertices.get(b as usize)?);
        let r = relative(*vertices.get(c as usize)?);
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
        sums.edges = sums
            .edges
            .wrapping_add(edge(a, b))
            .wrapping_add(edge(b, c))
            .wrapping_add(edge(c, a));
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
