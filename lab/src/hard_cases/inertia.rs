//! Moments of inertia of a distant body, and of a needle.

use nalgebra::Matrix3;

use super::family::{Family, numbers};
use spinning_bodies::Result;
use spinning_bodies::frame::BodyVector;
use spinning_bodies::inertia::{mesh_mass_properties, principal_axes_of};

pub(super) const FAR_MESH: Family = Family {
    name: "far-mesh",
    paragraph: "2.8",
    quantity: "a moment about the centre, of a tetrahedron far from the origin",
    lost: "the moment about the origin less *Mr*²",
    printed: r"I_O-Mr^2",
    cure: r"\text{sums of }\mathbf r-\mathbf r_0,\;\mathbf r_0\text{ a corner}",
    textbook: steiner,
    ours: |inputs| {
        let properties = mesh_mass_properties(&corners(numbers(inputs)?), &FACES, 1.0)?;
        let upright = BodyVector::new(0.0, 0.0, 1.0);
        Ok(vec![properties.inertia().moment_about(upright)?])
    },
};

pub(super) const NEEDLE: Family = Family {
    name: "needle",
    paragraph: "2.4",
    quantity: "the least principal moment of a needle",
    lost: "the cosines of a cubic whose roots are not of one size",
    printed: r"\tfrac13\operatorname{tr}I+2p\cos\tfrac{\psi+2\pi}3",
    cure: r"\tfrac{\det I}{I_2I_3}",
    textbook: |inputs| Ok(vec![least_root(&matrix(numbers(inputs)?))]),
    ours: |inputs| {
        let [least, ..] = principal_axes_of(&matrix(numbers(inputs)?))?.moments;
        Ok(vec![least])
    },
};

const FACES: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

/// A tetrahedron, displaced by the same distance along each axis.
fn corners([away]: [f64; 1]) -> [[f64; 3]; 4] {
    let near = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.25, 1.0, 0.0],
        [0.25, 0.5, 1.0],
    ];
    near.map(|corner| corner.map(|x| x + away))
}

/// ∫(x² + y²)dV about the origin, less V(X² + Y²): the parallel axis theorem, applied in reverse.
fn steiner(inputs: &[f64]) -> Result<Vec<f64>> {
    let corners = corners(numbers(inputs)?);
    let (mut volume, mut first, mut about_origin) = (0.0, [0.0; 2], 0.0);
    for face in FACES {
        let corner = face.map(|n| corners[n as usize]);
        let part = Matrix3::from(corner).determinant() / 6.0;
        volume += part;
        for k in 0..2 {
            let sum: f64 = corner.iter().map(|p| p[k]).sum();
            let squares: f64 = corner.iter().map(|p| p[k] * p[k]).sum();
            first[k] += part * sum / 4.0;
            about_origin += part / 20.0 * (squares + sum * sum);
        }
    }
    let squares = (first[0] * first[0] + first[1] * first[1]) / volume;
    Ok(vec![about_origin - squares])
}

/// The matrix with the entries xx yy zz xy xz yz.
fn matrix([x, y, z, xy, xz, yz]: [f64; 6]) -> Matrix3<f64> {
    Matrix3::new(x, xy, xz, xy, y, yz, xz, yz, z)
}

/// The least root of the characteristic cubic, by cosines.
fn least_root(a: &Matrix3<f64>) -> f64 {
    let mean = a.trace() / 3.0;
    let rest = a - Matrix3::identity() * mean;
    let spread = ((rest * rest).trace() / 6.0).sqrt();
    let cosine = (rest / spread).determinant() / 2.0;
    let third = cosine.clamp(-1.0, 1.0).acos() / 3.0;
    mean + 2.0 * spread * (third + core::f64::consts::TAU / 3.0).cos()
}
