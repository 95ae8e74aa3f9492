//! Closed forms from one event to the next.

use super::engine::{Bench, Departure, Ending, Engine, Leg, Sample, Stage};
use crate::error::Result;
use crate::integrators::Cost;
use crate::yo_yo::{Turn, TurnState, Unwinding, sleeping_spin};

/// The closed forms of a play without air.
pub(super) struct ClosedForms(pub(super) Bench);

/// Samples at the times within the duration, and the end if a time lies beyond it.
fn leg(
    (begin, times): (f64, &[f64]),
    duration: f64,
    sample: impl Fn(f64) -> Result<Sample>,
    end: impl FnOnce(f64) -> Result<Ending>,
) -> Result<Leg> {
    let since = |t: f64| (t - begin).max(0.0);
    let within = times.partition_point(|&t| since(t) < duration);
    let samples = times[..within].iter().map(|&t| sample(since(t)));
    Ok(Leg {
        samples: samples.collect::<Result<_>>()?,
        end: if within < times.len() {
            Some(end(begin + duration)?)
        } else {
            None
        },
        cost: Cost::default(),
    })
}

impl Engine for ClosedForms {
    fn leg(&self, departure: &Departure, begin: f64, times: &[f64]) -> Result<Leg> {
        let span = (begin, times);
        let Bench {
            toy,
            gravity,
            torque,
            asleep,
        } = self.0;
        let Departure {
            stage,
            energy,
            omega,
        } = *departure;
        match stage {
            Stage::Down | Stage::Up => {
                let way = Unwinding::new(toy, gravity, energy)?;
                let duration = way.duration()?;
                let sample = |t: f64| {
                    let (time, sign) = match stage {
                        Stage::Down => (t, 1.0),
                        _ => (duration - t, -1.0),
                    };
                    let depth = way.depth_at(time)?;
                    let omega = way.omega(depth);
                    Ok(Sample {
                        depth,
                        velocity: sign * way.speed(depth),
                        omega,
                        tension: toy.tension(depth, omega, gravity),
                        heat: 0.0,
                    })
                };
                let depth = match stage {
                    Stage::Down => toy.length(),
                    _ => way.top(),
                };
                let end = |time| {
                    Ok(Ending {
                        time,
                        energy,
                        omega: way.omega(depth),
                        heat: 0.0,
                    })
                };
                leg(span, duration, sample, end)
            }
            Stage::Turn | Stage::IntoSleep | Stage::OutOfSleep => {
                let turn = Turn::new(toy, gravity, omega)?;
                let half = 0.5 * turn.duration();
                let (from, duration, last) = match stage {
                    Stage::Turn => (0.0, 2.0 * half, omega),
                    Stage::IntoSleep => (0.0, half, turn.fastest()),
                    _ => (half, half, omega),
                };
                let sample = |t: f64| {
                    let TurnState {
                        omega,
                        depth,
                        velocity,
                        tension,
                        ..
                    } = turn.at(from + t)?;
                    Ok(Sample {
                        depth,
                        velocity,
                        omega,
                        tension,
                        heat: 0.0,
                    })
                };
                let end = |time| {
                    Ok(Ending {
                        time,
                        energy,
                        omega: last,
                        heat: 0.0,
                    })
                };
                leg(span, duration, sample, end)
            }
            Stage::Asleep => {
                let duration = asleep;
                let spin = |t: f64| sleeping_spin(&toy, omega, t, torque, 0.0);
                // Differences before squares.
                let heat = |now: f64| 0.5 * toy.inertia() * (omega - now) * (omega + now);
                let sample = |t: f64| {
                    let now = spin(t);
                    Ok(Sample {
                        depth: toy.length() + toy.axle(),
                        velocity: 0.0,
                        omega: now,
                        tension: toy.mass() * gravity,
                        heat: heat(now),
                    })
                };
                let end = |time| {
                    let last = spin(duration);
                    Ok(Ending {
                        time,
                        energy: energy - heat(last),
                        omega: last,
                        heat: heat(last),
                    })
                };
                leg(span, duration, sample, end)
            }
            Stage::Hanging | Stage::Caught => Ok(resting(&self.0, stage, times)),
        }
    }
}

/// For ever at the end of the string, or in the hand.
pub(super) fn resting(bench: &Bench, stage: Stage, times: &[f64]) -> Leg {
    let (depth, tension) = match stage {
        Stage::Hanging => (
            bench.toy.length() + bench.toy.axle(),
            bench.toy.mass() * bench.gravity,
        ),
        _ => (0.0, 0.0),
    };
    let sample = Sample {
        depth,
        velocity: 0.0,
        omega: 0.0,
        tension,
        heat: 0.0,
    };
    Leg {
        samples: vec![sample; times.len()],
        end: None,
        cost: Cost::default(),
    }
}
