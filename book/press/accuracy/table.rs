//! The table of a problem, and its winners.

use std::fmt::Write as _;

use lab::accuracy::{Measurement, Problem, Status};

use super::Swept;

/// Accuracies at which a winner is named.
pub const TARGETS: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

/// The method that the others are compared with.
const PEER: &str = "dop853";

/// The table of a problem: what tells of each method, then the winners.
pub fn text(problem: &Problem, swept: &[Swept]) -> String {
    let mut text = format!("{}: {}\n", problem.name(), problem.description());
    let _ = writeln!(
        text,
        "{} turns, {} s; error: angle between the attitudes at the end, rad\n\n{:>17} {:>10} {:>9} {:>9} {:>11} {:>10} {:>9} {:>9}",
        problem.turns(),
        problem.end(),
        "method",
        "parameter",
        "error",
        "of omega",
        "evaluations",
        "steps",
        "time",
        "digits/us",
    );
    for one in swept {
        for row in telling(&one.rows) {
            text.push_str(&line(row));
        }
        if one.left_out > 0 {
            let _ = writeln!(
                text,
                "{:>17}   left out: {} finer efforts, too long for this table",
                one.method, one.left_out
            );
        }
    }
    text.push('\n');
    let timed = || swept.iter().flat_map(|s| &s.rows);
    if timed().any(|row| row.seconds.is_some()) {
        for target in TARGETS {
            text.push_str(&winner(timed(), target));
        }
        text.push('\n');
    }
    text
}

/// The rows that a person wants to see: the cheapest to reach each of the targets, and the most exact. The CSV file has them all.
fn telling(rows: &[Measurement]) -> Vec<&Measurement> {
    let price = |row: &Measurement| row.seconds.unwrap_or(row.evaluations as f64);
    let cheapest = |target: f64| {
        let good = rows.iter().enumerate();
        let good = good.filter(|(_, row)| row.error_attitude.max(row.error_omega) <= target);
        good.min_by(|a, b| price(a.1).total_cmp(&price(b.1)))
    };
    let all = rows.iter().enumerate();
    let best = all.min_by(|a, b| a.1.error_attitude.total_cmp(&b.1.error_attitude));
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
        Some(seconds) => (duration(seconds), digits(row.error_attitude, seconds)),
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
        error(row.error_attitude),
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

/// The fastest run that is good enough in attitude and angular velocity, with and without closed form, against the peer's.
fn winner<'a>(rows: impl Iterator<Item = &'a Measurement> + Clone, target: f64) -> String {
    let fastest = |wanted: &dyn Fn(&str) -> bool| {
        rows.clone()
            .filter(|row| wanted(&row.method) && row.error_attitude.max(row.error_omega) <= target)
            .filter_map(|row| Some((row.method.as_str(), row.seconds?)))
            .min_by(|a, b| a.1.total_cmp(&b.1))
    };
    let peer = fastest(&|name| name == PEER);
    let told = |(name, seconds): (&str, f64)| {
        let ratio = match peer {
            Some(_) if name == PEER => String::new(),
            Some((_, slow)) => format!(" ({} x {PEER})", Ratio(slow / seconds)),
            None => format!(" ({PEER} does not get there)"),
        };
        format!("{name} in {}{ratio}", duration(seconds))
    };
    let Some(first) = fastest(&|_| true) else {
        return format!("{target:e}: none gets there\n");
    };
    let mut text = format!("{target:e}: {}", told(first));
    if first.0 == "exact" {
        text += &match fastest(&|name| name != "exact") {
            Some(second) => format!("; without a closed form {}", told(second)),
            None => "; without a closed form none gets there".to_owned(),
        };
    }
    text + "\n"
}

/// Two or three digits, not more.
struct Ratio(f64);

impl std::fmt::Display for Ratio {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let places = if self.0 < 9.95 { 1 } else { 0 };
        write!(f, "{:.places$}", self.0)
    }
}
