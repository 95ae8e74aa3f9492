//! Things to cut out and to print (page "On your table"): sheets at true size and a top, with the numbers that the library computes for them.

use crate::prelude::*;

mod chiral;
mod paper;

pub use paper::Paper;

/// The figures of the chapter.
pub(crate) const FIGURES: &[Entry] = &[of("printed-top", &[], chiral::section)];

/// A file to print.
#[derive(Debug, Clone)]
pub struct Sheet {
    /// Its name.
    pub name: String,
    /// What is in it.
    pub contents: Vec<u8>,
}

/// The strips, the cat, and the top.
///
/// # Errors
/// What the library refuses.
pub fn sheets(paper: Paper) -> Result<[Sheet; 3]> {
    let named = |name: &str, svg: String| Sheet {
        name: format!("{name}-{}.svg", paper.name()),
        contents: svg.into_bytes(),
    };
    Ok([
        named("strips", paper::strips(paper)?),
        named("paper-cat", paper::cat(paper)?),
        Sheet {
            name: "chiral-top.stl".to_owned(),
            contents: chiral::stl()?,
        },
    ])
}
