//! Euler's top.

use super::*;
use support::refused;

#[test]
fn at_rest_it_stays() -> Result<()> {
    for zero in [ZERO, [-0.0; 3]] {
        for moments in [[1.0, 2.0, 2.5], [1.0; 3], ZERO, [0.0, 1.0, 1.0]] {
            let top = EulerTop::new(moments, vector(zero), level())?;
            let state = top.at(1e18)?;
            assert_eq!(state.omega.norm(), 0.0);
            assert_eq!(state.attitude, level());
        }
    }
    Ok(())
}

#[test]
fn what_is_no_body_is_named() {
    let top = |i: [f64; 3], l: [f64; 3]| EulerTop::new(i, vector(l), level());
    refused!(top(ZERO, [1.0; 3]), Condition);
    refused!(top([0.0, 1.0, 1.0], [1.0; 3]), Condition);
    refused!(top([1.0, 2.0, -2.0], [1.0; 3]), Negative);
    refused!(top([1.0, 2.0, 3.1], [1.0; 3]), TriangleInequality);
    let beyond = top([1.0, 2.0, 2.5], [1.5e308; 3]);
    refused!(beyond, NotFinite, "the size of the angular momentum");
    // A needle whose own spin is too slow for any double.
    let (needle, slow) = ([1e-300, 1e-150, 1e-150], vector([7.7e-128, 2.2e-308, 0.0]));
    assert!(matches!(
        EulerTop::from_omega(needle, slow, level()),
        Err(Error::Condition { value: 0.0, .. })
    ));
    for bad in spoiled([1.0, 2.0, 2.5]) {
        refused!(top(bad, [1.0; 3]), NotFinite);
        refused!(top([1.0, 2.0, 2.5], bad), NotFinite);
    }
}

#[test]
fn long_times() -> Result<()> {
    let top = EulerTop::new([1.0, 2.0, 2.5], vector([0.3, 0.8, 0.4]), level())?;
    for t in BAD {
        refused!(top.at(t), NotFinite);
    }
    // Up to the time that is told, and no further.
    for moments in [[1.0, 2.0, 2.5], [1.0; 3], [1.0, 1.0, 1.5]] {
        let top = EulerTop::new(moments, vector([0.3, 0.8, 0.4]), level())?;
        let told = match top.at(f64::MAX) {
            Err(Error::OutOfRange { greatest, .. }) => greatest,
            other => panic!("{other:?}"),
        };
        assert!(top.at(0.999 * told).is_ok(), "{moments:?} {told:e}");
        refused!(top.at(1.001 * told), OutOfRange);
    }
    match top.at(1e18) {
        Ok(state) => assert!(state.omega.is_finite()),
        late => refused!(late, OutOfRange),
    }
    let still = EulerTop::new([1.0; 3], vector(ZERO), level())?;
    assert_eq!(still.regime(), Regime::AtRest);
    Ok(())
}
