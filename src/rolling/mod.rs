//! Round bodies that skid and roll (tutorial 4.3–4.5): the billiard shot, the spool, the ball on a withdrawn sheet.
//!
//! Velocity is positive in the direction of travel, and spin is positive when the body turns as it would in rolling that way. Spin is
//! given as *rim speed* RΩ, so that rolling means velocity = rim speed, and the contact point slips at velocity − rim speed.
//!
//! | paragraph | type | what it computes |
//! |---|---|---|
//! | 4.3 | [`RoundBody`], [`Shot`], [`SlideToRoll`] | the blow of a cue, and the sliding that ends in rolling |
//! | 4.3 | [`InPlane`], [`Slide`] | the same on the whole cloth: the massé shot |
//! | 4.3–4.5 | [`Course`] | friction, rolling resistance, a pull, a moving sheet: closed forms from event to event |
//! | 4.4 | [`Spool`], [`Tug`] | which way a spool rolls, what "gently" means, when it lifts off |
//! | 4.5 | [`Sheet`], [`SheetSpeeds`] | a sheet withdrawn at any speeds |
//!
//! ```
//! use spinning_bodies::rolling::RoundBody;
//!
//! let ball = RoundBody::new(0.17, 0.0286, 0.4)?;
//! assert_eq!(ball.pure_rolling_height(), 1.4); // the classic answer: 7R/5 above the table
//! # Ok::<(), spinning_bodies::Error>(())
//! ```

mod course;
mod friction;
pub(crate) mod moment;
mod plane;
mod sheet;
mod shot;
mod spool;
pub(crate) mod stretch;

pub use course::{Course, Event};
pub use friction::{Coulomb, RollingResistance, painleve_friction};
pub use moment::{Happening, Load, Moment};
pub use plane::{InPlane, Slide};
pub use sheet::{Sheet, SheetSpeeds};
pub use shot::{Regime, RoundBody, Shot, SlideToRoll};
pub use spool::{Spool, Tug, Way};
