//! Properties of Lagrange's top over tops and starts that nobody chose.

use super::{component, composed, derivative};
use nalgebra::{UnitQuaternion, Vector3};
use proptest::prelude::*;
use spinning_bodies::euler_top::{EulerTop, SymmetricTop};
use spinning_bodies::frame::{Attitude, BodyVector, SpaceVector};
use spinning_bodies::lagrange_top::{LagrangeTop, Nutation, State};
use support::vector;

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

/// Fails, with the numbers, unless the error is within the bound.
macro_rules! within {
    ($error:expr, $bound:expr, $what:expr) => {{
        let (error, bound): (f64, f64) = ($error, $bound);
        prop_assert!(
            error <= bound,
            "{} off by {error:e}, beyond {bound:e}",
            $what
        );
    }};
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    /// I∂Ω/∂t = IΩ∧Ω + Mgl z∧e₃ along the body's axes and q′ = ½qΩ, by differences of the eighth order.
    #[test]
    fn obeys_the_equations_of_motion(body in bodies(), omega in omegas(), start in attitudes(), t in -20.0..20.0) {
        let top = top(body, omega, start);
        let fastest = fastest(body, omega);
        // Times that are exact: a rounded one would show as an error of its own size over the step.
        let step = (0.04 / fastest).log2().floor().exp2();
        let t = f64::round(t / step) * step;
        let states: Vec<State> = (-4..=4).map(|k| at(&top, t + f64::from(k) * step)).collect();
        let here = states[4];
        let [i1, i3, weight] = body;
        let rates = derivative(core::array::from_fn(|k| states[k].omega.components()), step);
        let [x, y, z]: [f64; 3] = here.omega.components().into();
        let up = here.attitude.to_body(UP);
        let euler = Vector3::new(
            ((i1 - i3) * y * z + weight * up.y()) / i1,
            ((i3 - i1) * z * x - weight * up.x()) / i1,
            0.0,
        );
        within!((rates - euler).norm() / (fastest * fastest), 1.2e-13, "the angular acceleration");
        let relative = |k: usize| {
            let q: UnitQuaternion<f64> = here.attitude.quaternion().inverse() * states[k].attitude.quaternion();
            q.imag() * q.w.signum()
        };
        let turning = 2.0 * derivative(core::array::from_fn(relative), step);
        within!((turning - here.omega.components()).norm() / fastest, 1.5e-13, "2q* q'");
    }

    #[test]
    fn constants_stay(body in bodies(), omega in omegas(), start in attitudes(), t in -1e3..1e3) {
        let top = top(body, omega, start);
        let state = at(&top, t);
        let [i1, i3, weight] = body;
        let fastest = fastest(body, omega);
        // L₃ bit by bit.
        prop_assert_eq!(state.omega.z(), omega[2]);
        within!((top.axial_angular_momentum() - i3 * omega[2]).abs(), 1e-15 * i3 * omega[2].abs(), "L3");
        let vertical = state.angular_momentum.dot(&state.up);
        let scale = (i1 + i3) * fastest;
        within!((vertical - top.vertical_angular_momentum()).abs() / scale, 4e-15, "L_vert");
        let [x, y, z]: [f64; 3] = state.omega.components().into();
        let energy = 0.5 * (i1 * (x * x + y * y) + i3 * z * z) + weight * state.height;
        within!((energy - top.energy()).abs() / (scale * fastest), 4e-15, "the energy");
    }

    /// L = IΩ axis by axis, bit by bit, and z is where the attitude sees it.
    #[test]
    fn a_state_agrees_with_itself(body in bodies(), omega in omegas(), start in attitudes(), t in -100.0..100.0) {
        let state = at(&top(body, omega, start), t);
        let [i1, i3, _] = body;
        let l = vector([i1 * state.omega.x(), i1 * state.omega.y(), i3 * state.omega.z()]);
        prop_assert_eq!(state.angular_momentum, l);
        within!((state.up - state.attitude.to_body(UP)).norm(), 3e-15, "up");
        prop_assert_eq!(state.up.z(), state.height);
    }

    /// h, 1 − h and 1 + h are those of the attitude.
    #[test]
    fn height_is_that_of_the_attitude(body in bodies(), omega in omegas(), start in attitudes(), t in -100.0..100.0) {
        let state = at(&top(body, omega, start), t);
        let q = state.attitude.quaternion();
        let [less, more] = [2.0 * (q.i * q.i + q.j * q.j), 2.0 * (q.w * q.w + q.k * q.k)];
        // As chords: near a pole 1 ∓ h is the square of something small.
        let chord = |a: f64, b: f64| (a.sqrt() - b.sqrt()).abs();
        within!(chord(state.one_less, less), 2e-15, "1 - h");
        within!(chord(state.one_more, more), 2e-15, "1 + h");
        within!((state.height - 0.5 * (more - less)).abs(), 5e-15, "h");
        // With gravity upwards the roots are those of −h.
        let roots = top(body, omega, start).roots();
        let height = state.height * body[2].signum();
        prop_assert!(roots.h1 - 1e-15 <= height && height <= roots.h2 + 1e-15, "{} {height} {}", roots.h1, roots.h2);
    }

    /// Time zero is the start itself.
    #[test]
    fn begins_at_the_beginning(body in bodies(), omega in omegas(), start in attitudes()) {
        let state = at(&top(body, omega, start), 0.0);
        within!((state.omega - vector(omega)).norm() / fastest(body, omega), 2e-15, "omega");
        within!(state.attitude.angle_to(&start), 4e-15, "the attitude");
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
        within!(distance(&twice, &once, fastest), 1e-14, "restarted");
    }

    /// The top that starts with −Ω runs the motion backwards.
    #[test]
    fn time_runs_both_ways(body in bodies(), omega in omegas(), start in attitudes(), t in -100.0..100.0) {
        let fastest = fastest(body, omega);
        let forward = at(&top(body, omega, start), t);
        let reversed = at(&top(body, omega.map(|x| -x), start), -t);
        let expected = State { omega: -forward.omega, ..forward };
        within!(distance(&reversed, &expected, fastest), 2e-15, "reversed");
        within!((reversed.one_less - forward.one_less).abs(), 4e-16, "1 - h");
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
        within!(distance(&turned, &expected, fastest), 4.0 * allowed, "turned about the vertical");
        let back = turn.quaternion().inverse() * Vector3::from(omega);
        let spun = at(&top(body, back.into(), composed(&start, &turn)), t);
        let omega_there = BodyVector::from_components(turn.quaternion().inverse() * near.omega.components());
        let expected = State { attitude: composed(&near.attitude, &turn), omega: omega_there, ..near };
        within!(distance(&spun, &expected, fastest), 4.0 * allowed, "turned about the axis");
    }

    /// Mgl < 0 is the same top with its axis named the other way round: half a turn about x₁ before the motion and after.
    #[test]
    fn a_negative_lever_is_the_mirror(body in bodies(), omega in omegas(), start in attitudes(), t in -100.0..100.0) {
        let [i1, i3, weight] = body;
        let half = |attitude: &Attitude| {
            let q = attitude.quaternion();
            Attitude::from_quaternion(-q.i, q.w, q.k, -q.j).expect("a unit quaternion")
        };
        // Starts whose four numbers come through unrounded: one in the last place would grow with time.
        let (q, p) = (start.quaternion(), half(&start).quaternion());
        if [p.w, p.i, p.j, p.k] != [-q.i, q.w, q.k, -q.j] {
            return Ok(());
        }
        let fastest = fastest(body, omega);
        let plain = at(&top(body, omega, start), t);
        let [x, y, z] = omega;
        let other = at(&top([i1, i3, -weight], [x, -y, -z], half(&start)), t);
        let turned = |v: BodyVector| vector([v.x(), -v.y(), -v.z()]);
        let expected = State {
            omega: turned(plain.omega),
            angular_momentum: turned(plain.angular_momentum),
            attitude: half(&plain.attitude),
            up: turned(plain.up),
            height: -plain.height,
            one_less: plain.one_more,
            one_more: plain.one_less,
        };
        within!(distance(&other, &expected, fastest), 1e-15, "mirrored");
        within!((other.up - expected.up).norm(), 1e-15, "up, mirrored");
        within!((other.one_less - expected.one_less).abs().max((other.one_more - expected.one_more).abs()), 5e-16, "1 - h, 1 + h");
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
        within!((free.omega - omega_there).norm() / fastest, 2e-15, "omega");
        let turned = composed(&start, &symmetric.attitude_at(vector(omega), t).expect("moderate times"));
        within!(free.attitude.angle_to(&turned), 5e-15, "the attitude");
        let euler = EulerTop::from_omega([i1, i1, i3], vector(omega), start).expect("a body").at(t).expect("moderate times");
        within!(free.attitude.angle_to(&euler.attitude), 4e-15, "Euler's attitude");
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
        within!(distance(&free, &weak, fastest), 4e-15 + 2.0 * effect, "weak gravity");
    }

    /// After one nutation h and h′ are back, and the axis has gone round by the precession per nutation.
    #[test]
    fn one_nutation(body in bodies(), omega in omegas(), start in attitudes()) {
        let top = top(body, omega, start);
        let period = top.period();
        prop_assume!(period.is_finite() && period * fastest(body, omega) < 200.0);
        let (before, after) = (at(&top, 0.0), at(&top, period));
        // The period is rounded, and h moves meanwhile.
        let allowed = 2e-15 * (2.0 + fastest(body, omega) * period);
        within!((after.height - before.height).abs(), allowed, "h");
        let gained = top.precession_per_nutation().expect("a period");
        let sine = (before.one_less * before.one_more).sqrt();
        prop_assume!(gained.is_finite());
        let turn = Attitude::about_axis(vector([0.0, 0.0, 1.0]), gained).expect("an axis");
        let axis = |state: &State| state.attitude.to_space(vector([0.0, 0.0, 1.0]));
        let expected = turn.quaternion() * axis(&before).components();
        // A passage close by a pole turns the azimuth by half a turn within a moment.
        let off = (axis(&after).components() - expected).norm();
        within!(off, 4.0 * allowed + 4e-15 * gained.abs() * sine, "the axis");
        within!((top.mean_precession_rate().expect("a period") * period - gained).abs(), 4e-16 * gained.abs() + 1e-300, "the mean rate");
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
    assert_eq!(
        sleeping(4.0_f64.next_down()),
        Nutation::Sleeping { stable: false }
    );
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

/// The limit L₃ → L_vert through the pole: exactly, and a little beside, the motion is alike.
#[test]
fn no_jump_at_the_poles() {
    for (first, second) in [(1.0, 0.5), (-0.3, 0.5), (1.0, -2.0), (0.4, -2.0)] {
        let attitude = Attitude::from_quaternion(2.0, 1.0, 0.0, 0.0).expect("not zero");
        let through = top([1.0, 0.5, 1.0], [first, second, 2.0], attitude);
        for nudge in [1e-16, 1e-12, 1e-9] {
            let start = [first, second * (1.0 + nudge), 2.0];
            let beside = top([1.0, 0.5, 1.0], start, attitude);
            for k in 0..40 {
                let t = 0.31 * f64::from(k);
                let off = distance(&at(&through, t), &at(&beside, t), 4.0);
                assert!(
                    off <= 2e-14 + 100.0 * (1.0 + t) * nudge,
                    "{nudge:e} {t}: {off:e}"
                );
            }
        }
    }
}

/// From either side of the separatrix, one unit in the last place away, alike until the axes part.
#[test]
fn no_jump_at_the_separatrix() {
    let tilted = Attitude::from_quaternion(2.0, 1.0, 0.0, 0.0).expect("not zero");
    for (weight, second, spin, first) in [
        (31.25, 4.0, 16.0, 3.0_f64),
        (31.25, 4.0, 16.0, -3.0),
        (5.0, 0.0, 0.0, -2.0),
    ] {
        let start = |first: f64| top([1.0, 0.5, weight], [first, second, spin], tilted);
        let exact = start(first);
        for t in [-1.0, 0.1, 0.5, 1.0] {
            for beside in [first.next_up(), first.next_down()] {
                let off = distance(&at(&start(beside), t), &at(&exact, t), 16.0);
                assert!(off <= 1e-13, "{beside} {t}: {off:e}");
            }
        }
    }
}
