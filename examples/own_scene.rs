//! A scene of your own: a body, its start, its effects, and the accuracy of the result.
//!
//! `cargo run --release --example own_scene`

use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::scene::top::{AirDrag, Body, Gravity, Start, Top};
use spinning_bodies::scene::{Request, Scene};

fn main() -> spinning_bodies::Result<()> {
    // kg m² about the pivot, kg, m, rad/s; tilted by 0.3 rad.
    let body =
        Body::new([0.02, 0.02, 0.01])?.with_center_of_mass(1.0, BodyVector::new(0.0, 0.0, 0.08))?;
    let tilted = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), 0.3)?;
    let start = Start::with_omega(BodyVector::new(0.0, 0.0, 120.0), tilted);

    // Effects are values: an effect that is not added is not computed.
    let heavy = Top::new(body, start)?.with(Gravity::new(9.80665)?)?;
    let rubbed = heavy.with(AirDrag::new(1e-5)?)?;

    let request = Request::at([0.0, 1.0, 10.0])?.to_accuracy(1e-9)?;
    for (name, top) in [("in a vacuum", &heavy), ("in air", &rubbed)] {
        let motion = top.simulate(&request)?;
        println!("{name}: {}", motion.plan);
        println!(
            "  {} evaluations, at most {:.1e} off",
            motion.cost.evaluations, motion.error_estimate
        );
        for (t, state) in &motion.rows {
            let axis = state.attitude.to_space(BodyVector::new(0.0, 0.0, 1.0));
            println!(
                "  t = {t:>4} s  tilt {:.9} rad  spin {:.6} rad/s",
                axis.z().acos(),
                state.omega.z()
            );
        }
    }
    Ok(())
}
