//! Strange rotational phenomena (tutorial 1.1): what a body can do by changing its shape.
//!
//! | type | question | answer |
//! |---|---|---|
//! | [`Wriggler`], [`feet`] | can you slide on perfect ice? | no: the centre of mass stays, and a closed cycle of shapes brings the feet back |
//! | [`Crawler`] | and with friction? | yes: stick on the slow stroke, slip on the fast one |
//! | [`Waist`], [`Swivel`] | can you swivel? | yes: twist with the arms out, untwist with the arms in |
//! | [`Cat`], [`EqualHalves`] | how does a cat turn over? | bend, swing the bend once round, unbend |
//! | [`Skater`] | what does pulling in the arms do? | the spin grows, and the arms do the work |
//! | [`PaperCat`] | and a cat of paper? | the air turns it |
//!
//! One equation covers swivel, cat and skater. The rate of turning is θ′ = L/I − a(x) ψ′: the first term is due to angular momentum and
//! grows with time, the second is due to the change of shape. The integral of the second along a path of shapes is a geometric
//! phase: it depends on the path and not on the pace, and for a closed path it is an area integral ([`ShapePlane`]).

mod cat;
pub(crate) mod crawler;
mod holonomy;
mod ice;
mod paper_cat;
pub(crate) mod quadrature;
mod skater;
mod waist;

pub use cat::{Bend, Cat, EqualHalves, Half};
pub use crawler::{Crawler, Strokes};
pub use holonomy::{Hub, ShapePlane, Step, turn_along, turn_within};
pub use ice::{PARTS, Part, Wriggler, feet};
pub use paper_cat::PaperCat;
pub use skater::Skater;
pub use waist::{Swivel, Waist};
