//! Paths of shapes (tutorial 1.1): what muscles can do is prescribed; how hard they must work for it comes out.

use core::f64::consts::{PI, TAU};

use crate::error::{Error, Result, not_negative, positive, within};
use crate::phenomena::{Bend, Waist};

/// How a stroke of a muscle is spread over its time: from 0 to 1, at rest at both ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Pace {
    /// The same forward and backward: u³(10 − 15u + 6u²).
    #[default]
    Even,
    /// Slow at first and hasty at the end: the same of u².
    Late,
}

impl Pace {
    /// Value, rate and acceleration after a fraction `u` of the stroke.
    pub(crate) fn at(self, u: f64) -> [f64; 3] {
        let u = u.clamp(0.0, 1.0);
        match self {
            Self::Even => even(u),
            Self::Late => {
                let [value, rate, acceleration] = even(u * u);
                [
                    value,
                    2.0 * u * rate,
                    2.0 * rate + 4.0 * u * u * acceleration,
                ]
            }
        }
    }

    /// No rate is greater.
    pub(super) const fn greatest_rate(self) -> f64 {
        match self {
            Self::Even => 1.875,
            // At u² = 5/9.
            Self::Late => 2.73,
        }
    }
}

fn even(u: f64) -> [f64; 3] {
    let left = 1.0 - u;
    [
        u * u * u * (10.0 + u * (-15.0 + 6.0 * u)),
        30.0 * u * u * left * left,
        60.0 * u * left * (1.0 - 2.0 * u),
    ]
}

/// The shape of a swivel, a body of two parts on one axis, and how it changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Twist {
    /// Moment of the upper part, kg m².
    pub upper: f64,
    /// Angle of the upper part against the lower, radians.
    pub angle: f64,
    /// Its rate, rad/s.
    pub rate: f64,
}

/// A swivel twists with the arms out, pulls them in, untwists, and stretches them out: over and over again, each phase a quarter of the time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FourPhases {
    /// Upper moment with the arms out, kg m².
    pub arms_out: f64,
    /// Upper moment with the arms in, kg m².
    pub arms_in: f64,
    /// How far the upper part twists, radians.
    pub twist: f64,
    /// Duration of a cycle, s.
    pub duration: f64,
    /// How each phase is spread over its time.
    pub pace: Pace,
}

impl FourPhases {
    /// The shape at a time. The remainder by the duration is exact, however far that is.
    pub(super) fn at(&self, t: f64) -> Twist {
        let since = t.rem_euclid(self.duration);
        let phase = 4.0 * (since / self.duration);
        let [part, rate, _] = self.pace.at(phase.fract());
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
}

/// Rounds that a run with steps may pass through.
const MOST_ROUNDS: f64 = 1e5;

impl FourPhases {
    pub(super) fn checked(self) -> Result<Self> {
        positive("the duration of a cycle", self.duration)?;
        let waist = Waist {
            upper_arms_out: self.arms_out,
            upper_arms_in: self.arms_in,
            lower: 0.0,
        };
        waist.swivel_angle(self.twist)?;
        Ok(self)
    }

    /// Duration of a phase, s.
    pub(super) fn part(&self) -> f64 {
        self.duration / 4.0
    }

    /// Nothing, if a run with steps can pass through all the rounds up to this time.
    ///
    /// # Errors
    /// [`Error::Condition`] if they are too many.
    pub(super) fn passed_through(&self, time: f64) -> Result<()> {
        let condition = "a path of shapes must be asked for no more than 100000 rounds";
        no_more(time / self.duration, MOST_ROUNDS, condition)
    }

    /// The next corner after a time, s.
    pub(super) fn corner_after(&self, t: f64) -> f64 {
        let passed = (t / self.part()).floor();
        // At a corner itself the quotient may be rounded to less than its number.
        next_of(Some([1.0, 2.0].map(|n| (passed + n) * self.part())), t)
    }

    /// The least upper moment, kg m², and the fastest twist, rad/s.
    pub(super) fn extremes(&self) -> (f64, f64) {
        let twist = 4.0 * self.twist * self.pace.greatest_rate() / self.duration;
        (self.arms_out.min(self.arms_in), twist.abs())
    }
}

/// A skater's hands move to another distance, and stay there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Draw {
    /// Where they end, m.
    pub to: f64,
    /// When they begin, s.
    pub begin: f64,
    /// How long they take, s.
    pub duration: f64,
    /// How the stroke is spread over its time.
    pub pace: Pace,
}

impl Draw {
    pub(super) fn checked(self) -> Result<Self> {
        not_negative("the distance of the hands", self.to)?;
        not_negative("the time at which the hands begin", self.begin)?;
        positive("the time that the hands take", self.duration)?;
        Ok(self)
    }

    /// Distance of the hands from the axis (m), its rate and its acceleration, after they were at rest at `still`.
    pub(super) fn reach(&self, still: f64, t: f64) -> [f64; 3] {
        let [part, rate, acceleration] = self.pace.at((t - self.begin) / self.duration);
        let way = self.to - still;
        [
            still + way * part,
            way * rate / self.duration,
            way * acceleration / (self.duration * self.duration),
        ]
    }

    /// When they begin and when they end, s.
    pub(super) fn corners(&self) -> [f64; 2] {
        [self.begin, self.begin + self.duration]
    }
}

/// A cat bends forward, carries the bend once round, and straightens: a quarter, a half and a quarter of the time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turnover {
    /// Bend γ forward, radians.
    pub forward: f64,
    /// Bend backward, half-way round, radians; a cat's back allows less.
    pub back: f64,
    /// Duration of the whole, s.
    pub duration: f64,
    /// How each part is spread over its time.
    pub pace: Pace,
}

impl Turnover {
    pub(super) fn checked(self) -> Result<Self> {
        positive("the duration of the turnover", self.duration)?;
        within("the bend", self.forward, 0.0, PI)?;
        within("the bend", self.back, 0.0, PI)?;
        Ok(self)
    }

    /// The shape at a time, and its rate.
    pub(super) fn bend(&self, t: f64) -> Bend {
        let u = t / self.duration;
        let forward = |part: f64, rate: f64, direction: f64| Bend {
            angle: self.forward * part,
            direction,
            angle_rate: self.forward * rate * 4.0 / self.duration,
            direction_rate: 0.0,
        };
        if u < 0.25 {
            let [part, rate, _] = self.pace.at(4.0 * u);
            forward(part, rate, 0.0)
        } else if u < 0.75 {
            let [part, rate, _] = self.pace.at(2.0 * u - 0.5);
            let mean = 0.5 * (self.forward + self.back);
            let swing = 0.5 * (self.forward - self.back);
            let (sin, cos) = (TAU * part).sin_cos();
            let direction_rate = TAU * rate * 2.0 / self.duration;
            Bend {
                angle: mean + swing * cos,
                direction: TAU * part,
                angle_rate: -swing * sin * direction_rate,
                direction_rate,
            }
        } else {
            let [part, rate, _] = self.pace.at(4.0 * u - 3.0);
            forward(1.0 - part, -rate, TAU)
        }
    }

    /// Where the path is not smooth, s.
    pub(super) fn corners(&self) -> [f64; 3] {
        [0.25, 0.75, 1.0].map(|u| u * self.duration)
    }

    /// No rate is greater, rad/s.
    pub(super) fn greatest_rate(&self) -> f64 {
        2.0 * TAU * self.pace.greatest_rate() / self.duration
    }
}

/// Nothing, if a run can pass through so many.
///
/// # Errors
/// [`Error::Condition`] for more than the most.
pub(super) fn no_more(value: f64, most: f64, condition: &'static str) -> Result<()> {
    match value <= most {
        true => Ok(()),
        false => Err(Error::Condition { condition, value }),
    }
}

/// The first of these corners after a time, s; none is infinitely far.
pub(super) fn next_of<const N: usize>(corners: Option<[f64; N]>, t: f64) -> f64 {
    let mut corners = corners.into_iter().flatten();
    corners.find(|&corner| corner > t).unwrap_or(f64::INFINITY)
}
