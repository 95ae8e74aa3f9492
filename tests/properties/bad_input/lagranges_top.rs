//! Lagrange's top.

use super::*;
use support::{near, refused};

#[test]
fn pivot_at_the_centre_of_mass_is_a_free_top() -> Result<()> {
    let omega = vector([0.7, -0.4, 3.0]);
    let tilted = Attitude::from_quaternion(0.9, 0.3, 0.2, 0.1)?;
    for weightless in [0.0, -0.0] {
        let top = LagrangeTop::new(1.0, 0.5, weightless, omega, tilted)?;
        assert_eq!(top.roots().h3, f64::INFINITY);
    }
    let (kind, states) = lagrange(0.0, [0.0, 0.0, 3.0], tilted)?;
    assert_eq!(kind, Nutation::Spinning);
    let stays = |s: &State| s.omega == BodyVector::new(0.0, 0.0, 3.0);
    assert!(states.iter().all(stays));
    Ok(())
}

#[test]
fn gravity_upwards_is_the_same_top_upside_down() -> Result<()> {
    for omega in [ZERO, [0.0, 0.0, 3.0]] {
        assert_eq!(lagrange(-1.0, omega, upright())?.0, Nutation::Hanging);
        let stable = omega == [0.0, 0.0, 5.0];
        let (kind, _) = lagrange(-1.0, omega, hanging())?;
        assert_eq!(kind, Nutation::Sleeping { stable });
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
            let stable = spin == -7.0;
            let expected = match height {
                1.0 => Nutation::Sleeping { stable },
                _ => Nutation::Hanging,
            };
            assert_eq!(kind, expected, "at rest or spinning, the axis stays");
            let stays = |s: &State| (s.height, s.omega.z()) == (height, spin);
            assert!(states.iter().all(stays));
        }
        // Kicked, it leaves the pole and comes back to it.
        for spin in [0.0, 1.0, -7.0] {
            let omega = vector([0.3, 0.0, spin]);
            let top = LagrangeTop::new(1.0, 0.5, 1.0, omega, attitude)?;
            assert_eq!(top.at(0.0)?.height, height);
            let away = top.at(0.5 * top.period())?;
            let back = top.at(top.period())?;
            // Without spin the upright one falls through the bottom; the other swings.
            assert!((away.height - height).abs() > 1e-3, "{height} {spin}");
            assert!((back.height - height).abs() < 1e-15);
        }
    }
    Ok(())
}

#[test]
fn at_rest_it_falls_unless_upright_or_hanging() -> Result<()> {
    let tilted = Attitude::from_quaternion(2.0, 1.0, 0.0, 0.0)?;
    let turned = Attitude::from_quaternion(0.5, 0.0, 0.2, 0.9)?;
    for omega in [ZERO, [-0.0; 3]] {
        let ((kind, _), stable) = (lagrange(1.0, omega, upright())?, false);
        assert_eq!(kind, Nutation::Sleeping { stable });
        assert_eq!(lagrange(1.0, omega, hanging())?.0, Nutation::Hanging);
        for attitude in [tilted, level()] {
            let (kind, [first, later]) = lagrange(1.0, omega, attitude)?;
            assert_eq!(kind, Nutation::PlanePendulum);
            assert!(first.omega.norm() < 1e-15);
            assert!(later.omega.norm() > 0.1);
        }
        // Weightless and at rest, it stays as it is.
        for attitude in [tilted, level(), turned] {
            let (kind, [first, later]) = lagrange(0.0, omega, attitude)?;
            assert_eq!((kind, first), (Nutation::Spinning, later));
            let roots = LagrangeTop::new(1.0, 0.5, 0.0, vector(omega), attitude)?.roots();
            near!(roots.h1, first.height, 3e-16);
            near!(roots.h2, first.height, 3e-16);
        }
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
    let top = |[across, along, weight]: [f64; 3], omega: [f64; 3]| {
        LagrangeTop::new(across, along, weight, vector(omega), level())
    };
    refused!(top([0.0, 0.0, 1.0], [1.0; 3]), NotPositive);
    refused!(top([-1.0, 0.5, 1.0], [1.0; 3]), NotPositive);
    refused!(top([1.0, -0.5, 1.0], [1.0; 3]), Negative);
    refused!(top([1.0, 2.1, 1.0], [1.0; 3]), TriangleInequality);
    for bad in spoiled([1.0, 0.5, 1.0]) {
        refused!(top(bad, [1.0; 3]), NotFinite);
        refused!(top([1.0, 0.5, 1.0], bad), NotFinite);
    }
    for [w, x, y, z] in spoiled([1.0, 1.0, 0.0, 0.0]) {
        refused!(Attitude::from_quaternion(w, x, y, z), NotFinite);
    }
    refused!(top([1.0, 0.5, 1.0], [0.0, 1.7e308, 0.0]), OutOfRange);
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
        refused!(top.at(t), OutOfRange, "the time");
    }
    for t in BAD {
        refused!(top.at(t), NotFinite);
    }
    assert!(top.at(1e15)?.height.abs() <= 1.0);
    assert!(top.at(5e-324)?.height.abs() < 3e-16);
    Ok(())
}

#[test]
fn special_motions_name_what_they_refuse() {
    for [a, b, c, d] in spoiled([1.0, 1.0, 3.0, 0.5]) {
        refused!(pure_precession(a, b, c, d), NotFinite);
        assert!(fast_spin(a, b, c, d).is_err() && dip(a, b, c, d).is_err());
        assert!(tilt_after_kick(a, b, c, d).is_err());
    }
    for bad in BAD {
        assert!(sleeping_threshold(1.0, bad, 1.0).is_err());
        assert!(pendulum_between(bad, 1.0, 1.0).is_err() && apsides(0.1, bad).is_err());
    }
    refused!(pure_precession(1.0, 1.0, 3.0, 1.1), OutOfRange);
    refused!(fast_spin(1.0, 1.0, 0.0, 0.5), Condition);
    refused!(dip(1.0, 0.0, 1.0, 0.5), NotPositive);
    for tilt in [0.0, std::f64::consts::PI, -0.5, 4.0] {
        assert!(dip(1.0, 1.0, 1.0, tilt).is_err(), "let go at {tilt}");
    }
    // A plane pendulum has no ellipse.
    assert!(apsides(0.0, 0.1).is_err());
    assert!(apsides(0.2, 0.1).is_err() && apsides(1.0, 3.0).is_err());
    for (a, b) in [(0.0, 1.0), (1.0, 0.5), (1.5, 1.7)] {
        assert!(pendulum_between(a, b, 1.0).is_err());
    }
    for (inner, outer) in [(1.0, 0.5), (1.5, 1.7)] {
        let refused = pendulum_between(inner, outer, 1.0);
        let most = (std::f64::consts::PI - inner).next_down();
        assert!(
            matches!(refused, Err(Error::OutOfRange { least, greatest, .. }) if [least, greatest] == [inner, most])
        );
    }
    assert_eq!(sleeping_threshold(1.0, 0.5, 0.0), Ok(0.0));
    assert_eq!(pure_precession(1.0, 0.0, 0.0, 0.0), Ok(PurePrecession::Any));
    assert_eq!(tilt_after_kick(1.0, 1.0, 1.0, 0.0), Ok(0.0));
}
