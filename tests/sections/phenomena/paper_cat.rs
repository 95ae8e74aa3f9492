//! The cat of paper, which the air turns.

use super::*;
use spinning_bodies::phenomena::PaperCat;
use spinning_bodies::scene::effects::Air;

// claim: C1.1-9, C1.1-13
#[test]
fn s1_1_the_paper_cat_needs_air() -> Result<()> {
    let cat = PaperCat::POSTCARD;
    let g = Gravity::new(9.81)?;
    let air = Air::new(1.2)?;
    near!(cat.terminal_speed(1.2, 9.81), 2.022, 8e-5..=5e-4);
    // The torque of the air points to upright from every tilt, and is zero at the two ends.
    for k in 1..180 {
        let tilt = f64::from(k).to_radians();
        assert!(cat.righting(1.2, 2.0, tilt, 0.0) < 0.0);
        assert!(cat.righting(1.2, 2.0, -tilt, 0.0) > 0.0);
    }
    assert_eq!(cat.righting(1.2, 2.0, 0.0, 0.0), 0.0);
    // Heights of fall, m: Runge and Kutta's method in steps of 0.1 ms, by another program.
    let falls = [0.609_746, 0.825_466, 0.965_072, 1.291_469];
    for (degrees, fall) in [150.0, 170.0, 175.0, 179.0].into_iter().zip(falls) {
        let tilt = f64::to_radians(degrees);
        let scene = shape::PaperCat::new(cat, tilt)?.with(g)?;
        let airy = scene.with(air)?;
        let righted = airy.rights_itself(10.0)?.unwrap();
        near!(righted.fall, fall, 1e-7..=1e-6, "{degrees}");
        // In a vacuum it lands as it was let go.
        assert_eq!(scene.rights_itself(10.0)?, None);
        let motion = scene.simulate(&Request::at([0.5])?)?;
        assert_eq!(motion.rows[0].1.tilt, tilt);
        close!(motion.rows[0].1.fall, 0.5 * 9.81 * 0.25, 0.0..=1e-15);
    }
    // Upright is the only rest that lasts: it gets there and stays.
    let scene = shape::PaperCat::new(cat, 3.0)?.with(air)?.with(g)?;
    let motion = scene.simulate(&Request::at([30.0])?)?;
    observed!(motion.rows[0].1.tilt.abs(), 0.0..=2e-14);
    // Speed and fall have a closed form, the tilt has no say in them.
    let speed = cat.terminal_speed(1.2, 9.81);
    let x: f64 = 9.81 * 30.0 / speed;
    let [velocity, fall] = [speed * x.tanh(), speed * speed / 9.81 * x.cosh().ln()];
    close!(motion.rows[0].1.velocity, velocity, 0.0..=1e-10);
    close!(motion.rows[0].1.fall, fall, 0.0..=3e-15);
    Ok(())
}

// claim: C1.1-9
#[test]
fn s1_1_upside_down_is_an_equilibrium_and_costs_a_logarithm() {
    let cat = PaperCat::POSTCARD;
    let fall = |error: f64| {
        let scene = shape::PaperCat::new(cat, PI - error).unwrap();
        let scene = scene.with(Air::new(1.2).unwrap()).unwrap();
        let scene = scene.with(Gravity::new(9.81).unwrap()).unwrap();
        scene.rights_itself(30.0).unwrap().unwrap().fall
    };
    let decade = cat.fall_per_decade(1.2, 9.81);
    for exponent in 3..7 {
        let grown = fall(10f64.powi(-exponent - 1)) - fall(10f64.powi(-exponent));
        // The errors are small enough to be linear and the speed is terminal: the closed rate. Observed: 2e-5, 2e-7, 2e-9 and less, the
        // last by the rounding of π − error.
        close!(grown, decade, 5e-6..=1e-4);
    }
}
