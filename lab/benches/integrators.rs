//! What a step costs: geometric methods beside the classical Runge–Kutta method, ours and the crate's, and DOP853.
//!
//! `cargo bench -p lab --bench integrators`. Times are the least of several runs.

use std::hint::black_box;

use lab::follow::{DormandPrince8, Follow};
use lab::general::GeneralMethod;
use shared::{angle, least, only_tested};
use spinning_bodies::Result;
use spinning_bodies::euler_equations::quaternion_rate;
use spinning_bodies::euler_top::EulerTop;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::integrators::geometric::{
    DoubleDouble, FreeSplitting, GroupMidpoint, HeavySplitting, Integrator, MoserVeselov,
    MuntheKaas, Order, Phase, Real, VeselovOrder, Weight,
};
use spinning_bodies::integrators::{Effort, Method};

mod shared;

/// The asymmetric body of Hairer and Vilmart (2006).
const MOMENTS: [f64; 3] = [0.6, 0.8, 1.0];
const START: [f64; 3] = [1.8, 0.4, -0.9];
const UPRIGHT: [f64; 4] = [1.0, 0.0, 0.0, 0.0];
/// A heavy symmetric top.
const TOP: [f64; 3] = [1.0, 1.0, 0.6];
const LEVER: [f64; 3] = [0.0, 0.0, 1.5];

fn main() -> Result<()> {
    if only_tested() {
        return Ok(());
    }
    // `-- steps` or `-- long` for one part alone.
    let asked = |part: &str| {
        let mut named = std::env::args()
            .skip(1)
            .filter(|argument| !argument.starts_with('-'))
            .peekable();
        named.peek().is_none() || named.any(|argument| argument == part)
    };
    if asked("steps") {
        steps()?;
    }
    if asked("eight") {
        order_eight()?;
    }
    if asked("long") {
        long_runs()?;
    }
    Ok(())
}

/// The attitude of the free body in closed form.
fn exact_attitude(t: f64) -> Result<nalgebra::UnitQuaternion<f64>> {
    let l = BodyVector::from_components(START.into());
    let top = EulerTop::new(MOMENTS, l, Attitude::identity())?;
    Ok(top.at(t)?.attitude.quaternion())
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

/// The plain method of Runge and Kutta for L and the quaternion, nothing shared, nothing spared.
fn plain(y: &[f64; 7], h: f64) -> [f64; 7] {
    let [i1, i2, i3] = MOMENTS;
    let rate = |y: &[f64; 7]| -> [f64; 7] {
        let [a, b, c, w, x, z, v] = *y;
        let [o1, o2, o3] = [a / i1, b / i2, c / i3];
        let [p, q, r, s] = quaternion_rate([w, x, z, v], BodyVector::new(o1, o2, o3));
        [
            b * o3 - c * o2,
            c * o1 - a * o3,
            a * o2 - b * o1,
            p,
            q,
            r,
            s,
        ]
    };
    let moved = |h: f64, k: &[f64; 7]| -> [f64; 7] { core::array::from_fn(|i| y[i] + h * k[i]) };
    let a = rate(y);
    let b = rate(&moved(0.5 * h, &a));
    let c = rate(&moved(0.5 * h, &b));
    let d = rate(&moved(h, &c));
    core::array::from_fn(|i| y[i] + h / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]))
}

fn steps() -> Result<()> {
    // Short runs, many of them: on a busy machine only those shorter than a time slice are undisturbed.
    const COUNT: u64 = 10_000;
    let (h, t) = (0.01, 10.0);
    let start = Phase {
        l: START,
        q: UPRIGHT,
    };
    let exact = exact_attitude(t)?;
    let exact = [exact.w, exact.i, exact.j, exact.k];
    println!(
        "free body 0.6, 0.8, 1.0: ns a step, and the attitude's error at t = 10 with 1000 steps"
    );
    let report = |name: &str, time: f64, q: [f64; 4]| {
        let error = angle(q, exact);
        println!(
            "{name:>30} {:>9.1} {error:>10.1e}",
            time / COUNT as f64 * 1e9
        );
    };
    let time = least(60, || {
        let mut y = [1.8, 0.4, -0.9, 1.0, 0.0, 0.0, 0.0];
        for _ in 0..COUNT {
            y = plain(&y, black_box(h));
        }
        black_box(y);
    });
    let mut y = [1.8, 0.4, -0.9, 1.0, 0.0, 0.0, 0.0];
    for _ in 0..1000 {
        y = plain(&y, h);
    }
    report("plain Runge-Kutta", time, [y[3], y[4], y[5], y[6]]);
    for method in free_methods()? {
        let time = least(60, || run(&*method, &start, h, COUNT));
        let mut stepper = method.start(&start, h)?;
        let alone = least(60, || {
            for _ in 0..COUNT {
                let _ = black_box(black_box(&mut stepper).step());
            }
        });
        let seen = least(60, || {
            for _ in 0..COUNT {
                let _ = black_box(black_box(&mut stepper).step());
                let _ = black_box(stepper.phase());
            }
        });
        let mut stepper = method.start(&start, h)?;
        stepper.advance(1000)?;
        report(&method.name(), time, stepper.phase()?.q);
        println!(
            "{:>30} {:>9.1}, with the phase looked at {:.1}",
            "one by one",
            alone / COUNT as f64 * 1e9,
            seen / COUNT as f64 * 1e9
        );
    }
    for (name, time) in [
        ("rotations 2, f32", of_type::<f32>(COUNT)?),
        (
            "rotations 2, two words",
            of_type::<DoubleDouble>(COUNT / 10)? * 10.0,
        ),
    ] {
        println!("{name:>30} {:>9.1}", time / COUNT as f64 * 1e9);
    }
    for (method, effort) in [
        (Method::Rk4, Effort::Step(h)),
        (Method::Dop853, Effort::Tolerance(1e-10)),
    ] {
        let general = GeneralMethod::new(MOMENTS, (), method)?;
        let end = if method == Method::Rk4 {
            h * COUNT as f64
        } else {
            50.0
        };
        let steps = general.follow(&start, &[end], effort)?.cost.steps;
        let time = least(60, || {
            let _ = black_box(general.follow(&start, &[end], effort));
        });
        let course = general.follow(&start, &[t], effort)?;
        let time = time / steps as f64 * COUNT as f64;
        report(
            &format!("{} of the crate", method.name()),
            time,
            course.states[0].q,
        );
    }
    println!("\nheavy bodies: ns a step");
    for method in heavy_methods()? {
        let time = least(60, || run(&*method, &start, h, COUNT / 10));
        println!("{:>30} {:>9.1}", method.name(), time / COUNT as f64 * 1e10);
    }
    for (method, effort) in [
        (Method::Rk4, Effort::Step(h)),
        (Method::Dop853, Effort::Tolerance(1e-10)),
    ] {
        let general = GeneralMethod::new(TOP, Weight::new(LEVER)?, method)?;
        let steps = general.follow(&start, &[20.0], effort)?.cost.steps;
        let time = least(60, || {
            let _ = black_box(general.follow(&start, &[20.0], effort));
        });
        println!(
            "{:>30} {:>9.1}",
            format!("{} of the crate", method.name()),
            time / steps as f64 * 1e9
        );
    }
    Ok(())
}

/// Ours and the crate's method of order 8: time a step, and time at the same error by interpolation between tolerances.
fn order_eight() -> Result<()> {
    let start = Phase {
        l: START,
        q: UPRIGHT,
    };
    let weight = Weight::new(LEVER)?;
    let free: [Box<dyn Follow>; 2] = [
        Box::new(GeneralMethod::new(MOMENTS, (), Method::Dop853)?),
        Box::new(DormandPrince8::new(MOMENTS, ())?),
    ];
    let heavy: [Box<dyn Follow>; 2] = [
        Box::new(GeneralMethod::new(MOMENTS, weight, Method::Dop853)?),
        Box::new(DormandPrince8::new(MOMENTS, weight)?),
    ];
    let t = 50.0;
    let exact = exact_attitude(t)?;
    let truth = DormandPrince8::new(MOMENTS, weight)?;
    let truth = truth.follow(&start, &[t], Effort::Tolerance(1e-15))?;
    println!(
        "\norder 8 over {t} s: tolerance, error, steps, microseconds, ns a step; then the ratio of times at the same error"
    );
    for (what, methods, exact) in [
        ("free", free, [exact.w, exact.i, exact.j, exact.k]),
        ("heavy, unequal moments", heavy, truth.states[0].q),
    ] {
        println!("{what}");
        let mut curves: Vec<Vec<(f64, f64)>> = Vec::new();
        for method in &methods {
            let mut curve = Vec::new();
            for decade in 2..15 {
                let effort = Effort::Tolerance(10.0_f64.powi(-decade));
                let course = method.follow(&start, &[t], effort)?;
                let steps = course.cost.steps;
                let error = angle(course.states[0].q, exact);
                let time = least(60, || {
                    let _ = black_box(method.follow(black_box(&start), &[t], effort));
                });
                println!(
                    "{:>20} {:>8.0e} {error:>9.1e} {steps:>6} {:>9.2} {:>7.0}",
                    method.name(),
                    10.0_f64.powi(-decade),
                    time * 1e6,
                    time / steps as f64 * 1e9
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
            println!(
                "{:>20} 1e-{decade}: ours takes {ratio:.2} of the crate's time",
                ""
            );
        }
    }
    Ok(())
}

fn of_type<T: Real>(count: u64) -> Result<f64> {
    let method = FreeSplitting::new(MOMENTS, Order::Two)?;
    let start = Phase {
        l: START,
        q: UPRIGHT,
    }
    .cast::<T>();
    let h = T::from_double(0.01);
    Ok(least(60, || run(&method, &start, h, count)))
}

/// So many steps from this phase.
fn run<T: Real>(method: &dyn Integrator<T>, start: &Phase<T>, h: T, count: u64) {
    let _ = black_box(method.start(black_box(start), h).and_then(|mut stepper| {
        stepper.advance(count)?;
        stepper.phase()
    }));
}

/// |L| and the energy over 10⁷ steps: the spread of the first and of the last tenth, and by how much their means differ.
fn long_runs() -> Result<()> {
    println!(
        "\n10^7 steps of 0.01 s, sampled 10^4 times: relative, spread in the first tenth, in the last, and the means' difference"
    );
    println!(
        "{:>30} {:>28} {:>28} {:>10}",
        "method", "|L|", "E", "|q| - 1"
    );
    let free = free_methods()?;
    for method in &free {
        drift_of(&**method, MOMENTS, [0.0; 3])?;
    }
    for method in &heavy_methods()?[..3] {
        drift_of(&**method, TOP, LEVER)?;
    }
    drift("plain Runge-Kutta", MOMENTS, [0.0; 3], |phase| {
        let ([a, b, c], [w, x, y, z]) = (phase.l, phase.q);
        let mut p = [a, b, c, w, x, y, z];
        for _ in 0..1000 {
            p = plain(&p, 0.01);
        }
        let [a, b, c, w, x, y, z] = p;
        *phase = Phase {
            l: [a, b, c],
            q: [w, x, y, z],
        };
        Ok(())
    })
}

/// Step by step.
fn drift_of(method: &dyn Integrator, moments: [f64; 3], lever: [f64; 3]) -> Result<()> {
    let start = Phase {
        l: START,
        q: UPRIGHT,
    };
    let mut stepper = method.start(&start, 0.01)?;
    drift(&method.name(), moments, lever, |phase| {
        for _ in 0..1000 {
            stepper.step()?;
        }
        *phase = stepper.phase()?;
        Ok(())
    })
}

fn drift(
    name: &str,
    moments: [f64; 3],
    lever: [f64; 3],
    mut advance: impl FnMut(&mut Phase) -> Result<()>,
) -> Result<()> {
    let mut phase = Phase {
        l: START,
        q: UPRIGHT,
    };
    let mut values: [Vec<f64>; 2] = [Vec::new(), Vec::new()];
    for _ in 0..10_000 {
        advance(&mut phase)?;
        let up = phase.up();
        // Of a heavy top, L along the vertical stands for |L|.
        let heavy = lever != [0.0; 3];
        let size: f64 = if heavy {
            (0..3).map(|k| phase.l[k] * up[k]).sum()
        } else {
            phase.l.iter().map(|x| x * x).sum::<f64>().sqrt()
        };
        let kinetic: f64 = (0..3)
            .map(|k| 0.5 * phase.l[k] * phase.l[k] / moments[k])
            .sum();
        let weight: f64 = (0..3).map(|k| lever[k] * up[k]).sum();
        values[0].push(size);
        values[1].push(kinetic + weight);
    }
    let norm = phase.q.iter().map(|x| x * x).sum::<f64>().sqrt() - 1.0;
    print!("{name:>30}");
    for values in values {
        let scale = values[0].abs();
        let spread = |part: &[f64]| {
            let (least, most) = part
                .iter()
                .fold((f64::INFINITY, -f64::INFINITY), |(a, b), &v| {
                    (a.min(v), b.max(v))
                });
            (most - least) / scale
        };
        let mean = |part: &[f64]| {
            part.iter().map(|v| v - values[0]).sum::<f64>() / part.len() as f64 / scale
        };
        let (first, last) = (&values[..1000], &values[9000..]);
        print!(
            " {:>8.1e} {:>8.1e} {:>10.1e}",
            spread(first),
            spread(last),
            mean(last) - mean(first)
        );
    }
    println!(" {norm:>10.1e}");
    Ok(())
}
