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

/// 4·10⁵ steps here, 10⁷ in the benchmark `integrators`.
#[test]
fn nothing_drifts() {
    let samples = 400;
    for order in Order::ALL {
        let free = FreeSplitting::new(MOMENTS, order).unwrap();
        let [size, trend, spread] = run(&free, MOMENTS, [0.0; 3], samples);
        println!("rotations {order:?}: {size:e} {trend:e} {spread:e}");
        assert!(size < 4e-15, "{order:?} {size:e}");
        // The mean of an oscillation of O(step²) over 40 samples is not zero; of the higher orders there is less to see.
        assert!(
            trend < [2e-5, 2e-11, 2e-15][order.number() as usize / 2 - 1],
            "{order:?} {trend:e}"
        );
    }
    for order in VeselovOrder::ALL {
        let discrete = MoserVeselov::new(MOMENTS, order).unwrap();
        let [size, trend, spread] = run(&discrete, MOMENTS, [0.0; 3], samples / 4);
        println!("Moser-Veselov {order:?}: {size:e} {trend:e} {spread:e}");
        assert!(
            size < 4e-15 && spread < 4e-15,
            "{order:?} {size:e} {spread:e}"
        );
    }
    let midpoint = GroupMidpoint::new(MOMENTS).unwrap();
    let [size, _, spread] = run(&midpoint, MOMENTS, [0.0; 3], samples / 4);
    assert!(size < 4e-15 && spread < 4e-15, "{size:e} {spread:e}");
    for order in Order::ALL {
        let drift = SymmetricDrift::new(TOP).unwrap();
        let heavy = HeavySplitting::new(drift, Weight::new(LEVER).unwrap(), order);
        let [size, trend, spread] = run(&heavy, TOP, LEVER, samples / 4);
        println!("heavy {order:?}: {size:e} {trend:e} {spread:e}");
        assert!(size < 2e-14, "{order:?} {size:e}");
    }
}
