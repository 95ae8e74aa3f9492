//! Paragraph 6.3: the polhodes, and what they tell about the racket. Times and rates: `stability.rs`.

use super::*;
use spinning_bodies::euler_top::Sector;

// claim: C6.3-1, C6.3-4
#[test]
fn s6_3_range_of_the_ratio_and_lyapunov_functions() {
    for ([i1, i2, i3], o) in rational_starts(631, 300) {
        let [o1, o2, o3] = o;
        let (twice_energy, l2) = integrals([i1, i2, i3], o);
        // Definite across x₁ and across x₃, with positive coefficients as the moments ascend.
        let about_smallest = |o2: R, o3: R| i2 * (i2 - i1) * o2 * o2 + i3 * (i3 - i1) * o3 * o3;
        let about_largest = |o1: R, o2: R| i1 * (i3 - i1) * o1 * o1 + i2 * (i3 - i2) * o2 * o2;
        assert_eq!(l2 - twice_energy * i1, about_smallest(o2, o3));
        assert_eq!(twice_energy * i3 - l2, about_largest(o1, o2));
        assert!(i2 > i1 && i3 > i2 && i1 > ZERO);
        // Off the axes.
        assert!(twice_energy * i1 < l2 && l2 < twice_energy * i3);
        // Indefinite across x₂.
        let about_middle = |o1: R, o3: R| i3 * (i3 - i2) * o3 * o3 - i1 * (i2 - i1) * o1 * o1;
        assert_eq!(l2 - twice_energy * i2, about_middle(o1, o3));
        assert!(about_middle(o1, ZERO) < ZERO && about_middle(ZERO, o3) > ZERO);
        // Equality on the axes.
        let (e1, l1) = integrals([i1, i2, i3], [o1, ZERO, ZERO]);
        let (e3, l3) = integrals([i1, i2, i3], [ZERO, ZERO, o3]);
        assert!(l1 == e1 * i1 && l3 == e3 * i3);
        // And constant: the gradient is at right angles to Euler's equations.
        let rate = euler([i1, i2, i3], o);
        let about_smallest = i2 * (i2 - i1) * o2 * rate[1] + i3 * (i3 - i1) * o3 * rate[2];
        let about_largest = i1 * (i3 - i1) * o1 * rate[0] + i2 * (i3 - i2) * o2 * rate[1];
        assert_eq!([about_smallest, about_largest], [ZERO; 2]);
    }
}

// claim: C6.3-6
#[test]
fn s6_3_ellipsoid_meets_sphere() {
    for (moments, _, top) in random_tops(636, 200) {
        let start = at(&top, 0.0).angular_momentum;
        let twice_energy = 2.0 * top.energy();
        let picture = picture(&top, 0.0);
        for k in 0..12 {
            let l = at(&top, f64::from(k) * 0.83).angular_momentum;
            let drawn = picture.polhode_of_l(f64::from(k) * 0.5);
            for l in [l, drawn] {
                let c = l.components();
                let squares = (0..3).map(|k| c[k] * c[k] / (twice_energy * moments[k]));
                let on_ellipsoid: f64 = squares.sum();
                observed!((on_ellipsoid - 1.0).abs(), 4e-16..=4e-15); // observed 1.1e-15
                observed!((l.norm() / start.norm() - 1.0).abs(), 1e-16..=2e-15); // observed 4.4e-16
            }
        }
    }
    // The separatrix lies in two planes through x₂, of slope 3/4 for I = (3/2, 3, 4), a number the machine has: the motion is on it, and stays.
    for (l3, slope) in [(2.0, 0.75), (-2.0, -0.75)] {
        let top = thrown([1.5, 3.0, 4.0], [1.0, 0.5, l3]);
        assert_eq!(top.regime(), Regime::Separatrix);
        for k in -40..40 {
            let [o1, _, o3] = omega(&top, 5.0 * f64::from(k));
            // Two roundings, far out where both are nearly gone as well.
            observed!((o3 / o1 / slope - 1.0).abs(), 0.0..=4.5e-16); // observed none
        }
    }
    // On these planes, L² = 2EI₂ exactly: 7.5 = 3 · 2.5 and so on.
    let o = [rational(2, 3), rational(1, 6), rational(1, 2)];
    let i = [rational(3, 2), whole(3), whole(4)];
    let (twice_energy, l2) = integrals(i, o);
    assert_eq!(l2, twice_energy * i[1]);
}

// claim: C6.3-7
#[test]
fn s6_3_four_eyes() {
    let mut numbers = Uniform(637);
    let mut seen = [0; 4];
    for _ in 0..300 {
        let o: [f64; 3] = [0; 3].map(|_| numbers.signed());
        let top = tilted(MOMENTS, o);
        let picture = picture(&top, 0.0);
        // The axis that the curve goes round; |Ω₃| against |Ω₁|/√3 decides.
        let about_largest = o[2].abs() > o[0].abs() / 3f64.sqrt();
        let (axis, regime, sector) = if about_largest {
            (2, Regime::AroundLargest, Sector::AroundLargest)
        } else {
            (0, Regime::AroundSmallest, Sector::AroundSmallest)
        };
        assert_eq!((top.regime(), picture.sector), (regime, sector), "{o:?}");
        // In one period it goes once round its centre, on one side; and round none of the two other axes.
        for turning in 0..3 {
            let (a, b) = ((turning + 1) % 3, (turning + 2) % 3);
            let steps = 400;
            let place = |k: i32| {
                let state = at(&top, top.period() * f64::from(k) / f64::from(steps));
                let l = state.angular_momentum.components();
                (l[a], l[b], l[turning])
            };
            let mut angle = 0.0;
            for k in 0..steps {
                let ((a0, b0, c), (a1, b1, _)) = (place(k), place(k + 1));
                angle += (a0 * b1 - b0 * a1).atan2(a0 * a1 + b0 * b1);
                // It keeps to its side.
                assert!(turning != axis || c.signum() == o[axis].signum());
            }
            let turns = angle / TAU;
            if turning == axis {
                // dΩ₁ = −(I₃−I₂)Ω₂Ω₃/I₁: with the spin about the largest moment, against it about the smallest.
                let sense = if about_largest { 1.0 } else { -1.0 } * o[axis].signum();
                near!(turns, sense, 6e-16..=6e-15); // observed 1.9e-15
            } else {
                observed!(turns.abs(), 2e-16..=2e-15); // observed 6.3e-16
            }
        }
        seen[axis + usize::from(o[axis] < 0.0)] += 1;
    }
    assert!(seen.iter().all(|count| *count > 20), "{seen:?}");
    // The four eyes meet at ±x₂: the rims drawn by the separatrix pass there.
    let rim = Poinsot::new([1.5, 3.0, 4.0], vector([1.0, 0.5, 2.0])).unwrap();
    assert_eq!(rim.sector, Sector::Separatrix);
    let corner = rim.polhode(FRAC_PI_2);
    let [x, y, z] = corner.components().into();
    observed!(x.hypot(z) / y.abs(), 0.0..=2.3e-16); // observed 6.8e-17
    // It dawdles there: equal times are crowded next to x₂, as the pace tells.
    let near = Poinsot::new(MOMENTS, vector([0.01, 2.0, 0.02])).unwrap();
    let top = thrown(MOMENTS, [0.01, 2.0, 0.02]);
    let close = (0..1000)
        .filter(|k| omega(&top, top.period() * f64::from(*k) / 1000.0)[1].abs() > 0.99)
        .count();
    // So many of a thousand equal times within 8 degrees of the middle axis.
    assert!(close > 550, "{close}");
    assert!(near.pace(FRAC_PI_2) < 0.02 * near.pace(0.0));
}

// claim: C6.3-8
#[test]
fn s6_3_the_racket_and_its_axes() {
    // Head, strings and handle in the plane of x and y, the handle along x.
    let hoop_like = shapes::ellipse_lamina(0.25, [0.16, 0.13]).unwrap();
    let handle = shapes::rectangle_lamina(0.1, [0.35, 0.03]).unwrap();
    let handle = handle.moved(vector([-0.33, 0.0, 0.0])).unwrap();
    let racket = MassProperties::compose(&[hoop_like, handle]).unwrap();
    let axes = racket.inertia().principal_axes();
    let [i1, i2, i3] = axes.moments;
    assert!(i1 < i2 && i2 < i3);
    // A lamina: the moment about its normal is the sum of the two others.
    close!(i3, i1 + i2, 0.0..=4.5e-16);
    // Least about the handle, middle across it in the plane, greatest about the normal.
    for k in 0..3 {
        let along = axes.axes[(k, k)].abs();
        observed!((along - 1.0).abs(), 0.0..=4.5e-16); // observed none
    }
}

// claim: C6.3-9
#[test]
fn s6_3_the_picture_does_not_tell_the_pace() {
    for (moments, omega0, slow) in random_tops(639, 100) {
        for (s, tolerance) in [(8.0, 0.0), (0.125, 0.0), (3.0, 2e-14)] {
            let fast = tilted(moments, omega0.map(|o| s * o));
            assert_eq!(fast.regime(), slow.regime());
            close!(fast.period() * s, slow.period(), 1e-16..=2e-15); // observed 4.4e-16
            for t in [0.4, 9.0, -3.0] {
                // The same point of the curve, s times as large, at time t/s.
                let expected = omega(&slow, t).map(|o| s * o);
                let actual = fast.omega_at(t / s).unwrap();
                let off = distance(actual, expected) / vector(expected).norm();
                within(off, tolerance);
            }
            let [curve, wide] = [&slow, &fast].map(|top| picture(top, 0.0));
            for k in 0..6 {
                let parameter = f64::from(k);
                let error = (wide.polhode(parameter) - curve.polhode(parameter) * s).norm();
                observed!(error / wide.polhode(parameter).norm(), 2e-16..=2e-15); // observed 5.3e-16
                // The pace is what makes a polhode of it that obeys Euler's equations.
                let h = 1e-5;
                let way = wide.polhode(parameter + h) - wide.polhode(parameter - h);
                let velocity = way * (wide.pace(parameter) / (2.0 * h));
                let law = vector(euler(moments, wide.polhode(parameter).components().into()));
                let off = (velocity - law).norm() / wide.polhode(parameter).norm();
                observed!(off / wide.pace(0.0), 1e-12..=3e-10);
            }
        }
    }
}
