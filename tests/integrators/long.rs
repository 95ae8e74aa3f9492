//! Long runs: invariants neither drift nor spread, however many steps.

use spinning_bodies::integrators::geometric::{
    FreeSplitting, GroupMidpoint, HeavySplitting, Integrator, MoserVeselov, Order, Phase,
    SymmetricDrift, VeselovOrder, Weight,
};

use super::common::{LEVER, MOMENTS, TOP, start};

/// |L| of a free body or L along the vertical, and the energy.
fn invariants(phase: &Phase, moments: [f64; 3], lever: [f64; 3]) -> [f64; 2] {
    let up = phase.up();
    let kinetic: f64 = (0..3)
        .map(|k| 0.5 * phase.l[k] * phase.l[k] / moments[k])
        .sum();
    let potential: f64 = (0..3).map(|k| lever[k] * up[k]).sum();
    let size = if lever == [0.0; 3] {
        phase.l.iter().map(|x| x * x).sum::<f64>().sqrt()
    } else {
        (0..3).map(|k| phase.l[k] * up[k]).sum()
    };
    [size, kinetic + potential]
}

/// By how much the invariants are off after many steps, relative to their start: (greatest |ΔM|/M, means of E in the first and last tenth apart).
fn run(method: &dyn Integrator, moments: [f64; 3], lever: [f64; 3], samples: usize) -> [f64; 3] {
    let mut phase = start();
    let first = invariants(&phase, moments, lever);
    let mut energies = Vec::new();
    let mut worst = 0.0_f64;
    for _ in 0..samples {
        method.advance(&mut phase, 0.01, 1000).unwrap();
        let now = invariants(&phase, moments, lever);
        worst = worst.max((now[0] / first[0] - 1.0).abs());
        energies.push(now[1] / first[1] - 1.0);
    }
    let mean = |part: &[f64]| part.iter().sum::<f64>() / part.len() as f64;
    let tenth = samples / 10;
    let trend = mean(&energies[samples - tenth..]) - mean(&energies[..tenth]);
    let spread = energies.iter().fold(0.0_f64, |a, &b| a.max(b.abs()));
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
        assert!(
            size < 2e-15 && trend < allowed,
            "{order:?} {size:e} {trend:e}"
        );
    }
    for order in VeselovOrder::ALL {
        let discrete = MoserVeselov::new(MOMENTS, order).unwrap();
        let [size, _, spread] = run(&discrete, MOMENTS, [0.0; 3], 100);
        // Observed: 6.7e-16 and 1.6e-15.
        assert!(
            size < 2e-15 && spread < 4e-15,
            "{order:?} {size:e} {spread:e}"
        );
    }
    let midpoint = GroupMidpoint::new(MOMENTS).unwrap();
    let [size, _, spread] = run(&midpoint, MOMENTS, [0.0; 3], 100);
    assert!(size < 2e-15 && spread < 4e-15, "{size:e} {spread:e}");
    // Observed: 1.7e-6, 8.8e-14, 2.4e-16.
    for (order, allowed) in Order::ALL.into_iter().zip([5e-6, 3e-13, 2e-15]) {
        let drift = SymmetricDrift::new(TOP).unwrap();
        let heavy = HeavySplitting::new(drift, Weight::new(LEVER).unwrap(), order);
        let [size, trend, _] = run(&heavy, TOP, LEVER, 100);
        // Observed: 2.4e-15.
        assert!(
            size < 6e-15 && trend < allowed,
            "{order:?} {size:e} {trend:e}"
        );
    }
}
