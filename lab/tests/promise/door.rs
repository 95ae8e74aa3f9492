//! All that the suite asks of the library: a scene file goes in, rows and an estimate come out; and what a run of order 8 would cost.

use std::cell::Cell;

use lab::general::DifferentialEquations;
use spinning_bodies::frame::Attitude;
use spinning_bodies::integrators::{Effort, Kept, order_eight};
use spinning_bodies::scene::files::parse;
use support::double_double::Dd;

/// What came back.
#[derive(Debug, Clone)]
pub enum Answer {
    Motion(Motion),
    /// The message of the refusal.
    Refused(String),
}

#[derive(Debug, Clone)]
pub struct Motion {
    pub solver: String,
    pub estimate: f64,
    pub evaluations: u64,
    columns: Vec<&'static str>,
    rows: Vec<Vec<f64>>,
}

impl Motion {
    /// The numbers of these columns, row by row.
    pub fn rows(&self, names: &[&str]) -> Vec<Vec<Dd>> {
        let place = |name: &&str| {
            let place = self.columns.iter().position(|column| column == name);
            place.unwrap_or_else(|| panic!("no column {name} in {:?}", self.columns))
        };
        let places: Vec<usize> = names.iter().map(place).collect();
        let row = |row: &Vec<f64>| places.iter().map(|&place| Dd::from(row[place])).collect();
        self.rows.iter().map(row).collect()
    }
}

/// Runs a scene file.
pub fn simulate(text: &str) -> Answer {
    let asked = parse("scene", text).map_err(|mistakes| mistakes.to_string());
    let motion = asked.and_then(|(scene, request)| {
        let request = request.with_methods(&DifferentialEquations);
        let motion = scene.simulate(&request);
        motion.map_err(|error| error.to_string())
    });
    match motion {
        Ok(table) => Answer::Motion(Motion {
            solver: table.plan.solver.name().to_owned(),
            estimate: table.error_estimate,
            evaluations: table.cost.evaluations,
            columns: table.columns.iter().map(|column| column.name).collect(),
            rows: table.rows().map(|(_, row)| row).collect(),
        }),
        Err(told) => Answer::Refused(told),
    }
}

/// The quaternion as the library holds it: its start is the doubles of these.
pub fn held([w, x, y, z]: [f64; 4]) -> [f64; 4] {
    let attitude = Attitude::from_quaternion(w, x, y, z).expect("a direction");
    let q = attitude.quaternion();
    [q.w, q.i, q.j, q.k]
}

/// More evaluations than any run needs that succeeds. Where a loose tolerance throws the state far off, the equations may ask for steps without end.
const MOST: u64 = 20_000_000;

/// State and evaluations of one run of order 8 to the time, if it gets there.
pub fn order_eight_once<const N: usize>(
    rate: impl Fn(&[f64; N]) -> [f64; N],
    start: &[f64; N],
    scales: &[f64; N],
    time: f64,
    tolerance: f64,
) -> Option<([f64; N], u64)> {
    let spent = Cell::new(0);
    let system = |_: f64, y: &[f64; N]| {
        spent.set(spent.get() + 1);
        match spent.get() > MOST {
            true => [f64::NAN; N],
            false => rate(y),
        }
    };
    let effort = Effort::Tolerance(tolerance);
    let run = order_eight(&system, Kept::Nothing, start, scales, &[time], effort).ok()?;
    Some((run.states[0], run.cost.evaluations))
}
