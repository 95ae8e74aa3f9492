//! A heavy top inside a simulation of your own: one step at a time, each as cheap as a step of a whole run.
//!
//! `cargo run --release --example step_by_step`

use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::integrators::geometric::{HeavySplitting, Integrator, Order, Phase, Weight};

fn main() -> spinning_bodies::Result<()> {
    // kg m² about the pivot, and MgC in N m.
    let (moments, lever) = ([0.02, 0.015, 0.01], [0.0, 0.0, 0.8]);
    let method = HeavySplitting::new(moments, Weight::new(lever)?, Order::Four)?;
    let tilted = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), 0.3)?;
    let start = Phase::new(BodyVector::new(0.0, 0.0, 1.2), &tilted);
    let energy = |phase: &Phase| {
        let turning: f64 = (0..3).map(|k| phase.l[k] * phase.l[k] / moments[k]).sum();
        0.5 * turning + lever[2] * phase.up()[2]
    };

    let mut stepper = method.start(&start, 1e-3)?;
    for second in 1..=5 {
        for _ in 0..1000 {
            // Here a simulation would do its own work.
            stepper.step()?;
        }
        let now = stepper.phase()?;
        let drift = energy(&now) / energy(&start) - 1.0;
        println!(
            "{second} s: height of the axis {:.9}, energy off by {drift:+.1e}",
            now.up()[2]
        );
    }
    Ok(())
}
