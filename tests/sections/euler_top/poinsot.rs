//! Paragraphs 6.1 and 6.2: what stays, and Poinsot's ellipsoid rolling on its plane.

use super::*;
use spinning_bodies::conservation::{Particle, Particles};
use spinning_bodies::frame::SpaceVector as V;

/// Either side of the separatrix, next to it, and the axes in odd order.
fn tops() -> Vec<EulerTop> {
    vec![
        tilted(MOMENTS, [0.4, 0.3, 1.0]),
        tilted(MOMENTS, [2.0, 0.1, 1.0]),
        tilted(MOMENTS, [1e-9, -1.0, 1e-6]),
        tilted([3.0, 1.0, 2.5], [-0.7, 0.2, 1.3]),
        thrown([1.5, 3.0, 4.0], [1.0, 0.5, 2.0]),
        tilted([1.0, 1.0, 1.5], [0.3, 0.4, 2.0]),
    ]
}

fn momentum(top: &EulerTop, omega: [f64; 3]) -> BodyVector {
    let i = top.moments();
    vector([0, 1, 2].map(|k| i[k] * omega[k]))
}

/// Six particles with the moments 1, 2, 3 about their common centre: pairs at ±x on the three axes.
fn jack((attitude, omega): (Attitude, BodyVector), center: V, velocity: V) -> Particles {
    let mut list = Vec::new();
    // Σ m x² along the axes: 2, 1 and 0 make I = (1, 2, 3).
    for (mass, place) in [
        (1.0, [1.0, 0.0, 0.0]),
        (0.5, [0.0, 1.0, 0.0]),
        (2.0, [0.0; 3]),
    ] {
        for side in [1.0, -1.0] {
            let r = side * vector(place);
            list.push(Particle {
                mass,
                position: center + attitude.to_space(r),
                velocity: velocity + attitude.to_space(omega.cross(&r)),
            });
        }
    }
    Particles::new(list).unwrap()
}

// claim: C6.1-1, C1.4-1
#[test]
fn s6_1_constants_of_the_motion() {
    // The exact motion keeps them at any time, to rounding.
    for top in tops() {
        let (l, e) = (top.angular_momentum_in_space(), top.energy());
        for t in [-1e9, -40.0, -0.3, 0.7, 13.0, 1e4, 1e12] {
            let state = at(&top, t);
            let now = state.attitude.to_space(state.angular_momentum);
            observed!((now - l).norm() / l.norm(), 3e-16..=3e-15); // observed 9.3e-16
            let energy = 0.5 * state.omega.dot(&state.angular_momentum);
            observed!((energy / e - 1.0).abs(), 1e-16..=2e-15); // observed 4.4e-16
        }
    }
    // The same body as particles, thrown across the room: P is constant, and zero for who flies along.
    let top = tilted(MOMENTS, [0.4, 0.3, 1.0]);
    let v = V::new(3.0, -1.0, 0.5);
    for t in [0.0, 1.3, 7.0] {
        let state = at(&top, t);
        let turning = (state.attitude, state.omega);
        let thrown = jack(turning, t * v, v);
        observed!((thrown.momentum() - 7.0 * v).norm(), 0.0..=4e-15); // observed none, an ulp is 4e-15
        let along = jack(turning, V::zero(), (1.0 / 7.0) * thrown.momentum() - v);
        observed!(along.momentum().norm(), 0.0..=4.5e-16); // observed none
        let l = along.angular_momentum_about(V::zero());
        observed!((l - top.angular_momentum_in_space()).norm(), 6e-16..=6e-15); // observed 1.8e-15
        let split = along.energy_split();
        close!(split.translational + split.relative, 1.67, 2e-16..=3e-15);
        close!(thrown.energy_split().relative, 1.67, 0.0..=4e-15);
    }
}

// claim: C6.1-2
#[test]
fn s6_1_free_though_heavy() {
    // A gyroscope hung at its centre of mass in uniform gravity, in any attitude: no torque.
    let mut numbers = Uniform(61);
    let center = V::new(3.0, -2.0, 40.0);
    for _ in 0..20 {
        let turning = (numbers.attitude(), vector([0.4, 0.3, 1.0]));
        let body = jack(turning, center, V::zero());
        let uniform = |p: &Particle| V::new(0.0, 0.0, -9.81 * p.mass);
        let about_center = body.force_and_torque(center, uniform).unwrap();
        observed!(about_center.torque.norm(), 1e-15..=1e-14); // observed 3.1e-15
        // Hung elsewhere it is no free top.
        let elsewhere = body.force_and_torque(V::zero(), uniform).unwrap();
        assert!(elsewhere.torque.norm() > 100.0);
    }
    // The condition: gravity that falls off with the distance does torque a planet, 3μ/r³ e ∧ Ie with e the way up.
    let (mu, r) = (9.0, 1e3);
    let attitude = Attitude::about_axis(vector([1.0, -2.0, 0.5]), 0.8).unwrap();
    let still = (attitude, BodyVector::zero());
    let planet = jack(still, V::new(r, 0.0, 0.0), V::zero());
    let field = |p: &Particle| p.position * (-mu * p.mass / p.position.norm().powi(3));
    let about = planet.force_and_torque(planet.center(), field).unwrap();
    let up = attitude.to_body(V::new(1.0, 0.0, 0.0));
    let tidal = up.cross(&vector([up.x(), 2.0 * up.y(), 3.0 * up.z()])) * (3.0 * mu / r.powi(3));
    let error = (attitude.to_body(about.torque) - tidal).norm() / tidal.norm();
    observed!(error, 4e-7..=4e-6); // observed 1.2e-6
    assert!(tidal.norm() > 1e-9, "the precession of the equinoxes");
}

// claim: C6.2-1
#[test]
fn s6_2_l_stays_and_omega_moves() {
    let top = tilted(MOMENTS, [1.0, 1.0, 1.0]);
    for step in 1..=6 {
        let t = 0.5 * f64::from(step);
        let state = at(&top, t);
        let l = state.attitude.to_space(state.angular_momentum);
        observed!((l - V::new(1.0, 2.0, 3.0)).norm(), 5e-16..=6e-15); // observed 1.8e-15
        let moved = omega_in_space(&top, t);
        assert!((moved - V::new(1.0, 1.0, 1.0)).norm() > 0.05);
    }
    // Ω stays if it is along a principal axis, and only then.
    for (omega0, regime) in [
        ([1.3, 0.0, 0.0], Regime::PermanentRotation),
        ([0.0, -1.3, 0.0], Regime::PermanentRotation),
        ([0.0, 0.0, 1.3], Regime::PermanentRotation),
        ([1.3, 0.0, 1e-300], Regime::AroundSmallest),
        ([1e-300, 0.0, 1.3], Regime::AroundLargest),
    ] {
        let top = tilted(MOMENTS, omega0);
        assert_eq!(top.regime(), regime, "{omega0:?}");
        let stays = regime == Regime::PermanentRotation;
        assert_eq!(norm(euler(MOMENTS, omega0)) == 0.0, stays);
        assert_eq!(omega(&top, 1.0) == omega0, stays);
        assert_eq!(top.period().is_infinite(), stays);
    }
}

// claim: C6.2-2, C6.2-3
#[test]
fn s6_2_omega_on_ellipsoid_and_plane() {
    let unit = tilted(MOMENTS, [1.0; 3]);
    let height = picture(&unit, 0.0).plane_distance;
    close!(height, 1.603_567_451_474_546_308, 0.0..=3e-16);
    assert_eq!(unit.energy(), 3.0);
    for top in tops().into_iter().chain([unit]) {
        let l = top.angular_momentum_in_space();
        let picture = picture(&top, 0.0);
        let semi_axes = picture.semi_axes;
        for step in -20..20 {
            let t = 0.37 * f64::from(step);
            let o = omega(&top, t);
            let on_theta: f64 = (0..3).map(|k| (o[k] / semi_axes[k]).powi(2)).sum();
            observed!((on_theta - 1.0).abs(), 3e-16..=3e-15); // observed 8.9e-16
            let height = omega_in_space(&top, t).dot(&l) / l.norm();
            close!(height, picture.plane_distance, 3e-16..=3e-15); // observed 7.8e-16
        }
    }
}

// claim: C6.2-4
#[test]
fn s6_2_the_plane_touches() -> Result<()> {
    // Exactly: the gradient of ⟨Ix, x⟩ at Ω is 2L, and the support function of Θ in the direction L, √(2E ⟨L, I⁻¹L⟩), is 2E.
    let mut numbers = Uniform(62);
    for _ in 0..100 {
        let i = rational_moments(&mut numbers);
        let o = [0; 3].map(|_| ration(&mut numbers));
        let (twice_energy, _) = integrals(i, o);
        let h = rational(1, 7);
        for k in 0..3 {
            let shifted = |s: R| {
                let mut x = o;
                x[k] += s;
                integrals(i, x).0
            };
            // A quadratic: its central difference is its derivative, whatever the step.
            let slope = (shifted(h) - shifted(-h)) / (h + h);
            assert_eq!(slope, TWO * i[k] * o[k]);
        }
        let l = [0, 1, 2].map(|k| i[k] * o[k]);
        let support_squared = (0..3).fold(ZERO, |sum, k| sum + l[k] * l[k] / i[k]) * twice_energy;
        assert_eq!(support_squared, twice_energy * twice_energy);
        // Every other point of Θ lies below the plane.
        let moments = i.map(exact);
        let picture = Poinsot::new(moments, vector(l.map(exact)))?;
        for _ in 0..20 {
            let direction = numbers.vector().direction("a direction")?.components();
            let x = [0, 1, 2].map(|k| direction[k] * picture.semi_axes[k]);
            let height: f64 = (0..3).map(|k| exact(l[k]) * x[k]).sum();
            assert!(height <= exact(twice_energy) * (1.0 + 1e-15));
        }
    }
    Ok(())
}

// claim: C6.2-5
#[test]
fn s6_2_rolling_without_slipping() {
    for top in tops() {
        let size = vector(omega(&top, 0.0)).norm();
        let h = step(&top);
        // In units of what a point elsewhere on Θ does; observed 7e-15, the rounding of the coordinates over h.
        for n in (0..50).step_by(6) {
            let t = f64::from(n) * h;
            // The point of the body that is now in contact: at rest.
            let contact = at(&top, t).omega;
            let carried = |t: f64| in_space(at(&top, t).attitude.to_space(contact));
            let off = norm(derivative(carried, n, h)) / size / fastest(&top);
            observed!(off, 2e-15..=1e-14); // observed 5.2e-15
            // Herpolhode and polhode are run through at equal speed, in the same direction: dΩ/dt = ∂Ω/∂t.
            let in_plane = derivative(|t| in_space(omega_in_space(&top, t)), n, h);
            let on_body = euler(top.moments(), omega(&top, t));
            let seen = in_space(at(&top, t).attitude.to_space(vector(on_body)));
            let off = norm(difference(in_plane, seen)) / size / fastest(&top);
            observed!(off, 2e-15..=1e-14); // observed 5.5e-15
            // It pivots as well: the component of Ω along L.
            let l = top.angular_momentum_in_space();
            let pivot = omega_in_space(&top, t).dot(&l) / l.norm();
            close!(pivot, 2.0 * top.energy() / l.norm(), 2e-16..=3e-15);
        }
    }
}

/// The herpolhode's curvature from Euler's equations alone: Ω' × Ω'' along L over |Ω'|³, with Ω'' = ∂²Ω + Ω ∧ ∂Ω.
fn curvature(i: [f64; 3], o: [f64; 3]) -> f64 {
    let u = euler(i, o);
    let product = |j: usize, k: usize| u[j] * o[k] + o[j] * u[k];
    let acceleration = [
        (i[1] - i[2]) / i[0] * product(1, 2),
        (i[2] - i[0]) / i[1] * product(2, 0),
        (i[0] - i[1]) / i[2] * product(0, 1),
    ];
    let second = vector(acceleration) + vector(o).cross(&vector(u));
    let l = vector([0, 1, 2].map(|k| i[k] * o[k]));
    vector(u).cross(&second).dot(&l) / l.norm() / norm(u).powi(3)
}

// claim: C6.2-6
#[test]
fn s6_2_the_herpolhode_does_not_wind_back() {
    let mut numbers = Uniform(63);
    let mut bends = |moments: [f64; 3]| {
        let mut least = f64::INFINITY;
        for _ in 0..400 {
            let start = [0; 3].map(|_| numbers.signed());
            let l = vector([0, 1, 2].map(|k| moments[k] * start[k]));
            let picture = Poinsot::new(moments, l).unwrap();
            for k in 0..24 {
                let s = f64::from(k) * TAU / 24.0;
                let claimed = picture.herpolhode_curvature(s);
                let computed = curvature(moments, picture.polhode(s).components().into());
                // In units of the plane's height, as the curvature of a small polhode is large.
                let off = (claimed - computed).abs() / (1.0 + claimed.abs());
                observed!(off, 2e-15..=2e-14); // observed 4.8e-15
                least = least.min(claimed);
            }
        }
        least
    };
    for body in [[2.0, 3.0, 4.0], [1.2, 2.0, 3.0], MOMENTS, [1.0, 1.5, 2.5]] {
        assert!(bends(body) > 0.0, "{body:?}");
    }
    for none in [[1.0, 2.0, 3.5], [1.0, 2.0, 5.0]] {
        assert!(bends(none) < 0.0, "{none:?}");
    }
    // Seen in the motion itself: the turns of the curve in the plane, by differences.
    let turns = |moments: [f64; 3]| {
        let l = vector([0.5, 1.6, 0.02]);
        let top = EulerTop::beyond_bodies(moments, l, Attitude::identity()).unwrap();
        let normal = top.angular_momentum_in_space();
        let steps = 400;
        let at_step = |k: i32| omega_in_space(&top, top.period() * f64::from(k) / f64::from(steps));
        (0..steps)
            .filter(|k| {
                let (a, b, c) = (at_step(*k), at_step(k + 1), at_step(k + 2));
                (b - a).cross(&(c - b)).dot(&normal) < 0.0
            })
            .count()
    };
    assert_eq!(turns([1.0, 2.0, 3.0]), 0, "a lamina");
    assert!(turns([1.0, 2.0, 3.5]) > 0, "no body");
}

// claim: C6.2-7
#[test]
fn s6_2_ellipsoid_on_its_plane() {
    let top = tilted(MOMENTS, [0.4, 0.3, 1.0]);
    let l = top.angular_momentum_in_space();
    let picture = Poinsot::new(MOMENTS, vector([0.4, 0.6, 3.0])).unwrap();
    let height = 3.34 / 9.52f64.sqrt();
    close!(picture.plane_distance, height, 0.0..=5e-16);
    let [least, greatest] = picture.herpolhode_radii();
    let (mut low, mut high) = (f64::INFINITY, 0.0f64);
    for k in 0..720 {
        let t = top.period() * f64::from(k) / 720.0;
        let state = at(&top, t);
        // The contact point: on Θ, on Π, and no other point of Θ as high.
        let contact = omega_in_space(&top, t);
        let foot = contact - l * (contact.dot(&l) / l.dot(&l));
        low = low.min(foot.norm());
        high = high.max(foot.norm());
        if k % 60 == 0 {
            for n in 0..200 {
                let (z, phi) = (-0.995 + 0.01 * f64::from(n), 2.4 * f64::from(n));
                let rim = (1.0 - z * z).sqrt();
                let [a, b, c] = picture.semi_axes;
                let point = vector([a * rim * phi.cos(), b * rim * phi.sin(), c * z]);
                assert!(state.attitude.to_space(point).dot(&l) < 3.34);
            }
        }
        // The curve drawn from the parameter is the curve of the motion.
        let parameter = self::picture(&top, t).start();
        let off = (picture.polhode(parameter) - state.omega).norm();
        observed!(off, 2e-16..=2e-15); // observed 4.8e-16
    }
    near!(low, least, 1e-6..=1e-5); // observed 3.3e-6
    assert!(low >= least - 1e-15 && high <= greatest + 1e-15 && greatest - high < 1e-4);
}

// claim: C6.2-6, C6.2-7
#[test]
fn s6_2_radii_of_the_herpolhode() {
    // The extremes are reached where a component of Ω vanishes: there the motion must be at the closed-form distance.
    for (_, omega0, top) in random_tops(64, 200) {
        let picture = picture(&top, 0.0);
        let radii = picture.herpolhode_radii();
        let l = at(&top, 0.0).angular_momentum;
        let radius = |o: [f64; 3]| l.cross(&vector(o)).norm() / l.norm();
        let size = vector(omega0).norm();
        let quarter = FRAC_PI_2;
        let expected = [quarter, 0.0].map(|s| {
            let o: [f64; 3] = picture.polhode(s).components().into();
            let here = momentum(&top, o);
            here.cross(&vector(o)).norm() / here.norm()
        });
        observed!(norm(difference(radii, expected)) / size, 0.0..=8e-16); // observed 2.5e-16
        let start = radius(omega0);
        assert!(radii[0] - 1e-14 * size <= start && start <= radii[1] + 1e-14 * size);
        let off = distance(picture.polhode(picture.start()), omega0);
        observed!(off / size, 1e-16..=2e-15); // observed 4.1e-16
    }
}

/// The narrower half width of a polhode may be less than any double.
#[test]
fn s6_3_a_polhode_flatter_than_doubles_begins_where_it_should() {
    let l = BodyVector::new(3.6519420379412075, f64::MAX, 0.0);
    let picture = Poinsot::new([0.5, 9.8304846383639, 1.4002434530615526e-33], l).unwrap();
    assert_eq!(picture.start().abs(), FRAC_PI_2);
    let l = BodyVector::new(3e-308, 1.0, 1e-325);
    let picture = Poinsot::new([0.5, 9.8, 1e-33], l).unwrap();
    assert_eq!(picture.start().abs(), FRAC_PI_2);
}
