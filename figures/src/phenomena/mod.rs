//! Figures of the chapter on strange rotational phenomena (tutorial 1.1).

mod animated;
mod body;
mod film;
mod ice;
mod loops;
mod paper;
mod swivel;

pub(crate) use animated::cat_animated;
pub(crate) use film::{BACK_BEND, back_bend, cat_film};
pub(crate) use ice::{CRAWLER, ICE, crawler, ice};
pub(crate) use loops::{SHAPE_LOOPS, shape_loops};
pub(crate) use paper::{PAPER_CAT, PAPER_CAT_FALL, paper_cat, paper_cat_fall};
pub(crate) use swivel::{SWIVEL, swivel};
