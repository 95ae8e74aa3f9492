//! Runs and readings.

use super::*;
use spinning_bodies::scene::effects::Effect;

/// Gravity of the models, m/s².
pub const G: f64 = 9.81;

/// A body on a table in this gravity, under one more effect.
pub fn on_a_table(
    body: ConvexBody,
    start: Start,
    gravity: f64,
    effect: impl Into<Effect>,
) -> TableTop {
    let heavy = TableTop::new(body, start).with(Gravity::new(gravity).unwrap());
    heavy.unwrap().with(effect).unwrap()
}

/// The rows of a run of `end` seconds with `samples` equal steps.
pub fn run(scene: &TableTop, end: f64, samples: u32, accuracy: f64) -> Vec<(f64, State)> {
    let step = end / f64::from(samples);
    let times: Vec<f64> = (0..=samples).map(|i| step * f64::from(i)).collect();
    let request = Request::at(times).unwrap().to_accuracy(accuracy).unwrap();
    scene.simulate(&request).unwrap().rows
}

/// The greatest of a quantity.
pub fn most(rows: &[(f64, State)], quantity: impl Fn(&State) -> f64) -> f64 {
    rows.iter()
        .map(|row| quantity(&row.1))
        .fold(f64::MIN, f64::max)
}

/// Tilt in degrees.
pub fn degrees(state: &State) -> f64 {
    state.tilt().to_degrees()
}

/// The last state.
pub fn last(rows: &[(f64, State)]) -> State {
    rows.last().unwrap().1
}

/// Coulomb's law over 1 mm/s.
pub fn regularised(mu: f64) -> Regularised {
    Regularised::new(mu, 1e-3).unwrap()
}
