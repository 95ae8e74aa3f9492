//! Bodies that stand on a table (tutorial 4.7): tippe top, egg, hoop with clay, chiral tippe top, rattleback.
//!
//! A [`ConvexBody`] touches a level table with its [`Surface`]. The table pushes with a normal reaction N and, where the body slips with
//! velocity v at the contact, with friction N f(v). In the body's axes, with n the upward vertical, ρ = CK − S(n) the arm from the
//! centre of mass C to the contact and S the support map of the surface,
//!
//! * I Ω̇ + Ω∧IΩ = N ρ∧(n + f), and the level velocity of C changes by N f/M;
//! * the height of C is −⟨ρ, n⟩, so N follows from one linear equation.
//!
//! Simulations are scenes: [`crate::scene::contact`]. This module has the bodies, the laws of friction, and the results in closed form.
//!
//! | question | answer |
//! |---|---|
//! | how fast does a hoop with clay tip over? | [`HoopWithClay`]: the tutorial's estimate, and the one that uses Jellett's integral |
//! | does a tippe top turn over, and how far? | [`TippeTop`]: thresholds, final tilt, effective potential |
//! | does a body tip alike for both senses of spin? | [`chirality_index`], [`quasi_steady`] and its [`growth rates`](QuasiSteady::growth_rates) |
//! | how does one build such a body? | [`beads`], [`bodies`] |

pub mod bodies;
mod body;
mod chirality;
pub(crate) mod equations;
mod estimate;
pub(crate) mod flight;
mod friction;
mod growth;
mod steady;
mod surface;

pub use body::{ConvexBody, Start};
pub use chirality::{beads, chirality_index, swings_of_both_senses};
pub use estimate::HoopWithClay;
pub use friction::{Friction, NoSlip, Regularised, Resistance, Viscous};
pub use growth::{QuasiSteady, Rate, quasi_steady, rolling_growth_rates};
pub use steady::{Inversion, TippeTop};
pub use surface::Surface;
