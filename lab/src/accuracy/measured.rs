//! The committed measurements of the command `accuracy --csv`: which method is cheapest, and from which length on the closed form is cheaper.

/// The output of the command, under a line that names machine and compiler.
pub const SWEEP: &str = include_str!("../../../book/src/tables/accuracy.csv");
/// Lengths in turns.
const LENGTHS: [u32; 3] = [1, 10, 1000];
/// Each motion, its name in the book, and the lengths in turns for which all methods followed it.
pub const MOTIONS: [(&str, &str, [u32; 3]); 8] = [
    ("free-top", "free body", LENGTHS),
    ("near-separatrix", "beside the separatrix", LENGTHS),
    ("cusped-top", "top with cusps", LENGTHS),
    ("near-sleeping", "top, nearly asleep", LENGTHS),
    ("kovalevskaya-level", "Kovalevskaya’s top, level", LENGTHS),
    ("kovalevskaya", "Kovalevskaya’s top, upright", LENGTHS),
    ("heavy-body", "no closed form", LENGTHS),
    ("tippe-top", "tippe top", [1, 10, 100]),
];
/// Accuracies at which a winner is named.
pub const TARGETS: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];
/// The name of the closed form among the methods.
pub const EXACT: &str = "exact";

/// One measurement, as far as figures and tables need it.
#[derive(Debug)]
pub struct Row<'a> {
    /// The name of the motion and its length.
    pub problem: &'a str,
    /// The name of the method.
    pub method: &'a str,
    /// The error of the attitude or, without an attitude, that of the rates.
    pub error: f64,
    /// Seconds, or another cost.
    pub price: f64,
}

/// The measurements in the command's CSV file of runs that neither failed nor diverged.
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

/// The methods that reach this error on this run, cheapest first, each with its least price.
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

/// The number of turns from which the closed form is cheaper than every method with steps, if it lies between two measured lengths;
/// between them the logarithm of the price is interpolated linearly in that of the length.
pub fn crossover(rows: &[Row<'_>], motion: &str, lengths: &[u32], target: f64) -> Option<f64> {
    // The logarithm of the price of the cheapest method with steps relative to that of the closed form.
    let gain = |turns: f64| {
        let ranked = ranking(rows, &format!("{motion}/{turns}"), target);
        let price = |exact: bool| ranked.iter().find(|row| (row.0 == EXACT) == exact);
        Some((price(false)?.1 / price(true)?.1).ln())
    };
    lengths.windows(2).find_map(|pair| {
        let [short, long] = [f64::from(pair[0]), f64::from(pair[1])];
        let [before, after] = [gain(short)?, gain(long)?];
        let crosses = before < 0.0 && after >= 0.0;
        crosses.then(|| short * (long / short).powf(before / (before - after)))
    })
}
