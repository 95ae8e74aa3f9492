//! The scene `superball` (tutorial 4.6): a ball that bounces on a floor, or between floor and table top.

use super::prelude::*;
use crate::superball::{Flight, InFlight, Surface};

/// A ball that bounces on a floor or, if there is one, between floor and ceiling.
///
/// | effect | what it does |
/// |---|---|
/// | [`Gravity`](super::effects::Gravity) | bends the flights; without it they are straight |
/// | [`Restitution`](super::effects::Restitution) | reduces both contact speeds at a bounce; without it nothing is lost |
/// | [`Coulomb`](super::effects::Coulomb) | limits the tangential impulse; without it the contact never slips |
///
/// The plan is the [`Flight`]: closed forms, from bounce to bounce where bounces lose energy or slip. The equations are there for a request that
/// chooses a solver with steps.
#[derive(Debug, Clone, Copy)]
pub struct Superball {
    mass: f64,
    /// The ball's flight with its bounces, checked again when the scene runs, for ceiling and gravity may have changed.
    pub(super) flight: Flight,
}

impl Superball {
    /// A ball of this mass (kg) and inertia factor without a ceiling.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite) for the mass; those of [`Flight::new`]. Whether the ball fits under
    /// a ceiling is checked when the scene runs.
    ///
    /// ```
    /// use spinning_bodies::superball::{InFlight, Motion};
    /// use spinning_bodies::scene::{Request, Scene, Superball};
    /// let motion = Motion { velocity: 1.0, rim_speed: 0.0 };
    /// let start = InFlight { position: 0.0, height: 1.0, climb: -1.0, motion, bounces: 0 };
    /// // Down for a second; the floor leaves 3/7 of its velocity.
    /// let ball = Superball::new(0.1, 0.4, start)?.simulate(&Request::at([1.5])?)?.rows[0].1.ball;
    /// assert!((ball.motion.velocity - 3.0 / 7.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(mass: f64, kappa: f64, start: InFlight) -> Result<Self> {
        let mass = positive("the mass", mass)?;
        let flight = Flight::new(kappa, f64::INFINITY, (None, None, None), start)?;
        Ok(Self { mass, flight })
    }

    /// Adds a ceiling: `room` (m) is the distance from floor to ceiling less the ball's diameter.
    ///
    /// ```
    /// use spinning_bodies::superball::{InFlight, Motion};
    /// use spinning_bodies::scene::{Request, Scene, Superball};
    /// let motion = Motion { velocity: 1.0, rim_speed: 0.0 };
    /// let start = InFlight { position: 0.0, height: 1.0, climb: -1.0, motion, bounces: 0 };
    /// let ball = Superball::new(0.1, 0.4, start)?.under(1.0).simulate(&Request::at([3.5])?)?.rows[0].1.ball;
    /// // Floor, ceiling, floor: it comes back.
    /// assert!(ball.bounces == 3 && (ball.motion.velocity + 333.0 / 343.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn under(mut self, room: f64) -> Self {
        self.flight.room = room;
        self
    }

    /// Adds [`Gravity`](super::effects::Gravity), which here must not pull up, [`Restitution`](super::effects::Restitution), or [`Coulomb`](super::effects::Coulomb)'s friction at the contacts.
    ///
    /// # Errors
    /// [`Error::Negative`](crate::Error::Negative) for gravity; [`Error::Effect`](crate::Error::Effect) for any other effect.
    ///
    /// ```
    /// use spinning_bodies::superball::{InFlight, Motion};
    /// use spinning_bodies::scene::{Request, Scene, Superball, effects::Gravity};
    /// let motion = Motion { velocity: 1.0, rim_speed: 0.0 };
    /// let start = InFlight { position: 0.0, height: 1.0, climb: -1.0, motion, bounces: 0 };
    /// let falling = Superball::new(0.1, 0.4, start)?.with(Gravity::new(10.0)?)?;
    /// let ball = falling.simulate(&Request::at([0.1])?)?.rows[0].1.ball;
    /// assert!((ball.climb + 2.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn with(mut self, effect: impl Into<Effect>) -> Result<Self> {
        let flight = &mut self.flight;
        match effect.into() {
            Effect::Gravity(gravity) => {
                flight.gravity = not_negative("the acceleration of gravity", gravity.value())?;
            }
            Effect::Restitution(losses) => flight.losses = Some(losses),
            Effect::Coulomb(law) => flight.grip = Some(law),
            other => return Err(other.refused("a superball", "gravity, restitution, friction")),
        }
        Ok(self)
    }
}

state! {
    /// A ball at one time.
    Bouncing(columns! { |state: &Self|
        "x", "m", "place along the floor" => state.ball.position;
        "height", "m", "lowest point of the ball above the floor" => state.ball.height;
        "velocity", "m/s", "velocity along the floor" => state.ball.motion.velocity;
        "climb", "m/s", "velocity upward" => state.ball.climb;
        "rim_speed", "m/s", "radius times angular velocity, positive as in rolling" => state.ball.motion.rim_speed;
        "bounces", "1", "bounces so far; of infinitely many, those told apart" => state.ball.bounces as f64;
    }) {
        /// kinetic energy, and of the weight above the floor, J
        energy,
    }
    /// Position and motion.
    ball: InFlight,
}

/// Position, height, velocity upward and along the floor, rim speed.
fn numbers(ball: &InFlight) -> [f64; 5] {
    let motion = ball.motion;
    let along = [motion.velocity, motion.rim_speed];
    [ball.position, ball.height, ball.climb, along[0], along[1]]
}

impl Scene for Superball {
    type State = Bouncing;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let plan = match request.choice {
            Choice::Auto | Choice::Use(Solver::Exact) if self.flight.is_elastic() => {
                Plan::exact("elastic and non-slipping: a rotation a bounce, closed form")
            }
            _ => Plan::events("bounces: closed form from one to the next"),
        };
        let solvers = "the solver of a superball is `exact` without restitution and grip, `events`, or one that steps";
        planned_forward(request, plan, solvers)
    }

    fn simulate(&self, request: &Request) -> Result<Motion<Bouncing>> {
        let plan = self.plan(request)?;
        let flight = self.flight.checked()?;
        let (balls, done) = match plan.solver {
            Solver::Exact => {
                let balls = request.times().iter().map(|&t| flight.exact(t));
                let balls: Vec<_> = balls.collect::<Result<_>>()?;
                (balls, (Cost::default(), 2.0 * OF_CLOSED_FORMS))
            }
            Solver::Events => followed(self, request)?,
            _ => {
                let trace = to_accuracy(request, plan.solver, &|_| Ok(*self))?;
                let balls = trace.samples.iter().map(|(ball, y)| flying(ball, y));
                (balls.collect(), (trace.cost, trace.error))
            }
        };
        let energy = |ball: &InFlight| self.mass * ball.energy(flight.kappa, flight.gravity);
        // A ball that flew on through the floor would conserve its energy too.
        let depth = |ball: &InFlight| (-ball.height).max(ball.height - flight.room).max(0.0);
        let (first, inside) = (energy(&flight.start), depth(&flight.start));
        let law = match flight.is_elastic() {
            true => Law::Conserved,
            false => Law::NonIncreasing,
        };
        let states = &mut balls.iter().map(|ball| Bouncing::of([energy(ball)], *ball));
        let mut ledger = OpenLedger::of(request, plan, done, states);
        let highest = ledger.greatest(flight.start.height, |_, s| s.ball.height.abs());
        let highest = highest.min(flight.room);
        ledger.keep(("energy", law, first), first, |_, s| s.energy)?;
        let name = "depth in floor or ceiling";
        ledger.conserved(name, highest, inside, |_, s| depth(&s.ball))?;
        ledger.closed(request)
    }

    fn further(&self) -> Columns<Bouncing> {
        let (mass, kappa) = (self.mass, self.flight.kappa);
        let weight = mass * self.flight.gravity;
        columns! { |state: &Bouncing|
            "translation", "J", "kinetic energy of the centre" => {
                let [along, up] = [state.ball.motion.velocity, state.ball.climb];
                0.5 * mass * (along.powi(2) + up.powi(2))
            };
            "rotation", "J", "kinetic energy about the centre" => 0.5 * mass * kappa * state.ball.motion.rim_speed.powi(2);
            "potential", "J", "energy of the weight above the floor" => weight * state.ball.height;
            "l_over_radius", "kg m/s", "angular momentum about the centre over the radius, which the file does not give" => mass * kappa * state.ball.motion.rim_speed;
        }
    }
}

/// Rounding error of each bounce, four times the observed ones, and the relative change of a twin, which shows how the motion amplifies it. Each number is changed by
/// a fraction of its own of it, so that the effects of two changes do not cancel.
const ROUNDING: f64 = 1e-15;

/// The balls by closed forms from bounce to bounce, their cost, and their error relative to the greatest lengths and speeds of the motion.
///
/// Twins that differ by [`ROUNDING`] show how it is amplified: by no more than that, for next to a graze of the ceiling the effect grows as the root of the change.
/// They are compared after the same number of bounces, because a bounce makes the speeds jump, a moment earlier or later. In one of the two twins the effects of the changes
/// may cancel.
fn followed(ball: &Superball, request: &Request) -> Result<(Vec<InFlight>, (Cost, f64))> {
    let (flight, mut times) = (&ball.flight, request.times().to_vec());
    times.sort_by(f64::total_cmp);
    let budget = request.budget();
    let bounced = |time| budget.spend(1, time);
    let mut counted: Vec<_> = times.iter().map(|&t| (t, None)).collect();
    let ordered = flight.sampled(&counted, &bounced)?;
    let counts = counted.iter_mut().zip(&ordered);
    counts.for_each(|((_, count), ball)| *count = Some(ball.bounces));
    // What the start can reach counts, seen or not.
    let [length, _, speed] = ball.scales();
    let all = ordered.iter().chain([&flight.start]).map(numbers);
    let greatest = all.fold([length, length, speed, speed, speed], |most, ball| {
        core::array::from_fn(|n| greater(most[n], ball[n].abs()))
    });
    let [x, height, speeds @ ..] = greatest;
    let speed = speeds.into_iter().fold(0.0, f64::max);
    let sizes = [x.max(height), x.max(height), speed, speed, speed];
    let mut off = 0.0;
    for sense in [1.0, -1.0] {
        let mut twin = *flight;
        let start = &mut twin.start;
        start.climb *= 1.0 + sense * ROUNDING;
        start.height *= 1.0 - 0.7 * ROUNDING;
        start.motion.velocity *= 1.0 + 0.8 * sense * ROUNDING;
        start.motion.rim_speed *= 1.0 - 0.9 * ROUNDING;
        twin.gravity *= 1.0 - 0.6 * ROUNDING;
        budget.begin(request.furthest);
        let twins = twin.checked()?.sampled(&counted, &bounced)?;
        let pairs = ordered.iter().zip(&twins);
        let apart = pairs.map(|(a, b)| apart(&numbers(a), &numbers(b), &sizes));
        off = apart.fold(off, greater);
    }
    // All bounces of a ball that has come to lie on the floor are in a geometric sum, without rounding of each.
    let bounces = |lies: bool| {
        let balls = ordered.iter().filter(|ball| lies || ball.height > 0.0);
        let most = balls.map(|ball| ball.bounces).max();
        most.map_or(0, |most| most - flight.start.bounces)
    };
    let cost = Cost {
        evaluations: 0,
        steps: bounces(true),
    };
    let error = ROUNDING * (1.0 + bounces(false) as f64) + off;
    let asked = request.times().iter();
    let place = |t: &f64| times.partition_point(|earlier| earlier < t);
    let balls = asked.map(|t| ordered[place(t)]).collect();
    Ok((balls, (cost, error)))
}

/// The ball with these components in a flight.
fn flying(flight: &InFlight, &[position, height, climb]: &[f64; 3]) -> InFlight {
    InFlight {
        position,
        height,
        climb,
        ..*flight
    }
}

impl Superball {
    /// The ball after the bounce at the surface that it flies to.
    fn bounced(&self, ball: &InFlight) -> InFlight {
        let surface = match ball.climb > 0.0 {
            true => Surface::Ceiling,
            false => Surface::Floor,
        };
        self.flight.bounced(ball, 0.0, surface, ball.climb.abs())
    }

    /// Succeeds unless a ball at the floor rises by no more than a rounding of the heights: then bounces pile up without end.
    fn leaves_the_floor(&self, ball: &InFlight) -> Result<()> {
        let (g, [_, height]) = (self.flight.gravity, self.sizes());
        let rises = ball.climb * ball.climb > 2.0 * g * f64::EPSILON * height;
        if g == 0.0 || ball.height > 0.0 || rises {
            return Ok(());
        }
        let condition =
            "the solver must be `events` where bounces pile up: by steps they have no end";
        Err(Error::Solver { condition })
    }

    /// The speed at the floor, and the height to which it carries the ball.
    fn sizes(&self) -> [f64; 2] {
        let (g, ball) = (self.flight.gravity, self.flight.start);
        let speed = ball.climb.hypot((2.0 * g * ball.height).sqrt());
        [speed, self.flight.room.min(0.5 * speed * speed / g)]
    }
}

/// The components: position, height, velocity upward. A phase is a flight, or its falling half, named by its initial state.
impl Flow<3> for Superball {
    type Phase = InFlight;

    fn start(&self) -> Result<(InFlight, [f64; 3])> {
        let mut ball = self.flight.start;
        let [down, up] = [ball.climb < 0.0, ball.climb > 0.0];
        if ball.height == 0.0 && down || ball.height == self.flight.room && up {
            ball = self.bounced(&ball);
        }
        self.leaves_the_floor(&ball)?;
        Ok((ball, [ball.position, ball.height, ball.climb]))
    }

    fn scales(&self) -> [f64; 3] {
        let [speed, height] = self.sizes();
        let length = if height.is_finite() { height } else { 0.0 };
        let (length, ball) = (length.max(f64::MIN_POSITIVE), self.flight.start);
        let motion = ball.motion;
        let speed = speed.max(motion.velocity.abs()).max(motion.rim_speed.abs());
        [length, length, speed.max(f64::MIN_POSITIVE)]
    }

    /// Rounding of the times of the bounces adds up in one direction, as if the ball had started with another speed.
    fn doubt(&self, bounces: f64) -> [f64; 3] {
        [0.0, 0.0, OF_CLOSED_FORMS * bounces * self.scales()[2]]
    }

    fn pace(&self) -> f64 {
        let [speed, height] = self.sizes();
        if height > 0.0 { speed / height } else { 0.0 }
    }

    fn rate(&self, flight: InFlight, _: f64, y: &[f64; 3]) -> [f64; 3] {
        [flight.motion.velocity, y[2], -self.flight.gravity]
    }

    fn margin(&self, flight: InFlight, _: f64, y: &[f64; 3]) -> Option<f64> {
        let room = self.flight.room;
        match flight.climb > 0.0 {
            true => room.is_finite().then_some(room - y[1]),
            false => Some(y[1]),
        }
    }

    /// A flight is cut at its summit, for a step up and down again would hide a contact.
    fn lasts_until(&self, flight: InFlight, t: f64) -> f64 {
        match flight.climb > 0.0 && self.flight.gravity > 0.0 {
            true => t + flight.climb / self.flight.gravity,
            false => f64::INFINITY,
        }
    }

    fn next(&self, flight: InFlight, ended: Stop, _: f64, y: &mut [f64; 3]) -> Result<InFlight> {
        if ended == Stop::AtTheEnd {
            y[2] = 0.0;
            return Ok(flying(&flight, y));
        }
        let ball = self.bounced(&flying(&flight, y));
        *y = [ball.position, ball.height, ball.climb];
        self.leaves_the_floor(&ball)?;
        Ok(ball)
    }

    /// If one of the two has just bounced and the other is about to, the states after that bounce are compared.
    fn distance(&self, (p, a): &(InFlight, [f64; 3]), (q, b): &(InFlight, [f64; 3])) -> f64 {
        let (mut a, mut b) = (flying(p, a), flying(q, b));
        if a.bounces + 1 == b.bounces {
            a = self.bounced(&a);
        } else if b.bounces + 1 == a.bounces {
            b = self.bounced(&b);
        }
        let [length, _, speed] = self.scales();
        let scales = [length, length, speed, speed, speed];
        relative(&numbers(&a), &numbers(&b), &scales)
    }
}
