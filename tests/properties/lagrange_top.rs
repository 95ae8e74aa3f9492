//! Properties of Lagrange's top over tops and starts that nobody chose.

use super::{component, composed, rates};
use nalgebra::Vector3;
use proptest::prelude::*;
use spinning_bodies::euler_top::{EulerTop, SymmetricTop};
use spinning_bodies::frame::{Attitude, BodyVector, SpaceVector};
use spinning_bodies::lagrange_top::{LagrangeTop, Nutation, State};
use support::{heavy_rates, vector, within};

const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);

/// I₁, I₃ and Mgl, the centre of mass above or below.
fn bodies() -> impl Strategy<Value = [f64; 3]> {
    (0.3..3.0_f64, 0.02..1.98_f64, 0.1..5.0_f64, prop::bool::ANY)
        .prop_map(|(i1, ratio, weight, up)| [i1, i1 * ratio, if up { weight } else { -weight }])
}

/// Ω of every inclination: each component may be small.
fn omegas() -> impl Strategy<Value = [f64; 3]> {
    [component(3.0), component(3.0), component(3.0)]
}

/// Attitudes of every tilt, the poles among them and close to them.
fn attitudes() -> impl Strategy<Value = Attitude> {
    let ordinary = prop::array::uniform4(0.05..1.0_f64)
        .prop_map(|[w, x, y, z]| [w - 0.5, x - 0.4, y - 0.5, z]);
    let near_a_pole = (
        prop::array::uniform4(-1.0..1.0_f64),
        -40.0..0.0_f64,
        prop::bool::ANY,
    )
        .prop_map(|([w, x, y, z], exponent, up)| {
            let small = exponent.exp2();
            if up {
                [w + 2.0, x * small, y * small, z]
            } else {
                [w * small, x + 2.0, y, z * small]
            }
        });
    let poles = prop::sample::select(vec![[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]]);
    prop_oneof![4 => ordinary, 2 => near_a_pole, 1 => poles]
        .prop_map(|[w, x, y, z]| Attitude::from_quaternion(w, x, y, z).expect("not zero"))
}

fn top([i1, i3, weight]: [f64; 3], omega: [f64; 3], attitude: Attitude) -> LagrangeTop {
    LagrangeTop::new(i1, i3, weight, vector(omega), attitude).expect("a body and a finite start")
}

fn at(top: &LagrangeTop, t: f64) -> State {
    top.at(t).expect("moderate times")
}

/// Fastest rate in the motion, rad/s: Ω at the start, and what the fall from top to bottom can add.
fn fastest([i1, i3, weight]: [f64; 3], omega: [f64; 3]) -> f64 {
    vector(omega).norm() * (1.0 + i3 / i1) + 2.0 * (weight.abs() / i1).sqrt()
}

/// The larger of the angle between the attitudes and |ΔΩ| over the fastest rate.
fn distance(a: &State, b: &State, fastest: f64) -> f64 {
    let omega = (a.omega - b.omega).norm() / fastest;
    a.attitude.angle_to(&b.attitude).max(omega)
}

/// How fast neighbours may part: 1 + the greatest of the rates times t, times an exponential near the upright position.
fn parting([i1, _, weight]: [f64; 3], omega: [f64; 3], t: f64) -> f64 {
    let escape = (weight.abs() / i1).sqrt() * t.abs();
    (1.0 + vector(omega).norm() * t.abs()) * escape.exp()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    /// I∂Ω/∂t = IΩ∧Ω + Mgl z∧e₃ along the body's axes and q′ = ½qΩ, by differences.
    #[test]
    fn obeys_the_equations_of_motion(body in bodies(), omega in omegas(), start in attitudes(), t in -20.0..20.0) {
        let top = top(body, omega, start);
        let fastest = fastest(body, omega);
        // Times that are exact: a rounded one would show as an error of its own size over the step.
        let step = (0.14 / fastest).log2().floor().exp2();
        let n = f64::round(t / step) as i32;
        let [slopes, turning] = rates(|t| (at(&top, t).omega.components().into(), at(&top, t).attitude), n, step);
        let here = at(&top, f64::from(n) * step);
        let ([i1, i3, weight], up) = (body, here.attitude.to_body(UP));
        let [omega, up] = [here.omega, up].map(|v| v.components().into());
        let [euler, _] = heavy_rates([i1, i1, i3], [0.0, 0.0, weight], omega, up);
        within((slopes - Vector3::from(euler)).norm() / (fastest * fastest), 1.2e-13);
        within((turning - here.omega.components()).norm() / fastest, 1.5e-13);
    }

    /// L = IΩ axis by axis, bit by bit, and z is where the attitude sees it.
    #[test]
    fn a_state_agrees_with_itself(body in bodies(), omega in omegas(), start in attitudes(), t in -100.0..100.0) {
        let state = at(&top(body, omega, start), t);
        let [i1, i3, _] = body;
        let l = vector([i1 * state.omega.x(), i1 * state.omega.y(), i3 * state.omega.z()]);
        prop_assert_eq!(state.angular_momentum, l);
        within((state.up - state.attitude.to_body(UP)).norm(), 3e-15);
        prop_assert_eq!(state.up.z(), state.height);
    }

    /// Time zero is the start itself.
    #[test]
    fn begins_at_the_beginning(body in bodies(), omega in omegas(), start in attitudes()) {
        let state = at(&top(body, omega, start), 0.0);
        within((state.omega - vector(omega)).norm() / fastest(body, omega), 2e-15);
        within(state.attitude.angle_to(&start), 4e-15);
    }

    /// Stopping at t₁ and starting again is no interruption. The state at t₁ is rounded, and neighbours part.
    #[test]
    fn the_motion_is_a_flow(body in bodies(), omega in omegas(), start in attitudes(), first in -3.0..3.0, second in -3.0..3.0) {
        let fastest = fastest(body, omega);
        let [first, second] = [first / fastest, second / fastest];
        let whole = top(body, omega, start);
        let middle = at(&whole, first);
        let rest = top(body, middle.omega.components().into(), middle.attitude);
        let (once, twice) = (at(&whole, first + second), at(&rest, second));
        within(distance(&twice, &once, fastest), 1e-14);
    }

    /// The top that starts with −Ω runs the motion backwards.
    #[test]
    fn time_runs_both_ways(body in bodies(), omega in omegas(), start in attitudes(), t in -100.0..100.0) {
        let fastest = fastest(body, omega);
        let forward = at(&top(body, omega, start), t);
        let reversed = at(&top(body, omega.map(|x| -x), start), -t);
        let expected = State { omega: -forward.omega, ..forward };
        within(distance(&reversed, &expected, fastest), 2e-15);
        within((reversed.one_less - forward.one_less).abs(), 4e-16);
    }

    /// Powers of two change units, not digits: moments by 2ᵃ, Ω by 2ᵇ, Mgl by 2ᵃ⁺²ᵇ, time by 2⁻ᵇ.
    #[test]
    fn units_are_exact(body in bodies(), omega in omegas(), start in attitudes(), t in -100.0..100.0, a in -300..300, b in -150..150) {
        let (a, b) = (f64::from(a), f64::from(b));
        let plain = at(&top(body, omega, start), t);
        let [i1, i3, weight] = body;
        let other = [i1 * a.exp2(), i3 * a.exp2(), weight * (a + 2.0 * b).exp2()];
        let scaled = at(&top(other, omega.map(|x| x * b.exp2()), start), t * (-b).exp2());
        prop_assert_eq!(plain.attitude, scaled.attitude);
        prop_assert_eq!(plain.omega * b.exp2(), scaled.omega);
        prop_assert_eq!((plain.height, plain.one_less, plain.one_more), (scaled.height, scaled.one_less, scaled.one_more));
    }

    /// A turn of space about the vertical turns the whole motion; a turn of the body about its axis at the start stays with it.
    #[test]
    fn two_symmetries(body in bodies(), omega in omegas(), start in attitudes(), t in -3.0..3.0, angle in -3.0..3.0_f64) {
        let turn = Attitude::about_axis(vector([0.0, 0.0, 1.0]), angle).expect("an axis");
        let fastest = fastest(body, omega);
        let t = t / fastest;
        // The turned start is rounded, and neighbours part.
        let allowed = 2e-15 * parting(body, omega, t);
        let near = at(&top(body, omega, start), t);
        let turned = at(&top(body, omega, composed(&turn, &start)), t);
        let expected = State { attitude: composed(&turn, &near.attitude), ..near };
        within(distance(&turned, &expected, fastest), 4.0 * allowed);
        let back = turn.quaternion().inverse() * Vector3::from(omega);
        let spun = at(&top(body, back.into(), composed(&start, &turn)), t);
        let omega_there = BodyVector::from_components(turn.quaternion().inverse() * near.omega.components());
        let expected = State { attitude: composed(&near.attitude, &turn), omega: omega_there, ..near };
        within(distance(&spun, &expected, fastest), 4.0 * allowed);
    }

    /// Without gravity the symmetric free top says the same, by sines and cosines alone, and Euler's top by its own road.
    #[test]
    fn without_gravity_the_free_top(body in bodies(), omega in omegas(), start in attitudes(), t in -1e3..1e3) {
        prop_assume!(omega.iter().any(|x| x.abs() > 0.05));
        let [i1, i3, _] = body;
        let fastest = fastest([i1, i3, 0.0], omega);
        let free = at(&top([i1, i3, 0.0], omega, start), t);
        let symmetric = SymmetricTop::new(i1, i3).expect("a body");
        let omega_there = symmetric.omega_at(vector(omega), t);
        within((free.omega - omega_there).norm() / fastest, 2e-15);
        let euler = EulerTop::from_omega([i1, i1, i3], vector(omega), start).expect("a body").at(t).expect("moderate times");
        within(free.attitude.angle_to(&euler.attitude), 4e-15);
    }

    /// Gravity's effect goes to zero with Mgl, and in proportion.
    #[test]
    fn weak_gravity_is_nearly_none(body in bodies(), omega in omegas(), start in attitudes(), t in -3.0..3.0, exponent in -300.0..-8.0_f64) {
        let [i1, i3, _] = body;
        let weight = exponent.exp2();
        let fastest = fastest([i1, i3, 1.0], omega);
        let t = t / fastest;
        let free = at(&top([i1, i3, 0.0], omega, start), t);
        let weak = at(&top([i1, i3, weight], omega, start), t);
        // Mgl/I₁ pulls for a time t: so much of Ω, and of turning, and their share in what else turns.
        let effect = weight / i1 * t.abs() * (t.abs() + 1.0 / fastest) * (1.0 + fastest * t.abs());
        within(distance(&free, &weak, fastest), 4e-15 + 2.0 * effect);
    }

    /// Tops and starts as they are met with always move.
    #[test]
    fn every_top_moves(body in bodies(), omega in prop::array::uniform3(-1.0..1.0), exponents in prop::array::uniform3(-1000.0..0.0_f64), start in attitudes(), t in -1e9..1e9) {
        let omega = [0, 1, 2].map(|k| omega[k] * exponents[k].exp2());
        let state = top(body, omega, start).at(t);
        prop_assert!(state.is_ok(), "{body:?} {omega:?} {start:?} {t}: {state:?}");
    }
}

/// The kind is that of the numbers as they are: one unit in the last place decides.
#[test]
fn one_unit_in_the_last_place_decides_the_kind() {
    let upright = Attitude::identity();
    let sleeping = |omega3: f64| top([1.0, 0.5, 1.0], [0.0, 0.0, omega3], upright).kind();
    assert_eq!(sleeping(4.0), Nutation::Sleeping { stable: true });
    let (below, stable) = (4.0_f64.next_down(), false);
    assert_eq!(sleeping(below), Nutation::Sleeping { stable });
    // z = (0, 4/5, 3/5): steady precession 5 with L₃ = 4 under Mgl = 5, and the motion that climbs to the top and stays.
    let tilted = Attitude::from_quaternion(2.0, 1.0, 0.0, 0.0).expect("not zero");
    let kind = |weight: f64, omega: [f64; 3]| top([1.0, 0.5, weight], omega, tilted).kind();
    assert_eq!(kind(5.0, [0.0, 4.0, 8.0]), Nutation::PurePrecession);
    for beside in [4.0_f64.next_up(), 4.0_f64.next_down()] {
        assert_ne!(kind(5.0, [0.0, beside, 8.0]), Nutation::PurePrecession);
    }
    for first in [3.0_f64, -3.0] {
        assert_eq!(kind(31.25, [first, 4.0, 16.0]), Nutation::Waking);
        for beside in [first.next_up(), first.next_down()] {
            assert_ne!(kind(31.25, [beside, 4.0, 16.0]), Nutation::Waking);
        }
    }
    // Released at rest: cusps; a breath of φ' on either side: waves, loops.
    assert_eq!(kind(1.0, [0.0, 0.0, 3.0]), Nutation::Cusps);
    assert_eq!(kind(1.0, [0.0, 1e-300, 3.0]), Nutation::Waves);
    assert_eq!(kind(1.0, [0.0, -1e-300, 3.0]), Nutation::Loops);
    // No spin: in a plane, or not.
    assert_eq!(kind(1.0, [0.7, 0.0, 0.0]), Nutation::PlanePendulum);
    assert_eq!(kind(1.0, [0.7, 1e-300, 0.0]), Nutation::SphericalPendulum);
}
