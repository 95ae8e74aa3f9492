//! 8.3: the lattice that came next.

use super::*;
use spinning_bodies::kovalevskaya_top::toda::{Ends, Lattice};

// claim: C8.3-1
#[test]
fn s8_3_seventy_eight_years() {
    let (kovalevskaya, steklov_and_lyapunov, goryachev, toda) = (1889, 1893, 1900, 1967);
    assert_eq!(toda - kovalevskaya, 78);
    // Hers was not the last of its century: the condition on the claim.
    assert!((kovalevskaya..=1900).contains(&steklov_and_lyapunov));
    assert!((kovalevskaya..=1900).contains(&goryachev));
    // Goryachev's remark with code: kept on the level L_vert = 0, and only there.
    let moments = AxisMoments::new(4.0, 4.0, 1.0).expect("a body");
    let top = HeavyTop::new(moments, vector([1.0, 0.0, 0.0])).expect("a top");
    assert_eq!(top.kind(), Integrability::OnLevelZero(2));
    let omega = vector([0.7, 0.3, 0.5]);
    let level = |z: [f64; 3]| {
        let up = vector(z).direction("up").expect("a direction");
        let state = TopState { omega, up };
        let integral = top.further_integral(&state).expect("hers");
        (top.vertical_angular_momentum(&state), integral)
    };
    let (vertical, integral) = level([0.261225, -0.217688, -0.940411]);
    observed!(vertical.abs(), 4e-7..=3e-6);
    observed!(integral.rate.abs(), 3e-8..=1e-7);
    observed!(relative(integral.value, 0.948_287_88), 4e-9..=2e-7);
    assert!(level([0.0, 0.0, 1.0]).1.rate.abs() > 0.02);
}

// claim: C8.3-2
#[test]
fn s8_3_the_toda_lattice_keeps_its_eigenvalues() -> Result<()> {
    let (positions, momenta) = ([0.3, -0.2, 0.1, -0.2], [0.5, -0.4, 0.3, -0.4]);
    for ends in [Ends::Open, Ends::Periodic] {
        let mut lattice = Lattice::new(ends, &positions, &momenta)?;
        let (start, energy) = (lattice.eigenvalues()?, lattice.energy());
        // 4 tr L² = Σp² + 2Σe^{−gap} = 2H.
        let trace: f64 = start.iter().map(|x| x * x).sum();
        close!(2.0 * trace, energy, 8.0 * EPS);
        lattice.advance(0.01, 5000)?;
        for (now, before) in lattice.eigenvalues()?.iter().zip(&start) {
            // Observed after 50 units of time: 3e-14.
            near!(now, before, 1e-12);
        }
    }
    // Three particles in a ring.
    let ring = Lattice::new(Ends::Periodic, &[0.2, -0.1, -0.1], &[0.6, -0.2, -0.4])?;
    let known = [-0.663_507_44, -0.384_128_71, 1.047_636_16];
    for (value, expected) in ring.eigenvalues()?.into_iter().zip(known) {
        observed!(relative(value, expected), 3e-9..=1e-7);
    }
    // What the eigenvalues are: let the open lattice fly apart, and the momenta come to 2λ, sorted.
    let mut open = Lattice::new(Ends::Open, &positions, &momenta)?;
    let values = open.eigenvalues()?;
    open.advance(0.01, 12_000)?;
    for (p, value) in open.momenta().iter().zip(values) {
        near!(*p, 2.0 * value, 1e-9);
    }
    Ok(())
}
