//! Every bit pattern a double can have, as moments, rates, quaternions and times.

use proptest::prelude::*;

use support::any;

use super::*;

fn any3() -> impl Strategy<Value = [f64; 3]> {
    [any(), any(), any()]
}

/// Any quaternion; the identity in place of one that is none.
fn attitude() -> impl Strategy<Value = Attitude> {
    [any(), any(), any(), any()].prop_map(|[w, x, y, z]| {
        Attitude::from_quaternion(w, x, y, z).unwrap_or_else(|_| Attitude::identity())
    })
}

/// Moments of any size in any order, most of them a body's, some not.
fn moments() -> impl Strategy<Value = [f64; 3]> {
    let body = (any(), any(), 0.0..1.0_f64, 0..6_usize).prop_map(|(a, b, part, order)| {
        let (a, b) = (a.abs(), b.abs());
        let (least, greatest) = ((a - b).abs(), a + b);
        let mut i = [a, b, least + part * (greatest - least)];
        i.rotate_left(order % 3);
        if order > 2 {
            i.swap(0, 1);
        }
        i
    });
    prop_oneof![3 => body, 1 => any3()]
}

fn many(cases: u32) -> ProptestConfig {
    let asked = ProptestConfig::default();
    ProptestConfig {
        cases: cases.max(asked.cases),
        failure_persistence: None,
        ..asked
    }
}

fn no_nan(numbers: &[f64]) -> bool {
    numbers.iter().all(|x| !x.is_nan())
}

fn unit(attitude: &Attitude) -> bool {
    (attitude.quaternion().norm() - 1.0).abs() <= 1e-15
}

/// Nothing that a Lagrange top tells is NaN, its turning points are in order, and its states are states.
fn sound(top: &LagrangeTop, t: f64) -> std::result::Result<(), TestCaseError> {
    let r = top.roots();
    prop_assert!(
        no_nan(&[r.h1, r.h2, r.h3, r.third_less_one, top.period()]),
        "{top:?}"
    );
    prop_assert!(no_nan(&r.one_less) && no_nan(&r.one_more), "{top:?}");
    prop_assert!(
        -1.0 <= r.h1 && r.h1 <= r.h2 && r.h2 <= 1.0 && r.h3 >= 1.0,
        "{top:?}"
    );
    let rates = [top.precession_per_nutation(), top.mean_precession_rate()];
    prop_assert!(no_nan(&rates.map(|rate| rate.unwrap_or(0.0))), "{top:?}");
    for time in [t, 0.0] {
        let Ok(state) = top.at(time) else { continue };
        let told = format!("{top:?} {time:e}: {state:?}");
        prop_assert!(time.is_finite() && state.omega.is_finite(), "{told}");
        prop_assert!(unit(&state.attitude), "{told}");
        prop_assert!((-1.0..=1.0).contains(&state.height), "{told}");
        prop_assert!(state.one_less >= 0.0 && state.one_more >= 0.0, "{told}");
    }
    Ok(())
}

proptest! {
    #![proptest_config(many(4000))]

    #[test]
    fn any_euler_top(i in moments(), l in any3(), start in attitude(), t in any()) {
        let tops = [
            EulerTop::new(i, vector(l), start), EulerTop::from_omega(i, vector(l), start),
            EulerTop::from_integrals(i, l[0], l[1], start), EulerTop::beside_separatrix(i, l[1], l[2], start),
        ];
        for top in tops.into_iter().flatten() {
            prop_assert!(no_nan(&[top.energy(), top.period(), top.mean_precession_rate()]), "{top:?}");
            for time in [t, 0.0] {
                let Ok(state) = top.at(time) else { continue };
                prop_assert!(time.is_finite() && state.omega.is_finite() && state.angular_momentum.is_finite(), "{top:?} {time:e}: {state:?}");
                prop_assert!(unit(&state.attitude), "{top:?} {time:e}: {state:?}");
            }
        }
    }

    #[test]
    fn any_lagrange_top(i1 in any(), ratio in prop_oneof![3 => 0.0..2.0_f64, 1 => any()], weight in any(), omega in any3(), start in attitude(), t in any()) {
        if let Ok(top) = LagrangeTop::new(i1, i1 * ratio, weight, vector(omega), start) {
            sound(&top, t)?;
        }
    }

    #[test]
    fn any_top_from_integrals(i1 in any(), ratio in prop_oneof![3 => 0.0..2.0_f64, 1 => any()], weight in any(), kept in any3(), upright in 0..3_usize, t in any()) {
        let [l3, vertical, energy] = kept;
        // Half of them with L_vert = L₃.
        let vertical = if upright == 0 { l3 } else { vertical };
        let from = [LagrangeTop::from_integrals, LagrangeTop::above_upright];
        let mut tops = from.map(|from| from(i1, i1 * ratio, weight, l3, vertical, energy)).to_vec();
        tops.push(pendulum_from_integrals(vertical, energy, weight));
        for top in tops.into_iter().flatten() {
            sound(&top, t)?;
        }
    }

    #[test]
    fn any_picture(i in moments(), l in any3(), s in -10.0..10.0_f64) {
        if let Ok(picture) = Poinsot::new(i, vector(l)) {
            let [p, q] = [picture.polhode(s), picture.polhode_of_l(s)].map(|v| <[f64; 3]>::from(v.components()));
            prop_assert!(no_nan(&p) && no_nan(&q) && no_nan(&picture.semi_axes) && no_nan(&picture.herpolhode_radii()), "{picture:?} {s}");
            prop_assert!(no_nan(&[picture.plane_distance, picture.start(), picture.pace(s)]), "{picture:?} {s}");
        }
    }

    #[test]
    fn any_special_motion(a in any(), b in any(), c in any(), d in any(), angle in -1.0..4.0_f64) {
        if let Ok(rates) = pure_precession(a, b, c, d) {
            match rates {
                PurePrecession::One(w) => prop_assert!(!w.is_nan()),
                PurePrecession::Two { slow, fast } => prop_assert!(no_nan(&[slow, fast]) && slow.abs() <= fast.abs(), "{slow:e} {fast:e}"),
                _ => {}
            }
        }
        if let Ok(limit) = fast_spin(a, b, c, d) {
            prop_assert!(no_nan(&[limit.slow, limit.fast, limit.x]));
        }
        for tilt in [d, angle] {
            let Ok(sunk) = dip(a, b, c, tilt) else { continue };
            prop_assert!(no_nan(&[sunk.lowest_height, sunk.lowest_tilt, sunk.depth, sunk.cycloid.radius, sunk.cycloid.sine]), "{sunk:?}");
            prop_assert!(sunk.depth >= 0.0 && sunk.lowest_tilt <= 3.2, "{sunk:?}");
        }
        prop_assert!(!sleeping_threshold(a, b, c).unwrap_or(0.0).is_nan());
        prop_assert!(!tilt_after_kick(a, b, c, d).unwrap_or(0.0).is_nan());
        if let Ok(pendulum) = pendulum_between(a, angle, b) {
            prop_assert!(!pendulum.period().is_nan());
        }
        if let Ok(turn) = apsides(a, angle) {
            prop_assert!(no_nan(&[turn.advance, turn.small_swing]), "{a:e} {angle:e}: {turn:?}");
        }
        if let Ok(turn) = apsides(a, b) {
            prop_assert!(no_nan(&[turn.advance, turn.small_swing]), "{a:e} {b:e}: {turn:?}");
        }
    }
}

proptest! {
    #![proptest_config(many(400))]

    #[test]
    fn any_kovalevskaya_top(i3 in any(), nudge in prop_oneof![3 => Just(0.0), 1 => any()], lever in any3(), plane in 0.0..1.0_f64, omega in any3(), start in attitude(), t in any()) {
        let moments = [2.0 * i3, 2.0 * i3 + nudge, i3];
        let lever = if plane < 0.8 { [lever[0], lever[1], 0.0] } else { lever };
        let tops = [
            KovalevskayaTop::new(moments, vector(lever), vector(omega), start),
            KovalevskayaTop::with_up(moments, vector(lever), vector(omega), start.to_body(spinning_bodies::frame::SpaceVector::new(0.0, 0.0, 1.0))),
        ];
        let strength = (lever[0].hypot(lever[1]) / i3).sqrt();
        let fastest = vector(omega).components().amax().max(strength);
        let units = t.abs() * fastest;
        for top in tops.into_iter().flatten() {
            let kept = top.constants();
            prop_assert!(no_nan(&[kept.energy, kept.vertical_angular_momentum, kept.kovalevskaya]), "{top:?}");
            prop_assert!(no_nan(&top.frequencies().unwrap_or([0.0; 2])), "{top:?}");
            let _ = (top.roots(), top.heavy_top());
            // Where it walks, a long way takes long.
            let near = if (100.0..3e6).contains(&units) { 0.0 } else { t };
            for time in [near, 0.0] {
                if let Ok(state) = top.at(time) {
                    prop_assert!(time.is_finite() && state.omega.is_finite() && state.up.is_finite(), "{top:?} {time:e}: {state:?}");
                    prop_assert!(unit(&state.attitude) && (state.up.norm() - 1.0).abs() < 1e-12, "{top:?} {time:e}: {state:?}");
                }
            }
            if top.method() == Method::Separation
                && let Ok(state) = top.omega_and_up(t)
            {
                prop_assert!(t.is_finite() && state.omega.is_finite() && state.up.is_finite(), "{top:?} {t:e}: {state:?}");
            }
        }
    }
}
