//! Which way the contact slips and the body turns, and the constant accelerations that follow.

use super::forces::{Coulomb, Friction, Resistance};
use super::moment::{Happening, Load, Moment};
use crate::rolling::sheet::Support;

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

    /// What changes V + κRΩ: everything but friction.
    pub(crate) fn moment_about_the_table(&self, pace: &Pace) -> f64 {
        self.load.push + self.load.twist + pace.couple
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
///
/// `about` is V + κRΩ. No friction changes it, so the velocity of rolling follows from it without the roundings of the way there, and a body
/// that has none comes to rest, not to 1e-16 m/s.
pub(crate) fn settle(
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
