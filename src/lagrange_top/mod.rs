//! Lagrange's top (tutorial 7): a symmetric body on its tip under gravity, exactly and through the poles.
//!
//! The height h = cos θ of the axis goes like sn² between two roots of a cubic; the attitude is a pair of theta functions,
//! one for each Cayley–Klein parameter, regular where the axis passes the vertical. [`LagrangeTop`] decides
//! once what the axis does ([`Nutation`]).

mod evaluation;
mod kinds;
mod motion;
mod preparation;
mod roots;
mod turning;

pub use kinds::{Nutation, Roots};
pub use motion::{LagrangeTop, State};
