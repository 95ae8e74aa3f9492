//! The exact motion at its borders: regimes, scales, axes in any order, next to the separatrix, times both ways and far away,
//! and what is refused.

use super::*;
use support::ORDERS;

fn reordered<T: Copy>(v: [T; 3], order: [usize; 3]) -> [T; 3] {
    order.map(|k| v[k])
}

#[test]
fn euler_top_decides_the_regime_by_exact_differences() {
    let tiny = f64::from_bits(1);
    let (up, down) = (2f64.next_up(), 2f64.next_down());
    let (above, below) = (3f64.next_up(), 3f64.next_down());
    use Regime::{AroundLargest, AroundSmallest, AtRest, PermanentRotation, Rod};
    use Regime::{Separatrix, Sphere, Symmetric};
    for (moments, l, regime) in [
        (MOMENTS, [0.0, -0.0, 0.0], AtRest),
        (MOMENTS, [0.0, -0.0, tiny], PermanentRotation),
        (MOMENTS, [0.0, 1.0, 0.0], PermanentRotation),
        (MOMENTS, [0.0, 1.0, tiny], AroundLargest),
        (MOMENTS, [-tiny, 1.0, 0.0], AroundSmallest),
        ([2.0; 3], [1.0, 2.0, 3.0], Sphere),
        ([0.0, 2.0, 2.0], [0.0, 1.0, 1.0], Rod),
        ([2.0, 2.0, 3.0], [1.0, 2.0, 3.0], Symmetric),
        ([2.0, 2.0, 3.0], [1.0, 2.0, 0.0], PermanentRotation),
        ([2.0, up, 3.0], [1.0, 2.0, 0.0], AroundSmallest),
        ([1.0, 2.0, 2.0], [1.0, 2.0, 3.0], Symmetric),
        ([1.0, 2.0, up], [0.0, 2.0, 3.0], AroundLargest),
        // The squares of these slopes are in the ratio 4 : 1 exactly.
        ([1.5, 3.0, 4.0], [1.0, 7.0, 2.0], Separatrix),
        ([1.5, 3.0, 4.0], [1e-200, 7.0, -2e-200], Separatrix),
        ([1.5, 3.0, 4.0], [1.0, 7.0, up], AroundLargest),
        ([1.5, 3.0, 4.0], [1.0, 7.0, down], AroundSmallest),
        ([1.5, above, 4.0], [1.0, 7.0, 2.0], AroundSmallest),
        ([1.5, below, 4.0], [1.0, 7.0, 2.0], AroundLargest),
    ] {
        for order in ORDERS {
            for scale in [1.0, 2f64.powi(-40), 2f64.powi(300)] {
                let l = l.map(|x| if x.abs() == tiny { x } else { x * scale });
                let top = thrown(reordered(moments, order), reordered(l, order));
                assert_eq!(top.regime(), regime, "{moments:?} {l:?} {order:?}");
                let moves = matches!(regime, Symmetric | AroundLargest | AroundSmallest);
                assert_eq!(top.period().is_finite(), moves);
                assert_eq!(top.geometric_phase().is_some(), moves);
                // At t = 0 it stands where it was put.
                let state = at(&top, 0.0);
                let off = distance(state.angular_momentum, reordered(l, order));
                within(off, 4e-16 * norm(l));
                observed!(state.attitude.angle_to(&Attitude::identity()), 0.0..=4e-16); // observed 1.1e-16
            }
        }
    }
}

#[test]
fn euler_top_rods_and_rest() {
    // A rod turns steadily about L; a spin about itself is ignored in Ω and refused in L.
    let rod = tilted([0.0, 2.0, 2.0], [5.0, 0.6, 0.8]);
    assert_eq!(rod.regime(), Regime::Rod);
    assert_eq!([rod.energy(), rod.mean_precession_rate()], [1.0; 2]);
    let state = at(&rod, 0.4);
    assert_eq!(state.omega, vector([0.0, 0.6, 0.8]));
    let turned = Attitude::about_axis(vector([0.0, 0.6, 0.8]), 0.4).unwrap();
    observed!(state.attitude.angle_to(&turned), 0.0..=3e-16); // observed 7.9e-17
    let (about_itself, start) = (vector([1e-300, 0.0, 1.0]), Attitude::identity());
    let spinning = EulerTop::new([0.0, 2.0, 2.0], about_itself, start);
    refused!(spinning, Condition);
    let still = thrown(MOMENTS, [0.0; 3]);
    assert_eq!((still.energy(), still.mean_precession_rate()), (0.0, 0.0));
}

#[test]
fn euler_top_refuses_what_it_cannot_know() {
    // What would overflow is refused where it is made.
    let endless = EulerTop::new([1e-300; 3], vector([1e300, 0.0, 0.0]), Attitude::identity());
    assert!(endless.is_err());
    // Too many quarter periods to count: the limit is named, and it is one.
    let top = tilted(MOMENTS, [1.0; 3]);
    let refused = top.at(1e17);
    let Err(Error::OutOfRange {
        least,
        greatest: most,
        ..
    }) = refused
    else {
        panic!("{refused:?}")
    };
    assert!(most > 2f64.powi(53) * top.period() / 4.0 * 0.999 && least == -most);
    assert!(top.at(0.999 * most).is_ok() && top.at(1.001 * least).is_err());
}

#[test]
fn euler_top_regime_against_integers() {
    // Moments and components of 26 bits: (L² − 2EI₂)I₁I₃ = I₁(I₃−I₂)L₃² − I₃(I₂−I₁)L₁² fits an i128. L₃ is chosen next to the
    // separatrix, so that up to 50 of the 105 bits cancel.
    let mut numbers = Uniform(672);
    let mut seen = [0; 3];
    for _ in 0..20_000 {
        let mut integer = |least: f64| (least + numbers.next() * (2f64.powi(26) - least)).round();
        let [a, b, c] = [0; 3].map(|_| integer(1.0) / 2.0);
        let i = sorted([b + c, c + a, a + b].map(f64::round));
        if i[0] == i[1] || i[1] == i[2] {
            continue;
        }
        let (l1, l2) = (integer(1e6), integer(1.0));
        let slope = (i[2] * (i[1] - i[0]) / (i[0] * (i[2] - i[1]))).sqrt();
        let l3 = (l1 * slope + 2.0 * numbers.signed()).round();
        if l3 > 2f64.powi(26) {
            continue;
        }
        let [j1, j2, j3, m1, m3] = [i[0], i[1], i[2], l1, l3].map(|x| x as i128);
        // Of L, and of the same numbers as Ω.
        let exact = [
            j1 * (j3 - j2) * m3 * m3 - j3 * (j2 - j1) * m1 * m1,
            j3 * (j3 - j2) * m3 * m3 - j1 * (j2 - j1) * m1 * m1,
        ];
        let l = vector([l1, l2, -l3]);
        let tops = [EulerTop::beyond_bodies, EulerTop::from_omega];
        let tops = tops.map(|made| made(i, l, Attitude::identity()));
        for (top, exact) in tops.into_iter().zip(exact) {
            // The rounded moments may miss the triangle inequality by one.
            let Ok(top) = top else { continue };
            let (expected, place) = match exact.signum() {
                1 => (Regime::AroundLargest, 0),
                -1 => (Regime::AroundSmallest, 1),
                _ => (Regime::Separatrix, 2),
            };
            assert_eq!(top.regime(), expected, "{i:?} {l:?} {exact}");
            seen[place] += 1;
        }
    }
    assert!(seen[0] > 1000 && seen[1] > 1000, "{seen:?}");
}

#[test]
fn euler_top_phase_of_thin_and_wide_cones() {
    // Symmetric: the cone is round, 4π sin²(θ/2), with the wobble's sense.
    for (axial, sense) in [(1.5, -1.0), (0.5, 1.0)] {
        for tilt in [1e-150, 1e-8, 0.1, 1.0, FRAC_PI_2 - 1e-9, 2.5, PI - 1e-6] {
            let top = thrown([1.0, 1.0, axial], [tilt.sin(), 0.0, tilt.cos()]);
            // Seen from its own end L goes round the nearer end of the axis. The tilt is that of the rounded components.
            let [l1, _, l3]: [f64; 3] = at(&top, 0.0).angular_momentum.components().into();
            let size = l1.hypot(l3);
            let expected = sense * TAU * (l1 / size) * (l1 / (size + l3.abs()));
            let geometric = top.geometric_phase().unwrap().geometric;
            observed!((geometric / expected - 1.0).abs(), 0.0..=8e-16); // observed 2.2e-16
        }
    }
    // Thin cones about the stable axes are ellipses: area π P₁P₂/|L|², half axes by 6.7.
    for tilt in [1e-3, 1e-9, 1e-150] {
        for (omega, area, slack) in [
            ([tilt, 0.0, 1.0], -tilt * 2.0 * tilt / 9.0, 0.15),
            ([1.0, 0.0, tilt], 3.0 * tilt * 2.0 * 3f64.sqrt() * tilt, 8.0),
        ] {
            let phase = tilted(MOMENTS, omega).geometric_phase().unwrap();
            let error = (phase.geometric / (PI * area) - 1.0).abs();
            within(error, 1e-15 + slack * tilt * tilt);
        }
    }
    // Towards the separatrix both sides together fill the hemisphere; the two terms still make up the mean precession.
    for e in 1..17 {
        let d = 10f64.powi(-e);
        let tops = [
            thrown([1.5, 3.0, 4.0], [1.0, 0.5, 2.0 * (1.0 + d)]),
            thrown([1.5, 3.0, 4.0], [1.0 + d, 0.5, 2.0]),
        ];
        let mut both = 0.0;
        for top in tops {
            if top.regime() == Regime::Separatrix {
                continue;
            }
            let phase = top.geometric_phase().unwrap();
            let turn = top.mean_precession_rate() * top.period();
            let rest = support::wrapped(turn - phase.dynamical - phase.geometric).abs();
            observed!(rest / turn, 0.0..=8e-16); // observed 2.4e-16
            both += phase.geometric.abs();
        }
        // Two of the four eyes: half of the sphere, but for d ln d.
        if e < 16 {
            within((both - TAU).abs(), 8.0 * d * (1.0 - d.ln())); // observed a third of it
        }
    }
}

/// Moments r², (r² + q²)/2, q² and L = (p r, L₂, p q) make both sides of I₁(I₃ − I₂)L₃² = I₃(I₂ − I₁)L₁² one whole number of 200 bits, a different
/// product on each: the separatrix, and not a hair beside it.
#[test]
fn s6_6_whole_numbers_on_the_separatrix() {
    let mut numbers = Uniform(200);
    let mut odd = |bits: i32| 2.0 * (2f64.powi(bits - 2) * (1.0 + numbers.next())).floor() + 1.0;
    for _ in 0..200 {
        let (p, r, q) = (odd(26), odd(25), odd(26));
        let moments = [r * r, 0.5 * (r * r + q * q), q * q];
        let third = p * q;
        for (third, regime) in [
            (third, Regime::Separatrix),
            (third.next_up(), Regime::AroundLargest),
            (third.next_down(), Regime::AroundSmallest),
        ] {
            let l = vector([p * r, 1.0, third]);
            let top = EulerTop::beyond_bodies(moments, l, Attitude::identity()).unwrap();
            assert_eq!(top.regime(), regime, "{moments:?} {p}");
        }
    }
}
