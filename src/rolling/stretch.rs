//! One stretch of a [`Course`](super::course::Course): which way the contact slips and the body turns, the constant accelerations that follow,
//! and the roots at which it ends.

use super::course::{Coulomb, Happening, Load, Moment, RollingResistance};
use super::sheet::Sheet;
use crate::error::{Result, finite, positive};

/// Slips or turns: not at all by itself, one way, or held at zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Hold {
    /// No law acts on it.
    Free,
    /// It goes this way, +1 or −1.
    Goes(f64),
    /// It is zero and stays so.
    Held,
}

/// Constant accelerations of one stretch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pace {
    pub slipping: Hold,
    pub turning: Hold,
    /// Friction f and couple m per mass.
    pub friction: f64,
    pub couple: f64,
    /// V', (RΩ)', and that of the slip.
    pub velocity: f64,
    pub rim_speed: f64,
    pub slip: f64,
}

/// Everything about the motion that does not change.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Laws<'a> {
    pub kappa: f64,
    pub load: Load,
    pub friction: Option<Coulomb>,
    pub resistance: Option<RollingResistance>,
    pub sheet: Option<&'a Sheet>,
}

/// Constant accelerations from a moment on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stretch {
    pub start: f64,
    pub moment: Moment,
    pub pace: Pace,
    /// When the sheet begins to move otherwise.
    pub leg_ends: f64,
    load: Load,
    leg: usize,
    /// Speed and acceleration of the sheet, and from its edge to the point of contact; none without a sheet.
    sheet: Option<[f64; 3]>,
    on_sheet: bool,
    /// V + κRΩ at the start.
    about: f64,
}

impl<'a> Laws<'a> {
    pub fn new(
        kappa: f64,
        load: Load,
        (friction, resistance, sheet): (
            Option<Coulomb>,
            Option<RollingResistance>,
            Option<&'a Sheet>,
        ),
    ) -> Result<Self> {
        positive("the reaction of the ground", load.reaction)?;
        finite("the pull", load.push)?;
        finite("the twist", load.twist)?;
        Ok(Self {
            kappa: positive("the inertia factor", kappa)?,
            load,
            friction,
            resistance,
            sheet,
        })
    }

    /// Friction and couple for this slip and rim speed, on ground that accelerates: the one assignment of "goes one way" and "is held" that
    /// agrees with its own consequences. Held comes first, so a contact that can stick does.
    fn pace(&self, law: Option<Coulomb>, moment: &Moment, ground: f64) -> Pace {
        let (slip, rim_speed) = (moment.slip, moment.rim_speed);
        let mut first = None;
        for &slipping in candidates(law.is_some(), slip) {
            for &turning in candidates(self.resistance.is_some(), rim_speed) {
                let (pace, agrees) = self.consequence(law, slipping, turning, ground);
                let starts = (slip != 0.0 || starts(slipping, pace.slip))
                    && (rim_speed != 0.0 || starts(turning, pace.rim_speed));
                if agrees && starts {
                    return pace;
                }
                first.get_or_insert(pace);
            }
        }
        // There is always one, up to a rounding that decides between two that differ by as little.
        first.unwrap_or_else(|| self.consequence(None, Hold::Free, Hold::Free, ground).0)
    }

    fn consequence(
        &self,
        law: Option<Coulomb>,
        slipping: Hold,
        turning: Hold,
        ground: f64,
    ) -> (Pace, bool) {
        let Load {
            push,
            twist,
            reaction,
        } = self.load;
        let [kinetic, grip] = law.map_or([0.0; 2], |law| [law.kinetic(), law.grip()]);
        let most = self.resistance.map_or(0.0, |law| law.arm()) * reaction;
        let mut couple = match turning {
            Hold::Goes(sign) => Some(-sign * most),
            Hold::Free => Some(0.0),
            Hold::Held => None,
        };
        let friction = match (slipping, couple) {
            (Hold::Free, _) => 0.0,
            (Hold::Goes(sign), _) => -sign * kinetic * reaction,
            (Hold::Held, Some(m)) => {
                (self.kappa * (ground - push) + twist + m) / (1.0 + self.kappa)
            }
            (Hold::Held, None) => ground - push,
        };
        let couple = *couple.get_or_insert(friction - twist);
        let velocity = push + friction;
        let rim_speed = match turning {
            Hold::Held => 0.0,
            // On the same footing as the velocity, so that rolling stays rolling.
            _ if slipping == Hold::Held => velocity - ground,
            _ => (twist + couple - friction) / self.kappa,
        };
        let pace = Pace {
            slipping,
            turning,
            friction,
            couple,
            velocity,
            rim_speed,
            slip: match slipping {
                Hold::Held => 0.0,
                _ => velocity - rim_speed - ground,
            },
        };
        let sticks = slipping != Hold::Held || friction.abs() <= grip * reaction;
        let stays = turning != Hold::Held || couple.abs() <= most;
        (pace, sticks && stays)
    }

    /// The stretch at the start, whose slip is that over the ground as it moves then.
    pub fn first(&self, start: Moment) -> Stretch {
        let about = start.about_the_table(self.kappa);
        let sheet = self.sheet.map(Sheet::margin);
        self.begins(0.0, start, about, (0, sheet, sheet.is_some()))
    }

    /// A stretch that begins in this leg of the sheet's motion, so far from its edge, on it or not.
    fn begins(
        &self,
        start: f64,
        mut moment: Moment,
        about: f64,
        (mut leg, margin, on_sheet): (usize, Option<f64>, bool),
    ) -> Stretch {
        let (mut leg_ends, mut speed) = (f64::INFINITY, [0.0; 2]);
        if let Some(sheet) = self.sheet {
            let (mut from, mut to) = sheet.leg(leg);
            while to.0 <= start {
                if on_sheet && to.0 <= from.0 {
                    // A jerk.
                    moment.slip -= to.1 - from.1;
                }
                leg += 1;
                (from, to) = sheet.leg(leg);
            }
            let slope = if to.0.is_finite() {
                (to.1 - from.1) / (to.0 - from.0)
            } else {
                0.0
            };
            (leg_ends, speed) = (to.0, [from.1 + (start - from.0) * slope, slope]);
        }
        let pace = match self.sheet {
            Some(sheet) if on_sheet => self.pace(Some(sheet.friction()), &moment, speed[1]),
            _ => self.pace(self.friction, &moment, 0.0),
        };
        Stretch {
            start,
            moment,
            pace,
            leg_ends,
            load: self.load,
            leg,
            sheet: margin.map(|margin| [speed[0], speed[1], margin]),
            on_sheet,
            about,
        }
    }

    /// The stretch after one that so long after its start has ended with this moment and distance from the sheet's edge, because something has
    /// happened or by the clock; and what that means.
    pub fn after(
        &self,
        before: &Stretch,
        after: f64,
        (mut moment, mut margin): (Moment, f64),
        what: Option<Happening>,
    ) -> (Stretch, Option<Happening>) {
        let time = what.map_or(before.leg_ends, |_| before.start + after);
        // Everything but friction changes it.
        let moments = self.load.push + self.load.twist + before.pace.couple;
        let mut about = before.about + after * moments;
        let mut on_sheet = before.on_sheet;
        let happened = what.map(|what| match what {
            Happening::LeavesSheet | Happening::MountsSheet => {
                (on_sheet, margin) = (!on_sheet, 0.0);
                let ground = if on_sheet {
                    before.sheet_speed(after)
                } else {
                    0.0
                };
                moment.slip = moment.velocity - moment.rim_speed - ground;
                what
            }
            _ => {
                let ground = before.ground_speed(after);
                settle(
                    &mut moment,
                    what,
                    before.pace,
                    ground,
                    (&mut about, self.kappa),
                )
            }
        });
        let place = (before.leg, before.sheet.map(|_| margin), on_sheet);
        (self.begins(time, moment, about, place), happened)
    }
}

/// Ways a quantity with this value can go on.
fn candidates(acts: bool, value: f64) -> &'static [Hold] {
    match (acts, value) {
        (false, _) => &[Hold::Free],
        (true, 0.0) => &[Hold::Held, Hold::Goes(1.0), Hold::Goes(-1.0)],
        (true, value) if value > 0.0 => &[Hold::Goes(1.0)],
        (true, _) => &[Hold::Goes(-1.0)],
    }
}

/// Whether a quantity at zero, with this rate, goes the way it is said to go.
fn starts(hold: Hold, rate: f64) -> bool {
    match hold {
        Hold::Goes(sign) => sign * rate > 0.0,
        _ => true,
    }
}

/// Makes zero what has just become zero, and says what that means.
///
/// `about` is V + κRΩ. No friction changes it, so the velocity of rolling follows from it without the roundings of the way there, and a body
/// that has none comes to rest, not to 1e-16 m/s.
fn settle(
    moment: &mut Moment,
    what: Happening,
    pace: Pace,
    ground: f64,
    (about, kappa): (&mut f64, f64),
) -> Happening {
    if what == Happening::RollingBegins {
        moment.slip = 0.0;
        if pace.turning == Hold::Held {
            (moment.velocity, *about) = (ground, ground);
        } else {
            moment.velocity = (*about + kappa * ground) / (1.0 + kappa);
            moment.rim_speed = (*about - ground) / (1.0 + kappa);
        }
    } else {
        moment.rim_speed = 0.0;
        if pace.slipping == Hold::Held {
            (moment.velocity, *about) = (ground, ground);
        }
    }
    if moment.slip == 0.0 && moment.rim_speed == 0.0 {
        Happening::Rest
    } else {
        what
    }
}

impl Stretch {
    /// The body so long after the start.
    pub fn at(&self, t: f64) -> Moment {
        let (from, pace, load) = (&self.moment, &self.pace, &self.load);
        let advance = t * (from.velocity + 0.5 * t * pace.velocity);
        let turn = t * (from.rim_speed + 0.5 * t * pace.rim_speed);
        // What friction takes from the slip, and the couple from the turning, is heat.
        let slid = t * (from.slip + 0.5 * t * pace.slip);
        let ground = match self.sheet {
            Some([speed, slope, _]) if self.on_sheet => t * (speed + 0.5 * t * slope),
            _ => 0.0,
        };
        Moment {
            position: from.position + advance,
            velocity: from.velocity + t * pace.velocity,
            rim_speed: from.rim_speed + t * pace.rim_speed,
            slip: from.slip + t * pace.slip,
            turned: from.turned + turn,
            heat: from.heat - pace.friction * slid - pace.couple * turn,
            work: from.work + load.push * advance + load.twist * turn + pace.friction * ground,
        }
    }

    /// From the sheet's edge to the point of contact so long after the start; zero without a sheet.
    pub fn margin_at(&self, t: f64) -> f64 {
        self.sheet.map_or(0.0, |[speed, slope, margin]| {
            let advance = t * (self.moment.velocity + 0.5 * t * self.pace.velocity);
            margin + (advance - t * (speed + 0.5 * t * slope))
        })
    }

    /// The rates of the moment's numbers and of that distance, for the numbers so long after the start: what [`at`](Self::at) integrates.
    pub fn rates(&self, t: f64, numbers: &[f64; 8]) -> [f64; 8] {
        let [_, velocity, rim_speed, slip, ..] = *numbers;
        let (pace, load) = (&self.pace, &self.load);
        let heating = -pace.friction * slip - pace.couple * rim_speed;
        let working =
            load.push * velocity + load.twist * rim_speed + pace.friction * self.ground_speed(t);
        [
            velocity,
            pace.velocity,
            pace.rim_speed,
            pace.slip,
            rim_speed,
            heating,
            working,
            velocity - self.sheet_speed(t),
        ]
    }

    /// What can end the stretch, each with a number that is positive until it does.
    pub fn ends(&self, numbers: &[f64; 8]) -> impl Iterator<Item = (f64, Happening)> {
        let [_, _, rim_speed, slip, _, _, _, margin] = *numbers;
        let toward = |hold, value, what| match hold {
            Hold::Goes(sign) => Some((sign * value, what)),
            _ => None,
        };
        let edge = self.sheet.map(|_| match self.on_sheet {
            true => (margin, Happening::LeavesSheet),
            false => (-margin, Happening::MountsSheet),
        });
        let slips = toward(self.pace.slipping, slip, Happening::RollingBegins);
        let turns = toward(self.pace.turning, rim_speed, Happening::TurningStops);
        [slips, turns, edge].into_iter().flatten()
    }

    /// What ends the stretch before `longest` is over, and after how long.
    pub fn next(&self, longest: f64) -> Option<(f64, Happening)> {
        let (pace, from) = (&self.pace, &self.moment);
        let fall = |hold, value: f64, rate: f64| match hold {
            Hold::Goes(sign) => falls(sign * value, sign * rate),
            _ => None,
        };
        let edge = self.sheet.and_then(|[speed, slope, margin]| {
            let (drift, bend) = (from.velocity - speed, pace.velocity - slope);
            match self.on_sheet {
                true => crosses(margin, drift, bend).map(|t| (t, Happening::LeavesSheet)),
                false => crosses(-margin, -drift, -bend).map(|t| (t, Happening::MountsSheet)),
            }
        });
        let slips = fall(pace.slipping, from.slip, pace.slip);
        let turns = fall(pace.turning, from.rim_speed, pace.rim_speed);
        let all = [
            slips.map(|t| (t, Happening::RollingBegins)),
            turns.map(|t| (t, Happening::TurningStops)),
            edge,
        ];
        let mut soonest = None;
        for (t, what) in all.into_iter().flatten() {
            if t < soonest.map_or(longest, |(sooner, _)| sooner) {
                soonest = Some((t, what));
            }
        }
        soonest
    }

    fn sheet_speed(&self, t: f64) -> f64 {
        self.sheet
            .map_or(0.0, |[speed, slope, _]| speed + t * slope)
    }

    fn ground_speed(&self, t: f64) -> f64 {
        if self.on_sheet {
            self.sheet_speed(t)
        } else {
            0.0
        }
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
    let square = rate * rate - 2.0 * bend * value;
    if square < 0.0 {
        return None;
    }
    // The stable root of the two, whichever sign the rate has.
    if rate < 0.0 {
        Some(2.0 * value / (square.sqrt() - rate))
    } else if bend < 0.0 {
        Some((-rate - square.sqrt()) / bend)
    } else {
        None
    }
}
