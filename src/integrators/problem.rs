//! What is asked of an integrator, and what it answers.

use crate::error::Result;

/// Equations y' = f(t, y) for N numbers.
pub trait System<const N: usize> {
    /// f(t, y). May be called at states that the motion never reaches; a result that is not finite makes the step fail.
    ///
    /// ```
    /// use spinning_bodies::integrators::System;
    /// let swing = |_: f64, y: &[f64; 2]| [y[1], -y[0]];
    /// assert_eq!(System::rate(&swing, 0.0, &[1.0, 2.0]), [2.0, -1.0]);
    /// ```
    fn rate(&self, t: f64, y: &[f64; N]) -> [f64; N];

    /// Told of the time after every step.
    ///
    /// # Errors
    /// Those that end the run: where a budget of evaluations is spent, say.
    ///
    /// ```
    /// use core::cell::Cell;
    /// use spinning_bodies::integrators::{Effort, Kept, System, order_eight};
    /// /// The time itself, and how many steps it took.
    /// struct Clock(Cell<u64>);
    /// impl System<1> for Clock {
    ///     fn rate(&self, _: f64, _: &[f64; 1]) -> [f64; 1] {
    ///         [1.0]
    ///     }
    ///     fn reached(&self, _: f64) -> spinning_bodies::Result<()> {
    ///         self.0.set(self.0.get() + 1);
    ///         Ok(())
    ///     }
    /// }
    /// let clock = Clock(Cell::new(0));
    /// let run = order_eight(&clock, Kept::Nothing, &[0.0], &[1.0], &[1.0], Effort::Step(0.125))?;
    /// assert_eq!((clock.0.get(), run.cost.steps), (8, 8));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    fn reached(&self, _time: f64) -> Result<()> {
        Ok(())
    }

    /// The greatest rate at which a small departure from an equilibrium may grow, where it is known, 1/s: steps of [`order_eight`](super::order_eight())
    /// by a tolerance are no longer than 14 tolerance^(1/8) over it. At first the departure is smaller than the tolerance, which then says nothing of a step.
    ///
    /// ```
    /// use spinning_bodies::integrators::System;
    /// let swing = |_: f64, y: &[f64; 2]| [y[1], -y[0]];
    /// assert_eq!(swing.growth_rate(), 0.0);
    /// ```
    fn growth_rate(&self) -> f64 {
        0.0
    }
}

/// Equations by one function, another that is told of the time after every step, and their growth rate.
pub(crate) struct Watched<F, W>(pub F, pub W, pub f64);

impl<const N: usize, F, W> System<N> for Watched<F, W>
where
    F: Fn(f64, &[f64; N]) -> [f64; N],
    W: Fn(f64) -> Result<()>,
{
    fn rate(&self, t: f64, y: &[f64; N]) -> [f64; N] {
        self.0(t, y)
    }

    fn reached(&self, time: f64) -> Result<()> {
        self.1(time)
    }

    fn growth_rate(&self) -> f64 {
        self.2
    }
}

impl<const N: usize, F: Fn(f64, &[f64; N]) -> [f64; N]> System<N> for F {
    fn rate(&self, t: f64, y: &[f64; N]) -> [f64; N] {
        self(t, y)
    }
}

/// A method of the crate `differential-equations`, by its usual name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Method {
    /// The classical Runge–Kutta method, order 4, fixed steps.
    Rk4,
    /// Dormand and Prince, order 5(4).
    Dopri5,
    /// Dormand and Prince as programmed by Hairer, order 8(5,3).
    Dop853,
    /// Verner's most efficient pair, order 9(8).
    Verner98,
    /// Gauss and Legendre's implicit method with three stages, order 6, fixed steps: symplectic and symmetric in time. A step costs ten times
    /// the evaluations of one of RK4 and several hundred times its time, for Newton's method differentiates by differences and solves 3N
    /// equations with matrices from the heap.
    ///
    /// The crate offers it with error control alone, by an estimate of order 2 that shrinks steps as if it were of order 6; and it counts
    /// rejected steps from the start of the run and calls the equations stiff at the hundredth. Here the step is held and nothing is rejected.
    Gauss,
}

impl Method {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Rk4,
        Self::Dopri5,
        Self::Dop853,
        Self::Verner98,
        Self::Gauss,
    ];

    /// The name by which it is asked for.
    ///
    /// ```
    /// use spinning_bodies::integrators::Method;
    /// assert_eq!(Method::Dop853.name(), "dop853");
    /// ```
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rk4 => "rk4",
            Self::Dopri5 => "dopri5",
            Self::Dop853 => "dop853",
            Self::Verner98 => "verner98",
            Self::Gauss => "gauss",
        }
    }

    /// Whether the step is chosen by an error estimate, and [`Effort::Tolerance`] asked for; if not, [`Effort::Step`].
    pub(crate) const fn is_adaptive(self) -> bool {
        !matches!(self, Self::Rk4 | Self::Gauss)
    }
}

/// How hard a method works.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Effort {
    /// Steps of this length at most, s.
    Step(f64),
    /// Error of one step: this times |y| + scale, component by component.
    Tolerance(f64),
}

/// What a run has cost. The same on every machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Cost {
    /// Evaluations of the right-hand side.
    pub evaluations: u64,
    /// Steps taken, accepted ones.
    pub steps: u64,
}

impl core::ops::AddAssign for Cost {
    fn add_assign(&mut self, other: Self) {
        self.evaluations += other.evaluations;
        self.steps += other.steps;
    }
}

/// States at the times asked for, in their order.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution<Y> {
    /// One state a time.
    pub states: Vec<Y>,
    /// What it has cost.
    pub cost: Cost,
}

/// A quantity whose zero ends a run.
pub trait Event<const N: usize> {
    /// g(t, y); the run ends where it falls through zero.
    ///
    /// ```
    /// use spinning_bodies::integrators::Event;
    /// let height = |_: f64, y: &[f64; 2]| y[0];
    /// assert_eq!(Event::value(&height, 0.0, &[1.0, 2.0]), 1.0);
    /// ```
    fn value(&self, t: f64, y: &[f64; N]) -> f64;
}

impl<const N: usize, F: Fn(f64, &[f64; N]) -> f64> Event<N> for F {
    fn value(&self, t: f64, y: &[f64; N]) -> f64 {
        self(t, y)
    }
}

/// A run that ended by an event, or at its end.
#[derive(Debug, Clone, PartialEq)]
pub struct Passage<Y> {
    /// States at those of the times asked for that were reached.
    pub states: Vec<Y>,
    /// Time at which the run ended.
    pub time: f64,
    /// State there.
    pub end: Y,
    /// Whether an event ended it.
    pub stopped: Stop,
    /// What it has cost.
    pub cost: Cost,
}

/// What ended a [`Passage`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stop {
    /// The time was up.
    AtTheEnd,
    /// The event's quantity fell through zero.
    AtTheEvent,
}

/// Rates of numbers, into the second slice.
pub(crate) type AnyRate<'a> = dyn Fn(f64, &[f64], &mut [f64]) + 'a;

/// A quantity that depends on the time and on numbers.
pub(crate) type AnyEvent<'a> = dyn Fn(f64, &[f64]) -> f64 + 'a;

/// Equations, where they start and what is asked of them, for methods that learn the number of numbers when they run.
#[derive(Clone, Copy)]
pub struct AnyLeg<'a> {
    /// The rates of the numbers, into the second slice.
    pub rate: &'a AnyRate<'a>,
    /// Told of the time after every step; its error ends the run.
    pub reached: &'a dyn Fn(f64) -> Result<()>,
    /// The quantity that ends the run where it falls through zero.
    pub event: Option<&'a AnyEvent<'a>>,
    /// When it starts, s, and with what.
    pub start: (f64, &'a [f64]),
    /// Sizes below which a number counts as small.
    pub scales: &'a [f64],
    /// Samples, ordered from the start to the end, s.
    pub times: &'a [f64],
    /// When it ends, s.
    pub end: f64,
}

impl core::fmt::Debug for AnyLeg<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Self { start, end, .. } = self;
        f.debug_struct("AnyLeg")
            .field("start", start)
            .field("end", end)
            .finish_non_exhaustive()
    }
}

/// General methods that the library itself does not have: who has them hands them to a scene with its request.
pub trait GeneralMethods: core::fmt::Debug + Sync {
    /// The numbers at the samples, up to the end or to the event.
    ///
    /// # Errors
    /// As for the library's own [`Leg::follow`](super::Leg::follow).
    ///
    /// ```
    /// use spinning_bodies::Result;
    /// use spinning_bodies::integrators::{AnyLeg, Cost, Effort, GeneralMethods, Method, Passage, Stop};
    /// /// Steps along the tangent, a thousand of them, whatever is asked.
    /// #[derive(Debug)]
    /// struct Tangents;
    /// impl GeneralMethods for Tangents {
    ///     fn follow(&self, _: Method, leg: &AnyLeg<'_>, _: Effort) -> Result<Passage<Vec<f64>>> {
    ///         let (mut end, mut rate) = (leg.start.1.to_vec(), leg.start.1.to_vec());
    ///         let step = (leg.end - leg.start.0) / 1000.0;
    ///         for k in 0..1000 {
    ///             (leg.rate)(leg.start.0 + step * f64::from(k), &end, &mut rate);
    ///             end.iter_mut().zip(&rate).for_each(|(y, rate)| *y += step * rate);
    ///         }
    ///         let cost = Cost { evaluations: 1000, steps: 1000 };
    ///         Ok(Passage { states: vec![], time: leg.end, end, stopped: Stop::AtTheEnd, cost })
    ///     }
    /// }
    /// let leg = AnyLeg {
    ///     rate: &|_, y, rate| rate[0] = y[0],
    ///     reached: &|_| Ok(()),
    ///     event: None,
    ///     start: (0.0, &[1.0]),
    ///     scales: &[1.0],
    ///     times: &[],
    ///     end: 1.0,
    /// };
    /// let grown = Tangents.follow(Method::Rk4, &leg, Effort::Step(1.0))?;
    /// assert!((grown.end[0] - 1.001_f64.powi(1000)).abs() < 1e-12);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    fn follow(&self, method: Method, leg: &AnyLeg<'_>, effort: Effort)
    -> Result<Passage<Vec<f64>>>;
}
