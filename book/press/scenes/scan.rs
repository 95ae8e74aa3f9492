//! Scans: one scene file, some of its numbers varied over a grid, all cores at work.

use std::f64::consts::{PI, TAU};
use std::fmt;
use std::path::Path;
use std::str::FromStr;

use figures::Figure;
use figures::own::{Quantity, diagram, map};
use rayon::prelude::*;
use serde_json::{Value as Json, json};
use spinning_bodies::scene::{AnyScene, Column, Request, files};

use super::output::Format;
use super::plot::quantity;
use super::{parse, source};
use crate::writer::tell;
use crate::{Error, Result};

/// Numbers of a scene file that go through their ranges together: `initial.omega.2=50..200:16`.
#[derive(Debug, Clone, PartialEq)]
pub struct Over {
    /// Where each number stands, and the ends of its range.
    ranges: Vec<(String, f64, f64)>,
    count: usize,
    /// Equal ratios instead of equal differences.
    logarithmic: bool,
}

/// Most scenes of a scan, and fields of a map.
const MOST: usize = 1_000_000;
const MOST_FIELDS: usize = 10_000;

impl FromStr for Over {
    type Err = String;

    fn from_str(text: &str) -> std::result::Result<Self, String> {
        let refused = |told: &str| format!("`{text}` {told}");
        let expected = || {
            refused(
                "should look like initial.omega.2=50..200:16, a number of the file, its range, and how many values; :log behind it for equal ratios, KEY=FROM..TO,KEY=FROM..TO:16 for numbers that vary together",
            )
        };
        let (rest, logarithmic) = match text.strip_suffix(":log") {
            Some(rest) => (rest, true),
            None => (text, false),
        };
        let (rest, count) = rest.rsplit_once(':').ok_or_else(expected)?;
        let number = |text: &str| text.trim().parse::<f64>().ok().filter(|n| n.is_finite());
        let range = |text: &str| {
            let (path, range) = text.split_once('=')?;
            let (from, to) = range.split_once("..")?;
            // Three dots: one may be a decimal point, and nobody can tell which.
            let path = Some(path.trim()).filter(|path| !path.is_empty() && !to.starts_with('.'))?;
            Some((path.to_owned(), number(from)?, number(to)?))
        };
        let ranges: Option<Vec<_>> = rest.split(',').map(range).collect();
        let over = Self {
            ranges: ranges.ok_or_else(expected)?,
            count: count.trim().parse().map_err(|_| expected())?,
            logarithmic,
        };
        if !(1..=MOST).contains(&over.count) {
            return Err(expected());
        }
        if over.count == 1 && over.ranges.iter().any(|(_, from, to)| from != to) {
            return Err(refused("asks for one value of a range of many"));
        }
        if logarithmic && !over.ranges.iter().all(same_sign) {
            return Err(refused(
                "asks for equal ratios: both ends must be positive, or both negative",
            ));
        }
        Ok(over)
    }
}

/// To fifteen digits: a tenth is 0.1 then, not an ulp less.
fn rounded(value: f64) -> f64 {
    format!("{value:.14e}").parse().unwrap_or(value)
}

/// Whether both ends of a range are positive, or both negative.
fn same_sign(&(_, from, to): &(String, f64, f64)) -> bool {
    (from > 0.0 && to > 0.0) || (from < 0.0 && to < 0.0)
}

impl Over {
    fn paths(&self) -> impl Iterator<Item = &str> {
        self.ranges.iter().map(|(path, ..)| path.as_str())
    }

    /// The values at a place of the grid; the ends are met exactly.
    fn values(&self, place: usize) -> impl Iterator<Item = (&str, f64)> {
        let part = place as f64 / (self.count - 1).max(1) as f64;
        let value = move |from: f64, to: f64| match part {
            0.0 => from,
            1.0 => to,
            _ if self.logarithmic => rounded(from * (to / from).powf(part)),
            _ if (to - from).is_finite() => rounded(from + (to - from) * part),
            _ => from * (1.0 - part) + to * part,
        };
        let ranges = self.ranges.iter();
        ranges.map(move |(path, from, to)| (path.as_str(), value(*from, *to)))
    }
}

/// What is told of a column: `greatest:tilt`, `crossing:tilt=1.5`; of a column alone, its last value.
#[derive(Debug, Clone, PartialEq)]
pub struct Tell {
    column: String,
    what: What,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum What {
    First,
    Last,
    Least,
    Greatest,
    /// When it is first at this level, s.
    Crossing(f64),
}

impl FromStr for Tell {
    type Err = String;

    fn from_str(text: &str) -> std::result::Result<Self, String> {
        let expected = || {
            format!(
                "`{text}` should be a column, or first:, last:, least:, greatest: and a column, or crossing:COLUMN=LEVEL for the time when it is there"
            )
        };
        let (what, column) = text.split_once(':').unwrap_or(("last", text));
        let (column, level) = match column.split_once('=') {
            Some((column, level)) => (column, Some(level)),
            None => (column, None),
        };
        let what = match (what, level) {
            ("first", None) => What::First,
            ("last", None) => What::Last,
            ("least", None) => What::Least,
            ("greatest", None) => What::Greatest,
            ("crossing", Some(level)) => {
                let level = level.parse::<f64>().ok().filter(|level| level.is_finite());
                What::Crossing(level.ok_or_else(expected)?)
            }
            _ => return Err(expected()),
        };
        match column {
            "" => Err(expected()),
            _ => Ok(Self {
                column: column.to_owned(),
                what,
            }),
        }
    }
}

impl fmt::Display for Tell {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let column = &self.column;
        match self.what {
            What::First => write!(f, "first:{column}"),
            What::Last => write!(f, "{column}"),
            What::Least => write!(f, "least:{column}"),
            What::Greatest => write!(f, "greatest:{column}"),
            What::Crossing(level) => write!(f, "crossing:{column}={level:?}"),
        }
    }
}

/// A scan that is asked for.
#[derive(Debug)]
pub struct Scan {
    name: String,
    text: String,
    overs: Vec<Over>,
    /// Nothing: the last row.
    tells: Vec<Tell>,
    /// The columns that are told.
    columns: Vec<Column>,
}

/// What is told of a point, a number that is not there being none, or why there is nothing.
type Outcome = Result<Vec<Option<f64>>>;

/// The varied numbers of a point, and what came of them.
type Point<'a> = (Vec<(&'a str, f64)>, Outcome);

impl Scan {
    /// The scan of a file.
    ///
    /// # Errors
    /// [`Error::Input`] for a file that is not a scene, a number or a column that it does not have, a number that is to be varied twice, and more than a
    /// million points.
    pub fn new(path: &Path, overs: Vec<Over>, tells: Vec<Tell>) -> Result<Self> {
        let (name, text) = source(path)?;
        let (scene, _) = parse(&name, &text)?;
        let all: Vec<&str> = overs.iter().flat_map(Over::paths).collect();
        for (place, path) in all.iter().enumerate() {
            set(&name, &text, path, 0.0)?;
            if all[..place].contains(path) {
                let told = format!("{name}: `{path}` stands twice after --over");
                return Err(Error::Input(told));
            }
        }
        let counts = overs.iter().map(|over| over.count);
        if counts.fold(1_usize, usize::saturating_mul) > MOST {
            let told = format!("{name}: a scan has at most {MOST} points");
            return Err(Error::Input(told));
        }
        let named: Vec<&str> = tells.iter().map(|tell| tell.column.as_str()).collect();
        let scene = match named.is_empty() {
            true => scene,
            false => files::telling(scene, &named)
                .map_err(|told| Error::Input(format!("--tell, --plot: {name} {told}")))?,
        };
        let columns = scene.told().collect();
        Ok(Self {
            name,
            text,
            overs,
            tells,
            columns,
        })
    }

    /// How many points the grid has.
    pub fn points(&self) -> usize {
        self.overs.iter().map(|over| over.count).product()
    }

    /// The varied numbers of a point; those named last run fastest.
    fn varied(&self, mut point: usize) -> Vec<(&str, f64)> {
        let mut varied = Vec::new();
        for over in self.overs.iter().rev() {
            varied.splice(0..0, over.values(point % over.count));
            point /= over.count;
        }
        varied
    }

    fn outcome(&self, varied: &[(&str, f64)]) -> Outcome {
        let mut text = self.text.clone();
        for &(path, value) in varied {
            text = set(&self.name, &text, path, value)?;
        }
        let (scene, request) = parse(&self.name, &text)?;
        let names: Vec<&str> = self.columns.iter().map(|column| column.name).collect();
        let scene = scene.telling(&names)?;
        let motion = super::run(&self.name, &scene, &request)?;
        let mut rows: Vec<(f64, Vec<f64>)> = motion.rows().collect();
        rows.sort_by(|a, b| a.0.total_cmp(&b.0));
        let told = |(place, tell): (usize, &Tell)| {
            let column = || rows.iter().map(|(_, row)| row[place]);
            Ok(match tell.what {
                What::First => column().next(),
                What::Last => column().next_back(),
                What::Least => column().reduce(f64::min),
                What::Greatest => column().reduce(f64::max),
                What::Crossing(level) => {
                    let crossing = Crossing {
                        name: &self.name,
                        scene: &scene,
                        request: &request,
                        place,
                        level,
                    };
                    let rows: Vec<(f64, f64)> =
                        rows.iter().map(|(t, row)| (*t, row[place])).collect();
                    crossing.first(&rows)?
                }
            })
        };
        if self.tells.is_empty() {
            let last = rows.pop().map(|(t, row)| std::iter::once(t).chain(row));
            return Ok(last.into_iter().flatten().map(Some).collect());
        }
        self.tells.iter().enumerate().map(told).collect()
    }

    /// The heads of the numbers that are told of a point.
    fn heads(&self) -> Vec<String> {
        if self.tells.is_empty() {
            let time = std::iter::once("t".to_owned());
            let names = self.columns.iter().map(|column| column.name.to_owned());
            return time.chain(names).collect();
        }
        self.tells.iter().map(Tell::to_string).collect()
    }

    /// Runs the scene at every point of the grid, on all cores, and tells how that went: whether any point could be run. `done` is called after each.
    /// Warnings go to standard error.
    fn ran(&self, done: impl Fn() + Sync) -> (Vec<Point<'_>>, Result<()>) {
        self.warn();
        let points = (0..self.points()).into_par_iter().map(|point| {
            let varied = self.varied(point);
            let outcome = self.outcome(&varied);
            done();
            (varied, outcome)
        });
        let points: Vec<Point<'_>> = points.collect();
        let refusals = points
            .iter()
            .filter_map(|(_, outcome)| outcome.as_ref().err());
        let refusals: Vec<&Error> = refusals.collect();
        let (refused, all) = (refusals.len(), points.len());
        let ran = match refusals[..] {
            [] => Ok(()),
            [first, ..] if refused == all => Err(Error::Failed(format!(
                "no point of the scan could be run; the first: {first}"
            ))),
            [first, ..] => {
                tell(format_args!(
                    "warning: {refused} of {all} points are refused; the first: {first}"
                ));
                Ok(())
            }
        };
        (points, ran)
    }

    /// Runs it and gives the text of what is told, and whether any point could be run. `done` is called after each point.
    ///
    /// CSV: a line a point, the varied numbers, what is told, and `ok` or why there is nothing. JSON: an object with the rows, and apart from them what was
    /// refused.
    pub fn run(&self, format: Format, done: impl Fn() + Sync) -> (String, Result<()>) {
        let (points, ran) = self.ran(done);
        let text = match format {
            Format::Csv => self.csv(&points),
            Format::Json => self.json(&points),
        };
        (text, ran)
    }

    /// Runs it and draws the first number that is told: over one range a line, over two a map.
    ///
    /// # Errors
    /// [`Error::Input`] for more ranges or too large a map, [`Error::Failed`] if no point could be run.
    pub fn picture(&self, done: impl Fn() + Sync) -> Result<Figure> {
        let refused = |told: String| Err(Error::Input(format!("--plot: {told}")));
        let count = self.points();
        match self.overs.len() {
            2 if count > MOST_FIELDS => {
                return refused(format!(
                    "expected at most {MOST_FIELDS} points for a map, got {count}"
                ));
            }
            1 | 2 => (),
            more => return refused(format!("expected one --over, or two for a map, got {more}")),
        }
        let (points, ran) = self.ran(done);
        ran?;
        let value = |(_, outcome): &Point<'_>| match outcome.as_deref() {
            Ok(&[Some(first), ..]) => first,
            _ => f64::NAN,
        };
        // A crossing is told by its time.
        let times = |tell: &Tell| matches!(tell.what, What::Crossing(_));
        let column = match self.tells.iter().any(times) {
            true => None,
            false => self.columns.first(),
        };
        let values = points.iter().map(value).collect();
        let told = quantity(&self.heads()[0], column, values);
        let axis = |over: &Over| {
            let first = |place: usize| Some(over.values(place).next()?.1);
            let name = over.paths().next().unwrap_or_default();
            Quantity {
                unit: "",
                logarithmic: over.logarithmic,
                ..quantity(name, None, (0..over.count).filter_map(first).collect())
            }
        };
        let title = Path::new(&self.name).file_stem().unwrap_or_default();
        let title = format!("Many motions of {}", title.display());
        Ok(match &self.overs[..] {
            [x, y] => map(&title, &[axis(x), axis(y)], &told),
            overs => diagram(&title, &[[axis(&overs[0]), told]]),
        })
    }

    fn csv(&self, points: &[Point<'_>]) -> String {
        let heads = self.heads();
        let paths = self.overs.iter().flat_map(Over::paths);
        let all = paths.chain(heads.iter().map(String::as_str));
        let mut text = all.chain(["status"]).collect::<Vec<_>>().join(",") + "\n";
        for (varied, outcome) in points {
            let (told, status) = match outcome {
                Ok(told) => (told.clone(), "ok".to_owned()),
                Err(error) => {
                    let told = error.to_string().replace('"', "\"\"").replace('\n', "; ");
                    (vec![None; heads.len()], format!("\"{told}\""))
                }
            };
            let varied = varied.iter().map(|&(_, value)| Some(value));
            for number in varied.chain(told) {
                text += &number.map_or(String::new(), |number| format!("{number:?}"));
                text += ",";
            }
            text += &format!("{status}\n");
        }
        text
    }

    fn json(&self, points: &[Point<'_>]) -> String {
        let heads = self.heads();
        let (mut rows, mut refused) = (Vec::new(), Vec::new());
        for (varied, outcome) in points {
            let mut line = serde_json::Map::new();
            for &(path, value) in varied {
                line.insert(path.to_owned(), json!(value));
            }
            let lines = match outcome {
                Ok(told) => {
                    for (head, number) in heads.iter().zip(told) {
                        line.insert(head.clone(), json!(number));
                    }
                    &mut rows
                }
                Err(error) => {
                    line.insert("reason".to_owned(), json!(error.to_string()));
                    &mut refused
                }
            };
            lines.push(Json::Object(line).to_string());
        }
        let list = |lines: Vec<String>| match lines.is_empty() {
            true => "[]".to_owned(),
            false => format!("[\n    {}\n  ]", lines.join(",\n    ")),
        };
        format!(
            "{{\n  \"rows\": {},\n  \"refused\": {}\n}}\n",
            list(rows),
            list(refused)
        )
    }

    /// Says what a reader of the rows must know: the mass alone varies, beside an inertia that is not per mass.
    fn warn(&self) {
        let is = |path: &str, key: &str| path.split('.').take(2).eq(["body", key]);
        let varies = |key: &str| {
            let mut paths = self.overs.iter().flat_map(Over::paths);
            paths.any(|path| is(path, key))
        };
        let numbers = files::numbers(&self.text);
        let there = |key: &&str| numbers.iter().any(|path| is(path, key));
        let stays = ABSOLUTE.into_iter().find(there);
        if let (Some(stays), true, false) =
            (stays, varies("mass"), ABSOLUTE.into_iter().any(varies))
        {
            let name = &self.name;
            tell(format_args!(
                "warning: {name}: `body.mass` varies and `{stays}` in [body] stays as it is: each row is another body, not the same one made heavier"
            ));
        }
    }
}

/// The keys that say how a body resists being turned, whatever its mass.
const ABSOLUTE: [&str; 3] = ["moments", "inertia", "axial"];

/// The file with another number in one place.
fn set(name: &str, text: &str, path: &str, value: f64) -> Result<String> {
    files::set(text, path, value).ok_or_else(|| {
        let numbers = files::numbers(text);
        // What has only its table in common with it would not help.
        let key = |path: &str| path.split_once('.').map_or(path, |(_, key)| key).to_owned();
        let alike = |number: &&str| {
            let other = key(number);
            !files::meant(&key(path), std::iter::once(other.as_str())).is_empty()
        };
        let near = files::meant(path, numbers.iter().map(String::as_str).filter(alike));
        Error::Input(format!(
            "{name}: there is no number `{path}` to vary; keys are joined by dots, places in a list count from 0{near}"
        ))
    })
}

/// The time when a column is first at a level.
struct Crossing<'a> {
    name: &'a str,
    scene: &'a AnyScene,
    request: &'a Request,
    /// The column's place in a row.
    place: usize,
    level: f64,
}

/// Between two rows the scene is asked at so many times, and between two of those again, so often; what is left is a straight line.
const PARTS: usize = 64;
const ROUNDS: usize = 3;

impl Crossing<'_> {
    /// Where between two rows it is reached, as a part of the way. A jump over the level, as at a bounce, counts; an angle that goes round is at π and −π at
    /// once.
    fn between(&self, a: f64, b: f64) -> Option<f64> {
        let goes_round = self
            .scene
            .told()
            .nth(self.place)
            .is_some_and(|column| column.goes_round);
        let leaps = goes_round && (b - a).abs() > PI;
        let b = if leaps { b - TAU.copysign(b - a) } else { b };
        let levels: &[f64] = if leaps { &[0.0, TAU, -TAU] } else { &[0.0] };
        let mut levels = levels.iter().map(|turn| self.level + turn);
        let level = levels.find(|&level| a <= level && b > level || a >= level && b < level)?;
        Some((level - a) / (b - a))
    }

    /// The first of the times at which it is there.
    fn first(&self, rows: &[(f64, f64)]) -> Result<Option<f64>> {
        let between = |pair: &&[(f64, f64)]| self.between(pair[0].1, pair[1].1).is_some();
        let Some(mut pair) = rows.windows(2).find(between).map(<[_]>::to_vec) else {
            // In the only row, or in the last.
            let there = rows.iter().find(|row| row.1 == self.level);
            return Ok(there.map(|row| row.0));
        };
        for _ in 0..ROUNDS {
            let [(from, _), (to, _)] = pair[..] else {
                break;
            };
            let at = |k: usize| from + (to - from) * (k as f64 / PARTS as f64);
            let times: Vec<f64> = (1..PARTS).map(at).collect();
            let motion = super::run(self.name, self.scene, &self.request.of_times(&times))?;
            let inner = motion.rows().map(|(t, row)| (t, row[self.place]));
            let all: Vec<_> = [pair[0]]
                .into_iter()
                .chain(inner)
                .chain([pair[1]])
                .collect();
            match all.windows(2).find(between) {
                Some(closer) => pair = closer.to_vec(),
                None => break,
            }
        }
        let [(from, a), (to, b)] = pair[..] else {
            return Ok(None);
        };
        let part = self.between(a, b).unwrap_or(1.0);
        Ok(Some(from + (to - from) * part))
    }
}
