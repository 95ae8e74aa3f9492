//! A yo-yo let go or thrown from the hand (tutorial 4.9): down, turn, up, and down again; or down, asleep, awake, and up.
//!
//! | effect | slot | absent |
//! |---|---|---|
//! | weight | [`with_gravity`](Play::with_gravity) | it unwinds by its throw alone |
//! | loss at the turn | [`with_turn_loss`](Play::with_turn_loss) | every turn gives the spin back |
//! | work of the hand | [`with_hand`](Play::with_hand) | the hand holds still |
//! | a loop at the end of the string | [`with_sleep`](Play::with_sleep) | a knot: it comes up at once |
//! | friction in the loop | [`with_axle_friction`](Play::with_axle_friction) | it sleeps without loss |
//! | resistance of the air | [`with_air_drag`](Play::with_air_drag) | none; with it the closed forms end |

mod effects;
mod engine;
mod exact;
mod general;
mod listed;

pub use effects::{AirDrag, AxleFriction, Gravity, Hand, Sleep, TurnLoss};
pub use listed::Listed;

use super::effect::Absent;
use super::motion::{Motion, Request};
use super::plan::Plan;
use super::{Scene, Tabulated};
use crate::error::{Result, not_negative};
use crate::yo_yo::YoYo;
use effects::{AirTerm, AxleTerm, HandTerm, Passed, SleepTerm, TurnTerm, Weight};
use engine::{Acting, Setting};

/// What the yo-yo is at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// On its way down.
    Down,
    /// In the turn at the end of the string.
    Turn,
    /// On its way up.
    Up,
    /// Spinning in the loop.
    Asleep,
    /// At the end of the string, without spin enough to leave it.
    Hanging,
    /// Back in the hand with speed to spare, and caught.
    Caught,
}

/// The state of a yo-yo.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YoYoState {
    /// What it is at.
    pub phase: Phase,
    /// Depth below the hand, m.
    pub depth: f64,
    /// Velocity downward, m/s.
    pub velocity: f64,
    /// Spin, rad/s; its sense never changes.
    pub omega: f64,
    /// Pull of the string, N; the blows on falling asleep and on waking are not in it.
    pub tension: f64,
    /// Kinetic and potential energy, J; zero at rest at the hand.
    pub energy: f64,
    /// Energy lost so far, J.
    pub heat: f64,
    /// Work that the hand has done so far, J; catching counts against it.
    pub work: f64,
}

impl Tabulated for YoYoState {
    const COLUMNS: &'static [&'static str] = &[
        "depth", "velocity", "omega", "tension", "energy", "heat", "work",
    ];

    fn row(&self) -> Vec<f64> {
        vec![
            self.depth,
            self.velocity,
            self.omega,
            self.tension,
            self.energy,
            self.heat,
            self.work,
        ]
    }
}

/// A yo-yo, how fast it is thrown, and what acts on it.
///
/// Effects fill slots of their own, so the order in which they are listed cannot matter.
///
/// ```
/// use spinning_bodies::scene::{Request, Scene, yo_yo::{Gravity, Play}};
/// use spinning_bodies::yo_yo::YoYo;
///
/// let toy = YoYo::disc(0.055, 0.029, 1.0, 0.005)?;
/// let play = Play::new(toy, 0.0)?.with_gravity(Gravity { acceleration: 9.81 })?;
/// let motion = play.simulate(&Request::at([1.9])?)?;
/// assert!((motion.rows[0].1.depth - 0.9936).abs() < 1e-4);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Play<G = Absent, T = Absent, H = Absent, S = Absent, X = Absent, W = Absent> {
    toy: YoYo,
    throw: f64,
    gravity: G,
    turn_loss: T,
    hand: H,
    sleep: S,
    axle_friction: X,
    air_drag: W,
}

impl Play {
    /// This yo-yo, thrown from the hand with this speed (m/s; 0: let go).
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Negative`](crate::Error::Negative).
    pub fn new(toy: YoYo, throw: f64) -> Result<Self> {
        Ok(Self {
            toy,
            throw: not_negative("the speed of the throw", throw)?,
            gravity: Absent,
            turn_loss: Absent,
            hand: Absent,
            sleep: Absent,
            axle_friction: Absent,
            air_drag: Absent,
        })
    }
}

impl<G: Copy, T: Copy, H: Copy, S: Copy, X: Copy, W: Copy> Play<G, T, H, S, X, W> {
    /// Adds weight.
    ///
    /// # Errors
    /// As the fields of the effect say.
    pub fn with_gravity(self, effect: Gravity) -> Result<Play<Gravity, T, H, S, X, W>> {
        Ok(Play {
            toy: self.toy,
            throw: self.throw,
            gravity: effect.checked()?,
            turn_loss: self.turn_loss,
            hand: self.hand,
            sleep: self.sleep,
            axle_friction: self.axle_friction,
            air_drag: self.air_drag,
        })
    }

    /// Adds the loss of every turn.
    ///
    /// # Errors
    /// As the fields of the effect say.
    pub fn with_turn_loss(self, effect: TurnLoss) -> Result<Play<G, TurnLoss, H, S, X, W>> {
        Ok(Play {
            toy: self.toy,
            throw: self.throw,
            gravity: self.gravity,
            turn_loss: effect.checked()?,
            hand: self.hand,
            sleep: self.sleep,
            axle_friction: self.axle_friction,
            air_drag: self.air_drag,
        })
    }

    /// Adds the work of the hand at every turn.
    ///
    /// # Errors
    /// As the fields of the effect say.
    pub fn with_hand(self, effect: Hand) -> Result<Play<G, T, Hand, S, X, W>> {
        Ok(Play {
            toy: self.toy,
            throw: self.throw,
            gravity: self.gravity,
            turn_loss: self.turn_loss,
            hand: effect.checked()?,
            sleep: self.sleep,
            axle_friction: self.axle_friction,
            air_drag: self.air_drag,
        })
    }

    /// Ties the string in a loop, so that the yo-yo sleeps at the end of it.
    ///
    /// # Errors
    /// As the fields of the effect say.
    pub fn with_sleep(self, effect: Sleep) -> Result<Play<G, T, H, Sleep, X, W>> {
        Ok(Play {
            toy: self.toy,
            throw: self.throw,
            gravity: self.gravity,
            turn_loss: self.turn_loss,
            hand: self.hand,
            sleep: effect.checked()?,
            axle_friction: self.axle_friction,
            air_drag: self.air_drag,
        })
    }

    /// Adds the friction of the loop on the axle while the yo-yo sleeps.
    ///
    /// # Errors
    /// As the fields of the effect say.
    pub fn with_axle_friction(
        self,
        effect: AxleFriction,
    ) -> Result<Play<G, T, H, S, AxleFriction, W>> {
        Ok(Play {
            toy: self.toy,
            throw: self.throw,
            gravity: self.gravity,
            turn_loss: self.turn_loss,
            hand: self.hand,
            sleep: self.sleep,
            axle_friction: effect.checked()?,
            air_drag: self.air_drag,
        })
    }

    /// Adds the resistance of the air to the spin.
    ///
    /// # Errors
    /// As the fields of the effect say.
    pub fn with_air_drag(self, effect: AirDrag) -> Result<Play<G, T, H, S, X, AirDrag>> {
        Ok(Play {
            toy: self.toy,
            throw: self.throw,
            gravity: self.gravity,
            turn_loss: self.turn_loss,
            hand: self.hand,
            sleep: self.sleep,
            axle_friction: self.axle_friction,
            air_drag: effect.checked()?,
        })
    }
}

impl<G, T, H, S, X, W> Play<G, T, H, S, X, W>
where
    G: Weight,
    T: TurnTerm,
    H: HandTerm,
    S: SleepTerm,
    X: AxleTerm,
    W: AirTerm,
{
    /// The scene for the engine, which is compiled once for all lists of effects.
    fn setting(&self) -> Setting<'_> {
        Setting {
            toy: self.toy,
            throw: self.throw,
            effects: self,
        }
    }
}

impl<G, T, H, S, X, W> Acting for Play<G, T, H, S, X, W>
where
    G: Weight,
    T: TurnTerm,
    H: HandTerm,
    S: SleepTerm,
    X: AxleTerm,
    W: AirTerm,
{
    fn gravity(&self) -> f64 {
        self.gravity.acceleration()
    }

    fn turned(&self, passed: &mut Passed, kinetic: &dyn Fn(f64) -> f64) {
        self.turn_loss.pass(passed, kinetic);
        self.hand.pass(passed, 2.0 * kinetic(1.0));
    }

    fn sleeps(&self) -> Option<f64> {
        S::PRESENT.then(|| self.sleep.duration())
    }

    fn torque(&self) -> f64 {
        self.axle_friction.torque()
    }

    fn air(&self) -> Option<f64> {
        W::PRESENT.then(|| self.air_drag.coefficient())
    }
}

impl<G, T, H, S, X, W> Scene for Play<G, T, H, S, X, W>
where
    G: Weight,
    T: TurnTerm,
    H: HandTerm,
    S: SleepTerm,
    X: AxleTerm,
    W: AirTerm,
{
    type State = YoYoState;

    fn plan(&self, request: &Request) -> Result<Plan> {
        self.setting().plan(request)
    }

    fn simulate(&self, request: &Request) -> Result<Motion<YoYoState>> {
        self.setting().motion(request)
    }
}
