//! What the tests share: bounds with two sides, exact fractions, random numbers, tables, motions by power series.

#![expect(
    missing_docs,
    missing_debug_implementations,
    reason = "helpers of tests, read where they are used"
)]

pub mod decimal;
pub mod double_double;
pub mod free_top;
pub mod inertia;
pub mod kovalevskaya;
pub mod power_series;
mod random;
mod rationals;
pub mod table;

pub use random::{Uniform, any, ration};
pub use rationals::{ONE, R, TWO, ZERO, exact, rational, whole};

use core::f64::consts::TAU;
use core::fmt::Arguments;
use core::ops::{Add, Div, Mul, RangeInclusive, Sub};
use power_series::Number;
use spinning_bodies::frame::BodyVector;
use std::fs;
use std::path::Path;
use std::sync::Mutex;

/// An error within what was observed: asserted to be no greater than the upper end.
///
/// The lower end is for the greatest error that the line ever sees. Where the environment sets `REFERENCE_PLATFORM` it is written to
/// `target/tmp/observed`, one file a line, and `.ci/run` looks there for errors that have become much smaller than their bound: a bound that
/// no longer bites is brought down, or tells that the test no longer tests. On another processor, or with another libm, only the upper end counts.
#[macro_export]
macro_rules! observed {
    ($error:expr, $range:expr $(,)?) => {
        $crate::observed!($error, $range, "")
    };
    ($error:expr, $range:expr, $($told:tt)+) => {{
        static GREATEST: $crate::Greatest =
            $crate::Greatest::at(env!("CARGO_TARGET_TMPDIR"), module_path!(), line!());
        GREATEST.see($error, $range, format_args!($($told)+));
    }};
}

/// Two numbers, or arrays of them, as close as this in proportion to their size; zero is close to zero alone. Of two numbers a range, as in [`observed!`].
#[macro_export]
macro_rules! close {
    ($found:expr, $exact:expr, $least:literal..=$most:literal $($told:tt)*) => {
        $crate::observed!($crate::relative($found, $exact), $least..=$most $($told)*)
    };
    ($found:expr, $exact:expr, $most:expr) => {
        approx::assert_relative_eq!($found, $exact, max_relative = $most, epsilon = 0.0)
    };
}

/// Two numbers, or arrays of them, no further apart than this. Of two numbers a range, as in [`observed!`].
#[macro_export]
macro_rules! near {
    ($found:expr, $exact:expr, $least:literal..=$most:literal $($told:tt)*) => {
        $crate::observed!(($found - $exact).abs(), $least..=$most $($told)*)
    };
    ($found:expr, $exact:expr, $most:expr) => {
        approx::assert_relative_eq!($found, $exact, max_relative = 0.0, epsilon = $most)
    };
}

/// A result that is an error of this kind, of a quantity of this name.
#[macro_export]
macro_rules! refused {
    ($result:expr, $kind:ident $(, $quantity:literal)?) => {
        assert!(
            matches!($result, Err(spinning_bodies::Error::$kind { $(quantity: $quantity,)? .. })),
            stringify!($result)
        )
    };
}

/// How many samples to take: so many here, all of them where `REFERENCE_PLATFORM` is set, as in `.ci/run`.
pub fn samples<T>(here: T, all: T) -> T {
    if std::env::var_os("REFERENCE_PLATFORM").is_some() {
        all
    } else {
        here
    }
}

/// The greatest error that a line of a test has seen.
#[derive(Debug)]
pub struct Greatest {
    folder: &'static str,
    module: &'static str,
    line: u32,
    seen: Mutex<Option<f64>>,
}

impl Greatest {
    /// Of this line.
    pub const fn at(folder: &'static str, module: &'static str, line: u32) -> Self {
        Self {
            folder,
            module,
            line,
            seen: Mutex::new(None),
        }
    }

    /// Takes notice of an error.
    ///
    /// # Panics
    /// If it is above the range, or not a number.
    #[track_caller]
    pub fn see(&self, error: f64, range: RangeInclusive<f64>, told: Arguments<'_>) {
        let (least, most) = range.into_inner();
        assert!(error <= most, "{error:e} is above {most:e} {told}");
        if std::env::var_os("REFERENCE_PLATFORM").is_none() {
            return;
        }
        let mut seen = self
            .seen
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner());
        if seen.is_none_or(|before| error > before) {
            *seen = Some(error);
            let folder = Path::new(self.folder).join("observed");
            let name = format!("{}-{}", self.module.replace("::", "-"), self.line);
            let line = format!("{least:e} {error:e} {most:e}\n");
            let written =
                fs::create_dir_all(&folder).and_then(|()| fs::write(folder.join(name), line));
            assert!(written.is_ok(), "{written:?}");
        }
    }
}

/// Components along the body's axes.
pub const fn vector([x, y, z]: [f64; 3]) -> BodyVector {
    BodyVector::new(x, y, z)
}

/// How far two numbers that should be equal are apart, over the greater of them; 0 if both are 0.
pub fn relative(a: f64, b: f64) -> f64 {
    if a == b {
        0.0
    } else {
        (a - b).abs() / a.abs().max(b.abs())
    }
}

/// Fails, with the number, unless the error is within the bound: some three times what was observed over all cases.
#[track_caller]
pub fn within(error: f64, bound: f64) {
    assert!(error <= bound, "{error:e} is beyond {bound:e}");
}

/// An angle, brought into −π…π.
pub fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

/// Numbers of any kind, with the four operations.
pub trait Field:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
}

impl<T> Field for T where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Div<Output = T>
{
}

/// a∧b.
pub fn cross<T: Field>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [0, 1, 2].map(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j] * b[k] - a[k] * b[j]
    })
}

/// a·b.
pub fn dot<T: Field>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Euler's equations without torque: ∂Ω/∂t.
pub fn euler<T: Field>(moments: [T; 3], omega: [T; 3]) -> [T; 3] {
    [0, 1, 2].map(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        (moments[j] - moments[k]) * omega[j] * omega[k] / moments[i]
    })
}

/// Under the weight, with the lever MgC: I ∂Ω/∂t = IΩ∧Ω + z∧MgC and dz/dt = z∧Ω (5.1, 8.1).
pub fn heavy_rates<T: Field>(
    moments: [T; 3],
    lever: [T; 3],
    omega: [T; 3],
    up: [T; 3],
) -> [[T; 3]; 2] {
    let (free, torque) = (euler(moments, omega), cross(up, lever));
    let change = [0, 1, 2].map(|i| free[i] + torque[i] / moments[i]);
    [change, cross(up, omega)]
}

/// The slope at 0 of a polynomial of degree 4 at most, exactly.
pub fn exact_slope(f: impl Fn(R) -> R) -> R {
    let pair = |n: i128| f(whole(n)) - f(whole(-n));
    (whole(8) * pair(1) - pair(2)) / whole(12)
}

/// The derivative of f at n·h by central differences of order 18: the error is 1e-6 h¹⁸f⁽¹⁹⁾, and rounding over h.
pub fn derivative<const N: usize>(f: impl Fn(f64) -> [f64; N], n: i32, h: f64) -> [f64; N] {
    let mut total = [0.0; N];
    // (−1)^{k+1} p!²/(k (p−k)! (p+k)!) with p = 9.
    let mut binomial = -1.0;
    for k in 1..10 {
        binomial *= -f64::from(10 - k) / f64::from(9 + k);
        let (ahead, behind) = (f(f64::from(n + k) * h), f(f64::from(n - k) * h));
        for (sum, (a, b)) in total.iter_mut().zip(ahead.into_iter().zip(behind)) {
            *sum += binomial / f64::from(k) * (a - b) / h;
        }
    }
    total
}

/// The mean of a periodic function over one period, 0…1, by equal ordinates: the error falls like a geometric series.
pub fn mean(count: u32, f: impl Fn(f64) -> f64) -> f64 {
    let terms = (0..count).map(|k| f(f64::from(k) / f64::from(count)));
    terms.sum::<f64>() / f64::from(count)
}

/// The product of two quaternions (w, x, y, z) in numbers of any kind.
pub fn multiplied<T: Number>([a, b, c, d]: [T; 4], [w, x, y, z]: [T; 4]) -> [T; 4] {
    [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]
}

/// The rate of a quaternion (w, x, y, z) that turns body axes into those of space: half of q∘Ω, Ω along body axes.
pub fn turned<T: Number>([w, x, y, z]: [T; 4], [a, b, c]: [T; 3]) -> [T; 4] {
    let half = T::from(0.5);
    [
        T::from(-0.5) * (x * a + y * b + z * c),
        half * (w * a + y * c - z * b),
        half * (w * b + z * a - x * c),
        half * (w * c + x * b - y * a),
    ]
}

/// The greatest of these numbers, none of which is negative; what is no number is greater than all.
pub fn greatest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    let greater = |a: f64, b: f64| if b.is_nan() { f64::INFINITY } else { a.max(b) };
    numbers.into_iter().fold(0.0, greater)
}

/// The slope of ln error over ln step, by least squares.
pub fn slope(points: &[(f64, f64)]) -> f64 {
    let logs: Vec<(f64, f64)> = points.iter().map(|(x, y)| (x.ln(), y.ln())).collect();
    let mean = |of: fn(&(f64, f64)) -> f64| logs.iter().map(of).sum::<f64>() / logs.len() as f64;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let cross: f64 = logs.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    cross / logs.iter().map(|p| (p.0 - x).powi(2)).sum::<f64>()
}

/// The classical Runge–Kutta method: so many steps of this length; `look` sees where each ends.
pub fn runge_kutta<const N: usize>(
    rate: impl Fn(f64, [f64; N]) -> [f64; N],
    mut y: [f64; N],
    (steps, step): (u32, f64),
    mut look: impl FnMut(&[f64; N]),
) -> [f64; N] {
    for n in 0..steps {
        let t = step * f64::from(n);
        let shifted = |k: [f64; N], by: f64| core::array::from_fn(|i| y[i] + by * k[i]);
        let k1 = rate(t, y);
        let k2 = rate(t + step / 2.0, shifted(k1, step / 2.0));
        let k3 = rate(t + step / 2.0, shifted(k2, step / 2.0));
        let k4 = rate(t + step, shifted(k3, step));
        y = core::array::from_fn(|i| y[i] + step / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]));
        look(&y);
    }
    y
}

/// The six orders of three things.
pub const ORDERS: [[usize; 3]; 6] = [
    [0, 1, 2],
    [1, 2, 0],
    [2, 0, 1],
    [0, 2, 1],
    [2, 1, 0],
    [1, 0, 2],
];
