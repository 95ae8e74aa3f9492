//! A scene: a body, how it is held, how it starts, and the effects at work on it. Nothing else is computed.
//!
//! Each kind of scene is a type that takes its [`effects`] as values, one by one, and refuses by name those that have no meaning for it. An
//! effect that you do not add is not computed at all: it is not a coefficient of zero. A [`Plan`] says in one sentence how the scene will be
//! computed: in closed form where there is one, otherwise by the method of order 8. The [`Motion`] comes with an estimate of its error and with its
//! [`Ledger`](crate::conservation::Ledger): each quantity that the scene conserves, or can only lose, and how far the numbers strayed from that.
//! A ledger that does not balance is an error. With the feature `scene-files`, scenes can be read from text: `scene::files`.
//!
//! | kind | tutorial | what it is |
//! |---|---|---|
//! | [`StruckPlanet`] | 4.2 | a planet, struck |
//! | [`Roller`] | 4.3, 4.5 | a ball on a table, after the cue or on a sheet |
//! | [`TuggedSpool`] | 4.4 | a spool and its string |
//! | [`Superball`] | 4.6 | bounces |
//! | [`Swivel`](shape::Swivel), [`Skater`](shape::Skater), [`Cat`](shape::Cat), [`Crawler`](shape::Crawler), [`PaperCat`](shape::PaperCat) | 1.1 | in [`shape`]: bodies that change their shape |
//! | [`Top`](top::Top) | 6, 7, 8 | in [`top`]: a body with a fixed point: free, under gravity, with friction |
//! | [`Play`] | 4.9 | down, turn or sleep, and up again |
//! | [`Strip`] | 4.10 | a strip of paper in the air, or in a vacuum |
//! | [`TableTop`](contact::TableTop) | 4.7 | in [`contact`]: sliding, rolling, hopping |

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
mod plan;
mod roller;
pub mod shape;
mod sight;
mod spool;
mod strip;
mod superball;
pub mod top;
mod yo_yo;

pub use any::{AnyScene, Table, UnknownColumn};
pub use budget::{Progress, Reached};
pub use columns::{Column, Columns};
pub use meteorite::{Flying, StruckPlanet};
pub use motion::{Motion, Request, balanced};
pub use plan::{Choice, Geometric, Plan, Solver, UnknownSolver};
pub use roller::{Roller, Rolling};
pub use sight::{Around, Sight, Solid};
pub use spool::{Spooling, TuggedSpool};
pub use strip::{Strip, StripStart, StripState};
pub use superball::{Bouncing, Superball};
pub use yo_yo::{Phase, Play, YoYoState};

pub(crate) use budget::Budget;

use crate::error::Result;

/// What every kind of scene can do.
pub trait Scene {
    /// The state of the scene at one time.
    type State: Tabulated;

    /// Which solver will run, and why.
    ///
    /// # Errors
    /// [`Error::Solver`](crate::Error::Solver) if the solver asked for cannot run this scene.
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

    /// The motion at the times asked for, with its cost and its ledger.
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

    /// What else can be told of a state.
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

/// A state as a row of numbers.
pub trait Tabulated: Sized + 'static {
    /// The numbers that are told if nobody says which.
    ///
    /// ```
    /// use spinning_bodies::scene::{Tabulated, top::State};
    /// assert!(format!("{:?}", State::columns()).contains("omega3"));
    /// ```
    fn columns() -> Columns<Self>;

    /// Those numbers.
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, scene::{Tabulated, top::State}};
    /// let state = State { attitude: Attitude::identity(), omega: BodyVector::new(1.0, 2.0, 3.0), energy: 4.0 };
    /// assert_eq!(state.row(), [1.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0]);
    /// ```
    fn row(&self) -> Vec<f64> {
        Self::columns().row(self)
    }
}
