//! Where within a step the quantity of an event falls through zero.

use core::convert::Infallible;

use super::tableau::{Between, Step, sum};
use super::walk::Walk;
use crate::integrators::{Event, System};
use crate::search::halved;

/// The quantity of an event along a run.
pub(super) struct Watch<'a, const N: usize> {
    event: &'a Event<'a, N>,
    /// Its value at the end of the last step. A fall counts only once it has been positive.
    value: f64,
    armed: bool,
}

/// The time step of a difference quotient, as a fraction of a step.
const PROBE: f64 = 1e-8;
/// Most rounds of Newton's method on true states; at most four were observed.
const NEWTON: usize = 8;

impl<'a, const N: usize> Watch<'a, N> {
    pub fn new<S: System<N> + ?Sized>(event: &'a Event<'a, N>, walk: &Walk<'_, N, S>) -> Self {
        let (time, state) = walk.leg.start;
        let value = event(time, state);
        let probe = PROBE * walk.length * walk.sense;
        let soon = sum([1.0, probe], [state, &walk.rate]);
        Self {
            event,
            value,
            armed: value > 0.0 || value == 0.0 && event(time + probe, &soon) > 0.0,
        }
    }

    /// Time and state at which the quantity falls through zero within the step just taken, if it does.
    pub fn fall<S: System<N> + ?Sized>(
        &mut self,
        walk: &mut Walk<'_, N, S>,
        taken: &Step<N>,
    ) -> Option<(f64, [f64; N])> {
        let before = self.value;
        let now = (self.event)(walk.time.values[0], &walk.state.values);
        self.value = now;
        if self.armed == (now > 0.0) {
            // The cubic through both ends costs no evaluation. Where it stays above half the lower end value, the quantity has no dip. One that has not
            // been positive yet may rise and fall again: that is a dip of its negative.
            let sign = if self.armed { 1.0 } else { -1.0 };
            let low = 0.5 * (sign * before).min(sign * now);
            let cubic = Between::cubic(taken, &walk.rate);
            let stays = |&part: &f64| sign * self.value_at(taken, &cubic, part) >= low;
            if LOOKS.iter().all(stays) {
                return None;
            }
        }
        let between = walk.between(taken);
        let mut inner = (1..PLACES).map(|n| f64::from(n) / f64::from(PLACES));
        let mut armed = self.armed;
        let falls = inner.find(|&part| {
            let value = self.value_at(taken, &between, part);
            armed |= value > 0.0;
            armed && value <= 0.0
        });
        self.armed = armed || now > 0.0;
        // The first place at which the quantity is no longer positive, or the end.
        let part = falls.or((armed && now <= 0.0).then_some(1.0))?;
        Some(self.located(walk, taken, &between, part))
    }

    fn value_at(&self, taken: &Step<N>, between: &Between<N>, part: f64) -> f64 {
        (self.event)(taken.at(part), &between.at(part))
    }

    /// Time and state at which the quantity is zero, in the sixteenth of the step that ends at `until`. Called at most once in a run.
    #[cold]
    fn located<S: System<N> + ?Sized>(
        &self,
        walk: &mut Walk<'_, N, S>,
        taken: &Step<N>,
        between: &Between<N>,
        until: f64,
    ) -> (f64, [f64; N]) {
        let reach = [until - 1.0 / f64::from(PLACES), until];
        let above = |part| Ok::<_, Infallible>(self.value_at(taken, between, part) > 0.0);
        let Ok([_, mut part]) = halved(reach, 4.0 * f64::EPSILON * until, above);
        let mut state = walk.short(taken, part * taken.length);
        for _ in 0..NEWTON {
            let here = (self.event)(taken.at(part), &state);
            let rate = walk.leg.system.rate(taken.at(part), &state);
            walk.cost.evaluations += 1;
            // A difference towards the beginning of the step, where the quantity has not fallen yet.
            let h = -PROBE * taken.length;
            let moved = sum([1.0, h], [&state, &rate]);
            let slope = (here - (self.event)(taken.at(part) + h, &moved)) / PROBE;
            let next = (part - here / slope).clamp(reach[0], until);
            let gain = (next - part).abs() * taken.length.abs();
            let done = gain.is_nan() || gain <= f64::EPSILON * taken.at(part).abs();
            if here == 0.0 || slope >= 0.0 || done {
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
}

/// Places at which the cubic of every step is evaluated. A parabola that is positive at both ends and negative at any multiple of 1/[`PLACES`]
/// is below half of its lower end value at one of these.
const LOOKS: [f64; 4] = [0.0625, 0.25, 0.75, 0.9375];
/// Number of parts into which a closer look divides a step.
const PLACES: u32 = 16;
/// Newton's method doubles the digits: after a correction this small, as a fraction of the step, no further one is needed.
const SMALL: f64 = 1e-9;
