//! The equations scaled so that every component is near 1.

use core::cell::Cell;

use spinning_bodies::Result;
use spinning_bodies::integrators::{Event, Passage, System};

/// A system and its event with components in units of their scales, which are rounded to powers of two so that scaling causes no rounding.
pub(super) struct Scaled<'a, const N: usize> {
    system: &'a dyn System<N>,
    event: &'a Event<'a, N>,
    units: [f64; N],
    /// The scales, each replaced by the greatest size reached at a step if that is more.
    pub sizes: Cell<[f64; N]>,
}

impl<'a, const N: usize> Scaled<'a, N> {
    pub(super) fn new(
        system: &'a dyn System<N>,
        event: &'a Event<'a, N>,
        scales: &[f64; N],
    ) -> Self {
        let units = scales.map(|scale| power_of_two_below(scale.abs()));
        Self {
            system,
            event,
            units,
            sizes: Cell::new(*scales),
        }
    }

    pub(super) fn to_units(&self, y: &[f64; N]) -> [f64; N] {
        core::array::from_fn(|n| y[n] / self.units[n])
    }

    fn out_of_units(&self, y: &[f64; N]) -> [f64; N] {
        core::array::from_fn(|n| y[n] * self.units[n])
    }

    /// The event's quantity.
    pub(super) fn value(&self, t: f64, y: &[f64; N]) -> f64 {
        let y = self.out_of_units(y);
        let sizes = self.sizes.get();
        self.sizes
            .set(core::array::from_fn(|n| sizes[n].max(y[n].abs())));
        (self.event)(t, &y)
    }

    pub(super) fn passage(&self, passage: Passage<[f64; N]>) -> Passage<[f64; N]> {
        let states = passage.states.iter().map(|y| self.out_of_units(y));
        Passage {
            states: states.collect(),
            end: self.out_of_units(&passage.end),
            ..passage
        }
    }
}

impl<const N: usize> System<N> for Scaled<'_, N> {
    fn rate(&self, t: f64, y: &[f64; N]) -> [f64; N] {
        self.to_units(&self.system.rate(t, &self.out_of_units(y)))
    }

    fn reached(&self, time: f64) -> Result<()> {
        self.system.reached(time)
    }
}

/// The greatest power of two not above a size.
fn power_of_two_below(size: f64) -> f64 {
    const EXPONENT_BITS: u64 = 0x7ff0_0000_0000_0000;
    f64::from_bits(size.to_bits() & EXPONENT_BITS).max(f64::MIN_POSITIVE)
}
