//! Who runs a top, and why.

use super::books::Books;
use super::equations::{Equations, fastest};
use super::methods::{Heavy, longest};
use super::prices::{Cheapest, cheapest};
use super::steered::CALM;
use super::{ClosedForm, Resistance, State, Top, Weight, body, closed};
use crate::error::{Error, Result};
use crate::euler_equations::Integrability;
use crate::frame::BodyVector;
use crate::integrators::geometric::Phase;
use crate::integrators::{Effort, Method};
use crate::scene::{Choice, Geometric, Motion, Plan, Request, Solver};

/// The method for scenes without a closed form.
const LEAN: Solver = Solver::Geometric(Geometric::DormandPrince8);

/// A weight whose share of the energies is below this stirs no exponential growth in 400 radians: of 40 random tops none.
const WEAK: f64 = 0.1;

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

    pub(super) fn planned(&self, request: &Request) -> Result<(Plan, Option<ClosedForm>)> {
        match request.choice() {
            Choice::Auto if T::PRESENT => Ok((Plan::new(WITH_EVENTS, self.reason()), None)),
            Choice::Auto if Self::LOSSY => Ok((Plan::new(LEAN, self.reason()), None)),
            Choice::Auto => self.cheapest(request),
            Choice::Use(Solver::Exact) => match self.closed_form()? {
                Some(closed) => Ok((Plan::new(Solver::Exact, "asked for"), Some(closed))),
                None => Err(Error::Condition {
                    condition: "the solver `exact` is for scenes with a closed form, this one has none",
                    value: f64::NAN,
                }),
            },
            Choice::Use(solver @ Solver::General(_)) => Ok((Plan::new(solver, "asked for"), None)),
            Choice::Use(Solver::Geometric(method)) => {
                if T::PRESENT || Self::LOSSY && method != Geometric::DormandPrince8 {
                    return Err(Error::Condition {
                        condition: "the geometric solvers are for tops under gravity alone, and dormand-prince-8 for those whose friction is smooth",
                        value: f64::NAN,
                    });
                }
                Ok((Plan::new(Solver::Geometric(method), "asked for"), None))
            }
            Choice::Use(Solver::Events) => Err(Error::Condition {
                condition: "the solver `events` is for scenes with contacts, a top has none",
                value: f64::NAN,
            }),
        }
    }

    /// A closed form, unless one run of order 8 is cheaper than preparing it.
    fn cheapest(&self, request: &Request) -> Result<(Plan, Option<ClosedForm>)> {
        let lever = self.gravity.lever(self.body.arm());
        let omega = self.start.omega(self.body.moments)?;
        let angle = fastest(&self.body, lever, omega) * longest(request.times());
        let (samples, accuracy) = (request.times().len(), request.accuracy());
        let closed = match cheapest(self.body.moments, lever, angle, samples, accuracy) {
            Cheapest::ClosedForm => self.closed_form()?,
            Cheapest::OnlyRun => None,
            Cheapest::Run => {
                let reason = "a run so short that it costs less than preparing the closed form";
                return Ok((Plan::new(LEAN, reason), None));
            }
        };
        Ok(match closed {
            Some(closed) => (Plan::new(Solver::Exact, closed.reason()), Some(closed)),
            None => (Plan::new(LEAN, self.reason()), None),
        })
    }

    /// One run by a method for turning bodies, at these times, with this effort and no question about its error.
    ///
    /// What [`Scene::simulate`](crate::scene::Scene::simulate) does without the second run that vouches for the first, and without a word about a ledger that does not balance:
    /// for those who measure methods.
    ///
    /// # Errors
    /// [`Error::Condition`] where something other than gravity acts, or the method cannot run this top; those of the method.
    pub fn run_once(
        &self,
        times: &[f64],
        method: Geometric,
        effort: Effort,
    ) -> Result<Motion<State>> {
        if Self::LOSSY {
            return Err(Error::Condition {
                condition: "a run without a question about its error is for tops under gravity alone",
                value: f64::NAN,
            });
        }
        let books = Books::of(&self.body, self.gravity.lever(self.body.arm()), &self.start)?;
        let heavy = self.heavy(times, &books)?;
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

    pub(super) fn heavy<'a>(&self, times: &'a [f64], books: &Books) -> Result<Heavy<'a>> {
        self.needs_moments()?;
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
        Ok(Heavy {
            moments,
            lever,
            start: Phase::new(l, &self.start.attitude),
            fastest: fastest(&self.body, lever, omega).max(f64::MIN_POSITIVE),
            momentum: books.momentum_scale,
            energy: books.energy_scale,
            times,
            calm: self.calm(books),
        })
    }

    /// How far a motion goes before what is off by little may be off by much: a fourth integral keeps it for ever, a weak weight for longer.
    fn calm(&self, books: &Books) -> f64 {
        let weight = {
            let [x, y, z] = self.gravity.lever(self.body.arm());
            x.hypot(y).hypot(z)
        };
        match books.kind {
            Integrability::None | Integrability::OnLevelZero(_) => {
                if weight < WEAK * books.energy_scale {
                    10.0 * CALM
                } else {
                    CALM
                }
            }
            _ => f64::INFINITY,
        }
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
