//! The sleep: spinning in the loop at the end of the string.

use super::YoYo;

/// Spin, rad/s, `time` seconds after falling asleep with spin `omega`, under a constant torque of friction at the axle (N m): I ω' = −torque, until it has
/// stopped. Domain: none of the three negative.
///
/// ```
/// use spinning_bodies::yo_yo::{YoYo, sleeping_spin};
/// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
/// // 3 mN m over 0.3 g m²: 10 rad/s every second.
/// assert!((sleeping_spin(&toy, 100.0, 1.0, 3e-3) - 90.0).abs() < 1e-13);
/// assert_eq!(sleeping_spin(&toy, 100.0, 11.0, 3e-3), 0.0);
/// assert!(sleeping_spin(&toy, f64::NAN, 1.0, 3e-3).is_nan());
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn sleeping_spin(toy: &YoYo, omega: f64, time: f64, torque: f64) -> f64 {
    (omega - torque * time / toy.inertia).clamp(0.0, f64::INFINITY)
}

/// Spin, rad/s, after a jerk has made the string grip: I ω = (I + m r²)ω'.
///
/// The angular momentum about the string's end is conserved while the centre, at rest before, is jerked into motion; a fraction 1/(1 + I/(m r²)) of the energy is lost.
///
/// ```
/// use spinning_bodies::yo_yo::{YoYo, spin_after_waking};
/// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
/// assert!((spin_after_waking(&toy, 100.0) - 75.0).abs() < 1e-13);
/// // An axle so thin that m r² is nothing beside I.
/// assert_eq!(spin_after_waking(&YoYo::new(1e-200, 3e-4, 1.0, 1e-100)?, 100.0), 100.0);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn spin_after_waking(toy: &YoYo, omega: f64) -> f64 {
    omega / (1.0 + toy.mass * toy.axle * toy.axle / toy.inertia)
}
