//! Solvers, and the plan: which of them runs, and why.

use core::fmt;

use crate::integrators::Method;
use crate::integrators::geometric::{Order, VeselovOrder};

/// A solver of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Solver {
    /// A closed form: the same cost at any time, and errors of rounding only.
    Exact,
    /// Closed forms from one event to the next.
    Events,
    /// A general method with error control.
    General(Method),
    /// A method for turning bodies.
    Geometric(Geometric),
}

/// A method for turning bodies, under its name in the tables: those of [`geometric`](crate::integrators::geometric), and two with error control.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Geometric {
    /// Exact rotations about principal axes in turn; free bodies.
    Rotations(Order),
    /// The discrete free top; free bodies.
    MoserVeselov(VeselovOrder),
    /// Kicks by the weight between free motions.
    KickDrift(Order),
    /// Runge–Kutta of order 4 in the rotation vector.
    MuntheKaas,
    /// Runge–Kutta of order 8 with error control.
    DormandPrince8,
    /// Power series of order 36 in 106 bits with error control; bodies whose own axes are principal.
    PowerSeries,
}

impl Geometric {
    const fn name(self) -> &'static str {
        match self {
            Self::Rotations(Order::Two) => "rotations-2",
            Self::Rotations(Order::Four) => "rotations-4",
            Self::Rotations(Order::Six) => "rotations-6",
            Self::MoserVeselov(VeselovOrder::Two) => "moser-veselov-2",
            Self::MoserVeselov(VeselovOrder::Four) => "moser-veselov-4",
            Self::MoserVeselov(VeselovOrder::Six) => "moser-veselov-6",
            Self::MoserVeselov(VeselovOrder::Ten) => "moser-veselov-10",
            Self::KickDrift(Order::Two) => "kick-drift-2",
            Self::KickDrift(Order::Four) => "kick-drift-4",
            Self::KickDrift(Order::Six) => "kick-drift-6",
            Self::MuntheKaas => "munthe-kaas-4",
            Self::DormandPrince8 => "dormand-prince-8",
            Self::PowerSeries => "power-series",
        }
    }
}

impl Solver {
    /// The solver for scenes without a closed form.
    pub(crate) const ORDER_EIGHT: Self = Self::Geometric(Geometric::DormandPrince8);

    /// All solvers.
    ///
    /// ```
    /// use spinning_bodies::scene::Solver;
    /// assert!(Solver::all().any(|solver| solver.name() == "rotations-2"));
    /// ```
    pub fn all() -> impl Iterator<Item = Self> {
        let geometric = (Order::ALL.map(Geometric::Rotations).into_iter())
            .chain(VeselovOrder::ALL.map(Geometric::MoserVeselov))
            .chain(Order::ALL.map(Geometric::KickDrift))
            .chain([
                Geometric::MuntheKaas,
                Geometric::DormandPrince8,
                Geometric::PowerSeries,
            ]);
        [Self::Exact, Self::Events]
            .into_iter()
            .chain(Method::ALL.map(Self::General))
            .chain(geometric.map(Self::Geometric))
    }

    /// Its name in a scene file.
    ///
    /// ```
    /// use spinning_bodies::scene::Solver;
    /// // Every name is another.
    /// let mut names: Vec<_> = Solver::all().map(Solver::name).collect();
    /// names.sort();
    /// assert!(names.windows(2).all(|pair| pair[0] != pair[1]));
    /// ```
    pub const fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Events => "events",
            Self::General(method) => method.name(),
            Self::Geometric(method) => method.name(),
        }
    }
}

impl fmt::Display for Solver {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The solver that a scene runs on, and the reason.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Plan {
    /// The solver.
    pub solver: Solver,
    /// The reason: "no torque: closed form".
    pub reason: String,
}

impl Plan {
    pub(crate) fn new(solver: Solver, reason: impl Into<String>) -> Self {
        let reason = reason.into();
        Self { solver, reason }
    }

    /// The plan to use a closed form.
    pub(crate) fn exact(reason: impl Into<String>) -> Self {
        Self::new(Solver::Exact, reason)
    }

    /// The plan to use closed forms from event to event.
    pub(crate) fn events(reason: impl Into<String>) -> Self {
        Self::new(Solver::Events, reason)
    }

    /// The plan to use the method of order 8.
    pub(crate) fn stepped(reason: impl Into<String>) -> Self {
        Self::new(Solver::ORDER_EIGHT, reason)
    }
}

impl fmt::Display for Plan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.solver, self.reason)
    }
}

/// Who chooses the solver.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Choice {
    /// The scene: a closed form where there is one, whole or from event to event, otherwise the method of order 8.
    #[default]
    Auto,
    /// The user. A scene refuses a solver that cannot run it.
    Use(Solver),
}
