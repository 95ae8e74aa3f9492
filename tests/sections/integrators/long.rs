//! Long runs: invariants neither drift nor spread, however many steps.

use super::*;

/// |L| of a free body or L along the vertical, and the energy.
fn invariants(phase: &Phase, moments: [f64; 3], lever: [f64; 3]) -> [f64; 2] {
    let (up, l, free) = (phase.up(), phase.l, lever == [0.0; 3]);
    let halves = (0..3).map(|k| 0.5 * phase.l[k] * phase.l[k] / moments[k]);
    let size = if free { dot(l, l).sqrt() } else { dot(l, up) };
    [size, halves.sum::<f64>() + dot(lever, up)]
}

/// By how much the invariants are off after many steps, relative to their start: (greatest |ΔM|/M, means of E in the first and last tenth apart).
fn run(method: &dyn Integrator, moments: [f64; 3], lever: [f64; 3], samples: usize) -> [f64; 3] {
    let mut stepper = method.start(&start(), 0.01).unwrap();
    let first = invariants(&start(), moments, lever);
    let mut energies = Vec::new();
    let mut worst = 0.0_f64;
    for _ in 0..samples {
        stepper.advance(1000).unwrap();
        let now = invariants(&stepper.phase().unwrap(), moments, lever);
        worst = worst.max((now[0] / first[0] - 1.0).abs());
        energies.push(now[1] / first[1] - 1.0);
    }
    let mean = |part: &[f64]| part.iter().sum::<f64>() / part.len() as f64;
    let tenth = samples / 10;
    let trend = mean(&energies[samples - tenth..]) - mean(&energies[..tenth]);
    let spread = greatest(energies.iter().map(|x| x.abs()));
    [worst, trend.abs(), spread]
}

/// 4·10⁵ steps of free bodies and 10⁵ of others here, 10⁷ in the benchmark `integrators`.
#[test]
fn nothing_drifts() {
    // The mean of an oscillation of O(stepᵖ) over forty samples is not quite zero. Observed: 2.6e-8, 2.8e-15, 5.5e-16.
    for (order, allowed) in Order::ALL.into_iter().zip([1e-7, 1e-14, 2e-15]) {
        let free = FreeSplitting::new(MOMENTS, order).unwrap();
        let [size, trend, _] = run(&free, MOMENTS, [0.0; 3], 400);
        // Observed: 6.7e-16.
        within(size, 2e-15);
        within(trend, allowed);
    }
    for order in VeselovOrder::ALL {
        let discrete = MoserVeselov::new(MOMENTS, order).unwrap();
        let [size, _, spread] = run(&discrete, MOMENTS, [0.0; 3], 100);
        // Observed: 6.7e-16 and 1.6e-15.
        within(size, 2e-15);
        within(spread, 4e-15);
    }
    let midpoint = GroupMidpoint::new(MOMENTS).unwrap();
    let [size, _, spread] = run(&midpoint, MOMENTS, [0.0; 3], 100);
    assert!(size < 2e-15 && spread < 4e-15, "{size:e} {spread:e}");
    // Observed: 1.7e-6, 8.8e-14, 2.4e-16.
    for (order, allowed) in Order::ALL.into_iter().zip([5e-6, 3e-13, 2e-15]) {
        let heavy = HeavySplitting::new(TOP, Weight::new(LEVER).unwrap(), order).unwrap();
        let [size, trend, _] = run(&heavy, TOP, LEVER, 100);
        // Observed: 2.4e-15.
        within(size, 6e-15);
        within(trend, allowed);
    }
}

/// One step alone is a step of a run: the same bits, however often the phase is looked at; and L stays in space over 3·10⁵ of them, |L| over 10⁷ in
/// the benchmark `integrators`.
#[test]
fn a_step_alone_is_a_step_of_a_run() {
    let weight = Weight::new([0.4, -0.3, 0.6]).unwrap();
    let mut all: Vec<Box<dyn Integrator>> = Vec::new();
    for order in Order::ALL {
        all.push(Box::new(FreeSplitting::new(MOMENTS, order).unwrap()));
        for moments in [MOMENTS, TOP] {
            all.push(Box::new(
                HeavySplitting::new(moments, weight, order).unwrap(),
            ));
        }
    }
    for order in VeselovOrder::ALL {
        all.push(Box::new(MoserVeselov::new(MOMENTS, order).unwrap()));
    }
    all.push(Box::new(GroupMidpoint::new(MOMENTS).unwrap()));
    all.push(Box::new(MuntheKaas::new(MOMENTS, ()).unwrap()));
    for method in all {
        let mut run = method.start(&start(), 0.01).unwrap();
        let mut alone = method.start(&start(), 0.01).unwrap();
        run.advance(1000).unwrap();
        for _ in 0..1000 {
            alone.step().unwrap();
            alone.phase().unwrap();
        }
        assert_eq!(alone.phase(), run.phase(), "{}", method.name());
        assert_eq!(alone.cost(), run.cost(), "{}", method.name());
    }
    // With two equal moments all steps are alike, and so are their rounding errors.
    let in_space = |p: &Phase| p.attitude().unwrap().to_space(p.angular_momentum());
    for moments in [MOMENTS, TOP] {
        let free = FreeSplitting::new(moments, Order::Two).unwrap();
        let mut alone = free.start(&start(), 0.01).unwrap();
        let (first, mut worst) = (in_space(&start()), 0.0_f64);
        for _ in 0..300_000 {
            alone.step().unwrap();
            let now = in_space(&alone.phase().unwrap());
            worst = worst.max((now - first).norm() / first.norm());
        }
        observed!(worst, 2e-16..=3e-15);
    }
}
