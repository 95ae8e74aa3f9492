//! The scene `crawler` (tutorial 1.1): how it moves by the friction of imperfect ice.

use core::f64::consts::TAU;

use crate::phenomena::{self, crawler::Gap, crawler::Leg};
use crate::rolling::Coulomb;
use crate::scene::prelude::*;

/// Two feet joined by a muscle, on the ground, initially at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crawler {
    body: phenomena::Crawler,
    friction: Option<Coulomb>,
    gravity: Option<f64>,
}

state! {
    /// A crawler at one time.
    CrawlerState {
        /// Place of the rear foot, m.
        rear,
        /// Place of the front foot, m.
        front,
        /// Centre of mass, m.
        center,
        /// Its velocity, m/s.
        velocity,
        /// Work of the muscle so far, J.
        work,
        /// Heat of the ground so far, J.
        heat,
    }
}

impl Crawler {
    /// The crawler with its centre of mass at 0, on perfect ice.
    ///
    /// ```
    /// use spinning_bodies::{phenomena::{self, Strokes}, scene::{Request, Scene, shape::Crawler}};
    /// let strokes = Strokes { gap: 0.1, length: 0.05, push: 0.2, pull: 0.3 };
    /// let body = phenomena::Crawler::new(3.0, 1.0, strokes)?;
    /// let motion = Crawler::new(body).simulate(&Request::at([100.0])?)?;
    /// assert_eq!(motion.rows[0].1.center, 0.0); // perfect ice
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn new(body: phenomena::Crawler) -> Self {
        Self {
            body,
            friction: None,
            gravity: None,
        }
    }

    /// Adds [`Coulomb`], the friction of the ground, or [`Gravity`](crate::scene::effects::Gravity), which presses the feet on it.
    /// Either has an effect only with the other.
    ///
    /// # Errors
    /// [`Error::Effect`](crate::Error::Effect) for any other effect; [`Error::Negative`](crate::Error::Negative) for gravity that points up.
    ///
    /// ```
    /// use spinning_bodies::{phenomena::{self, Strokes}, scene::{Request, Scene, effects::Coulomb, shape::Crawler}};
    /// let strokes = Strokes { gap: 0.1, length: 0.05, push: 0.2, pull: 0.3 };
    /// let body = phenomena::Crawler::new(3.0, 1.0, strokes)?;
    /// let motion = Crawler::new(body).with(Coulomb::new(0.3)?)?.simulate(&Request::at([100.0])?)?;
    /// assert_eq!(motion.rows[0].1.center, 0.0); // nothing presses it to the ground
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn with(mut self, effect: impl Into<Effect>) -> Result<Self> {
        match effect.into() {
            Effect::Coulomb(friction) => self.friction = Some(friction),
            Effect::Gravity(gravity) => {
                self.gravity = Some(not_negative("the gravity of a crawler", gravity.value())?);
            }
            other => return Err(other.refused("a crawler", "friction, gravity")),
        }
        Ok(self)
    }

    /// μg of a foot that slips and of one that holds, m/s²; `None` on perfect ice.
    fn grip(&self) -> Option<[f64; 2]> {
        let (friction, g) = (self.friction?, self.gravity?);
        Some([friction.kinetic * g, friction.grip * g])
    }

    fn gap(&self, piece: u64, t: f64) -> Gap {
        self.body.strokes.at(piece, t)
    }

    /// The leg that begins at this time. Feet that have no velocity left come to rest first, and set that of the centre.
    fn leg(&self, piece: u64, t: f64, feet: [i8; 2], y: &mut [f64; 5]) -> Leg {
        let gap = self.gap(piece, t);
        let [sliding, holding] = self.grip().unwrap_or_default();
        let mut leg = self.body.leg(feet, &gap, sliding, holding);
        for foot in 0..2 {
            let slowing = self.body.slowing(&leg, foot, [y[1], gap.rate]);
            if slowing.is_some_and(|[velocity, _]| velocity <= 0.0) {
                let mut feet = leg.feet;
                feet[foot] = 0;
                y[1] = self.body.holding(foot, gap.rate);
                leg = self.body.leg(feet, &gap, sliding, holding);
            }
        }
        leg
    }

    /// The time after which a foot first comes to rest if the stroke continues, and which foot.
    fn rest(&self, leg: &Leg, velocity: f64, rate: f64) -> Option<(f64, usize)> {
        let stop = |foot: usize| {
            let [along, acceleration] = self.body.slowing(leg, foot, [velocity, rate])?;
            Some(((-along / acceleration).max(0.0), foot))
        };
        (0..2).filter_map(stop).min_by(|a, b| a.0.total_cmp(&b.0))
    }
}

/// Most cycles of a run: more than a day of crawling.
const MOST_CYCLES: f64 = 250_000.0;

/// The piece of the strokes, a half of one, and the leg: how the feet move in it.
type Phase = (u64, Leg);

/// Components: centre, velocity, impulse of friction, heat, work of the muscle. A phase ends where a stroke reverses or a foot comes to rest.
impl Flow<5> for Crawler {
    type Phase = Phase;

    fn start(&self) -> Result<(Phase, [f64; 5])> {
        let mut y = [0.0; 5];
        let leg = self.leg(0, 0.0, [0; 2], &mut y);
        Ok(((0, leg), y))
    }

    fn scales(&self) -> [f64; 5] {
        let strokes = self.body.strokes;
        let mass: f64 = self.body.masses.iter().sum();
        let speed = 2.0 * strokes.length / strokes.push.min(strokes.pull);
        let energy = mass * speed * speed;
        [strokes.length, speed, mass * speed, energy, energy]
    }

    fn pace(&self) -> f64 {
        let strokes = self.body.strokes;
        TAU / (2.0 * strokes.push.min(strokes.pull))
    }

    fn rate(&self, (piece, leg): Phase, t: f64, y: &[f64; 5]) -> [f64; 5] {
        let rate = self.gap(piece, t).rate;
        [
            y[1],
            leg.center,
            leg.ground[0] + leg.ground[1],
            self.body.heating(&leg, self.body.feet(y[1], rate)),
            self.body.muscle(&leg) * rate,
        ]
    }

    fn margin(&self, (piece, leg): Phase, t: f64, y: &[f64; 5]) -> Option<f64> {
        let rate = self.gap(piece, t).rate;
        let along = |foot| self.body.slowing(&leg, foot, [y[1], rate]);
        let margins = (0..2).filter_map(along).map(|[velocity, _]| velocity);
        margins.reduce(f64::min)
    }

    fn lasts_until(&self, (piece, _): Phase, _: f64) -> f64 {
        self.body.strokes.beginning(piece + 1)
    }

    fn next(&self, (piece, leg): Phase, ended: Stop, t: f64, y: &mut [f64; 5]) -> Result<Phase> {
        let (mut feet, mut rested) = (leg.feet, None);
        let rate = self.gap(piece, t).rate;
        let piece = match ended {
            Stop::AtTheEvent => {
                rested = self.rest(&leg, y[1], rate).map(|(_, foot)| foot);
                if let Some(foot) = rested {
                    feet[foot] = 0;
                }
                piece
            }
            Stop::AtTheEnd => {
                // Where the stroke reverses, a foot dragged by one at rest has stopped too, and both have the velocity of the centre, to rounding.
                let [_, speed, ..] = self.scales();
                let rests = feet.contains(&0) || y[1].abs() <= f64::EPSILON * speed;
                if piece % 2 == 1 && rests {
                    feet = [0; 2];
                    y[1] = 0.0;
                }
                piece + 1
            }
        };
        let next = self.leg(piece, t, feet, y);
        if let Some(foot) = next.feet.iter().position(|&sense| sense == 0) {
            y[1] = self.body.holding(foot, rate);
        } else if let Some(foot) = rested {
            // It slips on, the other way. The time of the event is rounded: what speed the foot has got since is due to the new friction.
            let of = |center, gap| self.body.feet(center, gap)[foot];
            let [was, is] = [leg, next].map(|leg| of(leg.center, leg.acceleration));
            y[1] += (is / was - 1.0) * of(y[1], rate);
        }
        Ok((piece, next))
    }

    /// Strokes are told from the time since their cycle began, which has no rounding of its own however many there were; friction forgets the roundings of
    /// events, and only those of the way add up.
    fn rounding(&self, angle: f64, phases: usize) -> f64 {
        let of_a_cycle = angle.min(self.pace() * self.body.strokes.cycle());
        let events = match self.grip() {
            Some(_) => f64::EPSILON * (angle + phases as f64),
            None => 0.0,
        };
        OF_CLOSED_FORMS * (1.0 + of_a_cycle) + events
    }

    fn known(&self, (piece, leg): Phase, ahead: &Ahead<'_, 5>) -> Option<Passed<5>> {
        let (from, y) = ahead.start;
        let gap = self.gap(piece, from);
        let after = |t: f64| Ok((self.body).after(&leg, y, [&gap, &self.gap(piece, t)]));
        let rest = self.rest(&leg, y[1], gap.rate);
        let rest = rest.map(|(after, _)| from + after);
        let rest = rest.filter(|&rest| rest < ahead.end);
        (!ahead.stepped).then(|| ahead.in_closed_form(rest, &after))
    }
}

impl Scene for Crawler {
    type State = CrawlerState;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let plan = match self.grip() {
            Some(_) => Plan::events("sliding friction: closed forms from event to event"),
            None => Plan::exact("no outside force: the centre of mass stays"),
        };
        let solvers = "the solver of a crawler is `events` on a rough ground, `exact` on perfect ice, or one that steps";
        planned_forward(request, plan, solvers)
    }

    fn simulate(&self, request: &Request) -> Result<Motion<CrawlerState>> {
        let plan = self.plan(request)?;
        let (body, strokes) = (&self.body, self.body.strokes);
        let what = "the time of a crawler, 250000 cycles at most,";
        within(what, request.furthest, 0.0, MOST_CYCLES * strokes.cycle())?;
        let gap = |t: f64| strokes.at(strokes.piece_at(t), t);
        // On perfect ice the only component is the muscle's work, which is the kinetic energy.
        let trace = solved((self, &plan, request), 1, &|t| {
            Ok([0.0, 0.0, 0.0, 0.0, body.energy(0.0, gap(t).rate)])
        })?;
        let mut ledger = trace.told(request, plan, |t, _, &[center, velocity, _, heat, work]| {
            let [rear, front] = body.feet(center, gap(t).gap);
            CrawlerState::of([rear, front, center, velocity, work, heat])
        });
        let [.., mass_speed, _, energy] = self.scales();
        let spent = ledger.greatest(0.0, |_, state| state.heat);
        let mass: f64 = body.masses.iter().sum();
        let impulse = |place: usize| trace.samples[place].1[2];
        let momentum = |place: usize, s: &CrawlerState| mass * s.velocity - impulse(place);
        let balance = |place: usize, s: &CrawlerState| {
            body.energy(s.velocity, gap(request.times()[place]).rate) + s.heat - s.work
        };
        let given = "momentum less the impulse of friction";
        ledger.conserved(given, mass_speed, 0.0, momentum)?;
        let left = "energy and heat less the work of the muscle";
        ledger.conserved(left, energy + spent, 0.0, balance)?;
        let heat = ("heat", Law::NonDecreasing, energy + spent);
        ledger.keep(heat, 0.0, |_, s| s.heat)?;
        ledger.closed(request)
    }

    fn further(&self) -> Columns<CrawlerState> {
        columns! { |state: &CrawlerState|
            "gap", "m", "distance of the feet" => state.front - state.rear;
        }
    }
}
