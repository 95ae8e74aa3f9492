//! The scene `spool` (tutorial 4.4): a spool on a table, pulled at its string.

use super::columns::{Columns, columns};
use super::effects::Effect;
use super::roller::{Roller, along, moments, rolling_plan};
use super::{Motion, Plan, Request, Scene, Tabulated};
use crate::error::Result;
use crate::rolling::{Load, Moment, Spool};

/// A spool on a level table, at rest or already moving.
///
/// | effect | what it does |
/// |---|---|
/// | [`Tug`](super::effects::Tug) | pulls steadily at the string, which winds or unwinds |
/// | [`Coulomb`](super::effects::Coulomb) | holds the contact, or rubs if the pull is too strong |
/// | [`RollingResistance`](super::effects::RollingResistance) | brakes the rotation by a couple |
///
/// ```
/// use spinning_bodies::rolling::{RoundBody, Spool};
/// use spinning_bodies::scene::effects::{Coulomb, Tug};
/// use spinning_bodies::scene::{Request, Scene, TuggedSpool};
///
/// let spool = Spool::new(RoundBody::new(0.2, 0.05, 0.5)?, 0.02)?;
/// let tugged = TuggedSpool::new(spool, 9.81)?.with(Coulomb::new(0.5)?)?.with(Tug::new(0.3, 0.5)?)?;
/// let motion = tugged.simulate(&Request::at([1.0])?)?;
/// assert!(motion.rows[0].1.wound > 0.0); // a low tug winds up
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct TuggedSpool {
    spool: Spool,
    gravity: f64,
    roller: Roller,
}

impl TuggedSpool {
    /// A spool at rest under gravity (m/s²).
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite) for gravity.
    ///
    /// ```
    /// use spinning_bodies::{rolling::{RoundBody, Spool}, scene::{Request, Scene, TuggedSpool}};
    /// let spool = Spool::new(RoundBody::new(2.0, 1.0, 0.5)?, 0.5)?;
    /// let motion = TuggedSpool::new(spool, 10.0)?.simulate(&Request::at([2.0])?)?;
    /// assert_eq!(motion.rows[0].1.moment.velocity, 0.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(spool: Spool, gravity: f64) -> Result<Self> {
        let roller = Roller::new(spool.body, gravity, 0.0, 0.0)?;
        Ok(Self {
            spool,
            gravity,
            roller,
        })
    }

    /// Sets the initial velocity and rim speed (m/s).
    ///
    /// ```
    /// use spinning_bodies::{rolling::{RoundBody, Spool}, scene::{Request, Scene, TuggedSpool}};
    /// let spool = Spool::new(RoundBody::new(2.0, 1.0, 0.5)?, 0.5)?;
    /// let motion = TuggedSpool::new(spool, 10.0)?.moving(1.5, 1.5).simulate(&Request::at([2.0])?)?;
    /// assert_eq!(motion.rows[0].1.moment.velocity, 1.5);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn moving(mut self, velocity: f64, rim_speed: f64) -> Self {
        self.roller.start = Moment::moving(velocity, rim_speed);
        self
    }

    /// Adds a [`Tug`](super::effects::Tug), [`Coulomb`](super::effects::Coulomb)'s friction on the table, or
    /// [`RollingResistance`](super::effects::RollingResistance).
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) for the reaction if the tug lifts the spool; [`Error::Effect`](crate::Error::Effect) for any
    /// other effect.
    ///
    /// ```
    /// use spinning_bodies::{rolling::{RoundBody, Spool}, scene::{Request, Scene, TuggedSpool, effects::{Coulomb, Tug}}};
    /// let spool = Spool::new(RoundBody::new(2.0, 1.0, 0.5)?, 0.5)?;
    /// let tugged = TuggedSpool::new(spool, 10.0)?.with(Tug::new(1.2, 0.0)?)?.with(Coulomb::new(0.3)?)?;
    /// let motion = tugged.simulate(&Request::at([2.0])?)?;
    /// // 0.2 m/s² for two seconds.
    /// assert!((motion.rows[0].1.moment.velocity - 0.4).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn with(mut self, effect: impl Into<Effect>) -> Result<Self> {
        match effect.into() {
            Effect::Tug(tug) => self.roller.load = self.spool.load(tug, self.gravity)?,
            Effect::Coulomb(law) => self.roller.friction = law.acts().then_some(law),
            Effect::RollingResistance(law) => self.roller.resistance = Some(law),
            other => return Err(other.refused("a spool", "tug, friction, rolling_resistance")),
        }
        Ok(self)
    }
}

/// A spool at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Spooling {
    /// Position and motion.
    pub moment: Moment,
    /// String wound on the axle since the start, m; negative if unwound.
    pub wound: f64,
    /// Kinetic energy, J.
    pub energy: f64,
    /// Heat so far, J.
    pub heat: f64,
    /// Work of the hand so far, J.
    pub work: f64,
}

impl Tabulated for Spooling {
    fn columns() -> Columns<Self> {
        along(|state: &Self| state.moment).and(columns! { |state: &Self|
            "wound", "m", "string wound up so far" => state.wound;
            "energy", "J", "kinetic energy" => state.energy;
            "heat", "J", "heat of friction and rolling resistance so far" => state.heat;
            "work", "J", "work of the tug so far" => state.work;
        })
    }
}

impl Scene for TuggedSpool {
    type State = Spooling;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let roller = &self.roller;
        let free = roller.load == Load::weight(self.gravity) && roller.resistance.is_none();
        let reason = match (roller.friction, free) {
            (Some(_), _) => Some("dry friction: closed form from event to event"),
            (None, false) => Some("steady forces: closed form from event to event"),
            (None, true) => None,
        };
        rolling_plan(request, reason)
    }

    fn simulate(&self, request: &Request) -> Result<Motion<Spooling>> {
        let plan = self.plan(request)?;
        let table = self.roller.table(request.furthest)?;
        let (mass, kappa) = (table.body.mass, table.body.inertia_factor);
        table.motion(request, plan, |moment| Spooling {
            moment,
            wound: self.spool.wound(&moment),
            energy: mass * moment.energy(kappa),
            heat: mass * moment.heat,
            work: mass * moment.work,
        })
    }

    fn further(&self) -> Columns<Spooling> {
        moments(self.spool.body, |state: &Spooling| state.moment)
    }
}
