//! Many states at once (tutorial 6.6, 6.8): equal to those of [`EulerTop::at`] to the last bit, by the same code in eight lanes.

use super::evaluation::State;
use super::motion::{EulerTop, Motion};
use crate::elliptic::lanes::fill;
use crate::error::Result;

impl EulerTop {
    /// Fills a slice with Ω, L and attitude at each of these times (s), which may be in any order; the slices have one length (6.6, 6.8).
    ///
    /// The states are those of [`at`](Self::at) to the last bit, with its domain and error. Eight times are computed side by side up to some 8·10⁶ turns from the
    /// start, unless a rate is near the ends of the range of doubles; the others one by one. Different threads may fill parts of the slices.
    ///
    /// Cost a state, relative to [`at`](Self::at) in the same run (`cargo bench -p lab --bench ensembles`), with the instructions that every processor of the
    /// family has: 0.35 where m ≤ 1/2, 0.42 where m > 1/2, 1 where Ω is constant; 1.1 for a batch of one time.
    ///
    /// # Errors
    /// [`Error::Condition`](crate::Error::Condition) if the slices differ in length; otherwise that of the first time that [`at`](Self::at) refuses, with some of the states
    /// written.
    ///
    /// ```
    /// use spinning_bodies::euler_top::{EulerTop, State};
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// let start = BodyVector::new(1.8, 0.4, -0.9);
    /// let top = EulerTop::new([0.6, 0.8, 1.0], start, Attitude::identity())?;
    /// let times: Vec<f64> = (0..100).map(|k| 0.1 * f64::from(k)).collect();
    /// let mut states = [State::default(); 100];
    /// top.states_at(&times, &mut states)?;
    /// assert_eq!(states[70], top.at(times[70])?);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn states_at(&self, times: &[f64], states: &mut [State]) -> Result<()> {
        let one = |t| self.at(t);
        match &self.motion {
            Motion::Moving(body) => fill(times, states, body.reach, one, |times, states| {
                body.side_by_side(times, states);
            }),
            Motion::Steady { .. } => fill(times, states, -1.0, one, |_, _| ()),
        }
    }
}
