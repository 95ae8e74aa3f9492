//! Lagrange's top: time for one exact state, and what integrators and a physics engine pay for the same state, in one run.
//!
//! `cargo bench -p lab --bench lagrange_top`, half a minute. Errors of the attitude are against the table of 32 digits. Times are the
//! least of several runs. The integrators solve the library's own Euler–Poisson equations and q′ = ½qΩ: the classical Runge–Kutta
//! method in steps of one length, and DOP853 of the crate `differential-equations`, relative and absolute tolerance alike. The engine is
//! rapier3d in doubles, a body on a ball joint, with the
//! settings it comes with but for the step.

#[path = "shared/heavy.rs"]
mod heavy;
#[path = "shared/joint.rs"]
mod joint;
mod shared;

use std::hint::black_box;

use heavy::{Heavy, dop853};
use joint::Engine;
use shared::{angle, least, least_of_few, only_tested};
use spinning_bodies::Result;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::lagrange_top::LagrangeTop;
use support::decimal::hexadecimal;

fn main() -> Result<()> {
    if only_tested() {
        return Ok(());
    }
    let rows = rows();
    let times = states(&rows)?;
    let mut summary = Vec::new();
    for (pair, ours) in rows.chunks(2).zip(times) {
        for row in pair {
            summary.push(compared(row, ours)?);
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
#[derive(Debug, Clone)]
struct Row {
    name: &'static str,
    span: &'static str,
    /// I₁, I₃, Mgl.
    body: [f64; 3],
    omega: [f64; 3],
    attitude: [f64; 4],
    time: f64,
    turns: f64,
    exact: [f64; 4],
}

fn rows() -> Vec<Row> {
    let lines: Vec<Vec<&str>> = include_str!("../../tests/reference/lagrange_top.csv")
        .lines()
        .skip(1)
        .map(|line| line.split(',').collect())
        .collect();
    let row = |name, id: usize, span| {
        let cells = &lines[id];
        assert_eq!(cells[0], id.to_string(), "the lines are in order");
        let exact = |k: usize| hexadecimal(cells[k]);
        let number = |k: usize| cells[k].parse().expect("a number");
        Row {
            name,
            span,
            body: [2, 3, 4].map(exact),
            omega: [5, 6, 7].map(exact),
            attitude: [8, 9, 10, 11].map(exact),
            time: exact(12),
            turns: number(21),
            exact: [16, 17, 18, 19].map(number),
        }
    };
    TOPS.iter()
        .flat_map(|(name, ids, spans)| [0, 1].map(|k| row(*name, ids[k], spans[k])))
        .collect()
}

impl Row {
    fn top(&self, unit: f64) -> Result<LagrangeTop> {
        let [w, x, y, z] = self.attitude;
        let [a, b, c] = self.omega;
        let [transverse, axial, weight] = self.body.map(|x| x * unit);
        let attitude = Attitude::from_quaternion(w, x, y, z)?;
        LagrangeTop::new(
            transverse,
            axial,
            weight,
            BodyVector::new(a, b, c),
            attitude,
        )
    }
}

/// Time for one state, prepared, and from scratch, seconds.
type Ours = [f64; 2];

/// The table of times for one state, and that of each top.
fn states(rows: &[Row]) -> Result<Vec<Ours>> {
    println!("one state (omega, L, attitude, up, height) of Lagrange's top, ns\n");
    println!(
        "{:>22} {:>9} {:>9} {:>5} {:>8} {:>14} {:>14}",
        "top", "prepared", "states_at", "ratio", "set-up", "set-up + state", "set-up / state"
    );
    let mut all = Vec::new();
    for pair in rows.chunks(2) {
        let row = &pair[0];
        all.push(timed(row, row.name, row.time)?);
    }
    let row = &rows[1];
    timed(row, "a million nutations", 1000.0 * row.time)?;
    Ok(all)
}

/// One line of the table, for times up to `span`.
fn timed(row: &Row, name: &str, span: f64) -> Result<Ours> {
    const COUNT: usize = 1000;
    const PART: usize = 100;
    let times: Vec<f64> = (0..COUNT)
        .map(|k| span * (k as f64 + 0.5) / COUNT as f64)
        .collect();
    // The same top in units of mass that are powers of two: the kind of motion stays, and nothing is prepared twice alike.
    let units: Vec<f64> = (0..COUNT).map(|k| ((k % 16) as f64).exp2()).collect();
    let top = row.top(1.0)?;
    let state = least(50, || {
        for t in &times {
            let _ = black_box(black_box(&top).at(*t));
        }
    });
    let mut states = vec![top.at(0.0)?; COUNT];
    let batch = least(50, || {
        let _ = black_box(&top).states_at(&times, &mut states);
        black_box(&states);
    });
    let set_up = least(200, || {
        for unit in &units[..PART] {
            let _ = black_box(black_box(row).top(*unit));
        }
    });
    let scratch = least(200, || {
        for (unit, t) in units.iter().zip(&times).take(PART) {
            let _ = black_box(black_box(row).top(*unit).and_then(|top| top.at(*t)));
        }
    });
    let [state, batch] = [state, batch].map(|time| time / COUNT as f64);
    let [set_up, scratch] = [set_up, scratch].map(|time| time / PART as f64);
    println!(
        "{name:>22} {:>9.1} {:>9.1} {:>5.2} {:>8.0} {:>14.0} {:>14.1}",
        1e9 * state,
        1e9 * batch,
        batch / state,
        1e9 * set_up,
        1e9 * scratch,
        set_up / state
    );
    Ok([state, scratch])
}

/// What one method makes of one state: error (rad) and time (s).
#[derive(Debug, Clone)]
struct Answer {
    method: String,
    error: f64,
    time: f64,
}

/// One state by all methods, printed; the exact one first.
fn compared(row: &Row, [prepared, scratch]: Ours) -> Result<(Row, Vec<Answer>)> {
    let q = row.top(1.0)?.at(row.time)?.attitude.quaternion();
    println!(
        "\n{}, {}, t = {:.6} s, {} turns: attitude\n\n{:>34} {:>10} {:>10} {:>12} {:>12}",
        row.name,
        row.span,
        row.time,
        row.turns,
        "method",
        "steps",
        "error rad",
        "time us",
        "times ours"
    );
    let mut answers = Vec::new();
    let mut say = |method: &str, steps: usize, exact: [f64; 4], time: f64| {
        let error = angle(exact, row.exact);
        println!(
            "{method:>34} {:>10} {error:>10.1e} {:>12.3} {:>12.1}",
            if steps == 0 {
                "-".to_owned()
            } else {
                steps.to_string()
            },
            1e6 * time,
            time / prepared
        );
        answers.push(Answer {
            method: method.to_owned(),
            error,
            time,
        });
    };
    let exact = [q.w, q.i, q.j, q.k];
    say("exact, prepared", 0, exact, prepared);
    say("exact, set-up and state", 0, exact, scratch);

    let [transverse, axial, weight] = row.body;
    let heavy = Heavy::new([transverse, transverse, axial], [0.0, 0.0, weight])?;
    let ([a, b, c], [w, x, y, z]) = (row.omega, row.attitude);
    let start = [a, b, c, w, x, y, z];
    for each in [10.0, 30.0, 100.0, 300.0, 1000.0] {
        let steps = (each * row.turns).ceil();
        if steps > 2e6 {
            continue;
        }
        let mut p = start;
        let time = least_of_few(20, || {
            p = black_box(heavy.runge_kutta(black_box(start), row.time, steps as u32));
        });
        say(
            "Runge-Kutta 4",
            steps as usize,
            [p[3], p[4], p[5], p[6]],
            time,
        );
    }
    for tolerance in [1e-6, 1e-9, 1e-12, 1e-14] {
        let mut found = None;
        let time = least_of_few(20, || {
            found = black_box(dop853(&heavy, black_box(start), row.time, tolerance));
        });
        let method = format!("DOP853, {tolerance:.0e}");
        if let Some((p, steps)) = found {
            say(&method, steps, [p[3], p[4], p[5], p[6]], time);
        } else {
            println!("{method:>34} gives up");
        }
    }
    for each in [100.0, 1000.0] {
        let steps = (each * row.turns).ceil();
        if steps > 2e5 {
            continue;
        }
        let mut q = row.attitude;
        let time = least_of_few(20, || {
            let mut engine = Engine::new(row.body, row.omega, row.attitude, row.time / steps);
            q = black_box(engine.after(steps as u32));
        });
        say("rapier3d", steps as usize, q, time);
    }
    Ok((row.clone(), answers))
}

/// The most accurate integrator, the cheapest within 1e-9, and the engine, beside the exact state.
fn summarised(all: &[(Row, Vec<Answer>)]) {
    println!(
        "\nin short: error (rad), time (us), and time over that of a prepared exact state\n\n{:>18} {:>14} {:>16} {:>32} {:>32} {:>28}",
        "top",
        "nutations",
        "exact",
        "most accurate integrator",
        "cheapest within 1e-9",
        "rapier3d at its best"
    );
    for (row, answers) in all {
        let ours = &answers[0];
        let engine = |a: &&Answer| a.method.starts_with("rapier");
        let integrator = |a: &&Answer| !engine(a) && !a.method.starts_with("exact");
        let by =
            |key: fn(&Answer) -> f64| move |a: &&Answer, b: &&Answer| key(a).total_cmp(&key(b));
        let shown = |answer: Option<&Answer>| {
            answer.map_or("none".to_owned(), |a| {
                format!(
                    "{:.0e} {:>9.1} {:>9.0}x",
                    a.error,
                    1e6 * a.time,
                    a.time / ours.time
                )
            })
        };
        let all = || answers.iter();
        println!(
            "{:>18} {:>14} {:>7.0e} {:>8.3} {:>32} {:>32} {:>28}",
            row.name,
            row.span,
            ours.error,
            1e6 * ours.time,
            shown(all().filter(integrator).min_by(by(|a| a.error))),
            shown(
                all()
                    .filter(integrator)
                    .filter(|a| a.error <= 1e-9)
                    .min_by(by(|a| a.time))
            ),
            shown(all().filter(engine).min_by(by(|a| a.error))),
        );
    }
}
