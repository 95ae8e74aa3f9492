//! Paragraphs 6.4 and 6.6: the sphere, and the generic top in Jacobi's functions.

use super::*;

/// The solution as the tutorial displays it, from I, 2E and L²; `sector` 3 for Ω₃ > 0, 1 with the indices 3 and 1 exchanged.
fn displayed(i: [f64; 3], twice_energy: f64, l2: f64, t: f64) -> [f64; 3] {
    let [i1, i2, i3] = i;
    let (d1, d3) = (l2 - twice_energy * i1, l2 - twice_energy * i3);
    let k2 = (i1 - i2) * d3 / ((i3 - i2) * d1);
    let tau = t * ((i3 - i2) * d1 / (i1 * i2 * i3)).sqrt();
    let jacobi = jacobi(k2, tau);
    [
        (d3 / ((i1 - i3) * i1)).sqrt() * jacobi.cn,
        (d3 / ((i2 - i3) * i2)).sqrt() * jacobi.sn,
        (d1 / ((i3 - i1) * i3)).sqrt() * jacobi.dn,
    ]
}

/// The same after I₁ and I₃, Ω₁ and Ω₃ have changed names.
fn displayed_exchanged([i1, i2, i3]: [f64; 3], twice_energy: f64, l2: f64, t: f64) -> [f64; 3] {
    let [o3, o2, o1] = displayed([i3, i2, i1], twice_energy, l2, t);
    [o1, o2, o3]
}

// claim: C6.4-1
#[test]
fn s6_4_spherical_top() {
    let omega0 = [0.3, -0.4, 1.2];
    assert_eq!(euler([2.5; 3], omega0), [0.0; 3]);
    for moments in [[2.5; 3], [1e-150; 3], [1e150; 3]] {
        let top = tilted(moments, omega0);
        assert_eq!(top.regime(), Regime::Sphere);
        assert_eq!((top.period(), top.geometric_phase()), (f64::INFINITY, None));
        assert_eq!(top.mean_precession_rate(), 1.3, "it turns about L at |Ω|");
        for t in [-7.0, 0.0, 0.9, 1e3] {
            let state = at(&top, t);
            assert_eq!(state.omega, vector(omega0));
            let turned = Attitude::about_axis(vector(omega0), 1.3 * t).unwrap();
            // One rounding of the rate times the time.
            let off = state.attitude.angle_to(&turned);
            within(off, 4e-16 + 2e-16 * 1.3 * t.abs());
        }
    }
    // One unit in the last place from it, Ω has not moved after a day of turning.
    let nearly = tilted([2.5, 2.5f64.next_up(), 2.5], omega0);
    assert_eq!(nearly.regime(), Regime::Symmetric);
    observed!(distance(at(&nearly, 100.0).omega, omega0), 3e-15..=3e-14); // observed 8.8e-15
}

// claim: C6.6-1
#[test]
fn s6_6_sectors() {
    let mut numbers = Uniform(661);
    let mut seen = [0; 2];
    for _ in 0..80 {
        let moments = sorted(random_moments(&mut numbers));
        let omega0: [f64; 3] = [0; 3].map(|_| numbers.signed());
        let mut flight = Flight::from_omega(moments, omega0);
        let l = vector([0, 1, 2].map(|k| moments[k] * omega0[k]));
        let (twice_energy, l2) = (l.dot(&vector(omega0)), l.dot(&l));
        assert!(moments[0] < l2 / twice_energy && l2 / twice_energy < moments[2]);
        let above = l2 > twice_energy * moments[1];
        let regime = tilted(moments, omega0).regime();
        let sides = [Regime::AroundSmallest, Regime::AroundLargest];
        assert_eq!(regime, sides[usize::from(above)]);
        // By the integrator: the one keeps its sign for a period, the two others change theirs.
        let period = tilted(moments, omega0).period();
        let mut changed = [false; 3];
        for _ in 0..24 {
            let now: [f64; 3] = flight.fly(period / 24.0).omega().components().into();
            for k in 0..3 {
                changed[k] |= now[k].signum() != omega0[k].signum();
            }
        }
        assert_eq!(changed, [above, true, !above], "{moments:?} {omega0:?}");
        seen[usize::from(above)] += 1;
    }
    assert!(seen[0] > 15 && seen[1] > 15, "{seen:?}");
    // The condition: on the axes the bounds are reached, and on the separatrix neither sign is in danger.
    let (energy, l2) = integrals([1, 2, 3].map(whole), [TWO, ZERO, ZERO]);
    assert_eq!(l2, energy);
    let between = thrown([1.5, 3.0, 4.0], [1.0, 0.5, 2.0]);
    assert_eq!(between.regime(), Regime::Separatrix);
}

// claim: C6.6-2, C6.6-3, C6.6-4, C6.6-5
#[test]
fn s6_6_from_the_integrals_to_the_modulus() {
    for ([i1, i2, i3], [o1, o2, o3]) in rational_starts(662, 200) {
        let (e, l2) = integrals([i1, i2, i3], [o1, o2, o3]);
        let (d1, d2, d3) = (l2 - e * i1, l2 - e * i2, l2 - e * i3);
        // Ω₃² and Ω₁² from Ω₂², as displayed.
        let third = |s: R| (d1 - (i2 - i1) * i2 * s) / ((i3 - i1) * i3);
        let first = |s: R| (d3 - (i2 - i3) * i2 * s) / ((i1 - i3) * i1);
        assert_eq!((first(o2 * o2), third(o2 * o2)), (o1 * o1, o3 * o3));
        // Ω₂'² as a polynomial of degree 4 in Ω₂: fifth differences vanish, the fourth does not.
        let factor = (i3 - i1) / i2;
        let quartic = |x: R| factor * factor * third(x * x) * first(x * x);
        let rate = factor * o3 * o1;
        assert_eq!(quartic(o2), rate * rate);
        let difference = |binomial: &[i128]| -> R {
            let terms = (0..)
                .zip(binomial)
                .map(|(n, b)| whole(*b) * quartic(whole(n)));
            terms.sum()
        };
        assert_eq!(difference(&[1, -5, 10, -10, 5, -1]), ZERO);
        let fourth = difference(&[1, -4, 6, -4, 1]);
        // 4! times the leading coefficient.
        let leading =
            factor * factor * (i2 - i1) * i2 * (i2 - i3) * i2 / ((i3 - i1) * i3 * (i1 - i3) * i1);
        assert_eq!(fourth, whole(24) * leading);
        assert!(leading != ZERO);
        // Its roots: where Ω₃ or Ω₁ vanishes.
        assert_eq!(third(d1 / ((i2 - i1) * i2)), ZERO);
        assert_eq!(first(d3 / ((i2 - i3) * i2)), ZERO);
        // τ² = t²·rate, ω² = Ω₂²·scale: (dω/dτ)² = (1 − ω²)(1 − k²ω²).
        let rate = (i3 - i2) * d1 / (i1 * i2 * i3);
        let scale = (i2 - i3) * i2 / d3;
        let k2 = (i1 - i2) * d3 / ((i3 - i2) * d1);
        for x in [o2, rational(1, 5), rational(7, 3)] {
            let w2 = x * x * scale;
            assert_eq!(quartic(x) * scale / rate, (ONE - w2) * (ONE - k2 * w2));
        }
        // The complement, and when it is positive.
        assert_eq!(ONE - k2, (i3 - i1) * d2 / ((i3 - i2) * d1));
        assert!(k2 > ZERO);
        // The condition: the sector of Ω₃.
        assert_eq!(k2 < ONE, d2 > ZERO);
        let exchanged = (i3 - i2) * d1 / ((i1 - i2) * d3);
        assert_eq!(exchanged, ONE / k2, "the other sector has the inverse");
        // The motion itself obeys the quartic.
        let moments = [i1, i2, i3].map(exact);
        let start = [o1, o2, o3].map(exact);
        let top = tilted(moments, start);
        let size = vector(start).norm();
        let [slope] = derivative(|t| [omega(&top, t)[1]], 0, step(&top));
        let off = (slope * slope - exact(quartic(o2))).abs() / size.powi(4);
        observed!(off, 4e-16..=4e-15); // observed 1.1e-15
    }
}

// claim: C6.6-4
#[test]
fn s6_6_sine_amplitude_inverts_the_integral() {
    for m in [0.0, 0.3, 0.5, 0.99] {
        // ∫₀^{1/2} dω/√((1−ω²)(1−mω²)).
        let slope = |x: f64| 1.0 / ((1.0 - x * x) * (1.0 - m * x * x)).sqrt();
        let tau = integral(slope, 0.0, 0.5);
        near!(jacobi(m, tau).sn, 0.5, 2e-16..=2e-15); // observed 4.4e-16
    }
}

// claim: C6.6-6
#[test]
fn s6_6_the_example() {
    let top = example();
    assert_eq!(top.regime(), Regime::AroundLargest);
    let expected = [
        -1.293_305_335_680_710_981_7,
        -0.572_154_969_129_696_090_4,
        1.106_441_547_077_867_780_8,
    ];
    // √2 and 2/√3 are rounded at the start.
    observed!(distance(at(&top, 10.0).omega, expected), 0.0..=1.1e-14);
    let shown = vector(displayed(MOMENTS, 6.0, 14.0, 10.0));
    observed!(distance(shown, expected), 0.0..=1.1e-14);
}

// claim: C6.6-7, C6.6-8
#[test]
fn s6_6_period_and_half_period() {
    let top = example();
    let gamma: f64 = 3.625_609_908_221_908_311_930_7; // Γ(1/4)
    let closed = 3f64.sqrt() * gamma * gamma / (2.0 * PI.sqrt());
    let period = 6.422_703_084_225_693_595_902_933;
    close!(closed, period, 0.0..=4.5e-16);
    close!(top.period(), period, 0.0..=4.5e-16);
    let half = complete_first(Parameter::from_parameter(0.5).unwrap()).unwrap();
    close!(4.0 * half * (6.0f64 / 8.0).sqrt(), period, 0.0..=4.5e-16);
    let mut numbers = Uniform(667);
    for n in 0..30 {
        let (moments, omega0) = if n == 0 {
            (MOMENTS, omega(&top, 0.0))
        } else {
            random_start(&mut numbers)
        };
        let top = tilted(moments, omega0);
        let size = vector(omega0).norm();
        // What keeps its sign, and the two that change it.
        let kept = kept_axis(&top);
        let halfway = Flight::from_omega(moments, omega0).fly(top.period() / 2.0);
        let flipped = [0, 1, 2].map(|k| if k == kept { omega0[k] } else { -omega0[k] });
        // The period's own rounding moves Ω by 2 ulp of a turn.
        observed!(distance(halfway.omega(), flipped) / size, 1e-16..=2e-15); // observed 3.4e-16
        let full = Flight::from_omega(moments, omega0).fly(top.period());
        observed!(distance(full.omega(), omega0) / size, 2e-16..=2e-15); // observed 6e-16
        let off = distance(at(&top, top.period()).omega, omega0) / size;
        observed!(off, 1e-16..=3e-15); // observed 7.1e-16
        // Not before, and the attitude does not come back with it.
        let early = at(&top, 0.25 * top.period()).omega;
        assert!((early - vector(omega0)).norm() > 1e-3 * size);
        assert!(full.attitude().angle_to(&Attitude::identity()) > 1e-3);
    }
}

// claim: C6.6-10
#[test]
fn s6_6_other_sector() {
    let top = tilted(MOMENTS, [2.0, 0.0, 1.0]);
    assert_eq!(top.regime(), Regime::AroundSmallest);
    let expected = [
        1.361_281_669_285_640_298_2,
        1.465_234_526_233_565_325_9,
        0.533_256_593_374_802_810_1,
    ];
    observed!(distance(at(&top, 1.0).omega, expected), 0.0..=4.5e-16); // observed none
    // 2E = 7, L² = 13: exchange 1 and 3 in every formula, and no sign.
    let shown = |t: f64| vector(displayed_exchanged(MOMENTS, 7.0, 13.0, t));
    observed!(distance(shown(1.0), expected), 0.0..=4.5e-16); // observed none
    observed!(distance(shown(5.0), omega(&top, 5.0)), 1e-16..=2e-15); // observed 3.8e-16
    close!(top.period(), 7.470_389_337_573_354_766_3, 0.0..=4.5e-16);
}

// claim: C6.6-11
#[test]
fn s6_6_signs() {
    for start in [[1.1, 0.7, 0.9], [2.0, 0.3, 1.0], [1.0, 0.5, 0.5]] {
        let plain = tilted(MOMENTS, start);
        for pattern in 0..8 {
            let sign = [0, 1, 2].map(|k| if pattern >> k & 1 == 1 { -1.0 } else { 1.0 });
            let turned = |o: [f64; 3]| [0, 1, 2].map(|k| sign[k] * o[k]);
            let top = tilted(MOMENTS, turned(start));
            assert_eq!(top.regime(), plain.regime());
            for t in [0.6, 4.0, -9.0] {
                // An even number of flips is a half turn of the body; an odd number reverses time.
                let time = t * sign[0] * sign[1] * sign[2];
                assert_eq!(omega(&top, t), turned(omega(&plain, time)));
                if time != t {
                    assert!(distance(at(&top, t).omega, turned(omega(&plain, t))) > 0.1);
                }
            }
        }
    }
}

// claim: C6.6-12
#[test]
fn s6_6_separatrix() {
    // L = (1, 0, 2) with I = (3/2, 3, 4). sech, tanh, sech, for ever.
    let moments = [1.5, 3.0, 4.0];
    let top = thrown(moments, [1.0, 0.0, 2.0]);
    assert_eq!(top.regime(), Regime::Separatrix);
    assert_eq!((top.period(), top.geometric_phase()), (f64::INFINITY, None));
    // L² = 5, 2E = 5/3: rate² = (I₃−I₂)(L²−2EI₁)/(I₁I₂I₃) = 2.5/18.
    let rate = (2.5f64 / 18.0).sqrt();
    for t in [-1800.0, -60.0, -1.0, 0.0, 0.3, 2.0, 37.0, 400.0, 1800.0] {
        let l = at(&top, t).angular_momentum;
        let (sech, tanh) = (1.0 / (rate * t).cosh(), (rate * t).tanh());
        near!(l.y(), 5f64.sqrt() * tanh, 0.0..=4e-16); // observed 1.1e-16
        // The tails relative to themselves, down to 1e-290: the rounding of the rate times the time.
        let slack = 1e-15 + 4e-16 * rate * t.abs();
        within((l.x() / sech - 1.0).abs(), slack);
        within((l.z() / (2.0 * sech) - 1.0).abs(), slack);
    }
    // It comes from the middle axis and ends there, the other way up.
    let (past, future) = (at(&top, -1e4), at(&top, 1e4));
    observed!((past.omega.y() + 5f64.sqrt() / 3.0).abs(), 0.0..=4.5e-16); // observed none
    near!(future.omega.y(), 5f64.sqrt() / 3.0, 0.0..=4.5e-16); // observed none
    observed!(future.omega.x().abs(), 0.0..=1e-300);
    observed!(past.omega.z().abs(), 0.0..=1e-300);
}

// claim: C6.6-13
#[test]
fn s6_6_symmetric_limits() -> Result<()> {
    let round = SymmetricTop::new(1.0, 1.5)?;
    let limit: BodyVector = round.omega_at(vector([0.5, 0.0, 2.0]), 1.7);
    let long = SymmetricTop::new(1.5, 1.0)?.omega_at(vector([0.0, 0.5, 2.0]), 1.7);
    let long_limit = [long.z(), long.x(), long.y()];
    for d in [1e-3, 1e-6, 1e-9, 1e-12] {
        let k2 = |top: &EulerTop| {
            let [i1, i2, i3] = top.moments();
            let o = omega(top, 0.0);
            let transverse = i1 * (i3 - i1) * o[0] * o[0];
            let axial = i3 * (i3 - i1) * o[2] * o[2];
            (i2 - i1) * transverse / ((i3 - i2) * axial)
        };
        let top = tilted([1.0, 1.0 + d, 1.5], [0.5, 0.0, 2.0]);
        let actual = (1.0 + d) - 1.0;
        close!(k2(&top) / actual, 0.25 / 3.0, 2.1 * d + 1e-15);
        let off = (at(&top, 1.7).omega - limit).norm();
        // In first order 1.351 d, of which 1.283 d in Ω₁; as far as rounding of Ω lets one see.
        let slack = d + 4e-16 / d;
        close!(off / actual, 1.351_068_44, slack);
        let first = at(&top, 1.7).omega.x() - limit.x();
        close!(first / actual, 1.283_253_2, slack);
        // The other limit, with 1 and 3 exchanged.
        let top = tilted([1.0, 1.5 - d, 1.5], [2.0, 0.0, 0.5]);
        assert_eq!(top.regime(), Regime::AroundSmallest);
        let actual = 1.5 - (1.5 - d);
        let off = distance(at(&top, 1.7).omega, long_limit);
        close!(off / actual, 0.585_117_27, slack);
    }
    // At the limits `properties` has the symmetric top's Ω and attitude; here its period and its precession.
    let top = tilted([1.0, 1.0, 1.5], [0.5, 0.0, 2.0]);
    assert_eq!(top.regime(), Regime::Symmetric);
    let other = tilted([1.0, 1.5, 1.5], [2.0, 0.0, 0.5]);
    close!(top.period(), round.wobble_period(2.0), 0.0..=3e-16);
    let rate = round.axis_rate_in_space(vector([0.5, 0.0, 2.0]));
    close!(top.mean_precession_rate(), rate, 0.0..=3e-16);
    // One unit in the last place from either limit nothing jumps.
    for (moments, start, limit) in [
        ([1.0, 1.0f64.next_up(), 1.5], [0.5, 0.0, 2.0], &top),
        ([1.0, 1.5f64.next_down(), 1.5], [2.0, 0.0, 0.5], &other),
    ] {
        let nearly = tilted(moments, start);
        let (a, b) = (at(&nearly, 1.7), at(limit, 1.7));
        observed!((a.omega - b.omega).norm(), 0.0..=9e-16); // observed 2.8e-16
        observed!(a.attitude.angle_to(&b.attitude), 0.0..=9e-16); // observed 2.8e-16
    }
    Ok(())
}
