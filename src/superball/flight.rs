//! A superball in flight (tutorial 4.6): from the hand to the floor, to the underside of a table, and so on, with the times of the bounces.

use super::{BounceRotation, Motion, Restitution, Surface, bounce_with, gripping_bounce};
use crate::error::{
    Result, finite, not_negative, out_of_range, positive, refused, stopped, within,
};
use crate::precise::{DoubleDouble, Number};
use crate::rolling::{Coulomb, Course, Load, Moment};

/// A ball in the air, or just after a bounce.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct InFlight {
    /// Position along the floor, m.
    pub position: f64,
    /// Height of the ball's lowest point above the floor, m.
    pub height: f64,
    /// Velocity upward, m/s.
    pub climb: f64,
    /// Velocity along the floor and rim speed, m/s.
    pub motion: Motion<f64>,
    /// Bounces so far; of infinitely many, those that could be told apart from the end.
    pub bounces: u64,
}

impl InFlight {
    fn checked(self) -> Result<Self> {
        finite("the place of the ball", self.position)?;
        finite("the height of the ball", self.height)?;
        finite("its velocity upward", self.climb)?;
        finite("its velocity", self.motion.velocity)?;
        finite("its rim speed", self.motion.rim_speed)?;
        Ok(self)
    }

    /// Energy per mass, ½(V² + V_z² + κ(RΩ)²) + g·height, J/kg.
    pub(crate) fn energy(&self, kappa: f64, gravity: f64) -> f64 {
        0.5 * (self.motion.energy(kappa) + self.climb * self.climb) + gravity * self.height
    }
}

/// A ball, its room and the effects on it.
///
/// Horizontal velocity and spin change only in bounces, and gravity changes only the vertical velocity; so height is quadratic in time in every flight,
/// and the time of a flight is a root, taken without cancellation.
#[derive(Debug, Clone, Copy)]
pub struct Flight {
    pub(crate) kappa: f64,
    /// Height from floor to ceiling less the ball's diameter; infinite without a ceiling.
    pub(crate) room: f64,
    /// Acceleration of gravity, m/s², 0 if there is none.
    pub(crate) gravity: f64,
    pub(crate) losses: Option<Restitution>,
    pub(crate) grip: Option<Coulomb>,
    /// The start.
    pub(crate) start: InFlight,
}

/// Receives the time of a bounce, and may end the run there.
type Told<'a> = &'a dyn Fn(f64) -> Result<()>;

/// A time, s, and the number of bounces after which the ball is asked for, if it is given.
type Sample = (f64, Option<u64>);

/// The time until a ball meets a surface, the surface, and the vertical speed then.
type Contact = (DoubleDouble, Surface, DoubleDouble);

/// The time from which the flights form a geometric series, the ball as it leaves the floor then, and the time at which the bounces end.
type Pile = (f64, InFlight, f64);

/// A ball followed from bounce to bounce.
struct Followed {
    /// One addition for each bounce, with similar rounding errors each time: in twice the precision.
    now: DoubleDouble,
    ball: InFlight,
    next: Option<Contact>,
    pile: Option<Pile>,
}

/// Most bounces followed one by one.
const MOST_BOUNCES: u64 = 10_000_000;

/// 2⁵³: up to here every whole number is a double.
const MOST_FLIGHTS: f64 = 9_007_199_254_740_992.0;

/// Times whose ratio differs from 1 by no more than this count as the same.
const SAME: f64 = 1e-16;

impl Flight {
    /// A ball of inertia factor κ (0…1, without the 0) that starts as `start`, in a room of height `room` (m; floor to ceiling less the ball's
    /// diameter, infinite for the open sky), under gravity (m/s²), with losses in its bounces and a contact that may slip, each if it is there.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) for κ or a start outside the room; [`Error::NotPositive`](crate::Error::NotPositive) for the room; [`Error::Negative`](crate::Error::Negative) for gravity;
    /// [`Error::NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// use spinning_bodies::superball::{Flight, InFlight, Motion};
    /// let motion = Motion { velocity: 1.0, rim_speed: 0.0 };
    /// let start = InFlight { position: 0.0, height: 4.905, climb: 0.0, motion, bounces: 0 };
    /// // Without gravity it goes straight on.
    /// let flight = Flight::new(0.4, f64::INFINITY, (None, None, None), start)?;
    /// assert_eq!(flight.exact(3.0)?.position, 3.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(
        kappa: f64,
        room: f64,
        (gravity, losses, grip): (Option<f64>, Option<Restitution>, Option<Coulomb>),
        start: InFlight,
    ) -> Result<Self> {
        let flight = Self {
            kappa,
            room,
            gravity: gravity.unwrap_or(0.0),
            losses,
            grip,
            start,
        };
        flight.checked()
    }

    /// # Errors
    /// Those of [`new`](Self::new).
    pub(crate) fn checked(self) -> Result<Self> {
        positive("the inertia factor", self.kappa)?;
        let gravity = not_negative("the acceleration of gravity", self.gravity)?;
        if self.room != f64::INFINITY {
            positive("the height of the room", self.room)?;
        }
        let start = self.start.checked()?;
        // The terms of the speeds at the contacts.
        let doubled = finite("twice the acceleration of gravity", 2.0 * gravity)?;
        let energy = start.climb * start.climb + doubled * start.height;
        finite("twice the energy of the ball per mass", energy)?;
        within("the inertia factor", self.kappa, 0.0, 1.0)?;
        within("the height", start.height, 0.0, self.room)?;
        Ok(self)
    }

    /// Whether energy is conserved and the bounces are reflections, so that [`Self::exact`] applies.
    pub(crate) fn is_elastic(&self) -> bool {
        self.losses.is_none() && self.grip.is_none()
    }

    /// The speeds at which a ball in flight meets the floor, and the ceiling if it gets so high. Its vertical velocity is given in two words, for it is
    /// rounded at every bounce, and where hardly any speed is lost always the same way.
    fn speeds(&self, ball: &InFlight, climb: DoubleDouble) -> (DoubleDouble, Option<DoubleDouble>) {
        let (v, g) = (climb.magnitude(), self.gravity);
        let square = v.square();
        // Without a fall the speed is the ball's own, even where its square underflows.
        let after = |fall: DoubleDouble, sum: DoubleDouble| match fall.value() {
            0.0 => v,
            _ => sum.square_root(),
        };
        let fall = DoubleDouble::product(2.0 * g, ball.height);
        let floor = after(fall, square + fall);
        let rise = DoubleDouble::difference(self.room, ball.height).times(2.0 * g);
        let ceiling = square - rise;
        // The speed after a bounce is rounded: a ball that by it just reaches the ceiling only touches it.
        let rounding = match ball.bounces == self.start.bounces {
            true => 0.0,
            false => 4.0 * f64::EPSILON * square.value(),
        };
        let strikes = ceiling.value() > rounding || rise.value() == 0.0 && v.value() > 0.0;
        let reached = self.room.is_finite() && strikes;
        (floor, reached.then(|| after(rise, ceiling)))
    }

    /// The next contact of a ball in flight with this vertical velocity. `None` if the ball never comes down, or lies on the floor.
    fn contact(&self, ball: &InFlight, v: DoubleDouble) -> Option<Contact> {
        let (floor, ceiling) = self.speeds(ball, v);
        // The root in the form that does not cancel, for either sign of v.
        let (time, surface, speed) = match ceiling {
            Some(speed) if ball.climb > 0.0 => {
                let left = DoubleDouble::difference(self.room, ball.height);
                (left.scaled(2.0) / (v + speed), Surface::Ceiling, speed)
            }
            _ if ball.climb < 0.0 => {
                let fall = DoubleDouble::from(2.0 * ball.height);
                (fall / (floor - v), Surface::Floor, floor)
            }
            _ if self.gravity > 0.0 && floor.value() > 0.0 => {
                let time = (v + floor) / DoubleDouble::from(self.gravity);
                (time, Surface::Floor, floor)
            }
            _ => return None,
        };
        // A time that overflows counts as never.
        let happens = time.value().is_finite();
        happens.then_some((time, surface, speed))
    }

    /// Whether a ball lies on the floor.
    fn lies(&self, ball: &InFlight) -> bool {
        self.gravity > 0.0 && self.speeds(ball, ball.climb.into()).0.value() == 0.0
    }

    /// The ball after a time without contact.
    fn flown(&self, ball: &InFlight, t: f64) -> InFlight {
        let g = self.gravity;
        InFlight {
            position: ball.position + t * ball.motion.velocity,
            height: ball.height + t * ball.climb - 0.5 * g * t * t,
            climb: ball.climb - g * t,
            ..*ball
        }
    }

    /// The ball as it leaves a surface at this speed.
    fn leaving(&self, surface: Surface, speed: f64, ball: &InFlight) -> InFlight {
        let (height, climb) = match surface {
            Surface::Floor => (0.0, speed),
            Surface::Ceiling => (self.room, -speed),
        };
        InFlight {
            height,
            climb,
            ..*ball
        }
    }

    /// A ball at a surface, after the bounce; `speed` is the vertical speed at which it arrives.
    pub(crate) fn bounced(&self, ball: &InFlight, t: f64, off: Surface, speed: f64) -> InFlight {
        let [normal, tangential] = self.restitution();
        let (motion, kappa) = (ball.motion, self.kappa);
        let motion = match self.grip {
            Some(grip) => {
                let impulse = (1.0 + normal) * speed;
                gripping_bounce(motion, off, kappa, tangential, grip, impulse)
            }
            None => bounce_with(motion, off, kappa, tangential),
        };
        InFlight {
            position: ball.position + t * ball.motion.velocity,
            motion,
            bounces: ball.bounces.saturating_add(1),
            ..self.leaving(off, normal * speed, ball)
        }
    }

    /// The ball at a time (s, 0 or later), if it is elastic and does not slip, without following the bounces: the n-th motion is a power of a
    /// rotation, all flights between two surfaces take the same time, and positions are sums of rotations.
    ///
    /// The flights are counted in twice the precision, so the result is that of the exact doubles given, however late the time. Error: a few units in the last
    /// place of the largest speed and distance of a flight, and of the position if the ball travels away; observed up to 10¹⁴ s (8·10¹⁴ bounces),
    /// against 34 digits: 1e-15. Cost: two powers, whatever t.
    ///
    /// # Errors
    /// [`Error::Condition`](crate::Error::Condition) if the ball is not elastic, or lies on the floor and would slip; [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Negative`](crate::Error::Negative) for the
    /// time; [`Error::NotFinite`](crate::Error::NotFinite) for a position that overflows; [`Error::OutOfRange`](crate::Error::OutOfRange) beyond 2⁵³ flights, which a double cannot count.
    ///
    /// ```
    /// use spinning_bodies::superball::{Flight, InFlight, Motion};
    /// let motion = Motion { velocity: 1.0, rim_speed: 0.0 };
    /// let start = InFlight { position: 0.0, height: 1.0, climb: -1.0, motion, bounces: 0 };
    /// let flight = Flight::new(0.4, 1.0, (None, None, None), start)?;
    /// // It lands after one second and keeps 3/7 of its velocity.
    /// assert!((flight.exact(1.5)?.position - (1.0 + 0.5 * 3.0 / 7.0)).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn exact(&self, t: f64) -> Result<InFlight> {
        self.after_flights(not_negative("the time", t)?)?.checked()
    }

    fn after_flights(&self, t: f64) -> Result<InFlight> {
        if !self.is_elastic() {
            let condition = "for the closed form the ball must have no losses and must not slip";
            return refused(condition, self.kappa);
        }
        let start = &self.start;
        let Some((first_time, first, speed)) = self.contact(start, start.climb.into()) else {
            return match self.lies(start) {
                true => self.on_the_floor(start, start.position, t),
                false => Ok(self.flown(start, t)),
            };
        };
        let since = DoubleDouble::from(t) - first_time;
        if since.value() < 0.0 {
            return Ok(self.flown(start, t));
        }
        let arrived = self.bounced(start, first_time.value(), first, speed.value());
        let (floor, ceiling) = self.speeds(start, start.climb.into());
        let flight = match ceiling {
            Some(speed) => DoubleDouble::from(2.0 * self.room) / (floor + speed),
            None if self.gravity > 0.0 => floor.scaled(2.0) / DoubleDouble::from(self.gravity),
            None => return Ok(self.flown(&arrived, since.value())),
        };
        let mut whole = (since / flight).value().floor();
        if whole.is_nan() || whole >= MOST_FLIGHTS {
            let latest = flight.value() * MOST_FLIGHTS;
            return Err(out_of_range("the time", t, [0.0, latest]));
        }
        let mut later = since - flight.times(whole);
        if later.value() < 0.0 {
            // The quotient was rounded up to a whole number.
            (whole, later) = (whole - 1.0, later + flight);
        }
        let count = whole as u64;
        let even = count.is_multiple_of(2);
        let (motion, way) = if ceiling.is_some() {
            let rotation = BounceRotation::new(self.kappa)?;
            // A motion that meets the ceiling first is the mirror image of one that meets the floor first.
            let sense = if first == Surface::Floor { 1.0 } else { -1.0 };
            let mirror = |m: Motion<f64>| Motion::new(m.velocity, sense * m.rim_speed);
            let seen = mirror(start.motion);
            let way = flight.value() * rotation.place(seen, count);
            (mirror(rotation.after(seen, count + 1)), way)
        } else {
            // With the floor alone two motions alternate, that after the first bounce and that of the start.
            let v = start.motion.velocity;
            let slip = DoubleDouble::difference(v, start.motion.rim_speed);
            let kick = slip.times(2.0 * self.kappa) / DoubleDouble::sum(1.0, self.kappa);
            let kicked = (count - count / 2) as f64;
            let way = DoubleDouble::product(v, whole) - kick.times(kicked);
            let motion = if even { arrived.motion } else { start.motion };
            (motion, (flight * way).value())
        };
        let (surface, speed) = match ceiling {
            Some(speed) if (first == Surface::Ceiling) == even => (Surface::Ceiling, speed),
            _ => (Surface::Floor, floor),
        };
        let ball = InFlight {
            position: arrived.position + way,
            motion,
            bounces: arrived.bounces.saturating_add(count),
            ..self.leaving(surface, speed.value(), &arrived)
        };
        Ok(self.flown(&ball, later.value()))
    }

    /// The time, s, at which a ball that loses height at every bounce has made all its bounces, infinitely many in a finite time. `None` if they never end.
    ///
    /// From the first contact with the floor the flights form a geometric series with the sum 2e_nV_z/(g(1−e_n)). Under a ceiling they do so from the first bounce
    /// after which the ball no longer reaches it; the bounces before are followed.
    ///
    /// # Errors
    /// [`Error::Integration`](crate::Error::Integration) after ten million bounces below the ceiling; [`Error::NotFinite`](crate::Error::NotFinite) for a time beyond the range of doubles.
    ///
    /// ```
    /// use spinning_bodies::superball::{Flight, InFlight, Motion, Restitution};
    /// let motion = Motion { velocity: 1.0, rim_speed: 0.0 };
    /// let start = InFlight { position: 0.0, height: 4.905, climb: 0.0, motion, bounces: 0 };
    /// let lossy = Restitution::new(0.5, 1.0)?;
    /// let flight = Flight::new(0.4, f64::INFINITY, (Some(9.81), Some(lossy), None), start)?;
    /// // A second of fall, and then 1 + ½ + ¼ + … seconds.
    /// assert!((flight.last_contact()?.unwrap() - 3.0).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn last_contact(&self) -> Result<Option<f64>> {
        let mut ball = self.thrown();
        while self.piles()
            && ball.pile.is_none()
            && let Some(next) = ball.next
        {
            self.follow(&mut ball, next, &|_| Ok(()))?;
        }
        let finite = |(.., last): Pile| finite("the time of the last contact", last);
        ball.pile.map(finite).transpose()
    }

    /// Whether it loses height at every bounce, so that the bounces have an end.
    fn piles(&self) -> bool {
        let [normal, _] = self.restitution();
        self.gravity > 0.0 && normal < 1.0
    }

    /// The ball at the start. One that lies on the floor has made all its bounces.
    fn thrown(&self) -> Followed {
        let ball = self.start;
        Followed {
            now: DoubleDouble::from(0.0),
            ball,
            next: self.contact(&ball, ball.climb.into()),
            pile: self.lies(&ball).then_some((0.0, ball, 0.0)),
        }
    }

    /// The next bounce.
    fn follow(&self, run: &mut Followed, next: Contact, bounced: Told<'_>) -> Result<()> {
        if run.ball.bounces - self.start.bounces >= MOST_BOUNCES {
            return stopped("too many bounces to follow one by one", run.now.value());
        }
        let (wait, surface, speed) = next;
        run.now = run.now + wait;
        let now = run.now.value();
        bounced(now)?;
        let ([normal, _], g) = (self.restitution(), self.gravity);
        let ball = self.bounced(&run.ball, wait.value(), surface, speed.value());
        let low = surface == Surface::Floor && ball.climb * ball.climb <= 2.0 * g * self.room;
        if low && self.piles() && run.pile.is_none() {
            let last = now + 2.0 * ball.climb / (g * (1.0 - normal));
            run.pile = Some((now, ball, last));
        }
        run.next = self.contact(&ball, speed.times(normal).signed(ball.climb));
        run.ball = ball;
        Ok(())
    }

    fn restitution(&self) -> [f64; 2] {
        let kept = |losses: Restitution| [losses.normal, losses.tangential];
        self.losses.map_or([1.0; 2], kept)
    }

    /// The ball at `times` (s, ascending from 0), bounce by bounce; after the last bounce it rolls, or slides until it rolls.
    ///
    /// If the ball cannot slip, the sums over all bounces are geometric series, and none of these bounces is followed.
    ///
    /// # Errors
    /// [`Error::Integration`](crate::Error::Integration) after ten million bounces; [`Error::Condition`](crate::Error::Condition) for times after the last bounce of a ball with e_t = 1 that cannot
    /// slip: its contact speed is reversed infinitely often and has no last value.
    ///
    /// ```
    /// use spinning_bodies::superball::{Flight, InFlight, Motion, Restitution};
    /// let motion = Motion { velocity: 1.0, rim_speed: 0.0 };
    /// let start = InFlight { position: 0.0, height: 4.905, climb: 0.0, motion, bounces: 0 };
    /// let lossy = Restitution::new(0.5, 1.0)?;
    /// let flight = Flight::new(0.4, f64::INFINITY, (Some(9.81), Some(lossy), None), start)?;
    /// // From the floor at 4.905 m/s, half a second on.
    /// assert!((flight.followed(&[1.5])?[0].height - 1.22625).abs() < 1e-14);
    /// // The second bounce is at the time of the last one, but for rounding, and its friction still counts.
    /// let (dead, slippery) = (Restitution::new(1e-9, 1.0)?, spinning_bodies::rolling::Coulomb::new(0.1)?);
    /// let start = InFlight { motion: Motion { velocity: 5.0, rim_speed: 0.0 }, ..start };
    /// let flight = Flight::new(0.4, f64::INFINITY, (Some(9.81), Some(dead), Some(slippery)), start)?;
    /// let end = flight.last_contact()?.unwrap();
    /// assert!((flight.followed(&[end])?[0].motion.velocity - (5.0 - 0.981 * (1.0 + 2e-9))).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn followed(&self, times: &[f64]) -> Result<Vec<InFlight>> {
        let samples: Vec<Sample> = times.iter().map(|&t| (t, None)).collect();
        self.sampled(&samples, &|_| Ok(()))
    }

    /// The same at times that may come with a number of bounces; then the ball is given after exactly that many, even if another falls on the same
    /// time. `bounced` receives the time of every bounce, and may end the run.
    pub(crate) fn sampled(&self, samples: &[Sample], bounced: Told<'_>) -> Result<Vec<InFlight>> {
        let (mut run, mut states) = (self.thrown(), Vec::with_capacity(samples.len()));
        for &(t, count) in samples {
            let t = not_negative("the time", t)?;
            let over = |run: &Followed| run.pile.filter(|&(.., last)| t >= last);
            while let Some(next) = run.next {
                let (now, wait, bounces) = (run.now, next.0, run.ball.bounces);
                let later = count.map_or((now + wait).value() > t, |count| bounces >= count);
                // The last bounces cannot be told apart from the end of the series.
                let ends = |(.., last): Pile| wait.value() <= SAME * last;
                if run.pile.is_some_and(ends) || over(&run).map_or(later, |_| self.grip.is_none()) {
                    break;
                }
                self.follow(&mut run, next, bounced)?;
            }
            let (now, ball) = (run.now, &run.ball);
            states.push(match over(&run) {
                Some((begun, first, last)) if self.grip.is_none() => {
                    self.piled(&first, last - begun, t - last)?
                }
                Some((.., last)) => {
                    let left = (DoubleDouble::from(last) - now).value();
                    let landed = ball.position + left * ball.motion.velocity;
                    self.on_the_floor(ball, landed, t - last)?
                }
                None => self.flown(ball, (DoubleDouble::from(t) - now).value()),
            });
        }
        states.into_iter().map(InFlight::checked).collect()
    }

    /// The ball `after` seconds from the last bounce, given the first ball of the geometric series and the time `took` that the series took.
    ///
    /// In successive flights the contact speed is u, −e_t u, e_t²u, …, and their durations are τ, e_n τ, e_n²τ, …
    fn piled(&self, first: &InFlight, took: f64, after: f64) -> Result<InFlight> {
        let [normal, tangential] = self.restitution();
        let (kappa, flight) = (self.kappa, took * (1.0 - normal));
        let slip = first.motion.contact_speed(Surface::Floor);
        // What the bounces take from the way, which without them were V·took. A ball that already lies on the floor has no flights.
        let taken = match took {
            0.0 => 0.0,
            _ => {
                let share = normal * (1.0 + tangential) / (1.0 + normal * tangential);
                kappa / (1.0 + kappa) * slip * took * share
            }
        };
        let landed = first.position + took * first.motion.velocity - taken;
        // The bounces that could have been followed: those that can be told apart from the end.
        let told = ((SAME * took / flight).ln() / normal.ln()).max(0.0).ceil();
        let bounces = first.bounces.saturating_add(told as u64);
        let ball = InFlight { bounces, ..*first };
        self.on_the_floor(&ball, landed, after)
    }

    /// A ball that has lain on the floor for `t` seconds, since it landed at `landed`.
    fn on_the_floor(&self, ball: &InFlight, landed: f64, t: f64) -> Result<InFlight> {
        let [_, tangential] = self.restitution();
        let motion = ball.motion;
        let (way, motion) = if tangential == -1.0 {
            (t * motion.velocity, motion)
        } else if self.grip.is_some() {
            let start = Moment::moving(motion.velocity, motion.rim_speed);
            let load = Load::weight(self.gravity);
            let course = Course::new(self.kappa, load, (self.grip, None, None), start, t)?;
            let end = course.at(t);
            (end.position, Motion::new(end.velocity, end.rim_speed))
        } else if tangential.abs() < 1.0 || motion.contact_speed(Surface::Floor) == 0.0 {
            // The velocity of rolling, which no impulse at the floor changes.
            let common = (motion.velocity + self.kappa * motion.rim_speed) / (1.0 + self.kappa);
            (t * common, Motion::new(common, common))
        } else {
            let condition = "tangential restitution, 1 if none is given, must be below 1 for a motion after infinitely many bounces, each of which reverses the contact speed";
            return refused(condition, tangential);
        };
        Ok(InFlight {
            position: landed + way,
            motion,
            ..self.leaving(Surface::Floor, 0.0, ball)
        })
    }
}
