//! Where the long axis of the asteroid Toutatis points, from the morning radar saw it to a million years later.
//!
//! `cargo run --release --example asteroid`

use spinning_bodies::euler_top::toutatis;
use spinning_bodies::frame::BodyVector;

/// A day, s.
const DAY: f64 = 86_400.0;

fn main() -> spinning_bodies::Result<()> {
    let asteroid = toutatis::top()?;
    let days = asteroid.period() / DAY;
    println!("It turns about its long axis in {days:.3} days.");

    // The closed form does not go through the days before: the last line costs as much as the first.
    println!("{:>12}  long axis in space", "day");
    for day in [0.0, 1.0, 7.35, 365.25, 3.6525e8] {
        let state = asteroid.at(day * DAY)?;
        let long = state.attitude.to_space(BodyVector::new(0.0, 0.0, 1.0));
        println!(
            "{day:>12}  {:+.9} {:+.9} {:+.9}",
            long.x(),
            long.y(),
            long.z()
        );
    }
    Ok(())
}
