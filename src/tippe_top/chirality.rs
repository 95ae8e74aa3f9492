//! Chirality: the index that decides it for a body on a sphere, and beads from which to build the body.

use nalgebra::{Matrix3, Vector3};

use super::body::ConvexBody;
use super::friction::Regularised;
use super::growth::{Rate, quasi_steady};
use crate::error::{Result, each_finite, finite};
use crate::frame::{Attitude, BodyVector};
use crate::inertia::{InertiaMatrix, ellipsoid_of_inertia};

/// The chirality index χ = k·(Ik ∧ I²k), with k the unit vector along `axis` (tutorial 4.7, chiral tippe tops): in the third power of the unit of I.
///
/// χ = 0 if and only if some plane through k is a principal plane of I. For a body on a sphere with k along CK the reflection in that
/// plane then maps the body to itself and reverses its spin, so it tips alike for both senses. A mirror image has −χ. With k = e3,
/// χ = I12 (I13² − I23²) + I13 I23 (I22 − I11).
///
/// Observed, not proved: for χ > 0 negative (clockwise) spin tips faster. Error: a few roundings of
/// |I|³.
///
/// # Errors
/// [`Error::ZeroVector`](crate::Error::ZeroVector), [`Error::NotFinite`](crate::Error::NotFinite) for the axis, and where |I|³ overflows.
///
/// ```
/// use spinning_bodies::{frame::BodyVector, inertia::InertiaMatrix, tippe_top::chirality_index};
/// // Not chiral: the axis is a principal one.
/// let inertia = InertiaMatrix::diagonal(1.0, 2.0, 3.0)?;
/// assert_eq!(chirality_index(&inertia, BodyVector::new(0.0, 0.0, 1.0))?, 0.0);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn chirality_index(inertia: &InertiaMatrix, axis: BodyVector) -> Result<f64> {
    let k = axis.direction("the axis CK")?.components();
    let matrix = inertia.matrix();
    let image = matrix * k;
    let index = k.dot(&image.cross(&(matrix * image)));
    finite("the chirality index", index)
}

/// The slow swing of small perturbations for spin in both senses, anticlockwise first, at `spin` (rad/s) under gravity g: it tells for which
/// sense of spin, if any, the top begins to turn over.
///
/// As [`quasi_steady`] and [`QuasiSteady::slow_swing`](super::QuasiSteady::slow_swing) for ±`spin`; errors and cost are theirs.
///
/// # Errors
/// As for [`quasi_steady`].
///
/// ```
/// use spinning_bodies::tippe_top::{Regularised, bodies, swings_of_both_senses};
/// let law = Regularised::new(0.3, 1e-3)?;
/// // A round tippe top rises whichever way it spins.
/// let [one, other] = swings_of_both_senses(&bodies::tippe_top()?, 9.81, law, 150.0)?;
/// assert!(one.growth > 0.0 && (one.growth / other.growth - 1.0).abs() < 1e-6);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn swings_of_both_senses(
    body: &ConvexBody,
    gravity: f64,
    friction: Regularised,
    spin: f64,
) -> Result<[Rate; 2]> {
    let swing = |spin| Ok(quasi_steady(body, gravity, friction, spin)?.slow_swing);
    Ok([swing(spin)?, swing(-spin)?])
}

/// Positions ±pᵢ (m), relative to C, of three pairs of opposite beads, each of mass `mass`/6, that have this inertia matrix.
///
/// pᵢ = Σⱼ √(3 Jⱼ/M) Qⱼᵢ eⱼ, with the principal second moments Jⱼ = ½ tr I − Iⱼ, the principal axes eⱼ, and any rotation Q: `mixing`
/// (the identity puts the beads on the principal axes). Every such set of three pairs is of this form, up to a reflection.
///
/// # Errors
/// [`Error::NotPositive`](crate::Error::NotPositive) for the mass, [`Error::NotFinite`](crate::Error::NotFinite) for a place.
///
/// ```
/// use spinning_bodies::{frame::Attitude, inertia::InertiaMatrix, tippe_top::beads};
/// let inertia = InertiaMatrix::diagonal(5.0, 4.0, 3.0)?;
/// // Two beads of 1 kg at each place: their second moments are ½tr I together.
/// let places = beads(6.0, &inertia, &Attitude::identity())?;
/// let sum: f64 = places.iter().map(|place| 2.0 * place.dot(place)).sum();
/// assert!((sum - 6.0).abs() < 1e-14);
/// // Nearly flat: the pair across the plane keeps its digits.
/// let thickness = 2.0 - (2.0 - 1e-10);
/// let flat = beads(6.0, &InertiaMatrix::diagonal(1.0, 1.0, 2.0 - thickness)?, &Attitude::identity())?;
/// assert!((flat[2].norm() / (0.25 * thickness).sqrt() - 1.0).abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn beads(mass: f64, inertia: &InertiaMatrix, mixing: &Attitude) -> Result<[BodyVector; 3]> {
    let axes = inertia.principal_axes();
    // The ellipsoid of inertia has the semi-axes √(5 Jⱼ/M).
    let semi_axes = ellipsoid_of_inertia(mass, &axes.principal_moments())?;
    let lengths = Vector3::from(semi_axes) * 0.6_f64.sqrt();
    let mixing = mixing.quaternion().to_rotation_matrix();
    let places = axes.axes * Matrix3::from_diagonal(&lengths) * mixing.matrix();
    each_finite("the place of a bead", places.iter().copied())?;
    Ok([0, 1, 2].map(|i| BodyVector::from_components(places.column(i).into_owned())))
}
