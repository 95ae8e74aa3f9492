//! What stability costs: the formula of the textbook and the library's way, at the hardest step of each family, side by side in one run.
//!
//! `cargo bench -p bench --bench hard_cases` prints times and ratios; with `-- --table FILE` it writes them as the table of the book, headed by the
//! machine's name, which is asked for with `--machine NAME`. Least of many runs, both ways in turn; each includes all preparation and the
//! allocation of its result.

use std::hint::black_box;

use spinning_bodies::Result;
use spinning_bodies::hard_cases::{Way, families};

#[path = "support/mod.rs"]
mod support;
use support::{least, only_tested};

const TOGETHER: u32 = 50;

fn main() -> Result<()> {
    if only_tested() {
        return Ok(());
    }
    let arguments: Vec<String> = std::env::args().collect();
    let value = |name: &str| {
        let place = arguments.iter().position(|argument| argument == name)?;
        arguments.get(place + 1).cloned()
    };
    let machine = value("--machine").unwrap_or_else(|| "this machine".to_owned());
    let mut table = String::from("| case | textbook, ns | ours, ns | ratio |\n|---|---|---|---|\n");
    for family in families() {
        let step = family.steps() - 1;
        let time = |way: Way| {
            // Many at a time: one takes no longer than a look at the clock.
            let together = least(100, || {
                for _ in 0..TOGETHER {
                    let _ = black_box(black_box(&family).run(black_box(step), way));
                }
            });
            together / f64::from(TOGETHER)
        };
        let (mut textbook, mut ours) = (f64::INFINITY, f64::INFINITY);
        for _ in 0..5 {
            textbook = textbook.min(time(Way::Textbook));
            ours = ours.min(time(Way::Ours));
        }
        let [a, b] = [textbook, ours].map(|seconds| seconds * 1e9);
        let name = family.name().replace('-', " ");
        let row = format!("| {name} | {a:.0} | {b:.0} | {:.1} |", b / a);
        println!("{row}");
        table += &row;
        table.push('\n');
    }
    table += &format!(
        "\n*Measured on {machine}, both ways in turn, the least of many runs; preparation included.*\n"
    );
    if let Some(path) = value("--table")
        && let Err(error) = std::fs::write(&path, table)
    {
        eprintln!("{path}: {error}");
        std::process::exit(1);
    }
    Ok(())
}
