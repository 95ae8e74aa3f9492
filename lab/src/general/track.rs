//! The record of a run, in times from 0 to 1.

use differential_equations::interpolate::Interpolation;
use differential_equations::prelude::ControlFlag;
use differential_equations::solout::Solout;
use differential_equations::solution::Solution as Finished;

use spinning_bodies::Result;

use super::clock::Timed;
use super::falling::Falling;

/// The record of a run: for each sample the last step before it, and the last two steps. It ends the run once the event is past.
pub(super) struct Track<'a, const N: usize> {
    timed: &'a Timed<'a, N>,
    /// The times of the samples. They are read one by one, because there may be millions and an event before the second of them.
    times: &'a [f64],
    crossing: Option<&'a Falling<'a, N>>,
    /// Times and states of the last steps before the samples.
    pub phases: Vec<f64>,
    pub states: Vec<[f64; N]>,
    pub last: (f64, [f64; N]),
    pub before: (f64, [f64; N]),
    /// Whether the quantity has been positive.
    pub armed: bool,
    /// Whether it has fallen since.
    pub fallen: bool,
    /// The result of [`System::reached`] after the last step: an error ends the run.
    pub went_on: Result<()>,
}

impl<'a, const N: usize> Track<'a, N> {
    pub fn new(
        timed: &'a Timed<'a, N>,
        times: &'a [f64],
        crossing: Option<&'a Falling<'a, N>>,
        start: (f64, [f64; N]),
    ) -> Self {
        Self {
            timed,
            times,
            crossing,
            phases: Vec::new(),
            states: Vec::new(),
            last: start,
            before: start,
            armed: false,
            fallen: false,
            went_on: Ok(()),
        }
    }
}

/// Number of parts of a step at whose ends the quantity is evaluated, lest it dip below zero within the step.
const PARTS: u32 = 8;

impl<const N: usize> Solout<f64, [f64; N]> for Track<'_, N> {
    fn solout<I>(
        &mut self,
        now: f64,
        before: f64,
        state: &[f64; N],
        state_before: &[f64; N],
        between: &mut I,
        _solution: &mut Finished<f64, [f64; N]>,
    ) -> ControlFlag<f64, [f64; N]>
    where
        I: Interpolation<f64, [f64; N]> + ?Sized,
    {
        while let Some(&time) = self.times.get(self.phases.len())
            && let phase = self.timed.clock.phase(time)
            && phase <= now
        {
            let (phase, state) = if phase < now {
                (before, state_before)
            } else {
                (now, state)
            };
            self.phases.push(phase);
            self.states.push(*state);
        }
        // The first call comes before the first step.
        let stepped = now > self.last.0;
        self.before = self.last;
        self.last = (now, *state);
        if let Some(crossing) = self.crossing
            && stepped
        {
            let here = crossing.value(now, state);
            // The first place at which the quantity has fallen: it may dip, as when a ball passes over the edge of a sheet and back.
            let mut parts = (1..PARTS).take_while(|_| self.armed);
            let dip = parts.find_map(|n| {
                let phase = before + (now - before) * f64::from(n) / f64::from(PARTS);
                let state = between.interpolate(phase).ok()?;
                (crossing.value(phase, &state) <= 0.0).then_some((phase, state))
            });
            self.last = dip.unwrap_or(self.last);
            self.fallen = dip.is_some() || self.armed && here <= 0.0;
            self.armed |= here > 0.0;
        }
        if stepped {
            let time = self.timed.clock.time(now);
            self.went_on = self.timed.system.reached(time);
        }
        if self.fallen || self.went_on.is_err() {
            ControlFlag::Terminate
        } else {
            ControlFlag::Continue
        }
    }
}
