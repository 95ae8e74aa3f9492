//! Tops under gravity alone by the methods for turning bodies.

use super::State;
use super::books::Books;
use super::foreseen::Foreseen;
use super::steered::{Shown, Steered, Wheel};
use crate::error::{Error, Result};
use crate::frame::BodyVector;
use crate::integrators::geometric::{
    Course, DormandPrince8, FreeSplitting, HeavySplitting, MoserVeselov, MuntheKaas, Order, Phase,
    Rotations, SymmetricDrift, Watched, Weight, order_eight_watched,
};
use crate::integrators::{Cost, Effort, Kept};
use crate::scene::Budget;
use crate::scene::plan::Geometric;

/// A top under its weight, or nothing.
pub(super) struct Heavy<'a> {
    pub moments: [f64; 3],
    /// MgC, N m.
    pub lever: [f64; 3],
    pub start: Phase,
    /// Scales of Ω (rad/s), of L (kg m²/s) and of the energy (J).
    pub fastest: f64,
    pub momentum: f64,
    pub energy: f64,
    pub times: &'a [f64],
    /// The angle up to which an error grows no faster than in proportion to the time.
    pub calm: f64,
    pub budget: &'a Budget,
}

impl Heavy<'_> {
    /// Phases at the times asked for, with an error below the accuracy.
    ///
    /// # Errors
    /// [`Error::Solver`] for a method that cannot run this top; [`Error::Accuracy`]; those of the method.
    pub fn to_accuracy(&self, method: Geometric, accuracy: f64) -> Result<Steered<Phase>> {
        if method != Geometric::DormandPrince8 {
            return self.halved(method, accuracy);
        }
        let system = DormandPrince8::new(self.moments, Weight::new(self.lever)?)?;
        let wheel = Wheel {
            run: |tolerance, times: &[f64]| self.shown(&system, times, tolerance),
            distance: |a: &Phase, b: &Phase| self.apart(a, b),
            times: self.times,
            fastest: self.fastest,
            // Near an unstable steady motion what is a little off grows from the start.
            calm: if self.liveliness() < STEADY && self.calm.is_finite() {
                0.0
            } else {
                self.calm
            },
            accuracy,
        };
        wheel.steer()
    }

    /// The same by steps whose length is known.
    ///
    /// # Errors
    /// As for [`to_accuracy`](Self::to_accuracy).
    pub fn foreseen(&self, foreseen: &Foreseen, accuracy: f64) -> Result<Steered<Phase>> {
        let free = self.lever == [0.0; 3];
        let (first, _) = self.invariants(&self.start);
        let run = |step: f64, method: &dyn Watched| {
            // About as many looks at the energy as steps make a turn at most.
            let stride = if free {
                u64::MAX
            } else {
                (longest(self.times) / step / LOOKS).ceil() as u64
            };
            let mut drift = 0.0_f64;
            let course = self.stepped(method, step, stride, |phase| {
                let (energy, _) = self.invariants(phase);
                drift = drift.max((energy - first).abs() / self.energy);
            })?;
            Ok((course.phases, course.cost, drift))
        };
        let moments = self.moments;
        match foreseen.method {
            Geometric::Rotations(order) if free => {
                let method = FreeSplitting::new(moments, order)?;
                foreseen.steer(accuracy, |step| run(step, &method))
            }
            Geometric::MoserVeselov(order) if free => {
                let method = MoserVeselov::new(moments, order)?;
                foreseen.steer(accuracy, |step| run(step, &method))
            }
            Geometric::KickDrift(order) => {
                let drift = SymmetricDrift::new(moments)?;
                let method = HeavySplitting::new(drift, Weight::new(self.lever)?, order);
                foreseen.steer(accuracy, |step| run(step, &method))
            }
            _ => self.to_accuracy(foreseen.method, accuracy),
        }
    }

    /// Steps of one length; `look` sees the phase every `stride` of them at least, and at each of the times.
    fn stepped(
        &self,
        method: &dyn Watched,
        step: f64,
        stride: u64,
        mut look: impl FnMut(&Phase),
    ) -> Result<Course> {
        let mut paid = 0;
        let mut watch = |time: f64, phase: &Phase, cost: Cost| {
            look(phase);
            let evaluations = cost.evaluations - paid;
            paid = cost.evaluations;
            self.budget.spend(evaluations, time)
        };
        let stride = stride.clamp(1, PATIENCE);
        method.watched(&self.start, self.times, step, stride, &mut watch)
    }

    /// How fast L and the vertical change along the body's axes, as a share of the fastest rate: nothing in steady motions.
    pub fn liveliness(&self) -> f64 {
        let (l, up) = (self.start.l, self.start.up());
        let omega: [f64; 3] = core::array::from_fn(|k| l[k] / self.moments[k]);
        let square = |of: &dyn Fn(usize, usize) -> f64| {
            let each = |k: usize| of((k + 1) % 3, (k + 2) % 3);
            (0..3).map(|k| each(k) * each(k)).sum::<f64>()
        };
        let tilting = square(&|i, j| up[i] * omega[j] - up[j] * omega[i]);
        let turning = square(&|i, j| {
            l[i] * omega[j] - l[j] * omega[i] + up[i] * self.lever[j] - up[j] * self.lever[i]
        });
        (tilting.sqrt() + turning.sqrt() / self.momentum) / self.fastest
    }

    /// One run, its error not asked for.
    ///
    /// # Errors
    /// As for [`to_accuracy`](Self::to_accuracy).
    pub fn once(&self, method: Geometric, effort: Effort) -> Result<(Vec<Phase>, Cost)> {
        if method == Geometric::DormandPrince8 {
            let system = DormandPrince8::new(self.moments, Weight::new(self.lever)?)?;
            return self.of_order_eight(&system, self.times, effort, |_, _| {});
        }
        let course = self
            .method(method)?
            .follow(&self.start, self.times, effort)?;
        Ok((course.phases, course.cost))
    }

    /// A run of order 8 and the most that it fails energy and L along the vertical.
    fn shown(
        &self,
        system: &DormandPrince8<Weight>,
        times: &[f64],
        tolerance: f64,
    ) -> Result<Shown<Phase>> {
        let (first, spin) = self.invariants(&self.start);
        let mut drift = 0.0_f64;
        let watch = |_, &[a, b, c, w, x, y, z]: &[f64; 7]| {
            let (l, q) = ([a, b, c], [w, x, y, z]);
            let (energy, about_vertical) = self.invariants(&Phase { l, q });
            let lost = (energy - first).abs() / self.energy;
            drift = drift
                .max(lost)
                .max((about_vertical - spin).abs() / self.momentum);
        };
        let effort = Effort::Tolerance(tolerance);
        let (states, cost) = self.of_order_eight(system, times, effort, watch)?;
        Ok(Shown {
            states,
            cost,
            drift,
        })
    }

    fn of_order_eight(
        &self,
        system: &DormandPrince8<Weight>,
        times: &[f64],
        effort: Effort,
        watch: impl FnMut(f64, &[f64; 7]),
    ) -> Result<(Vec<Phase>, Cost)> {
        let ([a, b, c], [w, x, y, z]) = (self.start.l, self.start.q);
        let start = [a, b, c, w, x, y, z];
        let l = self.momentum;
        let scales = [l, l, l, 1.0, 1.0, 1.0, 1.0];
        let kept = Kept::UnitQuaternion(3);
        let system = self.budget.counted(system);
        let run = order_eight_watched(&system, kept, &start, &scales, times, effort, watch)?;
        let phases = run.states.iter().map(|&[a, b, c, w, x, y, z]| Phase {
            l: [a, b, c],
            q: [w, x, y, z],
        });
        Ok((phases.collect(), run.cost))
    }

    /// Steps of one length, shortened until two runs vouch for each other: of the better the error is their distance over ratioᵖ − 1.
    fn halved(&self, method: Geometric, accuracy: f64) -> Result<Steered<Phase>> {
        let method = self.method(method)?;
        let order = f64::from(method.order().unwrap_or(2));
        let longest = longest(self.times);
        let run = |step: f64| self.stepped(&*method, step, PATIENCE, |_| {});
        let mut before_step = (0.5 / self.fastest).min(longest).max(f64::MIN_POSITIVE);
        let mut before = run(before_step)?;
        let (mut cost, mut shrink) = (before.cost, 0.5_f64);
        let mut reached = f64::INFINITY;
        loop {
            let step = before_step * shrink;
            let next = run(step)?;
            cost += next.cost;
            let pairs = before.phases.iter().zip(&next.phases);
            let apart = pairs.map(|(a, b)| self.apart(a, b)).fold(0.0, |m, d| {
                // What is not a number must not pass for small.
                if d <= m { m } else { d }
            });
            let error = 2.0 * apart / (shrink.powf(-order) - 1.0);
            if error <= accuracy {
                return Ok(Steered {
                    states: next.phases,
                    error,
                    cost,
                });
            }
            // Rounding: shorter steps no longer help.
            if error > reached && error < 1e-6 {
                break;
            }
            reached = reached.min(error);
            shrink = (0.4 * accuracy / error).powf(1.0 / order).clamp(0.1, 0.6);
            (before, before_step) = (next, step);
        }
        Err(Error::Accuracy {
            asked: accuracy,
            reached,
        })
    }

    /// The method, if it can run this top.
    fn method(&self, method: Geometric) -> Result<Box<dyn Watched>> {
        let free = self.lever == [0.0; 3];
        Ok(match method {
            Geometric::Rotations(order) if free => {
                Box::new(FreeSplitting::new(self.moments, order)?)
            }
            Geometric::MoserVeselov(order) if free => {
                Box::new(MoserVeselov::new(self.moments, order)?)
            }
            Geometric::Rotations(_) | Geometric::MoserVeselov(_) => {
                return Err(Error::Solver {
                    condition: "the solvers rotations and moser-veselov are for tops that no torque acts on",
                });
            }
            Geometric::KickDrift(order) => self.kick_drift(order)?,
            Geometric::MuntheKaas => {
                Box::new(MuntheKaas::new(self.moments, Weight::new(self.lever)?)?)
            }
            Geometric::DormandPrince8 => {
                return Err(Error::Condition {
                    condition: "dormand-prince-8 is not a method of steps of one length",
                    value: self.fastest,
                });
            }
        })
    }

    fn kick_drift(&self, order: Order) -> Result<Box<dyn Watched>> {
        let weight = Weight::new(self.lever)?;
        Ok(match SymmetricDrift::new(self.moments) {
            Ok(drift) => Box::new(HeavySplitting::new(drift, weight, order)),
            Err(_) => {
                let drift = Rotations::new(self.moments, order)?;
                Box::new(HeavySplitting::new(drift, weight, order))
            }
        })
    }

    /// Energy, and L along the vertical.
    fn invariants(&self, phase: &Phase) -> (f64, f64) {
        let up = phase.up();
        let sum = |of: &dyn Fn(usize) -> f64| of(0) + of(1) + of(2);
        let energy =
            sum(&|k| 0.5 * phase.l[k] * phase.l[k] / self.moments[k] + self.lever[k] * up[k]);
        (energy, sum(&|k| phase.l[k] * up[k]))
    }

    /// Angle between two attitudes, radians, or the distance of the angular velocities in their scale, whichever is more.
    fn apart(&self, a: &Phase, b: &Phase) -> f64 {
        let square = |x: f64| x * x;
        let turned: f64 = (0..4).map(|k| square(a.q[k] - b.q[k])).sum();
        let faster: f64 = (0..3)
            .map(|k| square((a.l[k] - b.l[k]) / self.moments[k]))
            .sum();
        (2.0 * turned.sqrt()).max(faster.sqrt() / self.fastest)
    }

    /// The rows of a motion.
    pub fn rows(&self, phases: &[Phase], books: &Books) -> Result<Vec<(f64, State)>> {
        let row = |(&t, phase): (&f64, &Phase)| {
            let attitude = phase.attitude()?;
            let [o1, o2, o3] = core::array::from_fn(|k| phase.l[k] / self.moments[k]);
            let omega = BodyVector::new(o1, o2, o3);
            let energy = books.energy(&attitude, omega);
            let state = State {
                attitude,
                omega,
                energy,
            };
            Ok((t, state))
        };
        self.times.iter().zip(phases).map(row).collect()
    }
}

/// Below this a motion is as good as steady, and may be leaving a place where it is unstable.
const STEADY: f64 = 0.02;

/// In a run of many steps the energy is looked at so often.
const LOOKS: f64 = 16.0;

/// A run of steps of one length tells how far it is after so many.
const PATIENCE: u64 = 65_536;

pub(super) fn longest(times: &[f64]) -> f64 {
    times.iter().fold(0.0_f64, |a, &b| a.max(b.abs()))
}
