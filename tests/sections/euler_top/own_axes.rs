//! 2.3, 6.6: a free body along axes that are no principal ones.

use super::*;
use nalgebra::UnitQuaternion;
use spinning_bodies::euler_top::FreeBody;

/// The same body twice: by its principal moments, and by the matrix that a turn makes of them.
#[test]
fn s6_6_a_turned_body_moves_as_its_principal_twin() -> Result<()> {
    let moments = [0.6, 0.8, 1.0];
    let turn = UnitQuaternion::from_scaled_axis(Vector3::new(0.4, -1.1, 0.7));
    let attitude = Attitude::from_quaternion(0.1, 0.7, -0.5, 0.5)?;
    let omega = Vector3::new(1.8, 0.4, -0.9);
    let twin = EulerTop::from_omega(moments, BodyVector::from_components(omega), attitude)?;
    let [matrix, rotation] = [
        Matrix3::from_diagonal(&moments.into()),
        turn.to_rotation_matrix().into_inner(),
    ];
    let turned = rotation * matrix * rotation.transpose();
    let inertia = InertiaMatrix::from_matrix(0.5 * (turned + turned.transpose()))?;
    let start = attitude * Attitude::from(turn.inverse());
    let body = FreeBody::new(&inertia, BodyVector::from_components(turn * omega), start)?;
    let [mut apart, mut off, mut leaning] = [0.0_f64; 3];
    for t in (0..200).map(|k| 0.5 * f64::from(k)) {
        let (state, expected) = (body.at(t)?, twin.at(t)?);
        let attitude = expected.attitude * Attitude::from(turn.inverse());
        apart = apart.max(state.attitude.angle_to(&attitude));
        off = off.max((state.omega.components() - turn * expected.omega.components()).norm());
        let l = inertia.angular_momentum(state.omega);
        leaning = leaning.max((l - state.angular_momentum).norm());
    }
    // Some hundred radians are turned: a rounding of the moments becomes a hundred.
    observed!(apart, 5e-15..=2e-13);
    observed!(off, 5e-15..=2e-13);
    observed!(leaning, 1e-16..=2e-15);
    assert_eq!(body.principal().regime(), twin.regime());
    Ok(())
}

/// Rounding moves a turned lamina across I₁ + I₂ = I₃, and gives a turned rod a moment of its own.
#[test]
fn s6_6_thin_bodies_in_turned_axes() -> Result<()> {
    for moments in [[1.0, 2.0, 3.0], [0.0, 1.0, 1.0]] {
        for k in 0..200 {
            let axis = Vector3::new(0.3, -0.7, 1.1) * f64::from(k);
            let turn = UnitQuaternion::from_scaled_axis(axis);
            let rotation = turn.to_rotation_matrix().into_inner();
            let matrix = rotation * Matrix3::from_diagonal(&moments.into()) * rotation.transpose();
            let inertia = InertiaMatrix::from_matrix(0.5 * (matrix + matrix.transpose()))?;
            let omega = BodyVector::from_components(turn * Vector3::new(0.0, 0.8, 0.5));
            let body = FreeBody::new(&inertia, omega, Attitude::identity())?;
            let [first, last] = [0.0, 3.0].map(|t| body.at(t));
            let (first, last) = (first?, last?);
            let l = [&first, &last].map(|state| state.attitude.to_space(state.angular_momentum));
            observed!((l[1] - l[0]).norm(), 1e-16..=1e-14);
            observed!((first.omega - omega).norm(), 1e-16..=1e-14);
        }
    }
    Ok(())
}
