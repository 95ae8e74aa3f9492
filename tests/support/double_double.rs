//! Arithmetic with 106 bits, for truths that ordinary numbers cannot check: a number is the sum hi + lo of two.
//!
//! Dekker's and Knuth's error-free sums and products; every operation is good to about 1e-31.

use crate::{cross, dot, greatest};
use num_traits::{One, Zero};
use std::iter::Sum;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default)]
pub struct Dd {
    pub hi: f64,
    pub lo: f64,
}

#[inline]
fn two_sum(a: f64, b: f64) -> Dd {
    let hi = a + b;
    let v = hi - a;
    let lo = (a - (hi - v)) + (b - v);
    Dd { hi, lo }
}

#[inline]
fn quick_two_sum(a: f64, b: f64) -> Dd {
    let hi = a + b;
    let lo = b - (hi - a);
    Dd { hi, lo }
}

impl Dd {
    pub const ZERO: Self = Self { hi: 0.0, lo: 0.0 };

    #[inline]
    pub fn value(self) -> f64 {
        self.hi + self.lo
    }

    pub fn abs(self) -> Self {
        if self.hi < 0.0 { -self } else { self }
    }

    pub fn sqrt(self) -> Self {
        if self.hi <= 0.0 {
            return Self::ZERO;
        }
        let root = Self::from(self.hi.sqrt());
        let once = 0.5 * (root + self / root);
        0.5 * (once + self / once)
    }
}

impl From<f64> for Dd {
    #[inline]
    fn from(hi: f64) -> Self {
        Self { hi, lo: 0.0 }
    }
}

impl Add for Dd {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        let high = two_sum(self.hi, other.hi);
        let low = two_sum(self.lo, other.lo);
        let carried = quick_two_sum(high.hi, high.lo + low.hi);
        quick_two_sum(carried.hi, carried.lo + low.lo)
    }
}

impl Neg for Dd {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        let (hi, lo) = (-self.hi, -self.lo);
        Self { hi, lo }
    }
}

impl Sub for Dd {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Dd {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let hi = self.hi * other.hi;
        let error = self.hi.mul_add(other.hi, -hi);
        quick_two_sum(hi, error + (self.hi * other.lo + self.lo * other.hi))
    }
}

impl Div for Dd {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let first = self.hi / other.hi;
        let rest = self - other * Self::from(first);
        let second = rest.hi / other.hi;
        let rest = rest - other * Self::from(second);
        quick_two_sum(first, second) + Self::from(rest.hi / other.hi)
    }
}

/// An ordinary number on either side is a pair whose second half is nil.
macro_rules! beside_an_ordinary_number {
    ($($kind:ident $operator:ident),*) => {$(
        impl $kind<f64> for Dd {
            type Output = Self;
            #[inline]
            fn $operator(self, other: f64) -> Self {
                $kind::$operator(self, Self::from(other))
            }
        }

        impl $kind<Dd> for f64 {
            type Output = Dd;
            #[inline]
            fn $operator(self, other: Dd) -> Dd {
                $kind::$operator(Dd::from(self), other)
            }
        }
    )*};
}

beside_an_ordinary_number!(Add add, Sub sub, Mul mul, Div div);

/// What vectors and matrices ask of their numbers.
macro_rules! assigned {
    ($($kind:ident $operator:ident $plain:tt),*) => {$(
        impl $kind for Dd {
            #[inline]
            fn $operator(&mut self, other: Self) {
                *self = *self $plain other;
            }
        }
    )*};
}

assigned!(AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /);

impl Zero for Dd {
    fn zero() -> Self {
        Self::ZERO
    }

    fn is_zero(&self) -> bool {
        *self == Self::ZERO
    }
}

impl One for Dd {
    fn one() -> Self {
        Self::from(1.0)
    }
}

impl Sum for Dd {
    fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
        terms.fold(Self::ZERO, Add::add)
    }
}

/// Eigenvalues, ascending, of a symmetric matrix of ordinary numbers, by cyclic Jacobi rotations.
pub fn eigenvalues(matrix: [[f64; 3]; 3]) -> [Dd; 3] {
    let mut a = matrix.map(|row| row.map(Dd::from));
    for _ in 0..12 {
        for (p, q, r) in [(0, 1, 2), (0, 2, 1), (1, 2, 0)] {
            let off = a[p][q];
            if off.hi == 0.0 {
                continue;
            }
            let twice = off + off;
            let difference = a[q][q] - a[p][p];
            let length = (difference * difference + twice * twice).sqrt();
            let mut t = twice / (difference.abs() + length);
            if difference.hi < 0.0 {
                t = -t;
            }
            let c = 1.0 / (1.0 + t * t).sqrt();
            let s = t * c;
            a[p][p] -= t * off;
            a[q][q] += t * off;
            let (rp, rq) = (a[r][p], a[r][q]);
            a[p][q] = Dd::ZERO;
            a[q][p] = Dd::ZERO;
            a[r][p] = c * rp - s * rq;
            a[p][r] = a[r][p];
            a[r][q] = s * rp + c * rq;
            a[q][r] = a[r][q];
        }
    }
    let mut values = [a[0][0], a[1][1], a[2][2]];
    values.sort_by(|x, y| x.partial_cmp(y).expect("finite"));
    values
}

/// The entries of a symmetric matrix: xx, yy, zz, xy, xz, yz.
const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// Volume, centre and inertia matrix about the centre (xx, yy, zz, xy, xz, yz) of a mesh of unit density.
///
/// The centre is that of the coordinates less the first vertex, so that its 30 digits are not spent on the offset.
pub struct MeshTruth {
    pub volume: Dd,
    pub center_from_first_vertex: [Dd; 3],
    pub inertia: [Dd; 6],
}

/// Exact sums over signed tetrahedra, in an order of its own: the apex is the first vertex of the list, and the
/// second moments are taken from the ten monomials of the corners, not from their sums.
pub fn mesh_truth(vertices: &[[f64; 3]], triangles: &[[u32; 3]]) -> MeshTruth {
    let apex = vertices[0];
    let relative = |index: u32| {
        let vertex = vertices[index as usize];
        [0, 1, 2].map(|i| two_sum(vertex[i], -apex[i]))
    };
    let mut determinant = Dd::ZERO;
    let mut first = [Dd::ZERO; 3];
    let mut second = [Dd::ZERO; 6];
    for corners in triangles {
        let [p, q, r] = corners.map(relative);
        let d = dot(p, cross(q, r));
        determinant += d;
        for i in 0..3 {
            first[i] += d * (p[i] + q[i] + r[i]);
        }
        for (sum, (i, j)) in second.iter_mut().zip(PAIRS) {
            let own = p[i] * p[j] + q[i] * q[j] + r[i] * r[j];
            let mixed =
                p[i] * q[j] + q[i] * p[j] + p[i] * r[j] + r[i] * p[j] + q[i] * r[j] + r[i] * q[j];
            *sum += d * (own + own + mixed);
        }
    }
    let volume = determinant / 6.0;
    let c = first.map(|sum| sum / (4.0 * determinant));
    let mut s = second.map(|sum| sum / 120.0);
    for (s, (i, j)) in s.iter_mut().zip(PAIRS) {
        *s -= volume * c[i] * c[j];
    }
    MeshTruth {
        volume,
        center_from_first_vertex: c,
        inertia: [s[1] + s[2], s[2] + s[0], s[0] + s[1], -s[3], -s[4], -s[5]],
    }
}

/// Largest difference between a computed inertia matrix and the exact one, over the largest exact entry.
pub fn inertia_error(truth: &MeshTruth, computed: impl Fn(usize, usize) -> f64) -> f64 {
    let largest = greatest(truth.inertia.map(|x| x.hi.abs()));
    let entries = PAIRS.into_iter().zip(truth.inertia);
    let off = entries.map(|((i, j), exact)| (computed(i, j) - exact).value().abs());
    greatest(off) / largest
}
