//! A scene of any kind as a motion on which methods are measured: two methods of different families provide the truth.

use core::f64::consts::TAU;

use spinning_bodies::frame::Attitude;
use spinning_bodies::integrators::{Effort, Method};
use spinning_bodies::scene::{AnyScene, Choice, Geometric, Request, Solver, Table};
use spinning_bodies::{Error, Result};

use super::candidate::efforts;
use super::measure::Trial;
use super::sample::{Apart, known};
use crate::general::DifferentialEquations;

/// The possible judges: a closed form, whole or from event to event; order 8; Verner's pair of order 9(8), of another family and implementation.
const JUDGES: [Solver; 4] = [
    Solver::Exact,
    Solver::Events,
    Solver::Geometric(Geometric::DormandPrince8),
    Solver::General(Method::Verner98),
];
/// The tolerance of judges that step.
const TIGHTEST: Effort = Effort::Tolerance(1e-15);
/// Number of times at which the judges are compared, the last being the end.
const SAMPLES: u32 = 16;
/// Greatest disagreement of judges: the coarsest accuracy in the tables.
const COARSEST: f64 = 1e-3;
/// The floor, as a multiple of the disagreement of the judges.
const TOLD: f64 = 10.0;

/// A scene from its start to its end, with the end state according to the first two judges that can run it.
///
/// A closed form also states its own error, and no smaller one is reported for it; where no method with steps can run, it is the only judge.
#[derive(Debug)]
pub struct JudgedScene {
    scene: AnyScene,
    /// The request for the state at the end.
    asked: Request,
    judges: Vec<Solver>,
    floor: f64,
    /// About the number of turns; 0 where nothing turns.
    turns: f64,
    truth: Vec<f64>,
    ruler: Ruler,
}

impl JudgedScene {
    /// The scene from time 0 to `end`, s. Among its usual columns the attitude's quaternion is compared, and the rates: all those in rad/s or,
    /// if there are none, all those in m/s.
    ///
    /// # Errors
    /// [`Error::Condition`] for a motion on which its judges disagree by more than 1e-3; that of the scene if none can run it.
    pub fn new(scene: AnyScene, end: f64) -> Result<Self> {
        let named = |wanted: &dyn Fn(&str, &str) -> bool| -> Vec<&'static str> {
            let usual = scene.columns().iter().filter(|column| column.usual);
            let found = usual.filter(|column| wanted(column.name, column.unit));
            found.map(|column| column.name).collect()
        };
        let attitude = named(&|name, _| ["qw", "qx", "qy", "qz"].contains(&name));
        let turning = named(&|_, unit| unit == "rad/s");
        let moving = named(&|_, unit| unit == "m/s");
        let turns = !turning.is_empty();
        let rates = if turns { turning } else { moving };
        let told = [&attitude[..], &rates].concat();
        let mut ruler = Ruler {
            rates: attitude.len(),
            fastest: 0.0,
        };
        let scene = scene.telling(&told).map_err(|_| NONE)?;

        let times = (1..=SAMPLES).map(|k| end * f64::from(k) / f64::from(SAMPLES));
        let request = Request::at(times.collect::<Vec<f64>>())?.in_one_run(TIGHTEST);
        let (mut judges, mut tables, mut refused) = (Vec::new(), Vec::<Table>::new(), NONE);
        for solver in JUDGES {
            let closed_twice = solver == Solver::Events && !judges.is_empty();
            if judges.len() == 2 || closed_twice {
                continue;
            }
            match scene.simulate(&by(&request, solver)) {
                Ok(table) => {
                    judges.push(solver);
                    tables.push(table);
                }
                Err(error) => refused = error,
            }
        }
        let truth = tables.first().ok_or(refused)?;
        let speeds = truth.rows().map(|(_, row)| size(&row[ruler.rates..]));
        ruler.fastest = speeds.fold(0.0, f64::max);
        let apart = tables.get(1).map_or(truth.error_estimate, |other| {
            let pairs = truth.rows().zip(other.rows());
            let apart = pairs.map(|((_, a), (_, b))| ruler.apart(&a, &b));
            apart.fold(0.0, |most: f64, Apart { attitude, omega }| {
                most.max(attitude).max(omega)
            })
        });
        if apart > COARSEST {
            return Err(Error::Condition {
                condition: "the two methods that judge a scene must agree to 1e-3 at their tightest; an earlier end may do",
                value: apart,
            });
        }
        Ok(Self {
            truth: truth.row(SAMPLES as usize - 1).1,
            floor: TOLD * apart.max(f64::EPSILON),
            turns: if turns {
                ruler.fastest * end / TAU
            } else {
                0.0
            },
            asked: Request::at([end])?,
            scene,
            judges,
            ruler,
        })
    }

    /// The judges, the more reliable one first.
    pub fn judges(&self) -> &[Solver] {
        &self.judges
    }

    /// The greatest error that cannot be distinguished from that of the truth: ten times the disagreement of the judges.
    pub const fn floor(&self) -> f64 {
        self.floor
    }

    /// The last time, s.
    pub fn end(&self) -> f64 {
        self.asked.times()[0]
    }

    /// Whether there is an attitude whose error is measured; if not, only rates are.
    pub const fn has_attitude(&self) -> bool {
        self.ruler.rates > 0
    }

    /// The efforts at which a solver runs this scene, from coarse to fine.
    pub fn efforts(&self, solver: Solver) -> Vec<Effort> {
        efforts(solver, self.end(), self.turns)
    }

    /// The trial of this solver on the scene, under this name. A run that exceeds this number of evaluations fails.
    pub fn trial<'a>(
        &'a self,
        name: &'a str,
        solver: Solver,
        efforts: &'a [Effort],
        most: u64,
    ) -> Trial<'a, Table> {
        let request = by(&self.asked, solver).within(most);
        Trial {
            names: [name, solver.name()],
            efforts,
            floor: self.floor,
            lost: self
                .ruler
                .apart(&self.truth, &vec![f64::NAN; self.truth.len()]),
            run: Box::new(move |effort| {
                let table = self.scene.simulate(&request.clone().in_one_run(effort))?;
                let cost = table.cost;
                Ok((table, cost))
            }),
            apart: Box::new(|table| {
                let Apart { attitude, omega } = self.ruler.apart(&self.truth, &table.row(0).1);
                // For a closed form an error that does not exist stays NaN.
                let told = |error: f64| match table.error_estimate {
                    own if own.is_finite() && own > error => own,
                    _ => error,
                };
                Apart {
                    attitude: told(attitude),
                    omega: told(omega),
                }
            }),
        }
    }
}

/// The error if no judge returned another.
const NONE: Error = Error::Empty {
    quantity: "the list of methods that can judge a scene",
};

fn by(request: &Request, solver: Solver) -> Request {
    let request = request.clone().by(Choice::Use(solver));
    request.with_methods(&DifferentialEquations)
}

/// The comparison of two rows.
#[derive(Debug)]
struct Ruler {
    /// Index of the first rate: after the quaternion, if there is one.
    rates: usize,
    /// The greatest norm of the rates.
    fastest: f64,
}

impl Ruler {
    fn apart(&self, truth: &[f64], row: &[f64]) -> Apart {
        let (_, rates) = row.split_at(self.rates);
        let gaps: Vec<f64> = truth[self.rates..]
            .iter()
            .zip(rates)
            .map(|(a, b)| a - b)
            .collect();
        let gap = size(&gaps);
        let attitude = match (attitude(truth), attitude(row)) {
            _ if self.rates == 0 => f64::NAN,
            (Some(truth), Some(here)) => truth.angle_to(&here),
            _ => f64::INFINITY,
        };
        let omega = match rates {
            [] => f64::NAN,
            // The scene is at rest all the time.
            _ if gap == 0.0 => 0.0,
            _ => known(gap / self.fastest),
        };
        Apart { attitude, omega }
    }
}

/// The attitude from the first four numbers.
fn attitude(row: &[f64]) -> Option<Attitude> {
    let &[w, x, y, z, ..] = row else { return None };
    Attitude::from_quaternion(w, x, y, z).ok()
}

/// √Σx².
fn size(numbers: &[f64]) -> f64 {
    numbers.iter().copied().fold(0.0, f64::hypot)
}
