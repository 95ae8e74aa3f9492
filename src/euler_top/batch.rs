//! Many states at once: one body at many times, or many bodies at one (tutorial 6.6, 6.8).
//!
//! The states of [`EulerTop::at`] to the last bit: for times, eight lanes of the same code.

use super::evaluation::State;
use super::motion::{EulerTop, Motion};
use crate::elliptic::lanes::fill;
use crate::error::{Error, Result, same_length};
use crate::frame::{Attitude, BodyVector};

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
    /// [`Error::Condition`] if the slices differ in length; otherwise that of the first time that [`at`](Self::at) refuses, the states being partly
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

/// A free body as it is let go at time 0: what [`EulerTop::new`] asks for, not prepared for any later time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Release {
    /// Principal moments, kg m², in any order.
    pub moments: [f64; 3],
    /// L along the principal axes, kg m²/s.
    pub angular_momentum: BodyVector,
    /// How the body stands in space.
    pub attitude: Attitude,
}

/// The body at a place, or what is wrong with it there.
fn prepared((place, release): (usize, &Release)) -> Result<EulerTop> {
    let Release {
        moments,
        angular_momentum,
        attitude,
    } = *release;
    EulerTop::new(moments, angular_momentum, attitude).map_err(|reason| Error::AtPlace {
        place,
        reason: Box::new(reason),
    })
}

/// Ω, L and attitude of bodies let go at time 0, at one time t (s) after that or before, in the order of the bodies (6.6, 6.8).
///
/// For a single step of a larger simulation: nothing is kept for another time. The states are those of [`EulerTop::new`] and [`EulerTop::at`] to the last
/// bit, and so is the cost; [`EulerTop::for_one_step`] costs less. Parts of the slices may be filled by different
/// threads.
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
/// assert_eq!(states[7], alone);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn released_states(releases: &[Release], t: f64, states: &mut [State]) -> Result<()> {
    same_length(releases.len(), states.len())?;
    for (release, state) in releases.iter().enumerate().zip(states) {
        *state = prepared(release)?.at(t)?;
    }
    Ok(())
}

/// Many free bodies, asked at one time (6.6, 6.8).
///
/// ```
/// use spinning_bodies::euler_top::{Ensemble, EulerTop, State};
/// use spinning_bodies::frame::{Attitude, BodyVector};
/// // Rackets, tossed ever more nearly about the middle axis.
/// let rackets = (0..20)
///     .map(|k| {
///         let tilt = 10f64.powi(-k);
///         EulerTop::new([1.0, 2.0, 3.0], BodyVector::new(tilt, 1.0, tilt), Attitude::identity())
///     })
///     .collect::<Result<Vec<_>, _>>()?;
/// let ensemble = Ensemble::new(rackets);
/// let mut states = [State::default(); 20];
/// ensemble.states_at(50.0, &mut states)?;
/// assert_eq!(states[19], ensemble.tops()[19].at(50.0)?);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Ensemble {
    tops: Vec<EulerTop>,
}

impl Ensemble {
    /// These bodies. Nothing is prepared anew: 1 kB a body.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::{Ensemble, EulerTop}, frame::{Attitude, BodyVector}};
    /// let omega = BodyVector::new(0.01, 1.0, 0.01);
    /// let top = EulerTop::from_omega([1.0, 2.0, 3.0], omega, Attitude::identity())?;
    /// assert_eq!(Ensemble::new(vec![top; 3]).tops().len(), 3);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(tops: Vec<EulerTop>) -> Self {
        Self { tops }
    }

    /// Bodies from scratch: what [`EulerTop::new`] makes of each (6.6, 6.8).
    ///
    /// # Errors
    /// [`Error::AtPlace`]: which body [`EulerTop::new`] refuses, the first of them, and why.
    ///
    /// ```
    /// use spinning_bodies::euler_top::{Ensemble, Release, State};
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// let gas = (1..=100).map(|k| Release {
    ///     moments: [1.0, 2.0, 2.5],
    ///     angular_momentum: BodyVector::new(1.0, 0.01 * f64::from(k), 0.5),
    ///     attitude: Attitude::identity(),
    /// });
    /// let gas = Ensemble::released(gas.collect())?;
    /// let mut states = [State::default(); 100];
    /// gas.states_at(3.0, &mut states)?;
    /// assert_eq!(states[99], gas.tops()[99].at(3.0)?);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn released(releases: Vec<Release>) -> Result<Self> {
        let tops: Result<Vec<_>> = releases.iter().enumerate().map(prepared).collect();
        Ok(Self::new(tops?))
    }

    /// The bodies, in the order they were given.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::{Ensemble, EulerTop}, frame::{Attitude, BodyVector}};
    /// let omega = BodyVector::new(0.01, 1.0, 0.01);
    /// let top = EulerTop::from_omega([1.0, 2.0, 3.0], omega, Attitude::identity())?;
    /// let period = top.period();
    /// assert_eq!(Ensemble::new(vec![top]).tops()[0].period(), period);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn tops(&self) -> &[EulerTop] {
        &self.tops
    }

    /// Ω, L and attitude of every body at time t (s), in the order of the bodies (6.6, 6.8).
    ///
    /// Domain and error: those of [`EulerTop::at`], whose states they are to the last bit, and whose cost. (Side by side, bodies would have to be
    /// fetched eight at a time: as soon as they no longer fit the nearer caches, that costs more than it saves.)
    ///
    /// # Errors
    /// [`Error::Condition`] if there is not one place for each body; that of the first body whose [`EulerTop::at`]
    /// refuses the time, the states being partly written.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::{Ensemble, EulerTop}, frame::{Attitude, BodyVector}};
    /// let omega = BodyVector::new(0.01, 1.0, 0.01);
    /// let top = EulerTop::from_omega([1.0, 2.0, 3.0], omega, Attitude::identity())?;
    /// let mut states = [top.at(0.0)?];
    /// let alone = top.at(5.0)?;
    /// Ensemble::new(vec![top]).states_at(5.0, &mut states)?;
    /// assert_eq!(states[0], alone);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn states_at(&self, t: f64, states: &mut [State]) -> Result<()> {
        same_length(self.tops.len(), states.len())?;
        for (top, state) in self.tops.iter().zip(states) {
            *state = top.at(t)?;
        }
        Ok(())
    }
}
