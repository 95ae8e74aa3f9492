//! Ω and z by separation, and the trial that decides between it and the power series.

use core::iter::successors;

use super::constants::{Constants, Phase, WidePhase};
use super::periods::Curve;
use super::separation::{Separation, Variables};
use super::solution::{Quotients, Reconstruction, Torus, distance};
use super::taylor::{FullState, full_state, project, series};
use crate::precise::{DoubleDouble, Number};

/// Why a motion is followed by power series and not solved by separation.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Reason {
    /// Two of the five roots coincide, or nearly: s₁ rests on them or reaches them only after infinite time, or the linear system loses digits.
    DoubleRoot,
    /// The linear system loses digits, as it does if gravity is weak compared with the spin: the formulas reproduce the start, or the motion some time
    /// later, only to this error, in units in which Ω and √(MgC₁/I₃) are at most of size 2.
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
    /// Whether two roots coincide between which s₁ or s₂ passes, so that the motion is not periodic in the phases.
    pub closed: bool,
}

/// States with attitudes by power series from time 0 on.
pub(super) type Trial = Vec<(f64, FullState)>;

/// The greatest disagreement up to which separation is trusted: the first divided by c where c < 1, the second for all c. Of 1000 random starts none had more than 1e-14 at the
/// start; near double roots some had more.
const TRUSTED: [f64; 2] = [3e-13, 1e-12];

/// Number of states that decide which half periods belong to a, and over which α is averaged, usually only to find its whole turns.
const STATES: i32 = 6;

/// How long the trial lasts, in units of the motion.
const TRIAL: f64 = 3.0;

impl Exact {
    /// The solution of a start, tried at the start and at later times against the power series.
    pub fn find(
        constants: &Constants,
        wide: &WidePhase,
        whole: &FullState,
    ) -> Result<(Self, Trial), Reason> {
        let exact = Self::nearest(constants, wide, &whole.0).ok_or(Reason::DoubleRoot)?;
        let c = constants.c.value();
        let path = successors(Some((0.0, *whole)), |(t, here)| {
            let series = series(c, here);
            let step = series.reach.min(TRIAL - t);
            (step > 0.0).then(|| (t + step, full_state(&series, step)))
        });
        let trial: Trial = path.collect();
        let off = |(t, (state, _)): &(f64, FullState)| distance(&exact.state(constants, *t), state);
        let worst = trial.iter().map(off).fold(0.0, f64::max);
        let trusted = (TRUSTED[0] / c.min(1.0)).min(TRUSTED[1]);
        if worst <= trusted {
            Ok((exact, trial))
        } else if exact.separation.narrowest < 1e-2 * c.min(1.0).powi(2) {
            // Weak gravity alone brings roots together, to a distance of order c².
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
        let places = separation.places(&variables, constants, wide);
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

    /// Sample phases, halved: spread over the torus, or on a double root those of times about 0.
    pub fn spread(&self) -> impl Iterator<Item = [f64; 2]> {
        (0..STATES).map(|n| {
            // Multiples of inverse powers of the plastic number are spread most evenly.
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

    /// Turns of the two phases at time `t`, halved and reduced to 0…1: a state returns when one of them gains 1, or never on a double root.
    pub fn halved(&self, t: f64) -> [f64; 2] {
        let v = [0, 1].map(|i| self.curve.advance[i].times(t) + DoubleDouble::from(self.origin[i]));
        let high = v.map(DoubleDouble::high);
        let whole = match self.torus.family.pinched() {
            Some(functions) if self.closed => functions.whole(high),
            _ => high.map(f64::floor),
        };
        [0, 1].map(|i| (v[i] - DoubleDouble::from(whole[i])).value())
    }

    /// The state at the phases v, halved.
    pub fn at_turns(&self, constants: &Constants, v: [f64; 2]) -> Phase {
        project(
            constants,
            &self.quotients.state(constants, &self.torus.parts(v)),
        )
    }
}
