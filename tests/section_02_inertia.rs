//! Section 2, the inertia matrix: one test a claim. Truths are exact rationals, quadrature written here, point
//! sums, or another route through the library (a mesh against a formula).

use approx::assert_relative_eq;
use nalgebra::{Matrix3, Vector3};
use num_rational::Ratio;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::inertia::{
    InertiaMatrix, MassProperties, PlatonicSolid, PrincipalMoments, RigidMotion,
    ellipsoid_of_inertia, mesh_mass_properties, principal_axes_of, routh, shapes,
};
use spinning_bodies::{Error, Result};

#[path = "support/inertia.rs"]
mod support;
use support::{
    R, Uniform, assert_inertia, circle, cubature, exact, fixed, gauss, particles, rational,
    unit_gauss, vector,
};

const EPS: f64 = f64::EPSILON;

/// The four masses 1, 2, 3, 4 of 2.2.
const MASSES: [i128; 4] = [1, 2, 3, 4];
const POSITIONS: [[i128; 3]; 4] = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]];
const U: [i128; 3] = [1, -2, 3];
const OMEGA: [i128; 3] = [2, 1, -1];

fn four_masses() -> Result<MassProperties> {
    let list: Vec<_> = MASSES
        .iter()
        .zip(POSITIONS)
        .map(|(&m, x)| (m as f64, x.map(|x| x as f64)))
        .collect();
    particles(&list)
}

fn motion_about_origin() -> RigidMotion {
    RigidMotion {
        base: BodyVector::zero(),
        velocity: vector(U.map(|x| x as f64)),
        omega: vector(OMEGA.map(|x| x as f64)),
    }
}

fn cross(a: [R; 3], b: [R; 3]) -> [R; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn dot(a: [R; 3], b: [R; 3]) -> R {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn add(a: [R; 3], b: [R; 3]) -> [R; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn assert_close(computed: BodyVector, exact: [R; 3]) {
    let exact = exact.map(|x| *x.numer() as f64 / *x.denom() as f64);
    let size = exact.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    let difference = computed.components() - Vector3::from(exact);
    assert!(
        difference.amax() <= 4.0 * EPS * size,
        "{computed:?} {exact:?}"
    );
}

#[test]
fn s2_1_mass_as_a_coefficient() -> Result<()> {
    // claim: C2.1-1
    let particle = MassProperties::particle(3.0, BodyVector::zero())?;
    let energy = |v: f64| -> Result<(f64, f64)> {
        let motion = RigidMotion {
            base: BodyVector::zero(),
            velocity: BodyVector::new(v, 0.0, 0.0),
            omega: BodyVector::zero(),
        };
        Ok((
            motion.momentum(&particle).x(),
            motion.energy(&particle)?.total(),
        ))
    };
    for v in [-2.0, 0.0, 0.5, 4.0] {
        let (p, e) = energy(v)?;
        assert_eq!(p, 3.0 * v);
        assert_eq!(e, 1.5 * v * v);
        assert_relative_eq!(e, p * p / 6.0, max_relative = EPS, epsilon = 0.0);
        // A quadratic has its derivative as an exact central difference; the step is a power of two.
        let slope = (energy(v + 0.25)?.1 - energy(v - 0.25)?.1) / 0.5;
        assert_eq!(slope, p);
    }
    Ok(())
}

#[test]
fn s2_1_inertia_depends_on_the_axis() -> Result<()> {
    // claim: C2.1-2
    let inertia = shapes::cuboid(1.0, [4.0, 6.0, 10.0])?.inertia();
    for (axis, expected) in [
        ([1.0, 0.0, 0.0], rational(34, 3)),
        ([0.0, 1.0, 0.0], rational(29, 3)),
        ([0.0, 0.0, 1.0], rational(13, 3)),
    ] {
        let moment = inertia.moment_about(vector(axis))?;
        assert_relative_eq!(moment, exact(expected), max_relative = EPS, epsilon = 0.0);
    }
    Ok(())
}

#[test]
fn s2_2_velocity_field() {
    // claim: C2.2-1
    let motion = motion_about_origin();
    let p = [5, -7, 11].map(|x| Ratio::from_integer(x as i128));
    let elsewhere = motion.seen_from(vector([5.0, -7.0, 11.0]));
    let (u, omega) = (U.map(Ratio::from_integer), OMEGA.map(Ratio::from_integer));
    // Small integers are exact in f64, so these are equalities.
    assert_close(elsewhere.velocity, add(u, cross(omega, p)));
    assert_eq!(elsewhere.omega, motion.omega);
    for x in POSITIONS {
        let point = vector(x.map(|x| x as f64));
        assert_eq!(motion.velocity_at(point), elsewhere.velocity_at(point));
        assert_close(
            motion.velocity_at(point),
            add(u, cross(omega, x.map(Ratio::from_integer))),
        );
    }
}

/// Σ m x∧v and ½Σ m v², in rationals, for the four masses with base point `base`.
fn direct_sums(base: [R; 3]) -> ([R; 3], R) {
    let (u, omega) = (U.map(Ratio::from_integer), OMEGA.map(Ratio::from_integer));
    let mut l = [rational(0, 1); 3];
    let mut energy = rational(0, 1);
    for (m, x) in MASSES.into_iter().zip(POSITIONS) {
        let x = x.map(Ratio::from_integer);
        let v = add(u, cross(omega, x));
        let arm = [x[0] - base[0], x[1] - base[1], x[2] - base[2]];
        l = add(l, cross(arm, v).map(|c| c * m));
        energy += dot(v, v) * rational(m, 2);
    }
    (l, energy)
}

#[test]
fn s2_2_angular_momentum_splits() -> Result<()> {
    // claim: C2.2-2
    let body = four_masses()?;
    let about_origin = body.about(BodyVector::zero())?;
    let expected = Matrix3::new(13.0, -4.0, -4.0, -4.0, 12.0, -4.0, -4.0, -4.0, 11.0);
    assert!((about_origin.matrix() - expected).amax() <= 4e-15);
    assert_relative_eq!(
        body.center().components(),
        Vector3::new(0.5, 0.6, 0.7),
        max_relative = EPS,
        epsilon = EPS
    );
    let split = motion_about_origin().angular_momentum(&body)?;
    let integers = |v: [i128; 3]| v.map(Ratio::from_integer);
    assert_close(split.of_motion, integers([32, -8, -16]));
    assert_close(split.of_rotation, integers([26, 8, -23]));
    assert_close(split.total(), integers([58, 0, -39]));
    assert_eq!(direct_sums(integers([0, 0, 0])).0, integers([58, 0, -39]));
    Ok(())
}

#[test]
fn s2_2_cross_term_drops() -> Result<()> {
    // claim: C2.2-3
    let body = four_masses()?;
    let center = [rational(1, 2), rational(3, 5), rational(7, 10)];
    let inertia = [
        [rational(9, 2), rational(-1, 1), rational(-1, 2)],
        [rational(-1, 1), rational(23, 5), rational(1, 5)],
        [rational(-1, 2), rational(1, 5), rational(49, 10)],
    ];
    for (i, row) in inertia.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            let computed = body.inertia().matrix()[(i, j)];
            assert!((computed - exact(*entry)).abs() <= 2.0 * EPS * 4.9);
        }
    }
    let omega = OMEGA.map(Ratio::from_integer);
    let i_omega = inertia.map(|row| dot(row, omega));
    assert_eq!(direct_sums(center).0, i_omega, "L = I_C Ω in rationals");
    let motion = motion_about_origin().seen_from(body.center());
    assert_close(
        motion.velocity,
        [rational(23, 10), rational(-39, 10), rational(37, 10)],
    );
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
fn s2_2_inertia_is_linear() -> Result<()> {
    // claim: C2.2-4
    let mut uniform = Uniform(24);
    for _ in 0..200 {
        let list = uniform.point_masses(7);
        let inertia = particles(&list)?.about(BodyVector::zero())?;
        let (a, b) = (uniform.vector(), uniform.vector());
        // ∫x∧(Ω∧x)ρ summed directly, for a sum of two angular velocities.
        let direct = |omega: BodyVector| -> BodyVector {
            list.iter()
                .map(|(m, x)| *m * vector(*x).cross(&omega.cross(&vector(*x))))
                .sum()
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
    Ok(())
}

#[test]
fn s2_2_dimensions() -> Result<()> {
    // claim: C2.2-5
    let list = Uniform(25).point_masses(5);
    let plain = particles(&list)?;
    // Units of mass 2³, length 2⁻⁵, time 2²: powers of two, so scaling is exact, bit for bit.
    let (a, b, c) = (8.0, 1.0 / 32.0, 4.0);
    let scaled: Vec<_> = list
        .iter()
        .map(|(m, x)| (a * m, x.map(|x| b * x)))
        .collect();
    let scaled = particles(&scaled)?;
    let omega = vector([0.3, -0.8, 0.5]);
    assert_eq!(
        scaled.inertia().matrix(),
        plain.inertia().matrix() * (a * b * b)
    );
    assert_eq!(
        scaled.inertia().angular_momentum(omega / c),
        plain.inertia().angular_momentum(omega) * (a * b * b / c)
    );
    Ok(())
}

#[test]
fn s2_2_l_is_not_parallel_to_omega() -> Result<()> {
    // claim: C2.2-6
    let inertia = InertiaMatrix::diagonal(1.0, 2.0, 3.0)?;
    let moments = PrincipalMoments::new(1.0, 2.0, 3.0)?;
    let angle = inertia.angle_between_l_and_omega(vector([1.0, 1.0, 1.0]))?;
    assert_relative_eq!(
        angle,
        0.387_596_686_655_180_65,
        max_relative = 2.0 * EPS,
        epsilon = 0.0
    );
    let bound = moments.greatest_angle();
    assert_relative_eq!(
        bound,
        std::f64::consts::FRAC_PI_6,
        max_relative = EPS,
        epsilon = 0.0
    );
    let attained = inertia.angle_between_l_and_omega(vector(moments.widest_omega()))?;
    assert_relative_eq!(attained, bound, max_relative = 4.0 * EPS, epsilon = 0.0);
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
    // Nearly equal moments: the arccosine would give 0 or 1.5e-8 here; the angle is (I3−I1)/(I1+I3) to first order.
    let close = PrincipalMoments::new(1.0, 1.0, 1.0 + 8.0 * EPS)?.greatest_angle();
    assert_relative_eq!(close, 4.0 * EPS, max_relative = 1e-14, epsilon = 0.0);
    Ok(())
}

#[test]
fn s2_3_energy_splits_in_three() -> Result<()> {
    // claim: C2.3-1, C2.3-2
    let body = four_masses()?;
    let split = motion_about_origin().energy(&body)?;
    assert_eq!(split.of_motion, 70.0);
    assert_relative_eq!(split.cross, 72.0, max_relative = 2.0 * EPS, epsilon = 0.0);
    assert_relative_eq!(
        split.of_rotation,
        41.5,
        max_relative = 2.0 * EPS,
        epsilon = 0.0
    );
    assert_relative_eq!(
        split.total(),
        183.5,
        max_relative = 2.0 * EPS,
        epsilon = 0.0
    );
    assert_eq!(direct_sums([rational(0, 1); 3]).1, rational(367, 2));
    // About the centre the cross term is gone and the sum is the same.
    let centered = motion_about_origin()
        .seen_from(body.center())
        .energy(&body)?;
    assert_eq!(centered.cross, 0.0);
    assert_relative_eq!(
        centered.of_rotation,
        exact(rational(251, 20)),
        max_relative = 4.0 * EPS,
        epsilon = 0.0
    );
    assert_relative_eq!(
        centered.total(),
        183.5,
        max_relative = 4.0 * EPS,
        epsilon = 0.0
    );
    // And where U is perpendicular to Ω∧(C−O), though neither vanishes.
    let mut motion = motion_about_origin();
    motion.velocity = motion.omega;
    assert!(motion.energy(&body)?.cross.abs() <= 100.0 * EPS);
    Ok(())
}

#[test]
fn s2_3_energy_depends_on_direction() -> Result<()> {
    // claim: C2.3-3
    let mut uniform = Uniform(33);
    let turn = uniform.attitude();
    let tilted = InertiaMatrix::diagonal(1.0, 2.0, 2.5)?.rotated(&turn);
    let axes = tilted.principal_axes();
    let (mut low, mut high) = (f64::INFINITY, 0.0_f64);
    for _ in 0..20_000 {
        let energy = tilted.rotational_energy(uniform.vector().direction("omega")?);
        (low, high) = (low.min(energy), high.max(energy));
    }
    assert!((0.5 * (1.0 - 8.0 * EPS)..0.51).contains(&low));
    assert!(high <= 1.25 * (1.0 + 8.0 * EPS) && high > 1.245);
    for (k, expected) in [(0, 0.5), (1, 1.0), (2, 1.25)] {
        let e = BodyVector::from_components(axes.axes().column(k).into_owned());
        assert_relative_eq!(
            tilted.rotational_energy(e),
            expected,
            max_relative = 8.0 * EPS,
            epsilon = 0.0
        );
    }
    Ok(())
}

#[test]
fn s2_4_symmetric() -> Result<()> {
    // claim: C2.4-1
    let mut uniform = Uniform(41);
    for _ in 0..500 {
        let list = uniform.point_masses(6);
        let inertia = particles(&list)?.about(BodyVector::zero())?;
        let (a, b) = (uniform.vector(), uniform.vector());
        let integral: f64 = list
            .iter()
            .map(|(m, x)| m * a.cross(&vector(*x)).dot(&b.cross(&vector(*x))))
            .sum();
        let (left, right) = (
            inertia.angular_momentum(a).dot(&b),
            inertia.angular_momentum(b).dot(&a),
        );
        let bound = 20.0 * EPS * inertia.matrix().amax();
        assert!((left - right).abs() <= bound && (left - integral).abs() <= bound);
        assert_eq!(inertia.matrix(), inertia.matrix().transpose());
    }
    Ok(())
}

#[test]
fn s2_4_principal_axes_exist() -> Result<()> {
    // claim: C2.4-2
    let inertia = four_masses()?.inertia();
    let principal = inertia.principal_axes();
    let expected = [
        3.509_198_310_154_528_3,
        4.672_222_350_831_977,
        5.818_579_339_013_495,
    ];
    for (moment, expected) in principal.moments().into_iter().zip(expected) {
        assert!((moment - expected).abs() <= 1e-15 * 5.82);
        // A root of the characteristic polynomial: its coefficients are rational.
        let (x, p) = (moment, inertia.matrix());
        let characteristic = (p - Matrix3::from_diagonal_element(x)).determinant();
        assert!(characteristic.abs() < 1e-14, "{characteristic:e}");
    }
    let v = principal.axes();
    assert!((v.transpose() * v - Matrix3::identity()).amax() <= 1e-15);
    assert!(v.determinant() > 0.0);
    let again = v * Matrix3::from_diagonal(&principal.moments().into()) * v.transpose();
    assert!((again - inertia.matrix()).amax() <= 1e-15 * 5.82);
    Ok(())
}

#[test]
fn s2_4_moment_about_an_axis() -> Result<()> {
    // claim: C2.4-3
    let mut uniform = Uniform(43);
    for _ in 0..500 {
        let list = uniform.point_masses(6);
        let inertia = particles(&list)?.about(BodyVector::zero())?;
        let axis = uniform.vector();
        let e = axis.direction("the axis")?;
        let distances: f64 = list
            .iter()
            .map(|(m, x)| {
                let away = e.cross(&vector(*x));
                m * away.dot(&away)
            })
            .sum();
        let difference = inertia.moment_about(axis)? - distances;
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
        assert_relative_eq!(a, expected, max_relative = EPS, epsilon = 0.0);
    }
    let mut uniform = Uniform(44);
    for _ in 0..1000 {
        // Realisable moments are exactly the pairwise sums of three numbers that are not negative.
        let [x, y, z] = [0; 3].map(|_| uniform.next());
        let moments = PrincipalMoments::new(y + z, z + x, x + y)?;
        let mass = 0.5 + uniform.next();
        let axes = ellipsoid_of_inertia(mass, &moments)?;
        let again = shapes::ellipsoid(mass, axes)?
            .inertia()
            .principal_axes()
            .moments();
        for (again, moment) in again.into_iter().zip(moments.values()) {
            assert_relative_eq!(again, moment, max_relative = 8.0 * EPS, epsilon = 0.0);
        }
        // Ordered as Poinsot's ellipsoid, whose semi-axes are 1/√I, but not of its shape.
        assert!(axes[0] >= axes[1] && axes[1] >= axes[2]);
    }
    // The condition: a lamina gives a flat ellipsoid; without the triangle inequality there is none.
    assert_eq!(
        ellipsoid_of_inertia(1.0, &PrincipalMoments::new(1.0, 2.0, 3.0)?)?[2],
        0.0
    );
    assert!(matches!(
        PrincipalMoments::new(1.0, 2.0, 3.1),
        Err(Error::TriangleInequality { .. })
    ));
    Ok(())
}

#[test]
fn s2_4_which_moments_are_possible() -> Result<()> {
    // claim: C2.4-5
    let mut uniform = Uniform(45);
    for _ in 0..1000 {
        let count = 2 + (uniform.next() * 6.0) as usize;
        let list = uniform.point_masses(count);
        let [a, b, c] = particles(&list)?.inertia().principal_axes().moments();
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
    Ok(())
}

/// Six masses on the axes and eight at the corners of a box, both with moments 2, 3, 4 (2.5).
fn six_and_eight() -> [Vec<(f64, [f64; 3])>; 2] {
    let s = [2.5_f64, 1.5, 0.5];
    let mut six = Vec::new();
    for k in 0..3 {
        for sign in [-1.0, 1.0] {
            let mut x = [0.0; 3];
            x[k] = sign * (3.0 * s[k]).sqrt();
            six.push((1.0 / 6.0, x));
        }
    }
    let corner = |n: usize| {
        let sign = |k: usize| if n >> k & 1 == 0 { 1.0 } else { -1.0 };
        (0.125, [0, 1, 2].map(|k| sign(k) * s[k].sqrt()))
    };
    [six, (0..8).map(corner).collect()]
}

#[test]
fn s2_5_different_bodies_same_inertia() -> Result<()> {
    // claim: C2.5-1
    let [six, eight] = six_and_eight();
    for (n, expected) in [
        (0, 2.738_612_787_525_830_6),
        (2, 2.121_320_343_559_642_6),
        (4, 1.224_744_871_391_589_1),
    ] {
        let distance = six[n].1[n / 2].abs();
        assert_relative_eq!(distance, expected, max_relative = EPS, epsilon = 0.0);
    }
    for list in [six, eight] {
        let body = particles(&list)?;
        assert_inertia(&body, [2.0, 3.0, 4.0, 0.0, 0.0, 0.0]);
        assert!(body.center().norm() <= 2.0 * EPS);
    }
    let radius = 1.7;
    let ball = shapes::ball(1.0, radius)?.inertia().matrix();
    let shell = shapes::spherical_shell(1.0, radius * 0.6_f64.sqrt())?
        .inertia()
        .matrix();
    assert_relative_eq!(ball, shell, max_relative = 4.0 * EPS, epsilon = 0.0);
    Ok(())
}

#[test]
fn s2_5_only_the_ellipsoid_is_seen() -> Result<()> {
    // claim: C2.5-2
    let [six, eight] = six_and_eight();
    let torque =
        |list: &[(f64, [f64; 3])], field: &dyn Fn(BodyVector) -> BodyVector| -> BodyVector {
            list.iter()
                .map(|(m, x)| *m * vector(*x).cross(&field(vector(*x))))
                .sum()
        };
    // Any linear field: equal torques, and the torque that the inertia matrix alone predicts.
    let mut uniform = Uniform(52);
    let inertia = InertiaMatrix::diagonal(2.0, 3.0, 4.0)?;
    for _ in 0..200 {
        let a = Matrix3::from_fn(|_, _| uniform.signed());
        let linear = |x: BodyVector| BodyVector::from_components(a * x.components());
        let predicted = inertia.torque_in_linear_field(&a);
        for list in [&six, &eight] {
            assert!((torque(list, &linear) - predicted).norm() <= 16.0 * EPS * 2.5);
        }
    }
    // The condition: in the cubic field f = −x³ẑ, at a tilt of 0.4 about y, they part.
    let tilt = Attitude::about_axis(BodyVector::new(0.0, 1.0, 0.0), 0.4)?;
    let cubic = |list: &[(f64, [f64; 3])]| -> f64 {
        list.iter()
            .map(|(m, x)| {
                let x = tilt.to_space(vector(*x));
                // N_y = z f_x − x f_z with f = (0, 0, −x³).
                m * x.x() * x.x().powi(3)
            })
            .sum()
    };
    assert_relative_eq!(
        cubic(&six),
        13.511_686_548_515_098,
        max_relative = 8.0 * EPS,
        epsilon = 0.0
    );
    assert_relative_eq!(
        cubic(&eight),
        5.468_770_068_329_157,
        max_relative = 8.0 * EPS,
        epsilon = 0.0
    );
    Ok(())
}

#[test]
fn s2_6_box() -> Result<()> {
    // claim: C2.6-1
    let edges = [4.0, 6.0, 10.0];
    let body = shapes::cuboid(2.0, edges)?;
    let entries = cubature([gauss(), gauss(), gauss()], |[a, b, c]| {
        ([2.0 * a, 3.0 * b, 5.0 * c], 1.0)
    });
    assert_inertia(&body, entries);
    assert_eq!(body.inertia().matrix()[(0, 1)], 0.0);
    // The same box as a mesh, in axes that do not suit it: the principal axes find its edges.
    let turn = Uniform(61).attitude();
    let vertices: Vec<[f64; 3]> = PlatonicSolid::Cube
        .vertices(1.0)?
        .into_iter()
        .map(|v| {
            turn.to_space(vector([0, 1, 2].map(|i| v[i] * edges[i])))
                .components()
                .into()
        })
        .collect();
    let tilted = mesh_mass_properties(&vertices, &PlatonicSolid::Cube.triangles(), 2.0 / 240.0)?;
    let principal = tilted.inertia().principal_axes();
    for (column, k) in [(0, 2), (1, 1), (2, 0)] {
        let mut edge = [0.0; 3];
        edge[k] = 1.0;
        let edge = turn.to_space(vector(edge)).components();
        let sine = principal.axes().column(column).cross(&edge).norm();
        assert!(sine <= 1e-14, "{sine:e}");
    }
    Ok(())
}

#[test]
fn s2_6_cylinder() -> Result<()> {
    // claim: C2.6-2
    let (radius, height) = (1.5, 2.0);
    let body = shapes::cylinder(3.0, radius, height)?;
    let across = rational(3 * 9, 4) + rational(4, 1);
    let across = exact(across / 12);
    assert_inertia(&body, [across, across, 1.125, 0.0, 0.0, 0.0]);
    let entries = cubature([unit_gauss(), circle(), gauss()], |[r, phi, u]| {
        let (sine, cosine) = phi.sin_cos();
        (
            [radius * r * cosine, radius * r * sine, 0.5 * height * u],
            r,
        )
    });
    assert_inertia(&body, entries);
    let mut uniform = Uniform(62);
    for _ in 0..50 {
        let phi = 7.0 * uniform.next();
        let angle =
            body.inertia()
                .angle_between_l_and_omega(vector([phi.cos(), phi.sin(), 0.0]))?;
        assert!(angle <= 2.0 * EPS);
    }
    // h = √3 R is inertially a ball.
    let ball = shapes::cylinder(1.0, 1.0, 3.0_f64.sqrt())?
        .inertia()
        .matrix();
    assert_relative_eq!(
        ball,
        Matrix3::identity() * 0.5,
        max_relative = 2.0 * EPS,
        epsilon = 0.0
    );
    Ok(())
}

#[test]
fn s2_6_equilateral_lamina() -> Result<()> {
    // claim: C2.6-3
    let h = 0.75_f64.sqrt();
    let lamina = shapes::triangle_lamina(1.0, [[0.0, 0.0], [1.0, 0.0], [0.5, h]])?;
    let (flat, normal) = (exact(rational(1, 24)), exact(rational(1, 12)));
    assert_inertia(&lamina, [flat, flat, normal, 0.0, 0.0, 0.0]);
    assert_relative_eq!(
        lamina.center().y(),
        h / 3.0,
        max_relative = EPS,
        epsilon = 0.0
    );
    let again = shapes::regular_polygon_lamina(1.0, 3, 3.0_f64.sqrt().recip())?;
    assert_inertia(&again, [flat, flat, normal, 0.0, 0.0, 0.0]);
    // A thin prism over the triangle, as a mesh: its thickness t adds t²/12 to the in-plane moments.
    let t = 1.0 / 1024.0;
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, h]];
    let vertices: Vec<_> = [0.0, t]
        .into_iter()
        .flat_map(|z| corners.map(|[x, y]| [x, y, z]))
        .collect();
    let triangles = [
        [0, 2, 1],
        [3, 4, 5],
        [0, 1, 4],
        [0, 4, 3],
        [1, 2, 5],
        [1, 5, 4],
        [2, 0, 3],
        [2, 3, 5],
    ];
    let prism = mesh_mass_properties(&vertices, &triangles, 1.0)?;
    let thick = flat + t * t / 12.0;
    assert_inertia(&prism, [thick, thick, normal, 0.0, 0.0, 0.0]);
    // A scalene triangle is not of revolution; its corners may be weighed as three masses M/12 and 3M/4 at the centroid.
    let corners = [[0.0, 0.0], [3.0, 0.0], [1.0, 2.0]];
    let scalene = shapes::triangle_lamina(12.0, corners)?;
    let mut masses: Vec<_> = corners.iter().map(|[x, y]| (1.0, [*x, *y, 0.0])).collect();
    masses.push((9.0, [4.0 / 3.0, 2.0 / 3.0, 0.0]));
    let weighed = particles(&masses)?.inertia().matrix();
    assert_relative_eq!(
        scalene.inertia().matrix(),
        weighed,
        max_relative = 8.0 * EPS,
        epsilon = 8.0 * EPS
    );
    let [i1, i2, _] = scalene.inertia().principal_axes().moments();
    assert!(i2 > 1.5 * i1);
    Ok(())
}

/// A symmetric matrix with random entries, made an inertia matrix by its second moments: S = A Aᵀ.
fn random_inertia(uniform: &mut Uniform) -> Result<InertiaMatrix> {
    let a = Matrix3::from_fn(|_, _| uniform.signed());
    InertiaMatrix::from_second_moments(a * a.transpose())
}

/// Mean of R I Rᵀ over the turns by 2πk/n about an axis, summed one by one.
fn mean_over_turns(inertia: &InertiaMatrix, axis: BodyVector, order: u32) -> Result<Matrix3<f64>> {
    let mut sum = Matrix3::zeros();
    for k in 0..order {
        let angle = std::f64::consts::TAU * f64::from(k) / f64::from(order);
        sum += inertia
            .rotated(&Attitude::about_axis(axis, angle)?)
            .matrix();
    }
    Ok(sum / f64::from(order))
}

#[test]
fn s2_6_symmetry_of_order_above_two() -> Result<()> {
    // claim: C2.6-4, C2.6-6
    let mut uniform = Uniform(64);
    for _ in 0..50 {
        let inertia = random_inertia(&mut uniform)?;
        let axis = uniform.vector();
        let e = axis.direction("the axis")?.components();
        for order in 1..=6 {
            let averaged = inertia.averaged_over_rotations(axis, order)?.matrix();
            let summed = mean_over_turns(&inertia, axis, order)?;
            let size = averaged.amax();
            assert!((averaged - summed).amax() <= 16.0 * EPS * size);
            // Of revolution about e: I = a δ + (c − a) e eᵀ.
            let c = e.dot(&(averaged * e));
            let a = 0.5 * (averaged.trace() - c);
            let revolution = Matrix3::identity() * a + e * e.transpose() * (c - a);
            let defect = (averaged - revolution).amax();
            if order >= 3 {
                assert!(defect <= 16.0 * EPS * size, "order {order}: {defect:e}");
            } else {
                // Order 2 does not suffice: an ellipsoid with three different axes has no more.
                assert!(defect > 1e-3 * size, "order {order}: {defect:e}");
            }
        }
    }
    let ellipsoid = shapes::ellipsoid(1.0, [1.0, 2.0, 3.0])?.inertia();
    for axis in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(vector) {
        assert_eq!(ellipsoid.averaged_over_rotations(axis, 2)?, ellipsoid);
        for order in 3..=6 {
            let changed = ellipsoid.averaged_over_rotations(axis, order)?.matrix();
            assert!((changed - ellipsoid.matrix()).amax() > 0.1);
        }
    }
    Ok(())
}

#[test]
fn s2_6_two_axes_make_a_ball() -> Result<()> {
    // claim: C2.6-5
    let (a, c) = (2.0, 3.25);
    let about = |e: Vector3<f64>| Matrix3::identity() * a + e * e.transpose() * (c - a);
    let first = about(Vector3::z());
    for u in [0.0, 1e-8, 0.1, 0.7, 1.5] {
        let other = Vector3::new(f64::sin(u), 0.0, f64::cos(u));
        let turn = Attitude::about_axis(vector(other.into()), 2.0 * std::f64::consts::PI / 3.0)?;
        let r = *turn.quaternion().to_rotation_matrix().matrix();
        // A matrix with both symmetries commutes with this turn; `first` does so only if u = 0 or a = c.
        let misfit = (r * first - first * r).norm();
        // Commutator of the two projectors: its squared norm is 2 sin²u cos²u.
        let commutator = first * about(other) - about(other) * first;
        let expected = 2.0_f64.sqrt() * (c - a).powi(2) * u.sin() * u.cos();
        assert!((commutator.norm() - expected).abs() <= 16.0 * EPS * c * c);
        // The register's form, 2(a−c)² sin²u, is the commutator with the rotation's generator about the other axis.
        let generator = other.cross_matrix();
        let spin = (first * generator - generator * first).norm_squared();
        let closed = 2.0 * (a - c).powi(2) * u.sin().powi(2);
        assert!(
            (spin - closed).abs() <= 32.0 * EPS * closed.max(1e-16),
            "{spin} {closed}"
        );
        assert_eq!(misfit > 1e-12, u > 0.0);
    }
    // Averaging over both symmetries in turn drives any body to a ball, at the rate ((3cos²u − 1)/2)² a round.
    let mut inertia = random_inertia(&mut Uniform(65))?;
    let u: f64 = 1.1;
    let other = vector([u.sin(), 0.0, u.cos()]);
    let mut defects = Vec::new();
    for _ in 0..40 {
        inertia = inertia.averaged_over_rotations(vector([0.0, 0.0, 1.0]), 3)?;
        inertia = inertia.averaged_over_rotations(other, 5)?;
        let mean = Matrix3::identity() * (inertia.matrix().trace() / 3.0);
        defects.push((inertia.matrix() - mean).norm());
    }
    let rate = ((3.0 * u.cos().powi(2) - 1.0) / 2.0).powi(2);
    assert_relative_eq!(
        defects[3] / defects[2],
        rate,
        max_relative = 1e-9,
        epsilon = 0.0
    );
    assert!(defects[39] <= 16.0 * EPS);
    Ok(())
}

#[test]
fn s2_6_cube_quiz() -> Result<()> {
    // claim: C2.6-7
    let (mass, edge) = (3.0, 2.0);
    let size = mass * edge * edge;
    let vertices = PlatonicSolid::Cube.vertices(edge)?;
    let corners: Vec<_> = vertices.iter().map(|&v| (mass / 8.0, v)).collect();
    let mesh = mesh_mass_properties(&vertices, &PlatonicSolid::Cube.triangles(), mass / 8.0)?;
    let solid = rational(1, 6);
    for (body, factor) in [
        (shapes::platonic(PlatonicSolid::Cube, mass, edge)?, solid),
        (shapes::cuboid(mass, [edge; 3])?, solid),
        (mesh, solid),
        (shapes::hollow_cube(mass, edge)?, rational(5, 18)),
        (shapes::wire_cube(mass, edge)?, rational(7, 18)),
        (particles(&corners)?, rational(1, 2)),
    ] {
        for axis in [
            [1.0, 1.0, 1.0],
            [1.0, 1.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.3, -0.5, 0.9],
        ] {
            let moment = body.inertia().moment_about(vector(axis))?;
            assert_relative_eq!(
                moment,
                size * exact(factor),
                max_relative = 8.0 * EPS,
                epsilon = 0.0
            );
        }
    }
    // Hollow and wire cubes again, composed of six laminae and of twelve rods.
    // A quarter turn that carries z to the axis.
    let turned = |body: MassProperties, axis: usize| -> Result<MassProperties> {
        let about = match axis {
            0 => [0.0, 1.0, 0.0],
            1 => [-1.0, 0.0, 0.0],
            _ => return Ok(body),
        };
        Ok(body.turned(&Attitude::about_axis(
            vector(about),
            std::f64::consts::FRAC_PI_2,
        )?))
    };
    let (mut faces, mut rods) = (Vec::new(), Vec::new());
    for axis in 0..3 {
        for s in [-1.0, 1.0] {
            let mut at = [0.0; 3];
            at[axis] = s;
            let face = shapes::rectangle_lamina(mass / 6.0, [edge; 2])?;
            faces.push(turned(face, axis)?.moved(vector(at))?);
            for t in [-1.0, 1.0] {
                let mut at = [s; 3];
                at[(axis + 1) % 3] = t;
                at[axis] = 0.0;
                rods.push(turned(shapes::rod(mass / 12.0, edge)?, axis)?.moved(vector(at))?);
            }
        }
    }
    for (parts, factor) in [(faces, rational(5, 18)), (rods, rational(7, 18))] {
        let entry = exact(factor) * edge * edge;
        assert_inertia(
            &MassProperties::compose(&parts)?,
            [entry, entry, entry, 0.0, 0.0, 0.0],
        );
    }
    // By cubature, about a vertex axis, an edge axis and a face axis.
    let half = 0.5 * edge;
    let entries = cubature([gauss(), gauss(), gauss()], |x| (x.map(|x| half * x), 1.0));
    assert_inertia(&shapes::cuboid(mass, [edge; 3])?, entries);
    // Through the centre only: about an edge it is 2Ma²/3.
    let about_edge = shapes::cuboid(mass, [edge; 3])?
        .about(vector([half, half, 0.0]))?
        .moment_about(vector([0.0, 0.0, 1.0]))?;
    assert_relative_eq!(
        about_edge,
        size * 2.0 / 3.0,
        max_relative = 4.0 * EPS,
        epsilon = 0.0
    );
    Ok(())
}

#[test]
fn s2_6_platonic_solids() -> Result<()> {
    // claim: C2.6-8
    let root5 = 5.0_f64.sqrt();
    let closed = [
        1.0 / 20.0,
        1.0 / 6.0,
        1.0 / 10.0,
        (95.0 + 39.0 * root5) / 300.0,
        (3.0 + root5) / 20.0,
    ];
    let digits = [
        0.05,
        1.0 / 6.0,
        0.1,
        0.607_355_503_741_639_3,
        0.261_803_398_874_989_5,
    ];
    for ((solid, closed), digits) in PlatonicSolid::ALL.into_iter().zip(closed).zip(digits) {
        assert_relative_eq!(
            solid.inertia_factor(),
            closed,
            max_relative = 2.0 * EPS,
            epsilon = 0.0
        );
        assert_eq!(solid.inertia_factor(), digits);
        let edge = 1.3;
        let vertices = solid.vertices(edge)?;
        // Every face has edges of that length, and all vertices are equally far from the centre.
        for face in solid.faces() {
            for (i, &a) in face.iter().enumerate() {
                let b = face[(i + 1) % face.len()];
                let side = vector(vertices[a as usize]) - vector(vertices[b as usize]);
                assert_relative_eq!(side.norm(), edge, max_relative = 4.0 * EPS, epsilon = 0.0);
            }
        }
        let body = mesh_mass_properties(&vertices, &solid.triangles(), 1.0)?;
        assert!(body.center().norm() <= 4.0 * EPS);
        let formula = shapes::platonic(solid, body.mass(), edge)?
            .inertia()
            .matrix();
        assert!((body.inertia().matrix() - formula).amax() <= 8.0 * EPS * formula.amax());
    }
    Ok(())
}

#[test]
fn s2_7_matrix_of_inertia() -> Result<()> {
    // claim: C2.7-1
    // A polynomial identity of degree 2 in x and 1 in Ω, on a grid that determines it.
    let range = [-2, -1, 0, 1, 3];
    for x in range {
        for y in range {
            for z in range {
                let point = [x, y, z].map(f64::from);
                let particle = InertiaMatrix::of_particle(1.0, vector(point))?;
                let [x, y, z] = point;
                let expected = Matrix3::new(
                    y * y + z * z,
                    -x * y,
                    -x * z,
                    -x * y,
                    z * z + x * x,
                    -y * z,
                    -x * z,
                    -y * z,
                    x * x + y * y,
                );
                assert_eq!(particle.matrix(), expected);
                for omega in [
                    [1.0, 0.0, 0.0],
                    [0.0, 1.0, 0.0],
                    [0.0, 0.0, 1.0],
                    [2.0, 1.0, -1.0],
                ]
                .map(vector)
                {
                    let double = vector(point).cross(&omega.cross(&vector(point)));
                    assert_eq!(particle.angular_momentum(omega), double);
                }
                // The second moments are x xᵀ, and lead back.
                let s = particle.second_moments();
                assert_eq!(s, Vector3::from(point) * Vector3::from(point).transpose());
            }
        }
    }
    Ok(())
}

#[test]
fn s2_7_routh_rule_three() -> Result<()> {
    // claim: C2.7-2, C2.7-3
    use routh::Form::{Cuboid, Rectangle, Rod};
    let cases = [
        (Rectangle, [2.0, 3.0], rational(13, 3)),
        (Rectangle, [3.0, 0.0], rational(3, 1)),
        (Cuboid, [3.0, 5.0], rational(34, 3)),
        (Rod, [2.0, 0.0], rational(4, 3)),
    ];
    for (form, semi_axes, expected) in cases {
        assert_relative_eq!(
            routh::moment(1.0, form, semi_axes)?,
            exact(expected),
            max_relative = EPS,
            epsilon = 0.0
        );
    }
    let box_entries = cubature([gauss(), gauss(), gauss()], |[a, b, c]| {
        ([2.0 * a, 3.0 * b, 5.0 * c], 1.0)
    });
    assert_relative_eq!(
        box_entries[0],
        exact(rational(34, 3)),
        max_relative = 16.0 * EPS,
        epsilon = 0.0
    );
    let flat = cubature([gauss(), gauss(), fixed(0.0)], |[a, b, c]| {
        ([2.0 * a, 3.0 * b, c], 1.0)
    });
    assert_relative_eq!(
        flat[2],
        routh::moment(1.0, Rectangle, [2.0, 3.0])?,
        max_relative = 16.0 * EPS,
        epsilon = 0.0
    );
    assert_inertia(&shapes::rectangle_lamina(1.0, [4.0, 6.0])?, flat);
    // About a square's diagonal the moment is Ma²/3; the rule with the half-diagonal, √2 a, would say 2Ma²/3.
    let square = shapes::rectangle_lamina(1.0, [2.0, 2.0])?.inertia();
    let diagonal = square.moment_about(vector([1.0, 1.0, 0.0]))?;
    assert_relative_eq!(diagonal, 1.0 / 3.0, max_relative = 2.0 * EPS, epsilon = 0.0);
    let wrong = routh::moment(1.0, Rectangle, [2.0_f64.sqrt(), 0.0])?;
    assert_relative_eq!(wrong, 2.0 / 3.0, max_relative = 2.0 * EPS, epsilon = 0.0);
    Ok(())
}

#[test]
fn s2_7_routh_rule_four_and_five() -> Result<()> {
    // claim: C2.7-4, C2.7-5, C2.7-6
    use routh::Form::{Ellipse, Ellipsoid};
    assert_eq!(
        routh::moment(1.0, Ellipse, [2.0, 3.0])?,
        exact(rational(13, 4))
    );
    assert_eq!(
        routh::moment(1.0, Ellipse, [3.0, 0.0])?,
        exact(rational(9, 4))
    );
    assert_eq!(routh::moment(1.0, Ellipse, [1.0, 1.0])?, 0.5);
    assert_eq!(
        routh::moment(1.0, Ellipsoid, [3.0, 5.0])?,
        exact(rational(34, 5))
    );
    assert_eq!(
        routh::moment(1.0, Ellipsoid, [1.0, 1.0])?,
        exact(rational(2, 5))
    );
    let ellipse = cubature([unit_gauss(), circle(), fixed(0.0)], |[r, phi, z]| {
        ([2.0 * r * phi.cos(), 3.0 * r * phi.sin(), z], r)
    });
    assert_inertia(&shapes::ellipse_lamina(1.0, [2.0, 3.0])?, ellipse);
    let ellipsoid = |axes: [f64; 3]| {
        cubature([unit_gauss(), gauss(), circle()], move |[r, u, phi]| {
            let sine = (1.0 - u * u).sqrt();
            let point = [r * sine * phi.cos(), r * sine * phi.sin(), r * u];
            ([0, 1, 2].map(|i| axes[i] * point[i]), r * r)
        })
    };
    assert_inertia(
        &shapes::ellipsoid(1.0, [2.0, 3.0, 5.0])?,
        ellipsoid([2.0, 3.0, 5.0]),
    );
    assert_inertia(&shapes::ball(4.0, 1.5)?, ellipsoid([1.5; 3]));
    assert_relative_eq!(
        shapes::ball(1.0, 1.0)?.inertia().matrix()[(0, 0)],
        exact(rational(2, 5)),
        max_relative = EPS,
        epsilon = 0.0
    );
    Ok(())
}

#[test]
fn s2_7_shells() -> Result<()> {
    // claim: C2.7-7
    let shell = |inner| -> Result<f64> {
        Ok(shapes::thick_shell(1.0, inner, 1.0)?.inertia().matrix()[(2, 2)])
    };
    assert_relative_eq!(
        shell(0.5)?,
        exact(rational(31, 70)),
        max_relative = 2.0 * EPS,
        epsilon = 0.0
    );
    assert_eq!(
        shell(0.0)?,
        shapes::ball(1.0, 1.0)?.inertia().matrix()[(2, 2)]
    );
    assert_relative_eq!(
        shell(1.0)?,
        exact(rational(2, 3)),
        max_relative = EPS,
        epsilon = 0.0
    );
    let thin = cubature([fixed(1.0), gauss(), circle()], |[r, u, phi]| {
        let sine = (1.0 - u * u).sqrt();
        ([r * sine * phi.cos(), r * sine * phi.sin(), r * u], 1.0)
    });
    assert_inertia(&shapes::spherical_shell(1.0, 1.0)?, thin);
    assert!(routh::moment(1.0, routh::Form::Hollow, [1.0, 1.0]).is_err());
    // Exact rationals along s → 1, where 1−s⁵ over 1−s³ as printed cancels; s = 1 − 2⁻ᵏ is a number.
    for k in 1..=25 {
        let s = R::from_integer(1) - rational(1, 1 << k);
        let one = R::from_integer(1);
        // The common factor is left out so that i128 holds the powers.
        let expected =
            rational(2, 5) * (one + s + s * s + s * s * s + s * s * s * s) / (one + s + s * s);
        assert_relative_eq!(
            shell(exact(s))?,
            exact(expected),
            max_relative = 3.0 * EPS,
            epsilon = 0.0
        );
    }
    // As printed, at one part in 10⁸: half of the digits are gone.
    let s = 1.0 - 1e-8_f64;
    let printed = 0.4 * (1.0 - s.powi(5)) / (1.0 - s.powi(3));
    assert!((printed / shell(s)? - 1.0).abs() > 1e-10);
    // Mass times radius squared of the ball less that of the cavity: the difference of two balls.
    let (inner, outer) = (0.7_f64, 1.2_f64);
    let difference = 0.4 * (outer.powi(5) - inner.powi(5)) / (outer.powi(3) - inner.powi(3));
    let moment = shapes::thick_shell(1.0, inner, outer)?.inertia().matrix()[(0, 0)];
    assert_relative_eq!(moment, difference, max_relative = 8.0 * EPS, epsilon = 0.0);
    Ok(())
}

#[test]
fn s2_7_where_routh_fails() -> Result<()> {
    // claim: C2.7-8
    use routh::Form::{Cone, CylinderAboutItsAxis, CylinderAcross, Hollow, Triangle};
    for form in [Cone, CylinderAcross, Hollow, Triangle] {
        assert_eq!(form.denominator(), None);
        assert!(matches!(
            routh::moment(1.0, form, [1.0, 1.0]),
            Err(Error::RouthDoesNotApply { .. })
        ));
    }
    let cylinder = shapes::cylinder(1.0, 1.0, 2.0)?.inertia().matrix();
    assert_relative_eq!(
        cylinder[(0, 0)],
        exact(rational(7, 12)),
        max_relative = EPS,
        epsilon = 0.0
    );
    for denominator in [3, 4, 5] {
        assert_ne!(rational(7, 12), rational(2, denominator));
    }
    assert_eq!(
        routh::moment(1.0, CylinderAboutItsAxis, [1.0, 1.0])?,
        cylinder[(2, 2)]
    );
    let (radius, height) = (1.25, 3.0);
    let cone = shapes::cone(1.0, radius, height)?;
    let axial = cone.inertia().matrix()[(2, 2)];
    assert_relative_eq!(
        axial,
        exact(rational(3, 10)) * radius * radius,
        max_relative = 2.0 * EPS,
        epsilon = 0.0
    );
    let entries = cubature([unit_gauss(), circle(), unit_gauss()], |[r, phi, s]| {
        let rho = radius * r * (1.0 - s);
        (
            [rho * phi.cos(), rho * phi.sin(), height * (s - 0.25)],
            r * (1.0 - s).powi(2),
        )
    });
    assert_inertia(&cone, entries);
    let (ring, tube) = (2.0, 0.75);
    let entries = cubature([unit_gauss(), circle(), circle()], |[r, psi, phi]| {
        let rho = ring + tube * r * psi.cos();
        (
            [rho * phi.cos(), rho * phi.sin(), tube * r * psi.sin()],
            r * rho,
        )
    });
    assert_inertia(&shapes::torus(1.0, ring, tube)?, entries);
    let entries = cubature([unit_gauss(), circle(), gauss()], |[t, phi, u]| {
        let rho = 0.5 + t;
        ([rho * phi.cos(), rho * phi.sin(), 2.0 * u], rho)
    });
    assert_inertia(&shapes::tube(1.0, 0.5, 1.5, 4.0)?, entries);
    Ok(())
}

#[test]
fn s2_7_why_three_four_five() -> Result<()> {
    // claim: C2.7-9
    for d in [1_u32, 2, 3, 4, 7] {
        // ⟨x²⟩ = ⟨r²⟩/d, and ⟨r²⟩ = ∫r^(d+1) / ∫r^(d−1) on 0..1: at most degree 8, so the rule is exact.
        let moment = |power: u32| -> f64 {
            unit_gauss()
                .iter()
                .map(|(r, w)| w * r.powi(power as i32))
                .sum()
        };
        let quadrature = moment(d + 1) / moment(d - 1) / f64::from(d);
        assert_relative_eq!(
            routh::mean_square(1.0, d)?,
            quadrature,
            max_relative = 8.0 * EPS,
            epsilon = 0.0
        );
        assert_relative_eq!(
            routh::mean_square(3.0, d)?,
            9.0 * quadrature,
            max_relative = 8.0 * EPS,
            epsilon = 0.0
        );
    }
    // One term a factor: the cylinder across is disc times rod.
    let cylinder = shapes::cylinder(1.0, 1.5, 4.0)?.inertia().matrix()[(0, 0)];
    let sum = routh::mean_square(1.5, 2)? + routh::mean_square(2.0, 1)?;
    assert_relative_eq!(cylinder, sum, max_relative = 2.0 * EPS, epsilon = 0.0);
    // The thin shell has a²/d instead: ⟨x²⟩ is half of its moment.
    let shell = shapes::spherical_shell(1.0, 1.0)?.inertia().matrix()[(0, 0)] / 2.0;
    assert_relative_eq!(shell, 1.0 / 3.0, max_relative = EPS, epsilon = 0.0);
    assert!(routh::mean_square(1.0, 0).is_err());
    Ok(())
}

#[test]
fn s2_8_parallel_axes() -> Result<()> {
    // claim: C2.8-1
    let body = four_masses()?;
    let shifted = body.inertia().shifted_from_center(10.0, body.center())?;
    let expected = Matrix3::new(13.0, -4.0, -4.0, -4.0, 12.0, -4.0, -4.0, -4.0, 11.0);
    assert!((shifted.matrix() - expected).amax() <= 4.0 * EPS * 13.0);
    // In rationals: the diagonal entry 9/2 + 10(36 + 49)/100 = 13.
    assert_eq!(
        rational(9, 2) + rational(10 * (36 + 49), 100),
        rational(13, 1)
    );
    assert_eq!(rational(-1, 2) - rational(10 * 35, 100), rational(-4, 1));
    // Only from the centre: shifting on from the origin as if it were the centre gives another matrix.
    let point = vector([1.0, 1.0, 1.0]);
    let right = body.about(point)?.matrix();
    let direct: Matrix3<f64> = MASSES
        .iter()
        .zip(POSITIONS)
        .map(|(&m, x)| {
            let d = vector(x.map(|x| x as f64)) - point;
            InertiaMatrix::of_particle(m as f64, d).map(|i| i.matrix())
        })
        .sum::<Result<Matrix3<f64>>>()?;
    assert!((right - direct).amax() <= 8.0 * EPS * 13.0);
    let wrong = shifted.shifted_from_center(10.0, point)?.matrix();
    assert!((wrong - right).amax() > 1.0);
    Ok(())
}

#[test]
fn s2_8_outer_product_form() -> Result<()> {
    // claim: C2.8-2
    for d in [[0.0, 0.0, 0.0], [1.0, -2.0, 3.0], [5.0, 0.0, -7.0]] {
        let d = Vector3::from(d);
        let outer = 3.0 * (Matrix3::identity() * d.norm_squared() - d * d.transpose());
        let particle = InertiaMatrix::of_particle(3.0, BodyVector::from_components(d))?;
        assert_eq!(particle.matrix(), outer);
    }
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
        assert_relative_eq!(
            about_pivot.matrix()[(k, k)],
            expected,
            max_relative = 2.0 * EPS,
            epsilon = 0.0
        );
    }
    assert_eq!(rational(10, 5) + rational(2, 5), rational(12, 5));
    assert_eq!(rational(4, 5) + rational(2, 5), rational(6, 5));
    // And any second-moment matrix has principal axes, not only an inertia matrix.
    let s = principal_axes_of(&ellipsoid.inertia().second_moments())?;
    for (value, expected) in s.moments().into_iter().zip([0.2, 0.6, 1.8]) {
        assert_relative_eq!(value, expected, max_relative = 4.0 * EPS, epsilon = 0.0);
    }
    Ok(())
}
