//! Problems that are none.

use lab::accuracy::{Model, Problem, Sample, candidates};
use spinning_bodies::Error;
use spinning_bodies::integrators::geometric::Phase;
use support::refused;

const START: Phase = Phase {
    l: [1.0, 2.0, 3.0],
    q: [1.0, 0.0, 0.0, 0.0],
};

fn sample(t: f64) -> Sample {
    Sample::new(t, [[1.0, 0.0]; 3], [[0.5, 0.0]; 4])
}

fn with(times: &[f64], turns: f64) -> Result<Problem, Error> {
    let truth = times.iter().map(|&t| sample(t)).collect();
    Problem::new("mine", top([1.0, 2.0, 2.5], [0.0; 3]), START, turns, truth)
}

fn top(moments: [f64; 3], lever: [f64; 3]) -> Model {
    Model::Top { moments, lever }
}

#[test]
fn bad_problems_are_refused() {
    refused!(with(&[], 1.0), Empty);
    for (time, turns) in [(f64::NAN, 1.0), (f64::INFINITY, 1.0), (1.0, f64::NAN)] {
        refused!(with(&[time], turns), NotFinite);
    }
    for times in [&[0.0][..], &[-1.0], &[1.0, 1.0], &[2.0, 1.0]] {
        refused!(with(times, 1.0), OutOfRange);
    }
    assert!(with(&[1.0, 2.0], 1.0).is_ok());
}

#[test]
fn moments_that_no_body_has_give_no_candidates() {
    let problem = |model| {
        let problem = Problem::new("mine", model, START, 1.0, vec![sample(1.0)]);
        candidates(&problem.unwrap())
    };
    for odd in [3.0, 0.0, f64::NAN, -1.0] {
        assert!(problem(top([1.0, 1.0, odd], [0.0; 3])).is_err(), "{odd}");
    }
    assert!(problem(top([1.0; 3], [0.0, f64::NAN, 0.0])).is_err());
    // Absurd numbers of turns are no reason to hang or to fail.
    for turns in [-1.0, 0.0, 1e300] {
        assert!(candidates(&with(&[1.0], turns).unwrap()).is_ok());
    }
}
