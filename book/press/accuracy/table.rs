//! The table of a problem, and its winners.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use lab::accuracy::measured::{Row, TARGETS, ranking};
use lab::accuracy::{Measurement, Status};

use super::patience::Swept;

/// The method that the others are compared with.
const PEER: &str = "dop853";

/// The table of a motion: the telling rows of each method, then the winners, by evaluations if no times were measured; errors below the floor are not known.
pub fn text(heading: &str, floor: f64, swept: &[Swept]) -> String {
    let mut text = format!(
        "{heading}\n\n{:>17} {:>10} {:>9} {:>9} {:>11} {:>10} {:>9}\n",
        "method", "parameter", "error", "of omega", "evaluations", "steps", "time",
    );
    for alike in swept.chunk_by(|a, b| failure(a).is_some() && failure(a) == failure(b)) {
        for row in alike.iter().flat_map(|one| telling(&one.rows)) {
            text.push_str(&line(row));
        }
        let name = match alike {
            [first, .., last] => format!("{} … {}", first.method, last.method),
            _ => alike[0].method.clone(),
        };
        if let Some(told) = failure(&alike[0]) {
            let _ = writeln!(text, "{name:>17}   failed: {told}");
        }
        if alike[0].left_out > 0 {
            let count = alike[0].left_out;
            let told = format!("left out: {count} finer efforts, too long for this table");
            let _ = writeln!(text, "{name:>17}   {told}");
        }
    }
    text + "\n" + &winners(floor, swept) + "\n"
}

/// For each accuracy the cheapest method, the next one, and the peer.
fn winners(floor: f64, swept: &[Swept]) -> String {
    let all = || swept.iter().flat_map(|one| &one.rows);
    let rows = kept(all()).map(|row| Row {
        problem: "",
        method: &row.method,
        error: worst(row),
        price: price(row),
    });
    let rows: Vec<Row<'_>> = rows.collect();
    let unit = match all().any(|row| row.seconds.is_some()) {
        true => duration,
        false => |evaluations: f64| format!("{evaluations} evaluations"),
    };
    let winner = |target: f64| {
        let mut ranked = ranking(&rows, "", target);
        // Below the floor only a closed form is known to be as good as its own estimate.
        ranked.retain(|(method, _)| target >= floor || CLOSED.contains(method));
        let others = match (target >= floor, ranked.is_empty()) {
            (true, true) => "no method reaches it",
            (true, false) => "",
            (false, true) => "unknown: the judges do not agree to that",
            (false, false) => "unknown for methods that step",
        };
        let all = ranked.iter().enumerate();
        let named = all.filter(|(place, (method, _))| *place < 2 || *method == PEER);
        let named = named.map(|(place, (method, price))| {
            let more = price / ranked[0].1;
            let digits = usize::from(more < 9.95);
            let more = match place > 0 && more.is_finite() {
                true => format!(", {more:.digits$} times as much"),
                false => String::new(),
            };
            format!("{method} in {}{more}", unit(*price))
        });
        let mut told: Vec<String> = named.chain([others.to_owned()]).collect();
        told.retain(|told| !told.is_empty());
        format!("{target:e}: {}\n", told.join("; "))
    };
    TARGETS.into_iter().map(winner).collect()
}

/// The methods that state their own error.
const CLOSED: [&str; 2] = ["exact", "events"];

/// Seconds, or evaluations where no clock ran.
fn price(row: &Measurement) -> f64 {
    row.seconds.unwrap_or(row.evaluations as f64)
}

/// The rows of runs that came to an end.
fn kept<'a>(rows: impl Iterator<Item = &'a Measurement>) -> impl Iterator<Item = &'a Measurement> {
    rows.filter(|row| matches!(row.status, Status::Ok | Status::Floor))
}

/// Cost and error at each effort that ran; the cost is at least one evaluation if no times were measured.
pub fn points(rows: &[Measurement]) -> Vec<[f64; 2]> {
    let paid = |row: &Measurement| row.seconds.unwrap_or(row.evaluations.max(1) as f64);
    let points = kept(rows.iter()).map(|row| [paid(row), worst(row)]);
    points.collect()
}

/// The greater of both errors, if there are two.
fn worst(row: &Measurement) -> f64 {
    row.error_attitude.max(row.error_omega)
}

/// The reason why a method failed at all efforts, from the last one, since the first may have been too coarse.
fn failure(one: &Swept) -> Option<String> {
    let failures = one.rows.iter().map(|row| row.failure.as_ref());
    let failures: Vec<_> = failures.collect::<Option<_>>()?;
    failures.last().map(ToString::to_string)
}

/// The rows of interest to a reader: the cheapest to reach each of the targets, and the most accurate. The CSV file has all rows.
fn telling(rows: &[Measurement]) -> impl Iterator<Item = &Measurement> {
    let cheapest = |target: f64| {
        let good = rows.iter().enumerate();
        let good = good.filter(|(_, row)| worst(row) <= target);
        good.min_by(|a, b| price(a.1).total_cmp(&price(b.1)))
    };
    let all = rows.iter().enumerate();
    let best = all.filter(|(_, row)| row.failure.is_none());
    let best = best.min_by(|a, b| a.1.error().total_cmp(&b.1.error()));
    let wanted = TARGETS.into_iter().filter_map(cheapest).chain(best);
    let places: BTreeSet<usize> = wanted.map(|(place, _)| place).collect();
    places.into_iter().map(|place| &rows[place])
}

fn line(row: &Measurement) -> String {
    let or_dash = |told: Option<String>| told.unwrap_or("-".to_owned());
    let error = |x: f64| or_dash(x.is_finite().then(|| format!("{x:.1e}")));
    let time = or_dash(row.seconds.map(duration));
    let parameter = Some(row.parameter).filter(|parameter| *parameter != 0.0);
    let parameter = or_dash(parameter.map(|parameter| format!("{parameter:.2e}")));
    let remark = match row.status {
        Status::Ok => "",
        other => other.word(),
    };
    let line = format!(
        "{:>17} {parameter:>10} {:>9} {:>9} {:>11} {:>10} {time:>9}  {remark}",
        row.method,
        error(row.error()),
        error(row.error_omega),
        row.evaluations,
        row.steps,
    );
    format!("{}\n", line.trim_end())
}

/// With three digits.
fn duration(seconds: f64) -> String {
    let (value, unit) = match seconds {
        s if s < 1e-6 => (s * 1e9, "ns"),
        s if s < 1e-3 => (s * 1e6, "us"),
        s if s < 1.0 => (s * 1e3, "ms"),
        s => (s, "s"),
    };
    let places = usize::from(value < 9.995) + usize::from(value < 99.95);
    format!("{value:.places$} {unit}")
}
