//! A strip of paper falls through air: it flutters or it tumbles (tutorial 4.10).
//!
//! The model is quasi-steady and two-dimensional: a long plate that turns only about its long axis, with forces that depend only on its present motion.
//! Its equations are those of Andersen, Pesavento and Wang (Journal of Fluid Mechanics 541, 2005): weight, added mass, lift by
//! a circulation with a translational and a rotational part, drag that depends on the angle of attack, and a torque that resists rotation.
//!
//! [`Equations`] has a place for each of these effects; [`Fall`] has them all, in the units of the theory, and finds the regime of a
//! fall in the [long run](Fall::long_run). [`Sheet`] is a real strip, in SI units.
//!
//! | | published | paper |
//! |---|---|---|
//! | [`Coefficients`] | [`Coefficients::PUBLISHED`], fitted by the authors to one plate in water | [`Coefficients::PAPER`], our fit to falling paper |
//! | flutter ends at I* | 1.2191 | 0.527 |
//! | Froude number there | 0.979 | 0.643; Belmonte, Eisenberg and Moses measured 0.67 ± 0.05 |

mod fall;
mod plate;
mod sheet;

pub use fall::{Coefficients, Fall, LongRun, Regime, Start};
pub use plate::{AddedMass, Drag, Equations, Lift, Plate, RotationalDamping};
pub use sheet::{MEASURED_FROUDE, Sheet, transition};
