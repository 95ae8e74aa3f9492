//! 2.4: the matrix is symmetric; its axes, its moments, its ellipsoid.

use super::*;
use spinning_bodies::inertia::ellipsoid_of_inertia;

#[test]
fn s2_4_symmetric() {
    // claim: C2.4-1
    for (list, inertia, [a, b]) in swarms(41, 500, 6) {
        let parts = list.iter().map(|(m, x)| (m, vector(*x)));
        let parts = parts.map(|(m, x)| m * a.cross(&x).dot(&b.cross(&x)));
        let integral: f64 = parts.sum();
        let left = inertia.angular_momentum(a).dot(&b);
        let right = inertia.angular_momentum(b).dot(&a);
        let bound = 20.0 * EPS * inertia.matrix().amax();
        assert!((left - right).abs() <= bound && (left - integral).abs() <= bound);
        assert_eq!(inertia.matrix(), inertia.matrix().transpose());
    }
}

#[test]
fn s2_4_moment_about_an_axis() -> Result<()> {
    // claim: C2.4-3
    for (list, inertia, [axis, _]) in swarms(43, 500, 6) {
        let e = axis.direction("the axis")?;
        let away = |x: &[f64; 3]| e.cross(&vector(*x));
        let parts = list.iter().map(|(m, x)| m * away(x).dot(&away(x)));
        let difference = inertia.moment_about(axis)? - parts.sum::<f64>();
        assert!(difference.abs() <= 10.0 * EPS * inertia.matrix().amax());
    }
    Ok(())
}

#[test]
fn s2_4_any_top_is_an_ellipsoid() -> Result<()> {
    // claim: C2.4-4
    let axes = ellipsoid_of_inertia(1.0, &PrincipalMoments::new(2.0, 3.0, 4.0)?)?;
    for (a, expected) in axes.into_iter().zip([
        3.535_533_905_932_737_6,
        2.738_612_787_525_830_6,
        1.581_138_830_084_189_7,
    ]) {
        close!(a, expected, EPS);
    }
    let mut uniform = Uniform(44);
    for _ in 0..1000 {
        // Realisable moments are exactly the pairwise sums of three numbers that are not negative.
        let [x, y, z] = [0; 3].map(|_| uniform.next());
        let moments = PrincipalMoments::new(y + z, z + x, x + y)?;
        let mass = 0.5 + uniform.next();
        let axes = ellipsoid_of_inertia(mass, &moments)?;
        let again = shapes::ellipsoid(mass, axes)?.inertia().principal_axes();
        for (again, moment) in again.moments.into_iter().zip(moments.values()) {
            close!(again, moment, 8.0 * EPS);
        }
        // Ordered as Poinsot's ellipsoid, whose semi-axes are 1/√I, but not of its shape.
        assert!(axes[0] >= axes[1] && axes[1] >= axes[2]);
    }
    // Squares of axes may leave the range of doubles, axes do not.
    let unit = 2f64.powi(600);
    let small = PrincipalMoments::new(2.0 / unit, 3.0 / unit, 4.0 / unit)?;
    assert_eq!(ellipsoid_of_inertia(unit, &small)?, axes.map(|a| a / unit));
    let great = PrincipalMoments::new(1.7e308, 1.7e308, 1.7e308)?;
    close!(
        ellipsoid_of_inertia(2.5, &great)?[0],
        1.7e308_f64.sqrt(),
        EPS
    );
    // The condition: a lamina gives a flat ellipsoid; without the triangle inequality there is none.
    let lamina = PrincipalMoments::new(1.0, 2.0, 3.0)?;
    assert_eq!(ellipsoid_of_inertia(1.0, &lamina)?[2], 0.0);
    refused!(PrincipalMoments::new(1.0, 2.0, 3.1), TriangleInequality);
    Ok(())
}

#[test]
fn s2_4_which_moments_are_possible() {
    // claim: C2.4-5
    let mut uniform = Uniform(45);
    for _ in 0..1000 {
        let count = 2 + (uniform.next() * 6.0) as usize;
        let list = uniform.point_masses(count);
        let [a, b, c] = particles(&list).unwrap().inertia().principal_axes().moments;
        assert!(a >= 0.0 && c - b <= a + 8.0 * EPS * c);
        // Two masses lie on a line, three in a plane, more in neither.
        match count {
            2 => assert!(a <= 8.0 * EPS * c && c - b <= 8.0 * EPS * c),
            3 => assert!((a + b - c).abs() <= 8.0 * EPS * c && a > 1e-8 * c),
            _ => assert!(a + b - c > 1e-9 * c),
        }
    }
    let unreal = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, 2.001));
    assert!(InertiaMatrix::from_matrix(unreal).is_err());
    assert!(InertiaMatrix::from_matrix(-Matrix3::identity()).is_err());
}
