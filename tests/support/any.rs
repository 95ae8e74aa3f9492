//! Numbers that nobody chose, for the property tests.

use proptest::prelude::*;

/// Any number at all: every class of f64, and the extremes more often than chance would have them.
pub fn any() -> impl Strategy<Value = f64> {
    prop_oneof![
        prop::num::f64::ANY,
        -10.0..10.0,
        0.1..10.0,
        prop::sample::select(vec![
            0.0,
            -0.0,
            1.0,
            -1.0,
            0.5,
            2.0,
            4.0,
            1.0 + f64::EPSILON,
            f64::MAX,
            f64::MIN,
            f64::MIN_POSITIVE,
            5e-324,
            f64::INFINITY,
            f64::NAN,
            1e200,
            1e150,
            1e-150,
            1e-200,
            1e-300,
        ]),
    ]
}
