//! One stretch of a course: quadratics in time, and the roots at which it ends.

use super::laws::{Hold, Pace};
use super::moment::{Happening, Load, Moment};
use crate::rolling::sheet::Support;

/// One stretch: constant accelerations from a moment on.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stretch {
    pub start: f64,
    pub moment: Moment,
    pub pace: Pace,
    pub load: Load,
    /// Speed and acceleration of the sheet, and from its edge to the point of contact.
    pub sheet: [f64; 2],
    pub margin: f64,
    pub on_sheet: bool,
}

impl Stretch {
    pub fn at(&self, t: f64) -> Moment {
        let (from, pace) = (&self.moment, &self.pace);
        let advance = t * (from.velocity + 0.5 * t * pace.velocity);
        let turn = t * (from.rim_speed + 0.5 * t * pace.rim_speed);
        let ground = if self.on_sheet {
            self.sheet_advance(t)
        } else {
            0.0
        };
        let slip_rate = match pace.slipping {
            Hold::Held => 0.0,
            _ => pace.velocity - pace.rim_speed - pace.ground,
        };
        // What friction takes from the slip, and the couple from the turning, is heat.
        let slid = match pace.slipping {
            Hold::Held => 0.0,
            _ => t * (from.slip + 0.5 * t * slip_rate),
        };
        Moment {
            position: from.position + advance,
            velocity: from.velocity + t * pace.velocity,
            rim_speed: from.rim_speed + t * pace.rim_speed,
            slip: from.slip + t * slip_rate,
            turned: from.turned + turn,
            heat: from.heat - pace.friction * slid - pace.couple * turn,
            work: from.work
                + self.load.push * advance
                + self.load.twist * turn
                + pace.friction * ground,
        }
    }

    /// What ends the stretch before `longest` is over, and when.
    pub fn next<S: Support>(&self, longest: f64) -> Option<(f64, Happening)> {
        let (pace, from) = (&self.pace, &self.moment);
        let mut first: Option<(f64, Happening)> = None;
        let mut consider = |t: Option<f64>, what| {
            if let Some(t) = t
                && t < first.map_or(longest, |sooner| sooner.0)
            {
                first = Some((t, what));
            }
        };
        if let Hold::Goes(sign) = pace.slipping {
            let rate = pace.velocity - pace.rim_speed - pace.ground;
            consider(
                falls(sign * from.slip, sign * rate),
                Happening::RollingBegins,
            );
        }
        if let Hold::Goes(sign) = pace.turning {
            let time = falls(sign * from.rim_speed, sign * pace.rim_speed);
            consider(time, Happening::TurningStops);
        }
        if S::ACTS {
            let drift = from.velocity - self.sheet[0];
            let bend = pace.velocity - self.sheet[1];
            if self.on_sheet {
                consider(crosses(self.margin, drift, bend), Happening::LeavesSheet);
            } else {
                consider(crosses(-self.margin, -drift, -bend), Happening::MountsSheet);
            }
        }
        first
    }

    pub fn sheet_advance(&self, t: f64) -> f64 {
        t * (self.sheet[0] + 0.5 * t * self.sheet[1])
    }

    pub fn margin_at(&self, t: f64) -> f64 {
        let advance = t * (self.moment.velocity + 0.5 * t * self.pace.velocity);
        self.margin + (advance - self.sheet_advance(t))
    }
}

/// When a positive quantity falls through zero at this rate.
fn falls(value: f64, rate: f64) -> Option<f64> {
    (value > 0.0 && rate < 0.0).then(|| -value / rate)
}

/// When value + rate t + ½ bend t², positive or just about to be, falls through zero.
fn crosses(value: f64, rate: f64, bend: f64) -> Option<f64> {
    if value <= 0.0 {
        // On the edge itself: it crosses at once, or it moves off first and may come back.
        if rate < 0.0 || (rate == 0.0 && bend < 0.0) {
            return Some(0.0);
        }
        return (rate > 0.0 && bend < 0.0).then(|| -2.0 * rate / bend);
    }
    let root = (rate * rate - 2.0 * bend * value).max(0.0);
    if rate * rate < 2.0 * bend * value {
        return None;
    }
    // The stable root of the two, whichever sign the rate has.
    let root = root.sqrt();
    if rate < 0.0 {
        Some(2.0 * value / (root - rate))
    } else if bend < 0.0 {
        Some((-rate - root) / bend)
    } else {
        None
    }
}
