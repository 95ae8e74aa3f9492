//! What the files of Section 8 share.

use num_rational::Ratio;
use spinning_bodies::frame::BodyVector;
use spinning_bodies::kovalevskaya_top::KovalevskayaTop;

pub type Q = Ratio<i128>;

pub type Result = spinning_bodies::Result<()>;

pub const MOMENTS: [f64; 3] = [2.0, 2.0, 1.0];

pub const EPS: f64 = f64::EPSILON;

pub fn q(numerator: i128, denominator: i128) -> Q {
    Q::new(numerator, denominator)
}

pub fn vector([x, y, z]: [f64; 3]) -> BodyVector {
    BodyVector::new(x, y, z)
}

/// The start of the register: c = 1, Ω = (1, ½, 0.3), z = (2, −1, 2)/3.
pub fn register() -> spinning_bodies::Result<KovalevskayaTop> {
    let (omega, up) = ([1.0, 0.5, 0.3], [2.0, -1.0, 2.0]);
    KovalevskayaTop::with_up(MOMENTS, vector([1.0, 0.0, 0.0]), vector(omega), vector(up))
}

pub fn cross(a: [Q; 3], b: [Q; 3]) -> [Q; 3] {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j] * b[k] - a[k] * b[j]
    })
}

/// I dΩ/dt = IΩ∧Ω + C∧(−Mgz) and dz/dt = z∧Ω, from the vector products (5.1, 8.1).
pub fn rates(moments: [Q; 3], lever: [Q; 3], omega: [Q; 3], z: [Q; 3]) -> [[Q; 3]; 2] {
    let l = std::array::from_fn(|i| moments[i] * omega[i]);
    let gyroscopic = cross(l, omega);
    let torque = cross(lever, z.map(|z| -z));
    let change = std::array::from_fn(|i| (gyroscopic[i] + torque[i]) / moments[i]);
    [change, cross(z, omega)]
}

/// Points with small rational coordinates, in no order: an identity of low degree that holds on all of them holds.
pub fn points() -> impl Iterator<Item = [Q; 12]> {
    let mut state = 1889_u64;
    let mut draw = move || {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        let (n, d) = ((state >> 33) % 19, (state >> 48) % 4 + 1);
        q(n as i128 - 9, d as i128)
    };
    std::iter::repeat_with(move || std::array::from_fn(|_| draw())).take(200)
}

/// A complex product of rationals.
pub fn times(a: [Q; 2], b: [Q; 2]) -> [Q; 2] {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}
