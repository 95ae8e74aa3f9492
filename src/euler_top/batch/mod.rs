//! Many states at once: one body at many times, or many bodies at one (tutorial 6.6, 6.8).
//!
//! The closed form without a branch, over rows of lanes that the compiler lays out side by side: a lane is a time or a body. Which
//! closed form it is, and up to which time, is decided once a body; beyond that time each state is [`EulerTop::at`]'s. Bodies from
//! scratch are prepared in the same way: sorted by kind, then eight at a time.

mod beginning;
mod lanes;
mod prepared;
mod release;

use std::sync::OnceLock;

use nalgebra::Quaternion;

use beginning::Beginnings;
use lanes::{Circular, Hyperbolic, Motion, Rows, Steady, Work};
use prepared::{Kind, Prepared};
pub use release::Release;
use release::{Sorted, Way};

use super::motion::{EulerTop, State};
use crate::error::{Error, Result};
use crate::frame::{Attitude, BodyVector};

/// So many times are worked on side by side.
const TIMES: usize = 32;

/// So many bodies.
const BODIES: usize = 8;

/// Which row is which of the body's own axes.
type Axes = [usize; 3];

/// Which row is which of the body's own axes, and the other way round.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Rowing([usize; 3]);

impl Rowing {
    /// From the body's own axes of the rows.
    fn new(axis: Axes) -> Self {
        let mut own = [0; 3];
        for k in 0..3 {
            own[axis[k]] = k;
        }
        Self(own)
    }
}

impl<const W: usize> Rows<W> {
    /// Hands out the states of the lanes one by one, along axes that are the same for all.
    #[inline(always)]
    fn each(&self, Rowing(own): Rowing, mut give: impl FnMut(usize, State)) {
        let [l1, l2, l3] = own.map(|k| &self.l[k]);
        let [o1, o2, o3] = own.map(|k| &self.omega[k]);
        let [w, x, y, z] = &self.attitude;
        for i in 0..W {
            let state = State {
                omega: BodyVector::new(o1[i], o2[i], o3[i]),
                angular_momentum: BodyVector::new(l1[i], l2[i], l3[i]),
                attitude: Attitude::from_unit(Quaternion::new(w[i], x[i], y[i], z[i])),
            };
            give(i, state);
        }
    }

    /// The state of one lane.
    #[inline(always)]
    fn one(&self, i: usize, Rowing([a, b, c]): Rowing) -> State {
        let (l, omega) = (&self.l, &self.omega);
        let [w, x, y, z] = &self.attitude;
        State {
            omega: BodyVector::new(omega[a][i], omega[b][i], omega[c][i]),
            angular_momentum: BodyVector::new(l[a][i], l[b][i], l[c][i]),
            attitude: Attitude::from_unit(Quaternion::new(w[i], x[i], y[i], z[i])),
        }
    }
}

fn same_length(wanted: usize, found: usize) -> Result<()> {
    if wanted == found {
        return Ok(());
    }
    Err(Error::Condition {
        condition: "there must be one place for each state",
        value: found as f64,
    })
}

impl EulerTop {
    /// Ω, L and attitude at each of these times (s), in any order, into a slice of the same length (6.6, 6.8).
    ///
    /// Domain: that of [`at`](Self::at). Up to some 8·10⁶ turns from the start, and unless the amplitudes or the rates are in ratios of
    /// 10⁶⁰ and more, 32 states are formed side by side; what lies beyond is handed to [`at`](Self::at), one by one.
    ///
    /// Error: the states are those of [`at`](Self::at) up to rounding; against the same 998 references of 32 digits the attitude is off by
    /// at most 7e-16 rad (1.5e-15, as [`at`](Self::at) is, for bodies one unit in the last place from a sphere), Ω and L by 5e-16.
    ///
    /// Cost: beside [`at`](Self::at) in the same run (`cargo bench -p bench --bench ensembles`), with the instructions every processor of the kind
    /// has: 0.19 of the time a state where m ≤ 1/2, 0.24 where m > 1/2, 0.38 where Ω stays and [`at`](Self::at) has little to do. The constants
    /// of a batch cost as much as one state. States are independent of each other: parts of the slices may be filled by different threads.
    ///
    /// # Errors
    /// [`Error::Condition`] if the slices differ in length; otherwise that of the first time that [`at`](Self::at) refuses, the states being partly
    /// written.
    ///
    /// ```
    /// use spinning_bodies::euler_top::{EulerTop, State};
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// let start = BodyVector::new(1.8, 0.4, -0.9);
    /// let top = EulerTop::new([0.6, 0.8, 1.0], start, Attitude::identity())?;
    /// let times: Vec<f64> = (0..100).map(|k| 0.1 * f64::from(k)).collect();
    /// let mut states = [State::default(); 100];
    /// top.states_at(&times, &mut states)?;
    /// assert!(states[70].attitude.angle_to(&top.at(times[70])?.attitude) < 2e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn states_at(&self, times: &[f64], states: &mut [State]) -> Result<()> {
        same_length(times.len(), states.len())?;
        let Some(Prepared { kind, axis, reach }) = Prepared::new(self) else {
            for (t, state) in times.iter().zip(states) {
                *state = self.at(*t)?;
            }
            return Ok(());
        };
        match &kind {
            Kind::Steady(motion) => self.fill(motion, axis, reach, times, states),
            Kind::Circular(motion) => self.fill(motion, axis, reach, times, states),
            Kind::Hyperbolic(motion) => self.fill(motion, axis, reach, times, states),
        }
    }

    fn fill(
        &self,
        motion: &impl Motion,
        axis: Axes,
        reach: f64,
        times: &[f64],
        states: &mut [State],
    ) -> Result<()> {
        let axis = Rowing::new(axis);
        let (mut work, mut rows) = (Work::<TIMES>::new(), Rows::<TIMES>::zero());
        for (times, states) in times.chunks(TIMES).zip(states.chunks_mut(TIMES)) {
            // The lanes of a last chunk that is not full are at time 0.
            let mut lanes = [0.0; TIMES];
            lanes[..times.len()].copy_from_slice(times);
            motion.at(&lanes, &mut work, &mut rows);
            if let Ok(states) = <&mut [State; TIMES]>::try_from(&mut *states) {
                rows.each(axis, |i, state| states[i] = state);
            } else {
                for (i, state) in states.iter_mut().enumerate() {
                    *state = rows.one(i, axis);
                }
            }
            // So counted that not-a-number is beyond.
            let within = lanes.iter().filter(|t| t.abs() <= reach).count();
            if within < TIMES {
                for (t, state) in times.iter().zip(states) {
                    *state = self.at(*t)?;
                }
            }
        }
        Ok(())
    }
}

/// Many free bodies, so laid out that their states at one time are formed side by side (6.6, 6.8).
///
/// Which of the closed forms belongs to a body, and up to which time, is decided once, here.
///
/// ```
/// use spinning_bodies::euler_top::{Ensemble, EulerTop, State};
/// use spinning_bodies::frame::{Attitude, BodyVector};
/// // Rackets, tossed ever more nearly about the middle axis.
/// let rackets = (0..20)
///     .map(|k| {
///         let tilt = 10f64.powi(-k);
///         EulerTop::new([1.0, 2.0, 3.0], BodyVector::new(tilt, 1.0, tilt), Attitude::identity())
///     })
///     .collect::<Result<Vec<_>, _>>()?;
/// let ensemble = Ensemble::new(rackets);
/// let mut states = [State::default(); 20];
/// ensemble.states_at(50.0, &mut states)?;
/// let last = ensemble.tops()[19].at(50.0)?;
/// assert!(states[19].attitude.angle_to(&last.attitude) < 2e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Ensemble {
    bodies: Bodies,
    groups: Groups,
}

/// What the bodies were made from.
#[derive(Debug, Clone)]
enum Bodies {
    Tops(Vec<EulerTop>),
    /// With the tops, if they have been asked for.
    Releases(Vec<Release>, OnceLock<Vec<EulerTop>>),
}

/// Bodies of one kind next to each other.
#[derive(Debug, Clone, Default)]
struct Groups {
    steady: Vec<Group<Steady<[f64; BODIES]>>>,
    circular: Vec<Group<Circular<[f64; BODIES]>>>,
    hyperbolic: Vec<Group<Hyperbolic<[f64; BODIES]>>>,
    /// Those that are done one by one.
    single: Vec<(usize, EulerTop)>,
}

/// Bodies side by side.
#[derive(Debug, Clone)]
struct Group<M> {
    motion: M,
    /// Which bodies they are; the last is repeated where there are too few.
    place: [usize; BODIES],
    axes: Numbering,
    reach: f64,
}

/// How the axes of the bodies of a group are numbered.
#[derive(Debug, Clone)]
enum Numbering {
    Alike(Rowing),
    Mixed([Rowing; BODIES]),
}

impl Numbering {
    fn new(axes: [Axes; BODIES]) -> Self {
        let rows = axes.map(Rowing::new);
        if rows.iter().all(|x| *x == rows[0]) {
            Self::Alike(rows[0])
        } else {
            Self::Mixed(rows)
        }
    }
}

/// A body of one kind: which it is, its axes, its reach and its constants.
type Body<One> = (usize, Axes, f64, One);

/// Bodies whose axes are numbered alike are put side by side, as far as it goes.
fn groups<One, M>(bodies: &[Body<One>], gather: impl Fn([&One; BODIES]) -> M) -> Vec<Group<M>> {
    let mut order: Vec<&Body<One>> = bodies.iter().collect();
    order.sort_by_key(|body| body.1);
    order
        .chunks(BODIES)
        .map(|chunk| {
            let body = |i: usize| chunk[i.min(chunk.len() - 1)];
            Group {
                motion: gather(core::array::from_fn(|i| &body(i).3)),
                place: core::array::from_fn(|i| body(i).0),
                axes: Numbering::new(core::array::from_fn(|i| body(i).1)),
                reach: chunk
                    .iter()
                    .fold(f64::INFINITY, |reach, body| reach.min(body.2)),
            }
        })
        .collect()
}

/// The same for bodies that are prepared side by side.
fn begun<M>(
    releases: &[Release],
    way: Way,
    sorted: &[Sorted],
    zero: impl Fn() -> M,
    mut prepare: impl FnMut(&Beginnings<BODIES>, &mut M) -> f64,
) -> Vec<Group<M>> {
    let mut order: Vec<&Sorted> = sorted.iter().filter(|body| body.way == way).collect();
    order.sort_by_key(|body| body.axes.axis);
    order
        .chunks(BODIES)
        .map(|chunk| {
            let bodies: [&Sorted; BODIES] = core::array::from_fn(|i| chunk[i.min(chunk.len() - 1)]);
            let mut group = Group {
                motion: zero(),
                place: bodies.map(|body| body.place),
                axes: Numbering::new(bodies.map(|body| body.axes.axis)),
                reach: 0.0,
            };
            let rows = Beginnings::gather(releases, bodies);
            group.reach = prepare(&rows, &mut group.motion);
            group
        })
        .collect()
}

impl Ensemble {
    /// These bodies. Cost: half of what [`EulerTop::new`] has cost for each, and less than 2 kB a body with its top.
    pub fn new(tops: Vec<EulerTop>) -> Self {
        let (mut steady, mut circular, mut hyperbolic, mut single) =
            (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for (i, top) in tops.iter().enumerate() {
            match Prepared::new(top) {
                None => single.push((i, *top)),
                Some(Prepared { kind, axis, reach }) => match kind {
                    Kind::Steady(motion) => steady.push((i, axis, reach, motion)),
                    Kind::Circular(motion) => circular.push((i, axis, reach, motion)),
                    Kind::Hyperbolic(motion) => hyperbolic.push((i, axis, reach, motion)),
                },
            }
        }
        Self {
            bodies: Bodies::Tops(tops),
            groups: Groups {
                steady: groups(&steady, Steady::gather),
                circular: groups(&circular, Circular::gather),
                hyperbolic: groups(&hyperbolic, Hyperbolic::gather),
                single,
            },
        }
    }

    /// Bodies from scratch, prepared side by side: what [`EulerTop::new`] would make of each and [`new`](Self::new) of all (6.6, 6.8).
    ///
    /// Formulas, domain and error: those of [`released_states`]. Cost: 0.22 of [`EulerTop::new`] and one [`EulerTop::at`] for each of a hundred
    /// bodies or a thousand; then what [`states_at`](Self::states_at) costs.
    ///
    /// # Errors
    /// [`Error::AtPlace`]: which body [`EulerTop::new`] would refuse, the first of them, and why.
    ///
    /// ```
    /// use spinning_bodies::euler_top::{Ensemble, Release, State};
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// let gas = (1..=100).map(|k| Release {
    ///     moments: [1.0, 2.0, 2.5],
    ///     angular_momentum: BodyVector::new(1.0, 0.01 * f64::from(k), 0.5),
    ///     attitude: Attitude::identity(),
    /// });
    /// let gas = Ensemble::released(gas.collect())?;
    /// let mut states = [State::default(); 100];
    /// gas.states_at(3.0, &mut states)?;
    /// let alone = gas.tops()[99].at(3.0)?;
    /// assert!(states[99].attitude.angle_to(&alone.attitude) < 2e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn released(releases: Vec<Release>) -> Result<Self> {
        let sorted: Vec<Sorted> = releases
            .iter()
            .enumerate()
            .map(|(place, release)| release.sorted(place))
            .collect();
        let mut single = Vec::new();
        for body in sorted.iter().filter(|body| body.way == Way::Single) {
            single.push((body.place, prepared_at(&releases, body.place)?));
        }
        let mut work = Work::new();
        let groups = Groups {
            steady: begun(
                &releases,
                Way::Steady,
                &sorted,
                Steady::zero,
                |rows, motion| rows.steady(motion),
            ),
            circular: begun(
                &releases,
                Way::Circular,
                &sorted,
                Circular::zero,
                |rows, motion| rows.circular(motion, &mut work),
            ),
            hyperbolic: begun(
                &releases,
                Way::Hyperbolic,
                &sorted,
                Hyperbolic::zero,
                |rows, motion| rows.hyperbolic(motion, &mut work),
            ),
            single,
        };
        Ok(Self {
            bodies: Bodies::Releases(releases, OnceLock::new()),
            groups,
        })
    }

    /// The bodies, in the order they were given. Those that were released are prepared one by one when this is first asked.
    pub fn tops(&self) -> &[EulerTop] {
        match &self.bodies {
            Bodies::Tops(tops) => tops,
            Bodies::Releases(releases, tops) => tops.get_or_init(|| {
                let tops: Result<Vec<_>> = releases.iter().map(Release::top).collect();
                // What would be refused was refused when the ensemble was made.
                tops.unwrap_or_default()
            }),
        }
    }

    fn count(&self) -> usize {
        match &self.bodies {
            Bodies::Tops(tops) => tops.len(),
            Bodies::Releases(releases, _) => releases.len(),
        }
    }

    fn alone(&self, place: usize, t: f64) -> Result<State> {
        match &self.bodies {
            Bodies::Tops(tops) => tops[place].at(t),
            Bodies::Releases(releases, _) => releases[place].top()?.at(t),
        }
    }

    /// Ω, L and attitude of every body at time t (s), in the order of the bodies (6.6, 6.8).
    ///
    /// Domain and error: those of [`EulerTop::states_at`]; eight bodies go side by side unless one of them is beyond its reach. Cost: 0.25 of
    /// [`EulerTop::at`] for each body of a thousand, 0.27 for each of a hundred. Ten thousand no longer fit the nearer caches: 0.25 if nothing else
    /// wants the memory, otherwise more. What the ensemble costs comes back after some eight times.
    ///
    /// # Errors
    /// [`Error::Condition`] if there is not one place for each body; that of the first body whose [`EulerTop::at`] refuses the time, the states
    /// being partly written.
    pub fn states_at(&self, t: f64, states: &mut [State]) -> Result<()> {
        same_length(self.count(), states.len())?;
        for (place, top) in &self.groups.single {
            states[*place] = top.at(t)?;
        }
        self.fill(&self.groups.steady, t, states)?;
        self.fill(&self.groups.circular, t, states)?;
        self.fill(&self.groups.hyperbolic, t, states)
    }

    fn fill<M: Motion>(&self, groups: &[Group<M>], t: f64, states: &mut [State]) -> Result<()> {
        let times = [t; BODIES];
        let (mut work, mut rows) = (Work::new(), Rows::zero());
        for group in groups {
            if t.abs() <= group.reach {
                group.motion.at(&times, &mut work, &mut rows);
                group.hand_out(&rows, states);
            } else {
                for place in group.place {
                    states[place] = self.alone(place, t)?;
                }
            }
        }
        Ok(())
    }
}

impl<M> Group<M> {
    #[inline(always)]
    fn hand_out(&self, rows: &Rows<BODIES>, states: &mut [State]) {
        match &self.axes {
            Numbering::Alike(axes) => {
                rows.each(*axes, |i, state| states[self.place[i]] = state);
            }
            Numbering::Mixed(axes) => {
                for i in 0..BODIES {
                    states[self.place[i]] = rows.one(i, axes[i]);
                }
            }
        }
    }
}

/// The body at a place, or what is wrong with it there.
fn prepared_at(releases: &[Release], place: usize) -> Result<EulerTop> {
    releases[place].top().map_err(|reason| Error::AtPlace {
        place,
        reason: Box::new(reason),
    })
}

/// Ω, L and attitude of bodies let go at time 0, at one time t (s) after that or before, in the order of the bodies (6.6, 6.8).
///
/// For a single step of a larger simulation: nothing is kept for another time, and nothing is allocated a body. Eight bodies of one kind (Ω stays,
/// m ≤ 1/2, m > 1/2) go side by side from their moments and L: m or mc, whichever is the lesser, from sums of terms of one
/// sign; Gauss's transformation; the rate and the turn about L from theta functions of the smaller nome, in two words each; then the
/// state. Which kind a body is, exact differences decide.
///
/// Domain: that of [`EulerTop::new`] and [`EulerTop::at`]. One by one go rods, bodies at rest, moments or components of L more than a factor
/// of 2¹⁰⁰ apart or beyond 10^±120, and all eight if one of them has turned some 8·10⁶ times.
///
/// Error: that of a body at a time; the states differ by no more than 1.1e-15 in the quaternion (5 ε), 5.1e-16 in L and 5.5e-16 in Ω, observed over
/// 5000 bodies at five times, among them rackets, symmetric bodies, spheres and both neighbourhoods of the separatrix down to one
/// unit in the last place. Against the references of 32 digits: attitude 1e-15 rad.
///
/// Cost: 0.22 of [`EulerTop::new`] and one [`EulerTop::at`] for each body, 0.23 for spheres, in one run with those (`cargo bench -p bench --bench
/// ensembles`), with the instructions every processor of the kind has. Parts of the slices may be filled by different threads.
///
/// # Errors
/// [`Error::Condition`] if there is not one place for each body; [`Error::AtPlace`] with the place of a body that is refused; that of
/// [`EulerTop::at`] for a time that it refuses. The states may then be partly written.
///
/// ```
/// use spinning_bodies::euler_top::{EulerTop, Release, State, released_states};
/// use spinning_bodies::frame::{Attitude, BodyVector};
/// let body = Release {
///     moments: [0.6, 0.8, 1.0],
///     angular_momentum: BodyVector::new(1.8, 0.4, -0.9),
///     attitude: Attitude::identity(),
/// };
/// let mut states = [State::default(); 20];
/// released_states(&[body; 20], 0.1, &mut states)?;
/// let alone = EulerTop::new(body.moments, body.angular_momentum, body.attitude)?.at(0.1)?;
/// assert!(states[7].attitude.angle_to(&alone.attitude) < 2e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn released_states(releases: &[Release], t: f64, states: &mut [State]) -> Result<()> {
    same_length(releases.len(), states.len())?;
    let mut steady = Waiting::new(Steady::zero(), |rows, motion, _| rows.steady(motion));
    let mut circular = Waiting::new(Circular::zero(), Beginnings::circular);
    let mut hyperbolic = Waiting::new(Hyperbolic::zero(), Beginnings::hyperbolic);
    for (place, release) in releases.iter().enumerate() {
        let sorted = release.sorted(place);
        match sorted.way {
            Way::Single => states[place] = prepared_at(releases, place)?.at(t)?,
            Way::Steady => steady.join(sorted, releases, t, states)?,
            Way::Circular => circular.join(sorted, releases, t, states)?,
            Way::Hyperbolic => hyperbolic.join(sorted, releases, t, states)?,
        }
    }
    steady.go(releases, t, states)?;
    circular.go(releases, t, states)?;
    hyperbolic.go(releases, t, states)
}

/// How a kind of motion is prepared for eight bodies; up to which time it holds.
type Prepare<M> = fn(&Beginnings<BODIES>, &mut M, &mut Work<BODIES>) -> f64;

/// Bodies of one kind that wait until there are enough of them to go side by side.
struct Waiting<M> {
    bodies: Vec<Sorted>,
    motion: M,
    prepare: Prepare<M>,
    work: Work<BODIES>,
    rows: Rows<BODIES>,
}

impl<M: Motion> Waiting<M> {
    fn new(motion: M, prepare: Prepare<M>) -> Self {
        Self {
            bodies: Vec::with_capacity(BODIES),
            motion,
            prepare,
            work: Work::new(),
            rows: Rows::zero(),
        }
    }

    fn join(
        &mut self,
        body: Sorted,
        releases: &[Release],
        t: f64,
        states: &mut [State],
    ) -> Result<()> {
        self.bodies.push(body);
        if self.bodies.len() < BODIES {
            return Ok(());
        }
        self.go(releases, t, states)
    }

    /// Those who wait; the last is repeated where there are too few.
    fn go(&mut self, releases: &[Release], t: f64, states: &mut [State]) -> Result<()> {
        let Some(last) = self.bodies.len().checked_sub(1) else {
            return Ok(());
        };
        let bodies: [&Sorted; BODIES] = core::array::from_fn(|i| &self.bodies[i.min(last)]);
        let beginnings = Beginnings::gather(releases, bodies);
        let reach = (self.prepare)(&beginnings, &mut self.motion, &mut self.work);
        if t.abs() <= reach {
            self.motion.at(&[t; BODIES], &mut self.work, &mut self.rows);
            for (i, body) in self.bodies.iter().enumerate() {
                states[body.place] = self.rows.one(i, Rowing::new(body.axes.axis));
            }
        } else {
            for body in &self.bodies {
                states[body.place] = releases[body.place].top()?.at(t)?;
            }
        }
        self.bodies.clear();
        Ok(())
    }
}
