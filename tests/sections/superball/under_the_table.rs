//! Bounce after bounce: the rotation, the way back out, no period.

use super::*;

// claim: C4.6-9
#[test]
fn s4_6_double_bounce_is_a_rotation() {
    let double = |kappa| {
        let [ceiling, floor] = [Surface::Ceiling, Surface::Floor].map(|s| bounce_matrix(s, kappa));
        times(ceiling, floor)
    };
    let trace = |m: [[R; 2]; 2]| m[0][0] + m[1][1];
    for kappa in kappas() {
        // trace = 2 cos 2δ = 4 cos² δ − 2 with cos δ = (1−κ)/(1+κ)
        let cos = (ONE - kappa) / (ONE + kappa);
        assert_eq!(trace(double(kappa)), whole(4) * cos * cos - TWO);
    }
    let delta = BounceRotation::of_fraction(2, 5).unwrap().angle();
    close!(delta, 1.127_885_282_721_257_7, 0.0..=2.3e-16);
    near!(delta.cos(), 3.0 / 7.0, 2.3e-16);
}

// claim: C4.6-7, C4.6-10, C4.6-13
#[test]
fn s4_6_chebyshev() {
    let known: [(usize, i128, i128); 7] = [
        (4, -479, 3720),
        (5, 13443, -15950),
        (6, 104129, -86580),
        (7, -33933, 1301030),
        (8, -5305919, -3563760),
        (9, -30172797, -42367910),
        (10, 78953249, 428831700),
    ];
    let motions: Vec<_> = thrown().take(12).collect();
    for (n, velocity, rim_speed) in known {
        let [v, w] = [velocity, rim_speed].map(|speed| rational(speed, 7i128.pow(n as u32)));
        assert_eq!(motions[n - 1], moving(v, w));
    }
    // T and U by their own recurrence.
    let x = rational(3, 7);
    let (mut t, mut u) = ([ONE, x], [ZERO, ONE]);
    for (n, motion) in (1..).zip(motions) {
        let spin = if n % 2 == 1 { u[1] } else { -u[1] };
        assert_eq!(motion, moving(t[1], rational(10, 7) * spin), "{n}");
        t = [t[1], TWO * x * t[1] - t[0]];
        u = [u[1], TWO * x * u[1] - u[0]];
    }
    // Any start, any κ: the closed form against 200 bounces one by one. The rim speed grows as 1/√κ.
    for (numerator, denominator) in [(2, 5), (2, 3), (1, 1), (1, 3), (1, 1000)] {
        let kappa = f64::from(numerator) / f64::from(denominator);
        let rotation = BounceRotation::of_fraction(numerator, denominator).unwrap();
        let start = moving(0.6, -1.7);
        assert_eq!(rotation.after(start, 0), start);
        for (n, motion) in (1..).zip(UnderTable::new(start, kappa).take(200)) {
            let closed = rotation.after(start, n);
            near!(closed.velocity, motion.velocity, 3e-14 / kappa.sqrt());
            near!(closed.rim_speed, motion.rim_speed, 3e-14 / kappa.sqrt());
        }
    }
}

// claim: C4.6-11
#[test]
fn s4_6_it_comes_back_out() {
    let known = [(3, 7), (-10, 49), (-403, 343), (-3300, 2401)];
    let known = known.map(|(n, d)| rational(n, d));
    assert!(thrown().positions().take(4).eq(known));
    // It runs outward after bounces 2, 3, 4 and inward again after the fifth.
    let outward = thrown().take(5).map(|m| m.velocity < ZERO);
    assert!(outward.eq([false, true, true, true, false]));
    // Between endless plates: never beyond −½ ± √(7/8), and as near to it as one waits for.
    let [least, greatest] = reach(BALL).unwrap();
    close!(least, -1.435_414_346_693_485_4, 0.0..=2.3e-16);
    close!(greatest, 0.435_414_346_693_485_35, 0.0..=3e-16);
    let start = moving(1.0, 0.0);
    let (mut low, mut high) = (0.0_f64, 0.0_f64);
    for x in UnderTable::new(start, BALL).positions().take(100_000) {
        (low, high) = (low.min(x), high.max(x));
    }
    assert!(low > least && high < greatest, "{low} {high}");
    observed!(low - least, 1e-11..=5e-10);
    observed!(greatest - high, 8e-12..=3e-10);
    // κ → 0: it passes straight through, and nothing holds it.
    let light = UnderTable::new(start, 1e-12).positions().nth(99).unwrap();
    close!(light, 100.0, 2e-9..=7e-8);
    assert!(reach(1e-12).unwrap()[1] > 4e5 && reach(0.0).is_err());
    // On the rim and beyond, ½(√(1 + 1/κ) − 1) is a small difference: ½(√2 − 1), and 1/4κ − 1/16κ² + ….
    let [hoop, beyond] = [1.0, 1e10].map(|kappa| reach(kappa).unwrap()[1]);
    close!(hoop, 0.207_106_781_186_547_52, 0.0..=3e-16);
    close!(beyond, 2.5e-11 * (1.0 - 2.5e-11), 0.0..=3e-16);
}

// claim: C4.6-12
#[test]
fn s4_6_never_periodic_except() {
    // 7ⁿ V_n is an integer that leaves a remainder mod 7 (3, then 6 times the last): no V_n after the start is ±1, and no
    // bounce repeats the start. 7⁴³ is the last power whose bounce fits into 127 bits.
    let mut motion = moving(ONE, ZERO);
    let mut surface = Surface::Floor;
    let mut remainder = 4; // so that the first step gives 3
    for n in 1..=43u32 {
        motion = checked_bounce(motion, surface, KAPPA).unwrap();
        surface = surface.opposite();
        remainder = remainder * 6 % 7;
        assert_eq!(*motion.velocity.denom(), 7i128.pow(n), "bounce {n}");
        assert_eq!(motion.velocity.numer().rem_euclid(7), remainder);
    }
    // The monic equation of 2 cos 2δ = −62/49 has no integer root: not an algebraic integer, so δ/π is irrational (Niven).
    assert!(!(TWO * thrown().nth(1).unwrap().velocity).is_integer());
    let period = |kappa: R| {
        let start = moving(ONE, rational(3, 10));
        let seen: Vec<_> = UnderTable::new(start, kappa).take(24).collect();
        (1..=12).map(|m| 2 * m).find(|&n| seen[n - 1] == start)
    };
    assert_eq!(period(ONE), Some(4));
    assert_eq!(period(rational(1, 3)), Some(6));
    assert_eq!(period(rational(2, 3)), None);
    // All mass on the rim: motion reversal after two. κ = 1/3: after three, with the spin gone.
    for (bounces, kappa) in [(2, ONE), (3, rational(1, 3))] {
        let after = UnderTable::new(moving(ONE, ZERO), kappa).nth(bounces - 1);
        assert_eq!(after, Some(moving(-ONE, ZERO)));
    }
}
