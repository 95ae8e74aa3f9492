//! The homogeneous ellipsoid that no dynamics can tell from the body (tutorial 2.4, 2.5).

use super::PrincipalMoments;
use crate::error::{Result, finite, positive};
use crate::precise::{Extended, Number};

/// Semi-axes in metres of the homogeneous ellipsoid of this mass with these principal moments (2.4).
///
/// a_i² = (5/2M)(I_j + I_k − I_i), a₁ ≥ a₂ ≥ a₃: long where the moment is small. A lamina gives a₃ = 0,
/// a rod a₂ = a₃ = 0. Not Poinsot's ellipsoid, whose semi-axes go as 1/√I_i.
///
/// Error: a₁ and a₂ to 2 ulp, whatever the quotients and their squares. The difference I₃ − I₂ is exact for every admissible triple, so a₃² loses
/// only what the moments themselves do not say: one rounding of I₁ − (I₃ − I₂). Cost: three roots.
///
/// # Errors
/// [`NotPositive`](crate::Error::NotPositive) or [`NotFinite`](crate::Error::NotFinite) for the mass, the latter if a semi-axis overflows.
///
/// ```
/// use spinning_bodies::inertia::{PrincipalMoments, ellipsoid_of_inertia};
/// let axes = ellipsoid_of_inertia(1.0, &PrincipalMoments::new(2.0, 3.0, 4.0)?)?;
/// assert!((axes[0] * axes[0] - 12.5).abs() < 1e-14);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn ellipsoid_of_inertia(mass: f64, moments: &PrincipalMoments) -> Result<[f64; 3]> {
    positive("the mass", mass)?;
    let [i1, i2, i3] = moments.values();
    // Twice the second moments ∫x_i²ρ; I3 − I2 is exact because I2 ≤ I3 ≤ 2 I2.
    let flatness = i3 - i2;
    let doubled = [i3 + (i2 - i1), i1 + flatness, (i1 - flatness).max(0.0)];
    let mut axes = [0.0; 3];
    for (axis, second_moment) in axes.iter_mut().zip(doubled) {
        // The square may leave the range of doubles where the axis does not.
        let square = Extended::from_double(second_moment).times(2.5) / Extended::from_double(mass);
        *axis = finite("a semi-axis", square.square_root().value())?;
    }
    Ok(axes)
}
