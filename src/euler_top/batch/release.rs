//! How bodies are let go, and which of them go side by side from there.

use super::Axes;
use crate::error::Result;
use crate::euler_top::motion::EulerTop;
use crate::euler_top::separation::separation;
use crate::euler_top::start::{Renumbering, Start};
use crate::frame::{Attitude, BodyVector};
use crate::inertia::PrincipalMoments;
use crate::precise::{DoubleDouble, Number, power_of_two_below};

/// A free body as it is let go at time 0: what [`EulerTop::new`] asks for, not prepared for any later time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Release {
    /// Principal moments, kg m², in any order.
    pub moments: [f64; 3],
    /// L along the principal axes, kg m²/s.
    pub angular_momentum: BodyVector,
    /// How the body stands in space.
    pub attitude: Attitude,
}

/// 2⁻¹⁰⁰: no number of a start may be a lesser part of the largest. Squares of squares and their trailing words are normal then.
const FAR_BELOW: f64 = 7.888_609_052_210_118e-31;

/// Units outside 10^±120 would bring rates out of the range in which they can be halved.
const UNITS: core::ops::RangeInclusive<f64> = 1e-120..=1e120;

/// In single words the difference of two numbers is known to less than this part of them.
const BLURRED: f64 = 1e-14;

/// How a body is prepared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Way {
    /// By itself: numbers too far apart, a rod, a body at rest, or one to be refused.
    Single,
    /// Ω stays.
    Steady,
    /// m ≤ 1/2.
    Circular,
    /// m > 1/2, the separatrix included.
    Hyperbolic,
}

/// A body with its axes renumbered as [`EulerTop::new`] would.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sorted {
    pub(super) place: usize,
    pub(super) way: Way,
    pub(super) axes: Renumbering,
    /// Sign of du/dt: −1 about the smallest moment.
    pub(super) sense: f64,
    /// Powers of two that L and the moments are divided by.
    pub(super) unit: f64,
    pub(super) unit_of_moments: f64,
}

impl Release {
    /// The body prepared by itself.
    pub(super) fn top(&self) -> Result<EulerTop> {
        EulerTop::new(self.moments, self.angular_momentum, self.attitude)
    }

    /// Which way it goes. Where single words leave a doubt about which axis L goes round, exact differences decide.
    pub(super) fn sorted(&self, place: usize) -> Sorted {
        let moments = self.moments;
        let given: [f64; 3] = self.angular_momentum.components().into();
        let rank = |k: usize| {
            let before = |j: usize| {
                usize::from(moments[j] < moments[k])
                    + usize::from(j < k && moments[j] == moments[k])
            };
            before(0) + before(1) + before(2)
        };
        let mut order: Axes = [0; 3];
        for k in 0..3 {
            order[rank(k).min(2)] = k;
        }
        let ([i0, i1, i2], l) = (order.map(|k| moments[k]), order.map(|k| given[k]));
        let greatest = l[0].abs().max(l[1].abs()).max(l[2].abs());
        let (unit, unit_of_moments) = (power_of_two_below(greatest), power_of_two_below(i2));
        let mut sorted = Sorted {
            place,
            way: Way::Single,
            axes: Renumbering::new(order, given),
            sense: 1.0,
            unit,
            unit_of_moments,
        };
        let near = |x: f64| (x == 0.0) | (x.abs() > unit * FAR_BELOW);
        let ordinary = UNITS.contains(&unit)
            & UNITS.contains(&unit_of_moments)
            & (i0 > unit_of_moments * FAR_BELOW)
            & (near(l[0]) & near(l[1]) & near(l[2]));
        // So written that not-a-number is not ordinary; infinity is beyond the units.
        if !ordinary || PrincipalMoments::new(i0, i1, i2).is_err() {
            return sorted;
        }
        let [a, b, c] = l.map(|x| x != 0.0);
        let moves = ((i0 != i1) & a & b) | ((i1 != i2) & b & c) | ((i0 != i2) & a & c);
        if !moves {
            sorted.way = Way::Steady;
            return sorted;
        }
        let l = l.map(|x| x / unit);
        let [i0, i1, i2] = [i0, i1, i2].map(|x| x / unit_of_moments);
        let c = [i0 * (i2 - i1), i1 * (i2 - i0), i2 * (i1 - i0)];
        let [s0, s1, s2] = l.map(|x| x * x);
        let (third, first) = (c[0] * s2, c[2] * s0);
        let mut distance = third - first;
        if distance.abs() <= BLURRED * third {
            let scaled = Start::AngularMomentum(given.map(|x| x / unit));
            let moments = [i0, i1, i2];
            distance = separation::<DoubleDouble>(moments, order, scaled).leading();
        }
        // m : mc.
        let (m, mc) = if distance < 0.0 {
            sorted.axes = Renumbering::new([order[2], order[1], order[0]], given);
            sorted.sense = -1.0;
            (c[0] * (c[1] * s2 + c[2] * s1), -c[1] * distance)
        } else {
            (c[2] * (c[1] * s0 + c[0] * s1), c[1] * distance)
        };
        sorted.way = if m > mc {
            Way::Hyperbolic
        } else {
            Way::Circular
        };
        sorted
    }
}
