//! The bodies of the chapter, with the parameters for which its numbers are computed.

use nalgebra::Matrix3;

use super::body::ConvexBody;
use super::surface::Surface;
use crate::error::{Result, within};
use crate::frame::{Attitude, BodyVector};
use crate::inertia::InertiaMatrix;

/// A ball of radius R with C a distance α R below its centre, and inertia matrix `inertia` in units M R² (third axis along CK).
///
/// # Errors
/// As for [`ConvexBody::new`] and [`InertiaMatrix::from_matrix`]; [`Error::OutOfRange`](crate::Error::OutOfRange) unless 0 ≤ α < 1.
///
/// ```
/// use spinning_bodies::tippe_top::bodies;
/// let ball = bodies::eccentric_ball(0.02, 0.02, 0.3, nalgebra::Matrix3::identity() * 0.4)?;
/// assert_eq!(ball.center().z(), 0.3 * 0.02);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn eccentric_ball(
    mass: f64,
    radius: f64,
    alpha: f64,
    inertia: Matrix3<f64>,
) -> Result<ConvexBody> {
    let surface = Surface::sphere(radius)?;
    offset(alpha)?;
    let inertia = InertiaMatrix::from_matrix(inertia * (mass * radius * radius))?;
    let center = BodyVector::new(0.0, 0.0, alpha * radius);
    ConvexBody::new(mass, inertia, surface, center)
}

/// α, the offset of C over the radius, if 0 ≤ α < 1.
pub(super) fn offset(alpha: f64) -> Result<f64> {
    let most = 1.0_f64.next_down();
    within("the offset of C over the radius", alpha, 0.0, most)
}

/// 1 − α cos θ, the height of C over R: a sum of positive terms, so that neither a small tilt nor a small 1 − α is lost.
pub(super) fn height(alpha: f64, tilt: f64) -> f64 {
    let half = (0.5 * tilt).sin();
    (1.0 - alpha) + 2.0 * alpha * half * half
}

/// The tutorial's hoop with clay, taken as a ball with I = (2/5) M R² in every direction and C at α R from its centre.
///
/// # Errors
/// As for [`eccentric_ball`].
///
/// ```
/// use spinning_bodies::tippe_top::bodies;
/// assert_eq!(bodies::hoop_with_clay(1.0, 0.5, 0.2)?.center().z(), 0.1);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn hoop_with_clay(mass: f64, radius: f64, alpha: f64) -> Result<ConvexBody> {
    eccentric_ball(mass, radius, alpha, Matrix3::identity() * 0.4)
}

/// The tippe top of Rauch-Wojciechowski and Rutstam's numerics: 20 g, R = 2 cm, α = 0.3, I3 = (2/5) M R², I1 = (131/350) M R².
///
/// # Errors
/// None for these parameters.
///
/// ```
/// use spinning_bodies::tippe_top::bodies;
/// assert_eq!(bodies::tippe_top()?.mass(), 0.02);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn tippe_top() -> Result<ConvexBody> {
    let moments = nalgebra::Vector3::new(131.0 / 350.0, 131.0 / 350.0, 0.4);
    eccentric_ball(0.02, 0.02, 0.3, Matrix3::from_diagonal(&moments))
}

/// A homogeneous egg: the spheroid with half length `long` along its third axis and radius `short` (m).
///
/// # Errors
/// As for [`ConvexBody::new`].
///
/// ```
/// use spinning_bodies::tippe_top::bodies;
/// // M(a² + b²)/5 across, 2Mb²/5 along.
/// let moments = bodies::egg(5.0, 2.0, 1.0)?.inertia().matrix().diagonal();
/// assert_eq!(moments.as_slice(), [5.0, 5.0, 2.0]);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn egg(mass: f64, long: f64, short: f64) -> Result<ConvexBody> {
    let surface = Surface::ellipsoid([short, short, long])?;
    let across = mass * (long * long + short * short) / 5.0;
    let along = mass * 2.0 * short * short / 5.0;
    let inertia = InertiaMatrix::diagonal(across, across, along)?;
    ConvexBody::new(mass, inertia, surface, BodyVector::zero())
}

/// A chiral tippe top with a perfectly spherical surface: 20 g, R = 2 cm, α = 0.19, and a skew inertia matrix.
///
/// Spun clockwise (seen from above) it turns over, spun anticlockwise it stays down. Its beads: [`beads`](super::beads).
///
/// # Errors
/// None for these parameters.
///
/// ```
/// use spinning_bodies::tippe_top::{bodies, chirality_index};
/// let top = bodies::chiral_top()?;
/// let (here, there) = (chirality_index(top.inertia(), top.center())?, chirality_index(top.mirrored().inertia(), top.center())?);
/// assert!(here != 0.0 && here == -there);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn chiral_top() -> Result<ConvexBody> {
    let inertia = Matrix3::new(
        0.480, 0.017, -0.008, 0.017, 0.420, 0.008, -0.008, 0.008, 0.530,
    );
    eccentric_ball(0.02, 0.02, 0.19, inertia)
}

/// A top of 20 g and R = 2 cm on an ellipsoidal end with semi-axes R(1+e), R(1−e), R, turned by `delta` (rad) about CK against the axes
/// of inertia, with `moments` in units M R²: it is chiral as a rattleback is. The top of the example, spun anticlockwise, turns over in a fifth of a second (at 102.4 rad/s, μ = 0.5).
///
/// # Errors
/// As for [`eccentric_ball`].
///
/// ```
/// use spinning_bodies::tippe_top::bodies;
/// let top = bodies::celt_ended_top(0.288, [0.351, 0.550, 0.505], 0.745, 0.144)?;
/// assert!((top.center().z() - 0.288 * 0.02).abs() < 1e-17);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn celt_ended_top(alpha: f64, moments: [f64; 3], delta: f64, e: f64) -> Result<ConvexBody> {
    let radius = 0.02;
    let axes = [radius * (1.0 + e), radius * (1.0 - e), radius];
    let turn = Attitude::about_axis(BodyVector::new(0.0, 0.0, 1.0), delta)?;
    let inertia = Matrix3::from_diagonal(&moments.into());
    let mut top = eccentric_ball(0.02, radius, alpha, inertia)?;
    top.surface = Surface::ellipsoid(axes)?.turned(&turn);
    Ok(top)
}

/// Kane and Levinson's rattleback (1982), of 1 kg: semi-axes 20, 3 and 2 cm, C 1 cm below the centre, moments 2, 16, 17 and product
/// −0.2 cm² per unit mass.
///
/// # Errors
/// None for these parameters.
///
/// ```
/// use spinning_bodies::tippe_top::bodies;
/// assert_eq!(bodies::rattleback()?.center().z(), 0.01);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn rattleback() -> Result<ConvexBody> {
    let inertia = Matrix3::new(2e-4, -2e-5, 0.0, -2e-5, 16e-4, 0.0, 0.0, 0.0, 17e-4);
    let inertia = InertiaMatrix::from_matrix(inertia)?;
    let surface = Surface::ellipsoid([0.2, 0.03, 0.02])?;
    ConvexBody::new(1.0, inertia, surface, BodyVector::new(0.0, 0.0, 0.01))
}
