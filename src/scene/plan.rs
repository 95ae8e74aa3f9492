//! Which solver runs, and why.

use core::fmt;
use core::str::FromStr;

use crate::integrators::Method;

/// Everything that can move a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Solver {
    /// A closed form: any time at the same cost, errors of rounding.
    Exact,
    /// Closed forms from one event to the next.
    Events,
    /// A general method with error control.
    General(Method),
}

impl Solver {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Exact,
        Self::Events,
        Self::General(Method::Rk4),
        Self::General(Method::Dopri5),
        Self::General(Method::Dop853),
        Self::General(Method::Verner98),
    ];

    /// The name by which it is asked for in a scene file.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Events => "events",
            Self::General(method) => method.name(),
        }
    }
}

impl fmt::Display for Solver {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The name is not that of a solver.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct UnknownSolver;

impl FromStr for Solver {
    type Err = UnknownSolver;

    fn from_str(name: &str) -> Result<Self, UnknownSolver> {
        let found = Self::ALL.into_iter().find(|solver| solver.name() == name);
        found.ok_or(UnknownSolver)
    }
}

/// The solver that a scene runs on, and the reason.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Plan {
    /// The solver.
    pub solver: Solver,
    /// Why: "no torque: closed form".
    pub reason: String,
}

impl Plan {
    pub(crate) fn new(solver: Solver, reason: impl Into<String>) -> Self {
        Self {
            solver,
            reason: reason.into(),
        }
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
    /// The scene: a closed form where there is one, otherwise the cheapest method that reaches the accuracy.
    #[default]
    Auto,
    /// The user. A scene refuses a solver that cannot run it.
    Use(Solver),
}
