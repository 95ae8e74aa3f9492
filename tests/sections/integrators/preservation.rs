//! What each method keeps, measured with long steps, and the table of it that the book prints.

use super::*;
use std::fmt::Write as _;

/// A tenth of a turn: what is not kept shows.
const STEP: f64 = 0.2;

/// Values in the course of 4000 steps: kept to rounding, bounded, or drifting.
fn verdict(values: &[f64]) -> &'static str {
    let scale = values[0].abs();
    let worst = |part: &[f64]| {
        part.iter()
            .fold(0.0_f64, |a, &v| a.max((v - values[0]).abs()))
            / scale
    };
    let quarter = values.len() / 4;
    let (early, late) = (worst(&values[..quarter]), worst(&values[3 * quarter..]));
    // Observed: at most 9e-14 where kept, 1.4e-11 and more elsewhere.
    if early.max(late) < 1e-12 {
        "kept"
    } else if late < 1.2 * early {
        "bounded"
    } else {
        "drifts"
    }
}

fn course(method: &dyn Follow) -> Vec<Phase> {
    let times: Vec<f64> = (0..=400).map(|n| f64::from(n) * 10.0 * STEP).collect();
    let step = STEP * (1.0 + 1e-12);
    method
        .follow(&start(), &times, Effort::Step(step))
        .unwrap()
        .states
}

fn one(method: &dyn Follow, phase: &Phase, t: f64) -> Phase {
    let step = Effort::Step(t.abs() * (1.0 + 1e-12));
    method.follow(phase, &[t], step).unwrap().states[0]
}

/// One step forward and back.
fn is_symmetric(method: &dyn Follow) -> bool {
    let there = one(method, &start(), STEP);
    let back = one(method, &there, -STEP);
    let gap = (0..3).map(|k| (back.l[k] - start().l[k]).abs());
    let worst = gap
        .chain((0..4).map(|k| (back.q[k] - start().q[k]).abs()))
        .fold(0.0, f64::max);
    worst < 1e-14
}

/// Whether one step keeps the symplectic form of phase space, dL∧dφ + the term of the moving axes, for all pairs of small changes.
fn is_symplectic(method: &dyn Follow) -> bool {
    const SMALL: f64 = 1e-5;
    // Longer still: what order 10 misses is small.
    const STEP: f64 = 0.3;
    let base = start();
    let image = one(method, &base, STEP);
    // Changes by a rotation about the body's axes, or of L.
    let changes: Vec<[f64; 6]> = (0..6)
        .map(|k| {
            let moved = |sign: f64| {
                let mut phase = base;
                if k < 3 {
                    let mut turn = [1.0, 0.0, 0.0, 0.0];
                    turn[k + 1] = 0.5 * sign * SMALL;
                    phase.q = product(phase.q, turn);
                } else {
                    phase.l[k - 3] += sign * SMALL;
                }
                one(method, &phase, STEP)
            };
            let (ahead, behind) = (moved(1.0), moved(-1.0));
            let [w, x, y, z] = image.q;
            let there = product(
                [w, -x, -y, -z],
                core::array::from_fn(|i| ahead.q[i] - behind.q[i]),
            );
            core::array::from_fn(|i| {
                let change = if i < 3 {
                    2.0 * there[i + 1]
                } else {
                    ahead.l[i - 3] - behind.l[i - 3]
                };
                change / (2.0 * SMALL)
            })
        })
        .collect();
    let form = |l: [f64; 3], a: &[f64; 6], b: &[f64; 6]| -> f64 {
        let pairing: f64 = (0..3).map(|i| b[i + 3] * a[i] - a[i + 3] * b[i]).sum();
        let volume: f64 = (0..3)
            .map(|i| l[i] * (a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]))
            .sum();
        pairing + volume
    };
    let mut worst = 0.0_f64;
    for i in 0..6 {
        for j in 0..6 {
            let unit = |k: usize| core::array::from_fn(|n| if n == k { 1.0 } else { 0.0 });
            let before = form(base.l, &unit(i), &unit(j));
            let after = form(image.l, &changes[i], &changes[j]);
            worst = worst.max((after - before).abs());
        }
    }
    // Observed: at most 2.2e-10 where kept (differences of 1e-5), at least 4e-8 where not.
    worst < 2e-9
}

fn product(p: [f64; 4], q: [f64; 4]) -> [f64; 4] {
    let ([a, b, c, d], [w, x, y, z]) = (p, q);
    [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]
}

fn row(method: &dyn Follow, moments: [f64; 3], lever: [f64; 3]) -> String {
    let course = course(method);
    let heavy = lever != [0.0; 3];
    let size: Vec<f64> = course.iter().map(|p| p.angular_momentum().norm()).collect();
    let energy: Vec<f64> = course
        .iter()
        .map(|p| {
            let up = p.up();
            (0..3)
                .map(|k| 0.5 * p.l[k] * p.l[k] / moments[k] + lever[k] * up[k])
                .sum()
        })
        .collect();
    let in_space = |axis: usize| -> Vec<f64> {
        let along = |p: &Phase| {
            p.attitude()
                .unwrap()
                .to_space(p.angular_momentum())
                .components()[axis]
        };
        course.iter().map(along).collect()
    };
    let verdicts = [0, 1, 2].map(|axis| verdict(&in_space(axis)));
    let space = if heavy {
        verdicts[2]
    } else {
        let worst = ["drifts", "bounded"]
            .into_iter()
            .find(|v| verdicts.contains(v));
        worst.unwrap_or("kept")
    };
    let norm: Vec<f64> = course
        .iter()
        .map(|p| p.q.iter().map(|x| x * x).sum::<f64>())
        .collect();
    let yes = |kept: bool| if kept { "yes" } else { "no" };
    format!(
        "| {} | {} | {} | {} | {} | {} | {} |\n",
        method.name(),
        if heavy { "—" } else { verdict(&size) },
        verdict(&energy),
        space,
        verdict(&norm),
        yes(is_symmetric(method)),
        yes(is_symplectic(method)),
    )
}

fn table() -> String {
    let mut text = String::from(
        "| method and order | size of L | energy | L in space | norm of the attitude | time symmetry | symplectic |\n|---|---|---|---|---|---|---|\n",
    );
    let mut section = |name: &str| writeln!(text, "| *{name}* | | | | | | |").unwrap();
    section("free body");
    for method in free_methods() {
        text += &row(&*method, MOMENTS, [0.0; 3]);
    }
    let mut section = |name: &str| writeln!(text, "| *{name}* | | | | | | |").unwrap();
    section("heavy top: L along the vertical");
    for method in heavy_methods_of(TOP, LEVER) {
        text += &row(&*method, TOP, LEVER);
    }
    let lever = [0.4, -0.3, 0.6];
    let mut section = |name: &str| writeln!(text, "| *{name}* | | | | | | |").unwrap();
    section("heavy body with unequal moments");
    for method in heavy_methods_of(MOMENTS, lever).iter().take(3) {
        text += &row(&**method, MOMENTS, lever);
    }
    text
}

/// The committed table is the measured one. `UPDATE_TABLES=1 cargo test --test sections preservation` writes it.
#[test]
fn the_table_of_what_is_kept() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../book/src/tables/integrators.md"
    );
    let measured = table();
    if std::env::var_os("UPDATE_TABLES").is_some() {
        std::fs::create_dir_all(concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/../../book/src/tables"
        ))
        .unwrap();
        std::fs::write(path, &measured).unwrap();
    }
    let committed = std::fs::read_to_string(path).unwrap_or_default();
    assert!(
        committed == measured,
        "what is kept has changed: UPDATE_TABLES=1 writes the table anew\n{measured}"
    );
}
