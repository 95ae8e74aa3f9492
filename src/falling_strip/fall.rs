//! A fall in the units of the theory, and its regime in the long run.

use core::f64::consts::{FRAC_1_PI, PI, TAU};

use super::plate::{AddedMass, Drag, Equations, Lift, Plate, RotationalDamping};
use crate::error::{Result, positive, within};
use crate::integrators::{Effort, Kept, System, order_eight};
use crate::search::halved;

/// The coefficients fitted for the forces of the fluid, all dimensionless.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coefficients {
    /// C_T and C_R.
    pub lift: Lift,
    /// A and B.
    pub drag: Drag,
    /// μ₁ and μ₂.
    pub damping: RotationalDamping,
    /// j: the moment of inertia over m a².
    pub inertia_factor: f64,
}

impl Coefficients {
    /// The coefficients of Andersen, Pesavento and Wang, for a thin elliptical plate: C_T = 1.2, C_R = π, A = 1.4, B = 1, μ₁ = μ₂ = 0.2, j = 1/4.
    pub const PUBLISHED: Self = Self::of([1.2, PI], [1.4, 1.0], [0.2, 0.2], 0.25);

    /// Our coefficients, for flat strips of paper: C_T = 1.7, C_R = 1.1, A = 1.7, B = 1, μ₁ = 0.05, μ₂ = 0.04, j = 1/3.
    ///
    /// Found by a random search among 12 500 sets for one that flutters below the measured transition, tumbles above it up to I* = 16, and glides
    /// at about 40 degrees. A fit, not a measurement; many neighbouring sets fit as well.
    pub const PAPER: Self = Self::of([1.7, 1.1], [1.7, 1.0], [0.05, 0.04], 1.0 / 3.0);

    /// C_T and C_R, A and B, μ₁ and μ₂, and j.
    const fn of(lift: [f64; 2], drag: [f64; 2], damping: [f64; 2], inertia_factor: f64) -> Self {
        let ([translational, rotational], [mean, contrast]) = (lift, drag);
        let [linear, quadratic] = damping;
        Self {
            lift: Lift {
                translational,
                rotational,
            },
            drag: Drag { mean, contrast },
            damping: RotationalDamping { linear, quadratic },
            inertia_factor,
        }
    }
}

/// The start of a fall, at the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Start {
    /// Angle of the chord above the horizontal, rad.
    pub tilt: f64,
    /// Velocity along the chord and across it, units U.
    pub velocity: [f64; 2],
    /// Angular velocity, units U/a.
    pub omega: f64,
}

impl Start {
    /// Released at 0.2 rad from the horizontal, with a small velocity.
    pub const TILTED: Self = Self {
        tilt: 0.2,
        velocity: [0.01, -0.01],
        omega: 0.0,
    };
}

/// A plate falling through a fluid, with all the terms, in units of its half width a, U = √(I* a g) and a/U.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fall {
    equations: Equations,
}

/// The regime of a fall.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Regime {
    /// Straight down, broadside.
    Steady,
    /// To and fro, without ever turning over.
    Flutter,
    /// Over and over in the same sense, perhaps with hesitations.
    Tumble,
    /// Irregular: it turns over now one way, now the other.
    Mixed,
}

/// The averages of a fall after its transients, in units of a, U and a/U.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LongRun {
    /// The regime.
    pub regime: Regime,
    /// Mean angular velocity.
    pub rotation: f64,
    /// Mean velocity sideways (to the right).
    pub drift: f64,
    /// Mean velocity downward.
    pub descent: f64,
    /// Greatest sideways distance, in the window, from the vertical line through the point where the window begins.
    pub reach: f64,
    /// Half the angle between the extreme ends of its swings, rad; `None` unless it flutters.
    pub swing: Option<f64>,
    /// Time after which the motion repeats itself, up to a turn by π; `None` if it did not in the window.
    pub period: Option<f64>,
}

impl LongRun {
    /// Angle of the path below the horizontal, rad.
    ///
    /// ```
    /// use spinning_bodies::falling_strip::{Coefficients, Fall, Start};
    /// let run = Fall::new(3.0, Coefficients::PUBLISHED)?.long_run(Start::TILTED, 100.0, 100.0)?;
    /// assert!(run.glide_angle() > 0.0 && run.glide_angle() < std::f64::consts::FRAC_PI_2);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn glide_angle(&self) -> f64 {
        self.descent.atan2(self.drift.abs())
    }
}

/// Indices of u, w and ω in the state.
const U: usize = 3;
const W: usize = 4;
const OMEGA: usize = 5;

/// Time between samples, units a/U: a sixtieth of the fastest turn.
const SAMPLE: f64 = 0.1;

/// The longest run, units a/U.
const LONGEST: f64 = 2e5;

/// A time and the state then.
type Sample = (f64, [f64; 7]);

/// A passage through the edge-on position, w = 0; or, for a plate that is never edge on, an end of a swing, ω = 0.
struct Passage {
    at: Sample,
    /// Whether the quantity falls through zero there.
    falling: bool,
}

impl Fall {
    /// The fall of a flat plate (β = 0) of mass ratio I* = m/(π ρ a²).
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::NotPositive`](crate::Error::NotPositive) for the mass ratio or the inertia factor;
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Negative`](crate::Error::Negative) for coefficients with which drag or damping would add energy.
    ///
    /// ```
    /// use spinning_bodies::falling_strip::{Coefficients, Fall};
    /// assert!(Fall::new(1.0, Coefficients::PUBLISHED).is_ok());
    /// assert!(Fall::new(0.0, Coefficients::PUBLISHED).is_err());
    /// ```
    pub fn new(mass_ratio: f64, coefficients: Coefficients) -> Result<Self> {
        let mass_ratio = positive("the mass ratio of the plate", mass_ratio)?;
        // a = 1, π ρ a² = 1, m = I*, and with m g = 1 the speed √(I* a g) is 1.
        let plate = Plate::new(1.0, mass_ratio, FRAC_1_PI, 0.0, coefficients.inertia_factor)?;
        let equations = Equations {
            plate,
            gravity: Some(1.0 / mass_ratio),
            lift: Some(coefficients.lift),
            drag: Some(coefficients.drag),
            damping: Some(coefficients.damping),
            added_mass: Some(AddedMass { factor: 1.0 }),
        };
        let equations = equations.checked()?;
        Ok(Self { equations })
    }

    /// x, y, θ, u, w, ω and heat at each of the times (units a/U), from the origin, by the method of order 8 with a tolerance of 1e-11.
    ///
    /// Observed error over 100 units of 39 regular motions, I* from 0.1 to 20, against 27 digits: 1e-8, at worst 2e-7. Chaotic motions (published coefficients, I* from 1.7 to 2.5)
    /// lose a digit every few units, as any method must.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::Integration`](crate::Error::Integration).
    ///
    /// ```
    /// use spinning_bodies::falling_strip::{Coefficients, Fall, Start};
    /// // Released, it falls; its mirror image goes the other way.
    /// let fall = Fall::new(1.0, Coefficients::PUBLISHED)?;
    /// let mirrored = Start { tilt: -0.2, velocity: [-0.01, -0.01], omega: 0.0 };
    /// let [one, other] = [Start::TILTED, mirrored].map(|start| fall.path(start, &[5.0]));
    /// let ([x, y, ..], [across, ..]) = (one?[0], other?[0]);
    /// assert!(y < 0.0 && (x + across).abs() < 1e-9);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn path(&self, start: Start, times: &[f64]) -> Result<Vec<[f64; 7]>> {
        let [u, w] = start.velocity;
        let state = [0.0, 0.0, start.tilt, u, w, start.omega, 0.0];
        let effort = Effort::Tolerance(1e-11);
        let equations: &dyn System<7> = &self.equations;
        let run = order_eight(equations, Kept::Nothing, &state, &[1.0; 7], times, effort)?;
        Ok(run.states)
    }

    /// Regime, averages and period of the fall between `run_up` and `run_up + window` (units a/U).
    ///
    /// Steady: the angle stays within a thousandth. Flutter: it stays within one turn. Tumble: it does not, and the plate never turns back by half a
    /// turn. If the motion repeats itself, averages are taken over whole periods.
    ///
    /// Cost: about 50 evaluations of the equations a unit of time.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) and [`Error::NotFinite`](crate::Error::NotFinite) for the times, the former also for a window that is
    /// nothing beside the run-up; [`Error::OutOfRange`](crate::Error::OutOfRange) beyond 200 000 units; as [`path`](Self::path).
    ///
    /// ```
    /// use spinning_bodies::falling_strip::{Coefficients, Fall, Regime, Start};
    /// let light = Fall::new(1.0, Coefficients::PUBLISHED)?;
    /// assert_eq!(light.long_run(Start::TILTED, 100.0, 100.0)?.regime, Regime::Flutter);
    /// assert!(light.long_run(Start::TILTED, 100.0, 1e-15).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn long_run(&self, start: Start, run_up: f64, window: f64) -> Result<LongRun> {
        let run_up = positive("the run-up", run_up)?;
        let window = positive("the window", window)?;
        within("the window of a long run", window.max(run_up), 0.0, LONGEST)?;
        // Too short a window would have no time between its ends.
        positive("the window beside the run-up", (run_up + window) - run_up)?;
        let count = (window / SAMPLE).ceil();
        let step = window / count;
        let times = (0..=count as usize).map(|k| run_up + step * k as f64);
        let times: Vec<f64> = times.collect();
        let path = self.path(start, &times)?;
        let samples: Vec<Sample> = times.into_iter().zip(path).collect();
        let edge_on = self.crossings(&samples, W)?;
        let ends = self.crossings(&samples, OMEGA)?;
        // Half the range of the angles at which it turns back.
        let swing = 0.5 * range(ends.iter().map(|end| end.at.1[2]));
        // All edge-on passages, or all left ends of swings.
        let passages: Vec<Passage> = if edge_on.len() > 2 {
            edge_on
        } else {
            ends.into_iter().filter(|end| end.falling).collect()
        };
        let (regime, begin) = (regime(&samples), samples[0]);
        let (first, last, period) = match repeats(&passages) {
            // Whole periods only: from the first passage to the last equivalent one.
            Some(every) if passages.len() > every => {
                let count = (passages.len() - 1) / every * every;
                let (first, last) = (passages[0].at, passages[count].at);
                let period = (last.0 - first.0) * every as f64 / count as f64;
                (first, last, Some(period))
            }
            _ => (begin, samples[samples.len() - 1], None),
        };
        let mean = |i: usize| (last.1[i] - first.1[i]) / (last.0 - first.0);
        let aside = samples.iter().map(|(_, y)| (y[0] - begin.1[0]).abs());
        Ok(LongRun {
            regime,
            rotation: mean(2),
            drift: mean(0),
            descent: -mean(1),
            reach: aside.fold(0.0, f64::max),
            swing: (regime == Regime::Flutter && swing >= 0.0).then_some(swing),
            period,
        })
    }

    /// All times at which a component of the state changes sign, and whether it was falling.
    fn crossings(&self, samples: &[Sample], component: usize) -> Result<Vec<Passage>> {
        let mut crossings = Vec::new();
        for [from, to] in samples.array_windows() {
            let falling = from.1[component] > 0.0;
            if falling == (to.1[component] > 0.0) {
                continue;
            }
            // By bisection on the cubic through values and rates.
            let between = self.between(from, to);
            let still = |t| Ok((between(t)[component] > 0.0) == falling);
            let [time, _] = halved([from.0, to.0], 1e-12 * (to.0 - from.0), still)?;
            let at = (time, between(time));
            crossings.push(Passage { at, falling });
        }
        Ok(crossings)
    }

    /// The state at a time between two samples, by the cubic through their values and rates.
    fn between(&self, (begin, from): &Sample, (end, to): &Sample) -> impl Fn(f64) -> [f64; 7] {
        let step = end - begin;
        let rates = [from, to].map(|state| self.equations.rate(0.0, state));
        move |time| {
            let s = (time - begin) / step;
            core::array::from_fn(|i| {
                let rise = to[i] - from[i];
                let bend = [step * rates[0][i] - rise, rise - step * rates[1][i]];
                from[i] + s * rise + s * (1.0 - s) * ((1.0 - s) * bend[0] + s * bend[1])
            })
        }
    }
}

/// The regime of a sampled path.
fn regime(path: &[Sample]) -> Regime {
    let angles = || path.iter().map(|(_, state)| state[2]);
    let range = range(angles());
    let net = path[path.len() - 1].1[2] - path[0].1[2];
    if range < 1e-3 {
        Regime::Steady
    } else if range < TAU {
        Regime::Flutter
    } else if turned_back(angles().map(|theta| theta * net.signum())) < PI {
        Regime::Tumble
    } else {
        Regime::Mixed
    }
}

/// The range of these angles.
fn range(angles: impl Iterator<Item = f64>) -> f64 {
    let nothing = [f64::INFINITY, f64::NEG_INFINITY];
    let [least, greatest] = angles.fold(nothing, |[low, high], x| [low.min(x), high.max(x)]);
    greatest - least
}

/// The most by which a sequence of angles falls below the greatest before it.
fn turned_back(angles: impl Iterator<Item = f64>) -> f64 {
    let mut greatest = f64::NEG_INFINITY;
    angles.fold(0.0, |back: f64, theta| {
        greatest = greatest.max(theta);
        back.max(greatest - theta)
    })
}

/// The number of passages after which the motion repeats itself, if it does so throughout.
fn repeats(passages: &[Passage]) -> Option<usize> {
    let alike = |a: &Passage, b: &Passage| {
        // The two sides of the plate are alike: one that moves the other way is turned by π.
        let (turned, sense) = match a.falling == b.falling {
            true => (0.0, 1.0),
            false => (PI, -1.0),
        };
        let turn = (a.at.1[2] - b.at.1[2] + turned + PI).rem_euclid(TAU) - PI;
        let apart = |i: usize, sense: f64| (a.at.1[i] - sense * b.at.1[i]).abs();
        turn.abs() + apart(U, sense) + apart(W, sense) + apart(OMEGA, 1.0) < 1e-3
    };
    (1..=passages.len() / 2).find(|&every| {
        let mut pairs = passages[every..].iter().zip(passages);
        pairs.all(|(later, earlier)| alike(later, earlier))
    })
}
