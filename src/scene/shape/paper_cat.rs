//! The scene `paper-cat` (tutorial 1.1): a rigid sheet that the air turns over.

use core::f64::consts::{PI, TAU};

use crate::phenomena;
use crate::scene::path::MOST_TURNED;
use crate::scene::prelude::*;

/// π less the double nearest to it.
const PI_LEFT: f64 = 1.224_646_799_147_353_2e-16;

/// A falling paper cat: tilt, air and weight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PaperCat {
    cat: phenomena::PaperCat,
    tilt: f64,
    air: Option<f64>,
    gravity: Option<f64>,
}

state! {
    /// A paper cat at one time.
    PaperCatState {
        /// How far it has fallen, m.
        fall,
        /// Velocity of the fall, m/s.
        velocity,
        /// Tilt from feet-down, rad.
        tilt,
        /// Rate of the tilt, rad/s.
        tilt_rate,
        /// Energy of the fall that the air has taken so far, J/kg.
        lost,
    }
}

/// The moment at which a paper cat first points its feet down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Righting {
    /// The time, s.
    pub time: f64,
    /// The height fallen, m.
    pub fall: f64,
}

impl PaperCat {
    /// A cat at rest, tilted by `tilt` (radians) from feet-down.
    ///
    /// # Errors
    /// Those of an invalid cat; [`Error::NotFinite`](crate::Error::NotFinite) for the tilt.
    ///
    /// ```
    /// use spinning_bodies::{phenomena, scene::{Request, Scene, shape::PaperCat}};
    /// let motion = PaperCat::new(phenomena::PaperCat::POSTCARD, 2.0)?.simulate(&Request::at([5.0])?)?;
    /// assert_eq!((motion.rows[0].1.fall, motion.rows[0].1.tilt), (0.0, 2.0)); // it floats
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(cat: phenomena::PaperCat, tilt: f64) -> Result<Self> {
        Ok(Self {
            cat: cat.checked()?,
            tilt: within("the tilt", tilt, -MOST_TURNED, MOST_TURNED)?,
            air: None,
            gravity: None,
        })
    }

    /// Adds [`Air`](crate::scene::effects::Air) or [`Gravity`](crate::scene::effects::Gravity).
    ///
    /// # Errors
    /// [`Error::Effect`](crate::Error::Effect) for any other.
    ///
    /// ```
    /// use spinning_bodies::{phenomena, scene::{Request, Scene, effects::Gravity, shape::PaperCat}};
    /// let cat = PaperCat::new(phenomena::PaperCat::POSTCARD, 2.0)?.with(Gravity::new(9.81)?)?;
    /// let motion = cat.simulate(&Request::at([2.0])?)?;
    /// assert!((motion.rows[0].1.fall - 2.0 * 9.81).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn with(mut self, effect: impl Into<Effect>) -> Result<Self> {
        match effect.into() {
            Effect::Air(air) => self.air = Some(air.value()),
            Effect::Gravity(gravity) => self.gravity = Some(gravity.value()),
            other => return Err(other.refused("a paper cat", "air, gravity")),
        }
        Ok(self)
    }

    /// The position from which the tilt is counted: feet down, or exactly upside down if the start is nearer to that.
    fn rest(&self) -> f64 {
        if self.tilt.cos() < 0.0 && self.tilt.abs() < TAU {
            PI.copysign(self.tilt)
        } else {
            0.0
        }
    }

    /// The tilt from [`rest`](Self::rest).
    fn leaning(&self) -> f64 {
        let rest = self.rest();
        // π exceeds its double.
        (self.tilt - rest) - rest / PI * PI_LEFT
    }

    /// Time and height at which the cat first points its feet down, or `None` if it does not within `time` (s). Observed error: 1e-12.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::Integration`](crate::Error::Integration).
    ///
    /// ```
    /// use spinning_bodies::{phenomena, scene::{effects::{Air, Gravity}, shape::PaperCat}};
    /// let cat = PaperCat::new(phenomena::PaperCat::POSTCARD, 175_f64.to_radians())?.with(Gravity::new(9.81)?)?;
    /// assert_eq!(cat.rights_itself(10.0)?, None); // in a vacuum
    /// let fall = cat.with(Air::new(1.2)?)?.rights_itself(10.0)?.map(|righting| righting.fall);
    /// assert!(fall.is_some_and(|fall| (fall - 0.965_072).abs() < 1e-6));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn rights_itself(&self, time: f64) -> Result<Option<Righting>> {
        let falling = self.falling(positive("the time to wait", time)?);
        let (side, rest) = (self.tilt.signum(), self.rest());
        let upright = move |_: f64, y: &[f64; 5]| side * (rest + y[2]);
        let leg: Leg<'_, 5, dyn System<5>> = Leg {
            system: &|t: f64, y: &[f64; 5]| falling.rate((), t, y),
            kept: Kept::Nothing,
            start: (0.0, &falling.start()?.1),
            scales: &falling.scales(),
            times: &[],
            end: time,
        };
        let run = leg.follow(Some(&upright), Effort::Tolerance(1e-14))?;
        let (time, fall) = (run.time, run.end[0]);
        Ok((run.stopped == Stop::AtTheEvent).then_some(Righting { time, fall }))
    }

    /// The flow of the cat for a time `last`.
    fn falling(&self, last: f64) -> Falling {
        let Self { mut cat, air, .. } = *self;
        let g = self.gravity.unwrap_or(0.0).abs();
        let fastest = air.map_or(f64::INFINITY, |air| cat.terminal_speed(air, g));
        // Near upside down the moment of the air has the opposite sign.
        if self.rest() != 0.0 {
            cat.lever = -cat.lever;
        }
        Falling {
            cat: Self { cat, ..*self },
            speed: fastest.min(g * last),
            height: size(fastest.min(g * last) * last),
            pace: (g * cat.lever.abs()).sqrt() / cat.gyration,
        }
    }
}

/// The size by which a quantity is judged; 1 for a quantity that stays 0.
fn size(greatest: f64) -> f64 {
    if greatest > 0.0 { greatest } else { 1.0 }
}

/// A paper cat as a flow, its greatest speed and height of fall, and the rate at which it swings.
#[derive(Clone, Copy)]
struct Falling {
    cat: PaperCat,
    speed: f64,
    height: f64,
    pace: f64,
}

impl Falling {
    /// The components with the rate of the tilt itself.
    fn told(&self, &[fall, velocity, tilt, sum, lost]: &[f64; 5]) -> [f64; 5] {
        [fall, velocity, tilt, sum - self.pace * tilt, lost]
    }

    /// The pace, rad/s; without a lever nothing turns the cat, and the fall alone has a rate.
    fn fastest(&self) -> f64 {
        let turning = Some(self.pace).filter(|&pace| pace > 0.0);
        size(turning.unwrap_or(self.speed / self.cat.cat.gyration))
    }
}

/// The components: fall, velocity, tilt from [`rest`](PaperCat::rest), its rate plus the pace times the tilt, loss. The sum is small only near balance, where its
/// error must be as small; the rate alone comes to zero where the cat has righted itself.
impl Flow<5> for Falling {
    type Phase = ();

    fn start(&self) -> Result<((), [f64; 5])> {
        let tilt = self.cat.leaning();
        Ok(((), [0.0, 0.0, tilt, self.pace * tilt, 0.0]))
    }

    fn scales(&self) -> [f64; 5] {
        // The error of a cat near balance is relative to its distance from balance.
        let near = self.cat.leaning().abs().clamp(1e-8, 1.0);
        let length = self.cat.cat.gyration;
        let rate = self.fastest();
        let speed = length * rate;
        [length, speed, near, near * rate, speed * speed]
    }

    fn pace(&self) -> f64 {
        self.pace
    }

    fn rate(&self, (): (), _: f64, y: &[f64; 5]) -> [f64; 5] {
        let (cat, air) = (&self.cat.cat, self.cat.air);
        let [_, velocity, tilt, tilt_rate, _] = self.told(y);
        let own = self.cat.gravity.unwrap_or(0.0);
        match air {
            None => [velocity, own, tilt_rate, self.pace * tilt_rate, 0.0],
            Some(air) => {
                let drag = cat.drag(air, velocity);
                let turn = cat.righting(air, velocity, tilt, tilt_rate);
                let sum_rate = turn + self.pace * tilt_rate;
                [velocity, own - drag, tilt_rate, sum_rate, drag * velocity]
            }
        }
    }

    fn distance(&self, ((), a): &((), [f64; 5]), ((), b): &((), [f64; 5])) -> f64 {
        let energy = size(self.speed * self.speed);
        let scales = [self.height, size(self.speed), 1.0, self.fastest(), energy];
        apart(&self.told(a), &self.told(b), &scales)
    }
}

impl Scene for PaperCat {
    type State = PaperCatState;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let plan = match self.air {
            Some(_) => Plan::stepped("air: no closed form"),
            None => Plan::exact("no air: a rigid body at rest does not turn"),
        };
        let solvers = "the solver of a paper cat is `exact`, if there is no air, or one that steps";
        planned_forward(request, plan, solvers)
    }

    fn simulate(&self, request: &Request) -> Result<Motion<PaperCatState>> {
        let plan = self.plan(request)?;
        let (falling, exact) = (self.falling(request.furthest), plan.solver == Solver::Exact);
        let trace = solved((&falling, &plan, request), 1, &|t| {
            let [fall, velocity] = self.gravity.map_or([0.0; 2], |g| [0.5 * g * t * t, g * t]);
            Ok([fall, velocity, self.tilt, 0.0, 0.0])
        })?;
        let rest = self.rest();
        let mut ledger = trace.told(request, plan, |_, _, y| {
            if exact {
                return PaperCatState::of(*y);
            }
            let [fall, velocity, tilt, rate, lost] = falling.told(y);
            PaperCatState::of([fall, velocity, rest + tilt, rate, lost])
        });
        let energy = |_: usize, state: &PaperCatState| {
            let kinetic = 0.5 * state.velocity * state.velocity;
            self.gravity.map_or(kinetic, |g| kinetic - g * state.fall)
        };
        let largest = ledger.greatest(0.0, |_, state| state.velocity.powi(2));
        let name = "energy of fall with what the air took";
        ledger.conserved(name, largest, 0.0, |k, s| energy(k, s) + s.lost)?;
        ledger.keep(("energy of fall", Law::NonIncreasing, largest), 0.0, energy)?;
        ledger.closed(request)
    }

    fn further(&self) -> Columns<PaperCatState> {
        let moment = self.cat.mass * self.cat.gyration.powi(2);
        columns! { |state: &PaperCatState|
            "l", "kg m²/s", "angular momentum about the centre of mass" => moment * state.tilt_rate;
        }
    }
}
