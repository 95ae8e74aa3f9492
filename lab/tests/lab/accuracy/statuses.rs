//! What a measurement says of its run, and what it asks of a clock.

use lab::accuracy::{
    Candidate, Measurement, Problem, Status, Trial, along_the_run, candidates, measure, named,
};
use spinning_bodies::integrators::Effort;

fn problem(name: &str) -> Problem {
    named(name).unwrap().remove(0)
}

fn candidate(problem: &Problem, name: &str) -> Candidate {
    let mut all = candidates(problem).unwrap();
    let place = all
        .iter()
        .position(|c| c.name == name)
        .expect("a method of this name");
    all.swap_remove(place)
}

fn once(problem: &Problem, name: &str, effort: Effort) -> Measurement {
    measure(problem, &candidate(problem, name), effort)
}

#[test]
fn a_step_too_long_diverges_and_a_wrong_effort_fails() {
    let free = problem("free-top/10");
    // Ten turns in one step.
    let coarse = once(&free, "rk4", Effort::Step(free.end()));
    assert_eq!(coarse.status, Status::Diverged);
    assert!(coarse.error_omega > 1.0 && coarse.evaluations > 0);
    let wrong = once(&free, "dop853", Effort::Step(0.1));
    assert_eq!(wrong.status, Status::Failed);
    assert_eq!(
        (wrong.error_attitude, wrong.error_omega),
        (f64::INFINITY, f64::INFINITY)
    );
    assert_eq!(
        (wrong.evaluations, wrong.steps, wrong.seconds),
        (0, 0, None)
    );
    let none = once(&free, "rotations-4", Effort::Step(0.0));
    assert_eq!(none.status, Status::Failed);
    let fine = once(&free, "rk4", Effort::Step(free.end() / 1024.0));
    assert_eq!(fine.status, Status::Ok);
    assert!(fine.error_attitude < 1e-4);
}

#[test]
fn rounding_is_called_the_floor_and_ends_the_sweep() {
    let free = problem("free-top/1");
    for name in ["rotations-6", "moser-veselov-10", "munthe-kaas-4", "rk4"] {
        let method = candidate(&free, name);
        let rows =
            Trial::of(&free, &method).sweep(|_, effort| Some(measure(&free, &method, effort)));
        let [.., before, last] = &rows[..] else {
            panic!("{name}: {rows:?}");
        };
        assert!(rows.len() < method.efforts.len(), "{name}");
        assert_eq!([before.status, last.status], [Status::Floor; 2], "{name}");
        let errors = rows.iter().map(|r| r.error_attitude);
        let best = errors.fold(f64::INFINITY, f64::min);
        println!("{name}: {best:e} in {} runs", rows.len());
        // Observed: 1.8e-16 … 6e-14 (rk4).
        assert!(best < 1e-13, "{name}: {best:e}");
        let ok = rows.iter().filter(|r| r.status == Status::Ok);
        assert!(ok.count() >= 4, "{name}");
    }
}

#[test]
fn a_sweep_stops_when_it_is_told_to() {
    let free = problem("free-top/10");
    let method = candidate(&free, "rotations-2");
    let mut asked = 0;
    let rows = Trial::of(&free, &method).sweep(|rows, next| {
        assert_eq!(rows.len(), asked);
        assert_eq!(next, method.efforts[asked]);
        asked += 1;
        (rows.len() < 5).then(|| measure(&free, &method, next))
    });
    assert_eq!((rows.len(), asked), (5, 6));
    assert!(Trial::of(&free, &method).sweep(|_, _| None).is_empty());
}

#[test]
fn a_clock_changes_nothing_but_the_time() {
    let free = problem("free-top/1");
    let method = candidate(&free, "rk4");
    let effort = Effort::Step(free.end() / 64.0);
    let timed_run = Trial::of(&free, &method).timed(effort);
    let time = timed_run.seconds.expect("a time");
    assert!((1e-8..1.0).contains(&time), "{time}");
    let untimed = Measurement {
        seconds: None,
        ..timed_run
    };
    assert_eq!(measure(&free, &method, effort), untimed);
    // What fails has no time.
    let wrong = Trial::of(&free, &method).timed(Effort::Tolerance(1e-9));
    assert_eq!((wrong.status, wrong.seconds), (Status::Failed, None));
}

#[test]
fn the_run_is_judged_along_the_way() {
    let nearly = problem("near-separatrix/10");
    let method = candidate(&nearly, "dop853");
    let effort = Effort::Tolerance(1e-9);
    let along = along_the_run(&nearly, &method, effort).unwrap();
    let end = measure(&nearly, &method, effort);
    // The last sample is the end, reached from the same step.
    assert!(along.attitude >= end.error_attitude, "{along:?} {end:?}");
    // Between, the flips are missed by more.
    let more = along.omega > 2.0 * end.error_omega;
    assert!(more, "{along:?} {end:?}");
}

#[test]
fn evaluations_are_counted_to_the_last() {
    let top = problem("cusped-top/10");
    let effort = Effort::Step(top.end() / 512.0);
    let rk4 = once(&top, "rk4", effort);
    // And one before the first step.
    assert_eq!((rk4.steps, rk4.evaluations), (512, 4 * 512 + 1));
    let kicks = once(&top, "kick-drift-2", effort);
    assert_eq!(kicks.steps, 512);
    println!("{kicks:?}");
}
