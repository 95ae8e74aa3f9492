//! A ball on a sheet that is withdrawn from under it (tutorial 4.5): it stops dead.

use super::friction::Coulomb;
use crate::error::{Result, each_finite, finite, not_empty, positive, refused};

/// The speed of the sheet from time 0 on: linear between the points given, constant after the last one.
///
/// Two points at one time make a jump in speed.
#[derive(Debug, Clone, PartialEq)]
pub struct SheetSpeeds {
    /// The points.
    pub(crate) points: Vec<(f64, f64)>,
}

impl SheetSpeeds {
    /// Through these points: time (s), in ascending order from 0, and speed (m/s).
    ///
    /// # Errors
    /// [`Error::Empty`](crate::Error::Empty); [`Error::NotFinite`](crate::Error::NotFinite); [`Error::Condition`](crate::Error::Condition) unless the times start at 0 and never go back.
    ///
    /// ```
    /// use spinning_bodies::rolling::SheetSpeeds;
    /// assert_eq!(SheetSpeeds::through([(0.0, 0.0), (1.0, 2.0), (3.0, 0.0)])?.at(2.0), 1.0);
    /// assert!(SheetSpeeds::through([(1.0, 2.0), (0.0, 0.0)]).is_err());
    /// assert!(SheetSpeeds::through([(0.0, -1e308), (1.0, 1e308)]).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn through(points: impl Into<Vec<(f64, f64)>>) -> Result<Self> {
        let points = points.into();
        not_empty("the list of the sheet's speeds", &points)?;
        let (first, _) = points[0];
        if first != 0.0 {
            return refused("the sheet's speeds must begin at time 0", first);
        }
        for &(time, speed) in &points {
            finite("the time of a speed of the sheet", time)?;
            finite("the speed of the sheet", speed)?;
        }
        if let Some(pair) = points.windows(2).find(|pair| pair[1].0 < pair[0].0) {
            let condition = "the times of the sheet's speeds must not decrease";
            return refused(condition, pair[1].0);
        }
        let changes = points.array_windows().map(|[from, to]| to.1 - from.1);
        each_finite("a change of the sheet's speed", changes)?;
        Ok(Self { points })
    }

    /// From rest to `speed` (m/s), in proportion to time, within `time` (s); then steadily on.
    ///
    /// # Errors
    /// As [`Self::through`].
    ///
    /// ```
    /// use spinning_bodies::rolling::SheetSpeeds;
    /// let speeds = SheetSpeeds::ramp(2.0, 1.0)?;
    /// assert_eq!((speeds.at(0.5), speeds.at(7.0)), (1.0, 2.0));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn ramp(speed: f64, time: f64) -> Result<Self> {
        Self::through([(0.0, 0.0), (time, speed)])
    }

    /// The speed at a time, m/s; at a jump the one after it, and before time 0 the first one given.
    ///
    /// ```
    /// use spinning_bodies::rolling::SheetSpeeds;
    /// assert_eq!(SheetSpeeds::ramp(2.0, 4.0)?.at(1.0), 0.5);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn at(&self, t: f64) -> f64 {
        let begun = self.points.partition_point(|point| point.0 <= t);
        let Some(leg) = begun.checked_sub(1) else {
            return self.points[0].1;
        };
        let (from, to) = self.leg(leg);
        from.1 + (t.min(f64::MAX) - from.0) * (to.1 - from.1) / (to.0 - from.0)
    }

    /// Leg number `index` of the motion: times (s) and speeds (m/s) of its two ends, the last one open.
    pub(super) fn leg(&self, index: usize) -> ((f64, f64), (f64, f64)) {
        let from = self.points[index.min(self.points.len() - 1)];
        let to = self.points.get(index + 1).copied();
        (from, to.unwrap_or((f64::INFINITY, from.1)))
    }
}

/// A sheet under the ball, its edge behind the ball.
///
/// All friction acts along lines in the table, so it has no moment about a point of the table: for a ball that was at rest V + κRΩ stays zero whatever the hand does.
/// Once it rolls, V = RΩ, so both are zero.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet {
    /// Friction on it.
    pub(crate) friction: Coulomb,
    /// The speeds of the sheet.
    pub(crate) speeds: SheetSpeeds,
    /// From its edge to the point of contact at time 0, m.
    pub(crate) margin: f64,
}

impl Sheet {
    /// A sheet of this friction, withdrawn at these speeds (positive: forward), whose edge is `margin` (m) behind the point of contact.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite) for the margin.
    ///
    /// ```
    /// use spinning_bodies::rolling::{Coulomb, Sheet, SheetSpeeds};
    /// let speeds = SheetSpeeds::ramp(2.0, 1.0)?;
    /// assert!(Sheet::new(Coulomb::new(0.3)?, speeds, 0.5).is_ok());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(friction: Coulomb, speeds: SheetSpeeds, margin: f64) -> Result<Self> {
        Ok(Self {
            friction,
            speeds,
            margin: positive("the distance of the sheet's edge", margin)?,
        })
    }

    /// The same sheet slightly changed: its speeds a little greater and less in turn, its edge a little nearer, by another fraction lest the effects cancel.
    pub(crate) fn moved(&self, by: f64) -> Self {
        let mut moved = self.clone();
        for (place, point) in moved.speeds.points.iter_mut().enumerate() {
            point.1 *= if place % 2 == 0 { 1.0 + by } else { 1.0 - by };
        }
        moved.margin *= 1.0 - 0.8 * by;
        moved
    }
}
