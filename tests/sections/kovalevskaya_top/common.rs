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

/// I dΩ/dt = IΩ∧Ω + C∧(−Mgz) and dz/dt = z∧Ω, from the vector products (5.1, 8.1).
pub fn rates(moments: [R; 3], lever: [R; 3], omega: [R; 3], z: [R; 3]) -> [[R; 3]; 2] {
    let l = std::array::from_fn(|i| moments[i] * omega[i]);
    let gyroscopic = cross(l, omega);
    let torque = cross(lever, z.map(|z| -z));
    let change = std::array::from_fn(|i| (gyroscopic[i] + torque[i]) / moments[i]);
    [change, cross(z, omega)]
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
