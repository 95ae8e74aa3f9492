//! 5.1: the flow on the momentum sphere.

use super::*;
use spinning_bodies::euler_equations::{Nature, fastest_flow, separatrix_slope};

#[test]
fn s5_1_the_flow_on_the_momentum_sphere() {
    let body = moments([1.0, 2.0, 3.0]);
    let l = vector([0.3, -0.5, 0.8]);
    let by_omega = l.cross(&body.angular_velocity(l));
    observed!((flow(&body, l) - by_omega).norm(), 0.0..=2e-16);
    let natures = equilibria(&body).map(|e| {
        assert_eq!(flow(&body, e.direction), BodyVector::zero());
        e.nature
    });
    let (c, s) = (Nature::Center, Nature::Saddle);
    assert_eq!(natures, [c, c, s, s, c, c]);
    // 6.7: (I₃−I₂)(I₂−I₁)/(I₂²I₁I₃) = 1/12 at the saddle, for |L| = 1.
    close!(equilibria(&body)[2].growth_squared, 1.0 / 12.0, 0.0..=3e-16);
    let round = equilibria(&moments([2.0; 3]));
    assert!(round.iter().all(|e| e.nature == Nature::Degenerate));
    // The separatrix is a great circle that the flow keeps, and it ends in the saddle.
    let sorted = PrincipalMoments::new(1.0, 2.0, 3.0).unwrap();
    let slope = separatrix_slope(&sorted);
    close!(slope, 3.0_f64.sqrt(), 0.0..=3e-16);
    let start = vector([1.0, 0.0, slope]) / 2.0;
    let path = streamline(&body, start, 0.01, 4000).unwrap();
    for p in &path[..1500] {
        // Observed 2e-11: a disturbance of the first step's error grows by e^(t/√12).
        near!(p.z(), slope * p.x(), 2e-14..=6e-13);
    }
    assert!(path[1500].y() > 0.999, "{:?}", path[1500]);
    // The fastest place, by search.
    let mut fastest: f64 = 0.0;
    for i in 0..200 {
        for j in 0..400 {
            let (s, c) = (f64::from(i) * 0.0157).sin_cos();
            let (t, d) = (f64::from(j) * 0.0157).sin_cos();
            fastest = fastest.max(flow(&body, vector([s * d, s * t, c])).norm());
        }
    }
    let bound = fastest_flow(&sorted);
    close!(bound, 1.0 / 3.0, 0.0..=3e-16);
    assert!(fastest <= bound && fastest > 0.9999 * bound);
}
