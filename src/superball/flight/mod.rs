//! A superball in flight (tutorial 4.6): from the hand to the floor, to the underside of a table, and so on, with exact times.
//!
//! Horizontal velocity and spin change only in bounces, height only as gravity says; so every flight is a quadratic and its time a root
//! taken without cancellation. What may be absent is a type parameter, as in [`course`](crate::rolling::course).

mod effects;

pub use effects::{Gravity, Grip, Losses, Slipping, Weight};

use super::{BounceRotation, Motion, Surface, bounce, gripping_bounce};
use crate::error::{Error, Result, finite, not_negative, positive};
use crate::integrators::{Cost, Effort, Method, Stop, solve, until};
use crate::rolling::course::{Coulomb, Course, Load, Moment, Nothing};

/// A ball in the air, or just after a bounce.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InFlight {
    /// Position along the floor, m.
    pub position: f64,
    /// Height of the ball's lowest point above the floor, m.
    pub height: f64,
    /// Velocity upward, m/s.
    pub climb: f64,
    /// Velocity along the floor and rim speed, m/s.
    pub motion: Motion<f64>,
    /// Bounces so far.
    pub bounces: u64,
}

impl InFlight {
    /// Energy per mass, ½(V² + V_z² + κ(RΩ)²) + g·height, J/kg.
    pub fn energy(&self, kappa: f64, gravity: f64) -> f64 {
        0.5 * (self.motion.energy(kappa) + self.climb * self.climb) + gravity * self.height
    }
}

/// A ball, the room it has and what acts on it.
#[derive(Debug, Clone, Copy)]
pub struct Flight<G = Nothing, L = Nothing, P = Nothing> {
    kappa: f64,
    /// From floor to ceiling less the ball's diameter; infinite without a ceiling.
    room: f64,
    gravity: G,
    losses: L,
    grip: P,
    start: InFlight,
}

/// More bounces than this are not followed one by one.
const MOST_BOUNCES: u64 = 10_000_000;

impl<G: Gravity, L: Losses, P: Grip> Flight<G, L, P> {
    /// A ball of inertia factor κ (0…1, without the 0) that starts as `start`, in a room of height `room` (m; floor to ceiling less the ball's
    /// diameter, infinite for the open sky).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for κ or a start outside the room; [`Error::NotPositive`] for the room; [`Error::NotFinite`].
    pub fn new(
        kappa: f64,
        room: f64,
        (gravity, losses, grip): (G, L, P),
        start: InFlight,
    ) -> Result<Self> {
        let kappa = positive("the inertia factor", kappa)?;
        if kappa > 1.0 {
            return Err(Error::OutOfRange {
                quantity: "the inertia factor",
                value: kappa,
                least: 0.0,
                greatest: 1.0,
            });
        }
        if room != f64::INFINITY {
            positive("the height of the room", room)?;
        }
        finite("the position", start.position)?;
        finite("the velocity upward", start.climb)?;
        finite("the velocity", start.motion.velocity)?;
        finite("the rim speed", start.motion.rim_speed)?;
        if !(0.0..=room).contains(&finite("the height", start.height)?) {
            return Err(Error::OutOfRange {
                quantity: "the height",
                value: start.height,
                least: 0.0,
                greatest: room,
            });
        }
        Ok(Self {
            kappa,
            room,
            gravity,
            losses,
            grip,
            start,
        })
    }

    /// κ.
    pub fn kappa(&self) -> f64 {
        self.kappa
    }

    /// Acceleration of gravity, m/s², 0 if there is none.
    pub fn gravity(&self) -> f64 {
        if G::ACTS {
            self.gravity.strength()
        } else {
            0.0
        }
    }

    /// Whether the energy is kept and the bounces are reflections, so that [`Self::exact`] speaks of it.
    pub fn is_elastic(&self) -> bool {
        !L::ACTS && !P::ACTS
    }

    /// The next contact of a ball in flight: after how long, with which surface, and at which vertical velocity. None if it never comes down.
    fn contact(&self, ball: &InFlight) -> Option<(f64, Surface, f64)> {
        let (h, v) = (ball.height, ball.climb);
        if !G::ACTS || self.gravity.strength() == 0.0 {
            return if v < 0.0 {
                Some((-h / v, Surface::Floor, v))
            } else if v > 0.0 && self.room.is_finite() {
                Some(((self.room - h) / v, Surface::Ceiling, v))
            } else {
                None
            };
        }
        let g = self.gravity.strength();
        let left = self.room - h;
        if v > 0.0 && v * v > 2.0 * g * left {
            let speed = (v * v - 2.0 * g * left).sqrt();
            return Some((2.0 * left / (v + speed), Surface::Ceiling, speed));
        }
        let speed = (v * v + 2.0 * g * h).sqrt();
        // The root that does not cancel, for either sign of v; a ball that rests on the floor has none.
        let time = if v < 0.0 {
            2.0 * h / (speed - v)
        } else {
            (v + speed) / g
        };
        (speed > 0.0).then_some((time, Surface::Floor, -speed))
    }

    fn flown(&self, ball: &InFlight, t: f64) -> InFlight {
        let mut height = ball.height + t * ball.climb;
        let mut climb = ball.climb;
        if G::ACTS {
            let g = self.gravity.strength();
            height -= 0.5 * g * t * t;
            climb -= g * t;
        }
        InFlight {
            position: ball.position + t * ball.motion.velocity,
            height,
            climb,
            ..*ball
        }
    }

    /// A ball at a surface, after the bounce; `speed` is its vertical velocity on arrival.
    fn bounced(&self, ball: &InFlight, t: f64, surface: Surface, speed: f64) -> InFlight {
        let [normal, tangential] = if L::ACTS {
            self.losses.restitution()
        } else {
            [1.0; 2]
        };
        let motion = if P::ACTS {
            let most = self.grip.friction() * (1.0 + normal) * speed.abs();
            gripping_bounce(ball.motion, surface, self.kappa, tangential, most)
        } else if L::ACTS {
            super::bounce_with(ball.motion, surface, self.kappa, tangential)
        } else {
            bounce(ball.motion, surface, self.kappa)
        };
        InFlight {
            position: ball.position + t * ball.motion.velocity,
            height: match surface {
                Surface::Floor => 0.0,
                Surface::Ceiling => self.room,
            },
            climb: -normal * speed,
            motion,
            bounces: ball.bounces + 1,
        }
    }

    /// The ball at a time (s, 0 or later), elastic and non-slipping, without following the bounces: the n-th is a power of a
    /// rotation, all flights between two surfaces take the same time, and the places are a sum of rotations.
    ///
    /// Error: some units in the last place of the speeds; of the place, those of t/τ flights. Cost: two powers, whatever t.
    ///
    /// # Errors
    /// [`Error::Condition`] if the ball is not elastic; [`Error::NotFinite`], [`Error::Negative`] for the time.
    pub fn exact(&self, t: f64) -> Result<InFlight> {
        let t = not_negative("the time", t)?;
        if !self.is_elastic() {
            return Err(Error::Condition {
                condition: "the closed form is for a ball without losses and slipping",
                value: self.kappa,
            });
        }
        let Some((first_time, first, speed)) = self.contact(&self.start) else {
            return Ok(self.flown(&self.start, t));
        };
        if t < first_time {
            return Ok(self.flown(&self.start, t));
        }
        let arrived = self.bounced(&self.start, first_time, first, speed);
        let Some((flight, second, _)) = self.contact(&arrived) else {
            return Ok(self.flown(&arrived, t - first_time));
        };
        let whole = ((t - first_time) / flight).floor();
        let later = (t - first_time) - whole * flight;
        let count = whole as u64;
        let start = self.start.motion;
        let (motion, way) = if second == first {
            // The floor alone: two motions by turns.
            let odd = arrived.motion;
            let evens = (count / 2) as f64;
            let odds = (count - count / 2) as f64;
            let now = if count.is_multiple_of(2) { odd } else { start };
            (now, odds * odd.velocity + evens * start.velocity)
        } else {
            let rotation = BounceRotation::new(self.kappa)?;
            // Ceiling first is floor first in a mirror.
            let mirror = |m: Motion<f64>| match first {
                Surface::Floor => m,
                Surface::Ceiling => Motion {
                    rim_speed: -m.rim_speed,
                    ..m
                },
            };
            let seen = mirror(start);
            (
                mirror(rotation.after(seen, count + 1)),
                rotation.place(seen, count),
            )
        };
        // Between two surfaces the ball leaves each at the same speed every time.
        let surface = if second == first || count.is_multiple_of(2) {
            first
        } else {
            second
        };
        let climb = if surface == first {
            arrived.climb
        } else {
            let (_, _, landing) = self.contact(&arrived).unwrap_or((0.0, second, 0.0));
            -landing
        };
        let ball = InFlight {
            position: arrived.position + flight * way,
            height: match surface {
                Surface::Floor => 0.0,
                Surface::Ceiling => self.room,
            },
            climb,
            motion,
            bounces: count + 1,
        };
        Ok(self.flown(&ball, later))
    }

    /// When a ball that loses height at every bounce has made them all, s: the bounces pile up after finite time. None if they never end.
    ///
    /// From the first contact with the floor the flights are a geometric series, 2e_nV_z/(g(1−e_n)). Under a ceiling: from the first bounce
    /// after which it is out of reach, which this function follows.
    ///
    /// # Errors
    /// [`Error::Integration`] after ten million bounces below the ceiling.
    pub fn last_contact(&self) -> Result<Option<f64>> {
        let [normal, _] = self.restitution();
        if normal >= 1.0 || self.gravity() == 0.0 {
            return Ok(None);
        }
        let (mut time, mut ball) = (0.0, self.start);
        for _ in 0..MOST_BOUNCES {
            let Some((wait, surface, speed)) = self.contact(&ball) else {
                return Ok(Some(time));
            };
            time += wait;
            ball = self.bounced(&ball, wait, surface, speed);
            let climb = ball.climb;
            if surface == Surface::Floor && climb * climb <= 2.0 * self.gravity() * self.room {
                return Ok(Some(time + 2.0 * climb / (self.gravity() * (1.0 - normal))));
            }
        }
        Err(TOO_MANY)
    }

    fn restitution(&self) -> [f64; 2] {
        if L::ACTS {
            self.losses.restitution()
        } else {
            [1.0; 2]
        }
    }

    /// The ball at `times` (s, ascending from 0), bounce by bounce; after the last bounce it rolls, or slides until it rolls.
    ///
    /// # Errors
    /// [`Error::Integration`] after ten million bounces; [`Error::Condition`] for times after the last bounce of a ball with e_t = 1 that cannot
    /// slip, whose contact speed is reversed infinitely often and has no last value.
    pub fn followed(&self, times: &[f64]) -> Result<Vec<InFlight>> {
        let last = self.last_contact()?;
        let mut states = Vec::with_capacity(times.len());
        let (mut now, mut ball) = (0.0, self.start);
        let mut next = self.contact(&ball);
        for &t in times {
            let t = not_negative("the time", t)?;
            loop {
                let over = last.is_some_and(|last| t >= last);
                let Some((wait, surface, speed)) = next else {
                    break;
                };
                if !over && now + wait > t {
                    break;
                }
                // The last bounces of the pile cannot be told apart from its end.
                if last.is_some_and(|last| now + wait >= last || wait <= 1e-16 * last) {
                    break;
                }
                if ball.bounces - self.start.bounces >= MOST_BOUNCES {
                    return Err(TOO_MANY);
                }
                now += wait;
                ball = self.bounced(&ball, wait, surface, speed);
                next = self.contact(&ball);
            }
            states.push(match last {
                Some(last) if t >= last => self.on_the_floor(&ball, now, last, t)?,
                _ => self.flown(&ball, t - now),
            });
        }
        Ok(states)
    }

    fn on_the_floor(&self, ball: &InFlight, now: f64, last: f64, t: f64) -> Result<InFlight> {
        let [_, tangential] = self.restitution();
        let motion = ball.motion;
        let common = (motion.velocity + self.kappa * motion.rim_speed) / (1.0 + self.kappa);
        let landed = ball.position + (last - now) * motion.velocity;
        let (position, motion) = if P::ACTS {
            let start = Moment::moving(motion.velocity, motion.rim_speed);
            let effects = (Coulomb::new(self.grip.friction())?, Nothing, Nothing);
            let load = Load::weight(self.gravity());
            let course = Course::new(self.kappa, load, effects, start, t - last)?;
            let end = course.at(t - last);
            let motion = Motion {
                velocity: end.velocity,
                rim_speed: end.rim_speed,
            };
            (landed + end.position, motion)
        } else if tangential.abs() < 1.0 {
            let motion = Motion {
                velocity: common,
                rim_speed: common,
            };
            (landed + (t - last) * common, motion)
        } else if tangential == -1.0 {
            (landed + (t - last) * motion.velocity, motion)
        } else {
            return Err(Error::Condition {
                condition: "after infinitely many reversals of the contact speed there is no motion to speak of; tangential restitution must be below 1",
                value: tangential,
            });
        };
        Ok(InFlight {
            position,
            height: 0.0,
            climb: 0.0,
            motion,
            bounces: ball.bounces,
        })
    }

    /// The ball at `times` (s, ascending from 0): flights by a general method, contacts located as events, bounces by the law.
    ///
    /// # Errors
    /// As for [`until`]; [`Error::Integration`] after a hundred thousand bounces.
    pub fn integrated(
        &self,
        times: &[f64],
        (method, effort): (Method, Effort),
    ) -> Result<(Vec<InFlight>, Cost)> {
        let (mut now, mut ball) = (0.0, self.start);
        let (mut states, mut cost) = (Vec::with_capacity(times.len()), Cost::default());
        let end = times.last().copied().unwrap_or(0.0);
        let g = self.gravity();
        while ball.bounces - self.start.bounces < 100_000 {
            let velocity = ball.motion.velocity;
            let rate = |_: f64, y: &[f64; 3]| [velocity, y[2], -g];
            let room = self.room;
            let rising = ball.climb > 0.0;
            // Up and down again in one step would hide a contact, so a flight is cut at its summit.
            let to = if rising && g > 0.0 {
                end.min(now + ball.climb / g)
            } else {
                end
            };
            let guard = |_: f64, y: &[f64; 3]| if rising { room - y[1] } else { y[1] };
            let y = [ball.position, ball.height, ball.climb];
            let size = ball.climb.abs().max(velocity.abs()).max(1e-3);
            let samples: Vec<f64> = times[states.len()..]
                .iter()
                .copied()
                .take_while(|&t| t <= to)
                .collect();
            let scales = [size; 3];
            let passage = until(
                &rate, now, &y, &scales, &samples, to, &guard, method, effort,
            )?;
            cost += passage.cost;
            let flying = |y: &[f64; 3]| InFlight {
                position: y[0],
                height: y[1],
                climb: y[2],
                ..ball
            };
            states.extend(passage.states.iter().map(flying));
            let mut y = passage.end;
            now = passage.time;
            if passage.stopped == Stop::AtTheEnd {
                if to >= end {
                    return Ok((states, cost));
                }
                ball = InFlight {
                    climb: 0.0,
                    ..flying(&y)
                };
                continue;
            }
            // Newton's method along the true flight takes the located root to rounding.
            for _ in 0..8 {
                let speed = if rising { -y[2] } else { y[2] };
                let step = -guard(now, &y) / speed;
                if !step.is_finite() || step.abs() <= 4e-16 * now {
                    break;
                }
                let tight = Effort::Tolerance(1e-14);
                let short = solve(
                    &rate,
                    now,
                    &y,
                    &scales,
                    &[now + step],
                    Method::Dop853,
                    tight,
                )?;
                cost += short.cost;
                (now, y) = (now + step, short.states[0]);
            }
            states.truncate(times.partition_point(|&t| t <= now));
            let surface = if rising {
                Surface::Ceiling
            } else {
                Surface::Floor
            };
            let arrived = flying(&y);
            ball = self.bounced(&arrived, 0.0, surface, arrived.climb);
        }
        Err(TOO_MANY)
    }
}

const TOO_MANY: Error = Error::Integration {
    reason: "too many bounces to follow one by one",
    time: f64::INFINITY,
};
