//! From effects that a list names at run time to a scene of the type they make.

use super::{Strip, StripStart, StripState};
use crate::error::Result;
use crate::falling_strip::{AddedMass, Drag, Equations, Gravity, Lift, Plate, RotationalDamping};
use crate::scene::{Scene, choose};

/// Effects of a strip that are known at run time only, as from a scene file.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Listed {
    /// Weight.
    pub gravity: Option<Gravity>,
    /// Lift.
    pub lift: Option<Lift>,
    /// Drag.
    pub drag: Option<Drag>,
    /// Resistance to rotation.
    pub rotational_damping: Option<RotationalDamping>,
    /// Added mass.
    pub added_mass: Option<AddedMass>,
}

impl Listed {
    /// The scene of a strip with just these effects.
    ///
    /// # Errors
    /// As [`Strip::new`], and the builder method of each effect.
    pub fn on(
        &self,
        plate: Plate,
        start: StripStart,
    ) -> Result<Box<dyn Scene<State = StripState>>> {
        let bare = Strip::new(plate, start)?;
        if let Some(effect) = self.gravity {
            bare.with_gravity(effect)?;
        }
        if let Some(effect) = self.lift {
            bare.with_lift(effect)?;
        }
        if let Some(effect) = self.drag {
            bare.with_drag(effect)?;
        }
        if let Some(effect) = self.rotational_damping {
            bare.with_rotational_damping(effect)?;
        }
        if let Some(effect) = self.added_mass {
            bare.with_added_mass(effect)?;
        }
        Ok(
            choose!((gravity = self.gravity) (lift = self.lift) (drag = self.drag) (damping = self.rotational_damping)
            (added_mass = self.added_mass) => {
                let equations = Equations { plate, gravity, lift, drag, damping, added_mass };
                Box::new(Strip { equations, start })
            }),
        )
    }
}
