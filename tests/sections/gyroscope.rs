//! Tutorial 4.8: the gyroscope, of which the tutorial says only that other books treat it.

use super::*;
use spinning_bodies::lagrange_top::{PurePrecession, fast_spin, pure_precession};

/// A wheel of 0.1 kg, 4 cm from its support, I₃ = 6e-5 kg m², 100 turns a second.
const WEIGHT_MOMENT: f64 = 0.1 * 9.81 * 0.04;
const AXIAL: f64 = 6e-5;
const TRANSVERSE: f64 = 3e-5 + 0.1 * 0.04 * 0.04;

// claim: C4.8-1
#[test]
fn s4_8_the_law_of_slow_precession_and_what_it_leaves_out() {
    let l3 = AXIAL * 100.0 * TAU;
    let law = WEIGHT_MOMENT / l3;
    near!(law, 1.0409, 8e-6..=5e-5, "{law}");
    // With the axle level the law is exact, and there is no other rate.
    let level = pure_precession(TRANSVERSE, WEIGHT_MOMENT, l3, 0.0).unwrap();
    let PurePrecession::One(rate) = level else {
        panic!("{level:?}")
    };
    observed!((rate / law - 1.0).abs(), 0.0..=3e-16);
    // With the axle 60° from the vertical it is too small by x = I₁ Mgl cos θ/L₃², here a part in 380; observed 1 + x + 2x² to 1e-7.
    let height = FRAC_PI_3.cos();
    let tilted = pure_precession(TRANSVERSE, WEIGHT_MOMENT, l3, height).unwrap();
    let PurePrecession::Two { slow, fast } = tilted else {
        panic!("{tilted:?}")
    };
    let x = fast_spin(TRANSVERSE, WEIGHT_MOMENT, l3, height).unwrap().x;
    near!(x, 0.002623, 1e-8..=5e-7, "{x}");
    near!(slow / law, 1.0 + x + 2.0 * x * x, 3e-8..=1e-6);
    // The other rate is the wobble of the free top, four hundred times as fast.
    near!(fast, 395.8, 3e-3..=0.05, "{fast}");
}
