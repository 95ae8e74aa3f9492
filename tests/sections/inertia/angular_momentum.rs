//! 2.2: the velocity field of a rigid body and its angular momentum.

use super::*;

fn assert_close(computed: BodyVector, exact: [R; 3]) {
    let exact = Vector3::from(exact.map(self::exact));
    let difference = computed.components() - exact;
    let off = difference.amax() / exact.amax();
    assert!(off <= 4.0 * EPS, "{computed:?} {exact:?}");
}

#[test]
fn s2_2_velocity_field() {
    // claim: C2.2-1
    let motion = motion_about_origin();
    let p = [5, -7, 11].map(|x| whole(x as i128));
    let elsewhere = motion.seen_from(vector([5.0, -7.0, 11.0]));
    let (u, omega) = (U.map(whole), OMEGA.map(whole));
    // Small integers are exact in f64, so these are equalities.
    assert_close(elsewhere.velocity, add(u, cross(omega, p)));
    assert_eq!(elsewhere.omega, motion.omega);
    for x in POSITIONS {
        let point = vector(x.map(|x| x as f64));
        assert_eq!(motion.velocity_at(point), elsewhere.velocity_at(point));
        let expected = add(u, cross(omega, x.map(whole)));
        assert_close(motion.velocity_at(point), expected);
    }
}

#[test]
fn s2_2_angular_momentum_splits() -> Result<()> {
    // claim: C2.2-2
    let body = four_masses()?;
    let (center, expected) = (body.center().components(), Vector3::new(0.5, 0.6, 0.7));
    assert_relative_eq!(center, expected, max_relative = EPS, epsilon = EPS);
    let split = motion_about_origin().angular_momentum(&body)?;
    let integers = |v: [i128; 3]| v.map(whole);
    assert_close(split.of_motion, integers([32, -8, -16]));
    assert_close(split.of_rotation, integers([26, 8, -23]));
    assert_close(split.of_motion + split.of_rotation, integers([58, 0, -39]));
    assert_eq!(direct_sums(integers([0, 0, 0])).0, integers([58, 0, -39]));
    Ok(())
}

#[test]
fn s2_2_cross_term_drops() -> Result<()> {
    // claim: C2.2-3
    let body = four_masses()?;
    let center = [rational(1, 2), rational(3, 5), rational(7, 10)];
    let inertia = [[45, -10, -5], [-10, 46, 2], [-5, 2, 49]];
    let inertia = inertia.map(|row| row.map(|n| rational(n, 10)));
    for (i, row) in inertia.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            let computed = body.inertia().matrix()[(i, j)];
            assert!((computed - exact(*entry)).abs() <= 2.0 * EPS * 4.9);
        }
    }
    let omega = OMEGA.map(whole);
    let i_omega = inertia.map(|row| dot(row, omega));
    assert_eq!(direct_sums(center).0, i_omega, "L = I_C Ω in rationals");
    let motion = motion_about_origin().seen_from(body.center());
    assert_close(motion.velocity, [23, -39, 37].map(|n| rational(n, 10)));
    let split = motion.angular_momentum(&body)?;
    assert_eq!(split.of_motion, BodyVector::zero());
    assert_close(split.of_rotation, i_omega);
    // The other ways: U = 0, and U along C − O.
    let mut held = motion_about_origin();
    held.velocity = BodyVector::zero();
    assert_eq!(held.angular_momentum(&body)?.of_motion, BodyVector::zero());
    held.velocity = 2.0 * body.center();
    let along = held.angular_momentum(&body)?.of_motion;
    assert!(along.norm() <= 8.0 * EPS * body.mass());
    Ok(())
}

#[test]
fn s2_2_inertia_is_linear() {
    // claim: C2.2-4
    for (list, inertia, [a, b]) in swarms(24, 200, 7) {
        // ∫x∧(Ω∧x)ρ summed directly, for a sum of two angular velocities.
        let turned = |omega: BodyVector, x: BodyVector| x.cross(&omega.cross(&x));
        let direct = |omega| -> BodyVector {
            let parts = list.iter().map(|(m, x)| *m * turned(omega, vector(*x)));
            parts.sum()
        };
        let sum = inertia.angular_momentum(a) + inertia.angular_momentum(b);
        let size = inertia.matrix().amax();
        assert!((direct(a + b) - sum).norm() <= 30.0 * EPS * size);
        let basis = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(vector);
        for (j, e) in basis.into_iter().enumerate() {
            let column = direct(e).components();
            assert!((column - inertia.matrix().column(j)).amax() <= 8.0 * EPS * size);
        }
    }
}

#[test]
fn s2_2_dimensions() -> Result<()> {
    // claim: C2.2-5
    let list = Uniform(25).point_masses(5);
    let plain = particles(&list)?;
    // Units of mass 2³, length 2⁻⁵, time 2²: powers of two, so scaling is exact, bit for bit.
    let (a, b, c) = (8.0, 1.0 / 32.0, 4.0);
    let scaled = list.iter().map(|(m, x)| (a * m, x.map(|x| b * x)));
    let scaled = particles(&scaled.collect::<Vec<_>>())?.inertia();
    let (plain, omega) = (plain.inertia(), vector([0.3, -0.8, 0.5]));
    assert_eq!(scaled.matrix(), plain.matrix() * (a * b * b));
    let l = plain.angular_momentum(omega) * (a * b * b / c);
    assert_eq!(scaled.angular_momentum(omega / c), l);
    Ok(())
}

#[test]
fn s2_2_l_is_not_parallel_to_omega() -> Result<()> {
    // claim: C2.2-6
    let inertia = InertiaMatrix::diagonal(1.0, 2.0, 3.0)?;
    let moments = PrincipalMoments::new(1.0, 2.0, 3.0)?;
    let angle = inertia.angle_between_l_and_omega(vector([1.0, 1.0, 1.0]))?;
    close!(angle, 0.387_596_686_655_180_65, 2.0 * EPS);
    let bound = moments.greatest_angle();
    close!(bound, FRAC_PI_6, EPS);
    let attained = inertia.angle_between_l_and_omega(vector(moments.widest_omega()))?;
    close!(attained, bound, 4.0 * EPS);
    let mut uniform = Uniform(26);
    let mut widest = 0.0_f64;
    for _ in 0..20_000 {
        let omega = uniform.vector();
        let angle = inertia.angle_between_l_and_omega(omega)?;
        assert!(inertia.angular_momentum(omega).dot(&omega) > 0.0);
        assert!(angle <= bound * (1.0 + 4.0 * EPS));
        widest = widest.max(angle);
    }
    // The bound is sharp: random directions come within a thousandth.
    assert!(widest > 0.999 * bound, "{widest}");
    for e in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
        assert_eq!(inertia.angle_between_l_and_omega(vector(e))?, 0.0);
    }
    assert_eq!(PrincipalMoments::new(2.0, 2.0, 2.0)?.greatest_angle(), 0.0);
    // With a negative zero, too; and a rod's are right angles.
    let nothing = PrincipalMoments::new(-0.0, -0.0, 0.0)?;
    assert_eq!(nothing.greatest_angle(), 0.0);
    let rod = PrincipalMoments::new(-0.0, 1.0, 1.0)?;
    assert_eq!(rod.greatest_angle(), FRAC_PI_2);
    // A body that is all but round: sin 2φ δ/2 at the angle φ from the axis, to all digits.
    let round = InertiaMatrix::diagonal(1.0, 1.0 + 8.0 * EPS, 1.0)?;
    let angle = round.angle_between_l_and_omega(vector([0.6, 0.8, 0.0]))?;
    close!(angle, 0.48 * 8.0 * EPS, 0.0..=2e-15);
    // Nearly equal moments: the arccosine would give 0 or 1.5e-8 here; the angle is (I3−I1)/(I1+I3) to first order.
    let close = PrincipalMoments::new(1.0, 1.0, 1.0 + 8.0 * EPS)?.greatest_angle();
    close!(close, 4.0 * EPS, 3e-16..=1e-14);
    Ok(())
}
