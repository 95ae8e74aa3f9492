//! Bodies that stand on a table (tutorial 4.7): hoop with clay, tippe top, egg, the chiral tippe top, the rattleback.

use crate::prelude::*;

mod animated;
mod ball;
mod beads;
mod chiral;
mod contact_path;
mod diagram;
mod egg;
mod energy;
mod growth;
mod hoop;
mod map;
mod potential;
mod rattleback;
mod stone;
mod strobe;
mod tip_over;
pub mod toys;
mod twins;

use chiral::BOTH_SPINS;
use potential::POTENTIAL;

/// The figures of the chapter on the tippe top, in its order.
pub const TIPPE_TOP: &[Entry] = &[
    of("tippe-top-animated", &[], animated::turning_over),
    of("egg-film", &egg::FILM, egg::egg_film),
    of("hoop-with-clay", hoop::HOOP, hoop::hoop_with_clay),
    of("tip-over", tip_over::TIP_OVER, tip_over::tip_over),
    of("contact-path", &contact_path::PATH, contact_path::path),
    of("tippe-energy", &energy::ENERGY, energy::height_and_energy),
    of("tippe-potential", POTENTIAL, potential::effective),
    of("tippe-diagram", diagram::DIAGRAM, diagram::energies),
    of("egg-angle", &[], egg::how_far_eggs_rise),
];

/// Those of the chapter on the chiral top, in its order.
pub const CHIRAL_TOP: &[Entry] = &[
    of("chiral-top", &BOTH_SPINS, chiral::both_spins),
    of("chiral-twins", &BOTH_SPINS, twins::twins),
    of("chiral-strobe", strobe::STROBED, strobe::strobed),
    of("chiral-map", &[], map::outcomes),
    of("chiral-growth", &growth::GROWTH, growth::growth_rates),
    of("chiral-beads", &[], beads::beads),
];

/// Those of the chapter on the rattleback, in its order.
pub const RATTLEBACK: &[Entry] = &[
    of("rattleback", &rattleback::REVERSALS, rattleback::reversals),
    of("rattleback-stone", &stone::STONE, stone::two_pairs_of_axes),
];
