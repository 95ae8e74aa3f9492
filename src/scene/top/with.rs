//! A top with one effect more.

use super::{AirDrag, BearingFriction, Gravity, PivotFriction, TipFriction, Top};
use crate::error::{Error, Result};
use crate::scene::Absent;

impl<F, B, D, T> Top<Absent, F, B, D, T> {
    /// The same under gravity.
    pub fn with_gravity(self, gravity: Gravity) -> Top<Gravity, F, B, D, T> {
        Top {
            body: self.body,
            start: self.start,
            gravity,
            pivot_friction: self.pivot_friction,
            bearing_friction: self.bearing_friction,
            air_drag: self.air_drag,
            tip_friction: self.tip_friction,
        }
    }
}

impl<G, B, D, T> Top<G, Absent, B, D, T> {
    /// The same with friction at the pivot.
    pub fn with_pivot_friction(
        self,
        pivot_friction: PivotFriction,
    ) -> Top<G, PivotFriction, B, D, T> {
        Top {
            body: self.body,
            start: self.start,
            gravity: self.gravity,
            pivot_friction,
            bearing_friction: self.bearing_friction,
            air_drag: self.air_drag,
            tip_friction: self.tip_friction,
        }
    }
}

impl<G, F, D, T> Top<G, F, Absent, D, T> {
    /// The same with friction at the pivot that spares the spin.
    pub fn with_bearing_friction(
        self,
        bearing_friction: BearingFriction,
    ) -> Top<G, F, BearingFriction, D, T> {
        Top {
            body: self.body,
            start: self.start,
            gravity: self.gravity,
            pivot_friction: self.pivot_friction,
            bearing_friction,
            air_drag: self.air_drag,
            tip_friction: self.tip_friction,
        }
    }
}

impl<G, F, B, T> Top<G, F, B, Absent, T> {
    /// The same with drag of the air.
    pub fn with_air_drag(self, air_drag: AirDrag) -> Top<G, F, B, AirDrag, T> {
        Top {
            body: self.body,
            start: self.start,
            gravity: self.gravity,
            pivot_friction: self.pivot_friction,
            bearing_friction: self.bearing_friction,
            air_drag,
            tip_friction: self.tip_friction,
        }
    }
}

impl<G, F, B, D> Top<G, F, B, D, Absent> {
    /// The same with dry friction at the tip.
    ///
    /// # Errors
    /// [`Error::Condition`] unless I₁ = I₂ and C lies on the third axis: of another body the spin would not stay stopped.
    pub fn with_tip_friction(
        self,
        tip_friction: TipFriction,
    ) -> Result<Top<G, F, B, D, TipFriction>> {
        if !self.body.is_symmetric_about_third() {
            return Err(Error::Condition {
                condition: "tip friction is for bodies with I1 = I2 and the centre of mass on the third axis",
                value: self.body.moments[1] / self.body.moments[0],
            });
        }
        Ok(Top {
            body: self.body,
            start: self.start,
            gravity: self.gravity,
            pivot_friction: self.pivot_friction,
            bearing_friction: self.bearing_friction,
            air_drag: self.air_drag,
            tip_friction,
        })
    }
}
