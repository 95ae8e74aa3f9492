//! Bodies that change their shape (tutorial 1.1): swivel, skater, cat and crawler; and a cat of paper, which is rigid.
//!
//! | kind | effects | plan |
//! |---|---|---|
//! | [`Swivel`] | a path of shapes, bearing friction | one integral along the path; with friction by steps |
//! | [`Skater`] | a path of the hands, bearing friction | Ω = L/I; with friction by steps |
//! | [`Cat`] | a path of shapes, gravity | equal halves without angular momentum: one integral; otherwise by steps |
//! | [`Crawler`] | friction, gravity | closed forms from event to event |
//! | [`PaperCat`] | air, gravity | with air by steps |
//!
//! A path of shapes is an effect like any other: without it the body is rigid. The path prescribes the motion of the muscles; the work they need is
//! computed.

mod cat;
mod crawler;
mod ice;
mod paper_cat;

pub use cat::{Cat, CatState};
pub use crawler::{Crawler, CrawlerState};
pub use ice::{Skater, SkaterState, Swivel, SwivelState};
pub use paper_cat::{PaperCat, PaperCatState, Righting};
