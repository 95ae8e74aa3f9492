//! Euler's top (tutorial 6): the rolling ellipsoid, the polhodes, the racket, and the wandering pole.

mod animated;
mod asteroid;
mod film;
mod flip_time;
mod poinsot;
mod polhodes;
mod racket;
mod solution;
mod wobble;

pub use animated::animated;
pub use asteroid::two_axes_in_the_sky;
pub use film::film;
pub use flip_time::flip_time;
pub use poinsot::rolling_ellipsoid;
pub use polhodes::polhodes;
pub use solution::solution;
pub use wobble::{polar_circles, precession_cones};
