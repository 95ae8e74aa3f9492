//! The homogeneous ellipsoid that no dynamics can tell from the body (tutorial 2.4, 2.5).

use super::moments::PrincipalMoments;
use crate::error::{Result, finite, positive};
use crate::precise::{Extended, Number};

/// Semi-axes in metres of the homogeneous ellipsoid of this mass with these principal moments (2.4).
///
/// a_i² = (5/2M)(I_j + I_k − I_i), a₁ ≥ a₂ ≥ a₃: long where the moment is small. A lamina gives a₃ = 0,
/// a rod a₂ = a₃ = 0. Not Poinsot's ellipsoid, whose semi-axes go as 1/√I_i.
///
/// Error: one rounding each, of a₃ too: I₁ − (I₃ − I₂) is formed in 106 bits. Cost: three roots of 106 bits.
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
    // Squares and sums may leave the range of doubles where an axis does not.
    let [mass, flat] = [mass, 0.0].map(Extended::from_double);
    let [i1, i2, i3] = moments.values().map(Extended::from_double);
    // Twice the second moments ∫x_i²ρ.
    let doubled = [i3 + (i2 - i1), i1 + (i3 - i2), flat.greater(i1 - (i3 - i2))];
    let mut axes = [0.0; 3];
    for (axis, second_moment) in axes.iter_mut().zip(doubled) {
        let square = second_moment.times(2.5).quotient(mass);
        *axis = finite("a semi-axis", square.square_root().value())?;
    }
    Ok(axes)
}
