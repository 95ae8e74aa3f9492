//! `[run]`: times, accuracy, solver and columns.

use super::file::*;
use super::reader::meant;
use crate::scene::{Choice, Request, UnknownColumn};

/// Most rows of a run: some gigabytes of output.
const MOST: usize = 10_000_000;

section! { Run
    times: Option<Vec<f64>>, "a list of times in s";
    until: Option<f64>, "the last time in s, in place of `times`";
    samples: Option<usize>, "the number of times from 0 on (101 by default), a whole number", From(2.0, MOST as f64);
    accuracy: f64 = 1e-10, "a relative accuracy", From(1e-15, 0.1);
    solver: Choice, "";
    columns: Option<Vec<String>>, "a list of the names of columns";
}

impl Run {
    pub fn request(&self, file: &Reader<'_>) -> Option<Request> {
        let request = file.right("run.times", Request::at(self.times(file)?))?;
        let request = file.right("run.accuracy", request.to_accuracy(self.accuracy))?;
        Some(request.by(self.solver))
    }

    /// The scene with the requested columns.
    pub fn told(&self, file: &Reader<'_>, scene: AnyScene) -> Option<AnyScene> {
        match self.columns.as_deref() {
            None => Some(scene),
            Some([]) => file.wrong("run.columns", " must name one number at least"),
            Some(names) => telling(scene, names)
                .map_or_else(|told| file.wrong("run.columns", &format!(" {told}")), Some),
        }
    }

    fn times(&self, file: &Reader<'_>) -> Option<Vec<f64>> {
        match (&self.times, self.until, self.samples) {
            (Some(times), None, None) if (1..=MOST).contains(&times.len()) => Some(times.clone()),
            (Some(times), None, None) => {
                let got = times.len();
                let told = format!(" must be a list of 1 to {MOST} times in s, got {got}");
                file.wrong("run.times", &told)
            }
            (None, Some(0.0), _) => {
                let told = " must be the last time in s, not 0: all rows would be the same";
                file.wrong("run.until", told)
            }
            (None, Some(until), samples) => {
                let samples = samples.unwrap_or(101);
                let last = (samples - 1) as f64;
                // The product comes first: 49 of 52 seconds in 520 parts is then 4.9, not one ulp less.
                let is_finite = (until * last).is_finite();
                let unit = if is_finite { 1.0 } else { last };
                // Zero is added last, for before the start it would be a negative zero.
                let at = |i: usize| (until / unit) * i as f64 / (last / unit) + 0.0;
                Some((0..samples).map(at).collect())
            }
            (Some(_), ..) => {
                file.wrong("run.times", " and `until` or `samples` exclude each other")
            }
            (None, None, _) => file.missing("run.times", "`times`, or `until` and `samples`,"),
        }
    }
}

/// The scene with these columns.
///
/// # Errors
/// An unknown name, with the one that was probably meant: "has no column `tlt` to tell; …"; a name given twice.
///
/// ```
/// use spinning_bodies::scene::files::{parse, telling};
/// let text = "[body]\nmoments = [1, 2, 3]\n[initial]\nomega = [0, 0, 2]\n[run]\ntimes = [1.0]\n";
/// let (scene, _) = parse("mine.toml", text)?;
/// let refused = telling(scene, &["enrgy"]).expect_err("a slip");
/// assert!(refused.ends_with("; did you mean `energy`?"));
/// # Ok::<(), spinning_bodies::scene::files::Mistakes>(())
/// ```
pub fn telling<N: AsRef<str>>(scene: AnyScene, names: &[N]) -> Result<AnyScene, String> {
    let scene = scene
        .telling(names)
        .map_err(|UnknownColumn { name, names }| {
            let meant = match name.as_str() {
                "t" => "; the time comes first, unasked".to_owned(),
                _ => meant(&name, names.iter().copied()),
            };
            let names = names.join(", ");
            format!("has no column `{name}` to tell; there are {names}{meant}")
        })?;
    let names: Vec<&str> = names.iter().map(N::as_ref).collect();
    match (0..names.len()).find(|&k| names[..k].contains(&names[k])) {
        None => Ok(scene),
        Some(twice) => Err(format!("is asked for column `{}` twice", names[twice])),
    }
}
