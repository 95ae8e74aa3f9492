//! Section 1: what a body does to itself. Sliding, swivelling, falling cats of flesh and of paper, the skater.

mod cat;
mod paper_cat;
mod skater;
mod sliding;
mod swivelling;

use super::*;
use spinning_bodies::phenomena::{Hub, ShapePlane, Step, turn_along, turn_within};
use spinning_bodies::scene::effects::{Gravity, Pace};
use spinning_bodies::scene::shape;
