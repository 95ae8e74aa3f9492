//! Principal moments and axes of a symmetric matrix (tutorial 2.4).
//!
//! Nothing is iterated to convergence. One root of the characteristic cubic is well separated from the other two, whatever the
//! matrix; its axis comes from a cross product, the other two moments and axes from one rotation in the plane at right angles to it.
//! All of this happens on the deviator, the matrix less a third of its trace, so that nearly equal moments are computed on the scale of their
//! differences. Moments lost in the rounding of greater ones are computed again in 106 bits. After D. Eberly, "A robust eigensolver for 3×3 symmetric matrices".

use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};

use crate::error::{Error, Result, each_finite};
use crate::precise::{DoubleDouble, Extended, Number, quick};
use crate::search::ascending;

/// Principal moments, ascending, and principal axes (2.4).
///
/// Promised for every matrix: no NaN; the same answer for the same entries; axes orthonormal (largest entry of
/// VᵀV − 1 at most 1e-15) and right-handed; moments within 1e-15 times the largest of the exact ones. The smallest moment of a needle
/// is right to 1e-15 of itself where it is between 1e-16 and a sixteenth of the largest (observed: 5e-16); and every moment is right to 1e-14 of itself, however small, with
/// the axis that belongs to it, where the matrix is graded: D A D with a diagonal D and a positive A, of ones on its diagonal, of condition up to 100
/// (observed, for moments from 1e-150 to 1e150: 3e-16, but 9e-15 where the smallest is hardly more than a sixteenth of the largest). A diagonal matrix is answered exactly, with
/// coordinate axes. Where two moments coincide, their axes are any pair in their plane; where they nearly do, the
/// axes are uncertain by the rounding of the matrix over the gap between the moments.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrincipalAxes {
    /// The principal moments, ascending, kg m².
    pub moments: [f64; 3],
    /// The principal axes as columns, unit vectors in the order of the moments, right-handed.
    pub axes: Matrix3<f64>,
}

impl PrincipalAxes {
    /// The rotation that turns components along the principal axes into those along the axes of the matrix.
    pub(crate) fn turn(&self) -> UnitQuaternion<f64> {
        UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(self.axes))
    }

    /// The moments as [`PrincipalMoments`](super::PrincipalMoments), pulled onto I₁ ≥ 0 and I₁ + I₂ ≥ I₃
    /// where rounding carried them across.
    ///
    /// ```
    /// use spinning_bodies::inertia::InertiaMatrix;
    /// let moments = InertiaMatrix::diagonal(3.0, 2.0, 4.0)?.principal_axes().principal_moments();
    /// assert_eq!(moments.values(), [2.0, 3.0, 4.0]);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn principal_moments(&self) -> super::PrincipalMoments {
        super::PrincipalMoments::nearest(self.moments)
    }

    /// The same axes with negative moments set to zero: an inertia matrix has none, but rounding may make one.
    #[inline]
    pub(super) fn not_negative(mut self) -> Self {
        self.moments = self.moments.map(|moment| moment.max(0.0));
        self
    }
}

/// Eigenvalues, ascending, and eigenvectors of any finite symmetric matrix; promises as for [`PrincipalAxes`].
///
/// Inertia matrices have [`InertiaMatrix::principal_axes`](super::InertiaMatrix::principal_axes); this is for second
/// moments, stresses and the like. An eigenvalue beyond the range of numbers is returned as the largest number.
///
/// # Errors
/// [`Error::NotFinite`], [`Error::NotSymmetric`] (mirror entries must agree exactly).
///
/// ```
/// use spinning_bodies::inertia::principal_axes_of;
/// use nalgebra::Matrix3;
/// let stress = Matrix3::new(0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0);
/// let [least, middle, most] = principal_axes_of(&stress)?.moments;
/// assert!((least + 1.0).abs() < 1e-15 && middle.abs() < 1e-15 && (most - 1.0).abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn principal_axes_of(matrix: &Matrix3<f64>) -> Result<PrincipalAxes> {
    symmetric("an entry of the matrix", matrix, 0.0)?;
    if matrix.amax() < 1e300 {
        return Ok(symmetric_axes(matrix));
    }
    let quarter = symmetric_axes(&(matrix * 0.25));
    Ok(PrincipalAxes {
        moments: quarter
            .moments
            .map(|moment| (4.0 * moment).clamp(-f64::MAX, f64::MAX)),
        axes: quarter.axes,
    })
}

/// Refuses a matrix with entries that are not finite, or that differ from their mirror entries by more than `slack`.
pub(super) fn symmetric(entries: &'static str, matrix: &Matrix3<f64>, slack: f64) -> Result<()> {
    each_finite(entries, matrix.iter().copied())?;
    for (row, column) in [(0, 1), (0, 2), (1, 2)] {
        let (upper, lower) = (matrix[(row, column)], matrix[(column, row)]);
        if (upper - lower).abs() > slack {
            return Err(Error::NotSymmetric {
                row,
                column,
                upper,
                lower,
            });
        }
    }
    Ok(())
}

type V = Vector3<f64>;

/// A moment below this fraction of the largest has lost more than four bits to the rounding of the mean.
const NEEDLE: f64 = 1.0 / 16.0;

/// The least entry, of a matrix scaled to 1, such that a product of three still has a second word.
const LEAST: f64 = 1e-60;

/// Coefficients of 1, h, h², h³ of the minimax cubic for 2 cos(arccos(h)/3) on 0..1.
const GUESS: [f64; 4] = [
    1.732_132_659_066_386_4,
    0.330_660_700_441_690_1,
    -0.081_382_394_845_774_4,
    0.018_639_367_794_963_49,
];

/// Moments and axes of a finite symmetric matrix whose trace is finite; only the upper triangle is read.
pub(super) fn symmetric_axes(matrix: &Matrix3<f64>) -> PrincipalAxes {
    let (m00, m11, m22) = (matrix.m11, matrix.m22, matrix.m33);
    if matrix.m12 == 0.0 && matrix.m13 == 0.0 && matrix.m23 == 0.0 {
        return coordinate_axes([m00, m11, m22]);
    }
    // The deviator. Any number near the mean will do as the shift; the subtraction is exact where entries are close.
    let mean = (m00 + m11 + m22) * (1.0 / 3.0);
    let deviator = matrix - Matrix3::from_diagonal_element(mean);
    let scales = |of: &Matrix3<f64>| {
        powers_of_two(of.fold(0.0, |size, x: f64| quick::greater(x.abs(), size)))
    };
    let (down, up) = scales(&deviator);
    let b = deviator * down;
    // Where the moments agree to many bits, what rounding the mean has left in the trace is no longer small: root and axis are those without it. At
    // the threshold it is the rounding of the deviator itself.
    let rest = deviator.trace() * (1.0 / 3.0);
    let scaled = if (rest * down).abs() > 2.0 * f64::EPSILON {
        let traceless = deviator - Matrix3::from_diagonal_element(rest);
        traceless * scales(&traceless).0
    } else {
        b
    };
    let (separated, side) = separated_root(&scaled);
    let apart = axis_of(&scaled, separated);
    let [u, w] = across(&apart);
    let (bu, bw) = (b * u, b * w);
    let (cosine, sine, low, high) = plane_rotation(u.dot(&bu), u.dot(&bw), w.dot(&bw));
    let (first, second) = (u * cosine - w * sine, u * sine + w * cosine);
    let alone = apart.dot(&(b * apart));
    // (apart, first, second) is right-handed, and so is its cyclic shift.
    let (values, mut axes) = match side {
        Side::Smallest => ([alone, low, high], [apart, first, second]),
        Side::Largest => ([low, high, alone], [first, second, apart]),
    };
    let mut moments = (V::from(values) * up).add_scalar(mean);
    let sizes = moments.abs();
    if sizes.x.min(sizes.y).min(sizes.z) < NEEDLE * sizes.x.max(sizes.z) {
        let scaled = matrix * down;
        if scaled.iter().all(|x| *x == 0.0 || x.abs() > LEAST) {
            moments *= down;
            refine_small_moments::<DoubleDouble>(&scaled, &mut moments, &mut axes, side);
            moments *= up;
        } else {
            refine_small_moments::<Extended>(matrix, &mut moments, &mut axes, side);
        }
    }
    // Equal moments may have been rounded into the wrong order by one unit.
    moments[1] = moments[1].max(moments[0]);
    moments[2] = moments[2].max(moments[1]);
    PrincipalAxes {
        moments: moments.into(),
        axes: Matrix3::from_columns(&axes),
    }
}

/// Computes small moments again in 106 bits, from the determinant of A − v or the characteristic polynomial; and their axes where two are lost.
///
/// In a graded matrix the terms of these sums are graded like their results: cancellation costs no more than the condition of the matrix scaled to a
/// diagonal of ones. The root that is well separated from the others, at the end `side`, is known to a few eps.
///
/// Not inlined: caller and callee together would run out of registers.
#[inline(never)]
fn refine_small_moments<N: Number>(
    a: &Matrix3<f64>,
    moments: &mut V,
    axes: &mut [V; 3],
    side: Side,
) {
    let [x, y, z, xy, xz, yz] = [a.m11, a.m22, a.m33, a.m12, a.m13, a.m23];
    let minor = |a: f64, b: f64, c: f64, d: f64| N::product(a, b).add_alike(N::product(-c, d));
    // det(A − v) = cube − v (squares − v (trace − v)).
    let first = minor(y, z, yz, yz);
    let squares = minor(x, y, xy, xy)
        .add_alike(minor(x, z, xz, xz))
        .add_alike(first);
    let cube = first
        .times(x)
        .add_alike(minor(xy, z, yz, xz).times(-xy))
        .add_alike(minor(y, xz, xy, yz).times(-xz));
    let (apart, [low, high]) = match side {
        Side::Smallest => (0, [1, 2]),
        Side::Largest => (2, [0, 1]),
    };
    let sizes = moments.abs();
    if sizes[apart] < NEEDLE * sizes[low].max(sizes[high]) {
        // v (1 − v (trace − v)/squares) = cube/squares; the other two moments lie so close that 4 · whole · slope is at most 3/4.
        let whole = cube.ratio(squares);
        let slope = N::from_double(moments[low] + moments[high]).ratio(squares);
        moments[apart] = 2.0 * whole / (1.0 + (1.0 - 4.0 * whole * slope).sqrt());
        return;
    }
    let [x, y, z, xy, xz, yz] = [x, y, z, xy, xz, yz].map(N::from_double);
    let trace = x.add_alike(y).add_alike(z);
    // One Newton step takes the separated root from an error of a few eps to their square; then the quadratic that is left.
    let [u, v, near] = [low, high, apart].map(|k| N::from_double(moments[k]));
    let slope = (near - u) * (near - v);
    let rest = ((trace - near) * near - squares) * near + cube;
    let root = near + rest.quotient(slope);
    let product = cube.quotient(root);
    let half = (squares - product).quotient(root).times(0.5);
    let square = half.square() - product;
    let spread = if square.leading() > 0.0 {
        square.square_root()
    } else {
        N::from_double(0.0)
    };
    let far = half - spread.signed(-half.leading());
    let pair = if far.leading() < 0.0 {
        [far, product.quotient(far)]
    } else if far.is_zero() {
        [far, far]
    } else {
        [product.quotient(far), far]
    };
    (moments[low], moments[high]) = (pair[0].narrow().value(), pair[1].narrow().value());
    if moments[high] - moments[low] > 1e-3 * sizes[apart] {
        // Their axes are already as good as the gap between them allows.
        return;
    }
    // The columns of the adjugate of A − low are multiples of its axis.
    let [x, y, z] = [x, y, z].map(|d| d - pair[0]);
    let minor = |a: N, b, c: N, d| (a * b).add_alike(-(c * d));
    let (a01, a02) = (minor(xz, yz, xy, z), minor(xy, yz, xz, y));
    let a12 = minor(xy, xz, yz, x);
    let columns = [
        [minor(y, z, yz, yz), a01, a02],
        [a01, minor(x, z, xz, xz), a12],
        [a02, a12, minor(x, y, xy, xy)],
    ];
    let mut column = columns[0];
    let mut largest = column[0].magnitude();
    for (k, other) in columns.into_iter().enumerate() {
        if other[k].magnitude().exceeds(largest) {
            (largest, column) = (other[k].magnitude(), other);
        }
    }
    if largest.is_zero() {
        return;
    }
    let axis = V::from(column.map(|x| x.ratio(largest)));
    let across = axis - axes[apart] * axis.dot(&axes[apart]);
    let (length, whole) = (across.dot(&across), axis.dot(&axis));
    // Where the two moments agree to the last bits the column is mere rounding, and any pair will do.
    if length > 0.5 * whole {
        axes[low] = across / length.sqrt();
        axes[high] = axes[apart].cross(&axes[low]);
    }
}

/// A diagonal matrix: its own entries in order, and coordinate axes, the last reversed if need be.
fn coordinate_axes(diagonal: [f64; 3]) -> PrincipalAxes {
    let order = ascending([0, 1, 2], &diagonal);
    let [first, second, _] = order.map(|i| V::ith(i, 1.0));
    PrincipalAxes {
        moments: order.map(|i| diagonal[i]),
        axes: Matrix3::from_columns(&[first, second, first.cross(&second)]),
    }
}

/// A power of two that brings `size` near 1, and its reciprocal; both normal, so that scaling rounds nothing.
fn powers_of_two(size: f64) -> (f64, f64) {
    let biased = ((size.to_bits() >> 52) & 0x7ff).clamp(2, 2044);
    let power = |biased: u64| f64::from_bits(biased << 52);
    (power(2046 - biased), power(biased))
}

/// Which end of the spectrum the separated root is.
#[derive(Clone, Copy)]
enum Side {
    Smallest,
    Largest,
}

/// Of a symmetric matrix B of vanishing trace, entries near 1: the root of the characteristic cubic that is at least as far from the middle one as the other.
///
/// With p² = |B|²/6 and h = det B/2p³ the roots are pt, t³ − 3t = 2h. For h ≥ 0 the largest lies between √3 and 2 and
/// its distance from the next is at least √3; for h < 0 the same holds of the smallest.
#[inline]
fn separated_root(b: &Matrix3<f64>) -> (f64, Side) {
    let (diagonal, off) = (b.diagonal(), V::new(b.m12, b.m13, b.m23));
    let squares = (diagonal.dot(&diagonal) + 2.0 * off.dot(&off)) / 6.0;
    let p = squares.sqrt();
    let determinant = b.determinant();
    let h = (0.5 * determinant.abs() / (squares * p)).min(1.0);
    // Minimax cubic for 2 cos(arccos(h)/3) on 0..1, error 7e-5; two Newton steps square it twice.
    let mut t = GUESS[0] + h * (GUESS[1] + h * (GUESS[2] + h * GUESS[3]));
    for _ in 0..2 {
        let tt = t * t;
        t = (2.0 * t * tt + 2.0 * h) / (3.0 * (tt - 1.0));
    }
    if determinant < 0.0 {
        (-p * t, Side::Smallest)
    } else {
        (p * t, Side::Largest)
    }
}

/// The unit vector that B − root annihilates: the longest cross product of two of its columns.
///
/// For the separated root that product is at least 2√3 p² long, so its direction is good to a few eps.
#[inline]
fn axis_of(b: &Matrix3<f64>, root: f64) -> V {
    let shifted = b - Matrix3::from_diagonal_element(root);
    let (x, y, z) = (shifted.column(0), shifted.column(1), shifted.column(2));
    // Together they are the adjugate, a multiple of v vᵀ: its largest diagonal entry marks the longest.
    let [x, y, z] = [y.cross(&z), z.cross(&x), x.cross(&y)];
    let sizes = [x.x.abs(), y.y.abs(), z.z.abs()];
    let longest = if sizes[0] >= sizes[1] && sizes[0] >= sizes[2] {
        x
    } else if sizes[1] >= sizes[2] {
        y
    } else {
        z
    };
    longest * (1.0 / longest.dot(&longest).sqrt())
}

/// Two unit vectors that with the unit vector `n` make a right-handed frame (n, u, w).
///
/// T. Duff et al., "Building an orthonormal basis, revisited": no root, no cancellation.
#[inline]
fn across(n: &V) -> [V; 2] {
    let [x, y, z] = (*n).into();
    let sign = 1.0_f64.copysign(z);
    let a = -1.0 / (sign + z);
    let b = x * y * a;
    [
        V::new(1.0 + sign * x * x * a, sign * b, -sign * x),
        V::new(b, sign + y * y * a, -y),
    ]
}

/// Cosine and sine of the turn that makes [[uu, uw], [uw, ww]] diagonal, and the two values, lower first.
#[inline]
fn plane_rotation(uu: f64, uw: f64, ww: f64) -> (f64, f64, f64, f64) {
    let difference = ww - uu;
    let twice = 2.0 * uw;
    let length = (difference * difference + twice * twice).sqrt();
    if length == 0.0 {
        return (1.0, 0.0, uu, ww);
    }
    // Tangent of the smaller angle, |tangent| ≤ 1.
    let tangent = twice / (difference.abs() + length);
    let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
    let sine = tangent * cosine;
    if difference >= 0.0 {
        (cosine, sine, uu - tangent * uw, ww + tangent * uw)
    } else {
        // u carries the larger value: a quarter turn more puts the lower first again.
        (sine, cosine, ww - tangent * uw, uu + tangent * uw)
    }
}
