//! Who runs a top, and why.

use super::books::Books;
use super::equations::{Equations, fastest};
use super::foreseen::Foreseen;
use super::methods::Heavy;
use super::prices::{Cheapest, Task};
use super::steered::CALM;
use super::{ClosedForm, Resistance, State, Top, Weight, body, closed};
use crate::error::{Error, Result};
use crate::euler_equations::Integrability;
use crate::frame::BodyVector;
use crate::integrators::geometric::Phase;
use crate::integrators::{Effort, Method};
use crate::scene::{Budget, Choice, Geometric, Motion, Plan, Request, Solver};

/// The method for scenes without a closed form.
pub(super) const LEAN: Solver = Solver::Geometric(Geometric::DormandPrince8);

/// How a plan is carried out.
#[allow(
    clippy::large_enum_variant,
    reason = "a run has one of these, and is over soon"
)]
pub(super) enum Way {
    /// By this closed form.
    Closed(ClosedForm),
    /// By steps of a length that is known.
    Foreseen(Foreseen),
    /// By the method that the plan names.
    Named,
}

/// A weight whose share of the energies is below this, and below that share of the distance from the free body's separatrix, stirs no exponential growth in
/// 150 radians: of 100 random tops none, but two of three that were nearer.
const WEAK: f64 = 0.1;
const WEAK_BESIDE: f64 = 0.3;

/// That for scenes with events.
const WITH_EVENTS: Solver = Solver::General(Method::Dop853);

impl<G: Weight, F: Resistance, B: Resistance, D: Resistance, T: Resistance> Top<G, F, B, D, T> {
    /// Whether anything resists; known at compile time.
    pub(super) const LOSSY: bool = F::PRESENT || B::PRESENT || D::PRESENT || T::PRESENT;

    /// The motion in closed form, if this scene has one.
    ///
    /// # Errors
    /// Those of the solution.
    pub fn closed_form(&self) -> Result<Option<ClosedForm>> {
        if Self::LOSSY {
            return Ok(None);
        }
        ClosedForm::find(&self.body, self.gravity.lever(self.body.arm()), &self.start)
    }

    pub(super) fn planned(&self, request: &Request, books: &Books) -> Result<(Plan, Way)> {
        match request.choice() {
            Choice::Auto if T::PRESENT => Ok((Plan::new(WITH_EVENTS, self.reason()), Way::Named)),
            Choice::Auto if Self::LOSSY => Ok((Plan::new(LEAN, self.reason()), Way::Named)),
            Choice::Auto => self.cheapest(request, books),
            Choice::Use(Solver::Exact) => match self.closed_form()? {
                Some(closed) => Ok((Plan::new(Solver::Exact, "asked for"), Way::Closed(closed))),
                None => Err(Error::Solver {
                    condition: "the solver `exact` is for scenes with a closed form, this one has none",
                }),
            },
            Choice::Use(solver @ Solver::General(_)) => {
                Ok((Plan::new(solver, "asked for"), Way::Named))
            }
            Choice::Use(Solver::Geometric(method)) => {
                if T::PRESENT || Self::LOSSY && method != Geometric::DormandPrince8 {
                    return Err(Error::Solver {
                        condition: "the geometric solvers are for tops under gravity alone, and dormand-prince-8 for those whose friction is smooth",
                    });
                }
                Ok((
                    Plan::new(Solver::Geometric(method), "asked for"),
                    Way::Named,
                ))
            }
            Choice::Use(Solver::Events) => Err(Error::Solver {
                condition: "the solver `events` is for scenes with contacts, a top has none",
            }),
        }
    }

    /// A closed form, unless a run is cheaper than preparing it.
    fn cheapest(&self, request: &Request, books: &Books) -> Result<(Plan, Way)> {
        let budget = Budget::unlimited();
        let heavy = self.heavy(request.times(), books, &budget)?;
        let task = Task::of(&heavy, books.kind, request.accuracy());
        let reason = "a run so short that it costs less than preparing the closed form";
        match task.cheapest() {
            Cheapest::ClosedForm => {
                if let Some(closed) = self.closed_form()? {
                    let plan = Plan::new(Solver::Exact, closed.reason());
                    return Ok((plan, Way::Closed(closed)));
                }
            }
            Cheapest::OnlyOrderEight => {}
            Cheapest::OrderEight => return Ok((Plan::new(LEAN, reason), Way::Named)),
            Cheapest::Steps(foreseen) => {
                let solver = Solver::Geometric(foreseen.method);
                return Ok((Plan::new(solver, reason), Way::Foreseen(foreseen)));
            }
        }
        Ok((Plan::new(LEAN, self.reason()), Way::Named))
    }

    /// What to do where a run of the scene's own choice has not reached the accuracy: the method of order 8, then a closed form, dear as it may be.
    pub(super) fn instead(&self, plan: &Plan) -> Result<Option<(Plan, Way)>> {
        if plan.solver != LEAN {
            let reason = "where steps of one length did not reach the accuracy";
            return Ok(Some((Plan::new(LEAN, reason), Way::Named)));
        }
        Ok(self.closed_form()?.map(|closed| {
            let plan = Plan::new(Solver::Exact, closed.reason());
            (plan, Way::Closed(closed))
        }))
    }

    /// One run by a method for turning bodies, at these times, with this effort and no question about its error.
    ///
    /// What [`Scene::simulate`](crate::scene::Scene::simulate) does without the second run that vouches for the first, and without a word about a ledger that does not balance:
    /// for those who measure methods.
    ///
    /// # Errors
    /// [`Error::Solver`] where something other than gravity acts, or the method cannot run this top; those of the method.
    pub fn run_once(
        &self,
        times: &[f64],
        method: Geometric,
        effort: Effort,
    ) -> Result<Motion<State>> {
        if Self::LOSSY {
            return Err(Error::Solver {
                condition: "a run without a question about its error is for tops under gravity alone",
            });
        }
        let books = Books::of(&self.body, self.gravity.lever(self.body.arm()), &self.start)?;
        self.needs_moments()?;
        let budget = Budget::unlimited();
        let heavy = self.heavy(times, &books, &budget)?;
        let (phases, cost) = heavy.once(method, effort)?;
        let rows = heavy.rows(&phases, &books)?;
        Ok(Motion {
            plan: Plan::new(Solver::Geometric(method), "asked for"),
            cost,
            error_estimate: None,
            ledger: books.lossless(&rows)?,
            rows,
        })
    }

    pub(super) fn heavy<'a>(
        &self,
        times: &'a [f64],
        books: &Books,
        budget: &'a Budget,
    ) -> Result<Heavy<'a>> {
        let lever = self.gravity.lever(self.body.arm());
        let moments = self.body.moments;
        let omega = self.start.omega(moments)?;
        let l = match self.start.spin {
            body::Spin::AngularMomentum(l) => l,
            body::Spin::Omega(_) => {
                let [a, b, c] = moments;
                BodyVector::new(a * omega.x(), b * omega.y(), c * omega.z())
            }
        };
        let fastest = fastest(&self.body, lever, omega).max(f64::MIN_POSITIVE);
        Ok(Heavy {
            moments,
            lever,
            start: Phase::new(l, &self.start.attitude),
            fastest,
            momentum: books.momentum_scale,
            energy: books.energy_scale,
            times,
            calm: self.calm(books, l, fastest),
            budget,
        })
    }

    /// How far (radians) a motion goes before what is off by little may be off by much: for ever with a fourth integral, long under a weak weight unless
    /// the free body would pass near turning about its middle axis.
    fn calm(&self, books: &Books, l: BodyVector, fastest: f64) -> f64 {
        if !matches!(
            books.kind,
            Integrability::None | Integrability::OnLevelZero(_)
        ) {
            return f64::INFINITY;
        }
        let [x, y, z] = self.gravity.lever(self.body.arm());
        let weight = x.hypot(y).hypot(z) / books.energy_scale;
        let moments = self.body.moments;
        let [a, b] = [f64::min, f64::max].map(|of| moments.into_iter().fold(moments[0], of));
        let middle = moments[0] + moments[1] + moments[2] - a - b;
        let (l, square) = (l.components(), l.dot(&l));
        let energy: f64 = (0..3).map(|k| l[k] * l[k] / moments[k]).sum();
        // 0 on the separatrix of the free body.
        let off = (energy * middle / square - 1.0).abs();
        if weight < WEAK && weight < WEAK_BESIDE * off {
            return 10.0 * CALM;
        }
        if off > 0.15 {
            return CALM;
        }
        // The rate at which the free body leaves its middle axis; four times e is harmless.
        let rate = square.sqrt()
            * ((1.0 / a - 1.0 / middle) * (1.0 / middle - 1.0 / b))
                .abs()
                .sqrt();
        CALM.min(4.0 * fastest / rate)
    }

    pub(super) fn needs_moments(&self) -> Result<()> {
        match self.body.moments.iter().find(|&&moment| moment == 0.0) {
            Some(&moment) => Err(Error::NotPositive {
                quantity: "a principal moment of a body without a closed form",
                value: moment,
            }),
            None => Ok(()),
        }
    }

    /// Why no closed form will do.
    fn reason(&self) -> String {
        let resisting = [
            (F::PRESENT, F::NAME),
            (B::PRESENT, B::NAME),
            (D::PRESENT, D::NAME),
            (T::PRESENT, T::NAME),
        ];
        let names: Vec<&str> = resisting.iter().filter(|r| r.0).map(|r| r.1).collect();
        if names.is_empty() {
            closed::NONE.to_owned()
        } else {
            format!("{}: no closed form", names.join(" and "))
        }
    }

    pub(super) fn equations(&self) -> Equations<G, F, B, D, T> {
        Equations {
            moments: self.body.moments,
            arm: self.body.arm(),
            gravity: self.gravity,
            pivot_friction: self.pivot_friction,
            bearing_friction: self.bearing_friction,
            air_drag: self.air_drag,
            tip_friction: self.tip_friction,
        }
    }
}
