//! A ball on a sheet that is withdrawn from under it (tutorial 4.5): it stops dead.
//!
//! All friction acts along lines in the table, so about a point of the table it has no moment: V + κRΩ stays zero whatever the hand does.
//! A ball that rolls has V = RΩ, and both are zero.

use super::friction::Coulomb;
use super::shot::RoundBody;
use crate::error::{Error, Result, finite, positive};

/// How fast the sheet goes, from time 0 on: straight from point to point, at its last speed after the last one.
///
/// Two points at one time make a jerk.
#[derive(Debug, Clone, PartialEq)]
pub struct SheetSpeeds {
    points: Vec<(f64, f64)>,
}

impl SheetSpeeds {
    /// Through these points: time (s), in ascending order from 0, and speed (m/s).
    ///
    /// # Errors
    /// [`Error::Empty`]; [`Error::NotFinite`]; [`Error::Condition`] unless the times start at 0 and never go back.
    pub fn through(points: impl Into<Vec<(f64, f64)>>) -> Result<Self> {
        let points = points.into();
        let Some(&(first, _)) = points.first() else {
            return Err(Error::Empty {
                quantity: "the list of the sheet's speeds",
            });
        };
        if first != 0.0 {
            return Err(Error::Condition {
                condition: "the sheet's speeds must begin at time 0",
                value: first,
            });
        }
        for &(time, speed) in &points {
            finite("the time of a speed of the sheet", time)?;
            finite("the speed of the sheet", speed)?;
        }
        if let Some(pair) = points.windows(2).find(|pair| pair[1].0 < pair[0].0) {
            return Err(Error::Condition {
                condition: "the times of the sheet's speeds must not go back",
                value: pair[1].0,
            });
        }
        Ok(Self { points })
    }

    /// From rest to `speed` (m/s), in proportion to time, within `time` (s); then steadily on.
    ///
    /// # Errors
    /// As [`Self::through`].
    pub fn ramp(speed: f64, time: f64) -> Result<Self> {
        Self::through([(0.0, 0.0), (time, speed)])
    }

    /// The speed at a time, m/s; at a jerk the one after it.
    pub fn at(&self, t: f64) -> f64 {
        let after = self.points.partition_point(|point| point.0 <= t);
        match (
            after.checked_sub(1).map(|i| self.points[i]),
            self.points.get(after),
        ) {
            (Some(from), Some(to)) => from.1 + (t - from.0) * (to.1 - from.1) / (to.0 - from.0),
            (Some(from), None) => from.1,
            (None, _) => self.points[0].1,
        }
    }

    /// The points.
    pub fn points(&self) -> &[(f64, f64)] {
        &self.points
    }
}

/// A sheet under the ball, its edge behind the ball.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet {
    friction: Coulomb,
    speeds: SheetSpeeds,
    margin: f64,
}

impl Sheet {
    /// A sheet of this friction, withdrawn at these speeds (positive: forward), whose edge is `margin` (m) behind the point of contact.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::NotFinite`] for the margin.
    pub fn new(friction: Coulomb, speeds: SheetSpeeds, margin: f64) -> Result<Self> {
        Ok(Self {
            friction,
            speeds,
            margin: positive("the distance of the sheet's edge", margin)?,
        })
    }

    /// How fast it goes.
    pub(crate) fn speeds(&self) -> &SheetSpeeds {
        &self.speeds
    }

    /// Friction on it.
    pub(crate) fn friction(&self) -> Coulomb {
        self.friction
    }

    /// From its edge to the point of contact at time 0, m.
    pub(crate) fn margin(&self) -> f64 {
        self.margin
    }

    /// Leg number `index` of its motion: times (s) and speeds (m/s) of its two ends, the last one open.
    pub(crate) fn leg(&self, index: usize) -> ((f64, f64), (f64, f64)) {
        let points = &self.speeds.points;
        let from = points[index.min(points.len() - 1)];
        let to = points.get(index + 1).copied();
        (from, to.unwrap_or((f64::INFINITY, from.1)))
    }
}

impl RoundBody {
    /// Acceleration of a body that rolls on a sheet which accelerates: κ/(1+κ) of it, 2/7 for the ball (4.5). Exact to two roundings.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub fn carried_by_sheet(&self, acceleration: f64) -> Result<f64> {
        let acceleration = finite("the sheet's acceleration", acceleration)?;
        Ok(self.inertia_factor() / self.pure_rolling_height() * acceleration)
    }
}
