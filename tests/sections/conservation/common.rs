//! What the files of Section 3 share.

use spinning_bodies::conservation::{ForceAndTorque, Particle, Particles};
use spinning_bodies::frame::SpaceVector;

pub type V = SpaceVector;

/// Small random integers as a linear congruential sequence: with them, and a total mass of 16, every sum below is
/// exact in double precision, so the laws can be asserted with `==`.
pub struct Integers(pub u64);

impl Integers {
    pub fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        f64::from((self.0 >> 40) as u32 % 17) - 8.0
    }

    pub fn vector(&mut self) -> V {
        V::new(self.next(), self.next(), self.next())
    }
}

pub const MASSES: [f64; 5] = [1.0, 2.0, 3.0, 4.0, 6.0];

/// Five particles in uniformly accelerated flight, and their state at any time.
pub struct Flight {
    pub start: Vec<(V, V, V)>,
}

impl Flight {
    pub fn random(seed: u64) -> Self {
        let mut random = Integers(seed);
        let start = MASSES.map(|_| (random.vector(), random.vector(), random.vector()));
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
        self.at(0.0)
            .force_and_torque(point, |p| p.mass * accelerations.next().unwrap())
            .unwrap()
    }
}
