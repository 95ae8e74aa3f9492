//! On perfect ice: why wriggling takes you nowhere (tutorial 1.1, picture a).

use crate::error::{Result, each_finite, finite, not_empty, positive};
use crate::integrators::System;

/// A part of a body on ice.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Part {
    /// Mass, kg.
    pub mass: f64,
    /// Its position relative to the feet, m.
    pub from_feet: [f64; 2],
}

/// Position of the feet, m, if the parts are arranged like this about them and the centre of mass is at `center`.
///
/// The centre of mass of a body that starts from rest without a horizontal force stays where it is, so the position of the feet is a function of the shape: F = C − Σmx/Σm.
/// A closed cycle of shapes brings them back, bit for bit.
///
/// # Errors
/// [`Error::Empty`](crate::Error::Empty) without parts; [`Error::NotPositive`](crate::Error::NotPositive) for a mass; [`Error::NotFinite`](crate::Error::NotFinite).
///
/// ```
/// use spinning_bodies::phenomena::{Part, feet};
/// // The upper part leans a metre to the right, so the feet move to the left and the centre stays.
/// let parts = [Part { mass: 1.0, from_feet: [0.0, 0.0] }, Part { mass: 3.0, from_feet: [1.0, 0.0] }];
/// assert_eq!(feet(&parts, [0.0, 0.0])?, [-0.75, 0.0]);
/// // A tiny body, whose masses times distances are below every double.
/// let tiny = parts.map(|part| Part { mass: 1e-200 * part.mass, from_feet: part.from_feet.map(|place| 1e-200 * place) });
/// assert!((feet(&tiny, [0.0, 0.0])?[0] / -0.75e-200 - 1.0).abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn feet(parts: &[Part], center: [f64; 2]) -> Result<[f64; 2]> {
    not_empty("the list of parts", parts)?;
    let mut mass = 0.0;
    for part in parts {
        mass += positive("the mass of a part", part.mass)?;
        each_finite("the place of a part", part.from_feet)?;
    }
    finite("the mass of all parts", mass)?;
    let place = [0, 1].map(|axis| {
        let share = |part: &Part| part.mass / mass * part.from_feet[axis];
        center[axis] - parts.iter().map(share).sum::<f64>()
    });
    each_finite("the place of the feet", place)?;
    Ok(place)
}

/// Parts of a [`Wriggler`].
pub const PARTS: usize = 6;
const JOINS: usize = PARTS * (PARTS - 1) / 2;

/// A body of six parts on frictionless ice, each pair joined by a muscle that pulls and pushes at random.
///
/// A muscle acts along the join like a damped spring whose rest length swings by half; the forces on its two ends are opposite, and
/// nothing else acts. State for the integrator: x, y of each part, then their velocities.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wriggler {
    masses: [f64; PARTS],
    muscles: [Muscle; JOINS],
    /// The state at time 0: at rest.
    pub start: [f64; 4 * PARTS],
}

#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Muscle {
    rest: f64,
    rate: f64,
    phase: f64,
}

/// Stiffness (N/m) and damping (N s/m) of a muscle.
const STIFFNESS: f64 = 300.0;
const DAMPING: f64 = 8.0;

impl Wriggler {
    /// A wriggler of this seed, at rest: masses of 5 to 15 kg on a circle of radius 0.5 m, muscles at 2 to 8 rad/s.
    ///
    /// ```
    /// use spinning_bodies::phenomena::Wriggler;
    /// assert_eq!(Wriggler::random(7), Wriggler::random(7));
    /// ```
    pub fn random(seed: u64) -> Self {
        let mut state = seed;
        let mut next = || {
            // Knuth's linear congruential generator; its high bits are the random ones.
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
        next();
        let masses = core::array::from_fn(|_| 5.0 + 10.0 * next());
        let mut start = [0.0; 4 * PARTS];
        for k in 0..PARTS {
            let (s, c) = (core::f64::consts::TAU * k as f64 / PARTS as f64).sin_cos();
            (start[2 * k], start[2 * k + 1]) = (0.5 * c, 0.5 * s);
        }
        let mut muscles = [Muscle::default(); JOINS];
        for (muscle, (i, j)) in muscles.iter_mut().zip(joins()) {
            let apart = [0, 1].map(|axis| start[2 * j + axis] - start[2 * i + axis]);
            *muscle = Muscle {
                rest: apart[0].hypot(apart[1]),
                rate: 2.0 + 6.0 * next(),
                phase: core::f64::consts::TAU * next(),
            };
        }
        Self {
            masses,
            muscles,
            start,
        }
    }

    /// The centre of mass, m.
    ///
    /// ```
    /// use spinning_bodies::phenomena::Wriggler;
    /// let body = Wriggler::random(7);
    /// // It starts on a circle of half a metre, so its centre is inside.
    /// let [x, y] = body.center(&body.start);
    /// assert!(x.hypot(y) < 0.5);
    /// ```
    pub fn center(&self, state: &[f64; 4 * PARTS]) -> [f64; 2] {
        let mass: f64 = self.masses.iter().sum();
        core::array::from_fn(|axis| {
            let parts = self.masses.iter().enumerate();
            parts.map(|(k, m)| m * state[2 * k + axis]).sum::<f64>() / mass
        })
    }
}

/// Every pair once.
fn joins() -> impl Iterator<Item = (usize, usize)> {
    (0..PARTS).flat_map(|i| (i + 1..PARTS).map(move |j| (i, j)))
}

impl System<{ 4 * PARTS }> for Wriggler {
    fn rate(&self, t: f64, y: &[f64; 4 * PARTS]) -> [f64; 4 * PARTS] {
        const HALF: usize = 2 * PARTS;
        let mut rate = [0.0; 4 * PARTS];
        rate[..HALF].copy_from_slice(&y[HALF..]);
        for (muscle, (i, j)) in self.muscles.iter().zip(joins()) {
            let apart = [0, 1].map(|axis| y[2 * j + axis] - y[2 * i + axis]);
            let parting = [0, 1].map(|axis| y[HALF + 2 * j + axis] - y[HALF + 2 * i + axis]);
            let length = apart[0].hypot(apart[1]);
            let lengthening = (apart[0] * parting[0] + apart[1] * parting[1]) / length;
            let rest = muscle.rest * (1.0 + 0.5 * (muscle.rate * t + muscle.phase).sin());
            let pull = STIFFNESS * (length - rest) + DAMPING * lengthening;
            for axis in [0, 1] {
                let force = pull * apart[axis] / length;
                rate[HALF + 2 * i + axis] += force / self.masses[i];
                rate[HALF + 2 * j + axis] -= force / self.masses[j];
            }
        }
        rate
    }
}
