//! Principal moments and axes of a symmetric matrix (tutorial 2.4).

use nalgebra::Matrix3;

use crate::error::{Error, Result, finite};

/// Principal moments, ascending, and principal axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrincipalAxes {
    moments: [f64; 3],
    axes: Matrix3<f64>,
}

impl PrincipalAxes {
    /// The principal moments, ascending, kg m².
    pub const fn moments(&self) -> [f64; 3] {
        self.moments
    }

    /// The principal axes as columns, unit vectors in the order of the moments, right-handed.
    pub const fn axes(&self) -> Matrix3<f64> {
        self.axes
    }

    /// The moments as [`PrincipalMoments`](super::PrincipalMoments), pulled onto I₁ ≥ 0 and I₁ + I₂ ≥ I₃
    /// where rounding carried them across.
    pub fn principal_moments(&self) -> super::PrincipalMoments {
        super::PrincipalMoments::nearest(self.moments)
    }
}

/// Eigenvalues, ascending, and eigenvectors of any finite symmetric matrix.
///
/// # Errors
/// [`Error::NotFinite`], [`Error::NotSymmetric`] (mirror entries must agree exactly).
pub fn principal_axes_of(matrix: &Matrix3<f64>) -> Result<PrincipalAxes> {
    for entry in matrix.iter() {
        finite("an entry of the matrix", *entry)?;
    }
    for (row, column) in [(0, 1), (0, 2), (1, 2)] {
        let (upper, lower) = (matrix[(row, column)], matrix[(column, row)]);
        if upper != lower {
            return Err(Error::NotSymmetric {
                row,
                column,
                upper,
                lower,
            });
        }
    }
    Ok(symmetric_axes(matrix))
}

/// Cyclic Jacobi rotations on the matrix scaled by a power of two.
pub(super) fn symmetric_axes(matrix: &Matrix3<f64>) -> PrincipalAxes {
    let largest = matrix.amax();
    let scale = if largest > 0.0 { largest } else { 1.0 };
    let mut a = matrix / scale;
    let mut v = Matrix3::<f64>::identity();
    for _ in 0..30 {
        if a[(0, 1)] == 0.0 && a[(0, 2)] == 0.0 && a[(1, 2)] == 0.0 {
            break;
        }
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            let off = a[(p, q)];
            if off.abs() < 1e-40 {
                a[(p, q)] = 0.0;
                a[(q, p)] = 0.0;
                continue;
            }
            let theta = (a[(q, q)] - a[(p, p)]) / (2.0 * off);
            let t = theta.signum() / (theta.abs() + theta.hypot(1.0));
            let c = 1.0 / t.hypot(1.0);
            let s = t * c;
            let mut g = Matrix3::identity();
            (g[(p, p)], g[(q, q)], g[(p, q)], g[(q, p)]) = (c, c, s, -s);
            a = g.transpose() * a * g;
            v *= g;
        }
    }
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| a[(i, i)].total_cmp(&a[(j, j)]));
    let moments = order.map(|i| a[(i, i)] * scale);
    let mut axes = Matrix3::from_columns(&order.map(|i| v.column(i).into_owned()));
    if axes.determinant() < 0.0 {
        let flipped = -axes.column(2);
        axes.set_column(2, &flipped);
    }
    PrincipalAxes { moments, axes }
}
