//! Properties of the free top over bodies and starts that nobody chose.

use super::{component, composed, rates, turn};
use proptest::prelude::*;
use spinning_bodies::euler_top::{EulerTop, State, SymmetricTop};
use spinning_bodies::frame::Attitude;
use support::vector;

/// Moments of a body, in any order: sums of pairs of three numbers, so that the triangle inequality holds.
fn moments() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(0.1..1.0).prop_map(|[a, b, c]: [f64; 3]| [b + c, c + a, a + b])
}

/// Angular momenta of every tilt: each component may be small.
fn momenta() -> impl Strategy<Value = [f64; 3]> {
    [component(1.0), component(1.0), component(1.0)]
        .prop_filter("at rest", |l| l.iter().any(|x| x.abs() > 0.05))
}

fn top(moments: [f64; 3], l: [f64; 3]) -> EulerTop {
    EulerTop::new(moments, vector(l), Attitude::identity()).expect("a body and a finite start")
}

/// The larger of the angle between the attitudes and |ΔL|/|L|.
fn distance(a: &State, b: &State) -> f64 {
    let l = (a.angular_momentum - b.angular_momentum).norm() / b.angular_momentum.norm();
    a.attitude.angle_to(&b.attitude).max(l)
}

/// Fastest rate in the motion, rad/s.
fn fastest(moments: [f64; 3], l: [f64; 3]) -> f64 {
    vector(l).norm() / moments.into_iter().fold(f64::INFINITY, f64::min)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    /// L′ = L ∧ Ω along the body's axes and q′ = ½qΩ, by differences.
    #[test]
    fn obeys_the_equations_of_motion(i in moments(), l in momenta(), start in turn(), t in -20.0..20.0) {
        let top = EulerTop::new(i, vector(l), start).expect("a body");
        // Times that are exact: a rounded one would show as an error of its own size over the step.
        let step = (0.14 / fastest(i, l)).log2().floor().exp2();
        let n = f64::round(t / step) as i32;
        let at = |t: f64| top.at(t).expect("moderate times");
        let momentum = |t: f64| (at(t).angular_momentum.components().into(), at(t).attitude);
        let [l_rates, turning] = rates(momentum, n, step);
        let here = at(f64::from(n) * step);
        let euler = here.angular_momentum.cross(&here.omega).components();
        let error = (l_rates - euler).norm() / (vector(l).norm() * fastest(i, l));
        prop_assert!(error <= 2e-14, "L' off by {error:e}");
        let error = (turning - here.omega.components()).norm() / fastest(i, l);
        prop_assert!(error <= 6e-14, "2q* q' off by {error:e}");
    }

    /// Another initial attitude turns the whole motion in space.
    #[test]
    fn initial_attitude_comes_first(i in moments(), l in momenta(), start in turn(), t in -100.0..100.0) {
        let plain = top(i, l).at(t).expect("moderate times");
        let turned = EulerTop::new(i, vector(l), start).expect("a body").at(t).expect("moderate times");
        prop_assert_eq!(plain.angular_momentum, turned.angular_momentum);
        prop_assert_eq!(plain.omega, turned.omega);
        let expected = composed(&start, &plain.attitude);
        prop_assert!(turned.attitude.angle_to(&expected) <= 2e-15, "{:e}", turned.attitude.angle_to(&expected));
    }

    /// Powers of two change units, not digits: moments by 2ᵃ, L by 2ᵇ, time by 2ᵃ⁻ᵇ.
    #[test]
    fn units_are_exact(i in moments(), l in momenta(), start in turn(), t in -100.0..100.0, a in -400..400, b in -400..400) {
        let (a, b) = (f64::from(a), f64::from(b));
        let top = EulerTop::new(i, vector(l), start).expect("a body");
        let same = EulerTop::new(i.map(|x| x * a.exp2()), vector(l.map(|x| x * b.exp2())), start).expect("the same body");
        prop_assert_eq!((top.regime(), top.period() * (a - b).exp2()), (same.regime(), same.period()));
        let plain = top.at(t).expect("moderate times");
        let scaled = same.at(t * (a - b).exp2()).expect("the same time");
        prop_assert_eq!(plain.attitude, scaled.attitude);
        prop_assert_eq!(plain.angular_momentum * b.exp2(), scaled.angular_momentum);
        prop_assert_eq!(plain.omega * (b - a).exp2(), scaled.omega);
    }

    /// Where two moments are equal the symmetric top of 6.5 says the same, by sines and cosines alone.
    #[test]
    fn equal_moments_give_the_symmetric_top(pair in 0.2..1.0_f64, ratio in 0.01..1.99_f64, omega in momenta(), t in -1e6..1e6, place in 0_usize..3) {
        let axial = pair * ratio;
        // The symmetric top's axis is its third: the others follow it cyclically.
        let renamed = |v: [f64; 3]| { let mut out = [0.0; 3]; for k in 0..3 { out[(place + 1 + k) % 3] = v[k]; } out };
        let exact = SymmetricTop::new(pair, axial).expect("a body");
        let top = EulerTop::from_omega(renamed([pair, pair, axial]), vector(renamed(omega)), Attitude::identity()).expect("a body");
        let state = top.at(t).expect("moderate times");
        let expected = vector(renamed(exact.omega_at(vector(omega), t).components().into()));
        let error = (state.omega - expected).norm() / expected.norm();
        prop_assert!(error <= 2e-15, "omega off by {error:e}");
        // Its attitude in the first second: about L, after a turn back about the axis.
        let [o1, o2, o3] = omega;
        let (t, l) = (t / 1e6, vector(renamed([o1, o2, ratio * o3])));
        let about_l = Attitude::about_axis(l, l.norm() * t);
        let about_axis = Attitude::about_axis(vector(renamed([0.0, 0.0, 1.0])), (1.0 - ratio) * o3 * t);
        let attitude = about_l.expect("it turns") * about_axis.expect("an axis");
        let error = top.at(t).expect("moderate times").attitude.angle_to(&attitude);
        prop_assert!(error <= 4e-15, "attitude off by {error:e}");
    }

    /// The products I Ω need not be doubles: that difference alone remains.
    #[test]
    fn omega_or_momentum_at_the_start(i in moments(), omega in momenta(), t in -1.0..1.0) {
        let l = [0, 1, 2].map(|k| i[k] * omega[k]);
        let one = EulerTop::from_omega(i, vector(omega), Attitude::identity()).expect("a body").at(t).expect("moderate times");
        let two = top(i, l).at(t).expect("moderate times");
        prop_assert!(distance(&one, &two) <= 1e-15 * (1.0 + 20.0 * t.abs()));
    }

    /// Bodies with moments and momenta that a body can have always move.
    #[test]
    fn every_body_moves(i in moments(), l in prop::array::uniform3(-1.0..1.0), exponents in prop::array::uniform3(-1000.0..0.0_f64), t in -1e9..1e9) {
        let l = [0, 1, 2].map(|k| l[k] * exponents[k].exp2());
        let state = top(i, l).at(t);
        prop_assert!(state.is_ok(), "{i:?} {l:?} {t}: {state:?}");
    }
}
