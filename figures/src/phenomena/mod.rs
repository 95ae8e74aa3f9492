//! Figures of the chapter on strange rotational phenomena (tutorial 1.1).

mod animated;
mod body;
mod film;
mod ice;
mod loops;
mod paper;
mod swivel;

pub(crate) use animated::cat_animated;
pub(crate) use film::{back_bend, cat_film};
pub(crate) use ice::{crawler, ice};
pub(crate) use loops::shape_loops;
pub(crate) use paper::{paper_cat, paper_cat_fall};
pub(crate) use swivel::swivel;
