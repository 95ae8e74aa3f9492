//! Dormand's and Prince's method of order 8 with nothing around it: arrays on the stack, equations compiled into the step.

use super::{Course, Follow, Phase, Torque, checked_moments, unit};
use crate::error::{Error, Result, finite, positive};
use crate::euler_equations::quaternion_rate;
use crate::frame::BodyVector;
use crate::integrators::order_eight::tableau::{Step, step};
use crate::integrators::real::Sums;
use crate::integrators::{Cost, Effort, Kept, Solution, System, order_eight};

/// [`order_eight`], every state at the end of a step shown to `watch` together with its time.
///
/// # Errors
/// As for [`order_eight`].
pub fn order_eight_watched<const N: usize, S: System<N> + ?Sized>(
    system: &S,
    kept: Kept,
    start: &[f64; N],
    scales: &[f64; N],
    times: &[f64],
    effort: Effort,
    watch: impl FnMut(f64, &[f64; N]),
) -> Result<Solution<N>> {
    for &t in times {
        finite("the time", t)?;
    }
    for &component in start {
        finite("the state at the start", component)?;
    }
    let pace = match effort {
        Effort::Step(step) => Pace::Fixed(positive("the step", step)?),
        Effort::Tolerance(tolerance) => Pace::Free(positive("the tolerance", tolerance)?),
    };
    let mut states = vec![*start; times.len()];
    let mut cost = Cost::default();
    let mut walk = Walk {
        system,
        kept,
        scales,
        cost: &mut cost,
        watch,
    };
    if let &[time] = times {
        states[0] = walk.legs(start, [time], pace, |_, _| {})?;
    } else {
        let mut order: Vec<usize> = (0..times.len()).collect();
        order.sort_by(|&i, &j| times[i].total_cmp(&times[j]));
        let (before, after) = order.split_at(order.partition_point(|&i| times[i] < 0.0));
        let ends = before.iter().rev().map(|&i| times[i]);
        walk.legs(start, ends, pace, |n, state| {
            states[before[before.len() - 1 - n]] = *state;
        })?;
        let ends = after.iter().map(|&i| times[i]);
        walk.legs(start, ends, pace, |n, state| states[after[n]] = *state)?;
    }
    Ok(Solution { states, cost })
}

#[derive(Clone, Copy)]
enum Pace {
    Fixed(f64),
    Free(f64),
}

/// Most steps of one run; about a minute of computing.
const MOST_STEPS: u64 = 200_000_000;

struct Walk<'a, const N: usize, S: ?Sized, W> {
    system: &'a S,
    kept: Kept,
    scales: &'a [f64; N],
    cost: &'a mut Cost,
    watch: W,
}

/// Where a run is.
struct Place<const N: usize> {
    state: Sums<f64, N>,
    time: Sums<f64, 1>,
    /// The rate here.
    rate: [f64; N],
}

impl<const N: usize> Place<N> {
    /// From here to that time; with what rounding has left of the time so far.
    fn until(&self, end: f64) -> f64 {
        (end - self.time.values[0]) - self.time.left[0]
    }
}

impl<const N: usize, S: System<N> + ?Sized, W: FnMut(f64, &[f64; N])> Walk<'_, N, S, W> {
    /// One leg after the other, all in one direction; the last state.
    fn legs(
        &mut self,
        start: &[f64; N],
        ends: impl IntoIterator<Item = f64>,
        pace: Pace,
        mut arrived: impl FnMut(usize, &[f64; N]),
    ) -> Result<[f64; N]> {
        let mut place = Place {
            state: Sums::new(*start),
            time: Sums::new([0.0]),
            rate: self.system.rate(0.0, start),
        };
        self.cost.evaluations += 1;
        // Length of the next step, 0 before there is one.
        let mut length = 0.0;
        for (n, end) in ends.into_iter().enumerate() {
            match pace {
                Pace::Fixed(longest) => self.even(&mut place, end, longest)?,
                Pace::Free(tolerance) => {
                    if length == 0.0 && end != 0.0 {
                        length = self.first_length(&place, end, tolerance);
                    }
                    length = self.free(&mut place, end, tolerance, length)?;
                }
            }
            for component in place.state.values {
                finite("the state after integration", component)?;
            }
            arrived(n, &place.state.values);
        }
        Ok(place.state.values)
    }

    /// Steps of one length, not above the longest.
    fn even(&mut self, place: &mut Place<N>, end: f64, longest: f64) -> Result<()> {
        let leg = place.until(end);
        let count = (leg.abs() / longest).ceil();
        if count > MOST_STEPS as f64 {
            return Err(too_many(place.time.values[0]));
        }
        let h = leg / count.max(1.0);
        for _ in 0..count as u64 {
            let taken = step(
                self.system,
                place.time.values[0],
                &place.state.values,
                &place.rate,
                h,
            );
            self.accept(place, &taken, h);
            self.system.reached(place.time.values[0])?;
        }
        place.time = Sums::new([end]);
        Ok(())
    }

    /// Steps as long as the tolerance allows, the first one of this length; the length that the next one may have.
    fn free(
        &mut self,
        place: &mut Place<N>,
        end: f64,
        tolerance: f64,
        mut length: f64,
    ) -> Result<f64> {
        let sense = if place.until(end) < 0.0 { -1.0 } else { 1.0 };
        let mut most_growth = MOST_GROWTH;
        loop {
            let left = place.until(end);
            if left * sense <= 0.0 {
                return Ok(length);
            }
            // The last two steps share what is left: no crumb at the end.
            let cut = if left.abs() <= length {
                left
            } else if left.abs() < 2.0 * length {
                0.5 * left
            } else {
                length * sense
            };
            let time = place.time.values[0];
            let taken = step(self.system, time, &place.state.values, &place.rate, cut);
            let error = taken.error(&place.state.values, self.scales, tolerance, cut);
            // error^(1/8), as DOP853 has it.
            let root = error.sqrt().sqrt().sqrt();
            let growth = SAFETY / root;
            if error <= 1.0 {
                self.accept(place, &taken, cut);
                if cut == left {
                    // What is left of the time now is rounding, not worth a step.
                    place.time = Sums::new([end]);
                }
                self.system.reached(time + cut)?;
                if self.cost.steps > MOST_STEPS {
                    return Err(too_many(time));
                }
                let next = cut.abs() * growth.clamp(LEAST_GROWTH, most_growth);
                // A step cut short by a sample does not shorten those after it.
                length = if cut.abs() < length && growth >= 1.0 {
                    next.max(length)
                } else {
                    next
                };
                most_growth = MOST_GROWTH;
            } else {
                self.cost.evaluations += STAGES - 1;
                // Not a number: as far off as can be.
                let shrink = if growth > LEAST_GROWTH {
                    growth
                } else {
                    LEAST_GROWTH
                };
                length = cut.abs() * shrink;
                most_growth = 1.0;
                if length <= f64::EPSILON * time.abs() || length == 0.0 || !length.is_finite() {
                    return Err(Error::Integration {
                        reason: "the step became too small: the tolerance is below rounding, or the motion is not finite",
                        time,
                    });
                }
            }
        }
    }

    fn accept(&mut self, place: &mut Place<N>, taken: &Step<N>, h: f64) {
        place.state.add_all(taken.change);
        if let Kept::UnitQuaternion(first) = self.kept
            && let Some(&[w, x, y, z]) = place.state.values[first.min(N)..].first_chunk()
        {
            // 1/|q| - 1, from 1 - |q|².
            let square = w * w + x * x + y * y + z * z;
            let excess = (1.0 - square) / (square + square.sqrt());
            for (n, component) in [w, x, y, z].into_iter().enumerate() {
                place.state.add(first + n, component * excess);
            }
        }
        place.time.add(0, h);
        place.rate = self.system.rate(place.time.values[0], &place.state.values);
        self.cost.evaluations += STAGES;
        self.cost.steps += 1;
        (self.watch)(place.time.values[0], &place.state.values);
    }

    /// A first guess at the length of a step: rates and their change over a short Euler step (Hairer, Nørsett, Wanner, II.4).
    fn first_length(&mut self, place: &Place<N>, end: f64, tolerance: f64) -> f64 {
        let span = place.until(end);
        let size = |v: &[f64; N]| {
            let weighted = |n: usize| v[n] / (place.state.values[n].abs() + self.scales[n]);
            let squares: f64 = (0..N).map(|n| weighted(n) * weighted(n)).sum();
            (squares / N as f64).sqrt()
        };
        let rate = size(&place.rate);
        let short = (0.01 / rate).min(span.abs());
        let h = short.copysign(span);
        let moved = core::array::from_fn(|n| place.state.values[n] + h * place.rate[n]);
        let there = self.system.rate(place.time.values[0] + h, &moved);
        self.cost.evaluations += 1;
        let bend = size(&core::array::from_fn(|n| there[n] - place.rate[n])) / short;
        // From the first derivative's size for the part of a body at rest, the second's square root being a rate as well.
        let pace = rate.max(bend.sqrt());
        let length = (tolerance.min(1.0)).sqrt().sqrt().sqrt() * FIRST / pace;
        if length.is_finite() && length > 0.0 {
            length.min(span.abs())
        } else {
            span.abs()
        }
    }
}

/// Length of the first step as a multiple of tolerance^(1/8) over the rate.
const FIRST: f64 = 4.0;
/// Those of DOP853.
const SAFETY: f64 = 0.9;
const LEAST_GROWTH: f64 = 1.0 / 3.0;
const MOST_GROWTH: f64 = 6.0;
const STAGES: u64 = 12;

fn too_many(time: f64) -> Error {
    Error::Integration {
        reason: "it takes more than two hundred million steps",
        time,
    }
}

/// [`order_eight`] for a turning body under a torque: L and the attitude's quaternion, which keeps norm 1.
///
/// Explicit, neither symmetric nor symplectic: energy and L drift like the error, in proportion to the time. With [`Effort::Tolerance`] the
/// error of a step is judged relative to |L| and in the quaternion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DormandPrince8<N> {
    inverse: [f64; 3],
    /// (I₂ − I₃)/(I₂I₃) and so on: L₁′ is this times L₂L₃, nearly equal moments lose nothing.
    difference: [f64; 3],
    torque: N,
}

impl<N> DormandPrince8<N> {
    /// For the body with these moments under this torque.
    ///
    /// # Errors
    /// Those of the moments.
    pub fn new(moments: [f64; 3], torque: N) -> Result<Self> {
        let moments = checked_moments(moments)?;
        Ok(Self {
            inverse: moments.map(|moment| 1.0 / moment),
            difference: core::array::from_fn(|k| {
                let (a, b) = (moments[(k + 1) % 3], moments[(k + 2) % 3]);
                (a - b) / a / b
            }),
            torque,
        })
    }
}

impl<N: Torque<f64>> System<7> for DormandPrince8<N> {
    /// L′ = L∧Ω + N and q′ = ½qΩ.
    #[inline(always)]
    fn rate(&self, _: f64, y: &[f64; 7]) -> [f64; 7] {
        let [a, b, c, w, x, y, z] = *y;
        let phase = Phase {
            l: [a, b, c],
            q: [w, x, y, z],
        };
        let [d1, d2, d3] = self.difference;
        let [j1, j2, j3] = self.inverse;
        let mut n = [d1 * (b * c), d2 * (c * a), d3 * (a * b)];
        if N::ACTS {
            let torque = self.torque.torque(&phase);
            n = core::array::from_fn(|k| n[k] + torque[k]);
        }
        let omega = BodyVector::new(j1 * a, j2 * b, j3 * c);
        let [qw, qx, qy, qz] = quaternion_rate(phase.q, omega);
        [n[0], n[1], n[2], qw, qx, qy, qz]
    }
}

impl<N: Torque<f64>> Follow for DormandPrince8<N> {
    fn name(&self) -> String {
        "dormand-prince-8".to_owned()
    }

    fn order(&self) -> Option<u32> {
        Some(8)
    }

    fn follow(&self, start: &Phase, times: &[f64], effort: Effort) -> Result<Course> {
        start.check()?;
        let ([a, b, c], [w, x, y, z]) = (start.l, unit(start.q));
        let size = (a * a + b * b + c * c).sqrt().max(f64::MIN_POSITIVE);
        let scales = [size, size, size, 1.0, 1.0, 1.0, 1.0];
        let packed = [a, b, c, w, x, y, z];
        let kept = Kept::UnitQuaternion(3);
        let run = order_eight(self, kept, &packed, &scales, times, effort)?;
        let phases = run.states.iter().map(|&[a, b, c, w, x, y, z]| Phase {
            l: [a, b, c],
            q: unit([w, x, y, z]),
        });
        Ok(Course {
            phases: phases.collect(),
            cost: run.cost,
        })
    }
}
