//! A planet that flies and turns freely, and is struck at time 0.

use super::super::extrapolation::pieced;
use super::super::number::{Matrix, Vector, inverse, rotation};
use super::super::random::Random;
use super::{Scene, Sort, told};
use support::double_double::Dd;
use support::turned;

/// m(r² − r r).
fn particle(mass: Dd, r: Vector) -> Matrix {
    (Matrix::from_diagonal_element(r.dot(&r)) - r * r.transpose()) * mass
}

/// Attitude and L along the body's axes after a time of free turning.
fn turned_freely(inertia: Matrix, omega: Vector, times: &[f64], rate: f64) -> Vec<[Dd; 7]> {
    let l = inertia * omega;
    let size = l.dot(&l).sqrt().value();
    let zero = Dd::ZERO;
    let start = [Dd::from(1.0), zero, zero, zero, l.x, l.y, l.z];
    let inverse = inverse(&inertia);
    let turning = |_: usize, _: Dd, &[w, x, y, z, a, b, c]: &[Dd; 7]| {
        let l = Vector::new(a, b, c);
        let omega = inverse * l;
        let [w, x, y, z] = turned([w, x, y, z], omega.into());
        let [a, b, c] = l.cross(&omega).into();
        [w, x, y, z, a, b, c]
    };
    let scales = [1.0, 1.0, 1.0, 1.0, size, size, size];
    pieced(turning, start, &scales, &[], times, 10.0 / rate)
}

pub fn meteorite(r: &mut Random) -> Scene {
    let mass = r.scaled(0.1, 10.0);
    let even = r.percent(30);
    let moments: [f64; 3] = loop {
        let m: [f64; 3] = core::array::from_fn(|_| mass * r.within(0.2, 0.6));
        if even {
            break [m[0]; 3].map(|m| m * (1.0 + r.nil_or(85, |r| r.scaled(1e-12, 1e-3))));
        }
        if (0..3).all(|k| m[k] < 0.95 * (m[(k + 1) % 3] + m[(k + 2) % 3])) {
            break m;
        }
    };
    let velocity = r.direction().map(|x| x * 0.5);
    let omega = r.direction();
    let struck = r.percent(85);
    let [small, speed] = [mass * r.scaled(1e-3, 0.3), r.scaled(0.3, 30.0)];
    let flight = r.direction().map(|x| x * speed);
    let at = {
        // It comes from outside.
        let at = r.direction();
        let inward: f64 = (0..3).map(|k| at[k] * flight[k]).sum();
        if inward > 0.0 { at.map(|x| -x) } else { at }
    };
    let mut text = format!(
        "kind = \"meteorite\"\n[body]\nmass = {mass:?}\nmoments = {moments:?}\n[initial]\nvelocity = {velocity:?}\nomega = {omega:?}\n[effects]\n"
    );
    if struck {
        text +=
            &format!("impact_mass = {small:?}\nimpact_velocity = {flight:?}\nimpact_at = {at:?}\n");
    }
    let planet = Matrix::from_diagonal(&moments.map(Dd::from).into());
    let (mass, small) = (Dd::from(mass), Dd::from(if struck { small } else { 0.0 }));
    let [flight, at] = [flight, at].map(|v| Vector::from(v.map(Dd::from)));
    let kick = if struck { speed * 0.3 } else { 0.0 };
    Scene {
        text,
        span: r.scaled(0.05, 60.0) / (1.0 + kick),
        start: velocity.iter().chain(&omega).map(|&x| (x, 1.0)).collect(),
        sizes: vec![(Sort::Length, 1.0)],
        columns: told(
            "attitude qw qx qy qz, rate omega1 omega2 omega3, length x y z, energy energy",
        ),
        truth: Box::new(move |start, times| {
            let velocity = Vector::new(start[0], start[1], start[2]);
            let omega = Vector::new(start[3], start[4], start[5]);
            let whole = mass + small;
            // The common centre, from the planet's; momenta before and after are the same.
            let centre = at * (small / whole);
            let after = (velocity * mass + flight * small) / whole;
            let inertia = planet + particle(mass, centre) + particle(small, at - centre);
            let kick = at.cross(&(flight - velocity)) * (mass * small / whole);
            let omega = inverse(&inertia) * (planet * omega + kick);
            let rate = omega.dot(&omega).sqrt().value().max(1e-3);
            let rows = turned_freely(inertia, omega, times, rate);
            let row = |(&t, y): (&f64, &[Dd; 7])| {
                let l = Vector::new(y[4], y[5], y[6]);
                let omega = inverse(&inertia) * l;
                let turn = rotation([y[0], y[1], y[2], y[3]]);
                let place = centre + after * Dd::from(t) - turn * centre;
                let energy = 0.5 * (whole * after.dot(&after) + l.dot(&omega));
                [&y[..4], omega.as_slice(), place.as_slice(), &[energy]].concat()
            };
            times.iter().zip(&rows).map(row).collect()
        }),
    }
}
