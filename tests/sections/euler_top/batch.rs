//! Many states at once (6.6, 6.8): those of one call at a time to the last bit, in whatever order and however many. That they are right, the
//! table of 32 digits says in `tests/hard_cases/free_top.rs`.

use super::*;

/// One body of each kind, and one whose axes are numbered the other way round.
fn tops() -> Vec<EulerTop> {
    let mut numbers = Uniform(66);
    use Regime::{AroundLargest, AroundSmallest, AtRest, PermanentRotation, Rod};
    use Regime::{Separatrix, Sphere, Symmetric};
    let kinds = [
        ([0.6, 0.8, 1.0], [1.8, 0.4, -0.9], AroundSmallest),
        ([0.8, 1.0, 0.6], [-0.4, 0.9, -0.3], AroundLargest),
        ([1.0, 3.0, 2.0], [1e-3, 3e-3, -2.0], AroundLargest),
        ([1.5, 3.0, 4.0], [1.0, 0.5, 2.0], Separatrix),
        ([1.0, 1.0, 1.5], [0.3, 0.4, 2.0], Symmetric),
        ([1.0, 1.0, 1.0], [0.3, 0.4, 2.0], Sphere),
        ([0.0, 1.0, 1.0], [0.0, 0.4, 2.0], Rod),
        ([1.0, 2.0, 3.0], [0.0, 2.0, 0.0], PermanentRotation),
        ([1.0, 2.0, 3.0], [0.0, 0.0, 0.0], AtRest),
        // In ratios of 10²⁰⁰.
        ([1.0, 2.0, 3.0], [1e-200, 1e-200, 2.0], AroundLargest),
    ];
    kinds
        .into_iter()
        .map(|(moments, l, regime)| {
            let top = EulerTop::new(moments, vector(l), numbers.attitude()).unwrap();
            assert_eq!(top.regime(), regime);
            top
        })
        .collect()
}

/// Some of the times beyond what goes side by side.
#[test]
fn s6_6_many_times_at_once() {
    for top in tops() {
        for count in [0, 1, 31, 32, 33, 100] {
            let far = |k| if k % 5 == 4 { 1e9 } else { -50.0 };
            let times: Vec<f64> = (0..count).map(|k| 7.3 * f64::from(k) + far(k)).collect();
            let mut states = vec![State::default(); times.len()];
            top.states_at(&times, &mut states).unwrap();
            let alone = top.states(times.clone()).map(Result::unwrap);
            assert!(alone.eq(states.clone()));
            for (t, state) in times.iter().zip(&states) {
                assert_eq!(top.at(*t).unwrap(), *state);
                assert_eq!(top.omega_at(*t).unwrap(), state.omega);
            }
        }
    }
}

#[test]
fn s6_6_what_a_batch_refuses() {
    for top in tops() {
        let mut states = [State::default(); 3];
        refused!(top.states_at(&[0.0, 1.0], &mut states), Condition);
        for t in [f64::NAN, f64::INFINITY] {
            refused!(top.states_at(&[0.0, t, 1.0], &mut states), NotFinite);
        }
    }
    let top = tops()[0];
    let mut states = [State::default(); 2];
    refused!(top.states_at(&[0.0, 1e300], &mut states), OutOfRange);
}
