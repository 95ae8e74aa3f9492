//! Lagrange's top (tutorial 7): the nose on the sphere, pure precession, the released top, the sleeping top.
//!
//! Units of all figures: I₁ = 1 and Mgl = 1; I₃ = 1 as well, unless said, so that L₃ is Ω₃. The motion of the axis depends on I₃ through L₃ only.

use crate::prelude::*;

mod animated;
mod cycloid;
mod launch;
mod nutations;
mod rates;
mod sleeping;
mod waking;
mod wooden;

/// The figures of the chapter, in its order.
pub const FIGURES: &[Entry] = &[
    of("wooden-top", wooden::ASKED, wooden::wooden_top),
    of("wooden-top-let-go", wooden::WOODEN, wooden::let_go),
    of("nutations", nutations::NUTATIONS, nutations::nutations),
    of("top-animated", &[], animated::top_animated),
    of("sleeping-threshold", sleeping::CHOSEN, sleeping::threshold),
    of("sleep-ends", waking::WAKING, waking::waking),
    of("cycloid", cycloid::CYCLOIDS, cycloid::cycloids),
    of("precession-rates", rates::RATES, rates::precession_rates),
];
