//! What stability costs: the formula of the textbook and the library's way, at the hardest step of each family, side by side in one run.
//!
//! `cargo bench -p lab --bench hard_cases` prints times and ratios; with `-- --table FILE` it writes them as the table of the book, headed by the
//! machine's name, which is asked for with `--machine NAME`. Least of many runs, both ways in turn; each includes all preparation and the
//! allocation of its result.

use std::hint::black_box;

use lab::hard_cases::{Formula, families};
use lab::stopwatch::in_turn;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().collect();
    let value = |name: &str| {
        let place = arguments.iter().position(|argument| argument == name)?;
        arguments.get(place + 1).cloned()
    };
    let machine = value("--machine").unwrap_or_else(|| "this machine".to_owned());
    let mut table = String::from("| case | textbook, ns | ours, ns | ratio |\n|---|--:|--:|--:|\n");
    for family in families() {
        let Some(hardest) = family.inputs()?.pop() else {
            continue;
        };
        let run = |way: Formula| drop(black_box(way(black_box(&hardest))));
        let times = in_turn([&mut || run(family.textbook), &mut || run(family.ours)]);
        let [a, b] = times.map(|seconds| seconds * 1e9);
        let name = family.name.replace('-', " ");
        let row = format!("| {name} | {a:.0} | {b:.0} | {:.1} |\n", b / a);
        print!("{row}");
        table += &row;
    }
    table += &format!(
        "\n*Measured on {machine}, both ways in turn, the least of many runs; preparation included.*\n"
    );
    if let Some(path) = value("--table") {
        std::fs::write(path, table)?;
    }
    Ok(())
}
