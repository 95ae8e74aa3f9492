//! The methods that can run a problem, and the efforts at which each is run.

use spinning_bodies::Result;
use spinning_bodies::integrators::geometric::{
    FreeSplitting, GroupMidpoint, HeavySplitting, MoserVeselov, MuntheKaas, Order, Torque,
    VeselovOrder, Weight,
};
use spinning_bodies::integrators::{Effort, Method};
use spinning_bodies::scene::{Geometric, Solver};

use super::ClosedForm;
use super::problem::{Model, Problem};
use super::table_top::Sliding;
use crate::follow::{DormandPrince8, Follow};
use crate::general::GeneralMethod;

/// A method for a problem, with its efforts from coarse to beyond what rounding allows.
#[derive(Debug)]
pub struct Candidate {
    /// The name in the tables: `exact`, `rk4`, `kick-drift-6`, …
    pub name: String,
    /// The method.
    pub method: Box<dyn Follow>,
    /// The efforts at which it is run, from coarse to fine.
    pub efforts: Vec<Effort>,
}

/// The methods that can run a problem: closed form where there is one, geometric ones, those of the crate `differential-equations`.
///
/// # Errors
/// Those of invalid moments and levers.
pub fn candidates(problem: &Problem) -> Result<Vec<Candidate>> {
    let mut found = Found {
        problem,
        candidates: Vec::new(),
    };
    match *problem.model() {
        Model::Top { moments, lever } => {
            if let Ok(exact) = ClosedForm::new(moments, lever) {
                found.add("exact", exact, vec![Effort::Tolerance(0.0)]);
            }
            if lever == [0.0; 3] {
                found.free(moments)?;
            } else {
                found.heavy(moments, lever)?;
            }
        }
        Model::Table(ball) => {
            for method in Method::ALL {
                let general = Some(method);
                found.general(method, Sliding { ball, general });
            }
            let ours = Sliding {
                ball,
                general: None,
            };
            found.add("dormand-prince-8", ours, tolerances());
        }
    }
    Ok(found.candidates)
}

struct Found<'a> {
    problem: &'a Problem,
    candidates: Vec<Candidate>,
}

impl Found<'_> {
    fn add(
        &mut self,
        name: impl Into<String>,
        method: impl Follow + 'static,
        efforts: Vec<Effort>,
    ) {
        self.candidates.push(Candidate {
            name: name.into(),
            method: Box::new(method),
            efforts,
        });
    }

    fn stepped(&mut self, name: impl Into<String>, method: impl Follow + 'static) {
        let efforts = steps(self.problem.end(), self.problem.turns(), &[1.0, 1.5]);
        self.add(name, method, efforts);
    }

    fn general(&mut self, method: Method, follow: impl Follow + 'static) {
        let (end, turns) = (self.problem.end(), self.problem.turns());
        let efforts = efforts(Solver::General(method), end, turns);
        self.add(method.name(), follow, efforts);
    }

    fn free(&mut self, moments: [f64; 3]) -> Result<()> {
        for order in Order::ALL {
            let method = FreeSplitting::new(moments, order)?;
            self.stepped(format!("rotations-{}", order as u32), method);
        }
        for order in VeselovOrder::ALL {
            let method = MoserVeselov::new(moments, order)?;
            self.stepped(format!("moser-veselov-{}", order as u32), method);
        }
        self.stepped("midpoint-2", GroupMidpoint::new(moments)?);
        self.any_torque(moments, ())
    }

    fn heavy(&mut self, moments: [f64; 3], lever: [f64; 3]) -> Result<()> {
        let weight = Weight::new(lever)?;
        for order in Order::ALL {
            let method = HeavySplitting::new(moments, weight, order)?;
            self.stepped(format!("kick-drift-{}", order as u32), method);
        }
        self.any_torque(moments, weight)
    }

    fn any_torque<N: Torque<f64> + Copy + core::fmt::Debug + 'static>(
        &mut self,
        moments: [f64; 3],
        torque: N,
    ) -> Result<()> {
        self.stepped("munthe-kaas-4", MuntheKaas::new(moments, torque)?);
        for method in Method::ALL {
            self.general(method, GeneralMethod::new(moments, torque, method)?);
        }
        let ours = DormandPrince8::new(moments, torque)?;
        self.add("dormand-prince-8", ours, tolerances());
        Ok(())
    }
}

/// The efforts at which a solver of scenes is run on a motion of this length (s) and about this number of turns.
pub(super) fn efforts(solver: Solver, end: f64, turns: f64) -> Vec<Effort> {
    match solver {
        Solver::Exact | Solver::Events => vec![Effort::Tolerance(0.0)],
        // The crate counts time from 0 to 1, where a third is not a double, so there is only one multiple.
        Solver::General(Method::Rk4 | Method::Gauss) => steps(end, turns, &[1.0]),
        Solver::General(_)
        | Solver::Geometric(Geometric::DormandPrince8 | Geometric::PowerSeries) => tolerances(),
        _ => steps(end, turns, &[1.0, 1.5]),
    }
}

/// Three to a decade, down to where the error of a step is rounding: finer than the differences between methods. Below 1e-15 a method may fail to find
/// a step, because of rounding.
fn tolerances() -> Vec<Effort> {
    const DECADES: [f64; 14] = [
        1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15,
    ];
    let within = |decade: f64| [decade, 0.5 * decade, 0.2 * decade].map(Effort::Tolerance);
    DECADES
        .into_iter()
        .flat_map(within)
        .take(3 * DECADES.len() - 2)
        .collect()
}

/// Steps from about two a turn upward: the run in 2ᵏ parts, times each of the `multiples`. With 1.5 these are 3·2ᵏ parts, whose steps for the listed
/// problems are exact doubles too: they add up to the run without rounding of time.
fn steps(end: f64, turns: f64, multiples: &[f64]) -> Vec<Effort> {
    const MOST: f64 = 1e9;
    const MOST_A_TURN: f64 = 131_072.0;
    let least = (2.0 * turns).max(4.0).log2().floor();
    let most = (MOST_A_TURN * turns.max(1.0)).min(MOST);
    let mut count = least.exp2();
    let mut efforts = Vec::new();
    while count <= most {
        let parts = multiples.iter().map(|multiple| multiple * count);
        efforts.extend(parts.map(|parts| Effort::Step(end / parts)));
        count *= 2.0;
    }
    efforts
}
