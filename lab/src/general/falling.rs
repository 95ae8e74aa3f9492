//! Locates, between the ends of a step, where a quantity falls through zero.

use spinning_bodies::Result;
use spinning_bodies::integrators::Event;

use super::clock::{Clock, Timed, carried};

/// A quantity that may fall through zero, as a function of phase.
pub(super) struct Falling<'a, const N: usize> {
    pub event: &'a Event<'a, N>,
    pub clock: Clock,
}

impl<const N: usize> Falling<'_, N> {
    pub fn value(&self, phase: f64, y: &[f64; N]) -> f64 {
        (self.event)(self.clock.time(phase), y)
    }

    /// Whether the quantity can fall from the start on: it is positive, or zero and about to rise.
    pub fn is_armed(&self, timed: &Timed<'_, N>, start: &[f64; N]) -> bool {
        let here = self.value(0.0, start);
        here > 0.0 || here == 0.0 && self.value(PROBE, &carried(timed, (0.0, *start), PROBE)) > 0.0
    }
}

/// Step in phase of the difference that shows whether a quantity rises from zero.
const PROBE: f64 = 1e-8;

/// The zero of the event's quantity between the two ends of a step, the second of which is past it.
///
/// By secants, halving the value at an end that has stayed twice (the Illinois rule), and by bisection whenever three trials have not made the
/// bracket eight times smaller, which also copes with a start at zero, where secants are useless.
pub(super) fn falling<const N: usize>(
    crossing: &Falling<'_, N>,
    before: (f64, [f64; N]),
    after: (f64, [f64; N]),
    reach: &mut dyn FnMut((f64, [f64; N]), f64) -> Result<[f64; N]>,
) -> Result<(f64, [f64; N])> {
    let (mut low, mut high) = (before, after);
    let mut above = crossing.value(low.0, &low.1);
    let mut below = crossing.value(high.0, &high.1);
    // The ordinates of the secant: the values, or fractions of them.
    let (mut left, mut right, mut moved) = (above, below, None);
    let (mut width, mut trials) = (high.0 - low.0, 0);
    for _ in 0..MOST_TRIALS {
        let rounding = 2.0 * f64::EPSILON * high.0;
        if high.0 - low.0 <= 2.0 * rounding || below == 0.0 {
            break;
        }
        trials += 1;
        let secant = low.0 + (high.0 - low.0) * (left / (left - right));
        let slow = trials == 3 && high.0 - low.0 > 0.125 * width;
        let phase = if slow || above <= 0.0 || !secant.is_finite() {
            0.5 * (low.0 + high.0)
        } else {
            // A step beyond the zero, so that the far end approaches it as well.
            secant.clamp(low.0 + rounding, high.0 - rounding)
        };
        if trials == 3 {
            (width, trials) = (high.0 - low.0, 0);
        }
        let place = (phase, reach(before, phase)?);
        let here = crossing.value(place.0, &place.1);
        if here > 0.0 {
            if moved == Some(End::Low) {
                right *= 0.5;
            }
            (low, above, left, moved) = (place, here, here, Some(End::Low));
        } else {
            if moved == Some(End::High) {
                left *= 0.5;
            }
            (high, below, right, moved) = (place, here, here, Some(End::High));
        }
    }
    let is_nearer = above > 0.0 && above < -below;
    Ok(if is_nearer { low } else { high })
}

/// An end of the bracket.
#[derive(Clone, Copy, PartialEq)]
enum End {
    Low,
    High,
}

/// Most trials; bisection alone would need sixty.
const MOST_TRIALS: usize = 200;
