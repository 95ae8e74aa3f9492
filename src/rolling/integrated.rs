//! The same motions by a general method: forces in, events located on the way. The check of [`Course`](super::course::Course).

use super::course::{Friction, Happening, Hold, Laws, Load, Moment, Pace, Resistance};
use super::course::{ground_now, jerk, on, settle};
use super::sheet::Support;
use crate::error::{Error, Result, finite, positive};
use crate::integrators::{Cost, Effort, Method, Stop, solve, until};

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
    let mut about = start.about_the_table(kappa);
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
            margin: if S::ACTS {
                sheet.margin() - start.position
            } else {
                0.0
            },
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
        let (mut stopped, mut what) = (Stop::AtTheEnd, Happening::Rest);
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
            let free = |t: f64, y: &State| leg_now.rate(t, y);
            let (mut first, mut ends) = (None, to);
            for guard in leg_now.guards::<S>().into_iter().flatten() {
                let passage = until(
                    &free,
                    now,
                    &y,
                    &scales,
                    &samples[..samples.partition_point(|&t| t <= ends)],
                    ends,
                    &|t: f64, y: &State| leg_now.value(guard, t, y),
                    method,
                    effort,
                )?;
                run.cost += passage.cost;
                if first.is_none() || passage.stopped == Stop::AtTheEvent {
                    (ends, what) = (passage.time, guard);
                    first = Some(passage);
                }
            }
            let Some(passage) = first else { break };
            run.moments.extend(
                samples
                    .iter()
                    .zip(&passage.states)
                    .map(|(&t, y)| leg_now.moment(t, y)),
            );
            (now, y, stopped) = (passage.time, passage.end, passage.stopped);
            if stopped == Stop::AtTheEvent {
                break;
            }
        }
        if stopped == Stop::AtTheEvent {
            // Newton's method along the true motion takes the located root to rounding.
            for _ in 0..NEWTON {
                let value = |t: f64, y: &State| leg_now.value(what, t, y);
                let here = value(now, &y);
                let rate = leg_now.rate(now, &y);
                let probe = core::array::from_fn(|i| y[i] + PROBE * rate[i]);
                let step = -here * PROBE / (value(now + PROBE, &probe) - here);
                if !step.is_finite() || step.abs() <= 4e-16 * now {
                    break;
                }
                let free = |t: f64, y: &State| leg_now.rate(t, y);
                let (to, dop) = (now + step, Method::Dop853);
                let tight = Effort::Tolerance(1e-14);
                let short = solve(&free, now, &y, &scales, &[to], dop, tight)?;
                run.cost += short.cost;
                (now, y) = (to, short.states[0]);
            }
            // Samples between the rough root and the true one belong to what comes next.
            let before = times.partition_point(|&t| t <= now);
            run.moments.truncate(before);
        }
        about += (now - from) * laws.moment_about_the_table(&pace);
        way = y[6];
        moment = leg_now.moment(now, &y);
        let sheet_speed = motion[0] + (now - from) * motion[1];
        if stopped == Stop::AtTheEnd {
            if leg_ends >= end {
                return Ok(run);
            }
            if S::ACTS && on_sheet {
                moment.slip -= jerk(sheet, leg);
            }
            leg += 1;
            continue;
        }
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
                (&mut about, kappa),
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
const NEWTON: u32 = 8;
/// For a difference quotient, s.
const PROBE: f64 = 1e-7;
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
        if self.on_sheet {
            self.sheet_speed(t)
        } else {
            0.0
        }
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

    /// What may happen in this stretch; rest stands for nothing.
    fn guards<S: Support>(&self) -> [Option<Happening>; 3] {
        let goes = |hold| matches!(hold, Hold::Goes(_));
        let edge = match (S::ACTS, self.on_sheet) {
            (false, _) => None,
            (true, true) => Some(Happening::LeavesSheet),
            (true, false) => Some(Happening::MountsSheet),
        };
        let slips = goes(self.pace.slipping).then_some(Happening::RollingBegins);
        let turns = goes(self.pace.turning).then_some(Happening::TurningStops);
        [Some(slips.unwrap_or(Happening::Rest)), turns, edge]
    }

    /// What must stay positive if it is not to happen.
    fn value(&self, what: Happening, t: f64, y: &State) -> f64 {
        let towards_zero = |hold, value: f64| match hold {
            Hold::Goes(sign) => sign * value,
            _ => 1.0,
        };
        match what {
            Happening::RollingBegins => {
                let slip = y[1] - y[2] - self.ground_speed(t);
                towards_zero(self.pace.slipping, slip)
            }
            Happening::TurningStops => towards_zero(self.pace.turning, y[2]),
            Happening::LeavesSheet => self.margin + y[0] - y[6],
            Happening::MountsSheet => y[6] - y[0] - self.margin,
            _ => 1.0,
        }
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
