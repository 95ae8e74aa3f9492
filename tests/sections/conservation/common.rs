//! What the files of Section 3 share.

use super::*;
use spinning_bodies::conservation::ForceAndTorque;

pub type V = SpaceVector;

/// Small random integers: with them, and a total mass of 16, every sum below is exact in double precision, so the laws can be asserted with `==`.
pub fn integers(numbers: &mut Uniform) -> V {
    let [x, y, z] = [0; 3].map(|_| (17.0 * numbers.next()).floor() - 8.0);
    V::new(x, y, z)
}

pub const MASSES: [f64; 5] = [1.0, 2.0, 3.0, 4.0, 6.0];

/// Five particles in uniformly accelerated flight, and their state at any time.
pub struct Flight {
    pub start: Vec<(V, V, V)>,
}

impl Flight {
    pub fn random(seed: u64) -> Self {
        let mut numbers = Uniform(seed);
        let mut vector = || integers(&mut numbers);
        let start = MASSES.map(|_| (vector(), vector(), vector()));
        Self {
            start: start.to_vec(),
        }
    }

    pub fn at(&self, t: f64) -> Particles {
        Particles::new(self.particles(t)).unwrap()
    }

    pub fn particles(&self, t: f64) -> Vec<Particle> {
        MASSES
            .iter()
            .zip(&self.start)
            .map(|(&mass, &(x, v, a))| Particle {
                mass,
                position: x + t * v + (0.5 * t * t) * a,
                velocity: v + t * a,
            })
            .collect()
    }

    /// Force and torque about `point` now: what makes the particles accelerate as they do.
    pub fn forces(&self, point: V) -> ForceAndTorque {
        let mut accelerations = self.start.iter().map(|&(_, _, a)| a);
        let force = |p: &Particle| p.mass * accelerations.next().unwrap();
        self.at(0.0).force_and_torque(point, force).unwrap()
    }
}
