//! Euler's top (tutorial 6): a body that turns under no torque.
//!
//! So far the symmetric top (6.5), solved exactly, and its most distinguished example, the Earth.

pub mod earth;
mod poinsot;
pub mod stability;
pub mod symmetric;

pub use poinsot::{Poinsot, Sector, separatrix_slope};
pub use symmetric::{Cones, Shape, SymmetricTop};
