//! 7.3: pure precession, slow and fast, and when there is any.

use super::*;
use spinning_bodies::euler_top::SymmetricTop;
use spinning_bodies::lagrange_top::least_axial_angular_momentum;

/// Both roots of I₁h w² − L₃w + Mgl = 0 for the unit top, slow and fast, without cancellation; L₃ > 0.
fn rates(h: f64, l3: f64) -> [f64; 2] {
    let fast = 0.5 * (l3 + (l3 * l3 - 4.0 * h).sqrt());
    [1.0 / fast, fast / h]
}

/// Steady precession w at cos θ = 3/5 of exact numbers: z = (0, 4/5, 3/5), Ω = (0, 4w/5, 2L₃), Mgl = L₃w − 3w²/5.
fn exactly(w: f64, l3: f64, weight: f64) -> LagrangeTop {
    leaning(weight, vector([0.0, 0.8 * w, l3 / AXIAL]))
}

/// A start at cos θ = 3/5, exactly.
fn leaning(weight: f64, omega: BodyVector) -> LagrangeTop {
    let attitude = Attitude::from_quaternion(2.0, 1.0, 0.0, 0.0).unwrap();
    LagrangeTop::new(1.0, AXIAL, weight, omega, attitude).unwrap()
}

// claim: C7.3-1
#[test]
fn s7_3_pure_precession_is_a_double_root() {
    // That f and f' vanish there, the quadratic below says in fractions. In the library h₁ = h₂, and the tilt does not move.
    for (w, l3, weight) in [(5.0, 4.0, 5.0), (5.0, 23.0, 100.0), (5.0, 6.0, 15.0)] {
        let top = exactly(w, l3, weight);
        assert!(is(&top, Nutation::PurePrecession), "{:?}", top.kind());
        let [h1, h2, h3] = roots(&top);
        assert_eq!(h1, h2);
        near!(h1, 0.6, 0.0..=4e-16);
        assert!(h3 > 1.0);
        for t in [0.1, 10.0, -1e3] {
            near!(at(&top, t).height, 0.6, 0.0..=4e-16);
        }
    }
    // The other double root, h₂ = h₃ = 1, is no precession: the sleeping top, or one that wakes.
    assert!(!is(&kicked(1.5, 0.0), Nutation::PurePrecession));
    let climbing = leaning(31.25, vector([-3.0, 4.0, 16.0]));
    assert!(is(&climbing, Nutation::Waking));
}

// claim: C7.3-2
#[test]
fn s7_3_quadratic_for_the_rate() {
    // f' = −2I₁(1 − h²)(I₁h w² − L₃w + Mgl) wherever f = 0 and w = (L_vert − L₃h)/(I₁(1 − h²)), exactly.
    let mut numbers = Uniform(732);
    let mut checked = 0;
    while checked < 200 {
        let [i1, weight] = body(&mut numbers);
        let [w, l3] = [0; 2].map(|_| ration(&mut numbers));
        let h = unit_vector(&mut numbers)[2];
        let sine2 = ONE - h * h;
        if sine2 == ZERO {
            continue;
        }
        checked += 1;
        let vertical = i1 * w * sine2 + l3 * h;
        let energy = i1 * w * w * sine2 / TWO + weight * h;
        let value = |h: R| cubic([i1, weight], energy, l3, vertical, h);
        assert_eq!(value(h), ZERO);
        let slope = exact_slope(|d| value(h + d));
        let quadratic = i1 * h * w * w - l3 * w + weight;
        assert_eq!(slope, -TWO * i1 * sine2 * quadratic);
    }
    // L₃ = 3, θ = 60°: 3 ∓ √7. Both keep the tilt.
    let expected = [0.3542486889354094094983842, 5.645751311064590590501616];
    for (w, expected) in rates(0.5, 3.0).into_iter().zip(expected) {
        observed!((w / expected - 1.0).abs(), 0.0..=3e-16);
        let top = spun(FRAC_PI_3, 0.0, w, 3.0);
        for t in [1.0, 7.0] {
            near!(at(&top, t).height, 0.5, 0.0..=3e-16);
            near!(gained_azimuth(&top, t, 50), w * t, 2e-15..=3e-14);
        }
        // Ten per cent beside it the tilt moves.
        assert!(band(&spun(FRAC_PI_3, 0.0, 1.1 * w, 3.0)) > 1e-3);
    }
}

// claim: C7.3-3
#[test]
fn s7_3_slow_and_fast() {
    let h = 0.5;
    let first = |l3: f64| [1.0 / l3, l3 / h];
    // Motions of the library's tops, and the first approximations are not; the orders beyond are in `special.rs`.
    for l3 in [10.0, 100.0] {
        for (w, near) in rates(h, l3).into_iter().zip(first(l3)) {
            let band = |w: f64| band(&spun(FRAC_PI_3, 0.0, w, l3));
            observed!(band(w), 0.0..=3e-16);
            assert!(band(near) > 1e-9, "{:e}", band(near));
        }
    }
}

// claim: C7.3-4
#[test]
fn s7_3_when_there_is_pure_precession() {
    let theta = FRAC_PI_3;
    // L₃² = 4I₁Mgl cos θ at 60°: L₃ = √2, one double rate L₃/(2I₁cos θ) = √2.
    let least = least_axial_angular_momentum(1.0, 1.0, 0.5).unwrap();
    assert_eq!(least, SQRT_2);
    // One per cent below it no rate at all keeps the tilt; one per cent above it two do.
    let narrowest = |l3: f64| {
        let bands = (0..4000).map(|k| {
            let w = 0.5 + 0.0005 * f64::from(k);
            band(&spun(theta, 0.0, w, l3))
        });
        bands.fold(f64::INFINITY, f64::min)
    };
    assert!(narrowest(0.99 * least) > 0.01);
    observed!(narrowest(1.01 * least), 7e-6..=1e-4);
    for w in rates(0.5, 1.01 * least) {
        // The double root is nearly triple here: h₃ − h₂ is small too.
        observed!(band(&spun(theta, 0.0, w, 1.01 * least)), 0.0..=3e-16);
    }
    // At equality, in exact numbers: cos θ = 3/5, w = 5, L₃ = 6, Mgl = 15, and 36 = 4·15·3/5.
    assert!(is(&exactly(5.0, 6.0, 15.0), Nutation::PurePrecession));
    // Below the horizon always two, of opposite sign; without spin the conical pendulum.
    for l3 in [0.0, 0.1, 1.0, 10.0] {
        let h: f64 = -0.5;
        let fast = -0.5 * (l3 + (l3 * l3 - 4.0 * h).sqrt());
        let pair = [fast / -h, -1.0 / fast];
        assert!(pair[0] < 0.0 && pair[1] > 0.0);
        for w in pair {
            observed!(band(&spun(2.0 * theta, 0.0, w, l3)), 0.0..=1e-15);
        }
        if l3 == 0.0 {
            near!(pair[1], 2.0_f64.sqrt(), 0.0..=3e-16);
        }
    }
}

// claim: C7.3-5
#[test]
fn s7_3_at_a_right_angle_one_rate() {
    for l3 in [0.5, 2.0, 16.0, -4.0] {
        // Mgl/L₃, exactly: powers of two all.
        let top = started([0.0, 1.0 / l3, l3 / AXIAL], level());
        assert!(is(&top, Nutation::PurePrecession), "{:?}", top.kind());
        for t in [0.7, 9.0] {
            observed!(at(&top, t).height.abs(), 0.0..=3e-16);
        }
    }
}

// claim: C7.3-6
#[test]
fn s7_3_fast_precession_is_the_free_one() {
    for (theta, l3) in [(0.4, 3.0), (1.2, -2.0), (2.5, 1.0_f64)] {
        // No gravity, L along the vertical: |L| cos θ = L₃, rate |L|/I₁ about it.
        let size = l3 / f64::cos(theta);
        let omega = vector([0.0, size * theta.sin(), l3 / AXIAL]);
        let free = LagrangeTop::new(1.0, AXIAL, 0.0, omega, tilted(theta)).unwrap();
        let symmetric = SymmetricTop::new(1.0, AXIAL).unwrap();
        close!(symmetric.axis_rate_in_space(omega), size.abs(), 0.0..=4e-16);
        for t in [0.3, 2.0, 11.0] {
            near!(at(&free, t).height, theta.cos(), 0.0..=4e-16);
            let [x, y, _] = axis(&at(&free, t));
            let (sine, cosine) = (size * t).sin_cos();
            let radius = theta.sin();
            let error = (x - radius * sine).hypot(y + radius * cosine);
            observed!(error, 3e-15..=3e-14);
        }
        // With a little gravity the fast rate is off by Mgl/L₃, and no more.
        if theta.cos() > 0.0 && l3 > 0.0 {
            for weight in [1e-3, 1e-6] {
                let h = theta.cos();
                let fast = (l3 + (l3 * l3 - 4.0 * h * weight).sqrt()) / (2.0 * h);
                within(((size - fast) / (weight / l3) - 1.0).abs(), weight + 1e-9);
            }
        }
    }
}

/// θ after `time` under transverse drag −cΩ⊥, and the speed of the axis then: RK4 along the axes of space.
fn dragged(w: f64, l3: f64, drag: f64, time: f64) -> [f64; 2] {
    let theta = FRAC_PI_3;
    let rate = |_: f64, y: [f64; 6]| {
        let [x, yy, z, a, b, c] = y;
        let along = x * a + yy * b + z * c;
        // Ω⊥ = L⊥/I₁, and e' = L∧e.
        let across = [a - along * x, b - along * yy, c - along * z];
        let [p, q, r] = cross([a, b, c], [x, yy, z]);
        let [u, v, w] = across.map(|x| -drag * x);
        [p, q, r, u - yy, v + x, w]
    };
    let (sine, h) = theta.sin_cos();
    // The axis (sin θ, 0, cos θ), Ω⊥ = w(ẑ − h e).
    let mut y = [sine, 0.0, h, 0.0, 0.0, 0.0];
    for (k, up) in [0.0, 0.0, 1.0].into_iter().enumerate() {
        y[3 + k] = w * (up - h * y[k]) + l3 * y[k];
    }
    let steps = (time * 500.0) as u32;
    let y = runge_kutta(rate, y, (steps, time / f64::from(steps)), |_| ());
    let [x, yy, z, ..] = y;
    let speed = rate(time, y)[..3].iter().map(|v| v * v).sum::<f64>().sqrt();
    [z.clamp(-1.0, 1.0).acos().min(x.hypot(yy).atan2(z)), speed]
}

// claim: C7.3-7
#[test]
fn s7_3_the_fast_precession_dies_first() {
    let (l3, drag) = (10.0, 0.05);
    let [slow, fast] = rates(0.5, l3);
    // The fast start moves its axis at 17.2; after 1/c = 20 an e-th of that is left, after 100 it is 0.11.
    within((dragged(fast, l3, drag, 0.0)[1] - 17.2).abs(), 0.05);
    let [_, speed] = dragged(fast, l3, drag, 100.0);
    within((speed - 0.11).abs(), 0.005);
    // The slow start has sunk from 60° to 62.5° by then: the scale is L₃²/(c Mgl) = 2000.
    let [theta, _] = dragged(slow, l3, drag, 100.0);
    within((theta.to_degrees() - 62.5).abs(), 0.05);
    // Half the drag: half the sinking.
    let [half, _] = dragged(slow, l3, 0.5 * drag, 100.0);
    let sunk = |theta: f64| theta.to_degrees() - 60.0;
    within((sunk(half) / sunk(theta) - 0.5).abs(), 0.01);
    // Without drag neither changes: the library's motion.
    for w in [slow, fast] {
        let [theta, speed] = dragged(w, l3, 0.0, 10.0);
        let state = at(&spun(FRAC_PI_3, 0.0, w, l3), 10.0);
        near!(theta.cos(), state.height, 2e-8..=2e-7);
        near!(speed, state.omega.x().hypot(state.omega.y()), 8e-7..=1e-5);
    }
}
