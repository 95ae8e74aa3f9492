//! Bad input for the three tops: whatever is given, a documented meaning or an error that names the condition.
//!
//! First the list of starts on which a formula divides by zero or a class has its border, each with what it means. Then chance: every
//! bit pattern of a double may be a moment, a rate, a quaternion or a time. No panic, and no NaN in a state that is handed out.
//! `PROPTEST_CASES` greater than the numbers below searches longer.

mod chance;
mod eulers_top;
mod kovalevskayas_top;
mod lagranges_top;

use spinning_bodies::euler_top::{EulerTop, Poinsot, Regime};
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::kovalevskaya_top::{Kind, KovalevskayaTop, Method};
use spinning_bodies::lagrange_top::{
    LagrangeTop, Nutation, PurePrecession, State, apsides, dip, fast_spin, pendulum_between,
    pendulum_from_integrals, pure_precession, sleeping_threshold, tilt_after_kick,
};
use spinning_bodies::{Error, Result};
use support::vector;

const BAD: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const ZERO: [f64; 3] = [0.0; 3];

/// These numbers with each of them, in turn, replaced by what is none.
fn spoiled<const N: usize>(numbers: [f64; N]) -> impl Iterator<Item = [f64; N]> {
    BAD.into_iter().flat_map(move |bad| {
        (0..N).map(move |k| core::array::from_fn(|j| if j == k { bad } else { numbers[j] }))
    })
}

fn upright() -> Attitude {
    Attitude::identity()
}

/// The axis straight down, exactly: a half turn about the first axis.
fn hanging() -> Attitude {
    Attitude::from_quaternion(0.0, 1.0, 0.0, 0.0).expect("a quaternion")
}

/// The axis level, exactly: z₃ = 0.
fn level() -> Attitude {
    Attitude::from_quaternion(1.0, 1.0, 0.0, 0.0).expect("a quaternion")
}

/// The start and the same after half a minute.
fn lagrange(weight: f64, omega: [f64; 3], attitude: Attitude) -> Result<(Nutation, [State; 2])> {
    let top = LagrangeTop::new(1.0, 0.5, weight, vector(omega), attitude)?;
    Ok((top.kind(), [top.at(0.0)?, top.at(30.0)?]))
}

/// The greatest and the smallest numbers, each with an exponent and all of its digits.
#[test]
fn numbers_in_refusals_can_be_read() {
    let told = |moments: [f64; 3]| {
        let refused = EulerTop::new(moments, vector([1.0; 3]), level());
        refused.expect_err("no body").to_string()
    };
    let unequal = |got: &str| {
        format!("principal moments must satisfy I1 + I2 >= I3, got {got}; no body has these")
    };
    let widest = unequal("5e-324 + 1 < 1.7976931348623157e308");
    assert_eq!(told([5e-324, 1.0, f64::MAX]), widest);
    let negative = "a principal moment must not be negative, got -1e-300";
    assert_eq!(told([1.0, 1.0, -1e-300]), negative);
    let wide = unequal("1 + 1 < 123456.5");
    assert_eq!(told([1.0, 1.0, 123456.5]), wide);
}
