//! Kovalevskaya's top: Ω and z by her own road at any time, and what integrators pay for the same numbers, in one run.
//!
//! `cargo bench -p lab --bench kovalevskaya_top`, a minute. Errors are the greatest of the six components against power series in
//! double-doubles; `cargo bench -p lab --bench kovalevskaya_top -- reference` computes those anew, which takes an hour. Times
//! are the least of several runs. The integrators solve Euler's equations under the weight and q′ = ½qΩ: the classical Runge–Kutta method and
//! DOP853 of the crate `differential-equations`.

mod shared;

use std::hint::black_box;

use lab::follow::Follow;
use lab::general::GeneralMethod;
use lab::stopwatch::least;
use shared::{head, numbers, only_tested};
use spinning_bodies::Result;
use spinning_bodies::integrators::geometric::{Phase, Weight};
use spinning_bodies::integrators::{Effort, Method};
use spinning_bodies::kovalevskaya_top::KovalevskayaTop;
use support::double_double::Dd;
use support::kovalevskaya::{LEVER, MOMENTS, SERIES, top};
use support::{greatest, vector};

/// Ω and z along the body's axes.
type Point = [f64; 6];

/// The start of the table. |z| differs from 1 by 2e-17, which can make 2e-11 in a million seconds.
const OMEGA: [f64; 3] = [1.0, 0.5, 0.3];
const UP: [f64; 3] = [0.6, 0.0, 0.8];

fn main() -> Result<()> {
    if only_tested() {
        return Ok(());
    }
    if std::env::args().any(|argument| argument == "reference") {
        reference();
        return Ok(());
    }
    times();
    compared()
}

/// What one state costs, for starts of several kinds.
fn times() {
    const COUNT: usize = 100;
    let columns = [
        "t about 10",
        "1e3",
        "1e6",
        "attitude, 10",
        "steps of 0.1",
        "set-up",
    ];
    head(
        "one state of Kovalevskaya's top, us: omega and z; with the attitude",
        &columns,
    );
    for (name, omega, up) in [
        ("the table's", OMEGA, UP),
        ("fast spin", [0.5, 0.3, 5.0], UP),
        ("through q = 0", [1.0, 0.0, 0.3], [0.6, 0.48, 0.64]),
        ("weak gravity", [10.0, 5.0, 3.0], UP),
    ] {
        let made = top(omega, up);
        let times = || (1..=COUNT).map(|k| 0.1 * k as f64);
        let [near, far, farthest] = [10.0, 1e3, 1e6].map(|t| {
            let states =
                || times().for_each(|k| drop(black_box(black_box(&made).omega_and_up(t + k))));
            least(states) / COUNT as f64
        });
        let attitude = least(|| drop(black_box(black_box(&made).at(10.0))));
        let batch = least(|| {
            for state in black_box(&made).states(times()) {
                let _ = black_box(state);
            }
        });
        let set_up = least(|| drop(black_box(top(black_box(omega), up))));
        let all = [near, far, farthest, attitude, batch / COUNT as f64, set_up];
        numbers(
            &format!("{name}, {:?}", made.method()),
            &all.map(|seconds| 1e6 * seconds),
        );
    }
}

fn point(top: &KovalevskayaTop, t: f64) -> Result<Point> {
    let state = top.omega_and_up(t)?;
    let (o, z) = (state.omega, state.up);
    Ok([o.x(), o.y(), o.z(), z.x(), z.y(), z.z()])
}

/// The motion of the table by all methods, at three times.
fn compared() -> Result<()> {
    let exact = top(OMEGA, UP);
    let l = vector([0, 1, 2].map(|k| MOMENTS[k] * OMEGA[k]));
    let start = Phase::new(l, &exact.at(0.0)?.attitude);
    for (t, truth) in TRUTH {
        let columns = ["steps", "error", "time, us", "times ours"];
        head(
            &format!("omega and z of the table's top at t = {t:e}"),
            &columns,
        );
        let prepared = least(|| drop(black_box(point(black_box(&exact), t))));
        let say = |method: &str, steps: f64, found: Point, seconds: f64| {
            let error = greatest((0..6).map(|k| (found[k] - truth[k]).abs()));
            numbers(method, &[steps, error, 1e6 * seconds, seconds / prepared]);
        };
        say("exact, prepared", f64::NAN, point(&exact, t)?, prepared);
        let scratch = least(|| drop(black_box(point(&top(black_box(OMEGA), UP), t))));
        say(
            "exact, set-up and state",
            f64::NAN,
            point(&exact, t)?,
            scratch,
        );
        let steps = [20.0, 200.0].map(|each| (Method::Rk4, Effort::Step(1.0 / each), each * t));
        // Nine million steps are enough of one kind.
        let tolerances =
            [1e-12, 1e-9, 1e-14].map(|most| (Method::Dop853, Effort::Tolerance(most), 0.0));
        let least_of_all = if t > 1e5 { 1 } else { 3 };
        let chosen = tolerances.into_iter().take(least_of_all);
        for (method, effort, _) in steps.into_iter().filter(|way| way.2 < 5e6).chain(chosen) {
            let general = GeneralMethod::new(MOMENTS, Weight::new(LEVER)?, method)?;
            let name = format!("{}, {effort:?}", method.name());
            let Ok(run) = general.follow(&start, &[t], effort) else {
                println!("{name} gives up");
                continue;
            };
            let seconds =
                least(|| drop(black_box(general.follow(black_box(&start), &[t], effort))));
            let (Phase { l, .. }, up) = (run.states[0], run.states[0].up());
            let found = [
                l[0] / MOMENTS[0],
                l[1] / MOMENTS[1],
                l[2] / MOMENTS[2],
                up[0],
                up[1],
                up[2],
            ];
            say(&name, run.cost.steps as f64, found, seconds);
        }
    }
    Ok(())
}

/// Prints [`TRUTH`].
fn reference() {
    let ([a, b, c], [x, y, z]) = (OMEGA, UP);
    // The attitude goes along, from the identity; nothing depends on it.
    let mut state = [a, b, c, x, y, z, 1.0, 0.0, 0.0, 0.0].map(Dd::from);
    let mut now = 0.0;
    for (t, _) in TRUTH {
        state = SERIES.after(state, t - now);
        now = t;
        println!("{t:e} {:?}", &state.map(Dd::value)[..6]);
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
