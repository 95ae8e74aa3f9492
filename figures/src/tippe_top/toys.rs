//! The bodies of the chapters and their runs.
//!
//! Every motion is a scene of the library, followed once: two runs that agree would cost three times as much, and a hand waits for the picture.

use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::integrators::Effort;
use spinning_bodies::scene::contact::{State, TableTop};
use spinning_bodies::scene::effects::{Gravity, NoSlip, Regularised, Viscous};
use spinning_bodies::scene::{Request, Scene};
use spinning_bodies::tippe_top::{ConvexBody, HoopWithClay, Start, TippeTop, bodies};

use crate::prelude::*;

/// Gravity of the figures, m/s²; the tippe top's own is that of its source.
pub const G: f64 = 9.81;
pub const G_TIPPE: f64 = 9.82;
/// Spin of the chiral top: six times √(g/R).
pub const CHIRAL_SPIN: f64 = 132.9;

pub type Rows = Vec<(f64, State)>;

/// The tolerance of a step. Within the ranges of the sliders it leaves no curve off by a thousandth of its axis.
const TOLERANCE: f64 = 1e-8;

/// States at `samples` + 1 equal steps up to `end`.
pub fn run(scene: &TableTop, end: f64, samples: u32) -> Result<Rows> {
    run_to(TOLERANCE, scene, end, samples)
}

fn run_to(tolerance: f64, scene: &TableTop, end: f64, samples: u32) -> Result<Rows> {
    let times: Vec<f64> = spaced([0.0, end], samples).collect();
    let request = Request::at(times)?.in_one_run(Effort::Tolerance(tolerance));
    Ok(scene.simulate(&request)?.rows)
}

/// The tilt of a top, °.
pub fn degrees(state: &State) -> f64 {
    state.tilt().to_degrees()
}

/// The times of a run and its tilts, °.
pub fn tilts(rows: &[(f64, State)]) -> impl Iterator<Item = Point> + Clone {
    rows.iter().map(|(time, state)| [*time, degrees(state)])
}

/// The greatest of them, °.
pub fn greatest_tilt(rows: &[(f64, State)]) -> f64 {
    tilts(rows).map(|[_, tilt]| tilt).fold(0.0, f64::max)
}

parameters! {
    pub ALPHA: "alpha", r"\alpha", "", "offset of the centre of mass over the radius", [0.05, 0.7], 0.3;
    pub GAMMA: "gamma", r"\gamma", "", "moment of inertia across the axis over that about it", [0.6, 1.5], 131.0 / 140.0;
    pub TURNS: "turns", "n", "turns/s", "spin at the start", [10.0, 100.0], 50.0;
    pub SPIN: "spin", r"\Omega", "rad/s", "spin at the start", [20.0, 200.0], 155.0;
    pub FRICTION: "friction", r"\mu", "", "coefficient of friction", [0.1, 1.0], 1.0 / 3.0;
    pub VISCOUS: "friction", "c", "s/m", "coefficient of viscous friction", [0.1, 1.0], 0.3;
}

/// Ticks of a tilt.
pub const TILTS: [f64; 5] = [0.0, 45.0, 90.0, 135.0, 180.0];

/// The axes of a tilt (°) against time (s).
pub fn tilt_against_time(pen: &mut Pen, frame: &Frame) {
    let names = ["time, s", "tilt"];
    frame.draw(pen, &frame.x.ticks(70.0), &marks(&TILTS, "°"), names);
}

/// The tutorial's toy in formulas, with this coefficient of friction.
pub fn toy(alpha: f64, mu: f64) -> Result<HoopWithClay> {
    HoopWithClay::new(0.02, 0.02, alpha, 0.4, mu, G)
}

/// The tutorial's toy by the full equations, spun about the vertical, 0.1 rad from its position of rest.
pub fn toy_scene(alpha: f64, spin: f64, mu: f64) -> Result<TableTop> {
    let body = bodies::hoop_with_clay(0.02, 0.02, alpha)?;
    body_scene(body, spin, 0.1, 0.0, mu)
}

/// The tippe top of Rauch-Wojciechowski and Rutstam, or one of another α and γ, in closed form.
pub fn tippe(alpha: f64, gamma: f64) -> Result<TippeTop> {
    let unit = 0.02 * 0.02 * 0.02 * 0.4;
    TippeTop::new(0.02, 0.02, alpha, unit * gamma, unit, G_TIPPE)
}

/// The same by the full equations, spun about its own axis at a tilt of 0.1 rad, with this viscous friction (s/m).
pub fn tippe_scene(top: &TippeTop, spin: f64, friction: f64) -> Result<TableTop> {
    let start = Start::about_third_axis(0.1, 0.0, spin)?;
    TableTop::new(top.body()?, start)
        .with(Gravity::new(G_TIPPE)?)?
        .with(Viscous::new(friction)?)
}

/// The chiral top, released about the vertical at this tilt and azimuth (rad).
pub fn chiral_scene(spin: f64, tilt: f64, azimuth: f64, mu: f64) -> Result<TableTop> {
    body_scene(bodies::chiral_top()?, spin, tilt, azimuth, mu)
}

/// The same with another body.
pub fn body_scene(
    body: ConvexBody,
    spin: f64,
    tilt: f64,
    azimuth: f64,
    mu: f64,
) -> Result<TableTop> {
    let start = Start::about_vertical(tilt, azimuth, spin)?;
    TableTop::new(body, start)
        .with(Gravity::new(G)?)?
        .with(Regularised::new(mu, 1e-3)?)
}

/// A boiled egg of 60 g, 6 cm long and 4 cm thick, 2° from lying flat, spun at this many turns per second.
pub fn egg_scene(turns: f64, mu: f64) -> Result<TableTop> {
    let start = Start::about_vertical(88_f64.to_radians(), 0.0, turns * TAU)?;
    TableTop::new(bodies::egg(0.06, 0.03, 0.02)?, start)
        .with(Gravity::new(G)?)?
        .with(Regularised::new(mu, 2e-3)?)
}

/// Kane and Levinson's rattleback, inclined by these angles (rad) about its long axis and about the axis across it.
pub fn stone_scene(spin: f64, tilt: f64) -> Result<TableTop> {
    let half = (0.5 * tilt).tan();
    let attitude = Attitude::from_quaternion(1.0, half, half, 0.0)?;
    let start = Start::spinning(attitude, BodyVector::new(0.0, 0.0, spin))?;
    TableTop::new(bodies::rattleback()?, start)
        .with(Gravity::new(G)?)?
        .with(NoSlip)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where the ranges of the sliders ask most of it, and what the axis shows.
    #[test]
    fn no_curve_is_off_by_a_thousandth_of_its_axis() {
        let spin: fn(&State) -> f64 = State::spin;
        for (scene, end, seen, axis) in [
            (stone_scene(-5.5, 1_f64.to_radians()), 14.0, spin, 14.3),
            (chiral_scene(-148.8, 0.477, 0.0, 0.25), 3.0, degrees, 180.0),
            (chiral_scene(-200.0, 0.52, 0.0, 0.6), 3.0, degrees, 180.0),
            (toy_scene(0.25, 60.0 * TAU, 1.0), 1.2, degrees, 180.0),
            (toy_scene(0.4, 400.0, 1.0), 0.84, degrees, 180.0),
            (egg_scene(24.2, 0.066), 3.8, degrees, 90.0),
        ] {
            let scene = scene.expect("a scene");
            let [one, true_one] = [TOLERANCE, 1e-12].map(|to| run_to(to, &scene, end, 600));
            let pairs = one
                .expect("a run")
                .into_iter()
                .zip(true_one.expect("a run"));
            let off = pairs.map(|((_, a), (_, b))| (seen(&a) - seen(&b)).abs() / axis);
            let off = off.fold(0.0, f64::max);
            assert!((1e-8..1e-3).contains(&off), "{off} of {axis}");
        }
    }
}
