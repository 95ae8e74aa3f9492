//! Scans: one scene file with some of its numbers varied over a grid, on all cores.

use std::collections::BTreeSet;
use std::f64::consts::{PI, TAU};
use std::path::Path;

use figures::Figure;
use figures::own::{Quantity, diagram, map};
use serde_json::{Value as Json, json};
use spinning_bodies::scene::{Column, files};

use super::output::Format;
use super::plot::quantity;
use super::{Motion, source, stem};
use crate::progress::on_all_processors;
use crate::writer::tell;
use crate::{Error, Result, error::one_line};

/// Numbers of a scene file that run through their ranges together: `initial.omega.2=50..200:16`.
#[derive(Debug, Clone, PartialEq)]
pub struct Over {
    /// The path of each number, and the ends of its range.
    ranges: Vec<(String, f64, f64)>,
    count: usize,
    /// Equal ratios instead of equal differences.
    logarithmic: bool,
}

/// Most scenes of a scan, and fields of a map.
const MOST: usize = 1_000_000;
const MOST_FIELDS: usize = 10_000;

/// The numbers that an option varies.
///
/// # Errors
/// What is expected.
pub fn over(text: &str) -> std::result::Result<Over, String> {
    let refused = |told: &str| Err(format!("`{text}` {told}"));
    let Some(over) = Over::read(text).filter(|over| (1..=MOST).contains(&over.count)) else {
        return refused(
            "should look like initial.omega.2=50..200:16: a number of the file, its range, and how many values, at most a million; add :log for equal ratios, or write KEY=FROM..TO,KEY=FROM..TO:16 for numbers that vary together",
        );
    };
    if over.count == 1 && over.ranges.iter().any(|(_, from, to)| from != to) {
        return refused("asks for a single value, but its range has different ends");
    }
    let one_sign = |(_, a, b): &(_, f64, f64)| a.min(*b) > 0.0 || a.max(*b) < 0.0;
    if over.logarithmic && !over.ranges.iter().all(one_sign) {
        return refused("asks for equal ratios: both ends must be positive, or both negative");
    }
    Ok(over)
}

/// A finite number in an option.
fn finite(text: &str) -> Option<f64> {
    text.parse().ok().filter(|number: &f64| number.is_finite())
}

/// Rounded to fifteen digits, so that a tenth is 0.1 and not an ulp less.
fn rounded(value: f64) -> f64 {
    format!("{value:.14e}").parse().unwrap_or(value)
}

impl Over {
    fn read(text: &str) -> Option<Self> {
        let bare = text.strip_suffix(":log");
        let (rest, count) = bare.unwrap_or(text).rsplit_once(':')?;
        let range = |text: &str| {
            let (path, range) = text.split_once('=')?;
            let (from, to) = range.split_once("..")?;
            // Three dots are ambiguous, because one of them may be a decimal point.
            let path = Some(path.trim()).filter(|path| !path.is_empty() && !to.starts_with('.'))?;
            Some((path.to_owned(), finite(from.trim())?, finite(to.trim())?))
        };
        Some(Self {
            ranges: rest.split(',').map(range).collect::<Option<_>>()?,
            count: count.trim().parse().ok()?,
            logarithmic: bare.is_some(),
        })
    }

    fn paths(&self) -> impl Iterator<Item = &str> {
        self.ranges.iter().map(|(path, ..)| path.as_str())
    }

    /// The values at a place of the grid; the ends are exact.
    fn values(&self, place: usize) -> impl Iterator<Item = f64> {
        let part = place as f64 / (self.count - 1).max(1) as f64;
        let value = move |from: f64, to: f64| match part {
            0.0 => from,
            1.0 => to,
            _ if self.logarithmic => {
                let [near, far] = [from, to].map(|end| end.abs().log10());
                rounded(10_f64.powf(near + (far - near) * part)).copysign(from)
            }
            _ if (to - from).is_finite() => rounded(from + (to - from) * part),
            _ => from * (1.0 - part) + to * part,
        };
        let ranges = self.ranges.iter();
        ranges.map(move |(_, from, to)| value(*from, *to))
    }
}

/// A number asked of a column: `greatest:tilt`, `crossing:tilt=1.5`; a column alone stands for its last value.
#[derive(Debug, Clone, PartialEq)]
pub struct Tell {
    column: String,
    what: What,
    /// The heading of its numbers.
    head: String,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum What {
    First,
    Last,
    Least,
    Greatest,
    /// The time at which it first reaches this level, s.
    Crossing(f64),
}

impl Tell {
    fn read(text: &str) -> Option<Self> {
        let (what, column) = text.split_once(':').unwrap_or(("last", text));
        let (column, what) = match (what, column.split_once('=')) {
            ("first", None) => (column, What::First),
            ("last", None) => (column, What::Last),
            ("least", None) => (column, What::Least),
            ("greatest", None) => (column, What::Greatest),
            ("crossing", Some((column, level))) => (column, What::Crossing(finite(level)?)),
            _ => return None,
        };
        let head = match what {
            What::Last => column.to_owned(),
            What::Crossing(level) => format!("crossing:{column}={level:?}"),
            _ => text.to_owned(),
        };
        let column = column.to_owned();
        (!column.is_empty()).then_some(Self { column, what, head })
    }
}

/// The number that an option asks for.
///
/// # Errors
/// What is expected.
pub fn asked(text: &str) -> std::result::Result<Tell, String> {
    Tell::read(text).ok_or_else(|| {
        format!(
            "`{text}` should be a column, or first:, last:, least: or greatest: before a column, or crossing:COLUMN=LEVEL for the time at which it reaches the level"
        )
    })
}

/// A scan to be run.
#[derive(Debug)]
pub struct Scan {
    name: String,
    text: String,
    overs: Vec<Over>,
    /// The numbers asked of a motion.
    tells: Vec<Tell>,
    /// The columns of a row after the time.
    columns: Vec<Column>,
}

/// The numbers asked of a point, `None` for one that does not exist; or the error of its motion.
type Outcome = Result<Vec<Option<f64>>>;

/// The varied numbers of a point, and their outcome.
type Point = (Vec<f64>, Outcome);

impl Scan {
    /// The scan of a file; if `tells` is empty, the last row of each motion is given.
    ///
    /// # Errors
    /// [`Error::Input`] for a file that is not a scene, a number or a column that it does not have, a number that is to be varied twice, and more than a
    /// million points.
    pub fn new(path: &Path, overs: Vec<Over>, mut tells: Vec<Tell>) -> Result<Self> {
        let (name, text) = source(path)?;
        let motion = Motion::of(&name, &text)?;
        let refused = |told: String| Err(Error::Input(format!("{name}: {told}")));
        let mut all = BTreeSet::new();
        for path in overs.iter().flat_map(Over::paths) {
            set(&name, &text, path, 0.0)?;
            if !all.insert(path.to_owned()) {
                return refused(format!("--over: `{path}` is given twice"));
            }
        }
        if let Some(tell) = tells.iter().find(|tell| !all.insert(tell.head.clone())) {
            return refused(format!("--tell: `{}` is given twice", tell.head));
        }
        let counts = overs.iter().map(|over| over.count);
        if counts.fold(1_usize, usize::saturating_mul) > MOST {
            return refused(format!("a scan may have at most {MOST} points"));
        }
        let named: BTreeSet<&str> = tells.iter().map(|tell| tell.column.as_str()).collect();
        let motion = motion.telling("--tell, --plot", &Vec::from_iter(named))?;
        let columns: Vec<Column> = motion.scene.told().collect();
        if tells.is_empty() {
            let names = columns.iter().map(|column| column.name);
            tells.extend(std::iter::once("t").chain(names).filter_map(Tell::read));
        }
        Ok(Self {
            name,
            text,
            overs,
            tells,
            columns,
        })
    }

    /// Number of points of the grid.
    pub fn points(&self) -> usize {
        self.overs.iter().map(|over| over.count).product()
    }

    /// The varied numbers of a point; those named last run fastest.
    fn varied(&self, mut point: usize) -> Vec<f64> {
        let mut varied = Vec::new();
        for over in self.overs.iter().rev() {
            varied.splice(0..0, over.values(point % over.count));
            point /= over.count;
        }
        varied
    }

    fn paths(&self) -> impl Iterator<Item = &str> {
        self.overs.iter().flat_map(Over::paths)
    }

    fn outcome(&self, varied: &[f64]) -> Outcome {
        let mut text = self.text.clone();
        for (path, &value) in self.paths().zip(varied) {
            text = set(&self.name, &text, path, value)?;
        }
        let names: Vec<&str> = self.columns.iter().map(|column| column.name).collect();
        let motion = Motion::of(&self.name, &text)?.telling("--tell, --plot", &names)?;
        let table = motion.at(motion.request.times())?;
        let mut rows: Vec<(f64, Vec<f64>)> = table.rows().collect();
        rows.sort_by(|a, b| a.0.total_cmp(&b.0));
        let told = |tell: &Tell| {
            // Only the time is no column.
            let place = names.iter().position(|name| *name == tell.column);
            let number = |(t, row): &(f64, Vec<f64>)| place.map_or(*t, |place| row[place]);
            let mut numbers = rows.iter().map(number);
            Ok(match tell.what {
                What::First => numbers.next(),
                What::Last => numbers.next_back(),
                What::Least => numbers.reduce(f64::min),
                What::Greatest => numbers.reduce(f64::max),
                What::Crossing(level) => {
                    let rows = rows.iter().map(|row| [row.0, number(row)]);
                    crossing(&motion, &tell.column, level, &rows.collect::<Vec<_>>())?
                }
            })
        };
        self.tells.iter().map(told).collect()
    }

    /// The headings of all numbers: the varied ones, then those asked for.
    fn heads(&self) -> Vec<String> {
        let told = self.tells.iter().map(|tell| tell.head.clone());
        self.paths().map(str::to_owned).chain(told).collect()
    }

    /// Runs the scene at every point of the grid, on all cores; the result is an error if no point could be run. `done` is called after each.
    /// Warnings go to standard error.
    fn ran(&self, done: impl Fn() + Sync) -> (Vec<Point>, Result<()>) {
        self.warn();
        let points: Vec<Point> = on_all_processors(self.points(), |point| {
            let varied = self.varied(point);
            let outcome = self.outcome(&varied);
            done();
            (varied, outcome)
        });
        let refusals = || points.iter().filter_map(|point| point.1.as_ref().err());
        let (refused, all) = (refusals().count(), points.len());
        let ran = match refusals().next() {
            None => Ok(()),
            Some(first) if refused == all => Err(Error::Failed(format!(
                "no point of the scan could be run; the first error: {first}"
            ))),
            Some(first) => {
                tell(one_line(&format!(
                    "warning: {refused} of {all} points are refused; the first error: {first}"
                )));
                Ok(())
            }
        };
        (points, ran)
    }

    /// Runs the scan and returns its output, and an error if no point could be run. `done` is called after each point.
    ///
    /// CSV: a line for each point, with the varied numbers, the numbers asked for, and `ok` or the reason for their absence. JSON: an object with the rows, and
    /// separately the refused points.
    pub fn run(&self, format: Format, done: impl Fn() + Sync) -> (String, Result<()>) {
        let (points, ran) = self.ran(done);
        let text = match format {
            Format::Csv => self.csv(&points),
            Format::Json => self.json(&points),
        };
        (text, ran)
    }

    /// Runs the scan and draws the first number asked for: a line over one range, a map over two.
    ///
    /// # Errors
    /// [`Error::Input`] for more ranges, one without extent or too large a map, [`Error::Failed`] if no point could be run or has the number.
    pub fn picture(&self, done: impl Fn() + Sync) -> Result<Figure> {
        let refused = |told: String| Err(Error::Input(format!("--plot: {told}")));
        let count = self.points();
        match self.overs.len() {
            2 if count > MOST_FIELDS => {
                let most = format!("expected at most {MOST_FIELDS} points for a map");
                return refused(format!("{most}, got {count}"));
            }
            1 | 2 => (),
            more => return refused(format!("expected one --over, or two for a map, got {more}")),
        }
        let mut drawn = self.overs.iter().map(|over| &over.ranges[0]);
        if let Some((path, only, _)) = drawn.find(|(_, from, to)| from == to) {
            return refused(format!("expected two ends of `{path}`, got {only:?} twice"));
        }
        let (points, ran) = self.ran(done);
        ran?;
        let value = |(_, outcome): &Point| match outcome.as_deref() {
            Ok(&[Some(first), ..]) => first,
            _ => f64::NAN,
        };
        // A crossing is given by its time.
        let tell = &self.tells[0];
        let is_time = matches!(tell.what, What::Crossing(_));
        let column = self.columns.first().filter(|_| !is_time);
        let values: Vec<f64> = points.iter().map(value).collect();
        if values.iter().all(|value| value.is_nan()) {
            let told = format!("--plot: no point of the scan has a `{}`", tell.head);
            return Err(Error::Failed(told));
        }
        let told = quantity(&tell.head, column, values);
        let axis = |over: &Over| {
            let first = |place: usize| over.values(place).next();
            let name = over.paths().next().unwrap_or_default();
            Quantity {
                unit: "",
                logarithmic: over.logarithmic,
                ..quantity(name, None, (0..over.count).filter_map(first).collect())
            }
        };
        let title = format!("Many motions of {}", stem(&self.name));
        Ok(match &self.overs[..] {
            [x, y] => map(&title, &[axis(x), axis(y)], &told),
            overs => diagram(&title, &[[axis(&overs[0]), told]]),
        })
    }

    fn csv(&self, points: &[Point]) -> String {
        let mut text = self.heads().join(",") + ",status\n";
        for (varied, outcome) in points {
            let (told, status) = match outcome {
                Ok(told) => (told.clone(), "ok".to_owned()),
                Err(error) => {
                    let told = error.to_string().replace('"', "\"\"").replace('\n', "; ");
                    (vec![None; self.tells.len()], format!("\"{told}\""))
                }
            };
            for number in varied.iter().copied().map(Some).chain(told) {
                text += &number.map_or(String::new(), |number| format!("{number:?}"));
                text += ",";
            }
            text += &format!("{status}\n");
        }
        text
    }

    fn json(&self, points: &[Point]) -> String {
        let heads = self.heads();
        let mut lines = [Vec::new(), Vec::new()];
        for (varied, outcome) in points {
            let told = outcome.iter().flatten().map(|number| json!(number));
            let numbers = varied.iter().map(|number| json!(number)).chain(told);
            let reason = outcome.as_ref().map_err(|error| json!(error.to_string()));
            let reason = reason.err().map(|reason| ("reason".to_owned(), reason));
            let line: Json = heads.iter().cloned().zip(numbers).chain(reason).collect();
            lines[usize::from(outcome.is_err())].push(line.to_string());
        }
        let [rows, refused] = lines.map(|lines| match lines.is_empty() {
            true => "[]".to_owned(),
            false => format!("[\n    {}\n  ]", lines.join(",\n    ")),
        });
        format!("{{\n  \"rows\": {rows},\n  \"refused\": {refused}\n}}\n")
    }

    /// Warns if the mass alone varies beside an inertia that is not per mass.
    fn warn(&self) {
        let numbers = files::numbers(&self.text);
        let is_there = |key: &str| numbers.iter().any(|path| key_of_body(path) == Some(key));
        let varies = |key: &str| self.paths().any(|path| key_of_body(path) == Some(key));
        if let Some(stays) = ABSOLUTE.into_iter().find(|key| is_there(key))
            && varies("mass")
            && !ABSOLUTE.into_iter().any(varies)
        {
            let name = &self.name;
            tell(one_line(&format!(
                "warning: {name}: `body.mass` varies but `{stays}` in [body] does not: each row is a different body, not the same one made heavier"
            )));
        }
    }
}

/// The key of the table [body] that a path leads to.
fn key_of_body(path: &str) -> Option<&str> {
    path.strip_prefix("body.")?.split('.').next()
}

/// The keys that give a body's inertia independently of its mass.
const ABSOLUTE: [&str; 3] = ["moments", "inertia", "axial"];

/// The file with another number in one place.
fn set(name: &str, text: &str, path: &str, value: f64) -> Result<String> {
    files::set(text, path, value).ok_or_else(|| {
        let numbers = files::numbers(text);
        // A number that shares only the table with it would be no help.
        fn key(path: &str) -> &str {
            path.split_once('.').map_or(path, |(_, key)| key)
        }
        let alike = |number: &&str| !files::meant(key(path), [key(number)].into_iter()).is_empty();
        let near = files::meant(path, numbers.iter().map(String::as_str).filter(alike));
        Error::Input(format!(
            "{name}: no number `{path}` stands in it to be varied; keys are joined by dots, and places in a list count from 0{near}"
        ))
    })
}

/// Between two rows the scene is computed at this many times, and between two of those again, until a straight line between them tells the
/// same time to this fraction of it, in at most this many rounds.
const PARTS: usize = 64;
const SAME: f64 = 1e-12;
const ROUNDS: usize = 6;

/// The first time at which a column reaches a level; the rows are times and the column's numbers. A jump over the level,
/// as at a bounce, counts; an angle that goes round is at π and −π at once.
fn crossing(motion: &Motion, name: &str, level: f64, rows: &[[f64; 2]]) -> Result<Option<f64>> {
    let mut columns = motion.scene.told();
    let goes_round = columns.any(|column| column.name == name && column.goes_round);
    if goes_round && level.abs() > PI {
        return Ok(None);
    }
    // The position between two rows, as a fraction.
    let part = |a: f64, b: f64| {
        let leaps = goes_round && (b - a).abs() > PI;
        let b = if leaps { b - TAU.copysign(b - a) } else { b };
        let levels: &[f64] = if leaps { &[0.0, TAU, -TAU] } else { &[0.0] };
        let mut levels = levels.iter().map(|turn| level + turn);
        let level = levels.find(|&level| a < level && b >= level || a > level && b <= level)?;
        Some((level - a) / (b - a))
    };
    let first = |rows: &[[f64; 2]]| {
        let mut pairs = rows.array_windows();
        pairs.find_map(|&[from, to]| Some((from, to, part(from[1], to[1])?)))
    };
    if let Some(row) = rows.first().filter(|row| row[1] == level) {
        return Ok(Some(row[0]));
    }
    let Some(mut found) = first(rows) else {
        return Ok(None);
    };
    let time = |(from, to, part): ([f64; 2], [f64; 2], f64)| from[0] + (to[0] - from[0]) * part;
    for _ in 0..ROUNDS {
        let (from, to, _) = found;
        let at = |k: usize| from[0] + (to[0] - from[0]) * (k as f64 / PARTS as f64);
        let table = motion.at(&(1..PARTS).map(at).collect::<Vec<_>>())?;
        let closer = [vec![from], table.numbers(["t", name])?, vec![to]].concat();
        let Some(closer) = first(&closer) else { break };
        let before = time(found);
        found = closer;
        if (time(found) - before).abs() <= SAME * before.abs() {
            break;
        }
    }
    Ok(Some(time(found)))
}
