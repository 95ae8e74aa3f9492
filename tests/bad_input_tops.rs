//! Bad input for the three tops: whatever is given, a documented meaning or an error that names the condition.
//!
//! First the list of starts on which a formula divides by zero or a class has its border, each with what it means. Then chance: every
//! bit pattern of a double may be a moment, a rate, a quaternion or a time. No panic, and no NaN in a state that is handed out.
//! `PROPTEST_CASES` greater than the numbers below searches longer.

use proptest::prelude::*;
use spinning_bodies::euler_top::{EulerTop, Regime};
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::kovalevskaya_top::{Kind, KovalevskayaTop, Method};
use spinning_bodies::lagrange_top::{
    LagrangeTop, Nutation, PurePrecession, State, apsides, dip, fast_spin, pendulum_between,
    pure_precession, sleeping_threshold, tilt_after_kick,
};
use spinning_bodies::{Error, Result};

const BAD: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const ZERO: [f64; 3] = [0.0; 3];

fn vector([x, y, z]: [f64; 3]) -> BodyVector {
    BodyVector::new(x, y, z)
}

fn upright() -> Attitude {
    Attitude::identity()
}

/// The axis straight down, exactly: a half turn about the first axis.
fn hanging() -> Attitude {
    Attitude::from_quaternion(0.0, 1.0, 0.0, 0.0).expect("a quaternion")
}

/// The axis level, exactly: z₃ = 0.
fn level() -> Attitude {
    Attitude::from_quaternion(1.0, 1.0, 0.0, 0.0).expect("a quaternion")
}

/// The start and the same after half a minute.
fn lagrange(weight: f64, omega: [f64; 3], attitude: Attitude) -> Result<(Nutation, [State; 2])> {
    let top = LagrangeTop::new(1.0, 0.5, weight, vector(omega), attitude)?;
    Ok((top.kind(), [top.at(0.0)?, top.at(30.0)?]))
}

mod lagranges_top {
    use super::*;

    #[test]
    fn pivot_at_the_centre_of_mass_is_a_free_top() -> Result<()> {
        let (omega, tilted) = (
            vector([0.7, -0.4, 3.0]),
            Attitude::from_quaternion(0.9, 0.3, 0.2, 0.1)?,
        );
        let free = EulerTop::from_omega([1.0, 1.0, 0.5], omega, tilted)?;
        for weightless in [0.0, -0.0] {
            let top = LagrangeTop::new(1.0, 0.5, weightless, omega, tilted)?;
            assert_eq!(top.roots().h3, f64::INFINITY);
            for t in [-3.0, 0.0, 0.5, 20.0] {
                let (mine, theirs) = (top.at(t)?, free.at(t)?);
                assert!(mine.attitude.angle_to(&theirs.attitude) < 3e-15);
                assert!((mine.omega - theirs.omega).norm() < 6e-15);
            }
        }
        let (kind, states) = lagrange(0.0, [0.0, 0.0, 3.0], tilted)?;
        assert_eq!(kind, Nutation::Spinning);
        assert!(
            states
                .iter()
                .all(|s| s.omega == BodyVector::new(0.0, 0.0, 3.0))
        );
        Ok(())
    }

    #[test]
    fn gravity_upwards_is_the_same_top_upside_down() -> Result<()> {
        for omega in [ZERO, [0.0, 0.0, 3.0]] {
            assert_eq!(lagrange(-1.0, omega, upright())?.0, Nutation::Hanging);
            let stable = omega == [0.0, 0.0, 5.0];
            assert_eq!(
                lagrange(-1.0, omega, hanging())?.0,
                Nutation::Sleeping { stable }
            );
        }
        // h goes where −h would.
        let [down, up] = [1.0, -1.0].map(|weight| {
            LagrangeTop::new(1.0, 0.5, weight, vector([0.4, 0.0, 0.0]), level()).expect("a top")
        });
        for t in [0.0, 0.7, 30.0] {
            assert!((down.at(t)?.height + up.at(-t)?.height).abs() < 1e-15);
        }
        Ok(())
    }

    #[test]
    fn tilt_of_exactly_nothing_or_a_half_turn() -> Result<()> {
        for (attitude, height) in [(upright(), 1.0), (hanging(), -1.0)] {
            for spin in [0.0, 1.0, -7.0] {
                let (kind, states) = lagrange(1.0, [0.0, 0.0, spin], attitude)?;
                let expected = match height {
                    1.0 => Nutation::Sleeping {
                        stable: spin == -7.0,
                    },
                    _ => Nutation::Hanging,
                };
                assert_eq!(kind, expected, "at rest or spinning, the axis stays");
                assert!(
                    states
                        .iter()
                        .all(|s| (s.height, s.omega.z()) == (height, spin))
                );
            }
            // Kicked, it leaves the pole and comes back to it.
            for spin in [0.0, 1.0, -7.0] {
                let omega = vector([0.3, 0.0, spin]);
                let top = LagrangeTop::new(1.0, 0.5, 1.0, omega, attitude)?;
                assert_eq!(top.at(0.0)?.height, height);
                let away = top.at(0.5 * top.period())?;
                let back = top.at(top.period())?;
                // Without spin the upright one falls through the bottom; the other swings.
                assert!(
                    (away.height - height).abs() > 1e-3,
                    "{height} {spin}: {away:?}"
                );
                assert!((back.height - height).abs() < 1e-15);
            }
        }
        Ok(())
    }

    #[test]
    fn spin_exactly_at_the_threshold_sleeps() -> Result<()> {
        let threshold = sleeping_threshold(1.0, 0.5, 1.0)?;
        assert_eq!(threshold, 4.0);
        for (spin, stable) in [
            (threshold, true),
            (-threshold, true),
            (threshold.next_down(), false),
        ] {
            let (kind, _) = lagrange(1.0, [0.0, 0.0, spin], upright())?;
            assert_eq!(kind, Nutation::Sleeping { stable });
        }
        Ok(())
    }

    #[test]
    fn at_rest_it_falls_unless_upright_or_hanging() -> Result<()> {
        let tilted = Attitude::from_quaternion(2.0, 1.0, 0.0, 0.0)?;
        for omega in [ZERO, [-0.0; 3]] {
            assert_eq!(
                lagrange(1.0, omega, upright())?.0,
                Nutation::Sleeping { stable: false }
            );
            assert_eq!(lagrange(1.0, omega, hanging())?.0, Nutation::Hanging);
            for attitude in [tilted, level()] {
                let (kind, [first, later]) = lagrange(1.0, omega, attitude)?;
                assert_eq!(kind, Nutation::PlanePendulum);
                assert!(first.omega.norm() < 1e-15);
                assert!(later.omega.norm() > 0.1);
            }
            // Weightless and at rest, it stays as it is.
            let (kind, [first, later]) = lagrange(0.0, omega, tilted)?;
            assert_eq!((kind, first), (Nutation::Spinning, later));
        }
        Ok(())
    }

    #[test]
    fn a_negative_zero_is_a_zero() -> Result<()> {
        let turn = |x: f64| Attitude::from_quaternion(2.0, 1.0, x, x).expect("a quaternion");
        for omega in [[0.0, 0.0, 3.0], [0.5, 0.0, 0.0], [0.0, 0.7, 0.0]] {
            let signed = omega.map(|x: f64| if x == 0.0 { -0.0 } else { x });
            for weight in [1.0, -1.0, 0.0] {
                let plain = LagrangeTop::new(1.0, 0.5, weight, vector(omega), turn(0.0))?;
                let other = LagrangeTop::new(1.0, 0.5, weight, vector(signed), turn(-0.0))?;
                assert_eq!(plain.kind(), other.kind());
                for t in [0.0, -0.0, 7.0] {
                    assert_eq!(plain.at(t)?, other.at(t)?);
                }
            }
        }
        Ok(())
    }

    #[test]
    fn what_is_no_body_is_named() {
        let refused = |body: [f64; 3], omega: [f64; 3]| {
            LagrangeTop::new(body[0], body[1], body[2], vector(omega), level())
                .expect_err("refused")
        };
        assert!(matches!(
            refused([0.0, 0.0, 1.0], [1.0; 3]),
            Error::NotPositive { .. }
        ));
        assert!(matches!(
            refused([-1.0, 0.5, 1.0], [1.0; 3]),
            Error::NotPositive { .. }
        ));
        assert!(matches!(
            refused([1.0, -0.5, 1.0], [1.0; 3]),
            Error::Negative { .. }
        ));
        assert!(matches!(
            refused([1.0, 2.1, 1.0], [1.0; 3]),
            Error::TriangleInequality { .. }
        ));
        for bad in BAD {
            for k in 0..3 {
                let (mut body, mut omega) = ([1.0, 0.5, 1.0], [1.0; 3]);
                body[k] = bad;
                assert!(matches!(refused(body, omega), Error::NotFinite { .. }));
                omega[k] = bad;
                assert!(matches!(
                    refused([1.0, 0.5, 1.0], omega),
                    Error::NotFinite { .. }
                ));
            }
            assert!(matches!(
                Attitude::from_quaternion(bad, 1.0, 0.0, 0.0),
                Err(Error::NotFinite { .. })
            ));
        }
        assert!(matches!(
            refused([1.0, 0.5, 1.0], [0.0, 1.7e308, 0.0]),
            Error::OutOfRange { .. }
        ));
    }

    #[test]
    fn a_needle_is_a_pendulum_whatever_its_spin() -> Result<()> {
        // I₃ = 0: L₃ = 0, and Ω₃ stays what it was.
        let needle = LagrangeTop::new(1.0, 0.0, 1.0, vector([0.3, 0.4, 50.0]), level())?;
        let pendulum = LagrangeTop::new(1.0, 0.0, 1.0, vector([0.3, 0.4, 0.0]), level())?;
        assert_eq!(needle.kind(), Nutation::SphericalPendulum);
        for t in [0.0, 1.0, 30.0] {
            let (spinning, still) = (needle.at(t)?, pendulum.at(t)?);
            assert!((spinning.height - still.height).abs() < 2e-15);
            assert_eq!(spinning.omega.z(), 50.0);
        }
        Ok(())
    }

    #[test]
    fn huge_and_tiny() -> Result<()> {
        let tilted = Attitude::from_quaternion(2.0, 1.0, 0.0, 0.0)?;
        for size in [1e300, 1e-300, f64::MIN_POSITIVE, 5e-324] {
            // The unit of mass is nothing to the motion as long as the numbers have their digits.
            let top = LagrangeTop::new(size, 0.5 * size, size, vector([0.0, 0.0, 3.0]), tilted)?;
            if size >= 1e-300 {
                let unit = LagrangeTop::new(1.0, 0.5, 1.0, vector([0.0, 0.0, 3.0]), tilted)?;
                assert!(top.at(5.0)?.attitude.angle_to(&unit.at(5.0)?.attitude) < 2e-15);
            }
            assert!(top.at(5.0)?.omega.is_finite());
            for omega in [[size, 0.0, 0.0], [0.0, size, size], [0.3, size, 0.4]] {
                let top = LagrangeTop::new(1.0, 0.5, 1.0, vector(omega), tilted)?;
                let state = top.at(1.0 / size.max(1.0))?;
                assert!(state.omega.is_finite() && state.height.abs() <= 1.0);
            }
        }
        Ok(())
    }

    #[test]
    fn gravity_that_is_next_to_nothing() -> Result<()> {
        // Mgl/I₁ underflows, and so the third root is beyond the doubles.
        let omega = vector([0.0, -0.65, 0.5]);
        let top = LagrangeTop::new(3.0, 0.0, 5e-324, omega, upright())?;
        assert_eq!(top.roots().h3, f64::INFINITY);
        assert!(top.at(3.0)?.omega.is_finite());
        Ok(())
    }

    #[test]
    fn a_time_no_digit_can_tell_is_refused() -> Result<()> {
        let top = LagrangeTop::new(1.0, 0.5, 1.0, vector([0.4, 0.1, 3.0]), level())?;
        for t in [1e18, -1e18, f64::MAX] {
            assert!(matches!(
                top.at(t),
                Err(Error::OutOfRange {
                    quantity: "the time",
                    ..
                })
            ));
        }
        for t in BAD {
            assert!(matches!(top.at(t), Err(Error::NotFinite { .. })));
        }
        assert!(top.at(1e15)?.height.abs() <= 1.0);
        assert!(top.at(5e-324)?.height.abs() < 3e-16);
        Ok(())
    }

    #[test]
    fn special_motions_name_what_they_refuse() {
        for bad in BAD {
            for k in 0..4 {
                let mut x = [1.0, 1.0, 3.0, 0.5];
                x[k] = bad;
                assert!(matches!(
                    pure_precession(x[0], x[1], x[2], x[3]),
                    Err(Error::NotFinite { .. })
                ));
                assert!(fast_spin(x[0], x[1], x[2], x[3]).is_err());
                assert!(dip(x[0], x[1], x[2], x[3]).is_err());
                assert!(tilt_after_kick(x[0], x[1], x[2], x[3]).is_err());
            }
            assert!(sleeping_threshold(1.0, bad, 1.0).is_err());
            assert!(pendulum_between(bad, 1.0, 1.0).is_err() && apsides(0.1, bad).is_err());
        }
        assert!(matches!(
            pure_precession(1.0, 1.0, 3.0, 1.1),
            Err(Error::OutOfRange { .. })
        ));
        assert!(matches!(
            fast_spin(1.0, 1.0, 0.0, 0.5),
            Err(Error::Condition { .. })
        ));
        assert!(matches!(
            dip(1.0, 0.0, 1.0, 0.5),
            Err(Error::NotPositive { .. })
        ));
        for tilt in [0.0, std::f64::consts::PI, -0.5] {
            assert!(dip(1.0, 1.0, 1.0, tilt).is_err(), "let go at {tilt}");
        }
        assert!(
            apsides(0.0, 0.1).is_err(),
            "a plane pendulum has no ellipse"
        );
        assert!(apsides(0.2, 0.1).is_err() && apsides(1.0, 3.0).is_err());
        assert_eq!(sleeping_threshold(1.0, 0.5, 0.0), Ok(0.0));
        assert_eq!(pure_precession(1.0, 0.0, 0.0, 0.0), Ok(PurePrecession::Any));
        assert_eq!(tilt_after_kick(1.0, 1.0, 1.0, 0.0), Ok(0.0));
    }
}

mod eulers_top {
    use super::*;

    #[test]
    fn at_rest_it_stays() -> Result<()> {
        for zero in [ZERO, [-0.0; 3]] {
            for moments in [[1.0, 2.0, 2.5], [1.0; 3], ZERO, [0.0, 1.0, 1.0]] {
                let top = EulerTop::new(moments, vector(zero), level())?;
                let state = top.at(1e18)?;
                assert_eq!(state.omega.norm(), 0.0);
                assert_eq!(state.attitude, level());
            }
        }
        Ok(())
    }

    #[test]
    fn what_is_no_body_is_named() {
        let refused = |i: [f64; 3], l: [f64; 3]| {
            EulerTop::new(i, vector(l), level()).expect_err("no body, or no start")
        };
        assert!(matches!(refused(ZERO, [1.0; 3]), Error::Condition { .. }));
        assert!(matches!(
            refused([0.0, 1.0, 1.0], [1.0; 3]),
            Error::Condition { .. }
        ));
        assert!(matches!(
            refused([1.0, 2.0, -2.0], [1.0; 3]),
            Error::Negative { .. }
        ));
        for bad in BAD {
            for k in 0..3 {
                let (mut i, mut l) = ([1.0, 2.0, 2.5], [1.0; 3]);
                i[k] = bad;
                assert!(matches!(refused(i, l), Error::NotFinite { .. }));
                l[k] = bad;
                assert!(matches!(
                    refused([1.0, 2.0, 2.5], l),
                    Error::NotFinite { .. }
                ));
            }
        }
    }

    #[test]
    fn long_times() -> Result<()> {
        let top = EulerTop::new([1.0, 2.0, 2.5], vector([0.3, 0.8, 0.4]), level())?;
        for t in BAD {
            assert!(matches!(top.at(t), Err(Error::NotFinite { .. })));
        }
        assert!(matches!(top.at(f64::MAX), Err(Error::OutOfRange { .. })));
        match top.at(1e18) {
            Ok(state) => assert!(state.omega.is_finite()),
            Err(error) => assert!(matches!(error, Error::OutOfRange { .. })),
        }
        assert_eq!(
            EulerTop::new([1.0; 3], vector(ZERO), level())?.regime(),
            Regime::AtRest
        );
        Ok(())
    }
}

mod kovalevskayas_top {
    use super::*;

    const MOMENTS: [f64; 3] = [2.0, 2.0, 1.0];

    fn made(lever: [f64; 3], omega: [f64; 3], up: [f64; 3]) -> Result<KovalevskayaTop> {
        KovalevskayaTop::with_up(MOMENTS, vector(lever), vector(omega), vector(up))
    }

    #[test]
    fn other_moments_are_another_top() {
        let with = |moments: [f64; 3]| {
            KovalevskayaTop::new(
                moments,
                vector([1.0, 0.0, 0.0]),
                vector([1.0, 0.5, 0.3]),
                level(),
            )
        };
        for moments in [
            [1.9, 1.9, 1.0],
            [2.0, 1.0, 1.0],
            [2.0, 2.0, 2.0],
            [1.0, 2.0, 2.0],
        ] {
            assert!(matches!(with(moments), Err(Error::Condition { .. })));
        }
        for k in 0..3 {
            let mut moments = MOMENTS;
            for zero in [0.0, -0.0, -1.0] {
                moments[k] = zero;
                assert!(matches!(with(moments), Err(Error::NotPositive { .. })));
            }
            for bad in BAD {
                moments[k] = bad;
                assert!(matches!(with(moments), Err(Error::NotFinite { .. })));
            }
        }
        for size in [1e300, 1e-300, f64::MIN_POSITIVE] {
            let rescaled = with(MOMENTS.map(|i| i * size));
            match rescaled {
                Ok(top) => assert!(top.at(0.0).is_ok_and(|s| s.omega.is_finite())),
                Err(error) => assert!(matches!(
                    error,
                    Error::NotFinite { .. } | Error::OutOfRange { .. }
                )),
            }
        }
    }

    #[test]
    fn levers_off_the_plane_or_none() -> Result<()> {
        let (omega, up) = ([1.0, 0.5, 0.3], [0.6, 0.0, 0.8]);
        for off in [0.1, -1e-300, 5e-324] {
            assert!(matches!(
                made([1.0, 0.0, off], omega, up),
                Err(Error::Condition { .. })
            ));
        }
        for zero in [0.0, -0.0] {
            let top = made([zero; 3], omega, up)?;
            assert_eq!(
                (top.kind(), top.method()),
                (Kind::EulerSymmetric, Method::FreeTop)
            );
            assert!(top.at(1e12)?.omega.is_finite());
            assert!(made([1.0, zero, zero], omega, up).is_ok());
        }
        // Gravity upwards, or C on the other side: the same top turned by half a turn.
        let (plain, turned) = (
            made([1.0, 0.0, 0.0], omega, up)?,
            made([-1.0, 0.0, 0.0], [-1.0, -0.5, 0.3], [-0.6, 0.0, 0.8])?,
        );
        for t in [0.0, 3.0, 50.0] {
            let (a, b) = (plain.omega_and_up(t)?, turned.omega_and_up(t)?);
            assert!((a.omega.x() + b.omega.x()).abs() < 1e-12);
            assert!((a.up.z() - b.up.z()).abs() < 1e-12);
        }
        Ok(())
    }

    #[test]
    fn at_rest_on_the_way_up_and_down() -> Result<()> {
        for zero in [ZERO, [-0.0; 3]] {
            for (up, stays) in [
                ([1.0, 0.0, 0.0], true),
                ([-1.0, 0.0, 0.0], true),
                ([0.0, 1.0, 0.0], false),
                ([0.0, 0.0, 1.0], false),
                ([0.0, 0.0, -1.0], false),
            ] {
                let top = made([1.0, 0.0, 0.0], zero, up)?;
                let state = top.at(3.0)?;
                assert_eq!(state.omega.norm() < 1e-14, stays, "{up:?}: {state:?}");
            }
            let still = made(ZERO, zero, [0.0, 0.6, 0.8])?;
            assert_eq!(still.at(1e18)?.omega.norm(), 0.0);
        }
        Ok(())
    }

    #[test]
    fn no_number_and_no_vertical() -> Result<()> {
        let (lever, omega, up) = ([1.0, 0.0, 0.0], [1.0, 0.5, 0.3], [0.6, 0.0, 0.8]);
        for bad in BAD {
            for k in 0..3 {
                let put = |mut x: [f64; 3]| {
                    x[k] = bad;
                    x
                };
                for top in [
                    made(put(lever), omega, up),
                    made(lever, put(omega), up),
                    made(lever, omega, put(up)),
                ] {
                    assert!(matches!(top, Err(Error::NotFinite { .. })));
                }
            }
            let top = made(lever, omega, up)?;
            assert!(matches!(top.at(bad), Err(Error::NotFinite { .. })));
            assert!(matches!(
                top.omega_and_up(bad),
                Err(Error::NotFinite { .. })
            ));
        }
        assert!(matches!(
            made(lever, omega, ZERO),
            Err(Error::ZeroVector { .. })
        ));
        let top = made(lever, omega, up)?;
        for t in [1e18, f64::MAX] {
            assert!(matches!(top.omega_and_up(t), Err(Error::OutOfRange { .. })));
            assert!(matches!(top.at(t), Err(Error::OutOfRange { .. })));
        }
        Ok(())
    }
}

/// Every bit pattern a double can have, moderate numbers, and the extremes more often than chance would have them.
fn any() -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => prop::num::u64::ANY.prop_map(f64::from_bits),
        3 => -10.0..10.0_f64,
        2 => (-1.0..1.0_f64, -1074..1024_i32).prop_map(|(x, e)| x * 2f64.powi(e / 2) * 2f64.powi(e - e / 2)),
        3 => prop::sample::select(vec![
            0.0, -0.0, 1.0, -1.0, 0.5, 2.0, 4.0, 1.0 + f64::EPSILON, 1.0 - f64::EPSILON, f64::MAX, f64::MIN,
            f64::MIN_POSITIVE, -f64::MIN_POSITIVE, 5e-324, -5e-324, 1e300, -1e300, 1e-300, 1e150, 1e-150, 1e18, 1e9,
            f64::INFINITY, f64::NEG_INFINITY, f64::NAN,
        ]),
    ]
}

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

proptest! {
    #![proptest_config(many(4000))]

    #[test]
    fn any_euler_top(i in moments(), l in any3(), start in attitude(), t in any()) {
        let tops = [EulerTop::new(i, vector(l), start), EulerTop::from_omega(i, vector(l), start)];
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
            let r = top.roots();
            prop_assert!(no_nan(&[r.h1, r.h2, r.h3, r.third_less_one, top.period()]), "{top:?}");
            prop_assert!(no_nan(&r.one_less) && no_nan(&r.one_more), "{top:?}");
            prop_assert!(-1.0 <= r.h1 && r.h1 <= r.h2 && r.h2 <= 1.0 && r.h3 >= 1.0, "{top:?}");
            prop_assert!(no_nan(&[top.precession_per_nutation().unwrap_or(0.0), top.mean_precession_rate().unwrap_or(0.0)]), "{top:?}");
            for time in [t, 0.0] {
                let Ok(state) = top.at(time) else { continue };
                prop_assert!(time.is_finite() && state.omega.is_finite() && unit(&state.attitude), "{top:?} {time:e}: {state:?}");
                prop_assert!((-1.0..=1.0).contains(&state.height) && state.one_less >= 0.0 && state.one_more >= 0.0, "{top:?} {time:e}: {state:?}");
            }
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
            prop_assert!(no_nan(&[turn.advance, turn.small_swing]));
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
