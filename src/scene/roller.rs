//! The scene `roller` (tutorial 4.3 and 4.5): a round body on a table, after the cue or on a sheet that is withdrawn.
//!
//! | effect | type | what it does |
//! |---|---|---|
//! | friction | [`Coulomb`] | against the slip on the table, until it rolls |
//! | resistance | [`RollingResistance`] | a couple against the turning, until it rests |
//! | sheet | [`Sheet`] | a moving ground under the body, until its edge has passed |
//!
//! Without any of them it glides and turns as it started.

use super::choose;
use super::{Absent, Choice, Effect, Motion, Plan, Request, Scene, Solver, Tabulated, balanced};
use crate::conservation::{Law, Ledger};
use crate::error::{Error, Result, positive};
use crate::integrators::{Cost, Effort, Method};
use crate::rolling::course::{
    Coulomb, Course, Friction, Load, Moment, Nothing, Resistance, RollingResistance,
};
use crate::rolling::integrated::integrated;
use crate::rolling::sheet::{Sheet, Support};
use crate::rolling::{RoundBody, Shot};

impl Effect for Coulomb {
    const PRESENT: bool = true;
    const NAME: &'static str = "friction";
}

impl Effect for RollingResistance {
    const PRESENT: bool = true;
    const NAME: &'static str = "resistance";
}

impl Effect for Sheet<'_> {
    const PRESENT: bool = true;
    const NAME: &'static str = "sheet";
}

impl Friction for Absent {
    const ACTS: bool = false;
    fn kinetic(&self) -> f64 {
        Nothing.kinetic()
    }
    fn grip(&self) -> f64 {
        Nothing.grip()
    }
}

impl Resistance for Absent {
    const ACTS: bool = false;
    fn arm(&self) -> f64 {
        Nothing.arm()
    }
}

impl Support for Absent {
    const ACTS: bool = false;
    fn leg(&self, index: usize) -> ((f64, f64), (f64, f64)) {
        Nothing.leg(index)
    }
    fn law(&self) -> Coulomb {
        Nothing.law()
    }
    fn margin(&self) -> f64 {
        Nothing.margin()
    }
}

/// A round body on a level table.
#[derive(Debug, Clone, Copy)]
pub struct Roller<F = Absent, C = Absent, S = Absent> {
    body: RoundBody,
    gravity: f64,
    start: Moment,
    friction: F,
    resistance: C,
    sheet: S,
}

impl Roller {
    /// A body pressed on the table by gravity (m/s²), with this velocity and rim speed (m/s).
    ///
    /// # Errors
    /// [`Error::NotPositive`] for gravity; [`Error::NotFinite`].
    pub fn new(body: RoundBody, gravity: f64, velocity: f64, rim_speed: f64) -> Result<Self> {
        Self::starting(body, gravity, Moment::moving(velocity, rim_speed))
    }

    /// The body of a [`Shot`] just after the stroke, its slip taken from the height of the stroke.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn after(shot: &Shot, gravity: f64) -> Result<Self> {
        let start = Moment {
            slip: shot.slip(),
            ..Moment::moving(shot.velocity(), shot.rim_speed())
        };
        Self::starting(shot.body(), gravity, start)
    }

    fn starting(body: RoundBody, gravity: f64, start: Moment) -> Result<Self> {
        crate::error::finite("the velocity", start.velocity)?;
        crate::error::finite("the rim speed", start.rim_speed)?;
        Ok(Self {
            body,
            gravity: positive("the acceleration of gravity", gravity)?,
            start,
            friction: Absent,
            resistance: Absent,
            sheet: Absent,
        })
    }
}

impl<F, C, S> Roller<F, C, S> {
    /// The same with friction on the table.
    pub fn with_friction<G>(self, friction: G) -> Roller<G, C, S> {
        let Self {
            body,
            gravity,
            start,
            resistance,
            sheet,
            ..
        } = self;
        Roller {
            body,
            gravity,
            start,
            friction,
            resistance,
            sheet,
        }
    }

    /// The same with rolling resistance.
    pub fn with_resistance<D>(self, resistance: D) -> Roller<F, D, S> {
        let Self {
            body,
            gravity,
            start,
            friction,
            sheet,
            ..
        } = self;
        Roller {
            body,
            gravity,
            start,
            friction,
            resistance,
            sheet,
        }
    }

    /// The same on a sheet.
    pub fn with_sheet<T>(self, sheet: T) -> Roller<F, C, T> {
        let Self {
            body,
            gravity,
            start,
            friction,
            resistance,
            ..
        } = self;
        Roller {
            body,
            gravity,
            start,
            friction,
            resistance,
            sheet,
        }
    }
}

impl<F: Friction, C: Resistance, S: Support> Roller<F, C, S> {
    /// Everything that happens up to a time (s), as closed forms from event to event.
    ///
    /// # Errors
    /// As [`Course::new`].
    pub fn course(&self, until: f64) -> Result<Course> {
        let effects = (self.friction, self.resistance, self.sheet);
        Course::new(self.kappa(), self.load(), effects, self.begin(), until)
    }

    fn kappa(&self) -> f64 {
        self.body.inertia_factor()
    }

    fn load(&self) -> Load {
        Load::weight(self.gravity)
    }

    fn begin(&self) -> Moment {
        let mut start = self.start;
        if S::ACTS {
            start.slip -= self.sheet.leg(0).0.1;
        }
        start
    }
}

/// A body on the table at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rolling {
    /// Where it is and how it moves.
    pub moment: Moment,
    /// Kinetic energy, J.
    pub energy: f64,
    /// Heat so far, J.
    pub heat: f64,
}

impl Tabulated for Rolling {
    /// m; m/s (rim_speed is RΩ, slip that of the contact over the ground under it); J.
    const COLUMNS: &'static [&'static str] =
        &["x", "velocity", "rim_speed", "slip", "energy", "heat"];

    fn row(&self) -> Vec<f64> {
        let m = &self.moment;
        vec![
            m.position,
            m.velocity,
            m.rim_speed,
            m.slip,
            self.energy,
            self.heat,
        ]
    }
}

impl<F, C, S> Scene for Roller<F, C, S>
where
    F: Effect + Friction,
    C: Effect + Resistance,
    S: Effect + Support,
{
    type State = Rolling;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let alone = !F::PRESENT && !C::PRESENT && !S::PRESENT;
        let why = match (F::PRESENT || S::PRESENT, C::PRESENT) {
            (true, _) => "sliding friction",
            (false, true) => "rolling resistance",
            (false, false) => "no force along the table",
        };
        planned(request, alone, why)
    }

    fn simulate(&self, request: &Request) -> Result<Motion<Rolling>> {
        let plan = self.plan(request)?;
        let (order, times) = request.forward()?;
        let effects = (self.friction, self.resistance, self.sheet);
        let (moments, cost) = match plan.solver {
            Solver::General(method) => {
                let effort = effort(method, request, &times);
                let run = integrated(
                    self.kappa(),
                    self.load(),
                    effects,
                    self.begin(),
                    &times,
                    (method, effort),
                )?;
                (run.moments, run.cost)
            }
            _ => closed(&self.course(last(&times))?, &times),
        };
        let mass = self.body.mass();
        let ledger = accounts(
            mass,
            self.kappa(),
            &self.begin(),
            &moments,
            |books| {
                if !C::PRESENT {
                    books.momentum("angular momentum about the table", |_, m| {
                        m.about_the_table(self.kappa())
                    })?;
                }
                books.energy(Law::Conserved)?;
                if !S::PRESENT {
                    books.loss()?;
                }
                Ok(())
            },
            &times,
        )?;
        let states = moments.iter().map(|moment| Rolling {
            moment: *moment,
            energy: mass * moment.energy(self.kappa()),
            heat: mass * moment.heat,
        });
        Ok(Motion {
            error_estimate: None,
            plan,
            cost,
            ledger: balanced(ledger, request.accuracy())?,
            rows: in_order(request, &order, states),
        })
    }
}

/// The plan of a body under dry friction.
pub(super) fn planned(request: &Request, alone: bool, why: &str) -> Result<Plan> {
    match request.choice() {
        Choice::Auto if alone => Ok(Plan::new(Solver::Exact, format!("{why}: closed form"))),
        Choice::Auto => Ok(Plan::new(
            Solver::Events,
            format!("{why}: closed form from event to event"),
        )),
        Choice::Use(Solver::Exact) if !alone => Err(Error::Solver {
            condition: "the solver exact needs a scene without friction, resistance, pull or sheet; ask for events",
        }),
        Choice::Use(Solver::General(method)) => Ok(Plan::new(
            Solver::General(method),
            format!("{why}: {} with events, as asked for", method.name()),
        )),
        Choice::Use(Solver::Geometric(_)) => Err(super::only_for_tops()),
        Choice::Use(solver) => Ok(Plan::new(solver, "as asked for")),
    }
}

pub(super) fn last(times: &[f64]) -> f64 {
    times.last().copied().unwrap_or(0.0)
}

pub(super) fn closed(course: &Course, times: &[f64]) -> (Vec<Moment>, Cost) {
    let cost = Cost {
        evaluations: 0,
        steps: course.stretches() as u64,
    };
    (times.iter().map(|&t| course.at(t)).collect(), cost)
}

/// How hard a general method must work. Between events these motions are polynomials, so no more is needed than a margin.
pub(super) fn effort(method: Method, request: &Request, times: &[f64]) -> Effort {
    if method.is_adaptive() {
        Effort::Tolerance((0.01 * request.accuracy()).max(1e-15))
    } else {
        Effort::Step((last(times) / 64.0).max(f64::MIN_POSITIVE))
    }
}

pub(super) fn in_order<T>(
    request: &Request,
    order: &[usize],
    states: impl Iterator<Item = T>,
) -> Vec<(f64, T)> {
    let mut rows: Vec<(usize, T)> = order.iter().copied().zip(states).collect();
    rows.sort_by_key(|row| row.0);
    let times = request.times();
    rows.into_iter()
        .map(|(i, state)| (times[i], state))
        .collect()
}

/// The books of a body under dry friction, per scene.
pub(super) struct Books<'a> {
    ledger: Ledger,
    mass: f64,
    kappa: f64,
    start: &'a Moment,
    moments: &'a [Moment],
    times: &'a [f64],
}

pub(super) fn accounts(
    mass: f64,
    kappa: f64,
    start: &Moment,
    moments: &[Moment],
    fill: impl FnOnce(&mut Books<'_>) -> Result<()>,
    times: &[f64],
) -> Result<Ledger> {
    let mut books = Books {
        ledger: Ledger::new(),
        mass,
        kappa,
        start,
        moments,
        times,
    };
    fill(&mut books)?;
    Ok(books.ledger)
}

impl Books<'_> {
    /// The largest of a quantity; of a motion without any of it, one.
    fn scale(&self, size: impl Fn(&Moment) -> f64) -> f64 {
        let all = self.moments.iter().chain([self.start]);
        let largest = all.map(size).fold(0.0, f64::max);
        if largest > 0.0 { largest } else { 1.0 }
    }

    /// A conserved quantity with the dimension of a velocity, given the time.
    pub(super) fn momentum(
        &mut self,
        name: &'static str,
        value: impl Fn(f64, &Moment) -> f64,
    ) -> Result<()> {
        let kappa = self.kappa;
        let scale = self.scale(|m| m.velocity.abs() + kappa * m.rim_speed.abs());
        let first = self.mass * value(0.0, self.start);
        let scale = self.mass * scale;
        let account = self
            .ledger
            .open_scaled(name, Law::Conserved, first, scale)?;
        for (&t, moment) in self.times.iter().zip(self.moments) {
            self.ledger.record(account, self.mass * value(t, moment))?;
        }
        Ok(())
    }

    /// Energy plus heat less work.
    pub(super) fn energy(&mut self, law: Law) -> Result<()> {
        let (mass, kappa) = (self.mass, self.kappa);
        let total = |m: &Moment| mass * (m.energy(kappa) + m.heat - m.work);
        let scale = mass * self.scale(|m| m.energy(kappa) + m.heat + m.work.abs());
        let name = "energy plus heat less work";
        let account = self
            .ledger
            .open_scaled(name, law, total(self.start), scale)?;
        for moment in self.moments {
            self.ledger.record(account, total(moment))?;
        }
        Ok(())
    }

    /// Kinetic energy, which friction can only lower.
    pub(super) fn loss(&mut self) -> Result<()> {
        let (mass, kappa) = (self.mass, self.kappa);
        let first = mass * self.start.energy(kappa);
        let scale = mass * self.scale(|m| m.energy(kappa));
        let law = Law::NonIncreasing;
        let account = self
            .ledger
            .open_scaled("kinetic energy", law, first, scale)?;
        for moment in self.moments {
            self.ledger.record(account, mass * moment.energy(kappa))?;
        }
        Ok(())
    }
}

/// Simulates `roller` with those of the effects that are listed: one compiled scene a combination.
///
/// # Errors
/// As for [`Scene::simulate`].
pub fn listed(
    roller: Roller,
    friction: Option<Coulomb>,
    resistance: Option<RollingResistance>,
    sheet: Option<Sheet<'_>>,
    request: &Request,
) -> Result<Motion<Rolling>> {
    choose!((friction = friction) (resistance = resistance) (sheet = sheet) => roller
        .with_friction(friction)
        .with_resistance(resistance)
        .with_sheet(sheet)
        .simulate(request))
}
