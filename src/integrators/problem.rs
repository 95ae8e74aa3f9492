//! Equations, efforts and events as an integrator takes them, and the solutions and costs it returns.

use crate::error::Result;

/// Equations y' = f(t, y) for N components.
pub trait System<const N: usize> {
    /// f(t, y). May be called at states that the motion never reaches; a result that is not finite makes the step fail.
    ///
    /// ```
    /// use spinning_bodies::integrators::System;
    /// let swing = |_: f64, y: &[f64; 2]| [y[1], -y[0]];
    /// assert_eq!(System::rate(&swing, 0.0, &[1.0, 2.0]), [2.0, -1.0]);
    /// ```
    fn rate(&self, t: f64, y: &[f64; N]) -> [f64; N];

    /// Called with the time after every step.
    ///
    /// # Errors
    /// Any error ends the run: a spent budget of evaluations, for example.
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

    /// The greatest rate, 1/s, at which a small departure from an equilibrium may grow, if it is known. Steps of [`order_eight`](super::order_eight())
    /// that follow a tolerance are no longer than 14 tolerance^(1/8) divided by it: while the departure is below the tolerance, the tolerance does not limit them.
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

/// Equations given by one function, another that is called with the time after every step, and their growth rate.
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

/// A method of the crate `differential-equations`, under its usual name.
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
    /// Gauss and Legendre's implicit method with three stages, order 6, fixed steps: symplectic and symmetric in time. A step takes ten times
    /// the evaluations of a step of RK4 and several hundred times its time, for Newton's method differentiates by differences and solves 3N
    /// equations with matrices allocated on the heap.
    ///
    /// The crate offers it only with error control, by an estimate of order 2 that shortens steps as if it were of order 6; and it counts
    /// rejected steps from the start of the run and calls the equations stiff at the hundredth. Here the step is fixed and none is rejected.
    Gauss,
}

impl Method {
    /// All methods.
    pub const ALL: [Self; 5] = [
        Self::Rk4,
        Self::Dopri5,
        Self::Dop853,
        Self::Verner98,
        Self::Gauss,
    ];

    /// The name under which a request selects it.
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

    /// Whether an error estimate chooses the step, so that the effort is an [`Effort::Tolerance`]; otherwise it is an [`Effort::Step`].
    pub(crate) const fn is_adaptive(self) -> bool {
        !matches!(self, Self::Rk4 | Self::Gauss)
    }
}

/// How accurately a method works: the length of its steps, or the error of one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Effort {
    /// Steps of this length at most, s.
    Step(f64),
    /// Steps whose error is at most this times |y| + scale in each component.
    Tolerance(f64),
}

/// What a run has cost, in counts that are the same on every machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Cost {
    /// Evaluations of the right-hand side, or of what a geometric method takes in their place: see [`Stepper::cost`](super::geometric::Stepper::cost).
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

/// States at the requested times, in their order.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution<Y> {
    /// One state for each time.
    pub states: Vec<Y>,
    /// The cost of the run.
    pub cost: Cost,
}

/// A quantity g(t, y); a run ends where it falls through zero.
pub type Event<'a, const N: usize> = dyn Fn(f64, &[f64; N]) -> f64 + 'a;

/// A run up to an event or to its end time.
#[derive(Debug, Clone, PartialEq)]
pub struct Passage<Y> {
    /// States at those of the requested times that were reached.
    pub states: Vec<Y>,
    /// Time at which the run ended.
    pub time: f64,
    /// State at that time.
    pub end: Y,
    /// What ended it.
    pub stopped: Stop,
    /// The cost of the run.
    pub cost: Cost,
}

/// What ended a [`Passage`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stop {
    /// The end time was reached.
    AtTheEnd,
    /// The event's quantity fell through zero.
    AtTheEvent,
}

/// The right-hand side: time, state, and the slice that receives the rates.
pub(crate) type AnyRate<'a> = dyn Fn(f64, &[f64], &mut [f64]) + 'a;

/// A function of time and state.
pub(crate) type AnyEvent<'a> = dyn Fn(f64, &[f64]) -> f64 + 'a;

/// Equations, initial state and requested times, for methods that learn the number of components only at run time.
#[derive(Clone, Copy)]
pub struct AnyLeg<'a> {
    /// Writes the rates of the components into the second slice.
    pub rate: &'a AnyRate<'a>,
    /// Called with the time after every step; an error ends the run.
    pub reached: &'a dyn Fn(f64) -> Result<()>,
    /// The quantity whose fall through zero ends the run.
    pub event: Option<&'a AnyEvent<'a>>,
    /// Initial time, s, and state.
    pub start: (f64, &'a [f64]),
    /// Sizes below which a component counts as small.
    pub scales: &'a [f64],
    /// Times of the samples, s, ordered from the start to the end.
    pub times: &'a [f64],
    /// End time, s.
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

/// General methods from outside the library, passed to a scene with the request.
pub trait GeneralMethods: core::fmt::Debug + Sync {
    /// The components at the samples, up to the end or to the event.
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
