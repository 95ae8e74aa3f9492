//! The launched top of the chapter, and where its nose is.

use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::lagrange_top::{LagrangeTop, PurePrecession, pure_precession};

use crate::prelude::*;

/// A top whose axis is at its turning point cos θ = `height`, going round the vertical at the rate φ′ = `pace`.
pub fn launch(height: f64, pace: f64, axial: f64) -> Result<LagrangeTop> {
    launch_body(height, pace, 1.0, axial)
}

/// The same for I₃ = `moment` and Ω₃ = `spin`.
pub fn launch_body(height: f64, pace: f64, moment: f64, spin: f64) -> Result<LagrangeTop> {
    let tilt = height.acos();
    let attitude = Attitude::about_axis(BodyVector::new(0.0, 1.0, 0.0), tilt)?;
    let omega = BodyVector::new(-pace * tilt.sin(), 0.0, spin);
    LagrangeTop::new(1.0, moment, 1.0, omega, attitude)
}

/// Both rates of pure precession at cos θ = `height`, slow and fast (7.3): the fast one infinite if the axis is horizontal, neither a
/// number where there is none.
pub fn pure_rates(height: f64, axial: f64) -> Result<[f64; 2]> {
    Ok(match pure_precession(1.0, 1.0, axial, height)? {
        PurePrecession::Two { slow, fast } => [slow, fast],
        PurePrecession::One(rate) if height == 0.0 => [rate, f64::INFINITY],
        PurePrecession::One(rate) => [rate, rate],
        PurePrecession::None | PurePrecession::Any => [f64::NAN; 2],
    })
}

/// A time with the tilt and the azimuth of a nose, °.
pub fn angles((time, nose): (f64, Vector)) -> [f64; 3] {
    let tilt = nose.x.hypot(nose.y).atan2(nose.z);
    [time, tilt.to_degrees(), nose.y.atan2(nose.x).to_degrees()]
}

/// The position of the nose of the top at a time, at unit distance from the pivot.
pub fn nose(top: &LagrangeTop, time: f64) -> Result<Vector> {
    let axis = BodyVector::new(0.0, 0.0, 1.0);
    Ok(top.at(time)?.attitude.to_space(axis).components())
}
