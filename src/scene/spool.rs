//! The scene `spool` (tutorial 4.4): a spool on a table, tugged at its string.
//!
//! | effect | type | what it does |
//! |---|---|---|
//! | tug | [`Tug`] | a steady pull at the string, which winds or unwinds |
//! | friction | [`Coulomb`] | holds the contact, or rubs if the tug is too hard |
//! | resistance | [`RollingResistance`] | a couple against the turning |

use super::choose;
use super::roller::{accounts, closed, effort, in_order, last, planned};
use super::{Absent, Effect, Motion, Plan, Request, Scene, Solver, Tabulated, balanced};
use crate::conservation::Law;
use crate::error::{Result, positive};
use crate::rolling::course::{
    Coulomb, Course, Friction, Load, Moment, Resistance, RollingResistance,
};
use crate::rolling::integrated::integrated;
use crate::rolling::spool::{Spool, Tug};

/// A pull at the string, or none.
pub trait Pull: Copy {
    /// What it loads the spool with.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) where the spool is lifted.
    fn load(&self, spool: &Spool, gravity: f64) -> Result<Load>;
}

impl Pull for Tug {
    fn load(&self, spool: &Spool, gravity: f64) -> Result<Load> {
        spool.load(*self, gravity)
    }
}

impl Pull for Absent {
    fn load(&self, _: &Spool, gravity: f64) -> Result<Load> {
        Ok(Load::weight(gravity))
    }
}

impl Effect for Tug {
    const PRESENT: bool = true;
    const NAME: &'static str = "tug";
}

/// A spool on a level table, from rest or already moving.
#[derive(Debug, Clone, Copy)]
pub struct TuggedSpool<T = Absent, F = Absent, C = Absent> {
    spool: Spool,
    gravity: f64,
    start: Moment,
    tug: T,
    friction: F,
    resistance: C,
}

impl TuggedSpool {
    /// A spool at rest under gravity (m/s²).
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite) for gravity.
    pub fn new(spool: Spool, gravity: f64) -> Result<Self> {
        Ok(Self {
            spool,
            gravity: positive("the acceleration of gravity", gravity)?,
            start: Moment::at_rest(),
            tug: Absent,
            friction: Absent,
            resistance: Absent,
        })
    }
}

impl<T, F, C> TuggedSpool<T, F, C> {
    /// The same with a velocity and a rim speed (m/s) to begin with.
    pub fn moving(mut self, velocity: f64, rim_speed: f64) -> Self {
        self.start = Moment::moving(velocity, rim_speed);
        self
    }

    /// The same with a tug.
    pub fn with_tug<U>(self, tug: U) -> TuggedSpool<U, F, C> {
        let Self {
            spool,
            gravity,
            start,
            friction,
            resistance,
            ..
        } = self;
        TuggedSpool {
            spool,
            gravity,
            start,
            tug,
            friction,
            resistance,
        }
    }

    /// The same with friction on the table.
    pub fn with_friction<G>(self, friction: G) -> TuggedSpool<T, G, C> {
        let Self {
            spool,
            gravity,
            start,
            tug,
            resistance,
            ..
        } = self;
        TuggedSpool {
            spool,
            gravity,
            start,
            tug,
            friction,
            resistance,
        }
    }

    /// The same with rolling resistance.
    pub fn with_resistance<D>(self, resistance: D) -> TuggedSpool<T, F, D> {
        let Self {
            spool,
            gravity,
            start,
            tug,
            friction,
            ..
        } = self;
        TuggedSpool {
            spool,
            gravity,
            start,
            tug,
            friction,
            resistance,
        }
    }
}

impl<T: Pull, F: Friction, C: Resistance> TuggedSpool<T, F, C> {
    /// Everything that happens up to a time (s), as closed forms from event to event.
    ///
    /// # Errors
    /// As [`Course::new`]; [`Error::NotPositive`](crate::Error::NotPositive) for the reaction if the tug lifts the spool.
    pub fn course(&self, until: f64) -> Result<Course> {
        let load = self.tug.load(&self.spool, self.gravity)?;
        let effects = (self.friction, self.resistance, Absent);
        Course::new(
            self.spool.body().inertia_factor(),
            load,
            effects,
            self.start,
            until,
        )
    }
}

/// A spool at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spooling {
    /// Where it is and how it moves.
    pub moment: Moment,
    /// String wound on the axle since the start, m; negative: paid out.
    pub wound: f64,
    /// Kinetic energy, J.
    pub energy: f64,
    /// Heat so far, J.
    pub heat: f64,
    /// Work of the hand so far, J.
    pub work: f64,
}

impl Tabulated for Spooling {
    /// m; m/s; m of string; J.
    const COLUMNS: &'static [&'static str] = &[
        "x",
        "velocity",
        "rim_speed",
        "slip",
        "wound",
        "energy",
        "heat",
        "work",
    ];

    fn row(&self) -> Vec<f64> {
        let m = &self.moment;
        let tail = [self.wound, self.energy, self.heat, self.work];
        let mut row = vec![m.position, m.velocity, m.rim_speed, m.slip];
        row.extend(tail);
        row
    }
}

impl<T, F, C> Scene for TuggedSpool<T, F, C>
where
    T: Effect + Pull,
    F: Effect + Friction,
    C: Effect + Resistance,
{
    type State = Spooling;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let alone = !T::PRESENT && !F::PRESENT && !C::PRESENT;
        let why = match (F::PRESENT, T::PRESENT || C::PRESENT) {
            (true, _) => "dry friction",
            (false, true) => "steady forces",
            (false, false) => "no force along the table",
        };
        planned(request, alone, why)
    }

    fn simulate(&self, request: &Request) -> Result<Motion<Spooling>> {
        let plan = self.plan(request)?;
        let (order, times) = request.forward()?;
        let kappa = self.spool.body().inertia_factor();
        let load = self.tug.load(&self.spool, self.gravity)?;
        let (moments, cost) = match plan.solver {
            Solver::General(method) => {
                let effort = effort(method, request, &times);
                let effects = (self.friction, self.resistance, Absent);
                let run = integrated(kappa, load, effects, self.start, &times, (method, effort))?;
                (run.moments, run.cost)
            }
            _ => closed(&self.course(last(&times))?, &times),
        };
        let mass = self.spool.body().mass();
        let fill = |books: &mut super::roller::Books<'_>| {
            if !C::PRESENT {
                // About the contact only the tug has a moment, and it is steady.
                books.momentum("angular momentum about the table less the tug's", |t, m| {
                    m.about_the_table(kappa) - t * (load.push + load.twist)
                })?;
            }
            books.energy(Law::Conserved)?;
            if !T::PRESENT {
                books.loss()?;
            }
            Ok(())
        };
        let ledger = accounts(mass, kappa, &self.start, &moments, fill, &times)?;
        let states = moments.iter().map(|moment| Spooling {
            moment: *moment,
            wound: self.spool.wound(moment),
            energy: mass * moment.energy(kappa),
            heat: mass * moment.heat,
            work: mass * moment.work,
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

/// Simulates `spool` with those of the effects that are listed: one compiled scene a combination.
///
/// # Errors
/// As for [`Scene::simulate`].
pub fn listed(
    spool: TuggedSpool,
    tug: Option<Tug>,
    friction: Option<Coulomb>,
    resistance: Option<RollingResistance>,
    request: &Request,
) -> Result<Motion<Spooling>> {
    choose!((tug = tug) (friction = friction) (resistance = resistance) => spool
        .with_tug(tug)
        .with_friction(friction)
        .with_resistance(resistance)
        .simulate(request))
}
