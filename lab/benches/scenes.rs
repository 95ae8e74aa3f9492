//! What an effect costs: the same motion with it and without it, in one run.
//!
//! `cargo bench -p lab --bench scenes`. Times are the least of several runs; evaluations of the right-hand side are the same on
//! every machine. With `-- --csv`, every kind with and without each of its effects, and every file of `book/scenes`, into
//! `book/src/tables`, from where the page "Scenes" and its figure take them.

use std::fmt::Write as _;
use std::hint::black_box;
use std::path::{Path, PathBuf};

mod shared;

use lab::stopwatch::{in_turn, least};
use press::scenes::prices::{PRICED, run};
use shared::{head, numbers};
use spinning_bodies::euler_top::EulerTop;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::integrators::Method;
use spinning_bodies::scene::top::{
    AirDrag, BearingFriction, Body, Gravity, PivotFriction, Start, TipFriction, Top,
};
use spinning_bodies::scene::{Choice, Request, Scene, Solver};

type Outcome = Result<(), Box<dyn std::error::Error>>;

fn main() -> Outcome {
    if shared::only_tested() {
        return Ok(());
    }
    if std::env::args().any(|argument| argument == "--csv") {
        let book = Path::new(env!("CARGO_MANIFEST_DIR")).join("../book");
        let folder = book.join("src/tables");
        std::fs::create_dir_all(&folder)?;
        std::fs::write(folder.join("scene-prices.csv"), matrix()?)?;
        std::fs::write(folder.join("scene-times.csv"), files(&book)?)?;
        return Ok(());
    }
    nothing()?;
    Ok(prices()?)
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

/// A scene without effects beside the free top called directly: set-up and ten thousand states each.
fn nothing() -> spinning_bodies::Result<()> {
    let (moments, omega) = ([1.0, 2.0, 3.0], BodyVector::new(0.4, 0.3, 1.0));
    let times: Vec<f64> = (0..10_000).map(|i| 0.01 * f64::from(i)).collect();
    let start = Start::with_omega(omega, Attitude::identity());
    let scene = Top::new(Body::new(moments)?, start)?;
    let request = Request::at(times.clone())?;
    let direct = || EulerTop::from_omega(moments, omega, Attitude::identity());
    let seconds = in_turn([
        &mut || {
            if let Ok(top) = black_box(direct()) {
                times.iter().for_each(|&t| drop(black_box(top.at(t))));
            }
        },
        &mut || {
            let rows = |top: EulerTop| times.iter().map(|&t| Ok((t, top.at(t)?))).collect();
            let kept: spinning_bodies::Result<Vec<_>> = black_box(direct()).and_then(rows);
            let _ = black_box(kept);
        },
        &mut || drop(black_box(scene.simulate(&request))),
    ]);
    head(
        "a scene without effects, over 10000 states",
        &["ns a state", "ratio"],
    );
    let names = [
        "EulerTop called directly",
        "and its states kept",
        "simulate: rows and ledger",
    ];
    for (name, time) in names.into_iter().zip(seconds) {
        numbers(name, &[time / times.len() as f64 * 1e9, time / seconds[0]]);
    }
    Ok(())
}

/// One effect more at a time, for a general method: ns an evaluation, evaluations, ms a run.
fn prices() -> spinning_bodies::Result<()> {
    let center = BodyVector::new(0.0, 0.0, 0.04);
    let body = Body::new([2.0e-4, 2.0e-4, 7.0e-5])?.with_center_of_mass(0.1, center)?;
    let tilted = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), 0.5)?;
    let start = Start::with_omega(BodyVector::new(0.0, 0.0, 188.5), tilted);
    let none = Top::new(body, start)?;
    let gravity = none.with(Gravity::new(9.81)?)?;
    let tops = [
        ("nothing", none),
        ("gravity", gravity),
        (
            "and pivot friction",
            gravity.with(PivotFriction::new(1e-6)?)?,
        ),
        (
            "and bearing friction",
            gravity.with(BearingFriction::new(1e-6)?)?,
        ),
        ("and air drag", gravity.with(AirDrag::new(1e-8)?)?),
        ("and tip friction", gravity.with(TipFriction::new(1e-6)?)?),
    ];
    let request = Request::at([1.0])?.to_accuracy(1e-9)?;
    let request = request
        .with_methods(&lab::general::DifferentialEquations)
        .by(Choice::Use(Solver::General(Method::Dop853)));
    let columns = ["evaluations", "ms", "ns/evaluation"];
    head(
        "one second of a top at 30 turns a second, DOP853 to 1e-9",
        &columns,
    );
    for (name, scene) in tops {
        let evaluations = scene.simulate(&request)?.cost.evaluations as f64;
        let time = least(|| drop(black_box(scene.simulate(&request))));
        numbers(name, &[evaluations, time * 1e3, time / evaluations * 1e9]);
    }
    Ok(())
}
