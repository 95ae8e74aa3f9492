//! A body on a table (tutorial 4.7): tippe top, egg, hoop with clay, chiral top, rattleback.
//!
//! | slot | effects | absent |
//! |---|---|---|
//! | gravity | [`Gravity`] | a free body, in closed form |
//! | friction | [`Viscous`], [`Regularised`], [`Coulomb`], [`NoSlip`] | a table without friction |
//! | resistance | [`Resistance`] to rolling and pivoting | |
//!
//! The table only pushes. Where the reaction falls to zero the body takes off, flies in closed form, and lands with an inelastic blow.
//! Coulomb's law is the true one: a body whose slip comes to rest rolls while the force that takes lies within the cone of friction, and
//! slides again when it does not; each change is located.
//!
//! ```
//! use spinning_bodies::scene::contact::{Gravity, TableTop, Viscous};
//! use spinning_bodies::scene::{Request, Scene};
//! use spinning_bodies::tippe_top::{Start, bodies};
//!
//! let start = Start::about_third_axis(0.1, 0.0, 155.0)?;
//! let scene = TableTop::new(bodies::tippe_top()?, start)
//!     .with_gravity(Gravity::new(9.82)?)
//!     .with_friction(Viscous::new(0.3)?);
//! let motion = scene.simulate(&Request::at([8.0])?.to_accuracy(1e-8)?)?;
//! let (_, state) = motion.rows[0];
//! assert!(state.tilt() > 3.1, "it stands on its head");
//! # Ok::<(), spinning_bodies::Error>(())
//! ```

mod effects;
mod engine;
mod listed;
mod run;
mod state;

pub use crate::tippe_top::{Coulomb, Holding, Regularised, Resistance, Viscous};
pub use effects::{Gravity, Grip, NoSlip, Pull, Resist};
pub use listed::{Friction, listed};
pub use run::{Phase, Support};
pub use state::{State, passage};

use self::engine::Setting;
use super::Scene;
use super::effect::Absent;
use super::motion::{Motion, Request};
use super::plan::Plan;
use crate::error::Result;
use crate::tippe_top::equations::Table;
use crate::tippe_top::{ConvexBody, Start};

/// A body on a table, with one slot an effect.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TableTop<G = Absent, F = Absent, R = Absent> {
    body: ConvexBody,
    start: Start,
    gravity: G,
    friction: F,
    resistance: R,
}

impl TableTop {
    /// The body, touching the table, without any effect: a free body.
    pub const fn new(body: ConvexBody, start: Start) -> Self {
        Self {
            body,
            start,
            gravity: Absent,
            friction: Absent,
            resistance: Absent,
        }
    }
}

impl<G, F, R> TableTop<G, F, R> {
    /// The same under gravity.
    pub fn with_gravity<P: Pull>(self, gravity: P) -> TableTop<P, F, R> {
        TableTop {
            body: self.body,
            start: self.start,
            gravity,
            friction: self.friction,
            resistance: self.resistance,
        }
    }

    /// The same with friction at the contact.
    pub fn with_friction<P: Grip>(self, friction: P) -> TableTop<G, P, R> {
        TableTop {
            body: self.body,
            start: self.start,
            gravity: self.gravity,
            friction,
            resistance: self.resistance,
        }
    }

    /// The same with resistance to rolling and pivoting.
    pub fn with_resistance<P: Resist>(self, resistance: P) -> TableTop<G, F, P> {
        TableTop {
            body: self.body,
            start: self.start,
            gravity: self.gravity,
            friction: self.friction,
            resistance,
        }
    }

    /// The mirror image of body and start, with the same effects.
    #[must_use]
    pub fn mirrored(mut self) -> Self {
        self.body = self.body.mirrored();
        self.start = self.start.mirrored();
        self
    }

    /// The body.
    pub const fn body(&self) -> &ConvexBody {
        &self.body
    }

    /// The start.
    pub const fn start(&self) -> &Start {
        &self.start
    }
}

impl<G: Pull, F: Grip, R: Resist> TableTop<G, F, R> {
    /// When the body slides, rolls and hops, up to the last of the times asked for.
    ///
    /// # Errors
    /// As for [`simulate`](Scene::simulate).
    pub fn phases(&self, request: &Request) -> Result<Vec<Phase>> {
        self.setting(&self.table()).phases(request)
    }

    fn table(&self) -> Table<F, R> {
        Table {
            body: self.body,
            gravity: self.gravity.pull().unwrap_or(0.0),
            friction: self.friction,
            resistance: self.resistance,
        }
    }

    const fn setting<'a>(&'a self, table: &'a Table<F, R>) -> Setting<'a> {
        Setting {
            ground: table,
            start: &self.start,
            gravity: G::PRESENT,
            friction: F::PRESENT,
            resistance: R::PRESENT,
        }
    }
}

impl<G: Pull, F: Grip, R: Resist> Scene for TableTop<G, F, R> {
    type State = State;

    fn plan(&self, request: &Request) -> Result<Plan> {
        self.setting(&self.table()).plan(request)
    }

    fn simulate(&self, request: &Request) -> Result<Motion<State>> {
        self.setting(&self.table()).motion(request)
    }
}
