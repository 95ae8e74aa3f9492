//! Conservation laws (tutorial 3): momentum, angular momentum, energy, and the ledger that checks them.
//!
//! Three laws carry the whole subject:
//!
//! * dP/dt = F: momentum changes by the total outside force;
//! * dL/dt = N: angular momentum about O changes by the total outside torque about O, if O is the centre of
//!   mass or at rest (a moving O adds the term −U∧P, see [`angular_momentum_rate`]);
//! * energy is conserved if all its forms are counted, heat included.
//!
//! [`Particles`] computes the quantities for point masses and
//! [`RigidMotion`](crate::inertia::RigidMotion) for a rigid body. [`ForceAndTorque`] is what changes them, and a
//! [`Ledger`] watches whether a simulation keeps them.
//!
//! ```
//! use spinning_bodies::conservation::{Law, Ledger};
//!
//! let mut ledger = Ledger::new();
//! let energy = ledger.open("energy", Law::Conserved, 2.0)?;
//! ledger.record(energy, 2.0 + 2e-12)?;
//! assert!(ledger.is_kept_within(1e-11)?);
//! assert!(!ledger.is_kept_within(1e-13)?);
//! # Ok::<(), spinning_bodies::Error>(())
//! ```

mod force;
mod ledger;
mod particles;

pub use force::{ForceAndTorque, angular_momentum_rate, uniform_gravity};
pub use ledger::{Account, Entry, Law, Ledger, Value};
pub use particles::{AngularMomentumParts, EnergyParts, Particle, Particles};
