//! Meshes read from files: STL and OBJ.

use std::collections::HashMap;

use super::icosphere::Mesh;
use crate::error::{Error, Result, each_finite, not_empty, refused};

/// The mesh of an STL file, text or binary. Corners with the same coordinates become one vertex.
///
/// # Errors
/// [`Error::AtPlace`] for a corner whose coordinates are not numbers, [`Error::Empty`] for a file without a triangle, [`Error::Condition`] for one that is
/// neither text nor of the length that its count of triangles asks for.
///
/// ```
/// use spinning_bodies::inertia::mesh_of_stl;
/// let text = "solid one\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop";
/// let (vertices, triangles) = mesh_of_stl(text.as_bytes())?;
/// assert_eq!((vertices.len(), triangles), (3, vec![[0, 1, 2]]));
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn mesh_of_stl(bytes: &[u8]) -> Result<Mesh> {
    let count = bytes.get(80..84).and_then(|count| count.try_into().ok());
    let count = count.map_or(0, |count| u32::from_le_bytes(count) as usize);
    let binary = bytes.len() == 84 + 50 * count;
    let corners: Vec<Result<[f64; 3]>> = if binary {
        let coordinate = |at: &[u8]| <[u8; 4]>::try_from(at).map_or(f32::NAN, f32::from_le_bytes);
        // A triangle has fifty bytes: twelve for its normal, 36 for its corners, two without a meaning.
        let triangles = bytes[84..].chunks_exact(50);
        let corners = triangles.flat_map(|triangle| triangle[12..48].chunks_exact(12));
        let corner = |corner: &[u8]| [0, 4, 8].map(|k| f64::from(coordinate(&corner[k..k + 4])));
        corners.map(|at| checked(corner(at))).collect()
    } else {
        // Line breaks carry no meaning: a file may be a single line. The solid's name, of any words but `facet`, comes before the first facet.
        let text = String::from_utf8_lossy(bytes);
        let mut words = text.split_whitespace().skip_while(|word| *word != "facet");
        let mut corners = Vec::new();
        while words.any(|word| word == "vertex") {
            corners.push(coordinates(words.by_ref()));
        }
        corners
    };
    let text = bytes.trim_ascii_start().starts_with(b"solid");
    if corners.is_empty() && !binary && !text && !bytes.is_empty() {
        let condition = "an STL file must be text that begins with `solid`, or have 84 bytes and 50 for each triangle that it counts";
        return refused(condition, bytes.len() as f64);
    }
    not_empty("the list of triangles", &corners)?;
    let mut known = HashMap::new();
    let mut vertices = Vec::new();
    let mut indices = Vec::new();
    for (place, corner) in corners.into_iter().enumerate() {
        let corner = at_place(place, corner)?;
        // Adding 0.0 makes −0 and +0 the same key.
        let index = *known
            .entry(corner.map(|x| (x + 0.0).to_bits()))
            .or_insert_with(|| {
                vertices.push(corner);
                vertices.len() as u32 - 1
            });
        indices.push(index);
    }
    let triangles = indices
        .chunks_exact(3)
        .map(|corners| [corners[0], corners[1], corners[2]]);
    Ok((vertices, triangles.collect()))
}

/// The mesh of an OBJ file: its vertices and faces, and nothing else that it holds. Faces with more than three corners are cut into triangles from the first corner.
///
/// # Errors
/// [`Error::AtPlace`] for a vertex whose coordinates are not numbers, and for a face without three vertex numbers.
///
/// ```
/// use spinning_bodies::inertia::mesh_of_obj;
/// let (vertices, triangles) = mesh_of_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")?;
/// assert_eq!((vertices.len(), triangles), (4, vec![[0, 1, 2], [0, 2, 3]]));
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn mesh_of_obj(text: &str) -> Result<Mesh> {
    let (mut vertices, mut triangles, mut faces) = (Vec::new(), Vec::new(), 0);
    for line in text.lines() {
        let said = line.split('#').next().unwrap_or_default();
        let mut words = said.split_whitespace();
        let kind = words.next();
        if kind == Some("v") {
            vertices.push(at_place(vertices.len(), coordinates(words))?);
        } else if kind == Some("f") {
            // Numbers count from 1; negative ones count back from the latest vertex.
            let index = |corner: &str| match corner.split('/').next()?.parse::<i64>().ok()? {
                number if number < 0 => u32::try_from(vertices.len() as i64 + number).ok(),
                number => u32::try_from(number - 1).ok(),
            };
            let given = words.clone().count();
            let corners: Vec<u32> = words.filter_map(index).collect();
            if corners.len() < given.max(3) {
                let condition = "a face must have three vertices or more, numbered from 1 or, negative, back from the last";
                return at_place(faces, refused(condition, corners.len() as f64));
            }
            faces += 1;
            let fan = corners[1..].windows(2);
            triangles.extend(fan.map(|pair| [corners[0], pair[0], pair[1]]));
        }
    }
    Ok((vertices, triangles))
}

fn coordinates<'a>(mut words: impl Iterator<Item = &'a str>) -> Result<[f64; 3]> {
    let mut next = || {
        words
            .next()
            .and_then(|word| word.parse().ok())
            .unwrap_or(f64::NAN)
    };
    checked([next(), next(), next()])
}

fn checked(corner: [f64; 3]) -> Result<[f64; 3]> {
    each_finite("a coordinate of a vertex", corner)?;
    Ok(corner)
}

fn at_place<T>(place: usize, given: Result<T>) -> Result<T> {
    given.map_err(|reason| Error::AtPlace {
        place,
        reason: Box::new(reason),
    })
}
