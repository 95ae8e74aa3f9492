//! Paragraph 4.3: the billiard shot, and what the cloth does to it.

mod billiard_shot;
mod cloth;

use super::*;
use spinning_bodies::rolling::{Coulomb, Course, Happening, Load, RoundBody};
use spinning_bodies::scene::Roller;
