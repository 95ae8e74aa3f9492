//! Rigid-body dynamics, computed exactly where that is possible and with a stated error where it is not.
//!
//! The companion library of the book *Spinning Bodies*. Its modules follow the sections of the tutorial:
//!
//! | section | module | what it computes | how exactly |
//! |---|---|---|---|
//! | 1.1 | [`phenomena`] | turning round with no angular momentum | quadratures to rounding; with air or friction, steps to the accuracy asked |
//! | 2 | [`inertia`] | inertia matrix, principal axes, shapes, meshes, Routh's rule | closed forms; principal axes computed without cancellation |
//! | 2.2, 5.1 | [`frame`] | body and space axes, attitude, the transport theorem | rounding |
//! | 3 | [`conservation`] | momentum, angular momentum, energy; the ledger that watches them | rounding; relative positions and velocities, so that a distant or fast swarm keeps its digits |
//! | 3.5 | [`rotating_fluid`] | Maclaurin's spheroids, Jacobi's ellipsoids | closed form |
//! | 4.2 | [`impacts`] | a meteorite strikes a planet and sticks | closed form |
//! | 4.3 to 4.5 | [`rolling`] | the billiard shot, the spool, the withdrawn sheet: skidding, rolling, and how one becomes the other | closed form from event to event |
//! | 4.6 | [`superball`] | bounces that conserve energy, and lossy ones | exact in fractions; closed form after any number of bounces |
//! | 4.7 | [`tippe_top`] | bodies that stand on a table: tippe top, egg, chiral top, rattleback | thresholds in closed form; motions by steps, to the accuracy asked |
//! | 4.9 | [`yo_yo`] | down, turn, sleep, and up again | closed form; with losses, in steps to the accuracy asked |
//! | 4.10 | [`falling_strip`] | flutter and tumbling of a strip in a fluid | steps to the accuracy asked; the model is fitted to experiments |
//! | 5 | [`euler_equations`] | Euler's equations, with torque and about any point; the heavy tops with a further integral | rounding |
//! | 5.2 | [`ideal_fluid`] | the ideal fluid as a top: Zeitlin's truncation, with all its invariants | to rounding, for the truncated model |
//! | 6 | [`euler_top`] | the free top: exact motion and attitude at any time, Poinsot, stability, the Earth and Toutatis | to the last digits of a double, at any time, on the separatrix too |
//! | 4.8, 7 | [`lagrange_top`] | the heavy symmetric top: exact motion and attitude, precession, dip, sleep, the spherical pendulum | to the last digits of a double, at any time, even when the top is asleep or nearly so |
//! | 8 | [`kovalevskaya_top`] | Kovalevskaya's top by separation of variables; Toda's lattice | the error grows with time, and is stated; at a double root and near it by theta functions where 32 digits tell the roots apart, otherwise by power series, or refused |
//! | 9 | [`pythagoras`] | the gas box on a hinge, with any triangle, polygon and corner | rounding |
//! |  | [`scene`] | a body, how it is held, its effects; how it will be computed, the motion and what it conserves | within the accuracy asked, or refused; every answer comes with an estimate of its error |
//! |  | [`integrators`] | methods for equations without a closed form; geometric methods for rotating bodies | to the order of each method; |L| kept to rounding by the geometric ones |
//! |  | [`elliptic`] | Jacobi functions and elliptic integrals that keep their digits at the separatrix | 0.6 of 2⁻⁵² for integrals, four units in the last place for functions |
//! |  | [`Error`] | the one error type |  |
//!
//! The front page of each module, and each function, says what was measured and against what.
//!
//! SI units and radians throughout; a quantity without a unit says so.

pub mod conservation;
pub mod elliptic;
mod error;
pub mod euler_equations;
pub mod euler_top;
pub mod falling_strip;
pub mod frame;
pub mod ideal_fluid;
pub mod impacts;
pub mod inertia;
pub mod integrators;
pub mod kovalevskaya_top;
pub mod lagrange_top;
pub mod phenomena;
mod precise;
pub mod pythagoras;
pub mod rolling;
pub mod rotating_fluid;
pub mod scene;
mod search;
pub mod superball;
pub mod tippe_top;
pub mod yo_yo;

pub use error::{Error, Result};

// The examples of both READMEs run as doctests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
#[doc = include_str!("README.md")]
struct FrontPages;
