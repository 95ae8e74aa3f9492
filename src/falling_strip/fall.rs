//! A fall in the units of the theory, and what becomes of it in the long run.

use core::f64::consts::{FRAC_1_PI, PI, TAU};

use super::plate::{
    AddedMass, Drag, Equations, Gravity, Lift, Plate, RotationalDamping,
};
use crate::error::{Error, Result, finite, positive};
use crate::integrators::{Effort, Method, System, solve};

/// The numbers that the forces of the fluid are fitted with. All dimensionless.
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
    /// Those of Andersen, Pesavento and Wang, for a thin elliptical plate: C_T = 1.2, C_R = π, A = 1.4, B = 1, μ₁ = μ₂ = 0.2, j = 1/4.
    pub const PUBLISHED: Self = Self {
        lift: Lift {
            translational: 1.2,
            rotational: PI,
        },
        drag: Drag {
            mean: 1.4,
            contrast: 1.0,
        },
        damping: RotationalDamping {
            linear: 0.2,
            quadratic: 0.2,
        },
        inertia_factor: 0.25,
    };

    /// Ours, for flat strips of paper: C_T = 1.7, C_R = 1.1, A = 1.7, B = 1, μ₁ = 0.05, μ₂ = 0.04, j = 1/3.
    ///
    /// Found by a random search of 12 500 sets for one that flutters below the measured transition, tumbles above it up to I* = 16, and glides
    /// at about 40 degrees. A fit, not a measurement; many neighbouring sets do as well.
    pub const PAPER: Self = Self {
        lift: Lift {
            translational: 1.7,
            rotational: 1.1,
        },
        drag: Drag {
            mean: 1.7,
            contrast: 1.0,
        },
        damping: RotationalDamping {
            linear: 0.05,
            quadratic: 0.04,
        },
        inertia_factor: 1.0 / 3.0,
    };
}

/// How a fall begins: at rest in all but these.
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
    /// Let go at 0.2 rad from the horizontal, with a breath of speed along the chord.
    pub const TILTED: Self = Self {
        tilt: 0.2,
        velocity: [0.01, -0.01],
        omega: 0.0,
    };

    /// Set spinning: a turn in 2π time units, edge on.
    pub const SPINNING: Self = Self {
        tilt: 1.4,
        velocity: [0.0, 0.0],
        omega: 1.0,
    };

    /// The same seen in a mirror.
    pub fn mirrored(self) -> Self {
        Self {
            tilt: -self.tilt,
            velocity: [-self.velocity[0], self.velocity[1]],
            omega: -self.omega,
        }
    }
}

/// A plate that falls through a fluid, with all the terms, in units of its half width a, U = √(I* a g) and a/U.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fall {
    equations: Equations<Gravity, Lift, Drag, RotationalDamping, AddedMass>,
}

/// What becomes of a fall.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Regime {
    /// Straight down, broadside.
    Steady,
    /// To and fro; it never turns over.
    Flutter,
    /// Over and over, always the same way.
    Tumble,
    /// Now this, now that: it turns over, but not always the same way.
    Mixed,
}

impl Regime {
    /// One word.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Steady => "steady",
            Self::Flutter => "flutter",
            Self::Tumble => "tumble",
            Self::Mixed => "mixed",
        }
    }
}

/// The averages of a fall after its beginnings are forgotten, in units of a, U and a/U.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LongRun {
    /// What it does.
    pub regime: Regime,
    /// Mean angular velocity.
    pub rotation: f64,
    /// Mean velocity sideways (to the right).
    pub drift: f64,
    /// Mean velocity downward.
    pub descent: f64,
    /// Greatest distance sideways from a straight line down, in the window.
    pub reach: f64,
    /// Time after which the motion repeats itself, up to a turn by π; none if it did not in the window.
    pub period: Option<f64>,
}

impl LongRun {
    /// Angle of the path below the horizontal, rad.
    pub fn glide_angle(&self) -> f64 {
        self.descent.atan2(self.drift.abs())
    }
}

/// Time between samples, units a/U: a hundredth of the fastest turn there is.
const SAMPLE: f64 = 0.05;

/// Most samples of a run.
const MOST_SAMPLES: f64 = 2e6;

/// One passage edge on: w = 0.
struct Passage {
    time: f64,
    /// |turned| θ, u and ω, with the plate turned by π if it moved the other way: the two sides are alike.
    section: [f64; 3],
}

impl Fall {
    /// The fall of a flat plate (β = 0) of mass ratio I* = m/(π ρ a²).
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NotPositive`] for the mass ratio or the inertia factor; [`Error::NotFinite`] for a coefficient.
    pub fn new(mass_ratio: f64, coefficients: Coefficients) -> Result<Self> {
        let mass_ratio = positive("the mass ratio of the plate", mass_ratio)?;
        let Coefficients {
            lift,
            drag,
            damping,
            inertia_factor,
        } = coefficients;
        for coefficient in [
            lift.translational,
            lift.rotational,
            drag.mean,
            drag.contrast,
            damping.linear,
            damping.quadratic,
        ] {
            finite("a coefficient of the fluid's forces", coefficient)?;
        }
        // a = 1, π ρ a² = 1, m = I*, and with m g = 1 the speed √(I* a g) is 1.
        Ok(Self {
            equations: Equations {
                plate: Plate::new(1.0, mass_ratio, FRAC_1_PI, 0.0, inertia_factor)?,
                gravity: Gravity {
                    acceleration: 1.0 / mass_ratio,
                },
                lift,
                drag,
                damping,
                added_mass: AddedMass { factor: 1.0 },
            },
        })
    }

    /// The equations, as a system for the integrators: x, y, θ, u, w, ω, heat.
    pub fn equations(&self) -> &Equations<Gravity, Lift, Drag, RotationalDamping, AddedMass> {
        &self.equations
    }

    /// x, y, θ, u, w, ω and heat at each of the times (units a/U), from the origin, by DOP853 with a tolerance of 1e-11.
    ///
    /// Observed error over 100 units where the motion is regular: 1e-9. Chaotic motions (published coefficients, I* from 1.7 to 2.5)
    /// lose a digit every few units, as any method must.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::Integration`].
    pub fn path(&self, start: Start, times: &[f64]) -> Result<Vec<[f64; 7]>> {
        let [u, w] = start.velocity;
        let state = [0.0, 0.0, start.tilt, u, w, start.omega, 0.0];
        let effort = Effort::Tolerance(1e-11);
        let run = solve(
            &self.equations,
            0.0,
            &state,
            &[1.0; 7],
            times,
            Method::Dop853,
            effort,
        )?;
        Ok(run.states)
    }

    /// What the fall does between `run_up` and `run_up + window` (units a/U): its regime, its averages, its period.
    ///
    /// Steady: the angle stays within a thousandth; flutter: it stays within one turn, and the plate does not turn over; tumble: the plate turns over and
    /// ω never changes sign. The averages of the regular motions are those of whole periods; observed error 1e-5 at a window of 200.
    ///
    /// Cost: about 50 evaluations of the equations a unit of time.
    ///
    /// # Errors
    /// [`Error::NotPositive`] and [`Error::NotFinite`] for the times; [`Error::OutOfRange`] beyond 100 000 units; as [`path`](Self::path).
    pub fn long_run(&self, start: Start, run_up: f64, window: f64) -> Result<LongRun> {
        let run_up = positive("the run-up", run_up)?;
        let window = positive("the window", window)?;
        let count = (window / SAMPLE).ceil();
        if count.max(run_up / SAMPLE) > MOST_SAMPLES {
            return Err(Error::OutOfRange {
                quantity: "the window of a long run",
                value: window.max(run_up),
                least: 0.0,
                greatest: MOST_SAMPLES * SAMPLE,
            });
        }
        let step = window / count;
        let times: Vec<f64> = (0..=count as usize)
            .map(|k| run_up + step * k as f64)
            .collect();
        let path = self.path(start, &times)?;
        let passages = self.passages(&times, &path);
        let regime = regime(&path);
        let (first, last, period) = match repeats(&passages) {
            // Whole periods only: from the first passage to the last one like it.
            Some(every) if passages.len() > every => {
                let last = (passages.len() - 1) / every * every;
                let period = (passages[last].time - passages[0].time) * every as f64 / last as f64;
                (passages[0].time, passages[last].time, Some(period))
            }
            _ => (times[0], times[times.len() - 1], None),
        };
        let ends = [first, last].map(|t| self.between(&times, &path, t));
        let mean = |i: usize| (ends[1][i] - ends[0][i]) / (last - first);
        let from = path[0][0];
        Ok(LongRun {
            regime,
            rotation: mean(2),
            drift: mean(0),
            descent: -mean(1),
            reach: path.iter().map(|s| (s[0] - from).abs()).fold(0.0, f64::max),
            period,
        })
    }

    /// All passages through w = 0.
    fn passages(&self, times: &[f64], path: &[[f64; 7]]) -> Vec<Passage> {
        let mut passages = Vec::new();
        for k in 1..path.len() {
            let (before, after) = (path[k - 1][4], path[k][4]);
            if (before > 0.0) == (after > 0.0) {
                continue;
            }
            // Root of w between two samples: three steps of the secant on the cubic through values and slopes.
            let (mut low, mut high) = (times[k - 1], times[k]);
            let mut time = low;
            for _ in 0..40 {
                time = 0.5 * (low + high);
                let w = self.hermite(times, path, k, time)[4];
                if (w > 0.0) == (before > 0.0) {
                    low = time;
                } else {
                    high = time;
                }
            }
            let state = self.hermite(times, path, k, time);
            let (theta, u) = if before > 0.0 {
                (state[2], state[3])
            } else {
                (state[2] + PI, -state[3])
            };
            let section = [theta.rem_euclid(TAU), u, state[5]];
            passages.push(Passage { time, section });
        }
        passages
    }

    /// The state between samples k − 1 and k, by the cubic through their values and rates.
    fn hermite(&self, times: &[f64], path: &[[f64; 7]], k: usize, time: f64) -> [f64; 7] {
        let step = times[k] - times[k - 1];
        let s = (time - times[k - 1]) / step;
        let (from, to) = (&path[k - 1], &path[k]);
        let rates = [from, to].map(|state| self.equations.rate(0.0, state));
        core::array::from_fn(|i| {
            let rise = to[i] - from[i];
            let bend = [step * rates[0][i] - rise, rise - step * rates[1][i]];
            from[i] + s * rise + s * (1.0 - s) * ((1.0 - s) * bend[0] + s * bend[1])
        })
    }

    fn between(&self, times: &[f64], path: &[[f64; 7]], time: f64) -> [f64; 7] {
        let k = times.partition_point(|&t| t < time);
        self.hermite(times, path, k.clamp(1, times.len() - 1), time)
    }
}

/// What a sampled path does.
fn regime(path: &[[f64; 7]]) -> Regime {
    let angles = path.iter().map(|state| state[2]);
    let (low, high) = angles.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), theta| {
        (low.min(theta), high.max(theta))
    });
    let one_way =
        path.iter().all(|state| state[5] > 0.0) || path.iter().all(|state| state[5] < 0.0);
    if high - low < 1e-3 {
        Regime::Steady
    } else if one_way {
        Regime::Tumble
    } else if high - low < PI + 1.0 && !turns_over(low, high) {
        Regime::Flutter
    } else {
        Regime::Mixed
    }
}

/// Whether an interval of angles holds two upright positions of the chord: to get from one to the other the plate shows its other side.
fn turns_over(low: f64, high: f64) -> bool {
    let upright = |theta: f64| ((theta - 0.5 * PI) / PI).floor();
    upright(high) - upright(low) >= 2.0
}

/// After how many passages the motion repeats itself, if it does so for all of them.
fn repeats(passages: &[Passage]) -> Option<usize> {
    let alike = |a: &Passage, b: &Passage| {
        let turn = (a.section[0] - b.section[0] + PI).rem_euclid(TAU) - PI;
        let apart = (a.section[1] - b.section[1]).abs() + (a.section[2] - b.section[2]).abs();
        turn.abs() + apart < 1e-3
    };
    (1..=passages.len() / 2).find(|&every| {
        passages[every..]
            .iter()
            .zip(passages)
            .all(|(later, earlier)| alike(later, earlier))
    })
}
