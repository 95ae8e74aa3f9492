//! A body held at a point, what acts on it, and its state at one time.

use super::body::{Body, Start};
use super::closed::ClosedForm;
use crate::error::{Error, Result};
use crate::frame::{Attitude, BodyVector};
use crate::scene::Tabulated;
use crate::scene::columns::{Columns, columns};
use crate::scene::effects::{
    AirDrag, BearingFriction, Effect, Gravity, PivotFriction, TipFriction,
};

/// A top and the effects at work on it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "Written")
)]
pub struct Top {
    pub(super) body: Body,
    pub(super) start: Start,
    pub(super) gravity: Option<Gravity>,
    pub(super) pivot_friction: Option<PivotFriction>,
    pub(super) bearing_friction: Option<BearingFriction>,
    pub(super) air_drag: Option<AirDrag>,
    pub(super) tip_friction: Option<TipFriction>,
}

/// A top as it was written, with effects that it may not take.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    body: Body,
    start: Start,
    gravity: Option<Gravity>,
    pivot_friction: Option<PivotFriction>,
    bearing_friction: Option<BearingFriction>,
    air_drag: Option<AirDrag>,
    tip_friction: Option<TipFriction>,
}

#[cfg(feature = "serde")]
impl TryFrom<Written> for Top {
    type Error = Error;

    fn try_from(written: Written) -> Result<Self> {
        let effects = [
            written.gravity.map(Effect::from),
            written.pivot_friction.map(Effect::from),
            written.bearing_friction.map(Effect::from),
            written.air_drag.map(Effect::from),
            written.tip_friction.map(Effect::from),
        ];
        let alone = Self::of_principal_axes(written.body, written.start)?;
        effects.into_iter().flatten().try_fold(alone, Self::with)
    }
}

/// A top at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct State {
    /// How the body stands in space.
    pub attitude: Attitude,
    /// Ω along the body's axes, rad/s.
    pub omega: BodyVector,
    /// Kinetic energy, plus potential energy above the pivot, J.
    pub energy: f64,
}

impl Tabulated for State {
    fn columns() -> Columns<Self> {
        Columns::default()
            .attitude(|state: &Self| state.attitude)
            .omega(|state| state.omega)
            .and(columns! { |state: &Self|
                "energy", "J", "kinetic energy, and of the weight above the pivot" => state.energy;
            })
    }
}

impl Top {
    /// The body, left alone.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for the start.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::scene::{Request, Scene, top::{AirDrag, Body, Gravity, Start, Top}};
    /// let body = Body::new([2.0, 2.0, 1.0])?.with_center_of_mass(1.0, BodyVector::new(0.0, 0.0, 0.5))?;
    /// let start = Start::with_omega(BodyVector::new(0.1, 0.0, 9.0), Attitude::identity());
    /// let free = Top::new(body, start)?;
    /// let heavy = free.with(Gravity::new(9.80665)?)?;
    /// let rubbed = heavy.with(AirDrag::new(1e-3)?)?;
    /// let request = Request::at([1.0])?;
    /// assert_eq!(free.plan(&request)?.to_string(), "exact: no torque: closed form");
    /// assert_eq!(heavy.plan(&request)?.to_string(), "exact: gravity on a symmetric top: closed form");
    /// assert_eq!(rubbed.plan(&request)?.to_string(), "dormand-prince-8: air_drag: no closed form");
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(body: Body, start: Start) -> Result<Self> {
        Self::of_principal_axes(body, start.inward(&body))
    }

    /// The same with a start along the principal axes.
    fn of_principal_axes(body: Body, start: Start) -> Result<Self> {
        start.omega(body.moments)?;
        Ok(Self {
            body,
            start,
            gravity: None,
            pivot_friction: None,
            bearing_friction: None,
            air_drag: None,
            tip_friction: None,
        })
    }

    /// The same with one effect more, or with another value of one that it has.
    ///
    /// # Errors
    /// [`Error::Effect`] for one that has no meaning for a top. [`Error::Condition`] for tip friction unless I₁ = I₂ and C lies on the third axis: of
    /// another body the spin would not stay stopped; for bearing friction of a body whose own axes are not principal ones.
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, scene::{effects::{AirDrag, TurnLoss}, top::{Body, Start, Top}}};
    /// let start = Start::with_omega(BodyVector::new(0.0, 0.0, 2.0), Attitude::identity());
    /// let free = Top::new(Body::new([1.0, 2.0, 3.0])?, start)?;
    /// assert!(free.with(AirDrag::new(1e-6)?).is_ok());
    /// assert!(free.with(TurnLoss::new(0.9)?).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn with(mut self, effect: impl Into<Effect>) -> Result<Self> {
        match effect.into() {
            Effect::Gravity(gravity) => self.gravity = Some(gravity),
            Effect::PivotFriction(friction) => self.pivot_friction = Some(friction),
            Effect::BearingFriction(_) if self.body.own.is_some() => {
                return Err(Error::Condition {
                    condition: "bearing friction is for bodies whose own axes are principal axes, all three products of inertia zero",
                    value: self.body.own.map_or(0.0, |own| own.angle()),
                });
            }
            Effect::BearingFriction(friction) => self.bearing_friction = Some(friction),
            Effect::AirDrag(drag) => self.air_drag = Some(drag),
            Effect::TipFriction(friction) if self.body.is_symmetric_about_third() => {
                self.tip_friction = Some(friction);
            }
            Effect::TipFriction(_) => {
                return Err(Error::Condition {
                    condition: "tip friction is for bodies with I1 = I2 and the centre of mass on the third axis",
                    value: self.body.moments[1] / self.body.moments[0],
                });
            }
            other => {
                let takes = "gravity, pivot_friction, bearing_friction, air_drag and tip_friction";
                return Err(other.refused("a top", takes));
            }
        }
        Ok(self)
    }

    /// The motion in closed form, if this scene has one.
    ///
    /// # Errors
    /// Those of the solution.
    pub(crate) fn closed_form(&self) -> Result<Option<ClosedForm>> {
        if self.resisting().next().is_some() {
            return Ok(None);
        }
        ClosedForm::find(&self.body, self.g(), &self.start)
    }

    /// MgC, N m: with the upward unit vector z the torque about the pivot is z∧MgC (8.1).
    pub(super) fn lever(&self) -> [f64; 3] {
        let g = self.g();
        self.body.arm().map(|component| component * g)
    }

    pub(super) fn g(&self) -> f64 {
        self.gravity.map_or(0.0, Gravity::value)
    }

    /// The names of what resists.
    pub(super) fn resisting(&self) -> impl Iterator<Item = &'static str> {
        let effects: [Option<Effect>; 4] = [
            self.pivot_friction.map(Effect::from),
            self.bearing_friction.map(Effect::from),
            self.air_drag.map(Effect::from),
            self.tip_friction.map(Effect::from),
        ];
        effects.into_iter().flatten().map(|effect| effect.name())
    }

    /// The rate that this top turns at, or would if its weight made it fall, rad/s.
    pub(super) fn pace(&self) -> Result<f64> {
        let moments = self.body.moments;
        let omega = self.start.omega(moments)?.norm();
        let [x, y, z] = self.lever();
        let arms = [y.hypot(z), z.hypot(x), x.hypot(y)];
        let square: f64 = (0..3)
            .filter(|&k| moments[k] > 0.0)
            .map(|k| (arms[k] / moments[k]).powi(2))
            .sum();
        let falling = (2.0 * square.sqrt()).sqrt();
        Ok(omega.hypot(falling).max(f64::MIN_POSITIVE))
    }
}
