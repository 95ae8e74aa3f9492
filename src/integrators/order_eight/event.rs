//! Where within a step a quantity falls through zero.

use super::tableau::Between;
use super::walk::{Taken, Walk};
use crate::integrators::{Event, System};

/// A quantity that may fall through zero.
pub(super) struct Watch<'a, const N: usize> {
    event: &'a dyn Event<N>,
    /// Its value at the end of the last step; it can fall once it has been positive.
    value: f64,
    armed: bool,
}

/// A very short while, as a part of a step.
const PROBE: f64 = 1e-8;
/// Rounds of the search on the polynomial, and of Newton's on true states. Halving alone would need sixty of the first; four of the second are
/// the most that were seen.
const MOST_ROUNDS: usize = 100;
const NEWTON: usize = 8;

impl<'a, const N: usize> Watch<'a, N> {
    pub fn new<S: System<N> + ?Sized>(event: &'a dyn Event<N>, walk: &Walk<'_, N, S>) -> Self {
        let (time, state) = walk.leg.start;
        let value = event.value(time, state);
        let probe = PROBE * walk.left();
        let soon = core::array::from_fn(|n| state[n] + probe * walk.rate[n]);
        let rises = || event.value(time + probe, &soon) > 0.0;
        Self {
            event,
            value,
            armed: value > 0.0 || value == 0.0 && rises(),
        }
    }

    /// When within the step just taken the quantity falls through zero, if it does, and with which state.
    pub fn fall<S: System<N> + ?Sized>(
        &mut self,
        walk: &mut Walk<'_, N, S>,
        taken: &Taken<N>,
    ) -> Option<(f64, [f64; N])> {
        let before = self.value;
        let now = self.event.value(walk.time.values[0], &walk.state.values);
        self.value = now;
        if !self.armed {
            self.armed = now > 0.0;
            return None;
        }
        if now > 0.0 {
            // The cubic through both ends costs nothing; where nothing on it comes down to half the lower end, nothing dips.
            let (cubic, low) = (walk.cubic(taken), 0.5 * before.min(now));
            if LOOKS
                .iter()
                .all(|&part| self.value_at(taken, &cubic, part) > low)
            {
                return None;
            }
        }
        let between = walk.between(taken);
        let mut inner = (1..PLACES).map(|n| f64::from(n) / f64::from(PLACES));
        let dips = inner.find(|&part| self.value_at(taken, &between, part) <= 0.0);
        // The first place at which it is no longer positive, or the end.
        let part = dips.or((now <= 0.0).then_some(1.0))?;
        Some(self.located(walk, taken, &between, part))
    }

    fn value_at(&self, taken: &Taken<N>, between: &Between<N>, part: f64) -> f64 {
        self.event.value(taken.at(part), &between.at(part))
    }

    /// When and with which state the quantity is zero, between the beginning of a step and this part of it: once a run at most.
    #[cold]
    fn located<S: System<N> + ?Sized>(
        &self,
        walk: &mut Walk<'_, N, S>,
        taken: &Taken<N>,
        between: &Between<N>,
        until: f64,
    ) -> (f64, [f64; N]) {
        let reach = [until - 1.0 / f64::from(PLACES), until];
        let mut part = self.on_the_polynomial(between, taken, reach);
        let mut state = walk.short(taken, part * taken.length);
        for _ in 0..NEWTON {
            let here = self.event.value(taken.at(part), &state);
            let rate = walk.leg.system.rate(taken.at(part), &state);
            walk.cost.evaluations += 1;
            // Towards the beginning: there the quantity has not fallen yet.
            let h = -PROBE * taken.length;
            let moved = core::array::from_fn(|n| state[n] + h * rate[n]);
            let slope = (here - self.event.value(taken.at(part) + h, &moved)) / PROBE;
            let next = (part - here / slope).clamp(reach[0], until);
            let gain = (next - part).abs() * taken.length.abs();
            let falls = slope < 0.0;
            let done = gain.is_nan() || gain <= f64::EPSILON * taken.at(part).abs();
            if here == 0.0 || !falls || done {
                break;
            }
            part = next;
            state = walk.short(taken, part * taken.length);
            if gain <= SMALL * taken.length.abs() {
                break;
            }
        }
        (taken.at(part), state)
    }

    /// By secants within an enclosure, the value at an end that stays twice halved (the Illinois rule), and halving where that is slow.
    fn on_the_polynomial(
        &self,
        between: &Between<N>,
        taken: &Taken<N>,
        [mut low, mut high]: [f64; 2],
    ) -> f64 {
        let value = |part: f64| self.value_at(taken, between, part);
        let (mut above, mut below) = (value(low), value(high));
        let mut last = 0;
        for round in 0..MOST_ROUNDS {
            if high - low <= 4.0 * f64::EPSILON * high || below == 0.0 {
                break;
            }
            let secant = low + (high - low) * (above / (above - below));
            let part = if round % 4 == 3 || above <= 0.0 || !(secant > low && secant < high) {
                0.5 * (low + high)
            } else {
                secant
            };
            let here = value(part);
            if here > 0.0 {
                (low, above) = (part, here);
                below *= if last == 1 { 0.5 } else { 1.0 };
                last = 1;
            } else {
                (high, below) = (part, here);
                above *= if last == -1 { 0.5 } else { 1.0 };
                last = -1;
            }
        }
        high
    }
}

/// Places at which every step is looked at: a parabola that is below zero somewhere between is below half of its lower end at one of them, if it is below
/// zero at any of those at which a step that may have dipped is looked at.
const LOOKS: [f64; 4] = [0.0625, 0.25, 0.75, 0.9375];
/// Parts of such a step.
const PLACES: u32 = 16;
/// Newton's method doubles the digits: after a correction this small, as a part of a step, nothing is left to correct.
const SMALL: f64 = 1e-9;
