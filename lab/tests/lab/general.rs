//! The adapter to the general integrators: samples in any order, events, orders of convergence, refusals.

use lab::general::Run;
use spinning_bodies::integrators::{Effort, Event, Method, Passage, Solution, Stop, System};
use spinning_bodies::{Error, Result};
use support::refused;

/// A pendulum of length g: not linear, and its quarter period from 90 degrees is K(1/2) exactly.
fn pendulum(_: f64, y: &[f64; 2]) -> [f64; 2] {
    [y[1], -y[0].sin()]
}

const QUARTER: f64 = 1.854_074_677_301_371_9;
const START: [f64; 2] = [core::f64::consts::FRAC_PI_2, 0.0];

fn by(method: Method) -> Effort {
    match method {
        Method::Rk4 => Effort::Step(1e-3),
        // Of order 6; Newton's method leaves a rounding or two a step, so fewer are better.
        Method::Gauss => Effort::Step(1e-2),
        _ => Effort::Tolerance(1e-12),
    }
}

/// The pendulum at these times.
fn swung(times: &[f64], method: Method, effort: Effort) -> Result<Solution<[f64; 2]>> {
    Run::new(&pendulum, &[1.0; 2], method, effort).solve(&START, times)
}

/// Until the event, or to the last time.
fn ended(
    (system, start): (&dyn System<2>, [f64; 2]),
    (times, last): (&[f64], f64),
    event: &Event<'_, 2>,
    (by, effort): (Method, Effort),
) -> Passage<[f64; 2]> {
    let run = Run::new(system, &[1.0; 2], by, effort);
    run.until(0.0, &start, times, last, event).unwrap()
}

#[test]
fn samples_come_in_the_order_asked_for_before_and_after_the_start() {
    for method in Method::ALL {
        let times = [4.0, 0.0, -1.0, 1.0, -4.0, 1.0].map(|quarters| quarters * QUARTER);
        let run = swung(&times, method, by(method));
        let angles: Vec<f64> = run.unwrap().states.iter().map(|y| y[0]).collect();
        let expected = [START[0], START[0], 0.0, 0.0, START[0], 0.0];
        for (angle, expected) in angles.iter().zip(expected) {
            // Observed: 2e-13 (rk4), 1e-12 (gauss6), 1e-11 (dopri5), 2e-12 (dop853), 2e-13 (verner98).
            assert!((angle - expected).abs() < 5e-11, "{method:?}: {angles:?}");
        }
    }
}

#[test]
fn an_event_is_located_to_the_accuracy_of_the_run() {
    for method in Method::ALL {
        let falling = |_: f64, y: &[f64; 2]| y[0];
        let times = (&[0.5, 1.0, 5.0][..], 10.0);
        let by = (method, by(method));
        let run = ended((&pendulum, START), times, &falling, by);
        assert_eq!(run.stopped, Stop::AtTheEvent);
        assert_eq!(run.states.len(), 2);
        let error = (run.time - QUARTER).abs().max(run.end[0].abs());
        assert!(error < 5e-11, "{method:?}: {error:e}");
    }
}

#[test]
fn evaluations_are_those_made() {
    for method in Method::ALL {
        let made = std::cell::Cell::new(0_u64);
        let counted = |t: f64, y: &[f64; 2]| {
            made.set(made.get() + 1);
            pendulum(t, y)
        };
        let run = Run::new(&counted, &[1.0; 2], method, by(method));
        let told = run.solve(&START, &[1.0, 2.0]).unwrap().cost.evaluations;
        // Not told: Euler's steps over what rounding has left, one for each sample and the end.
        let untold = made.get() - told;
        assert!(untold <= 4, "{method:?}: {untold} {told}");
    }
}

#[test]
fn what_cannot_be_followed_is_refused() {
    let explodes = |_: f64, y: &[f64; 1]| [y[0] * y[0]];
    for method in [Method::Dopri5, Method::Dop853, Method::Verner98] {
        let run = Run::new(&explodes, &[1.0], method, by(method));
        let error = run.solve(&[1.0], &[2.0]).expect_err("it has no end");
        let told = matches!(error, Error::Integration { .. } | Error::NotFinite { .. });
        assert!(told, "{method:?}: {error:?}");
    }
    let run = swung(&[f64::NAN], Method::Rk4, Effort::Step(0.1));
    refused!(run, NotFinite);
    let run = swung(&[1.0], Method::Rk4, Effort::Tolerance(0.1));
    refused!(run, Integration);
}

#[test]
fn an_event_after_a_long_step_is_located_as_well() {
    // A stone: the estimate of the error is zero, the steps grow without bound, and dense output over such a step is poor.
    let stone = |_: f64, y: &[f64; 2]| [y[1], 1.1];
    let end = |_: f64, y: &[f64; 2]| 1.0 - y[0];
    let exact = (2.0_f64 / 1.1).sqrt();
    for method in [Method::Dopri5, Method::Dop853, Method::Verner98] {
        for last in [1.4, 2.0, 3.0, 5.0, 20.0, 1000.0] {
            for tolerance in [1e-3, 1e-6, 1e-10] {
                let by = (method, Effort::Tolerance(tolerance));
                let run = ended((&stone, [0.0; 2]), (&[], last), &end, by);
                assert_eq!(run.stopped, Stop::AtTheEvent);
                let error = (run.time - exact).abs().max((run.end[0] - 1.0).abs());
                // Observed: 2e-13 at the longest span, whose phase has that rounding.
                assert!(error < 1e-11, "{method:?} {last} {tolerance}: {error:e}");
            }
        }
    }
}

/// A stone thrown up from the ground at speed V: y = V t − t²/2 and V − t.
fn stone(_: f64, y: &[f64; 2]) -> [f64; 2] {
    [y[1], -1.0]
}

const V: f64 = 1.7;

#[test]
fn events_of_every_shape_are_located_to_rounding() {
    type Shape = fn(f64, &[f64; 2]) -> f64;
    let root = |height: f64| V + (V * V - 2.0 * height).sqrt();
    let shapes: [(&str, Shape, f64); 8] = [
        ("linear", |_, y| y[1] - 0.3, V - 0.3),
        ("quadratic, zero at the start", |_, y| y[0], 2.0 * V),
        ("quadratic, below it", |_, y| y[0] + 0.25, root(-0.25)),
        (
            "the least of two, near the corner",
            |_, y| (y[1] - 0.5).min(3.0 * (y[1] - 0.5) + 1e-9),
            V - 0.5,
        ),
        (
            "a corner at the zero itself",
            |t, _| if t < 1.2 { 1.2 - t } else { 50.0 * (1.2 - t) },
            1.2,
        ),
        ("a jump", |t, _| if t < 1.3 { 4.0 } else { -1e-6 }, 1.3),
        ("a cube, flat at its zero", |t, _| (1.25 - t).powi(3), 1.25),
        ("in the very first instant", |t, _| 1e-7 - t, 1e-7),
    ];
    for method in Method::ALL {
        for last in [4.0, 20.0] {
            for (name, shape, exact) in shapes {
                let by = (method, by(method));
                let run = ended((&stone, [0.0, V]), (&[], last), &shape, by);
                assert_eq!(run.stopped, Stop::AtTheEvent, "{method:?} {last} {name}");
                let error = (run.time - exact).abs();
                let y = exact * (V - 0.5 * exact);
                let off = (run.end[0] - y).abs().max((run.end[1] - V + exact).abs());
                let worst = error.max(off);
                assert!(worst < 2e-13, "{method:?} {last} {name}: {worst:e}");
            }
        }
    }
}

#[test]
fn what_does_not_fall_through_zero_is_no_event() {
    type Shape = fn(f64, &[f64; 2]) -> f64;
    let shapes: [(&str, Shape); 4] = [
        ("negative throughout", |_, _| -1.0),
        ("rising", |t, _| t - 1.0),
        ("zero throughout", |_, _| 0.0),
        ("zero at the start and falling", |t, _| -t),
    ];
    for method in Method::ALL {
        for (name, shape) in shapes {
            let by = (method, by(method));
            let run = ended((&stone, [0.0, V]), (&[], 4.0), &shape, by);
            assert_eq!(run.stopped, Stop::AtTheEnd, "{method:?} {name}");
        }
    }
}
