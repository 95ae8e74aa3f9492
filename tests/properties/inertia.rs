//! Properties of the inertia module over bodies that nobody chose.

use super::turn;
use nalgebra::Matrix3;
use proptest::prelude::*;
use spinning_bodies::Result;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::inertia::{
    InertiaMatrix, MassProperties, PlatonicSolid, PrincipalMoments, RigidMotion,
    ellipsoid_of_inertia, icosphere, mesh_mass_properties, principal_axes_of, routh, shapes,
};
use support::inertia::particles;
use support::{ORDERS, any, vector};

const EPS: f64 = f64::EPSILON;

fn point() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-1.0..1.0)
}

fn masses() -> impl Strategy<Value = Vec<(f64, [f64; 3])>> {
    prop::collection::vec((0.1..2.0, point()), 1..8)
}

/// Largest difference of the matrices, which for a body of size 1 is in units of mass.
fn difference(a: &MassProperties, b: &MassProperties) -> f64 {
    (a.inertia().matrix() - b.inertia().matrix())
        .amax()
        .max((a.center() - b.center()).norm())
}

fn finite(body: &MassProperties) -> bool {
    body.center().is_finite()
        && body.inertia().matrix().iter().all(|x| x.is_finite())
        && body.mass() > 0.0
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn shapes_never_panic(m in any(), a in any(), b in any(), c in any(), corner in prop::array::uniform3(prop::array::uniform2(any()))) {
        let mut all = vec![
            shapes::cuboid(m, [a, b, c]), shapes::hollow_box(m, [a, b, c]), shapes::wire_box(m, [a, b, c]),
            shapes::ball(m, a), shapes::spherical_shell(m, a),
            shapes::thick_shell(m, a, b), shapes::ellipsoid(m, [a, b, c]), shapes::cylinder(m, a, b), shapes::elliptic_cylinder(m, [a, b], c),
            shapes::rod(m, a), shapes::hoop(m, a),
            shapes::disc(m, a), shapes::cone(m, a, b), shapes::torus(m, a, b), shapes::rectangle_lamina(m, [a, b]),
            shapes::ellipse_lamina(m, [a, b]), shapes::triangle_lamina(m, corner),
        ];
        all.extend(PlatonicSolid::ALL.map(|solid| shapes::platonic(solid, m, a)));
        for body in all.iter().flatten() {
            prop_assert!(finite(body));
            let axes = body.inertia().principal_axes();
            prop_assert!(axes.moments.iter().all(|x| x.is_finite() && *x >= 0.0));
            prop_assert!((axes.axes.transpose() * axes.axes - Matrix3::identity()).amax() <= 1e-15);
            // The body goes through every other door of the module.
            let moments = axes.principal_moments();
            let [smallest, middle, largest] = moments.values();
            prop_assert!(PrincipalMoments::new(smallest, middle, largest).is_ok());
            prop_assert!(moments.greatest_angle().is_finite());
            prop_assert!(moments.widest_omega().iter().all(|x| x.is_finite()));
            if let Ok(axes) = ellipsoid_of_inertia(body.mass(), &moments) {
                prop_assert!(axes.iter().all(|x| x.is_finite()));
            }
            let composed = MassProperties::compose(&[*body, *body]);
            if let Ok(composed) = composed {
                prop_assert!(finite(&composed));
            }
            for moved in [body.moved(vector([a, b, c])), body.moved(vector([c, a, a]))].iter().flatten() {
                prop_assert!(finite(moved));
            }
            if let Ok(about) = body.about(vector([c, b, a])) {
                prop_assert!(about.matrix().iter().all(|x| x.is_finite()));
            }
        }
    }

    #[test]
    fn matrices_never_panic(e in prop::array::uniform9(any()), axis in prop::array::uniform3(any()), order in 0_u32..9, q in prop::array::uniform4(any())) {
        let full = Matrix3::from_row_slice(&e);
        let symmetric = Matrix3::new(e[0], e[1], e[2], e[1], e[3], e[4], e[2], e[4], e[5]);
        for matrix in [full, symmetric, Matrix3::from_diagonal_element(e[0])] {
            if let Ok(found) = principal_axes_of(&matrix) {
                prop_assert!(found.moments.iter().all(|x| x.is_finite()));
                prop_assert!((found.axes.transpose() * found.axes - Matrix3::identity()).amax() <= 1e-15, "{:?}", matrix);
                let _ = found.principal_moments();
            }
            if let Ok(inertia) = InertiaMatrix::from_matrix(matrix) {
                let omega = vector(axis);
                let _ = (inertia.angular_momentum(omega), inertia.rotational_energy(omega), inertia.second_moments());
                let _ = (inertia.moment_about(omega), inertia.angle_between_l_and_omega(omega));
                let _ = inertia.torque_in_linear_field(&full);
                if let Ok(mean) = inertia.averaged_over_rotations(omega, order) {
                    prop_assert!(mean.matrix().iter().all(|x| x.is_finite()));
                }
                if let Ok(turn) = Attitude::from_quaternion(q[0], q[1], q[2], q[3]) {
                    let turned = inertia.rotated(&turn);
                    prop_assert!(turned.matrix().iter().all(|x| x.is_finite()));
                }
            }
        }
        let _ = InertiaMatrix::diagonal(e[0], e[1], e[2]);
        let _ = InertiaMatrix::of_particle(e[6], vector(axis));
        if let Ok(particle) = MassProperties::particle(e[6], vector(axis)) {
            let motion = RigidMotion { base: vector([e[0], e[1], e[2]]), velocity: vector([e[3], e[4], e[5]]), omega: vector([e[6], e[7], e[8]]) };
            let _ = (motion.angular_momentum(&particle), motion.energy(&particle), motion.momentum(&particle), motion.seen_from(particle.center()));
            if let Ok(turn) = Attitude::from_quaternion(q[0], q[1], q[2], q[3]) {
                prop_assert!(finite(&particle.turned(&turn)));
            }
        }
        for form in [routh::Form::Cuboid, routh::Form::Ellipse, routh::Form::Ellipsoid, routh::Form::Cone] {
            let _ = routh::moment(e[0], form, [e[1], e[2]]);
        }
        let _ = (routh::mean_square(e[0], order), icosphere(order.min(2), e[0]), PlatonicSolid::Cube.vertices(e[0]));
    }

    #[test]
    fn meshes_never_panic(
        vertices in prop::collection::vec(prop::array::uniform3(any()), 0..6),
        triangles in prop::collection::vec(prop::array::uniform3(0_u32..7), 0..6),
        density in any(),
        closed in prop::array::uniform4(prop::array::uniform3(any())),
    ) {
        let _ = mesh_mass_properties(&vertices, &triangles, density);
        let tetrahedron = [[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]];
        if let Ok(body) = mesh_mass_properties(&closed, &tetrahedron, density) {
            prop_assert!(finite(&body));
        }
    }

    #[test]
    fn turning_the_parts_turns_the_whole(list in masses(), turn in turn()) {
        let whole = particles(&list).expect("ordinary numbers").turned(&turn);
        let parts: Vec<_> = list.iter().map(|(m, x)| {
            MassProperties::particle(*m, vector(*x)).map(|p| p.turned(&turn))
        }).collect::<Result<_>>().expect("ordinary numbers");
        let parts = MassProperties::compose(&parts).expect("ordinary numbers");
        prop_assert!(difference(&whole, &parts) <= 16.0 * EPS * whole.mass());
        let moments = whole.inertia().principal_axes().moments;
        let before = particles(&list).expect("ordinary numbers").inertia().principal_axes().moments;
        for (a, b) in moments.into_iter().zip(before) {
            prop_assert!((a - b).abs() <= 16.0 * EPS * whole.mass());
        }
    }

    #[test]
    fn composing_in_groups_is_composing_at_once(list in masses(), more in masses()) {
        let groups = [particles(&list), particles(&more)].map(|b| b.expect("ordinary numbers"));
        let grouped = MassProperties::compose(&groups).expect("ordinary numbers");
        let all: Vec<_> = list.iter().chain(&more).copied().collect();
        let at_once = particles(&all).expect("ordinary numbers");
        prop_assert!(difference(&grouped, &at_once) <= 16.0 * EPS * at_once.mass());
        // The order does not matter either.
        let reversed: Vec<_> = all.iter().rev().copied().collect();
        prop_assert!(difference(&particles(&reversed).expect("ordinary numbers"), &at_once) <= 16.0 * EPS * at_once.mass());
    }

    #[test]
    fn parallel_axes_are_moving(list in masses(), d in point()) {
        let whole = particles(&list).expect("ordinary numbers");
        let about = whole.about(vector(d)).expect("ordinary numbers").matrix();
        let moved = whole.moved(-vector(d)).expect("ordinary numbers").about(BodyVector::zero()).expect("ordinary numbers").matrix();
        prop_assert!((about - moved).amax() <= 16.0 * EPS * whole.mass());
        let direct: Matrix3<f64> = list.iter().map(|(m, x)| {
            InertiaMatrix::of_particle(*m, vector(*x) - vector(d)).expect("ordinary numbers").matrix()
        }).sum();
        prop_assert!((about - direct).amax() <= 32.0 * EPS * whole.mass());
    }

    #[test]
    fn permuting_moments_permutes_nothing(a in 0.1..1.0_f64, b in 0.1..1.0_f64, c in 0.1..1.0_f64) {
        let moments = [b + c, c + a, a + b];
        let expected = PrincipalMoments::new(moments[0], moments[1], moments[2]).expect("realisable");
        for [i, j, k] in ORDERS {
            let again = PrincipalMoments::new(moments[i], moments[j], moments[k]).expect("realisable");
            prop_assert_eq!(again, expected);
            let axes = InertiaMatrix::diagonal(moments[i], moments[j], moments[k]).expect("realisable").principal_axes();
            prop_assert_eq!(axes.moments, expected.values());
            prop_assert_eq!(axes.axes.determinant(), 1.0);
        }
    }

    #[test]
    fn tetrahedra_have_exact_moments(p in prop::array::uniform4(point())) {
        let e = [1, 2, 3].map(|k| vector(p[k]) - vector(p[0]));
        let volume = e[0].dot(&e[1].cross(&e[2])) / 6.0;
        prop_assume!(volume.abs() > 1e-2);
        let faces = [[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]];
        let outward = if volume > 0.0 { faces } else { faces.map(|[a, b, c]| [a, c, b]) };
        let mesh = mesh_mass_properties(&p, &outward, 1.0).expect("a tetrahedron");
        // A tetrahedron weighs like M/20 at each corner and 4M/5 at the centroid.
        let middle = [0, 1, 2].map(|i| (p[0][i] + p[1][i] + p[2][i] + p[3][i]) / 4.0);
        let mut weights: Vec<_> = p.iter().map(|x| (volume.abs() / 20.0, *x)).collect();
        weights.push((0.8 * volume.abs(), middle));
        let weighed = particles(&weights).expect("ordinary numbers");
        prop_assert!((mesh.mass() - volume.abs()).abs() <= 16.0 * EPS);
        prop_assert!(difference(&mesh, &weighed) <= 1e-13, "{}", difference(&mesh, &weighed));
    }
}
