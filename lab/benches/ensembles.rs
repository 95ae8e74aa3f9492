//! Many states of free tops in one run: of one body at many times, eight of them side by side and one by one; of many bodies.
//!
//! `cargo bench -p lab --bench ensembles`. Times are the least of several runs, in ns a state, on one core but for the last table. Ten
//! thousand bodies no longer fit a cache of the second level: what else the machine does then shows. So it does in the last table, which tells
//! nothing on a machine whose cores are busy.

mod shared;

use std::hint::black_box;

use lab::stopwatch::{in_turn, least};
use rayon::prelude::*;
use shared::{FREE_BODIES, head, numbers, only_tested};
use spinning_bodies::Result;
use spinning_bodies::euler_top::{EulerTop, State};
use spinning_bodies::frame::{Attitude, BodyVector};
use support::{Uniform, greatest, vector};

const COUNT: usize = 1000;

fn main() -> Result<()> {
    if only_tested() {
        return Ok(());
    }
    many_times()?;
    many_bodies()?;
    cores()
}

fn thrown(moments: [f64; 3], l: BodyVector) -> Result<EulerTop> {
    EulerTop::new(moments, l, Attitude::identity())
}

fn many_times() -> Result<()> {
    let title = format!("one body at {COUNT} times, ns a state");
    head(&title, &["one by one", "batch", "ratio", "differ, rad"]);
    for (name, moments, l, span) in FREE_BODIES {
        let top = thrown(moments, vector(l))?;
        let time = |k| span * (k as f64 + 0.5) / COUNT as f64;
        let times: Vec<f64> = (0..COUNT).map(time).collect();
        let mut alone = vec![State::default(); COUNT];
        let mut together = alone.clone();
        let seconds = in_turn([
            &mut || one_by_one(&top, black_box(&times), &mut alone),
            &mut || drop(black_box(&top).states_at(black_box(&times), &mut together)),
        ]);
        let [single, batch] = seconds.map(|seconds| 1e9 * seconds / COUNT as f64);
        let pairs = alone.iter().zip(&together);
        let differ = greatest(pairs.map(|(a, b)| a.attitude.angle_to(&b.attitude)));
        numbers(name, &[single, batch, batch / single, differ]);
    }
    Ok(())
}

fn one_by_one(top: &EulerTop, times: &[f64], states: &mut [State]) {
    for (t, state) in times.iter().zip(states) {
        if let Ok(found) = black_box(top).at(*t) {
            *state = found;
        }
    }
}

fn many_bodies() -> Result<()> {
    head(
        "as many bodies at one time, ns a state",
        &["prepared", "new and at"],
    );
    // Bodies of every kind of asymmetry, about every axis.
    let mut uniform = Uniform(6);
    let mut start = || {
        let [a, b, c] = [0; 3].map(|_| 0.2 + uniform.next());
        ([b + c, c + a, a + b], uniform.vector())
    };
    for count in [100, COUNT, 10_000, 100_000] {
        let starts: Vec<([f64; 3], BodyVector)> = (0..count).map(|_| start()).collect();
        let made = starts.iter().map(|&(moments, l)| thrown(moments, l));
        let tops: Vec<EulerTop> = made.collect::<Result<_>>()?;
        let seconds = in_turn([
            &mut || {
                for top in black_box(&tops) {
                    let _ = black_box(top.at(black_box(7.3)));
                }
            },
            &mut || {
                for &(moments, l) in black_box(&starts) {
                    let _ = black_box(thrown(moments, l).and_then(|top| top.at(black_box(7.3))));
                }
            },
        ]);
        numbers(
            &count.to_string(),
            &seconds.map(|seconds| 1e9 * seconds / count as f64),
        );
    }
    Ok(())
}

/// The same work on one core and on all. What threads cost each other: nothing that shows. In 40 million states, 1.79, 1.92 and 2.03 s of
/// processor time on one thread and 1.77, 1.80 and 1.97 s on two, in turn; so what is missing to the number of cores, other work has taken.
fn cores() -> Result<()> {
    const MANY: usize = 200_000;
    const PART: usize = 2_000;
    let (_, moments, l, _) = FREE_BODIES[0];
    let top = thrown(moments, vector(l))?;
    let times: Vec<f64> = (0..MANY).map(|k| 0.01 * k as f64).collect();
    let mut states = vec![State::default(); MANY];
    let work =
        |(times, states): (&[f64], &mut [State])| drop(black_box(top.states_at(times, states)));
    let one = least(|| {
        times
            .chunks(PART)
            .zip(states.chunks_mut(PART))
            .for_each(work)
    });
    let all = least(|| {
        times
            .par_chunks(PART)
            .zip(states.par_chunks_mut(PART))
            .for_each(work)
    });
    let title = format!("{} cores, ns a state", rayon::current_num_threads());
    head(&title, &["on one", "on all", "times as fast"]);
    let each = 1e9 / MANY as f64;
    numbers("", &[each * one, each * all, one / all]);
    Ok(())
}
