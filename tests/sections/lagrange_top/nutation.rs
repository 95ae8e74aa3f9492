//! The second half of 7.2: nutation by elliptic functions, its period, the azimuth, and the erratum of its integral.

use super::*;
use spinning_bodies::elliptic::{
    Characteristic, Modulus, Parameter, complete_first, complete_third,
};

const EXAMPLES: [fn() -> LagrangeTop; 3] = [cusp, wave, swirl];

/// √(Mgl(h₃ − h₁)/2I₁) of the unit top.
fn rate(top: &LagrangeTop) -> f64 {
    let [h1, _, h3] = roots(top);
    (0.5 * (h3 - h1)).sqrt()
}

fn parameter(top: &LagrangeTop) -> Parameter {
    let [h1, h2, h3] = roots(top);
    Parameter::new((h2 - h1) / (h3 - h1), (h3 - h2) / (h3 - h1)).unwrap()
}

// claim: C7.2-9
#[test]
fn s7_2_elliptic_solution() {
    let expected = [[0.0, 0.5, 2.0], [0.0, 0.5, 2.0], [-0.5, 0.5, 5.0 / 3.0]];
    let heights = [
        0.20116398020196563299,
        0.20116398020196563299,
        -0.082983777721430580375,
    ];
    for ((example, expected), height) in EXAMPLES.into_iter().zip(expected).zip(heights) {
        let top = example();
        for (root, expected) in roots(&top).into_iter().zip(expected) {
            near!(root, expected, 2e-16..=2e-15);
        }
        near!(at(&top, 0.7).height, height, 1e-16..=2e-15);
        let [h1, h2, _] = roots(&top);
        let modulus = Modulus::new(parameter(&top));
        for k in -20..=20 {
            let t = 0.37 * f64::from(k);
            let state = at(&top, t);
            let sn = modulus.jacobi(t * rate(&top)).unwrap().sn;
            near!(state.height, h1 + (h2 - h1) * sn * sn, 3e-16..=3e-15);
        }
    }
}

// claim: C7.2-10
#[test]
fn s7_2_period_of_nutation() {
    let periods = [
        3.371500709625192085742407,
        3.371500709625192085742407,
        3.502564949385970903216222,
    ];
    for (example, expected) in EXAMPLES.into_iter().zip(periods) {
        let top = example();
        observed!((top.period() / expected - 1.0).abs(), 0.0..=7e-16);
        let closed = 2.0 * complete_first(parameter(&top)).unwrap() / rate(&top);
        observed!((closed / expected - 1.0).abs(), 0.0..=7e-16);
        // ∮ I₁ dh/√f with h = middle + half·cos u.
        let [h1, h2, h3] = roots(&top);
        let quadrature = TAU
            * mean(200, |s| {
                let h = 0.5 * (h1 + h2) + 0.5 * (h2 - h1) * (TAU * s).cos();
                (0.5 / (h3 - h)).sqrt()
            });
        observed!((quadrature / expected - 1.0).abs(), 0.0..=7e-16);
        // The state is back in h and h', and not after half of it.
        let state = at(&top, top.period());
        near!(state.height, h1, 0.0..=3e-16);
        near!(at(&top, 0.5 * top.period()).height, h2, 0.0..=4e-16);
    }
    // k → 1 only where h₂ = h₃ = 1: a kick ε of an upright top with L₃² < 4I₁Mgl. The period grows like ln(1/ε).
    let period = |kick: f64| {
        let top = kicked(1.5, kick);
        assert_eq!(roots(&top)[1], 1.0);
        top.period()
    };
    // Twice the time from e⁻ⁿ to e⁻ⁿ⁻¹ is 2/λ with λ = √(1 − L₃²/4).
    let lambda = (1.0 - 1.5 * 1.5 / 4.0_f64).sqrt();
    for (kick, bound) in [(1e-3, 1e-5), (1e-6, 1e-10), (1e-9, 1e-13)] {
        let growth = period(kick) - period(10.0 * kick);
        near!(growth * lambda / (2.0 * 10_f64.ln()), 1.0, bound * 100.0);
    }
}

// claim: C7.2-11
#[test]
fn s7_2_azimuth_in_a_nutation() {
    let gained = [
        1.685750354812596042871204,
        6.513093363214985324205051,
        1.774197536602291617367062,
    ];
    let early = [
        0.60299056000213551434,
        1.3612483848945871608,
        0.84998076850913081869,
    ];
    for ((example, expected), early) in EXAMPLES.into_iter().zip(gained).zip(early) {
        let top = example();
        let found = top.precession_per_nutation().unwrap();
        observed!((found / expected - 1.0).abs(), 0.0..=2e-15);
        let off = (top.mean_precession_rate().unwrap() * top.period() / expected - 1.0).abs();
        observed!(off, 0.0..=2e-15);
        // Two integrals of the third kind, one for each pole.
        let [h1, h2, _] = roots(&top);
        let (l3, vertical) = spins(&top);
        let third = |sign: f64| {
            let base = 1.0 - sign * h1;
            let n = Characteristic::from_characteristic(sign * (h2 - h1) / base).unwrap();
            (vertical - sign * l3) * complete_third(n, parameter(&top)).unwrap() / base
        };
        let closed = (third(1.0) + third(-1.0)) / rate(&top);
        observed!((closed / expected - 1.0).abs(), 2e-16..=2e-15);
        // Followed along the motion.
        let period = top.period();
        near!(gained_azimuth(&top, period, 60), expected, 4e-16..=8e-15);
        let turned = wrapped(azimuth(&at(&top, 0.7)) - azimuth(&at(&top, 0.0)));
        near!(turned, early, 1e-16..=2e-15);
    }
    // The wave is the cusp and half a turn: they share the cubic (C7.2-14).
    let difference =
        wave().precession_per_nutation().unwrap() - 2.0 * cusp().precession_per_nutation().unwrap();
    near!(difference, PI, 0.0..=3e-15);
}

// claim: C7.2-13
#[test]
fn s7_2_the_integral_for_the_azimuth_starts_at_h_of_0() {
    // Released from rest at h = 2/3 with L₃ = 3, E5: the band is [1/2, 2/3].
    let top = turning(0.5, 3.0, 2.0);
    for (root, expected) in roots(&top).into_iter().zip([0.5, 2.0 / 3.0, 4.0]) {
        near!(root, expected, 0.0..=4e-16);
    }
    let released = spun((2.0_f64 / 3.0).acos(), 0.0, 0.0, 3.0);
    near!(roots(&released)[0], 0.5, 0.0..=5e-16);

    // As displayed, from 0 to h: the integrand is not a real number on the way from 0 to h₁.
    let integrand = |h: f64| (2.0 - 3.0 * h) / ((1.0 - h * h) * f(&top, h).sqrt());
    for k in 0..50 {
        assert!(integrand(0.01 * f64::from(k)).is_nan());
    }
    // From h(0) = h₁, h = middle − half·cos u, it is the azimuth.
    let [h1, h2, h3] = roots(&top);
    let to = |h: f64| {
        let (middle, half) = (0.5 * (h1 + h2), 0.5 * (h2 - h1));
        let end = ((middle - h) / half).clamp(-1.0, 1.0).acos();
        let in_u = |u: f64| {
            let h = middle - half * u.cos();
            (2.0 - 3.0 * h) / ((1.0 - h * h) * (2.0 * (h3 - h)).sqrt())
        };
        integral(in_u, 0.0, end)
    };
    let period = top.period();
    for k in 1..10 {
        let t = 0.05 * f64::from(k) * period;
        let gained = gained_azimuth(&top, t, 20);
        near!(to(at(&top, t).height), gained, 5e-16..=5e-15);
    }
    // √f turns its sign round at h₂. Kept positive it would take back, on the way down, what was gained on the way up.
    let whole = gained_azimuth(&top, period, 40);
    near!(whole, 2.0 * to(h2), 1e-15..=1e-14);
    near!(whole, top.precession_per_nutation().unwrap(), 0.0..=7e-16);
    let kept = to(h2) - (to(h2) - to(h1));
    assert!(kept.abs() < 1e-15 && whole > 0.6, "{kept} {whole}");
    for k in 1..5 {
        // On the way down as much again, in the mirror of the way up.
        let t = 0.1 * f64::from(k) * period;
        let falling = gained_azimuth(&top, period - t, 40);
        let off = (falling - (2.0 * to(h2) - to(at(&top, t).height))).abs();
        observed!(off, 1e-15..=2e-14);
    }
}

// claim: C7.2-14
#[test]
fn s7_2_a_duality() {
    let mut numbers = Uniform(714);
    for _ in 0..200 {
        let [energy, l3, vertical, h] = [0; 4].map(|_| ration(&mut numbers));
        let [i1, weight] = body(&mut numbers);
        let raised = energy + (l3 * l3 - vertical * vertical) / (TWO * i1);
        let dual = cubic([i1, weight], raised, vertical, l3, h);
        assert_eq!(cubic([i1, weight], energy, l3, vertical, h), dual);
    }
    // Cusp and wave are such a pair: the same height at every time, says the chapter, and another azimuth.
    let (cusp, wave) = (cusp(), wave());
    assert_ne!(cusp.kind(), wave.kind());
    assert!(axis(&at(&cusp, 1.0))[1] - axis(&at(&wave, 1.0))[1] != 0.0);
    // Loops become waves.
    let dual = turning(-0.5, 0.5, 1.5);
    for (a, b) in roots(&swirl()).into_iter().zip(roots(&dual)) {
        near!(a, b, 4e-16..=4e-15);
    }
    assert_ne!(swirl().kind(), dual.kind());
}

#[test]
fn s7_2_many_times_at_once() {
    // The states of single calls to the last bit, near and far, on both sides of m = 1/2; of a top that sleeps, one by one.
    let mut numbers = Uniform(73);
    let mut tops: Vec<LagrangeTop> = EXAMPLES.iter().map(|example| example()).collect();
    for k in 0..60 {
        let omega = numbers.vector() * 10f64.powi(k % 3 - 1);
        let start = numbers.attitude();
        for weight in [0.0, 1.3, -1.3] {
            tops.push(LagrangeTop::new(1.0, 0.7, weight, omega, start).unwrap());
        }
    }
    let upright = vector([0.0, 0.0, 3.0]);
    tops.push(LagrangeTop::new(1.0, 0.7, 1.3, upright, Attitude::identity()).unwrap());
    tops.push(LagrangeTop::from_integrals(1.0, 0.5, 1.0, 1.0, 1.0, 2.0).unwrap());
    for top in tops {
        for count in [0, 1, 2, 3, 8, 9, 20] {
            let mut times: Vec<f64> = (0..count).map(|k| 7.3 * f64::from(k) - 50.0).collect();
            times.iter_mut().skip(6).step_by(7).for_each(|t| *t = 1e9);
            let mut states = vec![top.at(0.0).unwrap(); times.len()];
            top.states_at(&times, &mut states).unwrap();
            for (t, state) in times.iter().zip(&states) {
                assert_eq!(*state, top.at(*t).unwrap());
            }
        }
        let mut states = [top.at(0.0).unwrap(); 3];
        assert!(top.states_at(&[0.0, 1.0], &mut states).is_err());
        assert!(top.states_at(&[0.0, f64::NAN, 1.0], &mut states).is_err());
    }
}
