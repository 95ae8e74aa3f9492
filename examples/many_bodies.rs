//! Ten thousand asteroids after a year, on all cores: each is prepared once and then evaluated in closed form.
//!
//! `cargo run --release --example many_bodies`

use rayon::prelude::*;
use spinning_bodies::euler_top::EulerTop;
use spinning_bodies::frame::{Attitude, BodyVector};

fn main() -> spinning_bodies::Result<()> {
    // Moments and spins that cover their ranges evenly, by the golden ratio and its square.
    let share = |k: u32, step: f64| (f64::from(k) * step).fract();
    let bodies: Vec<EulerTop> = (0..10_000_u32)
        .into_par_iter()
        .map(|k| {
            let moments = [1.0, 1.0 + share(k, 0.618_034), 1.9];
            let spin = BodyVector::new(share(k, 0.754_878), share(k, 0.569_840), 1.0);
            EulerTop::from_omega(moments, spin, Attitude::identity())
        })
        .collect::<Result<_, _>>()?;

    let year = 365.25 * 86_400.0;
    let tilts: Vec<f64> = bodies
        .par_iter()
        .map(|body| {
            let l = body.at(year)?.angular_momentum;
            Ok((l.z() / l.norm()).acos())
        })
        .collect::<spinning_bodies::Result<_>>()?;
    let mean = tilts.iter().sum::<f64>() / tilts.len() as f64;
    println!(
        "{} bodies after a year: L is {mean:.6} rad from axis 3, on the average",
        tilts.len()
    );
    Ok(())
}
