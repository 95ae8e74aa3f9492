//! What each effect of a scene file costs: every kind with and without each of its effects, and every file of `book/scenes`.
//!
//! `cargo bench -p book --bench prices` writes the tables in `book/src/tables`, from where the page "Scenes" and its figure take them. Times are the
//! least of several runs; evaluations of the right-hand side are the same on every machine.

#[path = "../tests/book/priced.rs"]
mod priced;

use std::fmt::Write as _;
use std::hint::black_box;
use std::path::{Path, PathBuf};

use lab::stopwatch::least;
use press::scenes::run;
use priced::PRICED;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // `cargo test --benches` passes another flag, and there is nothing to measure.
    if std::env::args().any(|argument| argument == "--bench") {
        let book = Path::new(env!("CARGO_MANIFEST_DIR"));
        let folder = book.join("src/tables");
        std::fs::write(folder.join("scene-prices.csv"), matrix()?)?;
        std::fs::write(folder.join("scene-times.csv"), files(book)?)?;
    }
    Ok(())
}

/// The machine and the compiler, as a comment.
fn here() -> String {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info.lines().find(|line| line.starts_with("model name"));
    let model = model.and_then(|line| line.split(": ").nth(1));
    let compiler = std::process::Command::new("rustc")
        .arg("--version")
        .output();
    let compiler = compiler.map(|out| String::from_utf8_lossy(&out.stdout).trim().to_owned());
    let profile = if cfg!(debug_assertions) {
        "development profile"
    } else {
        "release"
    };
    format!(
        "# {}, one core, {}, {profile}\n",
        model.unwrap_or(std::env::consts::ARCH),
        compiler.unwrap_or_default()
    )
}

/// Solver, evaluations, least milliseconds of a scene.
fn spent(text: &str) -> Result<(String, u64, f64), Box<dyn std::error::Error>> {
    let table = run("scene", text)?;
    let time = least(|| drop(black_box(run("scene", text))));
    let solver = table.plan.solver.name().to_owned();
    Ok((solver, table.cost.evaluations, time * 1e3))
}

/// Every kind of scene, with and without each of its effects.
fn matrix() -> Result<String, Box<dyn std::error::Error>> {
    let mut text = here();
    text += "kind,effect,solver_without,solver,evaluations_without,evaluations,ms_without,ms\n";
    for kind in PRICED.iter() {
        for (effect, _) in &kind.effects {
            let (without, with) = kind.pair(effect);
            let with = spent(&with)?;
            let without = without.map(|text| spent(&text)).transpose()?;
            assert_eq!(without.is_none(), kind.needed.contains(effect));
            let (solver, evaluations, ms) = without.map_or_else(Default::default, |w| {
                (w.0, w.1.to_string(), format!("{:.4}", w.2))
            });
            writeln!(
                text,
                "{},{effect},{solver},{},{evaluations},{},{ms},{:.4}",
                kind.kind, with.0, with.1, with.2
            )?;
        }
    }
    Ok(text)
}

/// Every scene of the book at its own accuracy, and at 1e-9.
fn files(book: &Path) -> Result<String, Box<dyn std::error::Error>> {
    let mut text = here();
    text += "file,solver,evaluations,ms,evaluations_at_1e-9,ms_at_1e-9\n";
    let entries = std::fs::read_dir(book.join("scenes"))?;
    let mut paths = entries
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<Result<Vec<PathBuf>, _>>()?;
    paths.sort();
    for path in paths {
        let file = std::fs::read_to_string(&path)?;
        let bare: Vec<&str> = file
            .lines()
            .filter(|line| !line.starts_with("accuracy"))
            .collect();
        let (solver, evaluations, ms) = spent(&file)?;
        // [run] stands last in every file.
        let (_, finer, longer) = spent(&format!("{}\naccuracy = 1e-9\n", bare.join("\n")))?;
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        writeln!(
            text,
            "{name},{solver},{evaluations},{ms:.4},{finer},{longer:.4}"
        )?;
    }
    Ok(text)
}
