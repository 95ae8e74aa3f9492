//! Ω and z by separation, and the trial that decides between her road and the power series.

use core::iter::successors;

use super::constants::{Constants, Phase, WidePhase};
use super::periods::Curve;
use super::separation::{Separation, Variables};
use super::solution::{Quotients, Reconstruction, Torus, distance};
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

/// Ω and z of a motion solved by separation.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Exact {
    pub separation: Separation,
    pub curve: Curve,
    pub torus: Torus,
    quotients: Quotients,
    /// Turns of the phases at time 0, halved.
    origin: [f64; 2],
    /// Whether a handle of the curve is closed, so that the phases do not return.
    pub closed: bool,
}

/// States with attitudes by power series from time 0 on.
pub(super) type Trial = Vec<(f64, Carried)>;

/// The largest disagreement with which separation is trusted, over c where that is below 1, and whatever c: of 1000 random starts none had more than 1e-14 at the
/// start; beside double roots more.
const TRUSTED: [f64; 2] = [3e-13, 1e-12];

/// States that tell which half periods belong to a, and from which α is taken as a mean, where its whole turns are all that is in question as a rule.
const STATES: i32 = 6;

/// How long the trial lasts, in units of the motion.
const TRIAL: f64 = 3.0;

impl Exact {
    /// Roots, band, periods, signs and phases of a start; tried at the start and at a later time against the power series.
    pub fn find(
        constants: &Constants,
        wide: &WidePhase,
        whole: &Carried,
    ) -> Result<(Self, Trial), Reason> {
        let exact = Self::nearest(constants, wide, &whole.0).ok_or(Reason::DoubleRoot)?;
        let c = constants.c.value();
        let path = successors(Some((0.0, *whole)), |(t, here)| {
            let series = Series::<f64, 10>::of(c, here);
            let step = series.reach.min(TRIAL - t);
            (step > 0.0).then(|| (t + step, series.carried(step)))
        });
        let trial: Trial = path.collect();
        let off = |(t, (state, _)): &(f64, Carried)| distance(&exact.state(constants, *t), state);
        let worst = trial.iter().map(off).fold(0.0, f64::max);
        let trusted = (TRUSTED[0] / c.min(1.0)).min(TRUSTED[1]);
        if worst <= trusted {
            Ok((exact, trial))
        } else if exact.separation.narrowest < 1e-2 * c.min(1.0).powi(2) {
            // Weak gravity brings roots together by itself, to some c².
            Err(Reason::DoubleRoot)
        } else {
            Err(Reason::Cancellation(worst))
        }
    }

    fn nearest(constants: &Constants, wide: &WidePhase, start: &Phase) -> Option<Self> {
        let variables = Variables::of(constants, [wide[0], wide[1]]);
        let separation = Separation::prepare(constants, variables.s1)?;
        let curve = Curve::prepare(&separation)?;
        let mut torus = Torus::prepare(&curve, separation.pinched())?;
        let places = separation.places(&variables, constants.l1);
        let [one, two] = separation.phases(places.each_ref());
        let signs = [[0.5, 0.5], [0.5, -0.5], [-0.5, 0.5], [-0.5, -0.5]];
        let origins = signs.map(|[x, y]| [0, 1].map(|i| x * one[i] + y * two[i]));
        let system = Reconstruction::prepare(constants, &separation);
        let factors = torus.constants(&separation);
        let (quotients, origin) = system.fitted(constants, &torus, factors, origins, start)?;
        let closed = separation.touching();
        if closed {
            torus.family.at_double_root(origin);
        }
        Some(Self {
            separation,
            curve,
            torus,
            quotients,
            origin,
            closed,
        })
    }

    /// Phases, halved, that are spread over the torus; on a double root, of times about 0.
    pub fn spread(&self) -> impl Iterator<Item = [f64; 2]> {
        (0..STATES).map(|n| {
            // Multiples of the plastic number's powers spread most evenly.
            let part = |x: f64| (0.1 + f64::from(n) * x).fract();
            if self.closed {
                self.halved(f64::from(n) - 2.5)
            } else {
                [part(0.754_877_666_246_692_7), part(0.569_840_290_998_053_2)]
            }
        })
    }

    pub fn state(&self, constants: &Constants, t: f64) -> Phase {
        self.at_turns(constants, self.halved(t))
    }

    /// Turns of the two phases, halved, from 0 to 1: a state returns when one of these gains 1, or never on a double root.
    pub fn halved(&self, t: f64) -> [f64; 2] {
        let v = [0, 1].map(|i| self.curve.advance[i].times(t) + DoubleDouble::from(self.origin[i]));
        let high = v.map(DoubleDouble::high);
        let whole = match self.torus.family.pinched() {
            Some(functions) if self.closed => functions.whole(high),
            _ => high.map(f64::floor),
        };
        [0, 1].map(|i| (v[i] - DoubleDouble::from(whole[i])).value())
    }

    /// The state where the phases have turned so far, halved.
    pub fn at_turns(&self, constants: &Constants, v: [f64; 2]) -> Phase {
        project(
            constants,
            &self.quotients.state(constants, &self.torus.parts(v)),
        )
    }
}
