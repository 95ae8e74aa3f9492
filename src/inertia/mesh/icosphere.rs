//! A sphere of triangles, for tests of everything that takes a mesh.

use std::collections::HashMap;

use crate::error::{Result, positive, within};
use crate::inertia::platonic::PlatonicSolid;

/// Vertices and triangles of a mesh.
pub type Mesh = (Vec<[f64; 3]>, Vec<[u32; 3]>);

/// An icosahedron with each triangle cut into four `levels` times, all vertices on the sphere: 20·4^levels triangles.
///
/// `radius` in metres. The surface lies inside the sphere by a fraction of order 4^-levels. Cost: 20·4^levels steps.
///
/// # Errors
/// [`Error::NotPositive`](crate::Error::NotPositive) or [`Error::NotFinite`](crate::Error::NotFinite) for the radius, [`Error::OutOfRange`](crate::Error::OutOfRange) for more than 10 levels (21 million
/// triangles).
///
/// ```
/// let (vertices, triangles) = spinning_bodies::inertia::icosphere(2, 1.5)?;
/// assert_eq!((vertices.len(), triangles.len()), (162, 320));
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn icosphere(levels: u32, radius: f64) -> Result<Mesh> {
    positive("the radius", radius)?;
    within("the number of levels", f64::from(levels), 0.0, 10.0)?;
    let solid = PlatonicSolid::Icosahedron;
    let mut vertices: Vec<[f64; 3]> = solid.vertices(1.0)?.into_iter().map(unit).collect();
    let mut triangles = solid.triangles();
    for _ in 0..levels {
        let mut middles = HashMap::with_capacity(triangles.len() * 3 / 2);
        let mut finer = Vec::with_capacity(4 * triangles.len());
        for [a, b, c] in triangles {
            let mut middle = |i: u32, j: u32| {
                *middles.entry((i.min(j), i.max(j))).or_insert_with(|| {
                    let (p, q) = (vertices[i as usize], vertices[j as usize]);
                    vertices.push(unit([0, 1, 2].map(|k| p[k] + q[k])));
                    vertices.len() as u32 - 1
                })
            };
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            finer.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
        }
        triangles = finer;
    }
    for vertex in &mut vertices {
        *vertex = vertex.map(|coordinate| coordinate * radius);
    }
    Ok((vertices, triangles))
}

/// The point of the unit sphere in this direction.
fn unit(point: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = point;
    let length = (x * x + y * y + z * z).sqrt();
    point.map(|coordinate| coordinate / length)
}
