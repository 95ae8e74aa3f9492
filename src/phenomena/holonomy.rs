//! The geometric phase: turning by going round a loop of shapes (tutorial 1.1).

use core::f64::consts::TAU;

use super::quadrature::integral;
use crate::error::Result;

/// A shape plane (x, ψ), and the law by which the body turns back when ψ grows.
///
/// The shape of the body has two coordinates, x and an angle ψ, and without angular momentum the body turns about one line by θ′ = −a(x) ψ′.
/// Along a closed path of shapes the turn is −∮ a dψ: a line integral in which time does not occur. By Stokes' theorem it is an area integral,
/// −∬ a′(x) dx dψ, with the curvature a′ as density. Where the curvature is zero, as for the [slide on ice](super::feet), no loop has any effect.
pub trait ShapePlane {
    /// a(x): the angle by which the body turns back for each radian of ψ.
    ///
    /// ```
    /// use spinning_bodies::phenomena::{EqualHalves, ShapePlane};
    /// let cat = EqualHalves::new(0.02, 0.02)?; // as round as balls
    /// assert!((cat.turn_back(1.0) - (1.0 - 0.5_f64.cos())).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    fn turn_back(&self, x: f64) -> f64;

    /// a′(x): the curvature, density of the turn over the plane, with respect to dx dψ.
    ///
    /// ```
    /// use spinning_bodies::phenomena::{EqualHalves, ShapePlane};
    /// let cat = EqualHalves::new(0.02, 0.02)?; // as round as balls
    /// assert!((cat.curvature(1.0) - 0.5 * 0.5_f64.sin()).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    fn curvature(&self, x: f64) -> f64;
}

/// A point on a closed path of shapes, and the tangent of the path there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// (x, ψ).
    pub shape: [f64; 2],
    /// (x′, ψ′), the derivatives by the parameter of the path.
    pub rate: [f64; 2],
}

/// The point from which the enclosed area is swept out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Hub {
    /// A point (x, ψ) of the plane, for a loop along which ψ returns to its value.
    Point([f64; 2]),
    /// x = 0, where all ψ are the same shape, for a loop round it: x and ψ are polar coordinates, and a(0) = 0.
    Pole,
}

/// The turn −∮ a dψ along a closed smooth path, s from 0 to 2π, radians. Observed error: 5e-16 of ∮ |a ψ′| ds.
///
/// # Errors
/// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Accuracy`](crate::Error::Accuracy) if forty halvings of the path, or a million
/// points, do not suffice.
///
/// ```
/// use spinning_bodies::phenomena::{EqualHalves, Step, turn_along};
/// let cat = EqualHalves::new(0.02, 0.02)?; // as round as balls
/// // The bend carried once round: half a turn.
/// let third = 2.0 * std::f64::consts::FRAC_PI_3;
/// let turn = turn_along(&cat, |s| Step { shape: [third, s], rate: [0.0, 1.0] })?;
/// assert!((turn + std::f64::consts::PI).abs() < 1e-14);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn turn_along(plane: &impl ShapePlane, path: impl Fn(f64) -> Step) -> Result<f64> {
    let rate = |s: f64| {
        let step = path(s);
        -plane.turn_back(step.shape[0]) * step.rate[1]
    };
    integral(rate, 0.0, TAU)
}

/// The turn −∬ a′ dx dψ over the area that a closed smooth path encloses, radians: the same number as [`turn_along`], from the curvature alone.
///
/// The area is swept by the ray from the hub to the path; where the ray turns the other way, the area counts as negative.
/// Observed difference from [`turn_along`]: 4e-16 relative for the loops of the book.
///
/// # Errors
/// As [`turn_along`].
///
/// ```
/// use spinning_bodies::phenomena::{EqualHalves, Hub, Step, turn_within};
/// let cat = EqualHalves::new(0.02, 0.02)?; // as round as balls
/// let third = 2.0 * std::f64::consts::FRAC_PI_3;
/// let turn = turn_within(&cat, |s| Step { shape: [third, s], rate: [0.0, 1.0] }, Hub::Pole)?;
/// assert!((turn + std::f64::consts::PI).abs() < 1e-14);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn turn_within(plane: &impl ShapePlane, path: impl Fn(f64) -> Step, hub: Hub) -> Result<f64> {
    let ray = |s: f64| {
        let Step { shape, rate } = path(s);
        let (swept, density) = match hub {
            Hub::Point([x, psi]) => {
                let (out, across) = (shape[0] - x, shape[1] - psi);
                // dx dψ = ρ (out ψ′ − across x′) dρ ds.
                let density = integral(|rho| rho * plane.curvature(x + rho * out), 0.0, 1.0);
                (out * rate[1] - across * rate[0], density)
            }
            Hub::Pole => (rate[1], integral(|x| plane.curvature(x), 0.0, shape[0])),
        };
        -swept * density.unwrap_or(f64::NAN)
    };
    integral(ray, 0.0, TAU)
}
