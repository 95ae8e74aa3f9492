//! Stability of permanent rotations (tutorial 6.3, 6.7): linear rates, and the integrals that prove what linearisation cannot.
//!
//! The moments ascend, so x₁, x₂, x₃ are the axes of the smallest, the middle and the largest moment, and the components
//! of Ω are along them. Differences of moments are taken first, so that nearly symmetric bodies keep their digits.

use crate::error::{Result, finite, positive};
use crate::frame::BodyVector;
use crate::inertia::PrincipalMoments;
use crate::precise::{DoubleDouble, Number, power_of_two_below};

/// The linearised motion near the rotation about x₂ (6.7).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Saddle {
    /// Rate √λ at which a disturbance grows or decays, rad/s.
    pub rate: f64,
    /// Unit vector along which a disturbance grows, in the plane x₁x₃ of the body; its opposite would do as well.
    pub outgoing: BodyVector,
    /// Unit vector along which it decays: the tangent of the incoming separatrix.
    pub incoming: BodyVector,
}

/// λ = (I₁−I₂)(I₂−I₃)Ω₂²/(I₃I₁) in ∂²ΔΩ_i/∂t² = λΔΩ_i for i = 1, 3, rad²/s² (6.7).
///
/// The tutorial's formula lacks the factor Ω₂². Never negative; zero for a symmetric body, infinite where it overflows.
/// Error: seven roundings. Cost: a few operations.
///
/// # Errors
/// [`Error::NotFinite`](crate::Error::NotFinite) for Ω₂; [`Error::NotPositive`](crate::Error::NotPositive) if I₁ = 0: turning about x₁ would take no energy.
///
/// ```
/// use spinning_bodies::{euler_top::stability::lambda, inertia::PrincipalMoments};
/// let moments = PrincipalMoments::new(1.0, 2.0, 3.0)?;
/// assert!((lambda(&moments, 5.0)? - 25.0 / 3.0).abs() < 2e-15);
/// assert!((lambda(&moments, 1.0)? - 1.0 / 3.0).abs() < 1e-16, "what the tutorial prints");
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn lambda(moments: &PrincipalMoments, omega2: f64) -> Result<f64> {
    let [i1, i2, i3] = checked(moments)?;
    let omega2 = finite("the angular velocity", omega2)?;
    // Both quotients are at most 1, since I₁ + I₂ ≥ I₃.
    Ok((i3 - i2) / i1 * ((i2 - i1) / i3) * omega2 * omega2)
}

/// Rate and directions of growth and decay next to the rotation Ω₂ about x₂ (6.7).
///
/// The directions are ΔΩ₃/ΔΩ₁ = ∓√(I₁(I₂−I₁)/(I₃(I₃−I₂))), upper sign for growth if Ω₂ > 0: the tangents of the separatrix (6.3).
/// √λ is also the rate in the sech and tanh of the separatrix. Error: a few units in the last place. For a symmetric body the rate is zero
/// and both directions coincide with the other axis of the moment I₂; for a sphere they are x₁ by convention.
///
/// # Errors
/// As [`lambda`].
///
/// ```
/// use spinning_bodies::{euler_top::stability::saddle, inertia::PrincipalMoments};
/// let saddle = saddle(&PrincipalMoments::new(1.0, 2.0, 3.0)?, 2.0)?;
/// assert!((saddle.rate - 2.0 / 3f64.sqrt()).abs() < 3e-16);
/// let slope = saddle.incoming.z() / saddle.incoming.x();
/// assert!((slope - 1.0 / 3f64.sqrt()).abs() < 2e-16);
/// assert_eq!(saddle.outgoing.z(), -saddle.incoming.z());
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn saddle(moments: &PrincipalMoments, omega2: f64) -> Result<Saddle> {
    let [i1, i2, i3] = checked(moments)?;
    let omega2 = finite("the angular velocity", omega2)?;
    let rate = ((i3 - i2) / i3).sqrt() * (i2 - i1).sqrt() / i1.sqrt() * omega2.abs();
    // dΔΩ₁ = −(I₃−I₂)Ω₂ΔΩ₃/I₁, dΔΩ₃ = −(I₂−I₁)Ω₂ΔΩ₁/I₃.
    let along1 = i3.sqrt() * (i3 - i2).sqrt();
    let along3 = i1.sqrt() * (i2 - i1).sqrt();
    let length = along1.hypot(along3);
    let (first, third) = if length > 0.0 {
        (along1 / length, along3 / length)
    } else {
        (1.0, 0.0)
    };
    let third = third.copysign(omega2);
    Ok(Saddle {
        rate,
        outgoing: BodyVector::new(first, 0.0, -third),
        incoming: BodyVector::new(first, 0.0, third),
    })
}

/// Frequencies of small oscillations about a rotation at Ω (`omega`, rad/s) about x₁ and about x₃, rad/s (6.7):
/// √((I₂−I₁)(I₃−I₁)/(I₂I₃))|Ω| and √((I₃−I₁)(I₃−I₂)/(I₁I₂))|Ω|.
///
/// They are the limits of 2π over the period of 6.6. If I₁ = I₂ the first is zero, for the rotation drifts, and the second is Ω(I₃/I₁ − 1) of 6.5.
/// Oscillation to first order does not prove stability; [`lyapunov`] does. Error: a few units in the last place.
///
/// # Errors
/// As [`lambda`].
///
/// ```
/// use spinning_bodies::{euler_top::stability::oscillations, inertia::PrincipalMoments};
/// let [about_smallest, about_largest] = oscillations(&PrincipalMoments::new(1.0, 2.0, 3.0)?, 1.0)?;
/// assert!((about_smallest - 0.5773502691896257645).abs() < 2e-16 && (about_largest - 1.0).abs() < 3e-16);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn oscillations(moments: &PrincipalMoments, omega: f64) -> Result<[f64; 2]> {
    let [i1, i2, i3] = checked(moments)?;
    let omega = finite("the angular velocity", omega)?.abs();
    Ok([
        ((i2 - i1) / i2).sqrt() * ((i3 - i1) / i3).sqrt() * omega,
        ((i3 - i2) / i2).sqrt() * (i3 - i1).sqrt() / i1.sqrt() * omega,
    ])
}

/// The integrals L² − 2EI₁, L² − 2EI₂ and 2EI₃ − L², J² s², at Ω in rad/s: constant, each zero for the rotation about its axis (6.3).
///
/// I₂(I₂−I₁)Ω₂² + I₃(I₃−I₁)Ω₃² is definite across x₁ and I₁(I₃−I₁)Ω₁² + I₂(I₃−I₂)Ω₂² across x₃: a motion that starts near one of these
/// rotations stays near it, not only to first order. I₃(I₃−I₂)Ω₃² − I₁(I₂−I₁)Ω₁² is indefinite across x₂; its sign gives the sector
/// (6.6), its zero the separatrix. The first and third are sums of squares: error a few units in the last place however close to the axis, where L² and 2EI₁ agree in
/// all their digits; zero for tilts below 10⁻¹⁵⁴, where the squares underflow. The second is a difference taken in 106 bits: error a unit in the last
/// place, or 10⁻³¹ of its larger term if that is more, as far as (Ω₁/Ω₃)² is in the range of doubles; infinite or NaN where a square overflows.
///
/// ```
/// use spinning_bodies::{euler_top::stability::lyapunov, frame::BodyVector, inertia::PrincipalMoments};
/// let moments = PrincipalMoments::new(1.0, 2.0, 3.0)?;
/// let [about_smallest, ..] = lyapunov(&moments, BodyVector::new(1.0, 1e-10, 1e-10));
/// assert!((about_smallest / 8e-20 - 1.0).abs() < 5e-16);
/// let [.., about_largest] = lyapunov(&moments, BodyVector::new(1e-10, 1e-10, 1.0));
/// assert!((about_largest / 4e-20 - 1.0).abs() < 5e-16);
/// let about_middle = |omega1| lyapunov(&moments, BodyVector::new(omega1, 1.0, 1.0))[1];
/// assert!(about_middle(1.7) > 0.0 && about_middle(1.8) < 0.0);
/// // The squares of these moments overflow, and no integral does.
/// let [heavy, slow] = [PrincipalMoments::new(1e200, 2e200, 3e200)?, PrincipalMoments::new(1e-160, 2e-160, 3e-160)?];
/// assert!((lyapunov(&heavy, BodyVector::new(1e-150, 0.0, 1e-150))[1] / 2e100 - 1.0).abs() < 1e-15);
/// assert!((lyapunov(&slow, BodyVector::new(1e150, 0.0, 1e150))[1] / 2e-20 - 1.0).abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn lyapunov(moments: &PrincipalMoments, omega: BodyVector) -> [f64; 3] {
    let [i1, i2, i3] = moments.values();
    let [x, y, z] = [omega.x(), omega.y(), omega.z()];
    // Products of moments may leave the range of doubles where the integrals do not.
    let [unit, size] = [x.abs().max(z.abs()), i3].map(power_of_two_below);
    let term = |i: f64, more: f64, less: f64, omega: f64| {
        DoubleDouble::product(omega / unit, omega / unit)
            * DoubleDouble::difference(more / size, less / size)
            * DoubleDouble::from(i / size)
    };
    [
        (i2 * y) * ((i2 - i1) * y) + (i3 * z) * ((i3 - i1) * z),
        (term(i3, i3, i2, z) - term(i1, i2, i1, x)).value() * unit * size * unit * size,
        (i1 * x) * ((i3 - i1) * x) + (i2 * y) * ((i3 - i2) * y),
    ]
}

fn checked(moments: &PrincipalMoments) -> Result<[f64; 3]> {
    positive("the smallest moment", moments.values()[0])?;
    Ok(moments.values())
}
