//! Bodies on a table (tutorial 4.7): tippe top, egg, hoop with clay, chiral top, rattleback.
//!
//! | effect | values | if absent |
//! |---|---|---|
//! | gravity | [`Gravity`](super::effects::Gravity), downward | a free body, in closed form |
//! | friction | [`Viscous`](super::effects::Viscous), [`Regularised`](super::effects::Regularised), [`Coulomb`], [`NoSlip`](super::effects::NoSlip) | a table without friction |
//! | resistance | [`Resistance`](super::effects::Resistance) to rolling and pivoting, except in the impact of a landing | |
//!
//! The table only pushes. Where the reaction falls to zero the body takes off, flies in closed form, and lands with an inelastic impact. Where friction would press
//! the body into the table by more than any reaction lifts it (Painlevé 1895), the contact jams: an impulse slows its slip at once.
//! Coulomb's law is not smoothed: a body whose slip comes to rest rolls while the force needed for that lies within the cone of friction, and
//! slides again when it does not. The time of each change is located.
//!
//! ```
//! use spinning_bodies::scene::contact::TableTop;
//! use spinning_bodies::scene::effects::{Gravity, Viscous};
//! use spinning_bodies::scene::{Request, Scene};
//! use spinning_bodies::tippe_top::{Start, bodies};
//!
//! let start = Start::about_third_axis(0.1, 0.0, 155.0)?;
//! let scene = TableTop::new(bodies::tippe_top()?, start)
//!     .with(Gravity::new(9.82)?)?
//!     .with(Viscous::new(0.3)?)?;
//! let motion = scene.simulate(&Request::at([8.0])?.to_accuracy(1e-8)?)?;
//! let (_, state) = motion.rows[0];
//! assert!(state.tilt() > 3.1, "it stands on its head");
//! # Ok::<(), spinning_bodies::Error>(())
//! ```

use core::cell::Cell;

use nalgebra::{Quaternion, Vector3};

use super::engine::{DOUBT, tilted};
use super::prelude::*;
use crate::error::stopped;
use crate::integrators::Watched;
use crate::rolling::Coulomb;
use crate::tippe_top::equations::{Contact, NUMBERS, Numbers, Pose, Table, numbers};
use crate::tippe_top::flight::{Flight, TakeOff};
use crate::tippe_top::{ConvexBody, Friction, Start};

/// A body on a table, and the effects on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TableTop {
    table: Table,
    start: Start,
}

impl TableTop {
    /// The body, touching the table, without effects: a free body.
    ///
    /// ```
    /// use spinning_bodies::scene::{contact::TableTop, effects::Gravity};
    /// use spinning_bodies::tippe_top::{Start, bodies};
    /// let scene = TableTop::new(bodies::tippe_top()?, Start::about_third_axis(0.1, 0.0, 155.0)?);
    /// assert!(scene.with(Gravity::new(9.81)?).is_ok());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn new(body: ConvexBody, start: Start) -> Self {
        let table = Table::new(body, 0.0);
        Self { table, start }
    }

    /// Adds an effect; one of strength zero is absent.
    ///
    /// # Errors
    /// [`Error::Effect`] for one that has no meaning here; [`Error::NotPositive`] for gravity that does not press the body on the table.
    ///
    /// ```
    /// use spinning_bodies::scene::{contact::TableTop, effects::{Gravity, TurnLoss}};
    /// use spinning_bodies::tippe_top::{Start, bodies};
    /// let scene = TableTop::new(bodies::tippe_top()?, Start::about_third_axis(0.1, 0.0, 155.0)?);
    /// assert!(scene.with(Gravity::new(9.81)?).is_ok());
    /// // What has no meaning for a body on a table is refused by name.
    /// assert!(scene.with(TurnLoss::new(0.9)?).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn with(mut self, effect: impl Into<Effect>) -> Result<Self> {
        let table = &mut self.table;
        let some = |law: Friction| law.acts().then_some(law);
        let takes =
            "gravity, friction, regularised_friction, viscous_friction, no_slip, resistance";
        match effect.into() {
            Effect::Gravity(gravity) => table.gravity = positive("gravity", gravity.value())?,
            Effect::Coulomb(law) => table.friction = some(Friction::Coulomb(law)),
            Effect::Regularised(law) => table.friction = some(Friction::Regularised(law)),
            Effect::Viscous(law) => table.friction = some(Friction::Viscous(law)),
            Effect::NoSlip(_) => table.friction = Some(Friction::NoSlip),
            Effect::Resistance(law) => table.resistance = law.acts().then_some(law),
            other => return Err(other.refused("a body on a table", takes)),
        }
        Ok(self)
    }

    /// The phases of sliding, rolling and hopping, up to the last of the requested times.
    ///
    /// # Errors
    /// Those of [`simulate`](Scene::simulate).
    ///
    /// ```
    /// use spinning_bodies::scene::{Request, contact::{Support, TableTop}, effects::{Gravity, Viscous}};
    /// use spinning_bodies::tippe_top::{Start, bodies};
    /// let scene = TableTop::new(bodies::tippe_top()?, Start::about_third_axis(0.1, 0.0, 155.0)?);
    /// let scene = scene.with(Gravity::new(9.82)?)?.with(Viscous::new(0.3)?)?;
    /// assert_eq!(scene.phases(&Request::at([0.1])?.to_accuracy(1e-8)?)?[0].support, Support::Sliding);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn phases(&self, request: &Request) -> Result<Vec<Phase>> {
        let trace = self.trace(request, &self.plan(request)?)?;
        let phases = trace.phases.iter().map(|&(start, mode, _)| Phase {
            start,
            support: mode.support(),
        });
        let mut phases: Vec<Phase> = phases.collect();
        phases.dedup_by_key(|phase| phase.support);
        Ok(phases)
    }

    fn trace(&self, request: &Request, plan: &Plan) -> Result<Trace<Mode, NUMBERS>> {
        let flow = &|tolerance| self.on_the_table(tolerance);
        if plan.solver != Solver::Exact {
            return to_accuracy(request, plan.solver, flow);
        }
        let flow = flow(request.accuracy)?;
        let takeoff = flow.takeoff(0.0, &flow.start);
        let flight = Flight::from(&flow.table, &flow.start, takeoff)?;
        solved((&flow, plan, request), 1, &|t| flight.at(t))
    }

    fn on_the_table(&self, tolerance: f64) -> Result<OnTheTable> {
        let start = numbers(&self.start);
        each_finite("the start of a body on a table", start)?;
        let table = self.table;
        let falling = (table.gravity / table.body.surface.size).sqrt();
        let turning = self.start.omega.norm() + falling;
        Ok(OnTheTable {
            table,
            start,
            turning: turning.max(f64::MIN_POSITIVE),
            tolerance,
        })
    }
}

/// How the body is supported.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Support {
    /// On the table, slipping.
    Sliding,
    /// On the table, without slip.
    Rolling,
    /// Off the table.
    Airborne,
}

/// A phase of the motion with one kind of support.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phase {
    /// The time at which it begins, s.
    pub start: f64,
    /// The support.
    pub support: Support,
}

/// A body on a table at one time. The third axis of space points up, the table is the plane z = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct State {
    /// Attitude: turns the body's axes into those of space.
    pub attitude: Attitude,
    /// Angular velocity, rad/s.
    pub omega: BodyVector,
    /// Position of the centre of mass, m; at the start above the origin.
    pub position: SpaceVector,
    /// Velocity of the centre of mass, m/s.
    pub velocity: SpaceVector,
    /// Whether it slides, rolls or is in the air.
    pub support: Support,
    /// Velocity of the point in contact, m/s; zero in the air.
    pub slip: SpaceVector,
    /// Normal reaction of the table, N; never negative.
    pub reaction: f64,
    /// Size of the horizontal force of the table, N.
    pub friction: f64,
    /// Kinetic energy and M g times the height of C, J.
    pub energy: f64,
    /// Energy dissipated by friction, resistance and landings since the start, J.
    pub dissipated: f64,
    /// −⟨L, CO⟩ with O the lowest point, J s m: Jellett's integral where there is one.
    pub jellett: f64,
    /// Vertical component of the angular momentum about C, J s.
    pub vertical_angular_momentum: f64,
}

impl State {
    /// The upward vertical in the body's axes.
    ///
    /// ```
    /// use spinning_bodies::scene::{Request, Scene, contact::TableTop};
    /// use spinning_bodies::tippe_top::{Start, bodies};
    /// let scene = TableTop::new(bodies::tippe_top()?, Start::about_third_axis(0.1, 0.0, 155.0)?);
    /// let state = scene.simulate(&Request::at([0.0])?)?.rows[0].1;
    /// assert!((state.up().z() - 0.1_f64.cos()).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn up(&self) -> BodyVector {
        self.attitude.to_body(SpaceVector::new(0.0, 0.0, 1.0))
    }

    /// Angle between the body's third axis and the vertical, rad, 0…π; accurate at both ends.
    ///
    /// ```
    /// use spinning_bodies::scene::{Request, Scene, contact::TableTop};
    /// use spinning_bodies::tippe_top::{Start, bodies};
    /// let scene = TableTop::new(bodies::tippe_top()?, Start::about_third_axis(0.1, 0.0, 155.0)?);
    /// let state = scene.simulate(&Request::at([0.0])?)?.rows[0].1;
    /// assert!((state.tilt() - 0.1).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn tilt(&self) -> f64 {
        let up = self.up();
        up.x().hypot(up.y()).atan2(up.z())
    }

    /// Angular velocity about the vertical, rad/s.
    ///
    /// ```
    /// use spinning_bodies::scene::{Request, Scene, contact::TableTop};
    /// use spinning_bodies::tippe_top::{Start, bodies};
    /// let scene = TableTop::new(bodies::tippe_top()?, Start::about_third_axis(0.1, 0.0, 155.0)?);
    /// let state = scene.simulate(&Request::at([0.0])?)?.rows[0].1;
    /// assert!((state.spin() - 155.0 * 0.1_f64.cos()).abs() < 1e-12);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn spin(&self) -> f64 {
        self.omega.dot(&self.up())
    }
}

/// The time (s) at which `quantity` first rises through `level`, by linear interpolation between rows in ascending order of time; `None` if it does not.
///
/// ```
/// use spinning_bodies::scene::{Request, Scene, contact::{TableTop, passage}, effects::{Gravity, Viscous}};
/// use spinning_bodies::tippe_top::{Start, bodies};
/// let scene = TableTop::new(bodies::tippe_top()?, Start::about_third_axis(0.1, 0.0, 155.0)?);
/// let scene = scene.with(Gravity::new(9.82)?)?.with(Viscous::new(0.3)?)?;
/// let times: Vec<f64> = (0..81).map(|k| 0.1 * f64::from(k)).collect();
/// let rows = scene.simulate(&Request::at(times)?.to_accuracy(1e-8)?)?.rows;
/// // When C is above the centre: it turns over within eight seconds.
/// assert!(passage(&rows, |state| state.tilt(), 1.6).is_some());
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn passage(rows: &[(f64, State)], quantity: impl Fn(&State) -> f64, level: f64) -> Option<f64> {
    rows.array_windows().find_map(|[(t0, a), (t1, b)]| {
        let (low, high) = (quantity(a), quantity(b));
        (low < level && high >= level).then(|| t0 + (t1 - t0) * (level - low) / (high - low))
    })
}

impl Tabulated for State {
    fn columns() -> Columns<Self> {
        Columns::default()
            .attitude(|state: &Self| state.attitude)
            .omega(|state| state.omega)
            .vector(["x", "y", "z"], ["m", "centre of mass"], |s| s.position)
            .vector(["vx", "vy", "vz"], ["m/s", "its velocity"], |s| s.velocity)
            .and(columns! { |state: &Self|
                "slip", "m/s", "speed of the point in contact" => state.slip.norm();
                "reaction", "N", "push of the table, upwards" => state.reaction;
                "energy", "J", "kinetic energy, and of the weight above the table" => state.energy;
                "dissipated", "J", "what contact has taken so far" => state.dissipated;
            })
    }
}

/// The equations that hold.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Mode {
    Sliding,
    /// Sliding near the end of it: by Coulomb's law slower than [`NEAR`], or with friction that all but jams the contact, [`CLOSE`].
    Stopping,
    /// Sliding by Coulomb's law, just after rest.
    Leaving,
    Rolling,
    Airborne(TakeOff),
}

impl Mode {
    const fn support(&self) -> Support {
        match self {
            Self::Sliding | Self::Stopping | Self::Leaving => Support::Sliding,
            Self::Rolling => Support::Rolling,
            Self::Airborne(_) => Support::Airborne,
        }
    }
}

/// Slip, in units of μg/ω with ω the rate of the motion, below which a body is near rest: it would stop within this fraction of a radian.
const NEAR: f64 = 0.05;
/// The [lift](Contact::lift) below which friction all but jams the contact, if the reaction exceeds [`HEAVY`], in units of mass times acceleration of the motion; and
/// the lift that counts as none, in units of what presses the body on the table.
const CLOSE: f64 = 0.1;
const HEAVY: f64 = 10.0;
const JAMMED: f64 = 1e-9;
/// The most evaluations of the impact by which a jam is resolved: a tenth of a second.
const MOST_OF_A_JAM: u64 = 1_000_000;
/// Slip in the same units, for a tolerance of 1, below which a body leaving its rest slips in the direction that friction determines; the error of that grows as slip^(5/2).
const LEFT: f64 = 0.4;
const POWER: f64 = 0.4;
/// Slip, in units of the tolerance times the velocity of the motion, that counts as none; and the least and the greatest tolerance used for it: a slip
/// of 30 ε of the velocity is rounding.
const STILL: f64 = 0.1;
const FINEST: f64 = 1e-13;
const COARSEST: f64 = 1e-6;
/// Length of the run near rest, in units of ∫μg dt/|slip|: by its end the slip has its final direction, unless it has vanished before.
const SETTLED: f64 = 60.0;
/// Reaction, in units of the weight, below which a body takes off at an event. Take-off is located to rounding; the end of a slip, also an
/// event, says nothing about the reaction.
const LIFTED: f64 = 1e-6;
/// How far below zero rounding may take a slip that begins, in units of the slip at which [`Mode::Leaving`] ends.
const ROUNDING: f64 = 1e-6;

/// A table, the start of a body on it, and the tolerance of the run.
#[derive(Debug, Clone, Copy)]
struct OnTheTable {
    table: Table,
    start: Numbers,
    /// Fastest rate, rad/s.
    turning: f64,
    tolerance: f64,
}

impl OnTheTable {
    fn coulomb(&self) -> Option<Coulomb> {
        match self.table.friction {
            Some(Friction::Coulomb(law)) => Some(law),
            _ => None,
        }
    }

    /// Whether nothing presses the body on the table.
    fn is_free(&self) -> bool {
        self.table.gravity == 0.0
    }

    fn weight(&self) -> f64 {
        self.table.body.mass() * self.table.gravity
    }

    fn velocity_scale(&self) -> f64 {
        self.table.body.surface.size * self.turning
    }

    /// μg/ω: a slip of this speed stops within a radian.
    fn stopping_speed(&self, law: Coulomb) -> f64 {
        law.grip * self.table.gravity / self.turning
    }

    /// The slip at which the mode of leaving rest ends.
    fn left(&self, law: Coulomb) -> f64 {
        let tolerance = self.tolerance.max(FINEST);
        self.stopping_speed(law) * (LEFT * tolerance.powf(POWER)).min(0.5 * NEAR)
    }

    /// The slip that counts as none.
    fn still(&self) -> f64 {
        let speed = self.velocity_scale() + self.start[7].hypot(self.start[8]);
        STILL * self.tolerance.clamp(FINEST, COARSEST) * speed
    }

    fn contact(&self, mode: &Mode, pose: &Pose) -> Contact {
        let table = &self.table;
        match (mode, self.coulomb()) {
            (Mode::Airborne(_), _) => Contact::none(&table.body, &pose.omega),
            (Mode::Rolling, _) => table.rolls(pose),
            (Mode::Leaving, Some(law)) => table.leaving(pose, law.kinetic),
            _ => table.slides(pose),
        }
    }

    /// The states after a landing from this one, for C falling and for C rising.
    fn landings(&self, takeoff: &TakeOff, y: &Numbers) -> impl Iterator<Item = Numbers> {
        let fallen = takeoff.height - self.table.body.height(&Pose::of(y)).0;
        let climb = (takeoff.climb.powi(2) + 2.0 * self.table.gravity * fallen).sqrt();
        let climbs = [climb, -climb].into_iter();
        climbs.filter_map(|climb| self.table.landed(0.0, y, climb, &|_| Ok(())).ok())
    }

    fn takeoff(&self, time: f64, y: &Numbers) -> TakeOff {
        let (height, climb) = self.table.body.height(&Pose::of(y));
        TakeOff {
            time,
            height,
            climb,
        }
    }

    /// How a body in contact with the table goes on; without slip, near rest, or where friction jams the contact, the state may change.
    fn settled(&self, t: f64, y: &mut Numbers) -> Result<Mode> {
        let mode = self.supported(y);
        self.kept_down(t, mode, y)
    }

    /// This mode, unless friction jams the contact, or nothing presses the body on the table.
    fn kept_down(&self, t: f64, mut mode: Mode, y: &mut Numbers) -> Result<Mode> {
        if self.jams(&mode, y, JAMMED) {
            let taken = Cell::new(0);
            let slowly =
                "friction jams the contact, and slows its slip in too many steps; let it be weaker";
            let spent = |evaluations| {
                taken.set(taken.get() + evaluations);
                match taken.get() > MOST_OF_A_JAM {
                    true => stopped(slowly, t),
                    false => Ok(()),
                }
            };
            *y = self.table.jammed(t, y, &spent)?;
            mode = self.supported(y);
            // The impulse ends with the jam, so that hardly any lift may be left: then the slip is followed on.
            if self.jams(&mode, y, 0.0) {
                let reason = "friction and resistance press the body into the table by more than any reaction lifts it; let them be weaker";
                return stopped(reason, t);
            }
        }
        if self.pressing(&mode, &self.contact(&mode, &Pose::of(y))) > 0.0 {
            return Ok(mode);
        }
        self.released(t, y)
    }

    /// What keeps the body on the table, in units of its weight: the reaction, and while the body slides the reaction without friction and resistance.
    ///
    /// Both of them vanish together, but at a contact that is about to jam the reaction becomes infinite; and beyond, friction may hold down a body that would take
    /// off, which no contact with the least elasticity bears.
    fn pressing(&self, mode: &Mode, contact: &Contact) -> f64 {
        let rolls = *mode == Mode::Rolling;
        contact.reaction * if rolls { 1.0 } else { contact.lift } / self.weight()
    }

    /// Whether friction leaves no reaction that keeps a body pressed on the table out of it, or hardly any: a lift up to `none`, in units of what presses.
    fn jams(&self, mode: &Mode, y: &Numbers, none: f64) -> bool {
        let contact = self.contact(mode, &Pose::of(y));
        let pressing = self.pressing(mode, &contact);
        *mode != Mode::Rolling && pressing > 0.0 && contact.lift <= none * pressing
    }

    /// How far a sliding body is from the end of it, less than 1 near it.
    fn distance_to_rest(&self, contact: &Contact) -> f64 {
        let slow = |law| contact.slip.norm() / (NEAR * self.stopping_speed(law));
        let slow = self.coulomb().map_or(f64::INFINITY, slow);
        let heavy = HEAVY * self.table.body.mass() * self.velocity_scale() * self.turning;
        slow.min((contact.lift / CLOSE).max(heavy / contact.reaction.abs()))
    }

    /// The equations of a body in contact; without slip or near rest the state may change.
    fn supported(&self, y: &mut Numbers) -> Mode {
        if self.table.friction == Some(Friction::NoSlip) {
            *y = self.table.body.rolled(y);
            return Mode::Rolling;
        }
        let contact = self.table.slides(&Pose::of(y));
        match self.coulomb() {
            Some(law) if contact.slip.norm() <= 2.0 * self.still() => self.stopped(law, y),
            _ if self.distance_to_rest(&contact) <= 1.0 => Mode::Stopping,
            _ => Mode::Sliding,
        }
    }

    /// Removes the slip; then rolling if the cone allows it, otherwise sliding.
    fn stopped(&self, law: Coulomb, y: &mut Numbers) -> Mode {
        *y = self.table.body.rolled(&self.table.held(y));
        // At the rim of the cone rolling would have no event: the margin must fall through zero.
        match self.holds(law, y) {
            true => Mode::Rolling,
            false => Mode::Leaving,
        }
    }

    /// Whether the force that rolling needs lies within the cone.
    fn holds(&self, law: Coulomb, y: &Numbers) -> bool {
        let contact = self.table.rolls(&Pose::of(y));
        contact.reaction > 0.0 && contact.traction.norm() < law.grip
    }

    /// Lets the body take off, if it can: under the constraint of rolling, the horizontal force may be what holds it up.
    fn released(&self, time: f64, y: &Numbers) -> Result<Mode> {
        let contact = self.table.rolls(&Pose::of(y));
        if self.table.friction == Some(Friction::NoSlip) && contact.reaction * contact.lift >= 0.0 {
            let reason = "pure rolling takes a level force where nothing presses the body to the table; let it slide by Coulomb's law";
            return stopped(reason, time);
        }
        Ok(Mode::Airborne(self.takeoff(time, y)))
    }

    fn state(&self, t: f64, mode: &Mode, y: &Numbers) -> State {
        let body = &self.table.body;
        let y = &match mode {
            Mode::Rolling => body.rolled(y),
            _ => *y,
        };
        let pose = Pose::of(y);
        let (height, climb) = match mode {
            Mode::Airborne(takeoff) => takeoff.at(t, self.table.gravity),
            _ => body.height(&pose),
        };
        let contact = self.contact(mode, &pose);
        let reaction = contact.reaction.max(0.0);
        let omega = BodyVector::from_components(pose.omega);
        let up = BodyVector::from_components(pose.up);
        let velocity = Vector3::new(y[7], y[8], climb);
        let potential = self.weight() * height;
        State {
            attitude: pose.attitude(),
            omega,
            position: SpaceVector::new(y[9], y[10], height),
            velocity: SpaceVector::from_components(velocity),
            support: mode.support(),
            slip: SpaceVector::from_components(pose.turn * contact.slip),
            reaction,
            friction: reaction * contact.traction.norm(),
            energy: body.kinetic_energy(&pose.omega, &velocity) + potential,
            dissipated: y[11],
            jellett: body.jellett(up, omega),
            vertical_angular_momentum: body.inertia().angular_momentum(omega).dot(&up),
        }
    }
}

impl Flow<NUMBERS> for OnTheTable {
    type Phase = Mode;
    const KEPT: Kept = Kept::UnitQuaternion(0);

    fn start(&self) -> Result<(Mode, Numbers)> {
        let mut y = self.start;
        let mode = match self.is_free() {
            true => Mode::Airborne(self.takeoff(0.0, &y)),
            false => self.settled(0.0, &mut y)?,
        };
        Ok((mode, y))
    }

    fn scales(&self) -> Numbers {
        let (body, v, w) = (&self.table.body, self.velocity_scale(), self.turning);
        let (size, energy) = (body.surface.size, body.mass() * v * v);
        [1.0, 1.0, 1.0, 1.0, w, w, w, v, v, size, size, energy]
    }

    fn doubt(&self, _: f64) -> Numbers {
        let [w, x, y, z, a, b, c, ..] = self.start;
        let q = tilted(Quaternion::new(w, x, y, z));
        let rate = Vector3::new(a, b, c).norm();
        let [a, b, c] = [0, 1, 2].map(|n| DOUBT[n] * rate);
        [q.w, q.i, q.j, q.k, a, b, c, 0.0, 0.0, 0.0, 0.0, 0.0]
    }

    fn pace(&self) -> f64 {
        self.turning
    }

    fn rate(&self, mode: Mode, _: f64, y: &Numbers) -> Numbers {
        let pose = Pose::of(y);
        let y = &match mode {
            Mode::Rolling => self.table.body.rolling(y, &pose),
            _ => *y,
        };
        self.table.rates(y, &pose, &self.contact(&mode, &pose))
    }

    /// The least margin: what presses the body on the table; the distance of a slip from rest, or from the end of being near rest; the distance of rolling from the
    /// rim of the cone.
    fn margin(&self, mode: Mode, _: f64, y: &Numbers) -> Option<f64> {
        if self.is_free() {
            return None;
        }
        let contact = self.contact(&mode, &Pose::of(y));
        let pressed = self.pressing(&mode, &contact);
        let slip = contact.slip.norm();
        let near = self.distance_to_rest(&contact);
        Some(match (mode, self.coulomb()) {
            (Mode::Rolling, None) => pressed,
            (Mode::Rolling, Some(law)) => {
                pressed.min(pressed * (law.grip - contact.traction.norm()))
            }
            (Mode::Leaving, Some(law)) => {
                let left = self.left(law);
                let along = slip.copysign(-contact.slip.dot(&contact.traction));
                let ends = pressed.min(1.0 - along / left).min(along / left + ROUNDING);
                ends.min(contact.lift)
            }
            (Mode::Stopping, law) => {
                let moves = law.map_or(f64::INFINITY, |_| (slip / self.still()).ln());
                pressed.min(moves).min(contact.lift).min(2.0 - near)
            }
            _ => pressed.min(near - 1.0),
        })
    }

    fn next(&self, mode: Mode, _: Stop, t: f64, y: &mut Numbers) -> Result<Mode> {
        if matches!(mode, Mode::Airborne(_)) {
            return self.settled(t, y);
        }
        let contact = self.contact(&mode, &Pose::of(y));
        if self.pressing(&mode, &contact) <= LIFTED * contact.lift.abs() {
            return self.released(t, y);
        }
        let slip = contact.slip.norm();
        let mode = match (mode, self.coulomb()) {
            (Mode::Rolling, None) => return self.released(t, y),
            (Mode::Rolling, _) => {
                *y = self.table.body.rolled(y);
                Mode::Leaving
            }
            (Mode::Leaving, Some(law)) if slip < 0.5 * self.left(law) => self.stopped(law, y),
            (Mode::Stopping, Some(law)) if slip <= 2.0 * self.still() => self.stopped(law, y),
            (Mode::Stopping, Some(law)) if slip < 0.5 * self.left(law) => {
                // The slip has passed its rest, or has come as close to it as the steps resolve. One that still goes another way than it would leave has yet to stop.
                let leaving = self.contact(&Mode::Leaving, &Pose::of(y));
                match self.holds(law, y) {
                    true => self.stopped(law, y),
                    false if leaving.slip.dot(&leaving.traction) > 0.0 => Mode::Stopping,
                    false => Mode::Leaving,
                }
            }
            (Mode::Stopping, _) if self.distance_to_rest(&contact) > 1.0 => Mode::Sliding,
            _ => Mode::Stopping,
        };
        self.kept_down(t, mode, y)
    }

    fn known(&self, mode: Mode, ahead: &Ahead<'_, NUMBERS>) -> Option<Passed<NUMBERS>> {
        match mode {
            Mode::Airborne(takeoff) if !self.is_free() => Some(self.flown(takeoff, ahead)),
            Mode::Stopping => Some(self.slowed(ahead)),
            _ => None,
        }
    }

    /// If one of the two has just landed and the other is about to, the states after that landing are compared.
    fn distance(&self, (p, a): &(Mode, Numbers), (q, b): &(Mode, Numbers)) -> f64 {
        let scales = self.scales();
        let apart = |a: &Numbers, b: &Numbers| {
            let angle = Pose::of(a).attitude().angle_to(&Pose::of(b).attitude());
            let relative = |n: usize| (a[n] - b[n]).abs() / scales[n];
            (4..9).map(relative).fold(angle, greater)
        };
        let (takeoff, flying, other) = match (p, q) {
            (Mode::Airborne(_), Mode::Airborne(_)) => return apart(a, b),
            (Mode::Airborne(takeoff), _) => (takeoff, a, b),
            (_, Mode::Airborne(takeoff)) => (takeoff, b, a),
            _ => return apart(a, b),
        };
        let landed = self.landings(takeoff, flying);
        landed.fold(apart(a, b), |least, y| least.min(apart(&y, other)))
    }
}

impl OnTheTable {
    /// The flight, up to the end of its landing impact, if there is one.
    fn flown(&self, takeoff: TakeOff, ahead: &Ahead<'_, NUMBERS>) -> Passed<NUMBERS> {
        let flight = Flight::from(&self.table, ahead.start.1, takeoff)?;
        let landing = flight.landing(ahead.end, |time| ahead.budget.spend(1, time))?;
        let mut passage = ahead.in_closed_form(landing, &|t| flight.at(t))?;
        if let Some(time) = landing {
            let (_, climb) = takeoff.at(time, self.table.gravity);
            let spent = |evaluations| ahead.budget.spend(evaluations, time);
            passage.end = self.table.landed(time, &passage.end, climb, &spent)?;
        }
        Ok(passage)
    }

    /// The motion near rest, where friction turns with the slip, ever faster, or near a jam, where the reaction becomes infinite. The variable is not the time but
    /// ∫μg dt/(|slip| lift), in which the slip decays exponentially, its direction turns at a finite rate, and nothing is infinite.
    fn slowed(&self, ahead: &Ahead<'_, NUMBERS>) -> Passed<NUMBERS> {
        let (now, y) = ahead.start;
        let parted = |z: &[f64; NUMBERS + 1]| -> Numbers { core::array::from_fn(|n| z[n]) };
        // The rates of state and time.
        let rate = |_: f64, z: &[f64; NUMBERS + 1]| {
            ahead.budget.count(1);
            let y = parted(z);
            let pose = Pose::of(&y);
            let contact = self.table.slides(&pose);
            let slow = |law| contact.slip.norm() / self.stopping_speed(law);
            let pace = contact.lift * self.coulomb().map_or(1.0, slow) / self.turning;
            let rates = self.table.rates(&y, &pose, &contact);
            core::array::from_fn(|n| pace * rates.get(n).unwrap_or(&1.0))
        };
        let slowing = Watched(rate, |_| ahead.budget.reached(now), 0.0);
        let [mut scales, mut z] = [[1.0 / self.turning; NUMBERS + 1], [0.0; NUMBERS + 1]];
        scales[..NUMBERS].copy_from_slice(&self.scales());
        z[..NUMBERS].copy_from_slice(y);
        let mut passage = Passage {
            states: Vec::new(),
            time: now,
            end: *y,
            stopped: Stop::AtTheEnd,
            cost: Cost::default(),
        };
        for &time in ahead.times.iter().chain([&ahead.end]) {
            let left = |z: &[f64; NUMBERS + 1]| self.turning * (time - now - z[NUMBERS]);
            let lasts = |z: &[f64; NUMBERS + 1]| self.margin(Mode::Stopping, now, &parted(z));
            let whole = left(&z);
            if whole > 0.0 && lasts(&z) > Some(0.0) {
                let leg = Leg {
                    system: &slowing as &dyn System<{ NUMBERS + 1 }>,
                    kept: Self::KEPT,
                    start: (0.0, &z),
                    scales: &scales,
                    times: &[],
                    end: SETTLED,
                };
                let event = |_: f64, z: &[f64; NUMBERS + 1]| lasts(z).unwrap_or(0.0).min(left(z));
                // Not looser, or the errors of steps would pass for slip; not finer, or the rounding of so small a slip would dominate.
                let effort = Effort::Tolerance(self.tolerance.clamp(FINEST, COARSEST));
                let part = leg.follow(Some(&event), effort)?;
                passage.cost += part.cost;
                z = part.end;
            }
            passage.end = parted(&z);
            // The end is located to rounding, also that of the time.
            if left(&z) > 1e-9 * whole + 4.0 * f64::EPSILON * self.turning * time {
                passage.time = now + z[NUMBERS];
                passage.stopped = Stop::AtTheEvent;
                return Ok(passage);
            }
            passage.time = time;
            if passage.states.len() < ahead.times.len() {
                passage.states.push(passage.end);
            }
        }
        Ok(passage)
    }
}

impl Scene for TableTop {
    type State = State;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let plan = match (self.table.gravity, self.table.friction) {
            (0.0, _) => Plan::exact("no gravity, so no contact: closed form"),
            (_, Some(Friction::NoSlip)) => Plan::stepped("pure rolling: take-off is an event"),
            (_, Some(Friction::Coulomb(_))) => {
                Plan::stepped("Coulomb friction: slip, roll and take-off are events")
            }
            (_, Some(_)) => Plan::stepped("sliding friction: take-off is an event"),
            (_, None) => Plan::stepped("a table without friction: take-off is an event"),
        };
        if plan.solver != Solver::Exact {
            request.forward()?;
        }
        let solvers =
            "the solver of a body on a table is `exact`, without gravity, or one that steps";
        planned(request, plan, solvers)
    }

    fn simulate(&self, request: &Request) -> Result<Motion<State>> {
        let plan = self.plan(request)?;
        let trace = self.trace(request, &plan)?;
        let flow = self.on_the_table(request.accuracy)?;
        let (mode, y) = flow.start()?;
        let start = flow.state(0.0, &mode, &y);
        // Angular momenta are compared with those at this rate.
        let Table { body, .. } = &self.table;
        let spin = body.inertia().matrix().amax() * flow.turning;
        let first = start.energy;
        let mut ledger = trace.told(request, plan, |t, mode, y| flow.state(t, mode, y));
        let falling = ("energy", Law::NonIncreasing, first);
        ledger.keep(falling, first, |_, s| s.energy)?;
        let both = "energy and what contact has taken";
        // A contact that jams at once has taken its part already.
        let whole = first + start.dissipated;
        ledger.conserved(both, first, whole, |_, s| s.energy + s.dissipated)?;
        let no_couple = self.table.resistance.is_none();
        if self.table.gravity > 0.0 && no_couple && body.has_jellett_integral() {
            let scale = spin * body.surface.size;
            ledger.conserved("Jellett's integral", scale, start.jellett, |_, s| s.jellett)?;
        }
        if self.table.friction.is_none() && no_couple {
            let vertical = |s: &State| s.vertical_angular_momentum;
            let name = "vertical angular momentum";
            ledger.conserved(name, spin, vertical(&start), |_, s| vertical(s))?;
        }
        ledger.closed(request)
    }

    fn further(&self) -> Columns<State> {
        let Table { body, gravity, .. } = self.table;
        let l = move |state: &State| body.inertia().angular_momentum(state.omega);
        let momentum = move |state: &State| state.attitude.to_space(l(state));
        let weight = body.mass() * gravity;
        Columns::default()
            .angles(|state: &State| state.attitude)
            .and(columns! { |state: &State|
                "omega", "rad/s", "size of the angular velocity" => state.omega.norm();
                "vertical_spin", "rad/s", "angular velocity about the vertical" => state.spin();
            })
            .angular_momentum(|state| state.attitude, momentum)
            .and(columns! { |state: &State|
                "friction", "N", "size of the level force of the table" => state.friction;
                "translation", "J", "kinetic energy of the centre of mass" => 0.5 * body.mass() * state.velocity.dot(&state.velocity);
                "rotation", "J", "kinetic energy about the centre of mass" => 0.5 * l(state).dot(&state.omega);
                "potential", "J", "energy of the weight above the table" => weight * state.position.z();
                "jellett", "kg m³/s", "Jellett's integral" => state.jellett;
                "support", "1", "0 sliding, 1 rolling, 2 in the air" => f64::from(state.support as u8);
            })
    }
}
