//! What cannot be followed is refused with a reason, and never with a panic.

use super::*;
use spinning_bodies::integrators::Stop;

#[test]
fn numbers_that_are_none() {
    for method in all_methods() {
        let refused = |phase: Phase, time: f64, step: f64| {
            let run = method.follow(&phase, &[time], Effort::Step(step));
            assert!(run.is_err(), "{}", method.name());
        };
        for bad in [f64::NAN, f64::INFINITY] {
            let (mut momentum, mut attitude) = (start(), start());
            momentum.l[1] = bad;
            attitude.q[2] = bad;
            refused(momentum, 1.0, 0.1);
            refused(attitude, 1.0, 0.1);
            refused(start(), bad, 0.1);
        }
        for bad in [f64::NAN, f64::INFINITY, 0.0, -1.0] {
            refused(start(), 1.0, bad);
        }
    }
}

#[test]
fn extremes_neither_hang_nor_panic() {
    for method in all_methods() {
        for scale in [0.0, 1e-300, 1e-150, 1e150, 1e300] {
            let mut phase = start();
            phase.l = phase.l.map(|x| x * scale);
            // A number or an error; both are fine.
            if let Ok(course) = method.follow(&phase, &[1.0], Effort::Step(0.1)) {
                assert_eq!(course.states.len(), 1);
                let end = course.states[0];
                let finite = end.l.iter().chain(&end.q).all(|x| x.is_finite());
                assert!(finite, "{} {scale:e}", method.name());
            }
        }
    }
}

#[test]
fn a_step_too_long_for_an_implicit_method_is_refused() {
    let method = MoserVeselov::new(MOMENTS, VeselovOrder::Ten).unwrap();
    let run = method.start(&start(), 50.0).and_then(|mut s| s.step());
    refused!(run, Integration);
    let no_body = FreeSplitting::new([1.0, 1.0, 3.0], Order::Two);
    refused!(no_body, TriangleInequality);
    assert!(Weight::new([0.0, f64::NAN, 0.0]).is_err());
}

/// A step is asked for, where steps have one length.
#[test]
fn a_tolerance_is_refused() {
    let method = FreeSplitting::new(MOMENTS, Order::Two).unwrap();
    let run = method.follow(&start(), &[1.0], Effort::Tolerance(1e-6));
    refused!(run, Solver);
}

/// A quaternion is a direction: its length is nobody's torque.
#[test]
fn the_length_of_the_quaternion_does_not_matter() {
    let mut methods = all_methods();
    methods.extend(heavy_methods_of(MOMENTS, [0.3, 0.1, 1.0]));
    for method in methods {
        let of = |length: f64| {
            let mut phase = start();
            phase.q = phase.q.map(|x| x * length);
            method.follow(&phase, &[1.0], Effort::Step(0.1))
        };
        let [plain, long, short, huge] =
            [1.0, 3.0, 2f64.powi(-700), 2f64.powi(700)].map(|length| of(length).unwrap().states[0]);
        // Observed: 6e-16.
        close_to(&long, &plain, 3e-15, method.name());
        assert_eq!([short, huge], [plain; 2], "{}", method.name());
        assert!(of(0.0).is_err(), "{}", method.name());
    }
}

/// Units that are powers of two change no bit, as long as the numbers themselves are doubles. The last, a general method of the laboratory, is left out.
#[test]
fn units_do_not_matter() {
    let ends = |unit: f64, beat: f64| -> Vec<[f64; 4]> {
        let mut phase = start();
        phase.l = phase.l.map(|x| x * (unit / beat));
        let all = free_methods_of(MOMENTS.map(|i| i * unit));
        let end = |method: &dyn Follow| after(method, &phase, beat, 0.0625 * beat).q;
        all.iter().take(9).map(|method| end(&**method)).collect()
    };
    let far = [(300, 0), (-300, 0), (0, 300), (0, -300), (400, 200)];
    for [unit, beat] in far.map(|(unit, beat)| [unit, beat].map(|n| 2f64.powi(n))) {
        assert_eq!(ends(unit, beat), ends(1.0, 1.0), "{unit:e} {beat:e}");
    }
}

/// An event that leaps from one infinity to the other is found as any other leap, and a component that neither moves nor has a scale stops no step.
#[test]
fn infinite_events_and_components_without_a_scale() -> Result<()> {
    let swing = |_: f64, y: &[f64; 2]| [y[1], -y[0]];
    let leap = |t: f64, _: &[f64; 2]| f64::INFINITY.copysign(2.0 - t);
    let run = leg(&swing, (&[1.0, 0.0], &[1.0; 2]), (&[], 5.0));
    let passage = run.follow(Some(&leap), Effort::Tolerance(1e-12))?;
    near!(passage.time, 2.0, 0.0..=1e-15);
    assert_eq!(passage.stopped, Stop::AtTheEvent);
    let aside = |_: f64, y: &[f64; 2]| [-y[0], 0.0];
    let run = leg(&aside, (&[1.0, 0.0], &[0.0; 2]), (&[], 1.0));
    let end = run.follow(None, Effort::Tolerance(1e-12))?.end;
    near!(end[0], (-1.0_f64).exp(), 1e-14..=2e-13);
    assert_eq!(end[1], 0.0);
    for scale in [f64::NAN, -1.0] {
        let scales = [1.0, scale];
        let run = leg(&aside, (&[1.0, 0.0], &scales), (&[], 1.0));
        let refused = run.follow(None, Effort::Tolerance(1e-12)).unwrap_err();
        let told = refused.to_string();
        assert!(told.starts_with("the scale of a component"), "{told}");
    }
    Ok(())
}
