//! How far Lagrange's top sinks when it is let go at rest, and the cycloid it tends to (tutorial 7.4).
//!
//! Every difference that can cancel is formed in 106 bits with exponents of any size, and only results are rounded.

use std::f64::consts::PI;

use crate::error::{Error, Result, finite, positive};
use crate::precise::{Extended, Number};

/// How far a top sinks that is let go at rest, spinning (7.4).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dip {
    /// h₁ = cos θ at the lowest point; the start is h₂.
    pub lowest_height: f64,
    /// θ at the lowest point, radians.
    pub lowest_tilt: f64,
    /// By how much θ has grown there, radians.
    pub depth: f64,
    /// The curve that the trace tends to for fast spin.
    pub cycloid: Cycloid,
}

/// θ − θ₀ = a(1 − cos u) against φ sin θ₀ = a(u − sin u), the limit of fast spin (7.4).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cycloid {
    /// a = I₁Mgl sin θ₀/L₃², radians: the radius of the wheel that draws the curve.
    pub radius: f64,
    /// sin θ₀: azimuths are wider than the arcs by its reciprocal.
    pub sine: f64,
}

impl Cycloid {
    /// θ − θ₀ and φ, radians, when the wheel has turned by u (one turn is one nutation).
    ///
    /// Few units in the last place, for small u too. Not a number if u is not finite. Cost: a sine and a cosine.
    pub fn at(&self, u: f64) -> [f64; 2] {
        let half = (0.5 * u).sin();
        [
            2.0 * self.radius * half * half,
            self.radius * less_its_sine(u) / self.sine,
        ]
    }
}

/// u − sin u.
fn less_its_sine(u: f64) -> f64 {
    // For |u| ≤ 1 twelve terms of the series leave less than 10⁻²⁸ of the sum; beyond, the difference loses three bits at most.
    if u.abs() > 1.0 {
        return u - u.sin();
    }
    let square = u * u;
    let tail = (2..14).rev().fold(0.0, |sum, k| {
        let n = f64::from(2 * k);
        (1.0 - sum) * square / (n * (n + 1.0))
    });
    u * square / 6.0 * (1.0 - tail)
}

/// The lowest point of a top let go at rest at the tilt θ₀ with the angular momentum L₃ about its axis (7.4).
///
/// h₁ = λ − √(λ² − 2λh₀ + 1) with λ = L₃²/(4I₁Mgl): the start is the upper root h₂, so whatever comes next is lower. The dip
/// h₀ − h₁ is the positive root of d² + 2(λ − h₀)d = sin²θ₀, 1 − h₁ is 1 − h₀ plus that, and 1 + h₁ = 2λ(1 + h₀)/(1 + λ + √…).
///
/// Domain: I₁, Mgl > 0, any finite L₃ (without spin it falls through the lowest point, θ = π), 0 < θ₀ < π. Few units in the
/// last place, for the depth too however small. Cost: two square roots of 106 bits, a few sines.
///
/// # Errors
/// [`Error::NotFinite`], [`Error::NotPositive`], [`Error::OutOfRange`] for θ₀.
///
/// ```
/// use spinning_bodies::lagrange_top::dip;
/// // With L₃ = 2 from 60°: to the horizontal.
/// let sunk = dip(1.0, 1.0, 2.0, std::f64::consts::FRAC_PI_3)?;
/// assert!(sunk.lowest_height.abs() < 3e-16 && (sunk.depth.to_degrees() - 30.0).abs() < 1e-13);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn dip(transverse: f64, weight_moment: f64, l3: f64, tilt: f64) -> Result<Dip> {
    positive("the transverse moment", transverse)?;
    positive("the weight moment Mgl", weight_moment)?;
    finite("the axial angular momentum", l3)?;
    positive("the tilt", tilt)?;
    if tilt >= PI {
        return Err(Error::OutOfRange {
            quantity: "the tilt",
            value: tilt,
            least: 0.0,
            greatest: PI,
        });
    }
    let number = Extended::from_double;
    let (s, c) = (0.5 * tilt).sin_cos();
    let [below, above] = [s, c].map(|x| number(x).square().times(2.0)); // 1 ∓ cos θ₀
    let product = number(transverse) * number(weight_moment);
    let square = number(l3).square();
    let lambda = square.quotient(product.times(4.0));
    let one = number(1.0);
    // λ − h₀ = (λ − 1) + (1 − h₀), and the root of its square and sin²θ₀.
    let lead = lambda - one + below;
    let sine2 = below * above;
    let root = (lead.square() + sine2).square_root();
    let fall = if lead.leading() < 0.0 {
        root - lead
    } else {
        sine2.quotient(root + lead)
    };
    let one_less = below + fall;
    let whole = one + lambda + root;
    let one_more = (lambda * above).times(2.0).quotient(whole);
    let [less, more] = [one_less, one_more].map(|x| x.narrow().value());
    let lowest_tilt = 2.0 * less.sqrt().atan2(more.sqrt());
    // cos θ₀ − cos θ₁ = 2 sin((θ₁ − θ₀)/2) sin((θ₁ + θ₀)/2).
    let middle = (0.5 * (tilt + lowest_tilt)).sin();
    let half = (0.5 * fall.narrow().value() / middle).min(1.0);
    let sine = tilt.sin();
    Ok(Dip {
        lowest_height: 0.5 * (more - less),
        lowest_tilt,
        depth: 2.0 * half.asin(),
        cycloid: Cycloid {
            radius: if square.is_zero() {
                f64::INFINITY
            } else {
                product.quotient(square).narrow().value() * sine
            },
            sine,
        },
    })
}
