//! The free top against a table of 32 digits: angular momentum, angular velocity and attitude, not invariants alone.
//!
//! `tests/reference/free_top.py` says how the table was made and by which two routes. The inputs are exact numbers, so
//! whatever differs is the library's error, at any time.

use std::collections::BTreeMap;

use spinning_bodies::Result;
use spinning_bodies::euler_top::{EulerTop, State};
use spinning_bodies::frame::{Attitude, BodyVector, SpaceVector};
use support::{greatest, observed, refused, vector};

use support::double_double::Dd;
use support::table::{angle, apart, lines};

/// The body. Some well-known examples have moments that no body has: `new` must say so, and the motion follows
/// from Euler's equations all the same.
fn top(moments: [f64; 3], l: [f64; 3]) -> Result<EulerTop> {
    let (l, start) = (vector(l), Attitude::identity());
    let mut sorted = moments;
    sorted.sort_by(f64::total_cmp);
    let top = EulerTop::new(moments, l, start);
    if sorted[0] + sorted[1] < sorted[2] * (1.0 - 1e-15) {
        refused!(top, TriangleInequality);
        return EulerTop::beyond_bodies(moments, l, start);
    }
    top
}

/// The state found, and the same among others of the same body: the last of 37, where the first 32 go side by side, and one of those.
fn states(top: &EulerTop, time: f64) -> Result<[State; 3]> {
    let part = |k| if k % 9 == 0 { 1.0 } else { 1e-3 * f64::from(k) };
    let times: Vec<f64> = (0..37).map(|k| time * part(k)).collect();
    let mut states = [State::default(); 37];
    top.states_at(&times, &mut states)?;
    Ok([top.at(time)?, states[18], states[36]])
}

/// |ΔL|/|L|, or |ΔΩ|/|Ω|; 0 for 0 against 0.
fn relative(found: BodyVector, exact: [Dd; 3]) -> f64 {
    let [x, y, z] = exact.map(Dd::value);
    let (off, size) = (apart(found, exact), x.hypot(y).hypot(z));
    if size == 0.0 { off } else { off / size }
}

const FLIPS: &str = include_str!("../reference/peers/flip_time.csv");

/// Bar for the attitude (radians), L and Ω, at any time, on either side of the separatrix and on it.
/// Observed: 9e-16, 4e-16, 4e-16, and 1.8e-15 for the attitude after 5·10¹⁶ turns of a body one unit in the last place from a sphere.
const BAR: f64 = 2e-15;

/// In a batch of times the states are those of single calls to the last bit.
// claim: C6.6-9
#[test]
fn free_top_against_the_table() {
    let mut rows = 0;
    for cells in lines(include_str!("../reference/free_top.csv")) {
        let told = format!("row {} ({})", cells.text(0), cells.text(1));
        let (moments, [time]) = (cells.exact(2), cells.exact(8));
        let top = top(moments, cells.exact(5));
        let [state, beside, last] = top.and_then(|top| states(&top, time)).expect(&told);
        assert_eq!([beside, last], [state; 2], "{told}");
        let (l, attitude): ([Dd; 3], _) = (cells.decimals(9), cells.decimals(12));
        // A rod has no component of L along itself and is taken not to turn about itself.
        let omega = [0, 1, 2].map(|k| match moments[k] {
            0.0 => Dd::ZERO,
            moment => l[k] / moment,
        });
        let errors = [
            angle(&state.attitude, attitude),
            relative(state.angular_momentum, l),
            relative(state.omega, omega),
        ];
        observed!(greatest(errors), 6e-16..=BAR, "{told}");
        rows += 1;
    }
    assert_eq!(rows, 998);
}

/// The racket of 6.3 turns over in half a period of Ω: from a tilt of 0.1 to one of 1e-300, beside what other libraries make of it.
#[test]
fn flip_times_against_the_table() -> Result<()> {
    let mut rows = 0;
    for cells in lines(FLIPS).filter(|cells| cells.text(0) == "exact") {
        let ([tilt], [exact]) = (cells.numbers(2), cells.decimals(3));
        let start = BodyVector::new(tilt, 1.0, tilt);
        let top = EulerTop::from_omega([1.0, 2.0, 3.0], start, Attitude::identity())?;
        let error = (Dd::from(0.5 * top.period()) - exact).value().abs() / exact.value();
        // Observed 8.3e-17, which is a correctly rounded period.
        observed!(error, 0.0..=2e-16, "tilt {tilt:e}: {error:e}");
        rows += 1;
    }
    assert_eq!(rows, 44);
    Ok(())
}

/// The squares of these tilts are below the least double, or lose digits there; up to 2⁵³ quarter periods a state is a state all the same.
#[test]
fn next_to_the_middle_axis_to_the_last_time_that_is_admitted() -> Result<()> {
    for tilt in [1e-140, 1e-155, 1e-161, 1e-170, 1e-250, 1e-300] {
        let start = BodyVector::new(tilt, 1.0, tilt);
        let top = EulerTop::from_omega([1.0, 2.0, 3.0], start, Attitude::identity())?;
        for turns in [1e3, 1e13, 2e14, 3e14, 1e15, 1.8e15] {
            for part in 0..5 {
                let state = top.at((turns + 0.23 * f64::from(part)) * top.period())?;
                let energy = 0.5 * state.omega.dot(&state.angular_momentum);
                let l = state.attitude.to_space(state.angular_momentum)
                    - SpaceVector::new(0.0, 2.0, 0.0);
                let kept = (energy - 1.0).abs() < 1e-15 && l.norm() < 4e-15;
                assert!(kept, "{tilt:e} {turns:e}: {state:?}");
            }
        }
    }
    Ok(())
}

/// The committed measurements say what the figure of the flip time says: every peer has lost it, to 1e-3, by a tilt of 1e-8.
#[test]
fn every_peer_loses_the_flip_by_a_tilt_of_1e_8() {
    let mut lost: BTreeMap<&str, f64> = BTreeMap::new();
    for cells in lines(FLIPS) {
        let [tilt, _, error] = cells.numbers(2);
        let entry = lost.entry(cells.text(0)).or_insert(0.0);
        // A refusal is a NaN in the table and counts as lost.
        if error.is_nan() || error > 1e-3 {
            *entry = entry.max(tilt);
        }
    }
    assert_eq!(lost.remove("exact"), Some(0.0));
    assert_eq!(lost.len(), 7);
    for (library, tilt) in lost {
        assert!((0.9e-8..1.1e-7).contains(&tilt), "{library}: {tilt:e}");
    }
}
