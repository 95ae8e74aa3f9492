//! What the files of Section 8 share.

use super::*;
use support::power_series::Whole;

pub const MOMENTS: [f64; 3] = [2.0, 2.0, 1.0];

pub const EPS: f64 = f64::EPSILON;

/// The start of the register: c = 1, Ω = (1, ½, 0.3), z = (2, −1, 2)/3.
pub fn register() -> Result<KovalevskayaTop> {
    let (omega, up) = ([1.0, 0.5, 0.3], [2.0, -1.0, 2.0]);
    KovalevskayaTop::with_up(MOMENTS, vector([1.0, 0.0, 0.0]), vector(omega), vector(up))
}

/// Points with small rational coordinates, in no order: an identity of low degree that holds on all of them holds.
pub fn points() -> impl Iterator<Item = [R; 12]> {
    let mut numbers = Uniform(1889);
    let mut draw = move || {
        let [n, d] = [19.0, 4.0].map(|count| (count * numbers.next()) as i128);
        rational(n - 9, d + 1)
    };
    std::iter::repeat_with(move || std::array::from_fn(|_| draw())).take(200)
}

/// A complex product of rationals.
pub fn times(a: [R; 2], b: [R; 2]) -> [R; 2] {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

/// The same start as power series take it: Ω, z, and the attitude from the identity.
pub const REGISTER: Whole = {
    let third = 1.0 / 3.0;
    [
        1.0,
        0.5,
        0.3,
        2.0 * third,
        -third,
        2.0 * third,
        1.0,
        0.0,
        0.0,
        0.0,
    ]
};
