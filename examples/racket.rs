//! A tennis racket thrown about its middle axis: the time to its flip, for smaller and smaller errors of the throw.
//!
//! `cargo run --release --example racket`

use spinning_bodies::euler_top::EulerTop;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::inertia::shapes;

fn main() -> spinning_bodies::Result<()> {
    // The head is a hoop, the handle a rod: mass in kg, lengths in m.
    let racket = shapes::racket(0.34, 0.13, 0.4)?;
    let moments = racket.inertia().principal_axes().moments;
    println!("principal moments {moments:?} kg m²");

    println!("{:>9}  seconds from flip to flip", "rad/s off");
    for exponent in [-1, -3, -10, -100, -300] {
        let off = 10_f64.powi(exponent);
        let thrown = BodyVector::new(off, 10.0, 0.0);
        let top = EulerTop::from_omega(moments, thrown, Attitude::identity())?;
        let flip = 0.5 * top.period();
        let flipped = top.at(flip)?;
        assert!(
            flipped.omega.y() < -9.0,
            "after half a period it turns the other way"
        );
        println!("{off:>9.0e}  {flip:.12}");
    }
    Ok(())
}
