//! Bodies that change their shape (tutorial 1.1): swivel, skater, cat, crawler; and a cat of paper, which does not.
//!
//! | kind | effects | plan |
//! |---|---|---|
//! | [`Swivel`] | a path of shapes, bearing friction | one integral along the path of shapes; with friction steps |
//! | [`Skater`] | a path of the hands, bearing friction | Ω = L/I; with friction steps |
//! | [`Cat`] | a path of shapes, gravity | equal halves without angular momentum: one integral; otherwise steps |
//! | [`Crawler`] | friction, gravity | closed forms from event to event |
//! | [`PaperCat`] | air, gravity | with air steps |
//!
//! A path of shapes is an effect like any other: absent, the body is rigid. What muscles can do is prescribed; how hard they must work for it
//! comes out.

mod cat;
mod crawler;
mod paper_cat;
pub(crate) mod path;
mod skater;
mod swivel;

pub use cat::{Cat, CatState};
pub use crawler::{Crawler, CrawlerState};
pub use paper_cat::{PaperCat, PaperCatState, Righting};
pub use skater::{Skater, SkaterState};
pub use swivel::{Swivel, SwivelState};
