//! From effects that a list names at run time to a scene of the type they make.

use super::{AirDrag, AxleFriction, Gravity, Hand, Play, Sleep, TurnLoss, YoYoState};
use crate::error::Result;
use crate::scene::{Scene, choose};
use crate::yo_yo::YoYo;

/// Effects of a yo-yo that are known at run time only, as from a scene file.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Listed {
    /// Weight.
    pub gravity: Option<Gravity>,
    /// Loss of every turn.
    pub turn_loss: Option<TurnLoss>,
    /// Work of the hand.
    pub hand: Option<Hand>,
    /// The loop.
    pub sleep: Option<Sleep>,
    /// Friction in the loop.
    pub axle_friction: Option<AxleFriction>,
    /// Resistance of the air.
    pub air_drag: Option<AirDrag>,
}

impl Listed {
    /// The scene of a yo-yo, thrown with this speed (m/s), with just these effects.
    ///
    /// # Errors
    /// As [`Play::new`], and the builder method of each effect.
    pub fn on(&self, toy: YoYo, throw: f64) -> Result<Box<dyn Scene<State = YoYoState>>> {
        Play::new(toy, throw)?;
        let gravity = self.gravity.map(Gravity::checked).transpose()?;
        let turn_loss = self.turn_loss.map(TurnLoss::checked).transpose()?;
        let hand = self.hand.map(Hand::checked).transpose()?;
        let sleep = self.sleep.map(Sleep::checked).transpose()?;
        let axle_friction = self.axle_friction.map(AxleFriction::checked).transpose()?;
        let air_drag = self.air_drag.map(AirDrag::checked).transpose()?;
        Ok(
            choose!((gravity = gravity) (turn_loss = turn_loss) (hand = hand) (sleep = sleep) (axle_friction = axle_friction)
            (air_drag = air_drag) => {
                Box::new(Play { toy, throw, gravity, turn_loss, hand, sleep, axle_friction, air_drag })
            }),
        )
    }
}
