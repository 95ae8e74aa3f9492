//! Bodies from scratch to one time: prepared and moved in one go, and forgotten.

use super::beginning::Beginnings;
use super::constants::{Circular, Hyperbolic, Steady};
use super::lanes::{Motion, Rows, Work};
use super::release::{Release, Sorted, Way};
use super::{BODIES, Rowing, same_length};
use crate::error::{Error, Result};
use crate::euler_top::motion::{EulerTop, State};

/// The body at a place, or what is wrong with it there.
pub(super) fn prepared_at(releases: &[Release], place: usize) -> Result<EulerTop> {
    releases[place].top().map_err(|reason| Error::AtPlace {
        place,
        reason: Box::new(reason),
    })
}

/// Ω, L and attitude of bodies let go at time 0, at one time t (s) after that or before, in the order of the bodies (6.6, 6.8).
///
/// For a single step of a larger simulation: nothing is kept for another time, and nothing is allocated a body. Eight bodies of one kind (Ω stays,
/// m ≤ 1/2, m > 1/2) go side by side from their moments and L: m or mc, whichever is the lesser, from sums of terms of one
/// sign; Gauss's transformation; the rate and the turn about L from theta functions of the smaller nome, in two words each; then the
/// state. Which kind a body is, exact differences decide.
///
/// Domain: that of [`EulerTop::new`] and [`EulerTop::at`]. One by one go rods, bodies at rest, moments or components of L more than a factor
/// of 2¹⁰⁰ apart or beyond 10^±120, and all eight if one of them has turned some 8·10⁶ times.
///
/// Error: that of a body at a time; the states differ by no more than 1.1e-15 in the quaternion (5 ε), 5.1e-16 in L and 5.5e-16 in Ω, observed over
/// 5000 bodies at five times, among them rackets, symmetric bodies, spheres and both neighbourhoods of the separatrix down to one
/// unit in the last place. Against the references of 32 digits: attitude 1e-15 rad.
///
/// Cost: 0.21 of [`EulerTop::new`] and one [`EulerTop::at`] for each of a hundred bodies or a thousand, 0.23 for spheres, 0.23 to 0.25 for rackets
/// next to the separatrix, in one run with those (`cargo bench -p lab --bench ensembles`), with the instructions every processor of the kind has. Parts of the slices may be filled by different threads.
///
/// # Errors
/// [`Error::Condition`] if there is not one place for each body; [`Error::AtPlace`] with the place of a body that is refused; that of
/// [`EulerTop::at`] for a time that it refuses. The states may then be partly written.
///
/// ```
/// use spinning_bodies::euler_top::{EulerTop, Release, State, released_states};
/// use spinning_bodies::frame::{Attitude, BodyVector};
/// let body = Release {
///     moments: [0.6, 0.8, 1.0],
///     angular_momentum: BodyVector::new(1.8, 0.4, -0.9),
///     attitude: Attitude::identity(),
/// };
/// let mut states = [State::default(); 20];
/// released_states(&[body; 20], 0.1, &mut states)?;
/// let alone = EulerTop::new(body.moments, body.angular_momentum, body.attitude)?.at(0.1)?;
/// assert!(states[7].attitude.angle_to(&alone.attitude) < 2e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn released_states(releases: &[Release], t: f64, states: &mut [State]) -> Result<()> {
    same_length(releases.len(), states.len())?;
    let mut steady = Waiting::new(Steady::zero(), |rows, motion, _| rows.steady(motion));
    let mut circular = Waiting::new(Circular::zero(), Beginnings::circular);
    let mut hyperbolic = Waiting::new(Hyperbolic::zero(), Beginnings::hyperbolic);
    for (place, release) in releases.iter().enumerate() {
        let sorted = release.sorted(place);
        match sorted.way {
            Way::Single => states[place] = prepared_at(releases, place)?.at(t)?,
            Way::Steady => steady.join(sorted, releases, t, states)?,
            Way::Circular => circular.join(sorted, releases, t, states)?,
            Way::Hyperbolic => hyperbolic.join(sorted, releases, t, states)?,
        }
    }
    steady.go(releases, t, states)?;
    circular.go(releases, t, states)?;
    hyperbolic.go(releases, t, states)
}

/// How a kind of motion is prepared for eight bodies; up to which time it holds.
type Prepare<M> = fn(&Beginnings<BODIES>, &mut M, &mut Work<BODIES>) -> f64;

/// Bodies of one kind that wait until there are enough of them to go side by side.
struct Waiting<M> {
    bodies: Vec<Sorted>,
    motion: M,
    prepare: Prepare<M>,
    work: Work<BODIES>,
    rows: Rows<BODIES>,
}

impl<M: Motion> Waiting<M> {
    fn new(motion: M, prepare: Prepare<M>) -> Self {
        Self {
            bodies: Vec::with_capacity(BODIES),
            motion,
            prepare,
            work: Work::new(),
            rows: Rows::zero(),
        }
    }

    fn join(
        &mut self,
        body: Sorted,
        releases: &[Release],
        t: f64,
        states: &mut [State],
    ) -> Result<()> {
        self.bodies.push(body);
        if self.bodies.len() < BODIES {
            return Ok(());
        }
        self.go(releases, t, states)
    }

    /// Those who wait; the last is repeated where there are too few.
    fn go(&mut self, releases: &[Release], t: f64, states: &mut [State]) -> Result<()> {
        let Some(last) = self.bodies.len().checked_sub(1) else {
            return Ok(());
        };
        let bodies: [&Sorted; BODIES] = core::array::from_fn(|i| &self.bodies[i.min(last)]);
        let beginnings = Beginnings::gather(releases, bodies);
        let reach = (self.prepare)(&beginnings, &mut self.motion, &mut self.work);
        if t.abs() <= reach {
            self.motion.at(&[t; BODIES], &mut self.work, &mut self.rows);
            for (i, body) in self.bodies.iter().enumerate() {
                states[body.place] = self.rows.one(i, Rowing::new(body.axes.axis));
            }
        } else {
            for body in &self.bodies {
                states[body.place] = releases[body.place].top()?.at(t)?;
            }
        }
        self.bodies.clear();
        Ok(())
    }
}
