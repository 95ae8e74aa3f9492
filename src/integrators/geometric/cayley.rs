//! Implicit steps that turn the body by the rotation with the quaternion (1, e): the discrete free top of Moser and Veselov, and the midpoint rule.
//!
//! The midpoint rule solves Ie + e∧Ie = g = ½hL for e, Moser's and Veselov's top the same with (1 + |e|²)g on the right; the body then turns by
//! 2 arctan|e| about e. Both conserve |L| and E exactly but for rounding.

use super::preprocessing::corrections;
use super::stepper::{Run, Steps, checked_moments};
use super::{Integrator, Phase, Stepper};
use crate::error::{Error, Result, stopped};
use crate::integrators::real::{Real, cross, dot};
use crate::precise::power_of_two_below;

/// Order of [`MoserVeselov`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum VeselovOrder {
    /// With the moments of the body as they are.
    Two = 2,
    /// With one correction term of the moments.
    Four = 4,
    /// With two correction terms.
    Six = 6,
    /// With four correction terms.
    Ten = 10,
}

impl VeselovOrder {
    /// All orders.
    pub const ALL: [Self; 4] = [Self::Two, Self::Four, Self::Six, Self::Ten];
}

/// The discrete free top of Moser and Veselov (1991), with moments of inertia modified for order 2, 4, 6 or 10 (Hairer and Vilmart 2006).
///
/// Conserved, to rounding: |L|, the energy, L in space; the method is symmetric in time. Only order 2 is symplectic: the modified moments depend on |L|
/// and the energy, so neighbouring phases are moved by different tops, and the symplectic form changes by O(step^(p+1)) a step. It is the only method
/// here whose cost does not grow with its order. Each step is solved by Newton's method until the next correction is below rounding: two rounds for a
/// turn of a thirtieth of a radian, three for half a radian. Domain: steps up to a radian; for a longer one that has no solution, or whose modified
/// moments are not positive, [`Error::Integration`]. Thin bodies: with y = h²|L|²/(I₁I₃), I₁ and I₃ the least and the greatest moment, the
/// terms of the correction reach y, y² and y⁴ at orders 4, 6 and 10 and cancel, so y must be far below 10¹⁵, 10⁷ and 10³. The rounding errors of the
/// solutions make the energy walk at random: 4e-14 over 10⁷ steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MoserVeselov {
    moments: [f64; 3],
    order: VeselovOrder,
}

impl MoserVeselov {
    /// The method of this order for a body with these principal moments, kg m².
    ///
    /// # Errors
    /// Those of an invalid moment.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::integrators::geometric::{Integrator, MoserVeselov, Phase, VeselovOrder};
    /// let start = Phase::new(BodyVector::new(0.1, 2.0, 0.3), &Attitude::identity());
    /// let method = MoserVeselov::new([1.0, 2.0, 2.5], VeselovOrder::ALL[3])?;
    /// let mut run = method.start(&start, 0.02)?;
    /// run.advance(500)?;
    /// // |L| is conserved.
    /// assert!((run.phase()?.angular_momentum().norm() / start.angular_momentum().norm() - 1.0).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(moments: [f64; 3], order: VeselovOrder) -> Result<Self> {
        Ok(Self {
            moments: checked_moments(moments)?,
            order,
        })
    }
}

impl<T: Real> Integrator<T> for MoserVeselov {
    fn name(&self) -> String {
        format!("Moser-Veselov {}", self.order as u32)
    }

    fn order(&self) -> u32 {
        self.order as u32
    }

    fn start(&self, phase: &Phase<T>, step: T) -> Result<Box<dyn Stepper<T> + '_>> {
        let run = Run::new(phase, step)?;
        let unit = unit(self.moments);
        let inverse = self.moments.map(|i| T::from_double(i / unit).reciprocal());
        let scale = T::from_double(1.0 / unit) * step;
        let l = phase.l.map(|component| scale * component);
        let terms = self.order as usize / 2 - 1;
        let (factor, summand) = corrections(inverse, l, terms);
        let inverse = inverse.map(|a| a + (a * factor + summand));
        if !inverse.iter().all(|a| a.to_double() > 0.0) {
            let reason = "the step is too long for moments of inertia that make up for it";
            return stopped(reason, 0.0);
        }
        let moments = inverse.map(T::reciprocal);
        Ok(implicit_steps::<T, true>(moments, unit, run, step))
    }
}

/// The implicit midpoint rule with a rotation in place of a sum: Ω from the mean of L before and after, the body turned by 2 arctan(½h|Ω|) about it.
///
/// Conserved, to rounding: |L|, the energy, L in space; symmetric in time; the phase volume is not conserved. Solved like [`MoserVeselov`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroupMidpoint {
    moments: [f64; 3],
}

impl GroupMidpoint {
    /// The method for a body with these principal moments, kg m².
    ///
    /// # Errors
    /// Those of an invalid moment.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::integrators::geometric::{GroupMidpoint, Integrator, Phase};
    /// let start = Phase::new(BodyVector::new(0.1, 2.0, 0.3), &Attitude::identity());
    /// let method = GroupMidpoint::new([1.0, 2.0, 2.5])?;
    /// let mut run = method.start(&start, 0.02)?;
    /// run.advance(500)?;
    /// assert!((run.phase()?.angular_momentum().norm() / start.angular_momentum().norm() - 1.0).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(moments: [f64; 3]) -> Result<Self> {
        Ok(Self {
            moments: checked_moments(moments)?,
        })
    }
}

impl<T: Real> Integrator<T> for GroupMidpoint {
    fn name(&self) -> String {
        "midpoint 2".to_owned()
    }

    fn order(&self) -> u32 {
        2
    }

    fn start(&self, phase: &Phase<T>, step: T) -> Result<Box<dyn Stepper<T> + '_>> {
        let (run, unit) = (Run::new(phase, step)?, unit(self.moments));
        let moments = self.moments.map(|i| T::from_double(i / unit));
        Ok(implicit_steps::<T, false>(moments, unit, run, step))
    }
}

/// The power of two, kg m², over which moments and L are taken, for their powers may leave the range of doubles.
fn unit(moments: [f64; 3]) -> f64 {
    power_of_two_below(moments.into_iter().fold(0.0, f64::max))
}

/// A run of implicit steps; each starts Newton's method by extrapolating the last three solutions. The evaluations are solutions of Newton's linear system.
/// `moments` are those over `unit`.
fn implicit_steps<'a, T: Real, const VESELOV: bool>(
    moments: [T; 3],
    unit: f64,
    run: Run<T>,
    step: T,
) -> Box<dyn Stepper<T> + 'a> {
    let [one, two, three] = [1.0, 2.0, 3.0].map(T::from_double);
    let half = T::from_double(0.5 / unit) * step;
    // The latest solution first.
    let (mut last, mut known) = ([[T::from_double(0.0); 3]; 3], 0);
    let one_step = move |run: &mut Run<T>| {
        let l = run.l.values;
        let g = l.map(|component| half * component);
        let [a, b, c] = last;
        let guess = core::array::from_fn(|k| match known {
            0 => g[k] * moments[k].reciprocal(),
            1 => a[k],
            2 => two * a[k] - b[k],
            _ => three * (a[k] - b[k]) + c[k],
        });
        let (e, rounds) = solution::<T, VESELOV>(moments, g, guess).ok_or(Error::Integration {
            reason: "an implicit step has no solution nearby: it is too long",
            time: step.to_double() * known as f64,
        })?;
        let square = dot(e, e);
        let norm = one + square;
        let root = norm.square_root().reciprocal();
        let first = cross(e, l);
        let second = cross(e, first);
        let scale = two * root * root;
        let change = core::array::from_fn(|k| scale * (second[k] - first[k]));
        // 1/√(1 + e²) − 1 without cancellation: −e²/(1 + e² + √(1 + e²)).
        let cosine = -(square * root * root) * (one + root).reciprocal();
        run.turn([cosine, root * e[0], root * e[1], root * e[2]], change);
        last = [e, a, b];
        known += 1;
        Ok(rounds)
    };
    Steps::boxed(run, one_step)
}

/// The e that belongs to g, by Newton's method from a guess, and the number of its rounds.
#[inline(always)]
fn solution<T: Real, const VESELOV: bool>(
    i: [T; 3],
    g: [T; 3],
    mut e: [T; 3],
) -> Option<([T; 3], u64)> {
    let [one, two] = [1.0, 2.0].map(T::from_double);
    for round in 1..=MOST_ROUNDS {
        let ie: [T; 3] = core::array::from_fn(|k| i[k] * e[k]);
        let gyration = cross(e, ie);
        let scale = if VESELOV { one + dot(e, e) } else { one };
        let rest: [T; 3] = core::array::from_fn(|k| scale * g[k] - (ie[k] + gyration[k]));
        // Newton's matrix I + (terms of e∧Ie) − 2g eᵀ, by columns; the last term only for Moser's and Veselov's top.
        let mut columns = [
            [i[0], (i[0] - i[2]) * e[2], (i[1] - i[0]) * e[1]],
            [(i[2] - i[1]) * e[2], i[1], (i[1] - i[0]) * e[0]],
            [(i[2] - i[1]) * e[1], (i[0] - i[2]) * e[0], i[2]],
        ];
        if VESELOV {
            for (column, e) in columns.iter_mut().zip(e) {
                for (cell, g) in column.iter_mut().zip(g) {
                    *cell = *cell - two * g * e;
                }
            }
        }
        let [x, y, z] = columns;
        let yz = cross(y, z);
        let scale = dot(x, yz).reciprocal();
        let change = [
            scale * dot(rest, yz),
            scale * dot(x, cross(rest, z)),
            scale * dot(x, cross(y, rest)),
        ];
        e = core::array::from_fn(|k| e[k] + change[k]);
        let square = dot(change, change).to_double();
        // Convergence is quadratic, with a factor of order 1/|e| at most where steps are a radian or less: the remaining error is below
        // square/|e|, and below the rounding of e if square is below rounding times e².
        let size = dot(e, e).to_double();
        if square <= 0.125 * T::ROUNDING * size {
            return Some((e, round));
        }
        // e is the tangent of half the turn: a correction of a thousand leads to no solution nearby.
        if square.is_nan() || square > 1e6 {
            return None;
        }
    }
    None
}

/// The most rounds: where more are needed, there is no solution nearby.
const MOST_ROUNDS: u64 = 30;
