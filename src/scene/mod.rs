//! Scenes: a body, how it is held, how it starts, and the effects that act on it. Nothing else is computed.
//!
//! Each kind of scene is a type that takes its [`effects`] as values, one by one, and rejects by name those that have no meaning for it. An
//! effect that is not added is not computed at all: it is not a coefficient of zero. A [`Plan`] says in one sentence how the scene will be
//! computed: in closed form where there is one, otherwise by the method of order 8. The [`Motion`] contains an estimate of its error and its
//! [`Ledger`](crate::conservation::Ledger): each quantity that the scene conserves, or can only lose, and how far the computed states violate that.
//! A ledger that does not balance is an error. With the feature `scene-files`, `scene::files` reads scenes from text.
//!
//! | kind | tutorial | what it is |
//! |---|---|---|
//! | [`StruckPlanet`] | 4.2 | a planet, struck by a meteorite |
//! | [`Roller`] | 4.3, 4.5 | a ball on a table, struck by a cue or on a moving sheet |
//! | [`TuggedSpool`] | 4.4 | a spool, pulled at its string |
//! | [`Superball`] | 4.6 | a ball that bounces |
//! | [`Swivel`](shape::Swivel), [`Skater`](shape::Skater), [`Cat`](shape::Cat), [`Crawler`](shape::Crawler), [`PaperCat`](shape::PaperCat) | 1.1 | in [`shape`]: bodies that change their shape, and a cat of paper |
//! | [`Top`](top::Top) | 6, 7, 8 | in [`top`]: a body with a fixed point: free, under gravity, with friction |
//! | [`Play`] | 4.9 | a yo-yo: down, a turn or sleep, and up again |
//! | [`Strip`] | 4.10 | a strip of paper in air or in a vacuum |
//! | [`TableTop`](contact::TableTop) | 4.7 | in [`contact`]: a body that slides, rolls and hops on a table |

mod any;
mod budget;
mod columns;
pub mod contact;
pub mod effects;
mod engine;
#[cfg(feature = "scene-files")]
pub mod files;
mod meteorite;
mod motion;
mod path;
mod plan;
mod roller;
pub mod shape;
mod sight;
mod strip;
mod superball;
pub mod top;
mod yo_yo;

pub use any::{AnyScene, Table, UnknownColumn};
pub use budget::{Progress, Reached};
pub use columns::{Column, Columns};
pub use meteorite::{Flying, StruckPlanet};
pub use motion::{Motion, Request, balanced};
pub use plan::{Choice, Geometric, Plan, Solver};
pub use roller::{Roller, Rolling, Spooling, TuggedSpool};
pub use sight::{Around, Sight, Solid};
pub use strip::{Strip, StripStart, StripState};
pub use superball::{Bouncing, Superball};
pub use yo_yo::{Phase, Play, YoYoState};

pub(crate) use budget::Budget;

/// What a kind of scene is made of.
mod prelude {
    pub(crate) use super::columns::{Columns, columns, state};
    pub(crate) use super::effects::Effect;
    pub(crate) use super::engine::to_accuracy;
    pub(crate) use super::engine::{AN_INTEGRAL, Ahead, At, Flow, OF_CLOSED_FORMS, Passed, Trace};
    pub(crate) use super::engine::{apart, greater, planned, planned_forward, relative, solved};
    pub(crate) use super::motion::OpenLedger;
    pub(crate) use super::{Choice, Motion, Plan, Request, Scene, Solver, Tabulated};
    pub(crate) use crate::conservation::Law;
    pub(crate) use crate::error::{Error, Result, each_finite, finite};
    pub(crate) use crate::error::{not_negative, positive, within};
    pub(crate) use crate::frame::{Attitude, BodyVector, SpaceVector};
    pub(crate) use crate::integrators::{Cost, Effort, Kept, Leg, Passage, Stop, System};
}

use crate::error::Result;

/// A scene of any kind.
pub trait Scene {
    /// The state of the scene at one time.
    type State: Tabulated;

    /// Which solver will run, and why.
    ///
    /// # Errors
    /// [`Error::Solver`](crate::Error::Solver) if the requested solver cannot run this scene.
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, scene::{Request, Scene, Solver, top::{Body, Start, Top}}};
    /// let start = Start::with_omega(BodyVector::new(0.0, 0.0, 2.0), Attitude::identity());
    /// let top = Top::new(Body::new([1.0, 2.0, 3.0])?, start)?;
    /// // A free body has a closed form.
    /// assert_eq!(top.plan(&Request::at([1.0])?)?.solver, Solver::Exact);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    fn plan(&self, request: &Request) -> Result<Plan>;

    /// The motion at the requested times, with its cost and its ledger.
    ///
    /// # Errors
    /// As for [`plan`](Self::plan); [`Error::Integration`](crate::Error::Integration), [`Error::Accuracy`](crate::Error::Accuracy),
    /// [`Error::Budget`](crate::Error::Budget), [`Error::Ledger`](crate::Error::Ledger).
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, scene::{Request, Scene, top::{Body, Start, Top}}};
    /// let start = Start::with_omega(BodyVector::new(0.0, 0.0, 2.0), Attitude::identity());
    /// let top = Top::new(Body::new([1.0, 2.0, 3.0])?, start)?;
    /// let motion = top.simulate(&Request::at([1.0, 1e6])?)?;
    /// assert_eq!((motion.rows.len(), motion.rows[1].1.energy), (2, 6.0));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    fn simulate(&self, request: &Request) -> Result<Motion<Self::State>>;

    /// Further columns of a state, beside the usual ones.
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, scene::{AnyScene, top::{Body, Start, Top}}};
    /// let start = Start::with_omega(BodyVector::new(0.0, 0.0, 2.0), Attitude::identity());
    /// let top = AnyScene::scene(Box::new(Top::new(Body::new([1.0, 2.0, 3.0])?, start)?));
    /// assert!(top.columns().iter().any(|column| column.name == "tilt" && !column.usual));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    fn further(&self) -> Columns<Self::State> {
        Columns::default()
    }
}

/// A state that can be written as a row of numbers.
pub trait Tabulated: Sized + 'static {
    /// The columns that are output by default.
    ///
    /// ```
    /// use spinning_bodies::scene::{Tabulated, top::State};
    /// assert!(format!("{:?}", State::columns()).contains("omega3"));
    /// ```
    fn columns() -> Columns<Self>;

    /// The numbers in those columns.
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, scene::{Tabulated, top::State}};
    /// let state = State { attitude: Attitude::identity(), omega: BodyVector::new(1.0, 2.0, 3.0), energy: 4.0 };
    /// assert_eq!(state.row(), [1.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0]);
    /// ```
    fn row(&self) -> Vec<f64> {
        let columns = Self::columns();
        let places: Vec<usize> = (0..columns.0.len()).collect();
        columns.row(&places, self)
    }
}
