//! Two feet on a line, with a muscle between them: friction is what makes crawling possible (tutorial 1.1).

use crate::error::{Result, positive};
use crate::precise::DoubleDouble;

/// Two feet, rear and front.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crawler {
    /// Masses of rear and front foot, kg.
    pub(crate) masses: [f64; 2],
    /// The strokes of the muscle.
    pub(crate) strokes: Strokes,
}

/// The muscle's strokes: it pushes the feet apart by `length` in the time `push`, pulls them together in the time `pull`, and repeats this.
///
/// In each stroke the gap first accelerates uniformly and then slows down uniformly, so its acceleration is constant on four pieces of a cycle and
/// every velocity is linear between events.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strokes {
    /// Least gap, m.
    pub gap: f64,
    /// The increase of the gap in a push, m.
    pub length: f64,
    /// Duration of the push, s.
    pub push: f64,
    /// Duration of the pull, s.
    pub pull: f64,
}

/// The gap (m), its rate and its acceleration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Gap {
    /// Front minus rear, m.
    pub gap: f64,
    /// Its rate, m/s.
    pub rate: f64,
    /// Its acceleration, m/s².
    pub acceleration: f64,
}

impl Strokes {
    /// Duration of a cycle, s.
    ///
    /// ```
    /// use spinning_bodies::phenomena::Strokes;
    /// let strokes = Strokes { gap: 0.1, length: 0.05, push: 0.2, pull: 0.3 };
    /// assert_eq!(strokes.cycle(), 0.5);
    /// ```
    pub fn cycle(&self) -> f64 {
        self.push + self.pull
    }

    /// The time at which the piece of the motion with this number begins, s; there are four a cycle.
    pub(crate) fn beginning(&self, number: u64) -> f64 {
        let (push, pull) = (self.push, self.pull);
        let within = [0.0, 0.5 * push, push, push + 0.5 * pull][(number % 4) as usize];
        let cycles = (number / 4) as f64;
        cycles.mul_add(self.cycle(), cycles * self.beyond_the_cycle() + within)
    }

    /// What the rounded duration of a cycle lacks, s: beside many cycles it is more than a rounding.
    fn beyond_the_cycle(&self) -> f64 {
        DoubleDouble::sum(self.push, self.pull).low()
    }

    /// The piece in which a time (s) lies.
    pub(crate) fn piece_at(&self, time: f64) -> u64 {
        // One less than the whole cycles give, because their number may have been rounded up.
        let mut number = (4 * (time / self.cycle()) as u64).saturating_sub(1);
        while self.beginning(number + 1) < time {
            number += 1;
        }
        number
    }

    /// The gap at a time within the piece of this number.
    pub(crate) fn at(&self, number: u64, time: f64) -> Gap {
        let acceleration = self.acceleration(number);
        // Whole cycles are taken off before anything is rounded: beside many of them, the last digit of a clock is long. At the ends of the piece
        // their own clock is rounded, and thousands of ends would add up.
        let (cycles, piece) = (number / 4, number % 4);
        let mut ends = piece..=piece + 1;
        let since = match ends.find(|end| self.beginning(4 * cycles + end) == time) {
            Some(end) => self.beginning(end),
            None => {
                let cycles = -(cycles as f64);
                cycles.mul_add(self.cycle(), time) + cycles * self.beyond_the_cycle()
            }
        };
        // Counted from the end of the piece at which the rate is zero: the beginning of even pieces, the end of odd ones.
        let elapsed = since - self.beginning(piece + piece % 2);
        let base = self.gap + if wide(number) { self.length } else { 0.0 };
        Gap {
            gap: base + 0.5 * acceleration * elapsed * elapsed,
            rate: acceleration * elapsed,
            acceleration,
        }
    }

    /// The acceleration of the gap in a piece, m/s².
    fn acceleration(&self, number: u64) -> f64 {
        let stroke = if number % 4 < 2 { self.push } else { self.pull };
        let size = 4.0 * self.length / (stroke * stroke);
        if wide(number) { -size } else { size }
    }
}

/// Whether the gap is at its greatest at an end of this piece.
fn wide(number: u64) -> bool {
    matches!(number % 4, 1 | 2)
}

/// A stretch of time in which neither the muscle's acceleration nor the state of a foot changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Leg {
    /// The way in which rear and front foot slip: 1 forward, −1 back, 0 for one that holds.
    pub feet: [i8; 2],
    /// Acceleration of the gap, m/s².
    pub acceleration: f64,
    /// Acceleration of the centre, m/s².
    pub center: f64,
    /// Force of the ground on each foot, N.
    pub ground: [f64; 2],
}

impl Crawler {
    /// A crawler with feet of these masses (kg), rear and front, moved by these strokes.
    ///
    /// # Errors
    /// [`NotPositive`](crate::Error::NotPositive), [`NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// use spinning_bodies::phenomena::{Crawler, Strokes};
    /// let strokes = Strokes { gap: 0.1, length: 0.05, push: 0.2, pull: 0.3 };
    /// assert!(Crawler::new(1.0, 2.0, strokes).is_ok() && Crawler::new(0.0, 2.0, strokes).is_err());
    /// ```
    pub fn new(rear: f64, front: f64, strokes: Strokes) -> Result<Self> {
        positive("the least gap", strokes.gap)?;
        positive("the length of a stroke", strokes.length)?;
        positive("the duration of the push", strokes.push)?;
        positive("the duration of the pull", strokes.pull)?;
        let rear = positive("the mass of the rear foot", rear)?;
        let masses = [rear, positive("the mass of the front foot", front)?];
        positive("the acceleration of the push", strokes.acceleration(0))?;
        positive("the acceleration of the pull", strokes.acceleration(3))?;
        Ok(Self { masses, strokes })
    }

    fn mass(&self) -> f64 {
        self.masses[0] + self.masses[1]
    }

    /// The velocity of the centre, m/s, for which this foot is at rest while the gap opens at this rate; the same relation holds for accelerations.
    pub(crate) fn holding(&self, foot: usize, gap_rate: f64) -> f64 {
        [self.masses[1], -self.masses[0]][foot] / self.mass() * gap_rate
    }

    /// Positions of rear and front foot, m; the same relation holds for velocities.
    pub(crate) fn feet(&self, center: f64, gap: f64) -> [f64; 2] {
        [0, 1].map(|foot| center - self.holding(foot, gap))
    }

    /// Kinetic energy, J.
    pub(crate) fn energy(&self, velocity: f64, gap_rate: f64) -> f64 {
        let [v, w] = self.feet(velocity, gap_rate);
        0.5 * (self.masses[0] * v * v + self.masses[1] * w * w)
    }

    /// The leg that begins: which feet hold, and how the centre accelerates.
    ///
    /// `feet` is their state so far; `sliding` is μg (m/s²) of a slipping foot, `holding` the same for a foot at rest: it holds if the force
    /// needed for that is no more than `holding` times its mass, and otherwise starts to slip against that force.
    pub(crate) fn leg(&self, mut feet: [i8; 2], gap: &Gap, sliding: f64, holding: f64) -> Leg {
        let (masses, alpha) = (self.masses, gap.acceleration);
        let toward = |way: f64| way.signum() as i8;
        let held = |feet: &[i8; 2]| feet.iter().position(|&sense| sense == 0);
        // The force that holds a foot, from the acceleration of the other one as seen from it and the friction on that.
        let needed = |foot: usize, feet: &[i8; 2]| {
            let (parting, other) = ([alpha, -alpha][foot], 1 - foot);
            masses[other] * (parting + sliding * f64::from(feet[other]))
        };
        let holds = |foot, feet: &[i8; 2]| needed(foot, feet).abs() <= masses[foot] * holding;
        if feet == [0; 2] {
            // One holds and the other starts to slip, or both slip: outward when the gap accelerates outward.
            feet = [-alpha, alpha].map(toward);
            if let Some(foot) = [0, 1].into_iter().find(|&foot| holds(foot, &feet)) {
                feet[foot] = 0;
            }
        } else if let Some(foot) = held(&feet)
            && !holds(foot, &feet)
        {
            feet[foot] = toward(-needed(foot, &feet));
        }
        let mut ground = [0, 1].map(|foot| -sliding * masses[foot] * f64::from(feet[foot]));
        let center = if let Some(foot) = held(&feet) {
            ground[foot] = needed(foot, &feet);
            self.holding(foot, alpha)
        } else {
            (ground[0] + ground[1]) / self.mass()
        };
        Leg {
            feet,
            acceleration: alpha,
            center,
            ground,
        }
    }

    /// Force of the muscle, N, that presses the front foot forward and the rear foot back.
    pub(crate) fn muscle(&self, leg: &Leg) -> f64 {
        let [rear, front] = self.masses;
        front * (leg.center + rear / self.mass() * leg.acceleration) - leg.ground[1]
    }

    /// Heat, W, at these velocities of the feet.
    pub(crate) fn heating(&self, leg: &Leg, velocities: [f64; 2]) -> f64 {
        let slipping = (0..2).filter(|&foot| leg.feet[foot] != 0);
        let heats = slipping.map(|foot| -leg.ground[foot] * velocities[foot]);
        heats.sum()
    }

    /// Speed (m/s) and acceleration (m/s²) of a slipping foot in its direction, at these speeds of the centre and of the gap (m/s), if it slows down while
    /// neither foot holds: only then can it come to rest.
    /// While the other foot holds, a foot moves with the stroke, and rests only where the stroke turns.
    pub(crate) fn slowing(&self, leg: &Leg, foot: usize, speeds: [f64; 2]) -> Option<[f64; 2]> {
        let [velocity, gap_rate] = speeds;
        let along = |of: [f64; 2]| of[foot] * f64::from(leg.feet[foot]);
        let acceleration = along(self.feet(leg.center, leg.acceleration));
        let slows = acceleration < 0.0 && !leg.feet.contains(&0);
        slows.then(|| [along(self.feet(velocity, gap_rate)), acceleration])
    }

    /// Centre, velocity, impulse, heat and work later in a leg, from their values at its beginning and the gaps then and now.
    pub(crate) fn after(&self, leg: &Leg, from: &[f64; 5], [gap, now]: [&Gap; 2]) -> [f64; 5] {
        let [center, velocity, impulse, heat, work] = *from;
        let time = (now.rate - gap.rate) / leg.acceleration;
        let advance = (velocity + 0.5 * leg.center * time) * time;
        let opened = (gap.rate + 0.5 * leg.acceleration * time) * time;
        [
            center + advance,
            velocity + leg.center * time,
            impulse + (leg.ground[0] + leg.ground[1]) * time,
            heat + self.heating(leg, self.feet(advance, opened)),
            work + self.muscle(leg) * opened,
        ]
    }
}
