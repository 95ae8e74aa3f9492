//! The scenes `swivel` and `skater` (tutorial 1.1): a body of two parts, and one that pulls in the arms, both turning about the vertical on ice.

use crate::phenomena::{self, quadrature::integral};
use crate::scene::path::{Draw, FourPhases, Twist, next_of};
use crate::scene::prelude::*;

/// Two parts on one vertical axis, the lower one free to turn on the ice: angular momentum L, a path of shapes, and the friction of the bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swivel {
    lower: f64,
    upper: f64,
    angular_momentum: f64,
    path: Option<FourPhases>,
    bearing_friction: Option<f64>,
}

state! {
    /// A swivel at one time.
    SwivelState {
        /// How far the lower part has turned, rad.
        lower,
        /// How far the upper part has turned, rad.
        upper,
        /// Moment of the upper part, kg m².
        upper_moment,
        /// Rate of the lower part, rad/s.
        rate,
        /// Angular momentum L, kg m²/s.
        angular_momentum,
    }
}

impl Swivel {
    /// A body at rest without effects, its parts with these moments (kg m²).
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// use spinning_bodies::scene::{Request, Scene, shape::Swivel};
    /// let motion = Swivel::new(0.6, 2.0)?.simulate(&Request::at([5.0])?)?;
    /// assert_eq!(motion.rows[0].1.lower, 0.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(lower: f64, upper: f64) -> Result<Self> {
        Ok(Self {
            lower: positive("the lower moment", lower)?,
            upper: positive("the upper moment", upper)?,
            angular_momentum: 0.0,
            path: None,
            bearing_friction: None,
        })
    }

    /// Adds a path of shapes, [`FourPhases`], or [`BearingFriction`](crate::scene::effects::BearingFriction).
    ///
    /// # Errors
    /// [`Error::Effect`](crate::Error::Effect) for any other effect; the errors of an invalid path.
    ///
    /// ```
    /// use std::f64::consts::{FRAC_PI_2, FRAC_PI_8};
    /// use spinning_bodies::scene::{Request, Scene, effects::{FourPhases, Pace}, shape::Swivel};
    /// let phases = FourPhases { arms_out: 3.0, arms_in: 1.0, twist: FRAC_PI_2, duration: 2.0, pace: Pace::Even };
    /// let motion = Swivel::new(1.0, 3.0)?.with(phases)?.simulate(&Request::at([2.0])?)?;
    /// // It turns by 3/4 of the twist, and back by 1/2 of it.
    /// assert!((motion.rows[0].1.lower + FRAC_PI_8).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn with(mut self, effect: impl Into<Effect>) -> Result<Self> {
        match effect.into() {
            Effect::FourPhases(path) => self.path = Some(path.checked()?),
            Effect::BearingFriction(friction) => self.bearing_friction = Some(friction.value()),
            other => return Err(other.refused("a swivel", "four_phases, bearing_friction")),
        }
        Ok(self)
    }

    /// Sets the angular momentum at the start, kg m²/s.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// use spinning_bodies::scene::{Request, Scene, shape::Swivel};
    /// let turning = Swivel::new(0.6, 2.0)?.with_angular_momentum(2.6)?;
    /// let motion = turning.simulate(&Request::at([5.0])?)?;
    /// assert!((motion.rows[0].1.lower - 5.0).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn with_angular_momentum(mut self, l: f64) -> Result<Self> {
        self.angular_momentum = finite("the angular momentum", l)?;
        Ok(self)
    }

    fn shape(&self, t: f64) -> Twist {
        let (upper, angle, rate) = (self.upper, 0.0, 0.0);
        let still = Twist { upper, angle, rate };
        self.path.map_or(still, |path| path.at(t))
    }

    fn lower_rate(&self, l: f64, shape: &Twist) -> f64 {
        phenomena::Swivel { lower: self.lower }.rate(l, shape.upper, shape.rate)
    }

    fn state(&self, t: f64, &[since, l, before]: &[f64; 3]) -> SwivelState {
        let (shape, lower) = (self.shape(t), before + since);
        let (upper, rate) = (lower + shape.angle, self.lower_rate(l, &shape));
        SwivelState::of([lower, upper, shape.upper, rate, l])
    }

    /// The least moment of the whole body, and an upper bound of the lower part's rate.
    fn extremes(&self) -> (f64, f64) {
        let (upper, twist) = self.path.map_or((self.upper, 0.0), |path| path.extremes());
        let moment = upper + self.lower;
        let turning = self.angular_momentum.abs() / moment;
        (moment, (turning + twist).max(f64::MIN_POSITIVE))
    }

    /// The angle of the lower part: whole cycles, whole phases of the last one, and one integral for the rest.
    fn turned(&self, parts: &[f64], t: f64) -> Result<f64> {
        let Some(path) = &self.path else {
            return Ok(self.lower_rate(self.angular_momentum, &self.shape(t)) * t);
        };
        let (since, part) = (t.rem_euclid(path.duration), path.part());
        let rounds = ((t - since) / path.duration).round();
        finite("the number of rounds", rounds)?;
        let passed = ((since / part) as usize).min(parts.len() - 2);
        let rate = |t: f64| self.lower_rate(self.angular_momentum, &path.at(t));
        let rest = integral(rate, passed as f64 * part, since)?;
        Ok(rounds * parts[parts.len() - 1] + (parts[passed] + rest))
    }

    /// The angle of the lower part at the beginning of a cycle and after each of its phases.
    fn parts(&self, path: &FourPhases) -> Result<Vec<f64>> {
        let rate = |t: f64| self.lower_rate(self.angular_momentum, &path.at(t));
        let mut parts = vec![0.0];
        for n in 0..4_u8 {
            let [from, to] = [n, n + 1].map(|n| f64::from(n) * path.part());
            parts.push(parts[usize::from(n)] + integral(rate, from, to)?);
        }
        Ok(parts)
    }
}

/// The components, with friction: the angle of the lower part since the last corner of the path, L, and the angle before that: many rounds do not
/// loosen the tolerance of the last.
impl Flow<3> for Swivel {
    type Phase = ();

    fn start(&self) -> Result<((), [f64; 3])> {
        Ok(((), [0.0, self.angular_momentum, 0.0]))
    }

    fn scales(&self) -> [f64; 3] {
        let (moment, fastest) = self.extremes();
        [1.0, (moment * fastest).max(f64::MIN_POSITIVE), 1.0]
    }

    fn pace(&self) -> f64 {
        self.extremes().1
    }

    fn rate(&self, (): (), t: f64, y: &[f64; 3]) -> [f64; 3] {
        let rate = self.lower_rate(y[1], &self.shape(t));
        let torque = self.bearing_friction.map_or(0.0, |c| -c * rate);
        [rate, torque, 0.0]
    }

    fn lasts_until(&self, (): (), t: f64) -> f64 {
        let path = self.path;
        path.map_or(f64::INFINITY, |path| path.corner_after(t))
    }

    fn next(&self, (): (), _: Stop, _: f64, y: &mut [f64; 3]) -> Result<()> {
        *y = [0.0, y[1], y[2] + y[0]];
        Ok(())
    }

    fn distance(&self, ((), a): &((), [f64; 3]), ((), b): &((), [f64; 3])) -> f64 {
        let whole = |y: &[f64; 3]| [y[0] + y[2], y[1], 0.0];
        apart(&whole(a), &whole(b), &self.scales())
    }
}

impl Scene for Swivel {
    type State = SwivelState;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let plan = match self.bearing_friction {
            Some(_) => Plan::stepped("bearing friction: no closed form"),
            None => Plan::exact("no torque: one integral along the path of shapes"),
        };
        let solvers = "the solver of a swivel is `exact`, if nothing resists, or one that steps";
        planned_forward(request, plan, solvers)
    }

    fn simulate(&self, request: &Request) -> Result<Motion<SwivelState>> {
        let plan = self.plan(request)?;
        let (l, exact) = (self.angular_momentum, plan.solver == Solver::Exact);
        let parts = match &self.path {
            Some(path) if exact => self.parts(path)?,
            Some(path) => path.passed_through(request.furthest).map(|_| Vec::new())?,
            None => Vec::new(),
        };
        let evaluations = self.path.map_or(1, |_| AN_INTEGRAL);
        let known = |t| Ok([self.turned(&parts, t)?, l, 0.0]);
        let trace = solved((self, &plan, request), evaluations, &known)?;
        let mut ledger = trace.told(request, plan, |t, _, y| self.state(t, y));
        let upper = |place: usize, state: &SwivelState| {
            let rate = state.rate + self.shape(request.times()[place]).rate;
            state.upper_moment * rate
        };
        // L, summed over the two parts from their rates, plus what the bearing has taken.
        let whole = |place: usize, state: &SwivelState| {
            let both = upper(place, state) + self.lower * state.rate;
            self.bearing_friction
                .map_or(both, |c| both + c * state.lower)
        };
        let scale = ledger.greatest(l.abs(), |place, state| upper(place, state).abs());
        ledger.conserved("angular momentum", scale, l, whole)?;
        ledger.closed(request)
    }

    fn further(&self) -> Columns<SwivelState> {
        columns! { |state: &SwivelState|
            "twist", "rad", "angle of the upper part on the lower" => state.upper - state.lower;
        }
    }
}

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

    /// Distance of the hands and its rate.
    fn reach(&self, t: f64) -> [f64; 2] {
        let still = [self.reach, 0.0];
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

    fn state(&self, t: f64, &[angle, l, against_spin, heat]: &[f64; 4]) -> SkaterState {
        let [reach, rate] = self.reach(t);
        let spin = self.body.spin(l, reach);
        let [energy, resting] = [spin, 0.0].map(|spin| self.body.energy(spin, reach, rate));
        SkaterState::of([angle, spin, reach, energy, against_spin + resting, heat])
    }

    /// The state in closed form: Ω = L/I, and its integral while the hands move.
    fn known(&self, t: f64) -> Result<[f64; 4]> {
        let l = self.angular_momentum();
        let spin = |t: f64| self.body.spin(l, self.reach(t)[0]);
        let angle = match self.draw.map(|draw| draw.corners()) {
            None => spin(t) * t,
            Some([begin, end]) => {
                let moving = integral(spin, begin, t.clamp(begin, end))?;
                spin(0.0) * t.min(begin) + moving + spin(t) * (t - end).max(0.0)
            }
        };
        let work = self.body.work(l, self.reach, self.reach(t)[0])?;
        Ok([angle, l, work, 0.0])
    }
}

/// The components, with friction: angle, L, the work against the spin, without what the hands gain on their way, and heat.
impl Flow<4> for Skater {
    type Phase = ();

    fn start(&self) -> Result<((), [f64; 4])> {
        Ok(((), [0.0, self.angular_momentum(), 0.0, 0.0]))
    }

    fn scales(&self) -> [f64; 4] {
        let l = self.angular_momentum().abs();
        let energy = (0.5 * l * self.fastest()).max(f64::MIN_POSITIVE);
        [1.0, l.max(f64::MIN_POSITIVE), energy, energy]
    }

    fn pace(&self) -> f64 {
        self.fastest()
    }

    fn rate(&self, (): (), t: f64, y: &[f64; 4]) -> [f64; 4] {
        let [reach, rate] = self.reach(t);
        let spin = self.body.spin(y[1], reach);
        let power = self.body.power(spin, reach, rate);
        let torque = self.bearing_friction.map_or(0.0, |c| c * spin);
        [spin, -torque, power, torque * spin]
    }

    fn lasts_until(&self, (): (), t: f64) -> f64 {
        next_of(self.draw.map(|draw| draw.corners()), t)
    }

    fn distance(&self, ((), a): &((), [f64; 4]), ((), b): &((), [f64; 4])) -> f64 {
        apart(a, b, &self.scales())
    }
}

impl Scene for Skater {
    type State = SkaterState;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let plan = match self.bearing_friction {
            Some(_) => Plan::stepped("bearing friction: no closed form"),
            None => Plan::exact("no torque: spin and moment have a fixed product"),
        };
        let solvers = "the solver of a skater is `exact`, if nothing resists, or one that steps";
        planned_forward(request, plan, solvers)
    }

    fn simulate(&self, request: &Request) -> Result<Motion<SkaterState>> {
        let plan = self.plan(request)?;
        let run = (self, &plan, request);
        let trace = solved(run, AN_INTEGRAL, &|t| self.known(t))?;
        let mut ledger = trace.told(request, plan, |t, _, y| self.state(t, y));
        let l = self.angular_momentum();
        let start = self.state(0.0, &[0.0, l, 0.0, 0.0]);
        // The hands change the energy, and with it the rounding: drifts are relative to the greatest energy, of the spin or of the hands, between two rows perhaps.
        let hands = self.draw.map_or(0.0, |draw| {
            (draw.to - self.reach) * draw.pace.greatest_rate() / draw.duration
        });
        let [.., scale] = self.scales();
        let scale = scale.max(self.body.energy(0.0, self.reach, hands));
        let largest = ledger.greatest(scale, |_, state| state.energy);
        let momentum = |_: usize, state: &SkaterState| {
            let now = self.body.moment(state.reach) * state.spin;
            self.bearing_friction.map_or(now, |c| now + c * state.angle)
        };
        let balance = |_: usize, state: &SkaterState| state.energy + state.heat - state.work;
        ledger.conserved("angular momentum", l.abs(), l, momentum)?;
        let name = "energy less the work of the arms";
        ledger.conserved(name, largest, start.energy, balance)?;
        ledger.closed(request)
    }

    fn further(&self) -> Columns<SkaterState> {
        let body = self.body;
        columns! { |state: &SkaterState|
            "moment", "kg m²", "moment of inertia" => body.moment(state.reach);
            "l", "kg m²/s", "angular momentum" => body.moment(state.reach) * state.spin;
        }
    }
}
