//! 2.3: kinetic energy in three parts.

use super::*;

#[test]
fn s2_3_energy_splits_in_three() -> Result<()> {
    // claim: C2.3-1, C2.3-2
    let body = four_masses()?;
    let split = motion_about_origin().energy(&body)?;
    assert_eq!(split.of_motion, 70.0);
    close!(split.cross, 72.0, 2.0 * EPS);
    close!(split.of_rotation, 41.5, 2.0 * EPS);
    let whole = split.of_motion + split.cross + split.of_rotation;
    close!(whole, 183.5, 2.0 * EPS);
    assert_eq!(direct_sums([ZERO; 3]).1, rational(367, 2));
    // About the centre the cross term is gone and the sum is the same.
    let centered = motion_about_origin().seen_from(body.center());
    let centered = centered.energy(&body)?;
    assert_eq!(centered.cross, 0.0);
    close!(centered.of_rotation, exact(rational(251, 20)), 4.0 * EPS);
    let whole = centered.of_motion + centered.cross + centered.of_rotation;
    close!(whole, 183.5, 4.0 * EPS);
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
        let e = BodyVector::from_components(axes.axes.column(k).into_owned());
        close!(tilted.rotational_energy(e), expected, 8.0 * EPS);
    }
    Ok(())
}
