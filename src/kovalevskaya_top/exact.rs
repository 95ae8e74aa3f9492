//! Which branch a start lies on, and the trial that decides between her road and the power series.

use super::constants::{Constants, Phase, WidePhase};
use super::periods::Curve;
use super::separation::{Separation, Variables};
use super::solution::{Moving, Quotients, Reconstruction, Torus};
use super::taylor::{Carried, Series, project};
use crate::precise::{DoubleDouble, Number};

/// Why a motion is integrated and not solved by separation.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Reason {
    /// Two of the five roots coincide, or nearly: s₁ rests on them or comes to them only after infinite time, or the linear system loses digits.
    DoubleRoot,
    /// The linear system loses digits: her formulas give the start, or the motion some time later, only to this much, in units in
    /// which Ω and √(MgC₁/I₃) are at most of size 2. So it is for gravity that is weak against the spin.
    Cancellation(f64),
}

/// A motion solved by separation.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Exact {
    pub separation: Separation,
    pub curve: Curve,
    torus: Torus,
    quotients: Quotients,
    /// Turns of the phases at time 0, halved.
    origin: [f64; 2],
    /// And a unit of time.
    advance: [DoubleDouble; 2],
    /// States with attitudes by power series soon after time 0.
    pub trial: Vec<(f64, Carried)>,
}

/// The largest disagreement with which separation is trusted, over c where that is below 1, and whatever c: of 1000 random starts none had more than 1e-14 at the
/// start.
const TRUSTED: [f64; 2] = [3e-14, 1e-12];

/// How long the trial lasts, in units of the motion.
const TRIAL: f64 = 3.0;

impl Exact {
    /// Roots, band, periods, signs and phases of a start; tried at the start and at a later time against the power series.
    pub fn find(constants: &Constants, wide: &WidePhase, whole: &Carried) -> Result<Self, Reason> {
        let mut exact = Self::nearest(constants, wide, whole).ok_or(Reason::DoubleRoot)?;
        match tried(constants, whole, |t| exact.state(constants, t)) {
            Ok(trial) => {
                exact.trial = trial;
                Ok(exact)
            }
            // Weak gravity brings roots together by itself, to some c².
            Err(_)
                if exact.separation.narrowest() < 1e-2 * constants.c.value().min(1.0).powi(2) =>
            {
                Err(Reason::DoubleRoot)
            }
            Err(worst) => Err(Reason::Cancellation(worst)),
        }
    }

    // ANCHOR: branch
    /// Of the 4 × 8 signs of two phases and three roots, those that give the start back.
    fn nearest(constants: &Constants, wide: &WidePhase, whole: &Carried) -> Option<Self> {
        let variables = Variables::of(constants, wide);
        let separation = Separation::prepare(constants, variables.s1)?;
        let curve = Curve::prepare(&separation)?;
        let advance = separation.frequencies().map(|n| n.scaled(0.5));
        let torus = Torus::prepare(
            &curve,
            separation.pinched(),
            advance.map(DoubleDouble::value),
        )?;
        let sum = |[[a, b], [c, d]]: [[f64; 2]; 2], signs: [f64; 2]| {
            [(a, c), (b, d)].map(|(x, y)| 0.5 * (signs[0] * x + signs[1] * y))
        };
        let (places, products) = separation.midst();
        let midst = sum(separation.phases(places.each_ref()), [1.0, 1.0]);
        let [factors, wronskians] = torus.constants(&separation, midst, &products);
        let system =
            Reconstruction::prepare(constants, &separation.roots, separation.differences());
        let places = separation.places(&variables, constants.l1);
        let phases = separation.phases(places.each_ref());
        let every: [Quotients; 8] = core::array::from_fn(|choice| {
            system.quotients(factors, wronskians, choice, torus.split())
        });
        let mut best = (f64::INFINITY, [0.0; 2], &every[0]);
        for signs in [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]] {
            let origin = sum(phases, signs);
            let functions = torus.parts(origin);
            for quotients in &every {
                let miss = distance(&of(quotients, constants, &functions), &whole.0);
                if miss < best.0 {
                    best = (miss, origin, quotients);
                }
            }
        }
        let (_, origin, quotients) = best;
        let quotients = quotients.clone();
        Some(Self {
            separation,
            curve,
            torus,
            quotients,
            origin,
            advance,
            trial: Vec::new(),
        })
    }
    // ANCHOR_END: branch

    /// Turns of the two phases a unit of time, halved.
    pub fn advance(&self) -> [f64; 2] {
        self.advance.map(DoubleDouble::value)
    }

    pub fn state(&self, constants: &Constants, t: f64) -> Phase {
        self.at_turns(constants, self.halved(t))
    }

    /// Turns of the two phases, halved, from 0 to 1: a state returns when one of these gains 1.
    pub fn halved(&self, t: f64) -> [f64; 2] {
        [0, 1].map(|i| {
            let v = self.advance[i].times(t) + DoubleDouble::from(self.origin[i]);
            (v - DoubleDouble::from(v.high().floor())).value()
        })
    }

    /// The state where the phases have turned so far, halved.
    pub fn at_turns(&self, constants: &Constants, v: [f64; 2]) -> Phase {
        project(
            constants,
            &of(&self.quotients, constants, &self.torus.parts(v)),
        )
    }
}

fn of(quotients: &Quotients, constants: &Constants, functions: &[Moving; 7]) -> Phase {
    let [a, b, c, bc, ca, ab, alone] = *functions;
    quotients.state(constants, &[a, b, c], &[bc, ca, ab], alone[0])
}

/// States with attitudes by power series soon after time 0, from which the formula for Ω and z does not differ; or by how much it does.
pub(super) fn tried(
    constants: &Constants,
    start: &Carried,
    state: impl Fn(f64) -> Phase,
) -> Result<Vec<(f64, Carried)>, f64> {
    let c = constants.c.value();
    let trusted = (TRUSTED[0] / c.min(1.0)).min(TRUSTED[1]);
    let mut worst = distance(&state(0.0), &start.0);
    let (mut carried, mut t, mut trial) = (*start, 0.0, Vec::new());
    while t < TRIAL && worst <= trusted {
        let series = Series::<f64, 10>::of(c, &carried);
        let step = series.reach.min(TRIAL - t);
        carried = series.carried(step);
        t += step;
        worst = worst.max(distance(&state(t), &carried.0));
        trial.push((t, carried));
    }
    if worst <= trusted {
        Ok(trial)
    } else {
        Err(worst)
    }
}

pub(super) fn distance(a: &Phase, b: &Phase) -> f64 {
    let difference = (0..6).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt();
    // What is not a number is no agreement.
    if difference.is_nan() {
        f64::INFINITY
    } else {
        difference
    }
}
