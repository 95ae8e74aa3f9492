//! What each method keeps, measured with long steps, and the table of it that the book prints.

use super::*;
use std::fs;
use std::path::Path;
use support::multiplied;

/// A tenth of a turn: what is not kept shows.
const STEP: f64 = 0.2;

/// Values in the course of 4000 steps: kept to rounding, bounded, or drifting.
fn verdict(values: &[f64]) -> &'static str {
    let scale = values[0].abs();
    let worst = |part: &[f64]| greatest(part.iter().map(|v| (v - values[0]).abs())) / scale;
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
    let step = Effort::Step(STEP * (1.0 + 1e-12));
    method.follow(&start(), &times, step).unwrap().states
}

fn one(method: &dyn Follow, phase: &Phase, t: f64) -> Phase {
    after(method, phase, t, t.abs())
}

/// One step forward and back.
fn is_symmetric(method: &dyn Follow) -> bool {
    let there = one(method, &start(), STEP);
    let back = one(method, &there, -STEP);
    let gap = (0..3).map(|k| back.l[k] - start().l[k]);
    let turn = (0..4).map(|k| back.q[k] - start().q[k]);
    greatest(gap.chain(turn).map(f64::abs)) < 1e-14
}

/// Whether one step keeps the symplectic form of phase space, dL∧dφ + the term of the moving axes, for all pairs of small changes.
fn is_symplectic(method: &dyn Follow) -> bool {
    // Longer still: what order 10 misses is small.
    const STEP: f64 = 0.3;
    let base = start();
    let image = one(method, &base, STEP);
    // Changes by a rotation about the body's axes, or of L.
    let changes: [[f64; 6]; 6] = core::array::from_fn(|k| {
        let moved = |by: f64| {
            let mut phase = base;
            if k < 3 {
                let mut turn = [1.0, 0.0, 0.0, 0.0];
                turn[k + 1] = 0.5 * by;
                phase.q = multiplied(phase.q, turn);
            } else {
                phase.l[k - 3] += by;
            }
            let (Phase { l, q }, [w, x, y, z]) = (one(method, &phase, STEP), image.q);
            let [_, x, y, z] = multiplied([w, -x, -y, -z], q);
            [2.0 * x, 2.0 * y, 2.0 * z, l[0], l[1], l[2]]
        };
        derivative(moved, 0, 1e-3)
    });
    let form = |l: [f64; 3], a: &[f64; 6], b: &[f64; 6]| -> f64 {
        let pairing: f64 = (0..3).map(|i| b[i + 3] * a[i] - a[i + 3] * b[i]).sum();
        let across = cross([a[0], a[1], a[2]], [b[0], b[1], b[2]]);
        pairing + dot(l, across)
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
    // Observed: at most 2.2e-10 where kept, at least 4e-8 where not.
    worst < 2e-9
}

fn row(method: &dyn Follow, moments: [f64; 3], lever: [f64; 3]) -> String {
    let course = course(method);
    let heavy = lever != [0.0; 3];
    let size: Vec<f64> = course.iter().map(|p| p.angular_momentum().norm()).collect();
    let kinetic_and_potential = |p: &Phase| {
        let up = p.up();
        let parts = (0..3).map(|k| 0.5 * p.l[k] * p.l[k] / moments[k] + lever[k] * up[k]);
        parts.sum()
    };
    let energy: Vec<f64> = course.iter().map(kinetic_and_potential).collect();
    let in_space = |axis: usize| -> Vec<f64> {
        let momentum = |p: &Phase| p.attitude().unwrap().to_space(p.angular_momentum());
        let along = course.iter().map(|p| momentum(p).components()[axis]);
        along.collect()
    };
    let verdicts = [0, 1, 2].map(|axis| verdict(&in_space(axis)));
    let space = if heavy {
        verdicts[2]
    } else {
        let mut worst = ["drifts", "bounded"].into_iter();
        worst.find(|v| verdicts.contains(v)).unwrap_or("kept")
    };
    let norms = course.iter().map(|p| p.q.iter().map(|x| x * x).sum());
    let norm: Vec<f64> = norms.collect();
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
    let lever = [0.4, -0.3, 0.6];
    let mut splittings = heavy_methods_of(MOMENTS, lever);
    splittings.truncate(3);
    let heavy = heavy_methods_of(TOP, LEVER);
    for (name, methods, moments, lever) in [
        ("free body", free_methods(), MOMENTS, [0.0; 3]),
        ("heavy top: L along the vertical", heavy, TOP, LEVER),
        (
            "heavy body with unequal moments",
            splittings,
            MOMENTS,
            lever,
        ),
    ] {
        text += &format!("| *{name}* | | | | | | |\n");
        for method in methods {
            text += &row(&*method, moments, lever);
        }
    }
    text
}

/// The committed table is the measured one. `UPDATE_TABLES=1 cargo test --test sections preservation` writes it.
#[test]
fn the_table_of_what_is_kept() {
    let tables = Path::new(env!("CARGO_MANIFEST_DIR")).join("../book/src/tables");
    let path = tables.join("integrators.md");
    let measured = table();
    if std::env::var_os("UPDATE_TABLES").is_some() {
        fs::create_dir_all(&tables).unwrap();
        fs::write(&path, &measured).unwrap();
    }
    let committed = fs::read_to_string(path).unwrap_or_default();
    let told = "what is kept has changed: UPDATE_TABLES=1 writes the table anew";
    assert!(committed == measured, "{told}\n{measured}");
}
