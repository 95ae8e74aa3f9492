//! Lagrange's top (tutorial 7): a symmetric body on its tip under gravity, exactly and through the poles.
//!
//! The height h = cos θ of the axis goes like sn² between two roots of a cubic; the attitude is a pair of theta functions,
//! one for each Cayley–Klein parameter, regular where the axis passes the vertical. [`LagrangeTop`] decides
//! once what the axis does ([`Nutation`]).
//!
//! | paragraph | what | where |
//! |---|---|---|
//! | 7.1, 7.2 | tilt, azimuth and attitude at any time; period and precession; the kind of nutation | [`LagrangeTop`] |
//! | 7.2, 7.5 | a top from L₃, L_vert and E; waking exactly | [`LagrangeTop::from_integrals`], [`LagrangeTop::above_upright`] |
//! | 7.3 | pure precession, slow and fast, and when there is any | [`pure_precession`], [`fast_spin`] |
//! | 7.4 | how far a released top dips, and its cycloid | [`dip`] |
//! | 7.5 | the spin with which a top sleeps, and how far a kick tilts it | [`sleeping_threshold`], [`tilt_after_kick`] |
//! | 7.6 | the spherical pendulum and its turning ellipse | [`pendulum_between`], [`pendulum_from_integrals`], [`apsides`] |

mod angles;
mod dip;
mod evaluation;
mod kinds;
mod motion;
mod pendulum;
mod precession;
mod preparation;
mod roots;
mod sleeping;
mod turning;

pub use crate::frame::EulerAngles;
pub use dip::{Cycloid, Dip, dip};
pub use evaluation::State;
pub use kinds::{Nutation, Roots};
pub use motion::LagrangeTop;
pub use pendulum::{Apsides, apsides, pendulum_between, pendulum_from_integrals};
pub use precession::{
    FastSpin, PurePrecession, fast_spin, least_axial_angular_momentum, pure_precession,
};
pub(crate) use preparation::Exact;
pub use sleeping::{sleeping_threshold, tilt_after_kick};
