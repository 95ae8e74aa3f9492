//! The table of a problem, and its winners.

use std::fmt::Write as _;

use lab::accuracy::measured::{Row, TARGETS, ranking};
use lab::accuracy::{Measurement, Status};

use super::Swept;

/// The method that the others are compared with.
const PEER: &str = "dop853";

/// The table of a motion: what tells of each method, then the winners, by evaluations where no clock ran; errors below the floor are not known.
pub fn text(heading: &str, floor: f64, swept: &[Swept]) -> String {
    let mut text = format!(
        "{heading}\n\n{:>17} {:>10} {:>9} {:>9} {:>11} {:>10} {:>9} {:>9}\n",
        "method", "parameter", "error", "of omega", "evaluations", "steps", "time", "digits/us",
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
            let _ = writeln!(
                text,
                "{name:>17}   left out: {} finer efforts, too long for this table",
                alike[0].left_out
            );
        }
    }
    text.push('\n');
    let kept = |row: &&Measurement| matches!(row.status, Status::Ok | Status::Floor);
    let rows = swept.iter().flat_map(|s| &s.rows).filter(kept);
    let rows: Vec<Row<'_>> = rows
        .map(|row| Row {
            problem: "",
            method: &row.method,
            error: worst(row),
            price: price(row),
        })
        .collect();
    let unit = match swept
        .iter()
        .flat_map(|s| &s.rows)
        .any(|row| row.seconds.is_some())
    {
        true => duration,
        false => |evaluations: f64| format!("{evaluations} evaluations"),
    };
    for target in TARGETS {
        let ranked = ranking(&rows, "", target).into_iter();
        // Below the floor only a closed form is known to be as good as it says.
        let ranked = ranked.filter(|(method, _)| target >= floor || CLOSED.contains(method));
        let ranked: Vec<_> = ranked.collect();
        let told = match ranked[..] {
            [] if target < floor => "not told: the judges do not agree to that".to_owned(),
            [(best, least), ..] if target < floor => {
                format!("{best} in {}; of what steps it cannot be told", unit(least))
            }
            _ => winner(&ranked, unit),
        };
        let _ = writeln!(text, "{target:e}: {told}");
    }
    text + "\n"
}

/// The methods that tell their own error.
const CLOSED: [&str; 2] = ["exact", "events"];

/// Seconds, or evaluations where no clock ran.
fn price(row: &Measurement) -> f64 {
    row.seconds.unwrap_or(row.evaluations as f64)
}

/// What was paid at each effort that ran, one evaluation at least where no clock ran, and the error that was left.
pub fn points(rows: &[Measurement]) -> Vec<[f64; 2]> {
    let kept = rows
        .iter()
        .filter(|row| matches!(row.status, Status::Ok | Status::Floor));
    let paid = |row: &Measurement| row.seconds.unwrap_or(row.evaluations.max(1) as f64);
    kept.map(|row| [paid(row), worst(row)]).collect()
}

/// The greater of both errors, if there are two.
fn worst(row: &Measurement) -> f64 {
    row.error_attitude.max(row.error_omega)
}

/// Why a method failed at all efforts, at last, for the first may have been too coarse: without what stands in brackets, and not beyond a line.
fn failure(one: &Swept) -> Option<String> {
    const MOST: usize = 100;
    let failures = one.rows.iter().map(|row| row.failure.as_ref());
    let failures: Vec<_> = failures.collect::<Option<_>>()?;
    let mut told = failures.last()?.to_string();
    if let (Some(open), Some(close)) = (told.find(" ("), told.find(')'))
        && open < close
    {
        told.replace_range(open..=close, "");
    }
    if let Some((end, _)) = told.char_indices().nth(MOST) {
        told.truncate(end);
        told.push('…');
    }
    Some(told)
}

/// The rows that a person wants to see: the cheapest to reach each of the targets, and the most exact. The CSV file has them all.
fn telling(rows: &[Measurement]) -> Vec<&Measurement> {
    let cheapest = |target: f64| {
        let good = rows.iter().enumerate();
        let good = good.filter(|(_, row)| worst(row) <= target);
        good.min_by(|a, b| price(a.1).total_cmp(&price(b.1)))
    };
    let all = rows.iter().enumerate();
    let best = all.filter(|(_, row)| row.failure.is_none());
    let best = best.min_by(|a, b| a.1.error().total_cmp(&b.1.error()));
    let mut places: Vec<usize> = TARGETS
        .iter()
        .filter_map(|&target| cheapest(target))
        .chain(best)
        .map(|(place, _)| place)
        .collect();
    places.sort_unstable();
    places.dedup();
    places.into_iter().map(|place| &rows[place]).collect()
}

fn line(row: &Measurement) -> String {
    let error = |x: f64| {
        if x.is_finite() {
            format!("{x:.1e}")
        } else {
            "-".to_owned()
        }
    };
    let (time, digits) = match row.seconds {
        None => ("-".to_owned(), "-".to_owned()),
        Some(seconds) => (duration(seconds), digits(row.error(), seconds)),
    };
    let parameter = if row.parameter == 0.0 {
        "-".to_owned()
    } else {
        format!("{:.2e}", row.parameter)
    };
    let remark = match row.status {
        Status::Ok => "",
        other => other.word(),
    };
    let line = format!(
        "{:>17} {parameter:>10} {:>9} {:>9} {:>11} {:>10} {time:>9} {digits:>9}  {remark}",
        row.method,
        error(row.error()),
        error(row.error_omega),
        row.evaluations,
        row.steps,
    );
    format!("{}\n", line.trim_end())
}

/// Correct digits for each microsecond.
fn digits(error: f64, seconds: f64) -> String {
    // No error at all: judged by itself.
    let digits = -error.log10();
    if digits <= 0.0 || !digits.is_finite() {
        return "-".to_owned();
    }
    let value = digits / (1e6 * seconds);
    if value >= 0.01 {
        format!("{value:.2}")
    } else {
        format!("{value:.1e}")
    }
}

/// With three digits.
fn duration(seconds: f64) -> String {
    let (value, unit) = match seconds {
        s if s < 1e-6 => (s * 1e9, "ns"),
        s if s < 1e-3 => (s * 1e6, "us"),
        s if s < 1.0 => (s * 1e3, "ms"),
        s => (s, "s"),
    };
    let places = if value < 9.995 {
        2
    } else {
        usize::from(value < 99.95)
    };
    format!("{value:.places$} {unit}")
}

/// The cheapest method, the next one, and the peer, in words.
fn winner(ranked: &[(&str, f64)], told: impl Fn(f64) -> String) -> String {
    let Some(&(best, least)) = ranked.first() else {
        return "none gets there".to_owned();
    };
    let mut text = format!("{best} in {}", told(least));
    let peer = ranked.iter().skip(1).find(|(method, _)| *method == PEER);
    let next = ranked.get(1).filter(|(method, _)| *method != PEER);
    for (word, other) in [("next ", next), ("", peer)] {
        if let Some((method, price)) = other {
            let _ = write!(text, "; {word}{method} in {}", told(*price));
            if least > 0.0 {
                let _ = write!(text, ", {} times that", ratio(price / least));
            }
        }
    }
    if ranked.len() == 1 {
        text.push_str("; nothing else gets there");
    } else if peer.is_none() && best != PEER {
        let _ = write!(text, "; {PEER} does not get there");
    }
    text
}

/// Two or three digits, not more.
fn ratio(value: f64) -> String {
    let places = usize::from(value < 9.95);
    format!("{value:.places$}")
}
