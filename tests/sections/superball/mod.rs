//! Paragraph 4.6: the superball, in exact fractions wherever a fraction will do.

mod bounce;
mod common;
mod long_runs;
mod losses;
mod refusals;
mod spring;
mod under_the_table;

use super::*;
use common::*;
use spinning_bodies::superball::{
    BounceRotation, Flight, InFlight, Motion, Surface, UnderTable, bounce, bounce_matrix,
    checked_bounce, reach, spring_bounce,
};
