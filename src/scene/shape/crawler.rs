//! The crawler (tutorial 1.1): what friction makes possible on ice that is not perfect.

use super::{in_order, planned};
use crate::conservation::{Law, Ledger};
use crate::error::{Result, finite, not_negative, positive};
use crate::integrators::{Cost, Effort, Method, Stop, until};
use crate::phenomena::crawler::{self, Foot, Leg, Place};
use crate::scene::{
    Absent, Budget, Effect, Motion, Plan, Request, Scene, Solver, Tabulated, balanced,
};

/// The ground under the feet.
pub trait Ground: Effect {
    /// μg, m/s², or nothing: then the feet slide without a question being asked.
    fn grip(&self) -> Option<f64>;
}

impl Ground for Absent {
    fn grip(&self) -> Option<f64> {
        None
    }
}

/// Coulomb's friction between feet and ground, the same at rest and in motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroundFriction {
    mu: f64,
    g: f64,
}

impl GroundFriction {
    /// Coefficient μ under gravity g (m/s²).
    ///
    /// # Errors
    /// [`Error::Negative`](crate::Error::Negative), [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite).
    pub fn new(mu: f64, g: f64) -> Result<Self> {
        Ok(Self {
            mu: not_negative("the coefficient of friction", mu)?,
            g: positive("the acceleration of gravity", g)?,
        })
    }
}

impl Effect for GroundFriction {
    const PRESENT: bool = true;
    const NAME: &'static str = "ground_friction";
}

impl Ground for GroundFriction {
    fn grip(&self) -> Option<f64> {
        Some(self.mu * self.g)
    }
}

/// Two feet and a muscle on the ground, at rest at first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crawler<Friction = Absent> {
    body: crawler::Crawler,
    friction: Friction,
}

/// A crawler at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrawlerState {
    /// Place of the rear foot, m.
    pub rear: f64,
    /// Place of the front foot, m.
    pub front: f64,
    /// Centre of mass, m.
    pub center: f64,
    /// Its velocity, m/s.
    pub velocity: f64,
    /// Budget of the muscle, J.
    pub work: f64,
    /// Heat, J.
    pub heat: f64,
}

impl Tabulated for CrawlerState {
    const COLUMNS: &'static [&'static str] =
        &["rear", "front", "center", "velocity", "work", "heat"];

    fn row(&self) -> Vec<f64> {
        vec![
            self.rear,
            self.front,
            self.center,
            self.velocity,
            self.work,
            self.heat,
        ]
    }
}

impl Crawler {
    /// This crawler, its centre of mass at 0, on perfect ice.
    pub const fn new(body: crawler::Crawler) -> Self {
        Self {
            body,
            friction: Absent,
        }
    }
}

/// Everything that changes on the way.
#[derive(Debug, Clone, Copy)]
struct Walk {
    time: f64,
    place: Place,
    feet: [Foot; 2],
    cost: Cost,
}

impl<F: Ground> Crawler<F> {
    /// The same on this ground.
    pub fn with_friction<G: Ground>(self, friction: G) -> Crawler<G> {
        Crawler {
            body: self.body,
            friction,
        }
    }

    fn state(&self, piece: u64, t: f64, place: &Place) -> CrawlerState {
        let gap = self.body.strokes().at(piece, t);
        let [rear, front] = self.body.feet(place.center, gap.gap);
        CrawlerState {
            rear,
            front,
            center: place.center,
            velocity: place.velocity,
            work: place.work,
            heat: place.heat,
        }
    }

    /// On perfect ice the centre stays, and only the muscle's work is to be told: the kinetic energy.
    fn slid(&self, stops: &[f64]) -> Result<(Vec<(u64, Place)>, Cost)> {
        let mut piece = 0;
        let mut places = Vec::with_capacity(stops.len());
        for &t in stops {
            while self.body.strokes().piece(piece).1 < t {
                piece += 1;
            }
            let gap = self.body.strokes().at(piece, t);
            let place = Place {
                work: self.body.energy(0.0, gap.rate),
                ..Place::default()
            };
            places.push((piece, place));
        }
        Ok((places, Cost::default()))
    }

    /// From event to event: a stroke turns or a foot comes to rest.
    fn walked(
        &self,
        grip: f64,
        stops: &[f64],
        advance: impl Fn(&Leg, u64, &mut Walk, f64) -> Result<Option<usize>>,
    ) -> Result<(Vec<(u64, Place)>, Cost)> {
        let mut walk = Walk {
            time: 0.0,
            place: Place::default(),
            feet: [Foot::Holds; 2],
            cost: Cost::default(),
        };
        let mut places = Vec::with_capacity(stops.len());
        let mut left = stops.iter().copied().peekable();
        let mut piece = 0;
        while left.peek().is_some() {
            let (from, to, _) = self.body.strokes().piece(piece);
            walk.time = from;
            // Where the stroke turns, a foot that was dragged by one at rest is at rest as well.
            if piece % 2 == 0 && walk.feet.contains(&Foot::Holds) {
                walk.feet = [Foot::Holds; 2];
                walk.place.velocity = 0.0;
            }
            loop {
                let gap = self.body.strokes().at(piece, walk.time);
                let leg = self.body.leg(walk.feet, &gap, grip);
                walk.feet = leg.feet;
                let rested = loop {
                    let stop = left.peek().copied().filter(|&stop| stop <= to);
                    let rested = advance(&leg, piece, &mut walk, stop.unwrap_or(to))?;
                    if rested.is_some() || stop.is_none() {
                        break rested;
                    }
                    places.push((piece, walk.place));
                    left.next();
                };
                let Some(foot) = rested else { break };
                let rate = self.body.strokes().at(piece, walk.time).rate;
                walk.feet[foot] = Foot::Holds;
                walk.place.velocity = self.body.holding(foot, rate);
            }
            piece += 1;
        }
        Ok((places, walk.cost))
    }

    /// A leg in closed form, until `to` or until a foot rests.
    fn leg_known(&self, leg: &Leg, piece: u64, walk: &mut Walk, to: f64) -> Option<usize> {
        let gap = self.body.strokes().at(piece, walk.time);
        let rest = self.body.rest(leg, &walk.place, &gap, to - walk.time);
        let time = rest.map_or(to - walk.time, |(after, _)| after);
        walk.place = self.body.after(leg, &walk.place, &gap, time);
        walk.time = rest.map_or(to, |(after, _)| walk.time + after);
        rest.map(|(_, foot)| foot)
    }

    /// The same leg followed by a general method.
    fn leg_followed(
        &self,
        leg: &Leg,
        piece: u64,
        walk: &mut Walk,
        to: f64,
        (method, tolerance): (Method, f64),
        budget: &Budget,
    ) -> Result<Option<usize>> {
        let gap = |t: f64| self.body.strokes().at(piece, t);
        let velocities = |t: f64, y: &[f64; 5]| self.body.feet(y[1], gap(t).rate);
        let system = |t: f64, y: &[f64; 5]| {
            [
                y[1],
                leg.center,
                leg.ground[0] + leg.ground[1],
                self.body.heating(leg, velocities(t, y)),
                self.body.muscle(leg) * gap(t).rate,
            ]
        };
        let strokes = self.body.strokes();
        let along = |t: f64, y: &[f64; 5], k: usize| velocities(t, y)[k] * leg.feet[k].sign();
        // Only a foot that slows down can come to rest, and none while the other one holds; a foot that has just set off from rest must not
        // hide it by its zero.
        let accelerations = self.body.feet(leg.center, leg.acceleration);
        let held = leg.feet.contains(&Foot::Holds);
        let slows = |k: usize| !held && accelerations[k] * leg.feet[k].sign() < 0.0;
        // Linear in time wherever it can be, for the sake of the secants that locate its zero.
        let falling = |t: f64, y: &[f64; 5]| match [slows(0), slows(1)] {
            [true, true] => along(t, y, 0).min(along(t, y, 1)),
            [true, false] => along(t, y, 0),
            [false, true] => along(t, y, 1),
            [false, false] => 1.0,
        };
        let p = walk.place;
        let start = [p.center, p.velocity, p.impulse, p.heat, p.work];
        let speed = strokes.length / strokes.push.min(strokes.pull);
        // A foot that should have come to rest at the very end of the last leg does so now.
        if let Some(late) = (0..2).find(|&k| slows(k) && along(walk.time, &start, k) <= 0.0) {
            return Ok(Some(late));
        }
        let mass: f64 = self.body.masses().iter().sum();
        let energy = mass * speed * speed;
        let scales = [strokes.length, speed, mass * speed, energy, energy];
        let run = until(
            &budget.counted(&system),
            walk.time,
            &start,
            &scales,
            &[],
            to,
            &falling,
            method,
            Effort::Tolerance(tolerance),
        )?;
        let [center, velocity, impulse, heat, work] = run.end;
        walk.place = Place {
            center,
            velocity,
            impulse,
            heat,
            work,
        };
        walk.cost += run.cost;
        walk.time = run.time;
        let rested = run.stopped == Stop::AtTheEvent;
        Ok(rested.then(|| {
            let [rear, front] = [0, 1].map(|k| {
                if slows(k) {
                    along(run.time, &run.end, k).abs()
                } else {
                    f64::INFINITY
                }
            });
            usize::from(front < rear)
        }))
    }

    fn ledger(&self, stops: &[f64], places: &[(u64, Place)]) -> Result<Ledger> {
        let [rear, front] = self.body.masses();
        let energy = |t: f64, (piece, place): &(u64, Place)| {
            let rate = self.body.strokes().at(*piece, t).rate;
            self.body.energy(place.velocity, rate)
        };
        let strokes = self.body.strokes();
        let speed = strokes.length / strokes.push.min(strokes.pull);
        let spent = places.iter().map(|(_, p)| p.heat).fold(0.0, f64::max);
        let mut ledger = Ledger::new();
        let momentum = ledger.open_scaled(
            "momentum less the impulse of friction",
            Law::Conserved,
            0.0,
            (rear + front) * speed,
        )?;
        let balance = ledger.open_scaled(
            "energy and heat less the work of the muscle",
            Law::Conserved,
            0.0,
            (rear + front) * speed * speed + spent,
        )?;
        let heat = ledger.open_scaled("heat", Law::NonDecreasing, 0.0, spent.max(1.0))?;
        for (&t, entry) in stops.iter().zip(places) {
            let place = &entry.1;
            ledger.record(momentum, (rear + front) * place.velocity - place.impulse)?;
            ledger.record(balance, energy(t, entry) + place.heat - place.work)?;
            ledger.record(heat, place.heat)?;
        }
        Ok(ledger)
    }
}

impl<F: Ground> Scene for Crawler<F> {
    type State = CrawlerState;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let closed = if F::PRESENT {
            Ok((
                Solver::Events,
                "sliding friction: closed forms from event to event",
            ))
        } else {
            Ok((Solver::Exact, "no outside force: the centre of mass stays"))
        };
        planned(
            request,
            closed,
            "the solver of a crawler is `events` on a rough ground and by `exact` on perfect ice, or by a method with error control",
        )
    }

    fn simulate(&self, request: &Request) -> Result<Motion<CrawlerState>> {
        let plan = self.plan(request)?;
        let (order, _) = request.forward()?;
        let mut stops: Vec<f64> = order.iter().map(|&i| request.times()[i]).collect();
        stops.dedup();
        let last = stops.last().copied().unwrap_or(0.0);
        finite(
            "the number of strokes",
            self.body.pieces_until(last)? as f64,
        )?;
        let grip = self.friction.grip();
        let (places, cost) = match (plan.solver, grip) {
            (Solver::General(method), grip) => {
                // Errors of a chain of legs add up.
                let legs = self.body.pieces_until(last)?.max(1) as f64 * 4.0;
                let tolerance = (request.accuracy() / legs).max(1e-15);
                let (effort, budget) = ((method, tolerance), Budget::asked(request));
                self.walked(grip.unwrap_or(0.0), &stops, |leg, piece, walk, to| {
                    self.leg_followed(leg, piece, walk, to, effort, &budget)
                })?
            }
            (_, Some(grip)) => self.walked(grip, &stops, |leg, piece, walk, to| {
                Ok(self.leg_known(leg, piece, walk, to))
            })?,
            (_, None) => self.slid(&stops)?,
        };
        let ledger = balanced(self.ledger(&stops, &places)?, request.accuracy())?;
        let pairs = stops.iter().zip(&places);
        let states: Vec<CrawlerState> = pairs
            .map(|(&t, (piece, place))| self.state(*piece, t, place))
            .collect();
        Ok(Motion {
            error_estimate: None,
            plan,
            cost,
            ledger,
            rows: in_order(request, &stops, &states),
        })
    }
}
