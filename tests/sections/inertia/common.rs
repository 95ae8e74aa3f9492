//! What the files of Section 2 share.

use super::*;

pub const EPS: f64 = f64::EPSILON;

/// The four masses 1, 2, 3, 4 of 2.2.
pub const MASSES: [i128; 4] = [1, 2, 3, 4];

pub const POSITIONS: [[i128; 3]; 4] = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]];

pub const U: [i128; 3] = [1, -2, 3];

pub const OMEGA: [i128; 3] = [2, 1, -1];

pub fn four_masses() -> Result<MassProperties> {
    let list = [0, 1, 2, 3].map(|k| (MASSES[k] as f64, POSITIONS[k].map(|x| x as f64)));
    particles(&list)
}

pub fn motion_about_origin() -> RigidMotion {
    RigidMotion {
        base: BodyVector::zero(),
        velocity: vector(U.map(|x| x as f64)),
        omega: vector(OMEGA.map(|x| x as f64)),
    }
}

/// Particles, their inertia matrix about the origin, and two vectors.
pub type Swarm = (Vec<(f64, [f64; 3])>, InertiaMatrix, [BodyVector; 2]);

/// So many swarms of so many particles.
pub fn swarms(seed: u64, count: usize, particles: usize) -> impl Iterator<Item = Swarm> {
    let mut uniform = Uniform(seed);
    (0..count).map(move |_| {
        let list = uniform.point_masses(particles);
        let body = support::inertia::particles(&list).expect("masses");
        let inertia = body.about(BodyVector::zero()).expect("a finite matrix");
        (list, inertia, [uniform.vector(), uniform.vector()])
    })
}

pub fn add(a: [R; 3], b: [R; 3]) -> [R; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// Σ m x∧v and ½Σ m v², in rationals, for the four masses with base point `base`.
pub fn direct_sums(base: [R; 3]) -> ([R; 3], R) {
    let (u, omega) = (U.map(whole), OMEGA.map(whole));
    let mut l = [ZERO; 3];
    let mut energy = ZERO;
    for (m, x) in MASSES.into_iter().zip(POSITIONS) {
        let x = x.map(whole);
        let v = add(u, cross(omega, x));
        let arm = [x[0] - base[0], x[1] - base[1], x[2] - base[2]];
        l = add(l, cross(arm, v).map(|c| c * m));
        energy += dot(v, v) * rational(m, 2);
    }
    (l, energy)
}
