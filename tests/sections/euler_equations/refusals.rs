//! What is refused.

use nalgebra::Complex;
use spinning_bodies::Error;
use spinning_bodies::euler_equations::{AxisMoments, HeavyTop, SpringBody, rate_in_any_axes};
use spinning_bodies::frame::BodyVector;
use spinning_bodies::ideal_fluid::TruncatedFluid;
use spinning_bodies::inertia::InertiaMatrix;

use super::common::{OMEGA, PLATE, START, fluid, heavy, moments};

#[test]
fn s5_what_is_refused() {
    assert!(matches!(
        AxisMoments::new(0.0, 1.0, 1.0),
        Err(Error::NotPositive { .. })
    ));
    assert!(matches!(
        AxisMoments::new(1.0, 1.0, 3.0),
        Err(Error::TriangleInequality { .. })
    ));
    assert!(matches!(
        AxisMoments::new(1.0, f64::NAN, 3.0),
        Err(Error::NotFinite { .. })
    ));
    let rod = InertiaMatrix::diagonal(0.0, 1.0, 1.0).unwrap();
    assert!(matches!(
        rate_in_any_axes(&rod, OMEGA, BodyVector::zero()),
        Err(Error::NotPositive { .. })
    ));
    let lamina = moments([1.0, 2.0, 3.0]);
    assert!(matches!(
        SpringBody::new(lamina, 1e6, OMEGA),
        Err(Error::NotPositive { .. })
    ));
    let mut wild = SpringBody::new(moments(PLATE), 4e6, OMEGA).unwrap();
    assert!(matches!(
        wild.advance(200.0, 1000),
        Err(Error::NotFinite { .. })
    ));
    let top = heavy([2.0, 2.0, 1.0], [1.0, 0.0, 0.0]);
    assert!(matches!(
        top.lyapunov_exponent(&START, 1.0, -1.0),
        Err(Error::NotPositive { .. })
    ));
    assert!(matches!(
        top.lyapunov_exponent(&START, 1e300, 1e-9),
        Err(Error::OutOfRange { .. })
    ));
    assert!(HeavyTop::new(lamina, BodyVector::new(f64::NAN, 0.0, 0.0)).is_err());
    let one = Complex::new(1.0, 0.0);
    assert!(matches!(
        TruncatedFluid::new(4, &[]),
        Err(Error::Condition { .. })
    ));
    assert!(matches!(
        TruncatedFluid::new(1, &[]),
        Err(Error::OutOfRange { .. })
    ));
    assert!(matches!(
        TruncatedFluid::new(3, &[([3, -3], one)]),
        Err(Error::OutOfRange { .. })
    ));
    assert!(TruncatedFluid::new(3, &[([1, 0], one * f64::NAN)]).is_err());
    let mut still = fluid(3);
    assert!(matches!(still.advance(5.0), Err(Error::Condition { .. })));
    assert_eq!(still, fluid(3));
}
