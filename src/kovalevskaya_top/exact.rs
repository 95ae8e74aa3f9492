//! Which branch a start lies on, and the trial that decides between her road and the power series.

use super::constants::{Constants, Phase, WidePhase};
use super::separation::{Phases, Separation, Variables};
use super::solution::Reconstruction;
use super::taylor::{Carried, Series, project};

/// Why a motion is integrated and not solved by separation.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Reason {
    /// Two of the five roots coincide, or nearly: s₁ rests on them or comes to them only after infinite time, and a cosine series
    /// would need more than 2¹⁰ terms, or the linear system loses digits.
    DoubleRoot,
    /// The linear system loses digits: her formulas give the start, or the motion some time later, only to this much, in units in
    /// which Ω and √(MgC₁/I₃) are at most of size 2. So it is for gravity that is weak against the spin.
    Cancellation(f64),
}

/// A motion solved by separation.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Exact {
    pub separation: Separation,
    reconstruction: Reconstruction,
    /// a₁−a₂ and b₁−b₂ at time 0.
    origin: [f64; 2],
    /// States with attitudes by power series soon after time 0.
    pub trial: Vec<(f64, Carried)>,
}

/// The largest disagreement with which separation is trusted, over c where that is below 1, and whatever c: of 1000 random starts none had more than 1e-14 at the
/// start.
const TRUSTED: [f64; 2] = [3e-14, 1e-12];

/// How long the trial lasts, in units of the motion.
const TRIAL: f64 = 3.0;

impl Exact {
    /// Roots, band, quadratures, signs and phases of a start; tried at the start and at a later time against the power series.
    pub fn find(constants: &Constants, wide: &WidePhase, whole: &Carried) -> Result<Self, Reason> {
        let variables = Variables::of(constants, wide);
        let separation = Separation::prepare(constants, variables.s1).ok_or(Reason::DoubleRoot)?;
        let mut exact = Self {
            reconstruction: Reconstruction::prepare(constants, &separation.roots),
            separation,
            origin: [0.0; 2],
            trial: Vec::new(),
        };
        let guess = exact.separation.first_phases(&variables, constants.l1);
        let phases = exact.choose_branch(constants, &whole.0, guess);
        exact.origin = exact.separation.abel(phases);
        match tried(constants, whole, |t| exact.state(constants, t)) {
            Ok(trial) => {
                exact.trial = trial;
                Ok(exact)
            }
            Err(_) if exact.separation.narrowest() < 1e-6 => Err(Reason::DoubleRoot),
            Err(worst) => Err(Reason::Cancellation(worst)),
        }
    }

    // ANCHOR: branch
    /// Of the 4 × 8 signs of two phases and three roots, those that give the start back.
    fn choose_branch(&mut self, constants: &Constants, start: &Phase, guess: Phases) -> Phases {
        let mut best = (f64::INFINITY, guess, [1.0; 3]);
        for choice in 0..32 {
            let sign = |bit: u32| if choice >> bit & 1 == 0 { 1.0 } else { -1.0 };
            self.reconstruction.signs = [sign(0), sign(1), sign(2)];
            let phases = [sign(3) * guess[0], sign(4) * guess[1]];
            let state = self
                .reconstruction
                .state(constants, &self.separation, phases);
            let miss = distance(&state, start);
            if miss < best.0 {
                best = (miss, phases, self.reconstruction.signs);
            }
        }
        self.reconstruction.signs = best.2;
        best.1
    }
    // ANCHOR_END: branch

    fn raw(&self, constants: &Constants, phases: Phases) -> Phase {
        self.reconstruction
            .state(constants, &self.separation, phases)
    }

    pub fn phases(&self, t: f64) -> Phases {
        self.separation.phases([self.origin[0], self.origin[1] + t])
    }

    pub fn state(&self, constants: &Constants, t: f64) -> Phase {
        self.state_of_sums(constants, [self.origin[0], self.origin[1] + t])
    }

    /// Turns of the two phases if they advanced evenly, halved, from 0 to 1: a state returns when one of these gains 1.
    pub fn halved(&self, t: f64) -> Phases {
        halved(&self.separation, [self.origin[0], self.origin[1] + t])
    }

    /// The state at these phases and the halved even turns there; none at an instant where the linear system is singular.
    pub fn at_phases(&self, constants: &Constants, phases: Phases) -> Option<(Phase, [f64; 2])> {
        let state = self.raw(constants, phases);
        let known = state.iter().all(|x| x.is_finite());
        known.then(|| {
            let sums = self.separation.abel(phases);
            (project(constants, &state), halved(&self.separation, sums))
        })
    }

    fn state_of_sums(&self, constants: &Constants, sums: [f64; 2]) -> Phase {
        let state = self.raw(constants, self.separation.phases(sums));
        if state.iter().all(|x| x.is_finite()) {
            return project(constants, &state);
        }
        // The linear system is singular at this very instant: from a little earlier by power series.
        const EARLIER: f64 = 0.01;
        let before = self.raw(
            constants,
            self.separation.phases([sums[0], sums[1] - EARLIER]),
        );
        let (state, _) =
            Series::at(constants.c.value(), &(before, [1.0, 0.0, 0.0, 0.0])).after(EARLIER);
        project(constants, &state)
    }
}

fn halved(separation: &Separation, sums: [f64; 2]) -> [f64; 2] {
    separation.normalized(sums).map(|turns| {
        let v = 0.5 * turns;
        v - v.floor()
    })
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
        let series = Series::at(c, &carried);
        let step = series.reach.min(TRIAL - t);
        carried = series.after(step);
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
