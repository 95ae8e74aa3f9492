//! The scenes `roller` (tutorial 4.3 and 4.5), a round body on a table, struck by a cue or on a sheet that is withdrawn, and `spool` (4.4), pulled at its
//! string.

use super::prelude::*;
use crate::rolling::moment::State;
use crate::rolling::stretch::{Laws, Stretch};
use crate::rolling::{Course, Load, Moment, RoundBody, Shot, Spool};

/// A round body on a level table.
///
/// | effect | what it does |
/// |---|---|
/// | [`Coulomb`](super::effects::Coulomb) | friction against the slip, until the body rolls |
/// | [`RollingResistance`](super::effects::RollingResistance) | a couple against the rotation, until the body rests |
/// | [`Sheet`](super::effects::Sheet) | a moving ground under the body, until its edge has passed |
///
/// Without any of them the body glides and turns uniformly. Between events every velocity is linear in time, so the plan is the
/// [`Course`]: closed forms from event to event. The equations are there for a request that chooses a solver with steps.
///
/// ```
/// use spinning_bodies::rolling::RoundBody;
/// use spinning_bodies::scene::effects::Coulomb;
/// use spinning_bodies::scene::{Request, Roller, Scene};
///
/// let ball = RoundBody::new(0.17, 0.0286, 0.4)?;
/// let drawn = Roller::new(ball, 9.81, 1.0, -4.0)?.with(Coulomb::new(0.2)?)?;
/// let motion = drawn.simulate(&Request::at([5.0])?)?;
/// let rolls = &motion.rows[0].1.moment;
/// assert!((rolls.velocity - (1.0 - 0.4 * 4.0) / 1.4).abs() < 1e-15); // it comes back
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Roller {
    body: RoundBody,
    /// Its weight and, for a [spool](TuggedSpool), the pull at its string; and the effects on it.
    laws: Laws,
    start: Moment,
}

impl Roller {
    /// A body on the table under gravity (m/s²), with this velocity and rim speed (m/s).
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) for gravity; [`Error::NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// use spinning_bodies::{rolling::RoundBody, scene::{Request, Roller, Scene}};
    /// let ball = RoundBody::new(0.17, 0.0286, 0.4)?;
    /// // Without friction it keeps its velocity.
    /// let motion = Roller::new(ball, 10.0, 7.0, 0.0)?.simulate(&Request::at([2.0])?)?;
    /// assert_eq!(motion.rows[0].1.moment.velocity, 7.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(body: RoundBody, gravity: f64, velocity: f64, rim_speed: f64) -> Result<Self> {
        let load = Load::weight(positive("the acceleration of gravity", gravity)?);
        finite("the velocity", velocity)?;
        finite("the rim speed", rim_speed)?;
        Ok(Self {
            body,
            laws: Laws::new(body.inertia_factor, load, (None, None, None)),
            start: Moment::moving(velocity, rim_speed),
        })
    }

    /// The body of a [`Shot`] just after the stroke, its slip computed from the height of the stroke.
    ///
    /// # Errors
    /// Those of [`Self::new`].
    ///
    /// ```
    /// use spinning_bodies::{rolling::RoundBody, scene::{Request, Roller, Scene, effects::Coulomb}};
    /// let ball = RoundBody::new(0.17, 0.0286, 0.4)?;
    /// let struck = Roller::after(&ball.strike(1.0, 7.0)?, 10.0)?.with(Coulomb::new(0.2)?)?;
    /// let motion = struck.simulate(&Request::at([2.0])?)?;
    /// assert!((motion.rows[0].1.moment.velocity - 5.0).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn after(shot: &Shot, gravity: f64) -> Result<Self> {
        let mut roller = Self::new(shot.body, gravity, shot.velocity, shot.rim_speed)?;
        roller.start.slip = shot.slip;
        Ok(roller)
    }

    /// Adds [`Coulomb`](super::effects::Coulomb)'s friction on the table, [`RollingResistance`](super::effects::RollingResistance), or a [`Sheet`](super::effects::Sheet) between body and table.
    ///
    /// # Errors
    /// [`Error::Effect`](crate::Error::Effect) for any other effect.
    ///
    /// ```
    /// use spinning_bodies::{rolling::RoundBody, scene::{Request, Roller, Scene, effects::Coulomb}};
    /// let ball = RoundBody::new(0.17, 0.0286, 0.4)?;
    /// let sliding = Roller::new(ball, 10.0, 7.0, 0.0)?.with(Coulomb::new(0.2)?)?;
    /// let motion = sliding.simulate(&Request::at([0.5])?)?;
    /// // μg = 2 m/s².
    /// assert!((motion.rows[0].1.moment.velocity - 6.0).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn with(mut self, effect: impl Into<Effect>) -> Result<Self> {
        match effect.into() {
            Effect::Coulomb(law) => self.laws.friction = law.acts().then_some(law),
            Effect::RollingResistance(law) => self.laws.resistance = Some(law),
            Effect::Sheet(sheet) => self.laws.sheet = Some(sheet),
            other => return Err(other.refused("a roller", "friction, rolling_resistance, sheet")),
        }
        Ok(self)
    }

    fn table(&self, span: f64) -> Result<OnTable<'_>> {
        let (laws, mut start) = (self.laws.checked()?, self.start);
        if let Some(sheet) = &laws.sheet {
            start.slip -= sheet.speeds.points[0].1;
        }
        Ok(OnTable {
            body: self.body,
            laws,
            start,
            span,
        })
    }
}

state! {
    /// A body on the table at one time.
    Rolling(along(|state: &Self| state.moment)) {
        /// kinetic energy, J
        energy,
        /// heat of friction and rolling resistance so far, J
        heat,
    }
    /// Position and motion.
    moment: Moment,
}

/// Columns of the position and motion of a round body.
fn along<S: 'static>(of: fn(&S) -> Moment) -> Columns<S> {
    columns! { |state: &S|
        "x", "m", "place of the centre along the table" => of(state).position;
        "velocity", "m/s", "velocity of the centre" => of(state).velocity;
        "rim_speed", "m/s", "radius times angular velocity, positive as in rolling" => of(state).rim_speed;
        "slip", "m/s", "velocity of the point in contact over the ground under it" => of(state).slip;
    }
}

impl Scene for Roller {
    type State = Rolling;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let slides = self.laws.friction.is_some() || self.laws.sheet.is_some();
        let resistance = self.laws.resistance.map(|_| "rolling resistance");
        rolling_plan(request, slides.then_some("sliding friction").or(resistance))
    }

    fn simulate(&self, request: &Request) -> Result<Motion<Rolling>> {
        let plan = self.plan(request)?;
        let table = self.table(request.furthest)?;
        let (mass, kappa) = (self.body.mass, self.body.inertia_factor);
        table.motion(request, plan, |moment| {
            let parts = [moment.energy(kappa), moment.heat];
            Rolling::of(parts.map(|part| mass * part), moment)
        })
    }

    fn further(&self) -> Columns<Rolling> {
        moments(self.body, |state: &Rolling| state.moment)
    }
}

/// Further columns for the position and motion of a round body.
fn moments<S: 'static>(body: RoundBody, of: fn(&S) -> Moment) -> Columns<S> {
    let (mass, kappa, radius) = (body.mass, body.inertia_factor, body.radius);
    columns! { |state: &S|
        "turned", "rad", "angle turned" => of(state).turned / radius;
        "omega", "rad/s", "angular velocity" => of(state).rim_speed / radius;
        "translation", "J", "kinetic energy of the centre" => 0.5 * mass * of(state).velocity.powi(2);
        "rotation", "J", "kinetic energy about the centre" => 0.5 * mass * kappa * of(state).rim_speed.powi(2);
        "driven", "J", "work of tug and moving sheet so far" => mass * of(state).work;
        "l_about_table", "kg m²/s", "angular momentum about the line of contact" => mass * radius * of(state).about_the_table(kappa);
        "l", "kg m²/s", "angular momentum about the centre" => mass * kappa * radius * of(state).rim_speed;
    }
}

/// A spool on a level table, at rest or already moving.
///
/// | effect | what it does |
/// |---|---|
/// | [`Tug`](super::effects::Tug) | pulls steadily at the string, which winds or unwinds |
/// | [`Coulomb`](super::effects::Coulomb) | holds the contact, or rubs if the pull is too strong |
/// | [`RollingResistance`](super::effects::RollingResistance) | brakes the rotation by a couple |
///
/// ```
/// use spinning_bodies::rolling::{RoundBody, Spool};
/// use spinning_bodies::scene::effects::{Coulomb, Tug};
/// use spinning_bodies::scene::{Request, Scene, TuggedSpool};
///
/// let spool = Spool::new(RoundBody::new(0.2, 0.05, 0.5)?, 0.02)?;
/// let tugged = TuggedSpool::new(spool, 9.81)?.with(Coulomb::new(0.5)?)?.with(Tug::new(0.3, 0.5)?)?;
/// let motion = tugged.simulate(&Request::at([1.0])?)?;
/// assert!(motion.rows[0].1.wound > 0.0); // a low tug winds up
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct TuggedSpool {
    spool: Spool,
    gravity: f64,
    roller: Roller,
}

impl TuggedSpool {
    /// A spool at rest under gravity (m/s²).
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite) for gravity.
    ///
    /// ```
    /// use spinning_bodies::{rolling::{RoundBody, Spool}, scene::{Request, Scene, TuggedSpool}};
    /// let spool = Spool::new(RoundBody::new(2.0, 1.0, 0.5)?, 0.5)?;
    /// let motion = TuggedSpool::new(spool, 10.0)?.simulate(&Request::at([2.0])?)?;
    /// assert_eq!(motion.rows[0].1.moment.velocity, 0.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(spool: Spool, gravity: f64) -> Result<Self> {
        let roller = Roller::new(spool.body, gravity, 0.0, 0.0)?;
        Ok(Self {
            spool,
            gravity,
            roller,
        })
    }

    /// Sets the initial velocity and rim speed (m/s).
    ///
    /// ```
    /// use spinning_bodies::{rolling::{RoundBody, Spool}, scene::{Request, Scene, TuggedSpool}};
    /// let spool = Spool::new(RoundBody::new(2.0, 1.0, 0.5)?, 0.5)?;
    /// let motion = TuggedSpool::new(spool, 10.0)?.moving(1.5, 1.5).simulate(&Request::at([2.0])?)?;
    /// assert_eq!(motion.rows[0].1.moment.velocity, 1.5);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn moving(mut self, velocity: f64, rim_speed: f64) -> Self {
        self.roller.start = Moment::moving(velocity, rim_speed);
        self
    }

    /// Adds a [`Tug`](super::effects::Tug), [`Coulomb`](super::effects::Coulomb)'s friction on the table, or
    /// [`RollingResistance`](super::effects::RollingResistance).
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) for the reaction if the tug lifts the spool; [`Error::Effect`](crate::Error::Effect) for any
    /// other effect.
    ///
    /// ```
    /// use spinning_bodies::{rolling::{RoundBody, Spool}, scene::{Request, Scene, TuggedSpool, effects::{Coulomb, Tug}}};
    /// let spool = Spool::new(RoundBody::new(2.0, 1.0, 0.5)?, 0.5)?;
    /// let tugged = TuggedSpool::new(spool, 10.0)?.with(Tug::new(1.2, 0.0)?)?.with(Coulomb::new(0.3)?)?;
    /// let motion = tugged.simulate(&Request::at([2.0])?)?;
    /// // 0.2 m/s² for two seconds.
    /// assert!((motion.rows[0].1.moment.velocity - 0.4).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn with(mut self, effect: impl Into<Effect>) -> Result<Self> {
        let laws = &mut self.roller.laws;
        match effect.into() {
            Effect::Tug(tug) => laws.load = self.spool.load(tug, self.gravity)?,
            Effect::Coulomb(law) => laws.friction = law.acts().then_some(law),
            Effect::RollingResistance(law) => laws.resistance = Some(law),
            other => return Err(other.refused("a spool", "tug, friction, rolling_resistance")),
        }
        Ok(self)
    }
}

state! {
    /// A spool at one time.
    Spooling(along(|state: &Self| state.moment)) {
        /// string wound up so far, negative if unwound, m
        wound,
        /// kinetic energy, J
        energy,
        /// heat of friction and rolling resistance so far, J
        heat,
        /// work of the tug so far, J
        work,
    }
    /// Position and motion.
    moment: Moment,
}

impl Scene for TuggedSpool {
    type State = Spooling;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let laws = &self.roller.laws;
        let steady = laws.load != Load::weight(self.gravity) || laws.resistance.is_some();
        let friction = laws.friction.map(|_| "dry friction");
        rolling_plan(request, friction.or(steady.then_some("steady forces")))
    }

    fn simulate(&self, request: &Request) -> Result<Motion<Spooling>> {
        let plan = self.plan(request)?;
        let table = self.roller.table(request.furthest)?;
        let (mass, kappa) = (table.body.mass, table.body.inertia_factor);
        table.motion(request, plan, |moment| {
            let parts = [moment.energy(kappa), moment.heat, moment.work];
            let [energy, heat, work] = parts.map(|part| mass * part);
            Spooling::of([self.spool.wound(&moment), energy, heat, work], moment)
        })
    }

    fn further(&self) -> Columns<Spooling> {
        moments(self.spool.body, |state: &Spooling| state.moment)
    }
}

/// The plan of a rolling body: closed forms from event to event, where a force acts along the table, or a closed form without events.
fn rolling_plan(request: &Request, force: Option<&'static str>) -> Result<Plan> {
    let events = |force| format!("{force}: closed form from event to event");
    let reason = force.map_or("no force along the table: closed form".into(), events);
    let plan = match (request.choice, force) {
        (Choice::Auto | Choice::Use(Solver::Exact), None) => Plan::exact(reason),
        _ => Plan::events(reason),
    };
    let solvers = "the solver of what rolls is `events`, `exact` where no force acts along the table, or one that steps";
    planned_forward(request, plan, solvers)
}

/// A round body on a table under any of its laws: for [`Roller`] and [`TuggedSpool`].
#[derive(Clone, Copy)]
struct OnTable<'a> {
    body: RoundBody,
    laws: &'a Laws,
    start: Moment,
    /// The longest requested time, s.
    span: f64,
}

/// Relative change of a twin, which shows how the motion amplifies rounding. Each number is changed by a fraction of its own of it, so that the effects of
/// two changes do not cancel.
const MOVED: f64 = 1e-13;
/// Rounding error of each stretch, and that of the start in units of its amplification: sixteen times 2⁻⁵³. As many roundings lead
/// from the laws to the state at the end of a stretch: three for the slope of the sheet, one each for friction, couple, velocity and time, three for
/// the rate of the rim speed, two for that of the slip, and four for the state.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// Angle, rad, by which runs with steps are compared: between events a rolling body has no rate of its own.
const RADIANS: f64 = 16.0;

impl OnTable<'_> {
    /// The motion by the solver of a plan, each moment converted into a state.
    pub fn motion<S>(
        &self,
        request: &Request,
        plan: Plan,
        state: impl Fn(Moment) -> S,
    ) -> Result<Motion<S>> {
        let (moments, done) = self.followed(&plan, request)?;
        let (times, mut states) = (request.times(), moments.iter().copied().map(state));
        let mut ledger = OpenLedger::of(request, plan, done, &mut states);
        let &Laws { kappa, load, .. } = self.laws;
        let (mass, drive) = (self.body.mass, load.push + load.twist);
        let scale = |size: &dyn Fn(&Moment) -> f64| {
            let all = moments.iter().chain([&self.start]).map(size);
            mass * all.fold(0.0, f64::max)
        };
        let driven = load != Load::weight(load.reaction);
        let balance = |m: &Moment| mass * (m.energy(kappa) + m.heat - m.work);
        let kinetic = |m: &Moment| mass * m.energy(kappa);
        // About the table only a tug has a moment, and it is constant.
        let about =
            |row: usize, _: &S| mass * (moments[row].about_the_table(kappa) - times[row] * drive);
        if self.laws.resistance.is_none() {
            let name = match driven {
                true => "angular momentum about the table less the tug's",
                false => "angular momentum about the table",
            };
            let first = mass * self.start.about_the_table(kappa);
            let own = |m: &Moment| m.velocity.abs() + kappa * m.rim_speed.abs();
            let size = scale(&own).max(mass * self.speed());
            ledger.conserved(name, size, first, about)?;
        }
        let pull = |m: &Moment| (load.push * m.position).abs() + (load.twist * m.turned).abs();
        let size = scale(&|m| m.energy(kappa) + m.heat + m.work.abs() + pull(m));
        let name = "energy plus heat less work";
        let balanced = |row: usize, _: &S| balance(&moments[row]);
        ledger.conserved(name, size, balance(&self.start), balanced)?;
        if !driven && self.laws.sheet.is_none() {
            let size = scale(&|m| m.energy(kappa));
            let account = ("kinetic energy", Law::NonIncreasing, size);
            let falling = |row: usize, _: &S| kinetic(&moments[row]);
            ledger.keep(account, kinetic(&self.start), falling)?;
        }
        ledger.closed(request)
    }

    /// The moments at the requested times by the solver of the plan, their cost, and their error: lengths relative to the radius or the greatest length, speeds
    /// and energies relative to the greatest of the motion.
    fn followed(&self, plan: &Plan, request: &Request) -> Result<(Vec<Moment>, (Cost, f64))> {
        let times = request.times();
        if !matches!(plan.solver, Solver::Exact | Solver::Events) {
            let trace = to_accuracy(request, plan.solver, &|_| Ok(*self))?;
            let moments = trace.samples.iter().map(|(_, y)| Moment::of(y));
            return Ok((moments.collect(), (trace.cost, trace.error)));
        }
        let course = Course::under(self.laws, self.start, self.span)?;
        let moments: Vec<Moment> = times.iter().map(|&t| course.at(t)).collect();
        let cost = Cost {
            evaluations: 0,
            steps: course.stretches.len() as u64,
        };
        if plan.solver == Solver::Exact {
            return Ok((moments, (cost, OF_CLOSED_FORMS)));
        }
        let (sizes, mut off) = (self.sizes(&moments), 0.0);
        // The slip jumps where a ball passes the edge of its sheet; that against the table does not. How far the edge has gone since is not told.
        let told = |course: &Course, t: f64| {
            let mut y = course.state(t);
            (y[3], y[7]) = (y[1] - y[2], 0.0);
            y
        };
        // In one of the two twins the effects of the changes may cancel.
        for sense in [1.0, -1.0] {
            let (laws, start) = self.twin(sense);
            let twin = Course::under(&laws, start, self.span)?;
            let apart = |&t: &f64| apart(&told(&course, t), &told(&twin, t), &sizes);
            off = times.iter().map(apart).fold(off, greater);
        }
        let error = ROUNDING * (course.stretches.len() as f64 + off / MOVED);
        Ok((moments, (cost, error)))
    }

    /// A twin's laws and start: its reaction and the couple of the tug are a little greater, its push and its rim speed a little less; the speeds of the
    /// sheet are changed in turn, and its velocity and its inertia factor are greater for `sense` 1, less for −1. What starts without slip does so in a twin too.
    fn twin(&self, sense: f64) -> (Laws, Moment) {
        let (mut laws, mut start) = (self.laws.clone(), self.start);
        laws.sheet = laws.sheet.map(|sheet| sheet.moved(sense * MOVED));
        laws.load.reaction *= 1.0 + MOVED;
        laws.load.push *= 1.0 - 0.7 * MOVED;
        laws.load.twist *= 1.0 + 0.6 * MOVED;
        laws.kappa *= 1.0 + 0.5 * sense * MOVED;
        let faster = 0.8 * sense * MOVED * start.velocity;
        let slower = match start.slip {
            0.0 => faster,
            _ => -0.9 * MOVED * start.rim_speed,
        };
        start.velocity += faster;
        start.rim_speed += slower;
        start.slip += faster - slower;
        (laws, start)
    }

    /// The greatest size of each component over the moments, at least its natural scale.
    fn sizes(&self, moments: &[Moment]) -> State {
        let greatest = |kind: fn(&Moment) -> f64, least: f64| {
            let all = moments.iter().chain([&self.start]).map(kind);
            all.fold(least.max(f64::MIN_POSITIVE), greater)
        };
        let length = greatest(|m| m.position.abs().max(m.turned.abs()), self.body.radius);
        let all = |m: &Moment| m.velocity.abs().max(m.rim_speed.abs()).max(m.slip.abs());
        let speed = greatest(all, self.speed());
        let energy = greatest(|m| m.heat.max(m.work.abs()), 0.5 * speed * speed);
        [length, speed, speed, speed, length, energy, energy, length]
    }

    /// The greatest speed that the start, the sheet, or pull and twist alone could give: where the two balance, what remains is rounding.
    fn speed(&self) -> f64 {
        let Laws { load, sheet, .. } = self.laws;
        let points = sheet.iter().flat_map(|sheet| &sheet.speeds.points);
        let speeds = points.map(|point| point.1.abs());
        let own = self.start.velocity.abs().max(self.start.rim_speed.abs());
        let pulled = (load.push.abs() + load.twist.abs()) * self.span;
        speeds.fold(own.max(pulled), f64::max)
    }
}

impl Flow<8> for OnTable<'_> {
    type Phase = Stretch;

    fn start(&self) -> Result<(Stretch, State)> {
        let first = self.laws.first(self.start);
        Ok((first, first.state))
    }

    fn scales(&self) -> State {
        let (radius, reaction) = (self.body.radius, self.laws.load.reaction);
        let speed = self.speed().max((reaction * radius).sqrt());
        let energy = speed * speed;
        [radius, speed, speed, speed, radius, energy, energy, radius]
    }

    fn pace(&self) -> f64 {
        RADIANS / self.span.max(f64::MIN_POSITIVE)
    }

    fn rate(&self, stretch: Stretch, t: f64, y: &State) -> State {
        stretch.rates(t - stretch.start, y)
    }

    fn margin(&self, stretch: Stretch, _: f64, y: &State) -> Option<f64> {
        let margins = stretch.ends(y).map(|(margin, _)| margin);
        margins.reduce(f64::min)
    }

    /// At once if the body stands on the edge of the sheet and is about to pass it.
    fn lasts_until(&self, stretch: Stretch, _: f64) -> f64 {
        match stretch.next(f64::INFINITY) {
            Some((0.0, _)) => stretch.start,
            _ => stretch.leg_ends,
        }
    }

    fn next(&self, stretch: Stretch, ended: Stop, t: f64, y: &mut State) -> Result<Stretch> {
        let what = match ended {
            Stop::AtTheEvent => stretch.ends(y).min_by(|a, b| a.0.total_cmp(&b.0)),
            Stop::AtTheEnd => stretch.next(f64::INFINITY).filter(|next| next.0 == 0.0),
        };
        let what = what.map(|(_, what)| what);
        let (next, _) = self.laws.after(&stretch, t - stretch.start, y, what);
        *y = next.state;
        Ok(next)
    }
}
