//! Euler's top (tutorial 6): a body that turns under no torque.
//!
//! So far the symmetric top (6.5), solved exactly, and its most distinguished example, the Earth.

pub mod earth;
mod motion;
mod poinsot;
mod preparation;
pub mod stability;
pub mod symmetric;
mod turning;

pub use motion::{EulerTop, GeometricPhase, Regime, State};
pub use poinsot::{Poinsot, Sector, separatrix_slope};
pub use symmetric::{Cones, Shape, SymmetricTop};
