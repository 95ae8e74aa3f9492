//! The same by general integration: all there is with air, a check without.

use core::f64::consts::{FRAC_PI_2, PI};

use super::YoYoState;
use super::engine::{Bench, Departure, Ending, Engine, Leg, Sample, Setting, Stage};
use super::exact::resting;
use crate::error::{Error, Result};
use crate::integrators::{Cost, Effort, Method, Passage, Stop, until};
use crate::scene::{Budget, Request};
use crate::yo_yo::YoYo;

/// Integration of every phase with one tolerance.
struct Stepping<'a> {
    bench: Bench,
    /// Resistance of the air, kg m².
    air: f64,
    method: Method,
    tolerance: f64,
    budget: &'a Budget,
}

impl Setting<'_> {
    /// The states at `times` by a general method: with tolerances that fall until two runs agree to the accuracy.
    pub(super) fn refined(
        &self,
        times: &[f64],
        method: Method,
        request: &Request,
    ) -> Result<(Vec<YoYoState>, Cost)> {
        let (accuracy, budget) = (request.accuracy(), &Budget::asked(request));
        let run = |tolerance: f64| {
            let engine = Stepping {
                bench: self.bench(),
                air: self.effects.air().unwrap_or(0.0),
                method,
                tolerance,
                budget,
            };
            self.run(&engine, times, budget)
        };
        let spin = |states: &[YoYoState]| states.iter().map(|s| s.omega).fold(0.0, f64::max);
        let mut tolerance = (0.1 * accuracy).max(LEAST_TOLERANCE);
        let (mut last, mut cost) = run(tolerance)?;
        loop {
            let worse = tolerance;
            tolerance = (0.03 * tolerance).max(LEAST_TOLERANCE);
            let (states, more) = run(tolerance)?;
            cost += more;
            let fastest = spin(&states).max(f64::MIN_POSITIVE);
            let apart = last.iter().zip(&states).map(|(a, b)| {
                let depth = (a.depth - b.depth).abs() / self.toy.length();
                // At an event the spin may jump; the depth does not.
                if a.phase == b.phase {
                    depth.max((a.omega - b.omega).abs() / fastest)
                } else {
                    depth
                }
            });
            let apart = apart.fold(0.0, f64::max);
            if apart <= 0.5 * accuracy {
                return Ok((states, cost));
            }
            if worse == LEAST_TOLERANCE {
                return Err(Error::Accuracy {
                    asked: accuracy,
                    reached: 2.0 * apart,
                });
            }
            last = states;
        }
    }
}

const LEAST_TOLERANCE: f64 = 1e-15;

impl Stepping<'_> {
    fn follow<const N: usize>(
        &self,
        rate: impl Fn(f64, &[f64; N]) -> [f64; N],
        start: [f64; N],
        scales: [f64; N],
        (begin, times): (f64, &[f64]),
        event: impl Fn(f64, &[f64; N]) -> f64,
    ) -> Result<Passage<[f64; N]>> {
        let end = times.last().map_or(begin, |last| last.max(begin));
        let effort = Effort::Tolerance(self.tolerance);
        until(
            &self.budget.counted(&rate),
            begin,
            &start,
            &scales,
            times,
            end,
            &event,
            self.method,
            effort,
        )
    }

    /// A passage as a leg. The state is a coordinate, the spin and the heat.
    fn leg(
        &self,
        passage: Passage<[f64; 3]>,
        sample: impl Fn(&[f64; 3]) -> Sample,
        energy: impl Fn(&[f64; 3]) -> f64,
    ) -> Leg {
        let end = &passage.end;
        Leg {
            samples: passage.states.iter().map(sample).collect(),
            end: (passage.stopped == Stop::AtTheEvent).then(|| Ending {
                time: passage.time,
                energy: energy(end),
                omega: end[1].max(0.0),
                heat: end[2],
            }),
            cost: passage.cost,
        }
    }

    /// Angular acceleration on the string, up (−1) or down (1).
    fn unwinding(&self, toy: &YoYo, sign: f64, depth: f64, omega: f64) -> [f64; 3] {
        let g = self.bench.gravity;
        let square = toy.radius_squared(depth);
        let r = square.sqrt();
        let inertia = toy.inertia() + toy.mass() * square;
        let drive = toy.mass() * r * (g + 0.5 * toy.thinning() * omega * omega);
        let drag = self.air * omega * omega.abs();
        [
            sign * r * omega,
            (sign * drive - drag) / inertia,
            drag * omega,
        ]
    }
}

impl Engine for Stepping<'_> {
    fn leg(&self, departure: &Departure, begin: f64, times: &[f64]) -> Result<Leg> {
        let span = (begin, times);
        let toy = self.bench.toy;
        let (g, m, l, r) = (self.bench.gravity, toy.mass(), toy.length(), toy.axle());
        let air = self.air;
        let Departure {
            stage,
            energy,
            omega,
        } = *departure;
        let scale = m * g * l + energy.abs();
        let fastest = (2.0 * scale / (toy.inertia() + m * r * r)).sqrt();
        match stage {
            Stage::Down | Stage::Up => {
                let sign = if stage == Stage::Down { 1.0 } else { -1.0 };
                let depth = match stage {
                    Stage::Up => l,
                    _ if energy < 0.0 => -energy / (m * g),
                    _ => 0.0,
                };
                let rate = |_: f64, y: &[f64; 3]| self.unwinding(&toy, sign, y[0], y[1]);
                // Without energy to spare it is the spin that ends the way up: the depth would graze the hand.
                let spare = energy > 1e-12 * scale;
                let event = |_: f64, y: &[f64; 3]| match stage {
                    Stage::Down => (l - y[0]) / l,
                    _ if spare => (y[0] / l).min(y[1] / fastest),
                    _ => y[1] / fastest,
                };
                let start = [depth, omega, 0.0];
                let passage = self.follow(rate, start, [l, fastest, scale], span, event)?;
                let sample = |y: &[f64; 3]| {
                    let [depth, omega, heat] = *y;
                    let [velocity, spin_up, _] = self.unwinding(&toy, sign, depth, omega);
                    // The string alone turns the yo-yo, but for the air.
                    let torque = toy.inertia() * spin_up + air * omega * omega.abs();
                    Sample {
                        depth,
                        velocity,
                        omega,
                        tension: sign * torque / toy.radius(depth),
                        heat,
                    }
                };
                // At the top what is left of the spin is rounding unless the hand is there.
                let energy = |y: &[f64; 3]| {
                    let left = toy.kinetic_energy(y[0], y[1]) - m * g * y[0];
                    if stage == Stage::Up && y[1] < 1e-5 * fastest {
                        -m * g * y[0].max(0.0)
                    } else {
                        left
                    }
                };
                Ok(self.leg(passage, sample, energy))
            }
            Stage::Turn | Stage::IntoSleep | Stage::OutOfSleep => {
                let inertia = toy.inertia() + m * r * r;
                let pull = m * g * r / inertia;
                let rate = |_: f64, y: &[f64; 3]| {
                    let drag = air * y[1] * y[1].abs();
                    [y[1], pull * y[0].cos() - drag / inertia, drag * y[1]]
                };
                let (start, end) = match stage {
                    Stage::Turn => ([0.0, omega, 0.0], PI),
                    Stage::IntoSleep => ([0.0, omega, 0.0], FRAC_PI_2),
                    _ => {
                        let fast = (omega * omega + 2.0 * pull).sqrt();
                        ([FRAC_PI_2, fast, 0.0], PI)
                    }
                };
                let event = |_: f64, y: &[f64; 3]| end - y[0];
                let passage = self.follow(rate, start, [1.0, fastest, scale], span, event)?;
                let sample = |y: &[f64; 3]| {
                    let (sine, cosine) = y[0].sin_cos();
                    let [_, spin_up, _] = rate(0.0, y);
                    let up = r * (y[1] * y[1] * sine - spin_up * cosine);
                    Sample {
                        depth: l + r * sine,
                        velocity: r * y[1] * cosine,
                        omega: y[1],
                        tension: m * (g + up),
                        heat: y[2],
                    }
                };
                let energy =
                    |y: &[f64; 3]| 0.5 * inertia * y[1] * y[1] - m * g * (l + r * y[0].sin());
                Ok(self.leg(passage, sample, energy))
            }
            Stage::Asleep => {
                let waking = begin + self.bench.asleep;
                let torque = self.bench.torque;
                let sample = |y: &[f64; 3]| Sample {
                    depth: l + r,
                    velocity: 0.0,
                    omega: y[1],
                    tension: m * g,
                    heat: y[2],
                };
                let rate = |_: f64, y: &[f64; 3]| {
                    // No sign of ω: the run ends where it is zero, and a kink there would spoil the steps that try beyond.
                    let drag = torque + air * y[1] * y[1];
                    [y[1], -drag / toy.inertia(), drag * y[1]]
                };
                let within = times.partition_point(|&t| t < waking);
                let mut inside = times[..within].to_vec();
                let beyond = within < times.len();
                if beyond {
                    inside.push(waking);
                }
                let start = [0.0, omega, 0.0];
                let stopping = |_: f64, y: &[f64; 3]| y[1];
                let scales = [1.0, fastest, scale];
                let passage = self.follow(rate, start, scales, (begin, &inside), stopping)?;
                // Once stopped it stays so.
                let mut states = passage.states;
                let spent = 0.5 * toy.inertia() * omega * omega;
                states.resize(inside.len(), [0.0, 0.0, spent]);
                let end = if beyond { states.pop() } else { None };
                Ok(Leg {
                    samples: states.iter().map(sample).collect(),
                    end: end.map(|y| Ending {
                        time: waking,
                        energy: energy - y[2],
                        omega: y[1],
                        heat: y[2],
                    }),
                    cost: passage.cost,
                })
            }
            Stage::Hanging | Stage::Caught => Ok(resting(&self.bench, stage, times)),
        }
    }
}
