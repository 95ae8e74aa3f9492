//! The eight motions, from an ordinary one to those that are hard for a method.

use spinning_bodies::integrators::geometric::Phase;
use spinning_bodies::{Error, Result};

use super::problem::{Model, Problem};
use super::sample::Sample;
use super::table_top::SlidingBall;
use crate::table;

/// Rows of problem and length, time, attitude and angular velocity: the samples of the truth.
const TRUTH: &str = include_str!("../../../tests/reference/accuracy.csv");

/// The names of the problems; each is a family of runs, of 1, 10, … turns, a turn being 2π/|Ω| at the start.
///
/// | name | what makes it hard |
/// |---|---|
/// | `free-top` | nothing: the body of Hairer and Vilmart (2006) |
/// | `near-separatrix` | the period depends on the logarithm of 6e-8, and an error at one flip persists through all that follow |
/// | `cusped-top` | the axis comes to rest at every cusp |
/// | `near-sleeping` | within a thousandth of upright, it falls and rises again: near the pole, and near the separatrix |
/// | `kovalevskaya` | no axis of symmetry; axis 3 upright at the start, so that two roots of Kovalevskaya's polynomial coincide |
/// | `kovalevskaya-level` | no axis of symmetry; an ordinary start, axis 3 level |
/// | `heavy-body` | no closed form. Regular: starts 1e-9 apart are 3e-8 apart after 300 turns, in proportion to the time, as on a torus |
/// | `tippe-top` | friction: neither energy nor L is conserved; a tilt grows until the top stands inverted |
pub const NAMES: [&str; 8] = [
    "free-top",
    "near-separatrix",
    "cusped-top",
    "near-sleeping",
    "kovalevskaya",
    "kovalevskaya-level",
    "heavy-body",
    "tippe-top",
];

/// One problem over all its lengths. L, moments and lever are exact doubles, the quaternions exactly of length 1.
struct Family {
    description: &'static str,
    model: Model,
    l: [f64; 3],
    q: [f64; 4],
}

const LEVEL: [f64; 4] = [1.0, 0.0, 0.0, 0.0];
/// Turns axis 3 into the space axis 1: level.
const ROUND: [f64; 4] = [0.5, 0.5, 0.5, 0.5];

const fn top(moments: [f64; 3], lever: [f64; 3]) -> Model {
    Model::Top { moments, lever }
}

/// Families in the order of the names.
const FAMILIES: [Family; 8] = [
    Family {
        description: "free, all moments different: the body of Hairer and Vilmart (2006)",
        model: top([0.6, 0.8, 1.0], [0.0; 3]),
        l: [1.8, 0.4, -0.9],
        q: LEVEL,
    },
    Family {
        description: "free, 6e-8 beside the separatrix: a racket that flips",
        model: top([1.5, 3.0, 4.0], [0.0; 3]),
        // 1 + 2⁻²⁴; with 1 it is the separatrix itself.
        l: [1.000_000_059_604_644_8, 1.0, 2.0],
        q: LEVEL,
    },
    Family {
        description: "Lagrange's top, let go with its axis level and at rest: cusps",
        model: top([1.0, 1.0, 0.5], [0.0, 0.0, 1.0]),
        l: [0.0, 0.0, 3.0],
        q: ROUND,
    },
    Family {
        description: "Lagrange's top, upright and a little too slow to sleep: it wakes again and again",
        model: top([1.0, 1.0, 0.5], [0.0, 0.0, 1.0]),
        l: [0.000_976_562_5, 0.0, 1.75],
        q: LEVEL,
    },
    Family {
        description: "Kovalevskaya's top, axis 3 upright at the start",
        model: top([2.0, 2.0, 1.0], [1.0, 0.0, 0.0]),
        l: [1.5, 1.0, 1.25],
        q: LEVEL,
    },
    Family {
        description: "Kovalevskaya's top, axis 3 level at the start",
        model: top([2.0, 2.0, 1.0], [1.0, 0.0, 0.0]),
        l: [1.5, 1.0, 1.25],
        q: ROUND,
    },
    Family {
        description: "three different moments under gravity, spinning fast: no closed form",
        model: top([1.0, 1.5, 2.0], [0.25, 0.125, 0.5]),
        l: [0.5, 0.375, 6.0],
        q: ROUND,
    },
    Family {
        description: "a tippe top, sliding until it stands on its head",
        model: Model::Table(SlidingBall::TIPPE_TOP),
        l: [3e-6 * 8.0, 0.0, 3.2e-6 * 155.0],
        q: LEVEL,
    },
];

/// All problems, each over all its lengths, 28 runs in all.
///
/// # Errors
/// None for these bodies; those of the reference table, should a line be invalid.
pub fn problems() -> Result<Vec<Problem>> {
    read(|_| true)
}

/// The problems of this name: `free-top` for all its lengths, `free-top/1000` for one; an empty list if there is no such name.
///
/// # Errors
/// Those of [`problems`].
pub fn named(name: &str) -> Result<Vec<Problem>> {
    read(|run| run == name || run.split('/').next() == Some(name))
}

/// The problems with these names and lengths, in the order of the table.
fn read(wanted: impl Fn(&str) -> bool) -> Result<Vec<Problem>> {
    let samples = table::rows(TRUTH, wanted, |cells: [&'static str; 9]| {
        let [run, time, numbers @ ..] = cells;
        let [w, x, y, z, o1, o2, o3] = numbers.map(table::decimal);
        let (attitude, omega) = ([w?, x?, y?, z?], [o1?, o2?, o3?]);
        Ok((run, Sample::new(table::exact(time)?, omega, attitude)))
    })?;
    let runs = samples.chunk_by(|a, b| a.0 == b.0);
    runs.map(|samples| problem(samples[0].0, samples.iter().map(|(_, s)| *s).collect()))
        .collect()
}

/// The problem of this name and length, `free-top/1000`.
fn problem(run: &str, truth: Vec<Sample>) -> Result<Problem> {
    let (name, turns) = run.split_once('/').unwrap_or((run, ""));
    let family = NAMES.iter().zip(FAMILIES).find(|(n, _)| **n == name);
    let (Some((_, family)), Ok(turns)) = (family, turns.parse()) else {
        return Err(Error::Empty {
            quantity: "the list of problems of a name in the table",
        });
    };
    let start = Phase {
        l: family.l,
        q: family.q,
    };
    Ok(Problem::new(run, family.model, start, turns, truth)?.described(family.description))
}
