//! Many bodies whose constants are kept, eight of a kind side by side.

use std::sync::OnceLock;

use super::at_once::prepared_at;
use super::beginning::Beginnings;
use super::constants::{Circular, Hyperbolic, Steady};
use super::lanes::{Motion, Rows, Work};
use super::prepared::{Kind, Prepared};
use super::release::{Release, Sorted, Way};
use super::{Axes, BODIES, Rowing, same_length};
use crate::error::Result;
use crate::euler_top::motion::{EulerTop, State};

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
    /// Formulas, domain and error: those of [`released_states`](super::released_states). Cost: 0.22 of [`EulerTop::new`] and one
    /// [`EulerTop::at`] for each of a hundred bodies or a thousand, 0.25 for rackets next to the separatrix; then what [`states_at`](Self::states_at) costs.
    ///
    /// # Errors
    /// [`Error::AtPlace`](crate::Error::AtPlace): which body [`EulerTop::new`] would refuse, the first of them, and why.
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
    /// Domain and error: those of [`EulerTop::states_at`]; eight bodies go side by side unless one of them is beyond its reach. Cost: 0.23 of
    /// [`EulerTop::at`] for each body of a hundred or a thousand, 0.28 for spheres, for which [`EulerTop::at`] has little to do. Ten thousand no longer
    /// fit the nearer caches: 0.22 if nothing else wants the memory, otherwise more. An ensemble of prepared tops pays after some eight times, one
    /// from scratch at the first.
    ///
    /// # Errors
    /// [`Error::Condition`](crate::Error::Condition) if there is not one place for each body; that of the first body whose [`EulerTop::at`]
    /// refuses the time, the states being partly written.
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
