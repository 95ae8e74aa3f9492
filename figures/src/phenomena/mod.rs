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
    of("cat-animated", &[], animated::cat_animated),
    of("ice", ice::ICE, ice::ice),
    of("crawler", ice::CRAWLER, ice::crawler),
    of("swivel", swivel::SWIVEL, swivel::swivel),
    of("cat-film", &[], film::cat_film),
    of("shape-loops", loops::SHAPE_LOOPS, loops::shape_loops),
    of("back-bend", film::BACK_BEND, film::back_bend),
    of("paper-cat", paper::PAPER_CAT, paper::paper_cat),
    of("paper-cat-fall", paper::FALL, paper::paper_cat_fall),
];
