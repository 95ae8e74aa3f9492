//! The attitude that goes with her solution.

use super::*;

#[test]
fn the_attitude_carries_up_and_moves_with_omega() -> Result<()> {
    let (lever, omega) = (vector([0.3, -0.4, 0.0]), vector([1.0, 0.5, 0.3]));
    let start = Attitude::from_quaternion(0.3, -0.5, 0.7, 0.2)?;
    let top = KovalevskayaTop::new([1.0, 1.0, 0.5], lever, omega, start)?;
    let times = [0.0, 0.5, 1.0, 4.0, 12.0];
    for (t, state) in times.into_iter().zip(top.states(times)) {
        let state = state?;
        let alone = top.at(t)?;
        observed!(alone.attitude.angle_to(&state.attitude), 0.0..=4e-15);
        let up = state.attitude.to_body(SpaceVector::new(0.0, 0.0, 1.0));
        observed!((up - state.up).norm(), 1e-16..=2e-15);
        // Ω is the angle turned in a short time, to the second order of it.
        let h = 1e-4;
        let (before, after) = (top.at(t - h)?.attitude, top.at(t + h)?.attitude);
        let turn = before.quaternion().inverse() * after.quaternion();
        let rate = vector((turn.imag() * (1.0 / h) * turn.w.signum()).into());
        observed!((rate - state.omega).norm(), 3e-9..=1e-7, "{rate:?}");
    }
    Ok(())
}
