//! 3.5: spheroids and ellipsoids that turn.

use super::*;

/// Potential coefficient A_i of a spheroid straight from its definition a²c ∫ du/(Δ (a_i²+u)), with u = c² s²/(1−s)².
fn coefficient_by_quadrature(q: f64, along: f64) -> f64 {
    let integrand = |s: f64| {
        let u = (q * s / (1.0 - s)).powi(2);
        let du = 2.0 * q * q * s / (1.0 - s).powi(3);
        q / ((1.0 + u) * (q * q + u).sqrt() * (along * along + u)) * du
    };
    integral(integrand, 0.0, 1.0)
}

// claim: C3.5-1
#[test]
fn s3_5_maclaurin_spheroids() {
    // Against 32 digits, in units of machine epsilon. Observed: 4 and 4.
    let (mut worst, mut worst_ratio) = (0.0_f64, 0.0_f64);
    for line in include_str!("../../reference/maclaurin.csv")
        .lines()
        .skip(1)
    {
        let row: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        let star = MaclaurinSpheroid::from_eccentricity(row[0]).unwrap();
        worst = worst.max((star.rotation / row[1] - 1.0).abs() / f64::EPSILON);
        worst_ratio = worst_ratio.max((star.energy_ratio / row[2] - 1.0).abs() / f64::EPSILON);
    }
    assert!(worst <= 4.5, "{worst} ulp");
    assert!(worst_ratio <= 4.5, "{worst_ratio} ulp");

    let rotation = |e| MaclaurinSpheroid::from_eccentricity(e).unwrap().rotation;
    let off = relative(rotation(0.6), 0.201_352_059_619_914_088_2);
    observed!(off, 0.0..=4e-16);
    assert_eq!(rotation(0.0), 0.0);
    observed!(relative(rotation(1e-8), 8.0 / 15.0 * 1e-16), 0.0..=4e-16);
    // The disc: πq.
    let disc = MaclaurinSpheroid::from_axis_ratio(1e-12).unwrap();
    let off = relative(disc.rotation, PI * 1e-12);
    observed!(off, 8e-13..=3e-12);

    // Ω²/(πGρ) = 2(A₁ − A₃c²/a²) with the coefficients integrated.
    for q in [0.3_f64, 0.6, 0.9] {
        let star = MaclaurinSpheroid::from_axis_ratio(q).unwrap();
        let [a1, a3] = [1.0, q].map(|along| coefficient_by_quadrature(q, along));
        observed!(relative(2.0 * a1 + a3, 2.0), 6e-15..=2e-13);
        let off = relative(star.rotation, 2.0 * (a1 - a3 * q * q));
        observed!(off, 1e-14..=5e-13);
    }

    // Expected values of the register, 20 digits. Observed: 2 ulp at most.
    let fastest = MaclaurinSpheroid::fastest();
    let off = relative(fastest.eccentricity, 0.929_955_685_456_232_994_18);
    observed!(off, 0.0..=5e-16);
    let off = relative(fastest.rotation, 0.449_331_412_123_913_854_36);
    observed!(off, 2e-16..=9e-16);
    for e in [0.5, 0.9, 0.929, 0.931, 0.95] {
        assert!(rotation(e) < fastest.rotation);
    }
}

// claim: C3.5-1
#[test]
fn s3_5_jacobi_ellipsoids_branch_off() {
    let branch = MaclaurinSpheroid::at_jacobi_bifurcation();
    let off = relative(branch.eccentricity, 0.812_670_010_611_742_949_48);
    observed!(off, 0.0..=2e-15);
    let off = relative(branch.rotation, 0.374_229_674_786_195_634_35);
    observed!(off, 0.0..=2e-15);
    // An independent closed form of the same condition: arcsin e = e√(1−e²)(3+10e²)/(3+8e²−8e⁴) (Chandrasekhar 1969).
    let e2 = branch.eccentricity.powi(2);
    let closed = branch.eccentricity * (1.0 - e2).sqrt() * (3.0 + 10.0 * e2)
        / (3.0 + 8.0 * e2 - 8.0 * e2 * e2);
    observed!(relative(branch.eccentricity.asin(), closed), 0.0..=3e-15);
    observed!(relative(branch.energy_ratio, 0.137_528), 4e-7..=3e-6);

    // Jacobi's own sequence: starts where it branches, turns slower as it lengthens (models of the field: six digits).
    let start = JacobiEllipsoid::from_axis_ratio(1.0).unwrap();
    observed!(relative(start.rotation, branch.rotation), 2e-16..=2e-15);
    let off = relative(start.angular_momentum, branch.angular_momentum);
    observed!(off, 1e-16..=2e-15);
    for (b, c, rotation) in [
        (0.9, 0.551_873, 0.372_567),
        (0.7, 0.478_110, 0.355_679),
        (0.5, 0.383_309, 0.309_557),
        (0.432_232, 0.345_069, 0.284_030),
    ] {
        let star = JacobiEllipsoid::from_axis_ratio(b).unwrap();
        observed!(relative(star.axes[2], c), 4e-7..=2e-6);
        observed!(relative(star.rotation, rotation), 4e-7..=2e-6);
        assert!(star.angular_momentum > branch.angular_momentum);
    }
    // Twenty digits from quadrature in multiple precision. Observed 7e-16.
    for (b, c, rotation) in [
        (
            0.5,
            0.383_308_578_573_099_843_7,
            0.309_557_013_747_839_172_16,
        ),
        (
            0.1,
            0.096_815_242_566_304_156_552,
            0.060_472_160_195_441_782_64,
        ),
    ] {
        let star = JacobiEllipsoid::from_axis_ratio(b).unwrap();
        observed!(relative(star.axes[2], c), 0.0..=1.2e-15);
        observed!(relative(star.rotation, rotation), 2e-16..=1.2e-15);
    }
    // As near to 1 as one likes, without a jump from the limit a²−b² → 0.
    let near = JacobiEllipsoid::from_axis_ratio(1.0 - 1e-9).unwrap();
    observed!(relative(near.axes[2], branch.axis_ratio), 2e-10..=2e-9);
}
