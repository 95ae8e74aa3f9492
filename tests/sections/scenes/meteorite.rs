//! The impact, absent and vanishing.

use super::*;
use spinning_bodies::frame::BodyVector as V;
use spinning_bodies::impacts::{Impact, Meteorite, Planet, strike};
use spinning_bodies::scene::StruckPlanet;

fn planet() -> Planet {
    let brick = shapes::cuboid(5.0, [1.0, 2.0, 3.0]).unwrap().inertia();
    Planet::new(5.0, brick, V::new(1.0, -2.0, 0.5), V::new(0.3, 0.2, -1.0)).unwrap()
}

fn impact(mass: f64) -> Impact {
    Impact {
        meteorite: Meteorite::new(mass, V::new(3.0, 8.0, -20.0)).unwrap(),
        at: V::new(0.4, -1.0, 1.2),
    }
}

fn times() -> Request {
    Request::at([-2.0, -0.5, 0.0, 0.3, 5.0]).unwrap()
}

#[test]
fn free_before_and_after() -> Result<()> {
    let alone = StruckPlanet::new(planet()).simulate(&times())?;
    let struck = |mass| StruckPlanet::new(planet()).with(impact(mass)).unwrap();
    let hit = struck(0.7).simulate(&times())?;
    assert!(same(&alone, &hit) > 0.1);
    assert!(balance(&alone) < 1e-13, "{:e}", balance(&alone));
    assert!(balance(&hit) < 1e-13, "{:e}", balance(&hit));
    // Just after the blow it moves as the six equations say.
    let exact = strike(&planet(), &impact(0.7).meteorite, impact(0.7).at)?;
    let after = &hit.rows[2].1;
    assert!((after.omega - exact.omega_after).norm() < 1e-14);
    assert!(after.center.norm() < 1e-15);
    // A pebble changes as little as it weighs.
    let pebble = struck(1e-12).simulate(&times())?;
    let rows = alone.rows.iter().zip(&pebble.rows);
    let little = greatest(rows.map(|(a, b)| (a.1.omega - b.1.omega).norm()));
    assert!(little > 0.0 && little < 1e-9, "{little:e}");
    // Without spin hardly any angular momentum is there to compare rounding errors with, or none.
    let still = Planet::spherical(10.0, 4.0, V::new(0.3, 0.1, 0.7), V::zero())?;
    let (at, still) = (V::zero(), StruckPlanet::new(still));
    let [pebble, central] = [impact(1e-12), Impact { at, ..impact(0.7) }];
    for scene in [still, still.with(pebble)?, still.with(central)?] {
        assert!(balance(&scene.simulate(&times())?) < 1e-15);
    }
    // Nothing turns a round planet about the line to the stone: with it, it turns evenly about a line across, for ever.
    let small = Planet::spherical(5.0, 0.01, V::zero(), V::zero())?;
    let at = V::new(2.3, 1.7, 3.1);
    let far = StruckPlanet::new(small).with(Impact { at, ..impact(0.7) })?;
    let motion = far.simulate(&Request::at([0.0, 300.0])?.to_accuracy(1e-8)?)?;
    let [before, after] = [0, 1].map(|k| motion.rows[k].1.omega);
    let off = (after - before).norm() / before.norm();
    near!(off, 0.0, motion.error_estimate);
    Ok(())
}

/// Nearly equal moments make the even turn sensitive to their rounding: with the axes exchanged, and so rounded otherwise, it wanders no more than told.
#[test]
fn a_nearly_round_planet_tells_how_it_wanders() -> Result<()> {
    let [one, other] = [0, 1].map(|places| {
        let along = |of: [f64; 3]| V::from([0, 1, 2].map(|k| of[(k + places) % 3]));
        let [a, b, c] = along([0.4, 0.4 + 6e-12, 0.4 - 4e-12]).components().into();
        let (at, omega) = (along([-0.8, -0.3, -0.3]), along([0.0, 0.3, -0.3]));
        let inertia = InertiaMatrix::diagonal(a, b, c)?;
        let planet = StruckPlanet::new(Planet::new(1.0, inertia, V::zero(), omega)?);
        let meteorite = Meteorite::new(1.0, along([-0.172, 0.243, 0.243]))?;
        let struck = planet.with(Impact { meteorite, at })?;
        struck.simulate(&asking([3e3], 1e-6))
    });
    let (one, other) = (one?, other?);
    let off = one.rows[0].1.omega.y() - other.rows[0].1.omega.x();
    observed!(off.abs() / one.error_estimate, 1e-5..=5e-4);
    Ok(())
}

/// L = I·Ω about the centre of mass: of the brick before the blow; after it the meteorite, too, goes round the common centre, as the reduced mass at its place.
#[test]
fn angular_momentum_is_inertia_times_omega() {
    let struck = StruckPlanet::new(planet()).with(impact(0.7)).unwrap();
    let motion = struck.simulate(&times()).unwrap();
    let (at, reduced) = (impact(0.7).at, 5.0 * 0.7 / 5.7);
    let mut off = 0.0_f64;
    for (t, state) in &motion.rows {
        let mut l = planet().inertia.angular_momentum(state.omega);
        if *t >= 0.0 {
            l += reduced * at.cross(&state.omega.cross(&at));
        }
        let expected = state.attitude.to_space(l);
        off = off.max((state.angular_momentum - expected).norm() / expected.norm());
    }
    observed!(off, 1e-16..=3e-15);
    let [before, after] = [1, 2].map(|row| motion.rows[row].1.angular_momentum);
    assert!((after - before).norm() > before.norm(), "the blow is felt");
}

#[test]
fn only_the_closed_form_runs_it() {
    let dop853 = times().by(Choice::Use(Solver::General(Method::Dop853)));
    refused!(StruckPlanet::new(planet()).simulate(&dop853), Solver);
}
