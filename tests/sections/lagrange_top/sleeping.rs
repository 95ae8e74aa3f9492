//! 7.5: the sleeping top, its threshold with equality, and how it wakes and goes to sleep.

use super::*;

/// The greatest tilt, reached half a nutation after the upright position; from 1 − cos θ, which keeps its digits.
fn greatest_tilt(top: &LagrangeTop) -> f64 {
    2.0 * (0.5 * at(top, 0.5 * top.period()).one_less).sqrt().asin()
}

// claim: C7.5-1
#[test]
fn s7_5_the_cubic_of_the_sleeping_top() {
    let mut numbers = Uniform(751);
    for _ in 0..200 {
        let [i1, weight, l3, h] = [0; 4].map(|_| ration(&mut numbers));
        // Upright, E' = Mgl and L_vert = L₃.
        let f = cubic([i1, weight], weight, l3, l3, h);
        let factors = (ONE - h) * (ONE - h) * (TWO * i1 * weight * (ONE + h) - l3 * l3);
        assert_eq!(f, factors);
    }
}

// claim: C7.5-2
#[test]
fn s7_5_criterion() {
    // I₁ = 1, I₃ = ½, Mgl = 1: the threshold is Ω₃ = 4.
    let threshold = (4.0_f64 / (AXIAL * AXIAL)).sqrt();
    assert_eq!(threshold, 4.0);
    for (omega3, stable) in [
        (5.0, true),
        (4.0_f64.next_up(), true),
        (4.0_f64.next_down(), false),
        (-4.5, true),
        (-3.0, false),
        (1e-3, false),
    ] {
        let l3 = AXIAL * omega3;
        let top = kicked(l3, 0.0);
        assert_eq!(top.kind(), Nutation::Sleeping { stable }, "{omega3}");
        assert_eq!(omega3 * omega3 > threshold * threshold, stable);
        // The text's criterion: the sign of f = (1 − h)²(2(1 + h) − L₃²) just below h = 1.
        let below: f64 = f64::EPSILON / 4.0;
        assert_eq!(4.0 - l3 * l3 - 2.0 * below < 0.0, stable, "{omega3}");
        // It sleeps on where nothing kicks it, stable or not.
        let state = at(&top, 100.0);
        assert_eq!((state.one_less, state.height), (0.0, 1.0));
        // Kicked by 1e-6 it stays within a thousandth, or it does not.
        if (omega3.abs() - 4.0).abs() > 0.1 {
            assert_eq!(greatest_tilt(&kicked(l3, 1e-6)) < 1e-3, stable);
        }
    }
}

// claim: C7.5-4
#[test]
fn s7_5_at_equality_it_is_stable() {
    // f = −2I₁Mgl(1 − h)³ where L₃² = 4I₁Mgl, by the factors above: negative for every h < 1.
    let mut numbers = Uniform(754);
    // As displayed, Ω² > 4I₁Mgl/I₃², the criterion refuses equality (E7). These tops are at equality, exactly, and sleep well.
    for (transverse, axial, omega3) in [(1.0, 0.5, 4.0), (2.0, 0.5, -32.0), (0.25, 0.375, 1.0)] {
        let l3: f64 = axial * omega3;
        let weight = l3 * l3 / (4.0 * transverse);
        let threshold = 4.0 * transverse * weight / (axial * axial);
        let [displayed, sharp] = [omega3 * omega3 > threshold, omega3 * omega3 >= threshold];
        let omega = vector([0.0, 0.0, omega3]);
        let top = LagrangeTop::new(transverse, axial, weight, omega, tilted(0.0)).unwrap();
        let stable = is(&top, Nutation::Sleeping { stable: true });
        assert_eq!([stable, sharp, displayed], [true, true, false]);
    }
    // The tilt tends to zero with the kick, like its root: a hundredth of the kick, a tenth of the tilt.
    for kick in [1e-6, 1e-8, 1e-10] {
        let tilt = greatest_tilt(&kicked(2.0, kick));
        // u² ≈ ε², θ² ≈ 2u.
        within((tilt / (2.0 * kick).sqrt() - 1.0).abs(), kick + 1e-14);
    }
    let ratio = greatest_tilt(&kicked(2.0, 1e-8)) / greatest_tilt(&kicked(2.0, 1e-10));
    near!(ratio, 10.0, 1e-9..=2e-8);
    // One per mille below, it does not tend to zero with the kick.
    let woken = [1e-6, 1e-8, 1e-10].map(|kick| greatest_tilt(&kicked(1.998, kick)));
    assert!(woken.iter().all(|tilt| *tilt > 0.06), "{woken:?}");
    observed!(woken[1] - woken[2], 9e-14..=9e-13);
    // Any small disturbance, of all the data: 200 of size 1e-6 stay within 0.003.
    let mut largest: f64 = 0.0;
    for _ in 0..200 {
        let size = 1e-6;
        let (kick, tilt) = (numbers.vector() * size, size * numbers.next());
        let omega = vector([kick.x(), kick.y(), 4.0 + kick.z()]);
        let top = LagrangeTop::new(1.0, AXIAL, 1.0, omega, tilted(tilt)).unwrap();
        largest = largest.max((1.0 - roots(&top)[0]).max(0.0).sqrt() * 2.0_f64.sqrt());
    }
    assert!(largest < 0.003 && largest > 1e-4, "{largest}");
}

// claim: C7.5-5
#[test]
fn s7_5_below_it_wakes_up() {
    // cos θ = L₃²/2 − 1 however small the kick: 0.805 for L₃ = 1.9.
    let expected = 0.63512085858304272099_f64;
    near!(expected.cos(), 0.805, 0.0..=3e-16);
    let mut constant = Vec::new();
    for kick in [1e-8, 1e-12, 1e-100, 1e-150] {
        let top = kicked(1.9, kick);
        near!(greatest_tilt(&top), expected, 4e-16..=4e-15);
        // Only the time it takes grows with ln(1/ε), at the rate λ = √(1 − L₃²/4).
        let lambda = (1.0 - 0.95 * 0.95_f64).sqrt();
        let beyond = 0.5 * top.period() * lambda - (1.0 / kick).ln();
        constant.push(beyond);
    }
    assert!(constant[0].abs() < 1.0, "{constant:?}");
    for beyond in &constant {
        near!(beyond, constant[0], 9e-15..=9e-14);
    }
    // L₃ → 0: it falls right over.
    for l3 in [0.1, 0.01] {
        let over = PI - greatest_tilt(&kicked(l3, 1e-9));
        // cos θ = −1 + L₃²/2 is θ = π − L₃.
        within((over / l3 - 1.0).abs(), l3 * l3);
    }
}

// claim: C7.5-6
#[test]
fn s7_5_linear_criterion() {
    // I₁s² − L₃s + Mgl = 0 for x + iy ∝ exp(ist): real s iff L₃² ≥ 4I₁Mgl. Above, the tip draws the two circles.
    for (l3, kick) in [(2.5_f64, 1e-9), (10.0, 1e-9), (2.05, 1e-9)] {
        let root = (l3 * l3 - 4.0).sqrt();
        let [slow, fast] = [2.0 / (l3 + root), 0.5 * (l3 + root)];
        let top = kicked(l3, kick);
        for t in [0.4, 3.0, 17.0] {
            let [x, y, _] = axis(&at(&top, t));
            // e' = Ω∧e at the start: −i kick for Ω along x₁.
            let wave = |s: f64| [(s * t).cos(), (s * t).sin()];
            let size = kick / (fast - slow);
            let [a, b] = [wave(fast), wave(slow)];
            let expected = [-size * (a[0] - b[0]), -size * (a[1] - b[1])];
            let off = (x - expected[0]).hypot(y - expected[1]) / size;
            observed!(off, 7e-15..=6e-14);
        }
    }
    // Below, s is complex and the tip runs away at the rate √(Mgl/I₁ − L₃²/4I₁²).
    for l3 in [0.5, 1.5, 1.9_f64] {
        let lambda = (1.0 - 0.25 * l3 * l3).sqrt();
        let top = kicked(l3, 1e-100);
        let tilt = |t: f64| (2.0 * at(&top, t).one_less).sqrt();
        let rate = (tilt(20.0 / lambda + 1.0) / tilt(20.0 / lambda)).ln();
        observed!((rate / lambda - 1.0).abs(), 0.0..=7e-16);
    }
}

/// A top on a rounded peg on a table: centre of mass 2.7 cm above the middle of the peg's ball of 0.5 cm, M = 1, I = (5, 5, 3)
/// about the centre of mass, friction −μN·(slip), in cm and s. The tilts at the end and the least on the way.
fn on_a_peg(spin: f64, friction: f64, time: f64) -> [f64; 2] {
    const PEG: f64 = 0.5;
    const HEIGHT: f64 = 2.7;
    const GRAVITY: f64 = 981.0;
    const I1: f64 = 5.0;
    const I3: f64 = 3.0;
    // State: e, L about the centre of mass, its horizontal velocity.
    let rate = |_: f64, y: [f64; 8]| {
        let e = [y[0], y[1], y[2]];
        let l = [y[3], y[4], y[5]];
        let along = e[0] * l[0] + e[1] * l[1] + e[2] * l[2];
        let omega = [0, 1, 2].map(|k| l[k] / I1 + (1.0 / I3 - 1.0 / I1) * along * e[k]);
        // From the centre of mass to the point of contact.
        let arm = [-HEIGHT * e[0], -HEIGHT * e[1], -HEIGHT * e[2] - PEG];
        let turning = cross(omega, arm);
        let [x, z] = [0, 1].map(|k| -friction * (y[6 + k] + turning[k]));
        let force = [x, z, 1.0];
        // All per unit of normal force N; N from the height's own acceleration, HEIGHT·e₃'' = N/M − g.
        let torque = cross(arm, force);
        let falling = cross(l, e).map(|x| x / I1);
        let pull = cross(torque, e)[2] / I1;
        let swing = cross(l, falling)[2] / I1;
        let normal = (GRAVITY + HEIGHT * swing) / (1.0 - HEIGHT * pull);
        assert!(normal > 0.0, "the peg left the table");
        let [a, b, c] = torque.map(|x| normal * x);
        let [u, v, _] = force.map(|x| normal * x);
        [falling[0], falling[1], falling[2], a, b, c, u, v]
    };
    let (sine, h) = 0.5_f64.sin_cos();
    let y = [sine, 0.0, h, I3 * spin * sine, 0.0, I3 * spin * h, 0.0, 0.0];
    let tilt = |y: &[f64; 8]| y[0].hypot(y[1]).atan2(y[2]);
    let mut least = tilt(&y);
    let steps = (time * 5000.0) as u32;
    let step = time / f64::from(steps);
    let y = runge_kutta(rate, y, (steps, step), |y| least = least.min(tilt(y)));
    [tilt(&y), least]
}

// claim: C7.5-7
#[test]
fn s7_5_friction_of_a_rounded_peg_puts_it_to_sleep() {
    let [end, _] = on_a_peg(150.0, 0.005, 3.0);
    near!(end, 0.011, 1e-4..=5e-4);
    // Too slow for it.
    let [end, least] = on_a_peg(60.0, 0.005, 3.0);
    assert!(end > 0.1 && least > 0.1, "{end} {least}");
    // Without friction the tilt never gets below the start.
    for spin in [150.0, 60.0] {
        let [_, least] = on_a_peg(spin, 0.0, 3.0);
        observed!(0.5 - least, 0.0..=3e-16);
    }
    // A fixed pivot cannot do it: released, the start is the least tilt of all, in closed form.
    for spin in [150.0, 60.0] {
        let omega = vector([0.0, 0.0, spin]);
        let top = LagrangeTop::new(5.0 + 3.2 * 3.2, 3.0, 981.0 * 3.2, omega, tilted(0.5)).unwrap();
        near!(roots(&top)[1], 0.5_f64.cos(), 0.0..=3e-16);
        for k in 0..50 {
            assert!(at(&top, 0.06 * f64::from(k)).height <= 0.5_f64.cos() + 2e-16);
        }
    }
}
