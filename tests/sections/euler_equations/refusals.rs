//! What is refused.

use super::*;

#[test]
fn s5_what_is_refused() {
    refused!(AxisMoments::new(0.0, 1.0, 1.0), NotPositive);
    refused!(AxisMoments::new(1.0, 1.0, 3.0), TriangleInequality);
    refused!(AxisMoments::new(1.0, f64::NAN, 3.0), NotFinite);
    let rod = InertiaMatrix::diagonal(0.0, 1.0, 1.0).unwrap();
    let still = rate_in_any_axes(&rod, OMEGA, BodyVector::zero());
    refused!(still, NotPositive);
    let lamina = moments([1.0, 2.0, 3.0]);
    refused!(SpringBody::new(lamina, 1e6, OMEGA), NotPositive);
    // Pairs so far apart that the product of two has no square.
    let omega = |unit: f64| {
        let body = SpringBody::new(moments(PLATE.map(|x| x * unit)), 4e6, OMEGA);
        body.and_then(|body| body.omega()).unwrap()
    };
    assert_eq!(omega(2f64.powi(600)), omega(1.0));
    let mut wild = SpringBody::new(moments(PLATE), 4e6, OMEGA).unwrap();
    refused!(wild.advance(200.0, 1000), NotFinite);
    let top = heavy([2.0, 2.0, 1.0], [1.0, 0.0, 0.0]);
    refused!(top.lyapunov_exponent(&START, 1.0, -1.0), NotPositive);
    refused!(top.lyapunov_exponent(&START, 1e300, 1e-9), OutOfRange);
    assert!(HeavyTop::new(lamina, vector([f64::NAN, 0.0, 0.0])).is_err());
    let one = Complex::new(1.0, 0.0);
    refused!(TruncatedFluid::new(4, &[]), Condition);
    refused!(TruncatedFluid::new(1, &[]), OutOfRange);
    refused!(TruncatedFluid::new(3, &[([3, -3], one)]), OutOfRange);
    assert!(TruncatedFluid::new(3, &[([1, 0], one * f64::NAN)]).is_err());
    let mut still = fluid(3);
    refused!(still.advance(5.0), Condition);
    assert_eq!(still, fluid(3));
}

/// A time without steps would not pass.
#[test]
fn springs_take_one_step_at_least() -> Result<()> {
    let start = SpringBody::new(moments(PLATE), 4e6, OMEGA)?;
    let after = |steps| {
        let mut springs = start.clone();
        springs.advance(1e-4, steps)?;
        springs.omega()
    };
    assert_eq!(after(0)?, after(1)?);
    assert_ne!(after(1)?, start.omega()?);
    Ok(())
}
