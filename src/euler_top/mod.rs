//! Euler's top (tutorial 6): a body that turns freely, without torque.
//!
//! | paragraph | what | where |
//! |---|---|---|
//! | 6.2, 6.3 | the ellipsoid that rolls on a plane, polhode and herpolhode in closed form | [`Poinsot`] |
//! | 6.3, 6.7 | which permanent rotations are stable: growth rates, integrals | [`stability`] |
//! | 6.5 | two equal moments: sines and cosines | [`SymmetricTop`] |
//! | 6.5 | the symmetric top that everybody lives on | [`earth`] |
//! | 6.1, 6.4, 6.6, 6.8 | Ω, L and attitude of any body at any time; period, mean precession, geometric phase | [`EulerTop`] |
//! | 2.3, 6.6 | the same in axes that are not the principal ones | [`FreeBody`] |
//! | 6.6, 6.8 | the same for many times at once | [`EulerTop::states_at`] |
//! | 6.6, 6.8 | an asteroid that is far from symmetric | [`toutatis`] |
//!
//! [`EulerTop`] decides once what kind of motion it is ([`Regime`]) and covers the symmetric top, the sphere, the rod and the
//! separatrix too; [`SymmetricTop`] gives the simpler formulas of 6.5 for two equal moments.
//!
//! # Error and cost
//!
//! Ω and the attitude are exact for the doubles given, up to the last digits, without steps or series in time: every phase that
//! grows with time is carried in 106 bits, and differences that could cancel are formed from the exact numbers.

pub mod earth;
mod evaluation;
mod motion;
mod poinsot;
mod preparation;
pub mod stability;
mod symmetric;
pub mod toutatis;

pub use evaluation::State;
pub use motion::{EulerTop, FreeBody, GeometricPhase};
pub use poinsot::{Poinsot, Sector};
pub use preparation::Regime;
pub use symmetric::{Cones, Shape, SymmetricTop};
