//! Rigid-body dynamics, computed exactly where that is possible and with a stated error where it is not.
//!
//! The companion library of the book *Spinning Bodies*. Its modules follow the sections of the tutorial:
//!
//! | section | module | what it computes |
//! |---|---|---|
//! | 2.2, 5.1 | [`frame`] | body and space axes, attitude, the transport theorem |
//! | 2 | [`inertia`] | inertia matrix, principal axes, shapes, meshes, Routh's rule |
//! | | [`error`] | the one error type |
//!
//! SI units and radians throughout; a quantity without a unit says so.

pub mod error;
pub mod frame;
pub mod inertia;

pub use error::{Error, Result};
