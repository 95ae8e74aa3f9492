//! Gravity, losses and a limited grip, and what stands for each where there is none.

use super::super::Restitution;
use crate::error::{Result, not_negative};
use crate::rolling::course::Nothing;

/// Gravity, or none.
pub trait Gravity: Copy {
    /// Whether there is any.
    const ACTS: bool;
    /// Acceleration downward, m/s².
    fn strength(&self) -> f64;
}

/// Restitution, or none: elastic.
pub trait Losses: Copy {
    /// Whether there are any.
    const ACTS: bool;
    /// e_n and e_t.
    fn restitution(&self) -> [f64; 2];
}

/// A limit to the grip of the contact, or none.
pub trait Grip: Copy {
    /// Whether there is one.
    const ACTS: bool;
    /// Coefficient of friction.
    fn friction(&self) -> f64;
}

/// Acceleration of gravity, m/s².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weight(f64);

impl Weight {
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Negative`](crate::Error::Negative).
    pub fn new(strength: f64) -> Result<Self> {
        Ok(Self(not_negative("the acceleration of gravity", strength)?))
    }
}

/// Friction that limits the tangential impulse of a bounce to μ times the normal one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slipping(f64);

impl Slipping {
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Negative`](crate::Error::Negative).
    pub fn new(friction: f64) -> Result<Self> {
        Ok(Self(not_negative("the coefficient of friction", friction)?))
    }
}

impl Gravity for Weight {
    const ACTS: bool = true;
    fn strength(&self) -> f64 {
        self.0
    }
}

impl Losses for Restitution {
    const ACTS: bool = true;
    fn restitution(&self) -> [f64; 2] {
        [self.normal(), self.tangential()]
    }
}

impl Grip for Slipping {
    const ACTS: bool = true;
    fn friction(&self) -> f64 {
        self.0
    }
}

impl Gravity for Nothing {
    const ACTS: bool = false;
    fn strength(&self) -> f64 {
        0.0
    }
}

impl Losses for Nothing {
    const ACTS: bool = false;
    fn restitution(&self) -> [f64; 2] {
        [1.0; 2]
    }
}

impl Grip for Nothing {
    const ACTS: bool = false;
    fn friction(&self) -> f64 {
        f64::INFINITY
    }
}
