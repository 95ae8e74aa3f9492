//! 7.2, 7.5, 7.6: tops from what they keep, L₃, L_vert and E, and the separatrix reached exactly.

use super::*;
use spinning_bodies::lagrange_top::pendulum_from_integrals;

/// Bodies of many sizes, L₃ below the threshold of each, gravity either way.
const SLOW: [[f64; 4]; 6] = [
    [1.0, 0.5, 1.0, 1.0],
    [0.3, 0.1, 0.7, 0.2],
    [1.2e-3, 7e-4, 0.45, -0.03],
    [5e20, 9e20, 3e-7, 2e6],
    [1.0, 0.5, -1.0, 1.7],
    [0.3, 0.1, 0.7, 1e-200],
];

/// (L_vert − L₃), L_vert and the energy less that of the spin, from a state.
fn kept([i1, _, weight, l3]: [f64; 4], state: &State) -> [f64; 2] {
    let up = state.attitude.to_body(UP);
    let (x, y) = (state.omega.x(), state.omega.y());
    let vertical = i1 * (x * up.x() + y * up.y()) + l3 * state.height;
    [vertical, 0.5 * i1 * (x * x + y * y) + weight * state.height]
}

/// 1 − h = y₀ sech²(λt), y₀ = 2 − L₃²/2I₁|Mgl| and λ² = |Mgl| y₀/2I₁, until 1 − h underflows; with gravity upwards 1 + h.
#[test]
fn s7_5_the_waking_top_of_every_body_down_to_underflow() {
    for body @ [i1, i3, weight, l3] in SLOW {
        let vertical = if weight < 0.0 { -l3 } else { l3 };
        let top = LagrangeTop::above_upright(i1, i3, weight, l3, vertical, 0.0).unwrap();
        assert_eq!(top.kind(), Nutation::Waking, "{body:?}");
        assert_eq!(top.period(), f64::INFINITY);
        assert_eq!(top.precession_per_nutation(), None);
        let from_top = |s: &State| if weight < 0.0 { s.one_more } else { s.one_less };
        let size = weight.abs();
        let y0 = 2.0 - 0.5 * (l3 / i1) * (l3 / size);
        let rate = (0.5 * size * y0 / i1).sqrt();
        for turned in [
            0.0, 0.3, -1.0, 5.0, -30.0, 100.0, 200.0, 300.0, -353.0, 354.0,
        ] {
            let t = turned / rate;
            let state = at(&top, t);
            let left = from_top(&state);
            let cosh = (rate * t).cosh();
            // Observed: 1e-13, as the rounding of λt has it; the smallest are 1e-307.
            observed!(left / (y0 / cosh / cosh) - 1.0, 3e-14..=3e-13);
            observed!(1.0 - left / (y0 / cosh / cosh), 3e-14..=3e-13);
            // The axis itself is as near to the vertical.
            let [x, y, _] = axis(&state);
            let sine = (state.one_less * state.one_more).sqrt();
            within((x.hypot(y) - sine).abs(), 2e-15 * sine);
        }
        assert_eq!(from_top(&at(&top, 800.0 / rate)), 0.0, "{body:?}");
    }
}

/// Total energies that are doubles reach it too, and one unit in the last place beside it is beside it, with that distance.
#[test]
fn s7_5_one_unit_beside_the_separatrix() {
    let from = |vertical: f64, energy: f64| {
        LagrangeTop::from_integrals(1.0, 0.5, 1.0, 1.0, vertical, energy).unwrap()
    };
    assert_eq!(from(1.0, 2.0).kind(), Nutation::Waking);
    assert_eq!(from(1.0f64.next_up(), 2.0).kind(), Nutation::Waves);
    assert_eq!(from(1.0f64.next_down(), 2.0).kind(), Nutation::Loops);
    for energy in [2f64.next_up(), 2f64.next_down()] {
        let above = LagrangeTop::above_upright(1.0, 0.5, 1.0, 1.0, 1.0, energy - 2.0).unwrap();
        let whole = from(1.0, energy);
        assert_ne!(whole.kind(), Nutation::Waking);
        assert_eq!(whole.roots(), above.roots());
        assert_eq!(whole.period(), above.period());
    }
}

/// L_vert = L₃: 1 − h₁ and h₃ − 1 are the roots of a quadratic, and the period is 2 ln(16/mc)/(2λ) next to the separatrix.
/// 1 − k² is below every double, and a quarter period some 500 time constants: 1 + h = 2 tanh² of the time since the bottom, in units of √(I₁/Mgl).
#[test]
fn s7_5_a_quarter_period_of_many_time_constants() {
    let top = LagrangeTop::from_integrals(1.0, 1.07, 1e300, 2.3e-308, 0.0, 1e300).unwrap();
    for t in [0.0, 0.3, 1.5, 6.0] {
        let state = top.at(t * 1e-150).unwrap();
        let tanh = f64::tanh(t);
        within((state.one_more / 2.0 - tanh * tanh).abs(), 1e-15);
        within((state.omega.y() / 2e150 - 1.0 / t.cosh()).abs(), 1e-15);
    }
}

#[test]
fn s7_5_the_way_to_the_separatrix() {
    let (g, spin2) = (1.0, 1.0);
    let quadratic = 4.0 * g - spin2;
    let tiny = [
        1e-3,
        1e-6,
        1e-12,
        f64::EPSILON,
        1e-30,
        1e-100,
        1e-300,
        5e-324,
    ];
    for excess in tiny {
        let top = LagrangeTop::above_upright(1.0, 0.5, g, 1.0, 1.0, excess).unwrap();
        let e = 2.0 * excess;
        let root = ((quadratic - e) * (quadratic - e) + 16.0 * g * e).sqrt();
        let lowest = (quadratic - e + root) / (4.0 * g);
        let roots = top.roots();
        observed!((roots.one_less[0] / lowest - 1.0).abs(), 0.0..=1e-15);
        // It passes through the upright position.
        assert_eq!(roots.one_less[1], 0.0);
        // To one unit in the last place; 5e-324/1.5 is one unit itself.
        let third = e / (g * lowest);
        near!(roots.third_less_one, third, 6e-16 * excess + 5e-324);
        if (1e-300..1e-5).contains(&excess) {
            let mc = e / (g * lowest) / lowest;
            let period = (16f64.ln() - mc.ln()) / (2.0 * g * lowest).sqrt() * 2.0;
            within((top.period() / period - 1.0).abs(), mc.max(1e-15));
        }
        // Below the upright energy it turns before it is upright.
        let below = LagrangeTop::above_upright(1.0, 0.5, g, 1.0, 1.0, -excess).unwrap();
        let [_, upper] = below.roots().one_less;
        let sum = quadratic + e;
        let far = (sum + (sum * sum - 16.0 * g * e).sqrt()) / (4.0 * g);
        within((upper - e / (g * far)).abs(), 6e-16 * excess + 5e-324);
        assert_eq!(below.roots().h3, 1.0);
    }
}

/// What was given is kept at any time, the start is the lower turning point with φ = ψ = 0, and h stays between the roots.
#[test]
fn s7_2_any_integrals_are_kept() {
    let mut numbers = Uniform(72);
    let (mut moved, mut refused) = (0, 0);
    for _ in 0..4000 {
        let mut any = |least: f64, greatest: f64| least + (greatest - least) * numbers.next();
        let i1 = any(0.2, 3.0);
        let (i3, l3) = (any(0.1, 2.0) * i1, any(-4.0, 4.0));
        let (weight, vertical) = (any(-3.0, 3.0), any(-4.0, 4.0));
        let energy = any(-3.0, 12.0);
        let body = [i1, i3, weight, l3];
        let top = match LagrangeTop::from_integrals(i1, i3, weight, l3, vertical, energy) {
            Ok(top) => top,
            Err(error) => {
                assert!(matches!(error, Error::Condition { value, .. } if value == energy));
                // No height has so little: V = (L_vert − L₃h)²/2I₁(1 − h²) + Mgl h is greater everywhere.
                let left = energy - 0.5 * l3 * l3 / i3;
                for k in 1..400 {
                    let h = -1.0 + f64::from(k) / 200.0;
                    let turn = vertical - l3 * h;
                    assert!(left < 0.5 * turn * turn / (i1 * (1.0 - h * h)) + weight * h + 1e-9);
                }
                refused += 1;
                continue;
            }
        };
        moved += 1;
        let left = energy - 0.5 * l3 * l3 / i3;
        let size = left.abs() + weight.abs() + (vertical.abs() + l3.abs()).powi(2) / i1;
        let start = at(&top, 0.0);
        let angles = start.attitude.euler_angles();
        let roots = top.roots();
        // The lower side is that of the weight.
        let sides = |less: f64, more: f64| match weight < 0.0 {
            true => [more, less],
            false => [less, more],
        };
        let [less, more] = sides(roots.one_less[0], roots.one_more[0]);
        let lowest = 2.0 * less.sqrt().atan2(more.sqrt());
        near!(angles.theta, lowest, 1e-16..=2e-15);
        let turned = wrapped(angles.phi).abs() + wrapped(angles.psi).abs();
        within(turned, 2e-15 / lowest.sin().max(1e-3));
        for t in [0.0, 0.7, -3.1, 40.0] {
            let state = at(&top, t);
            let [l_vert, e] = kept(body, &state);
            // Observed: 8e-16 and 2.3e-15.
            let spins = vertical.abs() + l3.abs() + size.sqrt() * i1;
            near!(l_vert, vertical, 3e-15 * spins);
            within((e - left).abs(), 7e-15 * size);
            within((state.omega.z() - l3 / i3).abs(), 4e-16 * (l3 / i3).abs());
            let [less, more] = sides(state.one_less, state.one_more);
            assert!(less >= roots.one_less[1] * (1.0 - 1e-14));
            assert!(more >= roots.one_more[0] * (1.0 - 1e-14));
        }
    }
    assert!(moved > 2000 && refused > 200, "{moved} {refused}");
}

/// The same motion as from its start: roots, kind and period of a top made from Ω and attitude whose integrals are whole numbers.
#[test]
fn s7_2_the_same_as_from_the_start() {
    // L₃ = 2, L_vert = 1, E' = ½: cusps; L₃ = 1, L_vert = 2, E' = 2: waves; both with the roots 0, ½, 2.
    for (l3, vertical, energy, kind) in [
        (2.0, 1.0, 4.5, Nutation::Cusps),
        (1.0, 2.0, 3.0, Nutation::Waves),
    ] {
        let top = LagrangeTop::from_integrals(1.0, 0.5, 1.0, l3, vertical, energy).unwrap();
        let roots = top.roots();
        assert_eq!(top.kind(), kind);
        for (root, expected) in [(roots.h1, 0.0), (roots.h2, 0.5), (roots.h3, 2.0)] {
            near!(root, expected, 0.0..=2e-16);
        }
        let State {
            omega, attitude, ..
        } = at(&top, 0.0);
        let start = LagrangeTop::new(1.0, 0.5, 1.0, omega, attitude).unwrap();
        observed!((start.period() / top.period() - 1.0).abs(), 0.0..=1e-15);
        let off = at(&start, 7.0).attitude.angle_to(&at(&top, 7.0).attitude);
        observed!(off, 6e-16..=1e-14);
    }
    // L₃ = 3/2, L_vert = ½, E' = 13/24: loops.
    let swirl = LagrangeTop::from_integrals(1.0, 0.5, 1.0, 1.5, 0.5, 13.0 / 24.0 + 2.25).unwrap();
    assert_eq!(swirl.kind(), Nutation::Loops);
    // Cusps at h₂ = ⅔, which is no double: the terms balance all the same.
    let third = LagrangeTop::above_upright(1.0, 0.5, 3.0, 3.0, 2.0, -1.0).unwrap();
    assert_eq!(third.kind(), Nutation::Cusps);
    // At h = ½ under Mgl = 1 the rate 2 needs L₃ = 3/2; L_vert = 9/4 and E' = 2 follow.
    let steady = LagrangeTop::from_integrals(1.0, 0.5, 1.0, 1.5, 2.25, 2.0 + 2.25);
    assert_eq!(steady.unwrap().kind(), Nutation::PurePrecession);
}

/// What stays: upright above the threshold and on it, hanging with and without spin, no gravity.
#[test]
fn s7_5_tops_that_stay() {
    for l3 in [2.0, -3.0, 2.0f64.next_up()] {
        let asleep = LagrangeTop::above_upright(1.0, 0.5, 1.0, l3, l3, 0.0).unwrap();
        assert_eq!(asleep.kind(), Nutation::Sleeping { stable: true });
        assert_eq!(at(&asleep, 9.0).height, 1.0);
    }
    let below = 2f64.next_down();
    let awake = LagrangeTop::above_upright(1.0, 0.5, 1.0, below, below, 0.0).unwrap();
    assert_eq!(awake.kind(), Nutation::Waking);
    for l3 in [0.0, 1.0, -0.3] {
        let hanging = LagrangeTop::above_upright(1.0, 0.5, 1.0, l3, -l3, -2.0).unwrap();
        assert_eq!(hanging.kind(), Nutation::Hanging);
        assert_eq!(at(&hanging, 9.0).height, -1.0);
    }
    let spinning = LagrangeTop::from_integrals(1.0, 0.5, 0.0, 2.0, 1.0, 4.0).unwrap();
    assert_eq!(spinning.kind(), Nutation::Spinning);
    near!(at(&spinning, 5.0).height, 0.5, 0.0..=2e-16);
    let free = LagrangeTop::from_integrals(1.0, 0.5, 0.0, 1.0, 1.5, 3.0).unwrap();
    near!(at(&free, 5.0).omega.z(), 2.0, 0.0..=1e-15);
}

/// No gravity and no spin at rest, a needle with spin, too little energy, numbers that are none.
#[test]
fn s7_2_integrals_that_no_motion_has() {
    let from = LagrangeTop::from_integrals;
    for refused in [
        from(1.0, 0.5, 0.0, 0.0, 0.0, 0.0),
        from(1.0, 0.0, 1.0, 1e-300, 0.0, 5.0),
        from(1.0, 0.5, 1.0, 2.0, -2.0, 3.0f64.next_down()),
        from(1.0, 0.5, 1.0, 2.0, 2.0, 4.9),
        from(1.0, 0.5, 0.0, 1.0, 1.5, 1.0),
        pendulum_from_integrals(0.0, -9.81f64.next_up(), 9.81),
        pendulum_from_integrals(1.0, -9.81, 9.81),
    ] {
        refused!(refused, Condition);
    }
    for bad in [f64::NAN, f64::INFINITY] {
        for k in 0..6 {
            let mut x = [1.0, 0.5, 1.0, 1.0, 1.0, 5.0];
            x[k] = bad;
            let refused = from(x[0], x[1], x[2], x[3], x[4], x[5]);
            refused!(refused, NotFinite);
        }
    }
}

/// 7.6: 1 − h = 2 sech²(√g t) at energy = gravity; the plane pendulum's period is 4K(k²)/√g with k² = (E + g)/2g, or 2K(1/k²)/(k√g) beyond.
#[test]
fn s7_6_the_pendulum_from_its_integrals() {
    use spinning_bodies::elliptic::{Modulus, Parameter};
    for g in [9.81, 1.0, 3e-7] {
        let climbing = pendulum_from_integrals(0.0, g, g).unwrap();
        assert_eq!(climbing.kind(), Nutation::Waking);
        for turned in [0.5, -3.0, 90.0, 350.0] {
            let t = turned / g.sqrt();
            let cosh = (g.sqrt() * t).cosh();
            close!(at(&climbing, t).one_less, 2.0 / cosh / cosh, 4e-15..=4e-14);
        }
        let energies = [-0.9, 0.0, 1e-9, 0.7, 1.5, 80.0].map(|part| part * g);
        for energy in energies.into_iter().chain([g.next_down(), g.next_up()]) {
            let top = pendulum_from_integrals(0.0, energy, g).unwrap();
            assert_eq!(top.kind(), Nutation::PlanePendulum);
            // The nutation has half the period of a swing, and all of a turn.
            let (mc, rate) = match energy < g {
                true => ((g - energy) / (2.0 * g), g.sqrt()),
                false => ((energy - g) / (energy + g), (0.5 * (energy + g)).sqrt()),
            };
            let modulus = Modulus::new(Parameter::from_complement(mc).unwrap());
            let period = 2.0 * modulus.quarter_period() / rate;
            observed!((top.period() / period - 1.0).abs(), 0.0..=1e-15);
            for part in (1..7).map(f64::from) {
                let state = at(&top, 0.4 * part / rate);
                let sum = 0.5 * state.omega.dot(&state.omega) + g * state.height;
                observed!((sum - energy).abs() / (energy.abs() + g), 1e-16..=1e-15);
            }
        }
    }
    // A cone of 60° under gravity 1: L_vert² = sin⁴θ/cos θ = 9/8, E = ¾ − ½.
    let (vertical, energy) = (1.125f64.sqrt(), 0.25);
    for (beside, moves) in [(energy + 1e-12, true), (energy - 1e-12, false)] {
        let pendulum = pendulum_from_integrals(vertical, beside, 1.0);
        assert_eq!(pendulum.is_ok(), moves);
    }
}
