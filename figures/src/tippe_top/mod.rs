//! Bodies that stand on a table (tutorial 4.7): hoop with clay, tippe top, egg, the chiral tippe top, the rattleback.
//!
//! Every run is a scene of the library; accuracies are chosen so that no line moves by a tenth of a unit.

use core::f64::consts::{PI, TAU};

use spinning_bodies::Result;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::scene::contact::{State, TableTop};
use spinning_bodies::scene::effects::{Gravity, NoSlip, Regularised, Viscous};
use spinning_bodies::scene::{Request, Scene};
use spinning_bodies::tippe_top::{HoopWithClay, Start, TippeTop, bodies};

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
mod plot;
mod potential;
mod rattleback;
mod strobe;
mod tip_over;

pub use animated::turning_over;
pub use beads::beads;
pub use chiral::both_spins;
pub use contact_path::contact_path;
pub use diagram::energy_and_momentum;
pub use egg::{egg_film, how_far_eggs_rise};
pub use energy::height_and_energy;
pub use growth::growth_rates;
pub use hoop::hoop_with_clay;
pub use map::outcomes;
pub use potential::effective_potential;
pub use rattleback::reversals;
pub use strobe::strobed;
pub use tip_over::tip_over;

/// Gravity of the figures, m/s²; the tippe top's own is that of its source.
const G: f64 = 9.81;
const G_TIPPE: f64 = 9.82;
/// Spin of the tutorial's toy: 50 turns a second.
const TOY_SPIN: f64 = 100.0 * PI;
/// Spin of the chiral top: six times √(g/R).
const CHIRAL_SPIN: f64 = 132.9;

type Rows = Vec<(f64, State)>;

/// States at `samples` + 1 equal steps up to `end`.
fn run(scene: &TableTop, end: f64, samples: u32, accuracy: f64) -> Result<Rows> {
    let times: Vec<f64> = (0..=samples)
        .map(|k| end * f64::from(k) / f64::from(samples))
        .collect();
    let motion = scene.simulate(&Request::at(times)?.to_accuracy(accuracy)?)?;
    Ok(motion.rows)
}

/// The tutorial's toy in formulas.
fn toy(alpha: f64) -> Result<HoopWithClay> {
    HoopWithClay::new(0.02, 0.02, alpha, 0.4, 1.0 / 3.0, G)
}

/// The tutorial's toy in full, spun about the vertical, 0.1 rad off its rest.
fn toy_scene(alpha: f64, spin: f64) -> Result<TableTop> {
    let body = bodies::hoop_with_clay(0.02, 0.02, alpha)?;
    TableTop::new(body, Start::about_vertical(0.1, 0.0, spin)?)
        .with(Gravity::new(G)?)?
        .with(Regularised::new(1.0 / 3.0, 1e-3)?)
}

/// The tippe top of Rauch-Wojciechowski and Rutstam in closed form.
fn tippe() -> Result<TippeTop> {
    let unit = 0.02 * 0.02 * 0.02;
    TippeTop::new(0.02, 0.02, 0.3, unit * 131.0 / 350.0, unit * 0.4, G_TIPPE)
}

/// The same in full, spun about its own axis at a tilt of 0.1 rad.
fn tippe_scene(spin: f64) -> Result<TableTop> {
    let start = Start::about_third_axis(0.1, 0.0, spin)?;
    TableTop::new(bodies::tippe_top()?, start)
        .with(Gravity::new(G_TIPPE)?)?
        .with(Viscous::new(0.3)?)
}

/// The chiral top, released about the vertical at this tilt and azimuth (rad), μ = 0.3.
fn chiral_scene(spin: f64, tilt: f64, azimuth: f64) -> Result<TableTop> {
    let start = Start::about_vertical(tilt, azimuth, spin)?;
    TableTop::new(bodies::chiral_top()?, start)
        .with(Gravity::new(G)?)?
        .with(Regularised::new(0.3, 1e-3)?)
}

/// A boiled egg of 60 g, 6 cm long and 4 cm thick, lying but for 2°, spun at so many turns a second, μ = 0.1.
fn egg_scene(turns: f64) -> Result<TableTop> {
    let start = Start::about_vertical(88_f64.to_radians(), 0.0, turns * TAU)?;
    TableTop::new(bodies::egg(0.06, 0.03, 0.02)?, start)
        .with(Gravity::new(G)?)?
        .with(Regularised::new(0.1, 2e-3)?)
}

/// Kane and Levinson's rattleback, half a degree off about its long axis and about the one across.
fn stone_scene(spin: f64) -> Result<TableTop> {
    let half = 0.25_f64.to_radians().tan();
    let attitude = Attitude::from_quaternion(1.0, half, half, 0.0)?;
    let start = Start::spinning(attitude, BodyVector::new(0.0, 0.0, spin))?;
    TableTop::new(bodies::rattleback()?, start)
        .with(Gravity::new(G)?)?
        .with(NoSlip)
}
