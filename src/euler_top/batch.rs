//! Many states at once (tutorial 6.6, 6.8): those of [`EulerTop::at`] to the last bit, by eight lanes of the same code.

use super::evaluation::State;
use super::motion::{EulerTop, Motion};
use crate::elliptic::lanes::fill;
use crate::error::Result;

impl EulerTop {
    /// Ω, L and attitude at each of these times (s), in any order, into a slice of the same length (6.6, 6.8).
    ///
    /// The states of [`at`](Self::at) to the last bit, and so its domain and error: eight times go side by side up to some 8·10⁶ turns from the start, and where
    /// no rate is at the ends of the doubles; one by one what lies beyond. Parts of the slices may be filled by different threads.
    ///
    /// Cost: beside [`at`](Self::at) in the same run (`cargo bench -p lab --bench ensembles`), with the instructions every processor of the kind
    /// has: 0.35 of the time a state where m ≤ 1/2, 0.42 where m > 1/2, the same where Ω stays; 1.1 for a batch of one time.
    ///
    /// # Errors
    /// [`Error::Condition`](crate::Error::Condition) if the slices differ in length; otherwise that of the first time that [`at`](Self::at) refuses, the states being partly
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
