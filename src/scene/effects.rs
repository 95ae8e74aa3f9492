//! The effects that can act in a scene: a type for each, and [`Effect`] for any of them.
//!
//! A kind of scene takes effects one by one, `Top::new(body, start)?.with(Gravity::new(9.81)?)?.with(AirDrag::new(1e-6)?)?`, and rejects by
//! name those that have no meaning for it. An effect that is not given is absent from the equations, not multiplied by zero.

use crate::error::{Error, Result, finite, not_negative, within};

pub use super::path::{Draw, FourPhases, Pace, Turnover};
pub use crate::falling_strip::{AddedMass, Drag, Lift, RotationalDamping};
pub use crate::impacts::Impact;
pub use crate::rolling::{Coulomb, RollingResistance, Sheet, Tug};
pub use crate::superball::Restitution;
pub use crate::tippe_top::{NoSlip, Regularised, Resistance, Viscous};

/// Declares [`Effect`], with a name for each effect.
macro_rules! effects {
    ($($(#[$doc:meta])* $effect:ident, $name:literal;)*) => {
        /// Any of the effects that a scene may call for.
        #[derive(Debug, Clone, PartialEq)]
        #[non_exhaustive]
        pub enum Effect {
            $($(#[$doc])* $effect($effect),)*
        }

        impl Effect {
            /// The name of the effect in a scene file.
            pub(crate) const fn name(&self) -> &'static str {
                match self {
                    $(Self::$effect(_) => $name,)*
                }
            }
        }

        $(impl From<$effect> for Effect {
            fn from(effect: $effect) -> Self {
                Self::$effect(effect)
            }
        })*
    };
}

effects! {
    /// Uniform gravity.
    Gravity, "gravity";
    /// A torque −cΩ at the pivot.
    PivotFriction, "pivot_friction";
    /// A torque −cΩ of a bearing, which spares the spin of a top.
    BearingFriction, "bearing_friction";
    /// A torque −k|Ω|Ω of the air.
    AirDrag, "air_drag";
    /// A dry torque against the spin.
    TipFriction, "tip_friction";
    /// Dry friction at a contact.
    Coulomb, "friction";
    /// Dry friction, smoothed where the slip is small.
    Regularised, "regularised_friction";
    /// Friction in proportion to the slip.
    Viscous, "viscous_friction";
    /// A contact that never slips.
    NoSlip, "no_slip";
    /// Couples against rolling and pivoting.
    Resistance, "resistance";
    /// A reaction that acts ahead of the centre.
    RollingResistance, "rolling_resistance";
    /// A moving ground.
    Sheet, "sheet";
    /// A pull at a string.
    Tug, "tug";
    /// Losses at every bounce.
    Restitution, "restitution";
    /// Lift of a flat body.
    Lift, "lift";
    /// Drag of a flat body.
    Drag, "drag";
    /// Resistance to the rotation of a flat body.
    RotationalDamping, "rotational_damping";
    /// Fluid that is taken along.
    AddedMass, "added_mass";
    /// Air at rest.
    Air, "air";
    /// A meteorite that sticks to a planet.
    Impact, "impact";
    /// A cat that turns over.
    Turnover, "turnover";
    /// A swivel's cycle.
    FourPhases, "four_phases";
    /// Hands that are drawn in.
    Draw, "draw";
    /// Loss of spin at every turn of a yo-yo.
    TurnLoss, "turn_loss";
    /// Work of the hand at every turn.
    Hand, "hand";
    /// A loop in which a yo-yo spins asleep.
    Sleep, "sleep";
    /// Friction in the loop of a yo-yo's string.
    AxleFriction, "axle_friction";
}

impl Effect {
    /// The error of a kind of scene for which this effect has no meaning.
    pub(crate) const fn refused(&self, kind: &'static str, takes: &'static str) -> Error {
        Error::Effect {
            effect: self.name(),
            kind,
            takes,
        }
    }
}

/// Declares the effects that are given by one number.
macro_rules! numbers {
    ($($(#[$doc:meta])* $effect:ident, $(#[$of:meta])* $check:ident($quantity:literal);)*) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "serde", serde(try_from = "f64"))]
        pub struct $effect(f64);

        #[cfg(feature = "serde")]
        impl TryFrom<f64> for $effect {
            type Error = Error;

            fn try_from(value: f64) -> Result<Self> {
                Self::new(value)
            }
        }

        impl $effect {
            $(#[$of])*
            ///
            /// # Errors
            /// [`Error::NotFinite`]; [`Error::Negative`] for a resistance that would drive; [`Error::OutOfRange`] for a fraction outside 0…1.
            pub fn new(value: f64) -> Result<Self> {
                Ok(Self($check($quantity, value)?))
            }

            /// The number.
            pub(crate) const fn value(self) -> f64 {
                self.0
            }
        }
    )*};
}

numbers! {
    /// Uniform gravity, along the negative z axis of space.
    Gravity,
    /// Gravity of this strength, m/s². A top also takes zero, and negative values, which pull up; bodies that gravity must press on a floor do not.
    ///
    /// ```
    /// use spinning_bodies::scene::effects::Gravity;
    /// assert!(Gravity::new(0.1).is_ok() && Gravity::new(f64::NAN).is_err());
    /// ```
    finite("gravity");
    /// Friction at the pivot in proportion to the angular velocity: torque −cΩ (7.5).
    PivotFriction,
    /// The coefficient c, N m s.
    ///
    /// ```
    /// use spinning_bodies::scene::effects::PivotFriction;
    /// assert!(PivotFriction::new(0.1).is_ok() && PivotFriction::new(-0.1).is_err());
    /// ```
    not_negative("pivot friction");
    /// Viscous friction of a bearing: torque −cΩ, of a top −c(Ω₁, Ω₂, 0) (7.4).
    ///
    /// For a sharp tip or the bearing of a top's axle, where tilting and precessing are braked and the spin about the third axis is not. Under a skater or a
    /// swivel even the smallest c decides in the end: L falls by exactly c times the angle turned (1.1).
    BearingFriction,
    /// The coefficient c, N m s.
    ///
    /// ```
    /// use spinning_bodies::scene::effects::BearingFriction;
    /// assert!(BearingFriction::new(0.1).is_ok() && BearingFriction::new(-0.1).is_err());
    /// ```
    not_negative("bearing friction");
    /// Drag of the air in proportion to the square of the angular velocity: torque −k|Ω|Ω (4.9, 7.5).
    AirDrag,
    /// The coefficient k, N m s², which is kg m².
    ///
    /// ```
    /// use spinning_bodies::scene::effects::AirDrag;
    /// assert!(AirDrag::new(0.1).is_ok() && AirDrag::new(-0.1).is_err());
    /// ```
    not_negative("air drag");
    /// Dry friction at the tip, against the spin only: torque −N sgn(Ω₃) about the third axis (7.5).
    ///
    /// A dry tip of radius r under the weight Mg has N = ⅔μMgr. Only for symmetric tops with C on the third axis: once stopped, their spin stays
    /// at rest, which that of no other body would.
    TipFriction,
    /// The torque N, N m.
    ///
    /// ```
    /// use spinning_bodies::scene::effects::TipFriction;
    /// assert!(TipFriction::new(0.1).is_ok() && TipFriction::new(-0.1).is_err());
    /// ```
    not_negative("tip friction");
    /// Air at rest, in which a cat of paper falls (1.1).
    Air,
    /// Its density, kg/m³.
    ///
    /// ```
    /// use spinning_bodies::scene::effects::Air;
    /// assert!(Air::new(0.1).is_ok() && Air::new(-0.1).is_err());
    /// ```
    not_negative("the density of the air");
    /// Loss at every turn of a yo-yo, which keeps only a fraction of the spin (4.9).
    TurnLoss,
    /// Spin after over spin before, 0…1.
    ///
    /// ```
    /// use spinning_bodies::scene::effects::TurnLoss;
    /// assert!(TurnLoss::new(0.1).is_ok() && TurnLoss::new(1.5).is_err());
    /// ```
    part("the restitution of the turn");
    /// Work of the hand at every turn of a yo-yo: it is raised a little while the string pulls hardest (4.9). See
    /// [`Turn::work_of_lift`](crate::yo_yo::Turn::work_of_lift).
    Hand,
    /// The work, J.
    ///
    /// ```
    /// use spinning_bodies::scene::effects::Hand;
    /// assert!(Hand::new(0.1).is_ok() && Hand::new(-0.1).is_err());
    /// ```
    not_negative("the work of the hand");
    /// A loop at the end of a yo-yo's string: the yo-yo falls asleep at the lowest point, and a jerk wakes it (4.9).
    Sleep,
    /// How long it is left asleep, s.
    ///
    /// ```
    /// use spinning_bodies::scene::effects::Sleep;
    /// assert!(Sleep::new(0.1).is_ok() && Sleep::new(-0.1).is_err());
    /// ```
    not_negative("the duration of the sleep");
    /// Friction of the loop of a yo-yo's string on the axle (4.9).
    AxleFriction,
    /// A constant torque, N m.
    ///
    /// ```
    /// use spinning_bodies::scene::effects::AxleFriction;
    /// assert!(AxleFriction::new(0.1).is_ok() && AxleFriction::new(-0.1).is_err());
    /// ```
    not_negative("the friction of the axle");
}

/// The value, if it is a fraction 0…1.
fn part(quantity: &'static str, value: f64) -> Result<f64> {
    within(quantity, value, 0.0, 1.0)
}
