//! From event to event: a round body under dry friction, rolling resistance, a steady pull and a moving sheet.
//!
//! Per mass, with friction f, the couple m of rolling resistance, a pull p along the table and its moment q about the centre:
//! V' = p + f and κ(RΩ)' = q + m − f. As long as the contact slips one way, or sticks, all of these are constants; so positions
//! are quadratics in time, and the times at which something changes are roots of linear and quadratic equations.
//!
//! What may be absent is a type parameter; for the type that is not there ([`Friction::ACTS`] false) nothing is compiled.

use super::sheet::Support;
use crate::error::{Error, Result, finite, not_negative, positive};

/// Dry friction between body and ground.
pub trait Friction: Copy {
    /// Whether there is any.
    const ACTS: bool;
    /// Coefficient while the contact slips.
    fn kinetic(&self) -> f64;
    /// Greatest ratio of friction to reaction while it sticks.
    fn grip(&self) -> f64;
}

/// Coulomb's law: μ times the reaction against the slip; up to `grip` times the reaction while the contact sticks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coulomb {
    kinetic: f64,
    grip: f64,
}

impl Coulomb {
    pub(crate) const NONE: Self = Self {
        kinetic: 0.0,
        grip: 0.0,
    };

    /// One coefficient μ (dimensionless) for slipping and sticking.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::Negative`].
    pub fn new(coefficient: f64) -> Result<Self> {
        Self::with_grip(coefficient, coefficient)
    }

    /// A coefficient for slipping, and a greater one that has to be overcome first.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::Negative`]; [`Error::Condition`] if the grip is less than the sliding friction.
    pub fn with_grip(kinetic: f64, grip: f64) -> Result<Self> {
        let kinetic = not_negative("the coefficient of friction", kinetic)?;
        let grip = not_negative("the coefficient of static friction", grip)?;
        if grip < kinetic {
            return Err(Error::Condition {
                condition: "static friction must not be less than sliding friction",
                value: grip,
            });
        }
        Ok(Self { kinetic, grip })
    }
}

impl Friction for Coulomb {
    const ACTS: bool = true;
    fn kinetic(&self) -> f64 {
        self.kinetic
    }
    fn grip(&self) -> f64 {
        self.grip
    }
}

/// What resists the turning itself.
pub trait Resistance: Copy {
    /// Whether there is any.
    const ACTS: bool;
    /// Lever arm of the reaction over the radius.
    fn arm(&self) -> f64;
}

/// Rolling resistance: the reaction acts ahead of the centre by `arm` radii, a couple against the turning.
///
/// A body that rolls freely then slows down by arm·g/(1+κ), and one that is towed at constant speed takes a force of arm times
/// its weight. Billiard cloth: 0.005 to 0.015.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingResistance {
    arm: f64,
}

impl RollingResistance {
    /// The coefficient, dimensionless.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::Negative`].
    pub fn new(arm: f64) -> Result<Self> {
        Ok(Self {
            arm: not_negative("the coefficient of rolling resistance", arm)?,
        })
    }
}

impl Resistance for RollingResistance {
    const ACTS: bool = true;
    fn arm(&self) -> f64 {
        self.arm
    }
}

/// The friction, resistance or sheet that is not there.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Nothing;

impl Friction for Nothing {
    const ACTS: bool = false;
    fn kinetic(&self) -> f64 {
        0.0
    }
    fn grip(&self) -> f64 {
        0.0
    }
}

impl Resistance for Nothing {
    const ACTS: bool = false;
    fn arm(&self) -> f64 {
        0.0
    }
}

/// A steady load on the body, per mass, m/s².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    /// Pull along the table.
    pub push: f64,
    /// Moment about the centre over MR, positive the way the body rolls.
    pub twist: f64,
    /// Reaction of the ground; positive.
    pub reaction: f64,
}

impl Load {
    /// Weight alone, for gravity g (m/s²).
    pub const fn weight(gravity: f64) -> Self {
        Self {
            push: 0.0,
            twist: 0.0,
            reaction: gravity,
        }
    }
}

/// Where the body is and how it moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment {
    /// Position of the centre along the table, m.
    pub position: f64,
    /// Velocity V of the centre, m/s.
    pub velocity: f64,
    /// Rim speed RΩ, m/s.
    pub rim_speed: f64,
    /// Velocity of the contact point over the ground under it, m/s. While the ground rests it is V − RΩ, kept apart from the two
    /// so that nothing cancels when it is small.
    pub slip: f64,
    /// What the rim has turned, R times the angle, m.
    pub turned: f64,
    /// Heat of friction and rolling resistance so far, J/kg.
    pub heat: f64,
    /// Work that the pull and a moving sheet have done on the body so far, J/kg.
    pub work: f64,
}

impl Moment {
    /// At rest at the origin.
    pub const fn at_rest() -> Self {
        Self {
            position: 0.0,
            velocity: 0.0,
            rim_speed: 0.0,
            slip: 0.0,
            turned: 0.0,
            heat: 0.0,
            work: 0.0,
        }
    }

    /// At the origin with this velocity and rim speed (m/s), over ground at rest. Where the slip is known better than as the difference of
    /// the two, set it.
    pub const fn moving(velocity: f64, rim_speed: f64) -> Self {
        Self {
            velocity,
            rim_speed,
            slip: velocity - rim_speed,
            ..Self::at_rest()
        }
    }

    /// Kinetic energy per mass, ½(V² + κ(RΩ)²), J/kg.
    pub fn energy(&self, kappa: f64) -> f64 {
        0.5 * (self.velocity * self.velocity + kappa * self.rim_speed * self.rim_speed)
    }

    /// Angular momentum about the line of contact over MR: V + κRΩ, m/s. No friction changes it.
    pub fn about_the_table(&self, kappa: f64) -> f64 {
        self.velocity + kappa * self.rim_speed
    }
}

/// What happens between two stretches of a course.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Happening {
    /// The contact stops slipping: rolling begins.
    RollingBegins,
    /// The contact begins to slip.
    SlippingBegins,
    /// The turning stops for an instant or for good.
    TurningStops,
    /// The body has come to rest on the ground.
    Rest,
    /// The sheet's edge has passed under the body: now it is on the table.
    LeavesSheet,
    /// The sheet has come back under the body.
    MountsSheet,
}

/// What happened, and when.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// Time, s.
    pub time: f64,
    /// What.
    pub what: Happening,
    /// The body then.
    pub moment: Moment,
}

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
    pub(crate) slipping: Hold,
    pub(crate) turning: Hold,
    /// Friction f and couple m per mass.
    pub(crate) friction: f64,
    pub(crate) couple: f64,
    /// V', (RΩ)', the ground's.
    pub(crate) velocity: f64,
    pub(crate) rim_speed: f64,
    pub(crate) ground: f64,
}

/// Everything about the motion that does not change.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Laws<F, C> {
    pub(crate) kappa: f64,
    pub(crate) load: Load,
    pub(crate) friction: F,
    pub(crate) resistance: C,
}

impl<F: Friction, C: Resistance> Laws<F, C> {
    /// Friction and couple for this slip and rim speed, on ground that accelerates: the one assignment of "goes one way" and "is held" that
    /// agrees with its own consequences. Held comes first, so a contact that can stick does.
    pub(crate) fn pace(&self, friction: F, slip: f64, rim_speed: f64, ground: f64) -> Pace {
        let mut first = None;
        for slipping in candidates(F::ACTS, slip) {
            for turning in candidates(C::ACTS, rim_speed) {
                let (Some(slipping), Some(turning)) = (slipping, turning) else {
                    continue;
                };
                let (pace, agrees) = self.consequence(friction, slipping, turning, ground);
                let agrees = agrees
                    && (slip != 0.0 || starts(slipping, pace.velocity - pace.rim_speed - ground))
                    && (rim_speed != 0.0 || starts(turning, pace.rim_speed));
                if agrees {
                    return pace;
                }
                first.get_or_insert(pace);
            }
        }
        // There is always one, up to a rounding that decides between two that differ by as little.
        first.unwrap_or_else(|| self.consequence(friction, Hold::Free, Hold::Free, ground).0)
    }

    fn consequence(&self, law: F, slipping: Hold, turning: Hold, ground: f64) -> (Pace, bool) {
        let (kappa, load) = (self.kappa, self.load);
        let (push, twist, reaction) = (load.push, load.twist, load.reaction);
        let mut couple = match turning {
            Hold::Goes(sign) => Some(-sign * self.resistance.arm() * reaction),
            Hold::Free => Some(0.0),
            Hold::Held => None,
        };
        let friction = match (slipping, couple) {
            (Hold::Free, _) => 0.0,
            (Hold::Goes(sign), _) => -sign * law.kinetic() * reaction,
            (Hold::Held, Some(m)) => (kappa * (ground - push) + twist + m) / (1.0 + kappa),
            (Hold::Held, None) => ground - push,
        };
        let m = *couple.get_or_insert(friction - twist);
        let velocity = push + friction;
        let rim_speed = match turning {
            Hold::Held => 0.0,
            // On the same footing as the velocity, so that rolling stays rolling.
            _ if slipping == Hold::Held => velocity - ground,
            _ => (twist + m - friction) / kappa,
        };
        let pace = Pace {
            slipping,
            turning,
            friction,
            couple: m,
            velocity,
            rim_speed,
            ground,
        };
        let sticks = slipping != Hold::Held || friction.abs() <= law.grip() * reaction;
        let stays = turning != Hold::Held || m.abs() <= self.resistance.arm() * reaction;
        (pace, sticks && stays)
    }
}

/// Ways a quantity with this value can go on.
fn candidates(acts: bool, value: f64) -> [Option<Hold>; 3] {
    if !acts {
        [Some(Hold::Free), None, None]
    } else if value != 0.0 {
        [Some(Hold::Goes(value.signum())), None, None]
    } else {
        [
            Some(Hold::Held),
            Some(Hold::Goes(1.0)),
            Some(Hold::Goes(-1.0)),
        ]
    }
}

/// Whether a quantity at zero, with this rate, goes the way it is said to go.
fn starts(hold: Hold, rate: f64) -> bool {
    match hold {
        Hold::Goes(sign) => sign * rate > 0.0,
        _ => true,
    }
}

/// One stretch: constant accelerations from a moment on.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    start: f64,
    moment: Moment,
    pace: Pace,
    load: Load,
    /// Speed and acceleration of the sheet, and from its edge to the point of contact.
    sheet: [f64; 2],
    margin: f64,
    on_sheet: bool,
}

impl Stretch {
    fn at(&self, t: f64) -> Moment {
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
    fn next<S: Support>(&self, longest: f64) -> Option<(f64, Happening)> {
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

    fn sheet_advance(&self, t: f64) -> f64 {
        t * (self.sheet[0] + 0.5 * t * self.sheet[1])
    }

    fn margin_at(&self, t: f64) -> f64 {
        let advance = t * (self.moment.velocity + 0.5 * t * self.pace.velocity);
        self.margin + (advance - self.sheet_advance(t))
    }
}

/// Speed and acceleration of the sheet now, and when its leg ends; at rest for ever without one.
pub(crate) fn ground_now<S: Support>(sheet: S, leg: usize, now: f64) -> ([f64; 2], f64) {
    if S::ACTS {
        let (from, to) = sheet.leg(leg);
        let slope = slope(from, to);
        ([from.1 + (now - from.0) * slope, slope], to.0)
    } else {
        ([0.0; 2], f64::INFINITY)
    }
}

/// By how much the sheet's speed jumps in this leg, if it is one of no duration.
pub(crate) fn jerk<S: Support>(sheet: S, leg: usize) -> f64 {
    let (from, to) = sheet.leg(leg);
    if to.0 > from.0 { 0.0 } else { to.1 - from.1 }
}

/// The laws on the sheet.
pub(crate) fn on<F: Friction, C: Resistance, S: Support>(
    sheet: S,
    laws: &Laws<F, C>,
) -> Laws<Coulomb, C> {
    Laws {
        kappa: laws.kappa,
        load: laws.load,
        friction: sheet.law(),
        resistance: laws.resistance,
    }
}

/// Makes zero what has just become zero, and says what that means.
pub(crate) fn settle(moment: &mut Moment, what: Happening, pace: Pace, ground: f64) -> Happening {
    if what == Happening::RollingBegins {
        moment.slip = 0.0;
        // The velocity is the better known of the two, unless the spin is dead.
        if pace.turning == Hold::Held {
            moment.velocity = ground;
        } else {
            moment.rim_speed = moment.velocity - ground;
        }
    } else {
        moment.rim_speed = 0.0;
        if pace.slipping == Hold::Held {
            moment.velocity = ground;
        }
    }
    if moment.slip == 0.0 && moment.rim_speed == 0.0 {
        Happening::Rest
    } else {
        what
    }
}

/// A motion from event to event, whole.
#[derive(Debug, Clone)]
pub struct Course {
    kappa: f64,
    stretches: Vec<Stretch>,
    events: Vec<Event>,
    has_sheet: bool,
}

/// More stretches than this and something is wrong.
const MOST_STRETCHES: usize = 1_000_000;

impl Course {
    /// The course of a body of inertia factor `kappa`, from `start`, up to the time `until` (s).
    ///
    /// `start.slip` is taken as given; make it V − RΩ − (speed of the ground). Position is exact in each stretch: the errors are
    /// roundings. Observed against DOP853 with events: 3e-15 of the largest speed. Cost: a few microseconds a course.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for the reaction or κ; [`Error::NotFinite`]; [`Error::Integration`] after a million events.
    pub fn new<F: Friction, C: Resistance, S: Support>(
        kappa: f64,
        load: Load,
        (friction, resistance, sheet): (F, C, S),
        start: Moment,
        until: f64,
    ) -> Result<Self> {
        let kappa = positive("the inertia factor", kappa)?;
        positive("the reaction of the ground", load.reaction)?;
        finite("the pull", load.push)?;
        finite("the twist", load.twist)?;
        let until = finite("the time", until)?.max(0.0);
        for value in [start.position, start.velocity, start.rim_speed, start.slip] {
            finite("the start", value)?;
        }
        let laws = Laws {
            kappa,
            load,
            friction,
            resistance,
        };
        let mut course = Self {
            kappa,
            stretches: Vec::new(),
            events: Vec::new(),
            has_sheet: S::ACTS,
        };
        course.run::<F, C, S>(&laws, sheet, start, until)?;
        Ok(course)
    }

    fn run<F: Friction, C: Resistance, S: Support>(
        &mut self,
        laws: &Laws<F, C>,
        sheet: S,
        start: Moment,
        until: f64,
    ) -> Result<()> {
        let mut moment = start;
        let (mut now, mut leg, mut on_sheet) = (0.0, 0, S::ACTS);
        let mut margin = if S::ACTS { sheet.margin() } else { 0.0 };
        let mut slipped = moment.slip != 0.0;
        while self.stretches.len() < MOST_STRETCHES {
            let (motion, leg_ends) = ground_now(sheet, leg, now);
            let mut pace = if S::ACTS && on_sheet {
                on(sheet, laws).pace(sheet.law(), moment.slip, moment.rim_speed, motion[1])
            } else {
                laws.pace(laws.friction, moment.slip, moment.rim_speed, 0.0)
            };
            if pace.slipping == Hold::Held && pace.turning == Hold::Held {
                pace.rim_speed = 0.0;
            }
            let slips = pace.slipping != Hold::Held;
            if slips && !slipped && pace.slipping != Hold::Free {
                self.note(now, Happening::SlippingBegins, moment);
            }
            slipped = slips;
            let stretch = Stretch {
                start: now,
                moment,
                pace,
                load: laws.load,
                sheet: motion,
                margin,
                on_sheet,
            };
            self.stretches.push(stretch);
            let ends = leg_ends.min(until);
            let Some((wait, what)) = stretch.next::<S>(ends - now) else {
                if leg_ends >= until {
                    return Ok(());
                }
                (moment, margin) = (stretch.at(ends - now), stretch.margin_at(ends - now));
                now = ends;
                if S::ACTS && on_sheet {
                    moment.slip -= jerk(sheet, leg);
                }
                leg += 1;
                continue;
            };
            now += wait;
            (moment, margin) = (stretch.at(wait), stretch.margin_at(wait));
            let sheet_speed = motion[0] + wait * motion[1];
            match what {
                Happening::LeavesSheet | Happening::MountsSheet => {
                    (on_sheet, margin) = (!on_sheet, 0.0);
                    let ground = if on_sheet { sheet_speed } else { 0.0 };
                    moment.slip = moment.velocity - moment.rim_speed - ground;
                    self.note(now, what, moment);
                }
                _ => {
                    let ground = if on_sheet { sheet_speed } else { 0.0 };
                    let what = settle(&mut moment, what, pace, ground);
                    self.note(now, what, moment);
                }
            }
        }
        Err(Error::Integration {
            reason: "more than a million events",
            time: now,
        })
    }

    fn note(&mut self, time: f64, what: Happening, moment: Moment) {
        self.events.push(Event { time, what, moment });
    }

    /// The body at the time `t` (s), 0 up to the end of the course; outside, the nearest of the two stretches is continued.
    pub fn at(&self, t: f64) -> Moment {
        let stretch = self.stretch(t);
        stretch.at(t - stretch.start)
    }

    /// From the sheet's edge to the point of contact at the time `t` (s), m; negative: the body is off the sheet. None without a sheet.
    pub fn margin(&self, t: f64) -> Option<f64> {
        let stretch = self.stretch(t);
        self.has_sheet.then(|| stretch.margin_at(t - stretch.start))
    }

    fn stretch(&self, t: f64) -> &Stretch {
        let place = self.stretches.partition_point(|s| s.start <= t);
        &self.stretches[place.saturating_sub(1)]
    }

    /// What happens, in order.
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// The first of a kind.
    pub fn first(&self, what: Happening) -> Option<&Event> {
        self.events.iter().find(|event| event.what == what)
    }

    /// Inertia factor κ.
    pub fn kappa(&self) -> f64 {
        self.kappa
    }

    /// How many closed forms it is made of.
    pub fn stretches(&self) -> usize {
        self.stretches.len()
    }
}

fn slope(from: (f64, f64), to: (f64, f64)) -> f64 {
    if to.0 > from.0 && to.0.is_finite() {
        (to.1 - from.1) / (to.0 - from.0)
    } else {
        0.0
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
