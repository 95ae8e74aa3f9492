//! Random scenes of the kinds that are no tops, and the truth about each.

mod bouncing;
mod rolling;
mod shapes;
mod strip;
mod struck;
mod table_top;
mod yo_yo;

use super::door::{self, Answer};
use super::random::Random;
use super::verdict::{self, Given, Outcome};
use core::fmt;
use support::double_double::Dd;
use support::{greatest, multiplied};

/// What a column measures; the errors of all of one sort are judged by the greatest of them that the motion has, or by the size that they naturally
/// have for such a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sort {
    Length,
    Speed,
    /// Radians, as they are.
    Angle,
    Rate,
    Energy,
    Momentum,
    /// The first of four: a quaternion, judged by the angle between the attitudes.
    Attitude,
}

/// The rows at these times (s, ascending), from a start that is these numbers.
pub type Truth = dyn Fn(&[Dd], &[f64]) -> Vec<Vec<Dd>> + Send + Sync;

/// A scene without its times.
pub struct Scene {
    /// The scene file but for `[run]`.
    pub text: String,
    /// The longest time to be asked for, s.
    pub span: f64,
    /// The numbers of the start, and the size against which a change of each is small.
    pub start: Vec<(f64, f64)>,
    /// Natural sizes: a length of the body, the rate at which it would swing or fall.
    pub sizes: Vec<(Sort, f64)>,
    /// What the truth tells, by the names of the columns; an attitude is `qw`, with three more after it.
    pub columns: Vec<(&'static str, Sort)>,
    pub truth: Box<Truth>,
}

/// Columns by what they measure: `length x y, speed vx vy`.
fn told(groups: &'static str) -> Vec<(&'static str, Sort)> {
    let columns = |group: &'static str| {
        let mut names = group.split(' ');
        let sort = match names.next() {
            Some("length") => Sort::Length,
            Some("speed") => Sort::Speed,
            Some("angle") => Sort::Angle,
            Some("rate") => Sort::Rate,
            Some("energy") => Sort::Energy,
            Some("momentum") => Sort::Momentum,
            Some("attitude") => Sort::Attitude,
            other => panic!("{other:?} is no sort"),
        };
        names.map(move |name| (name, sort))
    };
    groups.split(", ").flat_map(columns).collect()
}

/// A line of the scene file, if there is a value.
pub fn line<T: fmt::Debug>(text: &mut String, key: &str, value: Option<T>) {
    if let Some(value) = value {
        *text += &format!("{key} = {value:?}\n");
    }
}

/// A scene and what is asked of it.
pub struct Case {
    scene: Scene,
    times: Vec<f64>,
    accuracy: f64,
}

type Kind = fn(&mut Random) -> Scene;

/// The strata and how many scenes there are of each: 1,000.
pub const STRATA: [(&str, usize, Kind); 24] = [
    ("roller", 60, rolling::roller),
    ("roller on a sheet", 50, rolling::sheet),
    ("spool", 60, rolling::spool),
    ("superball, elastic", 50, |r| bouncing::thrown(r, false)),
    ("superball, with losses", 70, |r| bouncing::thrown(r, true)),
    ("yo-yo", 40, |r| yo_yo::play(r, None)),
    ("yo-yo in air", 40, |r| yo_yo::play(r, Some([1e-5, 0.1]))),
    ("swivel", 30, |r| shapes::swivelling(r, false)),
    ("swivel with friction", 40, |r| shapes::swivelling(r, true)),
    ("skater", 30, |r| shapes::skating(r, false)),
    ("skater with friction", 40, |r| shapes::skating(r, true)),
    ("cat of equal halves", 30, |r| shapes::cat(r, true)),
    ("cat of unequal halves", 40, |r| shapes::cat(r, false)),
    ("paper cat", 60, shapes::paper_cat),
    ("crawler", 60, shapes::crawler),
    ("strip in a vacuum", 20, |r| strip::falling(r, false)),
    ("strip in air", 80, |r| strip::falling(r, true)),
    ("meteorite", 40, struck::meteorite),
    ("table top without friction", 40, |r| table_top::put(r, 0)),
    ("table top, viscous or smoothed", 50, |r| {
        table_top::put(r, 1)
    }),
    ("table top, rolling", 30, |r| table_top::put(r, 2)),
    ("table top, a ball by Coulomb's law", 10, table_top::ball),
    ("table top without gravity", 10, table_top::free),
    ("yo-yo in honey", 20, |r| yo_yo::play(r, Some([3.0, 100.0]))),
];

/// One case of one stratum.
pub fn case(stratum: usize, number: usize) -> Case {
    let mut random = Random::of(100 + stratum, number);
    let scene = STRATA[stratum].2(&mut random);
    let span = scene.span;
    let times = match random.whole(10) {
        0..6 => vec![span],
        6..8 => (0..2 + random.whole(5))
            .map(|_| span * random.within(0.0, 1.0))
            .collect(),
        8 => (1..=20).map(|k| span * f64::from(k) / 20.0).collect(),
        _ => vec![0.0, span, 0.3 * span],
    };
    Case {
        scene,
        times,
        accuracy: random.accuracy(),
    }
}

impl Case {
    pub fn text(&self) -> String {
        let (times, accuracy) = (&self.times, self.accuracy);
        format!(
            "{}[run]\ntimes = {times:?}\naccuracy = {accuracy:?}\n",
            self.scene.text
        )
    }

    /// Rows in the order of the times, and the scale of each column.
    fn truth(&self, start: &[Dd]) -> (Vec<Vec<Dd>>, Vec<f64>) {
        // Some more times tell how great each quantity becomes.
        let last = self.times.iter().fold(0.0, |a: f64, &b| a.max(b));
        let mut all: Vec<f64> = (0..=8).map(|k| last * f64::from(k) / 8.0).collect();
        all.extend(&self.times);
        all.sort_by(f64::total_cmp);
        all.dedup();
        let rows = (self.scene.truth)(start, &all);
        let most = |sort: Sort| {
            let places = (0..self.scene.columns.len()).filter(|&k| self.scene.columns[k].1 == sort);
            let sizes = places.flat_map(|k| rows.iter().map(move |row| row[k].value().abs()));
            let natural = self.scene.sizes.iter().filter(|size| size.0 == sort);
            let sizes = sizes.chain(natural.map(|size| size.1));
            sizes.fold(f64::MIN_POSITIVE, f64::max)
        };
        let scales = self.scene.columns.iter().map(|(_, sort)| match sort {
            Sort::Angle | Sort::Attitude => 1.0,
            sort => most(*sort),
        });
        let at = |t: &f64| all.iter().position(|x| x == t).expect("among them");
        let asked = self.times.iter().map(|t| rows[at(t)].clone()).collect();
        (asked, scales.collect())
    }

    /// The most by which rows are apart.
    fn apart(&self, a: &[Vec<Dd>], b: &[Vec<Dd>], scales: &[f64]) -> f64 {
        let columns = &self.scene.columns;
        let apart = |(a, b): (&Vec<Dd>, &Vec<Dd>)| {
            let mut worst = 0.0_f64;
            let mut k = 0;
            while k < columns.len() {
                let off = if columns[k].1 == Sort::Attitude {
                    k += 3;
                    turn(&a[k - 3..=k], &b[k - 3..=k])
                } else {
                    (a[k] - b[k]).value().abs() / scales[k]
                };
                worst = greatest([worst, off]);
                k += 1;
            }
            worst
        };
        greatest(a.iter().zip(b).map(apart))
    }

    pub fn judged(&self) -> Outcome {
        let start: Vec<Dd> = self.scene.start.iter().map(|&(x, _)| Dd::from(x)).collect();
        let (truth, scales) = self.truth(&start);
        let given = match door::simulate(&self.text()) {
            Answer::Refused(why) => Given::Refused {
                growth: self.growth(&truth, &scales),
                why,
            },
            Answer::Motion(motion) => {
                let names: Vec<&str> = self.scene.columns.iter().map(|column| column.0).collect();
                let rows = motion.rows(&names);
                Given::Answer(verdict::Answer {
                    error: self.apart(&rows, &truth, &scales),
                    estimate: motion.estimate,
                    evaluations: motion.evaluations,
                    cheapest: None,
                    solver: motion.solver,
                })
            }
        };
        Outcome {
            accuracy: self.accuracy,
            known: false,
            given,
        }
    }

    /// By how much a small change of one number of the start grows.
    fn growth(&self, truth: &[Vec<Dd>], scales: &[f64]) -> f64 {
        const BESIDE: f64 = 1e-16;
        let numbers = &self.scene.start;
        let grown = (0..numbers.len()).map(|k| {
            let mut start: Vec<Dd> = numbers.iter().map(|&(x, _)| Dd::from(x)).collect();
            start[k] = start[k] + BESIDE * numbers[k].1;
            let (rows, _) = self.truth(&start);
            self.apart(&rows, truth, scales) / BESIDE
        });
        grown.fold(1.0, f64::max)
    }
}

/// The angle between two attitudes.
fn turn(a: &[Dd], b: &[Dd]) -> f64 {
    let unit = |q: &[Dd]| {
        let size = q.iter().map(|&x| x * x).sum::<Dd>().sqrt();
        core::array::from_fn(|k| q[k] / size)
    };
    let [w, x, y, z] = unit(b);
    let [even, x, y, z] = multiplied(unit(a), [w, -x, -y, -z]).map(Dd::value);
    2.0 * x.hypot(y).hypot(z).atan2(even.abs())
}
