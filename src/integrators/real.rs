//! The kinds of number in which a geometric method computes: single, double, or two doubles.

use core::fmt::Debug;

use crate::precise::quick::{COSINE, SINE};
use crate::precise::{DoubleDouble, Number, Operators};

/// A number: `f32`, `f64` or [`DoubleDouble`].
///
/// The methods are generic over the three, so that the effect of rounding is seen by changing nothing else.
///
/// ```
/// use spinning_bodies::integrators::geometric::{DoubleDouble, Real};
/// let (one, three) = (DoubleDouble::from_double(1.0), DoubleDouble::from_double(3.0));
/// assert!((one / three * three - one).to_double().abs() < 1e-30);
/// assert_eq!((f32::from_double(0.1), 0.1_f64.two_words().to_double()), (0.1_f32, 0.1));
/// ```
pub trait Real: Functions {
    /// The number nearest to a double.
    ///
    /// ```
    /// use spinning_bodies::integrators::geometric::Real;
    /// assert_eq!(f32::from_double(0.1), 0.1_f32);
    /// ```
    fn from_double(value: f64) -> Self;

    /// The double nearest to the number.
    ///
    /// ```
    /// use spinning_bodies::integrators::geometric::Real;
    /// assert_eq!(0.5_f32.to_double(), 0.5);
    /// ```
    fn to_double(self) -> f64;

    /// The same number in two words.
    ///
    /// ```
    /// use spinning_bodies::integrators::geometric::Real;
    /// assert_eq!(0.1_f64.two_words().to_double(), 0.1);
    /// ```
    fn two_words(self) -> DoubleDouble {
        DoubleDouble::from(self.to_double())
    }
}

/// The operators of a number and the functions of a rotation. Sealed: other crates cannot implement it.
pub trait Functions: Operators + Debug + PartialEq + Send + Sync + 'static {
    /// The unit of rounding: half the distance from 1 to the next number.
    const ROUNDING: f64;

    /// 1/x.
    fn reciprocal(self) -> Self;

    /// √x for x ≥ 0.
    fn square_root(self) -> Self;

    /// sin x and 1 − cos x, each to about one unit in its last place for |x| ≤ π/4; beyond that with the platform's error.
    fn turn(self) -> (Self, Self);

    /// (sin x)/x and (1 − cos x)/x² from x², with the same errors.
    fn turn_of_square(self) -> (Self, Self);

    /// sin x and cos x of a long phase x, which needs two words to be known to a small part of a turn.
    fn sine_and_cosine(x: DoubleDouble) -> (Self, Self);
}

/// Up to this x², the short series are good to 2⁻⁶⁰: the first term left out is x¹⁰/11!, and x² < 1/256.
const SHORT: f64 = 1.0 / 256.0;

/// (π/4)².
const LONG: f64 = 0.616_850_275_068_084_9;

/// ((sin x)/x − 1)/x² and ((cos x − 1)/x² + 1/2)/x² from z = x² ≤ (π/4)², the short form by Taylor's series; the sums are arranged to
/// shorten the chain of dependent operations.
macro_rules! series {
    ($real:ty, $z:expr) => {{
        let z = $z;
        let w = z * z;
        if z < SHORT as $real {
            let sine =
                (-1.0 / 6.0 + z * (1.0 / 120.0)) + w * (-1.0 / 5040.0 + z * (1.0 / 362_880.0));
            let cosine =
                (1.0 / 24.0 - z * (1.0 / 720.0)) + w * (1.0 / 40_320.0 - z * (1.0 / 3_628_800.0));
            (sine, cosine)
        } else {
            let (s, c) = (SINE.map(|x| x as $real), COSINE.map(|x| x as $real));
            let sine = (s[0] + z * s[1]) + w * ((s[2] + z * s[3]) + w * (s[4] + z * s[5]));
            let cosine = (c[0] + z * c[1]) + w * ((c[2] + z * c[3]) + w * (c[4] + z * c[5]));
            (sine, cosine)
        }
    }};
}
macro_rules! machine {
    ($real:ty) => {
        impl Real for $real {
            #[inline(always)]
            fn from_double(value: f64) -> Self {
                value as Self
            }

            #[inline(always)]
            fn to_double(self) -> f64 {
                f64::from(self)
            }
        }

        impl Functions for $real {
            const ROUNDING: f64 = <$real>::EPSILON as f64 / 2.0;

            #[inline(always)]
            fn reciprocal(self) -> Self {
                1.0 / self
            }

            #[inline(always)]
            fn square_root(self) -> Self {
                self.sqrt()
            }

            #[inline(always)]
            fn turn(self) -> (Self, Self) {
                let square = self * self;
                if square > LONG as Self || square.is_nan() {
                    let half = (0.5 * self).sin();
                    return (self.sin(), 2.0 * half * half);
                }
                let (sine, cosine) = series!($real, square);
                (
                    self + self * (square * sine),
                    square * (0.5 - square * cosine),
                )
            }

            #[inline(always)]
            fn turn_of_square(self) -> (Self, Self) {
                if self > LONG as Self || self.is_nan() {
                    let x = self.sqrt();
                    let half = (0.5 * x).sin() / x;
                    return (x.sin() / x, 2.0 * half * half);
                }
                let (sine, cosine) = series!($real, self);
                (1.0 + self * sine, 0.5 - self * cosine)
            }

            fn sine_and_cosine(x: DoubleDouble) -> (Self, Self) {
                let (sine, cosine) = x.sin_cos();
                (sine as Self, cosine as Self)
            }
        }
    };
}

machine!(f32);
machine!(f64);

/// ((sin x)/x, (1 − cos x)/x²) from x² by Taylor's series, for x² ≤ 3.
fn taylor(square: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let one = DoubleDouble::from(1.0);
    let (mut sine, mut versine) = (one, DoubleDouble::from(0.5));
    let (mut a, mut b) = (sine, versine);
    // 30 terms reach 2⁻¹⁰⁷ for every x² ≤ 3; a smaller x² needs fewer.
    for n in 1..30 {
        let n = f64::from(2 * n);
        a = -(a * square) / DoubleDouble::from(n * (n + 1.0));
        b = -(b * square) / DoubleDouble::from((n + 1.0) * (n + 2.0));
        (sine, versine) = (sine + a, versine + b);
        if a.value().abs() < 1e-33 {
            break;
        }
    }
    (sine, versine)
}

impl Real for DoubleDouble {
    fn from_double(value: f64) -> Self {
        Self::from(value)
    }

    fn to_double(self) -> f64 {
        self.value()
    }

    fn two_words(self) -> Self {
        self
    }
}

impl Functions for DoubleDouble {
    const ROUNDING: f64 = 2.465_190_328_815_662e-32;

    fn reciprocal(self) -> Self {
        Self::from(1.0) / self
    }

    fn square_root(self) -> Self {
        Number::square_root(self)
    }

    fn turn(self) -> (Self, Self) {
        let (sine, versine) = (self * self).turn_of_square();
        (self * sine, self * self * versine)
    }

    fn turn_of_square(self) -> (Self, Self) {
        if self.value() <= 3.0 {
            return taylor(self);
        }
        if !self.value().is_finite() {
            return (self, self);
        }
        // sin x = 2 sin(x/2) cos(x/2) and 1 − cos x = 2 sin²(x/2), recursively until the series converges.
        let two = Self::from(2.0);
        let (sine, versine) = (self * Self::from(0.25)).turn_of_square();
        let cosine = Self::from(1.0) - self * Self::from(0.25) * versine;
        (sine * cosine, sine * sine * two.reciprocal())
    }

    fn sine_and_cosine(x: Self) -> (Self, Self) {
        let (sine, versine) = x.turn();
        (sine, Self::from(1.0) - versine)
    }
}

/// A sum of many small increments to three or four numbers, each with the rounding error it has so far (Kahan).
///
/// The error of n increments is that of one addition; a plain sum loses up to n times as much.
#[derive(Debug, Clone, Copy)]
pub(in crate::integrators) struct Sums<T, const N: usize> {
    pub values: [T; N],
    pub left: [T; N],
}

impl<T: Real, const N: usize> Sums<T, N> {
    pub fn new(values: [T; N]) -> Self {
        let left = [T::from_double(0.0); N];
        Self { values, left }
    }

    #[inline(always)]
    pub fn add(&mut self, k: usize, increment: T) {
        let increment = increment + self.left[k];
        let sum = self.values[k] + increment;
        self.left[k] = increment - (sum - self.values[k]);
        self.values[k] = sum;
    }

    #[inline(always)]
    pub fn add_all(&mut self, increments: [T; N]) {
        for (k, increment) in increments.into_iter().enumerate() {
            self.add(k, increment);
        }
    }
}

#[inline(always)]
pub(in crate::integrators) fn cross<T: Real>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

#[inline(always)]
pub(in crate::integrators) fn dot<T: Real>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The quaternion of a rotation, less 1, from half the rotation vector.
#[inline(always)]
pub(in crate::integrators) fn exponential<T: Real>(half: [T; 3]) -> [T; 4] {
    let square = dot(half, half);
    let (sine, versine) = square.turn_of_square();
    let [x, y, z] = half.map(|component| sine * component);
    [-(square * versine), x, y, z]
}

/// The product of two quaternions (w, x, y, z).
#[inline(always)]
pub(in crate::integrators) fn product<T: Real>(p: [T; 4], q: [T; 4]) -> [T; 4] {
    let [a, b, c, d] = p;
    let [w, x, y, z] = q;
    [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]
}

#[cfg(test)]
mod tests {
    use super::{DoubleDouble, Functions, Real};

    /// sin and 1 − cos of x in two words serve as the truth for those in double and single precision.
    #[test]
    fn turns_are_good_to_the_last_place_or_two() {
        let mut worst = [0.0_f64; 4];
        let mut x = 1e-9_f64;
        while x < 3.0 {
            let (sine, versine) = DoubleDouble::from(x).turn();
            let (s, v) = x.turn();
            let ulps = |found: f64, exact: f64, unit: f64| ((found - exact) / exact / unit).abs();
            let exact = [sine.to_double(), versine.to_double()];
            worst[0] = worst[0].max(ulps(s, exact[0], f64::EPSILON));
            worst[1] = worst[1].max(ulps(v, exact[1], f64::EPSILON));
            let (s, v) = (x * x).turn_of_square();
            worst[2] = worst[2].max(ulps(s * x, exact[0], f64::EPSILON));
            worst[3] = worst[3].max(ulps(v * x * x, exact[1], f64::EPSILON));
            // That truth is itself compared with the platform's functions.
            assert!(
                (exact[0] - x.sin()).abs() < 2e-16 && (exact[1] - (1.0 - x.cos())).abs() < 3e-16
            );
            x *= 1.003;
        }
        // Observed, in units of 2⁻⁵²: 0.996, 1.195, 0.998, 1.923; the last two contain the rounding of x² and of the products that undo the division.
        for (&one, allowed) in worst.iter().zip([1.0, 1.3, 1.1, 2.0]) {
            assert!(one < allowed, "{worst:?}");
        }
    }
}
