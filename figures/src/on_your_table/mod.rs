//! Things to cut out and to print (page "On your table"): sheets at true size and a top, with the numbers that the library computes for them.

use crate::prelude::*;

mod chiral;
mod paper;

/// The figures of the chapter.
pub(crate) const FIGURES: &[Entry] = &[of("printed-top", &[], chiral::section)];

/// A size of paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Paper {
    /// 210 mm by 297 mm.
    A4,
    /// 8.5 inches by 11.
    Letter,
}

impl Paper {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::A4, Self::Letter];

    /// As it stands in the names of files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::A4 => "a4",
            Self::Letter => "letter",
        }
    }

    /// Width and height, mm.
    pub const fn size(self) -> [f64; 2] {
        match self {
            Self::A4 => [210.0, 297.0],
            Self::Letter => [215.9, 279.4],
        }
    }
}

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
