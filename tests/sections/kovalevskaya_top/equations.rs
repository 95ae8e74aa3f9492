//! 8.1: the equations with gravity, and what stays.

use super::*;

// claim: C8.1-1
#[test]
fn s8_1_eulers_equations_with_gravity() -> Result<()> {
    for [a, b, c, o1, o2, o3, z1, z2, z3, c1, c2, c3] in points() {
        // Moments that a body has.
        let (x, y, w) = (a * a + ONE, b * b + ONE, c * c + ONE);
        let [i1, i2, i3] = [y + w, w + x, x + y];
        let [change, _] = heavy_rates([i1, i2, i3], [c1, c2, c3], [o1, o2, o3], [z1, z2, z3]);
        let displayed = [
            (i2 - i3) * o2 * o3 - (c2 * z3 - c3 * z2),
            (i3 - i1) * o3 * o1 - (c3 * z1 - c1 * z3),
            (i1 - i2) * o1 * o2 - (c1 * z2 - c2 * z1),
        ];
        let moments = AxisMoments::new(exact(i1), exact(i2), exact(i3))?;
        let top = HeavyTop::new(moments, vector([c1, c2, c3].map(exact)))?;
        let computed = top.rate(&TopState {
            omega: vector([o1, o2, o3].map(exact)),
            up: vector([z1, z2, z3].map(exact)),
        });
        for k in 0..3 {
            assert_eq!(change[k] * [i1, i2, i3][k], displayed[k]);
            // Observed: 1e-14 for numbers up to 9 and their products.
            let (found, exact) = (computed.omega.components()[k], exact(change[k]));
            assert_relative_eq!(found, exact, max_relative = 1e-14, epsilon = 1e-13);
        }
    }
    Ok(())
}

// claim: C8.1-2
#[test]
fn s8_1_the_library_keeps_energy_and_vertical_momentum() -> Result<()> {
    for [a, b, c, o1, o2, o3, z1, z2, z3, c1, c2, c3] in points() {
        // Moments that a body has.
        let [x, y, w] = [a, b, c].map(|x| exact(x * x) + 1.0);
        let moments = AxisMoments::new(y + w, w + x, x + y)?;
        let top = HeavyTop::new(moments, vector([c1, c2, c3].map(exact)))?;
        let now = TopState {
            omega: vector([o1, o2, o3].map(exact)),
            up: vector([z1, z2, z3].map(exact)),
        };
        let rate = top.rate(&now);
        let sizes = [now.omega, now.up, rate.omega, rate.up].map(|v| v.norm());
        let size = (x + y + w) * sizes.iter().sum::<f64>().powi(2);
        // All three are of second degree in the state, so this difference is the derivative along the motion.
        let slope = |kept: &dyn Fn(&TopState) -> f64| {
            let [after, before] = [1.0, -1.0].map(|d| TopState {
                omega: now.omega + d * rate.omega,
                up: now.up + d * rate.up,
            });
            0.5 * (kept(&after) - kept(&before)) / size
        };
        let slopes = [
            slope(&|s| top.energy(s)),
            slope(&|s| top.vertical_angular_momentum(s)),
            slope(&|s| s.up.dot(&s.up)),
        ];
        assert!(slopes.iter().all(|s| s.abs() < 1e-14), "{slopes:?}");
    }
    Ok(())
}

// claim: C8.1-3
#[test]
fn s8_1_energy_and_vertical_momentum_stay_and_l3_does_not() {
    let mut lost = 0;
    for [a, b, c, o1, o2, o3, z1, z2, z3, c1, c2, c3] in points() {
        let moments = [a * a, b * b, c * c].map(|x| x + ONE);
        let (omega, z, lever) = ([o1, o2, o3], [z1, z2, z3], [c1, c2, c3]);
        let [change, up_change] = heavy_rates(moments, lever, omega, z);
        let l: [R; 3] = std::array::from_fn(|i| moments[i] * omega[i]);
        let l_change: [R; 3] = std::array::from_fn(|i| moments[i] * change[i]);
        assert_eq!(dot(l, change) + dot(lever, up_change), ZERO, "dE/dt");
        assert_eq!(dot(l_change, z) + dot(l, up_change), ZERO, "dL_vert/dt");
        assert_eq!(dot(z, up_change), ZERO, "d|z|²/dt");
        // I₁ = I₂, C on axis 1: dL₃/dt = −MgC₁z₂.
        let symmetric = [moments[0], moments[0], moments[2]];
        let [change, _] = heavy_rates(symmetric, [c1, ZERO, ZERO], omega, z);
        assert_eq!(moments[2] * change[2], -c1 * z2);
        lost += usize::from(change[2] != ZERO);
    }
    // L₃ changes except where C₁z₂ = 0.
    assert!(lost > 150, "{lost} of 200");
}
