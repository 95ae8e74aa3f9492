//! The drawing tools of all figures: a figure then imports only what it takes from the library.

pub(crate) use crate::figure::{Entry, Figure, of};
pub(crate) use crate::parameter::{Parameter, Values};
pub(crate) use crate::plot::*;
pub(crate) use crate::solid::*;
pub(crate) use crate::style::*;
pub(crate) use core::f64::consts::{FRAC_PI_2, PI, TAU};
pub(crate) use spinning_bodies::Result;
