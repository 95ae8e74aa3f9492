//! The eight motions, from an ordinary one to those that are hard on a method.

use super::problem::{Problem, Setting};
use super::sample::Sample;
use super::table_top::OnTable;
use super::truth;
use crate::error::Result;
use crate::integrators::geometric::Phase;

/// The names of the problems; each is a family of runs, of 1, 10, … turns, a turn being 2π/|Ω| at the start.
///
/// | name | what makes it hard |
/// |---|---|
/// | `free-top` | nothing: the body of Hairer and Vilmart (2006) |
/// | `near-separatrix` | the period hangs on the logarithm of 6e-8, and what goes wrong at one flip is there at all that follow |
/// | `cusped-top` | the axis comes to rest at every cusp |
/// | `near-sleeping` | upright but for a thousandth, it falls and rises again: near the pole, and near the waking separatrix |
/// | `kovalevskaya` | no axis of symmetry; axis 3 upright at the start, so that two roots of her polynomial are one, and theta functions out of reach |
/// | `kovalevskaya-level` | no axis of symmetry; an ordinary start, axis 3 level |
/// | `heavy-body` | no closed form. Regular: starts 1e-9 apart are 3e-8 apart after 300 turns, in proportion to the time, as on a torus |
/// | `tippe-top` | friction: nothing is kept; a tilt grows until the top stands on its head |
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
    name: &'static str,
    description: &'static str,
    body: Body,
    l: [f64; 3],
    q: [f64; 4],
    runs: &'static [(u32, &'static [truth::Row])],
}

enum Body {
    Top([f64; 3], [f64; 3]),
    Tippe,
}

const LEVEL: [f64; 4] = [1.0, 0.0, 0.0, 0.0];
/// Turns axis 3 into the space axis 1: level.
const ROUND: [f64; 4] = [0.5, 0.5, 0.5, 0.5];

/// Mass, moments, radius, height of the centre over C, gravity, friction of the tippe top.
const TIPPE: (f64, [f64; 3], f64, f64, f64, f64) =
    (0.02, [3e-6, 3e-6, 3.2e-6], 0.02, 0.006, 9.81, 0.3);

static FAMILIES: [Family; 8] = [
    Family {
        name: NAMES[0],
        description: "free, all moments different: the body of Hairer and Vilmart (2006)",
        body: Body::Top([0.6, 0.8, 1.0], [0.0; 3]),
        l: [1.8, 0.4, -0.9],
        q: LEVEL,
        runs: &[
            (1, &truth::FREE_TOP_1),
            (10, &truth::FREE_TOP_10),
            (1000, &truth::FREE_TOP_1000),
            (1_000_000, &truth::FREE_TOP_1000000),
        ],
    },
    Family {
        name: NAMES[1],
        description: "free, 6e-8 beside the separatrix: a racket that flips",
        body: Body::Top([1.5, 3.0, 4.0], [0.0; 3]),
        // 1 + 2⁻²⁴; with 1 it is the separatrix itself.
        l: [1.000_000_059_604_644_8, 1.0, 2.0],
        q: LEVEL,
        runs: &[
            (1, &truth::NEAR_SEPARATRIX_1),
            (10, &truth::NEAR_SEPARATRIX_10),
            (1000, &truth::NEAR_SEPARATRIX_1000),
            (1_000_000, &truth::NEAR_SEPARATRIX_1000000),
        ],
    },
    Family {
        name: NAMES[2],
        description: "Lagrange's top, let go with its axis level and at rest: cusps",
        body: Body::Top([1.0, 1.0, 0.5], [0.0, 0.0, 1.0]),
        l: [0.0, 0.0, 3.0],
        q: ROUND,
        runs: &[
            (1, &truth::CUSPED_TOP_1),
            (10, &truth::CUSPED_TOP_10),
            (1000, &truth::CUSPED_TOP_1000),
            (1_000_000, &truth::CUSPED_TOP_1000000),
        ],
    },
    Family {
        name: NAMES[3],
        description: "Lagrange's top, upright and a little too slow to sleep: it wakes again and again",
        body: Body::Top([1.0, 1.0, 0.5], [0.0, 0.0, 1.0]),
        l: [0.000_976_562_5, 0.0, 1.75],
        q: LEVEL,
        runs: &[
            (1, &truth::NEAR_SLEEPING_1),
            (10, &truth::NEAR_SLEEPING_10),
            (1000, &truth::NEAR_SLEEPING_1000),
            (1_000_000, &truth::NEAR_SLEEPING_1000000),
        ],
    },
    Family {
        name: NAMES[4],
        description: "Kovalevskaya's top, axis 3 upright at the start",
        body: Body::Top([2.0, 2.0, 1.0], [1.0, 0.0, 0.0]),
        l: [1.5, 1.0, 1.25],
        q: LEVEL,
        runs: &[
            (1, &truth::KOVALEVSKAYA_1),
            (10, &truth::KOVALEVSKAYA_10),
            (1000, &truth::KOVALEVSKAYA_1000),
        ],
    },
    Family {
        name: NAMES[5],
        description: "Kovalevskaya's top, axis 3 level at the start",
        body: Body::Top([2.0, 2.0, 1.0], [1.0, 0.0, 0.0]),
        l: [1.5, 1.0, 1.25],
        q: ROUND,
        runs: &[
            (1, &truth::KOVALEVSKAYA_LEVEL_1),
            (10, &truth::KOVALEVSKAYA_LEVEL_10),
            (1000, &truth::KOVALEVSKAYA_LEVEL_1000),
        ],
    },
    Family {
        name: NAMES[6],
        description: "three different moments under gravity, spinning fast: no closed form",
        body: Body::Top([1.0, 1.5, 2.0], [0.25, 0.125, 0.5]),
        l: [0.5, 0.375, 6.0],
        q: ROUND,
        runs: &[
            (1, &truth::HEAVY_BODY_1),
            (10, &truth::HEAVY_BODY_10),
            (1000, &truth::HEAVY_BODY_1000),
        ],
    },
    Family {
        name: NAMES[7],
        description: "a tippe top, sliding until it stands on its head",
        body: Body::Tippe,
        l: [3e-6 * 8.0, 0.0, 3.2e-6 * 155.0],
        q: LEVEL,
        runs: &[
            (1, &truth::TIPPE_TOP_1),
            (10, &truth::TIPPE_TOP_10),
            (100, &truth::TIPPE_TOP_100),
        ],
    },
];

impl Family {
    fn problems(&self) -> Result<Vec<Problem>> {
        let setting = match self.body {
            Body::Top(moments, lever) => Setting::Top { moments, lever },
            Body::Tippe => {
                let (mass, moments, radius, offset, gravity, friction) = TIPPE;
                let table = OnTable::new(mass, moments, radius, offset, gravity, friction)?;
                Setting::Table(table)
            }
        };
        let start = Phase {
            l: self.l,
            q: self.q,
        };
        let run = |&(turns, rows): &(u32, &[truth::Row])| {
            let name = format!("{}/{turns}", self.name);
            let truth = rows.iter().map(sample).collect();
            let description = self.description.to_owned();
            Problem::new(name, description, setting, start, turns.into(), truth)
        };
        self.runs.iter().map(run).collect()
    }
}

/// All problems, each over all its lengths, 28 runs in all.
///
/// # Errors
/// None for these bodies.
pub fn problems() -> Result<Vec<Problem>> {
    let families = FAMILIES.iter().map(Family::problems);
    Ok(families.collect::<Result<Vec<_>>>()?.concat())
}

/// The problems of this name: `free-top` for all its lengths, `free-top/1000` for one; none if there is no such name.
///
/// # Errors
/// As for [`problems`].
pub fn named(name: &str) -> Result<Vec<Problem>> {
    let mut all = problems()?;
    all.retain(|p| p.name() == name || p.name().split('/').next() == Some(name));
    Ok(all)
}

fn sample(row: &truth::Row) -> Sample {
    let pair = |n: usize| [row[1 + 2 * n], row[2 + 2 * n]];
    Sample::new(
        row[0],
        [pair(0), pair(1), pair(2)],
        [pair(3), pair(4), pair(5), pair(6)],
    )
}
