//! Runs and readings.

use super::*;
use spinning_bodies::scene::effects::Effect;

/// Gravity of the models, m/s².
pub const G: f64 = 9.81;

/// A body on a table in this gravity, under one more effect.
pub fn on_a_table(body: ConvexBody, start: Start, g: f64, effect: impl Into<Effect>) -> TableTop {
    let heavy = TableTop::new(body, start).with(Gravity::new(g).unwrap());
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
    let quantities = rows.iter().map(|row| quantity(&row.1));
    quantities.fold(f64::MIN, f64::max)
}

/// By how much of its first value a quantity that should stay is off at the most.
pub fn drift(rows: &[(f64, State)], quantity: impl Fn(&State) -> f64) -> f64 {
    let first = quantity(&rows[0].1);
    most(rows, |state| (quantity(state) / first - 1.0).abs())
}

/// Friction that grows with the slip.
pub fn viscous(c: f64) -> Viscous {
    Viscous::new(c).unwrap()
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
