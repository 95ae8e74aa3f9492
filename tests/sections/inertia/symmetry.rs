//! 2.6: what an axis of symmetry does; the cube quiz and the Platonic solids.

use super::*;

/// A symmetric matrix with random entries, made an inertia matrix by its second moments: S = A Aᵀ.
fn random_inertia(uniform: &mut Uniform) -> Result<InertiaMatrix> {
    let a = Matrix3::from_fn(|_, _| uniform.signed());
    let second = a * a.transpose();
    InertiaMatrix::from_matrix(Matrix3::identity() * second.trace() - second)
}

/// Mean of R I Rᵀ over the turns by 2πk/n about an axis, summed one by one.
fn mean_over_turns(inertia: &InertiaMatrix, axis: BodyVector, order: u32) -> Result<Matrix3<f64>> {
    let mut sum = Matrix3::zeros();
    for k in 0..order {
        let angle = TAU * f64::from(k) / f64::from(order);
        let turn = Attitude::about_axis(axis, angle)?;
        sum += inertia.rotated(&turn).matrix();
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
        let turn = Attitude::about_axis(vector(other.into()), 2.0 * PI / 3.0)?;
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
        near!(spin, closed, 32.0 * EPS * closed.max(1e-16));
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
    close!(defects[3] / defects[2], rate, 3e-10..=1e-9);
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
        (shapes::hollow_box(mass, [edge; 3])?, rational(5, 18)),
        (shapes::wire_box(mass, [edge; 3])?, rational(7, 18)),
        (particles(&corners)?, rational(1, 2)),
    ] {
        for axis in [
            [1.0, 1.0, 1.0],
            [1.0, 1.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.3, -0.5, 0.9],
        ] {
            let moment = body.inertia().moment_about(vector(axis))?;
            close!(moment, size * exact(factor), 8.0 * EPS);
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
        Ok(body.turned(&Attitude::about_axis(vector(about), FRAC_PI_2)?))
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
        let whole = MassProperties::compose(&parts)?;
        assert_inertia(&whole, [entry, entry, entry, 0.0, 0.0, 0.0]);
    }
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
        let factor = shapes::platonic(solid, 1.0, 1.0)?.inertia().matrix()[(0, 0)];
        close!(factor, closed, 2.0 * EPS);
        assert_eq!(factor, digits);
        let edge = 1.3;
        let vertices = solid.vertices(edge)?;
        // Every face has edges of that length, and all vertices are equally far from the centre.
        for face in solid.faces() {
            for (i, &a) in face.iter().enumerate() {
                let b = face[(i + 1) % face.len()];
                let side = vector(vertices[a as usize]) - vector(vertices[b as usize]);
                close!(side.norm(), edge, 4.0 * EPS);
            }
        }
        let body = mesh_mass_properties(&vertices, &solid.triangles(), 1.0)?;
        assert!(body.center().norm() <= 4.0 * EPS);
        let formula = shapes::platonic(solid, body.mass(), edge)?;
        let formula = formula.inertia().matrix();
        assert!((body.inertia().matrix() - formula).amax() <= 8.0 * EPS * formula.amax());
    }
    Ok(())
}
