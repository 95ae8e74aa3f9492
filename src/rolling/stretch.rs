//! One stretch of a [`Course`](super::course::Course): which way the contact slips and the body turns, the constant accelerations that follow,
//! and the roots at which it ends.

use super::friction::{Coulomb, RollingResistance};
use super::moment::{Contact, Happening, Load, Moment, State};
use super::sheet::Sheet;
use crate::error::{Result, finite, positive};

/// How the contact slips or the body turns: one way, with the sign +1 or −1; 0 where no law acts on it. `None` where it is zero and held there.
type Sense = Option<f64>;

/// The friction of the ground and its acceleration.
type Ground = (Option<Coulomb>, f64);

/// Constant accelerations of one stretch.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Pace {
    pub slipping: Sense,
    pub turning: Sense,
    /// Friction f and couple m per mass.
    friction: f64,
    couple: f64,
    /// V', (RΩ)', and that of the slip.
    rates: [f64; 3],
}

/// The laws and constants of the motion.
#[derive(Debug, Clone)]
pub(crate) struct Laws {
    pub kappa: f64,
    pub load: Load,
    pub friction: Option<Coulomb>,
    pub resistance: Option<RollingResistance>,
    pub sheet: Option<Sheet>,
}

/// A stretch of the motion with constant accelerations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stretch {
    pub start: f64,
    pub state: State,
    pub pace: Pace,
    /// Time at which the sheet's acceleration changes.
    pub leg_ends: f64,
    load: Load,
    leg: usize,
    /// Speed and acceleration of the sheet.
    sheet: [f64; 2],
    /// Whether the body is on the sheet, if there is one.
    pub on_sheet: Option<bool>,
    /// V + κRΩ at the start.
    about: f64,
}

impl Laws {
    pub fn new(kappa: f64, load: Load, (friction, resistance, sheet): Contact<'_>) -> Self {
        Self {
            kappa,
            load,
            friction,
            resistance,
            sheet: sheet.cloned(),
        }
    }

    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite).
    pub fn checked(&self) -> Result<&Self> {
        positive("the reaction of the ground", self.load.reaction)?;
        finite("the pull", self.load.push)?;
        finite("the twist", self.load.twist)?;
        positive("the inertia factor", self.kappa)?;
        Ok(self)
    }

    /// The accelerations for this slip and rim speed on this ground: from the one assignment of "goes one way" and "is held" that
    /// is consistent with its own consequences. "Held" is tried first, so a contact that can stick does.
    fn pace(&self, ground: Ground, state: &State) -> Pace {
        let [_, _, rim_speed, slip, ..] = *state;
        let turns = candidates(self.resistance.is_some(), rim_speed);
        let slips = candidates(ground.0.is_some(), slip);
        for &slipping in slips {
            for &turning in turns {
                let (pace, agrees) = self.consequence(ground, [slipping, turning], state);
                if agrees {
                    return pace;
                }
            }
        }
        // One of them is always consistent, but for rounding, which may exclude two that nearly agree; then either will do.
        self.consequence(ground, [slips[0], turns[0]], state).0
    }

    /// The accelerations under one such assignment, and whether it agrees with them: friction and couple can hold what it calls held, and what begins to go
    /// goes the way assumed.
    fn consequence(&self, ground: Ground, senses: [Sense; 2], state: &State) -> (Pace, bool) {
        let (&Self { kappa, load, .. }, (law, ground)) = (self, ground);
        let [slipping, turning] = senses;
        let (push, twist, reaction) = (load.push, load.twist, load.reaction);
        let slides = law.map_or(0.0, |law| law.kinetic) * reaction;
        let grips = law.map_or(0.0, |law| law.grip) * reaction;
        let resists = self.resistance.map_or(0.0, |law| law.arm) * reaction;
        let couple = turning.map(|sense| -sense * resists);
        let (friction, velocity) = match (slipping, couple) {
            (Some(sense), _) => (-sense * slides, push - sense * slides),
            (None, Some(m)) => (
                (kappa * (ground - push) + twist + m) / (1.0 + kappa),
                // Not by way of the friction: where the loads nearly balance, their sum keeps its digits.
                ((push + twist) + m + kappa * ground) / (1.0 + kappa),
            ),
            (None, None) => (ground - push, ground),
        };
        let couple = couple.unwrap_or(friction - twist);
        let rim_speed = match (turning, slipping) {
            (None, _) => 0.0,
            // Computed from the acceleration of the centre, so that rolling stays rolling.
            (_, None) => velocity - ground,
            _ => (twist + couple - friction) / kappa,
        };
        let slip = slipping.map_or(0.0, |_| velocity - rim_speed - ground);
        let agrees = |sense, value: f64, rate: f64, force: f64, most: f64| match sense {
            None => force.abs() <= most,
            Some(sense) => sense == 0.0 || value != 0.0 || sense * rate > 0.0,
        };
        let slips = agrees(slipping, state[3], slip, friction, grips);
        let turns = agrees(turning, state[2], rim_speed, couple, resists);
        let pace = Pace {
            slipping,
            turning,
            friction,
            couple,
            rates: [velocity, rim_speed, slip],
        };
        (pace, slips && turns)
    }

    /// The first stretch; the slip of `start` is relative to the ground as it moves then.
    pub fn first(&self, start: Moment) -> Stretch {
        let mut state = start.state();
        state[7] = self.sheet.as_ref().map_or(0.0, |sheet| sheet.margin);
        self.begun(Stretch {
            start: 0.0,
            state,
            pace: Pace::default(),
            leg_ends: f64::INFINITY,
            load: self.load,
            leg: 0,
            sheet: [0.0; 2],
            on_sheet: self.sheet.as_ref().map(|_| true),
            about: start.about_the_table(self.kappa),
        })
    }

    /// The stretch with the accelerations and the motion of the sheet that belong to its start.
    fn begun(&self, mut stretch: Stretch) -> Stretch {
        let mut ground = (self.friction, 0.0);
        if let Some(sheet) = &self.sheet {
            let on_sheet = stretch.on_sheet == Some(true);
            let (mut from, mut to) = sheet.speeds.leg(stretch.leg);
            while to.0 <= stretch.start {
                if on_sheet && to.0 <= from.0 {
                    // A jump in the sheet's speed.
                    stretch.state[3] -= to.1 - from.1;
                }
                stretch.leg += 1;
                (from, to) = sheet.speeds.leg(stretch.leg);
            }
            let slope = (to.1 - from.1) / (to.0 - from.0);
            stretch.leg_ends = to.0;
            stretch.sheet = [from.1 + (stretch.start - from.0) * slope, slope];
            if on_sheet {
                ground = (Some(sheet.friction), slope);
            }
        }
        stretch.pace = self.pace(ground, &stretch.state);
        stretch
    }

    /// The stretch that follows one that ended in this state `after` seconds from its start, by an event or because the sheet's acceleration changes; and the
    /// event.
    ///
    /// What has become zero is set to exactly zero. Friction does not change V + κRΩ, so the velocity of rolling is computed from it, free of accumulated
    /// rounding, and a body for which it is zero comes to rest exactly, not to 1e-16 m/s.
    pub fn after(
        &self,
        before: &Stretch,
        after: f64,
        state: &State,
        what: Option<Happening>,
    ) -> (Stretch, Option<Happening>) {
        let (kappa, pace) = (self.kappa, &before.pace);
        let (mut next, mut rests) = (*before, false);
        next.start = what.map_or(before.leg_ends, |_| before.start + after);
        next.state = *state;
        // Everything except friction changes V + κRΩ.
        next.about += after * (self.load.push + self.load.twist + pace.couple);
        let [_, velocity, rim_speed, slip, .., margin] = &mut next.state;
        if matches!(what, Some(Happening::LeavesSheet | Happening::MountsSheet)) {
            (next.on_sheet, *margin) = (next.on_sheet.map(|on| !on), 0.0);
        }
        let ground = match next.on_sheet {
            Some(true) => before.sheet_speed(after),
            _ => 0.0,
        };
        match what {
            None if pace.slipping.is_none() => {}
            // Also where no event ends it: slip that began to grow in a steep leg, at a rounded time, is off by as much.
            None | Some(Happening::LeavesSheet | Happening::MountsSheet) => {
                *slip = *velocity - *rim_speed - ground;
            }
            Some(Happening::RollingBegins) if pace.turning.is_some() => {
                *slip = 0.0;
                *velocity = (next.about + kappa * ground) / (1.0 + kappa);
                *rim_speed = (next.about - ground) / (1.0 + kappa);
                rests = *rim_speed == 0.0;
            }
            Some(_) if pace.slipping.is_some() && pace.turning.is_some() => {
                *rim_speed = 0.0;
                rests = *slip == 0.0;
            }
            // It no longer slips or turns.
            Some(_) => {
                (*slip, *rim_speed, rests) = (0.0, 0.0, true);
                (*velocity, next.about) = (ground, ground);
            }
        }
        let happened = if rests { Some(Happening::Rest) } else { what };
        (self.begun(next), happened)
    }
}

/// The states in which a quantity with this value can continue.
fn candidates(acts: bool, value: f64) -> &'static [Sense; 3] {
    match (acts, value) {
        (false, _) => &[Some(0.0); 3],
        (true, 0.0) => &[None, Some(1.0), Some(-1.0)],
        (true, value) if value > 0.0 => &[Some(1.0); 3],
        (true, _) => &[Some(-1.0); 3],
    }
}

impl Stretch {
    /// The state `t` seconds after the start: quadratics in time, whose mean rates are those half-way. (The second derivative of the heat, a product of
    /// two accelerations, may not be a double where the heat is.)
    pub fn at(&self, t: f64) -> State {
        let half = 0.5 * t;
        let speeds = core::array::from_fn(|n| self.state[n + 1] + half * self.pace.rates[n]);
        let rates = self.flow(speeds, self.pace.rates, self.sheet_speed(half));
        core::array::from_fn(|n| self.state[n] + t * rates[n])
    }

    /// The rates of the state `t` seconds after the start.
    pub fn rates(&self, t: f64, state: &State) -> State {
        let [_, velocity, rim_speed, slip, ..] = *state;
        let speeds = [velocity, rim_speed, slip];
        self.flow(speeds, self.pace.rates, self.sheet_speed(t))
    }

    /// The rates of the state, given the speeds V, RΩ and slip, their accelerations, and the speed of the sheet. The work of friction against
    /// the slip, and of the couple against the rotation, becomes heat.
    fn flow(&self, [velocity, rim_speed, slip]: [f64; 3], rates: [f64; 3], sheet: f64) -> State {
        let (load, pace) = (&self.load, &self.pace);
        let on_it = self.on_sheet == Some(true);
        let ground = if on_it { sheet } else { 0.0 };
        let heat = -pace.friction * slip - pace.couple * rim_speed;
        let work = load.push * velocity + load.twist * rim_speed + pace.friction * ground;
        let [v, w, u] = rates;
        [velocity, v, w, u, rim_speed, heat, work, velocity - sheet]
    }

    /// The events that can end the stretch, each with a number that is positive until it happens.
    pub fn ends(&self, state: &State) -> impl Iterator<Item = (f64, Happening)> {
        let [_, _, rim_speed, slip, _, _, _, margin] = *state;
        let toward = |sense: Sense, value, what| {
            let goes = sense.filter(|&sense| sense != 0.0);
            goes.map(|sense| (sense * value, what))
        };
        let edge = self.on_sheet.map(|on| match on {
            true => (margin, Happening::LeavesSheet),
            false => (-margin, Happening::MountsSheet),
        });
        let slips = toward(self.pace.slipping, slip, Happening::RollingBegins);
        let turns = toward(self.pace.turning, rim_speed, Happening::TurningStops);
        [slips, turns, edge].into_iter().flatten()
    }

    /// The first event that ends the stretch before `longest`, and the time until it.
    pub fn next(&self, longest: f64) -> Option<(f64, Happening)> {
        let rates = self.rates(0.0, &self.state);
        let bends = self.flow(self.pace.rates, [0.0; 3], self.sheet[1]);
        let motions = self.ends(&self.state).zip(self.ends(&rates));
        let motions = motions.zip(self.ends(&bends));
        let mut soonest = None;
        for (((value, what), (rate, _)), (bend, _)) in motions {
            if let Some(t) = falls(value, rate, bend)
                && t < soonest.map_or(longest, |(sooner, _)| sooner)
            {
                soonest = Some((t, what));
            }
        }
        soonest
    }

    fn sheet_speed(&self, t: f64) -> f64 {
        self.sheet[0] + t * self.sheet[1]
    }
}

/// The time at which value + rate t + ½ bend t², positive or about to become so, falls through zero. From zero it falls at once, or it rises first and may
/// come back.
fn falls(value: f64, rate: f64, bend: f64) -> Option<f64> {
    let value = value.max(0.0);
    if bend == 0.0 {
        return (rate < 0.0).then(|| -value / rate);
    }
    let square = rate * rate - 2.0 * bend * value;
    // The earlier root, in the form without cancellation for the sign of the rate.
    let root = if rate < 0.0 {
        2.0 * value / (square.sqrt() - rate)
    } else {
        (-rate - square.sqrt()) / bend
    };
    (square >= 0.0 && (rate < 0.0 || bend < 0.0)).then_some(root)
}
