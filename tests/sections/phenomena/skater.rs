//! The skater.

use super::*;
use spinning_bodies::phenomena::Skater;
use spinning_bodies::scene::effects::Draw;

// claim: C1.1-10
#[test]
fn s1_1_the_skater_and_the_work_of_the_arms() {
    let body = Skater::new(1.0, 0.25).unwrap();
    let scene = shape::Skater::new(body, 1.0, 6.0).unwrap().with(Draw {
        to: 0.4,
        begin: 0.5,
        duration: 1.0,
        pace: Pace::Late,
    });
    let scene = scene.unwrap();
    let request = asking([0.9, 1.2, 2.0], 1e-12);
    let exact = scene.simulate(&request).unwrap();
    let end = exact.rows[2].1;
    close!(end.spin, 25.0 / 3.0, 0.0..=3e-16);
    close!(end.work, 10.5, 0.0..=5e-16);
    // Coriolis' force and the pull against the centrifugal force, integrated.
    let followed = scene.simulate(&by_general(request, Method::Dop853));
    let followed = followed.unwrap();
    for ((_, a), (_, b)) in exact.rows.iter().zip(&followed.rows) {
        // Observed: 2e-14.
        close!(a.spin, b.spin, 0.0..=2e-14);
        close!(a.work, b.work, 3e-15..=2e-13);
        close!(b.work, b.energy - 27.0, 4e-15..=1e-12);
    }
    // The arms alone: ∫ 2mΩ²r dr.
    let l = 9.0;
    let pull = |r: f64| -2.0 * 0.25 * body.spin(l, r).powi(2) * r;
    let work = integral(pull, 1.0, 0.4);
    close!(work, 10.5, 0.0..=1e-14);

    // A grown skater: 3.5 to 1 kg m², from two turns a second.
    let body = Skater::new(0.8, 2.5).unwrap();
    let [out, close] = [3.5, 1.0].map(|moment| body.reach(moment).unwrap());
    let l = 3.5 * 2.0 * TAU;
    close!(body.spin(l, close) / TAU, 7.0, 0.0..=5e-16);
    let before = body.energy(body.spin(l, out), out, 0.0);
    let after = body.energy(body.spin(l, close), close, 0.0);
    near!(before, 276.3, 1e-2..=0.05, "{before} {after}");
    near!(after, 967.2, 7e-3..=0.05, "{before} {after}");
    let off = relative(after - before, body.work(l, out, close).unwrap());
    observed!(off, 0.0..=1e-15);
    close!(after / before, 3.5, 0.0..=1e-15);
}
