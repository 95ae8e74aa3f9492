//! 2.7: Routh's rule, where it holds and where it fails.

use super::*;
use spinning_bodies::inertia::routh;
use support::inertia::{ellipsoid, fixed};

#[test]
fn s2_7_matrix_of_inertia() {
    // claim: C2.7-1, C2.8-2
    // A polynomial identity of degree 2 in x and 1 in Ω, on a grid that determines it.
    let range = [-2, -1, 0, 1, 3];
    for x in range {
        for y in range {
            for z in range {
                let point = [x, y, z].map(f64::from);
                let particle = InertiaMatrix::of_particle(1.0, vector(point)).unwrap();
                let [x, y, z] = point;
                let [xy, xz, yz] = [-x * y, -x * z, -y * z];
                let [xx, yy, zz] = [y * y + z * z, z * z + x * x, x * x + y * y];
                let expected = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
                assert_eq!(particle.matrix(), expected);
                let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
                for omega in axes.into_iter().chain([[2.0, 1.0, -1.0]]).map(vector) {
                    let double = vector(point).cross(&omega.cross(&vector(point)));
                    assert_eq!(particle.angular_momentum(omega), double);
                }
                // The second moments are x xᵀ, and lead back.
                let s = particle.second_moments();
                assert_eq!(s, Vector3::from(point) * Vector3::from(point).transpose());
            }
        }
    }
}

#[test]
fn s2_7_routh_rule_three() -> Result<()> {
    // claim: C2.7-2, C2.7-3
    use routh::Form::{Cuboid, Rectangle, Rod};
    let cases = [
        (Rectangle, [2.0, 3.0], rational(13, 3)),
        (Rectangle, [3.0, 0.0], whole(3)),
        (Cuboid, [3.0, 5.0], rational(34, 3)),
        (Rod, [2.0, 0.0], rational(4, 3)),
    ];
    for (form, semi_axes, expected) in cases {
        close!(routh::moment(1.0, form, semi_axes)?, exact(expected), EPS);
    }
    let box_entries = cubature([gauss(), gauss(), gauss()], |[a, b, c]| {
        ([2.0 * a, 3.0 * b, 5.0 * c], 1.0)
    });
    close!(box_entries[0], exact(rational(34, 3)), 16.0 * EPS);
    let flat = cubature([gauss(), gauss(), fixed(0.0)], |[a, b, c]| {
        ([2.0 * a, 3.0 * b, c], 1.0)
    });
    let across = routh::moment(1.0, Rectangle, [2.0, 3.0])?;
    close!(flat[2], across, 16.0 * EPS);
    assert_inertia(&shapes::rectangle_lamina(1.0, [4.0, 6.0])?, flat);
    Ok(())
}

#[test]
fn s2_7_routh_rule_four_and_five() -> Result<()> {
    // claim: C2.7-4, C2.7-5, C2.7-6
    use routh::Form::{Ellipse, Ellipsoid};
    for (form, axes, moment) in [
        (Ellipse, [2.0, 3.0], rational(13, 4)),
        (Ellipse, [3.0, 0.0], rational(9, 4)),
        (Ellipse, [1.0, 1.0], rational(1, 2)),
        (Ellipsoid, [3.0, 5.0], rational(34, 5)),
        (Ellipsoid, [1.0, 1.0], rational(2, 5)),
    ] {
        assert_eq!(routh::moment(1.0, form, axes)?, exact(moment));
    }
    let ellipse = cubature([unit_gauss(), circle(), fixed(0.0)], |[r, phi, z]| {
        ([2.0 * r * phi.cos(), 3.0 * r * phi.sin(), z], r)
    });
    assert_inertia(&shapes::ellipse_lamina(1.0, [2.0, 3.0])?, ellipse);
    let unequal = [2.0, 3.0, 5.0];
    let integrated = ellipsoid(unit_gauss(), unequal, 0.0);
    assert_inertia(&shapes::ellipsoid(1.0, unequal)?, integrated);
    let round = ellipsoid(unit_gauss(), [1.5; 3], 0.0);
    assert_inertia(&shapes::ball(4.0, 1.5)?, round);
    let ball = shapes::ball(1.0, 1.0)?.inertia().matrix();
    close!(ball[(0, 0)], exact(rational(2, 5)), EPS);
    Ok(())
}

#[test]
fn s2_7_shells() -> Result<()> {
    // claim: C2.7-7
    let shell = |inner| -> Result<f64> {
        Ok(shapes::thick_shell(1.0, inner, 1.0)?.inertia().matrix()[(2, 2)])
    };
    close!(shell(0.5)?, exact(rational(31, 70)), 2.0 * EPS);
    let ball = shapes::ball(1.0, 1.0)?.inertia().matrix();
    assert_eq!(shell(0.0)?, ball[(2, 2)]);
    close!(shell(1.0)?, exact(rational(2, 3)), EPS);
    let thin = ellipsoid(fixed(1.0), [1.0; 3], 0.0);
    assert_inertia(&shapes::spherical_shell(1.0, 1.0)?, thin);
    assert!(routh::moment(1.0, routh::Form::Hollow, [1.0, 1.0]).is_err());
    // Exact rationals along s → 1, where 1−s⁵ over 1−s³ as printed cancels; s = 1 − 2⁻ᵏ is a number.
    for k in 1..=25 {
        let s = whole(1) - rational(1, 1 << k);
        // The common factor is left out so that i128 holds the powers.
        let expected =
            rational(2, 5) * (ONE + s + s * s + s * s * s + s * s * s * s) / (ONE + s + s * s);
        close!(shell(exact(s))?, exact(expected), 3.0 * EPS);
    }
    // Mass times radius squared of the ball less that of the cavity: the difference of two balls.
    let (inner, outer) = (0.7_f64, 1.2_f64);
    let difference = 0.4 * (outer.powi(5) - inner.powi(5)) / (outer.powi(3) - inner.powi(3));
    let moment = shapes::thick_shell(1.0, inner, outer)?.inertia().matrix()[(0, 0)];
    close!(moment, difference, 8.0 * EPS);
    Ok(())
}

#[test]
fn s2_7_where_routh_fails() -> Result<()> {
    // claim: C2.7-8
    use routh::Form::{Cone, CylinderAboutItsAxis, CylinderAcross, Hollow, Triangle};
    for (form, name) in [
        (Cone, "a cone"),
        (CylinderAcross, "a cylinder about an axis across it"),
        (Hollow, "a hollow body"),
        (Triangle, "a triangle"),
    ] {
        let refused = routh::moment(1.0, form, [1.0, 1.0]);
        assert!(refused.clone().unwrap_err().to_string().contains(name));
        refused!(refused, RouthDoesNotApply);
    }
    let cylinder = shapes::cylinder(1.0, 1.0, 2.0)?.inertia().matrix();
    close!(cylinder[(0, 0)], exact(rational(7, 12)), EPS);
    let about_its_axis = routh::moment(1.0, CylinderAboutItsAxis, [1.0, 1.0])?;
    assert_eq!(about_its_axis, cylinder[(2, 2)]);
    let (radius, height) = (1.25, 3.0);
    let cone = shapes::cone(1.0, radius, height)?;
    let axial = cone.inertia().matrix()[(2, 2)];
    close!(axial, exact(rational(3, 10)) * radius * radius, 2.0 * EPS);
    let entries = cubature([unit_gauss(), circle(), unit_gauss()], |[r, phi, s]| {
        let rho = radius * r * (1.0 - s);
        let place = [rho * phi.cos(), rho * phi.sin(), height * (s - 0.25)];
        (place, r * (1.0 - s).powi(2))
    });
    assert_inertia(&cone, entries);
    let (ring, tube) = (2.0, 0.75);
    let entries = cubature([unit_gauss(), circle(), circle()], |[r, psi, phi]| {
        let rho = ring + tube * r * psi.cos();
        let place = [rho * phi.cos(), rho * phi.sin(), tube * r * psi.sin()];
        (place, r * rho)
    });
    assert_inertia(&shapes::torus(1.0, ring, tube)?, entries);
    Ok(())
}

#[test]
fn s2_7_why_three_four_five() -> Result<()> {
    // claim: C2.7-9
    for d in [1_u32, 2, 3, 4, 7] {
        // ⟨x²⟩ = ⟨r²⟩/d, and ⟨r²⟩ = ∫r^(d+1) / ∫r^(d−1) on 0..1: at most degree 8, so the rule is exact.
        let moment = |power: u32| -> f64 {
            let terms = unit_gauss().into_iter();
            terms.map(|(r, w)| w * r.powi(power as i32)).sum()
        };
        let quadrature = moment(d + 1) / moment(d - 1) / f64::from(d);
        close!(routh::mean_square(1.0, d)?, quadrature, 8.0 * EPS);
        close!(routh::mean_square(3.0, d)?, 9.0 * quadrature, 8.0 * EPS);
    }
    // One term a factor: the cylinder across is disc times rod.
    let cylinder = shapes::cylinder(1.0, 1.5, 4.0)?.inertia().matrix()[(0, 0)];
    let sum = routh::mean_square(1.5, 2)? + routh::mean_square(2.0, 1)?;
    close!(cylinder, sum, 2.0 * EPS);
    // The thin shell has a²/d instead: ⟨x²⟩ is half of its moment.
    let shell = shapes::spherical_shell(1.0, 1.0)?.inertia().matrix()[(0, 0)] / 2.0;
    close!(shell, 1.0 / 3.0, EPS);
    assert!(routh::mean_square(1.0, 0).is_err());
    Ok(())
}
