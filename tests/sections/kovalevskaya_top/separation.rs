//! 8.2: the separation of variables, roots and periods.

use super::*;

// claim: C8.2-10
#[test]
fn s8_2_the_separation_variables_obey_her_equations() -> Result<()> {
    let top = register()?;
    let roots = top.roots();
    // s from the definition along the motion by power series, ds/dt by differences.
    let (moments, lever) = (MOMENTS, [1.0, 0.0, 0.0]);
    let reference = power_series::Top { moments, lever };
    let variables = |t: f64| {
        let [o1, o2, o3, z1, z2, z3, ..] = reference.after(REGISTER, t);
        let [omega, up] = [[o1, o2, o3], [z1, z2, z3]].map(vector);
        top.separation_variables(&TopState { omega, up })
    };
    for n in [20, 50, 115, 155] {
        let t = 0.02 * f64::from(n);
        let (here, slope) = (variables(t), derivative(variables, n, 0.02));
        let solved = top.separation_variables(&top.omega_and_up(t)?);
        for i in 0..2 {
            // Observed: 2e-15.
            observed!(relative(solved[i], here[i]), 1e-16..=5e-15);
            let product: nalgebra::Complex<f64> = roots.iter().map(|e| here[i] - e).product();
            let left = ((here[0] - here[1]) * slope[i]).powi(2);
            observed!(relative(left / (4.0 * product.re), -1.0), 4e-13..=2e-11);
        }
    }
    Ok(())
}

/// Roots, periods and frequencies against values got by numerical quadrature elsewhere, eight digits.
#[test]
fn s8_2_roots_periods_and_frequencies() -> Result<()> {
    let lever = vector([1.0, 0.0, 0.0]);
    let omega = vector([1.0, 0.5, 0.3]);
    let top = KovalevskayaTop::with_up(MOMENTS, lever, omega, vector([0.6, 0.0, 0.8]))?;
    let near = |found: f64, expected: f64| {
        observed!((found - expected).abs(), 2e-9..=6e-9, "{found} {expected}")
    };
    let roots = top.roots();
    let expected = [0.643_355, -0.321_677, -0.321_677, 0.821_427, -0.189_760];
    for (root, real) in roots.iter().zip(expected) {
        observed!((root.re - real).abs(), 1e-7..=6e-7, "{root}");
    }
    assert!((roots[1].im.abs() - 0.074_512).abs() < 3e-6 && roots[1] == roots[2].conj());
    let periods = top.periods().expect("separated");
    let values = [3.118_751_94, 2.265_750_91, 11.865_809_81, -5.663_377_63];
    for (period, value) in periods.into_iter().zip(values) {
        near(period, value);
    }
    let [n1, n2] = top.frequencies().expect("separated");
    near(n1, 0.266_362_26);
    near(n2, 0.070_009_36);
    // a₁n₁ = a₂n₂ and b₁n₁ − b₂n₂ = 1.
    let [a1, b1, a2, b2] = periods;
    observed!((a1 * n1 - a2 * n2).abs(), 0.0..=1e-15);
    observed!((b1 * n1 - b2 * n2 - 1.0).abs(), 0.0..=1e-15);
    Ok(())
}
