//! Euler's top (tutorial 6): the rolling ellipsoid, the polhodes, the racket, and the wandering pole.

use crate::prelude::*;

mod animated;
mod asteroid;
mod body;
mod film;
mod flip_time;
mod poinsot;
mod polhodes;
mod racket;
mod solution;
mod wobble;

/// The figures of the chapter, in its order.
pub const FIGURES: &[Entry] = &[
    of("poinsot-ellipsoid", poinsot::POINSOT, poinsot::rolling),
    of("polhodes", polhodes::POLHODES, polhodes::polhodes),
    of("racket-flip", film::FILM, film::film),
    of("racket-flip-animated", &[], animated::animated),
    of("flip-time", flip_time::FLIP_TIME, flip_time::flip_time),
    of("polar-circles", wobble::CIRCLES, wobble::polar_circles),
    of("precession-cones", wobble::CONES, wobble::precession_cones),
    of("euler-solution", solution::SOLUTION, solution::solution),
    of("toutatis", asteroid::TOUTATIS, asteroid::two_axes),
];
