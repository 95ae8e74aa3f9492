//! Lagrange's top: time for one exact state, and what integrators and a physics engine pay for the same state, in one run.
//!
//! `cargo bench -p lab --bench lagrange_top`, half a minute. Errors of the attitude are against the table of 32 digits. Times are the
//! least of several runs. The integrators solve Euler's equations under the weight and q′ = ½qΩ: the classical Runge–Kutta
//! method in steps of one length, and DOP853 of the crate `differential-equations`. The engine is
//! rapier3d in doubles, a body on a ball joint, with the settings it comes with but for the step.

#[path = "shared/joint.rs"]
mod joint;
mod shared;

use std::hint::black_box;

use joint::Engine;
use lab::follow::Follow;
use lab::general::GeneralMethod;
use lab::stopwatch::{in_turn, least};
use shared::{head, line, numbers, only_tested};
use spinning_bodies::Result;
use spinning_bodies::frame::Attitude;
use spinning_bodies::integrators::geometric::{Phase, Weight};
use spinning_bodies::integrators::{Effort, Method};
use spinning_bodies::lagrange_top::LagrangeTop;
use support::double_double::Dd;
use support::table::{angle, lines};
use support::vector;

fn main() -> Result<()> {
    if only_tested() {
        return Ok(());
    }
    let rows = rows();
    let times = states(&rows)?;
    let mut summary = Vec::new();
    for (pair, ours) in rows.chunks(2).zip(times) {
        for row in pair {
            summary.push((row, compared(row, ours)?));
        }
    }
    summarised(&summary);
    Ok(())
}

/// The tops by two lines of the table each.
const TOPS: [(&str, [usize; 2], [&str; 2]); 6] = [
    ("ordinary", [210, 212], NUTATIONS),
    ("cusped", [142, 144], NUTATIONS),
    ("near-sleeping", [579, 580], NUTATIONS),
    // It nutates once and for ever: units of 1/λ, in which what is left of its tilt falls to 1/e.
    ("separatrix", [686, 688], ["3 decays", "50 decays"]),
    ("spherical pendulum", [270, 272], NUTATIONS),
    ("fast", [152, 154], NUTATIONS),
];
const NUTATIONS: [&str; 2] = ["10 nutations", "1000 nutations"];

/// A line of the table.
struct Row {
    name: String,
    /// I₁, I₃, Mgl.
    body: [f64; 3],
    omega: [f64; 3],
    attitude: [f64; 4],
    time: f64,
    turns: f64,
    exact: [Dd; 4],
}

fn rows() -> Vec<Row> {
    let table: Vec<_> = lines(include_str!("../../tests/reference/lagrange_top.csv")).collect();
    let row = |name: &str, id: usize, span: &str| {
        let cells = &table[id];
        assert_eq!(cells.text(0), id.to_string(), "the lines are in order");
        let [time] = cells.exact(12);
        Row {
            name: format!("{name}, {span}"),
            body: cells.exact(2),
            omega: cells.exact(5),
            attitude: cells.exact(8),
            time,
            turns: cells.text(21).parse().expect("a number"),
            exact: cells.decimals(16),
        }
    };
    let pair = |(name, ids, spans): &(&str, [usize; 2], [&str; 2])| {
        [0, 1].map(|k| row(name, ids[k], spans[k]))
    };
    TOPS.iter().flat_map(pair).collect()
}

impl Row {
    fn attitude(&self) -> Result<Attitude> {
        let [w, x, y, z] = self.attitude;
        Attitude::from_quaternion(w, x, y, z)
    }

    fn top(&self, unit: f64) -> Result<LagrangeTop> {
        let [transverse, axial, weight] = self.body.map(|x| x * unit);
        LagrangeTop::new(
            transverse,
            axial,
            weight,
            vector(self.omega),
            self.attitude()?,
        )
    }
}

/// Time for one state, prepared, and from scratch, seconds.
type Ours = [f64; 2];

/// The table of times for one state, and that of each top.
fn states(rows: &[Row]) -> Result<Vec<Ours>> {
    let columns = [
        "prepared",
        "states_at",
        "ratio",
        "set-up",
        "set-up + state",
        "set-up / state",
    ];
    head(
        "one state (omega, L, attitude, up, height) of Lagrange's top, ns",
        &columns,
    );
    let all = rows
        .chunks(2)
        .map(|pair| timed(&pair[0], &pair[0].name, pair[0].time));
    let all = all.collect::<Result<_>>()?;
    timed(&rows[1], "a million nutations", 1000.0 * rows[1].time)?;
    Ok(all)
}

/// One line of the table, for times up to `span`.
fn timed(row: &Row, name: &str, span: f64) -> Result<Ours> {
    const COUNT: usize = 1000;
    let times: Vec<f64> = (0..COUNT)
        .map(|k| span * (k as f64 + 0.5) / COUNT as f64)
        .collect();
    // The same top in units of mass that are powers of two: the kind of motion stays, and nothing is prepared twice alike.
    let unit = |k: usize| ((k % 16) as f64).exp2();
    let top = row.top(1.0)?;
    let mut states = vec![top.at(0.0)?; COUNT];
    let seconds = in_turn([
        &mut || {
            for t in &times {
                let _ = black_box(black_box(&top).at(*t));
            }
        },
        &mut || drop(black_box(black_box(&top).states_at(&times, &mut states))),
        &mut || {
            for k in 0..COUNT {
                let _ = black_box(black_box(row).top(unit(k)));
            }
        },
        &mut || {
            for (k, t) in times.iter().enumerate() {
                let _ = black_box(black_box(row).top(unit(k)).and_then(|top| top.at(*t)));
            }
        },
    ]);
    let all @ [state, batch, set_up, scratch] = seconds.map(|seconds| seconds / COUNT as f64);
    let [a, b, c, d] = all.map(|seconds| 1e9 * seconds);
    numbers(name, &[a, b, batch / state, c, d, set_up / state]);
    Ok([state, scratch])
}

/// What one method makes of one state: error (rad) and time (s).
struct Answer {
    method: String,
    error: f64,
    time: f64,
}

/// One state by all methods, printed; the exact one first.
fn compared(row: &Row, [prepared, scratch]: Ours) -> Result<Vec<Answer>> {
    let title = format!(
        "{}, t = {:.6} s, {} turns: attitude",
        row.name, row.time, row.turns
    );
    head(&title, &["steps", "error, rad", "time, us", "times ours"]);
    let mut answers = Vec::new();
    let mut say = |method: &str, steps: f64, attitude: &Attitude, time: f64| {
        let (method, error) = (method.to_owned(), angle(attitude, row.exact));
        numbers(&method, &[steps, error, 1e6 * time, time / prepared]);
        answers.push(Answer {
            method,
            error,
            time,
        });
    };
    let exact = row.top(1.0)?.at(row.time)?.attitude;
    say("exact, prepared", f64::NAN, &exact, prepared);
    say("exact, set-up and state", f64::NAN, &exact, scratch);
    let ([transverse, axial, weight], times) = (row.body, [row.time]);
    let moments = [transverse, transverse, axial];
    let l = vector([0, 1, 2].map(|k| moments[k] * row.omega[k]));
    let start = Phase::new(l, &row.attitude()?);
    let steps = |each: f64| (each * row.turns).ceil();
    let stepped = [10.0, 30.0, 100.0, 300.0, 1000.0]
        .into_iter()
        .filter(|&each| steps(each) < 2e6);
    let stepped = stepped.map(|each| (Method::Rk4, Effort::Step(row.time / steps(each))));
    let tolerances = [1e-6, 1e-9, 1e-12, 1e-14];
    let by_tolerance = tolerances.map(|most| (Method::Dop853, Effort::Tolerance(most)));
    for (method, effort) in stepped.chain(by_tolerance) {
        let general = GeneralMethod::new(moments, Weight::new([0.0, 0.0, weight])?, method)?;
        let name = format!("{}, {effort:?}", method.name());
        let Ok(run) = general.follow(&start, &times, effort) else {
            println!("{name} gives up");
            continue;
        };
        let seconds = least(|| drop(black_box(general.follow(black_box(&start), &times, effort))));
        say(
            &name,
            run.cost.steps as f64,
            &run.states[0].attitude()?,
            seconds,
        );
    }
    for steps in [100.0, 1000.0]
        .map(steps)
        .into_iter()
        .filter(|&steps| steps < 2e5)
    {
        let mut q = row.attitude;
        let seconds = least(|| {
            let mut engine = Engine::new(row.body, row.omega, row.attitude, row.time / steps);
            q = black_box(engine.after(steps as u32));
        });
        let [w, x, y, z] = q;
        say(
            "rapier3d",
            steps,
            &Attitude::from_quaternion(w, x, y, z)?,
            seconds,
        );
    }
    Ok(answers)
}

/// The most accurate integrator, the cheapest within 1e-9, and the engine, beside the exact state.
fn summarised(all: &[(&Row, Vec<Answer>)]) {
    let title = "in short: error (rad), and time over that of a prepared exact state";
    head(
        title,
        &["exact", "most accurate", "within 1e-9", "rapier3d"],
    );
    for (row, answers) in all {
        let ours = answers[0].time;
        let shown = |answer: Option<&Answer>| {
            answer.map_or("none".to_owned(), |a| {
                format!("{:.0e} {:.0}x", a.error, a.time / ours)
            })
        };
        let (engines, others): (Vec<_>, Vec<_>) =
            answers.iter().partition(|a| a.method == "rapier3d");
        let integrators = || others[2..].iter().copied();
        let fit = integrators().filter(|a| a.error <= 1e-9);
        let by_error = |a: &&Answer, b: &&Answer| a.error.total_cmp(&b.error);
        let chosen = [
            Some(others[0]),
            integrators().min_by(by_error),
            fit.min_by(|a, b| a.time.total_cmp(&b.time)),
            engines.into_iter().min_by(by_error),
        ];
        line(&row.name, &chosen.map(shown));
    }
}
