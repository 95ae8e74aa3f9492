//! The table of the chapter: who is cheapest, and by how much cheaper than dop853, from the command's CSV file.

use std::fmt::Write as _;

use super::table::TARGETS;

/// The runs of the table, each as a problem and its length, and their names in it.
const RUNS: [(&str, &str); 7] = [
    ("free-top/1000", "free body"),
    ("near-separatrix/1000", "beside the separatrix"),
    ("cusped-top/1000", "top with cusps"),
    ("near-sleeping/1000", "top, nearly asleep"),
    ("kovalevskaya/1000", "Kovalevskaya’s top"),
    ("heavy-body/1000", "no closed form"),
    ("tippe-top/100", "tippe top, 100 turns"),
];
const PEER: &str = "dop853";

struct Row<'a> {
    problem: &'a str,
    method: &'a str,
    error: f64,
    seconds: f64,
}

fn rows(csv: &str) -> Vec<Row<'_>> {
    let lines = csv.lines().filter(|line| !line.starts_with('#')).skip(1);
    let rows = lines.filter_map(|line| {
        let fields: Vec<&str> = line.split(',').collect();
        let [problem, method, _, error, _, _, _, seconds, status] = fields[..] else {
            return None;
        };
        let (error, seconds) = (error.parse().ok()?, seconds.parse().ok()?);
        let counts = matches!(status, "ok" | "floor");
        counts.then_some(Row {
            problem,
            method,
            error,
            seconds,
        })
    });
    rows.collect()
}

fn quickest<'a>(rows: impl Iterator<Item = &'a Row<'a>>, target: f64) -> Option<&'a Row<'a>> {
    let good = rows.filter(|row| row.error <= target);
    good.min_by(|a, b| a.seconds.total_cmp(&b.seconds))
}

/// A Markdown table: for each run and each accuracy the cheapest method, its time, and by what factor dop853 takes longer.
pub fn markdown(csv: &str) -> String {
    let rows = rows(csv);
    let mut text =
        "| motion | $10^{-3}$ | $10^{-6}$ | $10^{-9}$ | $10^{-12}$ |\n|---|---|---|---|---|\n"
            .to_owned();
    for (run, name) in RUNS {
        let _ = write!(text, "| {name}");
        for target in TARGETS {
            let of = || rows.iter().filter(|row| row.problem == run);
            let best = quickest(of(), target);
            let peer = quickest(of().filter(|row| row.method == PEER), target);
            let _ = match (best, peer) {
                (Some(best), Some(peer)) => write!(
                    text,
                    " | {}<br>{}, ×{}",
                    best.method,
                    time(best.seconds),
                    short(peer.seconds / best.seconds)
                ),
                (Some(best), None) => write!(
                    text,
                    " | {}<br>{}; {PEER} never",
                    best.method,
                    time(best.seconds)
                ),
                (None, _) => write!(text, " | —"),
            };
        }
        text.push_str(" |\n");
    }
    text
}

fn time(seconds: f64) -> String {
    if seconds < 1e-3 {
        format!("{}\u{a0}µs", short(1e6 * seconds))
    } else {
        format!("{}\u{a0}ms", short(1e3 * seconds))
    }
}

/// Two digits: more would not be the same tomorrow.
fn short(value: f64) -> String {
    if value < 9.95 {
        format!("{value:.1}")
    } else {
        let unit = 10.0_f64.powf(value.log10().floor() - 1.0);
        format!("{:.0}", (value / unit).round() * unit)
    }
}
