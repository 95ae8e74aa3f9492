//! 2.8: the theorem of parallel axes.

use super::*;
use spinning_bodies::inertia::principal_axes_of;

#[test]
fn s2_8_parallel_axes() -> Result<()> {
    // claim: C2.8-1
    let body = four_masses()?;
    let shifted = body.about(vector([0.0; 3]))?;
    let expected = Matrix3::new(13.0, -4.0, -4.0, -4.0, 12.0, -4.0, -4.0, -4.0, 11.0);
    observed!((shifted.matrix() - expected).amax(), 4e-16..=2e-15);
    // Only from the centre: shifting on from the origin as if it were the centre gives another matrix.
    let point = vector([1.0, 1.0, 1.0]);
    let right = body.about(point)?.matrix();
    let mut direct = Matrix3::zeros();
    for (&m, x) in MASSES.iter().zip(POSITIONS) {
        let d = vector(x.map(|x| x as f64)) - point;
        direct += InertiaMatrix::of_particle(m as f64, d)?.matrix();
    }
    assert!((right - direct).amax() <= 8.0 * EPS * 13.0);
    let wrong = MassProperties::new(10.0, point, shifted)?;
    let wrong = wrong.about(vector([0.0; 3]))?.matrix();
    assert!((wrong - right).amax() > 1.0);
    Ok(())
}

#[test]
fn s2_8_the_theorem_is_needed_after_all() -> Result<()> {
    // claim: C2.8-3
    // Kovalevskaya's ellipsoid of 8.1: semi-axes 1, √3, 3, pivot at √(2/5) on the first axis.
    let ellipsoid = shapes::ellipsoid(1.0, [1.0, 3.0_f64.sqrt(), 3.0])?;
    assert_inertia(&ellipsoid, [2.4, 2.0, 0.8, 0.0, 0.0, 0.0]);
    let about_pivot = ellipsoid.about(vector([0.4_f64.sqrt(), 0.0, 0.0]))?;
    let shifted = [2.4, 2.4, 1.2];
    for (k, expected) in shifted.into_iter().enumerate() {
        close!(about_pivot.matrix()[(k, k)], expected, 2.0 * EPS);
    }
    // And any second-moment matrix has principal axes, not only an inertia matrix.
    let s = principal_axes_of(&ellipsoid.inertia().second_moments())?;
    for (value, expected) in s.moments.into_iter().zip([0.2, 0.6, 1.8]) {
        close!(value, expected, 4.0 * EPS);
    }
    Ok(())
}
