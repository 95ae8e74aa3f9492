//! Methods for any equations, those of the crate `differential-equations`: systems of N equations, samples at given times, events.
//!
//! The library itself has only order 8 and the methods for bodies; the general methods serve to judge them, and are passed to a scene in its request as
//! [`DifferentialEquations`].
//!
//! * this file: the interface to scenes;
//! * `run`: the crate's loop with one of its methods, and the short steps to samples and events;
//! * `clock`: the equations with time rescaled to 0 … 1;
//! * `track`: the record of a run;
//! * `falling`: the location of an event between two steps;
//! * `scaled`: the equations scaled so that every component is near 1;
//! * `body`: the motion of a body by such a method.

mod body;
mod clock;
mod falling;
mod run;
mod scaled;
mod track;

use spinning_bodies::integrators::{AnyLeg, Effort, GeneralMethods, Method, Passage, System};
use spinning_bodies::{Error, Result};

pub use body::{GeneralMethod, order};
pub use run::Run;

/// The methods of the crate `differential-equations`, for scenes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DifferentialEquations;

impl GeneralMethods for DifferentialEquations {
    fn follow(
        &self,
        method: Method,
        leg: &AnyLeg<'_>,
        effort: Effort,
    ) -> Result<Passage<Vec<f64>>> {
        match leg.start.1.len() {
            ..=7 => sized::<7>(method, leg, effort),
            8..=12 => sized::<12>(method, leg, effort),
            count => Err(Error::Condition {
                condition: "the general methods are compiled for at most 12 numbers",
                value: count as f64,
            }),
        }
    }
}

/// The passage in N components, those beyond the leg's own being zero: each further N would take a second to compile.
fn sized<const N: usize>(
    method: Method,
    leg: &AnyLeg<'_>,
    effort: Effort,
) -> Result<Passage<Vec<f64>>> {
    struct Slices<'a, 'b, const N: usize>(&'a AnyLeg<'b>);
    impl<const N: usize> System<N> for Slices<'_, '_, N> {
        fn rate(&self, t: f64, y: &[f64; N]) -> [f64; N] {
            let (count, mut rate) = (self.0.start.1.len(), [0.0; N]);
            (self.0.rate)(t, &y[..count], &mut rate[..count]);
            rate
        }

        fn reached(&self, time: f64) -> Result<()> {
            (self.0.reached)(time)
        }
    }
    let of = |slice: &[f64], rest| core::array::from_fn(|n| slice.get(n).copied().unwrap_or(rest));
    let (time, start, count) = (leg.start.0, of(leg.start.1, 0.0), leg.start.1.len());
    let effort = match (method, effort) {
        // These take the mean square over all components.
        (Method::Dopri5 | Method::Dop853, Effort::Tolerance(tolerance)) => {
            Effort::Tolerance(tolerance * (count as f64 / N as f64).sqrt())
        }
        _ => effort,
    };
    let margin = |t: f64, y: &[f64; N]| leg.event.map_or(1.0, |event| event(t, &y[..count]));
    let passage = Run::new(&Slices::<N>(leg), &of(leg.scales, 1.0), method, effort)
        .until(time, &start, leg.times, leg.end, &margin)?;
    let own = |y: &[f64; N]| y[..count].to_vec();
    Ok(Passage {
        states: passage.states.iter().map(own).collect(),
        time: passage.time,
        end: own(&passage.end),
        stopped: passage.stopped,
        cost: passage.cost,
    })
}
