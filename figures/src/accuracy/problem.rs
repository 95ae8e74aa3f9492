//! The motions of the chapter, and their methods.

use lab::accuracy::{Candidate, Problem, named};
use spinning_bodies::Error;

use crate::prelude::*;

/// One problem over one length.
pub fn problem(name: &str) -> Result<Problem> {
    let first = named(name)?.into_iter().next();
    first.ok_or(Error::Empty {
        quantity: "the list of problems of this name",
    })
}

/// The method of this name.
pub fn method<'a>(all: &'a [Candidate], name: &str) -> Result<&'a Candidate> {
    let found = all.iter().find(|candidate| candidate.name == name);
    found.ok_or(Error::Empty {
        quantity: "the list of methods of this name",
    })
}
