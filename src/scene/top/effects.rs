//! The top, the effects on it, and its state.

use nalgebra::Matrix3;

use super::body::{Body, Start};
use crate::error::refused;
use crate::scene::effects::{AirDrag, BearingFriction, Gravity, PivotFriction, TipFriction};
use crate::scene::prelude::*;

/// A top and the effects on it.
///
/// ```
/// use spinning_bodies::frame::{Attitude, BodyVector};
/// use spinning_bodies::scene::{Request, Scene, effects::Gravity, top::{Body, Start, Top}};
/// let body = Body::new([1.0, 1.0, 0.3])?.with_center_of_mass(1.0, BodyVector::new(0.0, 0.0, 0.7))?;
/// let start = Start::with_omega(BodyVector::new(0.1, 0.3, 4.0), Attitude::identity());
/// let top = Top::new(body, start)?.with(Gravity::new(9.81)?)?;
/// let solver = |accuracy| Ok(top.simulate(&Request::at([0.5])?.to_accuracy(accuracy)?)?.plan.solver.name());
/// // A closed form, unless more is asked than the 6e-14 that it states: so early that steps may keep.
/// assert_eq!([solver(7e-14)?, solver(2e-14)?], ["exact", "dormand-prince-8"]);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Top {
    pub(super) body: Body,
    pub(super) start: Start,
    pub(super) gravity: Option<Gravity>,
    pub(super) pivot_friction: Option<PivotFriction>,
    pub(super) bearing_friction: Option<BearingFriction>,
    pub(super) air_drag: Option<AirDrag>,
    pub(super) tip_friction: Option<TipFriction>,
}

/// Reads the fields of a serialised top.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
#[serde(remote = "Top", deny_unknown_fields)]
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
impl<'de> serde::Deserialize<'de> for Top {
    fn deserialize<D: serde::Deserializer<'de>>(text: D) -> core::result::Result<Self, D::Error> {
        let read = Written::deserialize(text)?;
        read.checked().map_err(serde::de::Error::custom)
    }
}

/// A top at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct State {
    /// The attitude.
    pub attitude: Attitude,
    /// Ω along the body's axes, rad/s.
    pub omega: BodyVector,
    /// Kinetic energy plus potential energy relative to the pivot, J.
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
    /// The body without effects.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite) for the start.
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
        let top = Self {
            body,
            start: start.inward(&body),
            gravity: None,
            pivot_friction: None,
            bearing_friction: None,
            air_drag: None,
            tip_friction: None,
        };
        top.checked()
    }

    /// Adds an effect, or replaces its value.
    ///
    /// # Errors
    /// [`Error::Effect`](crate::Error::Effect) for one that has no meaning for a top. [`Error::Condition`](crate::Error::Condition) for tip friction unless I₁ = I₂ and C lies on the third axis, because
    /// the spin of any other body would not stay at rest; for bearing friction of a body whose own axes are not principal.
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
        let takes = "gravity, pivot_friction, bearing_friction, air_drag and tip_friction";
        match effect.into() {
            Effect::Gravity(gravity) => self.gravity = Some(gravity),
            Effect::PivotFriction(friction) => self.pivot_friction = Some(friction),
            Effect::BearingFriction(friction) => self.bearing_friction = Some(friction),
            Effect::AirDrag(drag) => self.air_drag = Some(drag),
            Effect::TipFriction(friction) => self.tip_friction = Some(friction),
            other => return Err(other.refused("a top", takes)),
        }
        self.checked()
    }

    /// The top, if its start is finite and its body is one for its effects.
    fn checked(self) -> Result<Self> {
        let body = self.body;
        self.start.omega(body.moments)?;
        if let Some(own) = body.own {
            let turn = own.quaternion().to_rotation_matrix();
            let matrix = turn * Matrix3::from_diagonal(&body.moments.into()) * turn.inverse();
            let [xy, xz, yz] = [matrix.m12, matrix.m13, matrix.m23].map(f64::abs);
            let product = xy.max(xz).max(yz);
            if self.bearing_friction.is_some() {
                let condition = "bearing friction is for bodies whose own axes are principal axes, without products of inertia in kg m²";
                return refused(condition, product);
            }
            if self.tip_friction.is_some() {
                let condition = "tip friction is for bodies whose own axes are principal axes, without products of inertia in kg m²";
                return refused(condition, product);
            }
        }
        if self.tip_friction.is_some() && !body.is_symmetric_about_third() {
            let ([x, y, _], [first, second, _]) = (body.center, body.moments);
            let condition = "tip friction is for bodies with the centre of mass on the third axis";
            return match x.hypot(y) {
                0.0 => refused("tip friction is for bodies with I2/I1 = 1", second / first),
                off => refused(condition, off),
            };
        }
        Ok(self)
    }

    /// MgC, N m: with the upward unit vector z the torque about the pivot is z∧MgC (8.1).
    pub(super) fn lever(&self) -> [f64; 3] {
        let g = self.g();
        self.body.arm().map(|component| component * g)
    }

    pub(super) fn g(&self) -> f64 {
        self.gravity.map_or(0.0, Gravity::value)
    }

    /// Succeeds if every axis has a moment or nothing resists: resistance excludes the closed forms, and steps need all moments.
    ///
    /// # Errors
    /// [`Error::NotPositive`].
    #[cfg(feature = "scene-files")]
    pub(in crate::scene) fn can_be_resisted(&self) -> Result<()> {
        let mut resisting = self.resisting();
        resisting.try_for_each(|_| self.body.has_every_moment())
    }

    /// The names of the resistances.
    pub(super) fn resisting(&self) -> impl Iterator<Item = &'static str> {
        let effects: [Option<Effect>; 4] = [
            self.pivot_friction.map(Effect::from),
            self.bearing_friction.map(Effect::from),
            self.air_drag.map(Effect::from),
            self.tip_friction.map(Effect::from),
        ];
        effects.into_iter().flatten().map(|effect| effect.name())
    }

    /// The pace, rad/s: the rate at which this top turns, or its weight would make it fall.
    pub(super) fn pace(&self) -> Result<f64> {
        let omega = self.start.omega(self.body.moments)?.norm();
        Ok(omega.hypot(self.falling()).max(f64::MIN_POSITIVE))
    }

    /// The rate at which its weight would make it fall, rad/s; 0 without weight.
    pub(super) fn falling(&self) -> f64 {
        let moments = self.body.moments;
        let [x, y, z] = self.lever();
        let arms = [y.hypot(z), z.hypot(x), x.hypot(y)];
        let ratios = [0, 1, 2].map(|k| match moments[k] {
            0.0 => 0.0,
            moment => arms[k] / moment,
        });
        (2.0 * BodyVector::from(ratios).norm()).sqrt()
    }
}
