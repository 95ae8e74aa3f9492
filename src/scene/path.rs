//! Paths of shapes (tutorial 1.1): the motion of the muscles as a function of time.

use core::f64::consts::{PI, TAU};

use crate::error::{Result, finite, not_negative, positive, within};
use crate::phenomena::Bend;

/// The progress of a stroke in its time: from 0 to 1, at rest at both ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Pace {
    /// Symmetric in time: u³(10 − 15u + 6u²).
    #[default]
    Even,
    /// Slow at first and hasty at the end: the same function of u².
    Late,
}

impl Pace {
    /// Progress and its rate after a fraction `u` of the stroke.
    pub(crate) fn at(self, u: f64) -> [f64; 2] {
        let u = u.clamp(0.0, 1.0);
        match self {
            Self::Even => even(u),
            Self::Late => {
                let [value, rate] = even(u * u);
                [value, 2.0 * u * rate]
            }
        }
    }

    /// An upper bound of the rate.
    pub(super) const fn greatest_rate(self) -> f64 {
        match self {
            Self::Even => 1.875,
            // At u² = 5/9.
            Self::Late => 2.73,
        }
    }
}

fn even(u: f64) -> [f64; 2] {
    let (left, value) = (1.0 - u, u * u * u * (10.0 + u * (-15.0 + 6.0 * u)));
    [value, 30.0 * u * u * left * left]
}

/// The shape of a swivel, a body of two parts on one axis, and its rate of change.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Twist {
    /// Moment of the upper part, kg m².
    pub upper: f64,
    /// Angle of the upper part relative to the lower, radians.
    pub angle: f64,
    /// Rate of that angle, rad/s.
    pub rate: f64,
}

/// The cycle of a swivel: it twists with the arms out, pulls them in, untwists, and stretches them out, each in a quarter of the duration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FourPhases {
    /// Upper moment with the arms out, kg m².
    pub arms_out: f64,
    /// Upper moment with the arms in, kg m².
    pub arms_in: f64,
    /// The angle by which the upper part twists, radians.
    pub twist: f64,
    /// Duration of a cycle, s.
    pub duration: f64,
    /// The progress of each phase.
    pub pace: Pace,
}

/// The most cycles in a run by steps.
const MOST_ROUNDS: f64 = 1e5;

impl FourPhases {
    /// The shape at a time. The remainder by the duration is exact, however late the time.
    pub(super) fn at(&self, t: f64) -> Twist {
        let since = t.rem_euclid(self.duration);
        let phase = 4.0 * (since / self.duration);
        let [part, rate] = self.pace.at(phase.fract());
        let rate = rate * self.twist * 4.0 / self.duration;
        let between = |from: f64, to: f64| from + (to - from) * part;
        let (upper, angle, rate) = match phase as u8 {
            0 => (self.arms_out, self.twist * part, rate),
            1 => (between(self.arms_out, self.arms_in), self.twist, 0.0),
            2 => (self.arms_in, self.twist * (1.0 - part), -rate),
            _ => (between(self.arms_in, self.arms_out), 0.0, 0.0),
        };
        Twist { upper, angle, rate }
    }

    pub(super) fn checked(self) -> Result<Self> {
        positive("the duration of a cycle", self.duration)?;
        positive("the upper moment with arms out", self.arms_out)?;
        positive("the upper moment with arms in", self.arms_in)?;
        finite("the twist", self.twist)?;
        Ok(self)
    }

    /// Duration of a phase, s.
    pub(super) fn part(&self) -> f64 {
        self.duration / 4.0
    }

    /// Succeeds if a run by steps can take all the cycles up to this time.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) for too many cycles.
    pub(super) fn passed_through(&self, time: f64) -> Result<f64> {
        let what = "the time of a run by steps, 100000 cycles at most,";
        within(what, time, 0.0, MOST_ROUNDS * self.duration)
    }

    /// The first boundary between two phases after a time, s.
    pub(super) fn corner_after(&self, t: f64) -> f64 {
        let passed = (t / self.part()).floor();
        // At a boundary the quotient may be rounded to less than its number.
        next_of(Some([1.0, 2.0].map(|n| (passed + n) * self.part())), t)
    }

    /// The least upper moment, kg m², and the fastest twist, rad/s.
    pub(super) fn extremes(&self) -> (f64, f64) {
        let twist = 4.0 * self.twist * self.pace.greatest_rate() / self.duration;
        (self.arms_out.min(self.arms_in), twist.abs())
    }
}

/// A motion of a skater's hands to another distance, where they stay.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Draw {
    /// Final distance, m.
    pub to: f64,
    /// Beginning of the motion, s.
    pub begin: f64,
    /// Duration of the motion, s.
    pub duration: f64,
    /// The progress of the motion.
    pub pace: Pace,
}

impl Draw {
    pub(super) fn checked(self) -> Result<Self> {
        not_negative("the distance of the hands", self.to)?;
        not_negative("the time at which the hands begin", self.begin)?;
        positive("the time that the hands take", self.duration)?;
        Ok(self)
    }

    /// Distance of the hands from the axis (m) and its rate, for hands first at rest at `still`.
    pub(super) fn reach(&self, still: f64, t: f64) -> [f64; 2] {
        let [part, rate] = self.pace.at((t - self.begin) / self.duration);
        let way = self.to - still;
        [still + way * part, way * rate / self.duration]
    }

    /// Beginning and end of the motion, s.
    pub(super) fn corners(&self) -> [f64; 2] {
        [self.begin, self.begin + self.duration]
    }
}

/// The motion of a cat that bends forward, carries the bend once round, and straightens: in a quarter, a half and a quarter of the duration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turnover {
    /// Bend γ forward, radians.
    pub forward: f64,
    /// Bend backward, half-way round, radians; a cat's back bends less.
    pub back: f64,
    /// Duration of the whole motion, s.
    pub duration: f64,
    /// The progress of each part.
    pub pace: Pace,
}

impl Turnover {
    pub(super) fn checked(self) -> Result<Self> {
        positive("the duration of the turnover", self.duration)?;
        within("the bend", self.forward, 0.0, PI)?;
        within("the bend", self.back, 0.0, PI)?;
        Ok(self)
    }

    /// The bend at a time, and its rate.
    pub(super) fn bend(&self, t: f64) -> Bend {
        let u = t / self.duration;
        let forward = |part: f64, rate: f64, direction: f64| Bend {
            angle: self.forward * part,
            direction,
            angle_rate: self.forward * rate * 4.0 / self.duration,
            direction_rate: 0.0,
        };
        if u < 0.25 {
            let [part, rate] = self.pace.at(4.0 * u);
            forward(part, rate, 0.0)
        } else if u < 0.75 {
            let [part, rate] = self.pace.at(2.0 * u - 0.5);
            let (s, c) = (0.5 * TAU * part).sin_cos();
            let direction_rate = TAU * rate * 2.0 / self.duration;
            Bend {
                // Of squares, which do not cancel where the smaller bend is nil.
                angle: self.forward * c * c + self.back * s * s,
                direction: TAU * part,
                angle_rate: (self.back - self.forward) * s * c * direction_rate,
                direction_rate,
            }
        } else {
            let [part, rate] = self.pace.at(4.0 * u - 3.0);
            forward(1.0 - part, -rate, TAU)
        }
    }

    /// The times at which the path is not smooth, s.
    pub(super) fn corners(&self) -> [f64; 3] {
        [0.25, 0.75, 1.0].map(|u| u * self.duration)
    }

    /// An upper bound of the rates, rad/s.
    pub(super) fn greatest_rate(&self) -> f64 {
        2.0 * TAU * self.pace.greatest_rate() / self.duration
    }
}

/// The greatest angle, rad, at which a motion begins that is computed by its angle: beyond, the angle has fewer digits than an answer.
pub(super) const MOST_TURNED: f64 = 1e6;

/// The first of these corners after a time, s; infinity if there is none.
pub(super) fn next_of<const N: usize>(corners: Option<[f64; N]>, t: f64) -> f64 {
    let mut corners = corners.into_iter().flatten();
    corners.find(|&corner| corner > t).unwrap_or(f64::INFINITY)
}
