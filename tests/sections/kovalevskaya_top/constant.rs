//! 8.2: her constant, along motions and in exact fractions.

use super::*;
use spinning_bodies::euler_top::EulerTop;
use spinning_bodies::kovalevskaya_top::Kind;

// claim: C8.2-1, C8.2-2, C8.2-3
#[test]
fn s8_2_her_equations_in_real_and_complex_form() {
    for [c, o1, o2, o3, z1, z2, z3, ..] in points() {
        let [change, up] =
            heavy_rates([TWO, TWO, ONE], [c, ZERO, ZERO], [o1, o2, o3], [z1, z2, z3]);
        assert_eq!(TWO * change[0], o2 * o3);
        assert_eq!(TWO * change[1], -o3 * o1 + c * z3);
        assert_eq!(change[2], -c * z2);
        let turned = [z2 * o3 - z3 * o2, z3 * o1 - z1 * o3, z1 * o2 - z2 * o1];
        assert_eq!(up, turned);
        // −i(x + iy) = y − ix.
        let (w, z) = ([o1, o2], [z1, z2]);
        let inner = [w[0] * o3 - c * z3, w[1] * o3];
        assert_eq!([TWO * change[0], TWO * change[1]], [inner[1], -inner[0]]);
        let inner = [z[0] * o3 - z3 * w[0], z[1] * o3 - z3 * w[1]];
        assert_eq!([up[0], up[1]], [inner[1], -inner[0]]);
    }
}

// claim: C8.2-4, C8.2-5
#[test]
fn s8_2_the_constant_turns_and_does_not_grow() {
    for [c1, c2, o1, o2, o3, z1, z2, z3, scale, ..] in points() {
        let i3 = scale * scale + ONE;
        let moments = [TWO * i3, TWO * i3, i3];
        let [change, up] = heavy_rates(moments, [c1, c2, ZERO], [o1, o2, o3], [z1, z2, z3]);
        let (w, z, c) = ([o1, o2], [z1, z2], [c1 / i3, c2 / i3]);
        // K = w² − cζ and dK/dt = 2w dw/dt − c dζ/dt.
        let (ww, cz) = (times(w, w), times(c, z));
        let k = [ww[0] - cz[0], ww[1] - cz[1]];
        let (wd, cd) = (times(w, [change[0], change[1]]), times(c, [up[0], up[1]]));
        let rate = [TWO * wd[0] - cd[0], TWO * wd[1] - cd[1]];
        assert_eq!(rate, [k[1] * o3, -k[0] * o3], "dK/dt = −iΩ₃K");
        assert_eq!(k[0] * rate[0] + k[1] * rate[1], ZERO, "d|K|²/dt");
    }
}

// claim: C8.2-6
#[test]
fn s8_2_along_a_motion() -> Result<()> {
    let top = register()?;
    assert_eq!(top.kind(), Kind::General);
    assert_eq!(top.method(), Method::Separation);
    let constants = top.constants();
    let exact = |x: f64, y: f64| close!(x, y, 2.0 * EPS);
    exact(constants.energy, 1.961_666_666_666_666_7);
    exact(constants.vertical_angular_momentum, 1.2);
    exact(constants.kovalevskaya, 257_f64.sqrt() / 12.0);
    let later = top.omega_and_up(1.0)?;
    let expected = [
        1.110_955_534_402_430_9,
        0.743_315_167_825_587_6,
        0.293_959_441_088_491_54,
        0.131_720_952_025_165_34,
        0.434_107_393_384_795_35,
        0.891_179_197_359_455,
    ];
    let found = [later.omega, later.up].map(|v| <[f64; 3]>::from(v.components()));
    for (x, y) in found.into_iter().flatten().zip(expected) {
        // Observed: 5e-16.
        near!(x, y, 2e-15);
    }
    let later = top.omega_and_up(5.0)?.omega.components();
    let expected = [
        -0.303_749_030_170_165_6,
        0.523_633_252_474_152_7,
        -1.684_130_898_346_793_2,
    ];
    for k in 0..3 {
        near!(later[k], expected[k], 4e-15);
    }
    // Along ten thousand seconds the constants stay at rounding, by projection as well as by the integrals.
    let heavy = top.heavy_top()?;
    for n in 0..500 {
        let state = top.omega_and_up(20.0 * f64::from(n))?;
        let k = heavy.further_integral(&state).expect("hers").value.sqrt();
        observed!((k - constants.kovalevskaya).abs(), 2e-16..=3e-15, "{k}");
        let off = (heavy.energy(&state) - constants.energy).abs();
        observed!(off, 3e-16..=3e-15);
        let off = (heavy.vertical_angular_momentum(&state) - 1.2).abs();
        observed!(off, 1e-16..=3e-15);
    }
    Ok(())
}

// claim: C8.2-7
#[test]
fn s8_2_the_phase_falls_by_the_integral_of_spin() -> Result<()> {
    let top = register()?;
    let k = |t: f64| -> Result<[f64; 2]> {
        let state = top.omega_and_up(t)?;
        let (o, z) = (state.omega, state.up);
        let real = o.x() * o.x() - o.y() * o.y() - z.x();
        Ok([real, 2.0 * o.x() * o.y() - z.y()])
    };
    let spin = |t: f64| top.omega_and_up(t).expect("a state").omega.z();
    let integral = integral(spin, 0.0, 5.0);
    // The argument followed from stretch to stretch.
    let mut turned = 0.0;
    for n in 0..50 {
        let (from, to) = (f64::from(n) / 10.0, f64::from(n + 1) / 10.0);
        let ([a, b], [c, d]) = (k(from)?, k(to)?);
        turned += (a * d - b * c).atan2(a * c + b * d);
    }
    // Observed: 1e-14 both.
    near!(integral, -2.931_948_462_105_553_6, 5e-14);
    near!(turned, -integral, 5e-14);
    Ok(())
}

/// Largest change of |w² − cζ| among t = 0.5, 1, …, 5 from the register's start, c = MgC₁/I₃ = 1, for I = (ratio, ratio, 1).
fn drift(ratio: f64, lever: [f64; 3]) -> f64 {
    let top = power_series::Top {
        moments: [ratio, ratio, 1.0],
        lever,
    };
    let constant = |y: &power_series::Whole| {
        let [p, q, _, z1, z2, ..] = *y;
        (p * p - q * q - z1).hypot(2.0 * p * q - z2)
    };
    let mut y = REGISTER;
    let start = constant(&y);
    let mut largest: f64 = 0.0;
    for _ in 0..10 {
        y = top.after(y, 0.5);
        largest = largest.max((constant(&y) - start).abs());
    }
    largest
}

// claim: C8.2-8
#[test]
fn s8_2_only_for_this_ratio() {
    let on_axis = [1.0, 0.0, 0.0];
    let found = [1.9, 2.1, 3.0].map(|ratio| drift(ratio, on_axis));
    observed!(relative(found[0], 0.067_019_307), 2e-9..=1e-7);
    observed!(relative(found[2], 0.390_437_05), 3e-9..=1e-7);
    assert!(found[1] > 0.02, "{found:?}");
    assert!(drift(2.0, [1.0, 0.0, 0.1]) > 0.02, "C off the plane");
    // Observed 7e-16 in the special case; close to it the drift is proportional to what is amiss.
    observed!(drift(2.0, on_axis), 1e-16..=4e-15);
    let (near, nearer) = (drift(2.0 + 1e-4, on_axis), drift(2.0 + 1e-6, on_axis));
    close!(near / nearer, 100.0, 0.01);
}

// claim: C8.2-9
#[test]
fn s8_2_without_gravity_it_is_eulers_top() -> Result<()> {
    // Erratum E8: C₁ = 0 is Euler's symmetric top with I₃/I₁ = ½; 7.1 asks of Lagrange's that O is not C.
    let (omega, up) = (vector([1.0, 0.5, 0.3]), vector([2.0, -1.0, 2.0]));
    let top = KovalevskayaTop::with_up(MOMENTS, BodyVector::zero(), omega, up)?;
    assert_eq!(top.kind(), Kind::EulerSymmetric);
    assert_eq!(top.method(), Method::FreeTop);
    assert_eq!(top.heavy_top()?.kind(), Integrability::Euler);
    close!(top.constants().kovalevskaya, 1.25, 2.0 * EPS);
    let start = top.at(0.0)?;
    let free = EulerTop::from_omega(MOMENTS, omega, start.attitude)?;
    for t in [1.0, 20.0, -7.0] {
        let state = top.at(t)?;
        // W turns at Ω₃(½ − 1), Ω₃ stays.
        let (s, c) = (-0.15 * t).sin_cos();
        let expected = vector([c - 0.5 * s, s + 0.5 * c, 0.3]);
        observed!((state.omega - expected).norm(), 0.0..=4e-15);
        let off = state.attitude.angle_to(&free.at(t)?.attitude);
        observed!(off, 1e-16..=2e-15);
    }
    // The limit: with little gravity the motion differs from that by a multiple of it.
    let difference = |c: f64| -> Result<f64> {
        let weak = KovalevskayaTop::with_up(MOMENTS, vector([c, 0.0, 0.0]), omega, up)?;
        Ok(weak.at(3.0)?.attitude.angle_to(&top.at(3.0)?.attitude))
    };
    for c in [1e-3, 1e-5, 1e-7] {
        let quotient = difference(c)? / c;
        close!(quotient, difference(1e-9)? / 1e-9, 4.0 * c + 1e-5);
    }
    Ok(())
}
