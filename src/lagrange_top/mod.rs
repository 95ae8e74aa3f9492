//! Lagrange's top (tutorial 7): a symmetric body with a fixed point on its axis, under gravity, in closed form.
//!
//! The height h = cos θ of the axis moves like sn² between two roots of a cubic; the attitude is a pair of theta functions,
//! one for each Cayley–Klein parameter, regular where the axis passes the vertical. [`LagrangeTop`] decides
//! once what kind of motion it is ([`Nutation`]).
//!
//! | paragraph | what | where |
//! |---|---|---|
//! | 7.1, 7.2 | tilt, azimuth and attitude at any time; period and precession; the kind of nutation | [`LagrangeTop`] |
//! | 7.2, 7.5 | a top from L₃, L_vert and E; the separatrix exactly | [`LagrangeTop::from_integrals`], [`LagrangeTop::above_upright`] |
//! | 7.3 | pure precession, slow and fast, and when it exists | [`pure_precession`], [`fast_spin`] |
//! | 7.4 | how far a released top dips, and its cycloid | [`dip`] |
//! | 7.5 | the spin with which a top sleeps, and how far a kick tilts it | [`sleeping_threshold`], [`tilt_after_kick`] |
//! | 7.6 | the spherical pendulum and its turning ellipse | [`pendulum_between`], [`pendulum_from_integrals`], [`apsides`] |

mod evaluation;
mod motion;
mod preparation;
mod roots;
mod special;

pub use crate::frame::EulerAngles;
pub use evaluation::State;
pub use motion::LagrangeTop;
pub(crate) use preparation::Exact;
pub(crate) use roots::greatest_root;
pub use roots::{Nutation, Roots};
pub use special::{
    Apsides, Cycloid, Dip, FastSpin, PurePrecession, apsides, dip, fast_spin,
    least_axial_angular_momentum, pendulum_between, pendulum_from_integrals, pure_precession,
    sleeping_threshold, tilt_after_kick,
};
