//! Many states of free tops in one run: of one body at many times, eight of them side by side and one by one; of many bodies.
//!
//! `cargo bench -p lab --bench ensembles`. Times are the least of several runs, in ns a state, on one core but for the last table. Ten
//! thousand bodies no longer fit a cache of the second level: what else the machine does then shows. So it does in the last table, which tells
//! nothing on a machine whose cores are busy.

mod shared;

use std::hint::black_box;

use rayon::prelude::*;
use shared::{FREE_BODIES, least, only_tested};
use spinning_bodies::euler_top::{EulerTop, State};
use spinning_bodies::frame::{Attitude, BodyVector};

const COUNT: usize = 1000;
const RUNS: usize = 60;

fn main() -> spinning_bodies::Result<()> {
    if only_tested() {
        return Ok(());
    }
    many_times()?;
    many_bodies()?;
    cores()
}

fn nanoseconds(count: usize, work: impl FnMut()) -> f64 {
    1e9 / count as f64 * least(RUNS, work)
}

fn many_times() -> spinning_bodies::Result<()> {
    println!("one body at {COUNT} times, ns a state");
    println!(
        "{:>20} {:>10} {:>8} {:>7} {:>12}",
        "body", "one by one", "batch", "ratio", "differ, rad"
    );
    for (name, moments, [x, y, z], span) in FREE_BODIES {
        let top = EulerTop::new(moments, BodyVector::new(x, y, z), Attitude::identity())?;
        let times: Vec<f64> = (0..COUNT)
            .map(|k| span * (k as f64 + 0.5) / COUNT as f64)
            .collect();
        let mut alone = vec![State::default(); COUNT];
        let mut together = alone.clone();
        let single = nanoseconds(COUNT, || {
            for (t, state) in black_box(&times).iter().zip(&mut alone) {
                if let Ok(found) = black_box(&top).at(*t) {
                    *state = found;
                }
            }
            black_box(&mut alone);
        });
        let batch = nanoseconds(COUNT, || {
            let _ = black_box(black_box(&top).states_at(black_box(&times), &mut together));
            black_box(&mut together);
        });
        println!(
            "{name:>20} {single:>10.1} {batch:>8.1} {:>7.3} {:>12.1e}",
            batch / single,
            furthest(&alone, &together)
        );
    }
    Ok(())
}

fn furthest(a: &[State], b: &[State]) -> f64 {
    a.iter()
        .zip(b)
        .map(|(a, b)| a.attitude.angle_to(&b.attitude))
        .fold(0.0, f64::max)
}

/// Numbers in 0…1 (Weyl's sequence).
fn number(k: usize, n: usize) -> f64 {
    const STEPS: [f64; 6] = [
        0.414_213_562_373_095_05,
        0.732_050_807_568_877_2,
        0.236_067_977_499_789_7,
        0.645_751_311_064_590_6,
        0.316_624_790_355_399_85,
        0.605_551_275_463_989_3,
    ];
    ((k + 1) as f64 * STEPS[n]).fract()
}

/// Bodies of every kind of asymmetry, about every axis.
fn starts(count: usize) -> Vec<([f64; 3], BodyVector)> {
    (0..count)
        .map(|k| {
            let masses = [0, 1, 2].map(|n| 0.2 + number(k, n));
            let moments = [
                masses[1] + masses[2],
                masses[2] + masses[0],
                masses[0] + masses[1],
            ];
            let [x, y, z] = [3, 4, 5].map(|n| 2.0 * number(k, n) - 1.0);
            (moments, BodyVector::new(x, y, z))
        })
        .collect()
}

fn many_bodies() -> spinning_bodies::Result<()> {
    let upright = Attitude::identity();
    println!("\nas many bodies at one time, ns a state");
    for count in [100, COUNT, 10_000, 100_000] {
        let starts = starts(count);
        let tops: Vec<EulerTop> = starts
            .iter()
            .map(|(moments, l)| EulerTop::new(*moments, *l, upright))
            .collect::<spinning_bodies::Result<_>>()?;
        let mut alone = vec![State::default(); count];
        let t = 7.3;
        let single = nanoseconds(count, || {
            for (top, state) in black_box(&tops).iter().zip(&mut alone) {
                if let Ok(found) = top.at(black_box(t)) {
                    *state = found;
                }
            }
            black_box(&mut alone);
        });
        let scratch = nanoseconds(count, || {
            for ((moments, l), state) in black_box(&starts).iter().zip(&mut alone) {
                if let Ok(found) =
                    EulerTop::new(*moments, *l, upright).and_then(|top| top.at(black_box(t)))
                {
                    *state = found;
                }
            }
            black_box(&mut alone);
        });
        for (name, time) in [("prepared", single), ("new and at", scratch)] {
            println!("{count:>8} {name:>30} {time:>10.1}");
        }
    }
    Ok(())
}

/// The same work on one core and on all. What threads cost each other: nothing that shows. In 40 million states, 1.79, 1.92 and 2.03 s of
/// processor time on one thread and 1.77, 1.80 and 1.97 s on two, in turn; so what is missing to the number of cores, other work has taken.
fn cores() -> spinning_bodies::Result<()> {
    const MANY: usize = 200_000;
    let (_, moments, [x, y, z], _) = FREE_BODIES[0];
    let top = EulerTop::new(moments, BodyVector::new(x, y, z), Attitude::identity())?;
    let times: Vec<f64> = (0..MANY).map(|k| 0.01 * k as f64).collect();
    let mut states = vec![State::default(); MANY];
    let part = 2_000;
    let one = nanoseconds(MANY, || {
        for (times, states) in times.chunks(part).zip(states.chunks_mut(part)) {
            let _ = black_box(top.states_at(times, states));
        }
    });
    let all = nanoseconds(MANY, || {
        times
            .par_chunks(part)
            .zip(states.par_chunks_mut(part))
            .for_each(|(times, states)| {
                let _ = black_box(top.states_at(times, states));
            });
    });
    println!(
        "\n{} cores: {one:.1} ns a state on one, {all:.1} on all, {:.2} times as fast",
        rayon::current_num_threads(),
        one / all
    );
    Ok(())
}
