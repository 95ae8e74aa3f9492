//! A strip, run: compiled once for all lists of effects, which come as [`Acting`] behind a pointer.

use super::{StripStart, StripState};
use crate::conservation::{Law, Ledger};
use crate::error::{Error, Result, finite};
use crate::falling_strip::{Pieces, Plate, in_pieces};
use crate::integrators::{Cost, Effort, Method, System, tightened};
use crate::scene::motion::{Motion, Request, balanced};
use crate::scene::plan::{Choice, Plan, Solver};
use crate::scene::{Budget, Counted};

/// Equations of a strip under some list of effects. The state is x, y, θ, u, w, ω and heat.
pub(super) trait Acting: Pieces {
    /// The strip.
    fn plate(&self) -> &Plate;
    /// g, m/s².
    fn gravity(&self) -> f64;
    /// Energy of the motion, that of the fluid taken along included, J/m.
    fn kinetic_energy(&self, y: &[f64; 7]) -> f64;
    /// Energy at this height, J/m.
    fn potential(&self, height: f64) -> f64;
    /// Impulse of strip and fluid, kg/s.
    fn impulse(&self, y: &[f64; 7]) -> [f64; 2];
    /// What of the fluid is in the list.
    fn acting(&self) -> List;
}

/// Which effects of the fluid are listed.
#[derive(Debug, Clone, Copy)]
pub(super) struct List {
    pub lift: bool,
    pub drag: bool,
    pub damping: bool,
    pub added_mass: bool,
}

impl List {
    const fn nothing_of_the_fluid(self) -> bool {
        !(self.lift || self.drag || self.damping || self.added_mass)
    }
}

/// A strip, how it starts, and its equations.
#[derive(Clone, Copy)]
pub(super) struct Setting<'a> {
    pub equations: &'a dyn Acting,
    pub start: StripStart,
}

impl Setting<'_> {
    pub fn plan(&self, request: &Request) -> Result<Plan> {
        let acting = self.equations.acting();
        let vacuum = acting.nothing_of_the_fluid();
        let solver = match request.choice() {
            Choice::Use(solver) => solver,
            Choice::Auto if vacuum => Solver::Exact,
            Choice::Auto => Solver::General(Method::Dop853),
        };
        let reason = match solver {
            Solver::Exact if vacuum => "a vacuum: closed form",
            Solver::Exact | Solver::Events | Solver::Geometric(_) => {
                return Err(Error::Solver {
                    condition: "the solver must be a general one for a strip in a fluid, which has no closed form",
                });
            }
            Solver::General(_) if vacuum => "asked for, though a vacuum has a closed form",
            Solver::General(_) => "forces of a fluid: general integration",
        };
        if acting.drag {
            request.forward()?;
        }
        Ok(Plan::new(solver, reason))
    }

    pub fn motion(&self, request: &Request) -> Result<Motion<StripState>> {
        let plan = self.plan(request)?;
        let times = request.times();
        let scales = self.scales();
        let (rows, cost) = match plan.solver {
            Solver::General(method) => {
                let budget = Budget::asked(request);
                let paid = Paid {
                    pieces: self.equations as &dyn Pieces,
                    whole: budget.counted(self.equations.whole()),
                };
                let first = self.first();
                integrated(&paid, &first, &scales, times, method, request.accuracy())?
            }
            _ => {
                let rows = times.iter().map(|&t| self.in_vacuum(t)).collect();
                (rows, Cost::default())
            }
        };
        for y in &rows {
            for &component in y {
                finite("the state of the strip", component)?;
            }
        }
        let ledger = self.ledger(times, &rows, request.accuracy())?;
        let states = rows.iter().map(|y| self.state(y));
        Ok(Motion {
            error_estimate: None,
            plan,
            cost,
            ledger,
            rows: times.iter().copied().zip(states).collect(),
        })
    }

    fn first(&self) -> [f64; 7] {
        let StripStart {
            angle,
            velocity: [vx, vy],
            omega,
        } = self.start;
        let (sine, cosine) = angle.sin_cos();
        let along = vx * cosine + vy * sine;
        let across = vy * cosine - vx * sine;
        [0.0, 0.0, angle, along, across, omega, 0.0]
    }

    /// The parabola.
    fn in_vacuum(&self, t: f64) -> [f64; 7] {
        let StripStart {
            angle,
            velocity: [vx, vy],
            omega,
        } = self.start;
        let g = self.equations.gravity();
        let theta = angle + omega * t;
        let (sine, cosine) = theta.sin_cos();
        let now = vy - g * t;
        let (along, across) = (vx * cosine + now * sine, now * cosine - vx * sine);
        let height = t * (vy - 0.5 * g * t);
        [vx * t, height, theta, along, across, omega, 0.0]
    }

    fn state(&self, y: &[f64; 7]) -> StripState {
        let (sine, cosine) = y[2].sin_cos();
        let potential = self.equations.potential(y[1]);
        StripState {
            position: [y[0], y[1]],
            angle: y[2],
            velocity: [y[3] * cosine - y[4] * sine, y[3] * sine + y[4] * cosine],
            omega: y[5],
            energy: self.equations.kinetic_energy(y) + potential,
            heat: y[6],
        }
    }

    /// Sizes of the state: a, 1, a speed, a rate, an energy.
    fn scales(&self) -> [f64; 7] {
        let plate = self.equations.plate();
        let a = plate.half_chord();
        let g = self.equations.gravity().abs();
        let [vx, vy] = self.start.velocity;
        let speed = (g * a).sqrt() + vx.hypot(vy) + a * self.start.omega.abs();
        // A strip that nothing moves has no speed; any will do.
        let speed = if speed > 0.0 { speed } else { 1.0 };
        let energy = plate.mass() * speed * speed;
        [a, a, 1.0, speed, speed, speed / a, energy]
    }

    fn ledger(&self, times: &[f64], rows: &[[f64; 7]], accuracy: f64) -> Result<Ledger> {
        let acting = self.equations.acting();
        let mut order: Vec<usize> = (0..times.len()).collect();
        order.sort_by(|&i, &j| times[i].total_cmp(&times[j]));
        let first = self.first();
        let start = self.state(&first);
        let [px, py] = self.equations.impulse(&first);
        let mut energy_scale = self.scales()[6];
        let mut impulse_scale = energy_scale / self.scales()[3];
        let weight = self.equations.plate().mass() * self.equations.gravity();
        for (y, t) in rows.iter().zip(times) {
            energy_scale = energy_scale.max(self.equations.kinetic_energy(y) + y[6]);
            impulse_scale = impulse_scale.max((weight * t).abs());
        }
        let mut ledger = Ledger::new();
        let balance = ledger.open_scaled(
            "energy and heat",
            Law::Conserved,
            start.energy,
            energy_scale,
        )?;
        let heat = if acting.drag || acting.damping {
            let name = "heat";
            Some(ledger.open_scaled(name, Law::NonDecreasing, 0.0, energy_scale)?)
        } else {
            None
        };
        // Without lift and drag only the weight changes the impulse of plate and fluid.
        let impulse = if acting.lift || acting.drag {
            None
        } else {
            let name = "horizontal impulse";
            let horizontal = ledger.open_scaled(name, Law::Conserved, px, impulse_scale)?;
            let name = "vertical impulse and that of the weight";
            let vertical = ledger.open_scaled(name, Law::Conserved, py, impulse_scale)?;
            Some((horizontal, vertical))
        };
        for i in order {
            let state = self.state(&rows[i]);
            ledger.record(balance, state.energy + state.heat)?;
            if let Some(heat) = heat {
                ledger.record(heat, state.heat)?;
            }
            if let Some((horizontal, vertical)) = impulse {
                let [x, y] = self.equations.impulse(&rows[i]);
                ledger.record(horizontal, x)?;
                ledger.record(vertical, y + weight * times[i])?;
            }
        }
        balanced(ledger, accuracy)
    }
}

/// Equations whose evaluations are counted.
struct Paid<'a> {
    pieces: &'a dyn Pieces,
    whole: Counted<'a, dyn System<7> + 'a>,
}

impl Pieces for Paid<'_> {
    fn rate_in(&self, sense: f64, state: &[f64; 7]) -> [f64; 7] {
        self.whole.budget.count(1);
        self.pieces.rate_in(sense, state)
    }

    fn has_kink(&self) -> bool {
        self.pieces.has_kink()
    }

    fn whole(&self) -> &dyn System<7> {
        &self.whole
    }
}

/// All rows by a general method: with a verified error where the method chooses its steps.
fn integrated(
    system: &dyn Pieces,
    first: &[f64; 7],
    scales: &[f64; 7],
    times: &[f64],
    method: Method,
    accuracy: f64,
) -> Result<(Vec<[f64; 7]>, Cost)> {
    // Everything but the heat, which the energy vouches for.
    let distance = |a: &[f64; 7], b: &[f64; 7]| {
        (0..6)
            .map(|i| (a[i] - b[i]).abs() / (scales[i] + a[i].abs()))
            .fold(0.0, f64::max)
    };
    let run = if method.is_adaptive() {
        // Turning back is a kink of the resistance, which no step may cross.
        let run = |tolerance: f64| {
            let effort = Effort::Tolerance(tolerance);
            in_pieces(system, first, scales, times, method, effort)
        };
        tightened(run, accuracy, distance)?
    } else {
        // An error of order step⁴, with the fastest motion of the scales as its unit of time.
        let step = 0.1 * accuracy.powf(0.25) * scales[0] / scales[3];
        let effort = Effort::Step(step);
        in_pieces(system, first, scales, times, method, effort)?
    };
    Ok((run.states, run.cost))
}
