//! Kovalevskaya's top in units of its own, I₃ = MgC₁ = 1, and the same by power series.

use crate::power_series::{Number, Top, Whole};
use crate::{greatest, vector};
use spinning_bodies::frame::Attitude;
use spinning_bodies::kovalevskaya_top::{KovalevskayaTop, State};

pub const MOMENTS: [f64; 3] = [2.0, 2.0, 1.0];
pub const LEVER: [f64; 3] = [1.0, 0.0, 0.0];

pub const SERIES: Top = Top {
    moments: MOMENTS,
    lever: LEVER,
};

pub fn top(omega: [f64; 3], up: [f64; 3]) -> KovalevskayaTop {
    KovalevskayaTop::with_up(MOMENTS, vector(LEVER), vector(omega), vector(up)).expect("a start")
}

/// Ω and z.
pub fn parts(state: &State) -> [f64; 6] {
    let (o, z) = (state.omega, state.up);
    [o.x(), o.y(), o.z(), z.x(), z.y(), z.z()]
}

/// Largest difference of a component of Ω and z, and the angle between the attitudes.
pub fn errors<T: Number>(state: &State, expected: &Whole<T>) -> [f64; 2] {
    let expected @ [.., w, x, y, z] = expected.map(T::double);
    let differences = parts(state).into_iter().zip(expected);
    let motion = greatest(differences.map(|(x, y)| (x - y).abs()));
    let attitude = Attitude::from_quaternion(w, x, y, z).expect("an attitude");
    [motion, attitude.angle_to(&state.attitude)]
}
