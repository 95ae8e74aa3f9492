//! The toy of the chapter.

use spinning_bodies::yo_yo::YoYo;

use crate::prelude::*;

pub const GRAVITY: f64 = 9.81;

parameters! {
    pub AXLE: "axle", "r", "mm", "radius of the axle", [3.0, 9.0], 5.0;
    pub LENGTH: "length", r"\ell", "m", "length of the string", [0.4, 1.5], 1.0;
}

/// Mass of the toy, kg.
pub const MASS: f64 = 0.055;

/// The toy of the chapter: 55 g, radius 29 mm, a metre of string on an axle of 5 mm.
pub fn toy(values: &Values, axle: &Parameter) -> Result<YoYo> {
    YoYo::disc(MASS, 0.029, values.of(&LENGTH), values.of(axle) / 1e3)
}
