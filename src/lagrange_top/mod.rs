//! Lagrange's top (tutorial 7): a symmetric body on its tip under gravity, exactly and through the poles.

mod motion;
mod roots;
mod turning;

pub use motion::{LagrangeTop, State};
