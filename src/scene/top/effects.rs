//! The effects that can act on a top, and the torque of each.

use crate::error::{Result, finite, not_negative};
use crate::scene::effect::{Absent, Effect};

/// What a torque can depend on: Ω and the upward unit vector z, along the principal axes.
#[derive(Debug, Clone, Copy)]
pub struct Turning {
    /// Ω, rad/s.
    pub omega: [f64; 3],
    /// z.
    pub up: [f64; 3],
}

/// The weight's slot.
pub trait Weight: Effect {
    /// MgC, N m, from MC, kg m: with the upward unit vector z the torque about the pivot is z∧MgC (8.1).
    fn lever(&self, arm: [f64; 3]) -> [f64; 3];
}

/// A slot for a torque that resists the turning.
pub trait Resistance: Effect {
    /// Adds the torque, N m.
    fn add_torque(&self, turning: &Turning, torque: &mut [f64; 3]);
}

impl Weight for Absent {
    fn lever(&self, _: [f64; 3]) -> [f64; 3] {
        [0.0; 3]
    }
}

impl Resistance for Absent {
    fn add_torque(&self, _: &Turning, _: &mut [f64; 3]) {}
}

/// Uniform gravity, down the space z axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gravity {
    g: f64,
}

impl Gravity {
    /// Gravity of `g` m/s². Zero is no gravity, and less pulls up.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite).
    pub fn new(g: f64) -> Result<Self> {
        Ok(Self {
            g: finite("gravity", g)?,
        })
    }
}

impl Effect for Gravity {
    const PRESENT: bool = true;
    const NAME: &'static str = "gravity";
}

impl Weight for Gravity {
    fn lever(&self, arm: [f64; 3]) -> [f64; 3] {
        arm.map(|component| component * self.g)
    }
}

/// Friction at the pivot in proportion to the turning: torque −cΩ (7.5).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PivotFriction {
    coefficient: f64,
}

impl PivotFriction {
    /// The friction with coefficient c in N m s.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Negative`](crate::Error::Negative).
    pub fn new(coefficient: f64) -> Result<Self> {
        Ok(Self {
            coefficient: not_negative("pivot friction", coefficient)?,
        })
    }
}

impl Effect for PivotFriction {
    const PRESENT: bool = true;
    const NAME: &'static str = "pivot_friction";
}

impl Resistance for PivotFriction {
    fn add_torque(&self, turning: &Turning, torque: &mut [f64; 3]) {
        for (component, omega) in torque.iter_mut().zip(turning.omega) {
            *component -= self.coefficient * omega;
        }
    }
}

/// Friction at the pivot that spares the spin: torque −c(Ω₁, Ω₂, 0) (7.4).
///
/// A sharp tip or a bearing of the axle: tilting and precessing cost, spinning about the third axis does not.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingFriction {
    coefficient: f64,
}

impl BearingFriction {
    /// The friction with coefficient c in N m s.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Negative`](crate::Error::Negative).
    pub fn new(coefficient: f64) -> Result<Self> {
        Ok(Self {
            coefficient: not_negative("bearing friction", coefficient)?,
        })
    }
}

impl Effect for BearingFriction {
    const PRESENT: bool = true;
    const NAME: &'static str = "bearing_friction";
}

impl Resistance for BearingFriction {
    fn add_torque(&self, turning: &Turning, torque: &mut [f64; 3]) {
        torque[0] -= self.coefficient * turning.omega[0];
        torque[1] -= self.coefficient * turning.omega[1];
    }
}

/// Drag of the air in proportion to the square of the turning: torque −k|Ω|Ω.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AirDrag {
    coefficient: f64,
}

impl AirDrag {
    /// The drag with coefficient k in N m s².
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Negative`](crate::Error::Negative).
    pub fn new(coefficient: f64) -> Result<Self> {
        Ok(Self {
            coefficient: not_negative("air drag", coefficient)?,
        })
    }
}

impl Effect for AirDrag {
    const PRESENT: bool = true;
    const NAME: &'static str = "air_drag";
}

impl Resistance for AirDrag {
    fn add_torque(&self, turning: &Turning, torque: &mut [f64; 3]) {
        let [x, y, z] = turning.omega;
        // Not `hypot`, which takes longer than all the rest: the square of Ω would have to overflow for it to matter.
        let strength = self.coefficient * (x * x + y * y + z * z).sqrt();
        for (component, omega) in torque.iter_mut().zip(turning.omega) {
            *component -= strength * omega;
        }
    }
}

/// Dry friction at the tip, against the spin alone: torque −N sgn(Ω₃) about the third axis (7.5).
///
/// A dry tip of radius r that bears Mg has N = ⅔μMgr. For symmetric tops on that axis only: there the spin, once stopped, stays
/// stopped, which no other body's would.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TipFriction {
    torque: f64,
}

impl TipFriction {
    /// The friction with torque N in N m.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Negative`](crate::Error::Negative).
    pub fn new(torque: f64) -> Result<Self> {
        Ok(Self {
            torque: not_negative("tip friction", torque)?,
        })
    }
}

impl Effect for TipFriction {
    const PRESENT: bool = true;
    const NAME: &'static str = "tip_friction";
}

impl Resistance for TipFriction {
    fn add_torque(&self, turning: &Turning, torque: &mut [f64; 3]) {
        // At rest it holds: with nothing else to turn it, the spin stays 0.
        if turning.omega[2] != 0.0 {
            torque[2] -= self.torque.copysign(turning.omega[2]);
        }
    }
}
