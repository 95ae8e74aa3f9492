//! A scene file as a problem: a top without losses, judged by a run in two words, or by its closed form.

use std::path::Path;

use lab::accuracy::{ClosedForm, Model, Problem, Sample};
use spinning_bodies::integrators::Effort;
use spinning_bodies::integrators::geometric::{
    Follow, HeavySplitting, Integrator, Order, Phase, Real, Rotations, TwoWords, Weight,
};
use spinning_bodies::scene::files::parse_top;

use crate::scenes;
use crate::{Error, Result};

/// The motion that a scene file describes, from its start to its last time.
///
/// # Errors
/// [`Error::Input`] for a file that is not the scene of a top without losses, or one that ends where it begins.
pub fn problem(file: &Path) -> Result<Problem> {
    let (name, text) = scenes::source(file)?;
    let (top, request) = parse_top(&name, &text)?;
    let refused = |key, told| Error::Input(format!("{name}: key `{key}` {told}"));
    if let Some(loss) = top.resisting().next() {
        let told = "in [effects] is a loss; tops are measured without";
        return Err(refused(loss, told));
    }
    let (moments, lever) = (top.moments(), top.lever().map(|x| x + 0.0));
    let end = request.times().iter().fold(0.0_f64, |a, b| a.max(*b));
    if end <= 0.0 {
        let told = "in [run] must be positive for a motion to be measured";
        return Err(refused("until", told));
    }
    let told = |error: spinning_bodies::Error| Error::Input(format!("{name}: {error}"));
    let start = top.phase().map_err(told)?;
    let omega = (0..3)
        .map(|k| start.l[k] / moments[k])
        .fold(0.0, f64::hypot);
    let turns = (omega * end / std::f64::consts::TAU).max(1.0);
    let samples = truth((moments, lever), &start, end, turns).map_err(told)?;
    let stem = file
        .file_stem()
        .map_or(name.clone(), |s| s.to_string_lossy().into_owned());
    let top = Model::Top { moments, lever };
    Problem::new(stem, top, start, turns.round(), samples).map_err(told)
}

type Body = ([f64; 3], [f64; 3]);

/// Sixteen samples: by a splitting of order 6 in two words if that takes seconds; otherwise by the closed form, if there is one.
fn truth(
    (moments, lever): Body,
    start: &Phase,
    end: f64,
    turns: f64,
) -> spinning_bodies::Result<Vec<Sample>> {
    let times: Vec<f64> = (1..=16).map(|k| end * f64::from(k) / 16.0).collect();
    let judged = |phases: &[Phase<TwoWords>]| {
        let pairs = times.iter().zip(phases);
        pairs
            .map(|(&t, phase)| Sample::of_phase(t, phase, moments))
            .collect()
    };
    match two_words((moments, lever), start, end, turns) {
        Ok(phases) => Ok(judged(&phases)),
        Err(error) => {
            let exact = ClosedForm::new(moments, lever).map_err(|_| error)?;
            let course = exact.follow(start, &times, Effort::Tolerance(0.0))?;
            let phases: Vec<_> = course.phases.iter().map(Phase::cast).collect();
            Ok(judged(&phases))
        }
    }
}

/// Most steps of a run in two words: some seconds of computing.
const MOST_STEPS: u64 = 300_000;

/// Steps are halved until the last two runs agree to 1e-16, the better one thereby to 2e-18.
fn two_words(
    (moments, lever): Body,
    start: &Phase,
    end: f64,
    turns: f64,
) -> spinning_bodies::Result<Vec<Phase<TwoWords>>> {
    let drift = Rotations::new(moments, Order::Six)?;
    let method = HeavySplitting::new(drift, Weight::new(lever)?, Order::Six);
    let run = |steps: u64| -> spinning_bodies::Result<Vec<Phase<TwoWords>>> {
        let mut phase: Phase<TwoWords> = start.cast();
        let parts = TwoWords::from_double(16.0 * steps as f64).reciprocal();
        let mut phases = Vec::new();
        for _ in 0..16 {
            method.advance(&mut phase, TwoWords::from_double(end) * parts, steps)?;
            phases.push(phase);
        }
        Ok(phases)
    };
    let (mut before, mut reached) = (None, f64::INFINITY);
    let mut steps = (turns * 4.0).ceil() as u64;
    while steps <= MOST_STEPS / 16 {
        let now = run(steps)?;
        if let Some(before) = before {
            reached = apart(before, &now);
            if reached < 1e-16 {
                return Ok(now);
            }
        }
        (before, steps) = (Some(now), 2 * steps);
    }
    Err(spinning_bodies::Error::Accuracy {
        asked: 1e-16,
        reached,
    })
}

/// The largest difference of two runs, of L relative.
fn apart(a: Vec<Phase<TwoWords>>, b: &[Phase<TwoWords>]) -> f64 {
    let gaps = a.iter().zip(b).map(|(a, b)| {
        let size =
            b.l.iter()
                .map(|x| x.to_double())
                .fold(f64::MIN_POSITIVE, f64::hypot);
        let l = (0..3).map(|k| (a.l[k] - b.l[k]).to_double().abs() / size);
        let q = (0..4).map(|k| (a.q[k] - b.q[k]).to_double().abs());
        l.chain(q).fold(0.0, f64::max)
    });
    gaps.fold(0.0, f64::max)
}
