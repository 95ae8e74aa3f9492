//! Scenes: every effect changes the answer, its zero limit does not, the ledger balances, and closed forms agree with integrators.

mod bodies;
mod contact;
mod files;
mod film;
mod meteorite;
mod roller;
mod shape;
mod spool;
mod strip;
mod superball;
mod told;
mod top;
mod units;
mod yo_yo;

use super::*;
use roller::{agreed, balance, same, times};
use spinning_bodies::rolling::{RoundBody, SheetSpeeds, Spool};
use spinning_bodies::scene::effects::{
    BearingFriction, Coulomb, Effect, Gravity, Restitution, RollingResistance, Sheet, Tug, TurnLoss,
};
use spinning_bodies::scene::{Motion, Tabulated};
