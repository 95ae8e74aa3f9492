//! The free top: time for one exact state, and what an integrator pays for the same state, in one run.
//!
//! `cargo bench -p lab --bench euler_top`. Errors are against the table of 32 digits. Times are the least of several
//! runs. The textbook's formulas over GSL and over Boost.Math are timed by `tests/reference/peers/state_time.cpp`; with
//! the program built from it named in the variable `STATE_TIME`, its lines stand in the same report.

mod shared;

use std::hint::black_box;

use lab::stopwatch::{in_turn, least};
use shared::{FREE_BODIES, head, numbers, only_tested};
use spinning_bodies::Result;
use spinning_bodies::euler_top::EulerTop;
use spinning_bodies::frame::{Attitude, BodyVector};
use support::power_series::{Top, Whole};
use support::table::{angle, lines};
use support::{euler, runge_kutta, turned, vector};

fn main() -> Result<()> {
    if only_tested() {
        return Ok(());
    }
    let ours = states()?;
    peers();
    integrators(ours)
}

fn thrown(moments: [f64; 3], l: BodyVector) -> Result<EulerTop> {
    EulerTop::new(black_box(moments), l, Attitude::identity())
}

/// The table of times for one state; returns that of the ordinary body, prepared, in seconds.
fn states() -> Result<f64> {
    const COUNT: usize = 1000;
    let columns = [
        "prepared",
        "omega only",
        "batch",
        "set-up",
        "set-up + state",
        "set-up/state",
    ];
    head("one state (omega, L, attitude) of a free top, ns", &columns);
    let mut first = None;
    for (name, moments, l, span) in FREE_BODIES {
        let (l, count) = (vector(l), COUNT as f64);
        let top = thrown(moments, l)?;
        let times: Vec<f64> = (0..COUNT)
            .map(|k| span * (k as f64 + 0.5) / count)
            .collect();
        // Bodies that differ in the last digits, so that nothing is prepared twice alike.
        let starts: Vec<BodyVector> = (0..COUNT).map(|k| l * (1.0 + 1e-13 * k as f64)).collect();
        let each = |work: &dyn Fn(f64, BodyVector)| {
            for (&t, &start) in times.iter().zip(&starts) {
                work(t, start);
            }
        };
        let seconds = in_turn([
            &mut || each(&|t, _| drop(black_box(black_box(&top).at(t)))),
            &mut || each(&|t, _| drop(black_box(black_box(&top).omega_at(t)))),
            &mut || {
                for state in black_box(&top).states(times.iter().copied()) {
                    let _ = black_box(state);
                }
            },
            &mut || each(&|_, start| drop(black_box(thrown(moments, start)))),
            &mut || {
                each(&|t, start| drop(black_box(thrown(moments, start).and_then(|top| top.at(t)))))
            },
        ]);
        let [state, omega, batch, set_up, scratch] = seconds.map(|seconds| 1e9 * seconds / count);
        numbers(
            name,
            &[state, omega, batch, set_up, scratch, set_up / state],
        );
        first.get_or_insert(1e-9 * state);
    }
    Ok(first.expect("at least one body"))
}

/// The lines of the peers' own program, if it was built.
fn peers() {
    let Some(program) = std::env::var_os("STATE_TIME") else {
        return;
    };
    println!("\nthe textbook's formulas over the peers' elliptic functions");
    match std::process::Command::new(program).output() {
        Ok(output) => print!("{}", String::from_utf8_lossy(&output.stdout)),
        Err(error) => println!("{error}"),
    }
}

/// The rows of Hairer and Vilmart's asymmetric body, by all methods.
fn integrators(ours: f64) -> Result<()> {
    let columns = ["t, s", "steps", "error, rad", "time, us", "times ours"];
    head(
        "attitude of I = (0.6, 0.8, 1), L = (1.8, 0.4, -0.9)",
        &columns,
    );
    for cells in lines(include_str!("../../tests/reference/free_top.csv")) {
        let (moments, l, [t]) = (cells.exact(2), cells.exact(5), cells.exact(8));
        if cells.text(1) != "hairer-vilmart" || moments[0] != 0.6 || t <= 0.0 {
            continue;
        }
        let truth = cells.decimals(12);
        let say = |method: &str, steps: f64, attitude: Attitude, seconds: f64| {
            let (off, times) = (angle(&attitude, truth), seconds / ours);
            numbers(method, &[t, steps, off, 1e6 * seconds, times]);
        };
        say(
            "exact",
            f64::NAN,
            thrown(moments, vector(l))?.at(t)?.attitude,
            ours,
        );
        if t > 1e4 {
            // Step by step that far takes seconds and gains nothing.
            continue;
        }
        let [a, b, c] = [0, 1, 2].map(|k| l[k] / moments[k]);
        let rate = |_: f64, [a, b, c, w, x, y, z]: [f64; 7]| {
            let ([p, q, r], [dw, dx, dy, dz]) =
                (euler(moments, [a, b, c]), turned([w, x, y, z], [a, b, c]));
            [p, q, r, dw, dx, dy, dz]
        };
        for each in [10.0, 30.0, 100.0, 300.0, 1000.0] {
            let steps = (each * t).ceil();
            if steps > 1e6 {
                continue;
            }
            let mut y = [a, b, c, 1.0, 0.0, 0.0, 0.0];
            let start = y;
            let seconds = least(|| {
                y = runge_kutta(rate, black_box(start), (steps as u32, t / steps), |_| ());
            });
            let [.., w, x, y, z] = y;
            say(
                "Runge-Kutta 4",
                steps,
                Attitude::from_quaternion(w, x, y, z)?,
                seconds,
            );
        }
        let (series, lever) = ([a, b, c, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0], [0.0; 3]);
        let (top, mut end): (_, Whole) = (Top { moments, lever }, series);
        let seconds = least(|| end = top.after(black_box(series), t));
        let [.., w, x, y, z] = end;
        say(
            "power series 30",
            f64::NAN,
            Attitude::from_quaternion(w, x, y, z)?,
            seconds,
        );
    }
    Ok(())
}
