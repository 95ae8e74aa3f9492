//! The free top: time for one exact state, and what an integrator pays for the same state, in one run.
//!
//! `cargo bench -p lab --bench euler_top`. Errors are against the table of 32 digits. Times are the least of several
//! runs. The textbook's formulas over GSL and over Boost.Math are timed by `tests/reference/peers/state_time.cpp`; with
//! the program built from it named in the variable `STATE_TIME`, its lines stand in the same report.

mod shared;

use std::hint::black_box;

use shared::{FREE_BODIES, angle, least, only_tested};
use spinning_bodies::euler_top::EulerTop;
use spinning_bodies::frame::{Attitude, BodyVector};
use support::decimal::hexadecimal;

fn main() -> spinning_bodies::Result<()> {
    if only_tested() {
        return Ok(());
    }
    let ours = states()?;
    peers();
    integrators(ours)
}

/// The table of times for one state; returns that of the ordinary body, prepared, in seconds.
fn states() -> spinning_bodies::Result<f64> {
    println!("one state (omega, L, attitude) of a free top, ns");
    println!(
        "{:>20} {:>9} {:>10} {:>8} {:>9} {:>13} {:>14}",
        "body", "prepared", "omega only", "batch", "set-up", "set-up+state", "set-up/state"
    );
    const COUNT: usize = 1000;
    let mut first = None;
    for (name, moments, l, span) in FREE_BODIES {
        let start = BodyVector::new(l[0], l[1], l[2]);
        let top = EulerTop::new(moments, start, Attitude::identity())?;
        let times: Vec<f64> = (0..COUNT)
            .map(|k| span * (k as f64 + 0.5) / COUNT as f64)
            .collect();
        // Bodies that differ in the last digits, so that nothing is prepared twice alike.
        let starts: Vec<BodyVector> = (0..COUNT)
            .map(|k| start * (1.0 + 1e-13 * k as f64))
            .collect();
        let state = least(50, || {
            for t in &times {
                let _ = black_box(black_box(&top).at(*t));
            }
        });
        let omega = least(50, || {
            for t in &times {
                let _ = black_box(black_box(&top).omega_at(*t));
            }
        });
        let batch = least(50, || {
            for state in black_box(&top).states(times.iter().copied()) {
                let _ = black_box(state);
            }
        });
        let set_up = least(50, || {
            for start in &starts {
                let _ = black_box(EulerTop::new(
                    black_box(moments),
                    *start,
                    Attitude::identity(),
                ));
            }
        });
        let scratch = least(50, || {
            for (start, t) in starts.iter().zip(&times) {
                let top = EulerTop::new(black_box(moments), *start, Attitude::identity());
                let _ = black_box(top.and_then(|top| top.at(*t)));
            }
        });
        let each = 1e9 / COUNT as f64;
        println!(
            "{name:>20} {:>9.1} {:>10.1} {:>8.1} {:>9.1} {:>13.1} {:>14.2}",
            state * each,
            omega * each,
            batch * each,
            set_up * each,
            scratch * each,
            set_up / state
        );
        first.get_or_insert(state / COUNT as f64);
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

/// L and the attitude quaternion.
type Point = [f64; 7];

/// Euler's equations and q′ = ½qΩ.
fn rates(inverse: [f64; 3], p: &Point) -> Point {
    let [l1, l2, l3, w, x, y, z] = *p;
    let [a, b, c] = [l1 * inverse[0], l2 * inverse[1], l3 * inverse[2]];
    [
        l2 * c - l3 * b,
        l3 * a - l1 * c,
        l1 * b - l2 * a,
        -0.5 * (x * a + y * b + z * c),
        0.5 * (w * a + y * c - z * b),
        0.5 * (w * b + z * a - x * c),
        0.5 * (w * c + x * b - y * a),
    ]
}

fn plus(p: &Point, h: f64, rate: &Point) -> Point {
    core::array::from_fn(|k| p[k] + h * rate[k])
}

/// The classical method of Runge and Kutta.
fn runge_kutta(inverse: [f64; 3], mut p: Point, t: f64, steps: u32) -> Point {
    let h = t / f64::from(steps);
    for _ in 0..steps {
        let a = rates(inverse, &p);
        let b = rates(inverse, &plus(&p, h / 2.0, &a));
        let c = rates(inverse, &plus(&p, h / 2.0, &b));
        let d = rates(inverse, &plus(&p, h, &c));
        p = core::array::from_fn(|k| p[k] + h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]));
    }
    p
}

/// Power series in time to the twentieth power, the strongest of the step-by-step methods here.
fn power_series(inverse: [f64; 3], mut p: Point, t: f64, steps: u32) -> Point {
    const ORDER: usize = 20;
    let h = t / f64::from(steps);
    for _ in 0..steps {
        let mut l = [[0.0; ORDER + 1]; 3];
        let mut omega = [[0.0; ORDER + 1]; 3];
        let mut q = [[0.0; ORDER + 1]; 4];
        for k in 0..3 {
            l[k][0] = p[k];
            omega[k][0] = p[k] * inverse[k];
        }
        for k in 0..4 {
            q[k][0] = p[3 + k];
        }
        for n in 0..ORDER {
            let product = |a: &[f64; ORDER + 1], b: &[f64; ORDER + 1]| -> f64 {
                (0..=n).map(|k| a[k] * b[n - k]).sum()
            };
            let step = h / (n + 1) as f64;
            let products = [
                product(&l[1], &l[2]),
                product(&l[2], &l[0]),
                product(&l[0], &l[1]),
            ];
            let [w, x, y, z] = &q;
            let [a, b, c] = &omega;
            let turning = [
                -(product(x, a) + product(y, b) + product(z, c)),
                product(w, a) + product(y, c) - product(z, b),
                product(w, b) + product(z, a) - product(x, c),
                product(w, c) + product(x, b) - product(y, a),
            ];
            for k in 0..3 {
                let difference = inverse[(k + 2) % 3] - inverse[(k + 1) % 3];
                l[k][n + 1] = step * difference * products[k];
                omega[k][n + 1] = l[k][n + 1] * inverse[k];
            }
            for k in 0..4 {
                q[k][n + 1] = 0.5 * step * turning[k];
            }
        }
        // Every coefficient carries its power of the step; the smallest are added first.
        let sum = |series: &[f64; ORDER + 1]| series.iter().rev().sum();
        p = [
            sum(&l[0]),
            sum(&l[1]),
            sum(&l[2]),
            sum(&q[0]),
            sum(&q[1]),
            sum(&q[2]),
            sum(&q[3]),
        ];
    }
    p
}

/// A row of the table: moments, L, t, and the quaternion to a double's precision and a rest.
struct Truth {
    moments: [f64; 3],
    start: [f64; 3],
    time: f64,
    attitude: [f64; 4],
}

/// The rows of Hairer and Vilmart's asymmetric body.
fn truths() -> Vec<Truth> {
    include_str!("../../tests/reference/free_top.csv")
        .lines()
        .map(|line| line.split(',').collect::<Vec<_>>())
        .filter(|fields| fields[1] == "hairer-vilmart")
        .map(|fields| Truth {
            moments: [2, 3, 4].map(|k| hexadecimal(fields[k])),
            start: [5, 6, 7].map(|k| hexadecimal(fields[k])),
            time: hexadecimal(fields[8]),
            attitude: [12, 13, 14, 15].map(|k| fields[k].parse().expect("a decimal")),
        })
        .filter(|truth| truth.moments[0] == 0.6 && truth.time > 0.0)
        .collect()
}

fn integrators(ours: f64) -> spinning_bodies::Result<()> {
    println!(
        "\nattitude of I = (0.6, 0.8, 1), L = (1.8, 0.4, -0.9) at time t: error (rad) and time"
    );
    println!(
        "{:>12} {:>22} {:>10} {:>11} {:>12} {:>12}",
        "t", "method", "steps", "error", "time us", "times ours"
    );
    for truth in truths() {
        let [a, b, c] = truth.start;
        let top = EulerTop::new(
            truth.moments,
            BodyVector::new(a, b, c),
            Attitude::identity(),
        )?;
        let q = top.at(truth.time)?.attitude.quaternion();
        println!(
            "{:>12.4e} {:>22} {:>10} {:>11.1e} {:>12.3} {:>12.1}",
            truth.time,
            "exact",
            "-",
            angle([q.w, q.i, q.j, q.k], truth.attitude),
            1e6 * ours,
            1.0
        );
        if truth.time > 1e4 {
            // Step by step that far takes seconds and gains nothing.
            continue;
        }
        let inverse = truth.moments.map(|moment| 1.0 / moment);
        let start = [a, b, c, 1.0, 0.0, 0.0, 0.0];
        type Method = fn([f64; 3], Point, f64, u32) -> Point;
        let methods: [(&str, Method, &[f64]); 2] = [
            (
                "Runge-Kutta 4",
                runge_kutta,
                &[10.0, 30.0, 100.0, 300.0, 1000.0],
            ),
            ("power series 20", power_series, &[1.0, 2.0, 4.0]),
        ];
        for (name, method, rates) in methods {
            for rate in rates {
                let steps = (rate * truth.time).ceil() as u32;
                if steps > 1_000_000 {
                    continue;
                }
                let runs = if steps > 10_000 { 3 } else { 20 };
                let mut p = start;
                let time = least(runs, || {
                    p = black_box(method(black_box(inverse), start, truth.time, steps));
                });
                println!(
                    "{:>12} {name:>22} {steps:>10} {:>11.1e} {:>12.3} {:>12.1}",
                    "",
                    angle([p[3], p[4], p[5], p[6]], truth.attitude),
                    1e6 * time,
                    time / ours
                );
            }
        }
    }
    Ok(())
}
