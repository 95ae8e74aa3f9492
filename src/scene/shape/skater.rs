//! The scene `skater` (tutorial 1.1): a skater who pulls in the arms.

use super::path::{Draw, next_of};
use crate::error::{Result, finite, not_negative};
use crate::phenomena;
use crate::phenomena::quadrature::integral;
use crate::scene::columns::{Columns, columns, state};
use crate::scene::effects::Effect;
use crate::scene::engine::{AN_INTEGRAL, Flow, apart, planned, solved};
use crate::scene::{Motion, Plan, Request, Scene};

/// A spinning skater: a core, two hands, a path for them, and the friction of the ice.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Skater {
    body: phenomena::Skater,
    reach: f64,
    spin: f64,
    draw: Option<Draw>,
    bearing_friction: Option<f64>,
}

state! {
    /// A skater at one time.
    SkaterState {
        /// Angle turned, rad.
        angle,
        /// Angular velocity Ω, rad/s.
        spin,
        /// Distance of the hands from the axis, m.
        reach,
        /// Kinetic energy, J.
        energy,
        /// Work of the arms so far, J.
        work,
        /// Heat of the bearing so far, J.
        heat,
    }
}

impl Skater {
    /// A skater with the hands at rest at a distance (m) from the axis, spinning at `spin` (rad/s).
    ///
    /// # Errors
    /// [`Error::Negative`](crate::Error::Negative), [`Error::NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// use spinning_bodies::{phenomena, scene::{Request, Scene, shape::Skater}};
    /// let skater = Skater::new(phenomena::Skater::new(0.8, 2.5)?, 0.7, 2.0)?;
    /// let motion = skater.simulate(&Request::at([3.0])?)?;
    /// assert!((motion.rows[0].1.angle - 6.0).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(body: phenomena::Skater, reach: f64, spin: f64) -> Result<Self> {
        Ok(Self {
            body,
            reach: not_negative("the distance of the hands", reach)?,
            spin: finite("the spin", spin)?,
            draw: None,
            bearing_friction: None,
        })
    }

    /// Adds a path of the hands, [`Draw`], or [`BearingFriction`](crate::scene::effects::BearingFriction) of the ice.
    ///
    /// # Errors
    /// [`Error::Effect`](crate::Error::Effect) for any other effect; the errors of an invalid path.
    ///
    /// ```
    /// use spinning_bodies::{phenomena, scene::{Request, Scene, effects::{Draw, Pace}, shape::Skater}};
    /// let body = phenomena::Skater::new(0.8, 2.5)?;
    /// // From 3.5 kg m² to 1 kg m²: three and a half times the spin.
    /// let [out, close] = [body.reach(3.5)?, body.reach(1.0)?];
    /// let draw = Draw { to: close, begin: 0.0, duration: 1.0, pace: Pace::Even };
    /// let motion = Skater::new(body, out, 2.0)?.with(draw)?.simulate(&Request::at([1.0])?)?;
    /// assert!((motion.rows[0].1.spin - 7.0).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn with(mut self, effect: impl Into<Effect>) -> Result<Self> {
        match effect.into() {
            Effect::Draw(draw) => self.draw = Some(draw.checked()?),
            Effect::BearingFriction(friction) => self.bearing_friction = Some(friction.value()),
            other => return Err(other.refused("a skater", "draw, bearing_friction")),
        }
        Ok(self)
    }

    /// Distance of the hands, its rate and its acceleration.
    fn reach(&self, t: f64) -> [f64; 3] {
        let still = [self.reach, 0.0, 0.0];
        self.draw.map_or(still, |draw| draw.reach(self.reach, t))
    }

    fn angular_momentum(&self) -> f64 {
        self.body.moment(self.reach) * self.spin
    }

    /// An upper bound of the spin, rad/s.
    fn fastest(&self) -> f64 {
        let nearest = self.draw.map_or(self.reach, |draw| draw.to.min(self.reach));
        let spin = self.body.spin(self.angular_momentum(), nearest);
        spin.abs().max(f64::MIN_POSITIVE)
    }

    fn state(&self, t: f64, &[angle, spin, work, heat]: &[f64; 4]) -> SkaterState {
        let [reach, rate, _] = self.reach(t);
        let energy = self.body.energy(spin, reach, rate);
        SkaterState::of([angle, spin, reach, energy, work, heat])
    }

    /// The state in closed form: Ω = L/I, and its integral while the hands move.
    fn known(&self, t: f64) -> Result<[f64; 4]> {
        let l = self.angular_momentum();
        let [reach, rate, _] = self.reach(t);
        let spin = |t: f64| self.body.spin(l, self.reach(t)[0]);
        let angle = match self.draw.map(|draw| draw.corners()) {
            None => spin(t) * t,
            Some([begin, end]) => {
                let moving = integral(spin, begin, t.clamp(begin, end))?;
                spin(0.0) * t.min(begin) + moving + spin(t) * (t - end).max(0.0)
            }
        };
        let work = self.body.work(l, self.reach, reach)? + self.body.hand * rate * rate;
        Ok([angle, spin(t), work, 0.0])
    }
}

/// The components, with friction: angle, spin, work and heat.
impl Flow<4> for Skater {
    type Phase = ();

    fn start(&self) -> Result<((), [f64; 4])> {
        Ok(((), [0.0, self.spin, 0.0, 0.0]))
    }

    fn scales(&self) -> [f64; 4] {
        let fastest = self.fastest();
        // Moving hands have energy even without spin.
        let hands = self.draw.map_or(0.0, |draw| {
            (draw.to - self.reach) * draw.pace.greatest_rate() / draw.duration
        });
        let [spinning, drawn] = [(fastest, 0.0), (0.0, hands)]
            .map(|(spin, rate)| self.body.energy(spin, self.reach, rate));
        let energy = spinning.max(drawn).max(f64::MIN_POSITIVE);
        [1.0, fastest, energy, energy]
    }

    fn pace(&self) -> f64 {
        self.fastest()
    }

    fn rate(&self, (): (), t: f64, y: &[f64; 4]) -> [f64; 4] {
        let ([reach, rate, acceleration], spin) = (self.reach(t), y[1]);
        let power = self.body.power(spin, reach, rate, acceleration);
        let free = self.body.acceleration(spin, reach, rate);
        match self.bearing_friction {
            None => [spin, free, power, 0.0],
            Some(c) => {
                let braked = free - c * spin / self.body.moment(reach);
                [spin, braked, power, c * spin * spin]
            }
        }
    }

    fn lasts_until(&self, (): (), t: f64) -> f64 {
        next_of(self.draw.map(|draw| draw.corners()), t)
    }

    fn distance(&self, ((), a): &((), [f64; 4]), ((), b): &((), [f64; 4])) -> f64 {
        apart(a, b, &self.scales())
    }
}

/// The message for a solver that this kind of scene does not have.
const SOLVERS: &str = "the solver of a skater is `exact`, if nothing resists, or one that steps";

impl Scene for Skater {
    type State = SkaterState;

    fn plan(&self, request: &Request) -> Result<Plan> {
        request.forward()?;
        let plan = match self.bearing_friction {
            Some(_) => Plan::stepped("bearing friction: no closed form"),
            None => Plan::exact("no torque: spin and moment have a fixed product"),
        };
        planned(request, plan, SOLVERS)
    }

    fn simulate(&self, request: &Request) -> Result<Motion<SkaterState>> {
        let plan = self.plan(request)?;
        let run = (self, &plan, request);
        let trace = solved(run, AN_INTEGRAL, |t| self.known(t))?;
        let mut books = trace.told(request, plan, |t, _, y| self.state(t, y));
        let l = self.angular_momentum();
        let start = self.state(0.0, &[0.0, self.spin, 0.0, 0.0]);
        // The hands change the energy, and with it the rounding: drifts are relative to the greatest energy.
        let energies = books.states().map(|state| state.energy);
        let largest = energies.fold(start.energy, f64::max);
        let momentum = |_: usize, state: &SkaterState| {
            let now = self.body.moment(state.reach) * state.spin;
            self.bearing_friction.map_or(now, |c| now + c * state.angle)
        };
        let balance = |_: usize, state: &SkaterState| state.energy + state.heat - state.work;
        books.conserved("angular momentum", l.abs(), l, momentum)?;
        let name = "energy less the work of the arms";
        books.conserved(name, largest, start.energy, balance)?;
        books.closed(request)
    }

    fn further(&self) -> Columns<SkaterState> {
        let body = self.body;
        columns! { |state: &SkaterState|
            "moment", "kg m²", "moment of inertia" => body.moment(state.reach);
            "l", "kg m²/s", "angular momentum" => body.moment(state.reach) * state.spin;
        }
    }
}
