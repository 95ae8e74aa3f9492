//! What the files of 4.2 share.

use super::*;
use spinning_bodies::impacts::Strike;

pub type V = BodyVector;

pub type Q3 = [R; 3];

pub const M: f64 = 1.0;

pub const SMALL: f64 = 0.01;

pub const MOMENT: f64 = 0.4;

pub fn x() -> V {
    V::new(0.6, 0.0, 0.8)
}

pub fn v() -> V {
    V::new(-10.0, -20.0, 5.0)
}

pub fn example() -> Strike {
    let planet = Planet::spherical(M, MOMENT, V::zero(), V::new(0.0, 0.0, 1.0)).unwrap();
    strike(&planet, &Meteorite::new(SMALL, v()).unwrap(), x()).unwrap()
}

pub fn close(actual: V, expected: [f64; 3], tolerance: f64) {
    within((actual - vector(expected)).norm(), tolerance);
}

pub fn add(a: Q3, b: Q3, factor: R) -> Q3 {
    [0, 1, 2].map(|i| a[i] + factor * b[i])
}

/// The tutorial's two vector balances as they stand, six linear equations in V' and Ω', by Gauss–Jordan elimination over
/// the rationals: no μ, no common centre, nothing of the library's algebra.
pub fn balances(
    big: R,
    moment: R,
    small: R,
    at: Q3,
    flight: Q3,
    velocity: Q3,
    omega: Q3,
) -> (Q3, Q3) {
    let momentum = add(velocity.map(|c| c * big), flight, small);
    let spin = add(omega.map(|c| c * moment), cross(at, flight), small);
    let right: Vec<R> = momentum.into_iter().chain(spin).collect();
    let left = |velocity: Q3, omega: Q3| -> Vec<R> {
        let ground = add(velocity, cross(omega, at), ONE);
        let p = add(velocity.map(|c| c * big), ground, small);
        let l = add(omega.map(|c| c * moment), cross(at, ground), small);
        p.into_iter().chain(l).collect()
    };
    let unit = |i: usize| [0, 1, 2].map(|j| if i == j { ONE } else { ZERO });
    let columns = [0, 1, 2, 3, 4, 5].map(|i| left(unit(i), unit(i.wrapping_sub(3))));
    let row = |i| columns.iter().map(|c| c[i]).chain([right[i]]).collect();
    let mut rows: Vec<Vec<R>> = (0..6).map(row).collect();
    for i in 0..6 {
        let pivot = (i..6).find(|&r| rows[r][i] != ZERO).unwrap();
        rows.swap(i, pivot);
        let scale = rows[i][i];
        rows[i].iter_mut().for_each(|c| *c /= scale);
        for r in (0..6).filter(|&r| r != i) {
            let factor = rows[r][i];
            let row = rows[i].clone();
            let pairs = rows[r].iter_mut().zip(row);
            pairs.for_each(|(c, p)| *c -= factor * p);
        }
    }
    let solution = |i: usize| rows[i][6];
    ([0, 1, 2].map(solution), [3, 4, 5].map(solution))
}

/// Both balances, inserted: (momentum, angular momentum about the point where C is at impact), after minus before.
pub fn defects(hit: &Strike) -> (V, V) {
    let (planet, meteorite, x) = (hit.planet, hit.meteorite, hit.at);
    let ground = hit.velocity_after + hit.omega_after.cross(&x);
    let (m, v) = (meteorite.mass, meteorite.velocity);
    let momentum = planet.mass * (hit.velocity_after - planet.velocity) + m * (ground - v);
    let change = hit.omega_after - planet.omega;
    let spin = planet.inertia.angular_momentum(change);
    (momentum, spin + x.cross(&(m * (ground - v))))
}

pub fn lopsided() -> Planet {
    // A box: I is a matrix here, and the axes are turned so that it is not even diagonal.
    let attitude = spinning_bodies::frame::Attitude::from_quaternion(0.9, 0.2, -0.3, 0.1).unwrap();
    let body = shapes::cuboid(5.0, [1.0, 2.0, 3.0]).unwrap();
    let (velocity, omega) = (V::new(1.0, -2.0, 0.5), V::new(0.3, 0.2, -1.0));
    Planet::new(5.0, body.turned(&attitude).inertia(), velocity, omega).unwrap()
}
