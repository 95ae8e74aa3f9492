//! Kovalevskaya's top: Ω and z by her own road at any time, and what integrators pay for the same numbers, in one run.
//!
//! `cargo bench -p lab --bench kovalevskaya_top`, a minute. Errors are the greatest of the six components against power series in
//! double-doubles; `cargo bench -p lab --bench kovalevskaya_top -- reference` computes those anew, which takes an hour. Times
//! are the least of several runs. The integrators solve the library's own Euler–Poisson equations: its classical Runge–Kutta step, and
//! DOP853 of the crate `differential-equations`, relative and absolute tolerance alike.

#[path = "shared/heavy.rs"]
#[allow(dead_code, reason = "the attitude is not asked for here")]
mod heavy;
mod shared;

use std::hint::black_box;

use differential_equations::ode::ODE;
use heavy::dop853;
use shared::{least, least_of_few, only_tested};
use spinning_bodies::Result;
use spinning_bodies::euler_equations::{AxisMoments, HeavyTop, TopState};
use spinning_bodies::frame::BodyVector;
use spinning_bodies::kovalevskaya_top::KovalevskayaTop;
use support::double_double::Dd;
use support::power_series::Top;

/// Ω and z along the body's axes.
type Point = [f64; 6];

/// Moments and MgC: c = MgC₁/I₃ = 1.
const MOMENTS: [f64; 3] = [2.0, 2.0, 1.0];
const LEVER: [f64; 3] = [1.0, 0.0, 0.0];

/// The start of the table. |z| differs from 1 by 2e-17, which can make 2e-11 in a million seconds.
const START: Point = [1.0, 0.5, 0.3, 0.6, 0.0, 0.8];

fn main() -> Result<()> {
    if only_tested() {
        return Ok(());
    }
    if std::env::args().any(|argument| argument == "reference") {
        reference();
        return Ok(());
    }
    times()?;
    compared()
}

fn vector([x, y, z]: [f64; 3]) -> BodyVector {
    BodyVector::new(x, y, z)
}

fn state([a, b, c, x, y, z]: Point) -> TopState {
    TopState {
        omega: vector([a, b, c]),
        up: vector([x, y, z]),
    }
}

fn point(state: &TopState) -> Point {
    let (o, z) = (state.omega, state.up);
    [o.x(), o.y(), o.z(), z.x(), z.y(), z.z()]
}

fn top(start: Point) -> Result<KovalevskayaTop> {
    let TopState { omega, up } = state(start);
    KovalevskayaTop::with_up(MOMENTS, vector(LEVER), omega, up)
}

/// What one state costs, for starts of several kinds.
fn times() -> Result<()> {
    println!("one state of Kovalevskaya's top, us\n");
    println!(
        "{:>24} {:>12} {:>28} {:>26} {:>10}",
        "", "", "omega and z about t =", "with the attitude", ""
    );
    println!(
        "{:>24} {:>12} {:>8} {:>9} {:>9} {:>12} {:>13} {:>10}",
        "start", "method", "10", "1e3", "1e6", "t = 10", "a step of 0.1", "set-up"
    );
    let starts: [(&str, Point); 4] = [
        ("the table's", START),
        ("fast spin", [0.5, 0.3, 5.0, 0.6, 0.0, 0.8]),
        ("through q = 0", [1.0, 0.0, 0.3, 0.6, 0.48, 0.64]),
        ("weak gravity", [10.0, 5.0, 3.0, 0.6, 0.0, 0.8]),
    ];
    for (name, start) in starts {
        const COUNT: usize = 100;
        let top = top(start)?;
        let about = |t: f64| {
            let work = || {
                for k in 0..COUNT {
                    let _ = black_box(black_box(&top).omega_and_up(t + 0.1 * k as f64));
                }
            };
            1e6 * least(20, work) / COUNT as f64
        };
        let attitude = least(10, || {
            let _ = black_box(black_box(&top).at(10.0));
        });
        let batch = least(10, || {
            for state in black_box(&top).states((1..=COUNT).map(|k| 0.1 * k as f64)) {
                let _ = black_box(state);
            }
        });
        let set_up = least(10, || {
            let _ = black_box(crate::top(black_box(start)));
        });
        println!(
            "{name:>24} {:>12} {:>8.2} {:>9.2} {:>9.2} {:>12.0} {:>13.1} {:>10.0}",
            format!("{:?}", top.method()),
            about(10.0),
            about(1e3),
            about(1e6),
            1e6 * attitude,
            1e6 * batch / COUNT as f64,
            1e6 * set_up
        );
    }
    Ok(())
}

/// The Euler–Poisson equations.
struct Poisson(HeavyTop);

impl ODE<f64, Point> for Poisson {
    fn diff(&self, _: f64, y: &Point, dydt: &mut Point) {
        *dydt = point(&self.0.rate(&state(*y)));
    }
}

/// The motion of the table by all methods, at three times.
fn compared() -> Result<()> {
    let exact = top(START)?;
    let poisson = Poisson(HeavyTop::new(
        AxisMoments::new(MOMENTS[0], MOMENTS[1], MOMENTS[2])?,
        vector(LEVER),
    )?);
    for (t, truth) in TRUTH {
        println!(
            "\nomega and z of the table's top at t = {t:e}\n\n{:>24} {:>10} {:>10} {:>14} {:>12}",
            "method", "steps", "error", "time us", "times ours"
        );
        let mut answer = [0.0; 6];
        let prepared = least(1000, || {
            if let Ok(found) = black_box(&exact).omega_and_up(black_box(t)) {
                answer = point(&found);
            }
        });
        let say = |method: &str, steps: String, found: Point, time: f64| {
            let error = (0..6)
                .map(|k| (found[k] - truth[k]).abs())
                .fold(0.0, f64::max);
            println!(
                "{method:>24} {steps:>10} {error:>10.1e} {:>14.1} {:>12.1}",
                1e6 * time,
                time / prepared
            );
        };
        say("exact, prepared", "-".to_owned(), answer, prepared);
        let scratch = least(10, || {
            if let Ok(found) = top(black_box(START)).and_then(|top| top.omega_and_up(t)) {
                answer = point(&found);
            }
        });
        say("exact, set-up and state", "-".to_owned(), answer, scratch);
        for each in [20.0, 200.0] {
            let steps = each * t;
            if steps > 5e6 {
                continue;
            }
            let mut found = state(START);
            let time = least_of_few(10, || {
                found = black_box(state(START));
                for _ in 0..steps as u64 {
                    found = poisson.0.step(&found, 1.0 / each);
                }
            });
            say("Runge-Kutta 4", format!("{steps}"), point(&found), time);
        }
        // Nine million steps are enough of one kind.
        let tolerances: &[f64] = if t > 1e5 {
            &[1e-12]
        } else {
            &[1e-9, 1e-12, 1e-14]
        };
        for &tolerance in tolerances {
            let mut found = None;
            let time = least_of_few(10, || {
                found = black_box(dop853(&poisson, black_box(START), t, tolerance));
            });
            let method = format!("DOP853, {tolerance:.0e}");
            match found {
                Some((p, steps)) => say(&method, steps.to_string(), p, time),
                None => println!("{method:>24} gives up"),
            }
        }
    }
    Ok(())
}

/// Prints [`TRUTH`].
fn reference() {
    let series = Top {
        moments: MOMENTS,
        lever: LEVER,
    };
    // The attitude goes along, from the identity; nothing depends on it.
    let mut y: [Dd; 10] = core::array::from_fn(|k| {
        Dd::from(if k < 6 {
            START[k]
        } else {
            f64::from(u8::from(k == 6))
        })
    });
    let mut now = 0.0;
    for (t, _) in TRUTH {
        y = series.after(y, t - now);
        now = t;
        println!("{t:e} {:?}", [0, 1, 2, 3, 4, 5].map(|k| y[k].value()));
    }
}

/// Ω and z at these times, rounded from power series in double-doubles.
const TRUTH: [(f64, Point); 4] = [
    (
        10.0,
        [
            1.1903690984409543,
            -0.45366745900653,
            -0.35784433065415144,
            0.20818096362476948,
            -0.9515170681043412,
            -0.22644194728534942,
        ],
    ),
    (
        1e3,
        [
            1.166889732852391,
            0.6035244197487155,
            0.09091510973751496,
            0.16499384754135954,
            0.8343702864880428,
            0.5259308464991953,
        ],
    ),
    (
        1e5,
        [
            1.131448285476947,
            -0.43555342358378213,
            -0.5379517573833299,
            0.28042194585981706,
            -0.38036472935883503,
            -0.8812980227709433,
        ],
    ),
    (
        1e6,
        [
            -0.4175920087866441,
            0.4357900841511072,
            1.569874173002897,
            0.29845145722234107,
            0.5972404237670831,
            0.7444666573463019,
        ],
    ),
];
