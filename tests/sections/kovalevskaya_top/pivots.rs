//! 8.1: bodies that are her top, and where to hold them.

use super::*;
use spinning_bodies::kovalevskaya_top::ellipsoid;
use support::inertia::{ellipsoid as solid, unit_gauss};

// claim: C8.1-4, C8.1-5
#[test]
fn s8_1_ellipsoids_that_are_her_top() -> Result<()> {
    let moments = |semi_axes: [f64; 3], distance: f64| -> Result<[f64; 3]> {
        let body = shapes::ellipsoid(1.0, semi_axes)?;
        let about = body.about(vector([distance, 0.0, 0.0]))?.matrix();
        Ok([about[(0, 0)], about[(1, 1)], about[(2, 2)]])
    };
    // From the mass integral in closed form, and once more by cubature over the body itself.
    let article = moments([1.0, 3_f64.sqrt(), 3.0], 0.4_f64.sqrt())?;
    let integrated = solid(unit_gauss(), [1.0, 3_f64.sqrt(), 3.0], 0.4_f64.sqrt());
    for (k, expected) in [2.4, 2.4, 1.2].into_iter().enumerate() {
        close!(article[k], expected, 2.0 * EPS);
        observed!(relative(integrated[k], expected), 1e-16..=1e-14);
    }
    // The order matters: with the axes exchanged it is another top.
    let other = moments([3_f64.sqrt(), 1.0, 3.0], 0.4_f64.sqrt())?;
    assert!((other[0] / other[2] - 2.0).abs() > 0.1, "{other:?}");
    // The family c = √3 b, d² = (b² − a²)/5, exactly: the squares are rational.
    for [a, b, ..] in points() {
        let (a2, b2) = (a * a, a * a + b * b);
        let (c2, d2) = (whole(3) * b2, (b2 - a2) / whole(5));
        let i1 = (b2 + c2) / whole(5);
        let i2 = (a2 + c2) / whole(5) + d2;
        let i3 = (a2 + b2) / whole(5) + d2;
        assert_eq!([i1, i2], [TWO * i3; 2]);
        // a = b: pivot at C. Inside the body where d < a, that is b² < 6a².
        assert_eq!(d2 == ZERO, b2 == a2);
        assert_eq!(d2 < a2, b2 < whole(6) * a2);
    }
    // And a member that is given to the constructor.
    let found = moments([0.5, 1.0, 3_f64.sqrt()], 0.15_f64.sqrt())?;
    let back = ellipsoid(1.0, found[2], 0.15_f64.sqrt())?;
    for (axis, expected) in back.into_iter().zip([0.5, 1.0, 3_f64.sqrt()]) {
        close!(axis, expected, 3.0 * EPS);
    }
    assert!(ellipsoid(1.0, 1.0, 0.5_f64.sqrt()).is_err());
    let lever = vector([0.15_f64.sqrt(), 0.0, 0.0]);
    let (omega, up) = (vector([1.0, 0.5, 0.3]), vector([2.0, -1.0, 2.0]));
    let top = KovalevskayaTop::with_up(found, lever, omega, up)?;
    assert_eq!(top.method(), Method::Separation);
    Ok(())
}

// claim: C8.1-6
#[test]
fn s8_1_which_pivots_a_body_allows() {
    let axial = 1.0;
    for step in 0..=40 {
        let square = f64::from(step) / 32.0;
        // About C, by the parallel axes theorem backwards.
        let about_center = PrincipalMoments::new(2.0 * axial, 2.0 * axial - square, axial - square);
        assert_eq!(about_center.is_ok(), square <= 0.5 * axial);
    }
    // At the limit a lamina at right angles to the first axis: 2 = 3/2 + 1/2.
    assert_eq!(TWO, rational(3, 2) + rational(1, 2));
}

// claim: C8.1-7
#[test]
fn s8_1_the_centre_anywhere_on_the_plane() -> Result<()> {
    let (omega, up) = ([1.0, 0.5, 0.3], [2.0, -1.0, 2.0]);
    let angle: f64 = 2.2;
    let turn = |[x, y, z]: [f64; 3]| {
        let (s, c) = angle.sin_cos();
        vector([c * x - s * y, s * x + c * y, z])
    };
    let plain = register()?;
    let turned = KovalevskayaTop::with_up(MOMENTS, turn([1.0, 0.0, 0.0]), turn(omega), turn(up))?;
    for t in [0.0, 1.0, 7.0, -3.0] {
        let (a, b) = (plain.omega_and_up(t)?, turned.omega_and_up(t)?);
        let expected = turn(a.omega.components().into());
        observed!((expected - b.omega).norm(), 1e-16..=5e-15, "{t}");
    }
    // The integral in general position is the one of the general top, squared.
    let top = turned.heavy_top()?;
    assert_eq!(top.kind(), Integrability::Kovalevskaya(2));
    let state = turned.omega_and_up(4.0)?;
    let integral = top.further_integral(&state).expect("hers");
    let off = relative(integral.value.sqrt(), 257_f64.sqrt() / 12.0);
    observed!(off, 0.0..=4e-15);
    // Off the plane there is no such top.
    let off = KovalevskayaTop::with_up(MOMENTS, vector([1.0, 0.0, 0.1]), vector(omega), vector(up));
    assert!(matches!(off, Err(Error::Condition { value: 0.1, .. })));
    Ok(())
}
