//! What a step costs: geometric methods beside the classical Runge–Kutta method, ours and the crate's, and DOP853.
//!
//! `cargo bench -p lab --bench integrators`; `-- steps`, `-- eight` or `-- long` for one part alone. Times are the least of several runs.

mod shared;

use std::hint::black_box;

use lab::follow::{DormandPrince8, Follow};
use lab::general::GeneralMethod;
use lab::stopwatch::{in_turn, least};
use shared::{head, numbers, only_tested};
use spinning_bodies::Result;
use spinning_bodies::euler_top::EulerTop;
use spinning_bodies::frame::Attitude;
use spinning_bodies::integrators::geometric::{
    DoubleDouble, FreeSplitting, GroupMidpoint, HeavySplitting, Integrator, MoserVeselov,
    MuntheKaas, Order, Phase, Real, Torque, VeselovOrder, Weight,
};
use spinning_bodies::integrators::{Effort, Method};
use support::{cross, dot, runge_kutta, turned, vector};

/// The asymmetric body of Hairer and Vilmart (2006).
const MOMENTS: [f64; 3] = [0.6, 0.8, 1.0];
const START: Phase = Phase {
    l: [1.8, 0.4, -0.9],
    q: [1.0, 0.0, 0.0, 0.0],
};
/// A heavy symmetric top.
const TOP: [f64; 3] = [1.0, 1.0, 0.6];
const LEVER: [f64; 3] = [0.0, 0.0, 1.5];
const STEP: f64 = 0.01;

fn main() -> Result<()> {
    if only_tested() {
        return Ok(());
    }
    let asked: Vec<String> = std::env::args()
        .skip(1)
        .filter(|word| !word.starts_with('-'))
        .collect();
    type Part = fn() -> Result<()>;
    let parts: [(&str, Part); 3] = [
        ("steps", steps),
        ("eight", order_eight),
        ("long", long_runs),
    ];
    for (name, part) in parts {
        if asked.is_empty() || asked.iter().any(|word| word == name) {
            part()?;
        }
    }
    Ok(())
}

/// The angle between the attitude of a phase and that of the free body in closed form.
fn off(phase: &Phase, t: f64) -> Result<f64> {
    let top = EulerTop::new(MOMENTS, vector(START.l), Attitude::identity())?;
    Ok(phase.attitude()?.angle_to(&top.at(t)?.attitude))
}

fn free_methods() -> Result<Vec<Box<dyn Integrator>>> {
    let mut all: Vec<Box<dyn Integrator>> = Vec::new();
    for order in Order::ALL {
        all.push(Box::new(FreeSplitting::new(MOMENTS, order)?));
    }
    for order in VeselovOrder::ALL {
        all.push(Box::new(MoserVeselov::new(MOMENTS, order)?));
    }
    all.push(Box::new(GroupMidpoint::new(MOMENTS)?));
    all.push(Box::new(MuntheKaas::new(MOMENTS, ())?));
    Ok(all)
}

fn heavy_methods() -> Result<Vec<Box<dyn Integrator>>> {
    let weight = Weight::new(LEVER)?;
    let mut all: Vec<Box<dyn Integrator>> = Vec::new();
    for moments in [TOP, MOMENTS] {
        for order in Order::ALL {
            all.push(Box::new(HeavySplitting::new(moments, weight, order)?));
        }
    }
    all.push(Box::new(MuntheKaas::new(TOP, weight)?));
    Ok(all)
}

/// So many steps of the plain method of Runge and Kutta for L and the quaternion, nothing shared, nothing spared.
fn plain(phase: &Phase, steps: u32) -> Phase {
    let rate = |_: f64, [a, b, c, w, x, y, z]: [f64; 7]| {
        let (l, [i1, i2, i3]) = ([a, b, c], MOMENTS);
        let omega = [a / i1, b / i2, c / i3];
        let ([p, q, r], [dw, dx, dy, dz]) = (cross(l, omega), turned([w, x, y, z], omega));
        [p, q, r, dw, dx, dy, dz]
    };
    let ([a, b, c], [w, x, y, z]) = (phase.l, phase.q);
    let start = [a, b, c, w, x, y, z];
    let [a, b, c, q @ ..] = runge_kutta(rate, start, (steps, black_box(STEP)), |_| ());
    Phase { l: [a, b, c], q }
}

/// So many steps from the start.
fn run<T: Real>(method: &dyn Integrator<T>, count: u64) -> Result<Phase<T>> {
    let mut stepper = method.start(&black_box(START).cast(), T::from_double(STEP))?;
    stepper.advance(count)?;
    stepper.phase()
}

fn steps() -> Result<()> {
    // Short runs, many of them: on a busy machine only those shorter than a time slice are undisturbed.
    const COUNT: u64 = 10_000;
    let each = |seconds: f64| 1e9 * seconds / COUNT as f64;
    let (t, few) = (10.0, 1000);
    let columns = ["of a run", "alone", "phase seen", "error at t = 10"];
    head(
        "free body 0.6, 0.8, 1.0: ns a step, and the attitude's error with 1000 steps",
        &columns,
    );
    let none = f64::NAN;
    let time = least(|| {
        black_box(plain(&START, COUNT as u32));
    });
    numbers(
        "plain Runge-Kutta",
        &[each(time), none, none, off(&plain(&START, few), t)?],
    );
    for method in free_methods()? {
        let [mut alone, mut seen] = [method.start(&START, STEP)?, method.start(&START, STEP)?];
        let seconds = in_turn([
            &mut || drop(black_box(run(&*method, COUNT))),
            &mut || {
                for _ in 0..COUNT {
                    let _ = black_box(black_box(&mut alone).step());
                }
            },
            &mut || {
                for _ in 0..COUNT {
                    let _ = black_box(black_box(&mut seen).step());
                    let _ = black_box(seen.phase());
                }
            },
        ]);
        let [run_of, alone, seen] = seconds.map(each);
        let error = off(&run(&*method, few.into())?, t)?;
        numbers(&method.name(), &[run_of, alone, seen, error]);
    }
    let method = FreeSplitting::new(MOMENTS, Order::Two)?;
    let single = least(|| drop(black_box(run::<f32>(&method, COUNT))));
    let words = least(|| drop(black_box(run::<DoubleDouble>(&method, COUNT))));
    numbers("rotations 2, f32", &[each(single)]);
    numbers("rotations 2, two words", &[each(words)]);
    general(MOMENTS, ())?;
    head("heavy bodies: ns a step", &["of a run"]);
    for method in heavy_methods()? {
        numbers(
            &method.name(),
            &[each(least(|| drop(black_box(run(&*method, COUNT)))))],
        );
    }
    general(TOP, Weight::new(LEVER)?)
}

/// What a step of the crate's methods costs.
fn general(moments: [f64; 3], torque: impl Torque<f64> + Copy + core::fmt::Debug) -> Result<()> {
    for (method, effort) in [
        (Method::Rk4, Effort::Step(STEP)),
        (Method::Dop853, Effort::Tolerance(1e-10)),
    ] {
        let general = GeneralMethod::new(moments, torque, method)?;
        let steps = general.follow(&START, &[50.0], effort)?.cost.steps;
        let time = least(|| {
            drop(black_box(general.follow(
                black_box(&START),
                &[50.0],
                effort,
            )))
        });
        numbers(
            &format!("{} of the crate", method.name()),
            &[1e9 * time / steps as f64],
        );
    }
    Ok(())
}

/// Ours and the crate's method of order 8: time a step, and time at the same error by interpolation between tolerances.
fn order_eight() -> Result<()> {
    let (t, weight) = (50.0, Weight::new(LEVER)?);
    let free: [Box<dyn Follow>; 2] = [
        Box::new(GeneralMethod::new(MOMENTS, (), Method::Dop853)?),
        Box::new(DormandPrince8::new(MOMENTS, ())?),
    ];
    let heavy: [Box<dyn Follow>; 2] = [
        Box::new(GeneralMethod::new(MOMENTS, weight, Method::Dop853)?),
        Box::new(DormandPrince8::new(MOMENTS, weight)?),
    ];
    for (what, methods) in [("free", free), ("heavy, unequal moments", heavy)] {
        head(
            &format!("order 8 over {t} s: {what}"),
            &["tolerance", "error", "steps", "us", "ns a step"],
        );
        // The library's own at its tightest judges a body that has no closed form.
        let truth = methods[1]
            .follow(&START, &[t], Effort::Tolerance(1e-15))?
            .states[0];
        let mut curves: Vec<Vec<(f64, f64)>> = Vec::new();
        for method in &methods {
            let mut curve = Vec::new();
            for tolerance in (2..15).map(|decade| 10.0_f64.powi(-decade)) {
                let effort = Effort::Tolerance(tolerance);
                let course = method.follow(&START, &[t], effort)?;
                let (found, steps) = (course.states[0], course.cost.steps as f64);
                let error = match what {
                    "free" => off(&found, t)?,
                    _ => found.attitude()?.angle_to(&truth.attitude()?),
                };
                let time =
                    least(|| drop(black_box(method.follow(black_box(&START), &[t], effort))));
                numbers(
                    &method.name(),
                    &[tolerance, error, steps, 1e6 * time, 1e9 * time / steps],
                );
                curve.push((error.ln(), time.ln()));
            }
            curves.push(curve);
        }
        for decade in [3, 6, 9, 12] {
            let error = 10.0_f64.powi(-decade).ln();
            let at = |curve: &[(f64, f64)]| {
                let pair = curve.windows(2).find(|w| w[1].0 <= error);
                pair.map_or(f64::NAN, |w| {
                    let share = ((error - w[0].0) / (w[1].0 - w[0].0)).max(0.0);
                    w[0].1 + share * (w[1].1 - w[0].1)
                })
            };
            let ratio = (at(&curves[1]) - at(&curves[0])).exp();
            numbers(&format!("at 1e-{decade}, ours over the crate's"), &[ratio]);
        }
    }
    Ok(())
}

/// |L| and the energy over 10⁷ steps: the spread of the first and of the last tenth, and by how much their means differ.
fn long_runs() -> Result<()> {
    let columns = [
        "|L|: first",
        "last tenth",
        "means apart",
        "E: first",
        "last tenth",
        "means apart",
        "|q| - 1",
    ];
    head(
        "10^7 steps of 0.01 s, sampled 10^4 times, relative",
        &columns,
    );
    let (free, heavy) = (free_methods()?, heavy_methods()?);
    let free = free.iter().map(|method| (method, MOMENTS, [0.0; 3]));
    for (method, moments, lever) in free.chain(heavy[..3].iter().map(|method| (method, TOP, LEVER)))
    {
        let mut stepper = method.start(&START, STEP)?;
        drift(&method.name(), moments, lever, |_| {
            (0..1000).try_for_each(|_| stepper.step())?;
            stepper.phase()
        })?;
    }
    drift("plain Runge-Kutta", MOMENTS, [0.0; 3], |phase| {
        Ok(plain(phase, 1000))
    })
}

fn drift(
    name: &str,
    moments: [f64; 3],
    lever: [f64; 3],
    mut advance: impl FnMut(&Phase) -> Result<Phase>,
) -> Result<()> {
    let mut phase = START;
    let mut values: [Vec<f64>; 2] = [Vec::new(), Vec::new()];
    for _ in 0..10_000 {
        phase = advance(&phase)?;
        let (l, up) = (phase.l, phase.up());
        // Of a heavy top, L along the vertical stands for |L|.
        let heavy = lever != [0.0; 3];
        values[0].push(if heavy { dot(l, up) } else { dot(l, l).sqrt() });
        let omega = [0, 1, 2].map(|k| l[k] / moments[k]);
        values[1].push(0.5 * dot(l, omega) + dot(lever, up));
    }
    let mut told = Vec::new();
    for values in values {
        let first = values[0];
        let off: Vec<f64> = values
            .iter()
            .map(|value| (value - first) / first.abs())
            .collect();
        let spread = |part: &[f64]| {
            let side = |sign: f64| {
                part.iter()
                    .map(|x| sign * x)
                    .fold(f64::NEG_INFINITY, f64::max)
            };
            side(1.0) + side(-1.0)
        };
        let mean = |part: &[f64]| part.iter().sum::<f64>() / part.len() as f64;
        let (early, late) = (&off[..1000], &off[9000..]);
        told.extend([spread(early), spread(late), mean(late) - mean(early)]);
    }
    told.push(phase.q.iter().map(|x| x * x).sum::<f64>().sqrt() - 1.0);
    numbers(name, &told);
    Ok(())
}
