//! Euler's equations as a flow: without torque L moves on the sphere |L| = const (tutorial 5.1, 6.3).

use super::{AxisMoments, runge_kutta};
use crate::error::{Result, finite};
use crate::frame::{BodyVector, finite_vector};
use crate::inertia::PrincipalMoments;

/// ∂L/∂t = L∧Ω in N m: Euler's equations without torque, for the angular momentum seen from the body (5.1).
///
/// Component 1 is (I₂ − I₃)/(I₂I₃) · L₂L₃, and cyclic. Domain: any vector. The result is at right angles to L and to Ω, so |L| and
/// E are constant. Error: each component to 4 ulp, without cancellation for nearly equal moments, as long as L₂L₃ and the product of the
/// first two factors are in the range of doubles. Cost: six divisions. No errors.
///
/// ```
/// use spinning_bodies::{euler_equations::{AxisMoments, flow}, frame::BodyVector};
/// let moments = AxisMoments::new(1.0, 2.0, 3.0)?;
/// let rate = flow(&moments, BodyVector::new(1.0, 0.0, 1.0));
/// assert!((rate - BodyVector::new(0.0, 2.0 / 3.0, 0.0)).norm() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn flow(moments: &AxisMoments, l: BodyVector) -> BodyVector {
    let [i1, i2, i3] = moments.values();
    BodyVector::new(
        inverse_difference(i2, i3) * l.y() * l.z(),
        inverse_difference(i3, i1) * l.z() * l.x(),
        inverse_difference(i1, i2) * l.x() * l.y(),
    )
}

/// 1/J − 1/I without overflow on the way.
fn inverse_difference(i: f64, j: f64) -> f64 {
    (i - j) / i.max(j) / i.min(j)
}

/// What the flow does near an equilibrium.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Nature {
    /// The flow circles it: the axis of the smallest or the largest moment.
    Center,
    /// The flow comes in along one line and leaves along another: the axis of the middle moment.
    Saddle,
    /// Another moment equals this axis's: the equilibrium lies on a circle of equilibria, past which its neighbours drift; or all
    /// three are equal, and nothing moves.
    Degenerate,
}

/// A direction of L at which the flow stands still.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Equilibrium {
    /// Unit vector along a principal axis.
    pub direction: BodyVector,
    /// What the flow does near it.
    pub nature: Nature,
    /// Square of the rate of linear growth divided by |L|², (I_j − I_i)(I_i − I_k)/(I_i² I_j I_k): positive at a saddle.
    pub growth_squared: f64,
}

/// The six equilibria of [`flow`], ±x₁, ±x₂, ±x₃, each with what happens near it (5.1, 6.3, 6.7).
///
/// Domain: any moments. If moments are equal there are more equilibria than these six, and those on the circle of equilibria are
/// called degenerate. Error: the growth to 5 ulp, as long as its square is in the range of a double. Cost: a few divisions.
///
/// ```
/// use spinning_bodies::euler_equations::{AxisMoments, Nature, equilibria};
/// let moments = AxisMoments::new(1.0, 2.0, 3.0)?;
/// let saddles = equilibria(&moments).iter().filter(|place| place.nature == Nature::Saddle).count();
/// assert_eq!(saddles, 2);
/// // A needle of no thickness: still all the same.
/// assert_eq!(equilibria(&AxisMoments::new(1.0, 5e-309, 1.0)?)[0].growth_squared, 0.0);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn equilibria(moments: &AxisMoments) -> [Equilibrium; 6] {
    let i = moments.values();
    core::array::from_fn(|n| {
        let axis = n / 2;
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let (up, down) = (i[j] - i[axis], i[axis] - i[k]);
        let mut e = [0.0; 3];
        e[axis] = if n % 2 == 0 { 1.0 } else { -1.0 };
        let growth = inverse_difference(i[j], i[axis]) * inverse_difference(i[axis], i[k]);
        // Decided by the signs of the differences: a quotient may underflow.
        let (nature, growth_squared) = match (up != 0.0 && down != 0.0, (up > 0.0) == (down > 0.0))
        {
            (false, _) => (Nature::Degenerate, 0.0),
            (true, true) => (Nature::Saddle, growth),
            (true, false) => (Nature::Center, growth),
        };
        Equilibrium {
            direction: BodyVector::new(e[0], e[1], e[2]),
            nature,
            growth_squared,
        }
    })
}

/// |L₃/L₁| on the separatrix, √(I₃(I₂−I₁)/(I₁(I₃−I₂))): the two great circles L² = 2EI₂ through the saddles (6.3).
///
/// For the sorted moments; dimensionless. Domain: 0 if I₂ = I₁, infinite if I₂ = I₃, not a number for a sphere, which has no
/// separatrix. Error: 4 ulp. Cost: two divisions and a root. No errors.
///
/// ```
/// use spinning_bodies::{euler_equations::separatrix_slope, inertia::PrincipalMoments};
/// assert!((separatrix_slope(&PrincipalMoments::new(1.0, 2.0, 3.0)?) - 3.0_f64.sqrt()).abs() < 1e-15);
/// // A needle: √2⁵⁰·10¹⁵⁰.
/// let slope = separatrix_slope(&PrincipalMoments::new(1e-300, 1.0 - 2f64.powi(-50), 1.0)?);
/// assert!((slope / 2f64.powi(25) / 1e150 - 1.0).abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn separatrix_slope(moments: &PrincipalMoments) -> f64 {
    let [i1, i2, i3] = moments.values();
    i3.sqrt() / i1.sqrt() * ((i2 - i1) / (i3 - i2)).sqrt()
}

/// Greatest |∂L/∂t| on the sphere |L| = 1, in units 1/(kg m²): ½(1/I₁ − 1/I₃), halfway between axes 1 and 3 (5.1).
///
/// L∧I⁻¹L is longest where the middle component vanishes; the middle moment plays no part. Zero for a sphere, infinite for a rod. Error: 3 ulp.
///
/// ```
/// use spinning_bodies::{euler_equations::fastest_flow, inertia::PrincipalMoments};
/// assert!((fastest_flow(&PrincipalMoments::new(1.0, 2.0, 3.0)?) - 1.0 / 3.0).abs() < 1e-16);
/// // A needle: ½/I₁.
/// assert!((fastest_flow(&PrincipalMoments::new(1e-300, 1e10, 1e10)?) / 5e299 - 1.0).abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn fastest_flow(moments: &PrincipalMoments) -> f64 {
    let [i1, _, i3] = moments.values();
    0.5 * inverse_difference(i3, i1)
}

/// The points that the flow of L passes at times 0, `step`, …, `count`·`step` seconds (5.1).
///
/// For pictures: the classical Runge–Kutta method with its O(step⁴) error, each point pulled back to the sphere of the
/// start. Where accuracy matters, [`EulerTop`](crate::euler_top::EulerTop) has the closed form. Negative steps run backwards. Cost: 4·`count` evaluations of [`flow`].
///
/// # Errors
/// [`Error::NotFinite`](crate::Error::NotFinite) for the start or the step, or where a step is so long that a point overflows.
///
/// ```
/// use spinning_bodies::{euler_equations::{AxisMoments, streamline}, frame::BodyVector};
/// let moments = AxisMoments::new(1.0, 2.0, 3.0)?;
/// let line = streamline(&moments, BodyVector::new(0.6, 0.0, 0.8), 0.1, 50)?;
/// assert_eq!(line.len(), 51);
/// assert!((line[50].norm() - 1.0).abs() < 1e-14);
/// assert!(streamline(&moments, BodyVector::new(0.6, 0.0, 0.8), 1e200, 50).is_err());
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn streamline(
    moments: &AxisMoments,
    start: BodyVector,
    step: f64,
    count: usize,
) -> Result<Vec<BodyVector>> {
    finite_vector("the angular momentum", start)?;
    finite("the step", step)?;
    let length = start.norm();
    let rate = |l: &[f64; 3]| flow(moments, (*l).into()).into();
    let mut points = vec![start];
    let mut l = start.into();
    for _ in 0..count {
        l = runge_kutta(rate, &l, step);
        let now = BodyVector::from(l);
        let size = now.norm();
        let now = if size > 0.0 {
            now * (length / size)
        } else {
            now
        };
        l = finite_vector("the angular momentum", now)?.into();
        points.push(now);
    }
    Ok(points)
}
