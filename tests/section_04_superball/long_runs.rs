//! Ten million bounces, and a million million.

use approx::assert_relative_eq;
use spinning_bodies::superball::{BounceRotation, Motion, UnderTable};

use crate::common::BALL;

/// Energy gained in `count` bounces with a step of one's own, from V = 1 without spin.
fn drift(count: u32, step: impl Fn(f64, f64, f64) -> (f64, f64)) -> f64 {
    let (mut v, mut w) = (1.0, 0.0);
    for n in 0..count {
        (v, w) = step(v, w, if n % 2 == 0 { 1.0 } else { -1.0 });
    }
    Motion {
        velocity: v,
        rim_speed: w,
    }
    .energy(BALL)
        - 1.0
}

// claim: C4.6-8
#[test]
fn s4_6_drift_over_ten_million_bounces() {
    let start = Motion {
        velocity: 1.0,
        rim_speed: 0.0,
    };
    let rotation = BounceRotation::of_fraction(2, 5).unwrap();
    let count = 10_000_000;
    let (a, b, c) = (3.0 / 7.0, 4.0 / 7.0, 10.0 / 7.0);
    let matrix = drift(count, |v, w, s| (a * v + s * b * w, s * c * v - a * w)).abs();
    let sevenths = drift(count, |v, w, s| {
        (v - b * (v - s * w), w + s * c * (v - s * w))
    })
    .abs();
    let last = UnderTable::new(start, BALL)
        .nth(count as usize - 1)
        .unwrap();
    let generic = (last.energy(BALL) - 1.0).abs();
    let far = rotation.after(start, u64::from(count));
    let closed = (far.energy(BALL) - 1.0).abs();
    println!(
        "matrix {matrix:e}, sevenths {sevenths:e}, bounce {generic:e}, closed form {closed:e}"
    );
    println!("velocity off by {:e}", last.velocity - far.velocity);
    // Observed 4.8e-10, 2.3e-11, 1.6e-9 and 0: whether a rounded coefficient is kind is luck; the closed form needs none.
    assert!((4e-10..6e-10).contains(&matrix), "{matrix:e}");
    assert!((1e-11..4e-11).contains(&sevenths), "{sevenths:e}");
    assert!((1e-9..2e-9).contains(&generic), "{generic:e}");
    assert!(closed < 5e-16, "{closed:e}");
    // The drift is linear: a tenth of the bounces, a tenth of the loss.
    let tenth = UnderTable::new(start, BALL)
        .nth(count as usize / 10 - 1)
        .unwrap();
    assert_relative_eq!(
        generic / (tenth.energy(BALL) - 1.0).abs(),
        10.0,
        max_relative = 0.1,
        epsilon = 0.0
    );
    // And the motion itself has lost its phase by no more than this.
    assert!((last.velocity - far.velocity).abs() < 3e-9);
}

// claim: C4.6-10
#[test]
fn s4_6_closed_form_after_a_million_million_bounces() {
    // The number is cos(10¹² arccos(3/7)) by 60-digit arithmetic.
    let rotation = BounceRotation::of_fraction(2, 5).unwrap();
    let start = Motion {
        velocity: 1.0,
        rim_speed: 0.0,
    };
    let n = 1_000_000_000_000;
    let far = rotation.after(start, n);
    assert_relative_eq!(
        far.velocity,
        -0.379_496_764_335_820_7,
        max_relative = 0.0,
        epsilon = 3e-16
    );
    // Half way twice, an even number of bounces being a rotation.
    let half = rotation.after(start, n / 2);
    let twice = rotation.after(half, n / 2);
    assert_relative_eq!(
        far.velocity,
        twice.velocity,
        max_relative = 0.0,
        epsilon = 5e-16
    );
    assert_relative_eq!(
        far.rim_speed,
        twice.rim_speed,
        max_relative = 0.0,
        epsilon = 1e-15
    );
    // 0.4 is not 2/5: after 10¹² bounces of that other ball the phase is off by some 1e-5.
    let other = BounceRotation::new(0.4).unwrap().after(start, n);
    let off = (other.velocity - far.velocity).abs();
    assert!((1e-6..1e-4).contains(&off), "{off:e}");
    let energy = rotation.after(start, u64::MAX).energy(BALL);
    assert_relative_eq!(energy, 1.0, max_relative = 5e-16, epsilon = 0.0);
}
