//! What an effect costs: the same motion with it and without it, in one run.
//!
//! `cargo bench -p bench --bench scenes`. Times are the least of several runs; evaluations of the right-hand side are the same on
//! every machine.

use std::hint::black_box;
use std::time::Instant;

use spinning_bodies::euler_top::EulerTop;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::integrators::Method;
use spinning_bodies::scene::top::{
    AirDrag, BearingFriction, Body, Gravity, Listed, PivotFriction, Start, TipFriction, Top,
};
use spinning_bodies::scene::{Choice, Request, Solver};

fn main() -> spinning_bodies::Result<()> {
    // `cargo test --benches` passes this flag; there is nothing to measure then.
    if std::env::args().any(|argument| argument == "--test") {
        return Ok(());
    }
    nothing()?;
    prices()
}

/// Least time of `runs` calls, seconds.
fn least(runs: usize, mut work: impl FnMut()) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..runs {
        let start = Instant::now();
        work();
        best = best.min(start.elapsed().as_secs_f64());
    }
    best
}

/// A scene without effects beside the free top called directly: set-up and ten thousand states each.
fn nothing() -> spinning_bodies::Result<()> {
    let (moments, omega) = ([1.0, 2.0, 3.0], BodyVector::new(0.4, 0.3, 1.0));
    let times: Vec<f64> = (0..10_000).map(|i| 0.01 * f64::from(i)).collect();
    let start = Start::with_omega(omega, Attitude::identity());
    let scene = Top::new(Body::new(moments)?, start)?;
    let request = Request::at(times.clone())?;
    let (mut direct, mut form, mut whole) = (f64::INFINITY, f64::INFINITY, f64::INFINITY);
    // Alternately, so that all see the same machine.
    for _ in 0..40 {
        direct = direct.min(least(1, || {
            if let Ok(top) = EulerTop::from_omega(moments, omega, Attitude::identity()) {
                for &t in &times {
                    let _ = black_box(top.at(t));
                }
            }
        }));
        form = form.min(least(1, || {
            if let Ok(top) = scene.free_top() {
                for &t in &times {
                    let _ = black_box(top.at(t));
                }
            }
        }));
        whole = whole.min(least(1, || {
            let _ = black_box(spinning_bodies::scene::Scene::simulate(&scene, &request));
        }));
    }
    println!("a scene without effects, ns a state over 10000 states");
    let count = times.len() as f64;
    for (name, time) in [
        ("EulerTop called directly", direct),
        ("the scene's free top", form),
        ("simulate: rows and ledger", whole),
    ] {
        println!(
            "{name:>28} {:>8.1} ratio {:.3}",
            time / count * 1e9,
            time / direct
        );
    }
    Ok(())
}

/// One effect more at a time, for a general method: ns an evaluation, evaluations, ms a run.
fn prices() -> spinning_bodies::Result<()> {
    let center = BodyVector::new(0.0, 0.0, 0.04);
    let body = Body::new([2.0e-4, 2.0e-4, 7.0e-5])?.with_center_of_mass(0.1, center)?;
    let tilted = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), 0.5)?;
    let start = Start::with_omega(BodyVector::new(0.0, 0.0, 188.5), tilted);
    let none = Listed::default();
    let gravity = Listed {
        gravity: Some(Gravity::new(9.81)?),
        ..none
    };
    let lists = [
        ("nothing", none),
        ("gravity", gravity),
        (
            "and pivot friction",
            Listed {
                pivot_friction: Some(PivotFriction::new(1e-6)?),
                ..gravity
            },
        ),
        (
            "and bearing friction",
            Listed {
                bearing_friction: Some(BearingFriction::new(1e-6)?),
                ..gravity
            },
        ),
        (
            "and air drag",
            Listed {
                air_drag: Some(AirDrag::new(1e-8)?),
                ..gravity
            },
        ),
        (
            "and tip friction",
            Listed {
                tip_friction: Some(TipFriction::new(1e-6)?),
                ..gravity
            },
        ),
    ];
    let request = Request::at([1.0])?.to_accuracy(1e-9)?;
    let request = request.by(Choice::Use(Solver::General(Method::Dop853)));
    println!("\none second of a top at 30 turns a second, DOP853 to 1e-9");
    println!(
        "{:>22} {:>12} {:>8} {:>14}",
        "effects", "evaluations", "ms", "ns/evaluation"
    );
    for (name, list) in lists {
        let scene = list.on(body, start)?;
        let evaluations = scene.simulate(&request)?.cost.evaluations;
        let time = least(7, || {
            let _ = black_box(scene.simulate(&request));
        });
        let each = time / evaluations as f64 * 1e9;
        println!(
            "{name:>22} {evaluations:>12} {:>8.2} {each:>14.1}",
            time * 1e3
        );
    }
    Ok(())
}
