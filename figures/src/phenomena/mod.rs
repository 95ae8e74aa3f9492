//! Figures of the chapter on strange rotational phenomena (tutorial 1.1).

use crate::prelude::*;

mod animated;
mod body;
mod film;
mod ice;
mod loops;
mod paper;
mod swivel;

/// The figures of the chapter, in its order.
pub const FIGURES: &[Entry] = &[
    of("cat-animated", &[], cat_animated),
    of("ice", ICE, ice),
    of("crawler", CRAWLER, crawler),
    of("swivel", SWIVEL, swivel),
    of("cat-film", &[], cat_film),
    of("shape-loops", SHAPE_LOOPS, shape_loops),
    of("back-bend", BACK_BEND, back_bend),
    of("paper-cat", PAPER_CAT, paper_cat),
    of("paper-cat-fall", PAPER_CAT_FALL, paper_cat_fall),
];

pub(crate) use animated::cat_animated;
pub(crate) use film::{BACK_BEND, back_bend, cat_film};
pub(crate) use ice::{CRAWLER, ICE, crawler, ice};
pub(crate) use loops::{SHAPE_LOOPS, shape_loops};
pub(crate) use paper::{PAPER_CAT, PAPER_CAT_FALL, paper_cat, paper_cat_fall};
pub(crate) use swivel::{SWIVEL, swivel};
