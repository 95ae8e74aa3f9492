//! What an effect costs: the same motion with it and without it, in one run.
//!
//! `cargo bench -p lab --bench scenes`. Times are the least of several runs; evaluations of the right-hand side are the same on
//! every machine.

use std::hint::black_box;

mod shared;

use lab::stopwatch::{in_turn, least};
use shared::{head, numbers};
use spinning_bodies::euler_top::EulerTop;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::integrators::Method;
use spinning_bodies::scene::top::{
    AirDrag, BearingFriction, Body, Gravity, PivotFriction, Start, TipFriction, Top,
};
use spinning_bodies::scene::{Choice, Request, Scene, Solver};

fn main() -> spinning_bodies::Result<()> {
    if shared::only_tested() {
        return Ok(());
    }
    nothing()?;
    prices()
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
