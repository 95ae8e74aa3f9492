//! Kovalevskaya's top.

use super::*;
use support::refused;

const MOMENTS: [f64; 3] = [2.0, 2.0, 1.0];

fn made(lever: [f64; 3], omega: [f64; 3], up: [f64; 3]) -> Result<KovalevskayaTop> {
    KovalevskayaTop::with_up(MOMENTS, vector(lever), vector(omega), vector(up))
}

#[test]
fn other_moments_are_another_top() {
    let (lever, omega) = (vector([1.0, 0.0, 0.0]), vector([1.0, 0.5, 0.3]));
    let with = |moments: [f64; 3]| KovalevskayaTop::new(moments, lever, omega, level());
    for [i1, i2] in [[1.9, 1.9], [2.0, 1.0], [2.0, 2.1]] {
        refused!(with([i1, i2, 1.0]), Condition);
    }
    for i1 in [1.0, 2.0] {
        refused!(with([i1, 2.0, 2.0]), Condition);
    }
    for k in 0..3 {
        let mut moments = MOMENTS;
        for zero in [0.0, -0.0, -1.0] {
            moments[k] = zero;
            refused!(with(moments), NotPositive);
        }
    }
    for bad in spoiled(MOMENTS) {
        refused!(with(bad), NotFinite);
    }
    for size in [1e300, 1e-300, f64::MIN_POSITIVE] {
        match with(MOMENTS.map(|i| i * size)) {
            Ok(top) => assert!(top.at(0.0).is_ok_and(|s| s.omega.is_finite())),
            Err(Error::NotFinite { .. } | Error::OutOfRange { .. }) => {}
            Err(error) => panic!("{error}"),
        }
    }
}

#[test]
fn levers_off_the_plane_or_none() -> Result<()> {
    let (omega, up) = ([1.0, 0.5, 0.3], [0.6, 0.0, 0.8]);
    for off in [0.1, -1e-300, 5e-324] {
        refused!(made([1.0, 0.0, off], omega, up), Condition);
    }
    for zero in [0.0, -0.0] {
        let top = made([zero; 3], omega, up)?;
        assert_eq!(top.kind(), Kind::EulerSymmetric);
        assert_eq!(top.method(), Method::FreeTop);
        assert!(top.at(1e12)?.omega.is_finite());
        assert!(made([1.0, zero, zero], omega, up).is_ok());
    }
    // Gravity upwards, or C on the other side: the same top turned by half a turn.
    let plain = made([1.0, 0.0, 0.0], omega, up)?;
    let turned = made([-1.0, 0.0, 0.0], [-1.0, -0.5, 0.3], [-0.6, 0.0, 0.8])?;
    for t in [0.0, 3.0, 50.0] {
        let (a, b) = (plain.omega_and_up(t)?, turned.omega_and_up(t)?);
        assert!((a.omega.x() + b.omega.x()).abs() < 1e-12);
        assert!((a.up.z() - b.up.z()).abs() < 1e-12);
    }
    Ok(())
}

#[test]
fn at_rest_on_the_way_up_and_down() -> Result<()> {
    for zero in [ZERO, [-0.0; 3]] {
        for (up, stays) in [
            ([1.0, 0.0, 0.0], true),
            ([-1.0, 0.0, 0.0], true),
            ([0.0, 1.0, 0.0], false),
            ([0.0, 0.0, 1.0], false),
            ([0.0, 0.0, -1.0], false),
        ] {
            let top = made([1.0, 0.0, 0.0], zero, up)?;
            let state = top.at(3.0)?;
            assert_eq!(state.omega.norm() < 1e-14, stays, "{up:?}: {state:?}");
        }
        let still = made(ZERO, zero, [0.0, 0.6, 0.8])?;
        assert_eq!(still.at(1e18)?.omega.norm(), 0.0);
    }
    Ok(())
}

#[test]
fn no_number_and_no_vertical() -> Result<()> {
    let (lever, omega, up) = ([1.0, 0.0, 0.0], [1.0, 0.5, 0.3], [0.6, 0.0, 0.8]);
    for bad in spoiled(up) {
        refused!(made(bad, omega, up), NotFinite);
        refused!(made(lever, bad, up), NotFinite);
        refused!(made(lever, omega, bad), NotFinite);
    }
    for bad in BAD {
        let top = made(lever, omega, up)?;
        refused!(top.at(bad), NotFinite);
        refused!(top.omega_and_up(bad), NotFinite);
    }
    refused!(made(lever, omega, ZERO), ZeroVector);
    let top = made(lever, omega, up)?;
    for t in [1e18, f64::MAX] {
        refused!(top.omega_and_up(t), OutOfRange);
        refused!(top.at(t), OutOfRange);
    }
    Ok(())
}
