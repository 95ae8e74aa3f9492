//! The tables of the chapter, from the command's CSV file: who is cheapest and who comes next, and where a closed form begins to pay.

use std::fmt::Write as _;

use super::table::TARGETS;

/// The longest runs that steppers take part in, each as a problem and its length, and their names in the table.
pub const RUNS: [(&str, &str); 8] = [
    ("free-top/1000", "free body"),
    ("near-separatrix/1000", "beside the separatrix"),
    ("cusped-top/1000", "top with cusps"),
    ("near-sleeping/1000", "top, nearly asleep"),
    ("kovalevskaya/1000", "Kovalevskaya’s top, upright"),
    ("kovalevskaya-level/1000", "Kovalevskaya’s top, level"),
    ("heavy-body/1000", "no closed form"),
    ("tippe-top/100", "tippe top, 100 turns"),
];
/// The method that the others are compared with.
pub const PEER: &str = "dop853";
const EXACT: &str = "exact";
/// Scenes of the book on which the judges agree to twelve digits, by their files, and their names in the table.
pub const SCENES: [(&str, &str); 3] = [
    ("strip", "a strip of paper in the air"),
    ("sliding-ball", "a ball that slides, then rolls"),
    ("yo-yo-asleep", "a yo-yo that sleeps"),
];
/// The accuracy at which closed forms and steppers are set side by side, and the lengths of the runs in turns.
const CROSSOVER: f64 = 1e-9;
const TURNS: [&str; 3] = ["1", "10", "1000"];

/// One measurement, as far as the tables need it.
#[derive(Debug)]
pub struct Row<'a> {
    /// The name of the motion.
    pub problem: &'a str,
    /// That of the method.
    pub method: &'a str,
    /// The angle, or where there is no attitude the error of the rates.
    pub error: f64,
    /// Seconds, or whatever is to be saved.
    pub price: f64,
}

/// The measurements of the command's CSV file that kept to the motion.
pub fn rows(csv: &str) -> Vec<Row<'_>> {
    let lines = csv.lines().filter(|line| !line.starts_with('#')).skip(1);
    let rows = lines.filter_map(|line| {
        let fields: Vec<&str> = line.split(',').collect();
        let [problem, method, _, angle, rates, _, _, seconds, status] = fields[..] else {
            return None;
        };
        let error = angle.parse().or_else(|_| rates.parse()).ok()?;
        let price = seconds.parse().ok()?;
        let counts = matches!(status, "ok" | "floor");
        counts.then_some(Row {
            problem,
            method,
            error,
            price,
        })
    });
    rows.collect()
}

/// The methods that reach the error on this run, cheapest first, each with its least price.
pub fn ranking<'a>(rows: &[Row<'a>], problem: &str, target: f64) -> Vec<(&'a str, f64)> {
    let mut ranked: Vec<(&str, f64)> = Vec::new();
    let good = rows
        .iter()
        .filter(|row| row.problem == problem && row.error <= target);
    for row in good {
        match ranked.iter_mut().find(|(method, _)| *method == row.method) {
            Some((_, least)) => *least = least.min(row.price),
            None => ranked.push((row.method, row.price)),
        }
    }
    ranked.sort_by(|a, b| a.1.total_cmp(&b.1));
    ranked
}

/// A Markdown table: for each of these runs and each accuracy the cheapest method and its time, the next one and dop853 as multiples of that time.
pub fn markdown(csv: &str, runs: &[(&str, &str)]) -> String {
    let rows = rows(csv);
    let mut text =
        "| motion | $10^{-3}$ | $10^{-6}$ | $10^{-9}$ | $10^{-12}$ |\n|---|---|---|---|---|\n"
            .to_owned();
    for (run, name) in runs {
        let _ = write!(text, "| {name}");
        for target in TARGETS {
            let ranked = ranking(&rows, run, target);
            let Some(&(best, least)) = ranked.first() else {
                text.push_str(" | —");
                continue;
            };
            let _ = write!(text, " | **{best}** {}", time(least));
            let peer = ranked.iter().skip(1).find(|(method, _)| *method == PEER);
            for (method, seconds) in ranked
                .get(1)
                .into_iter()
                .chain(peer.filter(|_| ranked[1].0 != PEER))
            {
                let _ = write!(text, "<br>{method} ×{}", short(seconds / least));
            }
            if ranked.len() == 1 {
                text.push_str("<br>nothing else");
            } else if peer.is_none() && best != PEER {
                let _ = write!(text, "<br>not {PEER}");
            }
        }
        text.push_str(" |\n");
    }
    text
}

/// A Markdown table: for each motion that has a closed form and each length, its time beside that of the quickest stepper to nine digits.
pub fn crossover(csv: &str) -> String {
    let rows = rows(csv);
    let mut text = "| motion | 1 turn | 10 turns | 1000 turns |\n|---|---|---|---|\n".to_owned();
    for (run, name) in RUNS {
        let (problem, _) = run.split_once('/').unwrap_or((run, ""));
        if !rows
            .iter()
            .any(|row| row.problem == run && row.method == EXACT)
        {
            continue;
        }
        let _ = write!(text, "| {name}");
        for turns in TURNS {
            let ranked = ranking(&rows, &format!("{problem}/{turns}"), CROSSOVER);
            let told = |exact: bool| {
                let first = ranked
                    .iter()
                    .find(|(method, _)| (*method == EXACT) == exact);
                first.map_or_else(
                    || {
                        if exact {
                            "no closed form".to_owned()
                        } else {
                            "no stepper".to_owned()
                        }
                    },
                    |(method, seconds)| format!("{method} {}", time(*seconds)),
                )
            };
            let cheaper = ranked.first().is_some_and(|(method, _)| *method == EXACT);
            let _ = if cheaper {
                write!(text, " | **{}**<br>{}", told(true), told(false))
            } else {
                write!(text, " | **{}**<br>{}", told(false), told(true))
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
