//! A superball under a table: exact fractions bounce by bounce, and a day of bounces at once.
//!
//! `cargo run --release --example superball`

use num_rational::Ratio;
use spinning_bodies::scene::effects::Gravity;
use spinning_bodies::scene::{Request, Scene, Superball};
use spinning_bodies::superball::{InFlight, Motion, UnderTable};

fn main() -> spinning_bodies::Result<()> {
    // In units of the first speed; κ = 2/5 is a homogeneous ball.
    let start = Motion {
        velocity: Ratio::new(1, 1),
        rim_speed: Ratio::new(0, 1),
    };
    for (bounce, motion) in UnderTable::new(start, Ratio::new(2_i128, 5))
        .take(3)
        .enumerate()
    {
        println!(
            "after bounce {}: V = {}, RΩ = {}",
            bounce + 1,
            motion.velocity,
            motion.rim_speed
        );
    }

    // A ball of 0.05 kg under gravity, between a floor and a table top 0.6 m above it, thrown from a height of 0.3 m.
    let motion = Motion {
        velocity: 2.0,
        rim_speed: 0.0,
    };
    let thrown = InFlight {
        position: 0.0,
        height: 0.3,
        climb: -5.0,
        motion,
        bounces: 0,
    };
    let ball = Superball::new(0.05, 0.4, thrown)?
        .under(0.6)
        .with(Gravity::new(9.81)?)?;
    let day = ball.simulate(&Request::at([86_400.0])?)?;
    let state = &day.rows[0].1.ball;
    println!(
        "after a day: {} bounces, at x = {:.9} m",
        state.bounces, state.position
    );
    println!(
        "energy kept to {:.1e}",
        day.ledger.entries()[0].relative_drift()
    );
    Ok(())
}
