//! 2.1: mass is a coefficient, inertia depends on the axis.

use super::*;

#[test]
fn s2_1_mass_as_a_coefficient() -> Result<()> {
    // claim: C2.1-1
    let particle = MassProperties::particle(3.0, BodyVector::zero())?;
    let energy = |v: f64| -> Result<(f64, f64)> {
        let motion = RigidMotion {
            base: BodyVector::zero(),
            velocity: vector([v, 0.0, 0.0]),
            omega: BodyVector::zero(),
        };
        let energy = motion.energy(&particle)?.of_motion;
        Ok((motion.momentum(&particle).x(), energy))
    };
    for v in [-2.0, 0.0, 0.5, 4.0] {
        let (p, e) = energy(v)?;
        assert_eq!(p, 3.0 * v);
        assert_eq!(e, 1.5 * v * v);
        close!(e, p * p / 6.0, EPS);
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
    for (k, thirds) in [34, 29, 13].into_iter().enumerate() {
        let axis = BodyVector::from_components(Matrix3::identity().column(k).into());
        close!(inertia.moment_about(axis)?, exact(rational(thirds, 3)), EPS);
    }
    Ok(())
}
