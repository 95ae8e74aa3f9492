//! Problems that are none.

use lab::accuracy::{Model, Problem, Sample, candidates};
use spinning_bodies::Error;
use spinning_bodies::integrators::geometric::Phase;

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
    assert!(matches!(with(&[], 1.0), Err(Error::Empty { .. })));
    assert!(matches!(
        with(&[f64::NAN], 1.0),
        Err(Error::NotFinite { .. })
    ));
    assert!(matches!(
        with(&[f64::INFINITY], 1.0),
        Err(Error::NotFinite { .. })
    ));
    assert!(matches!(
        with(&[1.0], f64::NAN),
        Err(Error::NotFinite { .. })
    ));
    for times in [&[0.0][..], &[-1.0], &[1.0, 1.0], &[2.0, 1.0]] {
        assert!(
            matches!(with(times, 1.0), Err(Error::OutOfRange { .. })),
            "{times:?}"
        );
    }
    assert!(with(&[1.0, 2.0], 1.0).is_ok());
}

#[test]
fn moments_that_no_body_has_give_no_candidates() {
    for moments in [
        [1.0, 1.0, 3.0],
        [0.0, 1.0, 1.0],
        [f64::NAN, 1.0, 1.0],
        [-1.0, 1.0, 1.0],
    ] {
        let problem = Problem::new(
            "mine",
            top(moments, [0.0; 3]),
            START,
            1.0,
            vec![sample(1.0)],
        );
        assert!(candidates(&problem.unwrap()).is_err(), "{moments:?}");
    }
    let lever = [0.0, f64::NAN, 0.0];
    let problem = Problem::new("mine", top([1.0; 3], lever), START, 1.0, vec![sample(1.0)]);
    assert!(candidates(&problem.unwrap()).is_err());
    // Absurd numbers of turns are no reason to hang or to fail.
    for turns in [-1.0, 0.0, 1e300] {
        let truth = vec![sample(1.0)];
        let problem = Problem::new("mine", top([1.0, 2.0, 2.5], [0.0; 3]), START, turns, truth);
        assert!(candidates(&problem.unwrap()).is_ok());
    }
}
