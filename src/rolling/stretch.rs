//! One stretch of a [`Course`](super::course::Course): which way the contact slips and the body turns, the constant accelerations that follow,
//! and the roots at which it ends.

use super::friction::{Coulomb, RollingResistance};
use super::moment::{Contact, Happening, Load, Moment, State};
use super::sheet::Sheet;
use crate::error::{Result, finite, positive};

/// The state of slipping or of turning: free of any law, going one way, or held at zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Hold {
    /// No law acts on it.
    Free,
    /// It has this sign, +1 or −1.
    Goes(f64),
    /// It is zero and stays zero.
    Held,
}

/// Constant accelerations of one stretch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pace {
    pub slipping: Hold,
    pub turning: Hold,
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

    /// The accelerations for this slip and rim speed, on ground with the acceleration `ground`: from the one assignment of "goes one way" and "is held" that
    /// is consistent with its own consequences. "Held" is tried first, so a contact that can stick does.
    fn pace(&self, law: Option<Coulomb>, state: &State, ground: f64) -> Pace {
        let [_, _, rim_speed, slip, ..] = *state;
        // What begins to go must go the way assumed.
        let stalls = |hold, value: f64, rate: f64| matches!(hold, Hold::Goes(sign) if value == 0.0 && sign * rate <= 0.0);
        let mut first = None;
        for &slipping in candidates(law.is_some(), slip) {
            for &turning in candidates(self.resistance.is_some(), rim_speed) {
                let (pace, agrees) = self.consequence(law, [slipping, turning], ground);
                let [_, turns, slips] = pace.rates;
                if agrees && !stalls(slipping, slip, slips) && !stalls(turning, rim_speed, turns) {
                    return pace;
                }
                first.get_or_insert(pace);
            }
        }
        // One of them is always consistent, but for rounding, which may exclude two that nearly agree; then either will do.
        first.unwrap_or_else(|| self.consequence(None, [Hold::Free; 2], ground).0)
    }

    /// The accelerations under one such assignment, and whether friction and couple can then hold what it calls held.
    fn consequence(&self, law: Option<Coulomb>, holds: [Hold; 2], ground: f64) -> (Pace, bool) {
        let [slipping, turning] = holds;
        let (kappa, load) = (self.kappa, self.load);
        let (push, twist) = (load.push, load.twist);
        let slides = law.map_or(0.0, |law| law.kinetic) * load.reaction;
        let grips = law.map_or(0.0, |law| law.grip) * load.reaction;
        let resists = self.resistance.map_or(0.0, |law| law.arm) * load.reaction;
        let couple = match turning {
            Hold::Goes(sign) => Some(-sign * resists),
            Hold::Free => Some(0.0),
            Hold::Held => None,
        };
        let friction = match (slipping, couple) {
            (Hold::Free, _) => 0.0,
            (Hold::Goes(sign), _) => -sign * slides,
            (Hold::Held, Some(m)) => (kappa * (ground - push) + twist + m) / (1.0 + kappa),
            (Hold::Held, None) => ground - push,
        };
        let velocity = match (slipping, couple) {
            // Not by way of the friction: where the loads nearly balance, their sum keeps its digits.
            (Hold::Held, Some(m)) => ((push + twist) + m + kappa * ground) / (1.0 + kappa),
            (Hold::Held, None) => ground,
            _ => push + friction,
        };
        let couple = couple.unwrap_or(friction - twist);
        let rim_speed = match (turning, slipping) {
            (Hold::Held, _) => 0.0,
            // Computed from the acceleration of the centre, so that rolling stays rolling.
            (_, Hold::Held) => velocity - ground,
            _ => (twist + couple - friction) / kappa,
        };
        let slip = match slipping {
            Hold::Held => 0.0,
            _ => velocity - rim_speed - ground,
        };
        let pace = Pace {
            slipping,
            turning,
            friction,
            couple,
            rates: [velocity, rim_speed, slip],
        };
        let sticks = slipping != Hold::Held || friction.abs() <= grips;
        let stays = turning != Hold::Held || couple.abs() <= resists;
        (pace, sticks && stays)
    }

    /// The first stretch; the slip of `start` is relative to the ground as it moves then.
    pub fn first(&self, start: Moment) -> Stretch {
        let mut state = start.state();
        state[7] = self.sheet.as_ref().map_or(0.0, |sheet| sheet.margin);
        let on_sheet = self.sheet.as_ref().map(|_| true);
        self.begins((0.0, state), start.about_the_table(self.kappa), 0, on_sheet)
    }

    /// A stretch that begins in this leg of the sheet's motion.
    fn begins(
        &self,
        (start, mut state): (f64, State),
        about: f64,
        mut leg: usize,
        on_sheet: Option<bool>,
    ) -> Stretch {
        let (mut leg_ends, mut moves) = (f64::INFINITY, [0.0; 2]);
        let (mut law, mut ground) = (self.friction, 0.0);
        if let Some(sheet) = &self.sheet {
            let on_sheet = on_sheet == Some(true);
            let (mut from, mut to) = sheet.speeds.leg(leg);
            while to.0 <= start {
                if on_sheet && to.0 <= from.0 {
                    // A jump in the sheet's speed.
                    state[3] -= to.1 - from.1;
                }
                leg += 1;
                (from, to) = sheet.speeds.leg(leg);
            }
            let slope = (to.1 - from.1) / (to.0 - from.0);
            (leg_ends, moves) = (to.0, [from.1 + (start - from.0) * slope, slope]);
            if on_sheet {
                (law, ground) = (Some(sheet.friction), slope);
            }
        }
        Stretch {
            start,
            state,
            pace: self.pace(law, &state, ground),
            leg_ends,
            load: self.load,
            leg,
            sheet: moves,
            on_sheet,
            about,
        }
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
        let time = what.map_or(before.leg_ends, |_| before.start + after);
        // Everything except friction changes V + κRΩ.
        let moments = self.load.push + self.load.twist + pace.couple;
        let mut about = before.about + after * moments;
        let mut on_sheet = before.on_sheet;
        let sheet = before.sheet_speed(after);
        let ground = |on: Option<bool>| if on == Some(true) { sheet } else { 0.0 };
        let mut state = *state;
        let [_, velocity, rim_speed, slip, .., margin] = &mut state;
        let mut rests = false;
        match what {
            // Slip that began to grow in a steep leg, at a rounded time, is off by as much.
            None if pace.slipping != Hold::Held => {
                *slip = *velocity - *rim_speed - ground(on_sheet);
            }
            None => {}
            Some(Happening::LeavesSheet | Happening::MountsSheet) => {
                (on_sheet, *margin) = (on_sheet.map(|on| !on), 0.0);
                *slip = *velocity - *rim_speed - ground(on_sheet);
            }
            Some(Happening::RollingBegins) if pace.turning != Hold::Held => {
                *slip = 0.0;
                *velocity = (about + kappa * ground(on_sheet)) / (1.0 + kappa);
                *rim_speed = (about - ground(on_sheet)) / (1.0 + kappa);
                rests = *rim_speed == 0.0;
            }
            Some(_) if pace.slipping != Hold::Held && pace.turning != Hold::Held => {
                *rim_speed = 0.0;
                rests = *slip == 0.0;
            }
            // It no longer slips or turns.
            Some(_) => {
                (*slip, *rim_speed, rests) = (0.0, 0.0, true);
                (*velocity, about) = (ground(on_sheet), ground(on_sheet));
            }
        }
        let next = self.begins((time, state), about, before.leg, on_sheet);
        let happened = if rests { Some(Happening::Rest) } else { what };
        (next, happened)
    }
}

/// The states in which a quantity with this value can continue.
fn candidates(acts: bool, value: f64) -> &'static [Hold] {
    match (acts, value) {
        (false, _) => &[Hold::Free],
        (true, 0.0) => &[Hold::Held, Hold::Goes(1.0), Hold::Goes(-1.0)],
        (true, value) if value > 0.0 => &[Hold::Goes(1.0)],
        (true, _) => &[Hold::Goes(-1.0)],
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
        let toward = |hold, value, what| match hold {
            Hold::Goes(sign) => Some((sign * value, what)),
            _ => None,
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

/// The time at which value + rate t + ½ bend t², positive or about to become so, falls through zero.
fn falls(value: f64, rate: f64, bend: f64) -> Option<f64> {
    if value <= 0.0 {
        // Starting at zero: it falls at once, or it rises first and may come back.
        if rate < 0.0 || (rate == 0.0 && bend < 0.0) {
            return Some(0.0);
        }
        return (rate > 0.0 && bend < 0.0).then(|| -2.0 * rate / bend);
    }
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
