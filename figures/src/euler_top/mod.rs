//! Euler's top (tutorial 6): the rolling ellipsoid, the polhodes, the racket, and the wandering pole.

use spinning_bodies::euler_top::EulerTop;
use spinning_bodies::frame::{Attitude, BodyVector};

use crate::prelude::*;

mod animated;
mod asteroid;
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

parameters! {
    SMALLEST: "smallest", "I_1", "kg m²", "smallest principal moment", [0.2, 1.4], 1.0;
    MIDDLE: "middle", "I_2", "kg m²", "middle principal moment", [1.5, 2.5], 2.0;
    LARGEST: "largest", "I_3", "kg m²", "largest principal moment", [2.6, 5.0], 3.0;
}

fn moments(values: &Values) -> [f64; 3] {
    values.each([SMALLEST, MIDDLE, LARGEST])
}

/// The top with these moments, whether a body has them or not.
fn top_of(moments: [f64; 3], omega: BodyVector, attitude: Attitude) -> Result<EulerTop> {
    EulerTop::beyond_bodies_from_omega(moments, omega, attitude)
}

/// The addition to a caption if no body has these moments.
fn remark([i1, i2, i3]: [f64; 3]) -> &'static str {
    // Sliders stop at decimals, whose sums are rounded.
    match i1 + i2 < i3 * (1.0 - 1e-12) {
        true => " No body has such moments, for $I_1 + I_2 < I_3$; Euler's equations do not mind.",
        false => "",
    }
}

/// Three numbers as they are printed in a caption.
fn triple(numbers: [f64; 3]) -> String {
    format!("({})", numbers.map(brief).join(", "))
}
