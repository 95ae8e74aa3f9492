//! The same motions by a general method: forces in, events located on the way. The check of [`Course`](super::course::Course).

use super::course::{Friction, Happening, Hold, Laws, Load, Moment, Pace, Resistance};
use super::course::{ground_now, on, settle};
use super::sheet::Support;
use crate::error::{Error, Result, finite, positive};
use crate::integrators::{Cost, Effort, Method, Stop, until};

/// Position, velocity, rim speed, turned, heat, work, and the way of the sheet.
type State = [f64; 7];

/// The body at `times` (s, ascending from 0), and when what happened; arguments as for [`Course::new`](super::course::Course::new).
///
/// Every stretch is cut into eight, so that a quantity that falls through zero and comes back is not overlooked.
///
/// # Errors
/// As for [`Course::new`](super::course::Course::new) and [`until`].
pub fn integrated<F: Friction, C: Resistance, S: Support>(
    kappa: f64,
    load: Load,
    (friction, resistance, sheet): (F, C, S),
    start: Moment,
    times: &[f64],
    (method, effort): (Method, Effort),
) -> Result<Run> {
    let kappa = positive("the inertia factor", kappa)?;
    positive("the reaction of the ground", load.reaction)?;
    for &time in times {
        finite("the time", time)?;
    }
    let laws = Laws {
        kappa,
        load,
        friction,
        resistance,
    };
    let end = times.last().copied().unwrap_or(0.0);
    let mut run = Run {
        moments: Vec::with_capacity(times.len()),
        events: Vec::new(),
        cost: Cost::default(),
    };
    let (mut now, mut leg, mut on_sheet) = (0.0, 0, S::ACTS);
    let mut moment = start;
    let mut way = 0.0;
    loop {
        let (motion, leg_ends) = ground_now(sheet, leg, now);
        let pace = if S::ACTS && on_sheet {
            on(sheet, &laws).pace(sheet.law(), moment.slip, moment.rim_speed, motion[1])
        } else {
            laws.pace(laws.friction, moment.slip, moment.rim_speed, 0.0)
        };
        let leg_now = Leg {
            pace,
            load,
            kappa,
            start: now,
            sheet: motion,
            margin: if S::ACTS { sheet.margin() - start.position } else { 0.0 },
            on_sheet,
        };
        let ends = leg_ends.min(end);
        let mut y = [
            moment.position,
            moment.velocity,
            moment.rim_speed,
            moment.turned,
            moment.heat,
            moment.work,
            way,
        ];
        let size = y[1].abs().max(y[2].abs()).max(motion[0].abs()).max(1e-3);
        let scales = [size, size, size, size, size * size, size * size, size];
        let mut stopped = Stop::AtTheEnd;
        let (from, span) = (now, ends - now);
        for part in 1..=PARTS {
            let to = if part == PARTS {
                ends
            } else {
                from + span * (f64::from(part) / f64::from(PARTS))
            };
            let samples: Vec<f64> = times[run.moments.len()..]
                .iter()
                .copied()
                .take_while(|&t| t <= to)
                .collect();
            let passage = until(
                &|t: f64, y: &State| leg_now.rate(t, y),
                now,
                &y,
                &scales,
                &samples,
                to,
                &|t: f64, y: &State| leg_now.guard::<S>(t, y).0,
                method,
                effort,
            )?;
            run.cost += passage.cost;
            run.moments
                .extend(samples.iter().zip(&passage.states).map(|(&t, y)| leg_now.moment(t, y)));
            (now, y, stopped) = (passage.time, passage.end, passage.stopped);
            if stopped == Stop::AtTheEvent {
                break;
            }
        }
        way = y[6];
        moment = leg_now.moment(now, &y);
        let sheet_speed = motion[0] + (now - from) * motion[1];
        if stopped == Stop::AtTheEnd {
            if leg_ends >= end {
                return Ok(run);
            }
            leg += 1;
            if S::ACTS && on_sheet {
                moment.slip -= sheet.leg(leg).0.1 - sheet.leg(leg - 1).1.1;
            }
            continue;
        }
        let what = leg_now.guard::<S>(now, &y).1;
        let what = match what {
            Happening::LeavesSheet | Happening::MountsSheet => {
                on_sheet = !on_sheet;
                let ground = if on_sheet { sheet_speed } else { 0.0 };
                moment.slip = moment.velocity - moment.rim_speed - ground;
                what
            }
            _ => settle(
                &mut moment,
                what,
                pace,
                if on_sheet { sheet_speed } else { 0.0 },
            ),
        };
        run.events.push((now, what));
        if run.events.len() > MOST_EVENTS {
            return Err(Error::Integration {
                reason: "more than a hundred thousand events",
                time: now,
            });
        }
    }
}

/// A motion by a general method.
#[derive(Debug, Clone)]
pub struct Run {
    /// The body at the times asked for.
    pub moments: Vec<Moment>,
    /// When what happened.
    pub events: Vec<(f64, Happening)>,
    /// What it has cost.
    pub cost: Cost,
}

const PARTS: u32 = 8;
const MOST_EVENTS: usize = 100_000;

/// A stretch with one law.
struct Leg {
    pace: Pace,
    load: Load,
    kappa: f64,
    start: f64,
    sheet: [f64; 2],
    margin: f64,
    on_sheet: bool,
}

impl Leg {
    fn sheet_speed(&self, t: f64) -> f64 {
        self.sheet[0] + (t - self.start) * self.sheet[1]
    }

    fn ground_speed(&self, t: f64) -> f64 {
        if self.on_sheet { self.sheet_speed(t) } else { 0.0 }
    }

    fn rate(&self, t: f64, y: &State) -> State {
        let (f, m) = (self.pace.friction, self.pace.couple);
        let ground = self.ground_speed(t);
        let slip = y[1] - y[2] - ground;
        let rubbing = match self.pace.slipping {
            Hold::Held => 0.0,
            _ => f * slip,
        };
        [
            y[1],
            self.load.push + f,
            match self.pace.turning {
                Hold::Held => 0.0,
                _ => (self.load.twist + m - f) / self.kappa,
            },
            y[2],
            -rubbing - m * y[2],
            self.load.push * y[1] + self.load.twist * y[2] + f * ground,
            self.sheet_speed(t),
        ]
    }

    /// The least of what must stay positive, and what it means when it does not.
    fn guard<S: Support>(&self, t: f64, y: &State) -> (f64, Happening) {
        let mut least = (f64::INFINITY, Happening::Rest);
        let mut consider = |value: f64, what| {
            if value < least.0 {
                least = (value, what);
            }
        };
        if let Hold::Goes(sign) = self.pace.slipping {
            consider(
                sign * (y[1] - y[2] - self.ground_speed(t)),
                Happening::RollingBegins,
            );
        }
        if let Hold::Goes(sign) = self.pace.turning {
            consider(sign * y[2], Happening::TurningStops);
        }
        if S::ACTS {
            let margin = self.margin + y[0] - y[6];
            if self.on_sheet {
                consider(margin, Happening::LeavesSheet);
            } else {
                consider(-margin, Happening::MountsSheet);
            }
        }
        if least.0 == f64::INFINITY {
            least.0 = 1.0;
        }
        least
    }

    fn moment(&self, t: f64, y: &State) -> Moment {
        Moment {
            position: y[0],
            velocity: y[1],
            rim_speed: y[2],
            slip: match self.pace.slipping {
                Hold::Held => 0.0,
                _ => y[1] - y[2] - self.ground_speed(t),
            },
            turned: y[3],
            heat: y[4],
            work: y[5],
        }
    }
}
